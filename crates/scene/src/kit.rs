//! The samplers of a path, chosen by one type.

use microwarp::tier::Tier;
use microwarp::warp::{
    CosineHemisphere, HenyeyGreenstein, Measured, PhongLobe, SolidAngle, Tent, TruncatedExponential,
};
use microwarp::{Error, Warp};

/// A warp of directions, of two numbers, that can be mixed with others.
pub trait Directions:
    Measured<Uniforms = [f32; 2], Point = [f32; 3], Density = f32, Measure = SolidAngle> + Copy
{
}

impl<W> Directions for W where
    W: Measured<Uniforms = [f32; 2], Point = [f32; 3], Density = f32, Measure = SolidAngle> + Copy
{
}

/// A set of samplers. Both tiers of `f32` are kits. One that takes some samplers of the integer tier by `fixed::Float` names
/// the others by a tier.
pub trait Kit: 'static {
    /// The tier of the samplers that are not named here.
    type Tier: Tier;
    /// Directions about +z by Lambert's law.
    type Cosine: Directions;
    /// Directions about +z in proportion to a power of the cosine.
    type Gloss: Directions;
    /// Directions about the way that light goes, +z.
    type Phase: Warp<Point = [f32; 3], Density = f32>;
    /// Distances in fog, up to an end.
    type Free: Warp<Point = f32, Density = f32>;
    /// Places in a pixel along one axis.
    type Filter: Warp<Point = f32, Density = f32>;

    fn cosine() -> Self::Cosine;

    /// # Errors
    /// The sampler's own, as in all of these.
    fn gloss(exponent: f32) -> Result<Self::Gloss, Error>;

    /// # Errors
    /// For an asymmetry that is not between −1 and 1.
    fn phase(asymmetry: f32) -> Result<Self::Phase, Error>;

    /// # Errors
    /// For a rate that is not finite, and a length that is not positive.
    fn free(rate: f32, length: f32) -> Result<Self::Free, Error>;

    /// # Errors
    /// For a radius that is not positive.
    fn filter(radius: f32) -> Result<Self::Filter, Error>;
}

impl<T: Tier> Kit for T {
    type Tier = T;
    type Cosine = CosineHemisphere<T>;
    type Gloss = PhongLobe<T>;
    type Phase = HenyeyGreenstein<T>;
    type Free = TruncatedExponential<T>;
    type Filter = Tent;

    #[inline]
    fn cosine() -> Self::Cosine {
        CosineHemisphere::new()
    }

    #[inline]
    fn gloss(exponent: f32) -> Result<Self::Gloss, Error> {
        PhongLobe::new(exponent)
    }

    #[inline]
    fn phase(asymmetry: f32) -> Result<Self::Phase, Error> {
        HenyeyGreenstein::new(asymmetry)
    }

    #[inline]
    fn free(rate: f32, length: f32) -> Result<Self::Free, Error> {
        TruncatedExponential::from_rate(rate, length)
    }

    #[inline]
    fn filter(radius: f32) -> Result<Self::Filter, Error> {
        Tent::new(radius)
    }
}
