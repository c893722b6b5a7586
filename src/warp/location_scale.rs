//! Laws on the line by inversion from both ends: what those share that have a tail at each end, and what those share that are
//! given by a location and a scale.

use crate::error::{Error, finite, positive, tried};
use crate::num::{folded, remainder, representable, two_sum};
use crate::tier::{Tier, scaled_exp};
use core::marker::PhantomData;

/// The types of a law that finds a point by the probability `beyond` it, on either side, and its samples of uniforms.
macro_rules! uniforms_by_tails {
    () => {
        type Uniforms = f32;
        type Point = f32;
        type Density = f32;

        #[inline]
        fn sample_canonical(&self, u: $crate::uniform::Canonical<f32>) -> f32 {
            let u = u.get();
            $crate::num::by_tail(u, |tail, upper| self.beyond(tail, upper))
        }
    };
}
pub(super) use uniforms_by_tails;

/// The same, and samples of words, which are taken as the middle of their cells at both ends.
macro_rules! by_tails {
    () => {
        super::location_scale::uniforms_by_tails!();

        #[inline]
        fn sample_words(&self, word: u32) -> f32 {
            let (tail, upper) = $crate::num::folded(word);
            self.beyond(tail, upper)
        }
    };
}
pub(super) use by_tails;

/// The density that comes with a sample of such a law, which is `placed` with it by the tail itself.
macro_rules! density_by_tails {
    () => {
        #[inline]
        fn sample_canonical_with_pdf(&self, u: $crate::uniform::Canonical<f32>) -> (f32, f32) {
            let u = u.get();
            $crate::num::by_tail(u, |tail, upper| self.placed(tail, upper))
        }

        #[inline]
        fn try_draw_with_pdf<R: rand_core::TryRng + ?Sized>(
            &self,
            rng: &mut R,
        ) -> Result<(f32, f32), R::Error> {
            let (tail, upper) = $crate::num::folded(rng.try_next_u32()?);
            Ok(self.placed(tail, upper))
        }
    };
}
pub(super) use density_by_tails;

/// A law of location 0 and scale 1.
pub(super) trait Standard {
    /// The factor of its density that the scale divides.
    const PEAK: f32;
    /// An upper bound on how far a sample lies from 0.
    const REACH: f32;

    /// The point with this probability, at most 1/2, beyond it.
    fn deviate(tail: f32, upper: bool) -> f32;

    /// The point of the middle of a word's cell.
    #[inline]
    fn of_word(word: u32) -> f32 {
        let (tail, upper) = folded(word);
        Self::deviate(tail, upper)
    }

    /// The density at t, given with its rounding error, in units of this peak; unspecified where it underflows.
    fn density(peak: f32, t: (f32, f32)) -> f32;

    /// The probability below t.
    fn cdf(t: f32) -> f32;
}

/// A location and a scale, and the peak of the law divided by the scale.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(super) struct Located<T> {
    pub location: f32,
    pub scale: f32,
    pub peak: f32,
    tier: PhantomData<T>,
}

impl<T> Located<T> {
    pub(super) const fn new(
        location: f32,
        scale: f32,
        peak: f32,
        reach: f32,
    ) -> Result<Self, Error> {
        let peak = peak / scale;
        tried!(checked(location, scale, reach));
        if peak.is_finite() {
            Ok(Self {
                location,
                scale,
                peak,
                tier: PhantomData,
            })
        } else {
            Err(Error::Empty)
        }
    }
}

pub(super) const fn checked(location: f32, scale: f32, reach: f32) -> Result<(), Error> {
    tried!(finite(location));
    tried!(positive(scale));
    // The distance of x from the location must not overflow either, hence twice the reach.
    if (location.abs() + 2.0 * reach * scale).is_finite() {
        Ok(())
    } else {
        Err(Error::TooLarge)
    }
}

/// The distance of x from the location in units of the scale, and its rounding error.
#[inline]
pub(super) fn standardised(x: f32, location: f32, unit: f32) -> (f32, f32) {
    // For a small one the rounding error would be subnormal.
    let scale = if unit < 1.0e-18 {
        18_446_744_073_709_551_616.0
    } else {
        1.0
    };
    let (distance, dropped) = two_sum(x, -location);
    let (distance, unit) = (scale * distance, scale * unit);
    let t = distance / unit;
    let rest = remainder(distance, t, unit) + scale * dropped;
    (t, rest / unit)
}

/// The peak times the exponential of this exponent, given with its rounding error; 0 where that underflows for any peak.
#[inline]
pub(super) fn decayed<T: Tier>(peak: f32, (exponent, rest): (f32, f32)) -> f32 {
    // The exponent may have overflowed.
    if exponent > -250.0 {
        scaled_exp::<T>(peak, exponent, rest)
    } else {
        0.0
    }
}

/// The density of a law at a point of the line.
#[inline]
pub(super) fn density<T, L: Standard>(law: &Located<T>, x: f32) -> f32 {
    if x.is_finite() {
        let t = standardised(x, law.location, law.scale);
        representable(L::density(law.peak, t))
    } else {
        0.0
    }
}

/// The constructor and the getters of a law with a location and a scale, and its samples.
macro_rules! located {
    ($name:ident) => {
        impl<T: Tier> $name<T> {
            /// The law with this location and this scale.
            ///
            /// # Errors
            /// [`Error::NotFinite`](crate::Error::NotFinite) for NaN or infinity,
            /// [`Error::NotPositive`](crate::Error::NotPositive) for a scale of 0 or less,
            /// [`Error::TooLarge`](crate::Error::TooLarge) if a sample could overflow,
            /// [`Error::Empty`](crate::Error::Empty) if the density could.
            pub const fn new(location: f32, scale: f32) -> Result<Self, crate::error::Error> {
                let (peak, reach) = (
                    <Self as super::location_scale::Standard>::PEAK,
                    <Self as super::location_scale::Standard>::REACH,
                );
                let law = super::location_scale::Located::new(location, scale, peak, reach);
                Ok(Self($crate::error::tried!(law)))
            }

            /// The location.
            #[must_use]
            pub const fn location(&self) -> f32 {
                self.0.location
            }

            /// The scale.
            #[must_use]
            pub const fn scale(&self) -> f32 {
                self.0.scale
            }

            #[inline]
            fn at(&self, t: f32) -> f32 {
                self.0.location + self.0.scale * t
            }

            #[inline]
            fn beyond(&self, tail: f32, upper: bool) -> f32 {
                self.at(<Self as super::location_scale::Standard>::deviate(
                    tail, upper,
                ))
            }
        }
    };
}
pub(super) use located;

/// What such a law has as a warp.
macro_rules! located_warp {
    () => {
        super::location_scale::uniforms_by_tails!();

        #[inline]
        fn sample_words(&self, word: u32) -> f32 {
            self.at(<Self as super::location_scale::Standard>::of_word(word))
        }

        #[inline]
        fn pdf(&self, x: f32) -> f32 {
            super::location_scale::density::<T, Self>(&self.0, x)
        }
    };
}
pub(super) use located_warp;

/// The inverse of such a law.
macro_rules! located_inverse {
    () => {
        #[inline]
        fn invert(&self, x: f32) -> f32 {
            let t = (x - self.0.location) / self.0.scale;
            $crate::num::into_unit(<Self as super::location_scale::Standard>::cdf(t))
        }
    };
}
pub(super) use located_inverse;
