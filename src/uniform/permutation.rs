//! An order of n numbers by a key: no table.

use super::points::keyed;
use crate::error::Error;
use crate::num::up_to;

/// The rounds of what is no table. Six leave pairs of places that are not independent up to n = 128.
const ROUNDS: usize = 8;
/// The most numbers that 4 bits each have room for.
const FEW: u32 = 16;
/// The number 1 sixteen times.
const ONES: u64 = 0x1111_1111_1111_1111;

/// A random order of the numbers 0 to n − 1 that is computed, number by number, and takes no memory.
///
/// [`get`](Self::get) says which number stands at a place, and [`index_of`](Self::index_of) at which place a number stands.
/// Equal n and seed give the same order.
///
/// # Domain
/// - Numbers: n from 1 to 2³² − 1.
/// - Parameter: a seed, which is hashed. Orders of neighbouring seeds are as independent ones.
///
/// # Accuracy
/// Each number stands at exactly one place, for every n and seed.
/// - Up to n = 16 the order is shuffled: over the seeds each occurs as of random shuffles. From n = 13 on there are more
///   orders than seeds.
/// - Beyond, eight rounds of a multiplication and a shift mix the place under sixteen hashed words. Over the seeds the places of one
///   number, of two and of three are as those of a random order, as far as some millions of orders tell. Of all n! orders only
///   2³² occur. The order keeps no secret.
///
/// # Cost
/// 76 bytes. The rounds work on 2ᵐ ≥ n numbers, and are repeated while they lead outside: at most 2ᵐ − n times, and 2ᵐ/n − 1
/// times on average. That is less than once, and never for a power of two. Over the seeds t repetitions and more
/// have a share of 2⁻ᵗ on average.
///
/// A place takes <!-- figure: point permutation_1000 -->85 instructions and 188 bytes of code on an M4F, 101 instructions on an M0<!-- --> for n = 1,000.
///
/// # Examples
/// ```
/// use microwarp::uniform::Permutation;
/// let pixels = Permutation::new(640 * 480, 7)?;
/// let first = pixels.get(0); // the pixel to be drawn first
/// assert_eq!(first.and_then(|pixel| pixels.index_of(pixel)), Some(0));
/// assert_eq!(pixels.get(640 * 480), None);
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// # See also
/// - [`shuffle`](super::shuffle): items in memory, by a generator.
/// - [`LatinHypercube`](super::LatinHypercube): points whose coordinates are such orders.
///
/// # Source
/// J. Black, P. Rogaway, "Ciphers with Arbitrary Finite Domains", 2002, <https://doi.org/10.1007/3-540-45760-7_9>, for the
/// repetition; A. Kensler, "Correlated Multi-Jittered Sampling", 2013, <https://graphics.pixar.com/library/MultiJitteredSampling/>,
/// for the use. The rounds are other ones.
#[doc(alias = "permute")]
#[doc(alias = "shuffle_iterator")]
#[doc(alias = "format_preserving_encryption")]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Permutation {
    count: u32,
    /// Of 2ᵐ numbers.
    mask: u32,
    /// m/2, rounded up.
    half: u32,
    /// What each round adds and multiplies by. Of few numbers, the first pair has the numbers, place by place.
    keys: [[u32; 2]; ROUNDS],
}

impl Permutation {
    /// The order of the numbers below `count` under a seed.
    ///
    /// # Errors
    /// [`Error::Empty`] for 0.
    pub const fn new(count: u32, seed: u32) -> Result<Self, Error> {
        if count == 0 {
            return Err(Error::Empty(0));
        }
        let key = keyed(seed, 0);
        let mut keys = [[0; 2]; ROUNDS];
        if count <= FEW {
            let numbers = shuffled(count, key);
            let [first, ..] = &mut keys;
            *first = [(numbers >> 32) as u32, numbers as u32];
        } else {
            let mut number = 0_u32;
            let mut rest: &mut [[u32; 2]] = &mut keys;
            while let [[add, multiply], others @ ..] = rest {
                *add = keyed(key, number);
                *multiply = keyed(key, number | 1) | 1;
                number = number.wrapping_add(2);
                rest = others;
            }
        }
        let zeros = count.wrapping_sub(1).leading_zeros();
        Ok(Self {
            count,
            mask: u32::MAX.wrapping_shr(zeros),
            half: 33_u32.wrapping_sub(zeros) >> 1,
            keys,
        })
    }

