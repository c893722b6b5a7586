//! A density that is constant on each of equal cells of an interval.

use super::cdf::Cdf;
use super::cells::Cells;
use super::selection::amount;
use super::storage::Storage;
use super::word::Word;
use crate::error::Error;
use crate::num::{into_unit, representable};
use crate::uniform::Canonical;
use crate::warp::{Invert, Warp};
use rand_core::TryRng;

/// Piecewise constant on an interval [low, high): a table's entries as the masses of equal cells.
///
/// The uniform selects the cell and what is left of it the place in the cell: the inverse of a cdf made of
/// straight pieces, increasing with the uniform.
///
/// - Storage: that of the [`Cdf`]; a `const` table has all of it in flash.
/// - Uniforms: one. Drawing takes one `u32` from a table of `u32` and two from a table of `u64`, and uses
///   all their bits: it reaches cells that the 24-bit grid of an `f32` passes over.
/// - Density: the cell's probability over its width, both as realised; 0 in a cell of weight zero. A cell
///   contains its lower edge, and `high` counts as part of the last.
/// - Cells: their edges are (1 − t) low + t high with t = j/n, each operation rounded to `f32`. A cell must
///   be at least 2⁻²⁰ of the larger bound wide.
/// - Errors are against the probabilities of the table, which are whole numbers of words; how far those may be from the
///   weights is said at [`Cdf`]. The figures hold in both tiers, which share this code; of `sample` they are in
///   ulp of the larger bound.
/// - Where a cell has few words it has as few places: one of a single word yields its lower edge. And since
///   the inverse is an `f32`, it returns to cells of probability below some 2⁻²⁴ only nearly.
///
/// | error | `libm` | `poly` |
/// |---|--:|--:|
/// | sample, ulp of the scale | 4.1 | 4.1 |
/// | pdf, relative | 1.8e-7 | 1.8e-7 |
/// | realised density, relative | 1.8e-7 | 1.8e-7 |
/// | inverse | 2.7e-7 | 2.7e-7 |
/// | round trip | 1.2e-7 + 2.5*r | 1.2e-7 + 2.5*r |
///
/// r is what one ulp of the larger bound makes of the inverse.
///
/// Source: M. Pharr, W. Jakob and G. Humphreys, "Physically Based Rendering", 2023.
///
/// ```
/// use microwarp::{Invert, Warp};
/// use microwarp::discrete::{Cdf, PiecewiseConstant1d};
/// let cdf = Cdf::<[u32; 4]>::new(&[1.0, 0.0, 2.0, 1.0])?;
/// let histogram = PiecewiseConstant1d::new(cdf, 0.0, 8.0)?;
/// assert_eq!(histogram.sample(0.375), 4.5);
/// assert_eq!(histogram.pdf(4.5), 0.25);
/// assert_eq!(histogram.pdf(3.0), 0.0);
/// assert_eq!(histogram.invert(4.5), 0.375);
/// # Ok::<(), microwarp::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct PiecewiseConstant1d<S> {
    cdf: Cdf<S>,
    cells: Cells,
}

impl<S> PiecewiseConstant1d<S> {
    /// A table whose entries are known to be as many as the cells.
    #[inline]
    pub(crate) const fn within(cdf: Cdf<S>, cells: Cells) -> Self {
        Self { cdf, cells }
    }
}

macro_rules! from_weights {
    ($word:ident) => {
        impl<const N: usize> PiecewiseConstant1d<[$word; N]> {
            /// These weights as the masses of equal cells of [low, high), as an array: for a `const`.
            ///
            /// # Errors
            /// Those of [`Cdf::new`] and of [`PiecewiseConstant1d::new`].
            pub const fn from_weights(
                weights: &[f32; N],
                low: f32,
                high: f32,
            ) -> Result<Self, Error> {
                let cdf = match Cdf::<[$word; N]>::new(weights) {
                    Ok(cdf) => cdf,
                    Err(error) => return Err(error),
                };
                match Cells::new([low, high], N) {
                    Ok(cells) => Ok(Self::within(cdf, cells)),
                    Err(error) => Err(error),
                }
            }
        }
    };
}

from_weights!(u32);
from_weights!(u64);

impl<W: Word, S: Storage<Item = W>> PiecewiseConstant1d<S> {
    /// The entries of a table as cells of [low, high).
    ///
    /// # Errors
    /// [`Error::NotFinite`] for NaN or infinite bounds, [`Error::Reversed`] for low > high,
    /// [`Error::Empty`] for bounds that are equal or so close that cells are narrower than 2⁻²⁰ of the
    /// larger bound or a density could overflow.
    pub fn new(cdf: Cdf<S>, low: f32, high: f32) -> Result<Self, Error> {
        let cells = Cells::new([low, high], cdf.entries())?;
        Ok(Self::within(cdf, cells))
    }

    /// The table of the cells.
    #[must_use]
    #[inline]
    pub const fn cdf(&self) -> &Cdf<S> {
        &self.cdf
    }

    /// The index of the cell that a point lies in; that of the nearer end for a point outside.
    #[must_use]
    #[inline]
    pub fn cell(&self, x: f32) -> usize {
        self.cells.find(x)
    }

    /// The cell that a point lies in and its probability; nothing outside and for a weight of zero.
    #[inline]
    pub(crate) fn mass_at(&self, x: f32) -> Option<(usize, f32)> {
        if !self.cells.contains(x) {
            return None;
        }
        let index = self.cells.find(x);
        let (_, count) = self.cdf.mass(index)?;
        Some((index, amount(count) * W::STEP))
    }

    #[inline]
    pub(crate) const fn cells(&self) -> &Cells {
        &self.cells
    }

    /// The cell that a word, and what lies below it, selects; and the point within it.
    #[inline]
    pub(crate) fn cell_and_place(&self, (word, fraction): (W, f32)) -> (usize, f32) {
        let share = self.cdf.locate(word);
        let x = self.cells.place(share.index, share.leftover(fraction));
        (share.index, x)
    }
}

impl<W: Word, S: Storage<Item = W>> Warp for PiecewiseConstant1d<S> {
    type Uniforms = f32;
    type Point = f32;
    type Density = f32;

    #[inline]
    fn sample_canonical(&self, u: Canonical<f32>) -> f32 {
        self.cell_and_place(W::from_uniform(u)).1
    }

    #[inline]
    fn pdf(&self, x: f32) -> f32 {
        match self.mass_at(x) {
            Some((index, mass)) => representable(self.cells.density(index, mass)),
            None => 0.0,
        }
    }

    #[inline]
    fn sample_words(&self, word: u32) -> f32 {
        self.cell_and_place((W::from_bits(word), 0.0)).1
    }

    #[inline]
    fn try_draw<R: TryRng + ?Sized>(&self, rng: &mut R) -> Result<f32, R::Error> {
        Ok(self.cell_and_place((W::try_draw(rng)?, 0.0)).1)
    }
}

impl<W: Word, S: Storage<Item = W>> Invert for PiecewiseConstant1d<S> {
    #[inline]
    fn invert(&self, x: f32) -> f32 {
        let index = self.cells.find(x);
        let (start, mass) = match self.cdf.mass(index) {
            Some((start, count)) => (start, amount(count)),
            None => (self.cdf.share(index).0, 0.0),
        };
        let within = mass * self.cells.fraction(index, x);
        into_unit((start.as_f32() + within) * W::STEP)
    }
}
