// The tab "A scene": what is chosen, and what the worker tells of the picture. The worker and its module are loaded when the
// tab is opened for the first time.

import { choices, readings } from "./controls.mjs";
import { expose } from "../view/film.mjs";

const at = (id) => document.getElementById(id);
const whole = (n) => n.toLocaleString("en");

const SCENES = {
  room: ["A matte room", "A matte room below a lamp and beside a window: lights by their solid angle."],
  fog: ["Glossy balls in fog", "Metal and lacquer in fog: GGX, Phong lobes, equi-angular distances, Henyey-Greenstein."],
  slivers: ["A sky over slivers", "Slivers of brass under an evening sky: directions from a table of the sky."],
  slit: ["Light through a slit", "A dark room, lit through a slit in its wall: what paths find hard."],
  sensor: ["A range sensor in fog", "What a range sensor with a lamp of its own reports in a foggy hall: near is yellow, far is blue."],
};
const POINTS = { pcg32: "random", by_position: "by position", strata: "strata", sobol: "Sobol’" };
const WIDTHS = [48, 96, 144, 288];
const RATIO = 2 / 3;

const state = { scene: "room", tier: "poly", points: "sobol", width: 144, seed: 42, job: 0, running: false, told: null };
let worker;
let module;
let hashes;

// --- what is chosen ----------------------------------------------------------------------------------

// A choice has been made: the page's address names it, and the worker starts anew.
function choose(choice) {
  Object.assign(state, choice);
  const { scene, tier, points, width, seed } = state;
  history.replaceState(null, "", `?${new URLSearchParams({ scene, tier, points, width, seed })}`);
  show_choices();
  begin();
}

function show_choices() {
  const { scene, tier, points, width } = state;
  const group = (id, options, chosen, choice) => choices(at(id), id, options.map(([value, label]) => ({ value, label })), chosen, (value) => choose(choice(value)));
  group("scenes", module.scenes.map((name) => [name, SCENES[name]?.[0] ?? name]), scene, (scene) => ({ scene }));
  group("scene-tier", module.tiers.map((name) => [name, name]), tier, (tier) => ({ tier }));
  group("scene-points", module.points.map((name) => [name, POINTS[name] ?? name]), points, (points) => ({ points }));
  group("scene-width", WIDTHS.map((columns) => [String(columns), `${columns} × ${columns * RATIO}`]), String(width), (columns) => ({ width: Number(columns) }));
  at("scene-seed").textContent = String(state.seed);
  at("scene-summary").textContent = SCENES[scene]?.[1] ?? "";
}

// A whole number that 32 bits hold, or why not.
function number(asked, name) {
  if (!/^\d+$/.test(asked) || Number(asked) >= 2 ** 32) throw new Error(`The ${name} "${asked}" is not a whole number below 2³².`);
  return Number(asked);
}

// What the page's address asks for, beyond what is chosen already.
function from_address() {
  const asked = new URLSearchParams(location.search);
  for (const name of ["scene", "tier", "points"]) state[name] = asked.get(name) ?? state[name];
  for (const name of ["width", "seed"]) if (asked.has(name)) state[name] = number(asked.get(name), name);
}

// --- the worker --------------------------------------------------------------------------------------

function most() {
  return 2 ** Number(at("passes").value);
}

function begin() {
  const { scene, tier, points, width, seed } = state;
  const height = Math.floor(width * RATIO);
  state.job += 1;
  state.told = { samples: 0, rate: null, error: null, request: { scene, tier, points, width, height, seed } };
  at("scene-refusal").hidden = true;
  Object.assign(at("scene").dataset, { shown: `${scene} ${tier} ${points}`, refused: "", samples: "0", error: "" });
  verdict("waiting", "To be compared with the golden table.");
  if (width > 0 && height > 0 && width * height <= module.most) Object.assign(at("film"), { width, height });
  worker.postMessage({ job: state.job, ...state.told.request, samples: most() / 2 });
  running(true);
  show_readings();
}

function stop() {
  state.job += 1;
  worker?.postMessage({ job: state.job });
  running(false);
}

function running(runs) {
  state.running = runs;
  at("render").textContent = runs ? "Stop" : "Render again";
}

function heard({ ready, broken, job, refused, hash, light, ...told }) {
  if (broken) return refuse("The scenes could not be loaded", `${broken}.`);
  if (ready) return opened(ready);
  if (job !== state.job) return undefined;
  if (refused) return refuse("No picture", refused);
  if (hash !== undefined) return judge(hash);
  if (light) expose(at("film"), { ...state.told.request, from: told.from, light });
  Object.assign(state.told, told);
  if (told.error !== undefined) passed(told);
  if (told.last) running(false);
  return show_readings();
}

