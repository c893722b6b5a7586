//! Directions from angles and angles from directions, without cancellation: shared by the warps over directions.

use crate::error::{Error, finite};
use crate::num::vector::{copied, dot, is_ordinary, scaled};
use crate::num::{into_unit, two_sum};
use crate::tier::{Tier, sqrt};
use core::f32::consts::TAU;

/// 2⁻¹⁰⁰. Below it 1 − cos θ equals sin²θ/2, and may have lost digits if it is a product.
pub(crate) const DEEP: f32 = 7.888_609e-31;

/// The direction with the given sine and cosine of its polar angle, `turn` turns about the axis.
#[inline]
pub(crate) fn around<T: Tier>(sin: f32, cos: f32, turn: f32, to: &mut [f32; 3]) {
    let (x, y) = T::polar(sin, turn);
    *to = [x, y, cos];
}

/// The direction with the given 1 − cos θ and 1 + cos θ, `turn` turns about the axis.
///
/// The smaller of the two holds the digits. The larger is taken as 2 minus the smaller, so that sine and cosine belong
/// to one angle.
#[inline]
pub(crate) fn between_poles<T: Tier>(down: f32, up: f32, turn: f32, to: &mut [f32; 3]) {
    let (small, cos) = if down < 1.0 {
        (down, 1.0 - down)
    } else {
        (up, up - 1.0)
    };
    around::<T>(T::sqrt(small * (2.0 - small)), cos, turn, to);
}

/// 1 − cos θ of a direction: from x and y near +z, where z has lost the digits.
#[inline]
pub(crate) fn one_minus_cos(direction: [f32; 3]) -> f32 {
    let [x, y, z] = direction;
    if z > 0.5 {
        (x * x + y * y) / (1.0 + z)
    } else {
        1.0 - z
    }
}

/// The azimuth of (x, y) in turns, in [0, 1).
#[inline]
pub(crate) fn azimuth<T: Tier>(x: f32, y: f32) -> f32 {
    let turns = T::atan2_turns(y, x);
    into_unit(if turns < 0.0 { turns + 1.0 } else { turns })
}

/// The unit vector along a direction of any finite length, the parameter of that place.
pub(crate) fn normalised(direction: [f32; 3], place: usize) -> Result<[f32; 3], Error> {
    let square = dot(direction, direction);
    if is_ordinary(square) {
        let length = sqrt(square);
        Ok(direction.map(|c| c / length))
    } else {
        normalised_any(copied(direction), place)
    }
}

/// The same of one that may be very long or short, or not a number.
#[cold]
#[inline(never)]
fn normalised_any(direction: [f32; 3], place: usize) -> Result<[f32; 3], Error> {
    for c in &direction {
        finite(*c, place)?;
    }
    let (_, point) = scaled(direction);
    let length = length(point);
    if length > 0.0 {
        Ok(point.map(|c| c / length))
    } else {
        Err(Error::ZeroLength(place))
    }
}

/// The length of a scaled point, or of an ordinary one.
#[inline]
pub(crate) fn length(point: [f32; 3]) -> f32 {
    sqrt(dot(point, point))
}

/// Whether all three coordinates are finite.
#[inline]
pub(crate) fn is_direction(direction: [f32; 3]) -> bool {
    let [x, y, z] = direction;
    x.is_finite() && y.is_finite() && z.is_finite()
}

/// How far outside a range of azimuths rounding can carry a point, in turns.
const AZIMUTH_SLACK: f32 = 2.5 * f32::EPSILON;

/// A range of azimuths in turns.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(crate) struct Azimuths {
    pub(super) start: f32,
    /// The width and its rounding error.
    pub(super) width: f32,
    pub(super) rest: f32,
}

impl Azimuths {
    /// From one finite azimuth to another that is not below it, the parameters of these places. A width that rounds to 1
    /// is a whole turn.
    pub(crate) const fn new([from, to]: [f32; 2], places: [usize; 2]) -> Result<Self, Error> {
        let (width, rest) = two_sum(to, -from);
        if from < -1.0 || from > 1.0 {
            return Err(Error::OutOfRange(places[0]));
        }
        if width > 1.0 {
            return Err(Error::OutOfRange(places[1]));
        }
        Ok(Self {
            start: from,
            width,
            rest: if width < 1.0 { rest } else { 0.0 },
        })
    }

    /// The azimuths of both sides. The second of a whole turn is the first plus 1, rounded to `f32`.
    pub(crate) const fn sides(&self) -> [f32; 2] {
        let (end, dropped) = two_sum(self.start, self.width);
        [self.start, end + (dropped + self.rest)]
    }

    /// The width and its rounding error.
    pub(crate) const fn width(&self) -> (f32, f32) {
        (self.width, self.rest)
    }

    /// The azimuth of a uniform, and by how many radians it was rounded.
    #[inline]
    pub(crate) fn at(&self, u: f32) -> (f32, f32) {
        // A sum of turns rounds up to four times as coarsely as the coordinates, so a point is turned by the rounding
        // error.
        let (turn, dropped) = two_sum(self.start, u * self.width);
        (turn, (dropped + u * self.rest) * TAU)
    }

    /// The azimuth of (x, y) from that of the first side, in turns, reduced to the value nearest to the middle.
    #[inline]
    pub(crate) fn of<T: Tier>(&self, x: f32, y: f32) -> f32 {
        let turn = T::atan2_turns(y, x) - self.start;
        let off = turn - 0.5 * self.width;
        let whole = if off > 1.5 {
            2.0
        } else if off > 0.5 {
            1.0
        } else if off < -1.5 {
            -2.0
        } else if off < -0.5 {
            -1.0
        } else {
            0.0
        };
        turn - whole
    }

    /// Whether the azimuth of (x, y) lies in the range, up to rounding.
    #[inline]
    pub(crate) fn contain<T: Tier>(&self, x: f32, y: f32) -> bool {
        let turn = self.of::<T>(x, y);
        turn >= -AZIMUTH_SLACK && turn <= self.width + AZIMUTH_SLACK
    }

    /// The uniform of the azimuth of (x, y).
    #[inline]
    pub(crate) fn invert<T: Tier>(&self, x: f32, y: f32) -> f32 {
        into_unit(self.of::<T>(x, y) / self.width)
    }
}

/// (x, y), turned by a small angle in radians.
#[inline]
pub(crate) fn nudged(x: f32, y: f32, angle: f32) -> [f32; 2] {
    [x - angle * y, y + angle * x]
}
