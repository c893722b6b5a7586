//! The constructors of the warps of the line.

use super::Constructor;
use crate::adversary::words::Kind::{Any, Positive};
use crate::catalogue::{Domain, Measure, entry, truth};
use microwarp::tier::Tier;
use microwarp::warp::*;

pub(super) fn constructors<T: Tier>() -> Vec<Constructor> {
    vec![
        Constructor {
            name: "Tent",
            constructor: "",
            parameters: &[Positive],
            build: |p| {
                let warp = Tent::new(p[0]).ok()?;
                Some(entry::<T, _>(
                    "Tent",
                    "",
                    Domain::Line,
                    Measure::Ulp,
                    warp,
                    truth::tent(p[0]),
                ))
            },
            seeds: Vec::new(),
        },
        Constructor {
            name: "Exponential",
            constructor: "",
            parameters: &[Positive],
            build: |p| {
                let warp = Exponential::<T>::new(p[0]).ok()?;
                Some(entry::<T, _>(
                    "Exponential",
                    "",
                    Domain::Line,
                    Measure::Ulp,
                    warp,
                    truth::exponential(p[0]),
                ))
            },
            seeds: Vec::new(),
        },
        Constructor {
            name: "Interval",
            constructor: "decreasing",
            parameters: &[Any, Any],
            build: |p| {
                let warp = Interval::decreasing(p[0], p[1]).ok()?;
                let scale = f64::from(p[0].abs().max(p[1].abs()));
                Some(entry::<T, _>(
                    "Interval",
                    "",
                    Domain::Line,
                    Measure::UlpOf(scale),
                    warp,
                    truth::interval(p[0], p[1], false),
                ))
            },
            seeds: Vec::new(),
        },
    ]
}
