//! The constructors of boxes and of pictures as densities.

use super::Constructor;
use super::line::histogram;
use microwarp::discrete::PiecewiseConstant2d;
use microwarp::tier::Tier;
use microwarp::warp::*;
use support::adversary::words::Kind::{Any, Positive};
use support::truth::Truth;
use support::{
    registry::{Domain, Entry, Flat, Measure, entry},
    truth,
};

pub(super) fn constructors<T: Tier>() -> Vec<Constructor> {
    vec![
        Constructor {
            name: "Aabb",
            constructor: "of 1 side",
            parameters: &[Any; 2],
            build: |p| sides::<T, 1>(p, Domain::Plane),
            seeds: Vec::new(),
        },
        Constructor {
            name: "Aabb",
            constructor: "of 2 sides",
            parameters: &[Any; 4],
            build: |p| sides::<T, 2>(p, Domain::Plane),
            seeds: Vec::new(),
        },
        Constructor {
            name: "Aabb",
            constructor: "of 3 sides",
            parameters: &[Any; 6],
            build: |p| sides::<T, 3>(p, Domain::Space),
            seeds: Vec::new(),
        },
        Constructor {
            name: "PiecewiseConstant2d",
            constructor: "of 2 by 2 cells",
            parameters: &[Any, Any, Any, Any, Positive, Positive, Positive, Positive],
            build: picture::<T>,
            seeds: vec![vec![
                -1.136_488_4,
                1.123_338_6,
                -1.131_686_4,
                1.149_362_9,
                0.069_521_83,
                0.290_617_5,
                0.890_342_7,
                0.496_947_02,
            ]],
        },
    ]
}

fn ordered(a: f32, b: f32) -> [f32; 2] {
    [a.min(b), a.max(b)]
}

fn size(ends: &[f32]) -> f64 {
    ends.iter().fold(0.0, |m: f32, x| m.max(x.abs())).into()
}

/// The bounds of each side, one after the other.
fn sides<T: Tier, const N: usize>(p: &[f32], domain: Domain) -> Option<Entry>
where
    [f32; N]: Flat<3> + Flat<4>,
{
    let side = |i: usize| ordered(p[2 * i], p[2 * i + 1]);
    let [low, high] = [0, 1].map(|end| std::array::from_fn(|i| side(i)[end]));
    let warp = Aabb::<N>::new(low, high).ok()?;
    let truth = truth::Sides((0..N).map(|i| side(i).map(f64::from)).collect());
    let of_size = Measure::Length(size(p));
    let truth = Box::new(truth) as Box<dyn Truth>;
    Some(
        entry::<T, _>("Aabb", "", domain, of_size, warp, truth)
            .variables(&[("n", N as f64), ("m", size(p))]),
    )
}

/// Two ranges and the weights of two rows. The truth has the words of the tables.
fn picture<T: Tier>(p: &[f32]) -> Option<Entry> {
    let (u, v) = (ordered(p[0], p[1]), ordered(p[2], p[3]));
    let weights = [[p[4], p[5]], [p[6], p[7]]];
    let warp = PiecewiseConstant2d::<[u32; 2], [[u32; 2]; 2]>::new(&weights, u, v).ok()?;
    let rows = (0..2).map(|row| histogram(warp.conditional(row).cdf(), u));
    let truth = truth::Picture::of(histogram(warp.marginal().cdf(), v)?, rows.collect());
    Some(entry::<T, _>(
        "PiecewiseConstant2d",
        "",
        Domain::Plane,
        Measure::Length(size(&p[..4])),
        warp,
        Box::new(truth) as Box<dyn Truth>,
    ))
}
