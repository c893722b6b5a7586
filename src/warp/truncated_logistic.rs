//! The logistic distribution restricted to an interval, from the end that is nearer to its location.

use super::location_scale::{Standard, decayed, standardised};
use super::{Invert, Logistic, Warp, drawn_with_pdf};
use crate::error::{Error, finite, positive, tried};
use crate::num::{Scaled, clamp, folded, into_unit, quick_two_sum, representable, two_sum};
use crate::tier::{LOG2_E, Tier, exp2_m1, times};
use crate::uniform::Canonical;
use core::marker::PhantomData;

/// From this many scales on, an interval about the location is measured from there.
const WIDE: f32 = 4.0;

/// Below this, a number is its own logarithm of 1 more, to half a unit in the last place.
const STRAIGHT: f32 = 1.0 / 67_108_864.0;

/// The share of the probability beyond a point that no sample has less of: of a smaller one `f32` has few digits.
#[inline]
fn reached(share: f32) -> f32 {
    if share > f32::MIN_POSITIVE {
        share
    } else {
        f32::MIN_POSITIVE
    }
}

/// Logistic with a location μ and a scale s, restricted to an interval [a, b]: wavelengths as the eye weighs them, azimuths in
/// hair.
///
/// It increases with the uniform, except for single steps back between neighbours of the grid by a few ulp. An interval about
/// μ that is 4s or wider is measured from μ: the probabilities below and above the point are sums of positive shares, and their
/// ratio is e^t. Any other is measured from the end x₀ that is nearer to μ. With v the probability between x₀ and the point, the
/// distance is s ln(1 + cv/(1 − v + ρv)), in which nothing cancels, however narrow the interval is and however far out.
///
#[cfg_attr(doc, doc = include_str!("../pictures/truncated_logistic.html"))]
///
/// # Density
/// e^(−t)/(s(1 + e^(−t))²(F(b) − F(a))) on [a, b], with t = |x − μ|/s and F the logistic function of (x − μ)/s; else 0.
///
/// # Domain
/// - Point: [a, b]. A point with less than 2⁻¹²⁶ of the probability beyond it is not reached: of the whole where samples are
///   measured from μ, else of that beyond the end x₀, as if the other end were infinite.
/// - Uniforms: one. Drawing takes all 32 bits of a word, as the middle of their cell.
/// - Parameters: a finite location, a scale above 0, and finite ends in their order, all of them so small that four times the
///   sum of their sizes is finite, and for which four times the largest density is finite, too.
///
/// # Accuracy
/// *Sample* counts units in the last place (ulp) of x₀, of x − x₀ or of l, whichever is largest. In an interval about μ
/// that is 4s or wider, x₀ is μ and l is s; otherwise x₀ is the end nearer to μ, as `f32` subtracts, and l is 0. *Pdf* and
/// *realised density* are relative, *inverse* and *round trip* are absolute errors of the uniform. [What each row
/// means](crate::warp#stated-errors).
///
/// | error | bound | kind |
/// |---|--:|---|
/// | sample, ulp of location or distance | 13 | found |
/// | pdf, relative | 1.1e-6 | found |
/// | realised density, relative | 1.1e-6 + 4*s/max(0, 1 - w/1e6) | found |
/// | pdf with the sample, relative | 7.5e-7 | found |
/// | inverse | 6.8e-7 | found |
/// | round trip | 7e-7 + 4.5*r | found |
///
/// A draw keeps the bound of a sample at the exact middle of its word. w is |x₀|/s. No realised density is stated from
/// 1e6 on, where the densities of neighbouring `f32` differ by a factor. s and r are the relative change of the density and the
/// change of the inverse when x moves by one such ulp.
///
/// # Cost
/// One draw in `poly`, PCG32 included, takes <!-- figure: cost TruncatedLogistic -->94 instructions and 436 bytes of code on an M4F, 3,432 instructions on an M0<!-- -->.
///
/// # Examples
/// ```
/// use microwarp::{Error, Warp, constant, poly as mw};
///
/// // Visible wavelengths in nm, after Radziszewski and others; pbrt's law. More of them: u + 1/4, u + 2/4, u + 3/4, modulo 1.
/// const VISIBLE: mw::TruncatedLogistic = constant!(mw::TruncatedLogistic::new(538.0, 69.444_44, 360.0, 830.0));
/// let (wavelength, pdf) = VISIBLE.sample_with_pdf(0.5);
/// assert!((wavelength - 545.903).abs() < 1e-2);
/// assert!((VISIBLE.pdf(538.0) - 0.003_939_804).abs() < 1e-8 && pdf < 0.003_94);
/// assert_eq!(VISIBLE.sample(0.0), 360.0);
///
/// // The azimuth at which hair scatters light, of scale 0.2 rad.
/// let azimuth = mw::TruncatedLogistic::new(0.0, 0.2, -3.141_592_7, 3.141_592_7)?;
/// assert_eq!(azimuth.sample(0.5), 0.0);
/// # Ok::<(), Error>(())
/// ```
///
/// # See also
/// - [`Logistic`]: without ends, at a lower cost.
/// - [`TruncatedExponential`](super::TruncatedExponential): what a far tail comes near to.
///
/// # Source
/// M. Radziszewski, K. Boryczko and W. Alda, "An Improved Technique for Full Spectral Rendering", 2009,
/// <https://dspace5.zcu.cz/handle/11025/1291>, for wavelengths; M. J.-Y. Chiang and others, "A Practical and Controllable Hair and
/// Fur Model for Production Path Tracing", 2016, <https://doi.org/10.1111/cgf.12830>, for hair. The two forms are this crate's own.
#[doc(alias = "wavelength")]
#[doc(alias = "spectral")]
#[doc(alias = "hair")]
#[doc(alias = "sigmoid")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct TruncatedLogistic<T> {
    location: f32,
    scale: f32,
    low: f32,
    high: f32,
    form: Form,
    /// The density at the point from which samples are measured; about the location four times that.
    peak: f32,
    tier: PhantomData<T>,
}

