//! Monte Carlo sampling for firmware, WASM and renderers: every classical warp of uniforms onto an
//! interval, a disk, directions, a lobe or a triangle, each with its density and its inverse; discrete and
//! tabulated distributions, rejection, estimators and Metropolis chains; over `f32`, without `std` and
//! without allocation.
//!
//! A sample's way through the crate is one straight corridor, and the modules are its rooms:
//!
//! ```text
//! generator (rand_core) -> canonical uniforms -> warp -> point, density -> estimate, error
//!                          [uniform]             [warp, on a tier]         [estimate]
//!                                                table -> index, pmf, leftover uniform
//!                                                [discrete]
//!                                                tries -> point accepted, within a budget
//!                                                [rejection]
//!                                                chain -> states of any density, each from the one before
//!                                                [metropolis]
//! ```
//!
//! A warp is a pure function of explicit uniforms, so that one and the same warp serves a pseudo-random
//! generator, a stratified or low-discrepancy set, a Markov chain in the unit cube
//! ([`metropolis::primary_density`]) and a replay from a log.
//!
//! # Choosing a tier
//! The tier is chosen once, by type: `use microwarp::poly as mw;` for `f32` arithmetic alone (the
//! choice for microcontrollers and WASM), `use microwarp::libm as mw;` for the functions of the `libm`
//! crate. Both families carry the same names, take the same uniforms and state their errors warp by warp.
//! For cores without a floating-point unit there is a third, feature `fixed`: `use microwarp::fixed as mw;` takes
//! words and gives fixed-point numbers, in a thirtieth of the instructions that soft float takes on a Cortex-M0.
//!
//! ```
//! use microwarp::{Warp, poly as mw};
//! use rand_pcg::Pcg32;
//!
//! let mut rng = Pcg32::new(42, 54);
//! let lobe = mw::PhongLobe::new(50.0)?;
//! let direction = lobe.draw(&mut rng);
//! let density = lobe.pdf(direction);
//! assert!(density > 0.0);
//! # Ok::<(), microwarp::Error>(())
//! ```
//!
//! # Promises
//! - The same uniforms give the same bits on every target.
//! - Any `f32` serves as a uniform (see [`uniform::Uniforms::canonical`]) and any parameter a constructor
//!   accepted gives finite results inside the stated domain; a refused parameter is an [`Error`].
//! - Nothing panics, allocates, recurses or loops without a bound.
//! - A weight of zero is never chosen, and a table selects with the probability it reports, to the last bit.
//! - A chain never enters a state whose density is 0, NaN, infinite or negative, and a rejected step leaves it
//!   as it was, to the last bit.
//! - A sample never has density 0. (One exception, in world coordinates: the sides of a turned patch next to
//!   its pole; see [`warp::Oriented`].)
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

pub mod discrete;
#[cfg(test)]
extern crate std;

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

/// The examples of the README are tests too.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;

/// Names the warps of one tier: aliases of the types that are generic over it, and the types that both tiers share.
macro_rules! of_tier {
    ($($file:ident::$name:ident $(<$tier:ident>)? $what:literal,)*) => {
        $(of_tier!(@ $name $(<$tier>)? $what);)*
    };
    (@ $name:ident $what:literal) => {
        #[doc(inline)]
        pub use crate::warp::$name;
    };
    (@ $name:ident <T> $what:literal) => {
        #[doc = concat!(
            $what, ".\n\nSee [`warp::", stringify!($name), "`](crate::warp::", stringify!($name),
            ") for the density, the domain, the errors and examples."
        )]
        pub type $name = crate::warp::$name<Tier>;
    };
}

/// A tier as a module, so that a program names its tier once.
macro_rules! tier_module {
    ($(#[$doc:meta])* $module:ident, $tier:ident) => {
        $(#[$doc])*
        pub mod $module {
            pub use crate::tier::$tier as Tier;
            crate::warp::each_warp!(of_tier);
            /// [`metropolis::ExponentialStep`](crate::metropolis::ExponentialStep) in this tier.
            pub type ExponentialStep = crate::metropolis::ExponentialStep<Tier>;
            /// [`metropolis::LogDensity`](crate::metropolis::LogDensity) in this tier.
            pub type LogDensity = crate::metropolis::LogDensity<Tier>;
            /// [`metropolis::NormalStep`](crate::metropolis::NormalStep) in this tier.
            pub type NormalStep<X> = crate::metropolis::NormalStep<X, Tier>;
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
