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
//! | a waiting time for several events; a probability, shares of a whole | [`Gamma`](rejection::Gamma); [`Beta`](rejection::Beta), [`Dirichlet`](rejection::Dirichlet) |
//! | a lamp: a sphere, a triangle, a rectangle, a mesh | [`VisibleSphere`](warp::VisibleSphere), [`SphericalTriangle`](warp::SphericalTriangle), [`SphericalRectangle`](warp::SphericalRectangle), [`Mesh`](discrete::Mesh) |
//! | a rough surface | [`GgxVisible`](warp::GgxVisible), about a normal by [`Oriented`](warp::Oriented) |
//! | a place in a pixel | [`Tent`](warp::Tent) for each axis; Mitchell's or another filter by [`SignedLinear1d`](discrete::SignedLinear1d) |
//! | pixels whose errors cancel | [`Screen`](uniform::Screen) |
//! | an even spread over a square | [`Strata2d`](uniform::Strata2d) |
//! | a random order, some of many items | [`shuffle`](uniform::shuffle), [`choose`](uniform::choose) |
//! | a random order of numbers that takes no memory | [`Permutation`](uniform::Permutation) |
//! | a few points in many dimensions | [`LatinHypercube`](uniform::LatinHypercube) |
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
//! The tier is a type, chosen once. `poly` and `libm` have every warp and take the same uniforms. `fixed` has those that
//! integers serve well, under the same names.
//!
//! # Samplers
//!
//! Every warp takes a fixed number of uniforms, encoded in its type, and provides `sample`, `pdf` and
//! [`invert`](Invert).
//!
//! On the line:
//! <!-- generated: listed Line -->
//! - [`Interval`](warp::Interval): Uniform on an interval [a, b)
//! - [`Power`](warp::Power): A power law on an interval: density ∝ xⁿ on [a, b], for any exponent
//! - [`PowerMax`](warp::PowerMax): The largest of N uniforms: density N x^(N−1) on [0, 1)
//! - [`Exponential`](warp::Exponential): Exponential with rate a, increasing with the uniform: free paths, waiting
//!   times
//! - [`ExponentialTail`](warp::ExponentialTail): Exponential with rate a, decreasing with the uniform, so that samples
//!   reach far into the tail
//! - [`TruncatedExponential`](warp::TruncatedExponential): Exponential on [0, X], with a rate of either sign: density ∝
//!   e^(−cx)
//! - [`EquiAngular`](warp::EquiAngular): Equi-angular sampling along a ray: density in proportion to 1/(D² + t²), the
//!   light that a point sends to each place of a ray through fog
//! - [`Tent`](warp::Tent): The tent (triangle) filter on (−r, r): a density that falls linearly from the centre to 0 at
//!   ±r
//! - [`Linear`](warp::Linear): Linear on [0, 1): density ∝ (1 − x)a + xb
//! - [`Normal`](warp::Normal): Normal (Gaussian) with a mean and a standard deviation, one number at a time
//! - [`StudentT`](warp::StudentT): Student's t with some degrees of freedom, a location and a scale: noise with
//!   outliers, by how many of them there are
//! - [`TruncatedNormal`](warp::TruncatedNormal): Normal (Gaussian) with mean μ and standard deviation σ, restricted to
//!   an interval [a, b], of which one end may be infinite
//! - [`Cauchy`](warp::Cauchy): Cauchy (Lorentz) with a location and a scale: the shape of spectral lines, and steps
//!   with a heavy tail
//! - [`Laplace`](warp::Laplace): Laplace (double exponential) with a location and a scale: an exponential on both sides
//!   of the location
//! - [`Logistic`](warp::Logistic): Logistic with a location and a scale, whose CDF is the logistic function (sigmoid)
//! - [`TruncatedLogistic`](warp::TruncatedLogistic): Logistic with a location μ and a scale s, restricted to an
//!   interval [a, b]: wavelengths as the eye weighs them, azimuths in hair
//! - [`Gumbel`](warp::Gumbel): Gumbel with a location and a scale: the largest of many numbers whose tail is
//!   exponential
//! - [`Rayleigh`](warp::Rayleigh): Rayleigh with a scale σ: the length of a vector of two normal numbers of deviation σ
//! - [`Weibull`](warp::Weibull): Weibull with a scale λ and a shape κ: life times, wind speeds, the weakest of many
//!   links
//! - [`Pareto`](warp::Pareto): Pareto with a minimum m and a shape α: a heavy tail that falls as a power
//! - [`LogNormal`](warp::LogNormal): Log-normal with the mean μ and the standard deviation σ of the logarithm: sizes,
//!   incomes, products of many factors
//! - [`Inversion`](warp::Inversion): Any density on the line, from its inverse CDF, the density itself and its CDF
//! - [`Transform`](warp::Transform): A change of variables: a warp followed by a one-to-one map y = f(x), with the
//!   density p(x)/|J(x)|
//! <!-- end -->
//!
//! In the plane, in boxes and on surfaces:
//! <!-- generated: listed Plane -->
//! - [`NormalPair`](warp::NormalPair): Two independent normals (Gaussians) with a common standard deviation, by Box and
//!   Muller's map
//! - [`StudentPair`](warp::StudentPair): Student's t in the plane: a point whose coordinates are two Student's t of one
//!   outlier, with common degrees of freedom
//! - [`MarginalConditional`](warp::MarginalConditional): A density in the plane: x from its marginal, then y from the
//!   conditional of that x
//! - [`Composed`](warp::Composed): Two warps composed: the points of `first`, a warp of the unit square, are the
//!   uniforms of `then`
//! - [`Product`](warp::Product): Two independent warps side by side: a point of each
//! - [`Each`](warp::Each): Several independent warps of one type side by side: a point of each
//! - [`Disk`](warp::Disk): Uniform on the unit disk, by polar coordinates
//! - [`DiskConcentric`](warp::DiskConcentric): Uniform on the unit disk, by Shirley and Chiu's concentric map
//! - [`Triangle`](warp::Triangle): Uniform barycentric coordinates: the shares of the three vertices of a triangle
//! - [`MultivariateNormal`](warp::MultivariateNormal): Several correlated normal numbers (Gaussians) of a mean and a
//!   covariance matrix, which may be singular
//! - [`TriangleOn`](warp::TriangleOn): Uniform on a triangle given by its vertices, in two, three or more dimensions
//! - [`Bilinear`](warp::Bilinear): Bilinear on the unit square: density in proportion to the interpolation between four
//!   weights, one a corner
//! - [`Aabb`](warp::Aabb): Uniform in an axis-aligned box of any dimension, such as the bounding box of a region
//! - [`Annulus`](warp::Annulus): Uniform on a ring between two circles about the origin (an annulus), or on a sector of
//!   one
//! - [`Ball`](warp::Ball): Uniform in the unit ball, the solid sphere
//! - [`RegularPolygon`](warp::RegularPolygon): Uniform on a regular polygon with its corners on the unit circle, the
//!   first at (1, 0)
//! - [`Simplex`](warp::Simplex): Uniform on the simplex of N dimensions: N shares and the rest, none negative, with sum
//!   1
//! - [`BoxSurface`](warp::BoxSurface): Uniform on the surface of an axis-aligned box, by area
//! - [`FrustumSurface`](warp::FrustumSurface): Uniform on the surface of a frustum, by area: a cylinder, a cone, or a
//!   cone whose top is cut off; with its disks, or as a tube without
//! - [`CapsuleSurface`](warp::CapsuleSurface): Uniform on the surface of a capsule, by area: all points at one distance
//!   from a segment of the z axis
//! <!-- end -->
//!
//! Directions:
//! <!-- generated: listed Directions -->
//! - [`Sphere`](warp::Sphere): Uniform over the unit sphere: all directions alike
//! - [`Hemisphere`](warp::Hemisphere): Uniform over the hemisphere about +z
//! - [`CosineHemisphere`](warp::CosineHemisphere): In proportion to the cosine over the hemisphere about +z (Lambert's
//!   law), by inversion
//! - [`MalleyHemisphere`](warp::MalleyHemisphere): In proportion to the cosine over the hemisphere about +z (Lambert's
//!   law), by Malley's method
//! - [`PhongLobe`](warp::PhongLobe): In proportion to a power of the cosine over the hemisphere about +z: the Phong
//!   lobe
//! - [`HenyeyGreenstein`](warp::HenyeyGreenstein): The phase function of Henyey and Greenstein: where fog, clouds, skin
//!   or dust scatter light
//! - [`VonMisesFisher`](warp::VonMisesFisher): The von Mises-Fisher distribution: the normal distribution of
//!   directions, for glossy lobes, light guiding and noise on an orientation
//! - [`Ggx`](warp::Ggx): Normals of the microfacets of a rough surface, after Trowbridge and Reitz (GGX)
//! - [`GgxVisible`](warp::GgxVisible): Normals of GGX microfacets that a viewer sees, in proportion to their visible
//!   area
//! - [`Reflected`](warp::Reflected): Directions into which GGX microfacets reflect a view: a warp of directions out of
//!   `GgxVisible`, a warp of normals
//! - [`Cone`](warp::Cone): Uniform over the directions within an angle of +z: a cone, also called a spherical cap
//! - [`VisibleSphere`](warp::VisibleSphere): Uniform over the directions in which a sphere is seen from a point: a
//!   sphere light, sampled by solid angle
//! - [`SphericalPatch`](warp::SphericalPatch): Uniform over the directions between two polar angles and two azimuths, a
//!   rectangle of latitude and longitude
//! - [`SphericalTriangle`](warp::SphericalTriangle): Uniform over the directions from a point to a triangle: an area
//!   light, sampled by its solid angle
//! - [`SphericalRectangle`](warp::SphericalRectangle): Uniform over the directions from a point to a rectangle, or any
//!   parallelogram: an area light, sampled by its solid angle
//! - [`Oriented`](warp::Oriented): A warp over directions, turned from +z onto a given normal
//! - [`Rotation`](warp::Rotation): Uniform over the rotations of space, as unit quaternions [x, y, z, w] with w ≥ 0
//! <!-- end -->
//!
//! Beside them stand [`Frame`](warp::Frame), an orthonormal frame about a normal, and [`Spherical`](warp::Spherical) coordinates.
//!
//! Tables ([`discrete`]):
//! - [`Cdf`](discrete::Cdf), [`Alias`](discrete::Alias): an index by weight, with its exact probability and a leftover uniform
//! - [`PiecewiseConstant1d`](discrete::PiecewiseConstant1d), [`PiecewiseConstant2d`](discrete::PiecewiseConstant2d): tabulated
//!   densities
//! - [`PiecewiseLinear1d`](discrete::PiecewiseLinear1d): a tabulated density, interpolated
//! - [`SignedLinear1d`](discrete::SignedLinear1d): a tabulated function of either sign with weights, such as a pixel filter
//! - [`Mesh`](discrete::Mesh): a point on a triangle mesh, by area or by weights of its faces
//! - [`LatLongMap`](discrete::LatLongMap): directions in proportion to a picture by latitude and longitude
//! - [`select_once`](discrete::select_once), [`select_once_uniform`](discrete::select_once_uniform): one selection, without a table
//! - [`SumTree`](discrete::SumTree): an index by integer weights that change, and several without replacement
//! - [`Reservoir`](discrete::Reservoir), [`WeightedReservoir`](discrete::WeightedReservoir): one or several items of a stream
//! - [`LightReservoir`](discrete::LightReservoir): one light of many candidates; of several places by a [`Normaliser`](discrete::Normaliser)
//! - [`Geometric`](discrete::Geometric), [`Poisson`](discrete::Poisson): failures before a success, events in an interval
//! - [`Binomial`](discrete::Binomial), [`NegativeBinomial`](discrete::NegativeBinomial): successes of so many trials, failures
//!   before so many successes
//! - [`Hypergeometric`](discrete::Hypergeometric): marked items of a sample without replacement
//! - [`DiscreteGaussian`](discrete::DiscreteGaussian), [`DiscreteLaplace`](discrete::DiscreteLaplace): integers about a centre
//! - [`Mixture`](discrete::Mixture): a point of one of several warps by weight, with the density of the mixture
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
//! - [`BinomialRejection`](rejection::BinomialRejection): successes of a variance from 10 up
//! - [`HypergeometricRejection`](rejection::HypergeometricRejection): marked items of a sample, likewise
//! - [`VonMises`](rejection::VonMises): angles about a mean direction, of any concentration
//! - [`Gamma`](rejection::Gamma): gamma and chi-squared numbers of any shape, or their logarithms
//! - [`Beta`](rejection::Beta), [`Dirichlet`](rejection::Dirichlet): a share and its rest, or shares of a whole
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
//! - [`Tuning`](metropolis::Tuning): the scale of a step, found while the chain burns in; of all that is
//!   [`Scalable`](metropolis::Scalable)
//! - [`Autocorrelation`](metropolis::Autocorrelation), [`split_r_hat`](metropolis::split_r_hat), [`Draws`](metropolis::Draws): has the
//!   chain converged?
//!
//! Estimators ([`estimate`]):
//! - [`Moments`](estimate::Moments): mean and variance
//! - [`Integral`](estimate::Integral): f/p with standard error and bounds
//! - [`WeightedMean`](estimate::WeightedMean): a self-normalised mean
//! - [`balance_heuristic`](estimate::balance_heuristic), [`power_heuristic`](estimate::power_heuristic),
//!   [`balance_heuristic_of`](estimate::balance_heuristic_of), [`power_heuristic_of`](estimate::power_heuristic_of): multiple
//!   importance sampling
//! - [`roulette`](estimate::roulette()): paths that may end
//!
//! Uniforms ([`uniform`]): the 24-bit grid, open, and full resolution; [`Range`](uniform::Range) and
//! [`Chance`](uniform::Chance): integers and events of exact probabilities; [`Strata1d`](uniform::Strata1d),
//! [`Strata2d`](uniform::Strata2d).
//!
//! Points, whose words are a function of an index and a dimension ([`uniform::Points`]):
//! - [`Sobol`](uniform::Sobol): Sobol' points with Owen's scrambling, up to 8 dimensions and any number by groups
//! - [`Recurrence`](uniform::Recurrence): the additive recurrence R₂ and its kin, the cheapest
//! - [`LatinHypercube`](uniform::LatinHypercube): n points, one in each of n strata of every dimension
//! - [`ByPosition`](uniform::ByPosition): random words by seed, pixel, sample and dimension
//! - [`Screen`](uniform::Screen): one set for all pixels of a picture, in an order by which errors of neighbours cancel
//!
//! Orders and choices, in integers ([`uniform`]):
//! - [`shuffle`](uniform::shuffle), [`shuffle_each`](uniform::shuffle_each): items in a random order, by few words or in few instructions
//! - [`choose`](uniform::choose), [`ChoiceInOrder`](uniform::ChoiceInOrder), [`ChoiceOfStream`](uniform::ChoiceOfStream): k of n items, or
//!   of a stream
//! - [`Permutation`](uniform::Permutation): the numbers below n in the order of a seed, and back, without memory
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

