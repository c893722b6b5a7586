//! What a density is taken by: a length, an area, a solid angle. Only densities by one measure may be added or compared.

use super::{
    Aabb, Composed, Each, Inversion, MarginalConditional, MultivariateNormal, Oriented, PowerMax,
    Product, Simplex, Transform, TriangleOn, Warp, each_warp,
};
use crate::tier::Tier;

/// A warp that says by which measure its density is taken, as a type.
///
/// [`discrete::Mixture`](crate::discrete::Mixture) adds only densities by one measure, so that a sum of others does not compile,
/// though directions, normals and points in space are all of type `[f32; 3]`. Every warp of this crate states its measure. One
/// of your own needs to where something asks for it.
///
/// | measure | of |
/// |---|---|
/// | [`Length`] | warps of the line |
/// | [`Area`] | warps of the plane and of surfaces |
/// | [`Volume`], or [`Content<N>`](Content) | bodies; boxes and simplices of N dimensions |
/// | [`SolidAngle`] | directions |
/// | [`Normals`] | normals of microfacets: their density by solid angle is not that of directions |
/// | [`Rotations`] | rotations |
/// | a pair `(A, B)` of measures, an array `[M; N]` | [`Product`] and [`Each`] |
/// | one of its own | a [`Transform`]: only its functions know where they lead |
///
/// ```
/// use microwarp::uniform::Canonical;
/// use microwarp::{Warp, warp::{Length, Measured}};
///
/// #[derive(Clone, Copy)]
/// struct Wave;
/// impl Warp for Wave {
///     type Uniforms = f32;
///     type Point = f32;
///     type Density = f32;
///     fn sample_canonical(&self, u: Canonical<f32>) -> f32 { u.get() }
///     fn pdf(&self, x: f32) -> f32 { if (0.0..1.0).contains(&x) { 1.0 } else { 0.0 } }
/// }
/// impl Measured for Wave { type Measure = Length; }
/// ```
#[diagnostic::on_unimplemented(
    message = "`{Self}` does not say by which measure its density is taken",
    note = "implement `microwarp::warp::Measured` beside `microwarp::Warp`, e.g. with `type Measure = SolidAngle;`"
)]
pub trait Measured: Warp {
    /// The measure: [`Length`], [`Area`], [`SolidAngle`], or another type, which need not have values.
    type Measure;
}

macro_rules! measures {
    ($($(#[$doc:meta])* $name:ident $(<const $n:ident: usize>)?;)*) => {$(
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        #[cfg_attr(feature = "defmt", derive(defmt::Format))]
        pub struct $name $(<const $n: usize>)?;
    )*};
}

measures! {
    /// The content of N dimensions, as the measure of a density ([`Measured`]).
    Content<const N: usize>;
    /// Solid angle in steradian, as the measure of a density ([`Measured`]).
    SolidAngle;
    /// Solid angle of the normals of microfacets, as the measure of a density ([`Measured`]).
    Normals;
    /// Area of the half sphere of unit quaternions, as the measure of a density ([`Measured`]).
    Rotations;
}

/// Length on the line.
pub type Length = Content<1>;
/// Area in the plane, and on surfaces in space.
pub type Area = Content<2>;
/// Volume in space.
pub type Volume = Content<3>;

macro_rules! measured {
    ($($file:ident::$name:ident $(<$t:ident $(, $n:ident)?>)? $what:literal $($measure:ident)?,)*) => {
        $(measured!(@ $name [$($t)?] $($measure)?);)*
    };
    (@ $name:ident [$($t:ident)?]) => {};
    (@ $name:ident [] $measure:ident) => {
        impl Measured for super::$name {
            type Measure = $measure;
        }
    };
    (@ $name:ident [T] $measure:ident) => {
        impl<T: Tier> Measured for super::$name<T> {
            type Measure = $measure;
        }
    };
}
each_warp!(measured);

/// The measures of types with parameters.
macro_rules! taken_by {
    ($([$($generics:tt)*] $warp:ty: $measure:ty;)*) => {
        $(impl<$($generics)*> $crate::warp::Measured for $warp
        where
            Self: $crate::warp::Warp,
        {
            type Measure = $measure;
        })*
    };
}

pub(crate) use taken_by;

taken_by! {
    [const N: usize] Aabb<N>: Content<N>;
    [const N: usize] PowerMax<N>: Length;
    [const D: usize] TriangleOn<D>: Area;
    [T: Tier, const N: usize] Simplex<T, N>: Content<N>;
    [T: Tier, const D: usize] MultivariateNormal<T, D>: Content<D>;
    [Q, P, C] Inversion<Q, P, C>: Length;
    [M, F] MarginalConditional<M, F>: Area;
    [B, W: Measured] Composed<B, W>: W::Measure;
    [W: Measured] Oriented<W>: W::Measure;
    [W: Measured, const N: usize] Each<W, N>: [W::Measure; N];
    [A: Measured, B: Measured] Product<A, B>: (A::Measure, B::Measure);
    // Where the map leads, only its functions know. So its points mix with those of the same functions alone.
    [W: Measured, F, G, J] Transform<W, F, G, J>: (W::Measure, F);
    [W: Measured] &W: W::Measure;
}
