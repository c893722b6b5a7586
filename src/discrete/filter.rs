//! Pixel filters, as their values at N equally spaced points: the vertices of a [`SignedLinear1d`](super::SignedLinear1d).
//!
//! The points go from one end of a filter to the other, so that an odd N has one in the middle. The radius is for the caller to say:
//! Mitchell's filter is made for 2 pixels, Lanczos' for as many pixels as it has lobes, the others for 1.5 to 2. Between the points a
//! filter is a straight line, which is off by at most f″/8 times the square of their distance.
//!
//! | filter | S = ∫\|f\|/∫f | variance of the weights in a square, S⁴ − 1 |
//! |---|--:|--:|
//! | [`gaussian`], [`blackman_harris`] | 1 | 0 |
//! | [`mitchell`] of ⅓ and ⅓ | 1.0700 | 0.31 |
//! | [`lanczos`] of 3 lobes | 1.3584 | 2.4 |
//!
//! ```
//! use microwarp::discrete::{SignedLinear1d, filter};
//! use microwarp::constant;
//! const SHARP: SignedLinear1d<65> = constant!(SignedLinear1d::new(&filter::lanczos(3), -3.0, 3.0));
//! const SOFT: SignedLinear1d<33> = constant!(SignedLinear1d::new(&filter::gaussian(1.0 / 3.0), -1.5, 1.5));
//! assert!((SHARP.weight(0.1) - 1.358).abs() < 2e-3);
//! assert!((SHARP.weight(1.5) + 1.358).abs() < 2e-3);
//! assert!((SOFT.weight(1.2) - 1.0).abs() < 1e-6);
//! ```

use crate::num::nearest_integer;
use crate::tier::exp2_pair;
use core::f32::consts::{LOG2_E, PI};

/// An array of the values of an expression of t, which goes from -1 to 1.
macro_rules! vertices {
    ($t:ident => $value:expr) => {{
        let mut vertices = [0.0; N];
        let mut rest: &mut [f32] = &mut vertices;
        let last = N.wrapping_sub(1) as f32;
        while let [first, others @ ..] = rest {
            // Of both sides alike.
            let $t = (last - 2.0 * others.len() as f32) / last;
            *first = $value;
            rest = others;
        }
        vertices
    }};
}

/// A normal density less its value at the ends, of a standard deviation in units of the radius.
///
/// Far beyond the ends of a small deviation it is 0; what is not a positive number makes vertices that no table takes.
#[must_use]
pub const fn gaussian<const N: usize>(deviation: f32) -> [f32; N] {
    let rate = 0.5 / (deviation * deviation);
    let end = exp_neg(rate);
    vertices!(t => exp_neg(rate * t * t) - end)
}

/// The window of F. J. Harris with four terms: "On the use of windows for harmonic analysis", 1978,
/// <https://doi.org/10.1109/PROC.1978.10837>.
#[must_use]
pub const fn blackman_harris<const N: usize>() -> [f32; N] {
    vertices!(t => 0.358_75
        + 0.488_29 * sin_pi(t + 0.5)
        + 0.141_28 * sin_pi(2.0 * t + 0.5)
        + 0.011_68 * sin_pi(3.0 * t + 0.5))
}

/// The cubic filter of D. P. Mitchell and A. N. Netravali, who advise ⅓ for both: "Reconstruction Filters in Computer Graphics", 1988,
/// <https://doi.org/10.1145/54852.378514>.
#[must_use]
pub const fn mitchell<const N: usize>(b: f32, c: f32) -> [f32; N] {
    vertices!(t => {
        let x = 2.0 * t.abs();
        let rest = 2.0 - x;
        let six = if x < 1.0 {
            x * x * ((12.0 - 9.0 * b - 6.0 * c) * x + (12.0 * b + 6.0 * c - 18.0)) + (6.0 - 2.0 * b)
        } else {
            rest * rest * (b * rest + 6.0 * c * (1.0 - x))
        };
        six / 6.0
    })
}

/// sinc(kt)·sinc(t), sinc t = sin πt/(πt), of k lobes on each side: C. Lanczos' window over the ideal filter. K. Turkowski, "Filters
/// for Common Resampling Tasks", 1990, advises 2 or 3.
#[must_use]
pub const fn lanczos<const N: usize>(lobes: u16) -> [f32; N] {
    vertices!(t => sinc(lobes as f32 * t) * sinc(t))
}

/// sin πx/(πx).
const fn sinc(x: f32) -> f32 {
    if x == 0.0 { 1.0 } else { sin_pi(x) / (PI * x) }
}

/// sin πx, to some 1e-7; for |x| up to 2²².
const fn sin_pi(x: f32) -> f32 {
    let (whole, number) = nearest_integer(x);
    let y = PI * (x - whole);
    let z = y * y;
    // Taylor's series on [-π/2, π/2].
    let tail = 1.0 / 362_880.0 - z * (1.0 / 39_916_800.0 - z / 6_227_020_800.0);
    let sine = y - y * z * (1.0 / 6.0 - z * (1.0 / 120.0 - z * (1.0 / 5040.0 - z * tail)));
    if number & 1 == 0 { sine } else { -sine }
}

/// e^-x of a number from 0 up; 0 from 60 on.
const fn exp_neg(x: f32) -> f32 {
    if x > 60.0 {
        0.0
    } else {
        exp2_pair(-x * LOG2_E, 0.0).0
    }
}
