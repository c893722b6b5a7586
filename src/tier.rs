//! The tiers: the elementary functions that a warp is built on.
//!
//! A program chooses a tier once, by type. [`Poly`] is for microcontrollers and WASM; [`Libm`] is the reference. Angles
//! are in turns (one turn is 2π radians), because a turn reduces exactly.

mod compensated;
mod libm;
mod normal;
mod poly;
mod power;
mod quantile;
mod sqrt;
mod table;
mod turns;

pub(crate) use self::compensated::{
    LN_2, LOG2_E, coin_series, exp_m1_of_product, exp_of_product, exp2_m1, ln_ratio,
    one_minus_cos_radians, scaled_exp, scaled_exp_of_product,
};
pub use self::libm::Libm;
pub(crate) use self::normal::{density_of_tail, hazard_above};
pub use self::poly::Poly;
pub(crate) use self::power::{exp2, exp2_neg_pair, exp2_pair, log2_1p, log2_of_sum, times};
pub(crate) use self::quantile::{
    normal_quantile, normal_quantile_of_word, normal_quantiles_of_word,
};
pub(crate) use self::sqrt::sqrt;
pub(crate) use self::table::{
    log2, neg_log2_1m, neg_log2_1m_of_word, neg_log2_1m_of_word_ahead, times_exp2,
};
pub(crate) use self::turns::exchanged;

mod sealed {
    pub trait Sealed {
        /// Whether a compiler can vectorise its functions.
        const VECTORS: bool;

        /// Whether distributions take their quick form by tables where a slower one has more digits.
        const TABLES: bool;

        /// `(sin(2πr), cos(2πr))` for `|r| <= 1/8`.
        fn sincos_quarter(r: f32) -> (f32, f32);

        /// [`Tier::neg_ln_1m`](super::Tier::neg_ln_1m) of the uniform of the grid that a word stands for: quicker one by one,
        /// but not vectorised.
        fn neg_ln_1m_of_word(word: u32) -> f32;
    }
}

/// Elementary functions over `f32`, with the errors that each tier states.
///
/// The trait is sealed: only [`Libm`] and [`Poly`] implement it. Each function returns for every `f32`, without a panic.
/// Inside the stated domain the result is within the error that the tier's page states.
///
/// # Examples
/// ```
/// use microwarp::tier::{Poly, Tier};
/// assert_eq!(Poly::sincos_turns(0.25), (1.0, 0.0)); // exact at quarter turns
/// assert!((Poly::ln(2.0) - core::f32::consts::LN_2).abs() < 1e-7);
/// ```
///
/// # See also
/// - [`poly`](crate::poly), [`libm`](crate::libm): every warp in one tier.
/// - `fixed`, a feature: the tier for cores without a floating-point unit.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a tier of floating-point functions",
    note = "the tiers are `microwarp::tier::Poly` and `microwarp::tier::Libm`; `microwarp::poly` and `microwarp::libm` name every warp in one of them"
)]
pub trait Tier:
    sealed::Sealed + Copy + Default + core::fmt::Debug + PartialEq + Send + Sync + 'static
{
    /// The name of the tier in tables: `"libm"` or `"poly"`.
    const NAME: &'static str;

    /// The square root of `x >= 0`, correctly rounded in both tiers; NaN below 0.
    #[must_use]
    #[inline]
    fn sqrt(x: f32) -> f32 {
        sqrt(x)
    }

    /// `(sin(2πt), cos(2πt))` of a phase `t` in turns.
    ///
    /// The reduction to a quadrant is exact, so quarter turns give exactly 0 and ±1. A phase that is not finite counts as
    /// a whole number of turns.
    #[must_use]
    fn sincos_turns(t: f32) -> (f32, f32);

    /// The point at a radius and an angle in turns, `(r cos 2πt, r sin 2πt)`, for fewer than 2²⁰ turns
    /// either way.
    ///
    /// The reduction to a quadrant is exact. Outside that range, and for NaN, the result is unspecified.
    #[must_use]
    fn polar(radius: f32, turn: f32) -> (f32, f32);

    /// The angle of the point `(x, y)` in turns, in `[-1/2, 1/2]`; 0 at the origin and for NaN.
    ///
    /// Its sign is that of `y`, down to the sign of a zero. An infinite coordinate counts as the largest
    /// finite one, so the axes and the diagonals are exact however far out.
    #[must_use]
    fn atan2_turns(y: f32, x: f32) -> f32;

    /// The natural logarithm of `x > 0`; `-∞` at 0, NaN below.
    #[must_use]
    fn ln(x: f32) -> f32;

    /// `ln(1 + x)` for `x > -1`, accurate where `x` is small; `-∞` at -1, NaN below.
    #[must_use]
    fn ln_1p(x: f32) -> f32;

    /// `-ln(1 - u)` of a uniform in `[0, 1)`, accurate where u is small; unspecified outside.
    #[must_use]
    fn neg_ln_1m(u: f32) -> f32;

    /// `(e^-x, 1 - e^-x)` for `0 <= x <= 87`, both accurate where they are small; unspecified outside.
    #[must_use]
    fn exp_neg_pair(x: f32) -> (f32, f32);

    /// `e^x`; 0 below the smallest subnormal, infinite past the largest finite value.
    #[must_use]
    fn exp(x: f32) -> f32;

    /// `e^x - 1`, accurate where `x` is small.
    #[must_use]
    fn exp_m1(x: f32) -> f32;

    /// `x^y` for `x >= 0`; unspecified below, where it may be NaN.
    ///
    /// `x^0` and `1^y` are always 1. Other powers of 0 and infinity are 0 or infinite.
    #[must_use]
    fn pow(x: f32, y: f32) -> f32;

    /// The cumulative distribution function of the standard normal at `x <= 0`, the lower tail.
    ///
    /// Arguments above 0, and NaN, count as 0, where the function is exactly 1/2.
    #[must_use]
    fn normal_cdf_lower(x: f32) -> f32;

    /// The standard normal quantile of a lower-tail probability `p` in `(0, 1/2]`; at most 0.
    ///
    /// Probabilities of 0 or less count as the smallest subnormal. Those above 1/2, and NaN, count as 1/2, where the
    /// quantile is exactly 0.
    #[must_use]
    fn normal_quantile_lower(p: f32) -> f32;
}
