//! Weights that combine two sampling techniques into one estimate.

/// 2⁹⁴; past it, a density times a count could overflow.
const LARGE: f32 = f32::from_bits((127 + 94) << 23);
/// 2⁻³³, which makes room for a count.
const ROOM: f32 = f32::from_bits((127 - 33) << 23);

/// What is no density counts as 0, and so does that of a technique not used.
#[inline]
fn density(n: u32, p: f32) -> f32 {
    if n > 0 && p > 0.0 { p } else { 0.0 }
}

/// The expected numbers of samples at the point, from both techniques, but for a common factor; finite.
#[inline]
fn expected(n_f: u32, p_f: f32, n_g: u32, p_g: f32) -> (f32, f32) {
    let (f, g) = (density(n_f, p_f), density(n_g, p_g));
    let (f, g) = if f > f32::MAX || g > f32::MAX {
        // An infinite density outweighs every finite one, and two are alike.
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
    if f > g {
        1.0 / (1.0 + shape(g / f))
    } else if g > 0.0 {
        let quotient = shape(f / g);
        quotient / (1.0 + quotient)
    } else {
        0.0
    }
}

/// The balance heuristic: the weight of a sample of technique f at a point which techniques f and g sample
/// with densities `p_f` and `p_g`, taking `n_f` and `n_g` samples in all.
///
/// w = `n_f p_f`/(`n_f p_f` + `n_g p_g`), without overflow or underflow on the way.
///
/// - Domain: any. A negative or NaN density counts as 0. An infinite one outweighs every finite one; two
///   count as equal.
/// - Range: [0, 1]. The weights of f and of g at a point sum to 1, but for rounding, wherever one of
///   the densities is positive (and its count); where neither is, both are 0.
/// - Error: 2.7 ulp for counts of 1, 4.3 ulp for any counts; below 2⁻¹²⁶, in subnormal spacings.
///
/// Source: E. Veach, L. J. Guibas, "Optimally Combining Sampling Techniques for Monte Carlo Rendering",
/// 1995.
///
/// ```
/// use microwarp::estimate::balance_heuristic;
/// assert_eq!(balance_heuristic(1, 3.0, 1, 1.0), 0.75);
/// assert_eq!(balance_heuristic(1, 3e38, 3, 3e38), 0.25);
/// ```
#[must_use]
#[inline]
pub fn balance_heuristic(n_f: u32, p_f: f32, n_g: u32, p_g: f32) -> f32 {
    weight(expected(n_f, p_f, n_g, p_g), |quotient| quotient)
}

/// The power heuristic with exponent 2: as [`balance_heuristic`], but with the squares of `n_f p_f` and
/// `n_g p_g`, which favours the technique that samples the point better.
///
/// Domain and range are those of [`balance_heuristic`].
///
/// - Error: 4.6 ulp for counts of 1, 7.2 ulp for any counts; below 2⁻¹²⁶, in subnormal spacings.
///
/// Source: E. Veach, L. J. Guibas, "Optimally Combining Sampling Techniques for Monte Carlo Rendering",
/// 1995.
///
/// ```
/// use microwarp::estimate::power_heuristic;
/// assert_eq!(power_heuristic(1, 3.0, 1, 1.0), 0.9);
/// assert_eq!(power_heuristic(1, 1e20, 1, 1e-25), 1.0);
/// ```
#[must_use]
#[inline]
pub fn power_heuristic(n_f: u32, p_f: f32, n_g: u32, p_g: f32) -> f32 {
    weight(expected(n_f, p_f, n_g, p_g), |quotient| quotient * quotient)
}
