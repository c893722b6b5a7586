import { Source } from "./source.js";

/** How many of so many trials succeed, exact to the word, for a variance trials·p·(1 − p) up to 100. */
export declare class Binomial {
  /** @throws RangeError for a p outside [0, 1], for NaN, and for a larger variance; see `BinomialRejection`. */
  constructor(trials: number, p: number);
  /**
   * Of probability part/whole each.
   *
   * @throws RangeError also for a `whole` of 0 and a larger `part`.
   */
  static fromRatio(trials: number, part: number, whole: number): Binomial;
  readonly trials: number;
  /** A count, by one word of the source. */
  draw(source: Source): number;
  /** The count of a word, an integer below 2³². */
  count(word: number): number;
  /** The probability of a count. */
  pmf(count: number): number;
  /** Fills an array with drawn counts; returns the array. */
  fill(counts: Uint32Array, source: Source): Uint32Array;
}

/** The same for any number of trials, where the variance is 10 or more: by rejection, of two words a try. */
export declare class BinomialRejection {
  /** @throws RangeError for a p outside [0, 1], for NaN, and for a smaller variance. */
  constructor(trials: number, p: number);
  readonly trials: number;
  /**
   * A count. Three in four tries give one, or more; of points each try takes the next.
   *
   * @throws RangeError where 32 tries give none, which no generator does in practice.
   */
  draw(source: Source): number;
  /** The probability of a count. */
  pmf(count: number): number;
}

interface SignedIntegers {
  /** An integer, by one word of the source. */
  draw(source: Source): number;
  /** The integer of a word, which is an integer below 2³². */
  integer(word: number): number;
  /** The probability of an integer. */
  pmf(integer: number): number;
  /** Fills an array with drawn integers; returns the array. */
  fill(integers: Int32Array, source: Source): Int32Array;
}

/** Integers about a centre with a Gaussian, exact to the word: in proportion to e^(−(k − centre)²/2scale²). */
export interface DiscreteGaussian extends SignedIntegers {}
export declare class DiscreteGaussian {
  /** @throws RangeError for NaN, a centre beyond 2³⁰ either way, and a scale that is not above 0 and up to 20. */
  constructor(centre: number, scale: number);
}

/** Integers about 0 whose probability falls as a power, exact to the word: in proportion to e^(−|k|/scale). */
export interface DiscreteLaplace extends SignedIntegers {}
export declare class DiscreteLaplace {
  /** @throws RangeError for NaN, and for a scale that is not above 0 and up to 9e7. */
  constructor(scale: number);
  /** Of the scale part/whole, two integers below 2³². */
  static fromRatio(part: number, whole: number): DiscreteLaplace;
}
