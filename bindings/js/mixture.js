// Points of one of several warps, picked by weight. What all parts are lies behind the head of a table.

import { OUT, integer, numbers, point, put, put_words, u32_of, wasm, weights_of, written, wrong } from "./core.js";
import { evaluate, figures_of } from "./density.js";
import { Warp, inside } from "./warp.js";

// As src/mixture.rs has them: the kind of the table, what is asked of it, its head and where the parts stand in it, and a refusal.
const [MIXTURE, INVERT, PMF] = [6, 3, 6];
const [MOST, HEAD, PARTS] = [32, 256, 2];
const OTHER_KIND = 30;

const kinds = (part) => new TypeError(`parts of one kind are expected: part ${part} has other points or uniforms than part 0, or a density by another measure`);

const mixed = (parts, weights) => {
  if (!Array.isArray(parts)) throw wrong("an array of warps", parts);
  const count = integer("the number of parts", parts.length, 1, MOST);
  const own = Array.from({ length: count }, (_, i) => parts[i]);
  const figures = own.map(figures_of);
  const by_weight = weights_of(weights);
  if (by_weight.length !== count) throw new RangeError(`${count} weights are expected, not ${by_weight.length}`);
  const [[, uniforms, dimensions]] = figures;
  let length = HEAD;
  const placed = own.map((part, i) => {
    if (part instanceof Mixture) throw wrong("a part that is no mixture", part);
    if (figures[i][1] !== uniforms || figures[i][2] !== dimensions) throw kinds(i);
    const [{ bits }, number, table] = inside(part);
    const at = length;
    length += (bits.length + 3) & ~3;
    return [bits, [number, table, 4 * at], at];
  });
  const head = new Uint32Array(length);
  head.set([count, dimensions, ...placed.flatMap(([, part]) => part)]);
  for (const [bits, , at] of placed) head.set(bits, at);
  const all = new Float32Array(MOST);
  all.set(by_weight);
  const loaded = written(length, head, all, (mixture, weights) => {
    const refusal = wasm.tabulate(MIXTURE, mixture, weights);
    if ((refusal & 31) === OTHER_KIND) throw kinds(refusal >>> 5);
    return refusal;
  });
  return [loaded, MIXTURE, [uniforms, dimensions, Math.max(...figures.map(([words]) => words))], true];
};

export class Mixture extends Warp {
  constructor(parts, weights) {
    super(...mixed(parts, weights));
  }
  // The uniform by which a part is picked lies behind the point.
  invert(at, uniform = 0.5) {
    const [, uniforms, dimensions] = figures_of(this);
    put([...numbers(at, dimensions), ...numbers(uniform, 1)], dimensions + 1);
    evaluate(this, INVERT, dimensions + 1, uniforms, 1, 0);
    return point(OUT, uniforms);
  }
  pmf(part) {
    put_words(Uint32Array.of(u32_of("part", part)));
    evaluate(this, PMF, 1, 1, 1, 0);
    return point(OUT, 1);
  }
}
