//! Arithmetic of ranges: each result holds all results for numbers of the operands, whatever doubles round.

use crate::range::Range;
use std::ops::{Add, Div, Mul, Sub};

/// Moves both ends outward by more than an operation of doubles rounds.
fn outward(low: f64, high: f64) -> Range {
    let step = |x: f64| x.abs() * f64::EPSILON + f64::MIN_POSITIVE;
    Range {
        low: if low == 0.0 { low } else { low - step(low) },
        high: if high == 0.0 { high } else { high + step(high) },
    }
}

/// A bound that is infinite is not reached, so that nothing times it is nothing.
fn times(a: f64, b: f64) -> f64 {
    if a == 0.0 || b == 0.0 { 0.0 } else { a * b }
}

impl Range {
    pub const ALL: Self = Self {
        low: f64::NEG_INFINITY,
        high: f64::INFINITY,
    };

    pub const fn only(x: f64) -> Self {
        Self { low: x, high: x }
    }

    pub fn both(x: f64) -> Self {
        Self { low: -x, high: x }
    }

    /// What is in both of two ranges that hold the same number.
    pub fn and(self, other: Self) -> Self {
        Self {
            low: self.low.max(other.low),
            high: self.high.min(other.high),
        }
    }

    /// The range with so much more at both ends.
    pub fn wider(self, by: f64) -> Self {
        outward(self.low - by, self.high + by)
    }

    pub fn sqrt(self) -> Self {
        outward(self.low.max(0.0).sqrt(), self.high.sqrt())
    }

    /// The share that a number of this range, 0 or more, has in its sum with one of the other.
    pub fn share(self, other: Self) -> Self {
        let of = |a: f64, b: f64| if a == 0.0 { 0.0 } else { a / (a + b) };
        if self.low < 0.0 || other.low < 0.0 {
            return Self::ALL;
        }
        let high = if other.low == 0.0 {
            1.0
        } else {
            of(self.high, other.low)
        };
        outward(of(self.low, other.high), high)
    }
}

impl Add for Range {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        outward(self.low + other.low, self.high + other.high)
    }
}

impl Sub for Range {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        outward(self.low - other.high, self.high - other.low)
    }
}

impl Mul for Range {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let [a, b] = [self.low, self.high];
        let ends = [other.low, other.high].map(|c| [times(a, c), times(b, c)]);
        let all = ends.as_flattened();
        outward(
            all.iter().copied().fold(f64::INFINITY, f64::min),
            all.iter().copied().fold(f64::NEG_INFINITY, f64::max),
        )
    }
}

impl Div for Range {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let inverse = if other.low > 0.0 || other.high < 0.0 {
            outward(1.0 / other.high, 1.0 / other.low)
        } else if other.low == 0.0 && other.high > 0.0 {
            outward(1.0 / other.high, f64::INFINITY)
        } else {
            Self::ALL
        };
        self * inverse
    }
}

#[test]
fn ranges_hold_their_results() {
    let [a, b] = [(-1.0, 2.0), (3.0, 4.0)].map(|(low, high)| Range { low, high });
    let holds = |range: Range, low: f64, high: f64| {
        let slack = 1e-14;
        assert!(range.low <= low && low - slack <= range.low, "{range:?}");
        assert!(
            range.high >= high && high + slack >= range.high,
            "{range:?}"
        );
    };
    holds(a + b, 2.0, 6.0);
    holds(a - b, -5.0, -1.0);
    holds(a * b, -4.0, 8.0);
    holds(a / b, -1.0 / 3.0, 2.0 / 3.0);
    holds(b.sqrt(), 3.0_f64.sqrt(), 2.0);
    holds(b.share(b), 3.0 / 7.0, 4.0 / 7.0);
    assert!((b / a).low == f64::NEG_INFINITY && (b * Range::only(0.0)).size() < 1e-300);
}
