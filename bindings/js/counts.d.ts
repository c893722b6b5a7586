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
