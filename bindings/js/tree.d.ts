import { Source } from "./source.js";

/**
 * Integer weights that change, as a tree of sums in place of them: the array holds the sums until `intoWeights` brings the weights
 * back, and nobody else may write to it. Selections and changes take log₂ n additions.
 *
 * A weight of 0 is never selected, and a positive one has at least one of the 2³² words.
 */
export declare class SumTree {
  /** @throws RangeError for no weights, more than 2²⁴, or a sum of 2³² or more; the weights are as they were then. */
  constructor(weights: Uint32Array);
  /** How many weights there are. */
  readonly entries: number;
  /** The sum of all weights. */
  readonly total: number;
  get(index: number): number;
  /**
   * Sets a weight, and returns the one that was there.
   *
   * @throws RangeError for an index out of range, or where the sum would be 2³² or more; nothing has changed then.
   */
  set(index: number, weight: number): number;
  /** The index of a word, an integer below 2³²; undefined where all weights are 0. */
  index(word: number): number | undefined;
  /** The probability of an index. */
  pmf(index: number): number;
  /** An index, by one word of the source; undefined where all weights are 0. */
  draw(source: Source): number | undefined;
  /**
   * So many different indices, drawn one after the other without replacement, by one word each; fewer where all positive weights are
   * drawn. The weights stay as they are.
   *
   * @throws RangeError for more than there are entries.
   */
  drawDistinct(count: number, source: Source): number[];
  /** Brings the weights back, and returns their array. Afterwards the tree has no entries, and calls throw a TypeError. */
  intoWeights(): Uint32Array;
}
