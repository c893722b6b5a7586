//! The uniform distribution on an interval of integers or of fixed-point numbers.

use super::kernel::product::high;
use super::kernel::quotient::reciprocal;
use super::number::Number;
use super::{Density, Uniform};
use crate::error::Error;
use crate::num::division::fraction_u32;
use crate::uniform::Canonical;
use crate::warp::{Invert, Warp};
use ::fixed::types::extra::LeEqU32;
use ::fixed::{FixedI32, FixedU32};
use core::marker::PhantomData;

/// Uniform on an interval of integers (`i32`, `u32`) or of fixed-point numbers.
///
/// A sample is ⌊n·u⌋ steps above the lowest value, where n is the number of values.
///
/// # Density
/// 1/(high − low), to 2⁻³³; for integers that is the probability 1/n of a value. 0 outside, never inside.
///
/// A density has steps of 2⁻³². On an interval as long as 10⁶ it therefore has four digits, and on one longer than 2³²
/// steps of 1 none. The exact probability of a value is one out of [`Interval::count`], to a word.
///
/// # Domain
/// - Point: [low, high) of [`Interval::new`], or [low, last] of `Interval::inclusive`, which may be all 2³² values.
/// - Uniforms: one word.
/// - Parameters: two `i32`, two `u32`, or two numbers of one `FixedI32` or `FixedU32` format.
/// - `invert` returns the smallest word whose sample is the point.
///
/// # Accuracy
/// Exact. Each value has ⌊2³²/n⌋ words or one more, in order, and no value has none. The warp has no grade, as it takes
/// a single product.
///
/// # Examples
/// ```
/// use fixed::types::{I16F16, U0F32};
/// use microwarp::{Invert, Warp, fixed as mw};
/// let dice = mw::Interval::<i32>::inclusive(1, 6)?;
/// assert_eq!(dice.sample(U0F32::from_num(0.5)), 4);
/// assert_eq!(dice.invert(4), 0.5);
/// let angle = mw::Interval::<I16F16>::new(I16F16::from_num(-3), I16F16::from_num(5))?;
/// assert_eq!(angle.sample(U0F32::from_num(0.25)), -1);
/// assert_eq!(angle.pdf(I16F16::ZERO), 0.125);
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// # See also
/// - [`Tent`](super::Tent) favours the middle.
/// - [`discrete`](crate::discrete) chooses integers by weights.
/// - [`warp::Interval`](crate::warp::Interval) is the interval of the float tiers.
///
/// # Source
/// D. Lemire, "Fast Random Integer Generation in an Interval", 2019, <https://doi.org/10.1145/3230636>. There a
/// rejection makes the values equally likely; here no word is rejected.
#[doc(alias = "uniform")]
#[doc(alias = "range")]
#[doc(alias = "dice")]
#[doc(alias = "gen_range")]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Interval<T> {
    /// The bits of the lowest value.
    start: u32,
    /// The number of values; 0 stands for 2³².
    count: u32,
    density: u64,
    number: PhantomData<T>,
}

impl<T> Interval<T> {
    /// The interval of so many values from these bits on; 0 stands for 2³².
    const fn of(start: u32, count: u32, fraction: u32) -> Self {
        let values = if count == 0 { 1 << 32 } else { count as u64 };
        let density = reciprocal(32 + fraction, values);
        Self {
            start,
            count,
            density: if density == 0 { 1 } else { density },
            number: PhantomData,
        }
    }

    /// The number of values, from 1 to 2³².
    #[must_use]
    pub const fn count(&self) -> u64 {
        if self.count == 0 {
            1 << 32
        } else {
            self.count as u64
        }
    }
}

macro_rules! constructors {
    ([$($parameter:tt)*] $number:ty, |$x:ident| $bits:expr, |$word:ident| $from_word:expr, $fraction:expr) => {
        impl<$($parameter)*> Interval<$number> {
            /// Uniform on [low, high), increasing with the uniform.
            ///
            /// # Errors
            /// [`Error::Reversed`] for low > high, [`Error::Empty`] for low = high.
            pub const fn new(low: $number, high: $number) -> Result<Self, Error> {
                let start = { let $x = low; $bits };
                let end = { let $x = high; $bits };
                if start > end {
                    Err(Error::Reversed(1))
                } else if start == end {
                    Err(Error::Empty(1))
                } else {
                    Ok(Self::of(start as u32, end.wrapping_sub(start) as u32, $fraction))
                }
            }

            /// Uniform on [low, last], increasing with the uniform.
            ///
            /// # Errors
            /// [`Error::Reversed`] for low > last.
            pub const fn inclusive(low: $number, last: $number) -> Result<Self, Error> {
                let start = { let $x = low; $bits };
                let last = { let $x = last; $bits };
                if start > last {
                    Err(Error::Reversed(1))
                } else {
                    let count = (last.wrapping_sub(start) as u32).wrapping_add(1);
                    Ok(Self::of(start as u32, count, $fraction))
                }
            }

            /// The lowest value.
            #[must_use]
            pub const fn low(&self) -> $number {
                let $word = self.start;
                $from_word
            }

            /// The largest value, which samples reach: one step below the `high` of [`Self::new`].
            #[must_use]
            pub const fn last(&self) -> $number {
                let $word = self.start.wrapping_add(self.count.wrapping_sub(1));
                $from_word
            }
        }
    };
}

constructors!([] i32, |x| x, |word| word as i32, 0);
constructors!([] u32, |x| x, |word| word, 0);
constructors!([Frac: LeEqU32] FixedI32<Frac>, |x| x.to_bits(), |word| FixedI32::from_bits(word as i32), Frac::U32);
constructors!([Frac: LeEqU32] FixedU32<Frac>, |x| x.to_bits(), |word| FixedU32::from_bits(word), Frac::U32);

impl<T: Number> Warp for Interval<T> {
    type Uniforms = Uniform;
    type Point = T;
    type Density = Density;

    #[inline]
    fn sample_canonical(&self, u: Canonical<Uniform>) -> T {
        let word = u.get().to_bits();
        let steps = if self.count == 0 {
            word
        } else {
            high(self.count, word)
        };
        T::from_word(self.start.wrapping_add(steps))
    }

    #[inline]
    fn pdf(&self, x: T) -> Density {
        let steps = x.to_word().wrapping_sub(self.start);
        if self.count == 0 || steps < self.count {
            Density::from_bits(self.density)
        } else {
            Density::ZERO
        }
    }
}

impl<T: Number> Invert for Interval<T> {
    #[inline]
    fn invert(&self, x: T) -> Uniform {
        let steps = x.to_word().wrapping_sub(self.start);
        let word = if self.count == 0 {
            steps
        } else if steps < self.count {
            first_word(steps, self.count)
        } else if x.to_word() ^ T::SIGN < self.start ^ T::SIGN {
            0
        } else {
            first_word(self.count - 1, self.count)
        };
        Uniform::from_bits(word)
    }
}

/// ⌈2³²·steps/count⌉, for steps < count.
#[inline]
fn first_word(steps: u32, count: u32) -> u32 {
    let (below, inexact) = fraction_u32(steps, count);
    below + u32::from(inexact)
}

#[cfg(feature = "defmt")]
impl<T> defmt::Format for Interval<T> {
    fn format(&self, f: defmt::Formatter<'_>) {
        defmt::write!(
            f,
            "Interval {{ start: {=u32}, count: {=u32} }}",
            self.start,
            self.count
        );
    }
}
