// What the test does in the tab "In JavaScript": every snippet, code with errors, code without an end; and that the npm
// package gives the points of the page's own module.

import { pathToFileURL } from "node:url";
import { Microwarp } from "../page/module.mjs";
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
  [`import { Normal } from "microwarp";\nnew Normal(0, -1);`, /^RangeError: a parameter that must be positive is not$/],
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

// Of every sampler whose class takes the numbers of the page: its points and densities in the module and in the package.
export async function same_points(binary, folder, check) {
  const npm = await import(pathToFileURL(`${folder}/index.js`));
  const module = new WebAssembly.Module(binary);
  const page = new Microwarp(module, new WebAssembly.Instance(module).exports);
  const compared = [];
  for (const { name, tiers, place, parameters } of page.subjects.filter(({ tiers }) => tiers.includes("poly"))) {
    const values = parameters.map(({ value }) => value);
    let warp;
    try {
      warp = new npm[name](...values);
    } catch (problem) {
      if (problem instanceof TypeError) continue;
      throw problem;
    }
    if (!(warp instanceof npm.Warp)) continue;
    const drawn = page.sample({ place, tier: "poly", source: "random", dimensions: 0, count: 500, seed: 9, parameters: values });
    const rng = new npm.Pcg32(9, 54);
    for (let k = 0; k < drawn.count; k += 1) {
      const point = [warp.draw(rng)].flat();
      const same = point.slice(0, 3).every((x, i) => x === drawn.points[3 * k + i]);
      const density = warp.pdf(point.length === 1 ? point[0] : point);
      if (!check(same && density === drawn.densities[k], `${name}: point ${k} is ${point} in the package, ${drawn.points.slice(3 * k, 3 * k + 3)} in the module`)) break;
    }
    compared.push(name);
  }
  check(compared.length >= 25, `only ${compared.length} samplers are compared with the package: ${compared.join(", ")}`);
  return compared;
}
