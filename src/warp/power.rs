//! The power law on an interval, in both orientations. Samples have nine digits inside in `libm`, and come by tables in `poly`.

use super::{Invert, Warp, drawn_with_pdf};
use crate::error::{Error, finite, tried};
use crate::num::double_word::by_64;
use crate::num::{
    Scaled, clamp, head, into_unit, middle, product, quick_two_sum, remainder, representable,
    two_sum,
};
use crate::tier::{
    LN_2, LOG2_E, Tier, exp2, exp2_m1, log2, log2_1p, log2_of_sum, times, times_exp2,
};
use crate::uniform::{Canonical, SMALLEST};
use core::marker::PhantomData;

/// A power law on an interval: density ∝ xⁿ on [a, b], for any exponent.
///
/// With m = n + 1, xᵐ is uniform between aᵐ and bᵐ. The code works relative to the end R where xᵐ is larger, with t
/// = 1 − (x/R)ᵐ, and takes the logarithm of 1 − t, so that nothing overflows and m near 0 does not cancel. In
/// [`libm`](crate::libm) it has nine digits. In `poly` it comes by a table or, for m near 0, by a series, in a fraction of
/// the time. [`Power::new`] runs from a at u = 0 to b, [`Power::decreasing`] from b to a. A sample never steps back from one
/// uniform of the grid to the next.
///
#[cfg_attr(doc, doc = include_str!("../pictures/power.html"))]
///
/// # Density
/// m xⁿ/(bᵐ − aᵐ), or 1/(x ln(b/a)) for n = −1, on [a, b]; else 0. [`sample_with_pdf`](Warp::sample_with_pdf) takes it from the
/// uniform.
///
/// # Domain
/// - Point: [a, b]; above 0 where the density is 0 or infinite at a = 0.
/// - Uniforms: one.
/// - Parameters: 0 ≤ a < b, and any n: −1, near −1, 0, up to ±1e8 and beyond. n > −1 where a = 0.
///
/// With a = 0 and n < 0 the density is infinite at 0. The largest `f32` stands for densities above it, and samples
/// that would be smaller than 2⁻¹⁴⁹ are 2⁻¹⁴⁹, as most are for n within 1e-3 of −1.
///
/// # Accuracy
/// *Sample* counts units in the last place (ulp) of the exact point. *Pdf* and *realised density* are relative,
/// *inverse* and *round trip* are absolute errors of the uniform. [What each row means](crate::warp#stated-errors).
///
/// | error | `libm` | `poly` | kind |
/// |---|--:|--:|---|
/// | sample, ulp | 1.5 | 3.7 + 4.9·min(1/k, k·d·d) | found |
/// | pdf, relative | 1.6e-7 | 1.6e-7 | found |
/// | realised density, relative | 1.8e-7 + s | 1.7e-7 + (3.7 + 4.8·min(1/k, k·d·d))·s/max(0, 1 - k/1e6) | found |
/// | pdf with the sample, relative | 5.7e-7 + s | 4.3e-7 + 3.2e-7·min(1/k, k·d·d) + 1.8*s | found |
/// | inverse | 3.5e-7 | 3.5e-7 | found |
/// | round trip | 3.4e-7 + 1.5*r | 3e-7 + (3.3 + 4.2·min(1/k, k·d·d))·r | found |
///
/// k is |n + 1| and d is log₂(b/a), infinite for a = 0. In `poly` no realised density is stated from k = 1e6 on, where the densities
/// of neighbouring `f32` differ by a factor. s and r are the relative change of the exact density and the change of the
/// exact inverse over one ulp of x.
///
/// # Cost
/// One draw in `poly`, PCG32 included, takes <!-- figure: cost Power -->151 instructions and 932 bytes of code on an M4F, 4,121 instructions on an M0<!-- -->.
///
/// # Examples
/// ```
/// use microwarp::{Invert, Warp, poly as mw};
/// let spectrum = mw::Power::new(-1.0, 1.0, 100.0)?; // equal weight to every octave
/// assert!((spectrum.sample(0.5) - 10.0).abs() < 1e-5);
/// let area = mw::Power::new(1.0, 0.0, 2.0)?;
/// assert_eq!(area.sample(0.25), 1.0);
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// # See also
/// - [`PowerMax`](super::PowerMax): whole exponents on [0, 1) without a logarithm.
/// - [`Linear`](super::Linear): n = 1, and any trapezoid, at a lower cost.
///
/// # Source
/// M. E. J. Newman, "Power Laws, Pareto Distributions and Zipf's Law", 2005,
/// <https://doi.org/10.1080/00107510500052444>. The stable form is derived here.
#[doc(alias = "pareto")]
#[doc(alias = "power_law")]
#[doc(alias = "log_uniform")]
#[doc(alias = "zipf")]
#[doc(alias = "reciprocal")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Power<T> {
    n: f32,
    low: f32,
    high: f32,
    /// The sample of u = 0.
    first: f32,
    /// Whether u = 0 is at R, which is a for n < −1 and b otherwise.
    from_anchor: bool,
    /// D = 1 − e^(−z) with z = |m| ln(b/a); for m = 0 by nine digits 1, by tables 0.
    drop: Pair,
    /// 2⁶⁴e^(−z), or 0 where that is negligible beside any uniform.
    rest: Pair,
    /// 1/m; −log₂(b/a) for m = 0. By tables 64 times that, and −64 log₂(e) D/m where D is below ½: a head of 12 bits and the
    /// rest.
    root: Pair,
    /// The density at R, and R times that.
    peak: Scaled,
    height: f32,
    tier: PhantomData<T>,
}

