//! Points instead of random numbers: each word is a function of the index of its point and of a dimension.

mod latin_hypercube;
mod position;
mod recurrence;
mod screen;
mod sobol;

pub use self::latin_hypercube::LatinHypercube;
pub use self::position::ByPosition;
pub use self::recurrence::Recurrence;
pub use self::screen::{Screen, ScreenPixel};
pub use self::sobol::Sobol;

use super::deep_from_word;
use super::generators::FromFn;
use crate::error::Error;
use core::convert::Infallible;
use rand_core::TryRng;

/// The most dimensions of a [`Sobol`](super::Sobol) or a [`Recurrence`](super::Recurrence).
pub const MAX_DIMENSIONS: usize = 8;

/// A set of points in the unit cube, whose words are a function of an index and a dimension.
///
/// There is no state: any thread takes any point, in any order. [`at`](Points::at) makes one point a generator, so that
/// every warp, stratum, table, rejection sampler and chain takes it, in the integer tier too.
///
/// # Accuracy
/// A word has 32 bits, and there are 2³² points. [`point`](Points::point) takes a word as the middle of its cell
/// ([`deep_from_word`]), which is right on average. [`Warp::draw`](crate::Warp::draw) cuts a word to the 24-bit grid, as it
/// does those of every generator, unless the warp draws middles itself. That is 2⁻²⁵ low on average, below the noise of a
/// random generator. The error of scrambled Sobol' points over a smooth integrand falls below it from some 2¹⁶ points on.
/// That of `draw` then stays near 3e-8 for each coordinate, where that of [`point`](Points::point) goes on to fall. At 2²⁰
/// points it is 1e-9 of the mean of e^(x + y) instead of 6e-8.
///
/// # Examples
/// ```
/// use microwarp::uniform::{Points, Sobol};
/// use microwarp::{Warp, poly as mw};
///
/// let (points, lens) = (Sobol::<2>::new(7)?, mw::Disk::new());
/// for i in 0..64 {
///     let fast = lens.draw(&mut points.at(i)); // cut to the grid
///     let mean = lens.sample(points.point(i)); // centred
///     assert!((fast[0] - mean[0]).abs() < 1e-6);
/// }
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// Points of your own:
/// ```
/// use microwarp::uniform::Points;
/// # use microwarp::uniform::ByPosition;
///
/// /// Every point of another set, moved by half the cube.
/// #[derive(Clone, Copy)]
/// struct Opposite<P>(P);
/// impl<P: Points> Points for Opposite<P> {
///     fn word(self, index: u32, dimension: u32) -> u32 { self.0.word(index, dimension) ^ 1 << 31 }
/// }
/// # assert_eq!(Opposite(Opposite(ByPosition::new(1, 2))).words::<2>(3), ByPosition::new(1, 2).words(3));
/// ```
///
/// # See also
/// - [`Sobol`](super::Sobol): the smallest errors, best with 2ᵐ points.
/// - [`Recurrence`](super::Recurrence): the cheapest, for any number of points.
/// - [`LatinHypercube`](super::LatinHypercube): for N known in advance, in any dimensions.
/// - [`ByPosition`](super::ByPosition): plain random numbers.
/// - [`Screen`](super::Screen): a set for the pixels of a picture.
#[doc(alias = "quasi-random")]
#[doc(alias = "low-discrepancy")]
#[doc(alias = "QMC")]
pub trait Points: Copy {
    /// The coordinate of point `index` in `dimension`, as a number of 32 fractional bits.
    #[must_use]
    fn word(self, index: u32, dimension: u32) -> u32;

    /// The first N coordinates of a point.
    #[must_use]
    #[inline]
    fn words<const N: usize>(self, index: u32) -> [u32; N] {
        core::array::from_fn(|d| self.word(index, d as u32))
    }

    /// The first N coordinates of a point as uniforms, the middles of the cells of their words: for
    /// [`Warp::sample`](crate::Warp::sample).
    #[must_use]
    #[inline]
    fn point<const N: usize>(self, index: u32) -> [f32; N] {
        self.words(index).map(deep_from_word)
    }

