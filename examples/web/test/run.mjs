// Tests the page's promises in headless Chromium.
//   node test/run.mjs SITE PANICS.wasm PICTURES
// SITE has the package, the module and what they are held against as `build` left them; PANICS.wasm is a module that can panic; PICTURES is
// where the screenshots go. Every check that could pass by seeing nothing has a control that it must reject.

import { mkdir, readFile, readdir, writeFile } from "node:fs/promises";
import { dirname, join } from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";
import { serve } from "../serve.mjs";
import { launch } from "./browser.mjs";
import { snippets } from "./code.mjs";
import { NO_SCENE, one_bit_wider, refused_scenes, rendered, verdict } from "./scene.mjs";
import { drawn, every_subject, most_points, refusals, shown, subjects_of, turns } from "./walk.mjs";

const web = dirname(dirname(fileURLToPath(import.meta.url)));
const [site, panics, pictures] = process.argv.slice(2);
if (!pictures) throw new Error("usage: node test/run.mjs SITE PANICS.wasm PICTURES");

const DESK = { width: 1280, height: 900 };
const PHONE = { width: 390, height: 844, scale: 2, mobile: true };
const NARROW = { width: 320, height: 640, mobile: true };
const DARK_AND_STILL = [{ name: "prefers-color-scheme", value: "dark" }, { name: "prefers-reduced-motion", value: "reduce" }];

const faults = [];
const say = (text) => console.log(text);
function check(holds, fault) {
  if (!holds) faults.push(fault);
  return holds;
}

// A row with the lowest bit of its last word changed.
const one_bit_changed = (row) => row.replace(/[0-9a-f]$/, (digit) => (parseInt(digit, 16) ^ 1).toString(16));
const row_of = (table, start) => table.split("\n").find((row) => row.startsWith(start));

function edited(text, from, to) {
  if (!text.includes(from)) throw new Error(`a control edits what is not there: ${from}`);
  return text.replace(from, to);
}

const microwarp = await import(pathToFileURL(`${site}/npm/index.js`));
const expected = await readFile(join(site, "expected.json"), "utf8");
const table = await readFile(join(site, "golden.csv"), "utf8");
const scenes = await readFile(join(site, "scene.wasm"));
const hashes = await readFile(join(site, "scene.csv"), "utf8");
const built = { "golden.csv": table, "expected.json": expected, "lines.mjs": await readFile(join(site, "lines.mjs")), "scene.wasm": scenes, "scene.csv": hashes };
for (const name of await readdir(join(site, "npm"))) built[`npm/${name}`] = await readFile(join(site, "npm", name));
const browser = await launch();

// Opens the page with some of its files replaced, waits for what it says of the golden bits, and closes it again.
async function with_page(what, screen, instead, work, address = "") {
  const server = await serve(web, { instead: { ...built, ...instead } });
  const page = await browser.open(server.url + address, screen);
  try {
    await page.until(`document.getElementById("golden").dataset.state !== "waiting"`);
    const golden = await page.evaluate(`({ ...document.getElementById("golden").dataset, text: document.getElementById("golden").textContent })`);
    return await work(page, golden);
  } catch (problem) {
    throw new Error(`${what}: ${problem.message}`);
  } finally {
    await page.close();
    server.close();
  }
}

// A page without a fault: nothing in the console, no request that failed, nothing wider than the screen.
async function sound(what, page) {
  page.problems.forEach((problem) => faults.push(`${what}: ${problem}`));
  const [content, screen] = await page.evaluate("[document.documentElement.scrollWidth, innerWidth]");
  check(content <= screen, `${what}: ${content} pixels wide on a screen of ${screen}`);
}

async function picture(page, name) {
  await page.call(() => scrollTo(0, 0));
  const png = await page.screenshot();
  check(png.length > 10_000, `the picture ${name} is nearly empty`);
  await writeFile(join(pictures, name), png);
}

// --- the module --------------------------------------------------------------------------------------

