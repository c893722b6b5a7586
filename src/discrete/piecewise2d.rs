//! A density that is constant on each of equal cells of a rectangle: a picture as a distribution.

use super::apportionment::Apportionment;
use super::cdf::{Cdf, fill, room};
use super::cells::Cells;
use super::piecewise1d::PiecewiseConstant1d;
use super::storage::{Grid, OwnedStorage, Storage};
use super::weights::{Scan, Unit, Weights};
use super::word::sealed::Arithmetic as _;
use super::word::{Word, Words};
use super::zones::Zones;
use crate::error::Error;
use crate::num::representable;
use crate::uniform::Canonical;
use crate::warp::{Invert, Warp};
use rand_core::TryRng;

/// A picture as a density: constant on each of equal cells of a rectangle, for area lights and texture maps.
///
/// It selects a row v by the marginal p(v), then a column u by the conditional p(u given v) of that row.
///
#[cfg_attr(doc, doc = include_str!("../pictures/piecewise_constant2d.html"))]
///
/// # Density
/// The product of the two cells' probabilities over the cell's area, both as realised; 0 in a cell of weight
/// zero and outside. A density below 2⁻¹⁴⁹ is reported as 2⁻¹⁴⁹. A cell contains its lower edges, and the
/// upper edges of the rectangle count as part of the last cells.
///
/// For a picture of all directions take [`LatLongMap`](super::LatLongMap): it weighs rows by their solid angles, and its
/// density is per steradian.
///
/// # Domain
/// - Weights: row by row, columns along u, rows along v. Each is as for [`Cdf`]; at most
///   [`MAX_ENTRIES`](super::MAX_ENTRIES) cells. Edges of cells are those of [`PiecewiseConstant1d`].
///   Pictures often have negative pixels, which the filters of cameras leave: bring them to 0 first, by `x.max(0.0)`.
/// - What is looked up: one colour in all of a cell. A picture that is looked up *bilinearly* shines also in a cell of
///   weight zero beside a bright one, where no point is sampled, and more than half of an integral may be lost. Weigh each
///   cell by the sum of itself and its eight neighbours then.
/// - Uniforms: two, along u and along v. A draw takes two words in this order, each one `u32` of the generator
///   for a table of `u32`, two for a table of `u64`, and uses all their bits.
/// - Storage: one word a row and one word a cell. [`new`](PiecewiseConstant2d::new) takes an array of arrays,
///   and a `const` lies in flash; [`from_slice`](PiecewiseConstant2d::from_slice) and
///   [`new_in`](PiecewiseConstant2d::new_in) take slices.
///
/// # Accuracy
/// Errors are against the probabilities of the table. Those differ from weight/total by less than 2⁻³¹ with
/// `u32`, and each positive cell has at least one word of its row, and its row at least one word. The size, by
/// which the error of a sample is divided, is the largest coordinate of the rectangle's edges; r is what 2⁻²⁴ of
/// the size makes of the inverse.
///
/// | error | bound | kind |
/// |---|--:|---|
/// | sample, of the size | 4.3e-7 | found |
/// | pdf, relative | 5.4e-7 | found |
/// | realised density, relative | 5.4e-7 | found |
/// | inverse | 3.1e-7 | found |
/// | round trip | 1.6e-7 + 4.4*r | found |
///
/// # Cost
/// That of two selections from a [`Cdf`](super::Cdf), and of two products.
///
/// # Examples
/// Two rows of three columns, on [0, 3) × [0, 1):
/// ```
/// use microwarp::{Invert, Warp};
/// use microwarp::discrete::PiecewiseConstant2d;
/// let sky = PiecewiseConstant2d::new(
///     &[[1.0, 0.0, 1.0], [0.0, 6.0, 0.0]],
///     [0.0, 3.0],
///     [0.0, 1.0],
/// )?;
/// assert_eq!(sky.sample([0.5, 0.625]), [1.5, 0.75]);
/// assert_eq!(sky.pdf([1.5, 0.75]), 1.5);
/// assert_eq!(sky.cell([1.5, 0.75]), [1, 1]);
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// # See also
/// - [`PiecewiseConstant1d`]: cells of an interval; also the type of the marginal and of each conditional.
/// - [`LatLongMap`](super::LatLongMap): a picture of all directions.
/// - [`Cdf`]: the index of a cell alone.
///
/// # Source
/// M. Pharr, W. Jakob and G. Humphreys, *Physically Based Rendering*, 4th edition, 2023, appendix A.5:
/// <https://pbr-book.org/4ed/Sampling_Algorithms/Sampling_Multidimensional_Functions>.
#[doc(alias = "Distribution2D")]
#[doc(alias = "importance_map")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct PiecewiseConstant2d<M, C> {
    marginal: PiecewiseConstant1d<M>,
    conditional: C,
    columns: Cells,
    width: u32,
}