/// A number and its rounding error.
type Pair = (f32, f32);

/// 2⁶⁴, which keeps the smallest uniforms and e^(−z) above the subnormal numbers.
const LIFT: f32 = 18_446_744_073_709_551_616.0;

impl<T: Tier> Power<T> {
    /// Density ∝ xⁿ on [a, b], increasing with the uniform.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for NaN or infinity, [`Error::Negative`] for a < 0, [`Error::Reversed`] for
    /// a > b, [`Error::Empty`] for a = b or a density that overflows, at b or at an a > 0,
    /// [`Error::NotNormalizable`] for a = 0 with n ≤ −1.
    pub const fn new(n: f32, a: f32, b: f32) -> Result<Self, Error> {
        Self::build(n, a, b, true)
    }

    /// Density ∝ xⁿ on [a, b], decreasing with the uniform: b at u = 0.
    ///
    /// # Errors
    /// The errors of [`Power::new`].
    pub const fn decreasing(n: f32, a: f32, b: f32) -> Result<Self, Error> {
        Self::build(n, a, b, false)
    }

    const fn build(n: f32, a: f32, b: f32, increasing: bool) -> Result<Self, Error> {
        tried!(finite(n, 0));
        tried!(finite(a, 1));
        tried!(finite(b, 2));
        if a < 0.0 {
            return Err(Error::Negative(1));
        }
        if a > b {
            return Err(Error::Reversed(2));
        }
        if a >= b {
            return Err(Error::Empty(2));
        }
        if a == 0.0 && n <= -1.0 {
            return Err(Error::NotNormalizable(1));
        }
        // −0 becomes 0.
        let a = a + 0.0;
        let m = two_sum(n, 1.0);
        let span = if a > 0.0 {
            Scaled::of(b).log2_over(Scaled::of(a))
        } else {
            (f32::INFINITY, 0.0)
        };
        let (drop, rest, root, height) = if m.0 == 0.0 {
            let span = quick_two_sum(span.0, span.1);
            let whole = (1.0, 0.0);
            (
                whole,
                (0.0, 0.0),
                (-span.0, -span.1),
                (whole, product(span, LN_2)),
            )
        } else {
            let (drop, rest) = decay(span, m);
            let inverse = 1.0 / m.0;
            let short = remainder(1.0, inverse, m.0) - inverse * m.1;
            (drop, rest, (inverse, short / m.0), (m, drop))
        };
        let anchor = Scaled::of(if m.0 < 0.0 { a } else { b });
        let mut power = Self {
            n,
            // x = 0 is excluded where the density there is 0 or infinite.
            low: if a > 0.0 || n == 0.0 { a } else { SMALLEST },
            high: b,
            first: if increasing { a } else { b },
            from_anchor: increasing == (m.0 < 0.0),
            drop,
            rest,
            root,
            peak: Scaled::of_quotient(height.0, height.1, anchor),
            height: Scaled::of_quotient(height.0, height.1, Scaled::ONE).value(),
            tier: PhantomData,
        };
        if power.first < power.low {
            power.first = power.along(power.weights(SMALLEST));
        }
        if T::TABLES {
            power.tabulate(m.0 == 0.0);
        }
        // An integrable singularity at 0 is accepted.
        if power.density(b) > f32::MAX || (a > 0.0 && power.density(a) > f32::MAX) {
            return Err(Error::Empty(Error::NO_PLACE));
        }
        Ok(power)
    }

