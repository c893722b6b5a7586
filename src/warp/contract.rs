//! The traits of warps: sampling, density and drawing; and the inverse.

use crate::uniform::{Canonical, Uniforms, infallible};
use rand_core::{Rng, TryRng};

/// A map from uniforms to a point, with the density of that point.
///
/// The two belong together: `pdf(sample(u))` is the density with which `sample` produces the point, within the bounds
/// that each warp states. Every warp of this crate has an inverse too, by the trait [`Invert`].
///
/// # Drawing from a generator
/// [`sample`](Warp::sample) takes uniforms. [`draw`](Warp::draw) takes a generator, and [`fill`](Warp::fill) fills a
/// slice from one. Both take every generator of `rand_core` 0.10, and a closure by
/// [`FromFn`](crate::uniform::FromFn). The page [`generators`](crate::generators) adapts those of older versions.
/// [`try_draw`](Warp::try_draw) and [`try_fill`](Warp::try_fill) pass on the error of a generator that can fail.
///
/// ```
/// use microwarp::{Warp, poly as mw};
/// use rand_pcg::Pcg32;
///
/// let disk = mw::Disk::new();
/// let point = disk.sample([0.25, 0.5]); // from explicit uniforms
/// assert!((disk.pdf(point) - 1.0 / core::f32::consts::PI).abs() < 1e-7);
///
/// let mut rng = Pcg32::new(1, 1);
/// let [x, y] = disk.draw(&mut rng); // from a generator
/// assert!(x * x + y * y <= 1.0);
/// ```
///
/// The crate does not depend on `rand`, so `rng.sample(warp)` does not compile. Where other code asks for rand's
/// `Distribution`, wrap the warp:
///
/// ```
/// use microwarp::{Warp, poly as mw};
/// use rand_distr::Distribution; // the same as `rand::distr::Distribution`
///
/// struct Draw<W>(W);
/// impl<W: Warp> Distribution<W::Point> for Draw<W> {
///     fn sample<R: rand_core::Rng + ?Sized>(&self, rng: &mut R) -> W::Point { self.0.draw(rng) }
/// }
///
/// let noise = Draw(mw::Normal::new(0.0, 1.0)?);
/// let number: f32 = noise.sample(&mut rand_pcg::Pcg32::new(1, 1));
/// assert!(number.abs() < 6.5);
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// # Your own warp
/// Give the three types, [`sample_canonical`](Warp::sample_canonical) and [`pdf`](Warp::pdf); the rest follows. The
/// inverse is a trait of its own, needed only where something asks for it. For a density on the line,
/// [`Inversion`](crate::warp::Inversion) makes a warp from closures, and [`Transform`](crate::warp::Transform) puts a
/// map after another warp.
#[doc(alias = "distribution")]
#[doc(alias = "sampler")]
#[doc(alias = "rng")]
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a warp",
    label = "a warp is expected here",
    note = "if this is the `Result` of a constructor, take the warp out of it with `?`, or with `microwarp::constant!`",
    note = "a rejection sampler is no warp, since it takes no fixed number of uniforms: draw from it by `microwarp::rejection::Rejection`"
)]
pub trait Warp {
    /// The uniforms of one sample: an `f32`, or an array with one for each.
    type Uniforms: Uniforms;
    /// The point: `f32` on the line, `[f32; 2]` in the plane, `[f32; 3]` for directions.
    type Point: Copy;
    /// The type of a density, `f32` in the float tiers.
    type Density: Copy;

    /// The point of uniforms that are known to lie in [0, 1). This is what a warp defines; call
    /// [`sample`](Warp::sample).
    #[must_use]
    fn sample_canonical(&self, u: Canonical<Self::Uniforms>) -> Self::Point;

    /// The density at `x`, per unit of length, of area or of solid angle (steradian).
    ///
    /// It is 0 outside the domain and for NaN, and never 0 at a point that `sample` returned. Directions are taken to have
    /// length 1: the density of a vector of another length is finite, not below 0, and means nothing.
    #[must_use]
    fn pdf(&self, x: Self::Point) -> Self::Density;

