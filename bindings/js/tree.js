// Weights that change: a tree of sums, in an array of its own that nobody else writes to.

import { big_of, whole } from "./integers.js";
import { drawn, integer, ready, refuse, scaled, u32_of, word_at, wrong } from "./core.js";

// The codes of refusals.
const [TOO_LARGE, NO_WEIGHTS, TOO_MANY_WEIGHTS] = [4, 10, 11];

export class SumTree {
  #sums;
  #total;
  // What weights of 64 bits are: BigInts.
  #big;
  constructor(weights) {
    if (!Array.isArray(weights) && !(ArrayBuffer.isView(weights) && "length" in weights)) throw wrong("an array of weights", weights);
    const n = integer("the number of weights", weights.length, 0, 0xffffffff);
    if (n === 0) refuse(NO_WEIGHTS);
    if (n > 2 ** 24) refuse(TOO_MANY_WEIGHTS);
    this.#big = typeof weights[0] === "bigint";
    const own = new (this.#big ? BigUint64Array : Uint32Array)(n);
    let total = this.#word(0);
    for (let i = 0; i < n; i += 1) total += own[i] = this.#weight(weights[i]);
    this.#grown(total);
    for (let i = 1; i <= n; i += 1) {
      const next = i + (i & -i);
      if (next <= n) own[next - 1] += own[i - 1];
    }
    this.#sums = own;
  }
  #word(number) {
    return this.#big ? BigInt(number) : number;
  }
  #weight(weight) {
    return (this.#big ? big_of : u32_of)("weight", weight);
  }
  // Takes a total, if it fits a word.
  #grown(total) {
    if (!(total < 2 ** (this.#big ? 64 : 32))) refuse(TOO_LARGE);
    this.#total = total;
  }
  // The sum of so many weights.
  #before(entries) {
    let sum = this.#word(0);
    for (let i = entries; i > 0; i &= i - 1) sum += this.#sums[i - 1];
    return sum;
  }
  #at(word) {
    const [sums, total] = [this.#sums, this.#total];
    if (!total) return undefined;
    let [left, index] = [this.#big ? total * word >> 64n : scaled(total, word), 0];
    for (let step = 1 << 31 - Math.clz32(sums.length); step > 0; step >>= 1) {
      const sum = sums[index + step - 1];
      if (sum <= left) [left, index] = [left - sum, index + step];
    }
    return index;
  }
  get entries() {
    return this.#sums.length;
  }
  get total() {
    return this.#total;
  }
  get(index) {
    integer("index", index, 0, this.#sums.length - 1);
    return this.#before(index + 1) - this.#before(index);
  }
  set(index, weight) {
    const [before, sums] = [this.get(index), this.#sums];
    this.#grown(this.#total - before + this.#weight(weight));
    // The array keeps the sums modulo the words there are, and none is larger.
    for (let i = index; i < sums.length; i |= i + 1) sums[i] += weight - before;
    return before;
  }
  index(word) {
    return this.#at((this.#big ? big_of : u32_of)("word", word));
  }
  pmf(index) {
    const weight = this.get(index);
    if (!weight) return 0;
    const [total, bits] = [BigInt(this.#total), this.#big ? 64n : 32n];
    const first = (sum) => ((BigInt(sum) << bits) + total - 1n) / total;
    const before = this.#before(index);
    return rounded(first(before + weight) - first(before)) / 2 ** Number(bits);
  }
  draw(source) {
    drawn(ready(source, this.#big ? 2 : 1, 1));
    return this.#at(this.#big ? whole() : word_at(0));
  }
  drawDistinct(count, source) {
    integer("count", count, 0, this.#sums.length);
    const found = [];
    try {
      for (let i = 0; i < count; i += 1) {
        const index = this.draw(source);
        if (index !== undefined) found.push([index, this.set(index, this.#word(0))]);
      }
    } finally {
      for (const [index, weight] of found) this.set(index, weight);
    }
    return found.map(([index]) => index);
  }
  weights() {
    const own = this.#sums.slice();
    for (let i = own.length; i > 0; i -= 1) {
      const next = i + (i & -i);
      if (next <= own.length) own[next - 1] -= own[i - 1];
    }
    return own;
  }
}

// A number of words as the nearest number of 32 bits, in one rounding: a bit that is dropped lies below what decides.
const rounded = (words) => {
  const dropped = BigInt(Math.max(words.toString(2).length - 50, 0));
  const kept = words >> dropped;
  return Math.fround(Number(kept << dropped === words ? kept : kept | 1n)) * 2 ** Number(dropped);
};
