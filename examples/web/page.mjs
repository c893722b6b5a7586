// The page: the selection, the drawing and the timing. The module samples. The tab with scenes and the one with code are parts
// of their own, in `page/scene.mjs` and `page/code.mjs`.

import { MOST, SOURCES, load } from "./page/module.mjs";
import { verify } from "./page/golden.mjs";
import { TIER_LABELS, families_of, realised } from "./page/catalogue.mjs";
import { choices, parameters, readings } from "./page/controls.mjs";
import * as scenes from "./page/scene.mjs";
import * as code from "./page/code.mjs";
import { framed } from "./view/frame.mjs";
import * as line from "./view/line.mjs";
import * as plane from "./view/plane.mjs";
import * as sphere from "./view/sphere.mjs";

const at = (id) => document.getElementById(id);
const whole = (n) => n.toLocaleString("en");
const figure = (x) => (x === 0 ? "0" : Math.abs(x) < 1e-2 || Math.abs(x) >= 1e5 ? x.toExponential(2) : x.toPrecision(3));

// The tabs beside those of samplers.
const TABS = { code: { label: "In JavaScript", part: code }, scene: { label: "A scene", part: scenes } };

const state = {
  family: null, entry: null, tier: "poly", source: "random", values: [], seed: 1,
  running: null, count: 0, tallied: null, scene: null, speed: null, clock: null,
};
let module;
let families;

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
  choose_tier(state.entry.tiers.includes(state.tier) ? state.tier : state.entry.tiers.at(state.entry.tiers.length > 1 ? 1 : 0));
  show_choices();
}

function choose_tier(tier) {
  const before = (state.entry.lists[state.tier] ?? []).map(({ label }) => label).join();
  const list = state.entry.lists[tier];
  const same = state.shown === state.entry && before === list.map(({ label }) => label).join();
  state.tier = tier;
  if (!same) {
    state.values = list.map(({ value }) => value);
    parameters(at("parameters"), list, (values) => {
      state.values = values;
      renew();
    });
  }
  state.shown = state.entry;
  renew();
}

// What the documentation says of a sampler, in the family of its tier where that has its own: a sentence, or bounds.
function documented({ documented: name }, tier, what) {
  const { float, integer } = module.documented[what];
  const own = name.startsWith("fixed::") || ["fine", "coarse", "compact"].includes(tier) ? integer : float;
  const type = name.replace("fixed::", "");
  return own[type] ?? float[type] ?? integer[type];
}

function show_choices() {
  const { family, entry, tier, source } = state;
  choices(at("subjects"), "subject", family.subjects.map(({ name, label }) => ({ value: name, label })), entry.name, choose_subject);
  choices(at("tiers"), "tier", entry.tiers.map((value) => ({ value, label: TIER_LABELS[value] })), tier, choose_tier);
  choices(at("sources"), "source", SOURCES.map((value) => ({ value, label: value, disabled: !entry.plans && value !== "random" })),
    entry.plans ? source : "random", (value) => {
      state.source = value;
      renew();
    });
}

// --- what is drawn --------------------------------------------------------------------------------

// The selection has changed: drop everything kept for the old one.
function renew() {
  Object.assign(state, { count: 0, tallied: null, speed: null });
  refresh(false);
  measure_speed_soon();
}

function refresh(keep) {
  const { entry, tier, seed, values } = state;
  const count = Math.min(MOST, 2 ** Number(at("count").value));
  at("count-text").textContent = whole(count);
  at("seed").textContent = String(seed);
  const p = values.map((value) => realised(entry, tier, value));
  const source = entry.plans ? state.source : "random";
  const request = { subject: entry.name, place: entry.places[tier], tier, source, dimensions: entry.words, count, seed, parameters: p };
  const drawn = module.sample(request);
  at("summary").textContent = documented(entry, tier, "summaries");
  document.body.dataset.shown = `${entry.name} ${tier}`;
  if (drawn.refused) return show_refusal(drawn.refused, request);
  const frame = (keep ? state.scene?.frame : null) ?? framed(drawn, entry.flat);
  state.count = count + (keep ? state.count : 0);
  if (entry.view === "line" || entry.view === "bars") state.tallied = line.tally(keep ? state.tallied : null, { entry, drawn, frame });
  state.scene = { entry, drawn, frame, request, tallied: state.tallied };
  draw(keep);
  show_readings();
}

// Measures speed only after a moment without changes, so that dragging a slider stays smooth.
function measure_speed_soon() {
  clearTimeout(state.clock);
  state.clock = setTimeout(measure_speed, 200);
}

function measure_speed() {
  if (!state.scene || state.running) return;
  state.speed = module.time(state.scene.request);
  show_readings();
}

// --- what is shown -----------------------------------------------------------------------------------

function draw(keep) {
  const { scene } = state;
  if (!scene || at("bench").hidden) return;
  const { entry } = scene;
  const pictures = { line: line.draw, bars: line.draw_bars, plane: plane.draw, sphere: sphere.draw };
  const turnable = entry.view === "sphere";
  at("refusal").hidden = true;
  at("uniforms").hidden = entry.words !== 2 || !["plane", "sphere"].includes(entry.view);
  at("view").classList.toggle("turnable", turnable);
  at("view").tabIndex = turnable ? 0 : -1;
  pictures[entry.view](at("view"), { ...scene, keep: keep && entry.view === "plane" && state.count < 1 << 18 });
  if (!at("uniforms").hidden) plane.draw_uniforms(at("square"), { ...scene, keep: false });
}

