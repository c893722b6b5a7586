// Tables of weights: indices, and densities made of pieces.

import { IN, OUT, elements, in_blocks, numbers, point, put, wasm, words_at, written } from "./core.js";
import { Warp, described } from "./warp.js";

const [DRAW, SAMPLE, PDF] = [0, 1, 2];
const HEAD = 6;

// A table by its kind, of so many words behind the head.
const tabulated = (kind, words, shape, bounds, weights) => {
  const cells = shape[0] * shape[1];
  if (weights.length !== cells) throw new RangeError(`${cells} weights are expected, not ${weights.length}`);
  const head = new Uint32Array(HEAD);
  head.set(shape);
  new Float32Array(head.buffer).set(bounds, 2);
  return written(HEAD + words, head, weights, (table, weights) => wasm.tabulate(kind, table, weights));
};

class Indices {
  constructor(kind, weights, words) {
    Object.assign(this, { _kind: kind, entries: weights.length });
    this._loaded = tabulated(kind, words, [weights.length, 1], [], weights);
  }
  draw(source) {
    source._words(IN * 4, 1, 1);
    this._evaluate(DRAW, 1, 1);
    return words_at(OUT, 1)[0];
  }
  select(uniform) {
    put(IN, uniform, 1);
    this._evaluate(SAMPLE, 3, 1);
    const [, pmf, leftover] = point(OUT, 3);
    return { index: words_at(OUT, 1)[0], pmf, leftover };
  }
  pmf(index) {
    words_at(IN, 1)[0] = index;
    this._evaluate(PDF, 1, 1);
    return point(OUT, 1);
  }
  fill(indices, source) {
    in_blocks(elements(indices, Uint32Array, 1), source, 1, indices, 1, (n) => this._evaluate(DRAW, 1, n));
    return indices;
  }
  _evaluate(what, outputs, count) {
    wasm.look_up(this._kind, what, this._loaded.address(), IN * 4, 1, OUT * 4, outputs, count);
  }
}

export class Cdf extends Indices {
  constructor(weights) {
    super(0, weights, weights.length);
  }
}
export class Alias extends Indices {
  constructor(weights) {
    super(1, weights, 3 * 2 ** Math.ceil(Math.log2(weights.length || 1)));
  }
}

// A table that is a warp.
class Pieces extends Warp {
  constructor(kind, words, shape, bounds, weights) {
    super();
    this._number = kind;
    this._loaded = tabulated(kind, words, shape, bounds, weights);
  }
  _evaluate(what, inputs, outputs, count) {
    wasm.look_up(this._number, what, this._loaded.address(), IN * 4, inputs, OUT * 4, outputs, count);
  }
}

export const PiecewiseConstant1d = /*#__PURE__*/ described(class PiecewiseConstant1d extends Pieces {
  constructor(weights, low, high) {
    super(2, weights.length + 1, [weights.length, 1], numbers([low, high], 2), weights);
  }
}, 1, 1, 1);

export const PiecewiseLinear1d = /*#__PURE__*/ described(class PiecewiseLinear1d extends Pieces {
  constructor(weights, low, high) {
    super(3, 2 * weights.length, [weights.length, 1], numbers([low, high], 2), weights);
  }
}, 1, 1, 1);

const grid = ([columns, rows]) => columns * rows + rows;

export const PiecewiseConstant2d = /*#__PURE__*/ described(class PiecewiseConstant2d extends Pieces {
  constructor(weights, shape, u, v) {
    super(4, grid(shape), shape, numbers([u, v], 4), weights);
  }
}, 2, 2, 2);

export const LatLongMap = /*#__PURE__*/ described(class LatLongMap extends Pieces {
  constructor(radiances, shape) {
    super(5, grid(shape), shape, [], radiances);
  }
}, 2, 3, 2);
