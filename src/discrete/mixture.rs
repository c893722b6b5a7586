//! Mixtures: a point of one of several warps, picked by weight.

use super::chooser::Chooser;
use crate::error::{Error, tried};
use crate::num::{above_zero, representable};
use crate::uniform::{Canonical, First, Led, Uniforms};
use crate::warp::{Invert, Measured, Warp};
use rand_core::TryRng;

/// N warps onto points of one kind, of as many uniforms, with densities by one measure: an array of one type, or a pair.
///
/// To mix three types, mix a pair with a third, or implement [`Warp`] for an `enum` and put its values into an array.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a set of {N} warps that can be mixed",
    label = "not {N} warps with the same uniforms, points and measure",
    note = "a mixture takes an array of one type, or a pair whose uniforms, points and measures are the same, and as many weights"
)]
pub trait Parts<const N: usize> {
    /// The uniforms of each.
    type Uniforms: First;
    /// The points of each.
    type Point: Copy;
    /// The measure of each density.
    type Measure;

    /// [`Warp::sample_canonical`] of the part of this index.
    fn sample_by(&self, index: usize, u: Canonical<Self::Uniforms>) -> Self::Point;

    /// [`Warp::sample_words`] of the part of this index.
    fn sample_words_by(
        &self,
        index: usize,
        words: <Self::Uniforms as Uniforms>::Words,
    ) -> Self::Point;

    /// [`Warp::sample_canonical_with_pdf`] of the part of this index.
    fn sample_with_pdf_by(&self, index: usize, u: Canonical<Self::Uniforms>) -> (Self::Point, f32);

    /// [`Warp::try_draw`] of the part of this index.
    ///
    /// # Errors
    /// The generator's own error.
    fn try_draw_by<R: TryRng + ?Sized>(
        &self,
        index: usize,
        rng: &mut R,
    ) -> Result<Self::Point, R::Error>;

    /// [`Warp::try_draw_with_pdf`] of the part of this index.
    ///
    /// # Errors
    /// The generator's own error.
    fn try_draw_with_pdf_by<R: TryRng + ?Sized>(
        &self,
        index: usize,
        rng: &mut R,
    ) -> Result<(Self::Point, f32), R::Error>;

    /// [`Warp::pdf`] of the part of this index.
    fn pdf_by(&self, index: usize, x: Self::Point) -> f32;
}

/// [`Parts`] that have inverses.
#[diagnostic::on_unimplemented(message = "not all warps of `{Self}` have an inverse")]
pub trait InvertParts<const N: usize>: Parts<N> {
    /// [`Invert::invert`] of the part of this index.
    fn invert_by(&self, index: usize, x: Self::Point) -> Self::Uniforms;
}

/// An array that is not empty.
pub trait NotEmpty<W> {
    /// The first of them.
    fn one(&self) -> &W;
}

macro_rules! not_empty {
    ($($n:literal)*) => {$(
        impl<W> NotEmpty<W> for [W; $n] {
            #[inline]
            fn one(&self) -> &W {
                let [first, ..] = self;
                first
            }
        }
    )*};
}
not_empty!(1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20 21 22 23 24 25 26 27 28 29 30 31 32);

/// A call of the part of an index: of an array, and of a pair.
macro_rules! of_array {
    ($parts:expr, $index:expr, $part:ident => $call:expr) => {{
        let $part = $parts.get($index).unwrap_or($parts.one());
        $call
    }};
}
macro_rules! of_pair {
    ($parts:expr, $index:expr, $part:ident => $call:expr) => {
        if $index == 0 {
            let $part = &$parts.0;
            $call
        } else {
            let $part = &$parts.1;
            $call
        }
    };
}

