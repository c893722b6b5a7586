//! Equi-angular sampling along a ray.

use super::{Invert, Warp};
use crate::error::{Error, finite};
use crate::num::{clamp, into_unit, remainder, two_product, two_sum};
use crate::tier::{Tier, sqrt};
use crate::uniform::Canonical;
use core::f32::consts::TAU;
use core::marker::PhantomData;

/// Equi-angular sampling along a ray: density in proportion to 1/(D² + t²), the light that a point sends to each place
/// of a ray through fog.
///
#[cfg_attr(doc, doc = include_str!("../pictures/equi_angular.html"))]
///
/// D is the distance at which the ray passes the light, and t the way along the ray from the foot, the place nearest
/// to the light. Seen from the light, the samples are uniform in angle. With Δ the angle between its ends, r their
/// distances to the light, `X = r_far sin((1 − w)Δ)` and `Y = r_near sin(wΔ)`, t is near + (far − near)Y/(X + Y), a
/// quotient of sums without cancellation. `near` is the end nearer to the foot, or the foot itself where the segment
/// passes it.
///
/// # Density
/// D/(Δ(D² + t²)) on [low, high]. Where Δ is below 2.5e-4 radians, D = 0 included, it is the limit of that:
/// `r_low r_high/((high − low)(D² + t²))`, for D = 0 in proportion to 1/t².
///
/// # Domain
/// [low, high], in the unit of length of the parameters. One uniform; t increases with it up to rounding: from one uniform of
/// the grid to the next it steps back by at most 7 ulp, as the table counts them. `low` and `high` are within
/// ±2⁴⁰ (1.1e12) and at least 2⁻⁴⁰ (9e-13) apart. D is from 2⁻⁴⁰ to 2⁴⁰, or 0 where the light lies on the ray and not
/// on the segment: both ends are at least 2⁻⁴⁰ away from it then, on one side.
///
/// # Accuracy
/// | error | `libm` | `poly` | kind |
/// |---|--:|--:|---|
/// | sample, ulp of itself or of a length | 15.3 | 15 | proven |
/// | pdf, relative | 6.5e-7 | 6.5e-7 | found |
/// | realised density, relative | 6.6e-7 + 8.3*s | 6.6e-7 + 8.3*s | found |
/// | inverse | 4.7e-7 | 5.6e-7 | found |
/// | round trip | 4.5e-7 + 2.1*r | 4.5e-7 + 2.1*r | found |
///
/// An ulp is that of t. Where the segment passes the foot it is that of D, or of the longer part where that is
/// shorter than D, as long as t is below. s and r: by how much the exact density, relatively, and the exact inverse
/// change over one such ulp.
///
/// # Cost
/// One draw in `poly`, PCG32 included, takes <!-- figure: cost EquiAngular -->144 instructions and 1,424 bytes of code on an M4F, 5,794 instructions on an M0<!-- -->.
///
/// # Examples
/// ```
/// use microwarp::{Invert, Warp, poly as mw};
/// // A lamp 2 m beside a ray, which passes it after 5 m and ends after 20 m.
/// let near_lamp = mw::EquiAngular::new(2.0, -5.0, 15.0)?;
/// let t = near_lamp.sample(0.5);
/// assert!(t.abs() < 1.0); // half of the samples lie before the lamp
/// assert!(near_lamp.pdf(0.0) > 25.0 * near_lamp.pdf(15.0));
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// # See also
/// - [`TruncatedExponential`](super::TruncatedExponential) follows the transmittance of the fog instead.
/// - [`Power`](super::Power) of exponent −2 is the distribution of D = 0 for any ratio of the ends.
///
/// # Source
/// C. Kulla and M. Fajardo, "Importance Sampling Techniques for Path Tracing in Participating Media", 2012,
/// <https://doi.org/10.1111/j.1467-8659.2012.03148.x>, rearranged here.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[doc(alias = "equiangular")]
#[doc(alias = "cauchy")]
#[doc(alias = "inverse_square")]
pub struct EquiAngular<T> {
    distance: f32,
    low: Side,
    high: Side,
    /// Δ in turns.
    angle: f32,
    /// The uniform of the foot; negative where the segment does not pass it.
    foot: f32,
    /// D/Δ, or its limit.
    scale: f32,
    tier: PhantomData<T>,
}

