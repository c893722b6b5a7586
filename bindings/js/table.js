// Tables of weights that select indices. Densities made of pieces are in `pieces.js`.

import { BUFFERS, OUT, from_source, in_blocks, index_at, keep, kept_word, place_ahead, plan, point, put, put_words, u32_of, view, wasm, weights_of, written } from "./core.js";

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
  #kind;
  #loaded;
  #entries;
  // Alone knows how many words a kind takes, since a caller can get at this class too.
  constructor(alias, weights) {
    weights = weights_of(weights);
    const { length } = weights;
    this.#kind = alias ? 1 : 0;
    const words = alias ? 3 * 2 ** Math.ceil(Math.log2(length || 1)) : length;
    this.#loaded = tabulated(this.#kind, words, [length, 1], [], weights);
    this.#entries = length;
  }
  get entries() {
    return this.#entries;
  }
  draw(source) {
    const at = place_ahead(this, source);
    if (at >= 0) return kept_word(at);
    const many = plan(this, source, 1, 1);
    this.#evaluate(DRAW, 1, Math.abs(many), Math.max(many, 0));
    keep();
    return index_at();
  }
  select(uniform) {
    put(uniform, 1);
    this.#evaluate(SAMPLE, 3, 1, 0);
    const [, pmf, leftover] = point(OUT, 3);
    return { index: index_at(), pmf, leftover };
  }
  pmf(index) {
    put_words(Uint32Array.of(u32_of("index", index)));
    this.#evaluate(PDF, 1, 1, 0);
    return point(OUT, 1);
  }
  fill(indices, source) {
    const own = view(indices, Uint32Array, 1);
    in_blocks(from_source(source, 1), 1, own, 1, (n, random) => this.#evaluate(DRAW, 1, n, random));
    return indices;
  }
  #evaluate(what, outputs, count, random) {
    wasm.look_up(this.#kind, what, this.#loaded.address(), BUFFERS, 1, outputs, count, random);
  }
}

export class Cdf extends Indices {
  constructor(weights) {
    super(0, weights);
  }
}
export class Alias extends Indices {
  constructor(weights) {
    super(1, weights);
  }
}
