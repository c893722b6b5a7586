// Weights that change: a tree of sums in place of them, in an array of the caller's.

import { drawn, integer, ready, refuse, scaled, u32_of, view, word_at } from "./core.js";

const ALL = 2 ** 32;
// The codes of refusals.
const [TOO_LARGE, NO_WEIGHTS, TOO_MANY_WEIGHTS] = [4, 10, 11];

export class SumTree {
  #sums;
  #total = 0;
  constructor(weights) {
    const own = view(weights, Uint32Array, 1);
    const n = own.length;
    if (n === 0 || n > 2 ** 24) refuse(n === 0 ? NO_WEIGHTS : TOO_MANY_WEIGHTS);
    let total = 0;
    for (const weight of own) total += weight;
    this.#grown(total);
    for (let i = 1; i <= n; i += 1) {
      const next = i + (i & -i);
      if (next <= n) own[next - 1] += own[i - 1];
    }
    this.#sums = own;
  }
  // Takes a total, if it fits a word.
  #grown(total) {
    if (!(total < ALL)) refuse(TOO_LARGE);
    this.#total = total;
  }
  // Throws for a tree whose weights are back.
  #tree() {
    if (!this.#sums) throw new TypeError("the weights are back: make a new SumTree of them");
    return this.#sums;
  }
  // The sum of so many weights.
  #before(entries) {
    let sum = 0;
    for (let i = entries; i > 0; i &= i - 1) sum += this.#sums[i - 1];
    return sum;
  }
  #at(word) {
    const [sums, total] = [this.#tree(), this.#total];
    if (total === 0) return undefined;
    let [left, index] = [scaled(total, word), 0];
    for (let step = 1 << 31 - Math.clz32(sums.length); step > 0; step >>= 1) {
      const sum = sums[index + step - 1];
      if (sum <= left) [left, index] = [left - sum, index + step];
    }
    return index;
  }
  get entries() {
    return this.#sums?.length ?? 0;
  }
  get total() {
    return this.#total;
  }
  get(index) {
    integer("index", index, 0, this.#tree().length - 1);
    return this.#before(index + 1) - this.#before(index);
  }
  set(index, weight) {
    const [before, sums] = [this.get(index), this.#sums];
    this.#grown(this.#total - before + u32_of("weight", weight));
    // The array keeps the sums modulo 2³², and none is larger.
    for (let i = index; i < sums.length; i |= i + 1) sums[i] += weight - before;
    return before;
  }
  index(word) {
    return this.#at(u32_of("word", word));
  }
  pmf(index) {
    const weight = this.get(index);
    if (weight === 0) return 0;
    const total = BigInt(this.#total);
    const first = (sum) => ((BigInt(sum) << 32n) + total - 1n) / total;
    const before = this.#before(index);
    return Math.fround(Number(first(before + weight) - first(before)) / ALL);
  }
  draw(source) {
    this.#tree();
    drawn(ready(source, 1, 1));
    return this.#at(word_at(0));
  }
  drawDistinct(count, source) {
    integer("count", count, 0, this.#tree().length);
    const found = [];
    try {
      for (let i = 0; i < count; i += 1) {
        const index = this.draw(source);
        if (index !== undefined) found.push([index, this.set(index, 0)]);
      }
    } finally {
      for (const [index, weight] of found) this.set(index, weight);
    }
    return found.map(([index]) => index);
  }
  intoWeights() {
    const own = this.#tree();
    [this.#sums, this.#total] = [undefined, 0];
    for (let i = own.length; i > 0; i -= 1) {
      const next = i + (i & -i);
      if (next <= own.length) own[next - 1] -= own[i - 1];
    }
    return own;
  }
}
