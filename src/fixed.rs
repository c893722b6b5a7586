//! The integer tier: random words in, fixed-point numbers out, and no floating-point operation anywhere.
//!
//! For cores without a floating-point unit, such as a Cortex-M0, where soft float costs some thirty times as many
//! instructions. Feature `fixed`.
//!
//! ```
//! use fixed::types::{I16F16, U16F16, extra::U16};
//! use microwarp::{Warp, constant, fixed as mw};
//! use rand_pcg::Pcg32;
//!
//! // Built and checked by the compiler, kept in flash.
//! const DELAY: mw::Exponential<U16> = constant!(mw::Exponential::from_mean(U16F16::lit("2.5")));
//!
//! let mut rng = Pcg32::new(42, 54);
//! let delay = DELAY.draw(&mut rng);                      // in U16F16, as its mean
//! let [x, y] = mw::Disk::new().draw(&mut rng);           // in I2F30
//! let quick = mw::coarse::Disk::new().draw(&mut rng);    // the same to 1e-4, in fewer instructions
//! let noise = mw::NormalPair::new([I16F16::ZERO; 2], I16F16::from_num(3))?.draw(&mut rng);
//! let [a, b] = mw::Float::new(mw::Disk::new()).draw(&mut rng); // in f32, computed on integers
//! # let _ = (delay, x, y, quick, noise, a, b);
//! # Ok::<(), microwarp::Error>(())
//! ```
//!
//! # What to import
//! - `use microwarp::{Warp, fixed as mw};`: the warps, and the trait with `draw`, `sample` and `pdf`.
//!   [`Invert`](crate::Invert) has `invert`. Name the module `mw`, because its own name is also that of the crate `fixed`.
//! - `use fixed::types::U16F16;`: the formats, from the crate `fixed`. It has to be a dependency of the program as well,
//!   `fixed = { version = "1.30", default-features = false }`. Call `lit` in constants alone, as in
//!   `const { U16F16::lit("2.5") }`: at run time it links a parser, and a program for a Cortex-M0 has 8,920 bytes instead of
//!   5,388. `from_num(20)` is free of that.
//! - Any generator of `rand_core` 0.10, such as `Pcg32` of `rand_pcg`.
//!
//! # Formats
//! A format `U16F16` has 16 bits before the point and 16 behind it; its **step** is 2⁻¹⁶. All formats have 32 bits, except
//! for densities and a few parameters with 64.
//!
//! | number | type | format |
//! |---|---|---|
//! | uniform, in [0, 1) | [`Uniform`] | `U0F32`: every word is one |
//! | coordinate of a disk, a direction or a quaternion, barycentric | [`Coordinate`] | `I2F30` |
//! | standard exponential | [`Length`] | `U5F27` |
//! | standard normal | [`Deviate`] | `I5F27` |
//! | density, rate | [`Density`] | `U32F32` |
//! | a parameter with a unit, and the points it scales | Q, yours to choose | any `FixedI32` or `FixedU32` |
//!
//! # Warps
//! | warp | words | point | parameters | density |
//! |---|--:|---|---|---|
//! | [`Interval`] | 1 | `i32`, `u32`, or Q | ends | 1/(high − low), for integers the probability 1/n |
//! | [`Tent`] | 1 | Q, signed | radius, in Q | per unit of length |
//! | [`StandardExponential`] | 1 | `U5F27` | none: mean 1 | per unit of length |
//! | [`Exponential`] | 1 | Q, unsigned | mean, in Q, or rate | per unit of length |
//! | [`TruncatedExponential`] | 1 | Q, unsigned | mean, in Q, or rate; length, in Q | per unit of length |
//! | [`StandardNormalPair`] | 2 | `[I5F27; 2]` | none: mean 0, standard deviation 1 | per unit of area |
//! | [`NormalPair`] | 2 | `[Q; 2]`, signed | means and standard deviation, in Q | per unit of area |
//! | [`MultivariateNormal`] | D, or D + 1 | `[Q; D]`, signed | means and deviations, in Q; correlations in `I2F30` | per unit of content |
//! | [`Disk`] | 2 | `[I2F30; 2]` | none | 1/π |
//! | [`Annulus`] | 2 | `[Q; 2]`, signed | radii, in Q; sides in turns | 1/area |
//! | [`Bilinear`] | 2 | `[U0F32; 2]` | weights at the corners, in any `FixedU32` | per unit of area |
//! | [`Triangle`] | 2 | `[I2F30; 3]` | none | 2 |
//! | [`TriangleOn`] | 2 | `[Q; D]`, signed | vertices, in Q | 1/area |
//! | [`RegularPolygon`] | 2 | `[I2F30; 2]` | corners, in `u16` | 1/area |
//! | [`Simplex`] | N | `([I2F30; N], I2F30)` | N, in its type, up to 12 | N! |
//! | [`Sphere`], [`Hemisphere`], [`CosineHemisphere`] | 2 | `[I2F30; 3]` | none | per steradian |
//! | [`Cone`] | 2 | `[I2F30; 3]` | 1 − cos θ in `U2F62`, or a half angle in turns | per steradian |
//! | [`HenyeyGreenstein`] | 2 | `[I2F30; 3]` | g in `I2F30`, or 1 − g in `U2F62` | per steradian |
//! | [`PhongLobe`] | 2 | `[I2F30; 3]` | exponent in `U32F32` | per steradian |
//! | [`Rotation`] | 3 | `[I2F30; 4]` | none | 1/π² |
//! | [`Float`] | those of a warp | in `f32` | a warp of these | in `f32` |
//!
//! For one normal number take either of a [`NormalPair`].
//!
//! [`DiskRejection`] and [`DiskRejection16`] draw the disk by [rejection](crate::rejection), and the tables of
//! [`discrete`](crate::discrete) select by words without a floating-point operation, too.
//!
//! # Which grade
//! | grade | take it | largest errors | tables that all functions share |
//! |---|---|--:|--:|
//! | [`Fine`] | unless another suits better: `mw::Disk` | about 1e-6 | 2 KB |
//! | [`Coarse`] | for sound, light and dithering, in the fewest instructions: `mw::coarse::Disk` | about 1e-4 | the same |
//! | [`Compact`] | where flash is short: `mw::compact::Disk` | about 1e-6 | none |
//!
//! The names of this module are those of grade [`Fine`]. [`coarse`] and [`compact`] have the same names in their grades,
//! and [`mod@warp`] has them with the grade as a parameter. [`Grade`] states the errors of the elementary functions.
//!
//! # If the rest of the program uses `f32`
//! [`Float`] wraps a warp: uniforms, points and densities become `f32`, and the computation stays on integers.
//!
//! # Densities
//! A constant density is right to its step of 2⁻³². Where the density is an exponential ([`Exponential`],
//! [`TruncatedExponential`], the normal pairs, [`PhongLobe`]), its error is that of the grade's `exp_neg` relative to the
//! *peak*. Far out in a tail few digits are left, or none, though the density of a sample is never 0. Where densities
//! vary by more than 10⁶, compute with logarithms, or in a float tier.
//!
//! # Stated errors
//! The table of each warp states the largest errors for all parameters, all formats and all words, as a number or as a
//! formula. Each page explains its rows and names. Rms and mean are those of the parameter sets that the tests list. An
//! adversary in the tests searches for worse cases. The last column says of [which kind](crate::warp#stated-errors) a bound
//! is: proven, exhaustive or found.

