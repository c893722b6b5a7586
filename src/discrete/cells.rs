//! Equal cells of an interval: where their edges are in `f32`, and which one a number lies in.

use crate::error::{Error, finite};
use crate::warp::{clamp, neighbour};

/// An interval in equal cells.
///
/// The edge of a cell is one and the same `f32` whoever asks for it, so that sampling and look-up agree.
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

/// The least width of a cell, of the larger bound: four steps of an `f32`, so that edges differ.
const LEAST: f32 = 1.0 / 4_194_304.0;

impl Cells {
    pub(crate) const fn new([low, high]: [f32; 2], count: usize) -> Result<Self, Error> {
        if count == 0 {
            return Err(Error::NoWeights);
        }
        match (finite(low), finite(high)) {
            (Ok(_), Ok(_)) => {}
            (Err(e), _) | (_, Err(e)) => return Err(e),
        }
        if low > high {
            return Err(Error::Reversed);
        }
        let scale = if (high - low).is_finite() { 1.0 } else { 0.5 };
        let length = high * scale - low * scale;
        let count = count as f32;
        let per_length = count / length;
        let larger = if -low > high { -low } else { high };
        // The first refuses an empty interval too, whose quotient is infinite.
        if !per_length.is_finite() || length / count < LEAST * (larger * scale) {
            return Err(Error::Empty);
        }
        Ok(Self {
            low,
            high,
            count,
            per_length,
            scale,
        })
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

    /// The point at a fraction of a cell; within the cell, whose upper edge belongs to the next.
    #[inline]
    pub(crate) fn place(&self, index: usize, fraction: f32) -> f32 {
        let (low, high) = self.edges(index);
        let x = (1.0 - fraction) * low + fraction * high;
        clamp(x, low, neighbour(high, low))
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
        // Rounding carries the guess by one cell at most: `tests/piecewise.rs` walks all edges.
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

    /// The density of a mass spread over a cell, as wide as its edges in `f32` make it.
    #[inline]
    pub(crate) fn density(&self, index: usize, mass: f32) -> f32 {
        let (low, high) = self.edges(index);
        let s = self.scale;
        (mass / (high * s - low * s)) * s
    }
}