/// From where samples are measured, and what that needs.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
enum Form {
    /// From an end.
    End {
        /// Whether it is the upper one.
        upper: bool,
        /// The probability on its side of the location over that on the other.
        odds: f32,
        /// The probability between the ends, times 1 + odds, both over that beyond this end; and that beyond the far end.
        part: f32,
        rest: f32,
        /// The scale times the part.
        length: f32,
    },
    /// From the location: the probabilities below and above each end, and that between them.
    Middle {
        low: [f32; 2],
        high: [f32; 2],
        between: f32,
    },
}

/// e^t, and e^t − 1 with its rounding error, for a t up to 4 that is given with its own.
const fn powers((t, rest): (f32, f32)) -> (f32, (f32, f32)) {
    if t > -110.0 {
        let (exact, small) = times(LOG2_E, t);
        let (k, rise) = exp2_m1(quick_two_sum(exact, small + rest * LOG2_E.0));
        let scale = Scaled::ONE.raised(k).value();
        let (less, dropped) = two_sum(scale - 1.0, scale * rise.0);
        let power = Scaled::of(1.0 + rise.0).raised(k).value();
        (power, (less, dropped + scale * rise.1))
    } else {
        (0.0, (-1.0, 0.0))
    }
}

const fn negative((t, rest): (f32, f32)) -> (f32, f32) {
    (-t, -rest)
}

impl<T: Tier> TruncatedLogistic<T> {
    /// Logistic with this location and this scale on [low, high].
    ///
    /// # Errors
    /// [`Error::NotFinite`] for NaN or infinity, [`Error::NotPositive`] for a scale of 0 or less, [`Error::Reversed`] for ends
    /// in the wrong order, [`Error::TooLarge`] where four times the sum of all sizes overflows, [`Error::Empty`] for equal ends
    /// and if four times the largest density overflows.
    pub const fn new(location: f32, scale: f32, low: f32, high: f32) -> Result<Self, Error> {
        tried!(finite(location, 0));
        tried!(positive(scale, 1));
        if tried!(finite(low, 2)) > tried!(finite(high, 3)) {
            return Err(Error::Reversed(3));
        }
        let sizes = (location.abs() + scale) + (low.abs() + high.abs());
        if !(4.0 * sizes).is_finite() {
            return Err(Error::TooLarge(Error::NO_PLACE));
        }
        let to_low = standardised(low, location, scale);
        let to_high = standardised(high, location, scale);
        let width = standardised(high, low, scale);
        let (fall, (gap, _)) = powers(negative(width));
        let (form, length) = if low < location && location < high && width.0 >= WIDE {
            let (low, _) = powers(to_low);
            let (high, _) = powers(negative(to_high));
            let between = -gap / ((1.0 + low) * (1.0 + high));
            let form = Form::Middle {
                low: [low / (1.0 + low), 1.0 / (1.0 + low)],
                high: [1.0 / (1.0 + high), high / (1.0 + high)],
                between,
            };
            (form, scale * between)
        } else {
            let upper = high <= location || high - location < location - low;
            let near = if upper { to_high } else { negative(to_low) };
            let (odds, _) = powers(near);
            let whole = 1.0 + odds * fall;
            let part = -gap * (1.0 + odds) / whole;
            let length = if width.0 < STRAIGHT {
                high - low
            } else {
                scale * part
            };
            let form = Form::End {
                upper,
                odds,
                part,
                rest: fall * (1.0 + odds) / whole,
                length,
            };
            (form, length)
        };
        let peak = 1.0 / length;
        // Four times the density at the location, where that is inside, or else at the end.
        let largest = match form {
            Form::Middle { .. } => peak,
            Form::End { odds, .. } if low < location && location < high => {
                peak * ((1.0 + odds) * (1.0 + odds) / odds)
            }
            Form::End { .. } => 4.0 * peak,
        };
        if !largest.is_finite() {
            return Err(Error::Empty(if low < high { Error::NO_PLACE } else { 3 }));
        }
        Ok(Self {
            location,
            scale,
            low,
            high,
            form,
            peak,
            tier: PhantomData,
        })
    }

