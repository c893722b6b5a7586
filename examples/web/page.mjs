// The page: the selection and the drawing. The npm package samples. The tab with scenes and the one with code are parts of
// their own, in `page/scene.mjs` and `page/code.mjs`.

import { MOST, SOURCES, documented, is_offered, nanoseconds, sample } from "./page/sample.mjs";
import { families_of } from "./page/catalogue.mjs";
import { choices, parameters, readings } from "./page/controls.mjs";
import * as scenes from "./page/scene.mjs";
import * as code from "./page/code.mjs";
import { draw as draw_picture, pictured } from "./view/picture.mjs";
import { draw_uniforms } from "./view/plane.mjs";
import { make_turnable } from "./view/sphere.mjs";

const at = (id) => document.getElementById(id);
const whole = (n) => n.toLocaleString("en");
const figure = (x) => (x === 0 ? "0" : Math.abs(x) < 1e-2 || Math.abs(x) >= 1e5 ? x.toExponential(2) : x.toPrecision(3));

// The tabs beside those of samplers.
const TABS = { code: { label: "In JavaScript", part: code }, scene: { label: "A scene", part: scenes } };

const state = { family: null, entry: null, source: "random", values: [], seed: 1, running: null, count: 0, scene: null, speed: null, clock: null };
let microwarp;
let families;
let docs;

// --- what is chosen ----------------------------------------------------------------------------------

function choose_family(name) {
  for (const id of ["scenes", "scene", "scene-controls"]) at(id).hidden = name !== "scene";
  for (const id of ["snippets", "code"]) at(id).hidden = name !== "code";
  for (const id of ["subjects", "bench", "controls"]) at(id).hidden = name in TABS;
  const tabs = Object.entries(TABS).map(([value, { label }]) => ({ value, label }));
  choices(at("families"), "family", [...families.map(({ name, label }) => ({ value: name, label })), ...tabs], name, choose_family);
  for (const [other, { part }] of Object.entries(TABS)) if (other !== name) part.close();
  if (name in TABS) {
    stop();
    clearTimeout(state.clock);
    return TABS[name].part.open();
  }
  state.family = families.find((family) => family.name === name);
  return choose_subject(state.family.subjects[0].name);
}

function choose_subject(name) {
  state.entry = state.family.subjects.find((entry) => entry.name === name);
  state.values = state.entry.parameters.map(({ value }) => value);
  choices(at("subjects"), "subject", state.family.subjects.map(({ name }) => ({ value: name, label: name })), name, choose_subject);
  parameters(at("parameters"), state.entry.parameters, (values) => {
    state.values = values;
    renew();
  });
  renew();
}

function show_sources(each) {
  const offered = SOURCES.map((value) => ({ value, label: value, disabled: !is_offered(value, each) }));
  choices(at("sources"), "source", offered, is_offered(state.source, each) ? state.source : "random", (value) => {
    state.source = value;
    renew();
  });
}

// --- what is drawn --------------------------------------------------------------------------------

// The selection has changed: drop everything kept for the old one.
function renew() {
  Object.assign(state, { count: 0, speed: null });
  refresh(false);
  // Only after a moment without changes, so that dragging a slider stays smooth.
  clearTimeout(state.clock);
  state.clock = setTimeout(measure_speed, 200);
}

function refresh(keep) {
  const { entry, seed, values } = state;
  const count = Math.min(MOST, 2 ** Number(at("count").value));
  at("count-text").textContent = whole(count);
  at("seed").textContent = String(seed);
  at("summary").textContent = docs[entry.of]?.summary ?? "";
  document.body.dataset.shown = entry.name;
  let made, drawn;
  try {
    made = entry.make(values);
    show_sources(made.uniforms ?? 0);
    const source = is_offered(state.source, made.uniforms ?? 0) ? state.source : "random";
    drawn = sample(microwarp, made, { source, count, seed });
  } catch (refusal) {
    return show_refusal(refusal);
  }
  state.count = count + (keep ? state.count : 0);
  state.scene = { ...pictured(drawn, keep ? state.scene : null), entry, made };
  draw(keep);
  show_readings();
}

function measure_speed() {
  if (!state.scene || state.running) return;
  state.speed = nanoseconds(microwarp, state.scene.made);
  show_readings();
}

// --- what is shown -----------------------------------------------------------------------------------

function draw(keep) {
  const { scene } = state;
  if (!scene || at("bench").hidden) return;
  const { view, drawn } = scene;
  at("refusal").hidden = true;
  at("uniforms").hidden = drawn.each !== 2 || !["plane", "sphere"].includes(view);
  at("view").classList.toggle("turnable", view === "sphere");
  at("view").tabIndex = view === "sphere" ? 0 : -1;
  draw_picture(at("view"), { ...scene, keep: keep && view === "plane" && state.count < 1 << 18 });
  if (!at("uniforms").hidden) draw_uniforms(at("square"), scene);
}

