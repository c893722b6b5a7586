//! The warps of the line.

use super::{Domain, Entry, Measure, entry};
use crate::truth::{self, Truth};
use microwarp::tier::Tier;
use microwarp::warp::*;

pub(crate) fn entries<T: Tier>() -> Vec<Entry> {
    use Domain::Line;
    use Measure::{Ulp, UlpFrom, UlpOf};
    let mut t = Vec::new();

    for (label, a, b, resolved) in [
        ("[0, 1]", 0.0, 1.0, true),
        ("[-3, 5]", -3.0, 5.0, true),
        ("[-3e38, 3e38]", -3e38, 3e38, true),
        ("[1e6, 1e6+1/16]", 1e6, 1e6 + 0.0625, false),
        ("[0, 1e-35]", 0.0, 1e-35, true),
        ("[-1.7374, -1.5582]", -1.737_384_2, -1.558_242_2, true),
    ] {
        let scale = f64::from(f32::max(f32::abs(a), f32::abs(b)));
        for increasing in [true, false] {
            let (name, warp) = if increasing {
                ("Interval", Interval::new(a, b))
            } else {
                ("Interval decreasing", Interval::decreasing(a, b))
            };
            let e = entry::<T, _>(
                name,
                label,
                Line,
                UlpOf(scale),
                warp.unwrap(),
                truth::interval(a, b, increasing),
            );
            t.push(if resolved { e } else { e.unresolved() });
        }
    }

    for (label, n, a, b, resolved) in [
        ("n=0 [1, 3]", 0.0, 1.0, 3.0, true),
        ("n=1 [0, 2]", 1.0, 0.0, 2.0, true),
        ("n=2.5 [0, 1]", 2.5, 0.0, 1.0, true),
        ("n=-0.5 [0, 4]", -0.5, 0.0, 4.0, true),
        ("n=-1 [1, 100]", -1.0, 1.0, 100.0, true),
        ("n=-0.9999999 [1, 100]", -0.999_999_9, 1.0, 100.0, true),
        ("n=-1.000001 [1, 100]", -1.000_001, 1.0, 100.0, true),
        ("n=-2.5 [1, 1e20]", -2.5, 1.0, 1e20, true),
        ("n=-0.99 [1e-10, 1e10]", -0.99, 1e-10, 1e10, true),
        ("n=-0.95 [1e-10, 1e10]", -0.95, 1e-10, 1e10, true),
        ("n=1 [1e20, 1e21]", 1.0, 1e20, 1e21, true),
        ("n=2 [1e-30, 1e-29]", 2.0, 1e-30, 1e-29, true),
        ("n=-1 [1e-37, 1e37]", -1.0, 1e-37, 1e37, true),
        ("n=1000 [1, 2]", 1000.0, 1.0, 2.0, true),
        ("n=-1000 [1, 2]", -1000.0, 1.0, 2.0, true),
        ("n=1e8 [1, 2]", 1e8, 1.0, 2.0, false),
        ("n=3 [1, 1.0001]", 3.0, 1.0, 1.0001, false),
        (
            "n=-0.7427 [3.5e-3, 2.5e13]",
            -0.742_730_2,
            3.537_985e-3,
            2.506_938_2e13,
            true,
        ),
        ("n=-0.9 [0, 1e30]", -0.9, 0.0, 1e30, true),
        ("n=1e6 [1, 3]", 1e6, 1.0, 3.0, false),
        ("n=1e8 [1, 3]", 1e8, 1.0, 3.0, false),
        ("n=-1.005 [1e-37, 1e38]", -1.005, 1e-37, 1e38, true),
        ("n=-1.007 [1e-30, 1e30]", -1.007, 1e-30, 1e30, true),
        ("n=-3 [1e-20, 1e20]", -3.0, 1e-20, 1e20, true),
        ("n=-0.748 [127, 7.3e6]", -0.748, 127.0, 7.3e6, true),
        ("n=-1 [1e-40, 1]", -1.0, 1e-40, 1.0, true),
        (
            "n=-0.9974 [1.6e-38, 4e28]",
            -0.997_436_5,
            1.595_427_9e-38,
            4.033_297e28,
            true,
        ),
    ] {
        for increasing in [true, false] {
            let (name, warp) = if increasing {
                ("Power", Power::<T>::new(n, a, b))
            } else {
                ("Power decreasing", Power::<T>::decreasing(n, a, b))
            };
            let e = entry::<T, _>(
                name,
                label,
                Line,
                Ulp,
                warp.unwrap(),
                truth::power(n, a, b, increasing),
            );
            t.push(if resolved { e } else { e.unresolved() });
        }
    }

    t.push(entry::<T, _>(
        "PowerMax",
        "N=1",
        Line,
        Ulp,
        PowerMax::<1>::new(),
        truth::power_max(1),
    ));
    t.push(
        entry::<T, _>(
            "PowerMax",
            "N=2",
            Line,
            Ulp,
            PowerMax::<2>::new(),
            truth::power_max(2),
        )
        .no_round_trip()
        .chart(truth::power(1.0, 0.0, 1.0, true)),
    );
    t.push(
        entry::<T, _>(
            "PowerMax",
            "N=4",
            Line,
            Ulp,
            PowerMax::<4>::new(),
            truth::power_max(4),
        )
        .no_round_trip()
        .chart(truth::power(3.0, 0.0, 1.0, true)),
    );

    for (label, rate) in [("a=1", 1.0), ("a=1e30", 1e30), ("a=3.1e-37", 3.1e-37)] {
        t.push(entry::<T, _>(
            "Exponential",
            label,
            Line,
            Ulp,
            Exponential::<T>::new(rate).unwrap(),
            truth::exponential(rate),
        ));
        t.push(
            entry::<T, _>(
                "ExponentialTail",
                label,
                Line,
                Ulp,
                ExponentialTail::<T>::new(rate).unwrap(),
                truth::exponential_tail(rate),
            )
            .words(2),
        );
    }

    for (label, rate, length) in [
        ("c=2 X=3", 2.0, 3.0),
        ("c=-2 X=3", -2.0, 3.0),
        ("c=0 X=2", 0.0, 2.0),
        ("c=1e-3 X=1", 1e-3, 1.0),
        ("c=-7e-3 X=1", -7e-3, 1.0),
        ("c=9e-3 X=1", 9e-3, 1.0),
        ("c=30 X=1", 30.0, 1.0),
        ("c=-60 X=1", -60.0, 1.0),
        ("c=1e4 X=1", 1e4, 1.0),
        ("c=-1e4 X=1", -1e4, 1.0),
        ("c=1e30 X=1e-30", 1e30, 1e-30),
        ("c=-17.727 X=0.5695", -17.727_365, 0.569_503_3),
        ("c=1e30 X=1e30", 1e30, 1e30),
        ("c=-95 X=1", -95.0, 1.0),
        ("c=3e-39 X=3.4e38", 3.045_662e-39, 3.391_878_5e38),
        ("c=-1.76e-6 X=2", -1.758_337e-6, 1.998_206_7),
    ] {
        // Far from the peak of a steep rise towards X, f32 near X resolves 1 part in 1e4 of it.
        let steep = rate * length < -1e3;
        let e = entry::<T, _>(
            "TruncatedExponential",
            label,
            Line,
            Ulp,
            TruncatedExponential::<T>::new(rate, length).unwrap(),
            truth::truncated_exponential(rate, length),
        );
        t.push(if steep { e.unresolved() } else { e });
    }

    for (label, r) in [("r=1", 1.0), ("r=3e38", 3e38), ("r=1e-30", 1e-30)] {
        t.push(entry::<T, _>(
            "Tent",
            label,
            Line,
            Ulp,
            Tent::new(r).unwrap(),
            truth::tent(r),
        ));
    }
    for (label, a, b) in [
        ("1 to 3", 1.0, 3.0),
        ("1 to 0", 1.0, 0.0),
        ("0 to 1", 0.0, 1.0),
        ("1 to 1", 1.0, 1.0),
        ("1 to 1.000001", 1.0, 1.000_001),
        ("1e-20 to 1e20", 1e-20, 1e20),
        ("3e38 to 1e38", 3e38, 1e38),
        ("5500 to 100866", 5_499.947, 100_865.68),
    ] {
        t.push(entry::<T, _>(
            "Linear",
            label,
            Line,
            Ulp,
            Linear::new(a, b).unwrap(),
            truth::linear(a, b),
        ));
    }
    for (label, mean, deviation) in [
        ("0, 1", 0.0, 1.0),
        ("100, 1", 100.0, 1.0),
        ("0, 1e-30", 0.0, 1e-30),
        ("0, 1e36", 0.0, 1e36),
    ] {
        let e = entry::<T, _>(
            "Normal",
            label,
            Line,
            UlpFrom(f64::from(mean)),
            Normal::<T>::new(mean, deviation).unwrap(),
            truth::normal(mean, deviation),
        );
        t.push(if mean == 0.0 { e } else { e.no_round_trip() });
    }
    t.extend([inversion::<T>(), sine::<T>(), logarithm::<T>()]);
    t
}

