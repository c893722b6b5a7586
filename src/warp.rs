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
pub(crate) mod contract;
mod direction;
mod disk;
mod exponential;
mod fill;
mod frame;
mod ggx;
mod hemisphere;
mod henyey_greenstein;
mod interval;
mod inversion;
mod linear;
mod marginal;
mod normal;
mod phong_lobe;
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
            ggx::Ggx<T> "Normals of the microfacets of a rough surface",
            ggx::GgxVisible<T> "Normals of the microfacets that a viewer sees",
            hemisphere::CosineHemisphere<T> "In proportion to the cosine over the hemisphere, by inversion",
            hemisphere::Hemisphere<T> "Uniform over the hemisphere about +z",
            hemisphere::MalleyHemisphere<T> "In proportion to the cosine over the hemisphere, by Malley's method",
            henyey_greenstein::HenyeyGreenstein<T> "The phase function of fog, clouds and skin",
            interval::Interval "Uniform on an interval",
            inversion::Inversion "Any density on the line, by its inverse CDF",
            linear::Linear "Linear on [0, 1)",
            phong_lobe::PhongLobe<T> "In proportion to a power of the cosine over the hemisphere",
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
pub use self::ggx::Reflection;

pub(crate) use self::contract::{Invert, Warp, one_by_one};
pub(crate) use self::fill::filled_in_blocks;
