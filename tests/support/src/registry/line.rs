//! The warps of the line, but for powers and what users compose.

use super::picture::{View, between};
use super::{Domain, Ends, Entry, Measure, Registered, entry, family};
use crate::adversary::words::Kind::{Any, Positive};
use crate::truth::{self, Truth};
use microwarp::Error::{self, *};
use microwarp::Invert;
use microwarp::tier::Tier;
use microwarp::warp::*;

const NAN: f32 = f32::NAN;
const INF: f32 = f32::INFINITY;

const TINY: f32 = 1.0e-45;

/// A warp of the line whose error is counted in ulp of the sample.
pub(super) fn in_ulp<T: Tier, W>(name: &'static str, warp: W, truth: Box<dyn Truth>) -> Entry
where
    W: Invert<Point = f32, Density = f32> + Send + Sync + 'static,
    W::Uniforms: super::Flat<4>,
{
    entry::<T, _>(name, Domain::Line, Measure::Ulp, warp, truth)
}

#[rustfmt::skip] // one line a case
pub(super) fn registered<T: Tier>() -> Vec<Registered> {
    vec![
        Registered::new("Interval", "new", &[Any, Any], |p| interval::<T>("Interval", p, Interval::new(p[0], p[1]), true))
            .ordered(&[[0, 1]])
            .case_with("[-3, 5]", &[-3.0, 5.0], |e| {
                e.picture("uniform on [−3, 5)", View::Line(between(-4.0, 6.0))).trade(family::INTERVAL, "interval")
            })
            .case("[0, 1]", &[0.0, 1.0])
            .case("[-3e38, 3e38]", &[-3e38, 3e38])
            .case_with("[1e6, 1e6+1/16]", &[1e6, 1e6 + 0.0625], Entry::unresolved)
            .case("[0, 1e-35]", &[0.0, 1e-35])
            .case("[-1.7374, -1.5582]", &[-1.737_384_2, -1.558_242_2])
            .seed(&[-f32::MAX, f32::MAX]).seed(&[0.0, 3.0e-39]).seed(&[1.0, 1.000_000_1])
            .refuse(&[NAN, 1.0], NotFinite).refuse(&[0.0, INF], NotFinite).refuse(&[1.0, 0.0], Reversed)
            .refuse(&[1.0, 1.0], Empty).refuse(&[0.0, TINY], Empty),
        Registered::new("Interval", "decreasing", &[Any, Any], |p| {
            interval::<T>("Interval decreasing", p, Interval::decreasing(p[0], p[1]), false)
        })
            .ordered(&[[0, 1]])
            .case_with("[-3, 5]", &[-3.0, 5.0], |e| {
                e.picture("the same, 5 first", View::Line(between(-4.0, 6.0))).trade(family::INTERVAL, "interval_decreasing")
            })
            .case("[0, 1]", &[0.0, 1.0])
            .case("[-3e38, 3e38]", &[-3e38, 3e38])
            .case_with("[1e6, 1e6+1/16]", &[1e6, 1e6 + 0.0625], Entry::unresolved)
            .case("[0, 1e-35]", &[0.0, 1e-35])
            .case("[-1.7374, -1.5582]", &[-1.737_384_2, -1.558_242_2])
            .refuse(&[-INF, 1.0], NotFinite).refuse(&[1.0, 0.0], Reversed).refuse(&[2.0, 2.0], Empty),
        Registered::new("Exponential", "", &[Positive], |p| {
            Ok(exponential(in_ulp::<T, _>("Exponential", Exponential::<T>::from_rate(p[0])?, truth::exponential(p[0]))))
        })
            .case_with("a=1", &[1.0], |e| {
                e.picture("p = exp(−x)", View::Line(between(-0.4, 6.0))).trade(family::EXPONENTIAL, "exponential_1")
            })
            .case("a=1e30", &[1e30])
            .case("a=3.1e-37", &[3.1e-37])
            .seed(&[3.06e-37])
            .refuse(&[NAN], NotFinite).refuse(&[0.0], NotPositive).refuse(&[-1.0], NotPositive).refuse(&[1.0e-40], TooLarge),
        Registered::new("ExponentialTail", "", &[Positive], |p| {
            let warp = ExponentialTail::<T>::from_rate(p[0])?;
            Ok(exponential(in_ulp::<T, _>("ExponentialTail", warp, truth::exponential_tail(p[0])).words(2)))
        })
            .case_with("a=1", &[1.0], |e| {
                let axes = between(-0.4, 9.3).log_y(1e-4);
                e.picture("p = exp(−x), the tail first", View::Line(axes)).trade(family::EXPONENTIAL, "exponential_tail_1")
            })
            .case("a=1e30", &[1e30])
            .case("a=3.1e-37", &[3.1e-37])
            .seed(&[1.0]).seed(&[3.06e-37]).seed(&[f32::MAX])
            .refuse(&[INF], NotFinite).refuse(&[-0.0], NotPositive).refuse(&[TINY], TooLarge),
        Registered::new("TruncatedExponential", "", &[Any, Positive], |p| {
            let warp = TruncatedExponential::<T>::from_rate(p[0], p[1])?;
            let mut entry = in_ulp::<T, _>("TruncatedExponential", warp, truth::truncated_exponential(p[0], p[1]));
            entry.open = false;
            Ok(entry.outside(&[[-1e-45, 0.0, 0.0]]))
        })
            .case_with("c=2 X=3", &[2.0, 3.0], |e| {
                e.picture("p ∝ exp(−2x) on [0, 3]", View::Line(between(-0.3, 3.3)))
                    .trade(family::TRUNCATED, "truncated_exponential_2_3")
            })
            .case_with("c=-2 X=3", &[-2.0, 3.0], |e| e.picture("p ∝ exp(2x) on [0, 3]", View::Line(between(-0.3, 3.3))))
            .case("c=0 X=2", &[0.0, 2.0])
            .case("c=1e-3 X=1", &[1e-3, 1.0])
            .case("c=-7e-3 X=1", &[-7e-3, 1.0])
            .case("c=9e-3 X=1", &[9e-3, 1.0])
            .case("c=30 X=1", &[30.0, 1.0])
            .case("c=-60 X=1", &[-60.0, 1.0])
            .case("c=1e4 X=1", &[1e4, 1.0])
            // Far from the peak of a steep rise towards X, f32 near X resolves 1 part in 1e4 of it.
            .case_with("c=-1e4 X=1", &[-1e4, 1.0], Entry::unresolved)
            .case("c=1e30 X=1e-30", &[1e30, 1e-30])
            .case("c=-17.727 X=0.5695", &[-17.727_365, 0.569_503_3])
            .case("c=1e30 X=1e30", &[1e30, 1e30])
            .case("c=-95 X=1", &[-95.0, 1.0])
            .case("c=3e-39 X=3.4e38", &[3.045_662e-39, 3.391_878_5e38])
            .case("c=-1.76e-6 X=2", &[-1.758_337e-6, 1.998_206_7])
            .seed(&[-f32::MAX, f32::MAX]).seed(&[0.0, f32::MAX]).seed(&[TINY, 1.0])
            .refuse(&[NAN, 1.0], NotFinite).refuse(&[1.0, NAN], NotFinite).refuse(&[1.0, 0.0], NotPositive)
            .refuse(&[1.0, -1.0], NotPositive).refuse(&[1.0, TINY], Empty),
        Registered::new("EquiAngular", "", &[Positive, Any, Any], |p| {
            let warp = EquiAngular::<T>::new(p[0], p[1], p[2])?;
            let [d, a, b] = [p[0], p[1], p[2]].map(f64::from);
            let least = if a < 0.0 && b > 0.0 { d.min(b.max(-a)) } else { 0.0 };
            let truth = truth::equi_angular(p[0], p[1], p[2]);
            let entry = entry::<T, _>("EquiAngular", Domain::Line, Measure::UlpAbove(least), warp, truth);
            Ok(entry.outside(&[[f32::MAX, 0.0, 0.0], [-f32::MAX, 0.0, 0.0]]))
        })
            .ordered(&[[1, 2]])
            .case_with("D=2 [-5, 15]", &[2.0, -5.0, 15.0], |e| {
                e.picture("p ∝ 1/(D² + t²), D = 2", View::Line(between(-7.0, 17.0))).trade("equi-angular", "equi_angular_2")
            })
            .case("D=0 [1, 1e6]", &[0.0, 1.0, 1e6])
            .case("D=0.5 [-9, -0.25]", &[0.5, -9.0, -0.25])
            .case("D=1 [0, 3]", &[1.0, 0.0, 3.0])
            .case("D=1e-12 [-1, 1e4]", &[1e-12, -1.0, 1e4])
            .case("D=1e-12 [1e-6, 1]", &[1e-12, 1e-6, 1.0])
            .case("D=1e12 [-1, 2]", &[1e12, -1.0, 2.0])
            .case_with("D=1 [1000, 1000.01]", &[1.0, 1000.0, 1000.01], Entry::unresolved)
            .seed(&[2.0, -5.0, 15.0]).seed(&[1e-12, -1.0, 1e4]).seed(&[0.0, 1e-12, 1e12]).seed(&[1.0, 0.0, 1e12])
            .seed(&[1.0, -1e-12, 1e12]).seed(&[1.0, -1.0, 1.0]).seed(&[1e12, -1e12, 1e12]).seed(&[1e4, 10.0, 20.0])
            .seed(&[1.0, 0.5, 4.0]).seed(&[3.0, -4.0, -1.0]).seed(&[1e-3, -1e-2, 1e-2]).seed(&[1.0, 1e-4, 1e4])
            .refuse(&[NAN, 0.0, 1.0], NotFinite).refuse(&[1.0, -INF, 1.0], NotFinite).refuse(&[-1.0, 0.0, 1.0], Negative)
            .refuse(&[1.0, 1.0, 0.0], Reversed).refuse(&[1.0, 1.0, 1.0], Empty).refuse(&[TINY, 0.0, 1.0], OutOfRange)
            .refuse(&[0.0, -1.0, 1.0], NotNormalizable).refuse(&[0.0, 0.0, 1.0], NotNormalizable)
            .refuse(&[1.0, 0.0, 1e13], TooLarge).refuse(&[1e13, 0.0, 1.0], TooLarge),
        Registered::new("Tent", "", &[Positive], |p| {
            let entry = in_ulp::<T, _>("Tent", Tent::new(p[0])?, truth::tent(p[0]));
            Ok(entry.outside(&[[f32::MAX, 0.0, 0.0], [-f32::MAX, 0.0, 0.0]]))
        })
            .case_with("r=1", &[1.0], |e| {
                e.picture("p = 1 − |x|", View::Line(between(-1.2, 1.2))).trade(family::LINE, "tent_2")
            })
            .case("r=3e38", &[3e38])
            .case("r=1e-30", &[1e-30])
            .seed(&[f32::MIN_POSITIVE])
            .refuse(&[NAN], NotFinite).refuse(&[0.0], NotPositive).refuse(&[TINY], Empty),
        Registered::new("Linear", "", &[Positive, Positive], |p| {
            let entry = in_ulp::<T, _>("Linear", Linear::new(p[0], p[1])?, truth::linear(p[0], p[1]));
            Ok(entry.outside(&[[-1e-7, 0.0, 0.0], [1.000_000_1, 0.0, 0.0]]))
        })
            .case_with("1 to 3", &[1.0, 3.0], |e| {
                e.picture("p ∝ 1 + 2x", View::Line(between(-0.1, 1.1))).trade(family::LINE, "linear_1_3")
            })
            .case("1 to 0", &[1.0, 0.0])
            .case("0 to 1", &[0.0, 1.0])
            .case("1 to 1", &[1.0, 1.0])
            .case("1 to 1.000001", &[1.0, 1.000_001])
            .case("1e-20 to 1e20", &[1e-20, 1e20])
            .case("3e38 to 1e38", &[3e38, 1e38])
            .case("5500 to 100866", &[5_499.947, 100_865.68])
            .seed(&[TINY, 0.0]).seed(&[f32::MAX, f32::MAX])
            .refuse(&[NAN, 1.0], NotFinite).refuse(&[1.0, INF], NotFinite).refuse(&[-1.0, 1.0], Negative)
            .refuse(&[0.0, 0.0], NotPositive),
        Registered::new("Normal", "", &[Any, Positive], |p| {
            let (mean, std_dev) = (f64::from(p[0]), f64::from(p[1]));
            let (warp, truth) = (Normal::<T>::new(p[0], p[1])?, truth::normal(p[0], p[1]));
            let mut entry = entry::<T, _>("Normal", Domain::Line, Measure::UlpFrom(mean), warp, truth);
            entry.ends = Ends::None;
            Ok(entry.variables(&[("w", mean.abs() / std_dev)]).outside(&[]))
        })
            .case_with("0, 1", &[0.0, 1.0], |e| {
                let mut entry = e.picture("mean 0, deviation 1", View::Line(between(-4.0, 4.0))).trade(family::NORMAL, "normal");
                if let Some(trade) = &mut entry.trade {
                    trade.calls = 2.0;
                }
                entry
            })
            .case_with("100, 1", &[100.0, 1.0], Entry::no_round_trip)
            .case("0, 1e-30", &[0.0, 1e-30])
            .case("0, 1e36", &[0.0, 1e36])
            .seed(&[0.0, 1.0]).seed(&[100.0, 1.0]).seed(&[1.0e37, 1.0e37]).seed(&[0.0, 1.0e-38]).seed(&[1.0e30, 1.0e-30])
            .refuse(&[NAN, 1.0], NotFinite).refuse(&[0.0, 0.0], NotPositive).refuse(&[0.0, -1.0], NotPositive)
            .refuse(&[0.0, 1.0e38], TooLarge).refuse(&[0.0, TINY], Empty),
    ]
}

/// What both exponentials have in common. The ends are not bounds of a domain but the last sample.
fn exponential(mut entry: Entry) -> Entry {
    entry.ends = Ends::Samples;
    entry.outside(&[[-1e-45, 0.0, 0.0]])
}

fn interval<T: Tier>(
    name: &'static str,
    p: &[f32],
    warp: Result<Interval, Error>,
    increasing: bool,
) -> Result<Entry, Error> {
    let scale = Measure::UlpOf(p[0].abs().max(p[1].abs()).into());
    let truth = truth::interval(p[0], p[1], increasing);
    let entry = entry::<T, _>(name, Domain::Line, scale, warp?, truth);
    Ok(entry.outside(&[[f32::MAX, 0.0, 0.0], [-f32::MAX, 0.0, 0.0]]))
}
