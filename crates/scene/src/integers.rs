//! The samplers of the integer tier, for paths that are in `f32` otherwise. Feature `fixed`.

use crate::kit::Kit;
use core::marker::PhantomData;
use fixed::types::extra::{U24, U30};
use fixed::types::{I2F30, U8F24, U32F32};
use microwarp::Error;
use microwarp::fixed::warp::{
    CosineHemisphere, HenyeyGreenstein, PhongLobe, Tent, TruncatedExponential,
};
use microwarp::fixed::{Float, Grade};
use microwarp::tier::Poly;

/// The kit of a grade, [`Fine`](microwarp::fixed::Fine) or [`Coarse`](microwarp::fixed::Coarse). What the integer tier lacks is
/// that of `poly`. Ways in fog are shorter than 256 metres.
pub struct Integers<G>(PhantomData<G>);

impl<G: Grade + 'static> Kit for Integers<G> {
    type Tier = Poly;
    type Cosine = Float<CosineHemisphere<G>>;
    type Gloss = Float<PhongLobe<G>>;
    type Phase = Float<HenyeyGreenstein<G>>;
    type Free = Float<TruncatedExponential<U24, G>>;
    type Filter = Float<Tent<U30, G>>;

    #[inline]
    fn cosine() -> Self::Cosine {
        Float::new(CosineHemisphere::new())
    }

    #[inline]
    fn gloss(exponent: f32) -> Result<Self::Gloss, Error> {
        let exponent = U32F32::checked_from_num(exponent).ok_or(Error::OutOfRange(0))?;
        PhongLobe::new(exponent).map(Float::new)
    }

    #[inline]
    fn phase(asymmetry: f32) -> Result<Self::Phase, Error> {
        let asymmetry = I2F30::checked_from_num(asymmetry).ok_or(Error::OutOfRange(0))?;
        HenyeyGreenstein::new(asymmetry).map(Float::new)
    }

    #[inline]
    fn free(rate: f32, length: f32) -> Result<Self::Free, Error> {
        let rate = U32F32::checked_from_num(rate).ok_or(Error::OutOfRange(0))?;
        let length = U8F24::checked_from_num(length).ok_or(Error::TooLarge(1))?;
        TruncatedExponential::from_rate(rate, length).map(Float::new)
    }

    #[inline]
    fn filter(radius: f32) -> Result<Self::Filter, Error> {
        let radius = I2F30::checked_from_num(radius).ok_or(Error::OutOfRange(0))?;
        Tent::new(radius).map(Float::new)
    }
}
