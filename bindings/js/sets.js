// Sets of points, strata, and permutations.

import { BUFFERS, IN, READY, Source, drawn, from_source, in_blocks, integer, point, put, refuse, u32_of, view, wasm, written } from "./core.js";

class Points extends Source {
  #kind;
  #seed;
  #pixel;
  #index = 0;
  #dimension = 0;
  constructor(kind, seed, pixel) {
    super();
    [this.#kind, this.#seed, this.#pixel] = [kind, u32_of("seed", seed), u32_of("pixel", pixel)];
  }
  get index() {
    return this.#index;
  }
  set index(index) {
    this.#index = u32_of("index", index);
  }
  get dimension() {
    return this.#dimension;
  }
  set dimension(dimension) {
    this.#dimension = u32_of("dimension", dimension);
  }
  at(index, dimension = 0) {
    const [seed, pixel] = [this.#seed, this.#pixel];
    const made = [() => new Sobol(seed), () => new ByPosition(seed, pixel), () => new LatinHypercube(pixel, seed)][this.#kind];
    return Object.assign(made?.() ?? new Points(this.#kind, seed, pixel), { index, dimension });
  }
  [READY](each, count) {
    refuse(wasm.points(BUFFERS, this.#kind, this.#seed, this.#pixel, this.#index, this.#dimension, each, count));
    // Behind the last of 2³² points comes the first.
    this.#index = this.#index + count >>> 0;
    return 0;
  }
}
export class Sobol extends Points {
  constructor(seed = 0) {
    super(0, seed, 0);
  }
}
export class ByPosition extends Points {
  constructor(seed, pixel) {
    super(1, seed, pixel);
  }
}
export class LatinHypercube extends Points {
  #count;
  constructor(count, seed = 0) {
    super(2, seed, integer("count", count, 1, 0xffffffff));
    this.#count = count;
  }
  get count() {
    return this.#count;
  }
}
// One set for a picture: a pixel is points of its own.
export class Screen {
  #width;
  #height;
  #kind;
  #seed;
  constructor(width, height, log2_samples, seed = 0) {
    this.#width = integer("width", width, 1, 0x10000);
    this.#height = integer("height", height, 1, 0x10000);
    const side = 32 - Math.clz32(width - 1 | height - 1);
    this.#kind = 3 + 256 * integer("log2Samples", log2_samples, 0, 32 - 2 * side) + 65536 * side;
    this.#seed = u32_of("seed", seed);
  }
  get width() {
    return this.#width;
  }
  get height() {
    return this.#height;
  }
  pixel(x, y) {
    integer("x", x, 0, this.#width - 1);
    integer("y", y, 0, this.#height - 1);
    return new Points(this.#kind, this.#seed, x + 65536 * y);
  }
}

const MOST = 2 ** 23;
export class Strata {
  #columns;
  #rows;
  #each;
  constructor(columns, rows) {
    this.#columns = integer("columns", columns, 1, MOST);
    this.#rows = rows === undefined ? 0 : integer("rows", rows, 1, MOST);
    this.#each = this.#rows ? 2 : 1;
    this.#place(0, 0);
  }
  // Turns uniforms in the memory into those of strata.
  #place(from, count) {
    refuse(wasm.strata(BUFFERS, this.#columns, this.#rows, from, count));
  }
  place(index, jitter) {
    u32_of("index", index);
    put(jitter, this.#each);
    this.#place(index, 1);
    return point(IN, this.#each);
  }
  uniforms(uniforms, source, from = 0) {
    const [own, each] = [view(uniforms, Float32Array, this.#each), this.#each];
    u32_of("from", from);
    in_blocks(from_source(source, each), each, own, each, (n, random) => {
      drawn(random);
      wasm.uniforms(BUFFERS, n * each, 0);
      this.#place(from, n);
      from = from + n >>> 0;
    }, true);
    return uniforms;
  }
}

// As src/words.rs has it.
const WORDS = 19;
export class Permutation {
  #length;
  #loaded;
  constructor(length, seed) {
    this.#length = integer("length", length, 1, 0xffffffff);
    u32_of("seed", seed);
    this.#loaded = written(WORDS, [], [], (at) => wasm.permutation(at, length, seed));
  }
  get length() {
    return this.#length;
  }
  get(place) {
    return wasm.permuted(this.#loaded.address(), integer("place", place, 0, this.#length - 1), 0) >>> 0;
  }
  indexOf(number) {
    return wasm.permuted(this.#loaded.address(), integer("number", number, 0, this.#length - 1), 1) >>> 0;
  }
  *[Symbol.iterator]() {
    for (let place = 0; place < this.#length; place += 1) yield this.get(place);
  }
}
