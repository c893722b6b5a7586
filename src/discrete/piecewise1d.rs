//! A density that is constant on each of equal cells of an interval.

use super::cdf::Cdf;
use super::cells::Cells;
use super::selection::amount;
use super::storage::{OwnedStorage, Storage};
use super::word::Word;
use crate::error::Error;
use crate::num::{into_unit, representable};
use crate::uniform::Canonical;
use crate::warp::{Invert, Warp};
use rand_core::TryRng;

/// A histogram as a density: constant on each of equal cells of an interval [low, high).
///
/// One uniform selects the cell, and what is left of it places the point within the cell. This is the inverse
/// of the cumulative distribution, so points increase with the uniform.
///
#[cfg_attr(doc, doc = include_str!("../pictures/piecewise_constant1d.html"))]
///
/// # Density
/// The probability of the cell over its width, both as realised; 0 in a cell of weight zero and outside. A cell
/// contains its lower edge, and `high` counts as part of the last cell.
///
/// # Domain
/// - Weights: those of [`Cdf`], one a cell. The edges of cells are (1 − t) low + t high with t = j/n, each
///   operation rounded to `f32`. A cell must be at least 2⁻²⁰ of the larger bound wide.
/// - Uniforms: one. A draw takes one `u32` of the generator for a table of `u32` and two for a table of `u64`,
///   and uses all their bits, so it reaches cells that the 24-bit grid of an `f32` passes over.
/// - Storage: that of the [`Cdf`], with the same constructors: [`new`](PiecewiseConstant1d::new) takes an array,
///   [`from_slice`](PiecewiseConstant1d::from_slice) and [`new_in`](PiecewiseConstant1d::new_in) take slices,
///   and [`from_cdf`](PiecewiseConstant1d::from_cdf) takes any finished table.
///
/// # Accuracy
/// Errors are against the probabilities of the table; [`Cdf`] says how far those are from the weights. Both
/// tiers share this code. The error of a sample is in ulp of the larger bound; r is what one ulp of the larger
/// bound makes of the inverse.
///
/// | error | bound | kind |
/// |---|--:|---|
/// | sample, ulp of the scale | 5.2 | found |
/// | pdf, relative | 2.4e-7 | found |
/// | realised density, relative | 2.4e-7 | found |
/// | inverse | 3.2e-7 | found |
/// | round trip | 1.5e-7 + 3*r | found |
///
/// A cell of few words has as few distinct points, and one of a single word yields its lower edge. The inverse
/// is an `f32`, so it returns only nearly to cells of probability below some 2⁻²⁴.
///
/// # Cost
/// That of a selection from a [`Cdf`](super::Cdf), and of a product.
///
/// # Examples
/// ```
/// use microwarp::{Invert, Warp};
/// use microwarp::discrete::PiecewiseConstant1d;
/// let histogram = PiecewiseConstant1d::new(&[1.0, 0.0, 2.0, 1.0], 0.0, 8.0)?;
/// assert_eq!(histogram.sample(0.375), 4.5);
/// assert_eq!(histogram.pdf(4.5), 0.25);
/// assert_eq!(histogram.pdf(3.0), 0.0);
/// assert_eq!(histogram.invert(4.5), 0.375);
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// # See also
/// - [`Cdf`]: the index alone.
/// - [`PiecewiseConstant2d`](super::PiecewiseConstant2d): cells of a rectangle.
///
/// # Source
/// M. Pharr, W. Jakob and G. Humphreys, *Physically Based Rendering*, 4th edition, 2023, appendix A.4:
/// <https://pbr-book.org/4ed/Sampling_Algorithms/Sampling_1D_Functions>.
#[doc(alias = "histogram")]
#[doc(alias = "Distribution1D")]
#[doc(alias = "piecewise_constant_distribution")]
#[doc(alias = "tabulated")]
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