#![expect(
    clippy::arithmetic_side_effects,
    clippy::cast_possible_wrap,
    reason = "plain operators never overflow here: builds with overflow checks try them at the extremes"
)]

// What is drawn can be logged.
#[cfg(feature = "defmt")]
const _: fn() = {
    const fn logs<T: defmt::Format>() {}
    logs::<::fixed::types::U16F16>
};

mod annulus;
mod bilinear;
mod bits;
mod cone;
mod direction;
mod disk;
mod exponential;
mod float;
mod formats;
mod grade;
mod hemisphere;
mod henyey_greenstein;
mod interval;
mod kernel;
mod lobe;
mod minors;
mod multivariate_normal;
mod normal;
mod number;
mod rayleigh;
mod regular_polygon;
mod rejection;
mod rotation;
mod simplex;
mod sphere;
mod symmetric;
mod tent;
mod triangle;
mod triangle_on;
mod truncated;

pub use self::float::{Float, FloatPoint, FloatUniforms};
pub use self::formats::{Coordinate, Density, Deviate, Length, Uniform};
pub use self::grade::{Coarse, Compact, Fine, Grade};
pub use self::rejection::{DiskRejection, DiskRejection16};

pub use self::interval::Interval;
pub use self::number::Number;

use crate::warp::{Content, Measured, Rotations, SolidAngle};