const captions = {
  line: "Bars: the points drawn. Line: the density that is reported.",
  bars: "Bars: how often each index was selected. Lines: the shares that are reported.",
  plane: "Points in the colour of their first uniform, or of their turn.",
  sphere: "Turn it by dragging or with the arrow keys; Home turns it back. +z is up.",
};

function show_readings() {
  const { scene: { entry, made, view, drawn }, speed } = state;
  const [least, most] = [drawn.densities.reduce((a, b) => Math.min(a, b)), drawn.densities.reduce((a, b) => Math.max(a, b))];
  readings(at("readings"), [
    ...(docs[entry.of]?.bounds ?? []).map(([quantity, bound]) => ({ label: `Error of ${quantity}`, value: `≤ ${bound}`, note: "stated" })),
    { label: "Density", value: least === most ? figure(least) : `${figure(least)} to ${figure(most)}`, note: "reported at the points" },
    ...(made.acceptanceRate === undefined ? [] : [{ label: "Accepted", value: `${(100 * made.acceptanceRate).toFixed(1)} %`, note: "of the proposals" }]),
    speed ? { label: "Speed", value: figure(1e3 / speed), unit: "million/s", note: `${figure(speed)} ns a point` }
      : { label: "Speed", value: "…", note: "in this browser, PCG32 included" },
  ]);
  Object.assign(document.body.dataset, { density: `${least} ${most}`, refused: "", count: String(drawn.count) });
  at("caption").textContent = captions[view];
  at("view").setAttribute("aria-label", `${entry.name}: ${whole(drawn.count)} points. ${captions[view]}`);
}

function show_refusal({ name, message, code }) {
  state.scene = null;
  stop();
  const context = at("view").getContext("2d");
  context.clearRect(0, 0, at("view").width, at("view").height);
  at("uniforms").hidden = true;
  const refusal = at("refusal");
  refusal.hidden = false;
  refusal.querySelector("strong").textContent = code === undefined ? name : `${name}, code ${code}`;
  refusal.querySelector("span").textContent = message;
  at("caption").textContent = "";
  at("view").setAttribute("aria-label", `${state.entry.name}: nothing is drawn, ${message}`);
  readings(at("readings"), []);
  Object.assign(document.body.dataset, { refused: message, density: "", count: "0" });
}

// --- running -----------------------------------------------------------------------------------------

function stop() {
  clearInterval(state.running);
  state.running = null;
  at("run").setAttribute("aria-pressed", "false");
  at("run").textContent = "Run";
}

function start() {
  const calm = window.matchMedia("(prefers-reduced-motion: reduce)").matches;
  state.running = setInterval(() => {
    state.seed += 1;
    refresh(true);
  }, calm ? 1000 : 150);
  at("run").setAttribute("aria-pressed", "true");
  at("run").textContent = "Stop";
}

function wire() {
  at("count").addEventListener("input", renew);
  at("again").addEventListener("click", () => {
    state.seed += 1;
    renew();
  });
  at("run").addEventListener("click", () => (state.running ? stop() : start()));
  at("controls").addEventListener("submit", (event) => event.preventDefault());
  make_turnable(at("view"), () => state.scene?.view === "sphere", () => draw(false));
  new ResizeObserver(() => draw(false)).observe(at("view"));
  window.matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => draw(false));
}

// --- the golden bits ---------------------------------------------------------------------------------

function browser() {
  const brand = navigator.userAgentData?.brands?.find(({ brand }) => !/not/i.test(brand));
  return brand ? `${brand.brand} ${brand.version}` : (/(Firefox|Chrome|Version)\/[\d.]+/.exec(navigator.userAgent)?.[0] ?? "this browser");
}

const text = async (url) => {
  const response = await fetch(url);
  if (!response.ok) throw new Error(`${url}: ${response.status}`);
  return response.text();
};

// As the test of the package compares them, in this browser.
async function show_golden() {
  const said = at("golden");
  try {
    const { differing } = await import("./lines.mjs");
    const { cases, wrong } = differing(microwarp, JSON.parse(await text("expected.json")), await text("golden.csv"));
    said.dataset.state = wrong.length === 0 ? "verified" : "mismatch";
    said.textContent = wrong.length === 0
      ? `Golden bits verified: all ${whole(cases)} cases of the package agree in ${browser()}.`
      : `Golden bits MISMATCH: ${whole(wrong.length)} of ${whole(cases)} cases do not agree in ${browser()}. First: ${wrong[0]}.`;
  } catch (problem) {
    said.dataset.state = "mismatch";
    said.textContent = `Golden bits NOT verified: ${problem.message}.`;
  }
}

try {
  microwarp = await import("./npm/streaming.js");
  families = families_of(microwarp);
  docs = await documented("npm");
  wire();
  choose_family(scenes.asked() ? "scene" : "plane");
  await show_golden();
} catch (problem) {
  at("golden").dataset.state = "mismatch";
  at("golden").textContent = `The package could not be loaded: ${problem.message}. Build it first: examples/web/build`;
  throw problem;
}
