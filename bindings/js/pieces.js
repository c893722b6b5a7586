// Tables of weights that are densities, made of pieces.

import { integer, numbers, weights_of, wrong } from "./core.js";
import { tabulated } from "./table.js";
import { Warp, described } from "./warp.js";

class Pieces extends Warp {
  constructor(kind, words, shape, bounds, weights, figures) {
    super(tabulated(kind, words, shape, bounds, weights), kind, figures, true);
  }
}

export const PiecewiseConstant1d = /*#__PURE__*/ described(class PiecewiseConstant1d extends Pieces {
  constructor(weights, low, high) {
    weights = weights_of(weights);
    super(2, weights.length + 1, [weights.length, 1], numbers([low, high], 2), weights, [1, 1, 1]);
  }
}, 1, 1);

export const PiecewiseLinear1d = /*#__PURE__*/ described(class PiecewiseLinear1d extends Pieces {
  constructor(weights, low, high) {
    weights = weights_of(weights);
    super(3, 2 * weights.length, [weights.length, 1], numbers([low, high], 2), weights, [1, 1, 1]);
  }
}, 1, 1);

// Columns and rows of a table, and its words.
const grid = (shape) => {
  if (shape?.length !== 2) throw wrong("a shape: [columns, rows]", shape);
  const [columns, rows] = ["columns", "rows"].map((name, i) => integer(name, shape[i], 1, 2 ** 24));
  return [[columns, rows], columns * rows + rows];
};

export const PiecewiseConstant2d = /*#__PURE__*/ described(class PiecewiseConstant2d extends Pieces {
  constructor(weights, shape, u, v) {
    const [own, words] = grid(shape);
    super(4, words, own, numbers([u, v], 4), weights_of(weights), [2, 2, 2]);
  }
}, 2, 2);

export const LatLongMap = /*#__PURE__*/ described(class LatLongMap extends Pieces {
  constructor(radiances, shape) {
    const [own, words] = grid(shape);
    super(5, words, own, [], weights_of(radiances), [2, 3, 2]);
  }
}, 2, 3);
