//! Sobol' points with Owen's scrambling, by a hash.

use super::{Points, hashes, keyed};
use crate::error::{Error, tried};

mod directions;

/// Sobol' points of D dimensions with Owen's scrambling: random, and much more even than random points.
///
/// Any number of points from index 0 on serves; 2ᵐ are best. Each point alone is uniform over the seeds, so the mean of an
/// integrand over a set has no bias.
///
#[cfg_attr(doc, doc = include_str!("../../pictures/sobol.html"))]
///
/// # Domain
/// - Points: 2³², by their index.
/// - Dimensions: D from 1 to 8. The first 2ᵐ points, and every block of 2ᵐ from a multiple of 2ᵐ on, have one in each of 2ᵐ
///   equal intervals of every dimension. In the square of the first two dimensions they have one in each of 2ᵐ equal boxes,
///   whatever their 2ᵃ columns and 2ᵇ rows, a + b = m.
/// - Dimensions from D on: groups of D, each a set of its own with a seed and an order of its own. The structure holds within a
///   group. Between groups the points are as independent ones.
/// - Parameter: a seed, which is hashed. Points of equal seeds are equal. Those of other seeds, neighbours too, are as
///   independent ones.
///
/// # Accuracy
/// Root mean square errors of the mean of N points, from 2⁸ to 2¹⁶, over seeds:
///
/// | integrand | falls as | of random points | at 2¹⁰ smaller by |
/// |---|---|---|--:|
/// | e^(x + y), 2 dimensions | N^−1.45 | N^−0.5 | 500 |
/// | a quarter of a disk, 2 dimensions | N^−0.75 | N^−0.5 | 5 |
/// | the product of 8 factors ½ + x | N^−1.0 | N^−0.5 | 17 |
/// | the same in groups of 2, 4 | N^−0.5 | N^−0.5 | 1.8, 2 |
///
/// The hash is nearly Owen's scrambling, and errors are those of exact scrambling: whether a bit is flipped depends on no bit
/// before it by more than 0.003, the noise of the measurement.
/// [`Points`] says when to take [`point`](Points::point) instead of [`Warp::draw`](crate::Warp::draw).
///
/// # Cost
/// The first two dimensions need no table, and a program of `Sobol<2>` links none. From the third on there are 768 bytes.
///
/// The two words of a point take <!-- figure: point sobol_2d -->44 instructions and 176 bytes of code on an M4F, 91 instructions on an M0<!-- -->.
/// Eight words, of the first 1,024 points, take <!-- figure: point sobol_8d -->260 instructions and 480 bytes of code on an M4F, 467 instructions on an M0<!-- -->.
///
/// # Examples
/// ```
/// use microwarp::uniform::{ByPosition, Points, Sobol};
/// use microwarp::{Warp, poly as mw};
///
/// // The mean of a cosine over a hemisphere, 1/2, from 256 points, in each of four pixels.
/// let seeds = ByPosition::new(2026, 0);
/// for pixel in 0..4 {
///     let points = Sobol::<2>::new(seeds.word(pixel, 0))?;
///     let cosine = |i| mw::Hemisphere::new().sample(points.point(i))[2];
///     let mean = (0..256).map(cosine).sum::<f32>() / 256.0;
///     assert!((mean - 0.5).abs() < 1e-3);
/// }
/// assert!(Sobol::<9>::new(1).is_err());
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// # See also
/// - [`Recurrence`](super::Recurrence): cheaper, and even for any number of points.
/// - [`Screen`](super::Screen): one set for all pixels of a picture.
/// - [`Strata2d`](crate::uniform::Strata2d): for a number of points that is known in advance.
///
/// # Source
/// I. M. Sobol', 1967, <https://doi.org/10.1016/0041-5553(67)90144-9>; directions of S. Joe, F. Y. Kuo, 2008,
/// <https://doi.org/10.1137/070709359>; A. B. Owen, 1995, <https://doi.org/10.1007/978-1-4612-2552-2_19>; by a hash: S. Laine,
/// T. Karras, 2011, <https://doi.org/10.1111/j.1467-8659.2011.02005.x>, B. Burley, 2020,
/// <https://jcgt.org/published/0009/04/01/>.
#[doc(alias = "Owen")]
#[doc(alias = "scrambled")]
#[doc(alias = "low-discrepancy")]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Sobol<const D: usize> {
    seeds: [u32; D],
}

