//! One set of points for a whole picture, in an order by which the errors of neighbouring pixels cancel.

use super::sobol::scrambled;
use super::{Points, keyed};
use crate::error::Error;

/// One set of points for all pixels of a picture, such that the errors of neighbouring pixels differ: blue noise.
///
#[cfg_attr(doc, doc = include_str!("../../pictures/screen.html"))]
///
/// A square of 2ᵃ × 2ᵃ pixels whose corner is at multiples of 2ᵃ takes a block of the set, and so does each pixel in it. Blocks lie
/// in a random order, by Owen's scrambling of the index, so that no seam of the order is seen. The points of one pixel are as even as
/// those of a set of its own, and those of neighbours together are nearly as even as so many points of one set. What a
/// filter, a screen or an eye averages over neighbours therefore has a smaller error.
///
/// # Domain
/// - Set: any, by its index. [`Sobol`](super::Sobol) has even blocks in one order for all of its dimensions: take the largest D
///   whose dimensions act together. Other sets gain less or nothing.
/// - Picture: b = ⌈log₂ of its longer side⌉. Pixels (x, y) and samples s < 2ᵏ take each index below 2^(2b + k) at most once; those
///   of a square picture of side 2ᵇ, exactly once. A pixel outside of the picture has the points of another one.
/// - Samples: k = `log2_samples`. **2ᵏ must be the number of samples that are taken.** The first 4 of 16 are even in a pixel, but
///   gain nothing between pixels. Samples from 2ᵏ on are those of further sets, independent of the first and in its order: words
///   are scrambled once more, under another key for every 2ᵏ samples.
/// - Parameter: a seed of the order, which is hashed. It may be that of the set. For another frame take others.
///
/// # Accuracy
/// Every point is uniform over the seeds of its set, so that no pixel has a bias. The root mean square error of a pixel is that of
/// a scrambled set of its own. After a mean over 3 × 3 pixels it is smaller by these factors, for integrands that change slowly over
/// the picture:
///
/// | integrand | 1 sample | 4 | 16 |
/// |---|--:|--:|--:|
/// | e^(ax + by) | 1.52 | 1.58 | 1.65 |
/// | a part of a disk | 1.32 | 1.33 | 1.25 |
/// | a half-plane | 1.32 | 1.25 | 1.26 |
///
/// # Cost
/// No table: 12 bytes beside the set. The words of a sample in two dimensions take
/// <!-- figure: point screen_sobol_2d -->109 instructions and 520 bytes of code on an M4F, 210 instructions on an M0<!-- -->.
///
/// # Examples
/// ```
/// use microwarp::uniform::{Points, Screen, Sobol};
/// use microwarp::{Warp, constant, poly as mw};
///
/// // 16 samples a pixel of a picture of 1920 × 1080.
/// const SCREEN: Screen<Sobol<8>> = constant!(Screen::new(constant!(Sobol::new(7)), [1920, 1080], 4, 7));
/// let lens = mw::Disk::new();
/// let pixel = SCREEN.pixel(960, 540);
/// let points = [0, 1, 2, 3].map(|sample| lens.draw(&mut pixel.at(sample)));
/// # assert!(points[0] != points[1]);
///
/// // The same point, from the set itself.
/// let set = Sobol::<8>::new(7)?;
/// assert_eq!(points[3], lens.draw(&mut set.at(pixel.index(3))));
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// # See also
/// - [`Sobol`](super::Sobol): the set; one with a seed of its own for each pixel has errors that are independent.
///
/// # Source
/// A. G. M. Ahmed, P. Wonka, "Screen-Space Blue-Noise Diffusion of Monte Carlo Sampling Error via Hierarchical Ordering of Pixels",
/// 2020, <https://doi.org/10.1145/3414685.3417881>; here the order is random by Owen's scrambling, in base 2.
#[doc(alias = "blue_noise")]
#[doc(alias = "dithering")]
#[doc(alias = "Morton")]
#[doc(alias = "Z-order")]
#[doc(alias = "ZSobolSampler")]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Screen<P> {
    points: P,
    key: u32,
    log2_samples: u32,
    /// The bits of an index: ones from the lowest on.
    indices: u32,
}