/// An end of the segment.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
struct Side {
    /// Its place on the ray.
    end: f32,
    /// Its distance to the light.
    distance: f32,
    /// The angle between it and the foot, in turns, where the segment passes that.
    angle: f32,
}

/// 2⁴⁰ and 2⁻⁴⁰: the longest and the shortest length.
const LONG: f32 = 1_099_511_627_776.0;
const SHORT: f32 = 1.0 / LONG;

/// What the `f32` nearest to 2π lacks.
const TAU_REST: f32 = (core::f64::consts::TAU - TAU as f64) as f32;

/// An angle in turns below which it is its sine: its square over 6 is less than 2⁻²⁶.
const FLAT: f32 = 4.0e-5;

/// 2⁻⁶⁰: the way of a uniform below it is in proportion to it.
const LINEAR: f32 = 8.673_617e-19;

/// a² + bc, rounded once.
fn square_and_product(a: f32, b: f32, c: f32) -> f32 {
    let ((square, lost), (product, dropped)) = (two_product(a, a), two_product(b, c));
    let (sum, rest) = two_sum(square, product);
    sum + (rest + (lost + dropped))
}

impl<T: Tier> EquiAngular<T> {
    /// Sampling of the segment [low, high] of a ray that passes a light at the given distance. Places on the ray are
    /// measured from the foot, the place nearest to the light.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for NaN or infinity, [`Error::Reversed`] for ends in the wrong order, [`Error::Empty`] for
    /// ends less than 2⁻⁴⁰ apart, [`Error::TooLarge`] for a length above 2⁴⁰, [`Error::Negative`] for a distance below
    /// 0, [`Error::OutOfRange`] for one above 0 and below 2⁻⁴⁰, [`Error::NotNormalizable`] for a light on the segment,
    /// or on its line and less than 2⁻⁴⁰ away.
    pub fn new(distance: f32, low: f32, high: f32) -> Result<Self, Error> {
        let (d, a, b) = (finite(distance, 0)?, finite(low, 1)?, finite(high, 2)?);
        if d < 0.0 {
            return Err(Error::Negative(0));
        }
        if a > b {
            return Err(Error::Reversed(2));
        }
        if d > LONG || a < -LONG || b > LONG {
            return Err(Error::TooLarge(if d > LONG {
                0
            } else if a < -LONG {
                1
            } else {
                2
            }));
        }
        let (extent, lost) = two_sum(b, -a);
        if extent < SHORT {
            return Err(Error::Empty(2));
        }
        if d == 0.0 && a < SHORT && b > -SHORT {
            return Err(Error::NotNormalizable(Error::NO_PLACE));
        }
        if d > 0.0 && d < SHORT {
            return Err(Error::OutOfRange(0));
        }
        let passed = a < 0.0 && b > 0.0;
        let side = |end: f32| Side {
            end,
            distance: sqrt(square_and_product(d, end, end)),
            angle: if passed {
                Self::turns(end.abs(), d)
            } else {
                0.0
            },
        };
        let (low, high) = (side(a), side(b));
        let angle = if passed {
            low.angle + high.angle
        } else {
            let (across, dropped) = two_product(d, extent);
            Self::turns(across + (dropped + d * lost), square_and_product(d, a, b))
        };
        let flat = !passed && angle < FLAT;
        Ok(Self {
            distance: d,
            low,
            high,
            angle: if flat { 0.0 } else { angle },
            foot: if passed { low.angle / angle } else { -1.0 },
            scale: if flat {
                low.distance * (high.distance / extent)
            } else {
                let (arc, dropped) = two_product(TAU, angle);
                let scale = d / arc;
                let lack = scale * (dropped + angle * TAU_REST);
                scale + (remainder(d, scale, arc) - lack) / arc
            },
            tier: PhantomData,
        })
    }

