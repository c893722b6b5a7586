// What the test does in the tab "A scene": pictures against the golden hashes, what moves, what is refused, and controls.

import { choose } from "./walk.mjs";

const TAB = `document.querySelector('input[name="family"][value="scene"]').click()`;
const CHOICES = ["scenes", "scene-tier", "scene-points"];
// Two tiers and two point sets of two scenes, among them the one whose picture is a distance.
const PICTURES = ["room", "sensor"].flatMap((scene) => ["libm", "poly"].flatMap((tier) => ["pcg32", "sobol"].map((points) => [scene, tier, points])));

const settled = `["verified", "mismatch"].includes(document.getElementById("host").dataset.state)`;
const said = (page) => page.evaluate(`({ ...document.getElementById("host").dataset, text: document.getElementById("host").textContent })`);
const shown = (page) => page.evaluate(`({ ...document.getElementById("scene").dataset })`);
const press = (page, id) => page.evaluate(`document.getElementById("${id}").click()`);
const refusal = (page) => page.evaluate(`document.getElementById("scene-refusal").hidden ? "" : document.getElementById("scene-refusal").innerText.replace(/\\s+/g, " ")`);

function slide(page, passes) {
  return page.call((value) => {
    const slider = document.getElementById("passes");
    slider.value = value;
    slider.dispatchEvent(new Event("input", { bubbles: true }));
  }, passes);
}

// How many colours the picture has.
function colours() {
  const { width, height } = document.getElementById("film");
  // From a copy, as what is read often is kept elsewhere.
  const context = Object.assign(document.createElement("canvas"), { width, height }).getContext("2d", { willReadFrequently: true });
  context.drawImage(document.getElementById("film"), 0, 0);
  return new Set(new Uint32Array(context.getImageData(0, 0, width, height).data.buffer)).size;
}

// Chooses pictures, and compares what the page says of their hashes with the table.
async function hashes(page, table, check) {
  const rows = new Map(table.trim().split("\n").filter((row) => !row.startsWith("#")).map((row) => row.split(",")));
  const seen = new Set();
  for (const picture of PICTURES) {
    for (const [k, name] of CHOICES.entries()) await page.call(choose, name, picture[k]);
    await page.until(settled, 60);
    const what = picture.join(" ");
    const { state, text } = await said(page);
    const due = rows.get(`${what} 48x32 4 1`);
    check(/^[0-9a-f]{8}$/.test(due), `${what}: no golden picture`);
    check(state === "verified" && text.includes(due), `${what}: the table has ${due}, the page says: ${text}`);
    await page.until(`Number(document.getElementById("scene").dataset.samples) >= 2`);
    check((await shown(page)).shown === what, `${what} was chosen, shown is ${(await shown(page)).shown}`);
    const count = await page.call(colours);
    check(count > 200, `${what}: a picture of ${count} colours`);
    seen.add(due);
  }
  check(seen.size === PICTURES.length, `${PICTURES.length} pictures have ${seen.size} hashes`);
  return rows.size;
}

// Begins anew with so many passes, and records what each of them says. Both in one task: no pass of the picture before comes
// between, however busy the machine is.
function record(passes) {
  const { dataset } = document.getElementById("scene");
  const slider = document.getElementById("passes");
  slider.value = passes;
  slider.dispatchEvent(new Event("input", { bubbles: true }));
  if (dataset.samples !== "0" || dataset.error !== "") throw new Error("the picture before is still shown");
  window.passes = [];
  new MutationObserver(() => {
    const speed = Array.from(document.querySelectorAll("#scene-readings .value"), ({ textContent }) => textContent)[2];
    if (dataset.error !== "") window.passes.push([Number(dataset.samples), Number(dataset.error), speed]);
  }).observe(document.getElementById("scene"), { attributes: true });
}

// The error of a picture of random points against one of many more samples: of the room, 48 by 32, 16 samples a pixel.
function against_reference(module) {
  const { exports } = new WebAssembly.Instance(new WebAssembly.Module(module), {});
  const [most, at, count] = [exports.most_pixels(), exports.shared_memory(), 48 * 32];
  const mean = (...request) => {
    new Uint32Array(exports.memory.buffer, at + 24 * most, 7).set(request);
    for (let row = 0; row < 32; row += 1) for (const half of [0, 1]) exports.render(half, row);
    const [a, b] = [0, 1].map((half) => new Float32Array(exports.memory.buffer, at + 12 * most * half, 3 * count));
    return Float64Array.from(a, (x, k) => (x + b[k]) / 2);
  };
  const [picture, reference] = [mean(0, 1, 0, 48, 32, 8, 42), mean(0, 1, 3, 48, 32, 128, 1000)];
  const [squares, sums] = [[0, 0, 0], [0, 0, 0]];
  reference.forEach((x, k) => {
    squares[k % 3] += (picture[k] - x) ** 2;
    sums[k % 3] += x;
  });
  return Math.sqrt(squares.reduce((sum, square, k) => sum + (square * count) / sums[k] ** 2, 0) / 3);
}

// The figures move: samples double, the error falls as noise does, the speed is measured anew.
async function figures(page, module, check) {
  for (const [name, value] of [["scenes", "room"], ["scene-points", "pcg32"], ["scene-width", "48"]]) await page.call(choose, name, value);
  await page.call(record, 6);
  await page.until(`window.passes.at(-1)?.[0] === 64`, 60);
  const passes = await page.evaluate("window.passes");
  const samples = [...new Set(passes.map(([count]) => count))];
  check(samples.join() === "2,4,8,16,32,64", `passes of ${samples.join()} samples`);
  const [first, last] = [passes[0][1], passes.at(-1)[1]];
  // Noise falls by the root of 32.
  check(last > 0 && last < first / 4, `the error of random points goes from ${first} to ${last}`);
  // Twice the half of the difference, or its root of 2, would be further off.
  const [estimated, real] = [passes.find(([count]) => count === 16)?.[1], against_reference(module)];
  check(Math.abs(estimated / real - 1) < 0.15, `the error is estimated as ${estimated}; against a finer picture it is ${real}`);
  check(new Set(passes.map(([, , speed]) => speed)).size > 1, "the speed does not move");
  const readings = await page.evaluate(`document.getElementById("scene-readings").innerText`);
  check(/\d %/.test(readings) && /thousand samples/.test(readings), `the figures are ${readings}`);
  return { first, last, estimated, real };
}

