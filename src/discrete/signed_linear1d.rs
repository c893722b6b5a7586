//! A function of either sign that is linear between equally spaced points, sampled by its size, with signed weights.

use super::PiecewiseLinear1d;
use super::word::Word;
use crate::error::{Error, tried};
use crate::num::{Scaled, quick_two_sum, two_sum};
use crate::uniform::{Uniforms, infallible};
use rand_core::{Rng, TryRng};

/// A function f of either sign, linear between equally spaced vertices: points in proportion to |f|, each with the weight by which
/// means become those under f. A pixel filter with negative lobes, sampled.
///
/// [`filter`](super::filter) has the vertices of the usual pixel filters. Take a sampler for each axis: the weight of a place is the
/// product of both.
///
/// # Weights
/// w = f(x)/(p(x) ∫f), with the probabilities p that the table realises, has the mean 1 exactly, and the mean of w·g(x) is
/// ∫f·g/∫f, both but for rounding. Where f has one sign over a cell, w is ±S but for the words of the table, S = ∫|f|/∫f; in cells
/// in which the sign changes it lies between. No other sampler of points has weights of a smaller variance.
///
/// The variance is S² − 1 on a line and S⁴ − 1 in a square, **of a constant picture too**: 0 for a filter that is nowhere
/// negative, 0.31 for Mitchell's, 2.4 for Lanczos'. A sum divided by the number of samples has this noise. Divide by the sum of the
/// weights ([`WeightedMean`](crate::estimate::WeightedMean), which is right in the limit and not on average), or take a filter that
/// is nowhere negative.
///
/// # Domain
/// - Vertices: at least two numbers of any sign, of which not all are 0. Their sizes are the weights of a
///   [`PiecewiseLinear1d`], with its domain, points and probabilities. ∫f is at least 2⁻²⁰ ∫|f|.
/// - Uniforms: one; points increase with it. A draw takes one `u32` of the generator.
/// - Outside of the bounds, and where f is 0 over a cell, the weight is 0.
///
/// # Accuracy
/// Weights are right to 3e-7 of themselves in cells without a change of sign, and in others to 3e-7 S and what one ulp of the larger
/// bound makes of them.
///
/// # Cost
/// 12 bytes a vertex. A draw with its weight, from 65 vertices of Lanczos' filter, PCG32 included, takes
/// <!-- figure: point signed_linear_1d_65_pcg32 -->225 instructions and 1,408 bytes of code on an M4F, 6,488 instructions on an M0<!-- -->.
///
/// # Examples
/// ```
/// use microwarp::discrete::{SignedLinear1d, filter};
/// use microwarp::constant;
/// use microwarp::estimate::WeightedMean;
/// use rand_pcg::Pcg32;
///
/// // Mitchell's filter, two pixels wide on each side of the middle.
/// const FILTER: SignedLinear1d<33> = constant!(SignedLinear1d::new(&filter::mitchell(1.0 / 3.0, 1.0 / 3.0), -2.0, 2.0));
/// let (mut rng, mut pixel) = (Pcg32::new(7, 7), WeightedMean::new());
/// for _ in 0..64 {
///     let [(x, across), (y, down)] = [FILTER.draw(&mut rng), FILTER.draw(&mut rng)];
///     let light = 0.5 + 0.1 * (x + y); // of the place (x, y), from the middle of the pixel
///     pixel.push(light, across * down);
/// }
/// assert!((pixel.mean().unwrap_or(0.0) - 0.5).abs() < 0.05);
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// # See also
/// - [`PiecewiseLinear1d`]: a density, without signs.
/// - [`Tent`](crate::warp::Tent): the filter of linear interpolation.
///
/// # Source
/// M. Ernst, M. Stamminger, G. Greiner, "Filter Importance Sampling", 2006, <https://doi.org/10.1109/RT.2006.280223>.
#[doc(alias = "filter_importance_sampling")]
#[doc(alias = "reconstruction_filter")]
#[doc(alias = "negative")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SignedLinear1d<const N: usize> {
    sizes: PiecewiseLinear1d<[u32; N], [f32; N]>,
    /// The vertices times a power of two, such that the largest is from 1 to 2.
    vertices: [f32; N],
    /// The sum over the cells of the vertices at both ends.
    sum: f32,
}

