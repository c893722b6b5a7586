// Integers of a range, by one word or by two: numbers, or BigInts of 64 bits.

import { drawn, integer, ready, scaled, word_at, wrong } from "./core.js";

const FAR = Number.MAX_SAFE_INTEGER;

// An unsigned BigInt of 64 bits, from a least one on.
export const big_of = (name, value, least = 0n) => {
  const expected = `${name}: a BigInt from ${least} to ${2n ** 64n - 1n}`;
  if (typeof value !== "bigint") throw wrong(expected, value);
  if (value < least || value >= 2n ** 64n) throw new RangeError(`${expected} is expected, not ${value}`);
  return value;
};
// The two words that were drawn, the leading one first.
export const whole = () => BigInt(word_at(0)) << 32n | BigInt(word_at(1));

export class Integers {
  #low;
  #high;
  constructor(low, high) {
    if (typeof low === "bigint") {
      big_of("low", low);
      big_of("high", high, low);
    } else {
      integer("low", low, -FAR, FAR);
      integer("high", high, low, Math.min(low + 2 ** 32 - 1, FAR));
    }
    [this.#low, this.#high] = [low, high];
  }
  get low() {
    return this.#low;
  }
  get high() {
    return this.#high;
  }
  draw(source) {
    if (typeof this.#low === "bigint") return this.drawWide(source);
    drawn(ready(source, 1, 1));
    return this.#low + scaled(this.#high - this.#low + 1, word_at(0));
  }
  drawWide(source) {
    drawn(ready(source, 2, 1));
    const offset = (BigInt(this.#high - this.#low) + 1n) * whole() >> 64n;
    return typeof this.#low === "bigint" ? this.#low + offset : this.#low + Number(offset);
  }
}
