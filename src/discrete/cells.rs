//! Equal cells of an interval: where their edges are in `f32`, and which one a number lies in.

use crate::error::{Error, tried};
use crate::num::{Scaled, Segment, clamp, extent, neighbour};

/// An interval in equal cells.
///
/// Everything takes the edges of a cell from here, so sampling and look-up agree to the last bit.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(crate) struct Cells {
    low: f32,
    high: f32,
    /// The number of cells; exact, since there are at most 2²⁴.
    count: f32,
    /// Cells per scaled length.
    per_length: f32,
    /// 1, or 1/2 where the length itself would overflow.
    scale: f32,
}

/// The least width of a cell, 2⁻²⁰ of the larger bound.
///
/// An edge is off by at most 2.5 · 2⁻²⁴ of the larger bound, five roundings, which is below a sixth of such
/// a cell: edges differ. There are then at most 2²¹ cells, so the four roundings of the guess in
/// [`Cells::find`] carry it by at most half a cell.
const LEAST: f32 = 1.0 / 1_048_576.0;

impl Cells {
    /// So many cells of a range, whose bounds are the parameters of these places.
    pub(crate) const fn new(
        range: [f32; 2],
        places: [usize; 2],
        count: usize,
    ) -> Result<Self, Error> {
        let [low, high] = range;
        if count == 0 {
            return Err(Error::NoWeights);
        }
        let (scale, length) = tried!(extent(range, places));
        let count = count as f32;
        let per_length = count / length;
        let larger = if -low > high { -low } else { high };
        // The first refuses an empty interval too, whose quotient is infinite; twice, because rounding
        // makes some cells narrower than others.
        if !(2.0 * per_length).is_finite() || length / count < LEAST * (larger * scale) {
            return Err(Error::Empty(places[1]));
        }
        Ok(Self {
            low,
            high,
            count,
            per_length,
            scale,
        })
    }

    /// The lower and the upper bound.
    #[inline]
    pub(crate) const fn range(&self) -> [f32; 2] {
        [self.low, self.high]
    }

    /// Refuses a rectangle on which a uniform density is not a normal number, or on one cell of which it
    /// could overflow. The other side is the parameter of that place.
    pub(crate) const fn check_area(&self, other: &Self, place: usize) -> Result<(), Error> {
        let area = self.length().times(other.length());
        let cells = Scaled::of(self.count).times(Scaled::of(other.count));
        if Scaled::ONE.over(area).value() < f32::MIN_POSITIVE {
            return Err(Error::TooLarge(place));
        }
        if cells.times(Scaled::of(2.0)).over(area).value() > f32::MAX {
            return Err(Error::Empty(place));
        }
        Ok(())
    }

    /// Refuses cells on one of which twice the density of a certain cell could overflow. The upper bound is the
    /// parameter of that place.
    pub(crate) const fn check_steep(&self, place: usize) -> Result<(), Error> {
        if (4.0 * self.per_length).is_finite() {
            Ok(())
        } else {
            Err(Error::Empty(place))
        }
    }

    const fn length(&self) -> Scaled {
        let scaled = self.high * self.scale - self.low * self.scale;
        Scaled::of(scaled).over(Scaled::of(self.scale))
    }

    /// The lower edge of a cell; the upper end of the interval for the number of cells.
    #[inline]
    fn edge(&self, index: f32) -> f32 {
        let t = index / self.count;
        (1.0 - t) * self.low + t * self.high
    }

    /// Both edges of a cell.
    #[inline]
    fn edges(&self, index: usize) -> (f32, f32) {
        let index = index as f32;
        (self.edge(index), self.edge(index + 1.0))
    }

