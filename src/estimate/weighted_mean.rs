//! A weighted mean, for weights of unknown sum.

use super::sum::{Scale, Sum};
use super::tally::Tally;
use crate::num::saturated;
use crate::tier::sqrt;

/// The weighted mean Σwf/Σw with its standard error: the ratio estimator, for weights of unknown sum.
///
/// It estimates E\[wf\]/E\[w\]; [`Integral`](super::Integral) of w·f would need E\[w\]. It is biased but consistent: to
/// first order its bias is (R V\[w\] − Cov\[w, wf\])/(N E\[w\]²), where R is the ratio. The bias falls as 1/N, faster than
/// the standard error's 1/√N. A constant f gives exactly that constant, whatever the weights, so it suits pixel filters.
/// For samples of density p, give weights w/p.
///
/// # Domain
///
/// - Finite values and weights; both may be negative. Other samples are refused and counted in [`WeightedMean::refused`].
///   A sample of weight 0 only adds to the count.
/// - Up to 2⁶⁴ − 1 samples, as for [`Moments`](super::Moments).
/// - [`None`] while the weights sum to 0 (in a sum of 47 bits); for the error, also for fewer than two samples. No result is
///   infinite. With positive weights the mean lies between the smallest and the largest value, up to rounding.
///
/// # Accuracy
///
/// The largest relative errors found, plus a tenth: in runs of 10⁸ samples whose values have a mean of 1000 standard
/// deviations, and in many short runs of all magnitudes with positive weights within six powers of ten; for those plus three
/// tenths of what a search of minutes found. In short runs the ratio's error is relative to the larger of ratio and
/// weighted standard deviation.
///
/// | error | 10⁸ samples, one by one | 10⁸ samples, merged | short runs | kind |
/// |---|--:|--:|--:|---|
/// | ratio | 3.4e-8 | 3.4e-8 | 4.3e-7 | found |
/// | standard error | 1.6e-7 | 1.6e-7 | 5.5e-7 | found |
///
/// The standard error is that of the delta method: √(N/(N−1) Σw²(f−R)²)/|Σw|. Its error is stated for values whose weighted
/// standard deviation is at least 10⁻⁶ of the largest; where they differ in their last bits alone, it loses digits, and may
/// come out as 0.
///
/// # Examples
///
/// ```
/// use microwarp::estimate::WeightedMean;
/// let mut pixel = WeightedMean::new();
/// pixel.push(2.0, 0.25);
/// pixel.push(4.0, 0.75);
/// assert_eq!(pixel.mean(), Some(3.5));
/// ```
///
/// # See also
///
/// - [`Moments`](super::Moments), without weights.
/// - [`Integral`](super::Integral), where the density is normalised.
///
/// # Source
///
/// W. G. Cochran, "Sampling Techniques", 3rd edition, 1977, chapter 6.
#[doc(alias = "pixel_filter")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct WeightedMean {
    tally: Tally,
    value_scale: Scale,
    weight_scale: Scale,
    /// A value near the ratio, K. Everything below is on the scales.
    centre: f32,
    /// Σw.
    weights: Sum,
    /// Σw(f − K).
    products: Sum,
    /// Σw².
    weight_squares: Sum,
    /// Σw·w(f − K).
    mixed: Sum,
    /// Σ(w(f − K))².
    product_squares: Sum,
}

impl Default for WeightedMean {
    #[inline]
    fn default() -> Self {
        Self::new()
    }
}

impl WeightedMean {
    /// No samples yet.
    #[must_use]
    #[inline]
    pub const fn new() -> Self {
        Self {
            tally: Tally::NOTHING,
            value_scale: Scale::FINEST,
            weight_scale: Scale::FINEST,
            centre: 0.0,
            weights: Sum::ZERO,
            products: Sum::ZERO,
            weight_squares: Sum::ZERO,
            mixed: Sum::ZERO,
            product_squares: Sum::ZERO,
        }
    }

    /// Takes in one sample; refuses NaN and infinity.
    #[inline]
    pub fn push(&mut self, value: f32, weight: f32) {
        let sound = value.is_finite() && weight.is_finite();
        if self.tally.admits(sound) && weight != 0.0 {
            self.add(value, weight);
        }
    }

    #[inline]
    fn add(&mut self, value: f32, weight: f32) {
        if !self.value_scale.holds(value) || !self.weight_scale.holds(weight) {
            self.rescale(
                self.value_scale.joined(Scale::of(value)),
                self.weight_scale.joined(Scale::of(weight)),
            );
        }
        let value = self.value_scale.apply(value);
        let weight = self.weight_scale.apply(weight);
        let weights = self.weights.plus(weight);
        // The centre moves before the sample is added: one that outweighs all others would leave nothing of
        // their squares, and is itself the centre then, so that none of its digits is lost.
        if weight.abs() >= self.weights.value().abs() {
            self.move_centre(value);
        } else if !weights.in_binade_of(self.weights) {
            let products = self.products.plus(weight * (value - self.centre));
            self.recentre(products, weights);
        }
        let product = weight * (value - self.centre);
        self.weights = weights;
        self.products = self.products.plus(product);
        self.weight_squares = self.weight_squares.plus(weight * weight);
        self.mixed = self.mixed.plus(weight * product);
        self.product_squares = self.product_squares.plus(product * product);
    }

