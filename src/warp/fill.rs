//! Filling a slice with several points at a time, where processors have vectors.

use super::Warp;
use crate::uniform::{Canonical, Uniforms, grid_from_word};
use rand_core::TryRng;

/// [`Warp::try_fill`] of a warp whose `try_draw` is the one provided; with `of placed` of one that is a [`Place`]. Where
/// the condition fails, points are drawn one by one: a tier whose functions no compiler turns into vectors gains
/// nothing.
macro_rules! filled_in_blocks {
    ($(where $vectors:expr)?) => {
        $crate::warp::filled_in_blocks!(by in_blocks $(where $vectors)?);
    };
    (of placed where $vectors:expr) => {
        $crate::warp::filled_in_blocks!(by placed_in_blocks where $vectors);
    };
    (by $fill:ident $(where $vectors:expr)?) => {
        #[inline]
        fn try_fill<R: rand_core::TryRng + ?Sized>(
            &self,
            rng: &mut R,
            points: &mut [Self::Point],
        ) -> Result<(), R::Error> {
            $(if !$vectors {
                return crate::warp::fill::one_by_one(self, rng, points);
            })?
            crate::warp::fill::$fill(self, rng, points)
        }
    };
}
pub(crate) use filled_in_blocks;

/// [`Warp::try_fill`] as it is provided.
#[inline]
pub(super) fn one_by_one<W: Warp, R: TryRng + ?Sized>(
    warp: &W,
    rng: &mut R,
    points: &mut [W::Point],
) -> Result<(), R::Error> {
    for point in points {
        *point = warp.try_draw(rng)?;
    }
    Ok(())
}

/// How many points are worked out together: few, so that the words of the next are drawn meanwhile. One where
/// processors have no vectors, and a loop over several would only cost memory.
const BLOCK: usize = if cfg!(any(
    target_arch = "x86_64",
    target_arch = "aarch64",
    target_feature = "simd128"
)) {
    8
} else {
    1
};

/// Draws the words of a block before it makes its points, so that no point waits for a generator and the compiler
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

/// A map of two uniforms that puts its point where it is wanted.
///
/// Two `f32` in an array are passed and returned as one integer, and a loop that takes them out of it and puts them
/// together again works with vectors half as long.
pub(crate) trait Place<const D: usize> {
    /// The point of two uniforms in [0, 1).
    fn place(&self, u1: f32, u2: f32, to: &mut [f32; D]);
}

/// [`Warp::sample_canonical`] of such a map.
#[inline]
pub(crate) fn placed<const D: usize, W: Place<D>>(warp: &W, u: Canonical<[f32; 2]>) -> [f32; D] {
    let [u1, u2] = u.get();
    let mut point = [0.0; D];
    warp.place(u1, u2, &mut point);
    point
}

/// [`in_blocks`] for such a map.
#[inline]
pub(super) fn placed_in_blocks<const D: usize, W, R>(
    warp: &W,
    rng: &mut R,
    points: &mut [[f32; D]],
) -> Result<(), R::Error>
where
    W: Place<D>,
    R: TryRng + ?Sized,
{
    let mut blocks = points.chunks_exact_mut(BLOCK);
    for block in &mut blocks {
        let (mut first, mut second) = ([0; BLOCK], [0; BLOCK]);
        let mut good = 0..;
        let drawn = first.iter_mut().zip(&mut second).try_for_each(|(a, b)| {
            *a = rng.try_next_u32()?;
            *b = rng.try_next_u32()?;
            good.next();
            Ok(())
        });
        let words = block.iter_mut().zip(first.into_iter().zip(second));
        let count = drawn.as_ref().map_or(good.start, |()| BLOCK);
        for (point, (a, b)) in words.take(count) {
            warp.place(grid_from_word(a), grid_from_word(b), point);
        }
        drawn?;
    }
    for point in blocks.into_remainder() {
        let [a, b] = <[f32; 2]>::try_words(rng)?;
        warp.place(grid_from_word(a), grid_from_word(b), point);
    }
    Ok(())
}
