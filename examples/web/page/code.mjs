// The tab "In JavaScript": code that a visitor may change, run with the npm package in a worker, and what it shows and prints.

import { SNIPPETS } from "./snippets.mjs";
import { choices } from "./controls.mjs";
import { spread } from "./sample.mjs";
import { draw as draw_picture, pictured } from "../view/picture.mjs";
import { make_turnable } from "../view/sphere.mjs";

// Code that runs for longer is stopped, in seconds.
const LONGEST = 10;

const at = (id) => document.getElementById(id);
let worker, clock, scene;

function choose(name) {
  choices(at("snippets"), "snippet", Object.entries(SNIPPETS).map(([value, [label]]) => ({ value, label })), name, choose);
  [, at("text").value] = SNIPPETS[name];
  run();
}

function run() {
  close();
  scene = null;
  at("printed").textContent = "";
  at("code-refusal").hidden = true;
  at("code").dataset.state = "running";
  draw();
  worker = new Worker(new URL("./run.mjs", import.meta.url), { type: "module" });
  worker.addEventListener("message", ({ data }) => heard(data));
  worker.addEventListener("error", ({ message }) => refuse(message ?? "The worker did not start."));
  worker.postMessage(at("text").value);
  clock = setTimeout(() => refuse(`Stopped after ${LONGEST} seconds.`), 1000 * LONGEST);
}

function heard({ printed, problem, ended, ...drawn }) {
  if (drawn.shown) return show(drawn);
  if (printed !== undefined) at("printed").textContent += `${printed}\n`;
  if (problem) refuse(problem);
  if (ended) end("ended");
}

function end(state) {
  close();
  at("code").dataset.state = state;
}

function refuse(problem) {
  end("refused");
  scene = null;
  draw();
  at("code-refusal").hidden = false;
  at("code-refusal").firstElementChild.textContent = problem;
}

function show({ shown, dimensions, count, densities, indices }) {
  scene = pictured({ count, points: spread(shown, dimensions), densities, each: 0, dimensions, indices });
  draw();
}

function draw() {
  if (at("code").hidden) return;
  if (scene) draw_picture(at("shown"), scene);
  else at("shown").getContext("2d").clearRect(0, 0, at("shown").width, at("shown").height);
}

// Opens the tab, and runs the first code where none has been chosen.
export function open() {
  if (at("snippets").dataset.options) return draw();
  at("go").addEventListener("click", run);
  make_turnable(at("shown"), () => scene?.view === "sphere", draw);
  new ResizeObserver(draw).observe(at("shown"));
  return choose("normals");
}

export function close() {
  clearTimeout(clock);
  worker?.terminate();
  worker = null;
}
