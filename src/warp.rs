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
//!   Where a page says that a draw keeps it, the bound also counts from the exact point of the middle of a word's cell.
//! - *sin θ*, *cos θ*: of directions, in ulp.
//! - *unit length*: of directions, the distance of their length from 1.
//! - *place on it*: of lights, the coordinates of the place that a direction leads to, absolute.
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
//! There is a column for each float tier, or one *bound* where both state the same: that of a type without a tier, or of one
//! whose formulas serve both. The last column says of which kind the bounds of a row are:
//!
//! - *proven*: no input exceeds them, by an argument that `docs/proofs.md` gives.
//! - *exhaustive*: all inputs have been tried.
//! - *found*: a search over parameters and uniforms, part of the tests, has met no case that exceeds them. They keep a
//!   margin, at least 1.3 times the worst that a long search found, and a case that reaches 1/2.5 of them is known.
//!
//! In the repository `docs/accuracy.md` lists the errors of single parameter sets.

mod aabb;
mod annulus;
mod ball;
mod bilinear;
mod box_surface;
mod capsule_surface;
mod cauchy;
mod composed;
mod cone;
pub(crate) mod contract;
mod degrees;
pub(crate) mod direction;
mod disk;
mod each;
mod equi_angular;
mod exponential;
mod fill;
mod frame;
mod frustum_surface;
mod ggx;
mod gumbel;
mod hemisphere;
mod henyey_greenstein;
mod interval;
mod inversion;
mod laplace;
mod light_sample;
mod linear;
mod location_scale;
mod log_normal;
mod logistic;
mod marginal;
mod measure;
mod multivariate_normal;
mod normal;
mod pareto;
mod phong_lobe;
mod planar;
mod power;
mod power_max;
mod product;
mod rayleigh;
mod reflected;
mod regular_polygon;
mod rotation;
mod seen;
mod simplex;
mod sphere;
mod spherical;
mod spherical_rectangle;
mod spherical_triangle;
mod student_pair;
mod student_t;
mod surface_point;
mod tent;
mod transform;
mod triangle;
pub(crate) mod triangle_on;
mod truncated;
mod truncated_logistic;
mod truncated_normal;
mod visible_sphere;
mod von_mises_fisher;
mod weibull;

