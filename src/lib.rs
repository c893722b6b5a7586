//! Monte Carlo sampling for firmware, WASM and renderers: `no_std`, without allocation, with the same bits on every
//! target and a measured error bound for every function.
//!
//! ```
//! use microwarp::{Warp, poly as mw};
//! use rand_pcg::Pcg32; // or any other generator of rand_core 0.10
//!
//! let mut rng = Pcg32::new(42, 54);
//! let lobe = mw::PhongLobe::new(50.0)?;
//! let direction = lobe.draw(&mut rng);        // from a generator
//! let other = lobe.sample([0.25, 0.75]);      // from uniforms of your own
//! let density = lobe.pdf(direction);
//! assert!(density > 0.0);
//! # let _ = other;
//! # Ok::<(), microwarp::Error>(())
//! ```
//!
//! # Which one do I take?
//!
//! | for | take |
//! |---|---|
//! | a core with an FPU, WASM, a PC | [`poly`]: `use microwarp::poly as mw;` |
//! | a core without an FPU | feature `fixed`: `use microwarp::fixed as mw;` |
//! | the last bits of logarithms | [`libm`]: `use microwarp::libm as mw;` |
//! | an integer of a range, an index, a die | [`Range`](uniform::Range), [`up_to`](uniform::up_to()) |
//! | a coin, an event of a given probability | [`Chance`](uniform::Chance) |
//! | one uniform number in [0, 1) | [`grid`](uniform::grid), or [`full`](uniform::full) with every digit of an `f32` |
//! | a slice of normal or exponential numbers | `fill` of [`NormalPair`](warp::NormalPair), of [`Exponential`](warp::Exponential) |
//! | one normal or exponential number from a generator | [`ZigguratNormal`](rejection::ZigguratNormal), [`ZigguratExponential`](rejection::ZigguratExponential); the number of words varies |
//! | normal numbers from your own uniforms | [`NormalPair`](warp::NormalPair) for two, [`Normal`](warp::Normal) for one, which keeps the order of strata |
//! | normal numbers without an FPU | `fixed::NormalPair`; for one, either of the two |
//! | a lamp: a sphere, a triangle, a rectangle, a mesh | [`VisibleSphere`](warp::VisibleSphere), [`SphericalTriangle`](warp::SphericalTriangle), [`SphericalRectangle`](warp::SphericalRectangle), [`Mesh`](discrete::Mesh) |
//! | a rough surface | [`GgxVisible`](warp::GgxVisible), about a normal by [`Oriented`](warp::Oriented) |
//! | a place in a pixel | [`Tent`](warp::Tent) for each axis; another filter as a [`PiecewiseConstant2d`](discrete::PiecewiseConstant2d) |
//! | an even spread over a square | [`Strata2d`](uniform::Strata2d) |
//! | one of many generators, by its number | [`ByPosition`](uniform::ByPosition) [seeds it](uniform#many-generators) |
//! | an index by weight, few draws per table | [`select_once`](discrete::select_once) |
//! | an index by weight, many draws | [`Cdf`](discrete::Cdf) up to some 8 entries (100 on a PC), [`Alias`](discrete::Alias) beyond |
//! | a picture, a histogram, a curve | [`PiecewiseConstant2d`](discrete::PiecewiseConstant2d), [`PiecewiseConstant1d`](discrete::PiecewiseConstant1d), [`PiecewiseLinear1d`](discrete::PiecewiseLinear1d) |
//! | an environment map, a light all around | [`LatLongMap`](discrete::LatLongMap) |
//! | particles by weight, as many as before | [`resampling`](discrete::resampling) |
//! | a shape with a simple test | [`Region`](rejection::Region) |
//! | a density known up to a factor | [`Chain`](metropolis::Chain) |
//! | fewer samples for the same error | [`Sobol`](uniform::Sobol) points instead of a generator |
//!
//! Gamma, beta, binomial, Student and Dirichlet numbers are not here. Take `rand_distr`, which runs on the same generators.
//!
//! The tier is a type, chosen once. `poly` and `libm` have every warp and take the same uniforms. `fixed` has those that
//! integers serve well, under the same names.
//!
//! # Samplers
//!
//! Every warp takes a fixed number of uniforms, encoded in its type, and provides `sample`, `pdf` and
//! [`invert`](Invert).
//!
//! On the line:
//! - [`Interval`](warp::Interval): uniform between two numbers, in either orientation
//! - [`Power`](warp::Power): a power law on an interval
//! - [`PowerMax`](warp::PowerMax): the largest of N uniforms
//! - [`Linear`](warp::Linear): a linear density on [0, 1)
//! - [`Tent`](warp::Tent): the tent filter
//! - [`Exponential`](warp::Exponential), [`ExponentialTail`](warp::ExponentialTail): exponential, from 0 or from the tail
//! - [`TruncatedExponential`](warp::TruncatedExponential): exponential on an interval, rising or falling
//! - [`Normal`](warp::Normal): normal, one number at a time
//! - [`TruncatedNormal`](warp::TruncatedNormal): normal on an interval or beyond a bound
//! - [`LogNormal`](warp::LogNormal): the exponential of a normal number
//! - [`Laplace`](warp::Laplace), [`Logistic`](warp::Logistic), [`Cauchy`](warp::Cauchy): symmetric, with heavier tails
//! - [`Gumbel`](warp::Gumbel), [`Weibull`](warp::Weibull): extremes and life times
//! - [`Rayleigh`](warp::Rayleigh): lengths of normal vectors
//! - [`Pareto`](warp::Pareto): a tail that falls as a power
//! - [`EquiAngular`](warp::EquiAngular): along a ray, uniform in the angle in which a light sees it
//! - [`Inversion`](warp::Inversion): your own inverse CDF
//!
//! In the plane and in boxes:
//! - [`Disk`](warp::Disk), [`DiskConcentric`](warp::DiskConcentric): uniform on the unit disk
//! - [`Triangle`](warp::Triangle), [`TriangleOn`](warp::TriangleOn): uniform barycentric coordinates, or a point on
//!   a triangle in the plane or in space
//! - [`Annulus`](warp::Annulus), [`RegularPolygon`](warp::RegularPolygon): uniform on a ring or its sector, on a regular polygon
//! - [`NormalPair`](warp::NormalPair): two independent normal numbers
//! - [`Aabb`](warp::Aabb): uniform in a box of any dimension
//! - [`Ball`](warp::Ball), [`Simplex`](warp::Simplex): uniform in the unit ball, on the simplex of any dimension
//! - [`Bilinear`](warp::Bilinear): bilinear on the unit square, by weights at its corners
//! - [`MarginalConditional`](warp::MarginalConditional): a marginal and the conditional at its point
//! - [`Composed`](warp::Composed): any warp of two uniforms, weighted by another on the unit square
//! - [`BoxSurface`](warp::BoxSurface), [`FrustumSurface`](warp::FrustumSurface), [`CapsuleSurface`](warp::CapsuleSurface):
//!   uniform on a box, a cylinder or cone, a capsule, with the normal
//!
//! Directions:
//! - [`Sphere`](warp::Sphere), [`Hemisphere`](warp::Hemisphere): uniform
//! - [`CosineHemisphere`](warp::CosineHemisphere), [`MalleyHemisphere`](warp::MalleyHemisphere): proportional to the cosine
//! - [`PhongLobe`](warp::PhongLobe): proportional to a power of the cosine
//! - [`HenyeyGreenstein`](warp::HenyeyGreenstein): the phase function of fog, clouds and skin
//! - [`VonMisesFisher`](warp::VonMisesFisher): the normal distribution of directions
//! - [`Ggx`](warp::Ggx), [`GgxVisible`](warp::GgxVisible): normals of rough microfacets, all or those that a viewer sees
//! - [`Cone`](warp::Cone): uniform within an angle of +z
//! - [`VisibleSphere`](warp::VisibleSphere): uniform over the directions in which a sphere is seen (a sphere light)
//! - [`SphericalPatch`](warp::SphericalPatch): uniform between two polar angles and two azimuths
//! - [`SphericalTriangle`](warp::SphericalTriangle), [`SphericalRectangle`](warp::SphericalRectangle): uniform over the
//!   directions to an area light
//! - [`Rotation`](warp::Rotation): uniform over all rotations, as unit quaternions
//! - [`Oriented`](warp::Oriented): any of these about a normal, by a [`Frame`](warp::Frame)
//! - [`Transform`](warp::Transform): any warp followed by your own one-to-one map; [`Spherical`](warp::Spherical)
//!   coordinates
//!
//! Tables ([`discrete`]):
//! - [`Cdf`](discrete::Cdf), [`Alias`](discrete::Alias): an index by weight, with its exact probability and a leftover uniform
//! - [`PiecewiseConstant1d`](discrete::PiecewiseConstant1d), [`PiecewiseConstant2d`](discrete::PiecewiseConstant2d): tabulated
//!   densities
//! - [`PiecewiseLinear1d`](discrete::PiecewiseLinear1d): a tabulated density, interpolated
//! - [`Mesh`](discrete::Mesh): a point on a triangle mesh, by area or by weights of its faces
//! - [`LatLongMap`](discrete::LatLongMap): directions in proportion to a picture by latitude and longitude
//! - [`select_once`](discrete::select_once), [`select_once_uniform`](discrete::select_once_uniform): one selection, without a table
//! - [`Reservoir`](discrete::Reservoir): one item of a stream
//! - [`Geometric`](discrete::Geometric), [`Poisson`](discrete::Poisson): failures before a success, events in an interval
//! - [`resampling`](discrete::resampling): systematic, stratified and residual resampling of particles, in place
//!
//! Rejection within a budget of tries ([`rejection`]):
//! - [`Region`](rejection::Region): uniform where a predicate holds
//! - [`Bounded`](rejection::Bounded): a density below a multiple of another
//! - [`DiskRejection`](rejection::DiskRejection), [`BallRejection`](rejection::BallRejection): disk and ball without a root or an angle
//! - [`ZigguratStandardNormal`](rejection::ZigguratStandardNormal), [`ZigguratNormal`](rejection::ZigguratNormal),
//!   [`ZigguratStandardExponential`](rejection::ZigguratStandardExponential),
//!   [`ZigguratExponential`](rejection::ZigguratExponential): the fastest for one number from a generator
//! - [`PoissonRejection`](rejection::PoissonRejection): events of a mean number from 10 up
//!
//! Markov chains ([`metropolis`]):
//! - [`Chain`](metropolis::Chain): states of any density, or of integer weights, in fixed memory
//! - [`UniformStep`](metropolis::UniformStep), [`UniformIndex`](metropolis::UniformIndex),
//!   [`Independence`](metropolis::Independence), [`TransitionTable`](metropolis::TransitionTable): proposals that forget the state, or take it
//!   from a table
//! - [`BoxStep`](metropolis::BoxStep), [`NormalStep`](metropolis::NormalStep),
//!   [`LogUniformStep`](metropolis::LogUniformStep), [`RandomWalk`](metropolis::RandomWalk),
//!   [`WrappedWalk`](metropolis::WrappedWalk): random walks in ℝᴰ and in the unit cube
//! - [`Subset`](metropolis::Subset), [`OneCoordinate`](metropolis::OneCoordinate), [`Product`](metropolis::Product),
//!   [`Mixture`](metropolis::Mixture): combinations
//! - [`WithPayload`](metropolis::WithPayload): what else the target finds, kept with the state
//! - [`Autocorrelation`](metropolis::Autocorrelation), [`split_r_hat`](metropolis::split_r_hat): has the chain converged?
//!
//! Estimators ([`estimate`]):
//! - [`Moments`](estimate::Moments): mean and variance
//! - [`Integral`](estimate::Integral): f/p with standard error and bounds
//! - [`WeightedMean`](estimate::WeightedMean): a self-normalised mean
//! - [`balance_heuristic`](estimate::balance_heuristic), [`power_heuristic`](estimate::power_heuristic): multiple importance
//!   sampling
//!
//! Uniforms ([`uniform`]): the 24-bit grid, open, and full resolution; [`Range`](uniform::Range) and
//! [`Chance`](uniform::Chance): integers and events of exact probabilities; [`Strata1d`](uniform::Strata1d),
//! [`Strata2d`](uniform::Strata2d).
//!
//! Points, whose words are a function of an index and a dimension ([`uniform::Points`]):
//! - [`Sobol`](uniform::Sobol): Sobol' points with Owen's scrambling, up to 8 dimensions and any number by groups
//! - [`Recurrence`](uniform::Recurrence): the additive recurrence R₂ and its kin, the cheapest
//! - [`ByPosition`](uniform::ByPosition): random words by seed, pixel, sample and dimension
//!
//! # Generators
//! [`Warp::draw`] takes any generator of `rand_core` 0.10, and [`Warp::try_draw`] one that can fail. Many HALs still implement
//! `rand_core` 0.6 or 0.9: features `rand_core_06` and `rand_core_09` bring the wrappers `Rng06`,
//! `TryRng06` and `Rng09` to [`uniform`]. A closure becomes a generator by [`FromFn`](uniform::FromFn). The page [`generators`] lists HALs, versions and
//! compiler errors.
//!
//! # Features
//! None is on by default, and no feature changes a number.
//! - `fixed`: the integer tier, over the types of the `fixed` crate
//! - `alloc`: tables in a `Vec` or a `Box`
//! - `rand_core_06`, `rand_core_09`: generators of HALs that implement older versions of `rand_core`
//! - `defmt`: `defmt::Format` on every public type
//!
//! # Constants
//! [`constant!`] makes a sampler or a table at compile time, in flash. The compiler reports a bad parameter.
//! ```
//! use microwarp::{constant, discrete::Cdf};
//! const DIE: Cdf<[u32; 6]> = constant!(Cdf::from_integers(&[1, 1, 1, 1, 1, 3]));
//! assert_eq!(DIE.pmf(5), 0.375);
//! ```
//!
//! # Stated errors
//! Each warp's page has a table of error bounds that hold for every accepted parameter. The module [`warp`] explains
//! its rows and units.
//!
//! # Promises
//! - The same uniforms give the same bits on every target: x86-64, AArch64, Cortex-M, RISC-V and WASM.
//! - Any `f32` serves as a uniform (see [`uniform::Uniforms::canonical`]). Any parameter a constructor
//!   accepted gives finite results inside the stated domain. A refused parameter is an [`Error`].
//! - Nothing panics, allocates, recurses or loops without a bound.
//! - A weight of zero is never chosen, and a table selects with exactly the probability it reports.
//! - A chain never enters a state whose density is 0, NaN, infinite or negative. A rejected step leaves it
//!   unchanged, to the last bit.
//! - A sample never has density 0. (One exception, in world coordinates: the sides of a rotated patch next to
//!   its pole; see [`Oriented`](warp::Oriented).)
#![no_std]
#![deny(unsafe_code, missing_docs)]
#![warn(
    missing_debug_implementations,
    missing_copy_implementations,
    unreachable_pub,
    unused_qualifications,
    clippy::pedantic
)]
#![allow(
    clippy::many_single_char_names,
    clippy::similar_names,
    reason = "formulas keep the letters of their sources"
)]
#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_precision_loss,
    clippy::cast_sign_loss,
    reason = "the range of what is cast is stated beside each cast"
)]
#![deny(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    clippy::unreachable,
    clippy::todo,
    clippy::unimplemented,
    clippy::indexing_slicing,
    clippy::string_slice,
    clippy::arithmetic_side_effects,
    clippy::integer_division_remainder_used
)]

