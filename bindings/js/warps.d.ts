// The warps, by `cargo regenerate` from crates/list/src/warps.rs and the documentation in src.
import { Gloss, Lamp, Surface } from "./lamps.js";
import { Vector2, Vector3, Warp } from "./warp.js";

/**
 * Uniform on an interval [a, b).
 *
 * `new Interval` runs from `a` at u = 0 up to, never reaching, `b`. `Interval.decreasing` runs from `b` at u = 0 down
 * to, never reaching, `a`. Neither ever turns back, whatever the bounds. Where `f32` has fewer points than there are
 * uniforms, each point has its share of them, to within three.
 *
 * **Density**
 * 1/(b − a) on [a, b], else 0.
 *
 * **Domain**
 * - Point: [a, b), or (a, b] where it decreases.
 * - Uniforms: one.
 * - Parameters: finite a < b. The width may overflow `f32`.
 * - Both tiers share this code.
 *
 * **Accuracy**
 * *Sample* counts units in the last place (ulp) of the larger bound, the scale. *Pdf* and *realised density* are
 * relative, *inverse* and *round trip* are absolute errors of the uniform. [What each row
 * means](https://docs.rs/microwarp/latest/microwarp/warp/#stated-errors).
 *
 * | error | bound | kind |
 * |---|--:|---|
 * | sample, ulp of the scale | 1.75 | proven |
 * | pdf, relative | 1.2e-7 | proven |
 * | realised density, relative | 1.2e-7 | proven |
 * | inverse | 2e-7 | found |
 * | round trip | 1.8e-7 + 1.63*r | found |
 *
 * The errors of samples and densities are proven for all bounds and uniforms: see `docs/proofs.md`.
 *
 * r is the change of the inverse when x moves by one ulp of the larger bound. On the 24-bit grid, samples are within
 * 1.5 ulp, or 1.13 where the bounds differ in sign.
 *
 * **Source**
 * F. Goualard, "Drawing Random Floating-Point Numbers from an Interval", ACM Transactions on Modeling and Computer
 * Simulation, 2022, <https://doi.org/10.1145/3503512>.
 */
export declare class Interval extends Warp<number, number> {
  /**
   * Uniform on [a, b), increasing with the uniform.
   *
   * @throws RangeError:
   * NotFinite (code 1) for NaN or infinite bounds, Reversed (code 2) for a > b, Empty (code 3) for a = b or a width
   * whose reciprocal overflows.
   */
  constructor(low: number, high: number);
  /**
   * Uniform on (a, b], decreasing with the uniform: b at u = 0.
   *
   * @throws RangeError:
   * The errors of `new Interval`.
   */
  static decreasing(low: number, high: number): Interval;
}

/**
 * A power law on an interval: density ∝ xⁿ on [a, b], for any exponent.
 *
 * With m = n + 1, xᵐ is uniform between aᵐ and bᵐ. The code works relative to the end R where xᵐ is larger, with t = 1
 * − (x/R)ᵐ, and takes the logarithm of 1 − t, so that nothing overflows and m near 0 does not cancel. In `poly` it
 * comes by a table or, for m near 0, by a series, in a fraction of the time. `new Power` runs from a at u = 0 to b,
 * `Power.decreasing` from b to a. A sample never steps back from one uniform of the grid to the next.
 *
 * **Density**
 * m xⁿ/(bᵐ − aᵐ), or 1/(x ln(b/a)) for n = −1, on [a, b]; else 0. `sampleWithPdf` takes it from the uniform.
 *
 * **Domain**
 * - Point: [a, b]; above 0 where the density is 0 or infinite at a = 0.
 * - Uniforms: one.
 * - Parameters: 0 ≤ a < b, and any n: −1, near −1, 0, up to ±1e8 and beyond. n > −1 where a = 0.
 *
 * With a = 0 and n < 0 the density is infinite at 0. The largest `f32` stands for densities above it, and samples that
 * would be smaller than 2⁻¹⁴⁹ are 2⁻¹⁴⁹, as most are for n within 1e-3 of −1.
 *
 * **Accuracy**
 * *Sample* counts units in the last place (ulp) of the exact point. *Pdf* and *realised density* are relative,
 * *inverse* and *round trip* are absolute errors of the uniform. [What each row
 * means](https://docs.rs/microwarp/latest/microwarp/warp/#stated-errors).
 *
 * | error | `poly` | kind |
 * |---|--:|---|
 * | sample, ulp | 3.7 + 4.9·min(1/k, k·d·d) | found |
 * | pdf, relative | 1.6e-7 | found |
 * | realised density, relative | 1.7e-7 + (3.7 + 4.8·min(1/k, k·d·d))·s/max(0, 1 - k/1e6) | found |
 * | pdf with the sample, relative | 4.3e-7 + 3.2e-7·min(1/k, k·d·d) + 1.8*s | found |
 * | inverse | 3.5e-7 | found |
 * | round trip | 3e-7 + (3.3 + 4.2·min(1/k, k·d·d))·r | found |
 *
 * k is |n + 1| and d is log₂(b/a), infinite for a = 0. In `poly` no realised density is stated from k = 1e6 on, where
 * the densities of neighbouring `f32` differ by a factor. s and r are the relative change of the exact density and the
 * change of the exact inverse over one ulp of x.
 *
 * **Source**
 * M. E. J. Newman, "Power Laws, Pareto Distributions and Zipf's Law", 2005,
 * <https://doi.org/10.1080/00107510500052444>. The stable form is derived here.
 */
export declare class Power extends Warp<number, number> {
  /**
   * Density ∝ xⁿ on [a, b], increasing with the uniform.
   *
   * @throws RangeError:
   * NotFinite (code 1) for NaN or infinity, Negative (code 6) for a < 0, Reversed (code 2) for a > b, Empty (code 3)
   * for a = b or a density that overflows, at b or at an a > 0, NotNormalizable (code 8) for a = 0 with n ≤ −1.
   */
  constructor(exponent: number, low: number, high: number);
  /**
   * Density ∝ xⁿ on [a, b], decreasing with the uniform: b at u = 0.
   *
   * @throws RangeError:
   * The errors of `new Power`.
   */
  static decreasing(exponent: number, low: number, high: number): Power;
}

/**
 * The largest of N uniforms: density N x^(N−1) on [0, 1).
 *
 * The power law of exponent n = N − 1, without a logarithm or a root in the sample. The loop is bounded by N.
 *
 * **Density**
 * N x^(N−1) on [0, 1], else 0.
 *
 * **Domain**
 * - Point: (0, 1).
 * - Uniforms: N, all alike. N = 0 does not compile.
 * - Inverse: many sets of uniforms share their largest. `invert` gives N times the point itself, whose sample is the
 *   point exactly.
 * - Both tiers share this code.
 *
 * **Accuracy**
 * *Sample* counts units in the last place (ulp) of the exact point. *Pdf* and *realised density* are relative,
 * *inverse* and *round trip* are absolute errors of the uniform. [What each row
 * means](https://docs.rs/microwarp/latest/microwarp/warp/#stated-errors).
 *
 * | error | bound | kind |
 * |---|--:|---|
 * | sample, ulp | 1 | proven |
 * | pdf, relative | 1.6e-7 | found |
 * | realised density, relative | 1.6e-7 | found |
 * | inverse | 0 | found |
 * | round trip | 1.9e-45 | found |
 *
 * The error of a sample is proven for all parameters and uniforms: see `docs/proofs.md`.
 *
 * **Source**
 * L. Devroye, "Non-Uniform Random Variate Generation", 1986, <https://doi.org/10.1007/978-1-4613-8643-8>.
 */
export declare class PowerMax2 extends Warp<number, [number, number]> {
  /**
   * The largest of N uniforms.
   */
  constructor();
}

/**
 * The largest of N uniforms: density N x^(N−1) on [0, 1).
 *
 * The power law of exponent n = N − 1, without a logarithm or a root in the sample. The loop is bounded by N.
 *
 * **Density**
 * N x^(N−1) on [0, 1], else 0.
 *
 * **Domain**
 * - Point: (0, 1).
 * - Uniforms: N, all alike. N = 0 does not compile.
 * - Inverse: many sets of uniforms share their largest. `invert` gives N times the point itself, whose sample is the
 *   point exactly.
 * - Both tiers share this code.
 *
 * **Accuracy**
 * *Sample* counts units in the last place (ulp) of the exact point. *Pdf* and *realised density* are relative,
 * *inverse* and *round trip* are absolute errors of the uniform. [What each row
 * means](https://docs.rs/microwarp/latest/microwarp/warp/#stated-errors).
 *
 * | error | bound | kind |
 * |---|--:|---|
 * | sample, ulp | 1 | proven |
 * | pdf, relative | 1.6e-7 | found |
 * | realised density, relative | 1.6e-7 | found |
 * | inverse | 0 | found |
 * | round trip | 1.9e-45 | found |
 *
 * The error of a sample is proven for all parameters and uniforms: see `docs/proofs.md`.
 *
 * **Source**
 * L. Devroye, "Non-Uniform Random Variate Generation", 1986, <https://doi.org/10.1007/978-1-4613-8643-8>.
 */
export declare class PowerMax3 extends Warp<number, [number, number, number]> {
  /**
   * The largest of N uniforms.
   */
  constructor();
}

/**
 * The largest of N uniforms: density N x^(N−1) on [0, 1).
 *
 * The power law of exponent n = N − 1, without a logarithm or a root in the sample. The loop is bounded by N.
 *
 * **Density**
 * N x^(N−1) on [0, 1], else 0.
 *
 * **Domain**
 * - Point: (0, 1).
 * - Uniforms: N, all alike. N = 0 does not compile.
 * - Inverse: many sets of uniforms share their largest. `invert` gives N times the point itself, whose sample is the
 *   point exactly.
 * - Both tiers share this code.
 *
 * **Accuracy**
 * *Sample* counts units in the last place (ulp) of the exact point. *Pdf* and *realised density* are relative,
 * *inverse* and *round trip* are absolute errors of the uniform. [What each row
 * means](https://docs.rs/microwarp/latest/microwarp/warp/#stated-errors).
 *
 * | error | bound | kind |
 * |---|--:|---|
 * | sample, ulp | 1 | proven |
 * | pdf, relative | 1.6e-7 | found |
 * | realised density, relative | 1.6e-7 | found |
 * | inverse | 0 | found |
 * | round trip | 1.9e-45 | found |
 *
 * The error of a sample is proven for all parameters and uniforms: see `docs/proofs.md`.
 *
 * **Source**
 * L. Devroye, "Non-Uniform Random Variate Generation", 1986, <https://doi.org/10.1007/978-1-4613-8643-8>.
 */
export declare class PowerMax4 extends Warp<number, [number, number, number, number]> {
  /**
   * The largest of N uniforms.
   */
  constructor();
}

/**
 * Exponential with rate a, increasing with the uniform: free paths, waiting times.
 *
 * x = −ln(1 − u)/a.
 *
 * **Density**
 * a e^(−ax) for x ≥ 0, else 0.
 *
 * **Domain**
 * - Point: [0, 16.64/a]. The largest uniform sets the largest sample.
 * - Uniforms: one.
 * - Parameters: a rate, or a mean, above 0.
 *
 * **Accuracy**
 * *Sample* counts units in the last place (ulp) of the exact point. *Pdf* and *realised density* are relative,
 * *inverse* and *round trip* are absolute errors of the uniform. [What each row
 * means](https://docs.rs/microwarp/latest/microwarp/warp/#stated-errors).
 *
 * | error | `poly` | kind |
 * |---|--:|---|
 * | sample, ulp | 3.2 | proven |
 * | pdf, relative | 2.8e-7 | found |
 * | realised density, relative | 3.4e-7 + 2.9*s | found |
 * | pdf with the sample, relative | 1.2e-7 | proven |
 * | inverse | 8.5e-8 | found |
 * | round trip | 4.3e-8 + 2.2*r | found |
 *
 * The errors of a sample and of the density with it are proven for all parameters and uniforms: see `docs/proofs.md`.
 *
 * s and r are the relative change of the density and the change of the inverse when x moves by one ulp.
 *
 * **Source**
 * J. von Neumann, "Various Techniques Used in Connection with Random Digits", 1951.
 */
export declare class Exponential extends Warp<number, number> {
  private constructor();
  /**
   * Exponential with the given rate (the reciprocal of the mean).
   *
   * @throws RangeError:
   * NotFinite (code 1) for NaN or infinity, NotPositive (code 5) for 0 or less, TooLarge (code 4) for a rate so small
   * that the tail overflows (below 3.1e-37).
   */
  static fromRate(rate: number): Exponential;
  /**
   * Exponential with the given mean. Its rate is 1/mean, rounded to `f32`.
   *
   * @throws RangeError:
   * NotFinite (code 1) for NaN or infinity, NotPositive (code 5) for 0 or less, Empty (code 3) for a mean so small that
   * the density overflows (below 2.9e-39), TooLarge (code 4) for one so large that the tail does (above 3.2e36).
   */
  static fromMean(mean: number): Exponential;
}

/**
 * Exponential with rate a, decreasing with the uniform, so that samples reach far into the tail.
 *
 * x = −ln(u)/a. Small uniforms keep their precision in `f32`, so this orientation reaches 44.36/a from full-resolution
 * uniforms, which is what `Warp.draw` takes here (45.06/a where all 64 bits are 0). An explicit u = 0 counts as 2⁻¹⁴⁹
 * and gives 103.28/a.
 *
 * **Density**
 * a e^(−ax) for x ≥ 0, else 0.
 *
 * **Domain**
 * - Point: [5.9e-8/a, 103.28/a].
 * - Uniforms: one. Drawing takes **two** words of the generator for it.
 * - Parameters: a rate, or a mean, above 0.
 *
 * **Accuracy**
 * *Sample* counts units in the last place (ulp) of the exact point. *Pdf* and *realised density* are relative,
 * *inverse* and *round trip* are absolute errors of the uniform. [What each row
 * means](https://docs.rs/microwarp/latest/microwarp/warp/#stated-errors).
 *
 * | error | `poly` | kind |
 * |---|--:|---|
 * | sample, ulp | 3 | proven |
 * | pdf, relative | 7.4e-7 | found |
 * | realised density, relative | 3e-7 + 2*s | found |
 * | pdf with the sample, relative | 6e-8 | proven |
 * | inverse | 8.4e-8 | found |
 * | round trip | 5.3e-8 + 2.6*r | found |
 *
 * The errors of a sample and of the density with it are proven for all parameters and uniforms: see `docs/proofs.md`.
 *
 * s and r are the relative change of the density and the change of the inverse when x moves by one ulp.
 *
 * **Source**
 * J. von Neumann, "Various Techniques Used in Connection with Random Digits", 1951.
 */
export declare class ExponentialTail extends Warp<number, number> {
  private constructor();
  /**
   * Exponential with the given rate (the reciprocal of the mean).
   *
   * @throws RangeError:
   * NotFinite (code 1) for NaN or infinity, NotPositive (code 5) for 0 or less, TooLarge (code 4) for a rate so small
   * that the tail overflows (below 3.1e-37).
   */
  static fromRate(rate: number): ExponentialTail;
  /**
   * Exponential with the given mean. Its rate is 1/mean, rounded to `f32`.
   *
   * @throws RangeError:
   * NotFinite (code 1) for NaN or infinity, NotPositive (code 5) for 0 or less, Empty (code 3) for a mean so small that
   * the density overflows (below 2.9e-39), TooLarge (code 4) for one so large that the tail does (above 3.2e36).
   */
  static fromMean(mean: number): ExponentialTail;
}

/**
 * Exponential on [0, X], with a rate of either sign: density ∝ e^(−cx).
 *
 * With z = cX: x = −ln(1 + u(e^(−z) − 1))/c, in a form chosen by z so that neither a small nor a large product cancels
 * or overflows. A rate of 0 is the uniform distribution, a negative rate a rising density.
 *
 * **Density**
 * c e^(−cx)/(1 − e^(−z)) on [0, X], else 0.
 *
 * **Domain**
 * - Point: [0, X].
 * - Uniforms: one.
 * - Parameters: any finite rate c, or a mean 1/c above 0 (that of the distribution before it is truncated), and a
 *   length X above 0.
 *
 * **Accuracy**
 * *Sample* counts units in the last place (ulp) of the exact point. *Pdf* and *realised density* are relative,
 * *inverse* and *round trip* are absolute errors of the uniform. [What each row
 * means](https://docs.rs/microwarp/latest/microwarp/warp/#stated-errors).
 *
 * | error | `poly` | kind |
 * |---|--:|---|
 * | sample, ulp | 5 | proven |
 * | pdf, relative | 2.4e-7 | found |
 * | realised density, relative | 2.4e-7 + 3.5*s | found |
 * | pdf with the sample, relative | 4.4e-7 | found |
 * | inverse | 3.4e-7 | found |
 * | round trip | 3e-7 + 2*r | found |
 *
 * s and r are the relative change of the exact density and the change of the exact inverse over one ulp of x.
 *
 * **Source**
 * C. Kulla and M. Fajardo, "Importance Sampling Techniques for Path Tracing in Participating Media", 2012,
 * <https://doi.org/10.1111/j.1467-8659.2012.03148.x>.
 */
export declare class TruncatedExponential extends Warp<number, number> {
  private constructor();
  /**
   * Density ∝ e^(−rate·x) on [0, length].
   *
   * @throws RangeError:
   * NotFinite (code 1) for NaN or infinity, NotPositive (code 5) for a length of 0 or less, Empty (code 3) for a length
   * whose reciprocal overflows.
   */
  static fromRate(rate: number, length: number): TruncatedExponential;
  /**
   * Density ∝ e^(−x/mean) on [0, length]: the exponential distribution of this mean, truncated. Its rate is 1/mean,
   * rounded to `f32`.
   *
   * @throws RangeError:
   * NotFinite (code 1) for NaN or infinity, NotPositive (code 5) for a mean or a length of 0 or less, Empty (code 3)
   * for a mean or a length whose reciprocal overflows.
   */
  static fromMean(mean: number, length: number): TruncatedExponential;
}

/**
 * Equi-angular sampling along a ray: density in proportion to 1/(D² + t²), the light that a point sends to each place
 * of a ray through fog.
 *
 * D is the distance at which the ray passes the light, and t the way along the ray from the foot, the place nearest to
 * the light. Seen from the light, the samples are uniform in angle. With Δ the angle between its ends, r their
 * distances to the light, `X = r_far sin((1 − w)Δ)` and `Y = r_near sin(wΔ)`, t is near + (far − near)Y/(X + Y), a
 * quotient of sums without cancellation. `near` is the end nearer to the foot, or the foot itself where the segment
 * passes it.
 *
 * **Density**
 * D/(Δ(D² + t²)) on [low, high]. Where Δ is below 2.5e-4 radians, D = 0 included, it is the limit of that: `r_low
 * r_high/((high − low)(D² + t²))`, for D = 0 in proportion to 1/t².
 *
 * **Domain**
 * [low, high], in the unit of length of the parameters. One uniform; t increases with it up to rounding: from one
 * uniform of the grid to the next it steps back by at most 7 ulp, as the table counts them. `low` and `high` are within
 * ±2⁴⁰ (1.1e12) and at least 2⁻⁴⁰ (9e-13) apart. D is from 2⁻⁴⁰ to 2⁴⁰, or 0 where the light lies on the ray and not on
 * the segment: both ends are at least 2⁻⁴⁰ away from it then, on one side.
 *
 * **Accuracy**
 * | error | `poly` | kind |
 * |---|--:|---|
 * | sample, ulp of itself or of a length | 15 | proven |
 * | pdf, relative | 6.5e-7 | found |
 * | realised density, relative | 6.6e-7 + 8.3*s | found |
 * | inverse | 5.6e-7 | found |
 * | round trip | 4.5e-7 + 2.1*r | found |
 *
 * An ulp is that of t. Where the segment passes the foot it is that of D, or of the longer part where that is shorter
 * than D, as long as t is below. s and r: by how much the exact density, relatively, and the exact inverse change over
 * one such ulp.
 *
 * **Source**
 * C. Kulla and M. Fajardo, "Importance Sampling Techniques for Path Tracing in Participating Media", 2012,
 * <https://doi.org/10.1111/j.1467-8659.2012.03148.x>, rearranged here.
 */
