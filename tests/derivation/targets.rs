//! What is fitted: the functions behind every constant, where, in how many terms, and with which weight.

use std::f64::consts::{FRAC_1_SQRT_2, LN_2, SQRT_2, TAU};

/// A value to be met at x; the weight turns an error there into the error that counts.
pub struct Point {
    pub x: f64,
    pub value: f64,
    pub weight: f64,
}

/// A polynomial in x with this many terms.
pub struct Polynomial {
    pub name: &'static str,
    pub interval: [f64; 2],
    pub terms: usize,
    pub target: fn(f64) -> Point,
}

/// A quotient of polynomials in x; the denominator begins with 1, which is not among the constants.
pub struct Rational {
    pub names: [&'static str; 2],
    pub interval: [f64; 2],
    /// Terms of the numerator.
    pub numerator: usize,
    /// Terms of the denominator after the 1.
    pub denominator: usize,
    /// The first term of the numerator, where it is given.
    pub first: Option<f32>,
    /// The interval's parameter need not be x.
    pub target: fn(f64) -> Point,
}

/// A number in one or two parts, the first of so many bits.
pub struct Split {
    pub name: &'static str,
    pub value: f64,
    pub bits: u32,
    pub parts: usize,
}

/// A power series, summed backwards.
pub fn series(x: f64, coefficient: impl Fn(f64) -> f64) -> f64 {
    (0..40)
        .rev()
        .fold(0.0, |sum, j| sum * x + coefficient(f64::from(j)))
}

/// A series whose coefficients are the running products of a ratio.
pub fn factorial_series(x: f64, first: f64, ratio: impl Fn(f64) -> f64) -> f64 {
    let mut term = first;
    let mut sum = first;
    for j in 1..40 {
        term *= x * ratio(f64::from(j));
        sum += term;
    }
    sum
}

/// By how much sine and cosine are drawn towards 0, at an eighth of a turn where their roundings add up, so that
/// the points of the largest radius stay within the disk whichever way they are rounded.
const DRAWN_IN: f64 = 5.0e-9;

/// sin(2πr)/r over s = r², absolute in the sine: the nearest f32 to 2π is off by 2.8e-8 of itself, which the
/// other terms make up for where the sine is large.
fn sine(s: f64) -> Point {
    let value = factorial_series(s, TAU, |j| -TAU * TAU / (2.0 * j * (2.0 * j + 1.0)));
    Point {
        x: s,
        value: value - DRAWN_IN * 64.0 * s * TAU,
        weight: s.sqrt(),
    }
}

/// (cos(2πr) - 1)/s over s = r², absolute in the cosine.
fn cosine(s: f64) -> Point {
    let value = factorial_series(s, -0.5 * TAU * TAU, |j| {
        -TAU * TAU / ((2.0 * j + 1.0) * (2.0 * j + 2.0))
    });
    Point {
        x: s,
        value: value - DRAWN_IN * 64.0 * 64.0 * s,
        weight: s,
    }
}

/// atan(z)/(2πz) - 1/8 over s = z², relative to the angle.
fn angle(s: f64) -> Point {
    let quotient = series(-s, |j| 1.0 / (2.0 * j + 1.0)) / TAU;
    Point {
        x: s,
        value: quotient - 0.125,
        weight: 1.0 / quotient,
    }
}

/// (2 artanh(s) - 2s)/s³ over w = s², relative to the logarithm.
fn logarithm(w: f64) -> Point {
    let value = series(w, |j| 2.0 / (2.0 * j + 3.0));
    Point {
        x: w,
        value,
        weight: w / (2.0 + w * value),
    }
}

/// (3 artanh(s)/s - 3 - w)/w² over w = s², relative to the logarithm.
fn long_logarithm(w: f64) -> Point {
    let value = series(w, |j| 3.0 / (2.0 * j + 5.0));
    Point {
        x: w,
        value,
        weight: w * w / (3.0 + w + w * w * value),
    }
}

/// (e^r - 1 - r)/r² over r, relative to e^r.
fn exponential(r: f64) -> Point {
    let value = factorial_series(r, 0.5, |j| 1.0 / (j + 2.0));
    Point {
        x: r,
        value,
        weight: r * r / (1.0 + r + r * r * value),
    }
}

/// 1/(e^(t²/2) Φ(-t)) - √(2π) t, which falls from 2 to 0, relative to the quotient.
fn mills(t: f64) -> Point {
    let quotient = 2.0 / (libm::exp(0.5 * t * t) * libm::erfc(t * FRAC_1_SQRT_2));
    Point {
        x: t,
        value: quotient - f64::from(TAU.sqrt() as f32) * t,
        weight: 1.0 / quotient,
    }
}

/// z/q - 5/2 over q², where q is the probability between the normal quantile z and the median.
fn central_quantile(z: f64) -> Point {
    let quotient = if z > 0.0 {
        z / (0.5 * libm::erf(z * FRAC_1_SQRT_2))
    } else {
        TAU.sqrt()
    };
    let q = z / quotient;
    Point {
        x: q * q,
        value: quotient - 2.5,
        weight: 1.0 / quotient,
    }
}

/// 3r/2 - 1 - z over r = √(-ln p), where p is the probability below the normal quantile -z; relative to z.
fn tail_quantile(z: f64) -> Point {
    let p = 0.5 * libm::erfc(z * FRAC_1_SQRT_2);
    let r = (-libm::log(p)).sqrt();
    Point {
        x: r,
        value: 1.5 * r - 1.0 - z,
        weight: 1.0 / z,
    }
}

pub fn polynomials() -> Vec<Polynomial> {
    // Arguments stay below these up to rounding: tan(π/8) = √2 - 1, (3/2 - 1)/(3/2 + 1), (√2 - 1)/(√2 + 1),
    // ln(2)/2.
    let tangent: f64 = 0.41422;
    let artanh: f64 = 0.20001;
    let long_artanh: f64 = 0.17158;
    let half = 0.347;
    let fit = |name, interval, terms, target| Polynomial {
        name,
        interval,
        terms,
        target,
    };
    vec![
        fit("SINE", [0.0, 1.0 / 64.0], 4, sine),
        fit("COSINE", [0.0, 1.0 / 64.0], 4, cosine),
        fit("ANGLE", [0.0, tangent.powi(2)], 5, angle),
        fit("LOGARITHM", [0.0, artanh.powi(2)], 3, logarithm),
        fit(
            "LONG_LOGARITHM",
            [0.0, long_artanh.powi(2)],
            3,
            long_logarithm,
        ),
        fit("EXPONENTIAL", [-half, half], 5, exponential),
    ]
}

pub fn rationals() -> Vec<Rational> {
    // The quantile changes forms at p = 1/8, where z is just above 1.15.
    vec![
        Rational {
            names: ["MILLS", "MILLS_OVER"],
            interval: [0.0, 15.0],
            numerator: 5,
            denominator: 4,
            first: Some(2.0),
            target: mills,
        },
        Rational {
            names: ["CENTRAL", "CENTRAL_OVER"],
            interval: [0.0, 1.1504],
            numerator: 5,
            denominator: 2,
            first: None,
            target: central_quantile,
        },
        Rational {
            names: ["TAIL", "TAIL_OVER"],
            interval: [1.1503, 14.2],
            numerator: 5,
            denominator: 3,
            first: None,
            target: tail_quantile,
        },
    ]
}

pub fn splits() -> Vec<Split> {
    let split = |name, value, bits, parts| Split {
        name,
        value,
        bits,
        parts,
    };
    vec![
        // Heads of 12 bits, whose products are exact.
        split("LN_2", LN_2, 12, 2),
        split("TO_LOG2", 2.0 / (3.0 * LN_2), 12, 2),
        split("SQRT_TAU", TAU.sqrt(), 24, 1),
        split("TAN_SIXTEENTH_TURN", SQRT_2 - 1.0, 24, 1),
    ]
}
