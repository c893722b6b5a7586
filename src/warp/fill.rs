//! Filling a slice several points at a time, for processors with vectors.

use super::Warp;
use crate::num::VECTORS;
use crate::uniform::Uniforms;
use rand_core::TryRng;

/// [`Warp::try_fill`] in blocks, for a warp with the default `try_draw`. Where the condition fails, points are drawn one
/// by one: a tier whose functions no compiler vectorises gains nothing. `by` names another way to fill blocks.
macro_rules! filled_in_blocks {
    ($(where $vectors:expr)?) => {
        $crate::warp::filled_in_blocks!(by $crate::warp::fill::in_blocks $(, where $vectors)?);
    };
    (by $in_blocks:path $(, where $vectors:expr)?) => {
        #[inline]
        fn try_fill<R: rand_core::TryRng + ?Sized>(
            &self,
            rng: &mut R,
            points: &mut [Self::Point],
        ) -> Result<(), R::Error> {
            $(if !$vectors {
                return $crate::warp::one_by_one(self, rng, points);
            })?
            $in_blocks(self, rng, points)
        }
    };
}
pub(crate) use filled_in_blocks;

/// How many points are computed together: few, so that the processor draws the next words meanwhile. One for processors
/// without vectors, where a block would only cost memory.
pub(super) const BLOCK: usize = if VECTORS { 8 } else { 1 };

/// Draws the words of a block before it computes the points, so that no point waits for the generator and the compiler
/// sees that they are independent.
#[inline]
pub(super) fn in_blocks<W: Warp, R: TryRng + ?Sized>(
    warp: &W,
    rng: &mut R,
    points: &mut [W::Point],
) -> Result<(), R::Error> {
    let mut blocks = points.chunks_exact_mut(BLOCK);
    for block in &mut blocks {
        let mut words = [W::Uniforms::try_words(rng)?; BLOCK];
        for (good, next) in (1..).zip(words.iter_mut().skip(1)) {
            match W::Uniforms::try_words(rng) {
                Ok(drawn) => *next = drawn,
                Err(error) => {
                    map(warp, block.iter_mut().zip(words).take(good));
                    return Err(error);
                }
            }
        }
        map(warp, block.iter_mut().zip(words));
    }
    for point in blocks.into_remainder() {
        *point = warp.try_draw(rng)?;
    }
    Ok(())
}

/// The points of words already drawn.
#[inline]
fn map<'a, W: Warp + 'a>(
    warp: &W,
    places: impl Iterator<Item = (&'a mut W::Point, <W::Uniforms as Uniforms>::Words)>,
) {
    for (point, words) in places {
        *point = warp.sample_words(words);
    }
}
