//! Warps of two uniforms: sampling, drawing and filling from one map.

use super::Warp;
use super::fill::BLOCK;
use crate::num::{VECTORS, into_unit};
use crate::uniform::{Canonical, Uniforms, grid_from_word};
use rand_core::TryRng;

/// The items of [`Warp`] for a [`PlanarMap`] into so many dimensions, except `pdf`. Where the condition
/// fails, points are drawn one by one. `with its density` is for a map with a [`put`](PlanarMap::put) of its own.
macro_rules! planar {
    ($dimensions:literal, with its density, where $vectors:expr) => {
        $crate::warp::planar::planar!($dimensions, where $vectors);

        #[inline]
        fn sample_canonical_with_pdf(
            &self,
            u: $crate::uniform::Canonical<[f32; 2]>,
        ) -> (Self::Point, f32) {
            $crate::warp::planar::sample_with_pdf(self, u)
        }

        #[inline]
        fn try_draw_with_pdf<R: rand_core::TryRng + ?Sized>(
            &self,
            rng: &mut R,
        ) -> Result<(Self::Point, f32), R::Error> {
            $crate::warp::planar::draw_with_pdf(self, rng)
        }

        #[inline]
        fn map_with_pdf(
            &self,
            uniforms: &[[f32; 2]],
            points: &mut [Self::Point],
            densities: &mut [f32],
        ) {
            $crate::warp::planar::map_with_pdf(self, uniforms, points, densities, $vectors);
        }
    };
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
            $crate::warp::planar::put_words(self, words, &mut point);
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
    /// The part of the map that depends on u₁ only. Override it if it is a long chain of dependent operations.
    #[inline]
    fn first(&self, u1: f32) -> f32 {
        u1
    }

    /// The same from the word that u₁ is drawn from.
    #[inline]
    fn first_of_word(&self, word: u32) -> f32 {
        self.first(Self::uniform_of_word(word))
    }

    /// The uniform that a word stands for.
    #[inline]
    fn uniform_of_word(word: u32) -> f32 {
        grid_from_word(word)
    }

    /// The point of two uniforms in [0, 1), of which [`first`](PlanarMap::first) has been applied to u₁.
    fn map_to(&self, first: f32, u2: f32, to: &mut [f32; D]);

    /// The same point, and its density. What it shares with the map is computed once, and a density that is known to be in
    /// the domain needs no test, so that a loop of it has no branch.
    #[inline]
    fn put(&self, first: f32, u2: f32, to: &mut [f32; D]) -> f32
    where
        Self: Warp<Point = [f32; D], Density = f32>,
    {
        self.map_to(first, u2, to);
        self.pdf(*to)
    }
}

/// [`Warp::sample_canonical`] of such a map.
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

/// [`Warp::sample_canonical_with_pdf`] of such a map.
#[inline]
pub(super) fn sample_with_pdf<const D: usize, W>(
    warp: &W,
    u: Canonical<[f32; 2]>,
) -> ([f32; D], f32)
where
    W: PlanarMap<D> + Warp<Point = [f32; D], Density = f32>,
{
    let [u1, u2] = u.get();
    let mut point = [0.0; D];
    let density = warp.put(warp.first(u1), u2, &mut point);
    (point, density)
}

/// [`Warp::try_draw_with_pdf`] of such a map.
#[inline]
pub(super) fn draw_with_pdf<const D: usize, W, R>(
    warp: &W,
    rng: &mut R,
) -> Result<([f32; D], f32), R::Error>
where
    W: PlanarMap<D> + Warp<Point = [f32; D], Density = f32>,
    R: TryRng + ?Sized,
{
    let [a, b] = <[f32; 2]>::try_words(rng)?;
    let mut point = [0.0; D];
    let density = warp.put(warp.first_of_word(a), W::uniform_of_word(b), &mut point);
    Ok((point, density))
}

/// [`Warp::sample_words`] of such a map, in place.
#[inline]
pub(crate) fn put_words<const D: usize, W: PlanarMap<D>>(
    warp: &W,
    [a, b]: [u32; 2],
    to: &mut [f32; D],
) {
    warp.map_to(warp.first_of_word(a), W::uniform_of_word(b), to);
}

/// So many points that what a block costs beside them does not show.
const MAPPED: usize = 64;

