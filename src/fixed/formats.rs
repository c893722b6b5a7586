//! The formats in which the integer tier takes uniforms and gives points and densities.

use ::fixed::types::{I2F30, I5F27, U0F32, U5F27, U32F32};

/// A uniform of the integer tier, k·2⁻³² in [0, 1): every word is one.
///
/// `Uniform::from_bits(word)` makes one of a word, `Uniform::from_num(0.25)` of a number.
pub type Uniform = U0F32;
/// A coordinate of the unit disk, of a direction, or barycentric. (`I1F31` cannot hold +1.)
pub type Coordinate = I2F30;
/// A coordinate of a standard normal pair: [−16, 16) in steps of 2⁻²⁷.
pub type Deviate = I5F27;
/// A number of the standard exponential distribution: [0, 32) in steps of 2⁻²⁷.
pub type Length = U5F27;
/// The type of every density of this tier, in steps of 2⁻³²; also of rates.
///
/// For floats there is no such name: their densities are `f32`.
pub type Density = U32F32;
