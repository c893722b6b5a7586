//! The warps of the float tiers.

use crate::run::Visit;
use crate::shared::Refusal;
use crate::subject::{Parameters, Subject};
use crate::{chains, rejected};
use core::f32::consts::TAU;
use microwarp::tier::Tier;
use microwarp::warp::{
    Aabb, Cone, CosineHemisphere, Disk, DiskConcentric, Exponential, ExponentialTail, Frame,
    Hemisphere, Interval, Inversion, Linear, MalleyHemisphere, MarginalConditional, Normal,
    NormalPair, Oriented, PhongLobe, Power, PowerMax, Sphere, SphericalPatch, Tent, Transform,
    Triangle, TriangleOn, TruncatedExponential,
};

/// Builds a subject and hands it on.
pub fn visit<T: Tier, V: Visit>(
    subject: Subject,
    p: &Parameters,
    v: &mut V,
) -> Result<(), Refusal> {
    let &[a, b, c, d, e, f, ..] = p;
    match subject {
        Subject::Interval => v.warp(&Interval::new(a, b)?),
        Subject::IntervalDecreasing => v.warp(&Interval::decreasing(a, b)?),
        Subject::Power => v.warp(&Power::<T>::new(a, b, c)?),
        Subject::PowerDecreasing => v.warp(&Power::<T>::decreasing(a, b, c)?),
        Subject::PowerMax => v.warp(&PowerMax::<4>::new()),
        Subject::Exponential => v.warp(&Exponential::<T>::new(a)?),
        Subject::ExponentialTail => v.warp(&ExponentialTail::<T>::new(a)?),
        Subject::TruncatedExponential => v.warp(&TruncatedExponential::<T>::new(a, b)?),
        Subject::Tent => v.warp(&Tent::new(a)?),
        Subject::Linear => v.warp(&Linear::new(a, b)?),
        Subject::Normal => v.warp(&Normal::<T>::new(a, b)?),
        Subject::Inversion => v.warp(&rising::<T>()),
        Subject::Transform => sine::<T, V>(v),
        Subject::Disk => v.warp(&Disk::<T>::new()),
        Subject::DiskConcentric => v.warp(&DiskConcentric::<T>::new()),
        Subject::Triangle => v.warp(&Triangle::new()),
        Subject::TriangleOn => v.warp(&TriangleOn::new([[a, b], [c, d], [e, f]])?),
        Subject::NormalPair => v.warp(&NormalPair::<T>::new([a, b], c)?),
        Subject::Aabb => v.warp(&Aabb::new([a, c], [b, d])?),
        Subject::MarginalConditional => below_diagonal(v),
        Subject::Sphere => v.warp(&Sphere::<T>::new()),
        Subject::Hemisphere => v.warp(&Hemisphere::<T>::new()),
        Subject::CosineHemisphere => v.warp(&CosineHemisphere::<T>::new()),
        Subject::MalleyHemisphere => v.warp(&MalleyHemisphere::<T>::new()),
        Subject::PhongLobe => v.warp(&PhongLobe::<T>::new(a)?),
        Subject::Cone => v.warp(&Cone::<T>::from_angle(a)?),
        Subject::SphericalPatch => v.warp(&SphericalPatch::<T>::new(a, b, c, d)?),
        Subject::Oriented => {
            let frame = Frame::new([a, b, c])?;
            v.warp(&Oriented::new(CosineHemisphere::<T>::new(), frame))
        }
        Subject::Bounded => rejected::bump::<T, V>(p, v),
        Subject::Chain => chains::of_density::<T, V>(p, v),
        _ => Err(Refusal::Unknown),
    }
}

/// p(x) = ½ + x on [0, 1], as a user would write it.
fn rising<T: Tier>() -> Inversion<impl Fn(f32) -> f32, impl Fn(f32) -> f32, impl Fn(f32) -> f32> {
    Inversion::new(
        |u: f32| 4.0 * u / (1.0 + T::sqrt(1.0 + 8.0 * u)),
        |x: f32| {
            if (0.0..=1.0).contains(&x) {
                0.5 + x
            } else {
                0.0
            }
        },
        |x: f32| 0.5 * x * (1.0 + x),
    )
}

/// y = sin x of x with density 2x on [0, 1].
fn sine<T: Tier, V: Visit>(v: &mut V) -> Result<(), Refusal> {
    v.warp(&Transform::new(
        Linear::new(0.0, 1.0)?,
        |x: f32| T::sincos_turns(x * (1.0 / TAU)).0,
        |y: f32| T::atan2_turns(y, T::sqrt((1.0 - y) * (1.0 + y))) * TAU,
        |x: f32| T::sincos_turns(x * (1.0 / TAU)).1,
    ))
}

/// Uniform on 0 ≤ y ≤ x ≤ 1: p(x) = 2x, p(y | x) = 1/x.
fn below_diagonal<V: Visit>(v: &mut V) -> Result<(), Refusal> {
    let whole = Interval::new(0.0, 1.0)?;
    let conditional = |x: f32| Interval::new(0.0, x).unwrap_or(whole);
    v.warp(&MarginalConditional::new(
        Linear::new(0.0, 1.0)?,
        conditional,
    ))
}
