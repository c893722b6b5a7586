//! Angles of segments, their sines and the distances of their ends: how far the kernels of a tier are off, and what is kept of them.

use crate::number::Number;
use crate::range::Range;
use crate::rounding::{Lost, UNIT};
use crate::swept::Swept;
use crate::tape::{NEAR, Tape, Traced};
use host::errors::raise;
use microwarp::tier::Tier;
use std::f64::consts::TAU;

/// tan(π/8) and the coefficients of the angle about the diagonal, as `poly` has them.
const TANGENT: f64 = 0.414_213_57;
pub const ANGLE: [f32; 5] = [
    0.034_154_94,
    -0.053_050_812,
    0.031_790_677,
    -0.022_048_812,
    0.012_717_884,
];

/// The angle of `poly` in turns, of the quotient of difference and sum of both coordinates.
pub fn from_the_diagonal(z: f32, [a, b, c, d, e]: [f32; 5]) -> f32 {
    let w = z * z;
    0.125 + (0.125 * z + z * (a + w * (b + w * (c + w * (d + w * e)))))
}

/// How far the kernels of a tier are off, upward and downward: the sine of turns, the angle of a quotient, and in `poly` that of a
/// quotient from the diagonal.
pub struct Links {
    /// What sines are off by otherwise, for a control.
    more: f64,
    sine: [Swept; 2],
    angle: [Swept; 2],
    diagonal: Option<[Swept; 2]>,
}

impl Links {
    pub fn of<T: Tier>(coefficients: [f32; 5], more: f64) -> Self {
        let least = 0.5_f32.powi(20);
        let poly = T::NAME == "poly";
        let highest = if poly { TANGENT as f32 } else { 1.0 };
        let diagonal = |z: f32| from_the_diagonal(-z, coefficients);
        Self {
            more,
            sine: Swept::both_ways(
                [least, 0.250_01],
                |t| T::sincos_turns(t).0,
                |t| (TAU * t).sin(),
            ),
            angle: Swept::both_ways(
                [least, highest],
                |q| T::atan2_turns(q, 1.0),
                |q| q.atan() / TAU,
            ),
            diagonal: poly.then(|| {
                Swept::both_ways([0.5_f32.powi(26), 0.414_22], diagonal, |z| {
                    0.125 - z.atan() / TAU
                })
            }),
        }
    }

    /// By what part of itself the angle of a quotient up to 1 is off, whose two numbers are off by so much together.
    fn acute(&self, q: Range, inputs: f64) -> f64 {
        let slope = |q: f64| {
            if q < 1e-8 {
                1.0
            } else {
                q / ((1.0 + q * q) * q.atan())
            }
        };
        let mut worst = 0.0_f64;
        let axis = self.diagonal.is_none() || q.low < TANGENT * (1.0 + NEAR);
        if axis {
            let high = if self.diagonal.is_some() {
                q.high.min(TANGENT * (1.0 + NEAR))
            } else {
                q.high
            };
            let q = Range { high, ..q };
            raise(
                &mut worst,
                slope(q.low) * (inputs + rounded(q)) + most_of(&self.angle, q),
            );
        }
        if let Some(diagonal) = &self.diagonal
            && q.high > TANGENT * (1.0 - NEAR)
        {
            let low = q.low.max(TANGENT * (1.0 - NEAR));
            let of = |q: f64| (1.0 - q).max(0.0) / (1.0 + q);
            let z = Range {
                low: of(q.high),
                high: of(low),
            };
            // The difference of two numbers of which neither is more than twice the other is exact.
            let roundings = if low >= 0.5 { 2.0 } else { 3.0 };
            let turned = roundings * z.high / ((1.0 + z.high * z.high) * low.atan());
            raise(
                &mut worst,
                slope(low) * inputs + turned + most_of(diagonal, z),
            );
        }
        worst * (1.0 + NEAR)
    }

