//! What the integer constants of the integer tier are: fitted polynomials and numbers, where each stands, and in which
//! Q format.

use crate::targets::{Point, factorial_series, series};
use std::f64::consts::{FRAC_1_PI, FRAC_1_SQRT_2, FRAC_PI_4, LN_2, LOG2_E, PI, SQRT_2};

/// A polynomial in x with as many terms as there are places for.
pub struct Fit {
    pub file: &'static str,
    pub before: &'static str,
    pub terms: usize,
    /// Fraction bits.
    pub bits: u32,
    pub interval: [f64; 2],
    pub target: fn(f64) -> Point,
}

/// sin(πr/4)/r over s = r², absolute in the sine; signs alternate.
fn sine(s: f64) -> Point {
    let squared = FRAC_PI_4 * FRAC_PI_4;
    Point {
        x: -s,
        value: factorial_series(s, FRAC_PI_4, |j| -squared / (2.0 * j * (2.0 * j + 1.0))),
        weight: s.sqrt(),
    }
}

/// (1 − cos(πr/4))/s over s = r², absolute in the cosine; signs alternate.
fn cosine(s: f64) -> Point {
    let squared = FRAC_PI_4 * FRAC_PI_4;
    let ratio = |j| -squared / ((2.0 * j + 1.0) * (2.0 * j + 2.0));
    Point {
        x: -s,
        value: factorial_series(s, 0.5 * squared, ratio),
        weight: s,
    }
}

/// −ln(1 − v)/v, absolute in the logarithm.
fn logarithm(v: f64) -> Point {
    Point {
        x: v,
        value: series(v, |j| 1.0 / (j + 1.0)),
        weight: v,
    }
}

/// (1 − 2^−f)/f, absolute in the power; signs alternate.
fn power_of_2(f: f64) -> Point {
    Point {
        x: -f,
        value: factorial_series(f, LN_2, |j| -LN_2 / (j + 1.0)),
        weight: f,
    }
}

/// 1/√m, relative; signs alternate.
fn inverse_root(m: f64) -> Point {
    Point {
        x: -m,
        value: 1.0 / m.sqrt(),
        weight: m.sqrt(),
    }
}

const SINE: &str = "kernel/sine.rs";
const LOG: &str = "kernel/log.rs";
const EXP: &str = "kernel/exp.rs";

pub fn fits() -> [Fit; 5] {
    let fit = |file, before, terms, bits, interval, target| Fit {
        file,
        before,
        terms,
        bits,
        interval,
        target,
    };
    let (unit, below_root) = ([0.0, 1.0], [0.0, 1.0 - FRAC_1_SQRT_2]);
    [
        fit(SINE, "const SINE_QUOTIENT: [u32; 3] = [", 3, 32, unit, sine),
        fit(
            SINE,
            "const COSINE_QUOTIENT: [u32; 3] = [",
            3,
            32,
            unit,
            cosine,
        ),
        fit(
            LOG,
            "const LOG_QUOTIENT: [u32; 5] = [",
            5,
            31,
            below_root,
            logarithm,
        ),
        fit(
            EXP,
            "const POWER_OF_2: [u32; 5] = [",
            5,
            32,
            unit,
            power_of_2,
        ),
        fit(
            "kernel/root.rs",
            "const INVERSE_ROOT: [u32; 3] = [",
            3,
            14,
            [0.25, 1.0],
            inverse_root,
        ),
    ]
}

/// Numbers as such.
pub struct Number {
    pub file: &'static str,
    /// What stands before it.
    pub before: &'static str,
    pub values: Vec<f64>,
    /// Fraction bits.
    pub bits: u32,
}

/// 1/k! from k = 2 on.
fn factorials() -> Vec<f64> {
    let products = (2..14).scan(1.0, |product, k| {
        *product /= f64::from(k);
        Some(*product)
    });
    products.collect()
}

/// The coefficients of sin²x/x² in powers of x² after the leading 1, without their signs: 2^(2k−1)/(2k)! from k = 2 on.
fn squared_sine() -> Vec<f64> {
    let terms = (2..9).scan(1.0, |term, k| {
        let k = f64::from(k);
        *term *= 4.0 / (2.0 * k * (2.0 * k - 1.0));
        Some(*term)
    });
    terms.collect()
}