export declare class EquiAngular extends Warp<number, number> {
  /**
   * Sampling of the segment [low, high] of a ray that passes a light at the given distance. Places on the ray are
   * measured from the foot, the place nearest to the light.
   *
   * @throws RangeError:
   * NotFinite (code 1) for NaN or infinity, Reversed (code 2) for ends in the wrong order, Empty (code 3) for ends less
   * than 2⁻⁴⁰ apart, TooLarge (code 4) for a length above 2⁴⁰, Negative (code 6) for a distance below 0, OutOfRange
   * (code 7) for one above 0 and below 2⁻⁴⁰, NotNormalizable (code 8) for a light on the segment, or on its line and
   * less than 2⁻⁴⁰ away.
   */
  constructor(distance: number, low: number, high: number);
}

/**
 * The tent (triangle) filter on (−r, r): a density that falls linearly from the centre to 0 at ±r.
 *
 * With t = 2u below the middle and t = 2(1 − u) above, x = ∓r(1 − t)/(1 + √t), which is ∓r(1 − √t) without its
 * cancellation at the centre. Samples increase with the uniform, whatever the radius.
 *
 * **Density**
 * (1 − |x|/r)/r where |x| < r, else 0.
 *
 * **Domain**
 * - Point: (−r, r). The ends, where the density is 0, are never returned.
 * - Uniforms: one. Drawing takes all 32 bits of a word, as the middle of their cell, so that no draw lies nearer to an
 *   end than its share.
 * - Parameters: a finite radius from the smallest normal `f32` up.
 * - Both tiers share this code. It needs nothing but a square root.
 *
 * **Accuracy**
 * *Sample* counts units in the last place (ulp) of the exact point. *Pdf* and *realised density* are relative,
 * *inverse* and *round trip* are absolute errors of the uniform. [What each row
 * means](https://docs.rs/microwarp/latest/microwarp/warp/#stated-errors).
 *
 * | error | bound | kind |
 * |---|--:|---|
 * | sample, ulp | 4 | proven |
 * | pdf, relative | 2.4e-7 | found |
 * | realised density, relative | 1.9e-7 + 3.3*s | found |
 * | pdf with the sample, relative | 2.6e-7 | found |
 * | inverse | 1.8e-7 | found |
 * | round trip | 1.8e-7 + 3.3*r | found |
 *
 * The error of a sample is proven for all parameters and uniforms: see `docs/proofs.md`.
 *
 * s and r are the relative change of the density, which falls to 0 at the ends, and the change of the inverse when x
 * moves by one ulp. On the 24-bit grid samples are within 2.4 ulp. A uniform below 2⁻⁴⁹ gives the last point before the
 * end, and with it the density of that point.
 *
 * **Source**
 * M. Pharr, W. Jakob and G. Humphreys, "Physically Based Rendering", third edition, 2016,
 * <https://pbr-book.org/3ed-2018/contents>. The form is derived here.
 */
export declare class Tent extends Warp<number, number> {
  /**
   * The tent of the given radius about 0.
   *
   * @throws RangeError:
   * NotFinite (code 1) for NaN or infinity, NotPositive (code 5) for 0 or less, Empty (code 3) for a radius below the
   * smallest normal `f32`.
   */
  constructor(radius: number);
}

/**
 * Linear on [0, 1): density ∝ (1 − x)a + xb.
 *
 * x = u(a + b)/(a + √((1 − u)a² + ub²)), which stays accurate where a and b are nearly equal, followed by one step of
 * Newton's method in higher precision. Samples increase with the uniform, whatever the densities.
 *
 * **Density**
 * 2((1 − x)a + xb)/(a + b) on [0, 1], else 0.
 *
 * **Domain**
 * - Point: [0, 1); (0, 1) where a is 0.
 * - Uniforms: one.
 * - Parameters: finite a and b, neither negative nor both 0.
 * - Both tiers share this code. It needs nothing but a square root.
 *
 * **Accuracy**
 * *Sample* counts units in the last place (ulp) of the exact point. *Pdf* and *realised density* are relative,
 * *inverse* and *round trip* are absolute errors of the uniform. [What each row
 * means](https://docs.rs/microwarp/latest/microwarp/warp/#stated-errors).
 *
 * | error | bound | kind |
 * |---|--:|---|
 * | sample, ulp | 0.76 | proven |
 * | pdf, relative | 3.4e-7 | found |
 * | realised density, relative | 3.2e-7 + 0.7*s | found |
 * | pdf with the sample, relative | 3.6e-7 | found |
 * | inverse | 3.3e-7 | found |
 * | round trip | 3.2e-7 + 0.8*r | found |
 *
 * s and r are the relative change of the density and the change of the inverse when x moves by one ulp. The error of a
 * sample is proven for all densities and uniforms: see `docs/proofs.md`. Only samples below 3e-38 are off by more than
 * 0.51 ulp.
 *
 * **Source**
 * M. Pharr, W. Jakob and G. Humphreys, "Physically Based Rendering", fourth edition, 2023,
 * <https://pbr-book.org/4ed/contents>.
 */
export declare class Linear extends Warp<number, number> {
  /**
   * Density ∝ `a` at 0 and ∝ `b` at 1.
   *
   * @throws RangeError:
   * NotFinite (code 1) for NaN or infinity, Negative (code 6) if either is below 0, NotPositive (code 5) if both are 0.
   */
  constructor(densityAt0: number, densityAt1: number);
}

/**
 * Normal (Gaussian) with a mean and a standard deviation, one number at a time.
 *
 * x = μ + σΦ⁻¹(u), increasing with the uniform, so that strata stay strata: never back from one uniform of the 24-bit
 * grid to the next, and by at most 2 ulp of location or distance from one word to the next. Up to 2.88σ it comes by a
 * table of 640 bytes, beyond by a logarithm and a root. Words as far from either end give opposite Φ⁻¹(u), to the last
 * bit.
 *
 * **Density**
 * e^(−(x−μ)²/2σ²)/(σ√2π), at least 2⁻¹⁴⁹ for every finite x.
 *
 * **Domain**
 * - Point: drawn samples end at 6.34σ on both sides. Uniforms on the 24-bit grid give −5.30σ to 5.30σ, except u = 0: it
 *   counts as 2⁻¹⁴⁹ and gives −14.2σ, an outlier that comes once in 2²⁴ uniforms.
 * - Uniforms: one. Drawing takes all 32 bits of a word, as the middle of their cell, so that the moments of what can be
 *   drawn are those of the normal distribution (the eighth to 1e-6).
 * - Parameters: a finite mean and a standard deviation above 0 for which no sample overflows. A standard deviation near
 *   the spacing of `f32` at the mean (6e-8 of it) is lost in the rounding of the samples.
 *
 * **Accuracy**
 * *Sample* counts units in the last place (ulp) of μ or of x − μ, whichever is larger. *Pdf* and *realised density* are
 * relative, *inverse* and *round trip* are absolute errors of the uniform. [What each row
 * means](https://docs.rs/microwarp/latest/microwarp/warp/#stated-errors).
 *
 * A draw keeps the bound of a sample at the exact middle of its word. The realised density is stated for |μ| < 1e6 σ.
 * In its formula w is |μ|/σ, and the divisor max(0, 1 − w/1e6) ends it there: it is nearly 1 for common parameters, and
 * beyond 1e6 the densities of neighbouring `f32` differ by a factor. s and r are the relative change of the density and
 * the change of the inverse when x moves by one ulp.
 *
 * | error | bound | kind |
 * |---|--:|---|
 * | sample, ulp of location or distance | 7.1 | proven |
 * | pdf, relative | 7.9e-7 | found |
 * | realised density, relative | 7.7e-7 + 5.4*s/max(0, 1 - w/1e6) | found |
 * | pdf with the sample, relative | 4.8e-7 | proven |
 * | inverse | 2.5e-7 | found |
 * | round trip | 2.1e-7 + 3*r | found |
 *
 * The errors of a sample and of the density with it are proven for all parameters and uniforms: see `docs/proofs.md`.
 *
 * **Source**
 * M. J. Wichura, "Algorithm AS 241: The Percentage Points of the Normal Distribution", 1988,
 * <https://doi.org/10.2307/2347330>, for the division into regions. The table and the coefficients are this crate's
 * own.
 */
export declare class Normal extends Warp<number, number> {
  /**
   * Normal with the given mean and standard deviation.
   *
   * @throws RangeError:
   * NotFinite (code 1) for NaN or infinity, NotPositive (code 5) for a standard deviation of 0 or less, TooLarge (code
   * 4) if a sample could overflow, Empty (code 3) if the density could.
   */
  constructor(mean: number, stdDev: number);
}

/**
 * Two independent normals (Gaussians) with a common standard deviation, by Box and Muller's map.
 *
 * Radius σ√(−2 ln(1 − u₁)), angle u₂ turns: a point of the plane about the mean point.
 *
 * **Density**
 * e^(−r²/2σ²)/(2πσ²) per unit area, at least 2⁻¹⁴⁹ for every finite point.
 *
 * **Domain**
 * - Point: within 5.77σ of the mean point.
 * - Uniforms: two, radius and angle. u₁ = 0 gives the mean point itself.
 * - Parameters: a finite mean point and a standard deviation above 0 for which neither samples nor the density
 *   overflow.
 *
 * **Accuracy**
 * *Sample* is the distance from the exact point, relative to the size: the farthest coordinate, which is the larger |μ|
 * plus 5.77σ. *Pdf* and *realised density* are relative, *inverse* and *round trip* are absolute errors of the
 * uniforms. [What each row means](https://docs.rs/microwarp/latest/microwarp/warp/#stated-errors).
 *
 * | error | bound | kind |
 * |---|--:|---|
 * | sample, of the size | 3.6e-7 | proven |
 * | pdf, relative | 4.4e-7 | found |
 * | realised density, relative | 7.2e-7 + 5.3*s/max(0, 1 - w/1e6) | found |
 * | pdf with the sample, relative | 3.9e-7 | found |
 * | inverse | 2.1e-7 | found |
 * | round trip | 1.5e-7 + 1.8*r | found |
 *
 * w is the larger |μ| over σ; no realised density is stated from 1e6 on. s and r are the relative change of the density
 * and the change of the inverse when the point moves by 2⁻²⁴ of the size. The error of the sample is proven for all
 * parameters and every pair of uniforms: see `docs/proofs.md`.
 *
 * **Source**
 * G. E. P. Box and M. E. Muller, "A Note on the Generation of Random Normal Deviates", 1958,
 * <https://doi.org/10.1214/aoms/1177706645>.
 */
export declare class NormalPair extends Warp<[number, number], [number, number]> {
  /**
   * Normals about the given mean point with the given standard deviation in each coordinate.
   *
   * @throws RangeError:
   * NotFinite (code 1) for NaN or infinity, NotPositive (code 5) for a standard deviation of 0 or less, TooLarge (code
   * 4) if a sample could overflow or the density vanish, Empty (code 3) if the density could overflow.
   */
  constructor(mean: Vector2, stdDev: number);
}

/**
 * Student's t in the plane: a point whose coordinates are two Student's t of one outlier, with common degrees of
 * freedom.
 *
 * Radius σ√ν √((1 − u₁)^(−2/ν) − 1), angle u₂ turns, Bailey's form. Each coordinate alone is a `StudentT`; they are not
 * independent, since a far point is far in both.
 *
 * **Density**
 * (1 + r²/νσ²)^(−(ν+2)/2)/(2πσ²) per unit area, at least 2⁻¹⁴⁹ for every finite point.
 *
 * **Domain**
 * - Point: drawn samples end at √ν √(4^(33/ν) − 1) σ from the location: 8.6e9σ for one degree of freedom, 6.8σ for
 *   many.
 * - Uniforms: two, radius and angle. u₁ = 0 gives the location itself. Drawing takes all 32 bits of the word of the
 *   radius, as the middle of their cell.
 * - Parameters: degrees of freedom above 0 that need not be whole, a finite location and a scale above 0, for which
 *   neither samples nor the density overflow: at a scale of 1, from 0.27 degrees on.
 *
 * **Accuracy**
 * *Sample* is the distance from the exact point, relative to the farther of the exact point's distance from the
 * location and of the location's coordinates from 0, and at least to 2⁻¹²⁶. *Pdf* and *realised density* are relative,
 * *inverse* and *round trip* are absolute errors of the uniforms. [What each row
 * means](https://docs.rs/microwarp/latest/microwarp/warp/#stated-errors).
 *
 * | error | bound | kind |
 * |---|--:|---|
 * | sample, of the distance or the location | 8.3e-7 | found |
 * | pdf, relative | 7.4e-7 | found |
 * | realised density, relative | 8.6e-7 + 12*s/max(0, 1 - w/1e6) | found |
 * | inverse | 2.1e-7 | found |
 * | round trip | 3e-7 + 4.5*r | found |
 *
 * w is the larger |location| over σ; no realised density is stated from 1e6 on. s and r are the relative change of the
 * density and the change of the inverse when the point moves by 2⁻²⁴ of the unit of the sample's error.
 *
 * **Source**
 * R. W. Bailey, "Polar Generation of Random Variates with the t-Distribution", 1994,
 * <https://doi.org/10.1090/S0025-5718-1994-1219702-8>. The forms free of cancellation are this crate's own.
 */
export declare class StudentPair extends Warp<[number, number], [number, number]> {
  /**
   * Student's t with these degrees of freedom about a location, with a scale of each coordinate.
   *
   * @throws RangeError:
   * NotFinite (code 1) for NaN or infinity, NotPositive (code 5) for degrees or a scale of 0 or less, TooLarge (code 4)
   * if a sample could overflow or the density vanish, Empty (code 3) if the density could overflow.
   */
  constructor(degrees: number, location: Vector2, scale: number);
}

/**
 * Student's t with some degrees of freedom, a location and a scale: noise with outliers, by how many of them there are.
 *
 * x = μ − σ√ν √((1 − u₁)^(−2/ν) − 1) cos πu₂, Bailey's form. It takes no loop, and increases with u₂. One degree of
 * freedom is `Cauchy`, and many are `Normal`; the form serves them all.
 *
 * **Density**
 * C(1 + t²/ν)^(−(ν+1)/2)/σ, where t = (x − μ)/σ and C = Γ((ν+1)/2)/(√(νπ) Γ(ν/2)); at least 2⁻¹⁴⁹ for every finite x.
 *
 * **Domain**
 * - Point: drawn samples end at √ν √(4^(33/ν) − 1) σ on both sides: 8.6e9σ for one degree of freedom, 6.8σ for many.
 * - Uniforms: two. Drawing takes all 32 bits of both words, as the middles of their cells, but for the second one near
 *   the location, of which 24 bits count. Words as far from either end of the second one give opposite numbers.
 * - Parameters: degrees of freedom above 0 that need not be whole, a finite location and a scale above 0, for which
 *   neither samples nor the density overflow: at a scale of 1, from 0.27 degrees on.
 * - Inverse: many pairs of uniforms share their point, and none is special. `invert` gives the pair with the smallest
 *   u₁, and u₂ at an end. A one-to-one map takes two numbers, `StudentPair`.
 *
 * **Accuracy**
 * *Sample* counts units in the last place (ulp) of the location or of the distance from it, whichever is larger. *Pdf*
 * and *realised density* are relative, *inverse* is the absolute error of the uniform. [What each row
 * means](https://docs.rs/microwarp/latest/microwarp/warp/#stated-errors).
 *
 * | error | bound | kind |
 * |---|--:|---|
 * | sample, ulp of location or distance | 14 | found |
 * | pdf, relative | 7.6e-7 | found |
 * | realised density, relative | 7.8e-7 + 9.7*s/max(0, 1 - w/1e6) | found |
 * | inverse | 1.8e-7 | found |
 * | round trip | 1 | found |
 *
 * w is |location|/scale. No realised density is stated from 1e6 on, where the densities of neighbouring `f32` differ by
 * a factor. s is the relative change of the density when x moves by one ulp.
 *
 * **Source**
 * R. W. Bailey, "Polar Generation of Random Variates with the t-Distribution", 1994,
 * <https://doi.org/10.1090/S0025-5718-1994-1219702-8>. The forms free of cancellation are this crate's own.
 */
export declare class StudentT extends Warp<number, [number, number]> {
  /**
   * Student's t with these degrees of freedom, this location and this scale. The standard law has 0 and 1.
   *
   * @throws RangeError:
   * NotFinite (code 1) for NaN or infinity, NotPositive (code 5) for degrees or a scale of 0 or less, TooLarge (code 4)
   * if a sample could overflow, Empty (code 3) if the density could.
   */
  constructor(degrees: number, location: number, scale: number);
}

/**
 * Normal (Gaussian) with mean μ and standard deviation σ, restricted to an interval [a, b], of which one end may be
 * infinite.
 *
 * x = μ + σΦ⁻¹((1 − u)Φ((a − μ)/σ) + uΦ((b − μ)/σ)), increasing with the uniform, except for single steps back between
 * neighbours of the grid by at most 3 ulp of x or of σ, whichever is larger. No two values of Φ are subtracted. Instead
 * x is found by its distance from x₀, the point of the interval nearest to the mean: over that distance the hazard φ/(1
 * − Φ) has the integral −ln(1 − f), where f is the share of the tail beyond x₀ that lies before x. So the distance
 * keeps its digits however far out the interval lies and however narrow it is.
 *
 * **Density**
 * e^(−(x−μ)²/2σ²)/(σ√2π(Φ((b − μ)/σ) − Φ((a − μ)/σ))) on [a, b], at least 2⁻¹⁴⁹; else 0.
 *
 * **Domain**
 * - Point: [a, b]. A point with less than 2⁻¹⁴⁹ of a tail beyond it is not reached.
 * - Uniforms: one. u = 0 counts as 2⁻¹⁴⁹ where there is no lower end, or less than 2⁻¹⁴⁹ of the tail beyond it. Drawing
 *   takes all 32 bits of a word, as the middle of their cell.
 * - Parameters: a finite mean, a standard deviation above 0, and finite ends, of which the nearer one is at most 1e18σ
 *   from the mean. Beyond an infinite end no sample may overflow.
 *
 * **Accuracy**
 * *Sample* counts units in the last place (ulp) of x₀, of x − x₀ or of l, whichever is largest. Where the mean is
 * between the ends, l is σ or the distance of the farther end, whichever is smaller; otherwise it is 0. *Pdf* and
 * *realised density* are relative, *inverse* and *round trip* are absolute errors of the uniform. [What each row
 * means](https://docs.rs/microwarp/latest/microwarp/warp/#stated-errors).
 *
 * | error | bound | kind |
 * |---|--:|---|
 * | sample, ulp of location or distance | 17 | found |
 * | pdf, relative | 1.1e-6 | found |
 * | realised density, relative | 1.1e-6 + 8*s/max(0, 1 - w/1e6) | found |
 * | pdf with the sample, relative | 5.2e-6 | found |
 * | inverse | 8.4e-7 | found |
 * | round trip | 4.8e-7 + 5.5*r | found |
 *
 * A draw keeps the bound of a sample at the exact middle of its word. w is |x₀|(1 + c)/σ with c = |x₀ − μ|/σ. No
 * realised density is stated from w = 1e6 on, where densities of neighbouring `f32` differ by a factor. s and r are the
 * relative change of the density and the change of the inverse when x moves by one such ulp.
 *
 * **Source**
 * C. P. Robert, "Simulation of truncated normal variables", 1995, <https://doi.org/10.1007/BF00143942>, for the
 * problem. The inversion by the hazard is this crate's own.
 */
