//! A density that changes linearly across the unit interval.

use super::{Warp, above_zero, into_unit, representable};
use crate::error::{Error, finite};
use crate::tier::sqrt;
use crate::uniform::{Canonical, LARGEST};

/// Linear on [0, 1): density ∝ (1 − x)a + xb.
///
/// x = u(a + b)/(a + √((1 − u)a² + ub²)), which stays accurate where a and b are nearly equal.
///
/// - Uniforms: one.
/// - Range: [0, 1); where a is 0, (0, 1).
/// - Density: 2((1 − x)a + xb)/(a + b) on [0, 1].
/// - Both tiers share this code: it needs nothing but a square root.
///
/// | error | `libm` | `poly` |
/// |---|--:|--:|
/// | sample, ulp | 3.8 | 3.8 |
/// | pdf, relative | 2.1e-7 | 2.1e-7 |
/// | realised density, relative | 1.2e-4 | 1.2e-4 |
/// | inverse | 1.7e-7 | 1.7e-7 |
/// | round trip | 3.3e-7 | 3.3e-7 |
///
/// Source: M. Pharr, W. Jakob and G. Humphreys, "Physically Based Rendering", 2023.
///
/// ```
/// use microwarp::{Warp, poly as mw};
/// let ramp = mw::Linear::new(0.0, 3.0)?;
/// assert_eq!(ramp.sample(0.25), 0.5);
/// assert_eq!(ramp.pdf(0.5), 1.0);
/// # Ok::<(), microwarp::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Linear {
    /// The densities at both ends, scaled so that the larger is 1.
    a: f32,
    b: f32,
}

impl Linear {
    /// Density ∝ `a` at 0 and ∝ `b` at 1.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for NaN or infinity, [`Error::Negative`] if either is below 0,
    /// [`Error::NotPositive`] if both are 0.
    pub const fn new(a: f32, b: f32) -> Result<Self, Error> {
        match (finite(a), finite(b)) {
            (Ok(_), Ok(_)) => {}
            (Err(e), _) | (_, Err(e)) => return Err(e),
        }
        if a < 0.0 || b < 0.0 {
            return Err(Error::Negative);
        }
        let larger = if a > b { a } else { b };
        if larger == 0.0 {
            return Err(Error::NotPositive);
        }
        Ok(Self {
            a: a / larger,
            b: b / larger,
        })
    }
}

impl Warp for Linear {
    type Uniforms = f32;
    type Point = f32;
    type Density = f32;

    #[inline]
    fn sample_canonical(&self, u: Canonical<f32>) -> f32 {
        let Self { a, b } = *self;
        let u = if a > 0.0 {
            u.get()
        } else {
            above_zero(u.get())
        };
        let root = sqrt((1.0 - u) * (a * a) + u * (b * b));
        // a + root may be subnormal and its reciprocal infinite; the quotient by it is not.
        let x = (u / (a + root)) * (a + b);
        if x < 1.0 { x } else { LARGEST }
    }

    #[inline]
    fn pdf(&self, x: f32) -> f32 {
        let Self { a, b } = *self;
        if (0.0..=1.0).contains(&x) {
            representable(2.0 * (((1.0 - x) * a + x * b) / (a + b)))
        } else {
            0.0
        }
    }

    #[inline]
    fn invert(&self, x: f32) -> f32 {
        let Self { a, b } = *self;
        let x = super::clamp(x, 0.0, 1.0);
        into_unit(x * ((a * (2.0 - x) + b * x) / (a + b)))
    }

    super::filled_in_blocks!();

    #[inline]
    fn sample_words(&self, word: u32) -> f32 {
        self.sample_canonical(crate::uniform::deep(word))
    }
}
