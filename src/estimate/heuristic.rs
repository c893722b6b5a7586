//! Weights that combine sampling techniques into one estimate.

use crate::num::power_of_two;

/// 2⁹⁴; above it, a density times a count could overflow.
const LARGE: f32 = f32::from_bits((127 + 94) << 23);
/// 2⁻³³, which makes room for a count.
const ROOM: f32 = f32::from_bits((127 - 33) << 23);

/// A density, or 0 for an invalid one and for a technique that takes no samples.
#[inline]
fn density(n: u32, p: f32) -> f32 {
    if n > 0 && p > 0.0 { p } else { 0.0 }
}

/// The expected numbers of samples at the point from both techniques, up to a common factor; finite.
#[inline]
fn expected(n_f: u32, p_f: f32, n_g: u32, p_g: f32) -> (f32, f32) {
    let (f, g) = (density(n_f, p_f), density(n_g, p_g));
    let (f, g) = if f > f32::MAX || g > f32::MAX {
        // An infinite density outweighs every finite one; two are equal.
        let infinite = |p| if p > f32::MAX { 1.0 } else { 0.0 };
        (infinite(f), infinite(g))
    } else if f > LARGE || g > LARGE {
        // If this rounds the smaller one, its weight is below the smallest `f32` in any case.
        (f * ROOM, g * ROOM)
    } else {
        (f, g)
    };
    (n_f as f32 * f, n_g as f32 * g)
}

/// The weight of f, from a quotient of at most 1 that `shape` may sharpen.
#[inline]
fn weight((f, g): (f32, f32), shape: impl Fn(f32) -> f32) -> f32 {
    // Which of the two is larger is anybody's guess, so it is selected and not branched on.
    let first = f > g;
    let (least, most) = if first { (g, f) } else { (f, g) };
    if most > 0.0 {
        let quotient = shape(least / most);
        (if first { 1.0 } else { quotient }) / (1.0 + quotient)
    } else {
        0.0
    }
}

/// The balance heuristic of multiple importance sampling: the weight of a sample of technique f.
///
/// At the sample's point the techniques f and g have the densities `p_f` and `p_g`, and take `n_f` and `n_g` samples in
/// all. The weight is w = `n_f p_f`/(`n_f p_f` + `n_g p_g`), computed without overflow or underflow.
///
/// # Domain
///
/// Any numbers. A negative or NaN density counts as 0. An infinite density outweighs every finite one; two infinite ones
/// count as equal. The weight is in [0, 1]. The weights of f and g at a point sum to 1, up to rounding, if one of the
/// techniques has a positive density and count; otherwise both are 0.
///
/// # Accuracy
///
/// Error: 3 ulp for counts of 1, 7 ulp for any counts, which is proven: up to seven roundings. An ulp is a unit in the
/// last place; below 2⁻¹²⁶, it is the subnormal spacing.
///
/// # Examples
///
/// ```
/// use microwarp::estimate::balance_heuristic;
/// assert_eq!(balance_heuristic(1, 3.0, 1, 1.0), 0.75);
/// assert_eq!(balance_heuristic(1, 3e38, 3, 3e38), 0.25);
/// ```
///
/// Multiple importance sampling of ∫eˣ over [0, 1), with one sample of each technique. The two weighted contributions
/// estimate the integral together, so their sum is pushed, once, with density 1:
/// ```
/// use microwarp::{Warp, estimate::{Integral, balance_heuristic}, poly as mw};
/// use rand_pcg::Pcg32;
/// let (f, g) = (mw::Linear::new(1.0, 2.0)?, mw::Interval::new(0.0, 1.0)?);
/// let (mut rng, mut integral) = (Pcg32::new(42, 54), Integral::new());
/// for _ in 0..10_000 {
///     let (x, y) = (f.draw(&mut rng), g.draw(&mut rng));
///     let by_f = balance_heuristic(1, f.pdf(x), 1, g.pdf(x)) * x.exp() / f.pdf(x);
///     let by_g = balance_heuristic(1, g.pdf(y), 1, f.pdf(y)) * y.exp() / g.pdf(y);
///     integral.push(by_f + by_g, 1.0);
/// }
/// assert_eq!(integral.count(), 10_000);
/// assert!((integral.estimate().unwrap_or(0.0) - 1.718_281_8).abs() < 0.01);
/// # Ok::<(), microwarp::Error>(())
/// ```
/// The counts are those of one such sum: 1 and 1 here, although 10,000 sums follow. Only their ratio enters the weight.
/// With `n_f` samples of f and `n_g` of g a sum, divide each contribution of f by `n_f` and each of g by `n_g`. A
/// sample of density 0 contributes 0.
///
/// # See also
///
/// - [`power_heuristic`], which often has less variance.
/// - [`balance_heuristic_of`], for more than two techniques.
///
/// # Source
///
/// E. Veach, L. J. Guibas, "Optimally Combining Sampling Techniques for Monte Carlo Rendering", 1995,
/// [doi:10.1145/218380.218498](https://doi.org/10.1145/218380.218498).
#[doc(alias = "multiple_importance_sampling")]
#[must_use]
#[inline]
pub fn balance_heuristic(n_f: u32, p_f: f32, n_g: u32, p_g: f32) -> f32 {
    weight(expected(n_f, p_f, n_g, p_g), |quotient| quotient)
}

