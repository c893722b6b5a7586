// Tables of weights that select indices. Densities made of pieces are in `pieces.js`.

import { IN, OUT, elements, in_blocks, point, put, wasm, words_at, written } from "./core.js";

const [DRAW, SAMPLE, PDF] = [0, 1, 2];
const HEAD = 6;

// A table by its kind, of so many words behind the head.
export const tabulated = (kind, words, shape, bounds, weights) => {
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