    /// D, the distance at which the ray passes the light.
    #[must_use]
    pub const fn distance(&self) -> f32 {
        self.distance
    }

    /// Where the segment begins, from the foot.
    #[must_use]
    pub const fn low(&self) -> f32 {
        self.low.end
    }

    /// Where the segment ends, from the foot.
    #[must_use]
    pub const fn high(&self) -> f32 {
        self.high.end
    }

    /// The angle of a point of the first quadrant, in turns. Above the diagonal its complement is worked out, which
    /// rounds less.
    #[inline]
    fn turns(y: f32, x: f32) -> f32 {
        if y > x {
            0.25 - T::atan2_turns(x, y)
        } else {
            T::atan2_turns(y, x)
        }
    }

    /// The sine of an angle in turns.
    #[inline]
    fn sine(angle: f32) -> f32 {
        T::sincos_turns(angle).0
    }
}

/// The place between two others that divides their distance in the ratio of two weights, measured from the one it is
/// nearer to.
#[inline]
fn between(near: f32, far: f32, to_far: f32, to_near: f32) -> f32 {
    let share = (far - near) / (to_far + to_near);
    if to_near < to_far {
        near + to_near * share
    } else {
        far - to_far * share
    }
}

impl<T: Tier> Warp for EquiAngular<T> {
    type Uniforms = f32;
    type Point = f32;
    type Density = f32;

    #[inline]
    fn sample_canonical(&self, u: Canonical<f32>) -> f32 {
        let u = u.get();
        let v = 1.0 - u;
        let (low, high) = (self.low, self.high);
        let t = if self.foot >= 0.0 {
            let (far, part) = if u < self.foot { (low, u) } else { (high, v) };
            let beyond = part * self.angle;
            let within = far.angle - beyond;
            let within = if within > 0.0 { within } else { 0.0 };
            let (x, y) = (Self::sine(beyond), Self::sine(within));
            between(0.0, far.end, far.distance * x, self.distance * y)
        } else {
            let ((near, w), (far, rest)) = if low.end >= 0.0 {
                ((low, u), (high, v))
            } else {
                ((high, v), (low, u))
            };
            if w < LINEAR && self.angle > 0.0 {
                // The angle may be below the range of `f32`, the way is not.
                let sum = far.distance * Self::sine(self.angle);
                let slope = near.distance * self.angle * TAU * ((far.end - near.end) / sum);
                near.end + w * slope
            } else {
                let (x, y) = if self.angle > 0.0 {
                    (Self::sine(rest * self.angle), Self::sine(w * self.angle))
                } else {
                    (rest, w)
                };
                between(near.end, far.end, far.distance * x, near.distance * y)
            }
        };
        clamp(t, low.end, high.end)
    }

    #[inline]
    fn pdf(&self, t: f32) -> f32 {
        if t >= self.low.end && t <= self.high.end {
            self.scale / (self.distance * self.distance + t * t)
        } else {
            0.0
        }
    }
}

impl<T: Tier> Invert for EquiAngular<T> {
    #[inline]
    fn invert(&self, t: f32) -> f32 {
        let (d, low, high) = (self.distance, self.low, self.high);
        let t = clamp(t, low.end, high.end);
        into_unit(if self.foot >= 0.0 {
            let angle = Self::turns(t.abs(), d);
            if t < 0.0 {
                (low.angle - angle) / self.angle
            } else {
                1.0 - (high.angle - angle) / self.angle
            }
        } else if self.angle > 0.0 {
            let share =
                |length: f32, end: f32| Self::turns(d * length, d * d + end * t) / self.angle;
            let part = share(t - low.end, low.end);
            if part <= 0.5 {
                part
            } else {
                1.0 - share(high.end - t, high.end)
            }
        } else {
            // Angles are as their sines, D(t − low)/(r_from r).
            let part = (t - low.end) / (high.end - low.end);
            part * high.distance / sqrt(d * d + t * t)
        })
    }
}