/// The constructors that `const` code can call: there, code cannot be generic over the word.
macro_rules! arrays {
    ($(
        $word:ident;
        $(#[$new_doc:meta])*
        $new:ident;
        $(#[$integers_doc:meta])*
        $from_integers:ident;
    )*) => {$(
        impl<const N: usize> PiecewiseConstant1d<[$word; N]> {
            $(#[$new_doc])*
            pub const fn $new(weights: &[f32; N], low: f32, high: f32) -> Result<Self, Error> {
                Self::array(Cdf::<[$word; N]>::$new(weights), low, high)
            }

            $(#[$integers_doc])*
            pub const fn $from_integers(
                weights: &[u32; N],
                low: f32,
                high: f32,
            ) -> Result<Self, Error> {
                Self::array(Cdf::<[$word; N]>::$from_integers(weights), low, high)
            }

            const fn array(
                cdf: Result<Cdf<[$word; N]>, Error>,
                low: f32,
                high: f32,
            ) -> Result<Self, Error> {
                let cdf = match cdf {
                    Ok(cdf) => cdf,
                    Err(error) => return Err(error),
                };
                match Cells::new([low, high], [1, 2], N) {
                    Ok(cells) => Ok(Self::within(cdf, cells)),
                    Err(error) => Err(error),
                }
            }
        }
    )*};
}

arrays! {
    u32;
    /// An array of weights as the masses of equal cells of [low, high), with words of 32 bits. `const`.
    ///
    /// # Errors
    /// Those of [`Cdf::new`] and of [`PiecewiseConstant1d::from_cdf`].
    ///
    /// # Cost
    /// At most 4 times the table and 2 KiB of stack, the table included; up to 8 times without optimisation. For
    /// large tables take [`PiecewiseConstant1d::new_in`], or with feature `alloc`
    /// [`PiecewiseConstant1d::from_slice`].
    new;
    /// An array of integer weights as the masses of equal cells of [low, high), with words of 32 bits. `const`.
    ///
    /// # Errors
    /// Those of [`Cdf::from_integers`] and of [`PiecewiseConstant1d::from_cdf`].
    from_integers;
    u64;
    /// An array of weights as the masses of equal cells of [low, high), with words of 64 bits: for weights of
    /// very different size. `const`.
    ///
    /// # Errors
    /// Those of [`Cdf::new_u64`] and of [`PiecewiseConstant1d::from_cdf`].
    new_u64;
    /// An array of integer weights, which are `u32` here too, as the masses of equal cells of [low, high), with
    /// words of 64 bits. `const`.
    ///
    /// # Errors
    /// Those of [`Cdf::from_integers_u64`] and of [`PiecewiseConstant1d::from_cdf`].
    from_integers_u64;
}

impl<W: Word, S: Storage<Item = W>> PiecewiseConstant1d<S> {
    /// A slice of weights as the masses of equal cells of [low, high), in storage of its own: see
    /// [`Cdf::from_slice`].
    ///
    /// # Errors
    /// Those of [`Cdf::from_slice`] and of [`PiecewiseConstant1d::from_cdf`].
    ///
    /// # Examples
    /// ```
    /// use microwarp::{Warp, discrete::PiecewiseConstant1d};
    /// let weights = vec![1.0, 0.0, 2.0, 1.0];
    /// let histogram = PiecewiseConstant1d::<heapless::Vec<u32, 16>>::from_slice(&weights, 0.0, 8.0)?;
    /// assert_eq!(histogram.sample(0.375), 4.5);
    /// # Ok::<(), microwarp::Error>(())
    /// ```
    pub fn from_slice(weights: &[f32], low: f32, high: f32) -> Result<Self, Error>
    where
        S: OwnedStorage,
    {
        Self::from_cdf(Cdf::from_slice(weights)?, low, high)
    }

    /// A slice of integer weights as the masses of equal cells of [low, high), in storage of its own.
    ///
    /// # Errors
    /// Those of [`Cdf::from_integer_slice`] and of [`PiecewiseConstant1d::from_cdf`].
    pub fn from_integer_slice(weights: &[u32], low: f32, high: f32) -> Result<Self, Error>
    where
        S: OwnedStorage,
    {
        Self::from_cdf(Cdf::from_integer_slice(weights)?, low, high)
    }
}

impl<'a, W: Word> PiecewiseConstant1d<&'a [W]> {
    /// A slice of weights as the masses of equal cells of [low, high), with the table at the beginning of
    /// borrowed memory: see [`Cdf::new_in`].
    ///
    /// # Errors
    /// Those of [`Cdf::new_in`] and of [`PiecewiseConstant1d::from_cdf`].
    ///
    /// # Cost
    /// At most 2 KiB of stack, whatever the number of weights; up to 8 KiB without optimisation.
    pub fn new_in(
        weights: &[f32],
        low: f32,
        high: f32,
        memory: &'a mut [W],
    ) -> Result<Self, Error> {
        Self::from_cdf(Cdf::new_in(weights, memory)?, low, high)
    }

    /// A slice of integer weights as the masses of equal cells of [low, high), with the table at the beginning
    /// of borrowed memory.
    ///
    /// # Errors
    /// Those of [`Cdf::from_integers_in`] and of [`PiecewiseConstant1d::from_cdf`].
    pub fn from_integers_in(
        weights: &[u32],
        low: f32,
        high: f32,
        memory: &'a mut [W],
    ) -> Result<Self, Error> {
        Self::from_cdf(Cdf::from_integers_in(weights, memory)?, low, high)
    }
}

impl<W: Word, S: Storage<Item = W>> PiecewiseConstant1d<S> {
    /// The entries of a finished table as cells of [low, high), in constant time.
    ///
    /// A table of [`Cdf::from_trusted_words`] may have wrong words: then points are still in [low, high), and
    /// densities finite.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for NaN or infinite bounds, [`Error::Reversed`] for low > high,
    /// [`Error::Empty`] for bounds that are equal or so close that cells are narrower than 2⁻²⁰ of the
    /// larger bound or a density could overflow.
    pub fn from_cdf(cdf: Cdf<S>, low: f32, high: f32) -> Result<Self, Error> {
        let cells = Cells::new([low, high], [1, 2], cdf.entries())?;
        Ok(Self::within(cdf, cells))
    }

    /// The lower bound.
    #[must_use]
    #[inline]
    pub const fn low(&self) -> f32 {
        self.cells.range()[0]
    }

    /// The upper bound.
    #[must_use]
    #[inline]
    pub const fn high(&self) -> f32 {
        self.cells.range()[1]
    }

    /// The table that selects cells.
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

    /// The cell that a point lies in; nothing outside.
    #[inline]
    pub(crate) fn cell_at(&self, x: f32) -> Option<usize> {
        self.cells.contains(x).then(|| self.cells.find(x))
    }

    /// The probability of a cell; nothing for a weight of zero.
    #[inline]
    pub(crate) fn mass(&self, index: usize) -> Option<f32> {
        let (_, count) = self.cdf.mass(index)?;
        Some(amount(count) * W::STEP)
    }

    #[inline]
    pub(crate) const fn cells(&self) -> &Cells {
        &self.cells
    }

    /// The cell that a word, and what lies below it, selects; and the point within it.
    #[allow(
        clippy::inline_always,
        reason = "programs with tables of two dimensions take 130 bytes less and more"
    )]
    #[inline(always)]
    pub(crate) fn cell_and_place(&self, (word, fraction): (W, f32)) -> (usize, f32) {
        let share = self.cdf.locate(word);
        let x = self.cells.place(share.index, share.leftover(fraction));
        (share.index, x)
    }

    /// The density in a cell.
    #[inline]
    fn density(&self, index: usize) -> f32 {
        self.mass(index)
            .map_or(0.0, |mass| representable(self.cells.density(index, mass)))
    }

    /// The point of a word, and what lies below it, with the density: that of the cell, which need not be found again.
    #[inline]
    fn with_density(&self, place: (W, f32)) -> (f32, f32) {
        let (index, x) = self.cell_and_place(place);
        (x, self.density(index))
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
        self.cell_at(x).map_or(0.0, |index| self.density(index))
    }

    // Written as the trait writes it: what compares public items takes another spelling for a change.
    #[inline]
    fn sample_canonical_with_pdf(
        &self,
        u: Canonical<Self::Uniforms>,
    ) -> (Self::Point, Self::Density) {
        self.with_density(W::from_uniform(u))
    }

    #[inline]
    fn sample_words(&self, word: u32) -> f32 {
        self.cell_and_place((W::from_bits(word), 0.0)).1
    }

    #[inline]
    fn try_draw<R: TryRng + ?Sized>(&self, rng: &mut R) -> Result<f32, R::Error> {
        Ok(self.cell_and_place((W::try_draw(rng)?, 0.0)).1)
    }

    #[inline]
    fn try_draw_with_pdf<R: TryRng + ?Sized>(
        &self,
        rng: &mut R,
    ) -> Result<(Self::Point, Self::Density), R::Error>
    where
        Self: Sized,
    {
        Ok(self.with_density((W::try_draw(rng)?, 0.0)))
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
