//! Every function of a tier with the domains over which its errors are stated, and what is exact there.
//!
//! The truth is f64: the host's functions, and erf and erfc of the `libm` crate in f64 for the normal
//! distribution. Nothing of the tiers goes into it.

use crate::sweep::{Input, Sweep};
use microwarp::tier::{Libm, Poly, Tier};
use std::f64::consts::{FRAC_1_SQRT_2, FRAC_PI_2, PI, SQRT_2, TAU};

/// A function of two `f32`; one of a single argument ignores the second.
pub type Function = fn(f32, f32) -> f32;

/// One number that a tier works out, in both tiers.
pub struct Output {
    pub truth: fn(f64, f64) -> f64,
    pub tiers: [Function; 2],
}

/// A row of the tables: outputs measured together over a domain.
pub struct Case {
    pub function: &'static str,
    pub domain: &'static str,
    pub sweeps: Vec<Sweep>,
    /// Whether an input belongs to the domain.
    pub within: fn(Input) -> bool,
    pub outputs: Vec<Output>,
}

/// Sine and cosine by a reduction that is exact in f64.
fn sincos(t: f64) -> (f64, f64) {
    let quarters = 4.0 * t;
    let nearest = quarters.round();
    let (s, c) = ((quarters - nearest) * FRAC_PI_2).sin_cos();
    match nearest.rem_euclid(4.0) as u32 {
        0 => (s, c),
        1 => (c, -s),
        2 => (-s, -c),
        _ => (-c, s),
    }
}

fn normal_cdf(x: f64) -> f64 {
    0.5 * libm::erfc(-x * FRAC_1_SQRT_2)
}

/// By statrs' inverse error functions and one step of Newton's method on libm's error functions.
fn normal_quantile(p: f64) -> f64 {
    let q = 0.5 - p;
    let (z, miss) = if q < 0.25 {
        let z = SQRT_2 * statrs::function::erf::erf_inv(2.0 * q);
        (z, 0.5 * libm::erf(z * FRAC_1_SQRT_2) - q)
    } else {
        let z = SQRT_2 * statrs::function::erf::erfc_inv(2.0 * p);
        (z, p - normal_cdf(-z))
    };
    miss / ((-0.5 * z * z).exp() / TAU.sqrt()) - z
}

fn atan2(y: f64, x: f64) -> f64 {
    if x == 0.0 && y == 0.0 {
        0.0
    } else {
        y.atan2(x) / (2.0 * PI)
    }
}

/// The outputs of a row: for each, the truth and the function over a tier `T`.
macro_rules! outputs {
    ($($truth:expr => $function:expr),+) => {
        vec![$(Output {
            truth: $truth,
            tiers: [
                { type T = Libm; $function },
                { type T = Poly; $function },
            ],
        }),+]
    };
}

const TINY: f32 = 1.0e-45;

/// Magnitudes between two values, 2^23/509 of them in every binade.
fn between(from: f32, to: f32) -> Sweep {
    Sweep::Magnitudes {
        from,
        to,
        step: 509,
        sign: 1.0,
    }
}

fn negative(from: f32, to: f32) -> Sweep {
    Sweep::Magnitudes {
        from,
        to,
        step: 509,
        sign: -1.0,
    }
}

fn every(from: f32, to: f32, sign: f32) -> Sweep {
    Sweep::Magnitudes {
        from,
        to,
        step: 1,
        sign,
    }
}

macro_rules! case {
    ($function:literal, $domain:literal, $sweeps:expr, $within:expr, $($outputs:tt)+) => {
        Case {
            function: $function,
            domain: $domain,
            sweeps: $sweeps.to_vec(),
            within: $within,
            outputs: outputs!($($outputs)+),
        }
    };
}

