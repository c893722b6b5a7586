//! The constructors of the warps that are open at an end, normals and exponentials; and what users compose, by examples.

use super::Constructor;
use microwarp::tier::Tier;
use microwarp::warp::*;
use support::adversary::words::Kind::{Any, Positive};
use support::truth::Truth;
use support::{
    registry::{Domain, Entry, Measure, entry, line, plane},
    truth,
};

pub(super) fn constructors<T: Tier>() -> Vec<Constructor> {
    vec![
        Constructor {
            name: "Normal",
            constructor: "",
            parameters: &[Any, Positive],
            build: |p| {
                let warp = Normal::<T>::new(p[0], p[1]).ok()?;
                Some(
                    entry::<T, _>(
                        "Normal",
                        "",
                        Domain::Line,
                        Measure::UlpFrom(f64::from(p[0])),
                        warp,
                        truth::normal(p[0], p[1]),
                    )
                    .variables(&[("w", f64::from(p[0].abs()) / f64::from(p[1]))]),
                )
            },
            seeds: vec![vec![0.0, 1.0], vec![100.0, 1.0]],
        },
        Constructor {
            name: "NormalPair",
            constructor: "",
            parameters: &[Any, Any, Positive],
            build: |p| {
                let warp = NormalPair::<T>::new([p[0], p[1]], p[2]).ok()?;
                Some(
                    entry::<T, _>(
                        "NormalPair",
                        "",
                        Domain::Plane,
                        Measure::Length(truth::normal_pair_size([p[0], p[1]], p[2])),
                        warp,
                        Box::new(truth::NormalPair {
                            mean: [p[0], p[1]].map(f64::from),
                            deviation: f64::from(p[2]),
                        }) as Box<dyn Truth>,
                    )
                    .variables(&[("w", f64::from(p[0].abs().max(p[1].abs())) / f64::from(p[2]))]),
                )
            },
            seeds: vec![vec![0.0, 0.0, 1.0], vec![3.0, -2.0, 0.5]],
        },
        Constructor {
            name: "ExponentialTail",
            constructor: "",
            parameters: &[Positive],
            build: |p| {
                let warp = ExponentialTail::<T>::new(p[0]).ok()?;
                Some(entry::<T, _>(
                    "ExponentialTail",
                    "",
                    Domain::Line,
                    Measure::Ulp,
                    warp,
                    truth::exponential_tail(p[0]),
                ))
            },
            seeds: vec![vec![1.0]],
        },
        composed("Inversion", "", |_| Some(line::inversion::<T>())),
        composed("Transform", "sine", |_| Some(line::sine::<T>())),
        composed("Transform", "logarithm", |_| Some(line::logarithm::<T>())),
        composed("MarginalConditional", "", |_| {
            Some(plane::below_diagonal::<T>())
        }),
    ]
}

/// An example without parameters of its own.
fn composed(
    name: &'static str,
    constructor: &'static str,
    build: fn(&[f32]) -> Option<Entry>,
) -> Constructor {
    Constructor {
        name,
        constructor,
        parameters: &[],
        build,
        seeds: Vec::new(),
    }
}