    /// The point of explicit uniforms. To draw from a generator, call [`draw`](Warp::draw).
    ///
    /// Uniforms outside [0, 1), and NaN, are brought into range first, by the rule of [`Uniforms::canonical`].
    #[must_use]
    #[inline]
    fn sample(&self, u: Self::Uniforms) -> Self::Point {
        self.sample_canonical(u.canonical())
    }

    /// The point of random words: what [`draw`](Warp::draw) and [`fill`](Warp::fill) make of a generator's words.
    ///
    /// That is the sample of the uniforms k·2⁻²⁴ that the words stand for, unless the domain is open at an end or the
    /// density vanishes there. Such a warp takes a word as the middle of its cell of uniforms, so that no draw lies
    /// beyond its share of the tail.
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

    /// Draws one point from a generator that can fail.
    ///
    /// A uniform takes one `u32` of the generator, unless the warp says otherwise.
    ///
    /// # Errors
    /// The generator's own error. Words drawn before it failed are lost.
    // On x86-64 the conversion of an integer has a false dependency on the register's old value. The compiler breaks it
    // in a loop, but not in a function that a loop calls.
    #[allow(
        clippy::inline_always,
        reason = "breaks the false dependency, on x86-64 only"
    )]
    #[cfg_attr(target_arch = "x86_64", inline(always))]
    #[cfg_attr(not(target_arch = "x86_64"), inline)]
    fn try_draw<R: TryRng + ?Sized>(&self, rng: &mut R) -> Result<Self::Point, R::Error>
    where
        Self: Sized,
    {
        Ok(self.sample_words(Self::Uniforms::try_words(rng)?))
    }

    /// Draws one point from a generator, `warp.draw(&mut rng)`.
    ///
    /// A uniform takes one `u32` of the generator, unless the warp says otherwise.
    ///
    /// ```
    /// use microwarp::{Warp, poly as mw};
    /// let mut rng = rand_pcg::Pcg32::new(42, 54);
    /// let noise = mw::Normal::new(20.0, 0.5)?;
    /// let reading: f32 = noise.draw(&mut rng);
    /// assert!((reading - 20.0).abs() < 3.2);
    /// # Ok::<(), microwarp::Error>(())
    /// ```
    #[allow(clippy::inline_always, reason = "as of `try_draw`")]
    #[cfg_attr(target_arch = "x86_64", inline(always))]
    #[cfg_attr(not(target_arch = "x86_64"), inline)]
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

    /// Fills a slice with points from a generator that can fail, in order.
    ///
    /// # Errors
    /// The generator's own error. The points before the failing one are in place, the rest of the slice is untouched.
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

    /// Fills a slice with points from a generator, in order: the points that as many calls of [`draw`](Warp::draw)
    /// would give, several at a time where the processor has vectors.
    #[inline]
    fn fill<R: Rng + ?Sized>(&self, rng: &mut R, points: &mut [Self::Point])
    where
        Self: Sized,
    {
        infallible(self.try_fill(rng, points));
    }

    /// A batch of samples: the points of a slice of uniforms, in order. For uniforms of your own, such as a point set, another
    /// generator or a replay.
    ///
    /// They are the points that as many calls of [`sample`](Warp::sample) would give, several at a time where the processor
    /// has vectors. If the slices differ in length, the shorter one counts; points beyond it are untouched.
    ///
    /// ```
    /// use microwarp::{Warp, poly as mw};
    /// let uniforms = [[0.25, 0.5], [0.75, 0.125]];
    /// let mut points = [[0.0; 2]; 2];
    /// let disk = mw::Disk::new();
    /// disk.map(&uniforms, &mut points);
    /// assert_eq!(points, uniforms.map(|u| disk.sample(u)));
    /// ```
    #[inline]
    fn map(&self, uniforms: &[Self::Uniforms], points: &mut [Self::Point])
    where
        Self: Sized,
    {
        for (point, &u) in points.iter_mut().zip(uniforms) {
            *point = self.sample(u);
        }
    }

    /// The points of a slice of uniforms, as [`map`](Warp::map) gives them, and their densities, as
    /// [`sample_with_pdf`](Warp::sample_with_pdf) gives them, several at a time likewise. The shortest slice counts.
    #[inline]
    fn map_with_pdf(
        &self,
        uniforms: &[Self::Uniforms],
        points: &mut [Self::Point],
        densities: &mut [Self::Density],
    ) where
        Self: Sized,
    {
        for ((point, density), &u) in points.iter_mut().zip(densities).zip(uniforms) {
            (*point, *density) = self.sample_with_pdf(u);
        }
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
/// `invert(sample(u))` is `u` again, within the bounds that each warp states. A Markov chain in the unit cube or a table
/// of strata finds the uniforms of a given point by it. Every warp of this crate has one. Your own warp needs one only
/// where something asks for it, such as the `invert` of a [`Transform`](crate::warp::Transform) around it.
///
/// ```
/// use microwarp::{Invert, Warp, poly as mw};
/// let disk = mw::Disk::new();
/// assert_eq!(disk.invert(disk.sample([0.25, 0.5])), [0.25, 0.5]);
/// ```
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no inverse",
    label = "a warp that can be inverted is expected here",
    note = "`invert` is a trait of its own: implement `microwarp::Invert` beside `microwarp::Warp`"
)]
pub trait Invert: Warp {
    /// The uniforms in [0, 1) whose sample is `x`. Outside the domain, the uniforms of some point inside it.
    #[must_use]
    fn invert(&self, x: Self::Point) -> Self::Uniforms;
}

