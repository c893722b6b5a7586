//! Mutations whose steps can be made longer or shorter.

use super::{
    BoxStep, Coordinates, LogUniformStep, NormalStep, OneCoordinate, RandomWalk, Subset,
    WrappedWalk,
};
use crate::num::{SMALLEST, clamp};
use crate::tier::Tier;

/// A mutation, or a distribution of steps, whose steps have a scale. [`Tuning`](super::Tuning) finds it.
///
/// A step of 0 stays 0. All others stay positive, and within the range that the constructor accepts: the scale is cut there.
///
/// # Examples
///
/// ```
/// use microwarp::metropolis::{BoxStep, Scalable};
/// let step = BoxStep::new([0.5, 0.0, 2e38])?;
/// assert_eq!(step.scaled(4.0).widths(), [2.0, 0.0, f32::MAX]);
/// # Ok::<(), microwarp::Error>(())
/// ```
#[diagnostic::on_unimplemented(
    message = "the steps of `{Self}` have no scale",
    note = "of a mixture, tune the small step alone, and mix it in afterwards"
)]
pub trait Scalable {
    /// The same with steps this many times as long. The factor is positive and finite; any other counts as 1.
    #[must_use]
    fn scaled(&self, factor: f32) -> Self;
}

/// A width, multiplied by a factor; what is positive stays so, and at most `largest`.
fn times(width: f32, factor: f32, largest: f32) -> f32 {
    let sound = factor > 0.0 && factor <= f32::MAX;
    if sound && width > 0.0 {
        clamp(width * factor, SMALLEST, largest)
    } else {
        width
    }
}

fn all_times<X: Coordinates>(mut widths: X, factor: f32, largest: f32) -> X {
    for width in widths.as_mut_slice() {
        *width = times(*width, factor, largest);
    }
    widths
}

impl<X: Coordinates> Scalable for BoxStep<X> {
    #[inline]
    fn scaled(&self, factor: f32) -> Self {
        Self::new(all_times(self.widths(), factor, f32::MAX)).unwrap_or(*self)
    }
}

impl<X: Coordinates, T: Tier> Scalable for NormalStep<X, T> {
    #[inline]
    fn scaled(&self, factor: f32) -> Self {
        Self::new(all_times(self.std_devs(), factor, 6e37)).unwrap_or(*self)
    }
}

impl<T: Tier> Scalable for LogUniformStep<T> {
    #[inline]
    fn scaled(&self, factor: f32) -> Self {
        let [smallest, largest] =
            [self.smallest(), self.largest()].map(|size| times(size, factor, f32::MAX));
        Self::new(smallest, largest).unwrap_or(*self)
    }
}

impl<L: Scalable> Scalable for RandomWalk<L> {
    #[inline]
    fn scaled(&self, factor: f32) -> Self {
        Self::new(self.law().scaled(factor))
    }
}

impl<L: Scalable> Scalable for WrappedWalk<L> {
    #[inline]
    fn scaled(&self, factor: f32) -> Self {
        Self::new(self.law().scaled(factor))
    }
}

impl<M: Scalable> Scalable for OneCoordinate<M> {
    #[inline]
    fn scaled(&self, factor: f32) -> Self {
        Self::new(self.mutation().scaled(factor))
    }
}

impl<M: Scalable + Copy, const K: usize, const D: usize> Scalable for Subset<M, K, D> {
    #[inline]
    fn scaled(&self, factor: f32) -> Self {
        Self::new(self.mutation().scaled(factor), *self.axes()).unwrap_or(*self)
    }
}
