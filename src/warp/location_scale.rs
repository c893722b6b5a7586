//! Distributions on the line by inversion from both ends: what those with a tail at each end share, and what those given by a
//! location and a scale share.

use crate::error::{Error, finite, positive, tried};
use crate::num::{folded, into_unit, remainder, representable, two_sum};
use crate::tier::{Tier, scaled_exp};
use core::marker::PhantomData;

/// The types of a distribution that finds a point by the probability `beyond` it, on either side, and its samples of uniforms.
macro_rules! uniforms_by_tails {
    () => {
        type Uniforms = f32;
        type Point = f32;
        type Density = f32;

        #[inline]
        fn sample_canonical(&self, u: $crate::uniform::Canonical<f32>) -> f32 {
            let u = u.get();
            if u < 0.5 {
                self.beyond($crate::num::above_zero(u), false)
            } else {
                self.beyond(1.0 - u, true)
            }
        }
    };
}
pub(super) use uniforms_by_tails;

/// The density that comes with a sample of such a distribution, which is `placed` with it by the tail itself.
macro_rules! density_by_tails {
    () => {
        #[inline]
        fn sample_canonical_with_pdf(&self, u: $crate::uniform::Canonical<f32>) -> (f32, f32) {
            let u = u.get();
            if u < 0.5 {
                self.placed($crate::num::above_zero(u), false)
            } else {
                self.placed(1.0 - u, true)
            }
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

/// A distribution of location 0 and scale 1.
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

/// A location and a scale, and the peak of the standard distribution divided by the scale.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(super) struct LocationScale<T> {
    pub location: f32,
    pub scale: f32,
    pub peak: f32,
    tier: PhantomData<T>,
}

impl<T> LocationScale<T> {
    pub(super) const fn new(
        location: f32,
        scale: f32,
        peak: f32,
        reach: f32,
        place: usize,
    ) -> Result<Self, Error> {
        let peak = peak / scale;
        tried!(checked(location, scale, reach, place));
        if peak.is_finite() {
            Ok(Self::of(location, scale, peak))
        } else {
            Err(Error::Empty(place.wrapping_add(1)))
        }
    }

    /// Of numbers that have been looked at; the peak is divided by the scale.
    #[inline]
    pub(super) const fn of(location: f32, scale: f32, peak: f32) -> Self {
        Self {
            location,
            scale,
            peak,
            tier: PhantomData,
        }
    }
}

/// Refuses what is no location, the parameter of that place, or no scale, the next; and samples that overflow. Where a parameter
/// stands before, the reach depends on it.
pub(super) const fn checked(
    location: f32,
    scale: f32,
    reach: f32,
    place: usize,
) -> Result<(), Error> {
    tried!(finite(location, place));
    tried!(positive(scale, place.wrapping_add(1)));
    // The distance of x from the location must not overflow either, hence twice the reach.
    if (location.abs() + 2.0 * reach * scale).is_finite() {
        Ok(())
    } else {
        Err(Error::TooLarge(if place == 0 {
            1
        } else {
            Error::NO_PLACE
        }))
    }
}

/// The same of a point of the plane, with a scale of each coordinate: the largest density of a law whose standard one is 1/2π.
pub(super) const fn peak_of_pair(
    [x, y]: [f32; 2],
    scale: f32,
    reach: f32,
    place: usize,
) -> Result<f32, Error> {
    tried!(checked(x, scale, reach, place));
    tried!(checked(y, scale, reach, place));
    let peak = 1.0 / core::f32::consts::TAU / scale / scale;
    if !peak.is_finite() {
        Err(Error::Empty(place.wrapping_add(1)))
    } else if peak < f32::MIN_POSITIVE {
        Err(Error::TooLarge(place.wrapping_add(1)))
    } else {
        Ok(peak)
    }
}

/// The distance of x from the location in units of the scale, and its rounding error.
#[inline]
pub(super) const fn standardised(x: f32, location: f32, unit: f32) -> (f32, f32) {
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

/// The density of such a distribution at a point of the line.
#[inline]
pub(super) fn density<T, L: Standard>(own: &LocationScale<T>, x: f32) -> f32 {
    if x.is_finite() {
        let t = standardised(x, own.location, own.scale);
        representable(L::density(own.peak, t))
    } else {
        0.0
    }
}

/// The inverse of such a distribution.
#[inline]
pub(super) fn invert<T, L: Standard>(own: &LocationScale<T>, x: f32) -> f32 {
    into_unit(L::cdf((x - own.location) / own.scale))
}

/// The constructor and the getters of a distribution with a location and a scale, and its samples.
macro_rules! location_scale {
    ($name:ident) => {
        impl<T: Tier> $name<T> {
            /// The distribution with this location and this scale.
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
                let own =
                    super::location_scale::LocationScale::new(location, scale, peak, reach, 0);
                Ok(Self($crate::error::tried!(own)))
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
pub(super) use location_scale;

/// What such a distribution has as a warp, except its density with a sample.
macro_rules! location_scale_warp {
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
pub(super) use location_scale_warp;
