//! Contests of warps that are drawn one sample after the other.

use crate::args::*;
use fixed::types::U32F32;
use host::contest::Contest;
use host::peers::{drawn, micro, rejecting, textbook};
use microwarp::fixed::{Coarse, Compact, Fine, Float, FloatPoint, Grade, Uniform};
use microwarp::rejection::{
    BallRejection, DiskRejection, Rejection, ZigguratStandardExponential, ZigguratStandardNormal,
};
use microwarp::tier::{Libm, Poly, Tier};
use microwarp::warp::Normal;
use microwarp::{Warp, uniform};
use rand_pcg::Pcg32;
use rand_pcg::rand_core::Rng;
use std::hint::black_box;

/// Cosine-power lobes have this exponent.
pub const EXPONENT: u16 = 50;

/// The power of a uniform that such a lobe's height is; the compiler may not know it beforehand.
pub fn lobe_power() -> f32 {
    black_box(1.0 / (f32::from(EXPONENT) + 1.0))
}

/// Admits a warp, written with `mw` for the module of its tier, in both float tiers.
macro_rules! tiers {
    ($contest:expr, $warp:expr) => {
        $contest
            .warp(LIBM, {
                use microwarp::libm as mw;
                $warp
            })
            .warp(POLY, {
                use microwarp::poly as mw;
                $warp
            })
    };
}

/// Admits a warp of the integer tier, in its three grades.
macro_rules! grades {
    ($contest:expr, $warp:expr) => {
        $contest
            .warp(FINE, {
                use microwarp::fixed as mw;
                Float::new($warp)
            })
            .warp(COARSE, {
                use microwarp::fixed::coarse as mw;
                Float::new($warp)
            })
            .warp(COMPACT, {
                use microwarp::fixed::compact as mw;
                Float::new($warp)
            })
    };
}

/// A word of the generator, stored where a number would be.
pub fn word(rng: &mut Pcg32) -> f32 {
    f32::from_bits(rng.next_u32())
}

/// A contest with the generator alone, which draws two words a point.
pub fn of_pairs<const N: usize>() -> Contest<[f32; N]> {
    with_pairs(Contest::new([0.0; N]))
}

/// Admits the generator alone. It writes the words where they are to stand: an array that a function returns may pass
/// through an integer register, which takes time.
pub fn with_pairs<const N: usize>(contest: Contest<[f32; N]>) -> Contest<[f32; N]> {
    contest.fill(FLOOR, |rng, points| {
        for point in points {
            if let [x, y, ..] = point.as_mut_slice() {
                *x = word(rng);
                *y = word(rng);
            }
        }
    })
}

pub fn disk() -> Contest<[f32; 2]> {
    let contest = tiers!(of_pairs(), mw::Disk::new());
    grades!(contest, mw::Disk::new())
        .draw(REJECTION, accepted(DiskRejection::new()))
        .draw(RAND_DISTR, rejecting::disk)
        .draw(MICROMATH, drawn(micro::disk))
        .draw(TEXTBOOK, drawn(textbook::disk))
}

/// A point. The budget suffices unless the generator is stuck.
pub fn accepted<S: Rejection<Point: Default>>(sampler: S) -> impl Fn(&mut Pcg32) -> S::Point {
    move |rng| match sampler.draw(rng) {
        Ok(accepted) => accepted.point,
        Err(_) => Default::default(),
    }
}

pub fn circle() -> Contest<[f32; 2]> {
    fn float<T: Tier>(rng: &mut Pcg32) -> [f32; 2] {
        let (s, c) = T::sincos_turns(uniform::grid(rng));
        [c, s]
    }
    fn integer<G: Grade>(rng: &mut Pcg32) -> [f32; 2] {
        let (s, c) = G::sincos_turns(Uniform::from_bits(rng.next_u32()));
        [c, s].to_float()
    }
    Contest::new([0.0; 2])
        .fill(FLOOR, |rng, points| {
            for [x, _] in points {
                *x = word(rng);
            }
        })
        .draw(LIBM, float::<Libm>)
        .draw(POLY, float::<Poly>)
        .draw(FINE, integer::<Fine>)
        .draw(COARSE, integer::<Coarse>)
        .draw(COMPACT, integer::<Compact>)
        .draw(RAND_DISTR, rejecting::circle)
        .draw(MICROMATH, drawn(micro::circle))
        .draw(TEXTBOOK, drawn(textbook::circle))
}