// The column of a tier in the documentation's tables of errors.
const COLUMN = { libm: 0, poly: 1, exact: 0, fine: 0, coarse: 1, compact: 2 };

// What a rejection, and what a chain reports of itself.
function of_family(family, [first, second]) {
  const percent = (share) => `${(100 * share).toFixed(1)} %`;
  if (family === "rejection") return [{ label: "Accepted", value: percent(first / second), note: `of ${whole(second)} tries` }];
  if (family !== "chains") return [];
  return [
    { label: "Accepted", value: percent(first), note: "of the proposals" },
    { label: "Autocorrelation time", value: second > 0 ? second.toFixed(1) : "–", note: second > 0 ? "steps" : "longer than 256 steps" },
  ];
}

function show_readings() {
  const { scene: { entry, drawn, request }, speed } = state;
  const densities = drawn.densities.subarray(0, drawn.count);
  const [least, most] = [densities.reduce((a, b) => Math.min(a, b)), densities.reduce((a, b) => Math.max(a, b))];
  readings(at("readings"), [
    ...Object.entries(documented(entry, request.tier, "bounds") ?? {}).map(([quantity, cells]) => (
      { label: `Error of ${quantity}`, value: `≤ ${cells[COLUMN[request.tier]]}`, note: "stated" })),
    { label: "Density", value: least === most ? figure(least) : `${figure(least)} to ${figure(most)}`, note: "reported at the points" },
    ...of_family(entry.family, drawn.report),
    speed ? {
      label: "Speed", value: figure(1e3 / speed.point), unit: "million/s",
      note: `${figure(speed.point)} ns a point; a word of PCG32 alone ${figure(speed.word)}`,
    } : { label: "Speed", value: "…", note: "in this browser, PCG32 included" },
  ]);
  Object.assign(document.body.dataset, { density: `${least} ${most}`, refused: "", count: String(request.count) });
  at("caption").textContent = captions[entry.view](entry);
  at("view").setAttribute("aria-label", `${entry.label}, ${TIER_LABELS[request.tier]}: ${whole(request.count)} points. ${captions[entry.view](entry)}`);
}

const captions = {
  line: () => "Bars: the points drawn. Line: the density that is reported.",
  bars: () => "Bars: how often each index was selected. Lines: the shares that are reported.",
  plane: (entry) => (entry.trail ? "States in the order of their colours." : "Points in the colour of their first uniform."),
  sphere: () => "Turn it by dragging or with the arrow keys; Home turns it back. +z is up.",
};

function show_refusal({ name, meaning }, request) {
  state.scene = null;
  stop();
  const context = at("view").getContext("2d");
  context.clearRect(0, 0, at("view").width, at("view").height);
  at("uniforms").hidden = true;
  const refusal = at("refusal");
  refusal.hidden = false;
  refusal.querySelector("strong").textContent = name;
  refusal.querySelector("span").textContent = meaning;
  at("caption").textContent = "";
  at("view").setAttribute("aria-label", `${request.subject}: nothing is drawn, ${name}`);
  readings(at("readings"), []);
  Object.assign(document.body.dataset, { refused: name, density: "", count: "0" });
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
  at("clock").addEventListener("click", measure_speed);
  at("controls").addEventListener("submit", (event) => event.preventDefault());
  sphere.make_turnable(at("view"), () => state.scene?.entry.view === "sphere", () => draw(false));
  new ResizeObserver(() => draw(false)).observe(at("view"));
  window.matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => draw(false));
}

// --- the golden bits ---------------------------------------------------------------------------------

function browser() {
  const brand = navigator.userAgentData?.brands?.find(({ brand }) => !/not/i.test(brand));
  return brand ? `${brand.brand} ${brand.version}` : (/(Firefox|Chrome|Version)\/[\d.]+/.exec(navigator.userAgent)?.[0] ?? "this browser");
}

async function show_golden() {
  const said = at("golden");
  try {
    const { cases, agreed, problems } = await verify(module, "golden.csv");
    said.dataset.state = problems.length === 0 ? "verified" : "mismatch";
    said.textContent = problems.length === 0
      ? `Golden bits verified: all ${whole(agreed)} words of ${whole(cases)} cases agree in ${browser()}.`
      : `Golden bits MISMATCH: ${whole(problems.length)} of ${whole(agreed + problems.length)} do not agree in ${browser()}. First: ${problems[0]}.`;
  } catch (problem) {
    said.dataset.state = "mismatch";
    said.textContent = `Golden bits NOT verified: ${problem.message}.`;
  }
}

try {
  module = await load("microwarp.wasm");
  families = families_of(module.subjects);
  at("module").textContent = `The module is ${whole(module.size)} bytes, imports ${module.imports === 0 ? "nothing and cannot panic" : `${module.imports} functions`}.`;
  wire();
  choose_family(scenes.asked() ? "scene" : "plane");
  await show_golden();
} catch (problem) {
  at("golden").dataset.state = "mismatch";
  at("golden").textContent = `The module could not be loaded: ${problem.message}.`;
  throw problem;
}