#[cfg(feature = "alloc")]
extern crate alloc;
#[cfg(test)]
extern crate std;

pub mod discrete;
mod error;
pub mod estimate;
#[cfg(feature = "fixed")]
pub mod fixed;
pub mod metropolis;
mod num;
pub mod rejection;
pub mod tier;
pub mod uniform;
pub mod warp;

pub use error::Error;
pub use warp::contract::{Invert, Warp};

/// A page: HALs with another `rand_core`, seeds, and what the compiler says.
///
#[cfg(all(doc, not(doctest)))]
#[doc = include_str!("../docs/generators.md")]
pub mod generators {}

/// The examples of the README are tests too.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;

/// Names the warps of one tier: aliases of the types that are generic over it, and the types that both tiers share.
macro_rules! of_tier {
    ($tier:ident; $($file:ident::$name:ident $(<$t:ident $(, $n:ident)?>)? $what:literal,)*) => {
        $(of_tier!(@ $tier $name $(<$t $(, $n)?>)? $what);)*
    };
    (@ $tier:ident $name:ident $what:literal) => {
        #[doc(inline)]
        pub use crate::warp::$name;
    };
    (@ $tier:ident $name:ident <T> $what:literal) => {
        #[doc = concat!(
            $what, ".\n\nSee [`warp::", stringify!($name), "`](crate::warp::", stringify!($name),
            ") for the density, the domain, the errors and examples."
        )]
        pub type $name = crate::warp::$name<$tier>;
    };
    (@ $tier:ident $name:ident <T, N> $what:literal) => {
        #[doc = concat!(
            $what, ".\n\nSee [`warp::", stringify!($name), "`](crate::warp::", stringify!($name),
            ") for the density, the domain, the errors and examples."
        )]
        pub type $name<const N: usize> = crate::warp::$name<$tier, N>;
    };
}

