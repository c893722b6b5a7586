//! The uniform distribution between two circles, and on a sector of that ring.

use super::direction::{PER_ANGLE, Scaled, around, square_of};
use super::grade::{Fine, Grade};
use super::kernel::product::{high, wide};
use super::kernel::quotient::quotient;
use super::{Density, Uniform};
use crate::error::Error;
use crate::uniform::Canonical;
use crate::warp::{Invert, Warp};
use ::fixed::FixedI32;
use ::fixed::types::extra::LeEqU32;
use core::marker::PhantomData;

/// Uniform on a ring between two circles about the origin (an annulus), or on a sector of one.
///
/// r = √(r₀² + u₁(r₁² − r₀²)), and the angle is u₂ of the way from one side of the sector to the other, or u₂ turns.
///
/// # Density
/// 1/(π(r₁² − r₀²)w) per unit area between the circles and the sides, with a width of w turns, at least 2⁻³²; 0 elsewhere.
/// A point counts as inside up to 2⁻¹⁸ of the outer radius beyond a circle or a side (in grade
/// [`Coarse`](super::Coarse) 2⁻¹¹), and two steps.
///
/// # Domain
/// - Point: r₀ ≤ √(x² + y²) ≤ r₁ and the azimuth between the sides, up to the error of a sample. A ring whose width is
///   near that error, or near a step of the format, is filled no more evenly than those are small.
/// - Uniforms: two words, radius then azimuth.
/// - Parameters: radii 0 ≤ r₀ < r₁ in any signed format of 32 bits, at most half its range. An inner radius of 0 gives a
///   disk. The sides in turns, from the first towards +y to the second, past 0 where the second is smaller.
///
/// # Accuracy
/// *Sample* is the absolute error of a coordinate relative to the outer radius, beyond half a step of the format. *Pdf* is the
/// relative error of the density, beyond a step of 2⁻³². *Round trip* is the error of the uniforms after `sample` and
/// `invert`: of u₁, and of u₂ times the radius over the outer one. The outer radius is n steps of the format, s is
/// 1 − (r₀/r₁)², and w the width in turns. Where the gap of a sector is narrower than the error, either side may be taken
/// for the other.
///
/// | error | fine | coarse | compact | kind |
/// |---|--:|--:|--:|---|
/// | sample, max | 1.3e-6 | 2.4e-4 | 8.6e-7 | found |
/// | pdf | 1.7e-9 | 1.8e-9 | 1.8e-9 | found |
/// | round trip, first | (2.6e-6 + 1.9/n)/s | (5e-4 + 1.9/n)/s | (2.6e-6 + 1.9/n)/s | found |
/// | round trip, second | (4e-7 + 0.48/n)/w | (4.5e-5 + 0.47/n)/w | (4e-7 + 0.48/n)/w | found |
///
/// # Cost
/// One draw in `fine`, PCG32 included, takes <!-- figure: cost fixed Annulus -->231 instructions and 400 bytes of code on an M0, 100 instructions on an M3<!-- -->.
///
/// # Examples
/// ```
/// use fixed::types::{I16F16, U0F32};
/// use microwarp::{Invert, Warp, fixed as mw};
/// let ring = mw::Annulus::new(I16F16::from_num(30), I16F16::from_num(50))?;
/// let [x, y] = ring.sample([0.4375_f32, 0.25].map(U0F32::from_num)); // half way in area
/// assert!(x == 0 && (y.to_num::<f64>() - 40.0).abs() < 1e-4);
/// assert_eq!(ring.pdf([10, 20].map(I16F16::from_num)), 0);
/// // An eighth of a turn to either side of +x.
/// let sides = [0.875_f32, 0.125].map(U0F32::from_num);
/// let fan = mw::Annulus::sector(I16F16::ZERO, I16F16::from_num(50), sides)?;
/// assert!(fan.pdf([20, 5].map(I16F16::from_num)) > 0 && fan.pdf([-20, 5].map(I16F16::from_num)) == 0);
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// # See also
/// - [`Disk`](super::Disk): the unit disk at a lower cost.
/// - [`RegularPolygon`](super::RegularPolygon) has straight sides.
/// - [`warp::Annulus`](crate::warp::Annulus) is the ring of the float tiers, which resolves rings of any width.
///
/// # Source
/// L. Devroye, "Non-Uniform Random Variate Generation", 1986, <https://doi.org/10.1007/978-1-4613-8643-8>.
#[doc(alias = "ring")]
#[doc(alias = "sector")]
#[doc(alias = "washer")]
#[doc(alias = "wedge")]
#[doc(alias = "uniform")]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Annulus<Frac, G = Fine> {
    /// The radii in steps, and how far left the outer one is shifted to fill a word.
    inner: u32,
    outer: u32,
    shift: u32,
    /// Of radii that are shifted so: the difference of their squares without its last 32 bits, and the smaller square.
    area: u32,
    square: u64,
    /// The first side and the width in Q32 turns; a width of 0 stands for a whole turn.
    start: u32,
    width: u32,
    density: Density,
    format: PhantomData<(Frac, G)>,
}

