// Evaluates every golden case in a WASM module and compares the words, bit by bit, with the table.
//   node run.mjs module.wasm golden.csv
// The table: one row a case, in index order: name, then its words in hexadecimal. `#` begins a comment.
import { readFile } from "node:fs/promises";

const hex = (word) => word.toString(16).padStart(8, "0");

function parseWord(field, line) {
  if (!/^(0x)?[0-9a-f]{1,8}$/i.test(field)) throw new Error(`line ${line}: not a 32-bit hexadecimal word: "${field}"`);
  return parseInt(field.replace(/^0x/i, ""), 16);
}

function parseTable(text) {
  return text.split(/\r?\n/).flatMap((row, index) => {
    if (row.trim() === "" || row.startsWith("#")) return [];
    const [name, ...fields] = row.split(",").map((field) => field.trim());
    return [{ name, words: fields.map((field) => parseWord(field, index + 1)) }];
  });
}

// The words of every case. The buffer is looked up after each call, since memory may have moved.
function evaluateAll({ golden_cases, golden_evaluate, golden_words, memory }) {
  return Array.from({ length: golden_cases() }, (_, index) => {
    const count = golden_evaluate(index);
    return Array.from(new Uint32Array(memory.buffer, golden_words(), count));
  });
}

// Counts the words that agree and says what does not.
function compare(table, results) {
  const problems = [];
  let matched = 0;
  if (table.length === 0) problems.push("the table is empty");
  if (table.length !== results.length) problems.push(`the table has ${table.length} cases, the module ${results.length}`);
  table.slice(0, results.length).forEach(({ name, words }, index) => {
    const got = results[index];
    if (words.length === 0) problems.push(`${name}: no words in the table`);
    if (words.length !== got.length) problems.push(`${name}: ${words.length} words in the table, ${got.length} from the module`);
    words.slice(0, got.length).forEach((word, at) => {
      if (word === got[at]) matched += 1;
      else problems.push(`${name}: word ${at} is ${hex(got[at])}, the table has ${hex(word)}`);
    });
  });
  return { matched, problems };
}

// Copies of the table, each wrong in one way: the comparison above must object to every one.
function corruptions(table) {
  const middle = Math.floor(table.length / 2);
  const change = (row) => table.map((entry, index) => (index === middle ? row(entry) : entry));
  return {
    "one bit flipped": change(({ name, words }) => ({ name, words: [...words.slice(0, -1), (words.at(-1) ^ 1) >>> 0] })),
    "one word too few": change(({ name, words }) => ({ name, words: words.slice(1) })),
    "one case missing": table.slice(0, -1),
    "one case too many": [...table, table[0]],
    "no case": [],
  };
}

const [modulePath, tablePath] = process.argv.slice(2);
if (!tablePath) throw new Error("usage: node run.mjs module.wasm golden.csv");

const table = parseTable(await readFile(tablePath, "utf8"));
const { instance } = await WebAssembly.instantiate(await readFile(modulePath), {});
const results = evaluateAll(instance.exports);
const { matched, problems } = compare(table, results);

if (problems.length > 0) {
  problems.slice(0, 20).forEach((problem) => console.error(problem));
  console.error(`FAILED: ${problems.length} problems, ${matched} words matched`);
  process.exit(1);
}
for (const [what, corrupted] of Object.entries(corruptions(table))) {
  if (compare(corrupted, results).problems.length === 0) {
    console.error(`FAILED: a corrupted table passes (${what})`);
    process.exit(1);
  }
}
console.log(`golden bits as WASM under node ${process.version}: ${matched} words of ${table.length} cases matched; 5 corrupted tables rejected`);
