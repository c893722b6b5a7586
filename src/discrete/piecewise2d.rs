//! A density that is constant on each of equal cells of a rectangle: a picture as a distribution.

use super::cdf::{Cdf, fill};
use super::cells::Cells;
use super::ladder::Ends;
use super::piecewise1d::PiecewiseConstant1d;
use super::source::{Scan, Source, Unit};
use super::storage::{Grid, Storage};
use super::word::{Word, Words};
use crate::error::Error;
use crate::num::representable;
use crate::uniform::Canonical;
use crate::warp::{Invert, Warp};
use rand_core::TryRng;

/// Piecewise constant on a rectangle, for environment lights and texture maps: a row v by the marginal
/// p(v), then a column u by the conditional p(u given v) of that row.
///
/// Weights are given row by row: columns run along u, rows along v.
///
/// - Storage: a table of one entry a row and one of one entry a cell. Arrays in a `const` are all in
///   flash, 4 (rows + cells) bytes of it with `u32`, and cost no RAM; borrowed slices serve pictures whose
///   size is known at run time. At most [`MAX_ENTRIES`](super::MAX_ENTRIES) cells.
/// - Uniforms: two, along u and along v. Drawing takes two words, in this order, of one `u32` each from
///   tables of `u32` and two each from tables of `u64`, and uses all their bits.
/// - Density: the product of the two cells' probabilities over the cell's area, both as realised; 0 in a
///   cell of weight zero. A cell contains its lower edges; the upper ends count as part of the last.
/// - A positive cell is given at least one word of its row, and its row at least one word. With `u32` the
///   probability of a cell differs from weight/total by less than 2⁻³¹; see [`Cdf`] for what else its
///   words mean.
/// - A cell whose density is below 2⁻¹⁴⁹ reports that.
/// - Edges, errors and what an inverse can return to are as for [`PiecewiseConstant1d`]; the size is the
///   largest bound.
///
/// For a picture of all directions, with u the azimuth in turns over [0, 1) and v the polar angle in half
/// turns over [0, 1), give each weight the factor sin πv of its row's middle; the density per steradian is
/// `pdf` / (2π² sin πv). Take `pdf` at the (u, v) that was sampled: a detour over a direction and back may
/// round into the cell beside.
///
/// | error | `libm` | `poly` |
/// |---|--:|--:|
/// | sample, of the size | 4e-7 | 4e-7 |
/// | pdf, relative | 4.2e-7 | 4.2e-7 |
/// | realised density, relative | 4.2e-7 | 4.2e-7 |
/// | inverse | 2.7e-7 | 2.7e-7 |
/// | round trip | 1.2e-7 + 3*r | 1.2e-7 + 3*r |
///
/// r is what 2⁻²⁴ of the size makes of the inverse.
///
/// Source: M. Pharr, W. Jakob and G. Humphreys, "Physically Based Rendering", 2023.
///
/// ```
/// use microwarp::{Invert, Warp};
/// use microwarp::discrete::PiecewiseConstant2d;
/// // Two rows of three columns, on [0, 3) × [0, 1): the compiler builds it, flash holds it.
/// const SKY: PiecewiseConstant2d<[u32; 2], [[u32; 3]; 2]> =
///     match PiecewiseConstant2d::<[u32; 2], [[u32; 3]; 2]>::new(
///         &[[1.0, 0.0, 1.0], [0.0, 6.0, 0.0]],
///         [0.0, 3.0],
///         [0.0, 1.0],
///     ) {
///         Ok(table) => table,
///         Err(_) => panic!("bad weights"),
///     };
/// assert_eq!(SKY.sample([0.5, 0.625]), [1.5, 0.75]);
/// assert_eq!(SKY.pdf([1.5, 0.75]), 1.5);
/// assert_eq!(SKY.cell([1.5, 0.75]), [1, 1]);
/// ```
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