export declare class TruncatedNormal extends Warp<number, number> {
  /**
   * Normal with this mean and this standard deviation on [low, high].
   *
   * @throws RangeError:
   * NotFinite (code 1) for NaN or infinity, NotPositive (code 5) for a standard deviation of 0 or less, Reversed (code
   * 2) for ends in the wrong order, OutOfRange (code 7) for an interval that is more than 1e18 standard deviations from
   * the mean, TooLarge (code 4) if the length of the interval overflows, Empty (code 3) for equal ends and if the
   * density overflows.
   */
  constructor(mean: number, stdDev: number, low: number, high: number);
  /**
   * Normal with this mean and this standard deviation from `low` up.
   *
   * @throws RangeError:
   * Those of `new TruncatedNormal`, with TooLarge (code 4) if a sample could overflow.
   */
  static above(mean: number, stdDev: number, low: number): TruncatedNormal;
  /**
   * Normal with this mean and this standard deviation up to `high`.
   *
   * @throws RangeError:
   * Those of `new TruncatedNormal`, with TooLarge (code 4) if a sample could overflow.
   */
  static below(mean: number, stdDev: number, high: number): TruncatedNormal;
}

/**
 * Cauchy (Lorentz) with a location and a scale: the shape of spectral lines, and steps with a heavy tail.
 *
 * x = x₀ − γ cot(πu), increasing with the uniform. The cotangent is a quotient of cosine and sine of half a turn, which
 * keeps its digits where the tangent of π(u − ½) has none.
 *
 * **Density**
 * γ/(π(γ² + (x − x₀)²)), at least 2⁻¹⁴⁹ for every finite x. It has no mean and no variance.
 *
 * **Domain**
 * - Point: drawn samples end at 2.7e9γ on both sides. Uniforms on the 24-bit grid give −5.3e6γ to 5.3e6γ, except u = 0.
 *   Uniforms below 2⁻⁶⁴, and 0 among them, count as 2⁻⁶⁴ and give −5.9e18γ.
 * - Uniforms: one. Drawing takes all 32 bits of a word, as the middle of their cell.
 * - Parameters: a finite location and a scale above 0 for which neither samples nor the density overflow.
 *
 * **Accuracy**
 * *Sample* counts units in the last place (ulp) of the location or of the distance from it, whichever is larger. *Pdf*
 * and *realised density* are relative, *inverse* and *round trip* are absolute errors of the uniform. [What each row
 * means](https://docs.rs/microwarp/latest/microwarp/warp/#stated-errors).
 *
 * | error | `poly` | kind |
 * |---|--:|---|
 * | sample, ulp of location or distance | 5.9 | proven |
 * | pdf, relative | 6.8e-7 | found |
 * | realised density, relative | 6.5e-7 + 3.4*s/max(0, 1 - w/1e6) | found |
 * | pdf with the sample, relative | 6e-7 | proven |
 * | inverse | 9.4e-8 | found |
 * | round trip | 7e-8 + 2*r | found |
 *
 * The errors of a sample and of the density with it are proven for all parameters and uniforms: see `docs/proofs.md`.
 *
 * w is |location|/scale. No realised density is stated from 1e6 on, where the densities of neighbouring `f32` differ by
 * a factor. s and r are the relative change of the density and the change of the inverse when x moves by one ulp.
 *
 * **Source**
 * N. L. Johnson, S. Kotz and N. Balakrishnan, "Continuous Univariate Distributions", volume 1, 1994, chapter 16. The
 * form of the cotangent is this crate's own.
 */
export declare class Cauchy extends Warp<number, number> {
  /**
   * The distribution with this location and this scale.
   *
   * @throws RangeError:
   * NotFinite (code 1) for NaN or infinity, NotPositive (code 5) for a scale of 0 or less, TooLarge (code 4) if a
   * sample could overflow, Empty (code 3) if the density could.
   */
  constructor(location: number, scale: number);
}

/**
 * Laplace (double exponential) with a location and a scale: an exponential on both sides of the location.
 *
 * x = μ + b ln(2u) below the median and μ − b ln(2(1 − u)) above it, increasing with the uniform.
 *
 * **Density**
 * e^(−|x−μ|/b)/(2b), at least 2⁻¹⁴⁹ for every finite x.
 *
 * **Domain**
 * - Point: drawn samples end at 22.2b on both sides. Uniforms on the 24-bit grid give −15.9b to 15.9b, except u = 0: it
 *   counts as 2⁻¹⁴⁹ and gives −102.6b.
 * - Uniforms: one. Drawing takes all 32 bits of a word, as the middle of their cell.
 * - Parameters: a finite location and a scale above 0 for which neither samples nor the density overflow.
 *
 * **Accuracy**
 * *Sample* counts units in the last place (ulp) of the location or of the distance from it, whichever is larger. *Pdf*
 * and *realised density* are relative, *inverse* and *round trip* are absolute errors of the uniform. [What each row
 * means](https://docs.rs/microwarp/latest/microwarp/warp/#stated-errors).
 *
 * | error | bound | kind |
 * |---|--:|---|
 * | sample, ulp of location or distance | 4 | proven |
 * | pdf, relative | 8.1e-7 | found |
 * | realised density, relative | 6e-7 + 2.6*s/max(0, 1 - w/1e6) | found |
 * | pdf with the sample, relative | 1.6e-7 | proven |
 * | inverse | 8.5e-8 | found |
 * | round trip | 6e-8 + 2*r | found |
 *
 * The errors of a sample and of the density with it are proven for all parameters and uniforms: see `docs/proofs.md`.
 *
 * w is |location|/scale. No realised density is stated from 1e6 on, where the densities of neighbouring `f32` differ by
 * a factor. s and r are the relative change of the density and the change of the inverse when x moves by one ulp.
 *
 * **Source**
 * S. Kotz, T. J. Kozubowski and K. Podgórski, "The Laplace Distribution and Generalizations", 2001,
 * <https://doi.org/10.1007/978-1-4612-0173-1>.
 */
export declare class Laplace extends Warp<number, number> {
  /**
   * The distribution with this location and this scale.
   *
   * @throws RangeError:
   * NotFinite (code 1) for NaN or infinity, NotPositive (code 5) for a scale of 0 or less, TooLarge (code 4) if a
   * sample could overflow, Empty (code 3) if the density could.
   */
  constructor(location: number, scale: number);
}

/**
 * Logistic with a location and a scale, whose CDF is the logistic function (sigmoid).
 *
 * x = μ + s ln(u/(1 − u)), increasing with the uniform, by a power of 2 and a series in (1 − 2p) of the probability p
 * of the tail, which does not cancel at the median.
 *
 * **Density**
 * e^(−t)/(s(1 + e^(−t))²) with t = |x − μ|/s, at least 2⁻¹⁴⁹ for every finite x. `sampleWithPdf` takes it from the
 * uniform, as u(1 − u)/s.
 *
 * **Domain**
 * - Point: drawn samples end at 22.9s on both sides. Uniforms on the 24-bit grid give −16.6s to 16.6s, except u = 0: it
 *   counts as 2⁻¹⁴⁹ and gives −103.3s.
 * - Uniforms: one. Drawing takes all 32 bits of a word, as the middle of their cell.
 * - Parameters: a finite location and a scale above 0 for which neither samples nor the density overflow.
 *
 * **Accuracy**
 * *Sample* counts units in the last place (ulp) of the location, of the distance from it or of the scale, whichever is
 * largest. *Pdf* and *realised density* are relative, *inverse* and *round trip* are absolute errors of the uniform.
 * [What each row means](https://docs.rs/microwarp/latest/microwarp/warp/#stated-errors).
 *
 * | error | bound | kind |
 * |---|--:|---|
 * | sample, ulp of location or distance | 5.8 | proven |
 * | pdf, relative | 8.9e-7 | found |
 * | realised density, relative | 5e-7 + 4.5*s/max(0, 1 - w/1e6) | found |
 * | pdf with the sample, relative | 3e-7 | proven |
 * | inverse | 1.6e-7 | found |
 * | round trip | 1.5e-7 + 1.9*r | found |
 *
 * The errors of a sample and of the density with it are proven for all parameters and uniforms: see `docs/proofs.md`.
 *
 * A draw keeps the bound of a sample at the exact middle of its word. w is |location|/scale. No realised density is
 * stated from 1e6 on, where the densities of neighbouring `f32` differ by a factor. s and r are the relative change of
 * the density and the change of the inverse when x moves by one ulp.
 *
 * **Source**
 * N. Balakrishnan (editor), "Handbook of the Logistic Distribution", 1992.
 */
export declare class Logistic extends Warp<number, number> {
  /**
   * The distribution with this location and this scale.
   *
   * @throws RangeError:
   * NotFinite (code 1) for NaN or infinity, NotPositive (code 5) for a scale of 0 or less, TooLarge (code 4) if a
   * sample could overflow, Empty (code 3) if the density could.
   */
  constructor(location: number, scale: number);
}

/**
 * Logistic with a location μ and a scale s, restricted to an interval [a, b]: wavelengths as the eye weighs them,
 * azimuths in hair.
 *
 * It increases with the uniform, except for single steps back between neighbours of the grid by a few ulp. An interval
 * about μ that is 4s or wider is measured from μ: the probabilities below and above the point are sums of positive
 * shares, and their ratio is e^t. Any other is measured from the end x₀ that is nearer to μ. With v the probability
 * between x₀ and the point, the distance is s ln(1 + cv/(1 − v + ρv)), in which nothing cancels, however narrow the
 * interval is and however far out.
 *
 * **Density**
 * e^(−t)/(s(1 + e^(−t))²(F(b) − F(a))) on [a, b], with t = |x − μ|/s and F the logistic function of (x − μ)/s; else 0.
 *
 * **Domain**
 * - Point: [a, b]. A point with less than 2⁻¹²⁶ of the probability beyond it is not reached: of the whole where samples
 *   are measured from μ, else of that beyond the end x₀, as if the other end were infinite.
 * - Uniforms: one. Drawing takes all 32 bits of a word, as the middle of their cell.
 * - Parameters: a finite location, a scale above 0, and finite ends in their order, all of them so small that four
 *   times the sum of their sizes is finite, and for which four times the largest density is finite, too.
 *
 * **Accuracy**
 * *Sample* counts units in the last place (ulp) of x₀, of x − x₀ or of l, whichever is largest. In an interval about μ
 * that is 4s or wider, x₀ is μ and l is s; otherwise x₀ is the end nearer to μ, as `f32` subtracts, and l is 0. *Pdf*
 * and *realised density* are relative, *inverse* and *round trip* are absolute errors of the uniform. [What each row
 * means](https://docs.rs/microwarp/latest/microwarp/warp/#stated-errors).
 *
 * | error | bound | kind |
 * |---|--:|---|
 * | sample, ulp of location or distance | 13 | found |
 * | pdf, relative | 1.1e-6 | found |
 * | realised density, relative | 1.1e-6 + 4*s/max(0, 1 - w/1e6) | found |
 * | pdf with the sample, relative | 7.5e-7 | found |
 * | inverse | 6.8e-7 | found |
 * | round trip | 7e-7 + 4.5*r | found |
 *
 * A draw keeps the bound of a sample at the exact middle of its word. w is |x₀|/s. No realised density is stated from
 * 1e6 on, where the densities of neighbouring `f32` differ by a factor. s and r are the relative change of the density
 * and the change of the inverse when x moves by one such ulp.
 *
 * **Source**
 * M. Radziszewski, K. Boryczko and W. Alda, "An Improved Technique for Full Spectral Rendering", 2009,
 * <https://dspace5.zcu.cz/handle/11025/1291>, for wavelengths; M. J.-Y. Chiang and others, "A Practical and
 * Controllable Hair and Fur Model for Production Path Tracing", 2016, <https://doi.org/10.1111/cgf.12830>, for hair.
 * The two forms are this crate's own.
 */
export declare class TruncatedLogistic extends Warp<number, number> {
  /**
   * Logistic with this location and this scale on [low, high].
   *
   * @throws RangeError:
   * NotFinite (code 1) for NaN or infinity, NotPositive (code 5) for a scale of 0 or less, Reversed (code 2) for ends
   * in the wrong order, TooLarge (code 4) where four times the sum of all sizes overflows, Empty (code 3) for equal
   * ends and if four times the largest density overflows.
   */
  constructor(location: number, scale: number, low: number, high: number);
}

/**
 * Gumbel with a location and a scale: the largest of many numbers whose tail is exponential.
 *
 * x = μ − β ln(−ln u), increasing with the uniform, by a table of logarithms that takes all digits of a word.
 *
 * **Density**
 * e^(−(t + e^(−t)))/β with t = (x − μ)/β, at least 2⁻¹⁴⁹ for every finite x. `sampleWithPdf` takes it from the uniform,
 * as −u ln(u)/β.
 *
 * **Domain**
 * - Point: drawn samples lie from −3.13β to 22.9β about the location. Uniforms on the 24-bit grid give −2.81β to 16.6β,
 *   except u = 0: it counts as 2⁻¹⁴⁹ and gives −4.64β.
 * - Uniforms: one. Drawing takes all 32 bits of a word, as the middle of their cell.
 * - Parameters: a finite location and a scale above 0 for which neither samples nor the density overflow.
 *
 * **Accuracy**
 * *Sample* counts units in the last place (ulp) of the location, of the distance from it or of the scale, whichever is
 * largest. *Pdf* and *realised density* are relative, *inverse* and *round trip* are absolute errors of the uniform.
 * [What each row means](https://docs.rs/microwarp/latest/microwarp/warp/#stated-errors).
 *
 * | error | bound | kind |
 * |---|--:|---|
 * | sample, ulp of location or distance | 5.9 | proven |
 * | pdf, relative | 3.7e-6 | found |
 * | realised density, relative | 5e-7 + 6*s/max(0, 1 - w/1e6) | found |
 * | pdf with the sample, relative | 5e-7 | proven |
 * | inverse | 1.3e-7 | found |
 * | round trip | 1.4e-7 + 2.2*r | found |
 *
 * The errors of a sample and of the density with it are proven for all parameters and uniforms: see `docs/proofs.md`.
 *
 * A draw keeps the bound of a sample at the exact middle of its word. w is |location|/scale. No realised density is
 * stated from 1e6 on, where the densities of neighbouring `f32` differ by a factor. s and r are the relative change of
 * the density and the change of the inverse when x moves by one ulp.
 *
 * **Source**
 * E. J. Gumbel, "Statistics of Extremes", 1958, <https://doi.org/10.7312/gumb92958>. The form by tables is this crate's
 * own.
 */
export declare class Gumbel extends Warp<number, number> {
  /**
   * The distribution with this location and this scale.
   *
   * @throws RangeError:
   * NotFinite (code 1) for NaN or infinity, NotPositive (code 5) for a scale of 0 or less, TooLarge (code 4) if a
   * sample could overflow, Empty (code 3) if the density could.
   */
  constructor(location: number, scale: number);
}

/**
 * Rayleigh with a scale σ: the length of a vector of two normal numbers of deviation σ.
 *
 * x = σ√(−2 ln(1 − u)), increasing with the uniform.
 *
 * **Density**
 * x e^(−x²/2σ²)/σ² for x ≥ 0, else 0.
 *
 * **Domain**
 * - Point: drawn samples lie from 1.5e-5σ to 6.76σ. Uniforms on the 24-bit grid reach 5.77σ; u = 0 counts as 2⁻¹⁴⁹, and
 *   gives 5.3e-23σ.
 * - Uniforms: one. Drawing takes all 32 bits of a word, as the middle of their cell.
 * - Parameters: a scale above 0 for which neither samples nor the density overflow.
 *
 * **Accuracy**
 * *Sample* counts units in the last place (ulp) of the exact point. *Pdf* and *realised density* are relative,
 * *inverse* and *round trip* are absolute errors of the uniform. [What each row
 * means](https://docs.rs/microwarp/latest/microwarp/warp/#stated-errors).
 *
 * | error | bound | kind |
 * |---|--:|---|
 * | sample, ulp | 2.7 | proven |
 * | pdf, relative | 1.2e-6 | found |
 * | realised density, relative | 5.5e-7 + 2.5*s | found |
 * | pdf with the sample, relative | 4e-7 | proven |
 * | inverse | 1.3e-7 | found |
 * | round trip | 1e-7 + 1.5*r | found |
 *
 * The errors of a sample and of the density with it are proven for all parameters and uniforms: see `docs/proofs.md`.
 *
 * s and r are the relative change of the density and the change of the inverse when x moves by one ulp.
 *
 * **Source**
 * Lord Rayleigh, "On the Resultant of a Large Number of Vibrations of the Same Pitch and of Arbitrary Phase", 1880,
 * <https://doi.org/10.1080/14786448008626893>.
 */
export declare class Rayleigh extends Warp<number, number> {
  /**
   * Rayleigh with this scale, the deviation of each coordinate of the vector.
   *
   * @throws RangeError:
   * NotFinite (code 1) for NaN or infinity, NotPositive (code 5) for 0 or less, TooLarge (code 4) if a sample could
   * overflow, Empty (code 3) if the density could.
   */
  constructor(scale: number);
}

/**
 * Weibull with a scale λ and a shape κ: life times, wind speeds, the weakest of many links.
 *
 * x = λ(−ln(1 − u))^(1/κ), increasing with the uniform. In `poly` the logarithms come by a table and have seven, in a
 * sixth of the time.
 *
 * **Density**
 * (κ/λ)(x/λ)^(κ−1) e^(−(x/λ)^κ) for x ≥ 0, else 0. With κ < 1 it is infinite at 0, and the largest `f32` stands for it.
 * `sampleWithPdf` takes it from the uniform, as κ(1 − u)(−ln(1 − u))/x.
 *
 * **Domain**
 * - Point: drawn samples lie from (1.16e-10)^(1/κ)·λ to 22.9^(1/κ)·λ. Uniforms on the 24-bit grid reach 16.6^(1/κ)·λ; u
 *   = 0 counts as 2⁻¹⁴⁹. Samples below 2⁻¹⁵⁰ are 0, as many are for κ below 0.1.
 * - Uniforms: one. Drawing takes all 32 bits of a word, as the middle of their cell.
 * - Parameters: a scale and a shape above 0 for which neither samples nor the density at the scale overflow. A scale of
 *   1 takes shapes from 0.036.
 *
 * **Accuracy**
 * *Sample* counts units in the last place (ulp) of the exact point. *Pdf* and *realised density* are relative,
 * *inverse* and *round trip* are absolute errors of the uniform. [What each row
 * means](https://docs.rs/microwarp/latest/microwarp/warp/#stated-errors).
 *
 * | error | `poly` | kind |
 * |---|--:|---|
 * | sample, ulp | 4.5 + 4.7/k | found |
 * | pdf, relative | 3.6e-6 | found |
 * | realised density, relative | 4e-7 + (4.6 + 3.8/k)*s/max(0, 1 - k/1e6) | found |
 * | pdf with the sample, relative | 6.8e-7 + 2.9e-7/k | found |
 * | inverse | 9.2e-8 | found |
 * | round trip | 1e-7 + (4.4 + 3.6/k)*r | found |
 *
 * A draw keeps the bound of a sample at the exact middle of its word. k is κ. No realised density is stated from 1e6
 * on, where the densities of neighbouring `f32` differ by a factor. s and r are the relative change of the density and
 * the change of the inverse when x moves by one ulp.
 *
 * **Source**
 * W. Weibull, "A Statistical Distribution Function of Wide Applicability", 1951, <https://doi.org/10.1115/1.4010337>.
 * Both forms are this crate's own.
 */