/// The power heuristic with exponent 2: [`balance_heuristic`] with the squares of `n_f p_f` and `n_g p_g`.
///
/// It favours the technique that samples the point better. Its domain is that of [`balance_heuristic`].
///
/// # Accuracy
///
/// Error: 5 ulp for counts of 1, 13 ulp for any counts, which is proven: up to thirteen roundings. An ulp is a unit in
/// the last place; below 2⁻¹²⁶, it is the subnormal spacing.
///
/// # Examples
///
/// ```
/// use microwarp::estimate::power_heuristic;
/// assert_eq!(power_heuristic(1, 3.0, 1, 1.0), 0.9);
/// assert_eq!(power_heuristic(1, 1e20, 1, 1e-25), 1.0);
/// ```
///
/// # See also
///
/// - [`balance_heuristic`], which is cheaper.
/// - [`power_heuristic_of`], for more than two techniques.
///
/// # Source
///
/// E. Veach, L. J. Guibas, "Optimally Combining Sampling Techniques for Monte Carlo Rendering", 1995,
/// [doi:10.1145/218380.218498](https://doi.org/10.1145/218380.218498).
#[doc(alias = "multiple_importance_sampling")]
#[must_use]
#[inline]
pub fn power_heuristic(n_f: u32, p_f: f32, n_g: u32, p_g: f32) -> f32 {
    weight(expected(n_f, p_f, n_g, p_g), |quotient| quotient * quotient)
}

/// The weight of a technique among several: its part of the sum of what `shape` makes of the expected numbers of samples.
/// They are scaled so that the largest density is near 2^`near`, from where no product leaves the range of `f32`.
#[inline]
fn weight_of(
    (counts, densities): (&[u32], &[f32]),
    own: usize,
    near: i32,
    shape: impl Fn(f32) -> f32,
) -> f32 {
    let techniques = || counts.iter().copied().zip(densities.iter().copied());
    let most = techniques().fold(0.0, |most: f32, (n, p)| {
        let p = density(n, p);
        if p > most { p } else { most }
    });
    let field = most.to_bits() >> 23;
    let up = near.wrapping_add(127).wrapping_sub_unsigned(field);
    let (first, second) = (
        power_of_two(up >> 1),
        power_of_two(up.wrapping_sub(up >> 1)),
    );
    let expected = |(n, p): (u32, f32)| {
        let p = density(n, p);
        let p = if most <= f32::MAX {
            p * first * second
        } else if p > f32::MAX {
            // An infinite density outweighs every finite one; several are equal.
            1.0
        } else {
            0.0
        };
        shape(n as f32 * p)
    };
    let sum = techniques().fold(0.0, |sum, technique| sum + expected(technique));
    match techniques().nth(own) {
        Some(own) if sum > 0.0 => expected(own) / sum,
        _ => 0.0,
    }
}