    /// The exponent n.
    #[must_use]
    pub const fn exponent(&self) -> f32 {
        self.n
    }

    /// The lower bound a. Where the density is 0 or infinite at a = 0, this is 2⁻¹⁴⁹, the smallest sample.
    #[must_use]
    pub const fn low(&self) -> f32 {
        self.low
    }

    /// The upper bound b.
    #[must_use]
    pub const fn high(&self) -> f32 {
        self.high
    }

    /// R, the end where xᵐ is larger.
    #[inline]
    const fn anchor(&self) -> f32 {
        if self.n < -1.0 { self.low } else { self.high }
    }

    /// The weights of the anchor and of the other end in the mixture, of a uniform.
    #[inline]
    const fn weights(&self, u: f32) -> (Pair, Pair) {
        let rise = 1.0 - u;
        let (u, rise) = ((u, 0.0), (rise, (1.0 - rise) - u));
        if self.from_anchor {
            (rise, u)
        } else {
            (u, rise)
        }
    }

    /// The sample of a uniform in (0, 1) by nine digits.
    #[inline]
    const fn along(&self, (near, away): (Pair, Pair)) -> f32 {
        let (q, q_rest) = product(away, self.drop);
        let log = if self.n + 1.0 == 0.0 {
            let part = head(q);
            (part, (q - part) + q_rest)
        } else if q < 0.29 {
            log2_1p(0.0, -q, -q_rest)
        } else {
            let (far, far_rest) = product(away, self.rest);
            let (w, dropped) = two_sum(near.0 * LIFT, far);
            log2_of_sum(w, dropped + (near.1 * LIFT + far_rest), 64.0)
        };
        let x = Scaled::of(self.anchor())
            .times_power(log, self.root)
            .value();
        clamp(x, self.low, self.high)
    }

    /// What samples by tables multiply by.
    const fn tabulate(&mut self, logarithmic: bool) {
        if logarithmic {
            self.drop = (0.0, 0.0);
        } else if self.drop.0 < 0.5 {
            let (slope, rest) = product(product(self.drop, self.root), LOG2_E);
            self.root = (-slope, -rest);
        }
        self.root = by_64(self.root);
    }