    /// How many numbers there are.
    #[must_use]
    #[inline]
    pub const fn count(&self) -> u32 {
        self.count
    }

    /// The number at a place; `None` from n on.
    #[must_use]
    #[inline]
    pub const fn get(&self, place: u32) -> Option<u32> {
        if place >= self.count {
            return None;
        }
        if self.count <= FEW {
            return Some((self.numbers() >> (place << 2)) as u32 & 15);
        }
        let (mut at, mut outside) = (self.mixed(place), self.outside());
        while at >= self.count && outside > 0 {
            at = self.mixed(at);
            outside = outside.wrapping_sub(1);
        }
        Some(at)
    }

    /// The place of a number; `None` from n on.
    #[must_use]
    #[inline]
    pub const fn index_of(&self, number: u32) -> Option<u32> {
        if number >= self.count {
            return None;
        }
        if self.count <= FEW {
            // The lowest zero of sixteen numbers of 4 bits.
            let other = self.numbers() ^ (number as u64).wrapping_mul(ONES);
            let zeros = other.wrapping_sub(ONES) & !other & (ONES << 3);
            return Some(zeros.trailing_zeros() >> 2);
        }
        let (mut at, mut outside) = (self.unmixed(number), self.outside());
        while at >= self.count && outside > 0 {
            at = self.unmixed(at);
            outside = outside.wrapping_sub(1);
        }
        Some(at)
    }

    /// Few numbers, 4 bits each.
    const fn numbers(&self) -> u64 {
        let [[upper, lower], ..] = self.keys;
        (upper as u64) << 32 | lower as u64
    }

    /// How many of 2ᵐ numbers are none of the order. From one of the order back to another, each is passed once at most.
    #[inline]
    const fn outside(&self) -> u32 {
        self.mask.wrapping_sub(self.count).wrapping_add(1)
    }

    /// Another of 2ᵐ numbers for each.
    #[inline]
    const fn mixed(&self, mut at: u32) -> u32 {
        let mut rest: &[[u32; 2]] = &self.keys;
        while let [[add, multiply], others @ ..] = rest {
            at = at.wrapping_add(*add).wrapping_mul(*multiply) & self.mask;
            at ^= at >> self.half;
            rest = others;
        }
        at
    }

    #[inline]
    const fn unmixed(&self, mut at: u32) -> u32 {
        let mut rest: &[[u32; 2]] = &self.keys;
        while let [others @ .., [add, multiply]] = rest {
            // Its own inverse, because twice the shift leaves nothing.
            at ^= at >> self.half;
            at = at.wrapping_mul(inverse(*multiply)).wrapping_sub(*add) & self.mask;
            rest = others;
        }
        at
    }
}

/// The numbers below `count` in random order, 4 bits each from the lowest on; and those behind, each at its own place.
const fn shuffled(count: u32, key: u32) -> u64 {
    let mut numbers = 0xfedc_ba98_7654_3210_u64;
    let mut last = count.wrapping_sub(1);
    while last > 0 {
        let (this, other) = (last << 2, up_to(last, keyed(key, last)) << 2);
        let difference = (numbers >> this ^ numbers >> other) & 15;
        numbers ^= difference << this | difference << other;
        last = last.wrapping_sub(1);
    }
    numbers
}

/// The number whose product with an odd one is 1, by Newton's method: each step doubles the 4 bits of the first guess.
const fn inverse(odd: u32) -> u32 {
    let mut guess = odd.wrapping_mul(3) ^ 2;
    let mut steps = 3_u32;
    while steps > 0 {
        guess = guess.wrapping_mul(2_u32.wrapping_sub(odd.wrapping_mul(guess)));
        steps = steps.wrapping_sub(1);
    }
    guess
}