impl<const D: usize> Sobol<D> {
    /// The points of a seed.
    ///
    /// # Errors
    /// [`Error::Empty`] for 0 dimensions, [`Error::TooLarge`] for more than 8.
    pub const fn new(seed: u32) -> Result<Self, Error> {
        let seeds = tried!(hashes(seed));
        Ok(Self { seeds })
    }
}

impl<const D: usize> Points for Sobol<D> {
    #[inline]
    fn word(self, index: u32, dimension: u32) -> u32 {
        let group = dimension.checked_div(D as u32).unwrap_or(0);
        let dimension = dimension.wrapping_sub(group.wrapping_mul(D as u32));
        let [first, ..] = self.seeds.as_slice() else {
            return 0;
        };
        let (index, seed) = if group == 0 {
            let seed = self.seeds.get(dimension as usize);
            (index, seed.copied().unwrap_or(0))
        } else {
            let key = keyed(*first, group);
            let order = scrambled(index.reverse_bits(), keyed(key, D as u32));
            (order.reverse_bits(), keyed(key, dimension))
        };
        // Bits are reversed until the end: the leading one is the lowest.
        let x = match dimension {
            0 => index,
            1 => pascal(index),
            // Without the condition two dimensions would link the table, where the compiler does not know the dimension.
            _ if D > 2 => directions::sum(index, dimension),
            _ => 0,
        };
        scrambled(x, seed).reverse_bits()
    }

    #[inline]
    fn words<const N: usize>(self, index: u32) -> [u32; N] {
        if N <= 2 || N > D {
            return core::array::from_fn(|d| self.word(index, d as u32));
        }
        // All at once, so that the bits of the index are gone through once.
        let [c, d, e, f, g, h] = directions::sums(index);
        let coordinates = [index, pascal(index), c, d, e, f, g, h];
        let mut words = [0; N];
        for ((word, x), seed) in words.iter_mut().zip(coordinates).zip(self.seeds) {
            *word = scrambled(x, seed).reverse_bits();
        }
        words
    }
}

/// The sums modulo 2 of the bits of an index by Pascal's triangle: bit j is the sum of those bits k that hold all bits of j.
#[inline]
const fn pascal(index: u32) -> u32 {
    let x = index ^ (index >> 1 & 0x5555_5555);
    let x = x ^ (x >> 2 & 0x3333_3333);
    let x = x ^ (x >> 4 & 0x0f0f_0f0f);
    let x = x ^ (x >> 8 & 0x00ff_00ff);
    x ^ (x >> 16)
}

/// Owen's scrambling of reversed bits: each bit is flipped or not, by a hash of the seed and of the bits below it.
///
/// Sums and products carry upwards alone. The form is that of N. Vegdahl, "Building a Better LK Hash", 2021,
/// <https://psychopath.io/post/2021_01_30_building_a_better_lk_hash>. Of some thousand random factors these had the least
/// bias over 2¹⁸ words and seeds: no bit follows one below it by more than the noise, 0.003.
#[inline]
pub(super) const fn scrambled(x: u32, seed: u32) -> u32 {
    let x = x ^ x.wrapping_mul(0x1705_b884);
    let x = x.wrapping_add(seed).wrapping_mul(seed >> 16 | 1);
    let x = x ^ x.wrapping_mul(0x7c2f_1220);
    x ^ x.wrapping_mul(0xe2a6_5e92)
}
