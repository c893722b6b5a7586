// Runs the snippets of a page as they stand: each of `js` as a module, which must print; those of `ts` and `html` are written
// to files, for tsc and for a browser. A snippet that is spoiled must fail.

import { execFileSync } from "node:child_process";
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";

const page = readFileSync(process.argv[2], "utf8");
const of = (kind) => Array.from(page.matchAll(new RegExp(`^\`\`\`${kind}\n(.*?)^\`\`\`$`, "gms")), ([, text]) => text);
const run = (text) => execFileSync(process.execPath, ["--input-type=module", "--eval", text], { encoding: "utf8", stdio: "pipe" });

const snippets = of("js");
if (snippets.length < 5) throw new Error(`only ${snippets.length} snippets`);
for (const text of snippets) {
  if (run(text).trim() === "") throw new Error(`prints nothing:\n${text}`);
  let passed = true;
  try {
    run(text.replace("microwarp", "microwarp-that-is-not"));
  } catch {
    passed = false;
  }
  if (passed) throw new Error("a snippet without its package passes");
}
const [[typed], [shown]] = [of("ts"), of("html")];
writeFileSync("snippet.ts", typed);
writeFileSync("index.html", shown);
mkdirSync("wrong");
writeFileSync("wrong/wrong.ts", `import { Disk, Exponential, Normal, Pcg32 } from "microwarp";
new Normal("0", 1); // wrong
new Exponential(1); // wrong
new Disk().sample(0.5); // wrong
new Disk().fill([0, 0], new Pcg32()); // wrong
export const name: string = new Normal(0, 1).draw(new Pcg32()); // wrong
`);
console.log(`${snippets.length} snippets run`);
