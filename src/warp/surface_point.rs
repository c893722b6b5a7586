//! Points of surfaces, and the sums of areas that may be 0 or leave the range of `f32`.

use crate::error::Error;
use crate::num::{Scaled, clamp, power_of_two};

/// A point of a surface, with the normal there.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SurfacePoint {
    /// The point.
    pub position: [f32; 3],
    /// The outward normal, a unit vector.
    pub normal: [f32; 3],
}

/// The power of two at or below a number, or the smallest normal one: divided by it, the number is below 2.
pub(super) const fn unit_of(x: f32) -> f32 {
    let binade = f32::from_bits(x.to_bits() & 0x7f80_0000);
    clamp(binade, f32::MIN_POSITIVE, f32::MAX)
}

/// The product of two numbers; nothing where one is 0.
pub(super) fn area(a: Option<Scaled>, b: Option<Scaled>) -> Option<Scaled> {
    Some(a?.times(b?))
}

/// A number from 0 up; nothing for 0.
pub(super) fn scaled(x: f32) -> Option<Scaled> {
    (x > 0.0).then(|| Scaled::of(x))
}

/// The areas of the parts of a surface, in one unit, and their sum; and the density, which is 1/(times · sum).
///
/// # Errors
/// [`Error::Empty`] without area, or where the density overflows; [`Error::TooLarge`] where it is below the smallest normal
/// number. A surface has two parameters, and these reasons lie in both.
pub(super) fn parts(areas: [Option<Scaled>; 3], times: f32) -> Result<([f32; 3], f32, f32), Error> {
    let exponents = areas.into_iter().flatten().map(|area| area.parts().1);
    let largest = exponents.max().ok_or(Error::Empty(1))?;
    let down = largest.wrapping_neg();
    let areas = areas.map(|area| area.map_or(0.0, |area| area.raised(down).value()));
    let [a, b, c] = areas;
    let sum = a + b + c;
    let density = Scaled::ONE.over(Scaled::of(times * sum)).raised(down);
    let density = density.value();
    if density > f32::MAX {
        Err(Error::Empty(1))
    } else if density >= f32::MIN_POSITIVE {
        Ok((areas, sum, density))
    } else {
        Err(Error::TooLarge(1))
    }
}

/// √(x² + y²) of numbers that may leave the range of `f32` as squares, in units of the power of two that is returned, too.
pub(super) fn hypotenuse(x: f32, y: f32) -> (f32, f32) {
    let (x, y) = (x.abs(), y.abs());
    let unit = unit_of(if x > y { x } else { y });
    let (x, y) = (x / unit, y / unit);
    (crate::tier::sqrt(x * x + y * y), unit)
}

/// 2⁻²⁰, sixteen roundings: how far from a surface of size 1 a point still counts as one of its points.
pub(super) const NEAR: f32 = power_of_two(-20);