macro_rules! parts {
    ($of:ident) => {
        #[inline]
        fn sample_by(&self, index: usize, u: Canonical<Self::Uniforms>) -> Self::Point {
            $of!(self, index, part => part.sample_canonical(u))
        }

        #[inline]
        fn sample_words_by(
            &self,
            index: usize,
            words: <Self::Uniforms as Uniforms>::Words,
        ) -> Self::Point {
            $of!(self, index, part => part.sample_words(words))
        }

        #[inline]
        fn sample_with_pdf_by(
            &self,
            index: usize,
            u: Canonical<Self::Uniforms>,
        ) -> (Self::Point, f32) {
            $of!(self, index, part => part.sample_canonical_with_pdf(u))
        }

        #[inline]
        fn try_draw_by<R: TryRng + ?Sized>(
            &self,
            index: usize,
            rng: &mut R,
        ) -> Result<Self::Point, R::Error> {
            $of!(self, index, part => part.try_draw(rng))
        }

        #[inline]
        fn try_draw_with_pdf_by<R: TryRng + ?Sized>(
            &self,
            index: usize,
            rng: &mut R,
        ) -> Result<(Self::Point, f32), R::Error> {
            $of!(self, index, part => part.try_draw_with_pdf(rng))
        }

        #[inline]
        fn pdf_by(&self, index: usize, x: Self::Point) -> f32 {
            $of!(self, index, part => part.pdf(x))
        }
    };
}

impl<W, const N: usize> Parts<N> for [W; N]
where
    W: Measured<Density = f32>,
    W::Uniforms: First,
    Self: NotEmpty<W>,
{
    type Uniforms = W::Uniforms;
    type Point = W::Point;
    type Measure = W::Measure;
    parts!(of_array);
}

impl<A, B> Parts<2> for (A, B)
where
    A: Measured<Density = f32>,
    A::Uniforms: First,
    B: Measured<
            Density = f32,
            Uniforms = A::Uniforms,
            Point = A::Point,
            Measure = <A as Measured>::Measure,
        >,
{
    type Uniforms = A::Uniforms;
    type Point = A::Point;
    type Measure = A::Measure;
    parts!(of_pair);
}

impl<W: Invert, const N: usize> InvertParts<N> for [W; N]
where
    Self: Parts<N, Uniforms = W::Uniforms, Point = W::Point> + NotEmpty<W>,
{
    #[inline]
    fn invert_by(&self, index: usize, x: W::Point) -> W::Uniforms {
        of_array!(self, index, part => part.invert(x))
    }
}

impl<A, B> InvertParts<2> for (A, B)
where
    A: Invert,
    B: Invert<Uniforms = A::Uniforms, Point = A::Point>,
    Self: Parts<2, Uniforms = A::Uniforms, Point = A::Point>,
{
    #[inline]
    fn invert_by(&self, index: usize, x: A::Point) -> A::Uniforms {
        of_pair!(self, index, part => part.invert(x))
    }
}

