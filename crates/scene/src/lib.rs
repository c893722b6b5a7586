//! A path tracer for a desk, a browser and a core without a floating-point unit: no `std`, no heap, no panic, and the same
//! bits everywhere. Shapes are few, because sampling is the point. Everything random comes from microwarp.
//!
//! A [`Scene`] is made of ingredients chosen by type: its materials, its lights, its [`Sky`] and its [`Fog`]. What a scene
//! does not name is not linked. A path is generic over two more types: the [`Kit`], which says by which samplers and hence in
//! which tier, and the [`Source`], which says from which points.
//!
//! | what is random | by |
//! |---|---|
//! | points for all pixels of a picture | `Screen` of `Sobol` |
//! | place in the pixel | `Tent` |
//! | place on the lens | `RegularPolygon` |
//! | which light | `Cdf` |
//! | direction to a rectangle, to a sphere, to the sky | `SphericalRectangle`, `VisibleSphere`, `LatLongMap` |
//! | reflection: matte, glossy, rough metal | `CosineHemisphere`, `PhongLobe`, `GgxVisible` |
//! | distance in fog | `TruncatedExponential` and `EquiAngular`, weighted together |
//! | scattering in fog | `HenyeyGreenstein` |
//! | paths from paths, in Metropolis light transport | `Chain` of a `Mixture` of `Product`s and a mutation of its own |
//!
//! Lengths are in metres and z is up. Radiance has three channels, red, green and blue.
#![no_std]
#![forbid(unsafe_code)]
#![deny(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    clippy::indexing_slicing,
    clippy::arithmetic_side_effects,
    clippy::integer_division_remainder_used
)]

pub mod camera;
pub mod film;
pub mod fog;
pub mod golden;
#[cfg(feature = "fixed")]
pub mod integers;
pub mod kit;
pub mod light;
pub mod material;
pub mod metropolis;
pub mod numbered;
pub mod path;
pub mod picture;
pub mod scenes;
pub mod shape;
pub mod shift;
pub mod sky;
pub mod source;
pub mod vector;

pub use camera::{Camera, View};
pub use film::{Colour, Echo, Film};
pub use fog::{Clear, Fog, Haze};
#[cfg(feature = "fixed")]
pub use integers::Integers;
pub use kit::Kit;
pub use light::{Choice, Lamp, Light};
pub use material::Material;
pub use metropolis::{Run, Walk};
pub use path::{Balance, Heuristic, LightOnly, LobeOnly, Power, Scene};
pub use picture::{Hash, Plan};
pub use shape::{Quad, Ray, Shape, Sphere};
pub use shift::Shift;
pub use sky::{NoSky, Sky};
pub use source::{Numbers, Random, Set, Source};