export declare class Weibull extends Warp<number, number> {
  /**
   * Weibull with this scale and this shape.
   *
   * @throws RangeError:
   * NotFinite (code 1) for NaN or infinity, NotPositive (code 5) for 0 or less, TooLarge (code 4) if a sample could
   * overflow, Empty (code 3) if the density at the scale could.
   */
  constructor(scale: number, shape: number);
}

/**
 * Pareto with a minimum m and a shape α: a heavy tail that falls as a power.
 *
 * x = m(1 − u)^(−1/α), increasing with the uniform. The logarithm, by a table of 65 cells, has seven digits of what it
 * adds to a whole number, and 1/α has nine, so that a small shape, whose power is large, costs few of a sample's.
 *
 * **Density**
 * α m^α/x^(α+1) for x ≥ m, else 0. The mean is finite for α > 1, the variance for α > 2. `sampleWithPdf` takes it from
 * the uniform, as α(1 − u)/x.
 *
 * **Domain**
 * - Point: drawn samples lie from m to m·2^(33/α). Uniforms on the 24-bit grid reach m·2^(24/α).
 * - Uniforms: one. Drawing takes all 32 bits of a word, as the middle of their cell.
 * - Parameters: a minimum and a shape above 0 for which neither samples nor the density overflow. A minimum of 1 takes
 *   shapes from 0.26.
 *
 * **Accuracy**
 * *Sample* counts units in the last place (ulp) of the exact point. *Pdf* and *realised density* are relative,
 * *inverse* and *round trip* are absolute errors of the uniform. [What each row
 * means](https://docs.rs/microwarp/latest/microwarp/warp/#stated-errors).
 *
 * | error | bound | kind |
 * |---|--:|---|
 * | sample, ulp | 3.2 + 1.9/k | proven |
 * | pdf, relative | 1.8e-7 | found |
 * | realised density, relative | 1.7e-7 + (4.7 + 0.93/k)*s/max(0, 1 - k/1e6) | found |
 * | pdf with the sample, relative | 5.2e-7 + 2.8e-7/k | found |
 * | inverse | 1.4e-7 | found |
 * | round trip | 1.1e-7 + (4 + 0.8/k)*r | found |
 *
 * The error of a sample is proven for all parameters and uniforms: see `docs/proofs.md`.
 *
 * A draw keeps the bound of a sample at the exact middle of its word. k is α. No realised density is stated from 1e6
 * on, where the densities of neighbouring `f32` differ by a factor. s and r are the relative change of the density and
 * the change of the inverse when x moves by one ulp.
 *
 * **Source**
 * M. E. J. Newman, "Power Laws, Pareto Distributions and Zipf's Law", 2005,
 * <https://doi.org/10.1080/00107510500052444>. The form by tables is this crate's own.
 */
export declare class Pareto extends Warp<number, number> {
  /**
   * Pareto with this minimum and this shape.
   *
   * @throws RangeError:
   * NotFinite (code 1) for NaN or infinity, NotPositive (code 5) for 0 or less, TooLarge (code 4) if a sample could
   * overflow, Empty (code 3) if the density could.
   */
  constructor(minimum: number, shape: number);
}

/**
 * Log-normal with the mean μ and the standard deviation σ of the logarithm: sizes, incomes, products of many factors.
 *
 * x = e^μ·2^(σ log₂e·Φ⁻¹(u)), increasing with the uniform: never back from one uniform of the 24-bit grid to the next.
 * e^μ is known from the constructor; the power comes by a table, Φ⁻¹ as in `Normal`.
 *
 * **Density**
 * e^(−(ln x − μ)²/2σ²)/(xσ√2π) for x > 0, else 0.
 *
 * **Domain**
 * - Point: drawn samples lie from e^(μ−6.34σ) to e^(μ+6.34σ). Uniforms on the 24-bit grid give e^(μ−5.30σ) to
 *   e^(μ+5.30σ), except u = 0: it counts as 2⁻¹⁴⁹ and gives e^(μ−14.2σ). Samples below 2⁻¹⁴⁹ are 2⁻¹⁴⁹.
 * - Uniforms: one. Drawing takes all 32 bits of a word, as the middle of their cell.
 * - Parameters: a finite μ and a σ above 0 for which no sample overflows (μ + 6.4σ up to 88.5), nor the density at the
 *   median (μ above −88 for common σ).
 *
 * **Accuracy**
 * *Sample* counts units in the last place (ulp) of the exact point. *Pdf* and *realised density* are relative,
 * *inverse* and *round trip* are absolute errors of the uniform. [What each row
 * means](https://docs.rs/microwarp/latest/microwarp/warp/#stated-errors).
 *
 * | error | bound | kind |
 * |---|--:|---|
 * | sample, ulp | 4.4 + 64*d | proven |
 * | pdf, relative | 2.7e-7 + 0.056*s/max(0, 1 - w/1e6) | found |
 * | realised density, relative | 3e-7 + (3.9 + 43·d)·s/max(0, 1 - w/1e6) | found |
 * | pdf with the sample, relative | 7.9e-7 + 2e-6*d | found |
 * | inverse | 2.5e-7 + 0.11*r/max(0, 1 - w/1e6) | found |
 * | round trip | 2.3e-7 + (3.1 + 46·d)·r | found |
 *
 * The error of a sample is proven for all parameters and uniforms: see `docs/proofs.md`.
 *
 * A draw keeps the bound of a sample at the exact middle of its word. d is σ, and w is 1/σ. Little is stated of
 * densities from w = 1e6 on, where those of neighbouring `f32` differ by a factor. s and r are the relative change of
 * the density and the change of the inverse when x moves by one ulp. The part of the sample's error in proportion to σ
 * comes from the last places of Φ⁻¹(u), which is −14.2 at its lowest. What is rounded to a sample below 2⁻¹²⁶ has its
 * own density; what lies below 2⁻¹⁴⁹, the smallest number, has that of 2⁻¹⁴⁹.
 *
 * **Source**
 * J. Aitchison and J. A. C. Brown, "The Lognormal Distribution", 1957.
 */
export declare class LogNormal extends Warp<number, number> {
  /**
   * Log-normal with this mean and this standard deviation of the logarithm.
   *
   * @throws RangeError:
   * NotFinite (code 1) for NaN or infinity, NotPositive (code 5) for a standard deviation of 0 or less, TooLarge (code
   * 4) if a sample could overflow, Empty (code 3) if the density at the median could.
   */
  constructor(meanOfLog: number, stdDevOfLog: number);
}

/**
 * Uniform on the unit disk, by polar coordinates.
 *
 * r = √u₁, θ = u₂ turns.
 *
 * **Density**
 * 1/π per unit area where x² + y² ≤ 1, else 0.
 *
 * **Domain**
 * - Point: x² + y² ≤ 1, always.
 * - Uniforms: two, radius and angle. Two zeros give the centre.
 *
 * **Accuracy**
 * *Sample* is the distance from the exact point, relative to the radius 1. *Pdf* and *realised density* are relative,
 * *inverse* and *round trip* are absolute errors of the uniforms. [What each row
 * means](https://docs.rs/microwarp/latest/microwarp/warp/#stated-errors).
 *
 * | error | `poly` | kind |
 * |---|--:|---|
 * | sample, of the size | 1.7e-7 | proven |
 * | pdf, relative | 4.5e-8 | exhaustive |
 * | realised density, relative | 4.5e-8 | exhaustive |
 * | inverse | 9.7e-8 | found |
 * | round trip | 4.8e-7 | found |
 *
 * The error of a sample is proven for every pair of uniforms: see `docs/proofs.md`.
 *
 * **Source**
 * P. Shirley, "Nonuniform Random Point Sets via Warping", Graphics Gems III, 1992.
 */
export declare class Disk extends Warp<[number, number], [number, number]> {
  /**
   * The unit disk.
   */
  constructor();
}

/**
 * Uniform on the unit disk, by Shirley and Chiu's concentric map.
 *
 * Squares about the centre of the unit square become circles about the centre of the disk. Neighbours stay neighbours
 * and strata stay compact, unlike with the polar map. With a = 2u₁ − 1 and b = 2u₂ − 1, the larger in magnitude is the
 * radius, and their quotient is the angle within its wedge.
 *
 * **Density**
 * 1/π per unit area where x² + y² ≤ 1, else 0.
 *
 * **Domain**
 * - Point: x² + y² ≤ 1, always.
 * - Uniforms: two. (½, ½) gives the centre.
 *
 * **Accuracy**
 * *Sample* is the distance from the exact point, relative to the radius 1. *Pdf* and *realised density* are relative,
 * *inverse* and *round trip* are absolute errors of the uniforms. [What each row
 * means](https://docs.rs/microwarp/latest/microwarp/warp/#stated-errors).
 *
 * | error | `poly` | kind |
 * |---|--:|---|
 * | sample, of the size | 2.1e-7 | proven |
 * | pdf, relative | 4.5e-8 | exhaustive |
 * | realised density, relative | 4.5e-8 | exhaustive |
 * | inverse | 1.4e-7 | found |
 * | round trip | 2.4e-7 | found |
 *
 * The error of a sample is proven for every pair of uniforms: see `docs/proofs.md`.
 *
 * **Source**
 * P. Shirley and K. Chiu, "A Low Distortion Map Between Disk and Square", Journal of Graphics Tools, 1997,
 * <https://doi.org/10.1080/10867651.1997.10487479>.
 */
export declare class DiskConcentric extends Warp<[number, number], [number, number]> {
  /**
   * The unit disk.
   */
  constructor();
}

/**
 * Uniform barycentric coordinates: the shares of the three vertices of a triangle.
 *
 * u = 1 − √U₁, v = √U₁ U₂, w = √U₁ (1 − U₂), with u in the form (1 − U₁)/(1 + √U₁), which keeps its digits near 0.
 *
 * **Density**
 * 2 with respect to (u, v), where none of the three is negative and their sum is 1 to rounding; else 0.
 *
 * **Domain**
 * - Point: [u, v, w], none negative, with sum 1 to rounding.
 * - Uniforms: two.
 * - Both tiers share this code. It needs nothing but a square root.
 *
 * **Accuracy**
 * *Sample* is the distance from the exact point, relative to the size 1. *Pdf* and *realised density* are relative,
 * *inverse* and *round trip* are absolute errors of the uniforms. [What each row
 * means](https://docs.rs/microwarp/latest/microwarp/warp/#stated-errors).
 *
 * | error | bound | kind |
 * |---|--:|---|
 * | sample, of the size | 1.2e-7 | proven |
 * | pdf, relative | 0 | exhaustive |
 * | realised density, relative | 0 | exhaustive |
 * | inverse | 2.45e-7 | found |
 * | round trip | 8.1e-8 | found |
 *
 * The error of the sample is proven for every pair of uniforms: see `docs/proofs.md`.
 *
 * **Source**
 * G. Turk, "Generating Random Points in Triangles", Graphics Gems, 1990.
 */
export declare class Triangle extends Warp<[number, number, number], [number, number]> {
  /**
   * The triangle of all barycentric coordinates.
   */
  constructor();
}

/**
 * Several correlated normal numbers (Gaussians) of a mean and a covariance matrix, which may be singular.
 *
 * x = μ + A z with A Aᵀ = Σ, where each z is Φ⁻¹ of its uniform. The matrix is taken apart with pivots, in twice the
 * digits of `f32` and in units of each coordinate's own. So samples keep their digits however strongly coordinates are
 * correlated, and metres may stand beside radians.
 *
 * A coordinate that follows from others, or that has no variance, has no randomness of its own: a robot that does not
 * slide moves along its heading alone.
 *
 * **Density**
 * e^(−|z|²/2)/∏ Aᵢᵢ√2π over the free coordinates, with respect to these: of a regular Σ that is e^(−tᵀΣ⁻¹t/2)/√det 2πΣ
 * with t = x − μ. It is at least 2⁻¹⁴⁹ where the other coordinates are what the free ones say, to rounding, and 0
 * elsewhere.
 *
 * **Domain**
 * - Point: D numbers. Each lies as far from its mean as those of `Normal` do, in units of √Σᵢᵢ and √D.
 * - Uniforms: D, one a coordinate; those of coordinates that are not free do nothing. A uniform of 0 counts as 2⁻¹⁴⁹.
 *   Drawing takes all 32 bits of each word, as the middle of their cell.
 * - Parameters: a finite mean and a finite matrix, which is symmetric and semi-definite, both to D·9.5e-7 of √Σᵢᵢ √Σⱼⱼ,
 *   since rounding makes others of such; of Σᵢⱼ and Σⱼᵢ the mean counts. What is left of a variance, given the others,
 *   counts as 0 up to D·2.4e-7 of it, and so does a variance up to D·2.8e-45. D is any number from 1.
 *
 * **Accuracy**
 * These are for two dimensions. *Sample* is the distance from the exact point, relative to the size: the largest |μᵢ|
 * plus 14.2 of the largest √Σᵢᵢ. *Pdf* and *realised density* are relative, *inverse* and *round trip* are absolute
 * errors of the uniforms. [What each row means](https://docs.rs/microwarp/latest/microwarp/warp/#stated-errors).
 *
 * | error | `poly` | kind |
 * |---|--:|---|
 * | sample, of the size | 5.6e-7 | found |
 * | pdf, relative | 7e-7 + 6*s | found |
 * | realised density, relative | 1e-6 + 3.5*s/max(0, 1 - s/0.1) | found |
 * | pdf with the sample, relative | 9.6e-7 | found |
 * | inverse | 2.2e-7 + 3.4*r | found |
 * | round trip | 2.2e-7 + 5*r | found |
 *
 * c is the condition number of the matrix of correlations, here at most 8.4e6; s and r are the relative change of the
 * density and the change of the inverse when the point moves by 2⁻²⁴ of the size. No realised density is stated where s
 * reaches 0.1.
 *
 * In D dimensions each coordinate of a sample is off by at most 3.2e-7 of |xᵢ| + |μᵢ| + √Σᵢᵢ max(1, |z|), whatever c
 * is, and pdf with the sample by 7e-7 + 1.3e-7·D. With q = |z|², whitened numbers in `poly` are off by 6e-7·√(c·q), the
 * logarithm of the density by 1.1e-7·(D + 4 + |ln p|) + 3.5e-7·√c·q, and so is the density, relatively and without |ln
 * p|. All are found, for D to 12.
 *
 * **Source**
 * N. J. Higham, "Analysis of the Cholesky Decomposition of a Semi-definite Matrix", 1990,
 * <https://eprints.maths.manchester.ac.uk/1193/>. The pivots by shares of variances, and the digits, are this crate's
 * own.
 */
export declare class MultivariateNormal2 extends Warp<[number, number], [number, number]> {
  /**
   * The law with this mean and this covariance matrix.
   *
   * @throws RangeError:
   * Empty (code 3) for D = 0, NotFinite (code 1) for NaN or infinity in either, Negative (code 6) for a variance below
   * 0, OutOfRange (code 7) for a matrix that is not symmetric, NotNormalizable (code 8) for one that is not
   * semi-definite, such as one with a correlation beyond 1.
   */
  constructor(mean: Vector2, covariance: readonly [Vector2, Vector2]);
}

/**
 * Several correlated normal numbers (Gaussians) of a mean and a covariance matrix, which may be singular.
 *
 * x = μ + A z with A Aᵀ = Σ, where each z is Φ⁻¹ of its uniform. The matrix is taken apart with pivots, in twice the
 * digits of `f32` and in units of each coordinate's own. So samples keep their digits however strongly coordinates are
 * correlated, and metres may stand beside radians.
 *
 * A coordinate that follows from others, or that has no variance, has no randomness of its own: a robot that does not
 * slide moves along its heading alone.
 *
 * **Density**
 * e^(−|z|²/2)/∏ Aᵢᵢ√2π over the free coordinates, with respect to these: of a regular Σ that is e^(−tᵀΣ⁻¹t/2)/√det 2πΣ
 * with t = x − μ. It is at least 2⁻¹⁴⁹ where the other coordinates are what the free ones say, to rounding, and 0
 * elsewhere.
 *
 * **Domain**
 * - Point: D numbers. Each lies as far from its mean as those of `Normal` do, in units of √Σᵢᵢ and √D.
 * - Uniforms: D, one a coordinate; those of coordinates that are not free do nothing. A uniform of 0 counts as 2⁻¹⁴⁹.
 *   Drawing takes all 32 bits of each word, as the middle of their cell.
 * - Parameters: a finite mean and a finite matrix, which is symmetric and semi-definite, both to D·9.5e-7 of √Σᵢᵢ √Σⱼⱼ,
 *   since rounding makes others of such; of Σᵢⱼ and Σⱼᵢ the mean counts. What is left of a variance, given the others,
 *   counts as 0 up to D·2.4e-7 of it, and so does a variance up to D·2.8e-45. D is any number from 1.
 *
 * **Accuracy**
 * These are for two dimensions. *Sample* is the distance from the exact point, relative to the size: the largest |μᵢ|
 * plus 14.2 of the largest √Σᵢᵢ. *Pdf* and *realised density* are relative, *inverse* and *round trip* are absolute
 * errors of the uniforms. [What each row means](https://docs.rs/microwarp/latest/microwarp/warp/#stated-errors).
 *
 * | error | `poly` | kind |
 * |---|--:|---|
 * | sample, of the size | 5.6e-7 | found |
 * | pdf, relative | 7e-7 + 6*s | found |
 * | realised density, relative | 1e-6 + 3.5*s/max(0, 1 - s/0.1) | found |
 * | pdf with the sample, relative | 9.6e-7 | found |
 * | inverse | 2.2e-7 + 3.4*r | found |
 * | round trip | 2.2e-7 + 5*r | found |
 *
 * c is the condition number of the matrix of correlations, here at most 8.4e6; s and r are the relative change of the
 * density and the change of the inverse when the point moves by 2⁻²⁴ of the size. No realised density is stated where s
 * reaches 0.1.
 *
 * In D dimensions each coordinate of a sample is off by at most 3.2e-7 of |xᵢ| + |μᵢ| + √Σᵢᵢ max(1, |z|), whatever c
 * is, and pdf with the sample by 7e-7 + 1.3e-7·D. With q = |z|², whitened numbers in `poly` are off by 6e-7·√(c·q), the
 * logarithm of the density by 1.1e-7·(D + 4 + |ln p|) + 3.5e-7·√c·q, and so is the density, relatively and without |ln
 * p|. All are found, for D to 12.
 *
 * **Source**
 * N. J. Higham, "Analysis of the Cholesky Decomposition of a Semi-definite Matrix", 1990,
 * <https://eprints.maths.manchester.ac.uk/1193/>. The pivots by shares of variances, and the digits, are this crate's
 * own.
 */