impl<P: Points> Screen<P> {
    /// An order of a set for a picture of so many columns and rows, with 2^`log2_samples` samples a pixel.
    ///
    /// # Errors
    /// [`Error::Empty`] for a picture without pixels, [`Error::TooLarge`] where 2b + k, as above, is more than 32.
    pub const fn new(
        points: P,
        [width, height]: [u32; 2],
        log2_samples: u32,
        seed: u32,
    ) -> Result<Self, Error> {
        if width == 0 || height == 0 {
            return Err(Error::Empty(1));
        }
        let last = width.wrapping_sub(1) | height.wrapping_sub(1);
        let side = 32_u32.wrapping_sub(last.leading_zeros());
        let bits = side.wrapping_mul(2).saturating_add(log2_samples);
        match 32_u32.checked_sub(bits) {
            Some(unused) => Ok(Self {
                points,
                key: keyed(seed, 3),
                log2_samples,
                indices: shifted_down(u32::MAX, unused),
            }),
            None => Err(Error::TooLarge(2)),
        }
    }

    /// The points of a pixel: sample s is point s.
    #[must_use]
    #[inline]
    pub const fn pixel(self, x: u32, y: u32) -> ScreenPixel<P> {
        let place = spread(x) | spread(y) << 1;
        ScreenPixel {
            first: match place.checked_shl(self.log2_samples) {
                Some(first) => first,
                None => 0,
            },
            screen: self,
        }
    }

    /// The set.
    #[must_use]
    #[inline]
    pub const fn points(self) -> P {
        self.points
    }

    /// The binary logarithm of the samples of a pixel.
    #[must_use]
    #[inline]
    pub const fn log2_samples(self) -> u32 {
        self.log2_samples
    }
}

/// The points of one pixel, from [`Screen::pixel`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ScreenPixel<P> {
    screen: Screen<P>,
    /// Its first sample along the curve.
    first: u32,
}

impl<P: Points> ScreenPixel<P> {
    /// The index in the set of a sample below 2ᵏ: the words of the pixel's point `sample` are those of the set's point `index`. Of a
    /// later sample it is that of the sample with its lowest k bits.
    #[must_use]
    #[inline]
    pub const fn index(self, sample: u32) -> u32 {
        let Screen {
            key,
            log2_samples,
            indices,
            ..
        } = self.screen;
        let beyond = match u32::MAX.checked_shl(log2_samples) {
            Some(beyond) => beyond,
            None => 0,
        };
        let along = self.first | sample & !beyond;
        scrambled(along.reverse_bits(), key).reverse_bits() & indices
    }

    /// The key of the further set that a sample belongs to, if it does.
    #[inline]
    const fn further(self, sample: u32) -> Option<u32> {
        match shifted_down(sample, self.screen.log2_samples) {
            0 => None,
            set => Some(keyed(self.screen.key, set)),
        }
    }
}

impl<P: Points> Points for ScreenPixel<P> {
    #[inline]
    fn word(self, sample: u32, dimension: u32) -> u32 {
        let word = self.screen.points.word(self.index(sample), dimension);
        self.further(sample)
            .map_or(word, |key| again(word, key, dimension))
    }

    #[inline]
    fn words<const N: usize>(self, sample: u32) -> [u32; N] {
        let mut words = self.screen.points.words(self.index(sample));
        if let Some(key) = self.further(sample) {
            for (word, dimension) in words.iter_mut().zip(0..) {
                *word = again(*word, key, dimension);
            }
        }
        words
    }
}

/// A word that is scrambled once more: a scrambled set becomes another one, independent of it.
#[inline]
const fn again(word: u32, key: u32, dimension: u32) -> u32 {
    scrambled(word.reverse_bits(), keyed(key, dimension)).reverse_bits()
}

/// A shift to the right by any number of bits.
#[inline]
const fn shifted_down(x: u32, bits: u32) -> u32 {
    match x.checked_shr(bits) {
        Some(shifted) => shifted,
        None => 0,
    }
}

/// The lowest 16 bits, each moved to twice its place: between those of another number they are a place along Morton's curve.
#[inline]
const fn spread(x: u32) -> u32 {
    let x = x & 0xffff;
    let x = (x | x << 8) & 0x00ff_00ff;
    let x = (x | x << 4) & 0x0f0f_0f0f;
    let x = (x | x << 2) & 0x3333_3333;
    (x | x << 1) & 0x5555_5555
}
