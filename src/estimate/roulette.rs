//! Russian roulette: what goes on is weighed by the chance with which it really does.

use crate::uniform::Chance;

/// Russian roulette: whether what has this chance goes on, and by what to multiply it then. `None` ends it.
///
/// The weight is the inverse of the chance that words of 32 bits realise, so that the mean stays what it was.
///
/// # Domain
/// - Uniforms: one word, which decides as that of a [`Chance`] does.
/// - The chance: any `f32`. From 1 up everything goes on with weight 1. NaN and what is not above 0 ends everything, and
///   so does a throughput that has become NaN.
/// - Weights: from 1 to 2³².
///
/// # Accuracy
/// The chance is ⌈2³²p⌉ of 2³² words, exactly p from 2⁻⁹ up. Chance times weight is 1 to 6e-8, for the weight is
/// rounded once. With the weight 1/p it would be off by up to 2.3e-5 at p = 1e-5, and by 5.9e-3 with a decision by
/// `grid(rng) < p`.
///
/// # Examples
/// ```
/// use microwarp::estimate::roulette;
/// use rand_pcg::{Pcg32, rand_core::Rng};
/// assert_eq!(roulette(0.25, 0), Some(4.0));
/// assert_eq!(roulette(0.25, 1 << 30), None);
/// // A path whose light may end after each bounce.
/// let (mut rng, mut throughput) = (Pcg32::new(42, 54), 1.0_f32);
/// for _ in 0..8 {
///     throughput *= 0.7;
///     let Some(weight) = roulette(throughput.min(0.95), rng.next_u32()) else { break };
///     throughput *= weight;
/// }
/// ```
///
/// # See also
/// - [`Chance`], for a chance that stays, with its [`weight`](Chance::weight).
///
/// # Source
/// J. Arvo, D. Kirk, "Particle Transport and Image Synthesis", 1990, <https://doi.org/10.1145/97879.97886>.
#[doc(alias = "russian_roulette")]
#[doc(alias = "termination")]
#[must_use]
#[inline]
pub fn roulette(chance: f32, word: u32) -> Option<f32> {
    if chance >= 1.0 {
        return Some(1.0);
    }
    let chance = Chance::new(chance).ok()?;
    chance.accepts(word).then(|| chance.weight())
}
