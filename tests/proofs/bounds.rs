//! The error of a map over all pairs of uniforms, from the errors of its factors.
//!
//! The point is (r cos φ, r sin φ), of a direction with its height. What is returned differs from it by the error of
//! r along the point's own direction, by r times the error of (cos φ, sin φ), and by the rounding of each
//! product, at most half an ulp of it. Each is bounded over a bin of radii and a cell of phases, and
//! their sum is projected onto the axes, where its largest value is the sum of the largest ones.

use crate::phases::{AXES, Cell, MISSED, axis};
use crate::radii::{Bin, Radii};
use crate::range::Range;
use std::f64::consts::{FRAC_PI_4, PI, TAU};

/// The errors of the f64 truths and sums, many times over.
const MARGIN: f64 = 1e-13;

/// What is rounded after the factors have been made; the controls leave some of it out.
#[derive(Clone, Copy, Debug)]
pub struct Roundings {
    /// The products of the radius with sine and cosine.
    pub products: bool,
    /// The phase, which is the quotient of the two numbers of the square.
    pub quotient: bool,
    /// Those numbers themselves.
    pub square: bool,
    /// By how many radians the phase is rounded otherwise.
    pub turn: f64,
    /// The sums of each coordinate with what turns the point by less than 1e-6.
    pub nudged: bool,
}

impl Roundings {
    /// The products alone.
    pub const PLAIN: Self = Self {
        products: true,
        quotient: false,
        square: false,
        turn: 0.0,
        nudged: false,
    };
}

/// A bound, and where it is reached.
#[derive(Clone, Copy, Debug, Default)]
pub struct Worst {
    pub bound: f64,
    pub cell: usize,
    pub bin: usize,
    /// The direction of the error.
    pub direction: [f64; 2],
}

impl Worst {
    fn raise(&mut self, other: Self) {
        // Not a number would win.
        if other.bound > self.bound || other.bound.is_nan() {
            *self = other;
        }
    }
}

/// Half an ulp of numbers up to x > 0.
fn half_ulp(x: f64) -> f64 {
    let below = f64::from_bits(x.to_bits() - 1);
    f64::from_bits(((below.to_bits() >> 52) - 24) << 52)
}

/// The largest product of two numbers of two ranges.
fn largest_product(a: Range, b: Range) -> f64 {
    (a.low * b.low)
        .max(a.low * b.high)
        .max(a.high * b.low)
        .max(a.high * b.high)
}

impl Roundings {
    /// Half the units in the last place of both products.
    fn of_products(self, bin: &Bin, cell: &Cell) -> [f64; 2] {
        let half = |factor: f64| {
            if self.nudged {
                2.0 * half_ulp(bin.r * (factor + 1e-6))
            } else if self.products {
                half_ulp(bin.r * factor)
            } else {
                0.0
            }
        };
        [cell.c, cell.s].map(half)
    }

    /// How far the point may be turned about the centre.
    fn turned(self, bin: &Bin, cell: &Cell) -> f64 {
        let phase = cell.turns.high;
        let quotient = if self.quotient {
            TAU * half_ulp(phase)
        } else {
            0.0
        };
        // A number of the square below -1/2 is rounded by 2^-25. The larger one turns the point by the phase over
        // the radius, the smaller one by an eighth of a turn.
        let number = |x: f64| {
            let rounded = self.square && x * bin.r >= 0.5;
            if rounded { 2.0_f64.powi(-25) } else { 0.0 }
        };
        bin.r * (quotient + self.turn) + TAU * phase * number(1.0) + FRAC_PI_4 * number(8.0 * phase)
    }

    /// The largest distance in the plane, and its direction.
    fn in_the_plane(self, bin: &Bin, cell: &Cell) -> (f64, [f64; 2]) {
        let [hx, hy] = self.of_products(bin, cell);
        let turned = self.turned(bin, cell);
        let middle = TAU * 0.5 * (cell.turns.low + cell.turns.high);
        let half = TAU * 0.5 * (cell.turns.high - cell.turns.low);
        let mut worst = (0.0, [0.0; 2]);
        for k in 0..AXES {
            let [ax, ay] = axis(k);
            let along = |x: f64| Range {
                low: x - half,
                high: x + half,
            };
            let angle = middle - PI * k as f64 / AXES as f64;
            for sign in [1.0, -1.0] {
                let kernel = (sign * cell.along[k].low).max(sign * cell.along[k].high);
                let radial = largest_product(along(sign * angle.cos()), bin.off);
                let tangential = (angle.sin().abs() + half) * turned;
                let sum =
                    bin.r * kernel.max(0.0) + radial + tangential + hx * ax.abs() + hy * ay.abs();
                if sum > worst.0 || sum.is_nan() {
                    worst = (sum, [sign * ax, sign * ay]);
                }
            }
        }
        (worst.0 * MISSED, worst.1)
    }

    /// The largest error of a point, over all pairs of a radius and a phase.
    pub fn sample(self, radii: &Radii, cells: &[Cell]) -> Worst {
        self.over(radii, cells, |bin, cell| {
            let (plane, direction) = self.in_the_plane(bin, cell);
            (plane.hypot(bin.height.size()) + MARGIN, direction)
        })
    }

    /// The largest difference of the length of a direction from 1.
    ///
    /// The length of p + e, where p is a unit vector, is at least 1 + p·e and at most e²/2 more.
    pub fn length(self, radii: &Radii, cells: &[Cell]) -> Worst {
        self.over(radii, cells, |bin, cell| {
            let [hx, hy] = self.of_products(bin, cell);
            let rounding = bin.r * (hx * cell.c + hy * cell.s);
            // The larger of the radii, so that 0 is among the products.
            let square = Range {
                low: 0.0,
                high: bin.r * bin.r,
            };
            let middle = TAU * 0.5 * (cell.turns.low + cell.turns.high);
            let [longer, shorter] = [1.0, -1.0].map(|sign| {
                let of = |range: Range| range.times(sign);
                of(bin.longer).high + largest_product(square, of(cell.radial)) + rounding
            });
            let sign = if longer > shorter { 1.0 } else { -1.0 };
            (
                longer.max(shorter) + MARGIN,
                [sign * middle.cos(), sign * middle.sin()],
            )
        })
    }

    fn over(
        self,
        radii: &Radii,
        cells: &[Cell],
        bound: impl Fn(&Bin, &Cell) -> (f64, [f64; 2]),
    ) -> Worst {
        let mut worst = Worst::default();
        for (i, bin) in radii.bins.iter().enumerate() {
            for (j, cell) in cells.iter().enumerate() {
                let (bound, direction) = bound(bin, cell);
                worst.raise(Worst {
                    bound,
                    cell: j,
                    bin: i,
                    direction,
                });
            }
        }
        worst
    }
}