    /// The same of any quotient.
    pub fn turns(&self, q: Range, inputs: f64) -> f64 {
        let mut worst = 0.0_f64;
        if q.low <= 1.0 + NEAR {
            raise(
                &mut worst,
                self.acute(
                    Range {
                        high: q.high.min(1.0),
                        ..q
                    },
                    inputs,
                ),
            );
        }
        if q.high >= 1.0 - NEAR {
            // A quarter less the angle of the inverse, rounded by 2⁻²⁷.
            let q = Range {
                low: q.low.max(1.0),
                ..q
            };
            let inverse = Range {
                low: 1.0 / q.high.max(1.0),
                high: 1.0 / q.low,
            };
            let off = self.acute(inverse, inputs) * inverse.high.atan() / TAU + 0.125;
            raise(&mut worst, off / (q.low.atan() / TAU) * (1.0 + NEAR));
        }
        worst
    }

    /// What a sine is off by in the middle, and otherwise.
    pub fn of_sine(&self, turns: Range) -> [f64; 2] {
        let size = Range {
            low: turns.low.max(0.0),
            high: turns.high.max(-turns.low),
        };
        let [middle, off] = Swept::about(&self.sine, size);
        [middle, off + self.more]
    }

    /// The sine of a record, off by so much.
    pub fn sine<'a>(tape: &'a Tape, turns: Traced<'a>, off: f64) -> Traced<'a> {
        let exact = tape.exactly(|| turns.sine());
        let floor = if turns.value().low < f64::from(f32::MIN_POSITIVE) {
            f64::from(f32::from_bits(1))
        } else {
            0.0
        };
        let part = Lost::part(exact.value(), off);
        exact.off_by(Lost {
            absolute: part.absolute + floor,
            floor,
            ..part
        })
    }

    /// Two sines of which the quotient alone counts: what both are off by counts once.
    pub fn sines<'a>(&self, tape: &'a Tape, turns: [Traced<'a>; 2]) -> [Traced<'a>; 2] {
        let [[of_x, x], [of_y, y]] = turns.map(|turns| self.of_sine(turns.value()));
        [
            Self::sine(tape, turns[0], x),
            Self::sine(tape, turns[1], y + (of_x - of_y).abs()),
        ]
    }
}

/// The largest error of either way.
fn most_of(errors: &[Swept; 2], range: Range) -> f64 {
    let [middle, off] = Swept::about(errors, range);
    middle.abs() + off
}

/// By what part of itself a number of a range is rounded, in units of 2⁻²⁴.
pub fn rounded(range: Range) -> f64 {
    (Lost::of(range).absolute / range.low / UNIT).min(1.0)
}

/// Where one length is at most so much of another, the root of the sum of their squares is the larger one in `f32`.
///
/// In units in which that is E, from 1 to 2, the sum is E² and a part p², and rounded by 2⁻²⁴, or from √2 on by 2⁻²³: its root leads to
/// less than half an ulp above E where p² is below 2⁻²⁴(2E - 1), or 2⁻²³(E - 1).
pub const SHORT: f64 = 0.64 / 4096.0;
const SHORT_OF_SMALL: f64 = 0.95 / 4096.0;

/// The distance of an end to the light.
pub fn radius(tape: &Tape, d: Range, end: Range) -> Traced<'_> {
    let larger = if end.low > d.low { end } else { d };
    let significand = |x: f64| f64::from_bits(x.to_bits() << 12 >> 12 | 1.0_f64.to_bits());
    let is_small = larger.high < 2.0 * larger.low
        && significand(larger.low) <= significand(larger.high)
        && significand(larger.high) < 1.414;
    let short = if is_small { SHORT_OF_SMALL } else { SHORT };
    if end.high <= short * d.low || d.high <= short * end.low {
        let all = Range {
            low: d.low.hypot(end.low),
            high: d.high.hypot(end.high),
        }
        .wider(0.0);
        let part = (d.high / end.low).min(end.high / d.low);
        tape.input(all)
            .off_by(Lost::part(all, 0.5 * part * part / UNIT * (1.0 + NEAR)))
    } else {
        tape.input(d * d + end * end).off(1.0).sqrt()
    }
}
