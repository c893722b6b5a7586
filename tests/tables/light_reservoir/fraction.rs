//! Fractions of 128 bits.

use std::iter::Sum;
use std::ops::{Add, Div, Mul};

/// In lowest terms, with a positive denominator. What does not fit panics.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Fraction(u128, u128);

pub const ZERO: Fraction = Fraction(0, 1);
pub const ONE: Fraction = Fraction(1, 1);

/// n/d.
pub const fn over(n: u128, d: u128) -> Fraction {
    let (mut a, mut b) = (n, d);
    while b > 0 {
        (a, b) = (b, a % b);
    }
    Fraction(n / a, d / a)
}

pub fn whole(n: u32) -> Fraction {
    over(n.into(), 1)
}

impl Fraction {
    /// ⌊2⁶⁴ times this⌋ of a fraction of at most 1.
    pub fn words(self) -> u128 {
        (self.0 << 64) / self.1
    }

    pub fn value(self) -> f64 {
        self.0 as f64 / self.1 as f64
    }
}

impl Add for Fraction {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        let Fraction(_, shared) = over(self.1, other.1);
        // The least common denominator.
        let common = self.1.checked_mul(shared).unwrap();
        let part = |f: Self| f.0.checked_mul(common / f.1).unwrap();
        over(part(self).checked_add(part(other)).unwrap(), common)
    }
}

impl Mul for Fraction {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let (a, b) = (over(self.0, other.1), over(other.0, self.1));
        Self(a.0.checked_mul(b.0).unwrap(), a.1.checked_mul(b.1).unwrap())
    }
}

impl Div for Fraction {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        assert!(other.0 > 0, "a division by 0");
        self * Self(other.1, other.0)
    }
}

impl Sum for Fraction {
    fn sum<I: Iterator<Item = Self>>(all: I) -> Self {
        all.fold(ZERO, Add::add)
    }
}
