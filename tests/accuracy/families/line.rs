//! The constructors of the warps of the line.

use super::Constructor;
use microwarp::Error;
use microwarp::discrete::{Cdf, PiecewiseConstant1d, Storage};
use microwarp::tier::Tier;
use microwarp::warp::*;
use support::adversary::words::Kind::{Any, Positive};
use support::truth::Truth;
use support::{
    registry::{Domain, Entry, Measure, entry},
    truth,
};

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
            constructor: "new",
            parameters: &[Any, Any],
            build: |p| interval::<T>(p, Interval::new, true),
            seeds: Vec::new(),
        },
        Constructor {
            name: "Interval",
            constructor: "decreasing",
            parameters: &[Any, Any],
            build: |p| interval::<T>(p, Interval::decreasing, false),
            seeds: Vec::new(),
        },
        Constructor {
            name: "Linear",
            constructor: "",
            parameters: &[Positive, Positive],
            build: |p| {
                let warp = Linear::new(p[0], p[1]).ok()?;
                Some(entry::<T, _>(
                    "Linear",
                    "",
                    Domain::Line,
                    Measure::Ulp,
                    warp,
                    truth::linear(p[0], p[1]),
                ))
            },
            seeds: Vec::new(),
        },
        Constructor {
            name: "PiecewiseConstant1d",
            constructor: "of 2 cells",
            parameters: &[Any, Any, Positive, Positive],
            build: cells::<T, 2>,
            seeds: vec![vec![-1.945_361_4, 1.981_400_4, 0.123_744_264, 0.151_265_96]],
        },
        Constructor {
            name: "PiecewiseConstant1d",
            constructor: "of 4 cells",
            parameters: &[Any, Any, Positive, Positive, Positive, Positive],
            build: cells::<T, 4>,
            seeds: Vec::new(),
        },
    ]
}

fn scale(range: [f32; 2]) -> Measure {
    Measure::UlpOf(range[0].abs().max(range[1].abs()).into())
}

fn interval<T: Tier>(
    p: &[f32],
    new: fn(f32, f32) -> Result<Interval, Error>,
    increasing: bool,
) -> Option<Entry> {
    let (a, b) = (p[0].min(p[1]), p[0].max(p[1]));
    let warp = new(a, b).ok()?;
    let truth = truth::interval(a, b, increasing);
    Some(entry::<T, _>(
        "Interval",
        "",
        Domain::Line,
        scale([a, b]),
        warp,
        truth,
    ))
}

/// A range and as many weights as there are cells. The truth has the words of the table, not the weights.
fn cells<T: Tier, const N: usize>(p: &[f32]) -> Option<Entry> {
    let range = [p[0].min(p[1]), p[0].max(p[1])];
    let weights: &[f32; N] = p[2..].try_into().unwrap();
    let warp = PiecewiseConstant1d::<[u32; N]>::from_weights(weights, range[0], range[1]).ok()?;
    Some(entry::<T, _>(
        "PiecewiseConstant1d",
        "",
        Domain::Line,
        scale(range),
        warp,
        Box::new(histogram(warp.cdf(), range)?) as Box<dyn Truth>,
    ))
}

/// The exact density of a table on equal cells.
pub(super) fn histogram<S: Storage<Item = u32>>(
    cdf: &Cdf<S>,
    range: [f32; 2],
) -> Option<truth::Histogram> {
    let words: Vec<f64> = (0..cdf.entries())
        .map(|j| cdf.numerator(j) as f64)
        .collect();
    truth::Histogram::new(&words, range)
}
