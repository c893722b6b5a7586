//! Discrete and tabulated distributions: an index by its weight, a cell by its height.
//!
//! Here live the tables ([`Cdf`], [`Alias`]), the piecewise-constant densities that stand on them
//! ([`PiecewiseConstant1d`], [`PiecewiseConstant2d`]), and selection without a table ([`select_once`],
//! [`Reservoir`]). Rejection is in another room.
//!
//! Weights are turned into integers once, sums are exact, selection compares integers: the probability a
//! table reports is the probability with which it selects, to the last bit, and the same 32 bits select
//! the same index on every target. The tables need no elementary function and serve every tier.
//!
//! From integer weights (`from_integers`) to an index (`draw_index`) or an [`ExactSelection`] (`draw_exact`) there is
//! no floating-point operation, nor in a program that does no more: for cores without a unit for it.
//!
//! | | entries | memory an entry | random bits a selection | steps of the probabilities |
//! |---|---|---|---|---|
//! | [`Cdf`] of `u32` | up to [`MAX_ENTRIES`] | 4 bytes | 32 | 2⁻³² |
//! | [`Cdf`] of `u64` | up to [`MAX_ENTRIES`] | 8 bytes | 64 | 2⁻⁶⁴ |
//! | [`Alias`] of `u32` | up to [`MAX_ENTRIES`], room for a power of two | 12 bytes | 32 | 2⁻³² |
//! | [`Alias`] of `u64` | up to [`MAX_ENTRIES`], room for a power of two | 24 bytes | 64 | 2⁻⁶⁴ |
//! | [`select_once`] | any number | none | 32 | 2⁻³² |
//! | [`Reservoir`] | any number | one item | 64 an item | 2⁻⁶⁴ |

mod alias;
mod bins;
mod cdf;
mod cells;
mod ladder;
mod once;
mod piecewise1d;
mod piecewise2d;
mod reservoir;
mod selection;
mod source;
mod storage;
mod total;
mod word;

pub use self::alias::Alias;
pub use self::bins::AliasEntry;
pub use self::cdf::Cdf;
pub use self::once::{select_once, select_once_uniform};
pub use self::piecewise1d::PiecewiseConstant1d;
pub use self::piecewise2d::PiecewiseConstant2d;
pub use self::reservoir::Reservoir;
pub use self::selection::{ExactSelection, Selection};
pub use self::storage::{Grid, Storage};
pub use self::word::Word;

/// The most entries a table may have, 2²⁴: as many as there are points on the grid of an `f32` uniform.
pub const MAX_ENTRIES: usize = 1 << 24;

/// The bits of the largest weight of a table, at least; every other is kept to the same unit, and a positive
/// one never to less than one unit. A weight of 24 bits is thus exact from 2⁻⁴⁷ of the largest up.
pub const WEIGHT_BITS: u32 = 71;
