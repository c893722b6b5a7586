//! Discrete and tabulated distributions: an index by its weight, a point by the weight of its cell.
//!
//! # Which one to take
//! | you have | take | memory an entry | a selection costs |
//! |---|---|---|---|
//! | up to some hundred weights that stay (on a microcontroller, some eight) | [`Cdf`] | 4 bytes | log₂ n comparisons |
//! | more weights that stay, and memory | [`Alias`] | 12 bytes, of a power of two | one look-up |
//! | weights that change with every selection | [`select_once`] | none | one pass over the weights |
//! | integer weights that change now and then | [`SumTree`] | none beside the weights | log₂ n additions |
//! | a stream whose length is not known | [`Reservoir`] | one item in all | two `u32` an item |
//! | candidates for a light, and a target that is not normalised | [`LightReservoir`] | one item in all | two `u32` a candidate |
//! | a stream with integer weights, and want several of its items | [`WeightedReservoir`] | 12 bytes and an item each of those, rounded up to 8 | one `u32` an item |
//! | weights of cells on a line, and want a point | [`PiecewiseConstant1d`] | 4 bytes | that of a `Cdf` |
//! | a density at equally spaced points of a line | [`PiecewiseLinear1d`] | 8 bytes | that of a `Cdf`, and a root or two |
//! | a function of either sign at such points, as a pixel filter | [`SignedLinear1d`], [`filter`] | 12 bytes | the same, and a quotient |
//! | particles, and want as many of equal weight | [`resampling`] | none | one pass over the particles |
//! | a probability, and count trials before a success | [`Geometric`] | none | a product a digit |
//! | a number of trials and a probability, and count successes | [`Binomial`] | 592 bytes in all | eight comparisons |
//! | a probability, and count failures before several successes | [`NegativeBinomial`] | 1,104 bytes in all | nine comparisons |
//! | a population, and count the marked ones of a sample | [`Hypergeometric`] | 552 bytes in all | eight comparisons |
//! | a centre and a spread, and want an integer about it | [`DiscreteGaussian`] | 1,080 bytes in all | nine comparisons |
//! | a scale, and want an integer about 0 with heavier tails | [`DiscreteLaplace`] | none | a product a digit |
//! | a mean, and count events | [`Poisson`] | none | some steps from the mean |
//! | a picture, and want a point | [`PiecewiseConstant2d`] | 4 bytes a cell and a row | those of two `Cdf` |
//! | a triangle mesh, and want a point on it | [`Mesh`] | 8 bytes a face | that of a `Cdf`, and a root |
//! | several warps, and want a point of one of them by its weight | [`Mixture`] | 16 bytes | that of a `Cdf`, and the warp |
//! | a picture of all directions, and want a direction | [`LatLongMap`] | 4 bytes a pixel and a row | those of two `Cdf`, and two angles |
//!
//! A table of `u32` words, the usual one, has probabilities in steps of 2⁻³² and takes one `u32` of the generator.
//! Weights of very different size, such as 1 beside 10⁻²⁰, need a table of `u64`: steps of 2⁻⁶⁴, two `u32`, and
//! twice the memory.
//!
//! | the weights are | table in | made by |
//! |---|---|---|
//! | an array | an array; a `const` lies in flash | `new`, `from_integers`; `new_u64`, `from_integers_u64` |
//! | a slice, few enough for a fixed capacity | `heapless::Vec` | `from_slice`, `from_integer_slice` |
//! | a slice of any length, on a host | `Vec` or `Box` (feature `alloc`) | `from_slice`, `from_integer_slice` |
//! | a slice, and you have the memory | borrowed memory | `new_in`, `from_integers_in` |
//! | a finished table, stored or sent | any of these | `from_words`; unchecked and in constant time `from_trusted_words` |
//!
//! The constructors of an array build the table on the stack, which takes up to 4 times its size and 2 KiB. `new_in`,
//! and `from_slice` on the heap, take 2 KiB of stack whatever the size. (Measured on a 64-bit host; unoptimised builds
//! take up to 8 times and 8 KiB.)
//!
//! # What all have in common
//! Weights become integers once, their sums are exact, and a selection compares integers. The probability that a
//! table reports is the one with which it selects, to the last bit, and the same 32 bits select the same index on
//! every target. A weight of zero is never selected. Tables need no elementary function and serve every tier.
//!
//! From integer weights (`from_integers`) to an index (`draw_index`) or an [`ExactSelection`] (`draw_exact`) there is
//! no floating-point operation, for cores without an FPU.

mod alias;
mod apportionment;
mod binomial;
mod bins;
mod cdf;
mod cells;
mod chooser;
mod combination;
mod discrete_gaussian;
mod discrete_laplace;
mod ends;
pub mod filter;
mod geometric;
mod hypergeometric;
mod lat_long_map;
mod layout;
mod light_reservoir;
mod mesh;
mod mixture;
mod negative_binomial;
mod piecewise1d;
mod piecewise2d;
mod piecewise_linear1d;
mod poisson;
pub mod resampling;
mod reservoir;
mod selection;
mod signed_linear1d;
mod single_selection;
mod storage;
mod sum_tree;
mod total;
mod weighted_reservoir;
mod weights;
mod word;
mod zones;

pub use self::alias::Alias;
pub use self::binomial::Binomial;
pub use self::bins::AliasEntry;
pub use self::cdf::Cdf;
pub use self::combination::Normaliser;
pub use self::discrete_gaussian::DiscreteGaussian;
pub use self::discrete_laplace::DiscreteLaplace;
pub use self::geometric::Geometric;
pub use self::hypergeometric::Hypergeometric;
pub use self::lat_long_map::{LatLongMap, PixelSample};
pub use self::light_reservoir::LightReservoir;
pub use self::mesh::{Mesh, MeshPoint};
pub use self::mixture::{InvertParts, Mixture, Parts};
pub use self::negative_binomial::NegativeBinomial;
pub use self::piecewise_linear1d::PiecewiseLinear1d;
pub use self::piecewise1d::PiecewiseConstant1d;
pub use self::piecewise2d::PiecewiseConstant2d;
pub use self::poisson::Poisson;
pub use self::reservoir::Reservoir;
pub use self::selection::{ExactSelection, Selection};
pub use self::signed_linear1d::SignedLinear1d;
pub use self::single_selection::{select_once, select_once_uniform};
pub use self::storage::{Grid, OwnedStorage, Storage};
pub use self::sum_tree::SumTree;
pub use self::weighted_reservoir::WeightedReservoir;
pub use self::word::Word;

use crate::warp::{Area, Length, SolidAngle};

crate::warp::taken_by! {
    [S] PiecewiseConstant1d<S>: Length;
    [S, V] PiecewiseLinear1d<S, V>: Length;
    [M, C] PiecewiseConstant2d<M, C>: Area;
    [I, S] Mesh<'_, I, S>: Area;
    [T, M, C] LatLongMap<T, M, C>: SolidAngle;
}

/// The most entries a table may have, 2²⁴: as many as there are points on the grid of an `f32` uniform.
pub const MAX_ENTRIES: usize = 1 << 24;

/// The bits of the largest weight of a table, at least. Every other weight is kept to the same unit, and a positive
/// one to no less than one unit, so a weight of 24 bits is exact from 2⁻⁴⁷ of the largest up.
pub const WEIGHT_BITS: u32 = 71;
