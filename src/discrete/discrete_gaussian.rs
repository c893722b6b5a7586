//! The discrete Gaussian: integers about a centre.

use super::ends::{Ends, Kind, Law, NOTHING, Squares};
use super::word::drawn_by_word;
use crate::error::{Error, finite, positive, tried};
use crate::num::Long;
use core::ops::RangeInclusive;

/// An integer with a Gaussian about any centre, of a scale up to 20, by inversion: noise of whole numbers, errors of a lattice.
///
/// It is not a rounded normal number: the probabilities are those of the Gaussian at the integers, normalised. The constructor
/// makes a table of the words of each integer, and a draw is nine comparisons of integers, which do not depend on the result.
/// Integers increase with the word.
///
/// No claim of privacy is made: a word has 32 bits, the tails end where a part of 2⁻³³ is left, and the generator decides what an
/// observer may guess.
///
/// # Density
/// In proportion to e^(−(k − μ)²/2s²) for the integer k.
///
/// # Domain
/// - Point: an `i32`. The tails of a single word end where a part of 2⁻³³ is left, about 6.3 s from the centre; at most 256
///   integers have words.
/// - Uniforms: one word.
/// - Parameters: a centre from −2³⁰ to 2³⁰, which need not be an integer, and a scale above 0 and up to 20. The scale of a Gaussian
///   is a little above its standard deviation where it is small.
///
/// # Accuracy
/// - Of the 2³² words, the cumulated probability times 2³² give k or less, rounded to the nearest integer.
///   [`words_of`](Self::words_of) says which give k. Before it is rounded, the number is off by less than 2⁻¹⁶.
/// - The pmf is that of the formula for every integer, to a relative error of 6.2e-8, or to the spacing of subnormals.
///
/// # Cost
/// 1,080 bytes of memory, or flash where [`constant!`](crate::constant) makes it. The constructor goes through at most 800
/// integers, with some twenty products of 64 bits each.
///
/// # Examples
/// ```
/// use microwarp::{constant, discrete::DiscreteGaussian};
/// use rand_pcg::Pcg32;
/// const NOISE: DiscreteGaussian = constant!(DiscreteGaussian::new(0.25, 3.0));
/// let noise = NOISE.draw(&mut Pcg32::new(1, 1));
/// assert!(NOISE.words_of(noise).is_some());
/// assert_eq!((NOISE.integer(0), NOISE.integer(1 << 31), NOISE.integer(u32::MAX)), (-19, 0, 19));
/// assert!((NOISE.pmf(0) - 0.132_519_83).abs() < 1e-7);
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// # See also
/// - [`DiscreteLaplace`](super::DiscreteLaplace): heavier tails, any scale.
/// - [`Binomial`](super::Binomial): the number of heads, which is nearly this where there are many coins.
/// - [`warp::Normal`](crate::warp::Normal): real numbers.
///
/// # Source
/// C. L. Canonne, G. Kamath and T. Steinke, "The Discrete Gaussian for Differential Privacy", 2020,
/// <https://arxiv.org/abs/2004.00010>, for the distribution. The table is this crate's own.
#[doc(alias = "lattice")]
#[doc(alias = "integer_noise")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct DiscreteGaussian {
    centre: f32,
    scale: f32,
    /// Twice the distance of the integer with the largest probability from the centre, in units of 2⁻⁶².
    off: i64,
    /// 1/2s².
    rate: Long,
    table: Ends<256>,
}

/// The sign bit: as far as counts, which begin at 0, are above integers.
const ZERO: u32 = 1 << 31;

#[expect(
    clippy::cast_possible_wrap,
    reason = "counts from the smallest integer"
)]
const fn integer_of(count: u32) -> i32 {
    (count ^ ZERO) as i32
}

const fn count_of(integer: i32) -> u32 {
    integer as u32 ^ ZERO
}

impl DiscreteGaussian {
    /// The largest scale.
    pub const LARGEST: f32 = 20.0;

    /// A Gaussian about this centre with this scale.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for NaN or infinity, [`Error::NotPositive`] for a scale of 0 or less, [`Error::TooLarge`] for one above
    /// 20, [`Error::OutOfRange`] for a centre beyond 2³⁰ either way.
    pub const fn new(centre: f32, scale: f32) -> Result<Self, Error> {
        const FAR: f32 = 1_073_741_824.0;
        let (centre, scale) = (tried!(finite(centre, 0)), tried!(positive(scale, 1)));
        if scale > Self::LARGEST {
            return Err(Error::TooLarge(1));
        }
        if centre < -FAR || centre > FAR {
            return Err(Error::OutOfRange(0));
        }
        // Cut towards 0, and exact: beyond 2²³ there is nothing to cut.
        let whole = centre as i32;
        let part = centre - whole as f32;
        let (mode, off) = if part >= 0.5 {
            (whole.wrapping_add(1), 1.0 - part)
        } else if part < -0.5 {
            (whole.wrapping_sub(1), -1.0 - part)
        } else {
            (whole, -part)
        };
        let scale_long = Long::of_f32(scale);
        let square = scale_long.times(scale_long);
        let rate = Long::of(1, 63).over(square);
        let off = (off * 9_223_372_036_854_775_808.0) as i64;
        let law = Self::law(count_of(mode), off, rate);
        Ok(Self {
            centre,
            scale,
            off,
            rate,
            table: Ends::of(&law, count_of(mode)),
        })
    }

    const fn law(mode: u32, off: i64, rate: Long) -> Law {
        Law {
            kind: Kind::Squares(Squares { mode, off, rate }),
            odds: NOTHING,
            inverse: NOTHING,
        }
    }

    /// The centre.
    #[must_use]
    pub const fn centre(&self) -> f32 {
        self.centre
    }

    /// The scale.
    #[must_use]
    pub const fn scale(&self) -> f32 {
        self.scale
    }

    /// The integer of a word.
    #[must_use]
    #[inline]
    pub fn integer(&self, word: u32) -> i32 {
        integer_of(self.table.count(word))
    }

    drawn_by_word!(i32 by integer);

    /// The words that give an integer; none beyond the end of either tail.
    #[must_use]
    pub fn words_of(&self, integer: i32) -> Option<RangeInclusive<u32>> {
        self.table.words_of(count_of(integer))
    }

    /// The probability of an integer; 0 only below the smallest `f32`.
    #[must_use]
    pub fn pmf(&self, integer: i32) -> f32 {
        let law = Self::law(self.table.mode(), self.off, self.rate);
        self.table.pmf(&law, count_of(integer))
    }
}
