import { Warp } from "./warp.js";

/**
 * A point of one of several warps, picked by weight, with the density of the mixture: one-sample multiple importance sampling.
 *
 * The first uniform, or the first word of a draw, picks the part, and what is left of it is the first one of that part. So a mixture
 * takes as many uniforms as its parts, and points of a set keep their structure. A draw takes as many words as that of the part which
 * takes most: beside an `ExponentialTail`, which takes two, others leave the second.
 *
 * **Density**
 * Σ qᵢ pᵢ(x), with the probabilities qᵢ with which parts are picked, exactly: multiples of 2⁻³², less than that from weight/total.
 * A part of weight 0 is never picked, nor asked. `sampleWithPdf` and `drawWithPdf` take the density of the part that is picked from
 * its sampler.
 *
 * **Domain**
 * - Parts: 1 to 32 warps with as many uniforms, points of one kind, and densities by one measure: length, area, volume, solid angle, or
 *   the solid angle of normals. No part is a mixture.
 * - Weights: a finite one of each part, zero or positive, not all zero.
 *
 * **Accuracy**
 * A sample has the error of the part that is picked; a density those of the parts, and (N + 1) · 6e-8 of its own.
 *
 * The parts are copied into the mixture, which is slow of a large table: make it once.
 *
 * **Source**
 * E. Veach, "Robust Monte Carlo Methods for Light Transport Simulation", 1997, section 9.2.4,
 * <https://graphics.stanford.edu/papers/veach_thesis/>.
 */
export declare class Mixture<Point, Uniforms> extends Warp<Point, Uniforms> {
  /**
   * @throws TypeError for what is no array of warps, and for parts that do not mix. RangeError for none or more than 32, for another
   * number of weights, and for weights that are negative or not finite, all zero, or too far apart.
   */
  constructor(parts: readonly Warp<Point, Uniforms>[], weights: readonly number[] | Float32Array | Float64Array);
  /** The probability with which a part is picked; 0 for one that there is not. */
  pmf(part: number): number;
  /**
   * The uniforms by which a part gives this point. It may come of several: `uniform` picks one by the probability that the point came of
   * it, so that of a point of the mixture and of a random uniform the uniforms are again uniform. `inverts` takes ½.
   */
  invert(point: Readonly<Point>, uniform?: number): Uniforms;
}
