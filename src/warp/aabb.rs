//! The uniform distribution on an axis-aligned box of any dimension.

use super::{Interval, Invert, Warp};
use crate::error::{Error, tried};
use crate::num::{Scaled, remainder, two_product, two_sum};
use crate::uniform::Canonical;

/// Uniform in an axis-aligned box of any dimension, such as the bounding box of a region.
///
#[cfg_attr(doc, doc = include_str!("../pictures/aabb.html"))]
///
/// # Density
/// The product of 1/(bᵢ − aᵢ), on the closed box.
///
/// # Domain
/// - Point: aᵢ ≤ xᵢ < bᵢ.
/// - Uniforms: one a dimension.
/// - Parameters: finite corners with aᵢ < bᵢ whose volume has a density that `f32` can hold.
/// - Both tiers share this code.
///
/// # Accuracy
/// *Sample* is the distance from the exact point, relative to the size, which is the largest bound. The other rows
/// are relative errors of densities and absolute errors of uniforms. [What each row
/// means](crate::warp#stated-errors).
///
/// | error | bound | kind |
/// |---|--:|---|
/// | sample, of the size | sqrt(n) * max(2.25e-7, 2.6e-45/m) | proven |
/// | pdf, relative | 7.8e-8 | found |
/// | realised density, relative | 7.8e-8 | found |
/// | inverse | 2e-7 | found |
/// | round trip | 1.8e-7 + max(3.3, 3.9e-38/m)*r | found |
///
/// The error of a sample is proven for all parameters and uniforms: see `docs/proofs.md`.
///
/// n is the number of dimensions and m the size. The second term of a maximum counts where m is subnormal, which it
/// can be in one dimension. r is the change of the inverse when the point moves by 2⁻²⁴ of the size.
///
/// # Cost
/// That of an [`Interval`](super::Interval) for each coordinate.
///
/// # Examples
/// ```
/// use microwarp::{Invert, Warp, warp::Aabb};
/// let room = Aabb::new([0.0, -1.0, 0.0], [4.0, 1.0, 2.0])?;
/// assert_eq!(room.sample([0.25, 0.5, 0.75]), [1.0, 0.0, 1.5]);
/// assert_eq!(room.pdf([1.0, 0.0, 1.5]), 1.0 / 16.0);
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// # See also
/// - [`Interval`](super::Interval): one dimension, in either orientation.
/// - [`rejection::Rejection`](crate::rejection::Rejection): a region inside a box.
///
/// # Source
/// L. Devroye, "Non-Uniform Random Variate Generation", 1986, <https://doi.org/10.1007/978-1-4613-8643-8>.
#[doc(alias = "box")]
#[doc(alias = "cuboid")]
#[doc(alias = "rectangle")]
#[doc(alias = "uniform")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Aabb<const N: usize> {
    sides: [Interval; N],
    density: f32,
}

impl<const N: usize> Aabb<N> {
    /// The box between two opposite corners, `low` and `high`.
    ///
    /// # Errors
    /// Those of [`Interval::new`] for each side. [`Error::Empty`] where the density overflows `f32`, [`Error::TooLarge`]
    /// where it is below the smallest normal number.
    pub const fn new(low: [f32; N], high: [f32; N]) -> Result<Self, Error> {
        let mut sides = [tried!(Interval::new(0.0, 1.0)); N];
        // The product of the lengths is significand · 2^exponent · (1 + rest).
        let (mut significand, mut exponent, mut rest) = (1.0, 0_i32, 0.0);
        let mut left: (&mut [Interval], &[f32], &[f32]) = (&mut sides, &low, &high);
        while let ([side, sides @ ..], [a, lows @ ..], [b, highs @ ..]) = left {
            let (a, b) = (*a, *b);
            *side = tried!(Interval::new(a, b));
            let scale = if (b - a).is_finite() { 1.0 } else { 0.5 };
            let (length, rounded_off) = two_sum(b * scale, -a * scale);
            let (digits, power) = Scaled::of(length).over(Scaled::of(scale)).parts();
            let (product, dropped) = two_product(significand, digits);
            rest += rounded_off / length + dropped / product;
            let more;
            (significand, more) = Scaled::of(product).parts();
            exponent = exponent.wrapping_add(power).wrapping_add(more);
            left = (sides, lows, highs);
        }
        let quotient = 1.0 / significand;
        let correction = remainder(1.0, quotient, significand) - rest;
        let density = Scaled::of(quotient + quotient * correction)
            .raised(exponent.wrapping_neg())
            .value();
        if density > f32::MAX {
            Err(Error::Empty(1))
        } else if density >= f32::MIN_POSITIVE {
            Ok(Self { sides, density })
        } else {
            Err(Error::TooLarge(1))
        }
    }

    /// The lower corner.
    #[must_use]
    pub fn low(&self) -> [f32; N] {
        self.sides.map(|side| side.low())
    }

    /// The upper corner.
    #[must_use]
    pub fn high(&self) -> [f32; N] {
        self.sides.map(|side| side.high())
    }
}

impl<const N: usize> Warp for Aabb<N> {
    type Uniforms = [f32; N];
    type Point = [f32; N];
    type Density = f32;

    #[inline]
    fn sample_canonical(&self, u: Canonical<[f32; N]>) -> [f32; N] {
        let mut point = [0.0; N];
        for ((x, side), u) in point.iter_mut().zip(&self.sides).zip(&u.each()) {
            *x = side.sample_canonical(*u);
        }
        point
    }

    #[inline]
    fn pdf(&self, point: [f32; N]) -> f32 {
        let inside = point
            .iter()
            .zip(&self.sides)
            .all(|(&x, side)| side.pdf(x) > 0.0);
        if inside { self.density } else { 0.0 }
    }
}

impl<const N: usize> Invert for Aabb<N> {
    #[inline]
    fn invert(&self, point: [f32; N]) -> [f32; N] {
        let mut u = [0.0; N];
        for ((u, side), x) in u.iter_mut().zip(&self.sides).zip(&point) {
            *u = side.invert(*x);
        }
        u
    }
}