function modules(panicking, readme) {
  const imports = (binary) => WebAssembly.Module.imports(new WebAssembly.Module(binary)).map(({ name }) => name);
  check(imports(scenes).length === 0, `the module imports ${imports(scenes).join(", ")}: it can panic`);
  check(imports(panicking).includes("panicked"), "control: a module that can panic does not show it");
  const stated = Number(/(\d+) kB/.exec(readme)?.[1]);
  check(Math.abs(scenes.length / 1000 / stated - 1) < 0.05, `the module of the scenes has ${scenes.length} bytes, README.md says ${stated} kB`);
  say(`the module of the scenes: ${scenes.length} bytes; no import, so no panic; in a module that panics the import was seen`);
}

// --- the page ----------------------------------------------------------------------------------------

async function on_a_desk() {
  await with_page("desk", DESK, {}, async (page, golden) => {
    const cases = 16 * JSON.parse(expected).golden.length;
    check(golden.state === "verified" && /verified/.test(golden.text), `golden bits: ${golden.text}`);
    check(golden.text.includes(`all ${cases.toLocaleString("en")} cases`), `the page says "${golden.text}", the package has ${cases} cases`);
    say(golden.text);
    const seen = await every_subject(page, microwarp, check);
    say(`${new Set(seen).size} samplers by every plan of uniforms: ${seen.length} pictures, each with positive densities and the bounds stated`);
    const refused = await refusals(page, check);
    say(`refused, each with its reason: ${refused.join("; ")}`);
    await most_points(page, check);
    await turns(page, check);
    await page.call(() => document.querySelector('input[name="family"][value="directions"]').click());
    await page.call(() => document.querySelector('input[name="subject"][value="CosineHemisphere"]').click());
    await page.until(`/million/.test(document.getElementById("readings").textContent)`);
    await picture(page, "desk.png");
    await sound("desk", page);
  });
}

async function on_small_screens() {
  await with_page("phone", PHONE, {}, async (page) => {
    await page.until(`/million/.test(document.getElementById("readings").textContent)`);
    await picture(page, "phone.png");
    await sound("phone", page);
  });
  await with_page("narrow, dark, still", { ...NARROW, features: DARK_AND_STILL }, {}, async (page) => {
    await page.call(() => document.querySelector('input[name="family"][value="line"]').click());
    await page.until(`/million/.test(document.getElementById("readings").textContent)`);
    const paper = await page.evaluate("getComputedStyle(document.body).backgroundColor");
    check(paper !== "rgb(247, 246, 242)", "the page is light where dark is preferred");
    await picture(page, "narrow.png");
    await sound("narrow", page);
  });
}

// --- the tab with code -------------------------------------------------------------------------------

async function with_code() {
  for (const [what, screen] of [["code", DESK], ["code, narrow", { ...NARROW, features: DARK_AND_STILL }]]) {
    await with_page(what, screen, {}, async (page) => {
      say(`${what}: ${(await snippets(page, check)).join(", ")} run; errors are shown, and code without an end is stopped`);
      await sound(what, page);
      await page.call(() => document.querySelector('input[name="snippet"][value="sky"]').click());
      await page.until(`document.getElementById("code").dataset.state === "ended"`);
      await picture(page, `${what.replace(", ", "-")}.png`);
    });
  }
}

// --- the tab with scenes -----------------------------------------------------------------------------

