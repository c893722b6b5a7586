//! Directions from angles and angles from directions, without cancellation: shared by the warps over directions.

use crate::num::into_unit;
use crate::tier::Tier;

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

/// Whether all three coordinates are finite.
#[inline]
pub(crate) fn is_direction(direction: [f32; 3]) -> bool {
    let [x, y, z] = direction;
    x.is_finite() && y.is_finite() && z.is_finite()
}
