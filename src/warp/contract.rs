//! What a warp is: sample, density, drawing; and the inverse beside it.

use crate::uniform::{Canonical, Uniforms, infallible};
use rand_core::{Rng, TryRng};

/// A map from uniforms to a point, with the density of that point and the inverse map.
///
/// The three belong together: `pdf(sample(u))` is the density with which `sample` realises the point,
/// and `invert(sample(u))` is `u` again, both within the bounds stated at each warp.
///
/// To write a warp of one's own, give the three types and the three required functions;
/// [`Inversion`] does it from closures.
///
/// ```
/// use microwarp::{Warp, poly as mw};
/// use rand_pcg::Pcg32;
///
/// let disk = mw::Disk::new();
/// let point = disk.sample([0.25, 0.5]);        // from uniforms of one's own
/// let again = disk.draw(&mut Pcg32::new(1, 1)); // from a generator
/// assert!((disk.pdf(point) - 1.0 / core::f32::consts::PI).abs() < 1e-7);
/// # let _ = again;
/// ```
pub trait Warp {
    /// The uniforms one sample takes; how many is part of the type.
    type Uniforms: Uniforms;
    /// The point: `f32` on the line, `[f32; 2]` in the plane, `[f32; 3]` for directions.
    type Point: Copy;
    /// The type of a density, `f32` in the float tiers.
    type Density: Copy;

    /// The point of uniforms that are known to lie in [0, 1).
    #[must_use]
    fn sample_canonical(&self, u: Canonical<Self::Uniforms>) -> Self::Point;

    /// The density at `x` with respect to length, area or solid angle; 0 outside the domain and for
    /// NaN. Never 0 at a point that `sample` returned.
    #[must_use]
    fn pdf(&self, x: Self::Point) -> Self::Density;

    /// The point of any uniforms whatever: they are brought into [0, 1) by the rule of
    /// [`Uniforms::canonical`] first.
    #[must_use]
    #[inline]
    fn sample(&self, u: Self::Uniforms) -> Self::Point {
        self.sample_canonical(u.canonical())
    }

    /// The point of the words that its uniforms are drawn from: what drawing gives, and filling.
    ///
    /// That is the sample of the grid's uniforms, unless the domain is open at an end or the density vanishes there.
    /// Such a warp counts a word as the middle of the uniforms that it stands for, so that no draw lies beyond its share
    /// of the tail.
    #[must_use]
    #[inline]
    fn sample_words(&self, words: <Self::Uniforms as Uniforms>::Words) -> Self::Point {
        self.sample_canonical(Self::Uniforms::from_words(words))
    }

    /// The point of uniforms that are known to lie in [0, 1), and its density, from what the sampler knows.
    ///
    /// As it is provided, this is [`sample_canonical`](Self::sample_canonical) and [`pdf`](Self::pdf) of its point. A
    /// warp that gets a sharper or a cheaper density from the uniforms overrides it, together with
    /// [`try_draw_with_pdf`](Self::try_draw_with_pdf), and states the error as *pdf with the sample*.
    #[must_use]
    #[inline]
    fn sample_canonical_with_pdf(
        &self,
        u: Canonical<Self::Uniforms>,
    ) -> (Self::Point, Self::Density) {
        let point = self.sample_canonical(u);
        (point, self.pdf(point))
    }

    /// The point of any uniforms, as [`sample`](Self::sample) gives it, and its density.
    ///
    /// The density belongs to the uniforms, `pdf` to the rounded point. Multiple importance sampling may mix the two:
    /// they agree to the sum of the errors stated as *pdf with the sample* and *realised density*, and are the same
    /// number where a warp states no *pdf with the sample*.
    ///
    /// ```
    /// use microwarp::{Warp, poly as mw};
    /// let fog = mw::HenyeyGreenstein::new(0.9)?;
    /// let (direction, density) = fog.sample_with_pdf([0.5, 0.25]);
    /// assert_eq!(direction, fog.sample([0.5, 0.25]));
    /// assert!((density / fog.pdf(direction) - 1.0).abs() < 2e-6);
    /// # Ok::<(), microwarp::Error>(())
    /// ```
    #[must_use]
    #[inline]
    fn sample_with_pdf(&self, u: Self::Uniforms) -> (Self::Point, Self::Density) {
        self.sample_canonical_with_pdf(u.canonical())
    }