export declare class MultivariateNormal3 extends Warp<[number, number, number], [number, number, number]> {
  /**
   * The law with this mean and this covariance matrix.
   *
   * @throws RangeError:
   * Empty (code 3) for D = 0, NotFinite (code 1) for NaN or infinity in either, Negative (code 6) for a variance below
   * 0, OutOfRange (code 7) for a matrix that is not symmetric, NotNormalizable (code 8) for one that is not
   * semi-definite, such as one with a correlation beyond 1.
   */
  constructor(mean: Vector3, covariance: readonly [Vector3, Vector3, Vector3]);
}

/**
 * Uniform on a triangle given by its vertices, in two, three or more dimensions.
 *
 * The barycentric combination of the vertices, coordinate by coordinate. Where the vertices lie close together beside
 * their distance from 0, their differences from the one nearest to 0 are combined, which are exact. So every
 * representable point of a small triangle far off is hit with the right probability, up to rounding.
 *
 * **Density**
 * 1/area per unit area on the triangle and within rounding of it, so that it is 0 at no sample. In two and three
 * dimensions it is 0 where a point lies more than 2⁻¹⁶ of the longest side and 2⁻¹⁹ of the size beyond the line of a
 * side, or off the plane.
 *
 * **Domain**
 * - Point: the triangle, to the rounding of its coordinates, and its bounding box exactly.
 * - Uniforms: two.
 * - Parameters: finite vertices of a triangle whose height over its longest side is at least 2⁻⁴⁰ of that side, with a
 *   density that `f32` can hold.
 * - Both tiers share this code.
 *
 * **Accuracy**
 * *Sample* is the distance from the exact point, relative to the size, which is the largest magnitude of a vertex's
 * coordinate. *Pdf* and *realised density* are relative, *inverse* and *round trip* are absolute errors of the
 * uniforms. [What each row means](https://docs.rs/microwarp/latest/microwarp/warp/#stated-errors).
 *
 * | error | bound | kind |
 * |---|--:|---|
 * | sample, of the size | 5.6e-7 | proven |
 * | pdf, relative | 3.1e-7 | found |
 * | realised density, relative | 3.1e-7 | found |
 * | inverse | min(1, 8.3e-7 + 8.6e-7/h + 1.4·r) | found |
 * | round trip | min(1, 5e-7 + 6e-7/h + 6*r) | found |
 *
 * These hold for every triangle accepted in two or three dimensions. The error of a sample is proven for all of them
 * and every pair of uniforms, in D dimensions as √(D/3) of what is stated: see `docs/proofs.md`. h is the height over
 * the longest side in terms of the size, and r the change of a point's uniforms when each coordinate moves by 2⁻²⁴ of
 * the size. The second uniform of a point within rounding of the first vertex, nearer than 2⁻²⁰ of the size over h, is
 * lost.
 *
 * **Source**
 * G. Turk, "Generating Random Points in Triangles", Graphics Gems, 1990.
 */
export declare class TriangleOn2d extends Warp<[number, number], [number, number]> {
  /**
   * Uniform on the triangle with these vertices.
   *
   * @throws RangeError:
   * NotFinite (code 1) for NaN or infinity, Empty (code 3) for a triangle that has no area, is lower than 2⁻⁴⁰ of its
   * longest side, or has a density that overflows, TooLarge (code 4) for one whose area overflows.
   */
  constructor(vertices: readonly [Vector2, Vector2, Vector2]);
}

/**
 * Uniform on a triangle given by its vertices, in two, three or more dimensions.
 *
 * The barycentric combination of the vertices, coordinate by coordinate. Where the vertices lie close together beside
 * their distance from 0, their differences from the one nearest to 0 are combined, which are exact. So every
 * representable point of a small triangle far off is hit with the right probability, up to rounding.
 *
 * **Density**
 * 1/area per unit area on the triangle and within rounding of it, so that it is 0 at no sample. In two and three
 * dimensions it is 0 where a point lies more than 2⁻¹⁶ of the longest side and 2⁻¹⁹ of the size beyond the line of a
 * side, or off the plane.
 *
 * **Domain**
 * - Point: the triangle, to the rounding of its coordinates, and its bounding box exactly.
 * - Uniforms: two.
 * - Parameters: finite vertices of a triangle whose height over its longest side is at least 2⁻⁴⁰ of that side, with a
 *   density that `f32` can hold.
 * - Both tiers share this code.
 *
 * **Accuracy**
 * *Sample* is the distance from the exact point, relative to the size, which is the largest magnitude of a vertex's
 * coordinate. *Pdf* and *realised density* are relative, *inverse* and *round trip* are absolute errors of the
 * uniforms. [What each row means](https://docs.rs/microwarp/latest/microwarp/warp/#stated-errors).
 *
 * | error | bound | kind |
 * |---|--:|---|
 * | sample, of the size | 5.6e-7 | proven |
 * | pdf, relative | 3.1e-7 | found |
 * | realised density, relative | 3.1e-7 | found |
 * | inverse | min(1, 8.3e-7 + 8.6e-7/h + 1.4·r) | found |
 * | round trip | min(1, 5e-7 + 6e-7/h + 6*r) | found |
 *
 * These hold for every triangle accepted in two or three dimensions. The error of a sample is proven for all of them
 * and every pair of uniforms, in D dimensions as √(D/3) of what is stated: see `docs/proofs.md`. h is the height over
 * the longest side in terms of the size, and r the change of a point's uniforms when each coordinate moves by 2⁻²⁴ of
 * the size. The second uniform of a point within rounding of the first vertex, nearer than 2⁻²⁰ of the size over h, is
 * lost.
 *
 * **Source**
 * G. Turk, "Generating Random Points in Triangles", Graphics Gems, 1990.
 */
export declare class TriangleOn3d extends Warp<[number, number, number], [number, number]> {
  /**
   * Uniform on the triangle with these vertices.
   *
   * @throws RangeError:
   * NotFinite (code 1) for NaN or infinity, Empty (code 3) for a triangle that has no area, is lower than 2⁻⁴⁰ of its
   * longest side, or has a density that overflows, TooLarge (code 4) for one whose area overflows.
   */
  constructor(vertices: readonly [Vector3, Vector3, Vector3]);
}

/**
 * Bilinear on the unit square: density in proportion to the interpolation between four weights, one a corner.
 *
 * y is linear with the sums of the rows, and x is linear with the weights interpolated at y, both by the form of
 * `Linear`. 1 − y and 1 − x come with digits of their own, so that the density has its digits in a corner of weight 0,
 * too.
 *
 * **Density**
 * 4 times the weight interpolated at (x, y), over the sum of the four, on [0, 1]²; else 0.
 *
 * **Domain**
 * - Point: [x, y] in [0, 1)². A coordinate is above 0 where the density at 0 is 0.
 * - Uniforms: two, the first for x and the second for y. Each coordinate increases with its own.
 * - Parameters: four finite weights, none negative and not all 0, of any magnitudes. The first row holds those at y =
 *   0, the first column those at x = 0.
 * - Both tiers share this code. It needs nothing but a square root.
 *
 * **Accuracy**
 * *Sample* is the distance from the exact point, relative to the size 1. Densities are relative, *inverse* and *round
 * trip* are absolute errors of the uniforms. [What each row
 * means](https://docs.rs/microwarp/latest/microwarp/warp/#stated-errors).
 *
 * | error | bound | kind |
 * |---|--:|---|
 * | sample, of the size | 5.6e-7 | proven |
 * | pdf, relative | 6e-7 | found |
 * | realised density, relative | 5.2e-7 + 4.7*s | found |
 * | pdf with the sample, relative | 8e-7 | found |
 * | inverse | 4.1e-7 | found |
 * | round trip | 4.3e-7 + 4.7*r | found |
 *
 * **Source**
 * M. Pharr, W. Jakob and G. Humphreys, "Physically Based Rendering", fourth edition, 2023,
 * <https://pbr-book.org/4ed/contents>; the complements are of this crate.
 */
export declare class Bilinear extends Warp<[number, number], [number, number]> {
  /**
   * Density in proportion to the interpolation of `weights[y][x]`: the first row holds the weights at (0, 0) and (1,
   * 0), the second those at (0, 1) and (1, 1).
   *
   * @throws RangeError:
   * NotFinite (code 1) for NaN or infinity, Negative (code 6) if any is below 0, NotPositive (code 5) if all are 0.
   */
  constructor(weights: readonly [Vector2, Vector2]);
}

/**
 * Uniform over the unit sphere: all directions alike.
 *
 * z = 1 − 2u₁, sin θ = 2√(u₁(1 − u₁)), φ = u₂ turns.
 *
 * **Density**
 * 1/(4π) per steradian, for any finite direction.
 *
 * **Domain**
 * - Point: unit vectors.
 * - Uniforms: two, for height and azimuth. The pole +z is at u₁ = 0.
 *
 * **Accuracy**
 * *Sample* is the distance from the exact direction, *unit length* the error of the length. sin θ and cos θ count units
 * in the last place (ulp). *Pdf* and *realised density* are relative, *inverse* and *round trip* are absolute errors of
 * the uniforms. [What each row means](https://docs.rs/microwarp/latest/microwarp/warp/#stated-errors).
 *
 * | error | `poly` | kind |
 * |---|--:|---|
 * | sample, of the size | 2.1e-7 | proven |
 * | sin θ, ulp | 1.26 | proven |
 * | unit length | 2.1e-7 | proven |
 * | pdf, relative | 4.5e-8 | exhaustive |
 * | realised density, relative | 4.5e-8 | exhaustive |
 * | inverse | 1.2e-7 | found |
 * | round trip | 1.2e-7 | found |
 *
 * The errors of the sample, of sin θ and of the length are proven for every pair of uniforms: see `docs/proofs.md`.
 *
 * **Source**
 * M. Pharr, W. Jakob and G. Humphreys, "Physically Based Rendering", third edition, 2016,
 * <https://pbr-book.org/3ed-2018/Monte_Carlo_Integration/2D_Sampling_with_Multidimensional_Transformations>.
 */
export declare class Sphere extends Warp<[number, number, number], [number, number]> {
  /**
   * All directions.
   */
  constructor();
}

/**
 * Uniform over the hemisphere about +z.
 *
 * z = u₁, sin θ = √(2d − d²) with d = 1 − u₁, φ = u₂ turns.
 *
 * **Density**
 * 1/(2π) per steradian where z ≥ 0, else 0.
 *
 * **Domain**
 * - Point: unit vectors with z ≥ 0.
 * - Uniforms: two, for height and azimuth. The horizon is at u₁ = 0.
 *
 * **Accuracy**
 * *Sample* is the distance from the exact direction, *unit length* the error of the length. sin θ and cos θ count units
 * in the last place (ulp). *Pdf* and *realised density* are relative, *inverse* and *round trip* are absolute errors of
 * the uniforms. [What each row means](https://docs.rs/microwarp/latest/microwarp/warp/#stated-errors).
 *
 * | error | `poly` | kind |
 * |---|--:|---|
 * | sample, of the size | 2.0e-7 | proven |
 * | sin θ, ulp | 1.3 | proven |
 * | unit length | 1.9e-7 | proven |
 * | pdf, relative | 4.5e-8 | exhaustive |
 * | realised density, relative | 4.5e-8 | exhaustive |
 * | inverse | 2.6e-7 | found |
 * | round trip | 8e-8 | found |
 *
 * The errors of the sample, of sin θ and of the length are proven for every pair of uniforms: see `docs/proofs.md`.
 *
 * **Source**
 * M. Pharr, W. Jakob and G. Humphreys, "Physically Based Rendering", third edition, 2016,
 * <https://pbr-book.org/3ed-2018/Monte_Carlo_Integration/2D_Sampling_with_Multidimensional_Transformations>.
 */
export declare class Hemisphere extends Warp<[number, number, number], [number, number]> {
  /**
   * The directions with z ≥ 0.
   */
  constructor();
}

/**
 * In proportion to the cosine over the hemisphere about +z (Lambert's law), by inversion.
 *
 * sin θ = √u₁, cos θ = √(1 − u₁), φ = u₂ turns.
 *
 * **Density**
 * cos θ/π per steradian where z > 0, else 0. Never 0 at a sample, whose z is at least 2⁻¹².
 *
 * **Domain**
 * - Point: unit vectors with z > 0.
 * - Uniforms: two, for the polar angle and the azimuth. The pole is at u₁ = 0.
 *
 * **Accuracy**
 * *Sample* is the distance from the exact direction, *unit length* the error of the length. sin θ and cos θ count units
 * in the last place (ulp). *Pdf* and *realised density* are relative, *inverse* and *round trip* are absolute errors of
 * the uniforms. [What each row means](https://docs.rs/microwarp/latest/microwarp/warp/#stated-errors).
 *
 * | error | `poly` | kind |
 * |---|--:|---|
 * | sample, of the size | 1.7e-7 | proven |
 * | sin θ, ulp | 0.51 | proven |
 * | cos θ, ulp | 0.86 | proven |
 * | unit length | 1.7e-7 | proven |
 * | pdf, relative | 5.7e-7 | found |
 * | realised density, relative | 2.1e-7 | found |
 * | inverse | 3e-7 | found |
 * | round trip | 2.4e-7 | found |
 *
 * The errors of the sample, of sin θ, of cos θ and of the length are proven for every pair of uniforms: see
 * `docs/proofs.md`.
 *
 * **Source**
 * M. Pharr, W. Jakob and G. Humphreys, "Physically Based Rendering", third edition, 2016,
 * <https://pbr-book.org/3ed-2018/Monte_Carlo_Integration/2D_Sampling_with_Multidimensional_Transformations>.
 */
export declare class CosineHemisphere extends Warp<[number, number, number], [number, number]> {
  /**
   * The directions with z > 0, weighted by z.
   */
  constructor();
}

/**
 * In proportion to the cosine over the hemisphere about +z (Lambert's law), by Malley's method.
 *
 * A point of the concentric disk, lifted onto the hemisphere. Strata stay compact, as with `DiskConcentric`. 1 − r² is
 * formed from the uniforms, where it does not cancel.
 *
 * **Density**
 * cos θ/π per steradian where z > 0, else 0. Never 0 at a sample.
 *
 * **Domain**
 * - Point: unit vectors with z > 0.
 * - Uniforms: two. (½, ½) gives the pole. Drawing takes them from the grid without 0, so that no draw lies nearer to
 *   the horizon than its share.
 *
 * **Accuracy**
 * *Sample* is the distance from the exact direction, *unit length* the error of the length. sin θ and cos θ count units
 * in the last place (ulp). *Pdf* and *realised density* are relative, *inverse* and *round trip* are absolute errors of
 * the uniforms. [What each row means](https://docs.rs/microwarp/latest/microwarp/warp/#stated-errors).
 *
 * | error | `poly` | kind |
 * |---|--:|---|
 * | sample, of the size | 2.1e-7 | proven |
 * | unit length | 1.8e-7 | proven |
 * | pdf, relative | 1.3e-7 | found |
 * | realised density, relative | 2.5e-7 | found |
 * | inverse | 2.1e-7 | found |
 * | round trip | 1.8e-7 | found |
 *
 * The errors of the sample and of the length are proven for every pair of uniforms: see `docs/proofs.md`.
 *
 * **Source**
 * T. J. V. Malley, "A Shading Method for Computer Generated Images", master's thesis, University of Utah, 1988. P.
 * Shirley and K. Chiu, "A Low Distortion Map Between Disk and Square", Journal of Graphics Tools, 1997,
 * <https://doi.org/10.1080/10867651.1997.10487479>.
 */
export declare class MalleyHemisphere extends Warp<[number, number, number], [number, number]> {
  /**
   * The directions with z > 0, weighted by z.
   */
  constructor();
}

/**
 * In proportion to a power of the cosine over the hemisphere about +z: the Phong lobe.
 *
 * cos θ = (1 − u₁)^(1/(n+1)). The code works with 1 − cos θ = −expm1(log1p(−u₁)/(n + 1)), so that a lobe of n = 1e8
 * does not collapse onto its axis. Where that leaves the range of `f32`, sin θ = √(2 ln(1/(1 − u₁)))/√(n + 1), so that
 * sin θ is 0 at u₁ = 0 alone, up to the largest n. n = 0 is the uniform hemisphere, n = 1 the cosine one.
 *
 * **Density**
 * (n + 1)/(2π) cosⁿθ per steradian where z > 0, else 0. Never 0 at a sample. Where z > ½, cos θ is read from all three
 * coordinates, because x and y hold digits that z has lost. `sampleWithPdf` takes it from the uniform, as (n + 1)(1 −
 * u₁)/(2π cos θ).
 *
 * **Domain**
 * - Point: unit vectors with z > 0.
 * - Uniforms: two, for the polar angle and the azimuth. The axis is at u₁ = 0.
 * - Parameters: any finite n ≥ 0.
 *
 * **Accuracy**
 * *Sample* is the distance from the exact direction, *unit length* the error of the length. sin θ and cos θ count units
 * in the last place (ulp). *Pdf* and *realised density* are relative, *inverse* and *round trip* are absolute errors of
 * the uniforms. [What each row means](https://docs.rs/microwarp/latest/microwarp/warp/#stated-errors).
 *
 * | error | `poly` | kind |
 * |---|--:|---|
 * | sample, of the size | 3e-7 | proven |
 * | sin θ, ulp | 3.9 | found |
 * | cos θ, ulp | 56 | found |
 * | unit length | 2.1e-7 | proven |
 * | pdf, relative | 5.3e-7 | found |
 * | realised density, relative | min(1.1e-5, 8.1e-7 + 27*s) | found |
 * | pdf with the sample, relative | 5e-7 + 3e-6/(1 + k) | found |
 * | inverse | 2.3e-7 | found |
 * | round trip | 3.1e-7 | found |
 *
 * k is n; the bounds hold for every n. s is the relative change of the density when sin θ and cos θ move by an ulp.
 * Azimuths of subnormal x and y, which only uniforms below 2⁻⁶⁴ give, have no more digits in the inverse than x and y
 * have. The errors of the sample and of the length are proven for every n and every pair of uniforms: see
 * `docs/proofs.md`.
 *
 * **Source**
 * E. P. Lafortune and Y. D. Willems, "Using the Modified Phong Reflectance Model for Physically Based Rendering", 1994,
 * <http://www.graphics.cornell.edu/~eric/Phong.html>.
 */
export declare class PhongLobe extends Warp<[number, number, number], [number, number]> {
  /**
   * The lobe of exponent `n` ≥ 0.
   *
   * @throws RangeError:
   * NotFinite (code 1) for NaN or infinity, Negative (code 6) below 0.
   */
  constructor(exponent: number);
}