    /// The sample by tables, of both weights; the first part of the second has 12 bits.
    #[allow(clippy::inline_always, reason = "see `Warp::try_draw`")]
    #[cfg_attr(target_arch = "x86_64", inline(always))]
    #[cfg_attr(not(target_arch = "x86_64"), inline)]
    fn mixed(&self, near: f32, (high, low): Pair) -> f32 {
        let (root, root_rest) = self.root;
        let (exact, small) = if self.drop.0 < 0.5 {
            // log₂(1 - q) is -q log₂(e)(1 + tail).
            let q = (high + low) * self.drop.0;
            let s = q / (2.0 - q);
            let w = s * s;
            let series = 1.0 / 3.0
                + w * (0.2 + w * (1.0 / 7.0 + w * (1.0 / 9.0 + w * (1.0 / 11.0 + w / 13.0))));
            let tail = s + (1.0 + s) * (w * series);
            let (exact, small) = (high * root, high * root_rest + low * (root + root_rest));
            (exact, small + (exact + small) * tail)
        } else {
            let (whole, log) = log2(near * LIFT + (high + low) * self.rest.0);
            let whole = whole - 64.0;
            (whole * root, log * (root + root_rest) + whole * root_rest)
        };
        // No quotient of two ends is below 2^-277; a law from 0 gets there.
        if exact + small < -40_000.0 {
            return self.low;
        }
        let x = times_exp2(Scaled::of(self.anchor()), exact, small);
        clamp(x, self.low, self.high)
    }

    /// The sample of both weights.
    #[inline]
    fn of_weights(&self, (near, away): (Pair, Pair)) -> f32 {
        if T::TABLES {
            let high = head(away.0);
            self.mixed(near.0, (high, (away.0 - high) + away.1))
        } else {
            self.along((near, away))
        }
    }

    /// The density at the sample x of both weights: (x/R)ᵐ, their mixture, counts for it.
    #[inline]
    fn density_of_weights(&self, near: f32, away: f32, x: f32) -> f32 {
        let mixture = if self.n + 1.0 == 0.0 {
            1.0
        } else if self.drop.0 < 0.5 {
            1.0 - away * self.drop.0
        } else {
            near + away * (self.rest.0 / LIFT)
        };
        representable(if x < f32::MIN_POSITIVE {
            self.pdf(x)
        } else if mixture > 1.0e-30 {
            self.height * mixture / x
        } else {
            // The product would lose digits that the density may have.
            let rate = Scaled::of(self.height).times(Scaled::of(mixture));
            rate.over(Scaled::of(x)).value()
        })
    }

    /// Both weights of a word by tables. That of the anchor is deep.
    #[allow(clippy::inline_always, reason = "see `Warp::try_draw`")]
    #[cfg_attr(target_arch = "x86_64", inline(always))]
    #[cfg_attr(not(target_arch = "x86_64"), inline)]
    fn weights_of_word(&self, word: u32) -> (f32, Pair) {
        let word = if self.from_anchor { !word } else { word };
        let away = !word;
        let low = (away & 0x000f_ffff) as f32 + 0.5;
        let high = (away >> 20) as f32;
        (middle(word), (high / 4096.0, low / 4_294_967_296.0))
    }

    /// The same by nine digits.
    #[inline]
    fn deep_weights(&self, word: u32) -> (Pair, Pair) {
        let word = if self.from_anchor { !word } else { word };
        let near = crate::uniform::deep_from_word(word);
        let away = 1.0 - near;
        ((near, 0.0), (away, (1.0 - away) - near))
    }

    /// The sample by nine digits of a word.
    #[inline(never)]
    fn deep(&self, word: u32) -> f32 {
        self.along(self.deep_weights(word))
    }

    #[inline]
    fn of_word_with_pdf(&self, word: u32) -> (f32, f32) {
        let x = self.sample_words(word);
        let (near, away) = if T::TABLES {
            let (near, (high, low)) = self.weights_of_word(word);
            (near, high + low)
        } else {
            let (near, away) = self.deep_weights(word);
            (near.0, away.0)
        };
        (x, self.density_of_weights(near, away, x))
    }

    /// The density inside the domain; infinite where it overflows.
    #[inline]
    const fn density(&self, x: f32) -> f32 {
        let log = Scaled::of(x).log2_over(Scaled::of(self.anchor()));
        self.peak.times_power(log, (self.n, 0.0)).value()
    }
}