    /// The location of the distribution before it is restricted.
    #[must_use]
    pub const fn location(&self) -> f32 {
        self.location
    }

    /// The scale of the distribution before it is restricted.
    #[must_use]
    pub const fn scale(&self) -> f32 {
        self.scale
    }

    /// The lower end.
    #[must_use]
    pub const fn low(&self) -> f32 {
        self.low
    }

    /// The upper end.
    #[must_use]
    pub const fn high(&self) -> f32 {
        self.high
    }

    /// The point with these shares of the probability below and above it, and its density.
    #[inline]
    fn place(&self, below: f32, above: f32) -> (f32, f32) {
        let (x, density) = match self.form {
            Form::End {
                upper,
                odds,
                part,
                rest,
                length,
            } => {
                let (near, before, beyond) = if upper {
                    (self.high, above, below)
                } else {
                    (self.low, below, above)
                };
                let left = reached(beyond + rest * before);
                let rise = part * before / left;
                let along = if rise < STRAIGHT {
                    length * before / left
                } else if left > 1.0e-30 {
                    self.scale * T::ln_1p(rise)
                } else {
                    self.scale * (T::ln(part * before) - T::ln(left))
                };
                let x = if upper { near - along } else { near + along };
                // What lies beyond the point of the probability beyond the end, and the rise of the other factor.
                let other = 1.0 + odds / (1.0 + odds) * (part * before);
                (x, left * other)
            }
            Form::Middle { low, high, .. } => {
                let lower = above * low[0] + below * high[0];
                let higher = above * low[1] + below * high[1];
                let upper = higher < lower;
                let tail = reached(if upper { higher } else { lower });
                let t = Logistic::<T>::deviate(tail, upper);
                (self.location + self.scale * t, tail * (1.0 - tail))
            }
        };
        (clamp(x, self.low, self.high), self.peak * density)
    }

    #[inline]
    fn of_word_with_pdf(&self, word: u32) -> (f32, f32) {
        let (tail, upper) = folded(word);
        let (x, density) = if upper {
            self.place(1.0 - tail, tail)
        } else {
            self.place(tail, 1.0 - tail)
        };
        (x, representable(density))
    }
}

impl<T: Tier> Warp for TruncatedLogistic<T> {
    type Uniforms = f32;
    type Point = f32;
    type Density = f32;

    #[inline]
    fn sample_canonical(&self, u: Canonical<f32>) -> f32 {
        self.sample_canonical_with_pdf(u).0
    }

    #[inline]
    fn sample_words(&self, word: u32) -> f32 {
        self.of_word_with_pdf(word).0
    }

    #[inline]
    fn sample_canonical_with_pdf(&self, u: Canonical<f32>) -> (f32, f32) {
        let u = u.get();
        let (x, density) = self.place(u, 1.0 - u);
        (x, representable(density))
    }

    drawn_with_pdf!(from of_word_with_pdf);

    #[inline]
    fn pdf(&self, x: f32) -> f32 {
        // False for NaN.
        if !(x >= self.low && x <= self.high) {
            return 0.0;
        }
        let t = standardised(x, self.location, self.scale);
        representable(match self.form {
            Form::End { upper, odds, .. } => {
                let (end, t) = if upper {
                    (self.high, t)
                } else {
                    (self.low, negative(t))
                };
                let along = standardised(x, end, self.scale);
                let along = if upper { along } else { negative(along) };
                let ratio = (1.0 + odds) / (1.0 + T::exp(t.0));
                let square = ratio * ratio;
                // The larger product first would overflow, the smaller one underflow.
                if self.peak < 1.0e30 {
                    decayed::<T>(self.peak * square, along)
                } else {
                    decayed::<T>(self.peak, along) * square
                }
            }
            Form::Middle { .. } => Logistic::<T>::density(self.peak, t),
        })
    }
}

impl<T: Tier> Invert for TruncatedLogistic<T> {
    #[inline]
    fn invert(&self, x: f32) -> f32 {
        let x = clamp(x, self.low, self.high);
        into_unit(match self.form {
            Form::End {
                upper,
                odds,
                part,
                length,
                ..
            } => {
                let along = if upper { self.high - x } else { x - self.low };
                let t = along / self.scale;
                let before = if t < STRAIGHT {
                    along / length
                } else {
                    let both = (1.0 + odds * T::exp(-t)) * part;
                    -T::exp_m1(-t) * (1.0 + odds) / both
                };
                if upper { 1.0 - before } else { before }
            }
            Form::Middle { low, between, .. } => {
                let below = Logistic::<T>::cdf((x - self.location) / self.scale);
                (below - low[0]) / between
            }
        })
    }
}
