// Metropolis chains with a target in JavaScript: the module proposes and decides, the target is called between. The chain's
// state is its own: the target and whoever reads it get copies.

import { BLOCK, BUFFERS, Loaded, OUT, numbers, point, put_state, put_words, integer, ready, refuse, wasm, word_at, wrong } from "./core.js";

const OUTCOMES = ["rejected", "accepted", "refused"];
// Words take two numbers more than coordinates.
const MOST = BLOCK - 2;

const is_array = (value) => Array.isArray(value) || ArrayBuffer.isView(value);

export class Chain {
  #target;
  #step;
  #dimensions;
  #words;
  #log;
  #scalar;
  #state;
  #density;
  #steps;
  #accepted;
  #refused;
  constructor(target, start, step) {
    if (typeof target !== "function") throw wrong("a target: a function", target);
    if (typeof start !== "number" && !is_array(start)) throw wrong("a start: a number or an array of numbers", start);
    const { normal, box, cube, logDensity = false } = step ?? {};
    if ((normal === undefined) === (box === undefined)) throw wrong("a step such as { normal: 1 } or { box: [1, 1] }", step);
    if (typeof logDensity !== "boolean") throw wrong("logDensity: a boolean", logDensity);
    this.#scalar = typeof start === "number";
    const dimensions = this.#scalar ? 1 : integer("coordinates", start.length, 1, MOST);
    const widths = numbers(normal ?? box, dimensions);
    const bits = new Uint32Array(3 + dimensions);
    bits.set([box === undefined ? 1 : 0, cube === undefined ? 0 : 1]);
    new Float32Array(bits.buffer).set([...numbers(cube ?? 0, 1), ...widths], 2);
    this.#target = target;
    this.#step = new Loaded(bits);
    this.#dimensions = dimensions;
    this.#words = dimensions + 1 + bits[1];
    this.#log = logDensity ? 1 : 0;
    this.#state = numbers(start, dimensions).map(Math.fround);
    // The widths are refused here, by a step that takes them all.
    put_words(new Uint32Array(this.#words).fill(-1));
    this.#propose(0);
    this.#density = this.#weigh(this.#state);
    this.#stands();
    this.reset();
  }
  get state() {
    return this.#copy(this.#state);
  }
  get density() {
    return this.#density;
  }
  get steps() {
    return this.#steps;
  }
  get accepted() {
    return this.#accepted;
  }
  get refused() {
    return this.#refused;
  }
  get acceptanceRate() {
    return this.#steps > 0 ? this.#accepted / this.#steps : undefined;
  }
  reset() {
    this.#steps = this.#accepted = this.#refused = 0;
    return this;
  }
  step(source) {
    const [from, fromDensity] = [this.#state, this.#density];
    const proposed = this.#propose(ready(source, this.#words, 1));
    const word = word_at(this.#words - 1);
    const proposedDensity = this.#weigh(proposed);
    const outcome = wasm.settle(BUFFERS, fromDensity, proposedDensity, word, this.#log);
    const acceptance = point(OUT, 1);
    this.#steps += 1;
    if (outcome === 1) {
      this.#accepted += 1;
      this.#state = proposed;
      this.#density = proposedDensity;
    } else if (outcome === 2) this.#refused += 1;
    return {
      from: this.#copy(from), fromDensity, proposed: this.#copy(proposed), proposedDensity, acceptance, outcome: OUTCOMES[outcome],
    };
  }
  save() {
    const { state, density, steps, accepted, refused } = this;
    return { state, density, steps, accepted, refused };
  }
  resume(saved) {
    const { state, density, steps, accepted, refused } = saved ?? {};
    if (typeof density !== "number") throw wrong("density: a number", density);
    const [own, before] = [numbers(state, this.#dimensions).map(Math.fround), this.#density];
    integer("steps", steps, 0, Number.MAX_SAFE_INTEGER);
    integer("accepted", accepted, 0, steps);
    integer("refused", refused, 0, steps - accepted);
    this.#density = Math.fround(density);
    try {
      this.#stands();
    } catch (refusal) {
      this.#density = before;
      throw refusal;
    }
    [this.#state, this.#steps, this.#accepted, this.#refused] = [own, steps, accepted, refused];
    return this;
  }

  #copy(state) {
    if (this.#scalar) return state[0];
    const copy = [];
    for (let i = 0; i < state.length; i += 1) copy.push(state[i]);
    return copy;
  }
  // What a step proposes, by words drawn before or in the memory.
  #propose(random) {
    const step = this.#step.address();
    put_state(this.#state);
    refuse(wasm.propose(step, BUFFERS, this.#dimensions, random));
    return this.#dimensions === 1 ? [point(OUT, 1)] : point(OUT, this.#dimensions);
  }
  #weigh(state) {
    const density = this.#target(this.#copy(state));
    if (typeof density !== "number") throw wrong("a number from the target", density);
    return Math.fround(density);
  }
  // A start without a density is what a table of nothing is.
  #stands() {
    if (wasm.settle(BUFFERS, this.#density, this.#density, 0, this.#log) === 3) {
      throw new RangeError(this.#log ? "the target must be finite at the start" : "the target must be positive and finite at the start");
    }
  }
}