    /// The point at a fraction of a cell, which increases with the fraction; within the cell, whose upper
    /// edge belongs to the next.
    #[inline]
    #[expect(
        clippy::float_cmp,
        reason = "points that are the edge itself, no others"
    )]
    pub(crate) fn place(&self, index: usize, fraction: f32) -> f32 {
        let (low, high) = self.edges(index);
        let x = Segment::new(low, high).at(fraction);
        if x == high { neighbour(high, low) } else { x }
    }

    /// The point at a part of a cell, at most half of it, from the lower edge or from the upper one. It does not pass the
    /// middle, so that it increases with the place from one half to the other; within the cell, whose upper edge belongs
    /// to the next, and whose lower one may be left out.
    #[inline]
    #[expect(
        clippy::float_cmp,
        reason = "points that are an edge itself, no others"
    )]
    pub(crate) fn place_from(&self, index: usize, (part, upper): (f32, bool), open: bool) -> f32 {
        let (low, high) = self.edges(index);
        let middle = 0.5 * low + 0.5 * high;
        if upper {
            let x = Segment::new(high, low).at(part);
            let x = if x > middle { x } else { middle };
            if x == high { neighbour(high, low) } else { x }
        } else {
            let x = Segment::new(low, high).at(part);
            let x = if x < middle { x } else { middle };
            if open && x == low {
                neighbour(low, high)
            } else {
                x
            }
        }
    }

    /// The number, or one inside its cell that is a margin away from both edges.
    #[inline]
    pub(crate) fn inside(&self, index: usize, x: f32, margin: f32) -> f32 {
        let (low, high) = self.edges(index);
        clamp(x, low + margin, high - margin)
    }

    /// Whether a number is in the interval, both ends included.
    #[inline]
    pub(crate) fn contains(&self, x: f32) -> bool {
        self.low <= x && x <= self.high
    }

    /// The cell a number lies in; that of the nearer end for a number outside.
    #[inline]
    pub(crate) fn find(&self, x: f32) -> usize {
        let last = self.count - 1.0;
        let guess = (x * self.scale - self.low * self.scale) * self.per_length;
        // Off by one cell at most, see `LEAST`; `tests/tables` walks all edges.
        let mut index = clamp(guess, 0.0, last) as u32 as f32;
        if index > 0.0 && x < self.edge(index) {
            index -= 1.0;
        } else if index < last && x >= self.edge(index + 1.0) {
            index += 1.0;
        }
        index as usize
    }

    /// The fraction of a cell at which a number lies, from 0 to 1.
    #[inline]
    pub(crate) fn fraction(&self, index: usize, x: f32) -> f32 {
        let (low, high) = self.edges(index);
        let s = self.scale;
        clamp((x * s - low * s) / (high * s - low * s), 0.0, 1.0)
    }

    /// Whether a number is an end of a cell, of those that count: the lower one, the upper one.
    #[inline]
    #[expect(
        clippy::float_cmp,
        reason = "points that are an edge itself, no others"
    )]
    pub(crate) fn is_end(&self, index: usize, x: f32, [lower, upper]: [bool; 2]) -> bool {
        let (low, high) = self.edges(index);
        (lower && x == low) || (upper && x == high)
    }

    /// The parts of a cell below and above a number, from 0 to 1. Each has its own digits.
    #[inline]
    pub(crate) fn parts(&self, index: usize, x: f32) -> (f32, f32) {
        let (low, high) = self.edges(index);
        let s = self.scale;
        let width = high * s - low * s;
        let part = |length: f32| clamp(length / width, 0.0, 1.0);
        (part(x * s - low * s), part(high * s - x * s))
    }

    /// Whether these cells are narrower than those.
    #[inline]
    pub(crate) fn narrower(&self, than: &Self) -> bool {
        self.per_length * self.scale > than.per_length * than.scale
    }

    /// The density of a mass spread over a cell, as wide as its edges in `f32` make it.
    #[inline]
    pub(crate) fn density(&self, index: usize, mass: f32) -> f32 {
        let (low, high) = self.edges(index);
        let s = self.scale;
        (mass / (high * s - low * s)) * s
    }
}
