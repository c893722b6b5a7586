// Tables of weights that are densities, made of pieces.

import { IN, OUT, numbers, wasm } from "./core.js";
import { tabulated } from "./table.js";
import { Warp, described } from "./warp.js";

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
