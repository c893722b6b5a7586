import { Source } from "./source.js";

/**
 * The integers from `low` to `high`, both among them: what is a Range in Rust, whose name browsers have given away. Numbers make a
 * range of up to 2³² safe integers; BigInts a range of any integers of 64 bits, without a sign.
 */
export interface Integers<N = number> {
  readonly low: N;
  readonly high: N;
  /** An integer, by one word of the source as its `range`; of BigInts by two, the leading one first. */
  draw(source: Source): N;
  /**
   * An integer by two words in any case. Of n integers each has 2⁶⁴/n of all pairs of words, rounded down or up: take it from some
   * 65,536 integers on.
   */
  drawWide(source: Source): N;
}

export declare const Integers: {
  /** @throws RangeError where `low` is above `high`, for more than 2³² numbers, and for what is no such integer. */
  new (low: number, high: number): Integers<number>;
  new (low: bigint, high: bigint): Integers<bigint>;
  readonly prototype: Integers<number | bigint>;
};
