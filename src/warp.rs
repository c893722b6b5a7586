//! Warps: maps from uniforms to a domain, each with its density and its inverse.
//!
//! A warp is a pure function of explicit uniforms. [`Warp::sample`] takes the uniforms,
//! [`Warp::draw`] and [`Warp::fill`] take a generator. What is generic over a tier
//! has an alias without the parameter in [`poly`](crate::poly) and in [`libm`](crate::libm).
//!
//! # Stated errors
//! Each warp's page has a table of error bounds, with a column for each tier. A bound holds for every parameter that the
//! constructor accepts and for every uniform, on the 24-bit grid or off it. It is a number, or a formula in the
//! parameters that the text below the table explains. The rows are:
//!
//! - *sample*: the distance from the exact map of the same uniforms. The row names its unit. *ulp* is a unit in the last
//!   place of the exact value. *ulp of the scale* is one of the end of the interval that is farther from 0. *of the
//!   size* is relative to the size of the domain, which the page gives (1 for directions).
//! - *sin θ*, *cos θ*: of directions, in ulp.
//! - *unit length*: of directions, the distance of their length from 1.
//! - *pdf*: the density at the returned point, relative to the exact density there. This is the error of p in an
//!   estimate f/p.
//! - *realised density*: the same density, relative to the exact density at the exact point. It adds what rounding the
//!   point changes, and is the error of 1/p as the Jacobian of the map at those uniforms.
//! - *pdf with the sample*: the density that [`Warp::sample_with_pdf`] hands over, relative to the exact density at the
//!   exact point. A warp without this row hands over `pdf` of the point.
//! - *inverse*: the uniforms of the returned point, absolute.
//! - *round trip*: the uniforms after `sample` and `invert`, absolute.
//!
//! Two names occur in many formulas, because no arithmetic removes the effect of rounding the point: `s` is the relative
//! change of the exact density, and `r` the change of the exact inverse, when the point moves by one unit of its
//! rounding. That unit is an ulp on the line, 2⁻²⁴ of the size in the plane and in space, and an ulp of sin θ and of
//! cos θ for directions.
//!
//! Densities outside the normal range of `f32` (1.2e-38 to 3.4e38) are positive and finite, and no more is promised.
//!
//! `docs/proofs.md` says which bounds are proven. The others are measured: a search over parameters and uniforms, part of
//! the tests, has found no case that exceeds them, and one that reaches at least half of them. `docs/accuracy.md` lists
//! the errors of single parameter sets.

mod aabb;
mod cone;
pub(crate) mod contract;
mod direction;
mod disk;
mod equi_angular;
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
mod von_mises_fisher;

/// Every warp in one line: its file, its name, and a sentence for the lists of the tiers. `<T>` marks types that are
/// generic over the tier.
///
/// From this list come the names of this module, and the names of both tiers with their documentation.
macro_rules! each_warp {
    ($then:ident) => {
        $then! {
            aabb::Aabb "Uniform in an axis-aligned box of any dimension; one uniform a dimension",
            cone::Cone<T> "Uniform over the directions within an angle of +z (a cone, or spherical cap); two uniforms",
            disk::Disk<T> "Uniform on the unit disk, by polar coordinates; two uniforms",
            disk::DiskConcentric<T> "Uniform on the unit disk, by Shirley and Chiu's concentric map, which keeps strata compact; two uniforms",
            equi_angular::EquiAngular<T> "Uniform in the angle in which a light sees a segment of a ray (equi-angular sampling); one uniform",
            exponential::Exponential<T> "Exponential, increasing with the uniform; one uniform",
            exponential::ExponentialTail<T> "Exponential, decreasing with the uniform, to far into the tail; one uniform, drawn from two words",
            frame::Frame "An orthonormal frame about a normal",
            frame::Oriented "A warp over directions, turned onto a normal",
            ggx::Ggx<T> "Normals of the microfacets of a rough surface (GGX, Trowbridge-Reitz); two uniforms",
            ggx::GgxVisible<T> "Normals of the GGX microfacets that a viewer sees; two uniforms",
            hemisphere::CosineHemisphere<T> "In proportion to the cosine over the hemisphere about +z (Lambert's law), by inversion; two uniforms",
            hemisphere::Hemisphere<T> "Uniform over the hemisphere about +z; two uniforms",
            hemisphere::MalleyHemisphere<T> "In proportion to the cosine over the hemisphere about +z (Lambert's law), by Malley's method, which keeps strata compact; two uniforms",
            henyey_greenstein::HenyeyGreenstein<T> "The Henyey-Greenstein phase function of fog, clouds and skin; two uniforms",
            interval::Interval "Uniform on an interval; one uniform",
            inversion::Inversion "Any density on the line, from its inverse CDF; one uniform",
            linear::Linear "Linear on [0, 1); one uniform",
            phong_lobe::PhongLobe<T> "In proportion to a power of the cosine over the hemisphere about +z (the Phong lobe); two uniforms",
            marginal::MarginalConditional "A density in the plane, from a marginal and its conditional; two uniforms",
            normal::Normal<T> "Normal (Gaussian), one number at a time by its quantile; one uniform",
            normal::NormalPair<T> "Two independent normals (Gaussians), by Box and Muller's map; two uniforms",
            power::Power<T> "A power law on an interval, for any exponent; one uniform",
            power_max::PowerMax "The largest of N uniforms, a power law of whole exponent; N uniforms",
            sphere::Sphere<T> "Uniform over the unit sphere; two uniforms",
            spherical::Spherical<T> "A point in spherical coordinates, angles in turns",
            spherical::SphericalPatch<T> "Uniform over the directions between two polar angles and two azimuths; two uniforms",
            tent::Tent "The tent (triangle) filter; one uniform",
            transform::Transform "A warp followed by a one-to-one map, with its Jacobian",
            triangle::Triangle "Uniform barycentric coordinates; two uniforms",
            triangle_on::TriangleOn "Uniform on a triangle given by its vertices; two uniforms",
            truncated::TruncatedExponential<T> "Exponential on [0, X], falling or rising; one uniform",
            von_mises_fisher::VonMisesFisher<T> "The normal distribution of directions (von Mises-Fisher); two uniforms",
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

pub(crate) use self::contract::{Invert, Warp, drawn_with_pdf, one_by_one};
pub(crate) use self::fill::filled_in_blocks;
