//! Primary sample space: a chain over the uniforms of a warp.

use crate::warp::Warp;

/// The density that a warp's uniforms need for its points to have the density `f`: f/p at the point.
///
/// With it, a chain in the unit cube drives a warp: its states are the warp's uniforms. The closer p is to f, the flatter
/// the chain's target. If f/p overflows `f32`, the state is refused.
///
/// To drive several warps, one after the other, write a closure that splits the uniforms and multiplies the densities, as
/// in the second half of the example.
///
/// # Examples
///
/// ```
/// use microwarp::metropolis::{Chain, LogUniformStep, Mixture, WrappedWalk, primary_density};
/// use microwarp::{Warp, poly as mw};
/// use rand_pcg::Pcg32;
///
/// // A lobe, and before it a bar that lets nothing pass.
/// let lobe = mw::PhongLobe::new(20.0)?;
/// let seen = move |w: [f32; 3]| if w[0].abs() < 0.02 { 0.0 } else { lobe.pdf(w) };
/// let target = primary_density(lobe, seen);
///
/// let small = WrappedWalk::new(mw::LogUniformStep::new(1.0 / 1024.0, 1.0 / 64.0)?);
/// let mutation = Mixture::large_small(0.1, small)?;
/// let mut rng = Pcg32::new(1, 1);
/// let mut chain = Chain::new([0.5, 0.3], target)?;
/// for _ in 0..1000 {
///     let uniforms = chain.step(target, &mutation, &mut rng).state();
///     assert!(lobe.sample(uniforms)[0].abs() >= 0.02);
/// }
///
/// // A path: a point of a lens, then a direction.
/// let lens = mw::Disk::new();
/// let f = |p: [f32; 2], w: [f32; 3]| p[0] * p[0] * w[2];
/// let path = |[a, b, c, d]: [f32; 4]| {
///     let (p, w) = (lens.sample([a, b]), lobe.sample([c, d]));
///     f(p, w) / (lens.pdf(p) * lobe.pdf(w))
/// };
/// let mut chain = Chain::new([0.5, 0.3, 0.5, 0.3], path)?;
/// chain.step(path, &mutation, &mut rng);
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// # See also
///
/// - [`LargeSmall`](super::LargeSmall), the usual mutation for it.
///
/// # Source
///
/// C. Kelemen, L. Szirmay-Kalos, G. Antal, F. Csonka, "A Simple and Robust Mutation Strategy for the Metropolis Light
/// Transport Algorithm", 2002, [doi:10.1111/1467-8659.t01-1-00703](https://doi.org/10.1111/1467-8659.t01-1-00703).
#[doc(alias = "primary_sample_space")]
#[inline]
pub fn primary_density<W, F>(warp: W, f: F) -> impl Fn(W::Uniforms) -> f32 + Copy
where
    W: Warp<Density = f32> + Copy,
    F: Fn(W::Point) -> f32 + Copy,
{
    move |uniforms| {
        let point = warp.sample(uniforms);
        f(point) / warp.pdf(point)
    }
}
