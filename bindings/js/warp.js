// What all warps have in common, and how their classes are made from one line each.

import { IN, OUT, Loaded, elements, in_blocks, numbers, point, put, wasm, written } from "./core.js";

const [DRAW, SAMPLE, PDF, INVERT] = [0, 1, 2, 3];
// Room for the largest warp, as src/warps.rs asserts.
const LARGEST = 128;

// Of all warps: how many uniforms and numbers a point has, and the words of a draw.
export class Warp {
  draw(source) {
    source._words(IN * 4, this._words, 1);
    return this._one(DRAW, this._words, this.dimensions);
  }
  sample(uniforms) {
    put(IN, uniforms, this.uniforms);
    return this._one(SAMPLE, this.uniforms, this.dimensions);
  }
  pdf(at) {
    put(IN, at, this.dimensions);
    return this._one(PDF, this.dimensions, 1);
  }
  invert(at) {
    put(IN, at, this.dimensions);
    return this._one(INVERT, this.dimensions, this.uniforms);
  }
  fill(points, source) {
    return this._all(DRAW, source, this._words, points, this.dimensions, elements(points, Float32Array, this.dimensions));
  }
  map(uniforms, points) {
    return this._arrays(SAMPLE, uniforms, this.uniforms, points, this.dimensions);
  }
  pdfs(points, densities) {
    return this._arrays(PDF, points, this.dimensions, densities, 1);
  }
  inverts(points, uniforms) {
    return this._arrays(INVERT, points, this.dimensions, uniforms, this.uniforms);
  }

  _evaluate(what, inputs, outputs, count) {
    wasm.evaluate(this._number, what, this._loaded.address(), IN * 4, inputs, OUT * 4, outputs, count);
  }
  _one(what, inputs, outputs) {
    this._evaluate(what, inputs, outputs, 1);
    return point(OUT, outputs);
  }
  _all(what, input, inputs, output, outputs, count) {
    in_blocks(count, input, inputs, output, outputs, (n) => this._evaluate(what, inputs, outputs, n));
    return output;
  }
  _arrays(what, input, inputs, output, outputs) {
    const count = elements(output, Float32Array, outputs);
    if (elements(input, Float32Array, inputs) !== count) throw new RangeError("the arrays have not as many elements");
    return this._all(what, input, inputs, output, outputs, count);
  }
}

// Gives a class its figures, where objects and users of the class find them.
export const described = (Class, uniforms, dimensions, _words) => {
  Object.assign(Class, { uniforms, dimensions });
  Object.assign(Class.prototype, { uniforms, dimensions, _words });
  return Class;
};

// A class from its name and its constructors with the numbers of their parameters: "Interval new11 decreasing11".
const MADE = {};
export const warp = (text, number, first, uniforms, dimensions, words) => {
  const [name, ...makers] = text.split(" ");
  const parsed = makers.map((maker) => /(\D+)(\d*)/.exec(maker));
  const usual = parsed.findIndex(([, method]) => method === "new");
  const Class = { [name]: class extends Warp {
    constructor(...given) {
      super();
      const [index, parameters] = given[0] === MADE ? given.slice(1) : [usual, given];
      if (index < 0) throw new TypeError(`${name} is made by ${parsed.map(([, method]) => `${name}.${method}`).join(" or ")}`);
      const lengths = parsed[index][2];
      if (parameters.length !== lengths.length) throw new TypeError(`${name} takes ${lengths.length} parameters`);
      const flat = parameters.flatMap((parameter, i) => numbers(parameter, +lengths[i]));
      this._loaded = written(LARGEST, [], flat, (to, from) => wasm.construct(first + index, from, to));
      this._number = number;
    }
  } }[name];
  parsed.forEach(([, method], index) => {
    if (index !== usual) Class[method] = (...parameters) => new Class(MADE, index, parameters);
  });
  return described(Class, uniforms, dimensions, words);
};