    /// Takes in all samples of another run.
    pub fn merge(&mut self, other: &Self) {
        let tally = match self.tally.joined(other.tally) {
            Ok(tally) => tally,
            Err(full) => {
                self.tally = full;
                return;
            }
        };
        let value_scale = self.value_scale.joined(other.value_scale);
        let weight_scale = self.weight_scale.joined(other.weight_scale);
        let (mut heavier, mut lighter) = (*self, *other);
        heavier.rescale(value_scale, weight_scale);
        lighter.rescale(value_scale, weight_scale);
        let reversed = heavier.weights.value().abs() < lighter.weights.value().abs();
        if heavier.is_blank() || (reversed && !lighter.is_blank()) {
            core::mem::swap(&mut heavier, &mut lighter);
        }
        let weights = heavier.weights;
        lighter.move_centre(heavier.centre);
        heavier.weights = weights.join(lighter.weights);
        heavier.products = heavier.products.join(lighter.products);
        heavier.weight_squares = heavier.weight_squares.join(lighter.weight_squares);
        heavier.mixed = heavier.mixed.join(lighter.mixed);
        heavier.product_squares = heavier.product_squares.join(lighter.product_squares);
        if !heavier.weights.in_binade_of(weights) {
            heavier.recentre(heavier.products, heavier.weights);
        }
        heavier.tally = tally;
        *self = heavier;
    }

    /// How many samples were taken in.
    #[must_use]
    #[inline]
    pub const fn count(&self) -> u64 {
        self.tally.count()
    }

    /// How many samples were refused because the value or the weight was NaN or infinite.
    #[must_use]
    #[inline]
    pub const fn refused(&self) -> u64 {
        self.tally.refused()
    }

    /// The weighted mean Σwf/Σw, or [`None`] while the weights sum to 0, as they do without samples.
    #[must_use]
    #[inline]
    pub fn mean(&self) -> Option<f32> {
        Some(self.value_scale.undo(self.centre + self.distance()?))
    }

    /// The standard error of the mean by the delta method, or [`None`] for fewer than two samples and while the weights sum
    /// to 0.
    #[must_use]
    #[inline]
    pub fn standard_error(&self) -> Option<f32> {
        // First move to the f32 nearest the ratio with all digits of the sums, then apply the rest as a correction:
        // where one weight outweighs the others, what they add is far below what is taken off.
        let mut about = *self;
        about.move_centre(self.centre + self.distance()?);
        let distance = about.distance()?;
        // Σ(w(f − R))², R being a distance from K.
        let squares = about
            .product_squares
            .plus(-distance * (2.0 * about.mixed.value() - distance * about.weight_squares.value()))
            .value();
        // What has overflowed to NaN stays so, and comes out as the largest number.
        let squares = if squares < 0.0 { 0.0 } else { squares };
        let count = self.count() as f32;
        let correction = count / self.count().saturating_sub(1) as f32;
        let error = sqrt(correction * squares) / self.weights.value().abs();
        (self.count() > 1).then(|| self.value_scale.undo(error))
    }

    /// Whether every weight so far was 0.
    #[inline]
    fn is_blank(&self) -> bool {
        // The square of the largest weight is above 2⁻⁴⁷ on its scale.
        self.weight_squares.value() == 0.0
    }

    /// The difference of the ratio from the centre, unless the weights sum to 0.
    #[inline]
    fn distance(&self) -> Option<f32> {
        let weights = self.weights.value();
        (weights != 0.0).then(|| saturated(self.products.value() / weights))
    }

    /// Moves the centre to the ratio of these two sums.
    #[cold]
    fn recentre(&mut self, products: Sum, weights: Sum) {
        let centre = self.centre + products.value() / weights.value();
        // Weights of both signs may put the ratio far outside the values, and the next one back.
        if centre.abs() < 4.0 {
            self.move_centre(centre);
        }
    }

    /// Changes the centre as if all differences had been taken from it.
    fn move_centre(&mut self, centre: f32) {
        let step = centre - self.centre;
        // Σ(w(d − s))² = Σ(wd)² − s(Σw·wd + Σw·w(d − s))
        let mixed = self.mixed.plus_multiple(self.weight_squares, -step);
        self.product_squares = self
            .product_squares
            .plus_multiple(self.mixed, -step)
            .plus_multiple(mixed, -step);
        self.mixed = mixed;
        self.products = self.products.plus_multiple(self.weights, -step);
        self.centre = centre;
    }

    #[cold]
    fn rescale(&mut self, value_scale: Scale, weight_scale: Scale) {
        let value = self.value_scale.shrinking_to(value_scale);
        let weight = self.weight_scale.shrinking_to(weight_scale);
        self.value_scale = value_scale;
        self.weight_scale = weight_scale;
        self.centre *= value;
        self.weights = self.weights.scaled(weight);
        self.products = self.products.scaled(weight).scaled(value);
        self.weight_squares = self.weight_squares.scaled(weight).scaled(weight);
        self.mixed = self.mixed.scaled(weight).scaled(weight).scaled(value);
        let squares = self.product_squares.scaled(weight).scaled(weight);
        self.product_squares = squares.scaled(value).scaled(value);
    }
}
