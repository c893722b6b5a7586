// What the test does as a visitor would: choosing, typing, turning. These functions run in the page.

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

// What is shown of a drawn sampler is what was chosen: points, and densities that are positive and finite.
export function drawn(what, { shown: name, summary, refused, count, inked, density }, check) {
  check(name === what, `${what} was chosen, and the page shows ${name}`);
  check(summary !== "" && summary !== "undefined", `${what}: no word on what it is`);
  check(refused === "", `${what}: refused, ${refused}`);
  check(Number(count) > 0 && inked > 500, `${what}: ${count} points, ${inked} pixels drawn`);
  const [least, most] = density.split(" ").map(Number);
  check(least > 0 && most < Infinity, `${what}: its densities are from ${least} to ${most}`);
}

// The families of samplers, each with its subjects; none of the package's classes may be missing.
export async function subjects_of(page, microwarp, check) {
  const found = [];
  for (const family of (await page.call(options, "family")).filter((name) => !["code", "scene"].includes(name))) {
    await page.call(choose, "family", family);
    found.push([family, await page.call(options, "subject")]);
  }
  const names = found.flatMap(([, subjects]) => subjects.map((subject) => subject.split(".")[0]));
  const warps = Object.keys(microwarp).filter((name) => microwarp[name].prototype instanceof microwarp.Warp);
  const missing = [...warps, "Alias", "Cdf", "Chain"].filter((name) => !names.includes(name));
  check(warps.length >= 59 && missing.length === 0, `of ${warps.length} warps the page does not show ${missing.join(", ")}`);
  return found;
}

// Chooses every sampler once, and for each every plan of uniforms. Gives what was seen.
export async function every_subject(page, microwarp, check) {
  const seen = [];
  for (const [family, subjects] of await subjects_of(page, microwarp, check)) {
    await page.call(choose, "family", family);
    for (const subject of subjects) {
      await page.call(choose, "subject", subject);
      // What is no warp has no such table, nor has a mixture, which adds to the errors of its parts, or a reflection.
      const stated = subject in microwarp ? microwarp[subject].prototype instanceof microwarp.Warp : true;
      if (["line", "plane", "directions", "space"].includes(family) && stated && !["Mixture", "Reflected"].includes(subject)) {
        const { text } = await page.call(shown);
        check(/Error of sample[^≤]*≤ \S/.test(text), `${subject}: no bound is stated: ${text}`);
      }
      for (const source of await page.call(options, "source")) {
        await page.call(choose, "source", source);
        drawn(subject, await page.call(shown), check);
        seen.push(subject);
      }
      await page.call(choose, "source", "random");
    }
  }
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

// Parameters that a constructor refuses, and the code and words that are due; then good ones.
const REFUSED = [
  ["line", "Interval", ["5", "-5"], "code 2 parameter 2 is below its lower bound", ["-3", "5"]],
  ["line", "Exponential.fromRate", ["nan"], "code 1 parameter 1 is NaN or infinite", ["1"]],
  ["line", "Tent", ["inf"], "code 1", ["1"]],
  ["line", "Power", ["-1", "0", "1"], "code 8", ["1", "0", "1"]],
  ["plane", "TriangleOn2d", ["0", "0", "1", "1", "2", "2"], "code 3", ["0", "0", "4", "0", "1", "3"]],
  ["directions", "VisibleSphere", ["0", "-1"], "RangeError", ["2", "1"]],
  ["directions", "Cone.fromRadians", ["4"], "code 7", ["0.1"]],
  ["tables", "Cdf", ["1", "-1"], "weight 1 is negative", ["3", "1"]],
  ["tables", "Alias", ["0", "0", "0", "0", "0", "0"], "every weight is zero", ["1"]],
  ["chains", "Chain", ["0", "2"], "RangeError", ["0.1", "0.2"]],
];

export async function refusals(page, check) {
  for (const [family, subject, bad, due, good] of REFUSED) {
    await page.call(choose, "family", family);
    await page.call(choose, "subject", subject);
    await page.call(type, bad);
    const said = await page.call(refusal);
    check(said.includes(due), `${subject} of ${bad.join(", ")}: due is ${due}, the page says "${said}"`);
    await page.call(type, good);
    const { count, inked } = await page.call(shown);
    check(await page.call(refusal) === "" && Number(count) > 0 && inked > 500, `${subject}: after good parameters nothing is drawn`);
  }
  return REFUSED.map(([, subject]) => subject);
}

// The slider's end: as many points as the page draws.
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
  for (const group of ["family", "subject", "source"]) {
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
