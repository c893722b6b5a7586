//! Warps of two uniforms: sampling, drawing and filling from one map.

use super::fill::BLOCK;
use crate::num::{VECTORS, into_unit};
use crate::uniform::{Canonical, Uniforms, grid_from_word};
use rand_core::TryRng;

/// The items of [`Warp`](super::Warp) for a [`PlanarMap`] into so many dimensions, except `pdf`. Where the condition
/// fails, points are drawn one by one.
macro_rules! planar {
    ($dimensions:literal, where $vectors:expr) => {
        type Uniforms = [f32; 2];
        type Point = [f32; $dimensions];
        type Density = f32;

        #[inline]
        fn sample_canonical(&self, u: $crate::uniform::Canonical<[f32; 2]>) -> Self::Point {
            $crate::warp::planar::sample(self, u)
        }

        #[inline]
        fn sample_words(
            &self,
            words: <Self::Uniforms as $crate::uniform::Uniforms>::Words,
        ) -> Self::Point {
            let mut point = [0.0; $dimensions];
            $crate::warp::planar::put(self, words, &mut point);
            point
        }

        $crate::warp::filled_in_blocks!(by $crate::warp::planar::in_blocks, where $vectors);

        #[inline]
        fn map(&self, uniforms: &[[f32; 2]], points: &mut [Self::Point]) {
            $crate::warp::planar::map(self, uniforms, points, $vectors);
        }
    };
}
pub(super) use planar;

/// A map of two uniforms, which writes its point in place.
///
/// Rust passes and returns an array of two `f32` as one integer. A loop that takes them apart and joins them again works
/// with vectors half as long.
pub(crate) trait PlanarMap<const D: usize> {
    /// What the map makes of u₁ alone before anything else, where that takes many steps one after the other.
    #[inline]
    fn first(&self, u1: f32) -> f32 {
        u1
    }

    /// The same from the word that u₁ is drawn from.
    #[inline]
    fn first_of_word(&self, word: u32) -> f32 {
        self.first(grid_from_word(word))
    }

    /// The point of two uniforms in [0, 1), of which [`first`](PlanarMap::first) has been applied to u₁.
    fn map_to(&self, first: f32, u2: f32, to: &mut [f32; D]);
}

/// [`Warp::sample_canonical`](super::Warp::sample_canonical) of such a map.
#[inline]
pub(crate) fn sample<const D: usize, W: PlanarMap<D>>(
    warp: &W,
    u: Canonical<[f32; 2]>,
) -> [f32; D] {
    let [u1, u2] = u.get();
    let mut point = [0.0; D];
    warp.map_to(warp.first(u1), u2, &mut point);
    point
}

/// [`Warp::sample_words`](super::Warp::sample_words) of such a map, in place.
#[inline]
pub(crate) fn put<const D: usize, W: PlanarMap<D>>(warp: &W, [a, b]: [u32; 2], to: &mut [f32; D]) {
    warp.map_to(warp.first_of_word(a), grid_from_word(b), to);
}

/// [`Warp::map`](super::Warp::map) of such a map, in blocks where the processor and the tier have vectors.
#[inline]
pub(super) fn map<const D: usize, W: PlanarMap<D>>(
    warp: &W,
    uniforms: &[[f32; 2]],
    points: &mut [[f32; D]],
    vectors: bool,
) {
    let count = uniforms.len().min(points.len());
    let (Some(uniforms), Some(points)) = (uniforms.get(..count), points.get_mut(..count)) else {
        return;
    };
    let (uniforms, points) = if VECTORS && vectors {
        map_blocks(warp, uniforms, points)
    } else {
        (uniforms, points)
    };
    for (point, &[u1, u2]) in points.iter_mut().zip(uniforms) {
        warp.map_to(warp.first(into_unit(u1)), into_unit(u2), point);
    }
}

/// The points of whole blocks, and what is left of slices of one length.
///
/// A block takes several loops of few steps each, so that the processor works on several vectors at once. Each coordinate
/// lies in an array of its own meanwhile, so that vectors are shuffled in the first and the last loop only.
#[inline]
fn map_blocks<'a, const D: usize, W: PlanarMap<D>>(
    warp: &W,
    uniforms: &'a [[f32; 2]],
    points: &'a mut [[f32; D]],
) -> (&'a [[f32; 2]], &'a mut [[f32; D]]) {
    /// So many points that what a block costs beside them does not show.
    const MAPPED: usize = 64;
    let (mut first, mut second, mut columns) = ([0.0; MAPPED], [0.0; MAPPED], [[0.0; MAPPED]; D]);
    let blocks = uniforms.chunks_exact(MAPPED);
    let rest = blocks.remainder();
    let mut places = points.chunks_exact_mut(MAPPED);
    for (uniforms, points) in blocks.zip(&mut places) {
        for ((a, b), &[u1, u2]) in first.iter_mut().zip(&mut second).zip(uniforms) {
            (*a, *b) = (into_unit(u1), into_unit(u2));
        }
        for a in &mut first {
            *a = warp.first(*a);
        }
        for (i, (&a, &b)) in first.iter().zip(&second).enumerate() {
            let mut point = [0.0; D];
            warp.map_to(a, b, &mut point);
            for (column, x) in columns.iter_mut().zip(point) {
                if let Some(place) = column.get_mut(i) {
                    *place = x;
                }
            }
        }
        for (i, point) in points.iter_mut().enumerate() {
            for (x, column) in point.iter_mut().zip(&columns) {
                if let Some(&value) = column.get(i) {
                    *x = value;
                }
            }
        }
    }
    (rest, places.into_remainder())
}

/// [`Warp::try_fill`](super::Warp::try_fill) of such a map, several points at a time.
#[inline]
pub(super) fn in_blocks<const D: usize, W, R>(
    warp: &W,
    rng: &mut R,
    points: &mut [[f32; D]],
) -> Result<(), R::Error>
where
    W: PlanarMap<D>,
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
            warp.map_to(warp.first(grid_from_word(a)), grid_from_word(b), point);
        }
        drawn?;
    }
    for point in blocks.into_remainder() {
        put(warp, <[f32; 2]>::try_words(rng)?, point);
    }
    Ok(())
}