/// Every warp in one line: its file, its name, and a sentence for the lists of the tiers. `<T>` marks types that are
/// generic over the tier, `<T, N>` those that are generic over a number, too. What follows is the measure of the density;
/// where nothing does, it depends on parameters of the type, and `measure.rs` says how.
///
/// From this list come the names of this module, and the names of both tiers with their documentation.
macro_rules! each_warp {
    ($then:ident $($tier:ident)?) => {
        $then! { $($tier;)?
            aabb::Aabb "Uniform in an axis-aligned box of any dimension; one uniform a dimension",
            annulus::Annulus<T> "Uniform on a ring between two circles, or on a sector of one; two uniforms" Area,
            ball::Ball<T> "Uniform in the unit ball; three uniforms" Volume,
            bilinear::Bilinear "Bilinear between four weights at the corners of the unit square; two uniforms" Area,
            box_surface::BoxSurface "Uniform on the surface of an axis-aligned box; two uniforms" Area,
            capsule_surface::CapsuleSurface<T> "Uniform on the surface of a capsule, a cylinder between two hemispheres; two uniforms" Area,
            cauchy::Cauchy<T> "Cauchy (Lorentz), heavy tails on both sides; one uniform" Length,
            composed::Composed "A warp fed with the points of another, e.g. to weight an area light by cosines",
            cone::Cone<T> "Uniform over the directions within an angle of +z (a cone, or spherical cap); two uniforms" SolidAngle,
            disk::Disk<T> "Uniform on the unit disk, by polar coordinates; two uniforms" Area,
            disk::DiskConcentric<T> "Uniform on the unit disk, by Shirley and Chiu's concentric map, which keeps strata compact; two uniforms" Area,
            each::Each "Several independent warps of one type side by side; their uniforms together",
            equi_angular::EquiAngular<T> "Uniform in the angle in which a light sees a segment of a ray (equi-angular sampling); one uniform" Length,
            exponential::Exponential<T> "Exponential, increasing with the uniform; one uniform" Length,
            exponential::ExponentialTail<T> "Exponential, decreasing with the uniform, to far into the tail; one uniform, drawn from two words" Length,
            frame::Frame "An orthonormal frame about a normal",
            frame::Oriented "A warp over directions, turned onto a normal",
            frustum_surface::FrustumSurface<T> "Uniform on a cylinder, a cone or a frustum, with or without its disks; two uniforms" Area,
            ggx::Ggx<T> "Normals of the microfacets of a rough surface (GGX, Trowbridge-Reitz); two uniforms" Normals,
            ggx::GgxVisible<T> "Normals of the GGX microfacets that a viewer sees; two uniforms" Normals,
            gumbel::Gumbel<T> "Gumbel, the distribution of maxima; one uniform" Length,
            hemisphere::CosineHemisphere<T> "In proportion to the cosine over the hemisphere about +z (Lambert's law), by inversion; two uniforms" SolidAngle,
            hemisphere::Hemisphere<T> "Uniform over the hemisphere about +z; two uniforms" SolidAngle,
            hemisphere::MalleyHemisphere<T> "In proportion to the cosine over the hemisphere about +z (Lambert's law), by Malley's method, which keeps strata compact; two uniforms" SolidAngle,
            henyey_greenstein::HenyeyGreenstein<T> "The Henyey-Greenstein phase function of fog, clouds and skin; two uniforms" SolidAngle,
            interval::Interval "Uniform on an interval; one uniform" Length,
            inversion::Inversion "Any density on the line, from its inverse CDF; one uniform",
            laplace::Laplace<T> "Laplace, an exponential on both sides; one uniform" Length,
            linear::Linear "Linear on [0, 1); one uniform" Length,
            log_normal::LogNormal<T> "Log-normal, the exponential of a normal number; one uniform" Length,
            logistic::Logistic<T> "Logistic, whose CDF is the sigmoid; one uniform" Length,
            phong_lobe::PhongLobe<T> "In proportion to a power of the cosine over the hemisphere about +z (the Phong lobe); two uniforms" SolidAngle,
            marginal::MarginalConditional "A density in the plane, from a marginal and its conditional; two uniforms",
            multivariate_normal::MultivariateNormal<T, N> "Several correlated normal numbers (Gaussians), of a covariance matrix that may be singular; N uniforms",
            normal::Normal<T> "Normal (Gaussian), one number at a time by its quantile; one uniform" Length,
            normal::NormalPair<T> "Two independent normals (Gaussians), by Box and Muller's map; two uniforms" Area,
            pareto::Pareto<T> "Pareto, a tail that falls as a power; one uniform" Length,
            product::Product "Two independent warps side by side; the uniforms of both",
            power::Power<T> "A power law on an interval, for any exponent; one uniform" Length,
            power_max::PowerMax "The largest of N uniforms, a power law of whole exponent; N uniforms",
            rayleigh::Rayleigh<T> "Rayleigh, the length of a vector of two normal numbers; one uniform" Length,
            reflected::Reflected<T> "Directions into which GGX microfacets reflect a view; two uniforms" SolidAngle,
            regular_polygon::RegularPolygon<T> "Uniform on a regular polygon; two uniforms" Area,
            rotation::Rotation<T> "Uniform over the rotations of space, as unit quaternions; three uniforms" Rotations,
            simplex::Simplex<T, N> "Uniform on the simplex of N dimensions: shares with sum 1; N uniforms",
            sphere::Sphere<T> "Uniform over the unit sphere; two uniforms" SolidAngle,
            spherical::Spherical<T> "A point in spherical coordinates, angles in turns",
            spherical::SphericalPatch<T> "Uniform over the directions between two polar angles and two azimuths; two uniforms" SolidAngle,
            spherical_rectangle::SphericalRectangle<T> "Uniform over the directions from a point to a rectangle; two uniforms" SolidAngle,
            spherical_triangle::SphericalTriangle<T> "Uniform over the directions from a point to a triangle (Arvo's map); two uniforms" SolidAngle,
            student_pair::StudentPair<T> "Student's t in the plane: a pair of numbers with heavy tails; two uniforms" Area,
            student_t::StudentT<T> "Student's t, heavy tails by degrees of freedom; two uniforms" Length,
            tent::Tent "The tent (triangle) filter; one uniform" Length,
            transform::Transform "A warp followed by a one-to-one map, with its Jacobian",
            triangle::Triangle "Uniform barycentric coordinates; two uniforms" Area,
            triangle_on::TriangleOn "Uniform on a triangle given by its vertices; two uniforms",
            truncated::TruncatedExponential<T> "Exponential on [0, X], falling or rising; one uniform" Length,
            truncated_logistic::TruncatedLogistic<T> "Logistic on an interval, as for wavelengths; one uniform" Length,
            truncated_normal::TruncatedNormal<T> "Normal on an interval or beyond a bound, right in the far tails; one uniform" Length,
            visible_sphere::VisibleSphere<T> "Uniform over the directions in which a sphere is seen from a point (a sphere light); two uniforms" SolidAngle,
            von_mises_fisher::VonMisesFisher<T> "The normal distribution of directions (von Mises-Fisher); two uniforms" SolidAngle,
            weibull::Weibull<T> "Weibull, life times by a shape; one uniform" Length,
        }
    };
}
pub(crate) use each_warp;

macro_rules! names {
    ($($file:ident::$name:ident $(<$tier:ident $(, $n:ident)?>)? $what:literal $($measure:ident)?,)*) => {
        $(pub use self::$file::$name;)*
    };
}
each_warp!(names);
pub use self::ggx::Reflection;
pub use self::light_sample::LightSample;
pub use self::measure::{Area, Content, Length, Measured, Normals, Rotations, SolidAngle, Volume};
pub use self::spherical_rectangle::OnRectangle;
pub use self::spherical_triangle::OnTriangle;
pub use self::surface_point::SurfacePoint;
pub use self::visible_sphere::SurfaceSample;

pub(crate) use self::contract::{Invert, Warp, drawn_with_pdf, one_by_one};
pub(crate) use self::fill::filled_in_blocks;
pub(crate) use self::measure::taken_by;