/// The cells along both axes.
const fn grid([u, v]: [[f32; 2]; 2], [columns, rows]: [usize; 2]) -> Result<(Cells, Cells), Error> {
    match (Cells::new(u, columns), Cells::new(v, rows)) {
        (Ok(columns), Ok(rows)) => match columns.check_area(&rows) {
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
    match Ends::of(Source::floats(weights), words.bits()) {
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

/// What `const` code cannot have of both words at once.
macro_rules! arrays {
    ($($word:ident, $either:ident;)*) => {$(
        impl<const U: usize, const V: usize> PiecewiseConstant2d<[$word; V], [[$word; U]; V]> {
            /// These weights as the masses of equal cells of a rectangle, as arrays: for a `const`.
            ///
            /// # Errors
            /// Those of [`Cdf::new`], an index counting cells row by row; where a row as a whole is
            /// [`Error::Unreachable`], that of its first positive weight. Those of
            /// [`PiecewiseConstant1d::new`] for the two ranges; [`Error::TooLarge`] and [`Error::Empty`]
            /// also for a rectangle on which a uniform density is below the smallest normal `f32`, or on
            /// one cell of which it could overflow.
            pub const fn new(
                weights: &[[f32; U]; V],
                u: [f32; 2],
                v: [f32; 2],
            ) -> Result<Self, Error> {
                let (columns, rows) = match grid([u, v], [U, V]) {
                    Ok(cells) => cells,
                    Err(error) => return Err(error),
                };
                let unit = match unit(weights) {
                    Ok(unit) => unit,
                    Err(error) => return Err(error),
                };
                let (mut marginal, mut conditional) = ([0; V], [[0; U]; V]);
                let mut sums = [0; V];
                let mut first = 0_usize;
                let mut cells: &[[f32; U]] = weights;
                let mut tables: &mut [[$word; U]] = &mut conditional;
                let mut left: &mut [u128] = &mut sums;
                while let ([row, rest @ ..], [table, others @ ..], [sum, more @ ..]) =
                    (cells, tables, left)
                {
                    *sum = unit.sum(row);
                    if let Err(error) = fill_row(row, Words::$either(table), first) {
                        return Err(error);
                    }
                    first = first.wrapping_add(U);
                    (cells, tables, left) = (rest, others, more);
                }
                match Ends::new(Source::Sums(&sums), $word::BITS) {
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
    u32, U32;
    u64, U64;
}

impl<'a, W: Word> PiecewiseConstant2d<&'a [W], &'a [W]> {
    /// These weights, row by row, as the masses of equal cells of a rectangle; the tables are
    /// laid out at the beginning of memory of the caller's, which takes one word a row and one
    /// word a cell.
    ///
    /// # Errors
    /// As for arrays; [`Error::OutOfRange`] where the weights are not rows times columns in
    /// number, [`Error::TooManyWeights`] also where the memory does not hold the tables. After
    /// [`Error::Unreachable`] the memory holds parts of tables.
    pub fn new_in(
        weights: &[f32],
        [columns, rows]: [usize; 2],
        u: [f32; 2],
        v: [f32; 2],
        marginal: &'a mut [W],
        conditional: &'a mut [W],
    ) -> Result<Self, Error> {
        if columns.checked_mul(rows) != Some(weights.len()) {
            return Err(Error::OutOfRange);
        }
        let source = Source::rows(weights, columns)?;
        let (cells, row_cells) = grid([u, v], [columns, rows])?;
        let tables = conditional
            .get_mut(..weights.len())
            .ok_or(Error::TooManyWeights)?;
        let cdf = match Cdf::<&[W]>::of(source, rows, marginal) {
            Err(Error::Unreachable(row)) => {
                let rest = weights.get(row.wrapping_mul(columns)..).unwrap_or(&[]);
                return Err(unreachable(rest, row, columns));
            }
            other => other?,
        };
        // Row by row without a division, which `chunks_exact` would bring and a panic with it.
        let (mut cells_left, mut words_left, mut first) = (weights, &mut *tables, 0_usize);
        while let (Some((row, more)), Some((table, others))) = (
            cells_left.split_at_checked(columns),
            words_left.split_at_mut_checked(columns),
        ) {
            fill_row(row, W::words(table), first)?;
            first = first.wrapping_add(columns);
            (cells_left, words_left) = (more, others);
        }
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
    /// A distribution out of the words of finished tables, such as [`PiecewiseConstant2d::as_words`] gave:
    /// the marginal's, and row by row those of the conditionals.
    ///
    /// # Errors
    /// Those of [`Cdf::from_words`], and of `new` for the ranges; [`Error::NotATable`] also where the rows
    /// are not of equal length.
    pub fn from_words(
        marginal: M,
        conditional: C,
        u: [f32; 2],
        v: [f32; 2],
    ) -> Result<Self, Error> {
        let cdf = Cdf::from_words(marginal)?;
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
        let (columns, rows) = grid([u, v], [width, rows])?;
        let mut left = conditional.flat();
        while let Some((row, more)) = left.split_at_checked(width) {
            Cdf::from_words(row)?;
            left = more;
        }
        Ok(Self {
            marginal: PiecewiseConstant1d::within(cdf, rows),
            conditional,
            columns,
            width: width as u32,
        })
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

    /// The point of exact words, along u and along v.
    #[inline]
    fn at(&self, [along_u, along_v]: [W; 2]) -> [f32; 2] {
        let (row, v) = self.marginal.cell_and_place((along_v, 0.0));
        let (_, u) = self.conditional(row).cell_and_place((along_u, 0.0));
        [u, v]
    }
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
        let [along_u, along_v] = u.each();
        let (row, v) = self.marginal.cell_and_place(W::from_uniform(along_v));
        let (_, u) = self
            .conditional(row)
            .cell_and_place(W::from_uniform(along_u));
        [u, v]
    }

    #[inline]
    fn pdf(&self, [u, v]: [f32; 2]) -> f32 {
        let Some((row, along_v)) = self.marginal.mass_at(v) else {
            return 0.0;
        };
        let Some((column, along_u)) = self.conditional(row).mass_at(u) else {
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

    #[inline]
    fn sample_words(&self, [along_u, along_v]: [u32; 2]) -> [f32; 2] {
        self.at([W::from_bits(along_u), W::from_bits(along_v)])
    }

    #[inline]
    fn try_draw<R: TryRng + ?Sized>(&self, rng: &mut R) -> Result<[f32; 2], R::Error> {
        let along_u = W::try_draw(rng)?;
        let along_v = W::try_draw(rng)?;
        Ok(self.at([along_u, along_v]))
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
