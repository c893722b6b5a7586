//! A density that is linear between equally spaced points of an interval.

use super::cdf::{Cdf, room};
use super::cells::Cells;
use super::piecewise1d::PiecewiseConstant1d;
use super::selection::{Share, amount};
use super::storage::{OwnedStorage, Storage};
use super::weights::Weights;
use super::word::Word;
use crate::error::Error;
use crate::num::{Scaled, above_zero, into_unit, representable};
use crate::tier::sqrt;
use crate::uniform::Canonical;
use crate::warp::{Invert, Warp};
use rand_core::TryRng;

/// A table of a density: linear between weights at equally spaced points of an interval [low, high).
///
/// One uniform selects a cell between two neighbouring points, the vertices, by the area of its trapezoid. What is left
/// of the uniform, a number of words, places the point within the cell, measured from the nearer end. This is the
/// inverse of the cumulative distribution, so points increase with the uniform.
///
#[cfg_attr(doc, doc = include_str!("../pictures/piecewise_linear1d.html"))]
///
/// # Density
/// In a cell of width h, probability p and weights a and b at its ends, p/h · 2((1 − t)a + tb)/(a + b) at the part t of
/// the cell. It is 0 in a cell with a weight of zero at both ends, at a vertex of weight zero, and outside. `high`
/// counts as part of the last cell.
///
/// The probability is that of the words of the cell, as realised. The density therefore jumps at a vertex, by at most
/// 2⁻³²(1/p₀ + 1/p₁) + 10 · 2⁻²⁴ m/h of itself: p₀ and p₁ are the probabilities of its cells, h is their width, and m
/// the larger bound. With `u64` and n cells the first term is (n 2⁻⁶⁴ + 2⁻⁵⁵)(1/p₀ + 1/p₁).
///
/// # Domain
/// - Weights: those of [`Cdf`], one a vertex and two at least. The vertices are the edges of cells as
///   [`PiecewiseConstant1d`](super::PiecewiseConstant1d) has them: one cell less than weights, each at least 2⁻²⁰ of the
///   larger bound wide.
/// - Uniforms: one. A draw takes one `u32` of the generator for a table of `u32` and two for a table of `u64`.
/// - Storage: a word a vertex, and the weights, which shape each cell: 8 bytes a vertex with `u32`, 12 with `u64`.
///   [`new`](PiecewiseLinear1d::new) takes an array, and a `const` lies in flash;
///   [`from_slice`](PiecewiseLinear1d::from_slice) takes slices, and [`new_in`](PiecewiseLinear1d::new_in) borrows both
///   weights and memory.
///
/// # Accuracy
/// Errors are against the probabilities of the table; [`Cdf`] says how far those are from the areas, for which a weight
/// is kept exactly unless it is below 2⁻⁴⁶ of the largest. Both tiers share this code. The error of a sample is in ulp
/// of the larger bound; r and s are what one ulp of the larger bound makes of the inverse, and of the density
/// relatively.
///
/// | error | bound | kind |
/// |---|--:|---|
/// | sample, ulp of the scale | 8.6 | found |
/// | pdf, relative | 7.5e-7 | found |
/// | realised density, relative | 7e-7 + 4.4*s | found |
/// | inverse | 4.4e-7 | found |
/// | round trip | 3.4e-7 + 1.9*r | found |
///
/// # Cost
/// That of a selection from a [`Cdf`](super::Cdf), of one root or two, and of four quotients.
///
/// # Examples
/// ```
/// use microwarp::{Invert, Warp};
/// use microwarp::discrete::PiecewiseLinear1d;
/// let hill = PiecewiseLinear1d::new(&[0.0, 2.0, 0.0, 0.0, 1.0], 0.0, 4.0)?;
/// assert_eq!(hill.pdf(1.0), 0.8);
/// assert_eq!(hill.pdf(0.5), 0.4);
/// assert_eq!(hill.pdf(2.5), 0.0);
/// assert_eq!(hill.sample(0.4), 1.0);
/// assert_eq!(hill.invert(3.5), 0.85);
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// # See also
/// - [`PiecewiseConstant1d`](super::PiecewiseConstant1d): a histogram, of half the memory.
/// - [`SignedLinear1d`](super::SignedLinear1d): a function of either sign.
/// - [`Linear`](crate::warp::Linear): one cell.
///
/// # Source
/// M. Pharr, W. Jakob and G. Humphreys, *Physically Based Rendering*, 4th edition, 2023, appendix A.4:
/// <https://pbr-book.org/4ed/Sampling_Algorithms/Sampling_1D_Functions>.
#[doc(alias = "piecewise_linear_distribution")]
#[doc(alias = "interpolated")]
#[doc(alias = "spectrum")]
#[doc(alias = "tabulated")]
#[doc(alias = "trapezoid")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct PiecewiseLinear1d<S, V> {
    /// The areas of the cells, and a last entry that has none.
    cells: PiecewiseConstant1d<S>,
    weights: V,
}

