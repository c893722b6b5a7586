//! Positive numbers as exact fractions, and how far an `f32` is off one.

use super::enumeration::rounded;
use num_bigint::BigUint;

/// numerator/denominator 2^exponent.
#[derive(Clone)]
pub struct Fraction {
    numerator: BigUint,
    denominator: BigUint,
    exponent: i64,
}

/// A positive finite number as integer and exponent.
fn parts(x: f32) -> (u32, i64) {
    let (field, fraction) = (x.to_bits() >> 23, x.to_bits() & 0x7f_ffff);
    assert!(x > 0.0 && field < 255);
    match field {
        0 => (fraction, -149),
        _ => (fraction | 0x80_0000, i64::from(field) - 150),
    }
}

impl Fraction {
    pub fn of(x: f32) -> Self {
        let (integer, exponent) = parts(x);
        Self {
            numerator: integer.into(),
            denominator: BigUint::from(1_u32),
            exponent,
        }
    }

    pub fn of_count(count: u128) -> Self {
        Self {
            numerator: count.into(),
            denominator: BigUint::from(1_u32),
            exponent: 0,
        }
    }

    pub fn times(&self, other: &Self) -> Self {
        Self {
            numerator: &self.numerator * &other.numerator,
            denominator: &self.denominator * &other.denominator,
            exponent: self.exponent + other.exponent,
        }
    }

    pub fn over(&self, other: &Self) -> Self {
        Self {
            numerator: &self.numerator * &other.denominator,
            denominator: &self.denominator * &other.numerator,
            exponent: self.exponent - other.exponent,
        }
    }

    /// Numerator and denominator in units of 2^unit.
    fn in_units(&self, unit: i64) -> (BigUint, BigUint) {
        let shift = self.exponent - unit;
        let by = shift.unsigned_abs();
        match shift {
            0.. => (&self.numerator << by, self.denominator.clone()),
            _ => (self.numerator.clone(), &self.denominator << by),
        }
    }

    /// The exponent of the leading bit.
    fn log2(&self) -> i64 {
        let guess = self.numerator.bits() as i64 - self.denominator.bits() as i64 + self.exponent;
        let (numerator, denominator) = self.in_units(guess);
        if numerator >= denominator {
            guess
        } else {
            guess - 1
        }
    }

    /// At most 1.
    pub fn capped(self) -> Self {
        if self.log2() >= 0 {
            Self::of(1.0)
        } else {
            self
        }
    }

    /// How far `got`, 0 or positive, is off in ulp of this: the spacing of `f32` here, and that of the
    /// subnormals below them.
    pub fn ulps(&self, got: f32) -> f64 {
        let ulp = self.log2().max(-126) - 23;
        let (numerator, denominator) = self.in_units(ulp);
        let got = match got {
            0.0 => (BigUint::ZERO, BigUint::from(1_u32)),
            _ => Self::of(got).in_units(ulp),
        };
        let (mine, its) = (numerator * &got.1, got.0 * &denominator);
        let off = if mine > its { mine - its } else { its - mine };
        // In units of 2^-64, so that what is rounded is an integer.
        rounded(&((off << 64_u32) / (denominator * got.1))) * 2_f64.powi(-64)
    }
}

#[test]
fn errors_in_ulp_are_exact() {
    let third = Fraction::of(1.0).over(&Fraction::of(3.0));
    // The f32 nearest to 1/3 is 11184811 2^-25: 1/3 ulp above. The one below is 2/3 ulp off.
    assert_eq!(
        (1.0_f32 / 3.0).to_bits() & 0x7f_ffff | 0x80_0000,
        11_184_811
    );
    assert!((third.ulps(1.0 / 3.0) - 1.0 / 3.0).abs() <= 1e-15);
    let below = f32::from_bits((1.0_f32 / 3.0).to_bits() - 1);
    assert!((third.ulps(below) - 2.0 / 3.0).abs() <= 1e-15);
    // Far below the subnormals, and next to a power of two from either side.
    let tiny = Fraction::of(1e-45).over(&Fraction::of(4.0));
    assert_eq!((tiny.ulps(0.0), tiny.ulps(1e-45)), (0.25, 0.75));
    assert_eq!(Fraction::of(1.0).ulps(1.0 - f32::EPSILON / 2.0), 0.5);
    let almost = Fraction::of(1.0 - f32::EPSILON / 2.0);
    assert_eq!((almost.ulps(1.0), almost.capped().ulps(1.0)), (1.0, 1.0));
    let above = Fraction::of_count(1 << 64).over(&Fraction::of_count((1 << 64) - 1));
    assert_eq!(above.capped().ulps(1.0), 0.0);
}

// How a measured figure is held to one of the documentation, and figures in its sentences.

/// Holds a measured error to the one stated, and the statement to being no more than 2.5 times what is measured: one that
/// a search found has a margin, and this search may be shorter.
pub fn assert_stated(what: &str, measured: f64, stated: f64) {
    println!("{what}: {measured:.3e} measured, {stated:.2e} stated");
    assert!(
        measured <= stated,
        "{what}: {measured:e} against {stated:e}"
    );
    assert!(
        stated <= 2.5 * measured,
        "{what}: {measured:e}, {stated:e} is stale"
    );
}

/// The error of an autocorrelation, as its documentation states it in a line of the text.
pub fn stated_error(source: &str) -> f64 {
    after(source, "Error of an autocorrelation: ")
}

/// The number that follows some words in a text, up to a comma.
pub fn after(source: &str, words: &str) -> f64 {
    let (_, rest) = source.split_once(words).unwrap();
    let figure = rest.split(',').next().unwrap();
    figure.trim().parse().unwrap()
}
