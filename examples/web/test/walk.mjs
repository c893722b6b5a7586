// What the test does as a visitor would: choosing, typing, turning. These functions run in the page.

import { lists_of } from "../page/module.mjs";

// Chooses a radio button and tells what the page then shows.
export function choose(group, value) {
  document.querySelector(`input[name="${group}"][value="${value}"]`).click();
}

const options = (group) => Array.from(document.querySelectorAll(`input[name="${group}"]:not(:disabled)`), ({ value }) => value);

// What is shown: the page's own figures, and how many pixels of the picture are drawn upon.
export function shown() {
  const canvas = document.getElementById("view");
  // Read from a copy, so that the page's own canvas stays as it is.
  const copy = Object.assign(document.createElement("canvas"), { width: canvas.width, height: canvas.height });
  const context = copy.getContext("2d", { willReadFrequently: true });
  context.drawImage(canvas, 0, 0);
  const pixels = context.getImageData(0, 0, copy.width, copy.height).data;
  let inked = 0;
  for (let k = 3; k < pixels.length; k += 4) inked += pixels[k] > 0 ? 1 : 0;
  const text_of = (id) => document.getElementById(id).textContent;
  return { ...document.body.dataset, inked, summary: text_of("summary"), text: text_of("readings") };
}

// The names of all samplers in the module itself, so that none can be missing from the page.
function names_of(binary) {
  const { exports } = new WebAssembly.Instance(new WebAssembly.Module(binary), {});
  return Array.from(lists_of(exports)).flat().map(({ name }) => name);
}

// What is shown of a drawn sampler is what was chosen: points, and densities that are positive and finite.
export function drawn(what, { shown: name, summary, refused, count, inked, density }, check) {
  check(name === what, `${what} was chosen, and the page shows ${name}`);
  check(summary !== "" && summary !== "undefined", `${what}: no word on what it is`);
  check(refused === "", `${what}: refused, ${refused}`);
  check(Number(count) > 0 && inked > 500, `${what}: ${count} points, ${inked} pixels drawn`);
  const [least, most] = density.split(" ").map(Number);
  check(least > 0 && most < Infinity, `${what}: its densities are from ${least} to ${most}`);
}

// Chooses every sampler in every tier once, and in one tier every plan of uniforms. Gives what was seen.
export async function every_subject(page, module, check) {
  const seen = [];
  const families = await page.call(options, "family");
  for (const family of families.filter((name) => !["code", "scene"].includes(name))) {
    await page.call(choose, "family", family);
    for (const subject of await page.call(options, "subject")) {
      await page.call(choose, "subject", subject);
      for (const tier of await page.call(options, "tier")) {
        await page.call(choose, "tier", tier);
        const what = `${subject} ${tier}`;
        const found = await page.call(shown);
        drawn(what, found, check);
        // What is no warp has no such table, nor has `Float`, which adds to the error of the warp in it.
        if (["line", "plane", "directions"].includes(family) && subject !== "FloatDisk") {
          check(/Error of sample[^≤]*≤ \S/.test(found.text), `${what}: no bound is stated: ${found.text}`);
        }
        seen.push(what);
        for (const source of ["poly", "exact"].includes(tier) ? await page.call(options, "source") : []) {
          await page.call(choose, "source", source);
          drawn(what, await page.call(shown), check);
        }
        await page.call(choose, "source", "random");
      }
    }
  }
  const missing = names_of(module).filter((name) => !seen.some((what) => what.startsWith(`${name} `)));
  check(missing.length === 0, `the page does not show ${missing.join(", ")}`);
  return seen;
}

// Types numbers into the boxes of the parameters.
function type(values) {
  const boxes = document.querySelectorAll('#parameters input[type="text"]');
  values.forEach((value, k) => {
    boxes[k].value = value;
    boxes[k].dispatchEvent(new Event("input", { bubbles: true }));
  });
}

function refusal() {
  const place = document.getElementById("refusal");
  return place.hidden ? "" : place.innerText.replace(/\s+/g, " ").trim();
}