/// A page: an integer, a coin, a shuffle, jitter, noise, seeds and logs, in one screen.
///
#[cfg(all(doc, not(doctest)))]
#[doc = include_str!("../docs/firmware.md")]
pub mod firmware {}

/// A page: lamps, rough surfaces, a sky and the weights between them, and pbrt's names beside these.
///
#[cfg(all(doc, not(doctest)))]
#[doc = include_str!("../docs/renderers.md")]
pub mod renderers {}

/// A page: HALs with another `rand_core`, seeds, and what the compiler says.
///
#[cfg(all(doc, not(doctest)))]
#[doc = include_str!("../docs/generators.md")]
pub mod generators {}

/// The examples of the README are tests too.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
#[cfg(doctest)]
#[doc = include_str!("../docs/firmware.md")]
struct Firmware;
#[cfg(doctest)]
#[doc = include_str!("../docs/renderers.md")]
struct Renderers;

/// Names the warps of one tier: aliases of the types that are generic over it, and the types that both tiers share.
macro_rules! of_tier {
    ($tier:ident; $($file:ident::$name:ident $(<$t:ident $(, $n:ident)?>)? $what:literal $($measure:ident)?,)*) => {
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
            /// [`rejection::BinomialRejection`](crate::rejection::BinomialRejection) in this tier.
            pub type BinomialRejection = crate::rejection::BinomialRejection<$tier>;
            /// [`rejection::HypergeometricRejection`](crate::rejection::HypergeometricRejection) in this tier.
            pub type HypergeometricRejection = crate::rejection::HypergeometricRejection<$tier>;
            /// [`rejection::VonMises`](crate::rejection::VonMises) in this tier.
            pub type VonMises = crate::rejection::VonMises<$tier>;
            /// [`rejection::Gamma`](crate::rejection::Gamma) in this tier.
            pub type Gamma = crate::rejection::Gamma<$tier>;
            /// [`rejection::Beta`](crate::rejection::Beta) in this tier.
            pub type Beta = crate::rejection::Beta<$tier>;
            /// [`rejection::Dirichlet`](crate::rejection::Dirichlet) in this tier.
            pub type Dirichlet<const N: usize> = crate::rejection::Dirichlet<$tier, N>;
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