pub fn sphere() -> Contest<[f32; 3]> {
    let contest = tiers!(of_pairs(), mw::Sphere::new());
    grades!(contest, mw::Sphere::new())
        .draw(RAND_DISTR, rejecting::sphere)
        .draw(MICROMATH, drawn(micro::sphere))
        .draw(TEXTBOOK, drawn(textbook::sphere))
}

pub fn hemisphere() -> Contest<[f32; 3]> {
    let contest = tiers!(of_pairs(), mw::Hemisphere::new());
    grades!(contest, mw::Hemisphere::new())
        .draw(RAND_DISTR, rejecting::hemisphere)
        .draw(MICROMATH, drawn(micro::hemisphere))
        .draw(TEXTBOOK, drawn(textbook::hemisphere))
}

pub fn cosine_hemisphere() -> Contest<[f32; 3]> {
    let contest = tiers!(of_pairs(), mw::CosineHemisphere::new());
    grades!(contest, mw::CosineHemisphere::new())
        .draw(RAND_DISTR, rejecting::cosine_hemisphere)
        .draw(MICROMATH, drawn(micro::cosine_hemisphere))
        .draw(TEXTBOOK, drawn(textbook::cosine_hemisphere))
}

pub fn lobe() -> Contest<[f32; 3]> {
    let contest = tiers!(of_pairs(), mw::PhongLobe::new(f32::from(EXPONENT)).unwrap());
    let (rejected, micro, textbook) = (lobe_power(), lobe_power(), lobe_power());
    grades!(contest, mw::PhongLobe::new(U32F32::from(EXPONENT)).unwrap())
        .draw(RAND_DISTR, move |rng| rejecting::lobe(rejected, rng))
        .draw(MICROMATH, drawn(move |u| micro::lobe(micro, u)))
        .draw(TEXTBOOK, drawn(move |u| textbook::lobe(textbook, u)))
}

pub fn exponential() -> Contest<f32> {
    let floor = Contest::new(0.0).draw(FLOOR, word);
    let contest = tiers!(floor, mw::Exponential::from_rate(1.0).unwrap());
    // Ours divides by its rate, so the formula does.
    let rate = black_box(1.0);
    let formula = move |u| textbook::exponential_of_rate(rate, u);
    grades!(contest, mw::StandardExponential::new())
        .draw(REJECTION, accepted(ZigguratStandardExponential::new()))
        .draw(RAND_DISTR, rejecting::exponential)
        .draw(MICROMATH, drawn(micro::exponential))
        .draw(TEXTBOOK, drawn(formula))
}

/// Two normals, each by its quantile.
fn one_at_a_time<T: Tier>() -> impl Fn(&mut Pcg32) -> [f32; 2] {
    let normal = black_box(Normal::<T>::new(0.0, 1.0).unwrap());
    move |rng| [normal.draw(rng), normal.draw(rng)]
}

/// Pairs, of which each counts as two.
pub fn normal() -> Contest<[f32; 2]> {
    let floor = of_pairs().counting(2);
    let pairs = tiers!(floor, mw::NormalPair::new([0.0; 2], 1.0).unwrap());
    let ziggurat = accepted(ZigguratStandardNormal::new());
    grades!(pairs, mw::StandardNormalPair::new())
        .draw(LIBM_SINGLE, one_at_a_time::<Libm>())
        .draw(POLY_SINGLE, one_at_a_time::<Poly>())
        .draw(REJECTION, move |rng| [ziggurat(rng), ziggurat(rng)])
        .draw(RAND_DISTR, |rng| {
            [rejecting::normal(rng), rejecting::normal(rng)]
        })
        .draw(MICROMATH, drawn(micro::normal_pair))
        .draw(TEXTBOOK, drawn(textbook::normal_pair))
}

pub fn ball() -> Contest<[f32; 3]> {
    Contest::new([0.0; 3])
        .draw(FLOOR, |rng| [word(rng), word(rng), word(rng)])
        .draw(REJECTION, accepted(BallRejection::new()))
        .draw(RAND_DISTR, rejecting::ball)
        .draw(TEXTBOOK, drawn(textbook::ball))
}