/// That a row as a whole is too small: its first positive weight is to blame. The weights are those from its first on.
const fn unreachable(weights: &[f32], row: usize, columns: usize) -> Error {
    let (mut rest, mut index) = (weights, row.wrapping_mul(columns));
    while let Some((&weight, others)) = rest.split_first() {
        if weight > 0.0 {
            break;
        }
        (rest, index) = (others, index.wrapping_add(1));
    }
    Error::Unreachable(index)
}

/// The cells along both axes. The range of the first is the parameter of that place, the other the next.
const fn grid(
    [u, v]: [[f32; 2]; 2],
    place: usize,
    [columns, rows]: [usize; 2],
) -> Result<(Cells, Cells), Error> {
    let next = place.wrapping_add(1);
    match (
        Cells::new(u, [place; 2], columns),
        Cells::new(v, [next; 2], rows),
    ) {
        (Ok(columns), Ok(rows)) => match columns.check_area(&rows, next) {
            Ok(()) => Ok((columns, rows)),
            Err(error) => Err(error),
        },
        (Err(error), _) | (_, Err(error)) => Err(error),
    }
}

/// The unit that the weights of all rows have in common.
const fn unit<const U: usize>(weights: &[[f32; U]]) -> Result<Unit, Error> {
    let mut scan = Scan::new();
    let mut left = weights;
    while let Some((row, rest)) = left.split_first() {
        scan = match scan.over(row) {
            Ok(scan) => scan,
            Err(error) => return Err(error),
        };
        left = rest;
    }
    scan.unit()
}

/// The conditional of one row, whose first cell has the index `first`. A row of zeros, which the
/// marginal never selects, becomes the table of one certain entry.
const fn fill_row(weights: &[f32], mut words: Words<'_>, first: usize) -> Result<(), Error> {
    match Apportionment::of(Weights::floats(weights), words.bits()) {
        Ok(ends) => fill(ends, words),
        Err(Error::AllZero) => {
            while words.left() > 0 {
                let last = words.left() == 1;
                words = words.then(if last { 0 } else { u128::MAX });
            }
        }
        Err(Error::Unreachable(index)) => {
            return Err(Error::Unreachable(first.wrapping_add(index)));
        }
        Err(error) => return Err(error),
    }
    Ok(())
}

