//! Warps: maps from canonical uniforms to a domain, each with its density and its inverse.
//!
//! Here live the [`Warp`] trait and the list of families; each family is a file of its own. A warp is
//! a pure function of explicit uniforms: generators enter only through [`Warp::draw`],
//! [`Warp::try_draw`] and their slice forms.
//!
//! # Stated errors
//! Each warp carries a table of error bounds, a column a tier. A bound holds for every parameter that the
//! constructor accepts and for every uniform, on the 24-bit grid or off it. It is a number, or a formula in the
//! parameters that the line below the table explains. The rows are:
//!
//! - *sample*: the distance from the exact map of the same uniforms. Its unit is one of three: a unit in the last
//!   place (ulp) of the exact value, an ulp of the larger bound (the scale), or the size of the domain.
//! - *sin θ*, *cos θ*: of directions, in ulp.
//! - *unit length*: of directions, from 1.
//! - *pdf*: the density at the returned point, relative to the exact density there.
//! - *realised density*: the density at the returned point, relative to the exact density at the exact point. Here
//!   the rounding of the point counts.
//! - *inverse*: the uniforms of the returned point, absolute.
//! - *round trip*: the uniforms after `sample` and `invert`, absolute.
//!
//! Two names occur in many formulas, because no arithmetic removes what the rounding of the point itself does:
//! `s` is the relative change of the exact density, and `r` the change of the exact inverse, when the point moves by
//! one unit of its rounding. That unit is an ulp on the line, 2⁻²⁴ of the size in the plane and in space, and an ulp of
//! sin θ and of cos θ for directions.
//!
//! Densities outside the normal range of `f32` (1.2e-38 to 3.4e38) are positive and finite, no more.
//!
//! `docs/proofs.md` says which bounds are proven. The others are found: a search over parameters and uniforms,
//! part of the tests, knows no case that exceeds them and one that comes to at least half of them.
//! `docs/accuracy.md` lists what single parameter sets show.

mod aabb;
mod cone;
mod direction;
mod disk;
mod exponential;
mod fill;
mod frame;
mod hemisphere;
mod henyey_greenstein;
mod interval;
mod inversion;
mod linear;
mod lobe;
mod marginal;
mod normal;
mod planar;
mod power;
mod power_max;
mod sphere;
mod spherical;
mod tent;
mod transform;
mod triangle;
mod triangle_on;
mod truncated;

/// Every warp in one line: where it is, its name and what it is; `<T>` marks what is generic over the tier.
///
/// From this list come the names of this module, those at the root of the crate, and the names of both tiers with
/// their documentation.
macro_rules! each_warp {
    ($then:ident) => {
        $then! {
            aabb::Aabb "Uniform in a box of any dimension",
            cone::Cone<T> "Uniform over the directions within an angle of +z",
            disk::Disk<T> "Uniform on the unit disk, by polar coordinates",
            disk::DiskConcentric<T> "Uniform on the unit disk, by Shirley's concentric map",
            exponential::Exponential<T> "Exponential, increasing with the uniform",
            exponential::ExponentialTail<T> "Exponential, decreasing with the uniform: the tail first",
            frame::Frame "An orthonormal frame about a normal",
            frame::Oriented "A warp over directions, turned onto a normal",
            hemisphere::CosineHemisphere<T> "In proportion to the cosine over the hemisphere, by inversion",
            hemisphere::Hemisphere<T> "Uniform over the hemisphere about +z",
            hemisphere::MalleyHemisphere<T> "In proportion to the cosine over the hemisphere, by Malley's method",
            henyey_greenstein::HenyeyGreenstein<T> "The phase function of fog, clouds and skin",
            interval::Interval "Uniform on an interval",
            inversion::Inversion "Any density on the line, by its inverse CDF",
            linear::Linear "Linear on [0, 1)",
            lobe::PhongLobe<T> "In proportion to a power of the cosine over the hemisphere",
            marginal::MarginalConditional "A marginal, and the conditional that belongs to its point",
            normal::Normal<T> "Normal, one number at a time",
            normal::NormalPair<T> "Two independent normals, by Box and Muller's map",
            power::Power<T> "In proportion to any power on an interval",
            power_max::PowerMax "The largest of N uniforms",
            sphere::Sphere<T> "Uniform over the unit sphere",
            spherical::Spherical<T> "A point in spherical coordinates",
            spherical::SphericalPatch<T> "Uniform over the directions between two polar angles and two azimuths",
            tent::Tent "The tent filter",
            transform::Transform "A warp followed by a one-to-one map",
            triangle::Triangle "Uniform barycentric coordinates",
            triangle_on::TriangleOn "Uniform on a triangle given by its vertices",
            truncated::TruncatedExponential<T> "Exponential on [0, X], rising or falling",
        }
    };
}
pub(crate) use each_warp;

macro_rules! names {
    ($($file:ident::$name:ident $(<$tier:ident>)? $what:literal,)*) => {
        $(pub use self::$file::$name;)*
    };
}
each_warp!(names);

pub(crate) use self::fill::filled_in_blocks;

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

    /// Uniforms in [0, 1) whose sample is `x`. A point outside the domain gives the uniforms of some
    /// point inside it.
    #[must_use]
    fn invert(&self, x: Self::Point) -> Self::Uniforms;

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
}

/// [`Warp::try_fill`] as it is provided.
#[inline]
fn one_by_one<W: Warp, R: TryRng + ?Sized>(
    warp: &W,
    rng: &mut R,
    points: &mut [W::Point],
) -> Result<(), R::Error> {
    for point in points {
        *point = warp.try_draw(rng)?;
    }
    Ok(())
}

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
    fn invert(&self, x: Self::Point) -> Self::Uniforms {
        (**self).invert(x)
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
    fn try_fill<R: TryRng + ?Sized>(
        &self,
        rng: &mut R,
        points: &mut [Self::Point],
    ) -> Result<(), R::Error> {
        (**self).try_fill(rng, points)
    }
}
