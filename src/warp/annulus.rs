//! The uniform distribution between two circles, and on a sector of that ring.

use super::direction::{Azimuths, nudged};
use super::planar::{PlanarMap, planar};
use super::{Invert, Warp};
use crate::error::{Error, finite, tried};
use crate::num::{
    Scaled, into_unit, pair, power_of_two, product, quick_two_sum, two_product, two_sum,
};
use crate::tier::Tier;
use core::marker::PhantomData;

/// Uniform on a ring between two circles about the origin (an annulus), or on a sector of one.
///
/// r = √(r₀² + g) with g = u₁(r₁² − r₀²), and near the inner circle r = r₀ + g/(r₀ + √(r₀² + g)), where the root alone would
/// lose digits of r − r₀. So a ring of any width gets its share of the uniforms up to the rounding of its points.
///
#[cfg_attr(doc, doc = include_str!("../pictures/annulus.html"))]
///
/// # Density
/// 1/(π(r₁² − r₀²)w) per unit area between the circles and the sides, with a width of w turns; else 0. A point counts as
/// inside up to the rounding of its coordinates: 3.6e-7 of the radius, and 3e-7 turns. Within 1e-30 of the origin every
/// azimuth counts as inside.
///
/// # Domain
/// - Point: r₀ ≤ √(x² + y²) ≤ r₁ and the azimuth between the sides, up to the rounding of the coordinates.
/// - Uniforms: two, radius and azimuth.
/// - Parameters: radii 0 ≤ r₀ < r₁; azimuths in turns, −1 ≤ φ₀ ≤ 1, φ₀ < φ₁ ≤ φ₀ + 1; an area whose density `f32` can
///   hold. An inner radius of 0 gives a disk.
///
/// # Accuracy
/// *Sample* is the distance from the exact point, relative to the outer radius. *Pdf* and *realised density* are
/// relative, *inverse* and *round trip* are absolute errors of the uniforms. [What each row
/// means](crate::warp#stated-errors).
///
/// | error | bound | kind |
/// |---|--:|---|
/// | sample, of the size | 4.9e-7 | proven |
/// | pdf, relative | 7.8e-8 | found |
/// | realised density, relative | 7.8e-8 | found |
/// | inverse | 2.2e-7/w | found |
/// | round trip | 1.8e-7/w + 3.9*r | found |
///
/// w is the width in turns. r is the change of the inverse when the point moves by 2⁻²⁴ of the outer radius. Before its
/// coordinates are rounded, the radius is that of a uniform at most 3.3e-7 away, in a ring of any width.
///
/// The error of a sample is proven for every ring, sector and pair of uniforms: see `docs/proofs.md`.
///
/// # Cost
/// One draw in `poly`, PCG32 included, takes <!-- figure: cost Annulus -->106 instructions and 464 bytes of code on an M4F, 4,478 instructions on an M0<!-- -->.
///
/// # Examples
/// ```
/// use microwarp::{Invert, Warp, poly as mw};
/// let ring = mw::Annulus::new(1.0, 2.0)?;
/// let [x, y] = ring.sample([0.5, 0.25]);
/// assert!(x.abs() < 1e-6 && (y - 2.5_f32.sqrt()).abs() < 1e-6);
/// assert_eq!(ring.pdf([0.0, 0.5]), 0.0);
/// let fan = mw::Annulus::sector(0.0, 1.0, -0.125, 0.125)?;
/// assert!(fan.pdf([0.5, 0.1]) > 0.0 && fan.pdf([-0.5, 0.1]) == 0.0);
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// # See also
/// - [`Disk`](super::Disk): the unit disk at a lower cost.
/// - [`SphericalPatch`](super::SphericalPatch): the same over directions.
/// - `fixed::Annulus`, with feature `fixed`: on integers.
///
/// # Source
/// L. Devroye, "Non-Uniform Random Variate Generation", 1986, <https://doi.org/10.1007/978-1-4613-8643-8>; the form
/// without a difference is of this crate.
#[doc(alias = "ring")]
#[doc(alias = "sector")]
#[doc(alias = "washer")]
#[doc(alias = "wedge")]
#[doc(alias = "uniform")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Annulus<T> {
    /// The inner radius as given. Over the scale it may underflow.
    inner: f32,
    /// The radii over the scale, which takes the outer one into [1, 2), and the difference of their squares.
    low: f32,
    high: f32,
    area: f32,
    /// A power of two.
    scale: f32,
    azimuths: Azimuths,
    density: f32,
    tier: PhantomData<T>,
}

/// How far outside the circles rounding can carry a sample, relative in the square of the radius.
const SLACK: f32 = 6.0 * f32::EPSILON;
/// The part of a square that underflows next to the origin.
const UNDERFLOW: f32 = 4.0 * f32::MIN_POSITIVE;
/// Below it the coordinates of a sample may be too few steps of `f32` to tell an azimuth.
const CENTRE: f32 = 1e-30;

impl<T: Tier> Annulus<T> {
    /// The ring between two radii.
    ///
    /// # Errors
    /// Those of [`Annulus::sector`].
    pub const fn new(inner: f32, outer: f32) -> Result<Self, Error> {
        Self::of([inner, outer], [0.0, 1.0], 1)
    }

