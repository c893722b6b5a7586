//! The integer tier: words in, fixed-point numbers out, and no floating-point operation anywhere.
//!
//! Here live the warps for cores without a floating-point unit, the integer kernels they stand on, and what of
//! the other rooms runs on integers alone. Feature `fixed`. Say the tier once, by `use microwarp::fixed as mw;`.

mod grade;
mod kernel;
mod rejection;

pub use self::grade::{Coarse, Compact, Fine, Grade};
pub use self::rejection::{DiskRejection, DiskRejection16};

use ::fixed::types::{I2F30, U0F32, U32F32};

/// A uniform of the integer tier: k·2⁻³², each word a number.
pub type Uniform = U0F32;
/// A coordinate of a point of the unit disk or sphere. (`I1F31` cannot hold +1.)
pub type Coordinate = I2F30;
/// A density, in steps of 2⁻³².
pub type Density = U32F32;
