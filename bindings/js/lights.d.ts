import { Source } from "./source.js";

/**
 * Resampled importance sampling of a stream of candidates: holds one of them, chosen nearly in proportion to a target that need not be
 * normalised, such as the light that a lamp would send here if nothing stood between. Items are anything.
 *
 * The estimate of a sum of f over all items is f(item) · `contribution`, unbiased for every number of candidates if the target is
 * positive wherever f is not 0.
 *
 * **Domain**
 * - Targets: finite numbers of 32 bits, zero or positive. A candidate of target 0 is never held, but it counts.
 * - Densities, those by which the candidates were drawn: positive and finite; of a table the probability of the index.
 * - Words: two of the source a decision, whatever the candidate.
 *
 * **Accuracy**
 * The quotient of target and density is rounded once, sums have 64 bits, and a decision is off by less than 2⁻⁶³.
 *
 * **Source**
 * J. Talbot, D. Cline, P. Egbert, "Importance Resampling for Global Illumination", 2005,
 * <https://doi.org/10.2312/EGWR/EGSR05/139-146>; B. Bitterli and others, "Spatiotemporal Reservoir Resampling for Real-Time Ray Tracing
 * with Dynamic Direct Lighting", 2020, <https://doi.org/10.1145/3386569.3392481>.
 */
export declare class LightReservoir<T = unknown> {
  constructor();
  /**
   * Offers a candidate; true where it is held now.
   *
   * @throws RangeError for a target that is negative or not finite (codes 6 and 1), or a density that is not positive or not finite
   * (codes 5 and 1). Nothing is drawn or changed then; so too below.
   */
  offer(item: T, target: number, density: number, source: Source): boolean;
  /**
   * Merges the reservoir of another place, or of another time; true where its item was taken. `target` is that of its item here, anew.
   * Of a part of one stream it is the item's own `target`, and then the merger is exact.
   *
   * @throws RangeError for a target that is negative or not finite.
   */
  absorb(other: LightReservoir<T>, target: number, source: Source): boolean;
  /** Lets the reservoir count for no more than so many candidates when it is merged. Its contribution stays. 0 empties it. */
  cap(limit: number): void;
  /** Divides by so many candidates in place of `count`, which stays. Once, after all mergers. 0 lets go of the item. */
  normalise(candidates: number): void;
  /** The item that is held; undefined before the first of positive target. */
  readonly item: T | undefined;
  /** The target of the item, by which it was chosen; 0 while nothing is held. */
  readonly target: number;
  /** How many candidates were offered, those of target 0 among them. */
  readonly count: number;
  /** By what to multiply f of the item, in place of 1/density: correctly rounded. 0 while nothing is held. */
  readonly contribution: number;
}

/**
 * The balance heuristic of multiple importance sampling: the weight of a sample of the technique `own`, n p/∑ n p, where technique k takes
 * n = counts[k] samples and draws the point with density p = densities[k]. Neither overflows or vanishes. A negative or NaN density
 * counts as 0, and an infinite one outweighs every finite one. The weights of all techniques sum to 1 to rounding, or are 0 where no
 * technique has a positive density and count. Of N techniques it is right to N + 4 units in the last place, which is proven.
 *
 * Source: E. Veach, L. J. Guibas, "Optimally Combining Sampling Techniques for Monte Carlo Rendering", 1995,
 * <https://doi.org/10.1145/218380.218498>.
 *
 * @throws RangeError for no techniques or more than 4,096, for a count that is no integer below 2³², and for an `own` that there is not.
 * TypeError for not as many densities as counts.
 */
export declare function balanceHeuristic(counts: ArrayLike<number>, densities: ArrayLike<number>, own: number): number;
/** The power heuristic with exponent 2: the same with the squares of n p. Right to N + 10 units in the last place, which is proven. */
export declare function powerHeuristic(counts: ArrayLike<number>, densities: ArrayLike<number>, own: number): number;

/**
 * Russian roulette: by what to multiply what goes on with this chance, or undefined where it ends; by one word of the source.
 *
 * The weight is the inverse of the chance that words realise, ⌈2³²p⌉ of 2³², so that the mean stays what it was: chance times weight is
 * 1 to 6e-8. From a chance of 1 up everything goes on with weight 1; NaN and what is not above 0 ends everything.
 */
export declare function roulette(chance: number, source: Source): number | undefined;