/// Every warp with a grade in one line: its file, its name, its other parameters (as declared and as named), and what it
/// is.
macro_rules! each_warp {
    ($then:ident $($grade:ident)?) => {
        $then! { $($grade;)?
            annulus::Annulus[Frac][Frac] "Uniform on a ring between two circles (an annulus), or on a sector of it; two words",
            bilinear::Bilinear "Bilinear between four weights at the corners of the unit square; two words",
            cone::Cone "Uniform over the directions within an angle of +z (a cone, or spherical cap); two words",
            disk::Disk "Uniform on the unit disk, by polar coordinates; two words",
            exponential::Exponential[Frac][Frac] "Exponential with a given mean or rate, increasing with the uniform; one word",
            exponential::StandardExponential "Exponential with mean 1, increasing with the uniform; one word",
            hemisphere::CosineHemisphere "In proportion to the cosine over the hemisphere about +z (Lambert's law); two words",
            hemisphere::Hemisphere "Uniform over the hemisphere about +z; two words",
            henyey_greenstein::HenyeyGreenstein "The phase function of Henyey and Greenstein, of fog, clouds and skin; two words",
            lobe::PhongLobe "In proportion to a power of the cosine over the hemisphere about +z (the Phong lobe); two words",
            multivariate_normal::MultivariateNormal[Frac, const D: usize][Frac, D] "Several correlated normal numbers (Gaussians), of deviations and correlations, which may be singular; D words, of an odd D one more",
            normal::NormalPair[Frac][Frac] "Two independent normals (Gaussians) with a mean point and a standard deviation; two words",
            normal::StandardNormalPair "Two independent normals (Gaussians) of mean 0 and standard deviation 1; two words",
            rayleigh::Rayleigh[Frac][Frac] "The Rayleigh distribution, the distance of two normals from their mean; one word",
            regular_polygon::RegularPolygon "Uniform on a regular polygon with its corners on the unit circle; two words",
            rotation::Rotation "Uniform over all rotations of space, as unit quaternions; three words",
            simplex::Simplex[const N: usize][N] "Uniform on the simplex: N shares of 1 and the rest; N words",
            sphere::Sphere "Uniform over the unit sphere; two words",
            symmetric::Laplace[Frac][Frac] "Laplace's distribution, exponential on either side; one word",
            symmetric::Logistic[Frac][Frac] "The logistic distribution, a bell with heavier tails than the normal one's; one word",
            tent::Tent[Frac][Frac] "The tent (triangle) filter; one word",
            triangle::Triangle "Uniform barycentric coordinates; two words",
            triangle_on::TriangleOn[Frac, const D: usize][Frac, D] "Uniform on a triangle given by its vertices; two words",
            truncated::TruncatedExponential[Frac][Frac] "Exponential on [0, length), given its mean or rate; one word",
        }
    };
}

macro_rules! graded {
    ($($file:ident::$name:ident $([$($declared:tt)*] [$($named:tt)*])? $what:literal,)*) => {
        $(pub use super::$file::$name;)*
    };
}

/// The warps of this tier, with their grade as a parameter. The aliases of [`fixed`](crate::fixed),
/// [`coarse`] and [`compact`] fill it in.
pub mod warp {
    pub use super::interval::Interval;
    each_warp!(graded);
}

crate::warp::taken_by! {
    [Frac, G] warp::Annulus<Frac, G>: Content<2>;
    [G] warp::Bilinear<G>: Content<2>;
    [G] warp::Cone<G>: SolidAngle;
    [G] warp::Disk<G>: Content<2>;
    [Frac, G] warp::Exponential<Frac, G>: Content<1>;
    [G] warp::StandardExponential<G>: Content<1>;
    [G] warp::CosineHemisphere<G>: SolidAngle;
    [G] warp::Hemisphere<G>: SolidAngle;
    [G] warp::HenyeyGreenstein<G>: SolidAngle;
    [G] warp::PhongLobe<G>: SolidAngle;
    [Frac, const D: usize, G] warp::MultivariateNormal<Frac, D, G>: Content<D>;
    [Frac, G] warp::NormalPair<Frac, G>: Content<2>;
    [G] warp::StandardNormalPair<G>: Content<2>;
    [Frac, G] warp::Rayleigh<Frac, G>: Content<1>;
    [G] warp::RegularPolygon<G>: Content<2>;
    [G] warp::Rotation<G>: Rotations;
    [const N: usize, G] warp::Simplex<N, G>: Content<N>;
    [G] warp::Sphere<G>: SolidAngle;
    [Frac, G] warp::Laplace<Frac, G>: Content<1>;
    [Frac, G] warp::Logistic<Frac, G>: Content<1>;
    [Frac, G] warp::Tent<Frac, G>: Content<1>;
    [G] warp::Triangle<G>: Content<2>;
    [Frac, const D: usize, G] warp::TriangleOn<Frac, D, G>: Content<2>;
    [Frac, G] warp::TruncatedExponential<Frac, G>: Content<1>;
    [T] Interval<T>: Content<1>;
    [W: Measured] Float<W>: W::Measure;
}

/// Aliases of the warps in one grade, so that a program names its grade once.
macro_rules! in_grade {
    ($grade:ident; $($file:ident::$name:ident $([$($declared:tt)*] [$($named:tt)*])? $what:literal,)*) => {$(
        #[doc = concat!($what, ". This is [`", stringify!($name), "`](crate::fixed::warp::", stringify!($name), ") in grade [`", stringify!($grade), "`](crate::fixed::", stringify!($grade), ").")]
        pub type $name $(<$($declared)*>)? = $crate::fixed::warp::$name<$($($named)*,)? $crate::fixed::$grade>;
    )*};
}

each_warp!(in_grade Fine);

/// The warps in grade [`Coarse`]: errors about 1e-4, in the fewest instructions.
pub mod coarse {
    pub use super::{Float, Interval};
    each_warp!(in_grade Coarse);
}

/// The warps in grade [`Compact`]: errors about 1e-6 without tables, in the least flash.
pub mod compact {
    pub use super::{Float, Interval};
    each_warp!(in_grade Compact);
}
