//! The constructors of the warps over directions.

use super::Constructor;
use crate::adversary::words::Kind::Within;
use crate::catalogue::{Domain, Measure, entry, truth};
use microwarp::tier::Tier;
use microwarp::warp::*;

pub(super) fn constructors<T: Tier>() -> Vec<Constructor> {
    vec![
        Constructor {
            name: "Sphere",
            constructor: "",
            parameters: &[],
            build: |_| {
                Some(entry::<T, _>(
                    "Sphere",
                    "",
                    Domain::Directions,
                    Measure::Length(1.0),
                    Sphere::<T>::new(),
                    truth::sphere(),
                ))
            },
            seeds: Vec::new(),
        },
        Constructor {
            name: "Cone",
            constructor: "from_one_minus_cos",
            parameters: &[Within(0.0, 2.0)],
            build: |p| {
                let warp = Cone::<T>::from_one_minus_cos(p[0]).ok()?;
                let k = f64::from(p[0]);
                Some(entry::<T, _>(
                    "Cone",
                    "",
                    Domain::Directions,
                    Measure::Length(1.0),
                    warp,
                    truth::cone(k, 2.0 - k),
                ))
            },
            seeds: Vec::new(),
        },
    ]
}
