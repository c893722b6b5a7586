//! Additive recurrences on the generalised golden ratios, in words.

use super::{ByPosition, Points, hashes};
use crate::error::{Error, tried};
use crate::num::high;

/// An additive recurrence of D dimensions, R₂ for two: point i is i steps from a random start, wrapped around the unit cube.
///
/// The steps are the powers of 1/φ, where φ > 1 and φ^(D + 1) = φ + 1. Any N points in a row are evenly spread, also where
/// N is not known in advance.
///
#[cfg_attr(doc, doc = include_str!("../../pictures/recurrence.html"))]
///
/// # Domain
/// - Points: 2³², by their index. In each dimension all of them differ.
/// - Dimensions: D from 1 to 8. From D on, words are those of [`ByPosition`](super::ByPosition): plain random ones.
/// - Parameter: a seed, whose hash gives the start. Points of two seeds differ by a random shift.
///
/// # Accuracy
/// Root mean square errors of the mean of N points, from 2⁸ to 2¹⁶, over seeds:
///
/// | integrand | falls as | of random points | at 2¹⁰ smaller by |
/// |---|---|---|--:|
/// | e^(x + y), 2 dimensions | N^−0.9 | N^−0.5 | 10 |
/// | a quarter of a disk, 2 dimensions | N^−0.75 | N^−0.5 | 5 |
///
/// A step is rounded to an odd number of 2⁻³².
///
/// # Cost
/// The two words of a point take <!-- figure: point recurrence_2d -->9 instructions and 92 bytes of code on an M4F, 9 instructions on an M0<!-- -->.
///
/// # Examples
/// ```
/// use microwarp::uniform::{Points, Recurrence};
/// use microwarp::{Warp, constant, poly as mw};
///
/// // 1,000 points of a disk; none is stored.
/// const POINTS: Recurrence<2> = constant!(Recurrence::new(7));
/// let disk = mw::Disk::new();
/// let right = (0..1000).filter(|&i| disk.draw(&mut POINTS.at(i))[0] > 0.0).count();
/// assert!(right.abs_diff(500) <= 5);
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// # See also
/// - [`Sobol`](super::Sobol): smaller errors, for smooth integrands and for more than two dimensions.
///
/// # Source
/// M. Roberts, "The Unreasonable Effectiveness of Quasirandom Sequences", 2018,
/// <https://extremelearning.com.au/unreasonable-effectiveness-of-quasirandom-sequences/>.
#[doc(alias = "R2")]
#[doc(alias = "Kronecker")]
#[doc(alias = "golden_ratio")]
#[doc(alias = "low-discrepancy")]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Recurrence<const D: usize> {
    start: [u32; D],
}

impl<const D: usize> Recurrence<D> {
    /// The points of a seed.
    ///
    /// # Errors
    /// [`Error::Empty`] for 0 dimensions, [`Error::TooLarge`] for more than 8.
    pub const fn new(seed: u32) -> Result<Self, Error> {
        let start = tried!(hashes(seed));
        Ok(Self { start })
    }

    /// The powers of 1/φ, as odd words.
    const STEPS: [u32; D] = {
        let inverse = inverse_of_phi(D);
        let mut steps = [0; D];
        let mut rest: &mut [u32] = &mut steps;
        let mut power = inverse;
        while let [first, others @ ..] = rest {
            *first = (power >> 32) as u32 | 1;
            power = high(power, inverse);
            rest = others;
        }
        steps
    };
}

impl<const D: usize> Points for Recurrence<D> {
    #[inline]
    fn word(self, index: u32, dimension: u32) -> u32 {
        let place = dimension as usize;
        if let (Some(start), Some(step)) = (self.start.get(place), Self::STEPS.get(place)) {
            start.wrapping_add(index.wrapping_mul(*step))
        } else {
            let seed = self.start.first().copied().unwrap_or(0);
            ByPosition::new(seed, 0).word(index, dimension)
        }
    }
}

/// 1/φ, with 64 fractional bits: the x for which x^D + x^(D + 1) is 1, bit by bit.
const fn inverse_of_phi(dimensions: usize) -> u64 {
    let (mut x, mut bit) = (0, 1_u64 << 63);
    while bit > 0 {
        let larger = x | bit;
        let (mut power, mut left) = (larger, dimensions);
        while left > 1 {
            power = high(power, larger);
            left = left.wrapping_sub(1);
        }
        if power.checked_add(high(power, larger)).is_some() {
            x = larger;
        }
        bit >>= 1;
    }
    x
}
