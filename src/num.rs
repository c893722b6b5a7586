//! Numbers: bounds, words, exponents and error-free arithmetic. All other rooms use this one.
//!
//! Nothing here knows a tier, a uniform or a warp.

mod bounds;
pub(crate) mod division;
pub(crate) mod double_word;
pub(crate) mod doubles;
mod error_free;
mod exact_sum;
mod exponent;
mod long;
mod roots;
mod scaled;
mod segment;
#[cfg(test)]
mod tests;
pub(crate) mod vector;
mod word;

pub use self::bounds::{LARGEST, SMALLEST};
pub(crate) use self::bounds::{
    VECTORS, above_zero, clamp, into_unit, representable, saturated, tail,
};
pub(crate) use self::error_free::{
    head, pair, product, quick_two_sum, remainder, two_product, two_sum,
};
pub(crate) use self::exact_sum::ExactSum;
pub(crate) use self::exponent::{
    is_plain, ldexp, nearest_integer, normalised, power_of_two, power_of_two_times,
};
pub(crate) use self::long::{Long, high};
pub(crate) use self::roots::{cube_root, inverse_square_root, square_root};
pub(crate) use self::scaled::Scaled;
pub(crate) use self::segment::{Segment, extent, neighbour};
#[cfg(feature = "fixed")]
pub(crate) use self::word::NARROW;
pub(crate) use self::word::{
    float, folded, folded_exactly, folded_tail, happens, middle, nearest, up_to, up_to_by_two,
    up_to_carried,
};