/**
 * The phase function of Henyey and Greenstein: where fog, clouds, skin or dust scatter light.
 *
 * Directions are local, about +z, the direction in which the light travels. The asymmetry g is the mean of cos θ: g > 0
 * favours +z, g < 0 sends the light back, and g = 0 is the uniform sphere. With h = |g|, w = 1 − u₁ for g ≥ 0 and w =
 * u₁ below, c = (1 − h) + 2hw, 1 − cos θ is 2u₁((1 − g)/c)²(1 + hw) and 1 + cos θ is 2(1 − u₁)((1 + g)/c)²((1 − h) +
 * hw); for g < 0 the two sums change places. Nothing is divided by g and both poles keep their digits, so that neither
 * g = 1e-30 nor g = 1 − 2⁻²⁴ is a special case.
 *
 * **Density**
 * (1 − g²)/(4πS³) per steradian for any finite direction, where S = √(1 + g² − 2g cos θ) is the distance from the
 * direction to the point g of the axis. The code works with S² = (1 − h)² + 2h(1 ∓ cos θ).
 *
 * **Domain**
 * - Point: unit vectors. For |g| near 1 most of them have z = ±1, and x and y hold all the information, which `pdf` and
 *   `invert` use.
 * - Uniforms: two, for the polar angle and the azimuth. +z is at u₁ = 0.
 * - Parameters: g in (−1, 1), or 1 − |g| from 2⁻³² to 1 and a side.
 *
 * **Accuracy**
 * *Sample* is the distance from the exact direction, *unit length* the error of the length. sin θ and cos θ count units
 * in the last place (ulp). *Pdf* and *realised density* are relative, *inverse* and *round trip* are absolute errors of
 * the uniforms. [What each row means](https://docs.rs/microwarp/latest/microwarp/warp/#stated-errors).
 *
 * | error | `poly` | kind |
 * |---|--:|---|
 * | sample, of the size | 6.2e-7 | proven |
 * | sin θ, ulp | 7.7 | proven |
 * | unit length | 2.3e-7 | proven |
 * | pdf, relative | 7.6e-7 | found |
 * | realised density, relative | 2.1e-6 | found |
 * | pdf with the sample, relative | 1.1e-6 | found |
 * | inverse | 4.9e-7 | found |
 * | round trip | 4.9e-7 | found |
 *
 * These hold for every g and every constructor. They count from the number that it is given: near 1 the rounding of g
 * to an `f32`, up to 3e-8, changes the width of the peak, 1 − |g|, which `fromOneMinusG` and `fromOnePlusG` take as it
 * is.
 *
 * The errors of the sample, of sin θ and of the length are proven for every g and every pair of uniforms: see
 * `docs/proofs.md`.
 *
 * **Source**
 * L. G. Henyey and J. L. Greenstein, "Diffuse Radiation in the Galaxy", 1941, <https://doi.org/10.1086/144246>. The
 * inverse CDF is that of M. Pharr, W. Jakob and G. Humphreys, "Physically Based Rendering", fourth edition, 2023,
 * <https://pbr-book.org/4ed/Volume_Scattering/Phase_Functions>, rearranged here.
 */
export declare class HenyeyGreenstein extends Warp<[number, number, number], [number, number]> {
  /**
   * The phase function of asymmetry `g`, in (−1, 1).
   *
   * @throws RangeError:
   * NotFinite (code 1) for NaN or infinity, OutOfRange (code 7) for 1 or more and for −1 or less, where all the light
   * goes one way and there is no density.
   */
  constructor(asymmetry: number);
  /**
   * Of asymmetry 0 or more, by 1 − g from 2⁻³² (2.3e-10) to 1, the width of a narrow peak, which a rounded g does not
   * tell.
   *
   * @throws RangeError:
   * NotFinite (code 1) for NaN or infinity, NotPositive (code 5) for 0 or less, OutOfRange (code 7) below 2⁻³² and
   * above 1.
   */
  static fromOneMinusG(oneMinusG: number): HenyeyGreenstein;
  /**
   * Of asymmetry 0 or less, by 1 + g: the mirror image of `fromOneMinusG`, whose light turns back.
   *
   * @throws RangeError:
   * Those of `fromOneMinusG`.
   */
  static fromOnePlusG(onePlusG: number): HenyeyGreenstein;
}

/**
 * The von Mises-Fisher distribution: the normal distribution of directions, for glossy lobes, light guiding and noise
 * on an orientation.
 *
 * Directions are local, about +z. The concentration κ is 0 for the uniform sphere; a large one gives a normal
 * distribution about +z of standard deviation 1/√κ radians in each of x and y. With v = 1 − u₁, 1 − cos θ is −ln(1 −
 * u₁(1 − e^(−2κ)))/κ and 1 + cos θ is ln(1 + v(e^(2κ) − 1))/κ. The nearer pole is measured from, and the logarithm is
 * taken of 1 + x or of v + u₁e^(−2κ), whichever keeps the digits: no two heights fall together, however large κ is.
 *
 * **Density**
 * κ/(2π(1 − e^(−2κ))) e^(−κ(1 − cos θ)) per steradian, for any finite direction. `sampleWithPdf` takes it from the
 * uniforms, without an exponential.
 *
 * **Domain**
 * Unit vectors. For large κ most of them have z = 1, and all the information is in x and y, which `pdf` and `invert`
 * read there. Two uniforms, polar then azimuth; +z is at u₁ = 0. κ is from 0 to 1e30. One below 2⁻³⁰ counts as that,
 * which changes no digit.
 *
 * **Accuracy**
 * | error | `poly` | kind |
 * |---|--:|---|
 * | sample, of the size | 3.8e-7 | proven |
 * | sin θ, ulp | 3.7 | found |
 * | unit length | 2.3e-7 | proven |
 * | pdf, relative | 4.3e-7 | found |
 * | realised density, relative | 1.2e-5 | found |
 * | pdf with the sample, relative | 3.6e-7 | found |
 * | inverse | 3.1e-7 | found |
 * | round trip | 3.2e-7 | found |
 *
 * These hold for every κ. The realised density counts the rounding of the direction up to 16.6 times: as far out,
 * 16.6/κ in 1 − cos θ, lies the last uniform. The density that comes with the sample does not know it. The errors of
 * samples and of their length are proven for every pair of uniforms: see `docs/proofs.md`.
 *
 * **Source**
 * R. Fisher, "Dispersion on a Sphere", 1953, <https://doi.org/10.1098/rspa.1953.0064>; its inverse as in W. Jakob,
 * "Numerically stable sampling of the von Mises Fisher distribution on S² (and other tricks)", 2012, rearranged here.
 */
export declare class VonMisesFisher extends Warp<[number, number, number], [number, number]> {
  /**
   * The distribution about +z of concentration `kappa`, from 0 to 1e30.
   *
   * @throws RangeError:
   * NotFinite (code 1) for NaN or infinity, Negative (code 6) below 0, OutOfRange (code 7) above 1e30.
   */
  constructor(kappa: number);
}

export interface Ggx extends Surface {}

/**
 * Normals of the microfacets of a rough surface, after Trowbridge and Reitz (GGX).
 *
 * The normal is the unit vector along (αx √u₁ cos φ, αy √u₁ sin φ, √(1 − u₁)), φ = u₂ turns. For reflection towards a
 * known viewer take `GgxVisible`, which wastes no normals that face away.
 *
 * **Density**
 * D(m) cos θ per steradian for z > 0, with D = 1/(π αx αy ((x/αx)² + (y/αy)² + z²)²). All terms are positive, so that
 * nothing cancels at small roughness. `sampleWithPdf` takes it from the uniforms, which is cheaper and does not count
 * the rounding of the normal.
 *
 * **Domain**
 * - Point: unit vectors with z > 0, about the surface normal +z.
 * - Uniforms: two, polar then azimuth; the pole is at u₁ = 0.
 * - Parameters: roughness αx and αy from 1e-4 to 1.
 *
 * **Accuracy**
 * *Sample* is the distance from the exact normal, *unit length* the error of the length. sin θ and cos θ count units in
 * the last place (ulp). *Pdf* and *realised density* are relative, *inverse* and *round trip* are absolute errors of
 * the uniforms; s and r are what one ulp of the normal changes in density and inverse. [What each row
 * means](https://docs.rs/microwarp/latest/microwarp/warp/#stated-errors).
 *
 * | error | `poly` | kind |
 * |---|--:|---|
 * | sample, of the size | 3.2e-7 | proven |
 * | sin θ, ulp | 6.2 | found |
 * | cos θ, ulp | 5.1 | found |
 * | unit length | 2.2e-7 | found |
 * | pdf, relative | 1.3e-6 | found |
 * | realised density, relative | 1.5e-6 + 1.8*s | found |
 * | pdf with the sample, relative | 1.7e-6 | found |
 * | inverse | 1.7e-7 | found |
 * | round trip | 2.1e-7 + 0.66*r | found |
 *
 * The error of a sample is proven for all roughnesses and every pair of uniforms: see `docs/proofs.md`.
 *
 * **Source**
 * T. S. Trowbridge and K. P. Reitz, "Average Irregularity Representation of a Rough Surface for Ray Reflection", 1975,
 * <https://doi.org/10.1364/JOSA.65.000531>; B. Walter and others, "Microfacet Models for Refraction through Rough
 * Surfaces", 2007, <https://doi.org/10.2312/EGWR/EGSR07/195-206>.
 */
export declare class Ggx extends Warp<[number, number, number], [number, number]> {
  /**
   * Normals of roughness `alpha` along x and along y; equal ones are isotropic.
   *
   * @throws RangeError:
   * NotFinite (code 1) for NaN or infinity, NotPositive (code 5) for 0 or less, OutOfRange (code 7) below 1e-4 and
   * above 1.
   */
  constructor(alpha: Vector2);
}

export interface GgxVisible extends Gloss {}

/**
 * Normals of GGX microfacets that a viewer sees, in proportion to their visible area.
 *
 * A direction uniform on a spherical cap and the viewer's, both in the space where the surface is a hemisphere, add up
 * to the normal (Dupuy and Benyoub). The azimuth u₂ is counted from the viewer's, so that the sum has no cancellation.
 * `sampleWithPdf` takes the density from the length of that sum, in which w·m does not cancel either.
 *
 * **Density**
 * `2 (w·m) D(m)/(w_z + ℓ)` per steradian where w·m > 0, with the view w, `ℓ = √(αx² w_x² + αy² w_y² + w_z²)` and D as
 * for `Ggx`. The reflected direction has density `D(m)/(2(w_z + ℓ))`. `GgxVisible.reflectedPdf` gives it.
 * `GgxVisible.bounded` divides by `k w_z + ℓ` instead, with k ≤ 1.
 *
 * **Domain**
 * - Point: unit vectors with z > 0, about the surface normal +z.
 * - Uniforms: two, polar then azimuth about the axis of the cap.
 * - Parameters: views up to the horizon, of any length; roughness αx and αy from 1e-4 to 1.
 *
 * Carry the normal of a reflection, or its density: computed again from the two rounded directions, the half vector
 * loses all its digits at small roughness (1e-4: errors of 0.3 % at 40°, of 100 % near the horizon).
 *
 * **Accuracy**
 * *Sample* is the distance from the exact normal, *unit length* the error of the length. *Pdf* and *realised density*
 * are relative, *inverse* and *round trip* are absolute errors of the uniforms; s and r are what one ulp of the normal
 * changes in density and inverse. [What each row
 * means](https://docs.rs/microwarp/latest/microwarp/warp/#stated-errors).
 *
 * | error | bound | kind |
 * |---|--:|---|
 * | sample, of the size | 6.6e-7 + 6.3e-7*q | found |
 * | unit length | 2.4e-7 | found |
 * | pdf, relative | 1.2e-6 + 2.8*s | found |
 * | realised density, relative | 1.4e-6 + 8.3·s + 8.4e-7·q | found |
 * | pdf with the sample, relative | 1.2e-6 + 9.7e-7*q | found |
 * | inverse | 8e-7 + 9.8*r | found |
 * | round trip | 8.3e-7 + 9.9*r | found |
 *
 * Here q is the larger roughness over the smaller one: where they differ, the azimuth of the normal is that much more
 * sensitive than the azimuth of the sum. The azimuth of the inverse is not held where u₁ is below 2⁻⁴⁰, next to the
 * pole of the cap: there it is the rounding of the normal. The grid has no such u₁ but 0.
 *
 * **Source**
 * E. Heitz, "Sampling the GGX Distribution of Visible Normals", 2018, <https://jcgt.org/published/0007/04/01/>; J.
 * Dupuy and A. Benyoub, "Sampling Visible GGX Normals with Spherical Caps", 2023, <https://doi.org/10.1111/cgf.14867>;
 * Y. Tokuyoshi and K. Eto, "Bounded VNDF Sampling for Smith-GGX Reflections", 2023,
 * <https://doi.org/10.1145/3610543.3626163>.
 */
export declare class GgxVisible extends Warp<[number, number, number], [number, number]> {
  /**
   * The normals seen from `view`, a direction of any length, of roughness `alpha` along x and along y.
   *
   * @throws RangeError:
   * NotFinite (code 1) for NaN or infinity, ZeroLength (code 9) for a view without a length, OutOfRange (code 7) for a
   * view below the surface and for a roughness below 1e-4 or above 1, NotPositive (code 5) for a roughness of 0 or
   * less.
   */
  constructor(view: Vector3, alpha: Vector2);
  /**
   * The same without the normals whose reflections all lie below the surface.
   *
   * @throws RangeError:
   * Those of `new GgxVisible`.
   */
  static bounded(view: Vector3, alpha: Vector2): GgxVisible;
}

/**
 * Uniform over the directions within an angle of +z: a cone, also called a spherical cap.
 *
 * With k = 1 − cos θmax and q = u₁k: sin θ = √(q(2 − q)), cos θ = 1 − q. The warp stores k, and 2 − k beside it,
 * because k keeps its digits where cos θmax has rounded to 1. A cone of 1e-19 rad samples as accurately as a wide one.
 * k is kept times a power of two, so that no product underflows and sin θ is 0 at u₁ = 0 alone.
 *
 * **Density**
 * 1/(2πk) per steradian inside the cone, and a few ulp beyond its rim; 0 elsewhere. `pdf(w) > 0` is no hit test:
 * whether a ray meets the lamp is a question to the geometry.
 *
 * **Domain**
 * - Point: unit vectors with 1 − cos θ ≤ k. For cones under 3e-4 rad z is 1 and x and y hold all the information, which
 *   `pdf` and `invert` use.
 * - Uniforms: two, for the polar angle and the azimuth. The axis is at u₁ = 0.
 * - Parameters: a half angle in radians, its sine, or 1 − cos of it.
 *
 * **Accuracy**
 * *Sample* is the distance from the exact direction, *unit length* the error of the length. sin θ and cos θ count units
 * in the last place (ulp). *Pdf* and *realised density* are relative, *inverse* and *round trip* are absolute errors of
 * the uniforms. [What each row means](https://docs.rs/microwarp/latest/microwarp/warp/#stated-errors).
 *
 * | error | `poly` | kind |
 * |---|--:|---|
 * | sample, of the size | 3.5e-7 | proven |
 * | sin θ, ulp | 3.7 | found |
 * | unit length | 2.3e-7 | proven |
 * | pdf, relative | 3.5e-7 | found |
 * | realised density, relative | 3.5e-7 | found |
 * | inverse | 5.4e-7 | found |
 * | round trip | 7e-7 | found |
 *
 * These hold for every cone of each constructor; of a u₁ below 2⁻¹²⁶ and a k below 2⁻¹⁰⁰, sin θ has fewer digits.
 * Azimuths of subnormal x and y, which only uniforms below 2⁻⁶⁴ give, have no more digits in the inverse than x and y
 * have.
 *
 * The errors of the sample and of the length are proven for every cone and every pair of uniforms: see
 * `docs/proofs.md`.
 *
 * **Source**
 * P. Shirley, C. Wang and K. Zimmerman, "Monte Carlo Techniques for Direct Lighting Calculations", ACM Transactions on
 * Graphics, 1996, <https://doi.org/10.1145/226150.226151>.
 */
export declare class Cone extends Warp<[number, number, number], [number, number]> {
  private constructor();
  /**
   * The cone of 1 − cos θmax = `k`, in (0, 2]. A `k` of 2 is the whole sphere.
   *
   * @throws RangeError:
   * NotFinite (code 1) for NaN or infinity, NotPositive (code 5) for 0 or less, OutOfRange (code 7) above 2, Empty
   * (code 3) below the smallest normal `f32`.
   */
  static fromOneMinusCos(oneMinusCos: number): Cone;
  /**
   * The cone of the given half angle in radians, in (0, π].
   *
   * @throws RangeError:
   * NotFinite (code 1) for NaN or infinity, NotPositive (code 5) for 0 or less, OutOfRange (code 7) above π, Empty
   * (code 3) below about 1.6e-19 rad.
   */
  static fromRadians(halfAngle: number): Cone;
  /**
   * The cone of the given sine of the half angle, in (0, 1]. Next to 1 it hangs on the last digits of the sine: for the
   * cone in which a sphere is seen, take `VisibleSphere`.
   *
   * @throws RangeError:
   * NotFinite (code 1) for NaN or infinity, NotPositive (code 5) for 0 or less, OutOfRange (code 7) above 1, Empty
   * (code 3) below 1.6e-19.
   */
  static fromSine(sine: number): Cone;
}

export interface VisibleSphere extends Lamp {}

/**
 * Uniform over the directions in which a sphere is seen from a point: a sphere light, sampled by solid angle.
 *
 * From outside, the directions fill a `Cone` about the centre. With d the distance to the centre and r the radius, its
 * cos θmax is `√(d² − r²)/d`, and `k = 1 − cos θmax = r²/(d²(1 + cos θmax))`. Where d² − r² is below d²/4 it is worked
 * out from both roundings of centre − point, and next to the surface exactly. So no height above the surface is too
 * small, and whether the point is inside is always decided right.
 *
 * **Density**
 * 1/(2πk) per steradian from outside, on the directions of the cone and up to 5e-7 rad beyond its rim; 1/(4π) in all
 * directions from inside. On the surface itself k is 1, and the directions fill the hemisphere towards the centre: the
 * limit from outside.
 *
 * `pdf(w) > 0` is no hit test, and a lamp of half angle below about 1e-5 rad is best taken as a point. The density that
 * comes with a sample belongs to its uniforms, and is right however narrow the cone is.
 *
 * **Domain**
 * - Point: unit vectors in world coordinates.
 * - Uniforms: two. The direction of the centre is at u₁ = 0, the rim (from inside, the opposite direction) at u₁ = 1.
 * - Parameters: any finite point and centre, and any radius above 0, if the half angle is at least 1.6e-19 rad and the
 *   far side of the sphere not beyond the range of `f32`.
 *
 * **Accuracy**
 * *Sample* is the distance from the exact direction, *unit length* the error of the length. *Pdf* and *realised
 * density* are relative, *inverse* and *round trip* are absolute errors of the uniforms; r is what one rounding of the
 * direction changes in them. [What each row means](https://docs.rs/microwarp/latest/microwarp/warp/#stated-errors).
 *
 * | error | `poly` | kind |
 * |---|--:|---|
 * | sample, of the size | 9e-7 | found |
 * | unit length | 5.3e-7 | found |
 * | pdf, relative | 9e-7 | found |
 * | realised density, relative | 9e-7 | found |
 * | inverse | min(1, 5e-7 + 15*r) | found |
 * | round trip | min(1, 6.2e-7 + 11*r) | found |
 *
 * In both tiers k is right to 8e-7 and the distance to 1.9e-6, relatively. The distance belongs to the uniforms, and
 * loses digits where it is below 1e-37, or the point nearer to the surface than 1e-37 radii.
 *
 * **Source**
 * P. Shirley, C. Wang and K. Zimmerman, "Monte Carlo Techniques for Direct Lighting Calculations", ACM Transactions on
 * Graphics, 1996, <https://doi.org/10.1145/226150.226151>, rearranged here.
 */
