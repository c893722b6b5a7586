// The generator.

import { BUFFERS, READY, Source, bits64, generator, stored, u32_of, wasm } from "./core.js";

const hex = (number) => number.toString(16).padStart(16, "0");

export class Pcg32 extends Source {
  #state = new Uint32Array(4);
  constructor(seed, stream = 0) {
    super();
    const random = () => crypto.getRandomValues(new BigUint64Array(1))[0];
    if (seed === undefined) [seed, stream] = [random(), random()];
    [seed, stream] = [bits64("seed", seed), bits64("stream", stream)];
    generator(this.#state);
    wasm.seed(BUFFERS, seed, stream);
  }
  static at(seed, index) {
    const rng = new Pcg32(0);
    [seed, index] = [u32_of("seed", seed), u32_of("index", index)];
    generator(rng.#state);
    wasm.seed_at(BUFFERS, seed, index);
    return rng;
  }
  get state() {
    return Array.from(new BigUint64Array(stored(this.#state).buffer), hex).join("-");
  }
  static resume(state) {
    const parts = typeof state === "string" && /^([0-9a-f]{16})-([0-9a-f]{15}[13579bdf])$/.exec(state);
    if (!parts) throw new RangeError("this is no state of a Pcg32");
    const rng = new Pcg32(0);
    rng.#state = new Uint32Array(BigUint64Array.from(parts.slice(1), (part) => BigInt("0x" + part)).buffer);
    return rng;
  }
  [READY](each, count) {
    generator(this.#state);
    return each * count;
  }
}
