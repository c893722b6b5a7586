// The golden bits: compares the module's results in this browser with the table that every target reproduces.

const hex = (word) => word.toString(16).padStart(8, "0");

// One row a case, in order: its name, then its words in hexadecimal. `#` begins a comment.
export function parse(text) {
  return text.split(/\r?\n/).flatMap((row) => {
    if (row.trim() === "" || row.startsWith("#")) return [];
    const [name, ...fields] = row.split(",").map((field) => field.trim());
    return [{ name, words: fields.map((field) => (/^[0-9a-f]{1,8}$/i.test(field) ? parseInt(field, 16) : NaN)) }];
  });
}

// How many words agree, and which cases do not.
export function compare(table, results) {
  const problems = [];
  let agreed = 0;
  if (table.length === 0) problems.push("the table is empty");
  if (table.length !== results.length) {
    problems.push(`the table has ${table.length} cases, the module ${results.length}`);
  }
  table.slice(0, results.length).forEach(({ name, words }, index) => {
    const got = results[index];
    if (words.length !== got.length) {
      problems.push(`${name}: ${words.length} words in the table, ${got.length} from the module`);
    }
    words.slice(0, got.length).forEach((word, at) => {
      if (word === got[at]) agreed += 1;
      else problems.push(`${name}: word ${at + 1} is ${hex(got[at])}, the table has ${Number.isNaN(word) ? "no word" : hex(word)}`);
    });
  });
  return { cases: table.length, agreed, problems };
}

export async function verify(module, url) {
  const response = await fetch(url);
  if (!response.ok) throw new Error(`${url}: ${response.status}`);
  const table = parse(await response.text());
  const began = performance.now();
  const results = module.golden_words();
  return { ...compare(table, results), milliseconds: performance.now() - began };
}