/// A tier as a module, so that a program names its tier once.
macro_rules! tier_module {
    ($(#[$doc:meta])* $module:ident, $tier:ident) => {
        $(#[$doc])*
        pub mod $module {
            use crate::tier::$tier;
            crate::warp::each_warp!(of_tier $tier);
            /// [`discrete::LatLongMap`](crate::discrete::LatLongMap) in this tier.
            pub type LatLongMap<M, C> = crate::discrete::LatLongMap<$tier, M, C>;
            /// [`rejection::PoissonRejection`](crate::rejection::PoissonRejection) in this tier.
            pub type PoissonRejection = crate::rejection::PoissonRejection<$tier>;
            /// [`metropolis::LogUniformStep`](crate::metropolis::LogUniformStep) in this tier.
            pub type LogUniformStep = crate::metropolis::LogUniformStep<$tier>;
            /// [`metropolis::LogDensity`](crate::metropolis::LogDensity) in this tier.
            pub type LogDensity = crate::metropolis::LogDensity<$tier>;
            /// [`metropolis::NormalStep`](crate::metropolis::NormalStep) in this tier.
            pub type NormalStep<X> = crate::metropolis::NormalStep<X, $tier>;
        }
    };
}

tier_module! {
    /// The warps of the reference tier, over the `libm` crate.
    libm, Libm
}

tier_module! {
    /// The warps of the polynomial tier: `f32` arithmetic alone.
    poly, Poly
}
