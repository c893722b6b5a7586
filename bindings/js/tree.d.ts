import { Source } from "./source.js";

/**
 * Integer weights that change, as a tree of sums. Selections and changes take log₂ n additions. The weights are copied: what is done
 * to the array of the caller does nothing to the tree.
 *
 * Weights are numbers below 2³², of which a draw takes one word; or BigInts below 2⁶⁴, of which it takes two. A weight of 0 is never
 * selected, and a positive one has at least one of all words.
 */
export interface SumTree<W = number> {
  /** How many weights there are. */
  readonly entries: number;
  /** The sum of all weights. */
  readonly total: W;
  get(index: number): W;
  /**
   * Sets a weight, and returns the one that was there.
   *
   * @throws RangeError for an index out of range, or where the sum would fit no word; nothing has changed then.
   */
  set(index: number, weight: W): W;
  /** The index of a word, an integer below 2³², or a BigInt below 2⁶⁴; undefined where all weights are 0. */
  index(word: W): number | undefined;
  /** The probability of an index. */
  pmf(index: number): number;
  /** An index; undefined where all weights are 0. */
  draw(source: Source): number | undefined;
  /**
   * So many different indices, drawn one after the other without replacement; fewer where all positive weights are drawn. The weights
   * stay as they are.
   *
   * @throws RangeError for more than there are entries.
   */
  drawDistinct(count: number, source: Source): number[];
  /** The weights, in an array of their own. */
  weights(): W extends bigint ? BigUint64Array : Uint32Array;
}

export declare const SumTree: {
  /** @throws RangeError for no weights, more than 2²⁴, or a sum of 2³² or more; of BigInts 2⁶⁴ or more. */
  new (weights: ArrayLike<number>): SumTree<number>;
  new (weights: ArrayLike<bigint>): SumTree<bigint>;
  readonly prototype: SumTree<number | bigint>;
};