/// [`Warp::map`] of such a map, in blocks where the processor and the tier have vectors.
#[inline]
pub(super) fn map<const D: usize, W: PlanarMap<D>>(
    warp: &W,
    uniforms: &[[f32; 2]],
    points: &mut [[f32; D]],
    vectors: bool,
) {
    let blocks = VECTORS && vectors;
    let count = if blocks { MAPPED } else { usize::MAX };
    let mut block = Block::new();
    for (uniforms, points) in uniforms.chunks(count).zip(points.chunks_mut(count)) {
        if let (true, Ok(uniforms), Ok(points)) = (
            blocks,
            uniforms.try_into(),
            <&mut [[f32; D]; MAPPED]>::try_from(&mut *points),
        ) {
            block.map(warp, uniforms, points, |_, a, b, to| warp.map_to(a, b, to));
        } else {
            for (point, &[u1, u2]) in points.iter_mut().zip(uniforms) {
                warp.map_to(warp.first(into_unit(u1)), into_unit(u2), point);
            }
        }
    }
}

/// [`Warp::map_with_pdf`] of such a map, in blocks likewise.
#[inline]
pub(super) fn map_with_pdf<const D: usize, W>(
    warp: &W,
    uniforms: &[[f32; 2]],
    points: &mut [[f32; D]],
    densities: &mut [f32],
    vectors: bool,
) where
    W: PlanarMap<D> + Warp<Point = [f32; D], Density = f32>,
{
    let blocks = VECTORS && vectors;
    let count = if blocks { MAPPED } else { usize::MAX };
    let mut block = Block::new();
    let places = points.chunks_mut(count).zip(densities.chunks_mut(count));
    for (uniforms, (points, densities)) in uniforms.chunks(count).zip(places) {
        if let (true, Ok(uniforms), Ok(points), Ok(densities)) = (
            blocks,
            uniforms.try_into(),
            <&mut [[f32; D]; MAPPED]>::try_from(&mut *points),
            <&mut [f32; MAPPED]>::try_from(&mut *densities),
        ) {
            block.map(warp, uniforms, points, |i, a, b, to| {
                let density = warp.put(a, b, to);
                if let Some(place) = densities.get_mut(i) {
                    *place = density;
                }
            });
        } else {
            for ((point, density), &[u1, u2]) in points.iter_mut().zip(densities).zip(uniforms) {
                *density = warp.put(warp.first(into_unit(u1)), into_unit(u2), point);
            }
        }
    }
}

/// A block of points on its way.
///
/// It takes several loops of few steps each, so that the processor works on several vectors at once. Each coordinate
/// lies in an array of its own meanwhile, so that vectors are shuffled in the first and the last loop only.
struct Block<const D: usize> {
    first: [f32; MAPPED],
    second: [f32; MAPPED],
    columns: [[f32; MAPPED]; D],
}

impl<const D: usize> Block<D> {
    const fn new() -> Self {
        Self {
            first: [0.0; MAPPED],
            second: [0.0; MAPPED],
            columns: [[0.0; MAPPED]; D],
        }
    }

    /// The points of a block of uniforms, each put by a function of its place in the block.
    #[inline]
    fn map<W: PlanarMap<D>>(
        &mut self,
        warp: &W,
        uniforms: &[[f32; 2]; MAPPED],
        points: &mut [[f32; D]; MAPPED],
        mut put: impl FnMut(usize, f32, f32, &mut [f32; D]),
    ) {
        for ((a, b), &[u1, u2]) in self.first.iter_mut().zip(&mut self.second).zip(uniforms) {
            (*a, *b) = (into_unit(u1), into_unit(u2));
        }
        for a in &mut self.first {
            *a = warp.first(*a);
        }
        for (i, (&a, &b)) in self.first.iter().zip(&self.second).enumerate() {
            let mut point = [0.0; D];
            put(i, a, b, &mut point);
            for (column, x) in self.columns.iter_mut().zip(point) {
                if let Some(place) = column.get_mut(i) {
                    *place = x;
                }
            }
        }
        for (i, point) in points.iter_mut().enumerate() {
            for (x, column) in point.iter_mut().zip(&self.columns) {
                if let Some(&value) = column.get(i) {
                    *x = value;
                }
            }
        }
    }
}

/// [`Warp::try_fill`] of such a map, several points at a time.
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
            let (u1, u2) = (W::uniform_of_word(a), W::uniform_of_word(b));
            warp.map_to(warp.first(u1), u2, point);
        }
        drawn?;
    }
    for point in blocks.into_remainder() {
        put_words(warp, <[f32; 2]>::try_words(rng)?, point);
    }
    Ok(())
}
