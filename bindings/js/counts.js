// Counts of successes: by a table that is exact to the word, and by rejection.

import { BUFFERS, OUT, from_source, in_blocks, index_at, numbers, point, put_words, ready, u32_of, view, wasm, written } from "./core.js";

// Room for either law; src/counts.rs has it, too.
const WORDS = 192;
const [TABLE, REJECTION, OF_RATIO] = [0, 1, 2];
const [COUNT, PMF] = [0, 1];
// As `BinomialRejection::BUDGET` has it.
const TRIES = 32;

const by_p = (kind, trials, p) => {
  u32_of("trials", trials);
  const [own] = numbers(p, 1);
  return written(WORDS, [], [], (at) => wasm.binomial(at, kind, trials, own, 0, 0));
};
const counted = (law, kind, what, count, random) => wasm.counted(kind, what, law.address(), BUFFERS, count, random);
const pmf = (law, kind, count) => {
  put_words(Uint32Array.of(u32_of("count", count)));
  counted(law, kind, PMF, 1, 0);
  return point(OUT, 1);
};

export class Binomial {
  #law;
  #trials;
  constructor(trials, p) {
    this.#law = by_p(TABLE, trials, p);
    this.#trials = trials;
  }
  static fromRatio(trials, part, whole) {
    const law = new Binomial(1, 0.5);
    [law.#trials, part, whole] = [u32_of("trials", trials), u32_of("part", part), u32_of("whole", whole)];
    law.#law = written(WORDS, [], [], (at) => wasm.binomial(at, OF_RATIO, trials, 0, part, whole));
    return law;
  }
  get trials() {
    return this.#trials;
  }
  count(word) {
    put_words(Uint32Array.of(u32_of("word", word)));
    counted(this.#law, TABLE, COUNT, 1, 0);
    return index_at();
  }
  draw(source) {
    counted(this.#law, TABLE, COUNT, 1, ready(source, 1, 1));
    return index_at();
  }
  pmf(count) {
    return pmf(this.#law, TABLE, count);
  }
  fill(counts, source) {
    const own = view(counts, Uint32Array, 1);
    in_blocks(from_source(source, 1), 1, own, 1, (n, random) => counted(this.#law, TABLE, COUNT, n, random));
    return counts;
  }
}

export class BinomialRejection {
  #law;
  #trials;
  constructor(trials, p) {
    this.#law = by_p(REJECTION, trials, p);
    this.#trials = trials;
  }
  get trials() {
    return this.#trials;
  }
  draw(source) {
    for (let tries = 0; tries < TRIES; tries += 1) {
      if (counted(this.#law, REJECTION, COUNT, 1, ready(source, 2, 1)) > 0) return index_at();
    }
    throw new RangeError(`a source of random words is expected: ${TRIES} tries gave no count`);
  }
  pmf(count) {
    return pmf(this.#law, REJECTION, count);
  }
}
