//! Ziggurats: normal and exponential numbers, mostly from one word, one table entry and one product.
//!
//! Here lives the try. The layers are in `ziggurat/layers.rs`, the two laws and what is public in files of their
//! own.
//!
//! The area under a curve that falls from 0 on is covered by 256 layers of equal area: rectangles from 0 to where
//! the curve is at their lower side, and below them all a last one with the curve's tail. A try chooses a layer and a
//! place in it from disjoint bits of one word. Nearly always the place is under the curve whatever the height, and
//! is the number. Otherwise it is beyond the upper side's end: in the lowest layer that is the tail, which another
//! two words sample by inversion, so that no try of it fails; elsewhere a second word is the height, which decides.

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

/// A law whose curve has been cut into layers.
trait Law {
    /// Its layers, in flash.
    fn layers() -> &'static Layers;
    /// The place in a layer as an odd number of 2⁻²⁴ of its width, from the bits of a word above the first 8.
    fn place(word: u32) -> i32;
    /// How far the curve at x is above that at a width, relative to the latter; 0 ≤ x < width.
    fn excess(width: f32, x: f32) -> f32;
    /// The number at a full-resolution uniform, the smaller the farther out, on the side of `x`.
    fn tail(u: f32, x: f32) -> f32;
}

/// What one word decides: the layer, the number, and whether the number stands.
#[inline]
fn glance<L: Law>(word: u32) -> (usize, f32, bool) {
    let index = (word & 0xff) as usize;
    let place = L::place(word);
    // There are as many layers as bytes, so that the compiler leaves out what else there could be.
    let outside = Layer {
        inner: 0,
        scale: 0.0,
    };
    let Layer { inner, scale } = *L::layers().layers.get(index).unwrap_or(&outside);
    // At most one less than the magnitude, which is odd and the bound even.
    let magnitude = (place ^ (place >> 31)) as u32;
    // The integer is exact, having 24 bits.
    (index, place as f32 * scale, magnitude < inner)
}

/// A try whose first word is known; the others are drawn if they are needed.
#[inline]
fn attempt<L: Law, E>(word: u32, next: impl FnMut() -> Result<u32, E>) -> Result<Option<f32>, E> {
    match glance::<L>(word) {
        (_, x, true) => Ok(Some(x)),
        (index, x, false) => beyond::<L, E>(index, x, next),
    }
}

/// A number in the tail, or one that its height decides on.
fn beyond<L: Law, E>(
    index: usize,
    x: f32,
    mut next: impl FnMut() -> Result<u32, E>,
) -> Result<Option<f32>, E> {
    let word = next()?;
    if index == 0 {
        return Ok(Some(L::tail(open_full(word, next()?).get(), x)));
    }
    let width = |index: usize| {
        // Past the last layer is the peak.
        let layer = L::layers().layers.get(index);
        // Exact: the quotient by a power of 2 was.
        layer.map_or(0.0, |layer| layer.scale * 16_777_216.0)
    };
    // Heights above the layer's lower side, relative to that: the curve's here, and the layer's.
    let outer = width(index);
    let [curve, whole] = [x.abs(), width(index.wrapping_add(1))].map(|x| L::excess(outer, x));
    Ok(happens(curve / whole, word).then_some(x))
}

/// A try with three words of one's own.
fn attempt_at<L: Law>([word, second, third]: [u32; 3]) -> Option<f32> {
    let mut rest = [second, third].into_iter();
    let next = || Ok::<_, Infallible>(rest.next().unwrap_or(third));
    match attempt::<L, _>(word, next) {
        Ok(point) => point,
        Err(never) => match never {},
    }
}

/// A try with the words of a generator.
#[inline]
fn try_once<L: Law, R: TryRng + ?Sized>(rng: &mut R) -> Result<Option<f32>, Failure<R::Error>> {
    let word = rng.try_next_u32().map_err(Failure::Generator)?;
    attempt::<L, _>(word, || rng.try_next_u32()).map_err(Failure::Generator)
}

/// Tries within a budget, which is not 0. What 98 calls of 100 need is inlined, and all else is not.
#[inline]
fn try_draw<L: Law, R: TryRng + ?Sized>(
    budget: u32,
    rng: &mut R,
) -> Result<Accepted<f32>, Failure<R::Error>> {
    let word = rng.try_next_u32().map_err(Failure::Generator)?;
    match glance::<L>(word) {
        (_, point, true) => Ok(Accepted { point, tries: 1 }),
        (index, x, false) => try_on::<L, R>(index, x, budget, rng),
    }
}

/// The rest of a try that one word has not decided, and further tries.
#[cold]
#[inline(never)]
fn try_on<L: Law, R: TryRng + ?Sized>(
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

/// What the public samplers have in common: `$placed` is their number, made of the standard one `$x`.
macro_rules! ziggurat {
    ($name:ident: $law:ty, |$sampler:ident, $x:ident| $placed:expr) => {
        impl $name {
            /// One try with three words of one's own; `None` if the number is rejected.
            ///
            /// The first word is nearly always all that counts. The second decides on a place beyond the inner part of
            /// its layer; second and third are the uniform of a tail.
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