async function with_scenes() {
  const began = performance.now();
  await with_page("scenes", DESK, {}, async (page) => {
    const { count, pictures: compared, errors } = await rendered(page, scenes, hashes, check);
    say(`scenes: ${compared} choices, each with the golden hash; the table has ${count}`);
    say(`scenes: error from ${errors.first} to ${errors.last}; once estimated ${errors.estimated}, against a finer picture ${errors.real}`);
    await sound("scenes", page);
  });
  await with_page("scenes, refused", { ...NARROW, features: DARK_AND_STILL }, {}, async (page) => {
    say(`scenes: ${await refused_scenes(page, check)} addresses refused, each with its reason`);
    await sound("scenes, refused", page);
    await picture(page, "scene-narrow.png");
  }, NO_SCENE);
  const line = row_of(hashes, "room poly sobol 48x32 4 1,");
  const changed = edited(hashes, line, one_bit_changed(line));
  for (const [what, instead, due] of [
    ["a changed bit of a hash", { "scene.csv": changed }, /^MISMATCH/],
    ["another module", { "scene.wasm": one_bit_wider(scenes) }, /^MISMATCH/],
    ["no table of hashes", { "scene.csv": null }, /^NOT compared/],
  ]) {
    const { state, text } = await with_page(`control: ${what}`, DESK, instead, verdict, "?scene=room");
    check(state === "mismatch" && due.test(text), `control: ${what}, and the page says: ${text}`);
    say(`control, ${what}: ${text}`);
  }
  await with_page("scenes on a desk", DESK, {}, async (page) => {
    await page.until(`Number(document.getElementById("scene").dataset.samples) >= 16`, 60);
    await picture(page, "scene.png");
    check((await verdict(page)).state === "verified", "the verdict is gone after further passes");
    await sound("scenes on a desk", page);
  }, "?scene=fog");
  say(`the tab with scenes took ${((performance.now() - began) / 1000).toFixed(1)} s`);
}

// --- controls ----------------------------------------------------------------------------------------

async function controls() {
  const row = row_of(table, "poly Normal #3,");
  await with_page("control: a changed bit", DESK, { "golden.csv": edited(table, row, one_bit_changed(row)) }, async (page, golden) => {
    check(golden.state === "mismatch" && /MISMATCH: 1 of/.test(golden.text), `control: one changed bit, and the page says: ${golden.text}`);
    say(`control, one bit changed: ${golden.text}`);
  });
  for (const missing of ["golden.csv", "npm/streaming.js"]) {
    await with_page(`control: no ${missing}`, DESK, { [missing]: null }, async (page, golden) => {
      check(golden.state === "mismatch" && page.problems.length > 0, `control: no ${missing}, which is not noticed`);
    });
  }
  const html = await readFile(join(web, "index.html"), "utf8");
  const noisy = edited(html, "</body>", `<script>console.error("control")</script></body>`);
  await with_page("control: a console error", DESK, { "index.html": noisy }, async (page) => {
    check(page.problems.some((problem) => problem.includes("control")), "control: an error in the console is not noticed");
  });
  const sampling = await readFile(join(web, "page/sample.mjs"), "utf8");
  const zero = edited(sampling, "    return { count, points:", "    densities[7] = 0;\n    return { count, points:");
  await with_page("control: a density of 0", DESK, { "page/sample.mjs": zero }, async (page) => {
    const found = [];
    drawn("Disk", await page.call(shown), (holds, fault) => holds || found.push(fault));
    check(found.length === 1 && /densities/.test(found[0]), `control: of a density of 0 is noticed ${found}`);
  });
  const catalogue = await readFile(join(web, "page/catalogue.mjs"), "utf8");
  const fewer = edited(catalogue, '["PowerMax2"], ', "");
  await with_page("control: a class too few", DESK, { "page/catalogue.mjs": fewer }, async (page) => {
    const found = [];
    await subjects_of(page, microwarp, (holds, fault) => holds || found.push(fault));
    check(found.length === 1 && /does not show PowerMax2$/.test(found[0]), `control: of a class too few is noticed ${found}`);
  });
  say("controls: a missing table or package, an error in the console, a density of 0 and a class too few were noticed");
}

await mkdir(pictures, { recursive: true });
try {
  modules(await readFile(panics), await readFile(join(web, "README.md"), "utf8"));
  await on_a_desk();
  await on_small_screens();
  await with_code();
  await with_scenes();
  await controls();
} catch (problem) {
  faults.push(problem.message);
} finally {
  await browser.close();
}
faults.slice(0, 30).forEach((fault) => console.error(fault));
if (faults.length > 0) {
  console.error(`FAILED: the page in Chromium, ${faults.length} faults`);
  process.exit(1);
}
say(`the page in Chromium: all as promised; pictures in ${pictures}`);
