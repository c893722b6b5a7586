//! Rejection of the points outside a region, which a predicate describes.

use super::{DEFAULT_BUDGET, Failure, Rejection, with_budget};
use crate::warp::Warp;
use rand_core::TryRng;

/// The points of a warp for which a predicate holds: uniform on a region where the warp is uniform.
///
/// # Density
/// That of the warp over the efficiency.
///
/// # Domain
/// - Point: that of the warp, where the predicate holds. The predicate sees the point exactly as it is returned.
/// - Words a try: those of the warp.
///
/// # Accuracy
/// That of the warp. Rejection adds no error.
///
/// # Cost
/// Efficiency: the probability that the warp gives to the region. For a uniform warp it is the measure of the region over
/// that of the domain.
///
/// # Examples
/// ```
/// use microwarp::warp::Aabb;
/// use microwarp::rejection::{Region, Rejection};
/// use rand_pcg::Pcg32;
/// // Uniform on a ring inside its box; the ring covers 59 % of it.
/// let ring = Region::new(
///     Aabb::new([-1.0, -1.0], [1.0, 1.0])?,
///     |[x, y]: [f32; 2]| (0.25..=1.0).contains(&(x * x + y * y)),
/// );
/// let [x, y] = ring.draw(&mut Pcg32::new(1, 1))?.point;
/// assert!(x * x + y * y >= 0.25);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// `?` does not turn the [`Failure`] of a draw into the error of a constructor: a function that has both returns a
/// `Box<dyn Error>`, or maps them as the [example](Failure#examples) does.
///
/// # See also
/// - [`Bounded`](super::Bounded) accepts with a probability instead of a predicate.
/// - [`warp::Aabb`](crate::warp::Aabb), the usual proposal.
/// - [`DiskRejection`](super::DiskRejection) and [`BallRejection`](super::BallRejection) are ready-made.
///
/// # Source
/// J. von Neumann, "Various Techniques Used in Connection with Random Digits", National Bureau of Standards Applied
/// Mathematics Series 12, 1951.
#[doc(alias = "rejection_sampling")]
#[doc(alias = "predicate")]
#[doc(alias = "filter")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Region<W, P> {
    domain: W,
    predicate: P,
    budget: u32,
}

impl<W, P> Region<W, P>
where
    W: Warp,
    P: Fn(W::Point) -> bool,
{
    /// Samples the part of `domain` in which `predicate` holds, with the budget [`DEFAULT_BUDGET`].
    pub const fn new(domain: W, predicate: P) -> Self {
        Self {
            domain,
            predicate,
            budget: DEFAULT_BUDGET,
        }
    }

    with_budget!();

    /// The warp that proposes points.
    pub const fn domain(&self) -> &W {
        &self.domain
    }

    /// One try with the given uniforms; `None` if the point lies outside the region.
    #[must_use]
    #[inline]
    pub fn attempt(&self, u: W::Uniforms) -> Option<W::Point> {
        self.inside(self.domain.sample(u))
    }

    #[inline]
    fn inside(&self, point: W::Point) -> Option<W::Point> {
        (self.predicate)(point).then_some(point)
    }
}

impl<W, P> Rejection for Region<W, P>
where
    W: Warp,
    P: Fn(W::Point) -> bool,
{
    type Point = W::Point;

    #[inline]
    fn budget(&self) -> u32 {
        self.budget
    }

    #[inline]
    fn try_once<R: TryRng + ?Sized>(
        &self,
        rng: &mut R,
    ) -> Result<Option<W::Point>, Failure<R::Error>> {
        let point = self.domain.try_draw(rng).map_err(Failure::Generator)?;
        Ok(self.inside(point))
    }
}