/// The constructors that `const` code can call: there, code cannot be generic over the word.
macro_rules! arrays {
    ($($word:ident, $either:ident, $array:ident; $(#[$new_doc:meta])* $new:ident;)*) => {$(
        impl<const U: usize, const V: usize> PiecewiseConstant2d<[$word; V], [[$word; U]; V]> {
            $(#[$new_doc])*
            pub const fn $new(
                weights: &[[f32; U]; V],
                u: [f32; 2],
                v: [f32; 2],
            ) -> Result<Self, Error> {
                Self::$array(weights, [u, v], Zones::Flat)
            }

            pub(crate) const fn $array(
                weights: &[[f32; U]; V],
                ranges: [[f32; 2]; 2],
                zones: Zones,
            ) -> Result<Self, Error> {
                let (columns, rows) = match grid(ranges, 1, [U, V]) {
                    Ok(cells) => cells,
                    Err(error) => return Err(error),
                };
                let unit = match unit(weights) {
                    Ok(unit) => unit,
                    Err(error) => return Err(error),
                };
                let (mut marginal, mut conditional) = ([0; V], [[0; U]; V]);
                let mut sums = [0; V];
                let (mut first, mut index) = (0_usize, 0_usize);
                let mut cells: &[[f32; U]] = weights;
                let mut tables: &mut [[$word; U]] = &mut conditional;
                let mut left: &mut [u128] = &mut sums;
                while let ([row, rest @ ..], [table, others @ ..], [sum, more @ ..]) =
                    (cells, tables, left)
                {
                    *sum = zones.weigh(unit.sum(row), index);
                    if let Err(error) = fill_row(row, Words::$either(table), first) {
                        return Err(error);
                    }
                    first = first.wrapping_add(U);
                    index = index.wrapping_add(1);
                    (cells, tables, left) = (rest, others, more);
                }
                match Apportionment::new(Weights::Sums(&sums), $word::BITS) {
                    Ok(ends) => fill(ends, Words::$either(&mut marginal)),
                    Err(Error::Unreachable(row)) => {
                        let row_weights: &[f32] = match weights.split_at_checked(row) {
                            Some((_, [weights, ..])) => weights,
                            _ => &[],
                        };
                        return Err(unreachable(row_weights, row, U));
                    }
                    Err(error) => return Err(error),
                }
                Ok(Self {
                    marginal: PiecewiseConstant1d::within(Cdf::trusted(marginal), rows),
                    conditional,
                    columns,
                    width: U as u32,
                })
            }
        }
    )*};
}

arrays! {
    u32, U32, array_u32;
    /// An array of rows of weights as the masses of equal cells of a rectangle, with words of 32 bits. `const`.
    ///
    /// # Errors
    /// Those of [`Cdf::new`], where an index counts cells row by row. Where a row as a whole is
    /// [`Error::Unreachable`], the index is that of its first positive weight. Those of
    /// [`PiecewiseConstant1d::from_cdf`] for the two ranges. [`Error::TooLarge`] also for a rectangle on which a
    /// uniform density is below the smallest normal `f32`, and [`Error::Empty`] for one on a cell of which it
    /// could overflow.
    ///
    /// # Cost
    /// At most 4 times the table, 16 bytes a row and 2 KiB of stack, the table included; up to 8 times without
    /// optimisation. For large pictures take [`PiecewiseConstant2d::new_in`], or with feature `alloc`
    /// [`PiecewiseConstant2d::from_slice`].
    ///
    /// # Examples
    /// Built by the compiler, and kept in flash:
    /// ```
    /// use microwarp::{Warp, constant, discrete::PiecewiseConstant2d};
    /// const SKY: PiecewiseConstant2d<[u32; 2], [[u32; 3]; 2]> =
    ///     constant!(PiecewiseConstant2d::new(
    ///         &[[1.0, 0.0, 1.0], [0.0, 6.0, 0.0]],
    ///         [0.0, 3.0],
    ///         [0.0, 1.0],
    ///     ));
    /// assert_eq!(SKY.sample([0.5, 0.625]), [1.5, 0.75]);
    /// ```
    new;
    u64, U64, array_u64;
    /// An array of rows of weights as the masses of equal cells of a rectangle, with words of 64 bits: for
    /// weights of very different size. `const`.
    ///
    /// # Errors
    /// Those of [`PiecewiseConstant2d::new`], except [`Error::Unreachable`].
    new_u64;
}

/// The weights of all rows as a source of their sums, and the cells along both axes.
fn plan(
    weights: &[f32],
    [columns, rows]: [usize; 2],
    ranges: [[f32; 2]; 2],
    zones: Zones,
) -> Result<(Weights<'_>, Cells, Cells), Error> {
    if columns.checked_mul(rows) != Some(weights.len()) {
        return Err(Error::OutOfRange(1));
    }
    let sums = Weights::rows(weights, columns, zones)?;
    let (column_cells, row_cells) = grid(ranges, 2, [columns, rows])?;
    Ok((sums, column_cells, row_cells))
}

/// The marginal, or its error as one of the first positive weight of a row.
fn blamed<S>(
    marginal: Result<Cdf<S>, Error>,
    weights: &[f32],
    columns: usize,
) -> Result<Cdf<S>, Error> {
    match marginal {
        Err(Error::Unreachable(row)) => {
            let rest = weights.get(row.wrapping_mul(columns)..).unwrap_or(&[]);
            Err(unreachable(rest, row, columns))
        }
        other => other,
    }
}

/// The conditionals of all rows.
fn fill_rows<W: Word>(weights: &[f32], columns: usize, tables: &mut [W]) -> Result<(), Error> {
    // Row by row without a division, which `chunks_exact` would bring and a panic with it.
    let (mut cells_left, mut words_left, mut first) = (weights, tables, 0_usize);
    while let (Some((row, more)), Some((table, others))) = (
        cells_left.split_at_checked(columns),
        words_left.split_at_mut_checked(columns),
    ) {
        fill_row(row, W::words(table), first)?;
        first = first.wrapping_add(columns);
        (cells_left, words_left) = (more, others);
    }
    Ok(())
}

// The bounds stand at the method, because the compiler shows no notes for bounds of an `impl`.
impl<M, C> PiecewiseConstant2d<M, C> {
    /// A slice of weights, row by row, as the masses of equal cells of a rectangle, in storage of its own: see
    /// [`Cdf::from_slice`]. The shape is the numbers of columns and of rows.
    ///
    /// # Errors
    /// Those of [`PiecewiseConstant2d::new`]; [`Error::OutOfRange`] where the weights are not columns times rows
    /// in number, [`Error::TooManyWeights`] also where the storage has no room for the tables.
    ///
    /// # Cost
    /// With storage on the heap at most 2 KiB of stack, whatever the size of the picture; up to 8 KiB without
    /// optimisation.
    ///
    /// # Examples
    /// In a `Vec`, which needs feature `alloc`:
    /// ```
    /// # #[cfg(feature = "alloc")] {
    /// use microwarp::{Warp, discrete::PiecewiseConstant2d};
    /// let picture = vec![1.0; 64 * 32];
    /// let light = PiecewiseConstant2d::<Vec<u32>, Vec<u32>>::from_slice(
    ///     &picture,
    ///     [64, 32],
    ///     [0.0, 1.0],
    ///     [0.0, 1.0],
    /// )?;
    /// assert_eq!(light.pdf([0.3, 0.6]), 1.0);
    /// # }
    /// # Ok::<(), microwarp::Error>(())
    /// ```
    pub fn from_slice(
        weights: &[f32],
        shape: [usize; 2],
        u: [f32; 2],
        v: [f32; 2],
    ) -> Result<Self, Error>
    where
        M: OwnedStorage<Item: Word>,
        C: OwnedStorage<Item = M::Item> + Grid<Item = M::Item>,
    {
        Self::owned(weights, shape, [u, v], Zones::Flat)
    }

    pub(crate) fn owned(
        weights: &[f32],
        shape: [usize; 2],
        ranges: [[f32; 2]; 2],
        zones: Zones,
    ) -> Result<Self, Error>
    where
        M: OwnedStorage<Item: Word>,
        C: OwnedStorage<Item = M::Item> + Grid<Item = M::Item>,
    {
        let [columns, rows] = shape;
        let (sums, cells, row_cells) = plan(weights, shape, ranges, zones)?;
        let mut conditional: C = room(M::Item::ZERO, weights.len())?;
        let cdf = blamed(Cdf::owned(sums, rows), weights, columns)?;
        fill_rows(weights, columns, conditional.items_mut())?;
        Ok(Self {
            marginal: PiecewiseConstant1d::within(cdf, row_cells),
            conditional,
            columns: cells,
            width: columns as u32,
        })
    }
}

impl<'a, W: Word> PiecewiseConstant2d<&'a [W], &'a [W]> {
    /// A slice of weights, row by row, as the masses of equal cells of a rectangle, with the tables at the
    /// beginning of borrowed memory: one word a row, and one word a cell. The shape is the numbers of columns
    /// and of rows.
    ///
    /// # Errors
    /// Those of [`PiecewiseConstant2d::new`]; [`Error::OutOfRange`] where the weights are not columns times rows
    /// in number, [`Error::TooManyWeights`] also where the memory has no room for the tables. After
    /// [`Error::Unreachable`] the memory holds parts of tables.
    ///
    /// # Cost
    /// At most 2 KiB of stack, whatever the size of the picture; up to 8 KiB without optimisation.
    pub fn new_in(
        weights: &[f32],
        shape: [usize; 2],
        u: [f32; 2],
        v: [f32; 2],
        marginal: &'a mut [W],
        conditional: &'a mut [W],
    ) -> Result<Self, Error> {
        Self::borrowed(weights, shape, [u, v], Zones::Flat, marginal, conditional)
    }

    pub(crate) fn borrowed(
        weights: &[f32],
        shape: [usize; 2],
        ranges: [[f32; 2]; 2],
        zones: Zones,
        marginal: &'a mut [W],
        conditional: &'a mut [W],
    ) -> Result<Self, Error> {
        let [columns, rows] = shape;
        let (sums, cells, row_cells) = plan(weights, shape, ranges, zones)?;
        let tables = conditional
            .get_mut(..weights.len())
            .ok_or(Error::TooManyWeights)?;
        let cdf = blamed(
            Cdf::<&[W]>::borrowed(sums, rows, marginal),
            weights,
            columns,
        )?;
        fill_rows(weights, columns, tables)?;
        Ok(Self {
            marginal: PiecewiseConstant1d::within(cdf, row_cells),
            conditional: tables,
            columns: cells,
            width: columns as u32,
        })
    }
}

impl<W, M, C> PiecewiseConstant2d<M, C>
where
    W: Word,
    M: Storage<Item = W>,
    C: Grid<Item = W>,
{
    /// A distribution from the words of finished tables, as [`PiecewiseConstant2d::as_words`] gave them: the
    /// marginal's, and row by row those of the conditionals. All words are checked.
    ///
    /// # Errors
    /// Those of [`PiecewiseConstant2d::from_trusted_words`]; [`Error::NotATable`] also for words that no table
    /// has.
    pub fn from_words(
        marginal: M,
        conditional: C,
        u: [f32; 2],
        v: [f32; 2],
    ) -> Result<Self, Error> {
        Cdf::from_words(marginal.items())?;
        let table = Self::from_trusted_words(marginal, conditional, u, v)?;
        let mut left = table.conditional.flat();
        while let Some((row, more)) = left.split_at_checked(table.width as usize) {
            Cdf::from_words(row)?;
            left = more;
        }
        Ok(table)
    }

    /// A distribution from the words of finished tables, in constant time: the words are not looked at.
    ///
    /// The words must be those that [`PiecewiseConstant2d::as_words`] gave, for the same type of word. With any
    /// other words the distribution is meaningless. Still nothing panics or loops, every cell is within the
    /// shape, points are in the rectangle, and densities are finite.
    ///
    /// # Errors
    /// [`Error::NoWeights`] without words, [`Error::TooManyWeights`] for more than
    /// [`MAX_ENTRIES`](super::MAX_ENTRIES) cells, [`Error::NotATable`] where the rows are not of equal length;
    /// those of [`PiecewiseConstant2d::new`] for the ranges.
    pub fn from_trusted_words(
        marginal: M,
        conditional: C,
        u: [f32; 2],
        v: [f32; 2],
    ) -> Result<Self, Error> {
        let cdf = Cdf::from_trusted_words(marginal)?;
        let rows = cdf.entries();
        let cells = conditional.flat().len();
        let width = cells.checked_div(rows).unwrap_or(0);
        if cells == 0 {
            return Err(Error::NoWeights);
        }
        if cells > super::MAX_ENTRIES {
            return Err(Error::TooManyWeights);
        }
        if width.checked_mul(rows) != Some(cells) {
            return Err(Error::NotATable);
        }
        let (columns, rows) = grid([u, v], 2, [width, rows])?;
        Ok(Self {
            marginal: PiecewiseConstant1d::within(cdf, rows),
            conditional,
            columns,
            width: width as u32,
        })
    }

    /// The coordinates of the rectangle's edges along u, the lower one first.
    #[must_use]
    #[inline]
    pub const fn u(&self) -> [f32; 2] {
        self.columns.range()
    }

    /// The coordinates of the rectangle's edges along v, the lower one first.
    #[must_use]
    #[inline]
    pub const fn v(&self) -> [f32; 2] {
        self.marginal.cells().range()
    }

    /// The words of the tables: the marginal's, and row by row those of the conditionals.
    #[must_use]
    #[inline]
    pub fn as_words(&self) -> (&[W], &[W]) {
        (self.marginal.cdf().as_words(), self.conditional.flat())
    }

    /// The numbers of columns and of rows.
    #[must_use]
    #[inline]
    pub fn shape(&self) -> [usize; 2] {
        [self.width as usize, self.marginal.cdf().entries()]
    }

    /// p(v): the distribution of the rows along v.
    #[must_use]
    #[inline]
    pub const fn marginal(&self) -> &PiecewiseConstant1d<M> {
        &self.marginal
    }

    /// The column and the row of the cell that a point lies in; those of the nearer end for a point
    /// outside.
    #[must_use]
    #[inline]
    pub fn cell(&self, [u, v]: [f32; 2]) -> [usize; 2] {
        [self.columns.find(u), self.marginal.cell(v)]
    }

    #[inline]
    pub(crate) fn column(&self, u: f32) -> usize {
        self.columns.find(u)
    }

    /// p(u given v): the distribution of the columns in a row; that of the last row beyond it. A row of
    /// zeros, which the marginal never selects, gives a certain first column.
    #[must_use]
    #[inline]
    pub fn conditional(&self, row: usize) -> PiecewiseConstant1d<&[W]> {
        let width = self.width as usize;
        let last = self.marginal.cdf().entries().saturating_sub(1);
        let row = if row < last { row } else { last };
        let start = row.wrapping_mul(width);
        let words = self
            .conditional
            .flat()
            .get(start..start.wrapping_add(width))
            .unwrap_or(&[]);
        PiecewiseConstant1d::within(Cdf::trusted(words), self.columns)
    }

    /// The cell, by its column and row, and the point of two words and what lies below them, along u and along v.
    #[allow(
        clippy::inline_always,
        reason = "of a draw nothing lies below the words, which saves two sums"
    )]
    #[cfg_attr(target_arch = "x86_64", inline(always))]
    #[cfg_attr(not(target_arch = "x86_64"), inline)]
    fn cell_and_place(&self, [along_u, along_v]: [(W, f32); 2]) -> ([usize; 2], [f32; 2]) {
        let (row, v) = self.marginal.cell_and_place(along_v);
        let (column, u) = self.conditional(row).cell_and_place(along_u);
        ([column, row], [u, v])
    }

    /// The density in a cell.
    #[inline]
    fn density(&self, [column, row]: [usize; 2]) -> f32 {
        let Some(along_v) = self.marginal.mass(row) else {
            return 0.0;
        };
        let Some(along_u) = self.conditional(row).mass(column) else {
            return 0.0;
        };
        let (columns, rows) = (&self.columns, self.marginal.cells());
        // The narrower side first: over the wider one alone the density may be subnormal and lose bits
        // that the product of the two has.
        representable(if columns.narrower(rows) {
            rows.density(row, columns.density(column, along_u) * along_v)
        } else {
            columns.density(column, rows.density(row, along_v) * along_u)
        })
    }

    /// The point with the density: that of the cell, which need not be found again.
    #[inline]
    fn with_density(&self, places: [(W, f32); 2]) -> ([f32; 2], f32) {
        let (cell, point) = self.cell_and_place(places);
        (point, self.density(cell))
    }
}

