//! The hypergeometric distribution of small variance: how many of those drawn without replacement are marked.

use super::ends::{Ends, Kind, Law};
use super::word::drawn_by_word;
use crate::error::Error;
use crate::num::Long;
use core::ops::RangeInclusive;

/// The number of marked items among n that are drawn from N without replacement, of which K are marked, of a variance up to 100,
/// by inversion: faulty parts of a sample, aces of a hand, tagged fish of a catch.
///
/// Counts increase with the word. The constructor makes a table of the words of each count, and a draw is eight
/// comparisons of integers. So [`constant!`](crate::constant) suits it, where the three numbers are constants.
///
/// # Density
/// C(K, k) C(N − K, n − k)/C(N, n) for the count k, with binomial coefficients C.
///
/// # Domain
/// - Point: a `u32` from n + K − N, or 0, to the smaller of n and K. The tails of a single word end where a part of 2⁻³³ is left.
/// - Uniforms: one word.
/// - Parameters: any N, and K and n from 0 to N, where the variance nK(N − K)(N − n)/(N²(N − 1)) is at most 100.
///
/// # Accuracy
/// - Of the 2³² words, the cumulated probability times 2³² give k or less, rounded to the nearest integer.
///   [`words_of`](Self::words_of) says which give k. Before it is rounded, the number is off by less than 2⁻²⁰.
/// - The pmf is that of the formula for every count, to a relative error of 6.2e-8, or to the spacing of subnormals.
///
/// # Cost
/// 552 bytes of memory, or flash where [`constant!`](crate::constant) makes it. The constructor goes through at most 450
/// counts, with a division of 64 bits each. There is no floating-point operation but in the pmf.
///
/// # Examples
/// ```
/// use microwarp::{constant, discrete::Hypergeometric};
/// use rand_pcg::Pcg32;
/// const ACES: Hypergeometric = constant!(Hypergeometric::new(52, 4, 13)); // in a hand of bridge
/// let aces = ACES.draw(&mut Pcg32::new(1, 1));
/// assert!(ACES.words_of(aces).is_some());
/// assert_eq!((ACES.count(0), ACES.count(1 << 31), ACES.count(u32::MAX)), (0, 1, 4));
/// assert!((ACES.pmf(0) - 0.303_817_53).abs() < 1e-8);
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// # See also
/// - [`rejection::HypergeometricRejection`](crate::rejection::HypergeometricRejection): variances from 10 up.
/// - [`Binomial`](super::Binomial): with replacement.
/// - [`uniform::choose`](crate::uniform::choose): the items themselves.
///
/// # Source
/// L. Devroye, *Non-Uniform Random Variate Generation*, Springer, 1986, chapters III.2 and X.4 (inversion, the ratio of
/// neighbouring probabilities): <http://luc.devroye.org/rnbookindex.html>.
#[doc(alias = "urn")]
#[doc(alias = "without_replacement")]
#[doc(alias = "acceptance_sampling")]
#[doc(alias = "capture_recapture")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Hypergeometric {
    population: u32,
    marked: u32,
    drawn: u32,
    table: Ends<128>,
}

impl Hypergeometric {
    /// Of a `population`, so many are `marked` and so many are `drawn`.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for more marked or drawn than there are, [`Error::TooLarge`] for a variance above 100.
    pub const fn new(population: u32, marked: u32, drawn: u32) -> Result<Self, Error> {
        let (Some(others), Some(left)) = (
            population.checked_sub(marked),
            population.checked_sub(drawn),
        ) else {
            return Err(Error::OutOfRange(if marked > population { 1 } else { 2 }));
        };
        let law = Self::law(population, marked, drawn);
        let [least, most] = law.range();
        // Otherwise the population is at least 2.
        if least < most {
            let all = Long::of(population as u64, 64);
            let mean = Long::of((marked as u64).wrapping_mul(drawn as u64), 64).over(all);
            let rest = Long::of((others as u64).wrapping_mul(left as u64), 64).over(all);
            let variance = mean.times(rest.over(Long::of((population as u64).wrapping_sub(1), 64)));
            if variance.exceeds(Long::of(100, 64)) {
                return Err(Error::TooLarge(Error::NO_PLACE));
            }
        }
        // The mode is (K + 1)(n + 1)/(N + 2), cut to an integer.
        let [marked_next, drawn_next] = [
            (marked as u64).wrapping_add(1),
            (drawn as u64).wrapping_add(1),
        ];
        let mode = Long::of(marked_next, 64)
            .times(Long::of(drawn_next, 64))
            .over(Long::of((population as u64).wrapping_add(2), 64))
            .whole();
        let mode = if mode < least as u64 {
            least
        } else if mode < most as u64 {
            mode as u32
        } else {
            most
        };
        Ok(Self {
            population,
            marked,
            drawn,
            table: Ends::of(&law, mode),
        })
    }

    const fn law(population: u32, marked: u32, drawn: u32) -> Law {
        Law {
            kind: Kind::Urn {
                population,
                marked,
                drawn,
            },
            odds: Long::ONE,
            inverse: Long::ONE,
        }
    }

    /// The number of all items.
    #[must_use]
    pub const fn population(&self) -> u32 {
        self.population
    }

    /// The number of marked items.
    #[must_use]
    pub const fn marked(&self) -> u32 {
        self.marked
    }

    /// The number of items drawn.
    #[must_use]
    pub const fn drawn(&self) -> u32 {
        self.drawn
    }

    /// The count of a word.
    #[must_use]
    #[inline]
    pub fn count(&self, word: u32) -> u32 {
        self.table.count(word)
    }

    drawn_by_word!();

    /// The words that give a count; none beyond the end of either tail.
    #[must_use]
    pub fn words_of(&self, count: u32) -> Option<RangeInclusive<u32>> {
        self.table.words_of(count)
    }

    /// The probability of a count; 0 only outside its range and below the smallest `f32`.
    #[must_use]
    pub fn pmf(&self, count: u32) -> f32 {
        self.table
            .pmf(&Self::law(self.population, self.marked, self.drawn), count)
    }
}
