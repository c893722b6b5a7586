//! How much `f32` rounds.

use crate::range::Range;

/// What an operation rounds: at most `absolute`, and at most `relative` of its result and `floor` beside it.
#[derive(Clone, Copy)]
pub struct Lost {
    pub absolute: f64,
    pub relative: f64,
    pub floor: f64,
}

impl Lost {
    pub const NOTHING: Self = Self {
        absolute: 0.0,
        relative: 0.0,
        floor: 0.0,
    };

    /// What `f32` rounds of numbers of a range.
    pub fn of(value: Range) -> Self {
        let floor = if value.low >= f64::from(f32::MIN_POSITIVE) {
            0.0
        } else {
            SUBNORMAL
        };
        Self {
            absolute: half_ulp(value.size()).max(floor),
            relative: UNIT,
            floor,
        }
    }

    /// A part of a number of a range, in units of 2⁻²⁴.
    pub fn part(value: Range, units: f64) -> Self {
        let relative = units * UNIT;
        Self {
            absolute: relative * value.size(),
            relative,
            floor: 0.0,
        }
    }

    pub fn times(self, by: f64) -> Self {
        Self {
            absolute: by * self.absolute,
            relative: by * self.relative,
            floor: by * self.floor,
        }
    }
}

/// 2⁻²⁴, and half the smallest `f32`.
pub const UNIT: f64 = 1.0 / 16_777_216.0;
const SUBNORMAL: f64 = 0.5 * f32::from_bits(1) as f64;

/// The most that numbers up to x are rounded by: half an ulp, or what x has beyond a power of two if it is less.
fn half_ulp(x: f64) -> f64 {
    if x < f64::from(f32::MIN_POSITIVE) {
        return SUBNORMAL;
    }
    let power = f64::from_bits(x.to_bits() >> 52 << 52);
    (0.5 * UNIT * power).max((x - power).min(UNIT * power))
}