/// The words of a draw, which have nothing left over below their last bit.
#[inline]
pub(super) fn try_words<W: Word, R: TryRng + ?Sized>(
    rng: &mut R,
) -> Result<[(W, f32); 2], R::Error> {
    Ok([(W::try_draw(rng)?, 0.0), (W::try_draw(rng)?, 0.0)])
}

impl<W, M, C> Warp for PiecewiseConstant2d<M, C>
where
    W: Word,
    M: Storage<Item = W>,
    C: Grid<Item = W>,
{
    type Uniforms = [f32; 2];
    type Point = [f32; 2];
    type Density = f32;

    #[inline]
    fn sample_canonical(&self, u: Canonical<[f32; 2]>) -> [f32; 2] {
        self.cell_and_place(u.each().map(W::from_uniform)).1
    }

    #[inline]
    fn pdf(&self, [u, v]: [f32; 2]) -> f32 {
        let inside = self.columns.contains(u) && self.marginal.cells().contains(v);
        if inside {
            self.density(self.cell([u, v]))
        } else {
            0.0
        }
    }

    // Written as the trait writes it: what compares public items takes another spelling for a change.
    #[inline]
    fn sample_canonical_with_pdf(
        &self,
        u: Canonical<Self::Uniforms>,
    ) -> (Self::Point, Self::Density) {
        self.with_density(u.each().map(W::from_uniform))
    }

    #[inline]
    fn sample_words(&self, words: [u32; 2]) -> [f32; 2] {
        let places = words.map(|word| (W::from_bits(word), 0.0));
        self.cell_and_place(places).1
    }

    #[inline]
    fn try_draw<R: TryRng + ?Sized>(&self, rng: &mut R) -> Result<[f32; 2], R::Error> {
        Ok(self.cell_and_place(try_words(rng)?).1)
    }

    #[inline]
    fn try_draw_with_pdf<R: TryRng + ?Sized>(
        &self,
        rng: &mut R,
    ) -> Result<(Self::Point, Self::Density), R::Error>
    where
        Self: Sized,
    {
        Ok(self.with_density(try_words(rng)?))
    }
}

impl<W, M, C> Invert for PiecewiseConstant2d<M, C>
where
    W: Word,
    M: Storage<Item = W>,
    C: Grid<Item = W>,
{
    #[inline]
    fn invert(&self, [u, v]: [f32; 2]) -> [f32; 2] {
        let row = self.marginal.cell(v);
        [self.conditional(row).invert(u), self.marginal.invert(v)]
    }
}
