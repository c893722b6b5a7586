//! A warp restricted to a region, given by a predicate.

use super::{DEFAULT_BUDGET, Failure, Rejection, with_budget};
use crate::warp::Warp;
use rand_core::TryRng;

/// The points of a warp for which a predicate holds: uniform on the region where the warp is uniform.
///
/// - Uniforms: those of the warp, a try. Words a try: what drawing the warp takes.
/// - Range: that of the warp, where the predicate holds. The predicate sees the point as it is returned.
/// - Density: that of the warp over the efficiency.
/// - Efficiency: the integral of the warp's density over the region; for a uniform warp the measure of the
///   region over that of the domain.
/// - Errors: those of the warp; rejection adds none.
///
/// Source: J. von Neumann, "Various Techniques Used in Connection with Random Digits", 1951.
///
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
    /// The part of `domain` in which `predicate` holds, with the budget [`DEFAULT_BUDGET`].
    pub const fn new(domain: W, predicate: P) -> Self {
        Self {
            domain,
            predicate,
            budget: DEFAULT_BUDGET,
        }
    }

    with_budget!();

    /// The warp whose points are kept or not.
    pub const fn domain(&self) -> &W {
        &self.domain
    }

    /// One try with uniforms of one's own; `None` if the point lies outside the region.
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
