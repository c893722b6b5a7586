// Where random words come from: what all sources have in common, and the generator.

import { IN, OUT, elements, generator, in_blocks, stored, wasm, words_at, take } from "./core.js";

const bits64 = (number) => BigInt.asUintN(64, BigInt(number));
const hex = (number) => number.toString(16).padStart(16, "0");

export class Source {
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
  static at(seed, index) {
    const rng = new Pcg32(0);
    wasm.seed_at(generator(rng._state), seed, index);
    return rng;
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