/// The coefficients of 1 − sin y/y in powers of y²/5, without their signs: 5^k/(2k + 1)! from k = 1 on.
fn sine_of_fifths() -> Vec<f64> {
    let terms = (1..9).scan(1.0, |term, k| {
        let k = f64::from(k);
        *term *= 5.0 / (2.0 * k * (2.0 * k + 1.0));
        Some(*term)
    });
    terms.collect()
}

/// The share of the points of a grid of 2¹⁶ × 2¹⁶, none of them on an axis, that lie in the disk.
fn share_of_grid() -> f64 {
    let inside = |x: u64| {
        let half = ((1 << 32) - x * x).isqrt();
        half.div_ceil(2)
    };
    let quarter: u64 = (0..1 << 15).map(|i| inside(2 * i + 1)).sum();
    quarter as f64 * 2_f64.powi(-30)
}

pub fn numbers() -> Vec<Number> {
    let list = |file, before, values, bits| Number {
        file,
        before,
        values,
        bits,
    };
    let one = |file, before, value, bits| list(file, before, vec![value], bits);
    let density = "const DENSITY: Density = Density::from_bits(";
    let per_angle = "const PER_ANGLE: Scaled = Scaled::normal(";
    // The cubic term of the sine, a³/6, is best met over half a cell by what is left of a (1 − h²/8).
    let half_cell = PI / 256.0;
    let cell = 2.0 * half_cell * (1.0 - half_cell * half_cell / 8.0);
    // The largest number of words of which 22.19, or 6.67, times as many are words still.
    let words = 2_f64.powi(32);
    let largest = (words / 22.19).floor() / words;
    let widest = (words / 6.67).floor() / words;
    vec![
        one(SINE, "const RADIANS: i32 = ", cell, 20),
        one(LOG, "const ROOT_2: u32 = ", SQRT_2 - 1.0, 32),
        one(LOG, "(((head * head) >> 16) * ", 1.0 / 3.0, 8),
        list(
            LOG,
            "const TERMS: [u32; 5] = [",
            (3..8).map(|k| 1.0 / f64::from(k)).collect(),
            16,
        ),
        list("cone.rs", "const SQUARE: [u32; 7] = [", squared_sine(), 32),
        one("cone.rs", "const PI: u64 = ", PI, 32),
        one(EXP, "const CELLS: u32 = ", 32.0 / LN_2, 10),
        one(EXP, "const LOG2_E: u32 = ", LOG2_E - 1.0, 32),
        one(EXP, "const LN_2: u32 = ", LN_2, 16),
        one(EXP, "let third = (head * ", 1.0 / 6.0, 16),
        one("disk.rs", density, FRAC_1_PI, 32),
        one("sphere.rs", density, FRAC_1_PI / 4.0, 32),
        one("hemisphere.rs", density, FRAC_1_PI / 2.0, 32),
        one("hemisphere.rs", "const PER_COSINE: u32 = ", FRAC_1_PI, 32),
        one("rotation.rs", density, FRAC_1_PI * FRAC_1_PI, 32),
        one(
            "regular_polygon.rs",
            "const SQUARE: u32 = ",
            0.8 * PI * PI,
            29,
        ),
        list(
            "regular_polygon.rs",
            "const TERMS: [u32; 8] = [",
            sine_of_fifths(),
            32,
        ),
        one("direction.rs", per_angle, FRAC_1_PI / 2.0, 32),
        one(
            "multivariate_normal/law.rs",
            "const PER_ROOT_TAU: Scaled = Scaled::normal(",
            (FRAC_1_PI / 2.0).sqrt(),
            32,
        ),
        one(
            "multivariate_normal/law.rs",
            "const SQUARE: u64 = ",
            6.67 * 6.67,
            16,
        ),
        one("exponential.rs", "const LARGEST: u32 = ", largest, 32),
        one("rayleigh.rs", "const LARGEST: u32 = ", widest, 32),
        one("truncated.rs", "const LN_2: u64 = ", LN_2, 32),
        list(
            "truncated.rs",
            "const FACTORIALS: [u32; 12] = [",
            factorials(),
            32,
        ),
        one(
            "rejection.rs",
            "pub const EFFICIENCY: U0F32 = U0F32::from_bits(",
            share_of_grid(),
            32,
        ),
    ]
}