export declare class VisibleSphere extends Warp<[number, number, number], [number, number]> {
  /**
   * The sphere of the given centre and radius, seen from `point`.
   *
   * @throws RangeError:
   * NotFinite (code 1) for NaN or infinity, NotPositive (code 5) for a radius of 0 or less, TooLarge (code 4) where the
   * far side of the sphere is beyond the range of `f32`, Empty (code 3) for a sphere seen under less than 1.6e-19 rad.
   */
  constructor(point: Vector3, centre: Vector3, radius: number);
}

/**
 * Uniform over the directions between two polar angles and two azimuths, a rectangle of latitude and longitude.
 *
 * cos θ is uniform between its two ends, and φ is uniform. The code works with 1 − cos θ and 1 + cos θ, so that neither
 * pole cancels.
 *
 * **Density**
 * 1/Ω per steradian inside, with Ω = (cos θ₀ − cos θ₁)(φ₁ − φ₀)·2π; else 0. A direction counts as inside up to the
 * rounding of its coordinates: 5e-7 relative in 1 ∓ cos θ, and 3e-7 turns of azimuth, which matters in patches only a
 * few times wider than that.
 *
 * **Domain**
 * - Point: unit vectors with θ and φ in the given ranges (φ modulo one turn).
 * - Uniforms: two, for the polar angle and the azimuth.
 * - Parameters: angles in turns (one turn is 2π radians): 0 ≤ θ₀ < θ₁ ≤ ½, −1 ≤ φ₀ ≤ 1, φ₀ < φ₁ ≤ φ₀ + 1.
 *
 * **Accuracy**
 * *Sample* is the distance from the exact direction, *unit length* the error of the length. sin θ and cos θ count units
 * in the last place (ulp). *Pdf* and *realised density* are relative, *inverse* and *round trip* are absolute errors of
 * the uniforms. [What each row means](https://docs.rs/microwarp/latest/microwarp/warp/#stated-errors).
 *
 * | error | `poly` | kind |
 * |---|--:|---|
 * | sample, of the size | 6.4e-7 | found |
 * | unit length | 3.3e-7 | found |
 * | pdf, relative | 7.5e-7 | found |
 * | realised density, relative | 7.5e-7 | found |
 * | inverse | min(1, 3e-7 + 7.3e-7*q/c + 1.6e-7/w) | found |
 * | round trip | min(1, 2.7e-7 + 7.9e-7*q/c + 1.6e-7/w) | found |
 *
 * These hold for every patch: c is cos θ₀ − cos θ₁, w the width φ₁ − φ₀ in turns, and q the smaller of 1 − cos θ₁ and 1
 * + cos θ₀.
 *
 * **Source**
 * M. Pharr, W. Jakob and G. Humphreys, "Physically Based Rendering", third edition, 2016,
 * <https://pbr-book.org/3ed-2018/contents>, for dω = sin θ dθ dφ.
 */
export declare class SphericalPatch extends Warp<[number, number, number], [number, number]> {
  private constructor();
  /**
   * @throws RangeError:
   * NotFinite (code 1) for NaN or infinity, Reversed (code 2) if an upper end is below its lower, OutOfRange (code 7)
   * for polar angles outside [0, ½], a `phi0` outside [−1, 1] or a width above 1 turn, Empty (code 3) for a patch with
   * no extent, one whose density overflows or one whose cos θ₀ − cos θ₁ is below the smallest normal `f32`. A width
   * that rounds to 1 is a whole turn.
   */
  static fromTurns(theta0: number, theta1: number, phi0: number, phi1: number): SphericalPatch;
}

export interface SphericalTriangle extends Lamp {}

/**
 * Uniform over the directions from a point to a triangle: an area light, sampled by its solid angle.
 *
 * The second uniform divides the solid angle by an arc from the first vertex, as in Arvo's map, and the first one goes
 * along the arc. With H half of the solid angle, the side b-c across from the first vertex a is divided in the ratio of
 * sin(u₂H)·√(2(1 + ab)) to sin((1 − u₂)H)·√((1 + bc)(1 + ca)). A direction is the sum of the directions of the vertices
 * times weights, which are products and sums of positive numbers. Nothing cancels, however small, thin or near the
 * triangle, and the barycentric coordinates are the weights over the distances.
 *
 * **Density**
 * 1/Ω per steradian inside and 0 outside, farther than the rounding of samples: 2.4e-6·q rad from a side, and farther
 * beyond a sharp corner. A world direction is rounded to 6e-8 rad, so that it cannot tell inside from outside in a
 * triangle a few times wider than that. Hence:
 *
 * - `pdf(w) > 0` is no hit test. The density of a triangle of 1e-3 rad integrates over all directions to 1.02, that of
 *   1e-6 rad (4e-13 sr) to about 80.
 *
 * Close to the triangle the density is as constant as far away, and right; the directions lose digits with q.
 *
 * **Domain**
 * - Point: unit vectors in world space. The triangle is seen from both sides.
 * - Uniforms: two. The first vertex is at u₁ = 0; from the second to the third, u₂ grows.
 * - Parameters: vertices with edges and distances of at most 2⁶⁰ (1e18), not all of them below 2⁻⁶⁰, that are seen
 *   under 1e-18 sr or more. Seen from their edge, or of a sharp first corner, they have g of at least 2⁻²⁸. With L the
 *   distance of the first vertex and E the longer edge from there, g is the determinant of the three vertices, taken
 *   from the point, over L E².
 * - A point from which a side is seen under nearly half a turn, 1 + cos being below 2⁻²¹, or the solid angle is within
 *   0.002 sr of 2π, counts as one on the triangle.
 * - q, the nearness, is 1 over the distance of the point from the plane triangle of three unit vectors, those to the
 *   vertices. It is 1 for small triangles, 2 for an octant, and about half the size over the height close to a
 *   triangle.
 *
 * **Accuracy**
 * *Sample* is the distance from the exact direction, *unit length* the error of the length, *place on it* that of the
 * barycentric coordinates. [What each row means](https://docs.rs/microwarp/latest/microwarp/warp/#stated-errors).
 *
 * | error | `poly` | kind |
 * |---|--:|---|
 * | sample, of the size | 1.3e-6*q | found |
 * | unit length | 2e-7 | found |
 * | place on it | 6.5e-7 + (3.9 + 1.9·q)·p | found |
 * | pdf, relative | 1.1e-6 + 5.5e-7*q + 1e-14/g | found |
 * | realised density, relative | 1.1e-6 + 5.5e-7*q + 1e-14/g | found |
 * | pdf with the sample, relative | 1.1e-6 + 5.5e-7*q + 1e-14/g | found |
 * | inverse | min(1, 5.5e-6 + 5.5e-6·q + (110 + 7.4·q)·r + 1.5e-6/h + 8e-8/g) | found |
 * | round trip | min(1, 5.5e-6 + 5.5e-6·q + (110 + 7.4·q)·r + 1.5e-6/h + 8e-8/g) | found |
 *
 * These hold for every triangle accepted. p is the change of the place when each uniform and each coordinate of the
 * direction moves by 2⁻²⁴, r the change of the uniforms when each coordinate of the direction does. h is the sine of
 * the smallest height: the second uniform of a direction within rounding of the first vertex, where √u₁ h is below
 * 2⁻²⁰, is lost.
 *
 * **Source**
 * J. Arvo, "Stratified Sampling of Spherical Triangles", SIGGRAPH 1995, <https://doi.org/10.1145/218380.218500>, and A.
 * Van Oosterom and J. Strackee, "The Solid Angle of a Plane Triangle", 1983,
 * <https://doi.org/10.1109/TBME.1983.325207>, rearranged here.
 */
export declare class SphericalTriangle extends Warp<[number, number, number], [number, number]> {
  /**
   * The directions from `point` to the triangle with these vertices, from either side.
   *
   * @throws RangeError:
   * NotFinite (code 1) for NaN or infinity, TooLarge (code 4) for distances beyond about 2⁶⁰, Empty (code 3) for
   * coincident vertices and for a triangle that is too small, too thin or seen too much from its edge, NotNormalizable
   * (code 8) for a point on the triangle. The section on the domain says where these begin.
   */
  constructor(point: Vector3, vertices: readonly [Vector3, Vector3, Vector3]);
}

export interface SphericalRectangle extends Lamp {}

/**
 * Uniform over the directions from a point to a rectangle, or any parallelogram: an area light, sampled by its solid
 * angle.
 *
 * Two spherical triangles about the corner, on both sides of the diagonal, each with the map of `SphericalTriangle`: u₂
 * sweeps the solid angle from the first edge to the second, and the map has no seam at the diagonal.
 *
 * **Density**
 * 1/Ω per steradian inside and 0 outside, farther than the rounding of samples, 2.4e-6·q rad. What `SphericalTriangle`
 * says of small triangles, of close points and of `pdf(w) > 0` holds here, too.
 *
 * **Domain**
 * - Point: unit vectors in world space. The rectangle is seen from both sides.
 * - Uniforms: two. The corner is at u₁ = 0; from the first edge to the second, u₂ grows.
 * - Parameters: those of `SphericalTriangle` for both halves, g being taken with the two edges and q the larger
 *   nearness of the two. The edges are taken as they are given, so that a small one keeps its digits far from 0.
 *
 * **Accuracy**
 * *Sample* is the distance from the exact direction, *unit length* the error of the length, *place on it* that of the
 * coordinates along the edges. [What each row means](https://docs.rs/microwarp/latest/microwarp/warp/#stated-errors).
 *
 * | error | bound | kind |
 * |---|--:|---|
 * | sample, of the size | 9.7e-7*q | found |
 * | unit length | 2e-7 | found |
 * | place on it | 7.8e-7 + (2.6 + 0.79·q)·p | found |
 * | pdf, relative | 9.6e-7 + 4.8e-7*q + 7.6e-15/g | found |
 * | realised density, relative | 9.6e-7 + 4.8e-7*q + 7.6e-15/g | found |
 * | pdf with the sample, relative | 9.6e-7 + 4.8e-7*q + 7.6e-15/g | found |
 * | inverse | min(1, 2.5e-6 + 2.5e-6·q + (54 + 2·q)·r + 8e-7/h + 8e-8/g) | found |
 * | round trip | min(1, 2.5e-6 + 2.5e-6·q + (54 + 2·q)·r + 8e-7/h + 8e-8/g) | found |
 *
 * These hold for every rectangle accepted. p is the change of the place when each uniform and each coordinate of the
 * direction moves by 2⁻²⁴, r the change of the uniforms when each coordinate of the direction does. h is the sine of
 * the smallest height of both halves: the second uniform of a direction within rounding of the corner, where √u₁ h is
 * below 2⁻²⁰, is lost.
 *
 * **Source**
 * C. Ureña, M. Fajardo and A. King, "An Area-Preserving Parametrization for Spherical Rectangles", 2013,
 * <https://doi.org/10.1111/cgf.12151>, for the problem; the map is that of `SphericalTriangle`.
 */
export declare class SphericalRectangle extends Warp<[number, number, number], [number, number]> {
  /**
   * The directions from `point` to the rectangle of `corner` and two edges, from either side. The edges need not be at
   * right angles.
   *
   * @throws RangeError:
   * NotFinite (code 1) for NaN or infinity, TooLarge (code 4) for distances and edges beyond about 2⁶⁰, ZeroLength
   * (code 9) for an edge of length 0, Empty (code 3) for a rectangle that is too small, too thin or seen too much from
   * its edge, NotNormalizable (code 8) for a point on the rectangle. The section on the domain says where these begin.
   */
  constructor(point: Vector3, corner: Vector3, edges: readonly [Vector3, Vector3]);
}

/**
 * Uniform in an axis-aligned box of any dimension, such as the bounding box of a region.
 *
 * **Density**
 * The product of 1/(bᵢ − aᵢ), on the closed box.
 *
 * **Domain**
 * - Point: aᵢ ≤ xᵢ < bᵢ.
 * - Uniforms: one a dimension.
 * - Parameters: finite corners with aᵢ < bᵢ whose volume has a density that `f32` can hold.
 * - Both tiers share this code.
 *
 * **Accuracy**
 * *Sample* is the distance from the exact point, relative to the size, which is the largest bound. The other rows are
 * relative errors of densities and absolute errors of uniforms. [What each row
 * means](https://docs.rs/microwarp/latest/microwarp/warp/#stated-errors).
 *
 * | error | bound | kind |
 * |---|--:|---|
 * | sample, of the size | sqrt(n) * max(2.25e-7, 2.6e-45/m) | proven |
 * | pdf, relative | 7.8e-8 | found |
 * | realised density, relative | 7.8e-8 | found |
 * | inverse | 2e-7 | found |
 * | round trip | 1.8e-7 + max(3.3, 3.9e-38/m)*r | found |
 *
 * The error of a sample is proven for all parameters and uniforms: see `docs/proofs.md`.
 *
 * n is the number of dimensions and m the size. The second term of a maximum counts where m is subnormal, which it can
 * be in one dimension. r is the change of the inverse when the point moves by 2⁻²⁴ of the size.
 *
 * **Source**
 * L. Devroye, "Non-Uniform Random Variate Generation", 1986, <https://doi.org/10.1007/978-1-4613-8643-8>.
 */
export declare class Aabb2d extends Warp<[number, number], [number, number]> {
  /**
   * The box between two opposite corners, `low` and `high`.
   *
   * @throws RangeError:
   * Those of `new Interval` for each side. Empty (code 3) where the density overflows `f32`, TooLarge (code 4) where it
   * is below the smallest normal number.
   */
  constructor(low: Vector2, high: Vector2);
}

/**
 * Uniform in an axis-aligned box of any dimension, such as the bounding box of a region.
 *
 * **Density**
 * The product of 1/(bᵢ − aᵢ), on the closed box.
 *
 * **Domain**
 * - Point: aᵢ ≤ xᵢ < bᵢ.
 * - Uniforms: one a dimension.
 * - Parameters: finite corners with aᵢ < bᵢ whose volume has a density that `f32` can hold.
 * - Both tiers share this code.
 *
 * **Accuracy**
 * *Sample* is the distance from the exact point, relative to the size, which is the largest bound. The other rows are
 * relative errors of densities and absolute errors of uniforms. [What each row
 * means](https://docs.rs/microwarp/latest/microwarp/warp/#stated-errors).
 *
 * | error | bound | kind |
 * |---|--:|---|
 * | sample, of the size | sqrt(n) * max(2.25e-7, 2.6e-45/m) | proven |
 * | pdf, relative | 7.8e-8 | found |
 * | realised density, relative | 7.8e-8 | found |
 * | inverse | 2e-7 | found |
 * | round trip | 1.8e-7 + max(3.3, 3.9e-38/m)*r | found |
 *
 * The error of a sample is proven for all parameters and uniforms: see `docs/proofs.md`.
 *
 * n is the number of dimensions and m the size. The second term of a maximum counts where m is subnormal, which it can
 * be in one dimension. r is the change of the inverse when the point moves by 2⁻²⁴ of the size.
 *
 * **Source**
 * L. Devroye, "Non-Uniform Random Variate Generation", 1986, <https://doi.org/10.1007/978-1-4613-8643-8>.
 */
export declare class Aabb3d extends Warp<[number, number, number], [number, number, number]> {
  /**
   * The box between two opposite corners, `low` and `high`.
   *
   * @throws RangeError:
   * Those of `new Interval` for each side. Empty (code 3) where the density overflows `f32`, TooLarge (code 4) where it
   * is below the smallest normal number.
   */
  constructor(low: Vector3, high: Vector3);
}

/**
 * Uniform on a ring between two circles about the origin (an annulus), or on a sector of one.
 *
 * r = √(r₀² + g) with g = u₁(r₁² − r₀²), and near the inner circle r = r₀ + g/(r₀ + √(r₀² + g)), where the root alone
 * would lose digits of r − r₀. So a ring of any width gets its share of the uniforms up to the rounding of its points.
 *
 * **Density**
 * 1/(π(r₁² − r₀²)w) per unit area between the circles and the sides, with a width of w turns; else 0. A point counts as
 * inside up to the rounding of its coordinates: 3.6e-7 of the radius, and 3e-7 turns. Within 1e-30 of the origin every
 * azimuth counts as inside.
 *
 * **Domain**
 * - Point: r₀ ≤ √(x² + y²) ≤ r₁ and the azimuth between the sides, up to the rounding of the coordinates.
 * - Uniforms: two, radius and azimuth.
 * - Parameters: radii 0 ≤ r₀ < r₁; azimuths in turns, −1 ≤ φ₀ ≤ 1, φ₀ < φ₁ ≤ φ₀ + 1; an area whose density `f32` can
 *   hold. An inner radius of 0 gives a disk.
 *
 * **Accuracy**
 * *Sample* is the distance from the exact point, relative to the outer radius. *Pdf* and *realised density* are
 * relative, *inverse* and *round trip* are absolute errors of the uniforms. [What each row
 * means](https://docs.rs/microwarp/latest/microwarp/warp/#stated-errors).
 *
 * | error | bound | kind |
 * |---|--:|---|
 * | sample, of the size | 4.9e-7 | proven |
 * | pdf, relative | 7.8e-8 | found |
 * | realised density, relative | 7.8e-8 | found |
 * | inverse | 2.2e-7/w | found |
 * | round trip | 1.8e-7/w + 3.9*r | found |
 *
 * w is the width in turns. r is the change of the inverse when the point moves by 2⁻²⁴ of the outer radius. Before its
 * coordinates are rounded, the radius is that of a uniform at most 3.3e-7 away, in a ring of any width.
 *
 * The error of a sample is proven for every ring, sector and pair of uniforms: see `docs/proofs.md`.
 *
 * **Source**
 * L. Devroye, "Non-Uniform Random Variate Generation", 1986, <https://doi.org/10.1007/978-1-4613-8643-8>; the form
 * without a difference is of this crate.
 */
export declare class Annulus extends Warp<[number, number], [number, number]> {
  /**
   * The ring between two radii.
   *
   * @throws RangeError:
   * Those of `Annulus.sector`.
   */
  constructor(inner: number, outer: number);
  /**
   * The part of a ring between two azimuths in turns, counted from +x towards +y.
   *
   * @throws RangeError:
   * NotFinite (code 1) for NaN or infinity, Negative (code 6) for a radius below 0, Reversed (code 2) if an upper end
   * is below its lower, OutOfRange (code 7) for a first azimuth outside [−1, 1] or a width above 1 turn, Empty (code 3)
   * for equal radii, equal azimuths or a density that overflows, TooLarge (code 4) for a density below the smallest
   * normal number. A width that rounds to 1 is a whole turn.
   */
  static sector(inner: number, outer: number, fromTurns: number, toTurns: number): Annulus;
}

/**
 * Uniform in the unit ball, the solid sphere.
 *
 * r = ∛u₁, and a direction of `Sphere`: z = r(1 − 2u₂), √(x² + y²) = 2r√(u₂(1 − u₂)), φ = u₃ turns. The cube root is
 * right to 0.51 units in the last place.
 *
 * **Density**
 * 3/(4π) per unit volume where x² + y² + z² ≤ 1, up to the rounding of the coordinates (3.6e-7 of the radius); else 0.
 *
 * **Domain**
 * - Point: x² + y² + z² ≤ 1, up to the rounding of the coordinates.
 * - Uniforms: three, for radius, height and azimuth. Strata of the first are shells of equal volume.
 *
 * **Accuracy**
 * *Sample* is the distance from the exact point, relative to the radius 1. *Pdf* and *realised density* are relative,
 * *inverse* and *round trip* are absolute errors of the uniforms. [What each row
 * means](https://docs.rs/microwarp/latest/microwarp/warp/#stated-errors).
 *
 * | error | bound | kind |
 * |---|--:|---|
 * | sample, of the size | 2.8e-7 | proven |
 * | pdf, relative | 1e-8 | exhaustive |
 * | realised density, relative | 1e-8 | exhaustive |
 * | inverse | 3e-7 | found |
 * | round trip | 1.1e-6 | found |
 *
 * The error of the sample is proven for all uniforms: see `docs/proofs.md`.
 *
 * **Source**
 * L. Devroye, "Non-Uniform Random Variate Generation", 1986, <https://doi.org/10.1007/978-1-4613-8643-8>.
 */
