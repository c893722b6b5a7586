import { Source } from "./source.js";

/**
 * Gamma of a shape from 1e-30 to 1e6 and a scale, whose product is the mean: the waiting time for several events, the precision of a
 * normal distribution that is learnt. 1/x is inverse-gamma, of the scale 1/scale.
 *
 * A draw takes two words or three for a try, of which 95 in a hundred succeed, or more; so too of the classes below, for each share.
 * Of a set of points it takes one, and of that as many dimensions as it needs.
 */
export declare class Gamma {
  /**
   * @throws RangeError for NaN, for a shape or scale of 0 or less, a shape out of range, a scale below 2⁻¹²⁵, and where a number
   * could overflow.
   */
  constructor(shape: number, scale: number);
  /** The sum of the squares of so many standard normal numbers, which need not be a whole number of them. */
  static chiSquared(degrees: number): Gamma;
  /**
   * A number above 0; what is below 2⁻¹⁴⁹, as most numbers of small shapes, becomes that.
   *
   * @throws RangeError where no try within the budget is accepted, which no generator does in practice; so too below.
   */
  draw(source: Source): number;
  /** The natural logarithm of a number, also where the number itself is too small. */
  drawLn(source: Source): number;
  /** The density at a number; 0 below 0. */
  pdf(at: number): number;
}

/** Beta with two shapes: a share of a whole and its rest, such as a probability after a − 1 successes and b − 1 failures. */
export declare class Beta {
  /** @throws RangeError for NaN, and for a shape that is not from 1e-30 to 1e6. */
  constructor(a: number, b: number);
  /** x and 1 − x, each with digits of its own. */
  draw(source: Source): [number, number];
  /** The density at x, given with 1 − x. */
  pdf(shares: readonly [number, number]): number;
}

/** Dirichlet: shares of a whole, with a shape for each; from two of them, which is `Beta`, to eight. */
export declare class Dirichlet {
  /** @throws RangeError for fewer or more shapes, for NaN, and for a shape that is not from 1e-30 to 1e6. */
  constructor(shapes: ArrayLike<number>);
  /** How many shares there are. */
  readonly shares: number;
  /** The shares, none of them 0; their sum is 1 to rounding. */
  draw(source: Source): number[];
  /** The density at these shares, with respect to all but one. */
  pdf(shares: ArrayLike<number>): number;
}

/** The normal distribution of angles, in radians: about a mean direction, and uniform for a concentration of 0. */
export declare class VonMises {
  /**
   * @throws RangeError for NaN, a mean beyond 2π either way, and a concentration beside 0 that is not from 1e-30 to 1e30.
   */
  constructor(mean: number, concentration: number);
  /** An angle from −π to π: two words a try, of which two in three succeed, or more. */
  draw(source: Source): number;
  /** The density per radian. */
  pdf(at: number): number;
}