// What is under way ends where something else is chosen, and at a press of the button.
async function stops(page, check) {
  await slide(page, 12);
  await page.call(choose, "scenes", "fog");
  await page.until(`Number(document.getElementById("scene").dataset.samples) >= 4`);
  check((await shown(page)).shown.startsWith("fog "), "the picture is not of what was chosen last");
  await press(page, "render");
  const { samples } = await shown(page);
  await new Promise((resolve) => setTimeout(resolve, 400));
  check((await shown(page)).samples === samples, "rendering does not stop");
  await press(page, "scene-again");
  await page.until(`document.getElementById("scene-seed").textContent === "44" && Number(document.getElementById("scene").dataset.samples) >= 2`);
  const address = await page.evaluate("location.search");
  check(address === "?scene=fog&tier=poly&points=pcg32&width=48&seed=44", `the address is ${address}`);
}

// The arrow keys choose among the scenes, and the focus stays.
async function keys(page, check) {
  await page.evaluate(`document.querySelector('input[name="scenes"]:checked').focus()`);
  for (const type of ["keyDown", "keyUp"]) await page.send("Input.dispatchKeyEvent", { type, key: "ArrowRight", code: "ArrowRight", windowsVirtualKeyCode: 39 });
  const [focused, now] = await page.evaluate(`[document.activeElement.value, document.getElementById("scene").dataset.shown]`);
  check(focused === "slivers" && now.startsWith("slivers "), `an arrow key leads to ${focused}, shown is ${now}`);
  const names = await page.evaluate(`Array.from(document.querySelectorAll("#film, #scene, #scene-controls, #passes"), (of) => of.getAttribute("aria-label") ?? of.labels?.[0]?.textContent)`);
  check(names.every((name) => name), `without a name for a screen reader: ${names.join()}`);
}

// The whole tab, from a page that has not loaded it.
export async function rendered(page, module, table, check) {
  const loaded = () => page.evaluate(`performance.getEntriesByType("resource").filter(({ name }) => /render.mjs|scene.csv|scene.wasm/.test(name)).length`);
  check(await loaded() === 0, "the scenes are loaded before their tab is opened");
  await page.evaluate(TAB);
  await page.until(`document.getElementById("scene").dataset.shown !== undefined`);
  check(await loaded() > 0, "control: what is loaded is not seen");
  await slide(page, 3);
  const count = await hashes(page, table, check);
  const errors = await figures(page, module, check);
  await stops(page, check);
  await keys(page, check);
  await page.evaluate(`document.querySelector('input[name="family"][value="plane"]').click()`);
  const gone = await page.evaluate(`[location.search, document.getElementById("scene").hidden, document.getElementById("bench").hidden].join()`);
  check(gone === ",true,false", `after the tab was left: ${gone}`);
  return { count, pictures: PICTURES.length, errors };
}

// Addresses of no picture, and what is due. A page on which the first was opened shows each of the others.
const REFUSED = [
  ["?scene=attic", 'There is no scene "attic". There are room, fog, slivers, slit, sensor.'],
  ["?scene=room&tier=double", 'There is no tier "double". There are libm, poly.'],
  ["?scene=room&tier=poly&points=dice", 'There is no point set "dice"'],
  ["?scene=room&points=sobol&width=0", "a picture has 1 to 65536 pixels"],
  ["?scene=room&width=70000", "a picture has 1 to 65536 pixels"],
  ["?scene=room&width=4294967296", "is not a whole number"],
  ["?scene=room&width=-3", 'The width "-3" is not a whole number'],
  ["?scene=room&width=96&seed=x", 'The seed "x" is not a whole number'],
];
export const NO_SCENE = REFUSED[0][0];

export async function refused_scenes(page, check) {
  for (const [address, due] of REFUSED) {
    await page.call((search) => {
      document.querySelector('input[name="family"][value="plane"]').click();
      history.replaceState(null, "", search);
      document.querySelector('input[name="family"][value="scene"]').click();
    }, address);
    await page.until(`!document.getElementById("scene-refusal").hidden`).catch(() => {});
    const text = await refusal(page);
    check(text.includes(due), `${address}: due is ${due}, the page says "${text}"`);
  }
  await page.call(choose, "scenes", "slit");
  await page.call(choose, "scene-width", "144");
  await page.until(`Number(document.getElementById("scene").dataset.samples) >= 2`);
  check(await refusal(page) === "", "after a good choice the page still refuses");
  return REFUSED.length;
}

// With another address the tab is opened at once; until its verdict is there.
export async function verdict(page) {
  await page.until(settled, 60);
  return said(page);
}

// A module whose room is seen by a camera that is wider by one bit.
export function one_bit_wider(module) {
  const spread = Buffer.from(new Float32Array([0.425]).buffer);
  const wrong = Buffer.from(module);
  let found = 0;
  for (let at = wrong.indexOf(spread); at >= 0; at = wrong.indexOf(spread, at + 4)) {
    wrong[at] ^= 1;
    found += 1;
  }
  if (found === 0) throw new Error("a control edits what is not there: the camera of the room");
  return wrong;
}
