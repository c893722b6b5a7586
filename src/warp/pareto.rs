//! The Pareto distribution. Both tiers share its samples and density.

use super::{Invert, Warp, drawn_with_pdf};
use crate::error::{Error, positive, tried};
use crate::num::double_word::{by_64, reciprocal};
use crate::num::{Scaled, into_unit, middle, representable};
use crate::tier::{LN_2, Tier, neg_log2_1m, neg_log2_1m_of_word, times_exp2};
use crate::uniform::Canonical;
use core::marker::PhantomData;

/// Pareto with a minimum m and a shape α: a heavy tail that falls as a power.
///
/// x = m(1 − u)^(−1/α), increasing with the uniform. The logarithm, by a table of 65 cells, has seven digits of what it adds to
/// a whole number, and 1/α has nine, so that a small shape, whose power is large, costs few of a sample's.
///
#[cfg_attr(doc, doc = include_str!("../pictures/pareto.html"))]
///
/// # Density
/// α m^α/x^(α+1) for x ≥ m, else 0. The mean is finite for α > 1, the variance for α > 2.
/// [`sample_with_pdf`](Warp::sample_with_pdf) takes it from the uniform, as α(1 − u)/x.
///
/// # Domain
/// - Point: drawn samples lie from m to m·2^(33/α). Uniforms on the 24-bit grid reach m·2^(24/α).
/// - Uniforms: one. Drawing takes all 32 bits of a word, as the middle of their cell.
/// - Parameters: a minimum and a shape above 0 for which neither samples nor the density overflow. A minimum of 1 takes
///   shapes from 0.26.
///
/// # Accuracy
/// *Sample* counts units in the last place (ulp) of the exact point. *Pdf* and *realised density* are relative,
/// *inverse* and *round trip* are absolute errors of the uniform. [What each row means](crate::warp#stated-errors).
///
/// | error | bound | kind |
/// |---|--:|---|
/// | sample, ulp | 3.2 + 1.9/k | proven |
/// | pdf, relative | 1.8e-7 | found |
/// | realised density, relative | 1.7e-7 + (4.7 + 0.93/k)*s/max(0, 1 - k/1e6) | found |
/// | pdf with the sample, relative | 5.2e-7 + 2.8e-7/k | found |
/// | inverse | 1.4e-7 | found |
/// | round trip | 1.1e-7 + (4 + 0.8/k)*r | found |
///
/// The error of a sample is proven for all parameters and uniforms: see `docs/proofs.md`.
///
/// A draw keeps the bound of a sample at the exact middle of its word. k is α. No realised density is stated from 1e6 on, where
/// the densities of neighbouring `f32` differ by a factor. s and r are the relative change of the density and the change of the
/// inverse when x moves by one ulp.
///
/// # Cost
/// One draw in `poly`, PCG32 included, takes <!-- figure: cost Pareto -->86 instructions and 528 bytes of code on an M4F, 2,596 instructions on an M0<!-- -->.
///
/// # Examples
/// ```
/// use microwarp::{Invert, Warp, poly as mw};
/// let wealth = mw::Pareto::new(1.0, 2.0)?;
/// assert_eq!(wealth.sample(0.75), 2.0);
/// assert_eq!(wealth.pdf(2.0), 0.25);
/// assert_eq!(wealth.invert(2.0), 0.75);
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// # See also
/// - [`Power`](super::Power): a power law on an interval.
/// - [`Cauchy`](super::Cauchy): heavy tails on both sides.
/// - [`Weibull`](super::Weibull): tails between an exponential and a power.
///
/// # Source
/// M. E. J. Newman, "Power Laws, Pareto Distributions and Zipf's Law", 2005, <https://doi.org/10.1080/00107510500052444>. The
/// form by tables is this crate's own.
#[doc(alias = "power_law")]
#[doc(alias = "heavy_tail")]
#[doc(alias = "lomax")]
#[doc(alias = "eighty_twenty")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Pareto<T> {
    minimum: Scaled,
    shape: f32,
    /// 64/α: a head of 12 bits and the rest.
    root: (f32, f32),
    tier: PhantomData<T>,
}