impl<Frac: LeEqU32, G: Grade> Annulus<Frac, G> {
    /// The ring between two radii.
    ///
    /// # Errors
    /// [`Error::Negative`] for a radius below 0, [`Error::Reversed`] if the inner one is the larger, [`Error::TooLarge`] for
    /// an outer one of more than half the format's range, [`Error::Empty`] for equal radii, or radii so near each
    /// other that the density overflows.
    pub const fn new(inner: FixedI32<Frac>, outer: FixedI32<Frac>) -> Result<Self, Error> {
        Self::of(inner, outer, 0, 0, 1)
    }

    /// The part of a ring from one side to another, each an azimuth in turns, counted from +x towards +y.
    ///
    /// # Errors
    /// Those of [`Annulus::new`], and [`Error::Empty`] for equal sides.
    pub const fn sector(
        inner: FixedI32<Frac>,
        outer: FixedI32<Frac>,
        sides: [Uniform; 2],
    ) -> Result<Self, Error> {
        let [from, to] = sides;
        match to.to_bits().wrapping_sub(from.to_bits()) {
            0 => Err(Error::Empty(2)),
            width => Self::of(inner, outer, from.to_bits(), width, Error::NO_PLACE),
        }
    }

    /// With the place of a reason that lies in all parameters.
    const fn of(
        inner: FixedI32<Frac>,
        outer: FixedI32<Frac>,
        start: u32,
        width: u32,
        all: usize,
    ) -> Result<Self, Error> {
        let (inner, outer) = (inner.to_bits(), outer.to_bits());
        if inner < 0 || outer < 0 {
            return Err(Error::Negative(if inner < 0 { 0 } else { 1 }));
        }
        if inner > outer {
            return Err(Error::Reversed(1));
        }
        if inner == outer {
            return Err(Error::Empty(1));
        }
        if outer > 1 << 30 {
            return Err(Error::TooLarge(1));
        }
        let (inner, outer) = (inner as u32, outer as u32);
        let steps = (outer - inner) as u64 * (outer + inner) as u64;
        let area = Scaled::of(steps, 2 * Frac::I32);
        let area = if width == 0 {
            area
        } else {
            let part = area.mantissa as u64 * width as u64;
            Scaled::of(part, 64 + area.exponent)
        };
        let density = PER_ANGLE.doubled().over(area);
        // 2³² or more.
        if density.exponent < -32 {
            return Err(Error::Empty(all));
        }
        let shift = ((outer - 1) | 1).leading_zeros();
        let (low, whole) = ((inner as u64) << shift, (outer as u64) << shift);
        // A power of two fills 33 bits.
        let top = if whole >> 32 == 0 {
            whole
        } else {
            u32::MAX as u64
        };
        Ok(Self {
            inner,
            outer,
            shift,
            area: (((top - low) * (top + low)) >> 32) as u32,
            square: low * low,
            start,
            width,
            density: density.density(u32::MAX),
            format: PhantomData,
        })
    }

    /// The inner and the outer radius.
    #[must_use]
    pub const fn radii(&self) -> [FixedI32<Frac>; 2] {
        let [inner, outer] = [self.inner as i32, self.outer as i32];
        [FixedI32::from_bits(inner), FixedI32::from_bits(outer)]
    }

