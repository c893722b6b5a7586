//! The integer tier: words in, fixed-point numbers out, and no floating-point operation anywhere.
//!
//! Here live the warps for cores without a floating-point unit, the integer kernels they stand on, and what of
//! the other rooms runs on integers alone. Feature `fixed`. Say the tier once, by `use microwarp::fixed as mw;`.

#![expect(
    clippy::arithmetic_side_effects,
    clippy::cast_possible_wrap,
    reason = "plain operators never overflow here: builds with overflow checks try them at the extremes"
)]

mod cone;
mod direction;
mod disk;
mod exponential;
mod float;
mod grade;
mod hemisphere;
mod interval;
mod kernel;
mod lobe;
mod normal;
mod number;
mod rejection;
mod sphere;
mod tent;
mod triangle;
mod triangle_on;
mod truncated;

pub use self::float::{Float, FloatPoint, FloatUniforms};
pub use self::grade::{Coarse, Compact, Fine, Grade};
pub use self::rejection::{DiskRejection, DiskRejection16};

pub use self::interval::Interval;
pub use self::number::Number;

/// The warps of this tier with their grade as a parameter; the aliases beside this module name it.
pub mod warp {
    pub use super::cone::Cone;
    pub use super::disk::Disk;
    pub use super::exponential::{Exponential, StandardExponential};
    pub use super::hemisphere::{CosineHemisphere, Hemisphere};
    pub use super::interval::Interval;
    pub use super::lobe::PhongLobe;
    pub use super::normal::{NormalPair, StandardNormalPair};
    pub use super::sphere::Sphere;
    pub use super::tent::Tent;
    pub use super::triangle::Triangle;
    pub use super::triangle_on::TriangleOn;
    pub use super::truncated::TruncatedExponential;
}

/// Names the warps in one grade, so that a program says its grade once.
macro_rules! names {
    ($grade:ident) => {
        names! { $grade;
            Cone, CosineHemisphere, Disk, Exponential[Frac][Frac], Hemisphere, NormalPair[Frac][Frac], PhongLobe,
            Sphere, StandardExponential, StandardNormalPair, Tent[Frac][Frac], Triangle,
            TriangleOn[Frac, const D: usize][Frac, D], TruncatedExponential[Frac][Frac],
        }
    };
    ($grade:ident; $($name:ident $([$($parameter:tt)*] [$($argument:tt)*])?,)*) => {$(
        #[doc = concat!("[`warp::", stringify!($name), "`](crate::fixed::warp::", stringify!($name), ") in this grade.")]
        pub type $name $(<$($parameter)*>)? = $crate::fixed::warp::$name<$($($argument)*,)? $crate::fixed::$grade>;
    )*};
}

names!(Fine);

/// The warps in grade [`Coarse`].
pub mod coarse {
    pub use super::{Float, Interval};
    names!(Coarse);
}

/// The warps in grade [`Compact`].
pub mod compact {
    pub use super::{Float, Interval};
    names!(Compact);
}

use ::fixed::types::{I2F30, I5F27, U0F32, U5F27, U32F32};

/// A uniform of the integer tier: k·2⁻³², each word a number.
pub type Uniform = U0F32;
/// A coordinate of a point of the unit disk or sphere. (`I1F31` cannot hold +1.)
pub type Coordinate = I2F30;
/// A coordinate of a standard normal pair.
pub type Deviate = I5F27;
/// A length of the standard exponential distribution.
pub type Length = U5F27;
/// A density, in steps of 2⁻³².
pub type Density = U32F32;
