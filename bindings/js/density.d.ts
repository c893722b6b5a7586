import { Source } from "./source.js";
import { Warp } from "./warp.js";

/** A point, and its density. */
export interface Sample<Point = number | number[]> {
  point: Point;
  /**
   * The density by the uniforms of the point, from what the sampler knows: often sharper than `Warp.pdf` of the rounded point, and
   * never 0. The two agree to the errors that the class states.
   */
  pdf: number;
}

/** `Warp.sample` of uniforms of your own, and the density. Uniforms outside [0, 1), and NaN, are brought into range. */
export declare function sampleWithPdf<Point, Uniforms>(warp: Warp<Point, Uniforms>, uniforms: Readonly<Uniforms>): Sample<Point>;
/** `Warp.draw`, and the density: the same point of the same words, in one call. */
export declare function drawWithPdf<Point, Uniforms>(warp: Warp<Point, Uniforms>, source: Source): Sample<Point>;
/**
 * Fills two arrays with drawn points and their densities, those of as many calls of `drawWithPdf`; returns the points.
 *
 * @throws RangeError where the arrays have not as many elements; nothing has been drawn then. So too `mapWithPdf`.
 */
export declare function fillWithPdf<Point, Uniforms>(
  warp: Warp<Point, Uniforms>,
  points: Float32Array,
  densities: Float32Array,
  source: Source,
): Float32Array;
/** `sampleWithPdf` of each element of an array, into two others; returns the points. */
export declare function mapWithPdf<Point, Uniforms>(
  warp: Warp<Point, Uniforms>,
  uniforms: Float32Array,
  points: Float32Array,
  densities: Float32Array,
): Float32Array;