    /// The azimuths of both sides in turns; both 0 for the whole ring.
    #[must_use]
    pub const fn sides(&self) -> [Uniform; 2] {
        let to = self.start.wrapping_add(self.width);
        [Uniform::from_bits(self.start), Uniform::from_bits(to)]
    }

    /// The square of a point's distance from the centre, and its azimuth from the first side.
    #[inline]
    fn polar(&self, point: [FixedI32<Frac>; 2]) -> (u64, u32) {
        let [x, y] = point.map(FixedI32::to_bits);
        let square = square_of([x.unsigned_abs(), y.unsigned_abs()]);
        (square, G::angle(y, x).wrapping_sub(self.start))
    }

    /// By how many turns an azimuth from the first side lies before it (first) or behind the second one (second).
    #[inline]
    fn beside(&self, turn: u32) -> (u32, u32) {
        if self.width == 0 || turn <= self.width {
            (0, 0)
        } else {
            (turn.wrapping_neg(), turn - self.width)
        }
    }
}

impl<Frac: LeEqU32, G: Grade> Warp for Annulus<Frac, G> {
    type Uniforms = [Uniform; 2];
    type Point = [FixedI32<Frac>; 2];
    type Density = Density;

    #[inline]
    fn sample_canonical(&self, u: Canonical<[Uniform; 2]>) -> [FixedI32<Frac>; 2] {
        let [u1, u2] = u.get().map(Uniform::to_bits);
        let square = self.square + wide(self.area, u1);
        // 16 more bits near the centre, where the root is steep.
        let radius = if square >> 48 == 0 {
            G::root((square >> 16) as u32) >> 8
        } else {
            G::root((square >> 32) as u32)
        };
        let turn = match self.width {
            0 => u2,
            width => high(width, u2),
        };
        // A word of radius and 30 bits of sine make two bits less than the shift.
        let right = self.shift - 2;
        let half = ((1_u32 << right) >> 1) as i32;
        let [x, y] = around::<G>(radius, self.start.wrapping_add(turn));
        // One by one: where code is to be small, `map` is a loop over memory.
        [(x + half) >> right, (y + half) >> right].map(FixedI32::from_bits)
    }

    #[inline]
    fn pdf(&self, point: [FixedI32<Frac>; 2]) -> Density {
        let (square, turn) = self.polar(point);
        let slack = high(self.outer, G::ASTRAY) + 2;
        let [low, most] = [self.inner.saturating_sub(slack), self.outer + slack];
        let between = wide(low, low) <= square && square <= wide(most, most);
        // Off a side by so much of a turn, and by about 2π times as much of the radius, which is up to √2 times the larger
        // coordinate: 8 times is between.
        let (before, behind) = self.beside(turn);
        let [x, y] = point.map(|c| c.to_bits().unsigned_abs());
        let off = wide(before.min(behind), x.max(y)) >> 29;
        if between && off <= u64::from(slack) {
            self.density
        } else {
            Density::ZERO
        }
    }
}

impl<Frac: LeEqU32, G: Grade> Invert for Annulus<Frac, G> {
    #[inline]
    fn invert(&self, point: [FixedI32<Frac>; 2]) -> [Uniform; 2] {
        let (square, turn) = self.polar(point);
        let [low, whole] = [self.inner, self.outer].map(|r| wide(r, r));
        let part = Scaled::of(square.saturating_sub(low), 0);
        let u1 = part.over(Scaled::of(whole - low, 0)).to_bits(32);
        let u2 = match (self.width, self.beside(turn)) {
            (0, _) => turn,
            (_, (before, behind)) if before < behind => 0,
            (width, _) if turn < width => quotient(turn, width),
            _ => u32::MAX,
        };
        [u1, u2].map(Uniform::from_bits)
    }
}

#[cfg(feature = "defmt")]
impl<Frac, G> defmt::Format for Annulus<Frac, G> {
    fn format(&self, f: defmt::Formatter<'_>) {
        defmt::write!(
            f,
            "Annulus {{ inner: {=u32}, outer: {=u32}, start: {=u32}, width: {=u32} }}",
            self.inner,
            self.outer,
            self.start,
            self.width
        );
    }
}