    /// Draws one point: one `u32` of the generator for each uniform, unless the warp says otherwise.
    ///
    /// # Errors
    /// The generator's own error; nothing is drawn then.
    // x86-64 converts an integer into a part of a register and waits for what was there before, unless the
    // compiler clears it, which it does in a loop and not in a function that it calls from one.
    #[allow(
        clippy::inline_always,
        reason = "as said above, on this processor alone"
    )]
    #[cfg_attr(target_arch = "x86_64", inline(always))]
    #[cfg_attr(not(target_arch = "x86_64"), inline)]
    fn try_draw<R: TryRng + ?Sized>(&self, rng: &mut R) -> Result<Self::Point, R::Error>
    where
        Self: Sized,
    {
        Ok(self.sample_words(Self::Uniforms::try_words(rng)?))
    }

    /// Draws one point from a generator that cannot fail.
    #[inline]
    fn draw<R: Rng + ?Sized>(&self, rng: &mut R) -> Self::Point
    where
        Self: Sized,
    {
        infallible(self.try_draw(rng))
    }

    /// Draws one point, as [`try_draw`](Self::try_draw) does, and hands over its density.
    ///
    /// # Errors
    /// The generator's own error; nothing is drawn then.
    #[inline]
    fn try_draw_with_pdf<R: TryRng + ?Sized>(
        &self,
        rng: &mut R,
    ) -> Result<(Self::Point, Self::Density), R::Error>
    where
        Self: Sized,
    {
        let point = self.try_draw(rng)?;
        Ok((point, self.pdf(point)))
    }

    /// Draws one point and its density from a generator that cannot fail.
    #[inline]
    fn draw_with_pdf<R: Rng + ?Sized>(&self, rng: &mut R) -> (Self::Point, Self::Density)
    where
        Self: Sized,
    {
        infallible(self.try_draw_with_pdf(rng))
    }

    /// Fills a slice with points, in order.
    ///
    /// # Errors
    /// The generator's own error; the points before the failing one are in place, the rest of the
    /// slice is untouched.
    #[inline]
    fn try_fill<R: TryRng + ?Sized>(
        &self,
        rng: &mut R,
        points: &mut [Self::Point],
    ) -> Result<(), R::Error>
    where
        Self: Sized,
    {
        one_by_one(self, rng, points)
    }

    /// Fills a slice with points from a generator that cannot fail.
    #[inline]
    fn fill<R: Rng + ?Sized>(&self, rng: &mut R, points: &mut [Self::Point])
    where
        Self: Sized,
    {
        infallible(self.try_fill(rng, points));
    }

    /// Fills a slice with points and their densities, in order, from a generator that cannot fail.
    #[inline]
    fn fill_with_pdf<R: Rng + ?Sized>(
        &self,
        rng: &mut R,
        points: &mut [(Self::Point, Self::Density)],
    ) where
        Self: Sized,
    {
        for point in points {
            *point = self.draw_with_pdf(rng);
        }
    }
}

/// The inverse of a warp: the uniforms of a point.
///
/// Every warp of this crate has one. A warp of yours needs it only where something asks for it, such as the `invert`
/// of a [`Transform`](crate::warp::Transform) around it.
pub trait Invert: Warp {
    /// The uniforms in [0, 1) whose sample is `x`. For a point outside the domain, the uniforms of some
    /// point inside it.
    #[must_use]
    fn invert(&self, x: Self::Point) -> Self::Uniforms;
}

/// [`Warp::try_fill`] as it is provided.
#[inline]
pub(crate) fn one_by_one<W: Warp, R: TryRng + ?Sized>(
    warp: &W,
    rng: &mut R,
    points: &mut [W::Point],
) -> Result<(), R::Error> {
    for point in points {
        *point = warp.try_draw(rng)?;
    }
    Ok(())
}

/// [`Warp::try_draw_with_pdf`] of a warp that overrides [`Warp::sample_canonical_with_pdf`] and draws from the grid.
macro_rules! drawn_with_pdf {
    () => {
        #[inline]
        fn try_draw_with_pdf<R: rand_core::TryRng + ?Sized>(
            &self,
            rng: &mut R,
        ) -> Result<(Self::Point, Self::Density), R::Error> {
            let words = <Self::Uniforms as $crate::uniform::Uniforms>::try_words(rng)?;
            Ok(self.sample_canonical_with_pdf(
                <Self::Uniforms as $crate::uniform::Uniforms>::from_words(words),
            ))
        }
    };
}
pub(crate) use drawn_with_pdf;

/// A reference to a warp is a warp, so that compositions can borrow.
impl<W: Warp> Warp for &W {
    type Uniforms = W::Uniforms;
    type Point = W::Point;
    type Density = W::Density;

    #[inline]
    fn sample_canonical(&self, u: Canonical<Self::Uniforms>) -> Self::Point {
        (**self).sample_canonical(u)
    }

    #[inline]
    fn pdf(&self, x: Self::Point) -> Self::Density {
        (**self).pdf(x)
    }

    #[inline]
    fn sample_words(&self, words: <Self::Uniforms as Uniforms>::Words) -> Self::Point {
        (**self).sample_words(words)
    }

    #[inline]
    fn try_draw<R: TryRng + ?Sized>(&self, rng: &mut R) -> Result<Self::Point, R::Error> {
        (**self).try_draw(rng)
    }

    #[inline]
    fn sample_canonical_with_pdf(
        &self,
        u: Canonical<Self::Uniforms>,
    ) -> (Self::Point, Self::Density) {
        (**self).sample_canonical_with_pdf(u)
    }

    #[inline]
    fn try_draw_with_pdf<R: TryRng + ?Sized>(
        &self,
        rng: &mut R,
    ) -> Result<(Self::Point, Self::Density), R::Error> {
        (**self).try_draw_with_pdf(rng)
    }

    #[inline]
    fn try_fill<R: TryRng + ?Sized>(
        &self,
        rng: &mut R,
        points: &mut [Self::Point],
    ) -> Result<(), R::Error> {
        (**self).try_fill(rng, points)
    }
}

impl<W: Invert> Invert for &W {
    #[inline]
    fn invert(&self, x: Self::Point) -> Self::Uniforms {
        (**self).invert(x)
    }
}
