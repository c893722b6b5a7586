// What the test does in the tab "In JavaScript": every snippet, code with errors, code without an end.

import { SNIPPETS } from "../page/snippets.mjs";
import { choose } from "./walk.mjs";

const ended = `["ended", "refused"].includes(document.getElementById("code").dataset.state)`;

// What the tab shows once the code has ended, and how many pixels are drawn upon.
function shown() {
  const { width, height } = document.getElementById("shown");
  const context = Object.assign(document.createElement("canvas"), { width, height }).getContext("2d", { willReadFrequently: true });
  context.drawImage(document.getElementById("shown"), 0, 0);
  const pixels = context.getImageData(0, 0, width, height).data;
  const inked = pixels.reduce((sum, value, k) => sum + (k % 4 === 3 && value > 0 ? 1 : 0), 0);
  const text_of = (id) => document.getElementById(id).innerText.trim();
  return { ...document.getElementById("code").dataset, inked, printed: text_of("printed"), refused: text_of("code-refusal") };
}

async function run(page, code) {
  await page.call((text) => {
    document.getElementById("text").value = text;
    document.getElementById("go").click();
  }, code);
  await page.until(ended, 60);
  return page.call(shown);
}

const WRONG = [
  [`import { Normal } from "microwarp";\nnew Normal(0, -1);`, /^RangeError: parameter 2 must be positive$/],
  ["const = 1;", /^SyntaxError/],
  ["for (;;);", /^Stopped after \d+ seconds\.$/],
  ["show(new Float32Array(4), 4);", /^RangeError: points of 1, 2 or 3/],
];

export async function snippets(page, check) {
  await page.call(choose, "family", "code");
  for (const [name, [, code]] of Object.entries(SNIPPETS)) {
    await page.call(choose, "snippet", name);
    await page.until(ended, 60);
    const { state, inked, printed, refused } = await page.call(shown);
    check(state === "ended" && refused === "" && inked > 500, `${name}: ${state}, ${inked} pixels drawn, ${refused}`);
    check((printed !== "") === code.includes("console.log"), `${name} prints "${printed}"`);
  }
  for (const [code, due] of WRONG) {
    const { state, inked, refused } = await run(page, code);
    check(state === "refused" && due.test(refused) && inked === 0, `"${code}": ${state}, "${refused}", ${inked} pixels`);
  }
  const { printed } = await run(page, `console.log("a", 1, [2n], new Float32Array(1));`);
  check(printed === `a 1 ["2n"] [0]`, `printed is ${printed}`);
  return Object.keys(SNIPPETS);
}
