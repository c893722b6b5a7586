//! Random words by their position alone.

use super::{Points, hash, keyed};

/// Random numbers without a generator: a word is a hash of a seed, a pixel, a sample and a dimension.
///
/// Any thread takes any word, in any order, and a sample is repeated by its numbers. The index of [`Points`] is the sample.
/// "Pixel" can be any stream: a particle, a task, a frame.
///
#[cfg_attr(doc, doc = include_str!("../../pictures/by_position.html"))]
///
/// # Domain
/// - Numbers: 2³² each of seeds, pixels, samples and dimensions.
/// - Within a seed, no two samples of any pixels have the same words.
///
/// # Accuracy
/// Words pass tests of equal bits, of independence from the word at each neighbouring seed, pixel, sample and dimension, and of
/// avalanche: a changed bit of any of the four numbers changes each bit of the word half the time, as far as 65,536 positions
/// tell. Of neighbouring samples and pixels they are independent in pairs and triples, and no two samples exchange words. The
/// hash keeps no secret. Errors of means fall as N^−0.5.
///
/// # Cost
/// The two words of a point take <!-- figure: point by_position_2 -->42 instructions and 160 bytes of code on an M4F, 59 instructions on an M0<!-- -->.
///
/// # Examples
/// ```
/// use microwarp::uniform::{ByPosition, Points};
/// use microwarp::{Warp, poly as mw};
///
/// let lens = mw::Disk::new();
/// let pixel = ByPosition::new(2026, 1920 * 7 + 13);
/// let points = [0, 1, 2, 3].map(|sample| lens.draw(&mut pixel.at(sample)));
/// assert_eq!(points[2], lens.draw(&mut pixel.at(2)));
/// ```
///
/// # See also
/// - [`Sobol`](super::Sobol), [`Recurrence`](super::Recurrence): sets whose means have smaller errors.
///
/// # Source
/// J. K. Salmon, M. A. Moraes, R. O. Dror, D. E. Shaw, "Parallel Random Numbers: As Easy as 1, 2, 3", 2011,
/// <https://doi.org/10.1145/2063384.2063405>, for the idea; the hash is `lowbias32` of C. Wellons,
/// <https://github.com/skeeto/hash-prospector>.
#[doc(alias = "counter_based")]
#[doc(alias = "hash")]
#[doc(alias = "stateless")]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ByPosition {
    /// The key of dimensions: another one for each pixel of a seed.
    dimensions: u32,
    /// The key of samples.
    samples: u32,
}

impl ByPosition {
    /// The words of a pixel under a seed.
    #[must_use]
    pub const fn new(seed: u32, pixel: u32) -> Self {
        Self {
            dimensions: keyed(keyed(seed, 0), pixel),
            samples: keyed(keyed(seed, 1), pixel),
        }
    }
}

impl Points for ByPosition {
    #[inline]
    fn word(self, sample: u32, dimension: u32) -> u32 {
        // A sum: by a difference in bits two samples would exchange their words of two dimensions.
        let word = keyed(self.samples, sample).wrapping_add(keyed(self.dimensions, dimension));
        hash(word)
    }
}