impl<T: Tier> Pareto<T> {
    /// Pareto with this minimum and this shape.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for NaN or infinity, [`Error::NotPositive`] for 0 or less, [`Error::TooLarge`] if a sample
    /// could overflow, [`Error::Empty`] if the density could.
    pub const fn new(minimum: f32, shape: f32) -> Result<Self, Error> {
        tried!(positive(minimum, 0));
        let root = reciprocal(tried!(positive(shape, 1)));
        // The deepest word, and what rounding may add.
        let last = Scaled::of(minimum).times_power((33.01, 0.0), root);
        if !last.value().is_finite() {
            Err(Error::TooLarge(1))
        } else if !(shape / minimum).is_finite() {
            Err(Error::Empty(1))
        } else {
            Ok(Self {
                minimum: Scaled::of(minimum),
                shape,
                root: by_64(root),
                tier: PhantomData,
            })
        }
    }

    /// The minimum.
    #[must_use]
    pub const fn minimum(&self) -> f32 {
        self.minimum.value()
    }

    /// The shape, the power with which the probability beyond a point falls.
    #[must_use]
    pub const fn shape(&self) -> f32 {
        self.shape
    }

    /// The minimum over the α-th root of a probability, given by its negative log₂.
    #[inline]
    fn beyond(&self, (whole, rest): (f32, f32)) -> f32 {
        let (root, root_rest) = self.root;
        let small = rest * (root + root_rest) + whole * root_rest;
        times_exp2(self.minimum, whole * root, small)
    }

    /// A point and its density, (1 − u)α/x, of this log₂ and 1 − u.
    #[inline]
    fn beyond_with_pdf(&self, log: (f32, f32), share: f32) -> (f32, f32) {
        let x = self.beyond(log);
        (x, representable(self.shape * share / x))
    }

    #[inline]
    fn of_word_with_pdf(&self, word: u32) -> (f32, f32) {
        self.beyond_with_pdf(neg_log2_1m_of_word(word), middle(!word))
    }

    /// log₂ of the minimum over x, for an x from there up.
    #[inline]
    fn log2_of_share(&self, x: f32) -> (f32, f32) {
        self.minimum.log2_over(Scaled::of(x))
    }
}

impl<T: Tier> Warp for Pareto<T> {
    type Uniforms = f32;
    type Point = f32;
    type Density = f32;

    #[inline]
    fn sample_canonical(&self, u: Canonical<f32>) -> f32 {
        self.beyond(neg_log2_1m(u.get()))
    }

    #[inline]
    fn sample_words(&self, word: u32) -> f32 {
        self.beyond(neg_log2_1m_of_word(word))
    }

    #[inline]
    fn sample_canonical_with_pdf(&self, u: Canonical<f32>) -> (f32, f32) {
        self.beyond_with_pdf(neg_log2_1m(u.get()), 1.0 - u.get())
    }

    drawn_with_pdf!(from of_word_with_pdf);

    #[inline]
    fn pdf(&self, x: f32) -> f32 {
        if (self.minimum()..=f32::MAX).contains(&x) {
            let start = Scaled::of(self.shape).over(Scaled::of(x));
            let log = self.log2_of_share(x);
            representable(start.times_power(log, (self.shape, 0.0)).value())
        } else {
            0.0
        }
    }
}

impl<T: Tier> Invert for Pareto<T> {
    #[inline]
    fn invert(&self, x: f32) -> f32 {
        if x > self.minimum() {
            let log = self.log2_of_share(if x < f32::MAX { x } else { f32::MAX });
            into_unit(-T::exp_m1(self.shape * ((log.0 + log.1) * LN_2.0)))
        } else {
            0.0
        }
    }
}