export declare class Ball extends Warp<[number, number, number], [number, number, number]> {
  /**
   * The unit ball.
   */
  constructor();
}

/**
 * Uniform over the rotations of space, as unit quaternions [x, y, z, w] with w ≥ 0.
 *
 * √(x² + y²) = √u₁ at the angle of u₃ turns, and √(z² + w²) = √(1 − u₁) at an angle within a quarter turn of +w, which
 * grows with u₂. It is uniform in the sense of Haar: a rotation before or after does not change it. The angle θ of the
 * rotation has density (1 − cos θ)/π; an axis and an angle that are uniform each favour small angles.
 *
 * **Density**
 * 1/π² per unit area of the half sphere in four dimensions, w ≥ 0, for any finite quaternion. A quaternion and its
 * negative are one rotation. For the measure in which the rotations have the volume 8π², as by Euler angles, divide by
 * 8; a density with respect to the uniform distribution itself is 1.
 *
 * **Domain**
 * - Point: unit quaternions with w ≥ 0, (x, y, z) = sin(θ/2) times the axis and w = cos(θ/2).
 * - Uniforms: three. (0, ½, 0) gives the identity.
 *
 * **Accuracy**
 * *Sample* is the distance from the exact quaternion, in four dimensions; its length is right to the same bound. *Pdf*
 * and *realised density* are relative, *inverse* and *round trip* are absolute errors of the uniforms. [What each row
 * means](https://docs.rs/microwarp/latest/microwarp/warp/#stated-errors).
 *
 * | error | `poly` | kind |
 * |---|--:|---|
 * | sample, of the size | 2.2e-7 | proven |
 * | pdf, relative | 5.5e-9 | exhaustive |
 * | realised density, relative | 5.5e-9 | exhaustive |
 * | inverse | 1.2e-7 | found |
 * | round trip | 2.4e-7 | found |
 *
 * The error of the sample is proven for all uniforms: see `docs/proofs.md`.
 *
 * **Source**
 * K. Shoemake, "Uniform Random Rotations", Graphics Gems III, 1992,
 * <https://doi.org/10.1016/B978-0-08-050755-2.50036-1>.
 */
export declare class Rotation extends Warp<[number, number, number, number], [number, number, number]> {
  /**
   * All rotations.
   */
  constructor();
}

/**
 * Uniform on a regular polygon with its corners on the unit circle, the first at (1, 0).
 *
 * The second uniform goes round the rim: ⌊n u₂⌋ counts the sides, and what is left of it, exactly, is the place along
 * that side. The first takes the point of the rim √u₁ of the way from the centre. The map is continuous, so that strata
 * stay together.
 *
 * The bladed aperture of a camera is one.
 *
 * **Density**
 * 1/(n/2 · sin(2π/n)) per unit area inside, up to the rounding of the coordinates (5e-7 of the radius); else 0.
 *
 * **Domain**
 * - Point: inside the polygon, up to the rounding of the coordinates.
 * - Uniforms: two, distance from the centre and place along the rim. Two zeros give the centre.
 * - Parameter: n from 3 to 65,535.
 *
 * **Accuracy**
 * *Sample* is the distance from the exact point, relative to the radius 1. *Pdf* and *realised density* are relative,
 * *inverse* and *round trip* are absolute errors of the uniforms. [What each row
 * means](https://docs.rs/microwarp/latest/microwarp/warp/#stated-errors).
 *
 * | error | `poly` | kind |
 * |---|--:|---|
 * | sample, of the size | 3.8e-7 | proven |
 * | pdf, relative | 2.8e-7 | found |
 * | realised density, relative | 2.8e-7 | found |
 * | inverse | 7.4e-7 | found |
 * | round trip | 1.2e-6 | found |
 *
 * The error of a sample is proven for all polygons and every pair of uniforms: see `docs/proofs.md`.
 *
 * **Source**
 * M. Pharr, W. Jakob and G. Humphreys, "Physically Based Rendering", third edition, 2016,
 * <https://pbr-book.org/3ed-2018/Monte_Carlo_Integration/2D_Sampling_with_Multidimensional_Transformations>, where
 * sampling regular polygons is an exercise.
 */
export declare class RegularPolygon extends Warp<[number, number], [number, number]> {
  /**
   * The polygon with so many corners.
   *
   * @throws RangeError:
   * OutOfRange (code 7) for fewer than three.
   */
  constructor(corners: number);
}

/**
 * Uniform on the simplex of N dimensions: N shares and the rest, none negative, with sum 1.
 *
 * Each share is taken from what the earlier ones leave: xⱼ = rest · (1 − (1 − uⱼ)^(1/m)) with m = N, N − 1, …, 1, and
 * the rest keeps the other part. Both parts come from one exponential that is accurate at either end, so that every
 * share has a small relative error, however small it is.
 *
 * The shares are barycentric coordinates of a segment, a triangle, a tetrahedron and so on, or the weights of a
 * mixture, or the lengths into which N uniform points divide [0, 1].
 *
 * **Density**
 * N! with respect to the N shares, where neither they nor the rest are negative and their sum is 1 to rounding; else 0.
 *
 * **Domain**
 * - Point: the N shares, and the rest.
 * - Uniforms: N. Each share increases with its own.
 * - N from 1 to 34, the largest whose density `f32` can hold. Others do not compile.
 *
 * **Accuracy**
 * *Sample* is the distance from the exact point, relative to the size 1. *Pdf* and *realised density* are relative,
 * *inverse* and *round trip* are absolute errors of the uniforms. [What each row
 * means](https://docs.rs/microwarp/latest/microwarp/warp/#stated-errors).
 *
 * | error | bound | kind |
 * |---|--:|---|
 * | sample, of the size | 1e-7 + 5.5e-8*n | found |
 * | pdf, relative | 6e-8 | exhaustive |
 * | realised density, relative | 6e-8 | exhaustive |
 * | inverse | 1.6e-7 + 5.5e-8*n | found |
 * | round trip | min(9e-8 + 1e-7·n, 2.5e-7 + 5.5e-8·n) | found |
 *
 * n is the number of dimensions. The relative error of the jth share is at most j·3.5e-7, and that of the rest (n +
 * 1)·3.5e-7, unless it is subnormal. Their sum is 1 to 1e-7 + 5.5e-8·n.
 *
 * **Source**
 * L. Devroye, "Non-Uniform Random Variate Generation", 1986, <https://doi.org/10.1007/978-1-4613-8643-8>.
 */
export declare class Simplex2 extends Warp<[number, number, number], [number, number]> {
  /**
   * The simplex of N dimensions, with N + 1 corners.
   */
  constructor();
}

/**
 * Uniform on the simplex of N dimensions: N shares and the rest, none negative, with sum 1.
 *
 * Each share is taken from what the earlier ones leave: xⱼ = rest · (1 − (1 − uⱼ)^(1/m)) with m = N, N − 1, …, 1, and
 * the rest keeps the other part. Both parts come from one exponential that is accurate at either end, so that every
 * share has a small relative error, however small it is.
 *
 * The shares are barycentric coordinates of a segment, a triangle, a tetrahedron and so on, or the weights of a
 * mixture, or the lengths into which N uniform points divide [0, 1].
 *
 * **Density**
 * N! with respect to the N shares, where neither they nor the rest are negative and their sum is 1 to rounding; else 0.
 *
 * **Domain**
 * - Point: the N shares, and the rest.
 * - Uniforms: N. Each share increases with its own.
 * - N from 1 to 34, the largest whose density `f32` can hold. Others do not compile.
 *
 * **Accuracy**
 * *Sample* is the distance from the exact point, relative to the size 1. *Pdf* and *realised density* are relative,
 * *inverse* and *round trip* are absolute errors of the uniforms. [What each row
 * means](https://docs.rs/microwarp/latest/microwarp/warp/#stated-errors).
 *
 * | error | bound | kind |
 * |---|--:|---|
 * | sample, of the size | 1e-7 + 5.5e-8*n | found |
 * | pdf, relative | 6e-8 | exhaustive |
 * | realised density, relative | 6e-8 | exhaustive |
 * | inverse | 1.6e-7 + 5.5e-8*n | found |
 * | round trip | min(9e-8 + 1e-7·n, 2.5e-7 + 5.5e-8·n) | found |
 *
 * n is the number of dimensions. The relative error of the jth share is at most j·3.5e-7, and that of the rest (n +
 * 1)·3.5e-7, unless it is subnormal. Their sum is 1 to 1e-7 + 5.5e-8·n.
 *
 * **Source**
 * L. Devroye, "Non-Uniform Random Variate Generation", 1986, <https://doi.org/10.1007/978-1-4613-8643-8>.
 */
export declare class Simplex3 extends Warp<[number, number, number, number], [number, number, number]> {
  /**
   * The simplex of N dimensions, with N + 1 corners.
   */
  constructor();
}

/**
 * Uniform on the simplex of N dimensions: N shares and the rest, none negative, with sum 1.
 *
 * Each share is taken from what the earlier ones leave: xⱼ = rest · (1 − (1 − uⱼ)^(1/m)) with m = N, N − 1, …, 1, and
 * the rest keeps the other part. Both parts come from one exponential that is accurate at either end, so that every
 * share has a small relative error, however small it is.
 *
 * The shares are barycentric coordinates of a segment, a triangle, a tetrahedron and so on, or the weights of a
 * mixture, or the lengths into which N uniform points divide [0, 1].
 *
 * **Density**
 * N! with respect to the N shares, where neither they nor the rest are negative and their sum is 1 to rounding; else 0.
 *
 * **Domain**
 * - Point: the N shares, and the rest.
 * - Uniforms: N. Each share increases with its own.
 * - N from 1 to 34, the largest whose density `f32` can hold. Others do not compile.
 *
 * **Accuracy**
 * *Sample* is the distance from the exact point, relative to the size 1. *Pdf* and *realised density* are relative,
 * *inverse* and *round trip* are absolute errors of the uniforms. [What each row
 * means](https://docs.rs/microwarp/latest/microwarp/warp/#stated-errors).
 *
 * | error | bound | kind |
 * |---|--:|---|
 * | sample, of the size | 1e-7 + 5.5e-8*n | found |
 * | pdf, relative | 6e-8 | exhaustive |
 * | realised density, relative | 6e-8 | exhaustive |
 * | inverse | 1.6e-7 + 5.5e-8*n | found |
 * | round trip | min(9e-8 + 1e-7·n, 2.5e-7 + 5.5e-8·n) | found |
 *
 * n is the number of dimensions. The relative error of the jth share is at most j·3.5e-7, and that of the rest (n +
 * 1)·3.5e-7, unless it is subnormal. Their sum is 1 to 1e-7 + 5.5e-8·n.
 *
 * **Source**
 * L. Devroye, "Non-Uniform Random Variate Generation", 1986, <https://doi.org/10.1007/978-1-4613-8643-8>.
 */
export declare class Simplex4 extends Warp<[number, number, number, number, number], [number, number, number, number]> {
  /**
   * The simplex of N dimensions, with N + 1 corners.
   */
  constructor();
}

/**
 * Uniform on the surface of an axis-aligned box, by area.
 *
 * The first uniform selects a pair of opposite faces and what is left of it is a coordinate; the second one selects a
 * face of the pair by its first bit, and the others are the other coordinate. A box that is flat in one axis has two
 * faces.
 *
 * **Density**
 * 1/area per unit area on the surface, and 0 farther from it than 2⁻²⁰ of the size.
 *
 * **Domain**
 * - Point: position and outward normal, six numbers, exactly on its face, with a normal along an axis. Density and
 *   inverse take the face from the normal, which decides at edges and on a flat box.
 * - Uniforms: two. On a face across x, a uniform runs along y and the other one along z; across y, along z and x;
 *   across z, along x and y. The pair of the smallest faces comes first, and below ½ the second uniform selects the
 *   lower face.
 * - Parameters: finite corners with aᵢ ≤ bᵢ, of which one side at most has no length, and an area whose density `f32`
 *   can hold. A face without area is never selected.
 * - Both tiers share this code.
 *
 * **Accuracy**
 * *Sample* is the distance from the exact point, relative to the size, which is the largest bound. *Pdf* and *realised
 * density* are relative to the density with which points of the face are drawn, whose share of the uniforms is rounded
 * to `f32`. *Inverse* and *round trip* are absolute errors of the uniforms. [What each row
 * means](https://docs.rs/microwarp/latest/microwarp/warp/#stated-errors).
 *
 * | error | bound | kind |
 * |---|--:|---|
 * | sample, of the size | 6e-7 | found |
 * | pdf, relative | 8.7e-7 | found |
 * | realised density, relative | 8.7e-7 | found |
 * | inverse | 3.4e-7 | found |
 * | round trip | 2.5e-7 + 1.5*r | found |
 *
 * r is the change of the inverse when the point moves by 2⁻²⁴ of the size.
 *
 * **Source**
 * L. Devroye, "Non-Uniform Random Variate Generation", 1986, <https://doi.org/10.1007/978-1-4613-8643-8>, section II.4
 * on compositions.
 */
export declare class BoxSurface extends Warp<[number, number, number, number, number, number], [number, number]> {
  /**
   * The surface of the box between two opposite corners, `low` and `high`.
   *
   * @throws RangeError:
   * NotFinite (code 1) for NaN or infinity, Reversed (code 2) where a coordinate of `low` is above that of `high`.
   * Empty (code 3) for a box without area, or so small that the density overflows, TooLarge (code 4) for one whose
   * density is below the smallest normal number.
   */
  constructor(low: Vector3, high: Vector3);
}

/**
 * Uniform on the surface of a frustum, by area: a cylinder, a cone, or a cone whose top is cut off; with its disks, or
 * as a tube without.
 *
 * The first uniform runs along the profile: from the centre of the lower disk to its rim, up the side, and over the
 * upper disk to its centre. The second one is the azimuth. The map is continuous over the rims.
 *
 * **Density**
 * 1/area per unit area on the surface, and 0 farther from it than 2⁻²⁰ of the size. The area is π(r₀² + (r₀ + r₁)ℓ +
 * r₁²) with ℓ² = h² + (r₀ − r₁)², or π(r₀ + r₁)ℓ of a tube.
 *
 * **Domain**
 * - Point: position and outward normal, six numbers. The axis is +z, the lower disk at z = 0 and the upper one at z =
 *   h, exactly. Density and inverse take from the normal whether a point is on the side.
 * - Uniforms: two. Two zeros give the centre of the lower disk, or the rim of a tube.
 * - Parameters: radii and height from 0 up with an area whose density `f32` can hold. A part without area is never met:
 *   a cone has one disk, and of height 0 there are two disks and the ring between them.
 *
 * **Accuracy**
 * *Sample* is the distance from the exact point, relative to the size, which is the largest of both radii and the
 * height. *Pdf* and *realised density* are relative, *inverse* and *round trip* are absolute errors of the uniforms.
 * [What each row means](https://docs.rs/microwarp/latest/microwarp/warp/#stated-errors).
 *
 * | error | bound | kind |
 * |---|--:|---|
 * | sample, of the size | 5.6e-7 | found |
 * | pdf, relative | 6e-7 | found |
 * | realised density, relative | 6e-7 | found |
 * | inverse | min(1, 5.7e-7 + 9.4e-7*g) | found |
 * | round trip | min(1, 6.6e-7 + 1.4e-6*g) | found |
 *
 * g is the share of the side in the area, times the size over the length ℓ of the side: above 2 for a narrow ring
 * alone. The azimuth of a point nearer to the axis than 2⁻¹²⁵ is lost. The normal is right to 3.4e-7, absolutely.
 *
 * **Source**
 * M. Pharr, W. Jakob and G. Humphreys, *Physically Based Rendering*, 4th edition, 2023, section 6.3:
 * <https://pbr-book.org/4ed/Shapes/Cylinders>, for the cylinder; the profile of all here.
 */
export declare class FrustumSurface extends Warp<[number, number, number, number, number, number], [number, number]> {
  /**
   * A frustum of the given lower and upper radius and height, with its disks. Equal radii make a cylinder, and a radius
   * of 0 a cone.
   *
   * @throws RangeError:
   * NotFinite (code 1) for NaN or infinity, Negative (code 6) for a number below 0. Empty (code 3) for a surface
   * without area, or so small that the density overflows, TooLarge (code 4) for one whose density is below the smallest
   * normal number, or whose diameter overflows.
   */
  constructor(radii: Vector2, height: number);
  /**
   * The side of a frustum alone, without its disks.
   *
   * @throws RangeError:
   * Those of `new FrustumSurface`.
   */
  static tube(radii: Vector2, height: number): FrustumSurface;
}

/**
 * Uniform on the surface of a capsule, by area: all points at one distance from a segment of the z axis.
 *
 * A zone of a sphere has the area of the cylinder around it, so the height z is uniform over the whole capsule
 * (Archimedes). The second uniform is the azimuth. Of height 0 the capsule is a sphere.
 *
 * **Density**
 * 1/(2πr(h + 2r)) per unit area on the surface, and 0 farther from it than 2⁻²⁰ of the size.
 *
 * **Domain**
 * - Point: position and outward normal, six numbers. The segment runs from the origin to (0, 0, h), the surface from z
 *   = −r to z = h + r. Density and inverse do not read the normal.
 * - Uniforms: two. The lower pole is at u₁ = 0.
 * - Parameters: a height from 0 up and a radius above 0 with a density that `f32` can hold.
 *
 * **Accuracy**
 * *Sample* is the distance from the exact point, relative to the size, h + r. *Pdf* and *realised density* are
 * relative, *inverse* and *round trip* are absolute errors of the uniforms. [What each row
 * means](https://docs.rs/microwarp/latest/microwarp/warp/#stated-errors).
 *
 * | error | bound | kind |
 * |---|--:|---|
 * | sample, of the size | 3.6e-7 | found |
 * | pdf, relative | 3.1e-7 | found |
 * | realised density, relative | 3.1e-7 | found |
 * | inverse | 2e-7 | found |
 * | round trip | 2.5e-7 | found |
 *
 * The azimuth of a point nearer to the axis than 2⁻¹²⁵ is lost. The normal is right to 2.6e-7, absolutely.
 *
 * **Source**
 * E. W. Weisstein, "Archimedes' Hat-Box Theorem", <https://mathworld.wolfram.com/ArchimedesHat-BoxTheorem.html>.
 */
export declare class CapsuleSurface extends Warp<[number, number, number, number, number, number], [number, number]> {
  /**
   * The capsule around a segment of the given height, at the given radius.
   *
   * @throws RangeError:
   * NotFinite (code 1) for NaN or infinity, Negative (code 6) for a height below 0, NotPositive (code 5) for a radius
   * of 0 or less. Empty (code 3) where the density overflows, TooLarge (code 4) where it is below the smallest normal
   * number, or where h + 2r overflows.
   */
  constructor(height: number, radius: number);
}
