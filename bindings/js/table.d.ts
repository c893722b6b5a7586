import { Source } from "./source.js";
import { Vector2, Warp } from "./warp.js";

type Numbers = readonly number[] | Float32Array | Float64Array;

/** What a selection gives. */
export interface Selection {
  index: number;
  /** The probability of the index. */
  pmf: number;
  /** Where the uniform fell within the share of the index: a uniform again. */
  leftover: number;
}

/**
 * A table of weights that selects indices. Weights are rounded to 32 bits; the table holds probabilities as multiples of
 * 2⁻³², and what it reports is what it does.
 */
export declare abstract class Indices {
  /** @throws RangeError for weights that are negative or not finite, all zero, or too far apart. */
  constructor(weights: Numbers);
  /** How many weights there are. */
  readonly entries: number;
  draw(source: Source): number;
  select(uniform: number): Selection;
  /** The probability of an index. */
  pmf(index: number): number;
  /** Fills an array with drawn indices; returns the array. */
  fill(indices: Uint32Array, source: Source): Uint32Array;
}

/** Indices by cumulated weights: the index increases with the uniform, so that strata stay strata. */
export declare class Cdf extends Indices {}
/** Indices by the alias method, in constant time. */
export declare class Alias extends Indices {}

/** A density that is constant on cells of equal length, from `low` to `high`. */
export declare class PiecewiseConstant1d extends Warp<number, number> {
  constructor(weights: Numbers, low: number, high: number);
}
/** A density that is linear between weights at equally spaced points, from `low` to `high`. */
export declare class PiecewiseLinear1d extends Warp<number, number> {
  constructor(weights: Numbers, low: number, high: number);
}
/** A density that is constant on the cells of a grid: weights row by row, `shape` as columns and rows. */
export declare class PiecewiseConstant2d extends Warp<[number, number], [number, number]> {
  constructor(weights: Numbers, shape: readonly [number, number], u: Vector2, v: Vector2);
}
/**
 * Directions in proportion to the pixels of a picture of the sky in latitude and longitude: radiances row by row from the
 * pole +z, `shape` as columns and rows.
 */
export declare class LatLongMap extends Warp<[number, number, number], [number, number]> {
  constructor(radiances: Numbers, shape: readonly [number, number]);
}