/// 2⁻²⁰.
const LEAST: f32 = 1.0 / 1_048_576.0;

impl<const N: usize> SignedLinear1d<N> {
    /// The values of the function at equally spaced points from `low` to `high`.
    ///
    /// # Errors
    /// Those of [`PiecewiseLinear1d::new`] for the sizes; [`Error::NotNormalizable`] where ∫f is negative, or below 2⁻²⁰ ∫|f|.
    pub const fn new(vertices: &[f32; N], low: f32, high: f32) -> Result<Self, Error> {
        let mut sizes = *vertices;
        let mut largest = 0.0;
        let mut rest: &mut [f32] = &mut sizes;
        while let [first, others @ ..] = rest {
            *first = first.abs();
            if *first > largest {
                largest = *first;
            }
            rest = others;
        }
        let sizes = tried!(PiecewiseLinear1d::new(&sizes, low, high));
        let down = Scaled::of(largest).parts().1.wrapping_neg();
        let mut scaled = *vertices;
        let mut rest: &mut [f32] = &mut scaled;
        let (mut sum, mut sum_of_sizes, mut before) = ((0.0, 0.0), 0.0, None);
        while let [first, others @ ..] = rest {
            if *first != 0.0 {
                *first = Scaled::of(first.abs())
                    .raised(down)
                    .value()
                    .copysign(*first);
            }
            if let Some(before) = before {
                let (head, dropped) = two_sum(sum.0, before);
                let (head, dropped_too) = two_sum(head, *first);
                sum = quick_two_sum(head, sum.1 + (dropped + dropped_too));
                sum_of_sizes += first.abs() + f32::abs(before);
            }
            before = Some(*first);
            rest = others;
        }
        if sum.0 < LEAST * sum_of_sizes {
            return Err(Error::NotNormalizable(0));
        }
        Ok(Self {
            sizes,
            vertices: scaled,
            sum: sum.0,
        })
    }

    /// The sampler of points, whose density is in proportion to |f|.
    #[must_use]
    #[inline]
    pub const fn sizes(&self) -> &PiecewiseLinear1d<[u32; N], [f32; N]> {
        &self.sizes
    }

    /// The weight of a point.
    #[must_use]
    pub fn weight(&self, x: f32) -> f32 {
        match self.sizes.cells().cell_at(x) {
            Some(index) => self.weight_in(index, x),
            None => 0.0,
        }
    }

    /// The weight of a point of a cell.
    #[inline]
    fn weight_in(&self, index: usize, x: f32) -> f32 {
        let Some(mass) = self.sizes.cells().mass(index) else {
            return 0.0;
        };
        let vertex = |index: usize| self.vertices.get(index).copied().unwrap_or(0.0);
        let (a, b) = (vertex(index), vertex(index.wrapping_add(1)));
        let sign = if a >= 0.0 && b >= 0.0 {
            1.0
        } else if a <= 0.0 && b <= 0.0 {
            -1.0
        } else {
            let (below, above) = self.sizes.cells().cells().parts(index, x);
            let (a, b) = (above * a, below * b);
            (a + b) / (a.abs() + b.abs())
        };
        sign * (a.abs() + b.abs()) / (mass * self.sum)
    }

    /// The point of a uniform, and its weight.
    #[must_use]
    #[inline]
    pub fn sample(&self, u: f32) -> (f32, f32) {
        self.with_weight(u32::from_uniform(u.canonical()))
    }

    /// The point of a word, and what lies below it, with the weight: its cell need not be found again.
    #[inline]
    fn with_weight(&self, place: (u32, f32)) -> (f32, f32) {
        let (index, x) = self.sizes.cell_and_place(place);
        (x, self.weight_in(index, x))
    }

    /// Draws a point and its weight from a generator that can fail.
    ///
    /// # Errors
    /// The generator's own error.
    #[inline]
    pub fn try_draw<R: TryRng + ?Sized>(&self, rng: &mut R) -> Result<(f32, f32), R::Error> {
        Ok(self.with_weight((u32::try_draw(rng)?, 0.0)))
    }

    /// Draws a point and its weight.
    #[inline]
    pub fn draw<R: Rng + ?Sized>(&self, rng: &mut R) -> (f32, f32) {
        infallible(self.try_draw(rng))
    }
}