/// 1 − e^(−z) and 2⁶⁴e^(−z) for z = |m| ln(b/a), from log₂(b/a).
const fn decay(span: (f32, f32), m: Pair) -> (Pair, Pair) {
    // From here on e^(−z) is less than 2⁻⁴⁰ of the smallest float.
    if m.0.abs() * (span.0 + span.1) >= 190.0 {
        return ((1.0, 0.0), (0.0, 0.0));
    }
    let (exact, small) = times(span, -m.0.abs());
    let small = small - m.1.copysign(m.0 * m.1) * span.0;
    let (k, rise) = exp2_m1(quick_two_sum(exact, small));
    let (power, dropped) = quick_two_sum(1.0, rise.0);
    let scale = Scaled::ONE.raised(k.wrapping_add(64)).value();
    let rest = (power * scale, (dropped + rise.1) * scale);
    let drop = if k == 0 {
        (-rise.0, -rise.1)
    } else {
        let (drop, dropped) = quick_two_sum(1.0, -rest.0 / LIFT);
        (drop, dropped - rest.1 / LIFT)
    };
    (drop, rest)
}

impl<T: Tier> Warp for Power<T> {
    type Uniforms = f32;
    type Point = f32;
    type Density = f32;

    #[inline]
    fn sample_canonical(&self, u: Canonical<f32>) -> f32 {
        let u = u.get();
        if u <= 0.0 {
            self.first
        } else {
            self.of_weights(self.weights(u))
        }
    }

    #[inline]
    fn sample_canonical_with_pdf(&self, u: Canonical<f32>) -> (f32, f32) {
        let x = self.sample_canonical(u);
        let (near, away) = self.weights(u.get());
        // The end itself may stand for a density of 0.
        let density = if u.get() > 0.0 {
            self.density_of_weights(near.0, away.0, x)
        } else {
            self.pdf(x)
        };
        (x, density)
    }

    drawn_with_pdf!(from of_word_with_pdf);

    #[inline]
    fn pdf(&self, x: f32) -> f32 {
        if x >= self.low && x <= self.high {
            representable(self.density(x))
        } else {
            0.0
        }
    }

    /// Takes the end where the density may be 0 or infinite as that of u = 0, in both orientations.
    #[allow(clippy::inline_always, reason = "see `Warp::try_draw`")]
    #[cfg_attr(target_arch = "x86_64", inline(always))]
    #[cfg_attr(not(target_arch = "x86_64"), inline)]
    fn sample_words(&self, word: u32) -> f32 {
        if T::TABLES {
            let (near, away) = self.weights_of_word(word);
            self.mixed(near, away)
        } else {
            self.deep(word)
        }
    }
}

impl<T: Tier> Invert for Power<T> {
    #[inline]
    fn invert(&self, x: f32) -> f32 {
        let x = clamp(x, self.low, self.high);
        let log = Scaled::of(x).log2_over(Scaled::of(self.anchor()));
        let m = two_sum(self.n, 1.0);
        let (power, away) = if m.0 == 0.0 {
            let unit = if T::TABLES { 64.0 } else { 1.0 };
            (0.0, (log.0 + log.1) * unit / (self.root.0 + self.root.1))
        } else if m.0 * (log.0 + log.1) > -190.0 {
            let (exact, small) = times(log, m.0);
            let (k, a, b) = exp2(exact, small + m.1 * log.0);
            let scale = Scaled::ONE.raised(k).value();
            let part = scale * (a + b);
            (scale + part, ((1.0 - scale) - part) / self.drop.0)
        } else {
            (0.0, 1.0)
        };
        // A small `near` is computed directly, not as 1 minus `away`.
        let near = if away > 0.5 && self.drop.0 > 0.5 && power > 0.0 {
            (power - self.rest.0 / LIFT) / self.drop.0
        } else {
            1.0 - away
        };
        into_unit(if self.from_anchor { away } else { near })
    }
}
