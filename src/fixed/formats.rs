//! The formats in which the integer tier takes uniforms and gives points and densities.

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