/// The default of [`Warp::try_fill`].
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

/// The draws of a method of two explicit uniforms, which take a word for each from the grid, in order.
macro_rules! drawn_by {
    ($(#[$doc:meta])* $draw:ident, $try_draw:ident, $method:ident -> $out:ty) => {
        $(#[$doc])*
        ///
        /// That is the method of explicit uniforms, of two words of the generator on the 24-bit grid. A
        /// [`Cursor`](crate::uniform::Cursor) gives its next two dimensions.
        #[inline]
        pub fn $draw<R: rand_core::Rng + ?Sized>(&self, rng: &mut R) -> $out {
            crate::uniform::infallible(self.$try_draw(rng))
        }

        /// Likewise from a generator that can fail.
        ///
        /// # Errors
        /// The generator's own error.
        #[inline]
        pub fn $try_draw<R: rand_core::TryRng + ?Sized>(&self, rng: &mut R) -> Result<$out, R::Error> {
            let u = <[f32; 2] as crate::uniform::Uniforms>::try_draw(rng)?;
            Ok(self.$method(u.get()))
        }
    };
}
pub(super) use drawn_by;

/// [`Warp::try_draw_with_pdf`] of a warp that overrides [`Warp::sample_canonical_with_pdf`] and draws from the grid, `by`
/// another uniform of a word, or `from` the word by a method.
macro_rules! drawn_with_pdf {
    (from $of_word:ident) => {
        #[inline]
        fn try_draw_with_pdf<R: rand_core::TryRng + ?Sized>(
            &self,
            rng: &mut R,
        ) -> Result<(f32, f32), R::Error> {
            Ok(self.$of_word(rng.try_next_u32()?))
        }
    };
    (by $uniform:path) => {
        #[inline]
        fn try_draw_with_pdf<R: rand_core::TryRng + ?Sized>(
            &self,
            rng: &mut R,
        ) -> Result<(f32, f32), R::Error> {
            let word = rng.try_next_u32()?;
            Ok(self.sample_canonical_with_pdf($uniform(word)))
        }
    };
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

/// A reference to a warp is a warp, so that compositions can borrow one.
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

    #[inline]
    fn map(&self, uniforms: &[Self::Uniforms], points: &mut [Self::Point]) {
        (**self).map(uniforms, points);
    }

    #[inline]
    fn map_with_pdf(
        &self,
        uniforms: &[Self::Uniforms],
        points: &mut [Self::Point],
        densities: &mut [Self::Density],
    ) {
        (**self).map_with_pdf(uniforms, points, densities);
    }
}

impl<W: Invert> Invert for &W {
    #[inline]
    fn invert(&self, x: Self::Point) -> Self::Uniforms {
        (**self).invert(x)
    }
}