/// The cells between so many vertices, on a range whose bounds are the parameters of these places.
const fn between(range: [f32; 2], places: [usize; 2], vertices: usize) -> Result<Cells, Error> {
    match Cells::new(range, places, vertices.saturating_sub(1)) {
        Ok(cells) => match cells.check_steep(places[1]) {
            Ok(()) => Ok(cells),
            Err(error) => Err(error),
        },
        Err(error) => Err(error),
    }
}

/// The constructors that `const` code can call: there, code cannot be generic over the word.
macro_rules! arrays {
    ($($word:ident; $(#[$doc:meta])* $new:ident;)*) => {$(
        impl<const N: usize> PiecewiseLinear1d<[$word; N], [f32; N]> {
            $(#[$doc])*
            pub const fn $new(weights: &[f32; N], low: f32, high: f32) -> Result<Self, Error> {
                let cdf = match Cdf::<[$word; N]>::array(Weights::neighbours(weights)) {
                    Ok(cdf) => cdf,
                    Err(error) => return Err(error),
                };
                match between([low, high], [1, 2], N) {
                    Ok(cells) => Ok(Self {
                        cells: PiecewiseConstant1d::within(cdf, cells),
                        weights: *weights,
                    }),
                    Err(error) => Err(error),
                }
            }
        }
    )*};
}

arrays! {
    u32;
    /// An array of weights at equally spaced points from `low` to `high`, with words of 32 bits. `const`.
    ///
    /// # Errors
    /// Those of [`Cdf::new`], and of [`PiecewiseConstant1d::from_cdf`](super::PiecewiseConstant1d::from_cdf) for the
    /// bounds; [`Error::NoWeights`] for fewer than two weights. [`Error::Unreachable`] names the first vertex of a
    /// cell.
    ///
    /// # Cost
    /// At most 4 times the table and 2 KiB of stack, the table included; up to 8 times without optimisation. For
    /// large tables take [`PiecewiseLinear1d::new_in`], or with feature `alloc` [`PiecewiseLinear1d::from_slice`].
    new;
    u64;
    /// An array of weights at equally spaced points from `low` to `high`, with words of 64 bits: for weights of very
    /// different size. `const`.
    ///
    /// # Errors
    /// Those of [`PiecewiseLinear1d::new`], except [`Error::Unreachable`].
    new_u64;
}

impl<'a, W: Word> PiecewiseLinear1d<&'a [W], &'a [f32]> {
    /// A slice of weights at equally spaced points from `low` to `high`, which stays borrowed, with one word a weight
    /// at the beginning of borrowed memory.
    ///
    /// # Errors
    /// Those of [`PiecewiseLinear1d::new`]; [`Error::TooManyWeights`] also where the memory has no room for the words.
    ///
    /// # Cost
    /// At most 2 KiB of stack, whatever the number of weights; up to 8 KiB without optimisation.
    pub fn new_in(
        weights: &'a [f32],
        low: f32,
        high: f32,
        memory: &'a mut [W],
    ) -> Result<Self, Error> {
        let cells = Weights::neighbours(weights)?;
        let cdf = Cdf::<&[W]>::borrowed(cells, weights.len(), memory)?;
        Ok(Self {
            cells: PiecewiseConstant1d::within(cdf, between([low, high], [1, 2], weights.len())?),
            weights,
        })
    }
}

impl<W, S, V> PiecewiseLinear1d<S, V>
where
    W: Word,
    S: Storage<Item = W>,
    V: Storage<Item = f32>,
{
    /// A slice of weights at equally spaced points from `low` to `high`, in storage of its own: see
    /// [`Cdf::from_slice`].
    ///
    /// # Errors
    /// Those of [`PiecewiseLinear1d::new`]; [`Error::TooManyWeights`] also where the storage has no room for them.
    ///
    /// # Examples
    /// ```
    /// use microwarp::{Warp, discrete::PiecewiseLinear1d};
    /// use heapless::Vec;
    /// let weights = vec![1.0, 1.0, 3.0];
    /// let table = PiecewiseLinear1d::<Vec<u32, 8>, Vec<f32, 8>>::from_slice(&weights, 0.0, 2.0)?;
    /// assert_eq!(table.pdf(2.0), 1.0);
    /// # Ok::<(), microwarp::Error>(())
    /// ```
    pub fn from_slice(weights: &[f32], low: f32, high: f32) -> Result<Self, Error>
    where
        S: OwnedStorage,
        V: OwnedStorage,
    {
        let cells = Weights::neighbours(weights)?;
        let mut kept: V = room(0.0, weights.len())?;
        for (slot, weight) in kept.items_mut().iter_mut().zip(weights) {
            *slot = *weight;
        }
        let cdf = Cdf::owned(cells, weights.len())?;
        Ok(Self {
            cells: PiecewiseConstant1d::within(cdf, between([low, high], [1, 2], weights.len())?),
            weights: kept,
        })
    }

    /// A finished table, as [`PiecewiseLinear1d::cdf`] gave it, with its weights: kept in flash by another program, or
    /// sent over a wire. The weights are checked. That they belong to the table is not: they shape the density within
    /// each cell, and the table says how probable the cell is.
    ///
    /// # Errors
    /// [`Error::NotATable`] where there are not as many weights as entries, or where the last entry is not empty;
    /// [`Error::NotFiniteWeight`], [`Error::NegativeWeight`]; those of [`PiecewiseLinear1d::new`] for the bounds.
    pub fn from_cdf(cdf: Cdf<S>, weights: V, low: f32, high: f32) -> Result<Self, Error> {
        let count = cdf.entries();
        let beyond = cdf.mass(count.saturating_sub(1));
        if weights.items().len() != count || beyond.is_some() {
            return Err(Error::NotATable);
        }
        for (index, weight) in weights.items().iter().enumerate() {
            if !weight.is_finite() {
                return Err(Error::NotFiniteWeight(index));
            }
            if *weight < 0.0 {
                return Err(Error::NegativeWeight(index));
            }
        }
        Ok(Self {
            cells: PiecewiseConstant1d::within(cdf, between([low, high], [2, 3], count)?),
            weights,
        })
    }

    /// The lower bound.
    #[must_use]
    #[inline]
    pub const fn low(&self) -> f32 {
        self.cells.low()
    }

    /// The upper bound.
    #[must_use]
    #[inline]
    pub const fn high(&self) -> f32 {
        self.cells.high()
    }

    /// The table that selects cells. Each cell is an entry, and there is a last one that is never selected.
    #[must_use]
    #[inline]
    pub const fn cdf(&self) -> &Cdf<S> {
        self.cells.cdf()
    }

    #[inline]
    pub(super) const fn cells(&self) -> &PiecewiseConstant1d<S> {
        &self.cells
    }

    /// The weights of the vertices.
    #[must_use]
    #[inline]
    pub fn weights(&self) -> &[f32] {
        self.weights.items()
    }

    /// The index of the cell that a point lies in; that of the nearer end for a point outside.
    #[must_use]
    #[inline]
    pub fn cell(&self, x: f32) -> usize {
        self.cells.cell(x)
    }

    #[inline]
    fn slope(&self, index: usize) -> Slope {
        let weight = |index: usize| self.weights.items().get(index).copied().unwrap_or(0.0);
        Slope::new(weight(index), weight(index.wrapping_add(1)))
    }

    /// The cell that a word, and what lies below it, selects; and the point within it.
    #[inline]
    pub(super) fn cell_and_place(&self, (word, fraction): (W, f32)) -> (usize, f32) {
        let share = self.cdf().locate(word);
        let slope = self.slope(share.index);
        let place = slope.place(&share, fraction);
        let cells = self.cells.cells();
        let x = cells.place_from(share.index, place, slope.low == 0.0);
        (share.index, x)
    }

    /// The density at a point of a cell.
    #[inline]
    fn density(&self, index: usize, x: f32) -> f32 {
        let Some(mass) = self.cells.mass(index) else {
            return 0.0;
        };
        let (slope, cells) = (self.slope(index), self.cells.cells());
        if cells.is_end(index, x, [slope.low == 0.0, slope.high == 0.0]) {
            return 0.0;
        }
        let scale = cells.density(index, mass / (0.5 + 0.5 * slope.ratio));
        representable(slope.density(cells.parts(index, x), scale))
    }

    /// The point of a word, and what lies below it, with the density: its cell need not be found again.
    #[inline]
    fn with_density(&self, place: (W, f32)) -> (f32, f32) {
        let (index, x) = self.cell_and_place(place);
        (x, self.density(index, x))
    }
}

/// A density that changes linearly from one end of a cell to the other.
#[derive(Clone, Copy)]
struct Slope {
    low: f32,
    high: f32,
    /// The smaller weight over the larger one.
    ratio: f32,
}

/// 2⁻⁶⁰: below it a density that is in proportion to a ratio is formed with exponents of its own.
const FAINT: f32 = 8.673_617e-19;

impl Slope {
    #[inline]
    fn new(low: f32, high: f32) -> Self {
        let (small, large) = if low < high { (low, high) } else { (high, low) };
        Self {
            low,
            high,
            // Two weights of 0, which no table of ours selects, are as good as any two equal ones.
            ratio: if large > 0.0 { small / large } else { 1.0 },
        }
    }

    #[inline]
    fn rises(&self) -> bool {
        self.low < self.high
    }

    /// The part of the cell from its nearer end to the place within a share of words; whether that is the upper end.
    #[inline]
    fn place<W: Word>(&self, share: &Share<W>, fraction: f32) -> (f32, bool) {
        let below = share.leftover(fraction);
        let r = self.ratio;
        let half = if self.rises() { 1.0 + 3.0 * r } else { 3.0 + r };
        if below * (4.0 * (1.0 + r)) < half {
            (self.quantile(below, self.rises()), false)
        } else {
            (self.quantile(share.rest(fraction), !self.rises()), true)
        }
    }

    /// The part of the cell, up to half of it, that holds a part of its mass: from the end of the smaller weight or from
    /// the other.
    ///
    /// Every operation of either form is monotone, and so is the whole: points never step back.
    #[inline]
    fn quantile(&self, part: f32, from_small: bool) -> f32 {
        let r = self.ratio;
        let bend = (1.0 - r) * (1.0 + r);
        if from_small {
            let root = sqrt(if r > 0.0 { part } else { above_zero(part) });
            let start = r / root;
            root * (1.0 + r) / (start + sqrt(start * start + bend))
        } else {
            part * (1.0 + r) / (1.0 + sqrt(1.0 - part * bend))
        }
    }

    /// The part of the mass below a place: the parts of the cell below and above it.
    #[inline]
    fn mass(&self, (below, above): (f32, f32)) -> f32 {
        let of = |part: f32, rest: f32, from_small: bool| {
            let r = self.ratio;
            let (near, far) = if from_small { (r, 1.0) } else { (1.0, r) };
            part * (near * (1.0 + rest) + far * part) / (1.0 + r)
        };
        if below < 0.5 {
            of(below, above, self.rises())
        } else {
            1.0 - of(above, below, !self.rises())
        }
    }

    /// The density at a place, where `scale` is that at the end of the larger weight.
    #[inline]
    fn density(&self, (below, above): (f32, f32), scale: f32) -> f32 {
        let (to_large, to_small, small, large) = if self.rises() {
            (below, above, self.low, self.high)
        } else {
            (above, below, self.high, self.low)
        };
        let floor = if self.ratio < FAINT && small > 0.0 && scale > 0.0 {
            let ratio = Scaled::of(small).over(Scaled::of(large));
            ratio.times(Scaled::of(scale)).value()
        } else {
            self.ratio * scale
        };
        to_large * scale + to_small * floor
    }
}

impl<W, S, V> Warp for PiecewiseLinear1d<S, V>
where
    W: Word,
    S: Storage<Item = W>,
    V: Storage<Item = f32>,
{
    type Uniforms = f32;
    type Point = f32;
    type Density = f32;

    #[inline]
    fn sample_canonical(&self, u: Canonical<f32>) -> f32 {
        self.cell_and_place(W::from_uniform(u)).1
    }

    #[inline]
    fn pdf(&self, x: f32) -> f32 {
        self.cells
            .cell_at(x)
            .map_or(0.0, |index| self.density(index, x))
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

impl<W, S, V> Invert for PiecewiseLinear1d<S, V>
where
    W: Word,
    S: Storage<Item = W>,
    V: Storage<Item = f32>,
{
    #[inline]
    fn invert(&self, x: f32) -> f32 {
        let index = self.cells.cell(x);
        let (start, mass) = match self.cdf().mass(index) {
            Some((start, count)) => (start, amount(count)),
            None => (self.cdf().share(index).0, 0.0),
        };
        let within = mass * self.slope(index).mass(self.cells.cells().parts(index, x));
        into_unit((start.as_f32() + within) * W::STEP)
    }
}