pub fn cases() -> Vec<Case> {
    use Sweep::{Edges, Grid, Pairs, Powers};
    let all = [between(TINY, f32::MAX), negative(TINY, f32::MAX), Edges];
    // The largest errors of the exponentials are rare: here every argument is tried that has a result
    // of its own.
    let exponents = [
        all[0],
        all[1],
        Edges,
        every(0.0625, 105.0, 1.0),
        every(0.0625, 105.0, -1.0),
    ];
    vec![
        case!("sqrt", "x ≥ 0", [between(TINY, f32::MAX), Edges], |(x, _)| x >= 0.0,
            |x, _| x.sqrt() => |x, _| T::sqrt(x)),
        case!("sincos_turns", "0 ≤ t ≤ 1", [Grid(1.0)], |_| true,
            |t, _| sincos(t).0 => |t, _| T::sincos_turns(t).0,
            |t, _| sincos(t).1 => |t, _| T::sincos_turns(t).1),
        case!("sincos_turns", "finite t", all, |_| true,
            |t, _| sincos(t).0 => |t, _| T::sincos_turns(t).0,
            |t, _| sincos(t).1 => |t, _| T::sincos_turns(t).1),
        case!("polar, r = 1", "0 ≤ t ≤ 1", [Grid(1.0)], |_| true,
            |t, _| sincos(t).1 => |t, _| T::polar(1.0, t).0,
            |t, _| sincos(t).0 => |t, _| T::polar(1.0, t).1),
        case!("sin² + cos²", "0 ≤ t ≤ 1", [Grid(1.0)], |_| true,
        // Squared and summed in f64, and rounded only after 1 has been taken off.
        |_, _| 0.0 => |t, _| {
            let (s, c) = T::sincos_turns(t);
            let (s, c) = (f64::from(s), f64::from(c));
            (s * s + c * c - 1.0) as f32
        }),
        case!("atan2_turns", "finite x, y", [
                Pairs { x: [TINY, f32::MAX], y: [TINY, f32::MAX], count: 1 << 21 },
                Pairs { x: [1.0e-4, 1.0e4], y: [1.0e-4, 1.0e4], count: 1 << 22 },
                Pairs { x: [0.5, 2.0], y: [0.5, 2.0], count: 1 << 22 },
                Pairs { x: [TINY, 1.0e-43], y: [TINY, 1.0e-43], count: 1 << 16 },
                Pairs { x: [1.0e38, f32::MAX], y: [1.0e38, f32::MAX], count: 1 << 20 },
                Edges,
            ], |_| true,
            |x, y| atan2(y, x) => |x, y| T::atan2_turns(y, x)),
        case!("ln", "2⁻²⁴ ≤ x ≤ 1", [Grid(1.0)], |(x, _)| x > 0.0,
            |x, _| x.ln() => |x, _| T::ln(x)),
        case!("ln", "x > 0", [between(TINY, f32::MAX), Edges], |(x, _)| x > 0.0,
            |x, _| x.ln() => |x, _| T::ln(x)),
        case!("ln_1p", "-1 < x ≤ 0", [Grid(-1.0)], |(x, _)| x > -1.0,
            |x, _| x.ln_1p() => |x, _| T::ln_1p(x)),
        case!("ln_1p", "x > -1", all, |(x, _)| x > -1.0,
            |x, _| x.ln_1p() => |x, _| T::ln_1p(x)),
        case!("neg_ln_1m", "grid of [0, 1)", [Grid(1.0)], |(u, _)| u < 1.0,
            |u, _| -(-u).ln_1p() => |u, _| T::neg_ln_1m(u)),
        case!("neg_ln_1m", "0 ≤ u < 1", [between(TINY, 1.0), every(0.0625, 1.0, 1.0)], |(u, _)| u < 1.0,
            |u, _| -(-u).ln_1p() => |u, _| T::neg_ln_1m(u)),
        case!("exp_neg_pair", "0 ≤ x ≤ 1", [Grid(1.0)], |_| true,
            |x, _| (-x).exp() => |x, _| T::exp_neg_pair(x).0,
            |x, _| -(-x).exp_m1() => |x, _| T::exp_neg_pair(x).1),
        case!("exp_neg_pair", "0 ≤ x ≤ 87", [between(TINY, 87.0), every(0.0625, 17.0, 1.0)], |_| true,
            |x, _| (-x).exp() => |x, _| T::exp_neg_pair(x).0,
            |x, _| -(-x).exp_m1() => |x, _| T::exp_neg_pair(x).1),
        case!("exp", "-1 ≤ x ≤ 0", [Grid(-1.0)], |_| true,
            |x, _| x.exp() => |x, _| T::exp(x)),
        case!("exp", "finite x", exponents, |_| true,
            |x, _| x.exp() => |x, _| T::exp(x)),
        case!("exp_m1", "-1 ≤ x ≤ 0", [Grid(-1.0)], |_| true,
            |x, _| x.exp_m1() => |x, _| T::exp_m1(x)),
        case!("exp_m1", "finite x", exponents, |_| true,
            |x, _| x.exp_m1() => |x, _| T::exp_m1(x)),
        case!("pow", "0 ≤ x ≤ 1, y = 1/51", [Grid(1.0)], |_| true,
            |x, _| x.powf(f64::from(1.0_f32 / 51.0)) => |x, _| T::pow(x, 1.0 / 51.0)),
        case!("pow", "x ≥ 0, finite y", [
                Powers { x: [TINY, f32::MAX], count: 1 << 21 },
                Powers { x: [0.1, 10.0], count: 1 << 21 },
                Powers { x: [0.5, 2.0], count: 1 << 21 },
                Powers { x: [0.999, 1.001], count: 1 << 20 },
                Powers { x: [0.999_999, 1.000_001], count: 1 << 18 },
                Pairs { x: [TINY, f32::MAX], y: [TINY, f32::MAX], count: 1 << 20 },
                Pairs { x: [0.01, 100.0], y: [0.01, 30.0], count: 1 << 21 },
                Edges,
            ], |(x, _)| x >= 0.0,
            |x, y| x.abs().powf(y) => |x, y| T::pow(x, y)),
        case!("normal_cdf_lower", "x ≤ 0", [negative(TINY, 20.0), Grid(-1.0)], |_| true,
            |x, _| normal_cdf(x) => |x, _| T::normal_cdf_lower(x)),
        case!("normal_quantile_lower", "2⁻²⁴ ≤ p ≤ 1/2", [Grid(0.5)], |(p, _)| p > 0.0,
            |p, _| normal_quantile(p) => |p, _| T::normal_quantile_lower(p)),
        case!("normal_quantile_lower", "0 < p ≤ 1/2", [between(TINY, 0.5)], |_| true,
            |p, _| normal_quantile(p) => |p, _| T::normal_quantile_lower(p)),
    ]
}