    /// The part of a ring between two azimuths in turns, counted from +x towards +y.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for NaN or infinity, [`Error::Negative`] for a radius below 0, [`Error::Reversed`] if an upper
    /// end is below its lower, [`Error::OutOfRange`] for a first azimuth outside [−1, 1] or a width above 1 turn,
    /// [`Error::Empty`] for equal radii, equal azimuths or a density that overflows, [`Error::TooLarge`] for a density
    /// below the smallest normal number. A width that rounds to 1 is a whole turn.
    pub const fn sector(
        inner: f32,
        outer: f32,
        from_turns: f32,
        to_turns: f32,
    ) -> Result<Self, Error> {
        Self::of([inner, outer], [from_turns, to_turns], Error::NO_PLACE)
    }

    /// With the place of a reason that lies in all.
    const fn of(
        [inner, outer]: [f32; 2],
        [from_turns, to_turns]: [f32; 2],
        all: usize,
    ) -> Result<Self, Error> {
        tried!(finite(inner, 0));
        tried!(finite(outer, 1));
        tried!(finite(from_turns, 2));
        tried!(finite(to_turns, 3));
        if inner < 0.0 || outer < 0.0 {
            return Err(Error::Negative(if inner < 0.0 { 0 } else { 1 }));
        }
        if inner > outer || from_turns > to_turns {
            return Err(Error::Reversed(if inner > outer { 1 } else { 3 }));
        }
        let azimuths = tried!(Azimuths::new([from_turns, to_turns], [2, 3]));
        let (width, rest) = azimuths.width();
        if inner >= outer || width <= 0.0 {
            return Err(Error::Empty(if inner >= outer { 1 } else { 3 }));
        }
        let (high, exponent) = Scaled::of(outer).parts();
        let low = if inner > 0.0 {
            Scaled::of(inner).raised(exponent.wrapping_neg()).value()
        } else {
            0.0
        };
        let (area, dropped) = product(two_sum(high, -low), two_sum(high, low));
        let divisor = (area, dropped + area * (rest / width));
        let density = Scaled::of_quotient(
            pair(core::f64::consts::FRAC_1_PI),
            divisor,
            Scaled::of(width),
        );
        let density = density.raised(exponent.wrapping_mul(-2)).value();
        if density > f32::MAX {
            return Err(Error::Empty(all));
        }
        if density < f32::MIN_POSITIVE {
            return Err(Error::TooLarge(all));
        }
        Ok(Self {
            inner,
            low,
            high,
            area,
            scale: power_of_two(exponent),
            azimuths,
            density,
            tier: PhantomData,
        })
    }

    /// The inner radius.
    #[must_use]
    pub const fn inner(&self) -> f32 {
        self.inner
    }

    /// The outer radius.
    #[must_use]
    pub const fn outer(&self) -> f32 {
        self.high * self.scale
    }

    /// The azimuths of the two sides in turns. The second of a whole turn is the first plus 1, rounded to `f32`.
    #[must_use]
    pub const fn phi_turns(&self) -> [f32; 2] {
        self.azimuths.sides()
    }
}

impl<T: Tier> PlanarMap<2> for Annulus<T> {
    #[inline]
    fn map_to(&self, u1: f32, u2: f32, to: &mut [f32; 2]) {
        let gain = u1 * self.area;
        let square = self.low * self.low;
        let root = T::sqrt(square + gain);
        let r = if gain < square {
            self.low + gain / (self.low + root)
        } else {
            root
        };
        let r = if r < self.high { r } else { self.high };
        let (turn, angle) = self.azimuths.at(u2);
        let (x, y) = T::polar(r * self.scale, turn);
        *to = nudged(x, y, angle);
    }

    #[inline]
    fn put(&self, u1: f32, u2: f32, to: &mut [f32; 2]) -> f32 {
        self.map_to(u1, u2, to);
        self.density
    }
}

impl<T: Tier> Warp for Annulus<T> {
    planar!(2, with its density, where T::VECTORS);

    #[inline]
    fn pdf(&self, point: [f32; 2]) -> f32 {
        let [x, y] = point.map(|c| c / self.scale);
        let square = x * x + y * y;
        let [low, high] = [self.low, self.high].map(|r| r * r);
        let between = square >= low - low * SLACK - UNDERFLOW && square <= high + high * SLACK;
        let [x, y] = point;
        let central = x.abs() < CENTRE && y.abs() < CENTRE;
        if between && (central || self.azimuths.contain::<T>(x, y)) {
            self.density
        } else {
            0.0
        }
    }
}

impl<T: Tier> Invert for Annulus<T> {
    #[inline]
    fn invert(&self, point: [f32; 2]) -> [f32; 2] {
        // x² + y² − r₀² with the rounding errors of all products, since it is as small as the ring is thin.
        let [x, y] = point.map(|c| c / self.scale);
        let [(xx, x_rest), (yy, y_rest), (low, low_rest)] =
            [x, y, self.low].map(|c| two_product(c, c));
        let (square, square_rest) = two_sum(xx, yy);
        let (gain, gain_rest) = two_sum(square, -low);
        let rest = gain_rest + (square_rest + (x_rest + y_rest - low_rest));
        let (gain, _) = quick_two_sum(gain, rest);
        let [x, y] = point;
        [into_unit(gain / self.area), self.azimuths.invert::<T>(x, y)]
    }
}
