import { Source } from "./source.js";

/** Two numbers. */
export type Vector2 = readonly [number, number] | Float32Array | Float64Array;
/** Three numbers. */
export type Vector3 = readonly [number, number, number] | Float32Array | Float64Array;

/**
 * A map from uniforms in [0, 1) to points, with the density of the points.
 *
 * A point on the line is a number, any other an array of `dimensions` numbers; uniforms likewise. Numbers are rounded to
 * 32 bits. Arrays hold element after element. The same uniforms give the same bits as the Rust crate `microwarp`, tier `poly`.
 */
export declare abstract class Warp<Point = number | number[], Uniforms = number | number[]> {
  /** The numbers of a point. */
  static readonly dimensions: number;
  /** The uniforms of a sample. */
  static readonly uniforms: number;
  /** The numbers of a point. */
  readonly dimensions: number;
  /** The uniforms of a sample. */
  readonly uniforms: number;

  /** Draws a point. For many, `fill` is several times faster. */
  draw(source: Source): Point;
  /** The point of uniforms of your own; those outside [0, 1), and NaN, are brought into range. */
  sample(uniforms: Readonly<Uniforms>): Point;
  /**
   * The density at a point: per unit of length, area or solid angle. It is 0 outside the domain and for NaN. Directions are
   * taken to have length 1: the density of a vector of another length is finite, not below 0, and means nothing.
   */
  pdf(point: Readonly<Point>): number;
  /** The uniforms whose sample is this point. */
  invert(point: Readonly<Point>): Uniforms;

  /** Fills an array with drawn points, those that as many calls of `draw` would give; returns the array. */
  fill(points: Float32Array, source: Source): Float32Array;
  /** `sample` of each element of an array, into another; returns the latter. */
  map(uniforms: Float32Array, points: Float32Array): Float32Array;
  /** `pdf` of each point of an array, into another; returns the latter. */
  pdfs(points: Float32Array, densities: Float32Array): Float32Array;
  /** `invert` of each point of an array, into another; returns the latter. */
  inverts(points: Float32Array, uniforms: Float32Array): Float32Array;
}
