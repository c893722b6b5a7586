//! Arithmetic of ranges: each result holds all results for numbers of the operands, whatever doubles round.

use crate::range::Range;
use std::f64::consts::TAU;
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

    /// The sine of turns, of which at most a quarter counts either way.
    pub fn sine(self) -> Self {
        let of = |x: f64| (TAU * x.clamp(-0.25, 0.25)).sin();
        // Beyond a quarter it falls again.
        let past = of(0.5 - self.high.max(0.25));
        outward(of(self.low).min(past), of(self.high)).wider(0.0)
    }

    /// How fast that grows with the turns.
    pub fn slope_of_sine(self) -> Self {
        let of = |x: f64| TAU * (TAU * x).cos();
        self.by_distance_from_0(of)
    }

    /// How fast it grows relatively as the turns grow relatively, x/tan x in radians.
    pub fn sine_relatively(self) -> Self {
        let of = |x: f64| {
            if x == 0.0 {
                1.0
            } else {
                TAU * x / (TAU * x).tan()
            }
        };
        self.by_distance_from_0(of)
    }

    /// Of an even function that falls from 0 on.
    fn by_distance_from_0(self, of: impl Fn(f64) -> f64) -> Self {
        let near = self.low.max(-self.high).max(0.0);
        let [low, high] = [self.size(), near].map(of);
        Self { low, high }.wider(4e-15)
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
    let turns = Range {
        low: -0.125,
        high: 0.25,
    };
    holds(turns.sine(), -0.5_f64.sqrt(), 1.0);
    holds(turns.slope_of_sine(), 0.0, TAU);
    holds(turns.sine_relatively(), 0.0, 1.0);
    assert!((b / a).low == f64::NEG_INFINITY && (b * Range::only(0.0)).size() < 1e-300);
}