    /// A point as a generator, for [`Warp::draw`](crate::Warp::draw): each word is the next coordinate, from dimension 0.
    #[must_use]
    #[inline]
    fn at(self, index: u32) -> Cursor<Self> {
        Cursor {
            points: self,
            index,
            dimension: 0,
        }
    }
}

/// One point as a generator, from [`Points::at`]: each word is the coordinate of the next dimension.
///
/// A `u64` takes two coordinates, the lower half first, and bytes take one for every four. After 2³² coordinates it
/// begins again.
///
/// # Examples
/// ```
/// use microwarp::uniform::{Points, Sobol};
/// use microwarp::{Warp, poly as mw};
///
/// // A path: a point of the lens, then a direction at each bounce, always in the same dimensions.
/// let path = Sobol::<8>::new(7)?.at(100);
/// let lens = mw::Disk::new().draw(&mut path.skip_to(0));
/// let bounces = [0, 1, 2].map(|k| mw::CosineHemisphere::new().draw(&mut path.skip_to(2 + 2 * k)));
/// # assert!(lens[0].abs() <= 1.0 && bounces[2][2] >= 0.0);
/// # Ok::<(), microwarp::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Cursor<P> {
    points: P,
    index: u32,
    dimension: u32,
}

impl<P: Points> Cursor<P> {
    /// The dimension of the next word.
    #[must_use]
    #[inline]
    pub const fn dimension(&self) -> u32 {
        self.dimension
    }

    /// The same point, from the given dimension on.
    #[must_use]
    #[inline]
    pub const fn skip_to(self, dimension: u32) -> Self {
        Self { dimension, ..self }
    }

    #[inline]
    fn next_word(&mut self) -> u32 {
        let word = self.points.word(self.index, self.dimension);
        self.dimension = self.dimension.wrapping_add(1);
        word
    }
}

impl<P: Points> TryRng for Cursor<P> {
    type Error = Infallible;

    #[inline]
    fn try_next_u32(&mut self) -> Result<u32, Infallible> {
        Ok(self.next_word())
    }

    #[inline]
    fn try_next_u64(&mut self) -> Result<u64, Infallible> {
        FromFn(|| self.next_word()).try_next_u64()
    }

    #[inline]
    fn try_fill_bytes(&mut self, bytes: &mut [u8]) -> Result<(), Infallible> {
        FromFn(|| self.next_word()).try_fill_bytes(bytes)
    }
}

/// What is added before a hash, so that no input is one that the hash keeps: 2³² over the golden ratio.
const GOLDEN: u32 = 0x9e37_79b9;

/// A one-to-one hash of 32 bits, in which each bit of the input changes each of the output with a chance of nearly ½.
///
/// It is `lowbias32` of C. Wellons, <https://github.com/skeeto/hash-prospector>.
#[inline]
const fn hash(x: u32) -> u32 {
    let x = x ^ (x >> 16);
    let x = x.wrapping_mul(0x7feb_352d);
    let x = x ^ (x >> 15);
    let x = x.wrapping_mul(0x846c_a68b);
    x ^ (x >> 16)
}

/// The hash of a number under a key.
#[inline]
pub(super) const fn keyed(key: u32, number: u32) -> u32 {
    hash(key.wrapping_add(number.wrapping_add(1).wrapping_mul(GOLDEN)))
}

/// The hashes of a seed, one for each dimension of a set.
const fn hashes<const D: usize>(seed: u32) -> Result<[u32; D], Error> {
    match D {
        0 => return Err(Error::Empty(Error::NO_PLACE)),
        1..=MAX_DIMENSIONS => {}
        _ => return Err(Error::TooLarge(Error::NO_PLACE)),
    }
    let key = keyed(seed, 0);
    let mut hashes = [0; D];
    let mut rest: &mut [u32] = &mut hashes;
    let mut dimension = 0;
    while let [first, others @ ..] = rest {
        *first = keyed(key, dimension);
        dimension = dimension.wrapping_add(1);
        rest = others;
    }
    Ok(hashes)
}
