// Where random words come from: a generator, sets of points, strata.

import { IN, OUT, elements, generator, in_blocks, point, put, refuse, stored, wasm, words_at, take } from "./core.js";

const bits64 = (number) => BigInt.asUintN(64, BigInt(number));
const hex = (number) => number.toString(16).padStart(16, "0");

class Source {
  words(words, dimensions = 1) {
    const count = elements(words, Uint32Array, dimensions);
    in_blocks(count, this, dimensions, words, dimensions, (n) => {
      words_at(OUT, n * dimensions).set(words_at(IN, n * dimensions));
    });
    return words;
  }
  uniforms(uniforms, dimensions = 1) {
    const count = elements(uniforms, Float32Array, dimensions);
    in_blocks(count, this, dimensions, uniforms, dimensions, (n) => {
      wasm.uniforms(IN * 4, n * dimensions, this instanceof Pcg32 ? 0 : 1);
      take(OUT, n * dimensions).set(take(IN, n * dimensions));
    });
    return uniforms;
  }
}

export class Pcg32 extends Source {
  constructor(seed, stream = 0) {
    super();
    this._state = new Uint32Array(4);
    const random = () => crypto.getRandomValues(new BigUint64Array(1))[0];
    if (seed === undefined) [seed, stream] = [random(), random()];
    [seed, stream] = [bits64(seed), bits64(stream)];
    wasm.seed(generator(this._state), seed, stream);
  }
  get state() {
    return Array.from(new BigUint64Array(stored(this._state).buffer), hex).join("-");
  }
  static resume(state) {
    const parts = /^([0-9a-f]{16})-([0-9a-f]{15}[13579bdf])$/.exec(state);
    if (!parts) throw new RangeError("this is no state of a Pcg32");
    const state_words = parts.slice(1).map((part) => BigInt("0x" + part));
    return Object.assign(Object.create(Pcg32.prototype), { _state: new Uint32Array(BigUint64Array.from(state_words).buffer) });
  }
  _words(address, each, count) {
    wasm.random(generator(this._state), address, each * count);
  }
}

class Points extends Source {
  constructor(by_position, seed, pixel) {
    super();
    Object.assign(this, { by_position, seed, pixel, index: 0, dimension: 0 });
  }
  at(index, dimension = 0) {
    return Object.assign(Object.create(Object.getPrototypeOf(this)), this, { index, dimension });
  }
  _words(address, each, count) {
    wasm.points(this.by_position, this.seed, this.pixel, this.index, this.dimension, address, each, count);
    this.index += count;
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

export class Strata {
  constructor(columns, rows = 0) {
    Object.assign(this, { columns, rows, _each: rows ? 2 : 1 });
    this._place(0, 0);
  }
  // Turns uniforms in the memory into those of strata.
  _place(from, count) {
    refuse(wasm.strata(this.columns, this.rows, from, IN * 4, count));
  }
  place(index, jitter) {
    put(IN, jitter, this._each);
    this._place(index, 1);
    return point(IN, this._each);
  }
  uniforms(uniforms, source, from = 0) {
    const each = this._each;
    in_blocks(elements(uniforms, Float32Array, each), source, each, uniforms, each, (n) => {
      wasm.uniforms(IN * 4, n * each, 0);
      this._place(from, n);
      take(OUT, n * each).set(take(IN, n * each));
      from += n;
    });
    return uniforms;
  }
}