/// A point of one of several warps, picked by weight, with the density of the mixture: one-sample multiple importance sampling.
///
/// One word picks the part and is its first word too: where the word lies within the share of the part is again a uniform. So a mixture
/// takes as many words as its parts, and points of a set ([`Points`](crate::uniform::Points)) keep their structure. Nothing is
/// allocated, and no part is a trait object.
///
#[cfg_attr(doc, doc = include_str!("../pictures/mixture.html"))]
///
/// # Density
/// Σ qᵢ pᵢ(x), in the order of the parts, with the probabilities qᵢ with which parts are picked, exactly: those of a
/// [`Cdf`](super::Cdf), out of 2³², and not the weights. A part of weight 0 is never picked, and its density is never asked for. The
/// density is 0 where all are, and the nearest positive `f32` where the sum leaves the range.
/// [`sample_with_pdf`](Warp::sample_with_pdf) takes the density of the picked part from its sampler, and asks the others for theirs.
///
/// # Domain
/// - Point: that of the parts.
/// - Uniforms: those of one part; all parts take as many. Drawing takes the words that drawing from the picked part takes. A draw reads
///   all 32 bits of its first word: a part of probability q has 32 + log₂ q of them left, rounded down, and at least 24 down to 2⁻⁸.
///   A part that takes further words for its tails, or a table of `u64`, has no digits below these. Explicit uniforms pick a part by
///   their own digits: on the 24-bit grid a probability is met to 2⁻²⁴.
/// - Parameters: an array of 1 to 32 warps of one type, or a pair of two types, with densities by one
///   [measure](crate::warp::Measured); a finite weight of each, zero or positive, not all zero.
/// - Size: that of the parts, and 16 bytes each.
///
/// Densities by different measures do not mix. The normals of a microfacet are no directions, though both are `[f32; 3]`:
/// [`Reflected`](crate::warp::Reflected) makes directions of them.
/// ```compile_fail,E0271
/// use microwarp::{discrete::Mixture, poly as mw};
/// let normals = mw::GgxVisible::new([0.6, 0.0, 0.8], [0.3, 0.3])?;
/// let lobe = Mixture::new((mw::CosineHemisphere::new(), normals), &[1.0, 2.0])?;
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// # Accuracy
/// - The probability of a part is exactly [`numerator`](Mixture::numerator) of 2³², and differs from weight/total by less than 2⁻³²,
///   or by at most that where some weight is below such a step. A weight too small for one word among so many is
///   [`Error::Unreachable`].
/// - The rest that [`choose`](Mixture::choose) gives is the middle of the word's place in the share, within 2⁻³².
/// - The density has the errors of those of the parts, and (N + 1) · 6e-8 of its own.
/// - A sample has the error of the part that is picked. Next to the end of a share, rounding may take it for the other side.
///
/// These are for three intervals of length 1 apart from each other, whose weights are 1, 4 and 3: *sample* in units in the last place
/// (ulp), densities relative, *inverse*, of which there is one there, and *round trip* absolute. [What each row
/// means](crate::warp#stated-errors).
///
/// | error | bound | kind |
/// |---|--:|---|
/// | sample, ulp | 1 | found |
/// | pdf, relative | 1e-7 | found |
/// | realised density, relative | 1e-7 | found |
/// | inverse | 3e-10 | found |
/// | round trip | 1.6e-7 | found |
///
/// # Cost
/// A comparison a part (log₂ N where there are no vectors) and two products, beside the part that is picked; a density costs those of all
/// parts. The constructor divides once a part.
///
/// # Examples
/// ```
/// use microwarp::{Warp, discrete::Mixture, poly as mw};
/// use rand_pcg::Pcg32;
///
/// // A matte ground under a glossy coat: a third of the directions by the cosine, two thirds by the reflection.
/// let gloss = mw::Reflected::new(mw::GgxVisible::new([0.6, 0.0, 0.8], [0.3, 0.3])?);
/// let lobe = Mixture::new((mw::CosineHemisphere::new(), gloss), &[1.0, 2.0])?;
/// let (direction, density) = lobe.draw_with_pdf(&mut Pcg32::new(42, 54)); // two words
/// assert!((lobe.pdf(direction) / density - 1.0).abs() < 1e-5);
/// # Ok::<(), microwarp::Error>(())
/// ```
/// Of several warps of one type, and of constants:
/// ```
/// use microwarp::{Warp, constant, discrete::Mixture, poly as mw};
/// const PEAKS: Mixture<[mw::Normal; 2], 2> = constant!(Mixture::new(
///     [constant!(mw::Normal::new(-3.0, 0.5)), constant!(mw::Normal::new(2.0, 1.0))],
///     &[1.0, 3.0],
/// ));
/// assert_eq!((PEAKS.pmf(0), PEAKS.choose(0x4000_0000)), (0.25, (1, 0)));
/// assert!(PEAKS.sample(0.1) < 0.0 && PEAKS.sample(0.7) > 0.0);
/// ```
///
/// # See also
/// - [`Cdf`](super::Cdf): the index alone.
/// - [`estimate::balance_heuristic`](crate::estimate::balance_heuristic): where each part gets samples of its own.
/// - [`metropolis::Mixture`](crate::metropolis::Mixture): of mutations of Markov chains.
///
/// # Source
/// E. Veach, "Robust Monte Carlo Methods for Light Transport Simulation", 1997, section 9.2.4,
/// <https://graphics.stanford.edu/papers/veach_thesis/>.
#[doc(alias = "multiple_importance_sampling")]
#[doc(alias = "mis")]
#[doc(alias = "one_sample")]
#[doc(alias = "composition")]
#[doc(alias = "brdf")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Mixture<P, const N: usize> {
    parts: P,
    chooser: Chooser<N>,
}

