//! Ziggurats: normal and exponential numbers, mostly from one word, one table entry and one product.
//!
//! Here lives the try. `ziggurat/layers.rs` has the layers; each distribution and its public samplers have a file.
//!
//! The curve falls from 0 on. 256 layers of equal area cover the area under it: rectangles that reach from 0 to where the
//! curve meets their lower side, and a lowest layer that includes the tail. A try takes a layer and a place in it from
//! disjoint bits of one word. Nearly always the place is under the curve at every height of the layer, and is the number.
//! Otherwise it lies beyond the end of the upper side. In the lowest layer that is the tail: two more words sample it by
//! inversion, so that no such try fails. In other layers a second word is the height, which decides.

mod exponential;
mod layers;
mod normal;

pub use self::exponential::{ZigguratExponential, ZigguratStandardExponential};
pub use self::normal::{ZigguratNormal, ZigguratStandardNormal};

use self::layers::{Layer, Layers};
use super::{Accepted, Failure};
use crate::num::happens;
use crate::uniform::open_full;
use core::convert::Infallible;
use rand_core::TryRng;

/// A distribution whose curve is cut into layers.
trait Distribution {
    /// The layers, in flash.
    fn layers() -> &'static Layers;
    /// The place in a layer as an odd number of 2⁻²⁴ of its width, from the bits of a word above the first 8.
    fn place(word: u32) -> i32;
    /// The height of the curve at x above that at `width`, relative to the latter; 0 ≤ x < width.
    fn excess(width: f32, x: f32) -> f32;
    /// The number in the tail on the side of `x`, from a uniform of full resolution: a smaller one lies farther out.
    fn tail(u: f32, x: f32) -> f32;
}

/// What the first word decides: the layer, the number, and whether that is accepted.
#[inline]
fn glance<L: Distribution>(word: u32) -> (usize, f32, bool) {
    let index = (word & 0xff) as usize;
    let place = L::place(word);
    // There are as many layers as values of a byte, so the compiler drops this case.
    let outside = Layer {
        inner: 0,
        scale: 0.0,
    };
    let Layer { inner, scale } = *L::layers().layers.get(index).unwrap_or(&outside);
    // At most one less than the magnitude; that is odd and the bound even, so the comparison is exact.
    let magnitude = (place ^ (place >> 31)) as u32;
    // The integer is exact, having 24 bits.
    (index, place as f32 * scale, magnitude < inner)
}

/// A try whose first word is known. The others are drawn only if needed.
#[inline]
fn attempt<L: Distribution, E>(
    word: u32,
    next: impl FnMut() -> Result<u32, E>,
) -> Result<Option<f32>, E> {
    match glance::<L>(word) {
        (_, x, true) => Ok(Some(x)),
        (index, x, false) => beyond::<L, E>(index, x, next),
    }
}

/// A number in the tail, or one accepted by its height.
fn beyond<L: Distribution, E>(
    index: usize,
    x: f32,
    mut next: impl FnMut() -> Result<u32, E>,
) -> Result<Option<f32>, E> {
    let word = next()?;
    if index == 0 {
        return Ok(Some(L::tail(open_full(word, next()?).get(), x)));
    }
    let width = |index: usize| {
        // The width at the peak, past the last layer, is 0.
        let layer = L::layers().layers.get(index);
        // Exact, as a product with a power of 2.
        layer.map_or(0.0, |layer| layer.scale * 16_777_216.0)
    };
    // Heights of the curve here, and of the layer, both above the layer's lower side and relative to it.
    let outer = width(index);
    let [curve, whole] = [x.abs(), width(index.wrapping_add(1))].map(|x| L::excess(outer, x));
    Ok(happens(curve / whole, word).then_some(x))
}

/// A try with three given words.
fn attempt_at<L: Distribution>([word, second, third]: [u32; 3]) -> Option<f32> {
    let mut rest = [second, third].into_iter();
    let next = || Ok::<_, Infallible>(rest.next().unwrap_or(third));
    match attempt::<L, _>(word, next) {
        Ok(point) => point,
        Err(never) => match never {},
    }
}

/// A try with the words of a generator.
#[inline]
fn try_once<L: Distribution, R: TryRng + ?Sized>(
    rng: &mut R,
) -> Result<Option<f32>, Failure<R::Error>> {
    let word = rng.try_next_u32().map_err(Failure::Generator)?;
    attempt::<L, _>(word, || rng.try_next_u32()).map_err(Failure::Generator)
}

/// Tries within a budget above 0. Only the part that 98 calls of 100 need is inlined.
#[inline]
fn try_draw<L: Distribution, R: TryRng + ?Sized>(
    budget: u32,
    rng: &mut R,
) -> Result<Accepted<f32>, Failure<R::Error>> {
    let word = rng.try_next_u32().map_err(Failure::Generator)?;
    match glance::<L>(word) {
        (_, point, true) => Ok(Accepted { point, tries: 1 }),
        (index, x, false) => try_on::<L, R>(index, x, budget, rng),
    }
}

/// The rest of a try that its first word did not decide, and further tries.
#[cold]
#[inline(never)]
fn try_on<L: Distribution, R: TryRng + ?Sized>(
    index: usize,
    x: f32,
    budget: u32,
    rng: &mut R,
) -> Result<Accepted<f32>, Failure<R::Error>> {
    let (mut index, mut x, mut tries) = (index, x, 1_u32);
    loop {
        let decided = beyond::<L, _>(index, x, || rng.try_next_u32());
        if let Some(point) = decided.map_err(Failure::Generator)? {
            return Ok(Accepted { point, tries });
        }
        if tries >= budget {
            return Err(Failure::BudgetSpent { tries });
        }
        tries = tries.wrapping_add(1);
        let word = rng.try_next_u32().map_err(Failure::Generator)?;
        let inside;
        (index, x, inside) = glance::<L>(word);
        if inside {
            return Ok(Accepted { point: x, tries });
        }
    }
}

/// What the public samplers have in common. `$placed` makes their number of the standard number `$x`.
macro_rules! ziggurat {
    ($name:ident: $law:ty, |$sampler:ident, $x:ident| $placed:expr) => {
        impl $name {
            /// One try with three given words; `None` if the number is rejected.
            ///
            /// Nearly always only the first word counts. The second decides about a place beyond the inner part of its
            /// layer. The second and the third are the uniform of a tail.
            #[must_use]
            pub fn attempt(&self, words: [u32; 3]) -> Option<f32> {
                let $sampler = self;
                attempt_at::<$law>(words).map(|$x| $placed)
            }
        }

        impl Rejection for $name {
            type Point = f32;

            #[inline]
            fn budget(&self) -> u32 {
                self.budget
            }

            #[inline]
            fn try_once<R: TryRng + ?Sized>(
                &self,
                rng: &mut R,
            ) -> Result<Option<f32>, Failure<R::Error>> {
                let $sampler = self;
                Ok(try_once::<$law, R>(rng)?.map(|$x| $placed))
            }

            #[inline]
            fn try_draw<R: TryRng + ?Sized>(
                &self,
                rng: &mut R,
            ) -> Result<Accepted<f32>, Failure<R::Error>> {
                let $sampler = self;
                let Accepted { point: $x, tries } = try_draw::<$law, R>(self.budget, rng)?;
                Ok(Accepted {
                    point: $placed,
                    tries,
                })
            }
        }
    };
}
use ziggurat;
