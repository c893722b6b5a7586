//! The constructors of the power laws and of the exponential on an interval.

use super::Constructor;
use microwarp::tier::Tier;
use microwarp::warp::{Power, PowerMax, TruncatedExponential};
use support::adversary::words::Kind::{self, Any, Positive, Within};
use support::{
    registry::{Domain, Entry, Measure, entry},
    truth,
};

fn power<T: Tier>(n: f32, a: f32, b: f32, increasing: bool) -> Option<Entry> {
    let warp = if increasing {
        Power::<T>::new(n, a, b)
    } else {
        Power::<T>::decreasing(n, a, b)
    };
    Some(entry::<T, _>(
        "Power",
        "",
        Domain::Line,
        Measure::Ulp,
        warp.ok()?,
        truth::power(n, a, b, increasing),
    ))
}

fn largest<T: Tier, const N: usize>() -> Option<Entry>
where
    [f32; N]: support::registry::Flat<4>,
{
    let truth = truth::power_max(u32::try_from(N).unwrap());
    let mut entry = entry::<T, _>(
        "PowerMax",
        "",
        Domain::Line,
        Measure::Ulp,
        PowerMax::<N>::new(),
        truth,
    );
    // Many sets of uniforms share their largest.
    entry.round_trip = N == 1;
    Some(entry)
}

pub(super) fn constructors<T: Tier>() -> Vec<Constructor> {
    const NEAR: Kind = Within(-1.02, -0.98);
    let of = |name, constructor, parameters, build| Constructor {
        name,
        constructor,
        parameters,
        build,
        seeds: Vec::new(),
    };
    vec![
        of("Power", "new", &[Any, Positive, Positive], |p| {
            power::<T>(p[0], p[1], p[2], true)
        }),
        of("Power", "decreasing", &[Any, Positive, Positive], |p| {
            power::<T>(p[0], p[1], p[2], false)
        }),
        of("Power", "near n=-1", &[NEAR, Positive, Positive], |p| {
            power::<T>(p[0], p[1], p[2], true)
        }),
        of("Power", "from 0", &[Any, Positive], |p| {
            power::<T>(p[0], 0.0, p[1], true)
        }),
        of("PowerMax", "N=1", &[], |_| largest::<T, 1>()),
        of("PowerMax", "N=3", &[], |_| largest::<T, 3>()),
        of("PowerMax", "N=4", &[], |_| largest::<T, 4>()),
        of("TruncatedExponential", "", &[Any, Positive], |p| {
            let warp = TruncatedExponential::<T>::new(p[0], p[1]).ok()?;
            Some(entry::<T, _>(
                "TruncatedExponential",
                "",
                Domain::Line,
                Measure::Ulp,
                warp,
                truth::truncated_exponential(p[0], p[1]),
            ))
        }),
    ]
}
