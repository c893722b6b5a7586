//! The warps of this tier for users of `f32`, and the conversions.

use super::direction::Scaled;
use super::kernel::float;
use super::number::Number;
use super::{Density, Uniform};
use crate::uniform::{Canonical, Uniforms};
use crate::warp::{Invert, Warp};
use ::fixed::types::extra::LeEqU32;
use ::fixed::{FixedI32, FixedU32};
use rand_core::TryRng;

mod sealed {
    pub trait Sealed {}
}
use sealed::Sealed;

/// Uniforms of the integer tier with a counterpart in `f32`: a [`Uniform`] or an array of them.
///
/// [`Float`] uses it. The trait is sealed.
pub trait FloatUniforms: Uniforms + Sealed {
    /// The same number of `f32`.
    type Float: Uniforms<Words = Self::Words>;
    /// The words of any `f32`, brought into [0, 1).
    fn words(u: Self::Float) -> Self;
    /// The `f32` below or at each word.
    fn floats(self) -> Self::Float;
}

/// Points of the integer tier with a counterpart in `f32`: a [`Number`], an array of them, or two such points.
///
/// [`Float`] uses it. The trait is sealed.
pub trait FloatPoint: Copy + Sealed {
    /// The same number of `f32`.
    type Float: Copy;
    /// The numbers cut towards 0 to the format: its ends for those that do not fit, 0 for NaN.
    fn from_float(x: Self::Float) -> Self;
    /// The numbers cut towards 0 to 24 digits.
    fn to_float(self) -> Self::Float;
}

impl Sealed for i32 {}
impl Sealed for u32 {}
impl<Frac: LeEqU32> Sealed for FixedI32<Frac> {}
impl<Frac: LeEqU32> Sealed for FixedU32<Frac> {}
impl<T: Sealed, const N: usize> Sealed for [T; N] {}
impl<A: Sealed, B: Sealed> Sealed for (A, B) {}

impl FloatUniforms for Uniform {
    type Float = f32;

    #[inline]
    fn words(u: f32) -> Self {
        Self::from_bits(float::uniform(u.to_bits()))
    }

    #[inline]
    fn floats(self) -> f32 {
        f32::from_bits(float::of(self.to_bits(), 32))
    }
}

impl<const N: usize> FloatUniforms for [Uniform; N] {
    type Float = [f32; N];

    #[inline]
    fn words(u: [f32; N]) -> Self {
        u.map(FloatUniforms::words)
    }

    #[inline]
    fn floats(self) -> [f32; N] {
        self.map(FloatUniforms::floats)
    }
}

const SIGN: u32 = 1 << 31;

impl<T: Number + Sealed> FloatPoint for T {
    type Float = f32;

    #[inline]
    fn from_float(x: f32) -> Self {
        let bits = x.to_bits();
        let magnitude = float::magnitude(bits, T::FRACTION);
        T::from_word(match (T::SIGN, bits & SIGN) {
            (0, 0) => magnitude,
            (0, _) => 0,
            (_, 0) => magnitude.min(SIGN - 1),
            _ => magnitude.min(SIGN).wrapping_neg(),
        })
    }

    #[inline]
    fn to_float(self) -> f32 {
        let word = self.to_word();
        f32::from_bits(if word & T::SIGN == 0 {
            float::of(word, T::FRACTION)
        } else {
            float::of(word.wrapping_neg(), T::FRACTION) | SIGN
        })
    }
}

impl<T: Number + FloatPoint<Float = f32>, const N: usize> FloatPoint for [T; N] {
    type Float = [f32; N];

    #[inline]
    fn from_float(x: [f32; N]) -> Self {
        x.map(T::from_float)
    }

    #[inline]
    fn to_float(self) -> [f32; N] {
        self.map(T::to_float)
    }
}

impl<A: FloatPoint, B: FloatPoint> FloatPoint for (A, B) {
    type Float = (A::Float, B::Float);

    #[inline]
    fn from_float((a, b): Self::Float) -> Self {
        (A::from_float(a), B::from_float(b))
    }

