// Counts of successes, by a table that is exact to the word and by rejection; and integers about a centre.

import { OUT, from_source, in_blocks, index_at, integer, point, put_words, ready, u32_of, view } from "./core.js";
import { ask, law_of } from "./laws.js";

const [TABLE, REJECTION, OF_RATIO, GAUSSIAN, LAPLACE, LAPLACE_OF_RATIO] = [0, 1, 2, 3, 4, 5];
const [COUNT, PMF] = [0, 1];
// As `BinomialRejection::BUDGET` has it.
const TRIES = 32;

const by_p = (kind, trials, p) => law_of(kind, [p], u32_of("trials", trials));
const pmf = (law, kind, count) => {
  put_words(Uint32Array.of(u32_of("count", count)));
  ask(law, kind, PMF, 1, 0);
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
    law.#law = law_of(OF_RATIO, [], trials, part, whole);
    return law;
  }
  get trials() {
    return this.#trials;
  }
  count(word) {
    put_words(Uint32Array.of(u32_of("word", word)));
    ask(this.#law, TABLE, COUNT, 1, 0);
    return index_at();
  }
  draw(source) {
    ask(this.#law, TABLE, COUNT, 1, ready(source, 1, 1));
    return index_at();
  }
  pmf(count) {
    return pmf(this.#law, TABLE, count);
  }
  fill(counts, source) {
    const own = view(counts, Uint32Array, 1);
    in_blocks(from_source(source, 1), 1, own, 1, (n, random) => ask(this.#law, TABLE, COUNT, n, random));
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
      if (ask(this.#law, REJECTION, COUNT, 1, ready(source, 2, 1)) > 0) return index_at();
    }
    throw new RangeError(`a source of random words is expected: ${TRIES} tries gave no count`);
  }
  pmf(count) {
    return pmf(this.#law, REJECTION, count);
  }
}

// Integers with a sign, of a law that the classes below hand over: nothing else is one.
const signed = (kind, made) => class {
  #law;
  constructor(...parameters) {
    this.#law = made(...parameters);
  }
  integer(word) {
    put_words(Uint32Array.of(u32_of("word", word)));
    ask(this.#law, kind, COUNT, 1, 0);
    return index_at() | 0;
  }
  draw(source) {
    ask(this.#law, kind, COUNT, 1, ready(source, 1, 1));
    return index_at() | 0;
  }
  pmf(at) {
    put_words(Uint32Array.of(integer("integer", at, -(2 ** 31), 2 ** 31 - 1)));
    ask(this.#law, kind, PMF, 1, 0);
    return point(OUT, 1);
  }
  fill(integers, source) {
    const own = view(integers, Int32Array, 1);
    in_blocks(from_source(source, 1), 1, own, 1, (n, random) => ask(this.#law, kind, COUNT, n, random));
    return integers;
  }
};

export class DiscreteGaussian extends /*#__PURE__*/ signed(GAUSSIAN, (centre, scale) => law_of(GAUSSIAN, [centre, scale])) {}

const RATIO = {};
export class DiscreteLaplace extends /*#__PURE__*/ signed(LAPLACE, (scale, part, whole) => (
  scale === RATIO ? law_of(LAPLACE_OF_RATIO, [], 0, u32_of("part", part), u32_of("whole", whole)) : law_of(LAPLACE, [scale])
)) {
  static fromRatio(part, whole) {
    return new DiscreteLaplace(RATIO, part, whole);
  }
}