impl<P: Parts<N>, const N: usize> Mixture<P, N> {
    /// A mixture of warps, picked in proportion to these weights.
    ///
    /// # Errors
    /// [`Error::AllZero`]; with the index of the weight [`Error::NegativeWeight`], [`Error::NotFiniteWeight`], and
    /// [`Error::Unreachable`] for a positive weight that is too small beside the others; [`Error::Empty`] for warps that take no
    /// uniform, by which nothing can be picked.
    pub const fn new(parts: P, weights: &[f32; N]) -> Result<Self, Error>
    where
        P: Copy,
    {
        if P::Uniforms::COUNT == 0 {
            return Err(Error::Empty(0));
        }
        let chooser = tried!(Chooser::new(weights));
        Ok(Self { parts, chooser })
    }

    /// The warps.
    #[must_use]
    pub const fn parts(&self) -> &P {
        &self.parts
    }

    /// The part that a word picks, and the first word of that part: the rest of this one.
    #[must_use]
    #[inline]
    pub fn choose(&self, word: u32) -> (usize, u32) {
        self.chooser.choose(word)
    }

    /// How many of the 2³² words pick a part: its probability is exactly this out of 2³².
    #[must_use]
    pub fn numerator(&self, part: usize) -> u64 {
        self.chooser.numerator(part)
    }

    /// The probability of a part, correctly rounded; 0 for a weight of 0 and beyond the last part.
    #[must_use]
    pub fn pmf(&self, part: usize) -> f32 {
        self.chooser.pmf(part)
    }

    /// The share that each part has in the density, of the densities of parts; none of one that is 0. Parts of weight 0 are not
    /// asked.
    #[inline]
    fn terms(&self, density: impl Fn(usize) -> f32) -> impl Iterator<Item = Option<f32>> {
        let pmfs = self.chooser.pmfs().iter().enumerate();
        pmfs.map(move |(index, &pmf)| {
            let density = if pmf > 0.0 { density(index) } else { 0.0 };
            // NaN is no density.
            (density > 0.0).then_some(pmf * density)
        })
    }

    #[inline]
    fn density(&self, density: impl Fn(usize) -> f32) -> f32 {
        let sum = self.terms(density).flatten().reduce(|sum, term| sum + term);
        // Where all round to 0 it is the smallest number.
        sum.map_or(0.0, representable)
    }

    /// The density at a point where one part is known to have this one.
    #[inline]
    fn density_beside(&self, known: usize, its: f32, x: P::Point) -> f32 {
        self.density(|index| match index {
            _ if index == known => its,
            _ => self.parts.pdf_by(index, x),
        })
    }

    /// The density of the mixture where its parts have these densities: for a value and a density from the same ones.
    ///
    /// ```
    /// use microwarp::{Warp, discrete::Mixture, poly as mw};
    /// let lobe = Mixture::new((mw::CosineHemisphere::new(), mw::Sphere::new()), &[1.0, 1.0])?;
    /// let (up, [cosine, all]) = ([0.0, 0.0, 1.0], [0.318_309_9, 0.079_577_47]);
    /// assert_eq!(lobe.pdf_of([cosine, all]), 0.5 * cosine + 0.5 * all);
    /// # assert!((lobe.pdf_of([cosine, all]) / lobe.pdf(up) - 1.0).abs() < 1e-6);
    /// # Ok::<(), microwarp::Error>(())
    /// ```
    #[must_use]
    #[inline]
    pub fn pdf_of(&self, densities: [f32; N]) -> f32 {
        self.density(|index| densities.get(index).copied().unwrap_or(0.0))
    }

    /// The part that uniforms pick, and its uniforms.
    #[inline]
    fn picked(&self, u: Canonical<P::Uniforms>) -> (usize, Canonical<P::Uniforms>) {
        let first = u.get().first().map_or(0.0, |first| *first);
        let (index, rest) = self.chooser.choose_uniform(first);
        (index, u.with_first(rest))
    }