    #[inline]
    fn to_float(self) -> Self::Float {
        let (a, b) = self;
        (a.to_float(), b.to_float())
    }
}

/// A warp of the integer tier with uniforms, points and densities in `f32`, for cores without a floating-point unit.
///
/// The warp computes on integers, and the conversions only take the bits of floats apart and put them together. A program
/// that does nothing else with `f32` links no floating-point routine.
///
/// # Density
/// That of the warp at the point converted back to its format. A coordinate that does not fit counts as the end of the
/// format, NaN as 0.
///
/// # Domain
/// - Point: that of the warp. Coordinates are cut towards 0 to the 24 digits of an `f32`, so that no magnitude grows.
///   Where the ends of an interval or the vertices of a triangle have more digits, a cut point can leave it, and then has
///   density 0.
/// - Uniforms: as many as the warp takes, cut to multiples of 2⁻³². Any `f32` serves, by the rule of
///   [`Uniforms::canonical`]. Drawing takes words straight from the generator, all 32 bits of them.
/// - Parameter: any warp of [`fixed::warp`](super::warp).
///
/// # Accuracy
/// The errors of the warp, and 1.2e-7 of each coordinate because it is cut.
///
/// # Examples
/// ```
/// use microwarp::{Invert, Warp, fixed as mw};
/// let disk = mw::Float::new(mw::Disk::new());
/// assert_eq!(disk.sample([0.25, 0.5]), [-0.5, 0.0]);
/// assert!((disk.pdf([-0.5, 0.0]) - 1.0 / core::f32::consts::PI).abs() < 1e-7);
/// ```
///
/// # See also
/// - The tiers [`poly`](crate::poly) and [`libm`](crate::libm), where the core has a floating-point unit.
#[doc(alias = "f32")]
#[doc(alias = "soft_float")]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Float<W>(W);

impl<W> Float<W> {
    /// The given warp, with `f32` for its uniforms, points and densities.
    #[must_use]
    pub const fn new(warp: W) -> Self {
        Self(warp)
    }

    /// The wrapped warp, on fixed-point numbers.
    #[must_use]
    pub const fn warp(&self) -> &W {
        &self.0
    }
}

impl<W> Warp for Float<W>
where
    W: Warp<Density = Density>,
    W::Uniforms: FloatUniforms,
    W::Point: FloatPoint,
{
    type Uniforms = <W::Uniforms as FloatUniforms>::Float;
    type Point = <W::Point as FloatPoint>::Float;
    type Density = f32;

    #[inline]
    fn sample_canonical(&self, u: Canonical<Self::Uniforms>) -> Self::Point {
        self.sample(u.get())
    }

    /// The point of any uniforms. The conversion brings them into range.
    #[inline]
    fn sample(&self, u: Self::Uniforms) -> Self::Point {
        self.0.sample(W::Uniforms::words(u)).to_float()
    }

    #[inline]
    fn pdf(&self, x: Self::Point) -> f32 {
        let density = self.0.pdf(W::Point::from_float(x)).to_bits();
        let Scaled { mantissa, exponent } = Scaled::of(density, 32);
        let bits = ((125 - exponent) as u32) << 23;
        f32::from_bits(if density == 0 {
            0
        } else {
            bits + (mantissa >> 8)
        })
    }

    #[inline]
    fn sample_words(&self, words: <Self::Uniforms as Uniforms>::Words) -> Self::Point {
        self.0.sample_words(words).to_float()
    }

    #[inline]
    fn try_draw<R: TryRng + ?Sized>(&self, rng: &mut R) -> Result<Self::Point, R::Error> {
        self.0.try_draw(rng).map(W::Point::to_float)
    }
}

impl<W> Invert for Float<W>
where
    W: Invert<Density = Density>,
    W::Uniforms: FloatUniforms,
    W::Point: FloatPoint,
{
    #[inline]
    fn invert(&self, x: Self::Point) -> Self::Uniforms {
        self.0.invert(W::Point::from_float(x)).floats()
    }
}
