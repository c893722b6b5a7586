//! Vectors of three numbers: places, directions, radiances.

use microwarp::tier::{Poly, Tier};

pub type Vector = [f32; 3];

#[inline]
pub const fn dot([a, b, c]: Vector, [x, y, z]: Vector) -> f32 {
    a * x + b * y + c * z
}

#[inline]
pub const fn cross([a, b, c]: Vector, [x, y, z]: Vector) -> Vector {
    [b * z - c * y, c * x - a * z, a * y - b * x]
}

#[inline]
pub const fn plus([a, b, c]: Vector, [x, y, z]: Vector) -> Vector {
    [a + x, b + y, c + z]
}

#[inline]
pub const fn minus([a, b, c]: Vector, [x, y, z]: Vector) -> Vector {
    [a - x, b - y, c - z]
}

#[inline]
pub const fn scaled([a, b, c]: Vector, by: f32) -> Vector {
    [a * by, b * by, c * by]
}

/// Channel by channel.
#[inline]
pub const fn times([a, b, c]: Vector, [x, y, z]: Vector) -> Vector {
    [a * x, b * y, c * z]
}

/// The square root, which is the same in both tiers.
#[inline]
pub fn sqrt(x: f32) -> f32 {
    Poly::sqrt(x)
}

#[inline]
pub fn length(v: Vector) -> f32 {
    sqrt(dot(v, v))
}

/// A unit vector along `v`; `v` itself where it has no length.
#[inline]
pub fn unit(v: Vector) -> Vector {
    let length = length(v);
    if length > 0.0 {
        scaled(v, 1.0 / length)
    } else {
        v
    }
}

#[inline]
pub const fn largest([a, b, c]: Vector) -> f32 {
    let ab = if a > b { a } else { b };
    if ab > c { ab } else { c }
}