// A pass has ended.
function passed({ samples, error }) {
  const { scene, tier, points } = state.told.request;
  Object.assign(at("scene").dataset, { samples: String(samples), error: String(error) });
  at("film").setAttribute("aria-label", `${SCENES[scene][0]}, ${tier}, ${POINTS[points]}: ${whole(samples)} samples a pixel, error ${percent(error)}`);
}

function refuse(name, meaning) {
  stop();
  const [refusal, canvas] = [at("scene-refusal"), at("film")];
  canvas.getContext("2d").clearRect(0, 0, canvas.width, canvas.height);
  canvas.setAttribute("aria-label", `Nothing is rendered: ${meaning}`);
  refusal.hidden = false;
  refusal.querySelector("strong").textContent = name;
  refusal.querySelector("span").textContent = meaning;
  at("scene").dataset.refused = meaning;
  verdict("waiting", "Nothing to compare.");
  readings(at("scene-readings"), []);
}

// --- what is shown -----------------------------------------------------------------------------------

const percent = (x) => (Number.isFinite(x) ? `${(100 * x).toPrecision(3)} %` : "not known");

function show_readings() {
  const { samples, error, rate } = state.told;
  const last = whole(most());
  readings(at("scene-readings"), [
    { label: "Error of the picture", value: error === null ? "…" : percent(error), note: "of its mean light: the noise, root mean square" },
    { label: "Samples a pixel", value: whole(samples), note: state.running ? `on the way to ${last}` : "rendering has stopped" },
    { label: "Speed", value: rate ? whole(Math.round(rate / 1000)) : "…", unit: "thousand samples/s", note: rate ? `${(1e6 / rate).toPrecision(3)} µs a path, in one worker` : "in one worker" },
  ]);
}

const hex = (word) => word.toString(16).padStart(8, "0");

function verdict(kind, text) {
  const place = at("host");
  place.dataset.state = kind;
  if (place.textContent !== text) place.textContent = text;
}

// Compares the hash of a small picture with the one that every target reproduces.
function judge(hash) {
  if (hashes instanceof Error) return verdict("mismatch", `NOT compared with the golden table: ${hashes.message}.`);
  const { request: { scene, tier, points } } = state.told;
  const { width, height, samples, seed } = module.plan;
  const [got, due] = [hex(hash), hashes.get(`${scene} ${tier} ${points} ${width}x${height} ${samples} ${seed}`)];
  return got === due
    ? verdict("verified", `The same bits as on every other target: ${width} × ${height} pixels of this scene have the hash ${got}.`)
    : verdict("mismatch", `MISMATCH with the golden table: ${width} × ${height} pixels of this scene have the hash ${got} here, ${due} there.`);
}

// --- opening and closing -----------------------------------------------------------------------------

async function table(url) {
  const response = await fetch(url);
  if (!response.ok) throw new Error(`${url}: ${response.status}`);
  return new Map((await response.text()).trim().split("\n").map((row) => row.split(",")));
}

// The module is there, and perhaps the tab has been left.
async function opened(ready) {
  hashes = await table("scene.csv").catch((problem) => problem);
  module = ready;
  const { size, imports } = module;
  at("scene-module").textContent = `The module of the scenes is ${whole(size)} bytes, loaded with this tab; it imports ${imports === 0 ? "nothing and cannot panic" : `${imports} functions`}.`;
  wire();
  if (!at("scene").hidden) resume();
}

function wire() {
  at("passes").addEventListener("input", () => {
    show_most();
    begin();
  });
  at("render").addEventListener("click", () => (state.running ? stop_and_show() : begin()));
  at("scene-again").addEventListener("click", () => choose({ seed: (state.seed + 2) % 2 ** 32 }));
  at("scene-controls").addEventListener("submit", (event) => event.preventDefault());
}

function resume() {
  try {
    from_address();
  } catch (problem) {
    show_choices();
    return refuse("No picture", problem.message);
  }
  return choose({});
}

export const asked = () => new URLSearchParams(location.search).has("scene");

export function open() {
  if (module) return resume();
  if (worker) return undefined;
  worker = new Worker(new URL("./render.mjs", import.meta.url), { type: "module" });
  worker.addEventListener("message", ({ data }) => heard(data));
  worker.addEventListener("error", ({ message }) => refuse("The scenes could not be loaded", message ?? "The worker did not start."));
  return show_most();
}

function stop_and_show() {
  stop();
  show_readings();
}

function show_most() {
  at("passes-text").textContent = whole(most());
}

export function close() {
  if (!worker) return;
  stop();
  history.replaceState(null, "", location.pathname);
}