// Parameters that a constructor refuses, or with which a sampler fails, and the error that is due; then good ones.
const REFUSED = [
  ["line", "Interval", "poly", ["5", "-5"], "Error::Reversed", ["-3", "5"]],
  ["line", "Exponential", "libm", ["nan"], "Error::NotFinite", ["1"]],
  ["line", "Exponential", "fine", ["0"], "Error::NotPositive", ["1"]],
  ["line", "Tent", "coarse", ["inf"], "No number of I16F16", ["1"]],
  ["line", "Power", "poly", ["-1", "0", "1"], "Error::NotNormalizable", ["1", "0", "1"]],
  ["plane", "TriangleOn", "libm", ["0", "0", "1", "1", "2", "2"], "Error::Empty", ["0", "0", "4", "0", "1", "3"]],
  ["directions", "Oriented", "poly", ["0", "0", "0"], "Error::ZeroLength", ["1", "2", "3"]],
  ["directions", "Cone", "compact", ["0.75"], "Error::OutOfRange", ["0.1"]],
  ["tables", "Cdf", "exact", ["1", "-1"], "Error::NegativeWeight(1)", ["3", "1"]],
  ["tables", "Alias", "exact", ["0", "0", "0", "0", "0", "0"], "Error::AllZero", ["1"]],
  ["rejection", "Region", "exact", ["0.9", "0.5"], "Failure::BudgetSpent", ["0.5", "1"]],
  ["rejection", "Bounded", "poly", ["8", "1"], "Failure::BoundExceeded", ["8", "3.15"]],
  ["chains", "Chain", "poly", ["0", "2"], "Error::", ["0.1", "0.2"]],
];

export async function refusals(page, check) {
  for (const [family, subject, tier, bad, due, good] of REFUSED) {
    await page.call(choose, "family", family);
    await page.call(choose, "subject", subject);
    await page.call(choose, "tier", tier);
    await page.call(type, bad);
    const said = await page.call(refusal);
    check(said.includes(due), `${subject} ${tier} of ${bad.join(", ")}: due is ${due}, the page says "${said}"`);
    await page.call(type, good);
    const { count, inked } = await page.call(shown);
    check(await page.call(refusal) === "" && Number(count) > 0 && inked > 500, `${subject} ${tier}: after good parameters nothing is drawn`);
  }
  return [...new Set(REFUSED.map(([, , , , due]) => due).filter((due) => !due.endsWith("::")))];
}

// The slider's end: as many points as the shared memory holds.
export async function most_points(page, check) {
  const slide = (value) => page.call((to) => {
    const slider = document.getElementById("count");
    slider.value = to;
    slider.dispatchEvent(new Event("input", { bubbles: true }));
  }, value);
  await page.call(choose, "family", "plane");
  await slide(16);
  const { count } = await page.call(shown);
  check(Number(count) === 65536, `${count} points at the slider's end`);
  await slide(12);
}

// The sphere turns by keys and by the mouse; running goes on to new seeds and stops.
export async function turns(page, check) {
  await page.call(choose, "family", "directions");
  const image = () => page.call(() => document.getElementById("view").toDataURL());
  const before = await image();
  await page.call(() => document.getElementById("view").focus());
  await page.send("Input.dispatchKeyEvent", { type: "keyDown", key: "ArrowLeft", code: "ArrowLeft", windowsVirtualKeyCode: 37 });
  const by_key = await image();
  check(by_key !== before, "an arrow key does not turn the sphere");
  await page.send("Input.dispatchKeyEvent", { type: "keyDown", key: "Home", code: "Home", windowsVirtualKeyCode: 36 });
  check((await image()) === before, "Home does not turn the sphere back");
  const [x, y] = await page.call(() => {
    const { left, top, width, height } = document.getElementById("view").getBoundingClientRect();
    return [left + width / 2, top + height / 2];
  });
  for (const [type, dx] of [["mousePressed", 0], ["mouseMoved", 40], ["mouseReleased", 40]]) {
    await page.send("Input.dispatchMouseEvent", { type, x: x + dx, y, button: "left", buttons: 1, clickCount: 1 });
  }
  check((await image()) !== before, "dragging does not turn the sphere");
  const press = (id) => page.call((button) => document.getElementById(button).click(), id);
  const seed = () => page.call(() => Number(document.getElementById("seed").textContent));
  const first = await seed();
  await press("run");
  await page.until(`Number(document.getElementById("seed").textContent) > ${first + 3}`);
  await press("run");
  const last = await seed();
  await new Promise((resolve) => setTimeout(resolve, 400));
  check((await seed()) === last, "the page does not stop running");
  await by_arrows(page, check);
  await page.call(() => document.activeElement.blur());
}

// The arrow keys go from one choice of a group to the next, and the focus stays with them.
async function by_arrows(page, check) {
  const focused = () => page.call(() => document.activeElement.value);
  for (const group of ["family", "subject", "tier"]) {
    await page.call(choose, "family", "plane");
    await page.call((name) => document.querySelector(`input[name="${name}"]:checked`).focus(), group);
    const visited = [await focused()];
    for (let k = 0; k < 2; k += 1) {
      for (const type of ["keyDown", "keyUp"]) await page.send("Input.dispatchKeyEvent", { type, key: "ArrowRight", code: "ArrowRight", windowsVirtualKeyCode: 39 });
      visited.push(await focused());
    }
    const chosen = await page.call((name) => document.querySelector(`input[name="${name}"]:checked`).value, group);
    check(new Set(visited).size > 1 && chosen === visited.at(-1), `by arrow keys from ${visited.join(" to ")}, and chosen is ${chosen}`);
  }
}
