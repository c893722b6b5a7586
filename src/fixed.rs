//! The integer tier: words in, fixed-point numbers out, and no floating-point operation anywhere.
//!
//! Here live the warps for cores without a floating-point unit, the integer kernels they stand on, and what of
//! the other rooms runs on integers alone. Feature `fixed`. Say the tier once, by `use microwarp::fixed as mw;`.
//!
//! ```
//! use fixed::types::{I16F16, U16F16};
//! use microwarp::{Warp, fixed as mw};
//! use rand_pcg::Pcg32;
//!
//! let mut rng = Pcg32::new(42, 54);
//! let [x, y] = mw::Disk::new().draw(&mut rng);           // in I2F30
//! let quick = mw::coarse::Disk::new().draw(&mut rng);    // the same to 1e-4, in fewer instructions
//! let waiting = mw::Exponential::from_mean(U16F16::from_num(2.5))?.draw(&mut rng);
//! let noise = mw::NormalPair::new([I16F16::ZERO; 2], I16F16::from_num(3))?.draw(&mut rng);
//! let [a, b] = mw::Float::new(mw::Disk::new()).draw(&mut rng); // in f32, out of integers
//! # let _ = (x, y, quick, waiting, noise, a, b);
//! # Ok::<(), microwarp::Error>(())
//! ```
//!
//! # Warps
//! Every uniform is a word, [`Uniform`]; every density a [`Density`], whose steps are 2⁻³². Q stands for any format of 32
//! bits of the `fixed` crate, the parameters' own.
//!
//! | warp | words | point | parameters | density |
//! |---|--:|---|---|---|
//! | [`Interval`] | 1 | `i32`, `u32`, or Q | ends | 1/(b − a), of integers the probability 1/n |
//! | [`Tent`] | 1 | Q, signed | radius, in Q | per unit of length |
//! | [`StandardExponential`] | 1 | `U5F27` | none: mean 1 | per unit of length |
//! | [`Exponential`] | 1 | Q, unsigned | mean, in Q | per unit of length |
//! | [`TruncatedExponential`] | 1 | Q, unsigned | mean and length, in Q | per unit of length |
//! | [`StandardNormalPair`] | 2 | `[I5F27; 2]` | none: mean 0, deviation 1 | per unit of area |
//! | [`NormalPair`] | 2 | `[Q; 2]`, signed | means and deviation, in Q | per unit of area |
//! | [`Disk`] | 2 | `[I2F30; 2]` | none | 1/π |
//! | [`Triangle`] | 2 | `[I2F30; 3]` | none | 2 |
//! | [`TriangleOn`] | 2 | `[Q; D]`, signed | vertices, in Q | 1/area |
//! | [`Sphere`], [`Hemisphere`], [`CosineHemisphere`] | 2 | `[I2F30; 3]` | none | per steradian |
//! | [`Cone`] | 2 | `[I2F30; 3]` | 1 − cos θ in `U2F62`, or an angle in turns | per steradian |
//! | [`PhongLobe`] | 2 | `[I2F30; 3]` | exponent in `U32F32` | per steradian |
//! | [`Float`] | those of a warp | in `f32` | a warp of these | in `f32` |
//!
//! # Densities
//! Every warp has one, since an estimator divides by it, but a density in fixed point has its limits. Where it is constant it
//! is as good as its steps of 2⁻³². Where it is an exponential ([`Exponential`], [`TruncatedExponential`], the normal
//! pairs, [`PhongLobe`]) the error of the grade's `exp_neg` is a part of the peak, not of the value: far out in a tail
//! few digits or none are left, though it is never 0 at a sample. Where values vary by more than 10⁶, take logarithms
//! of one's own, or a float tier.
//!
//! # Errors
//! The table of each warp states the largest errors for all parameters, all formats and all words, as a number or as a
//! formula in what is named above it; rms and mean are those of the sets that the tests list. An adversary in the tests searches
//! for worse.
//!
//! # Grades
//! The names here are those of grade [`Fine`]; [`coarse`] and [`compact`] have the same names in theirs, and [`mod@warp`]
//! has them with the grade as a parameter. [`Grade`] states the errors of the functions, each warp its own.
//!
//! | grade | largest errors | tables that all share |
//! |---|--:|--:|
//! | [`Fine`] | about 1e-6 | 2 KB |
//! | [`Coarse`] | about 1e-4 | the same |
//! | [`Compact`] | about 1e-6 | none |

#![expect(
    clippy::arithmetic_side_effects,
    clippy::cast_possible_wrap,
    reason = "plain operators never overflow here: builds with overflow checks try them at the extremes"
)]

mod cone;
mod direction;
mod disk;
mod exponential;
mod float;
mod formats;
mod grade;
mod hemisphere;
mod interval;
mod kernel;
mod lobe;
mod minors;
mod normal;
mod number;
mod rejection;
mod sphere;
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

/// Every warp with a grade in one line: where it is, its name, and other parameters, as declared and as named.
macro_rules! each_warp {
    ($then:ident $($grade:ident)?) => {
        $then! { $($grade;)?
            cone::Cone,
            disk::Disk,
            exponential::Exponential[Frac][Frac],
            exponential::StandardExponential,
            hemisphere::CosineHemisphere,
            hemisphere::Hemisphere,
            lobe::PhongLobe,
            normal::NormalPair[Frac][Frac],
            normal::StandardNormalPair,
            sphere::Sphere,
            tent::Tent[Frac][Frac],
            triangle::Triangle,
            triangle_on::TriangleOn[Frac, const D: usize][Frac, D],
            truncated::TruncatedExponential[Frac][Frac],
        }
    };
}

macro_rules! graded {
    ($($file:ident::$name:ident $([$($declared:tt)*] [$($named:tt)*])?,)*) => {
        $(pub use super::$file::$name;)*
    };
}

/// The warps of this tier with their grade as a parameter; the aliases beside this module name it.
pub mod warp {
    pub use super::interval::Interval;
    each_warp!(graded);
}

/// Names the warps in one grade, so that a program says its grade once.
macro_rules! in_grade {
    ($grade:ident; $($file:ident::$name:ident $([$($declared:tt)*] [$($named:tt)*])?,)*) => {$(
        #[doc = concat!("[`warp::", stringify!($name), "`](crate::fixed::warp::", stringify!($name), ") in this grade.")]
        pub type $name $(<$($declared)*>)? = $crate::fixed::warp::$name<$($($named)*,)? $crate::fixed::$grade>;
    )*};
}

each_warp!(in_grade Fine);

/// The warps in grade [`Coarse`].
pub mod coarse {
    pub use super::{Float, Interval};
    each_warp!(in_grade Coarse);
}

/// The warps in grade [`Compact`].
pub mod compact {
    pub use super::{Float, Interval};
    each_warp!(in_grade Compact);
}
