// Points with their densities, in one call: functions, so that only who imports them loads them.

import { BUFFERS, OUT, from_array, from_source, in_blocks, point, put, ready, refuse, view, wasm, wrong } from "./core.js";
import { Warp, inside } from "./warp.js";

// As src/warps.rs and src/laws.rs have them.
const [SAMPLE, DRAW] = [4, 5];
const [DENSITIES, NOT_LINKED] = [48, 31];

// Does something to elements of so many numbers, and puts out others of so many.
export const evaluate = (warp, what, inputs, outputs, count, random) => {
  const [loaded, number, table] = inside(warp);
  wasm[table ? "look_up" : "evaluate"](number, what, loaded.address(), BUFFERS, inputs, outputs, count, random);
};
// The words of a draw of a warp, if it is one, its uniforms and the numbers of a point.
export const figures_of = (warp) => {
  if (!(warp instanceof Warp)) throw wrong("a warp", warp);
  return inside(warp).slice(3);
};

// The same as `evaluate` for points with the density behind each.
const with_pdf = (warp, what, inputs, dimensions, count, random) => {
  if (wasm.ask(DENSITIES, 0, 0, BUFFERS, 0, 0) === 0) refuse(NOT_LINKED);
  evaluate(warp, what, inputs, dimensions + 1, count, random);
};
const one = (warp, what, inputs, dimensions, random) => {
  with_pdf(warp, what, inputs, dimensions, 1, random);
  return { point: point(OUT, dimensions), pdf: point(OUT + dimensions, 1) };
};
export const sampleWithPdf = (warp, uniforms) => {
  const [, each, dimensions] = figures_of(warp);
  put(uniforms, each);
  return one(warp, SAMPLE, each, dimensions, 0);
};
export const drawWithPdf = (warp, source) => {
  const [words, , dimensions] = figures_of(warp);
  return one(warp, DRAW, words, dimensions, ready(source, words, 1));
};

// Fills two arrays of as many elements by inputs of so many numbers.
const all = (warp, what, feed, inputs, count, dimensions, points, densities) => {
  if (points.length !== count * dimensions || densities.length !== count) throw new RangeError("the arrays have not as many elements");
  const both = new Float32Array(count * (dimensions + 1));
  in_blocks(feed, inputs, both, dimensions + 1, (n, random) => with_pdf(warp, what, inputs, dimensions, n, random));
  for (let i = 0; i < count; i += 1) {
    const at = i * (dimensions + 1);
    points.set(both.subarray(at, at + dimensions), i * dimensions);
    densities[i] = both[at + dimensions];
  }
};
export const fillWithPdf = (warp, points, densities, source) => {
  const [words, , dimensions] = figures_of(warp);
  const [own, beside] = [view(points, Float32Array, dimensions), view(densities, Float32Array, 1)];
  all(warp, DRAW, from_source(source, words), words, beside.length, dimensions, own, beside);
  return points;
};
export const mapWithPdf = (warp, uniforms, points, densities) => {
  const [, each, dimensions] = figures_of(warp);
  const [from, own, beside] = [view(uniforms, Float32Array, each), view(points, Float32Array, dimensions), view(densities, Float32Array, 1)];
  all(warp, SAMPLE, from_array(from, each), each, from.length / each, dimensions, own, beside);
  return points;
};