/// The balance heuristic of any number of techniques: the weight of a sample of the technique `own`.
///
/// A technique takes n = `counts[k]` samples, and draws the point of the sample with density p = `densities[k]`. The weight is
/// w = `n p`/∑ `n p`, computed without overflow or underflow.
///
/// # Domain
///
/// Any numbers, and as many techniques as both slices have, up to 2²⁴. A negative or NaN density counts as 0. An
/// infinite density outweighs every finite one; several count as equal. The weight is in [0, 1], and 0 of a technique
/// that there is not. The weights of all sum to 1, up to rounding, if one technique has a positive density and count;
/// otherwise all are 0.
///
/// # Accuracy
///
/// Error of N techniques: N ulp for counts of 1, N + 4 ulp for any counts, which is proven: as many
/// roundings. An ulp is a unit in the last place; below 2⁻¹²⁶, it is the subnormal spacing.
///
/// # Examples
///
/// ```
/// use microwarp::estimate::balance_heuristic_of;
/// // A lamp, a lobe and the sky, of which the last takes two samples.
/// let weights = [0, 1, 2].map(|own| balance_heuristic_of(&[1, 1, 2], &[3.0, 1.0, 2.0], own));
/// assert_eq!(weights, [0.375, 0.125, 0.5]);
/// assert_eq!(balance_heuristic_of(&[1, 1, 3], &[f32::NAN, f32::INFINITY, 1e38], 1), 1.0);
/// ```
///
/// # See also
///
/// - [`balance_heuristic`], of two techniques, which is cheaper.
/// - [`power_heuristic_of`], which often has less variance.
///
/// # Source
///
/// E. Veach, L. J. Guibas, "Optimally Combining Sampling Techniques for Monte Carlo Rendering", 1995,
/// [doi:10.1145/218380.218498](https://doi.org/10.1145/218380.218498).
#[doc(alias = "multiple_importance_sampling")]
#[must_use]
#[inline]
pub fn balance_heuristic_of(counts: &[u32], densities: &[f32], own: usize) -> f32 {
    weight_of((counts, densities), own, 60, |expected| expected)
}

/// The power heuristic with exponent 2 of any number of techniques: [`balance_heuristic_of`] with the squares of `n p`.
///
/// It favours the technique that samples the point best. Its domain is that of [`balance_heuristic_of`].
///
/// # Accuracy
///
/// Error of N techniques: N + 2 ulp for counts of 1, N + 10 ulp for any counts, which is proven: as many
/// roundings. An ulp is a unit in the last place; below 2⁻¹²⁶, it is the subnormal spacing.
///
/// # Examples
///
/// ```
/// use microwarp::estimate::power_heuristic_of;
/// assert_eq!(power_heuristic_of(&[1, 1, 2], &[3.0, 1.0, 1.0], 0), 9.0 / 14.0);
/// assert_eq!(power_heuristic_of(&[1, 1], &[1e20, 1e-25], 0), 1.0);
/// ```
///
/// # See also
///
/// - [`power_heuristic`], of two techniques.
///
/// # Source
///
/// E. Veach, L. J. Guibas, "Optimally Combining Sampling Techniques for Monte Carlo Rendering", 1995,
/// [doi:10.1145/218380.218498](https://doi.org/10.1145/218380.218498).
#[doc(alias = "multiple_importance_sampling")]
#[must_use]
#[inline]
pub fn power_heuristic_of(counts: &[u32], densities: &[f32], own: usize) -> f32 {
    weight_of((counts, densities), own, 16, |expected| expected * expected)
}
