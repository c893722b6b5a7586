// What all warps have in common, and how their classes are made from one line each.

import { BUFFERS, Loaded, OUT, from_array, from_source, in_blocks, keep, kept_point, numbers, place_ahead, plan, point, put, view, wasm, written } from "./core.js";

const [DRAW, SAMPLE, PDF, INVERT] = [0, 1, 2, 3];
// Room for the largest warp, as src/warps.rs asserts.
const LARGEST = 128;

// What is loaded of a warp, its number, whether that is one of a table, and its figures, whatever a class made of it says.
export let inside;

// Of all warps: how many uniforms and numbers a point has, and the words of a draw.
export class Warp {
  #loaded;
  #number;
  #table;
  #words;
  #uniforms;
  #dimensions;
  static {
    inside = (warp) => [warp.#loaded, warp.#number, warp.#table, warp.#words, warp.#uniforms, warp.#dimensions];
  }
  // What is loaded, and its number among the warps or, of a table, its kind.
  constructor(loaded, number, figures, table = false) {
    // No caller has one, whatever class is made of this one.
    if (!(loaded instanceof Loaded)) throw new TypeError("a class of a warp is expected, not Warp");
    [this.#loaded, this.#number, this.#table] = [loaded, number, table];
    [this.#uniforms, this.#dimensions, this.#words] = figures;
  }
  get uniforms() {
    return this.#uniforms;
  }
  get dimensions() {
    return this.#dimensions;
  }
  draw(source) {
    const at = place_ahead(this, source);
    if (at >= 0) return kept_point(at);
    const [words, dimensions] = [this.#words, this.#dimensions];
    const many = plan(this, source, words, dimensions);
    this.#evaluate(DRAW, words, dimensions, Math.abs(many), many > 0 ? many * words : 0);
    keep();
    return point(OUT, dimensions);
  }
  sample(uniforms) {
    put(uniforms, this.#uniforms);
    return this.#one(SAMPLE, this.#uniforms, this.#dimensions);
  }
  pdf(at) {
    put(at, this.#dimensions);
    return this.#one(PDF, this.#dimensions, 1);
  }
  invert(at) {
    put(at, this.#dimensions);
    return this.#one(INVERT, this.#dimensions, this.#uniforms);
  }
  fill(points, source) {
    const own = view(points, Float32Array, this.#dimensions);
    this.#all(DRAW, from_source(source, this.#words), this.#words, own, this.#dimensions);
    return points;
  }
  map(uniforms, points) {
    return this.#arrays(SAMPLE, uniforms, this.#uniforms, points, this.#dimensions);
  }
  pdfs(points, densities) {
    return this.#arrays(PDF, points, this.#dimensions, densities, 1);
  }
  inverts(points, uniforms) {
    return this.#arrays(INVERT, points, this.#dimensions, uniforms, this.#uniforms);
  }

  #evaluate(what, inputs, outputs, count, random) {
    const at = this.#loaded.address();
    if (this.#table) wasm.look_up(this.#number, what, at, BUFFERS, inputs, outputs, count, random);
    else wasm.evaluate(this.#number, what, at, BUFFERS, inputs, outputs, count, random);
  }
  #one(what, inputs, outputs) {
    this.#evaluate(what, inputs, outputs, 1, 0);
    return point(OUT, outputs);
  }
  #all(what, feed, inputs, output, outputs) {
    in_blocks(feed, inputs, output, outputs, (n, random) => this.#evaluate(what, inputs, outputs, n, random));
  }
  #arrays(what, input, inputs, output, outputs) {
    const [from, to] = [view(input, Float32Array, inputs), view(output, Float32Array, outputs)];
    if (from.length / inputs !== to.length / outputs) throw new RangeError("the arrays have not as many elements");
    // What would be overwritten before it is read is kept. Two shared buffers may have one memory.
    const { buffer } = from;
    this.#all(what, from_array(buffer === to.buffer || "growable" in buffer ? from.slice() : from, inputs), inputs, to, outputs);
    return output;
  }
}

// Gives a class its figures, where users of the class find them.
export const described = (Class, uniforms, dimensions) => Object.assign(Class, { uniforms, dimensions });

// A class from its name and its constructors with the numbers of their parameters: "Interval new11 decreasing11".
const MADE = {};
export const warp = (text, number, first, ...figures) => {
  const [name, ...makers] = text.split(" ");
  const parsed = makers.map((maker) => /(\D+)(\d*)/.exec(maker));
  const usual = parsed.findIndex(([, method]) => method === "new");
  const Class = { [name]: class extends Warp {
    constructor(...given) {
      const [index, parameters] = given[0] === MADE ? given.slice(1) : [usual, given];
      if (index < 0) throw new TypeError(`${name} is made by ${parsed.map(([, method]) => `${name}.${method}`).join(" or ")}`);
      const lengths = parsed[index][2];
      if (parameters.length !== lengths.length) throw new TypeError(`${name} takes ${lengths.length} parameters`);
      const flat = parameters.flatMap((parameter, i) => numbers(parameter, +lengths[i]));
      super(written(LARGEST, [], flat, (to, from) => wasm.construct(first + index, from, to)), number, figures);
    }
  } }[name];
  parsed.forEach(([, method], index) => {
    if (index !== usual) Class[method] = (...parameters) => new Class(MADE, index, parameters);
  });
  return described(Class, ...figures);
};