/// p(x) = ½ + x on [0, 1].
pub fn inversion<T: Tier>() -> Entry {
    use Domain::Line;
    use Measure::Ulp;
    entry::<T, _>(
        "Inversion",
        "p=1/2+x",
        Line,
        Ulp,
        Inversion::new(
            |u: f32| 4.0 * u / (1.0 + T::sqrt(1.0 + 8.0 * u)),
            |x: f32| 0.5 + x,
            |x: f32| 0.5 * x * (1.0 + x),
        ),
        Box::new(truth::Line {
            quantile: |u: f64| 4.0 * u / (1.0 + (1.0 + 8.0 * u).sqrt()),
            pdf: |x: f64| 0.5 + x,
            cdf: |x: f64| 0.5 * x * (1.0 + x),
        }) as Box<dyn Truth>,
    )
}

/// Y = sin X with p(x) = 2x on [0, 1]: p(y) = 2 asin(y)/√(1 − y²) on [0, sin 1].
pub fn sine<T: Tier>() -> Entry {
    use Domain::Line;
    use Measure::Ulp;
    let sine = |x: f32| T::sincos_turns(x * (1.0 / core::f32::consts::TAU)).0;
    let cosine = |x: f32| T::sincos_turns(x * (1.0 / core::f32::consts::TAU)).1;
    let arcsine =
        |y: f32| T::atan2_turns(y, T::sqrt((1.0 - y) * (1.0 + y))) * core::f32::consts::TAU;
    entry::<T, _>(
        "Transform",
        "y=sin x",
        Line,
        Ulp,
        Transform::new(Linear::new(0.0, 1.0).unwrap(), sine, arcsine, cosine),
        Box::new(truth::Line {
            quantile: |u: f64| u.sqrt().sin(),
            pdf: |y: f64| 2.0 * y.asin() / (1.0 - y * y).sqrt(),
            cdf: |y: f64| y.asin().powi(2),
        }) as Box<dyn Truth>,
    )
}

