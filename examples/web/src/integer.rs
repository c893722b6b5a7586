//! The warps of the integer tier; parameters in formats of 16 fraction bits.

use crate::run::Visit;
use crate::shared::Refusal;
use crate::subject::{Parameters, Subject};
use fixed::types::{I16F16, U0F32, U16F16, U32F32};
use microwarp::fixed::warp::{
    Cone, CosineHemisphere, Disk, Exponential, Hemisphere, Interval, NormalPair, PhongLobe, Sphere,
    StandardExponential, StandardNormalPair, Tent, Triangle, TriangleOn, TruncatedExponential,
};
use microwarp::fixed::{Float, Grade};

/// Builds a subject and hands it on.
pub fn visit<G: Grade, V: Visit>(
    subject: Subject,
    p: &Parameters,
    v: &mut V,
) -> Result<(), Refusal> {
    let &[a, b, c, d, e, f, ..] = p;
    match subject {
        Subject::Interval => v.warp(&Interval::<I16F16>::new(signed(a)?, signed(b)?)?),
        Subject::Tent => v.warp(&Tent::<_, G>::new(signed(a)?)?),
        Subject::StandardExponential => v.warp(&StandardExponential::<G>::new()),
        Subject::Exponential => v.warp(&Exponential::<_, G>::new(unsigned(a)?)?),
        Subject::TruncatedExponential => v.warp(&TruncatedExponential::<_, G>::new(
            unsigned(a)?,
            unsigned(b)?,
        )?),
        Subject::Disk => v.warp(&Disk::<G>::new()),
        Subject::FloatDisk => v.warp(&Float::new(Disk::<G>::new())),
        Subject::Triangle => v.warp(&Triangle::<G>::new()),
        Subject::TriangleOn => {
            let vertex = |x, y| Ok::<_, Refusal>([signed(x)?, signed(y)?]);
            let vertices = [vertex(a, b)?, vertex(c, d)?, vertex(e, f)?];
            v.warp(&TriangleOn::<_, 2, G>::new(vertices)?)
        }
        Subject::StandardNormalPair => v.warp(&StandardNormalPair::<G>::new()),
        Subject::NormalPair => v.warp(&NormalPair::<_, G>::new(
            [signed(a)?, signed(b)?],
            signed(c)?,
        )?),
        Subject::Sphere => v.warp(&Sphere::<G>::new()),
        Subject::Hemisphere => v.warp(&Hemisphere::<G>::new()),
        Subject::CosineHemisphere => v.warp(&CosineHemisphere::<G>::new()),
        Subject::PhongLobe => v.warp(&PhongLobe::<G>::new(exponent(a)?)?),
        Subject::Cone => v.warp(&Cone::<G>::from_angle(turns(a)?)?),
        _ => Err(Refusal::Unknown),
    }
}

/// A parameter in steps of 2⁻¹⁶, if the format holds it; what has more digits is cut.
fn signed(x: f32) -> Result<I16F16, Refusal> {
    if (-32_768.0..32_768.0).contains(&x) {
        Ok(I16F16::from_bits((x * 65_536.0) as i32))
    } else {
        Err(Refusal::Format("I16F16"))
    }
}

fn unsigned(x: f32) -> Result<U16F16, Refusal> {
    if (0.0..65_536.0).contains(&x) {
        Ok(U16F16::from_bits((x * 65_536.0) as u32))
    } else {
        Err(Refusal::Format("U16F16"))
    }
}

fn exponent(x: f32) -> Result<U32F32, Refusal> {
    if (0.0..4_294_967_296.0).contains(&x) {
        Ok(U32F32::from_bits((x * 4_294_967_296.0) as u64))
    } else {
        Err(Refusal::Format("U32F32"))
    }
}

fn turns(x: f32) -> Result<U0F32, Refusal> {
    if (0.0..1.0).contains(&x) {
        Ok(U0F32::from_bits((x * 4_294_967_296.0) as u32))
    } else {
        Err(Refusal::Format("U0F32"))
    }
}