    /// Uniforms whose sample is `x`, within the rounding of the first: those by which the part got there that `u` picks.
    ///
    /// A point may come of each part, so the mixture has no [`Invert`]. This picks a part with the probability that the point
    /// came of it, qᵢ pᵢ(x) over the density. Of a point of the mixture and a `u` that is uniform, the uniforms are again uniform:
    /// that is the inverse which a Markov chain between spaces of uniforms needs. Outside the domain they are those of some
    /// point of the first part that has a weight.
    ///
    /// ```
    /// use microwarp::{Warp, discrete::Mixture, poly as mw};
    /// let near = mw::Normal::new(0.0, 1.0)?;
    /// let mixture = Mixture::new([near, mw::Normal::new(1.0, 1.0)?], &[1.0, 1.0])?;
    /// let [low, high] = [0.0, 0.9].map(|u| mixture.invert_with(0.5, u)); // halfway, both are as likely
    /// assert!(low < 0.5 && high > 0.5);
    /// assert!([low, high].iter().all(|&u| (mixture.sample(u) - 0.5).abs() < 1e-6));
    /// # Ok::<(), microwarp::Error>(())
    /// ```
    #[must_use]
    pub fn invert_with(&self, x: P::Point, u: f32) -> P::Uniforms
    where
        P: InvertParts<N>,
    {
        let mut terms = [0.0_f32; N];
        let shares = self.terms(|index| self.parts.pdf_by(index, x));
        for (slot, share) in terms.iter_mut().zip(shares) {
            *slot = share.map_or(0.0, |share| above_zero(share).min(f32::MAX));
        }
        // A sum of 32 terms or fewer does not overflow of their 32nds.
        if terms.iter().any(|&term| term > f32::MAX / 32.0) {
            terms = terms.map(|term| term / 32.0);
        }
        let mut at = u.canonical().get() * terms.iter().sum::<f32>();
        let pmfs = self.chooser.pmfs().iter();
        let mut index = pmfs.take_while(|&&pmf| pmf <= 0.0).count();
        for (part, &term) in terms.iter().enumerate() {
            if term > 0.0 {
                index = part;
                if at < term {
                    break;
                }
                at -= term;
            }
        }
        let mut uniforms = self.parts.invert_by(index, x);
        if let Some(first) = uniforms.first() {
            *first = self.chooser.uniform(index, *first);
        }
        uniforms
    }
}

impl<P: Parts<N>, const N: usize> Warp for Mixture<P, N> {
    type Uniforms = P::Uniforms;
    type Point = P::Point;
    type Density = f32;

    #[inline]
    fn sample_canonical(&self, u: Canonical<P::Uniforms>) -> P::Point {
        let (index, u) = self.picked(u);
        self.parts.sample_by(index, u)
    }

    #[inline]
    fn pdf(&self, x: P::Point) -> f32 {
        self.density(|index| self.parts.pdf_by(index, x))
    }

    #[inline]
    fn sample_words(&self, mut words: <P::Uniforms as Uniforms>::Words) -> P::Point {
        let mut index = 0;
        if let Some(first) = P::Uniforms::first_word(&mut words) {
            (index, *first) = self.choose(*first);
        }
        self.parts.sample_words_by(index, words)
    }

    #[inline]
    fn sample_canonical_with_pdf(&self, u: Canonical<P::Uniforms>) -> (P::Point, f32) {
        let (index, u) = self.picked(u);
        let (x, density) = self.parts.sample_with_pdf_by(index, u);
        (x, self.density_beside(index, density, x))
    }

    #[inline]
    fn try_draw<R: TryRng + ?Sized>(&self, rng: &mut R) -> Result<P::Point, R::Error> {
        let (index, rest) = self.choose(rng.try_next_u32()?);
        self.parts.try_draw_by(index, &mut Led::new(rest, rng))
    }

    #[inline]
    fn try_draw_with_pdf<R: TryRng + ?Sized>(
        &self,
        rng: &mut R,
    ) -> Result<(P::Point, f32), R::Error> {
        let (index, rest) = self.choose(rng.try_next_u32()?);
        let drawn = self
            .parts
            .try_draw_with_pdf_by(index, &mut Led::new(rest, rng));
        let (x, density) = drawn?;
        Ok((x, self.density_beside(index, density, x)))
    }
}

impl<P: Parts<N>, const N: usize> Measured for Mixture<P, N> {
    type Measure = P::Measure;
}