/// p(x) = x on [√2, 2] becomes p(y) = e^y on [0, ln 2] under y = 2 ln x − ln 2.
pub fn logarithm<T: Tier>() -> Entry {
    use Domain::Line;
    use Measure::UlpOf;
    entry::<T, _>(
        "Transform",
        "y=2 ln x - ln 2",
        Line,
        UlpOf(0.7),
        Transform::new(
            Power::<T>::new(1.0, core::f32::consts::SQRT_2, 2.0).unwrap(),
            |x: f32| 2.0 * T::ln(x) - core::f32::consts::LN_2,
            |y: f32| T::exp(0.5 * (y + core::f32::consts::LN_2)),
            |x: f32| 2.0 / x,
        ),
        Box::new(truth::Line {
            // Exact for the interval whose lower end is the f32 nearest to the root of 2.
            quantile: |u: f64| {
                let low = f64::from(core::f32::consts::SQRT_2).powi(2);
                ((1.0 - u) * low + u * 4.0).ln() - f64::from(core::f32::consts::LN_2)
            },
            pdf: |y: f64| {
                let low = f64::from(core::f32::consts::SQRT_2).powi(2);
                (y + f64::from(core::f32::consts::LN_2)).exp() / (4.0 - low)
            },
            cdf: |y: f64| {
                let low = f64::from(core::f32::consts::SQRT_2).powi(2);
                ((y + f64::from(core::f32::consts::LN_2)).exp() - low) / (4.0 - low)
            },
        }) as Box<dyn Truth>,
    )
}
