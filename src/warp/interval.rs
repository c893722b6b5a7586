//! The uniform distribution on an interval, in both orientations.

use super::{Invert, Warp};
use crate::error::{Error, tried};
use crate::num::into_unit;
use crate::num::{Segment, extent, neighbour};
use crate::uniform::Canonical;

/// Uniform on an interval [a, b).
///
/// [`Interval::new`] runs from `a` at u = 0 up to, never reaching, `b`. [`Interval::decreasing`] runs from `b` at u
/// = 0 down to, never reaching, `a`. Neither ever turns back, whatever the bounds. Where `f32` has fewer points
/// than there are uniforms, each point has its share of them, to within three.
///
#[cfg_attr(doc, doc = include_str!("../pictures/interval.html"))]
///
/// # Density
/// 1/(b − a) on [a, b], else 0.
///
/// # Domain
/// - Point: [a, b), or (a, b] where it decreases.
/// - Uniforms: one.
/// - Parameters: finite a < b. The width may overflow `f32`.
/// - Both tiers share this code.
///
/// # Accuracy
/// *Sample* counts units in the last place (ulp) of the larger bound, the scale. *Pdf* and *realised density* are
/// relative, *inverse* and *round trip* are absolute errors of the uniform. [What each row
/// means](crate::warp#stated-errors).
///
/// | error | bound | kind |
/// |---|--:|---|
/// | sample, ulp of the scale | 1.75 | proven |
/// | pdf, relative | 1.2e-7 | proven |
/// | realised density, relative | 1.2e-7 | proven |
/// | inverse | 2e-7 | found |
/// | round trip | 1.8e-7 + 1.63*r | found |
///
/// The errors of samples and densities are proven for all bounds and uniforms: see `docs/proofs.md`.
///
/// r is the change of the inverse when x moves by one ulp of the larger bound. On the 24-bit grid, samples are
/// within 1.5 ulp, or 1.13 where the bounds differ in sign.
///
/// # Cost
/// One draw in `poly`, PCG32 included, takes <!-- figure: cost Interval -->35 instructions and 148 bytes of code on an M4F, 762 instructions on an M0<!-- -->.
///
/// # Examples
/// ```
/// use microwarp::{Invert, Warp, poly as mw};
/// let angle = mw::Interval::new(-3.0, 5.0)?;
/// assert_eq!(angle.sample(0.25), -1.0);
/// assert_eq!(angle.pdf(0.0), 0.125);
/// assert_eq!(angle.invert(-1.0), 0.25);
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// # See also
/// - [`Aabb`](super::Aabb): any dimension.
/// - [`PiecewiseConstant1d`](crate::discrete::PiecewiseConstant1d): a histogram.
///
/// # Source
/// F. Goualard, "Drawing Random Floating-Point Numbers from an Interval", ACM Transactions on Modeling and Computer
/// Simulation, 2022, <https://doi.org/10.1145/3503512>.
#[doc(alias = "uniform")]
#[doc(alias = "range")]
#[doc(alias = "gen_range")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Interval {
    segment: Segment,
    end: f32,
    /// The neighbour of `end` inside the interval, in place of samples that round to `end`.
    last: f32,
    density: f32,
}

impl Interval {
    /// Uniform on [a, b), increasing with the uniform.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for NaN or infinite bounds, [`Error::Reversed`] for a > b,
    /// [`Error::Empty`] for a = b or a width whose reciprocal overflows.
    pub const fn new(a: f32, b: f32) -> Result<Self, Error> {
        let density = tried!(Self::density_on(a, b));
        Ok(Self {
            segment: Segment::new(a, b),
            end: b,
            last: neighbour(b, a),
            density,
        })
    }

    /// Uniform on (a, b], decreasing with the uniform: b at u = 0.
    ///
    /// # Errors
    /// The errors of [`Interval::new`].
    pub const fn decreasing(a: f32, b: f32) -> Result<Self, Error> {
        let density = tried!(Self::density_on(a, b));
        Ok(Self {
            segment: Segment::new(b, a),
            end: a,
            last: neighbour(a, b),
            density,
        })
    }

    /// The lower bound.
    #[must_use]
    pub const fn low(&self) -> f32 {
        let (start, end) = (self.segment.start(), self.end);
        if start < end { start } else { end }
    }

    /// The upper bound.
    #[must_use]
    pub const fn high(&self) -> f32 {
        let (start, end) = (self.segment.start(), self.end);
        if start < end { end } else { start }
    }

    const fn density_on(a: f32, b: f32) -> Result<f32, Error> {
        let (scale, length) = tried!(extent([a, b], [0, 1]));
        let density = scale / length;
        if density.is_finite() {
            Ok(density)
        } else {
            Err(Error::Empty(1))
        }
    }
}

impl Warp for Interval {
    type Uniforms = f32;
    type Point = f32;
    type Density = f32;

    #[inline]
    #[expect(
        clippy::float_cmp,
        reason = "only samples equal to the end are replaced"
    )]
    fn sample_canonical(&self, u: Canonical<f32>) -> f32 {
        let x = self.segment.at(u.get());
        if x == self.end { self.last } else { x }
    }

    #[inline]
    fn pdf(&self, x: f32) -> f32 {
        let (start, end) = (self.segment.start(), self.end);
        let inside = (start <= x && x <= end) || (end <= x && x <= start);
        if inside { self.density } else { 0.0 }
    }

    super::filled_in_blocks!();
}

impl Invert for Interval {
    #[inline]
    fn invert(&self, x: f32) -> f32 {
        // Halved where the density is subnormal, since the width could overflow.
        let s = if self.density < f32::MIN_POSITIVE {
            0.5
        } else {
            1.0
        };
        let start = self.segment.start() * s;
        into_unit((x * s - start) / (self.end * s - start))
    }
}
