//! The warps of the line, but for powers and what users compose.

use super::evidence::{normal, ramp};
use super::picture::{View, between};
use super::{Domain, Ends, Entry, Measure, Registered, entry, evidence, in_both};
use crate::adversary::words::Kind::{Any, Positive};
use crate::peers;
use crate::truth::{self, Truth, exact};
use microwarp::Error::{self, *};
use microwarp::Invert;
use microwarp::tier::Tier;
use microwarp::warp::*;
use std::f64::consts::PI;
use std::sync::Arc;

const NAN: f32 = f32::NAN;
const INF: f32 = f32::INFINITY;

const TINY: f32 = 1.0e-45;

/// A warp of the line whose error is counted in ulp of the sample.
pub(super) fn in_ulp<T: Tier, W>(name: &'static str, warp: W, truth: Arc<dyn Truth>) -> Entry
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
                e.picture("uniform on [−3, 5)", View::Line(between(-4.0, 6.0)))
            })
            .control("an interval bent by a power of xi near 1", |[u, ..], wrong| [8.0 * u.powf(1.0 + wrong) - 3.0, 0.0, 0.0], &["chi-square", "distance", "mean x"])
            .case("[0, 1]", &[0.0, 1.0])
            .case("[-3e38, 3e38]", &[-3e38, 3e38])
            .case_with("[1e6, 1e6+1/16]", &[1e6, 1e6 + 0.0625], Entry::unresolved)
            .case("[0, 1e-35]", &[0.0, 1e-35])
            .case("[-1.7374, -1.5582]", &[-1.737_384_2, -1.558_242_2])
            .seed(&[-f32::MAX, f32::MAX]).seed(&[0.0, 3.0e-39]).seed(&[1.0, 1.000_000_1])
            .refuse(&[NAN, 1.0], NotFinite(0)).refuse(&[0.0, INF], NotFinite(1)).refuse(&[1.0, 0.0], Reversed(1))
            .refuse(&[1.0, 1.0], Empty(1)).refuse(&[0.0, TINY], Empty(1))
            .constant(in_both!(Interval::new(0.1, 0.7)))
            .constant(in_both!(Interval::decreasing(-0.1, 0.7)))
            .gives_back(|p| Interval::new(p[0], p[1]).map(|warp| vec![warp.low(), warp.high()])),
        Registered::new("Interval", "decreasing", &[Any, Any], |p| {
            interval::<T>("Interval decreasing", p, Interval::decreasing(p[0], p[1]), false)
        })
            .ordered(&[[0, 1]])
            .case_with("[-3, 5]", &[-3.0, 5.0], |e| {
                e.picture("the same, 5 first", View::Line(between(-4.0, 6.0)))
            })
            .case("[0, 1]", &[0.0, 1.0])
            .case("[-3e38, 3e38]", &[-3e38, 3e38])
            .case_with("[1e6, 1e6+1/16]", &[1e6, 1e6 + 0.0625], Entry::unresolved)
            .case("[0, 1e-35]", &[0.0, 1e-35])
            .case("[-1.7374, -1.5582]", &[-1.737_384_2, -1.558_242_2])
            .refuse(&[-INF, 1.0], NotFinite(0)).refuse(&[1.0, 0.0], Reversed(1)).refuse(&[2.0, 2.0], Empty(1)),
        Registered::new("Exponential", "", &[Positive], |p| {
            Ok(half_line(in_ulp::<T, _>("Exponential", Exponential::<T>::from_rate(p[0])?, exact!(exponential(p[0])))).own_density())
        })
            .case_with("a=1", &[1.0], |e| {
                e.picture("p = exp(−x)", View::Line(between(-0.4, 6.0))).trade(evidence::EXPONENTIAL, "exponential_1")
            })
            .control("an exponential whose rate is off", |[u, ..], wrong| [-(-u).ln_1p() / (1.0 + wrong), 0.0, 0.0], &["chi-square", "distance", "mean x", "mean x²"])
            .case("a=1e30", &[1e30])
            .case("a=3.1e-37", &[3.1e-37])
            .seed(&[3.06e-37])
            .refuse(&[NAN], NotFinite(0)).refuse(&[0.0], NotPositive(0)).refuse(&[-1.0], NotPositive(0)).refuse(&[1.0e-40], TooLarge(0))
            .constant(in_both!(Exponential<T>::from_rate(0.7)))
            .constant(in_both!(Exponential<T>::from_mean(0.7)))
            .gives_back(|p| Exponential::<T>::from_rate(p[0]).map(|warp| vec![warp.rate()])),
        Registered::new("ExponentialTail", "", &[Positive], |p| {
            let warp = ExponentialTail::<T>::from_rate(p[0])?;
            Ok(half_line(in_ulp::<T, _>("ExponentialTail", warp, exact!(exponential_tail(p[0]))).words(2)).own_density().deep())
        })
            .case_with("a=1", &[1.0], |e| {
                let axes = between(-0.4, 9.3).log_y(1e-4);
                e.picture("p = exp(−x), the tail first", View::Line(axes)).trade(evidence::EXPONENTIAL, "exponential_tail_1")
            })
            .control("a tail whose rate is off", |[u, ..], wrong| [-(1.0 - u).ln() / (1.0 + wrong), 0.0, 0.0], &["chi-square", "distance", "mean x"])
            .without("moment", "a draw takes two words, whose pairs are too many")
            .without("peer", "rand_distr has none by two words; Exp1 stands beside Exponential")
            .case("a=1e30", &[1e30])
            .case("a=3.1e-37", &[3.1e-37])
            .seed(&[1.0]).seed(&[3.06e-37]).seed(&[f32::MAX])
            .refuse(&[INF], NotFinite(0)).refuse(&[-0.0], NotPositive(0)).refuse(&[TINY], TooLarge(0))
            .constant(in_both!(ExponentialTail<T>::from_rate(3.0)))
            .constant(in_both!(ExponentialTail<T>::from_mean(3.0)))
            .gives_back(|p| ExponentialTail::<T>::from_rate(p[0]).map(|warp| vec![warp.rate()])),
        Registered::new("TruncatedExponential", "", &[Any, Positive], |p| {
            let warp = TruncatedExponential::<T>::from_rate(p[0], p[1])?;
            let mut entry = in_ulp::<T, _>("TruncatedExponential", warp, exact!(truncated_exponential(p[0], p[1])));
            entry.open = false;
            Ok(entry.own_density().deep().outside(&[[-1e-45, 0.0, 0.0]]))
        })
            .case_with("c=2 X=3", &[2.0, 3.0], |e| e.picture("p ∝ exp(−2x) on [0, 3]", View::Line(between(-0.3, 3.3))))
            .without("peer", "rand_distr has none")
            .control("a truncated exponential whose rate is off", |[u, ..], wrong| [cut(u, 2.0 + 2.0 * wrong), 0.0, 0.0], &["chi-square", "distance", "mean x"])
            // The start of a steep rise has its own share.
            .moment(&[-1e4, 1.0], "y^4", |x, _| (1e4 * (1.0 - x)).powi(4), 24.0, 1e-3)
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
            .refuse(&[NAN, 1.0], NotFinite(0)).refuse(&[1.0, NAN], NotFinite(1)).refuse(&[1.0, 0.0], NotPositive(1))
            .refuse(&[1.0, -1.0], NotPositive(1)).refuse(&[1.0, TINY], Empty(1))
            .constant(in_both!(TruncatedExponential<T>::from_rate(1e-7, 3.0)))
            .constant(in_both!(TruncatedExponential<T>::from_rate(0.7, 3.0)))
            .constant(in_both!(TruncatedExponential<T>::from_rate(-0.7, 3.0)))
            .constant(in_both!(TruncatedExponential<T>::from_rate(-700.0, 0.3)))
            .constant(in_both!(TruncatedExponential<T>::from_mean(0.7, 3.0)))
            .gives_back(|p| TruncatedExponential::<T>::from_rate(p[0], p[1]).map(|warp| vec![warp.rate(), warp.length()])),
        Registered::new("EquiAngular", "", &[Positive, Any, Any], |p| {
            let warp = EquiAngular::<T>::new(p[0], p[1], p[2])?;
            let [d, a, b] = [p[0], p[1], p[2]].map(f64::from);
            let least = if a < 0.0 && b > 0.0 { d.min(b.max(-a)) } else { 0.0 };
            let truth = exact!(equi_angular(p[0], p[1], p[2]));
            let entry = entry::<T, _>("EquiAngular", Domain::Line, Measure::UlpAbove(least), warp, truth);
            Ok(entry.outside(&[[f32::MAX, 0.0, 0.0], [-f32::MAX, 0.0, 0.0]]))
        })
            .ordered(&[[1, 2]])
            .case_with("D=2 [-5, 15]", &[2.0, -5.0, 15.0], |e| {
                e.picture("p ∝ 1/(D² + t²), D = 2", View::Line(between(-7.0, 17.0)))
            })
            .control("equal steps along the ray", |[u, ..], _| [20.0 * u - 5.0, 0.0, 0.0], &["chi-square", "distance", "mean x²"])
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
            .refuse(&[NAN, 0.0, 1.0], NotFinite(0)).refuse(&[1.0, -INF, 1.0], NotFinite(1)).refuse(&[-1.0, 0.0, 1.0], Negative(0))
            .refuse(&[1.0, 1.0, 0.0], Reversed(2)).refuse(&[1.0, 1.0, 1.0], Empty(2)).refuse(&[TINY, 0.0, 1.0], OutOfRange(0))
            .refuse(&[0.0, -1.0, 1.0], NotNormalizable(Error::NO_PLACE)).refuse(&[0.0, 0.0, 1.0], NotNormalizable(Error::NO_PLACE))
            .refuse(&[1.0, 0.0, 1e13], TooLarge(2)).refuse(&[1e13, 0.0, 1.0], TooLarge(0))
            .gives_back(|p| EquiAngular::<T>::new(p[0], p[1], p[2]).map(|warp| vec![warp.distance(), warp.low(), warp.high()]))
            .without("constant", "its constructor is no constant function: it takes roots"),
        Registered::new("Tent", "", &[Positive], |p| {
            let entry = in_ulp::<T, _>("Tent", Tent::new(p[0])?, exact!(tent(p[0])));
            Ok(entry.own_density().deep().outside(&[[f32::MAX, 0.0, 0.0], [-f32::MAX, 0.0, 0.0]]))
        })
            .case_with("r=1", &[1.0], |e| e.picture("p = 1 − |x|", View::Line(between(-1.2, 1.2))))
            .without("peer", "Triangular of rand_distr has a mode anywhere")
            .control("a box for a tent", |[u, ..], _| [2.0 * u - 1.0, 0.0, 0.0], &["chi-square", "distance", "mean x²"])
            .case("r=3e38", &[3e38])
            .width(&[1.0], 2.0, 2e-5).width(&[3e18], 2.0 * f64::from(3e18_f32), 2e-5)
            .case("r=1e-30", &[1e-30])
            .seed(&[f32::MIN_POSITIVE])
            .refuse(&[NAN], NotFinite(0)).refuse(&[0.0], NotPositive(0)).refuse(&[TINY], Empty(0))
            .constant(in_both!(Tent::new(0.3)))
            .gives_back(|p| Tent::new(p[0]).map(|warp| vec![warp.radius()])),
        Registered::new("Linear", "", &[Positive, Positive], |p| {
            let entry = in_ulp::<T, _>("Linear", Linear::new(p[0], p[1])?, exact!(linear(p[0], p[1])));
            Ok(entry.own_density().deep().outside(&[[-1e-7, 0.0, 0.0], [1.000_000_1, 0.0, 0.0]]))
        })
            .case_with("1 to 3", &[1.0, 3.0], |e| e.picture("p ∝ 1 + 2x", View::Line(between(-0.1, 1.1))))
            .without("peer", "rand_distr has none")
            .control("a slope slightly off", |[u, ..], wrong| [ramp(u, 1.0 + 4.0 * wrong, 3.0), 0.0, 0.0], &["chi-square", "distance", "mean x"])
            .case("1 to 0", &[1.0, 0.0])
            .case("0 to 1", &[0.0, 1.0])
            .case("1 to 1", &[1.0, 1.0])
            .case("1 to 1.000001", &[1.0, 1.000_001])
            .case("1e-20 to 1e20", &[1e-20, 1e20])
            .case("3e38 to 1e38", &[3e38, 1e38])
            .case("5500 to 100866", &[5_499.947, 100_865.68])
            .width(&[0.0, 1.0], 1.0, 2e-5).width(&[1e-20, 1.0], 1.0, 2e-5).width(&[0.0, 3e38], 1.0, 2e-5)
            .seed(&[TINY, 0.0]).seed(&[f32::MAX, f32::MAX])
            .refuse(&[NAN, 1.0], NotFinite(0)).refuse(&[1.0, INF], NotFinite(1)).refuse(&[-1.0, 1.0], Negative(0))
            .refuse(&[0.0, 0.0], NotPositive(1))
            .constant(in_both!(Linear::new(0.1, 0.3)))
            .without("getters", "its ends are densities"),
        Registered::new("Normal", "", &[Any, Positive], |p| {
            let (mean, std_dev) = (f64::from(p[0]), f64::from(p[1]));
            let (warp, truth) = (Normal::<T>::new(p[0], p[1])?, exact!(normal(p[0], p[1])));
            let mut entry = entry::<T, _>("Normal", Domain::Line, Measure::UlpFrom(mean, 0.0), warp, truth);
            entry.ends = Ends::None;
            entry.deep = true;
            Ok(entry.middle().own_density().variables(&[("w", mean.abs() / std_dev)]).outside(&[]))
        })
            .case_with("0, 1", &[0.0, 1.0], |e| {
                e.picture("mean 0, deviation 1", View::Line(between(-4.0, 4.0))).trade(evidence::NORMAL, "normal")
            })
            .control("a normal of a deviation slightly too large", |[u, v, _], wrong| [(1.0 + wrong) * normal(u, v), 0.0, 0.0], &["chi-square", "distance", "mean x²"])
            .moment(&[0.0, 1.0], "z^2", |z, _| z.powi(2), 1.0, 1e-6).moment(&[0.0, 1.0], "z^4", |z, _| z.powi(4), 3.0, 1e-6)
            .moment(&[0.0, 1.0], "z^8", |z, _| z.powi(8), 105.0, 3e-6)
            .peer("normal, one at a time", &[0.5, 1.5], "StandardNormal", || peers::block(rand_distr::Normal::new(0.5, 1.5)))
            .case_with("100, 1", &[100.0, 1.0], Entry::no_round_trip)
            .case("0, 1e-30", &[0.0, 1e-30])
            .case("0, 1e36", &[0.0, 1e36])
            .seed(&[0.0, 1.0]).seed(&[100.0, 1.0]).seed(&[1.0e37, 1.0e37]).seed(&[0.0, 1.0e-38]).seed(&[1.0e30, 1.0e-30])
            .refuse(&[NAN, 1.0], NotFinite(0)).refuse(&[0.0, 0.0], NotPositive(1)).refuse(&[0.0, -1.0], NotPositive(1))
            .refuse(&[0.0, 1.0e38], TooLarge(1)).refuse(&[0.0, TINY], Empty(1))
            .constant(in_both!(Normal<T>::new(0.3, 1.7)))
            .gives_back(|p| Normal::<T>::new(p[0], p[1]).map(|warp| vec![warp.mean(), warp.std_dev()])),
        Registered::new("TruncatedNormal", "new", &[Any, Positive, Any, Any], |p| {
            truncated_normal::<T>("TruncatedNormal", p, [p[2], p[3]], TruncatedNormal::new(p[0], p[1], p[2], p[3]))
        })
            .ordered(&[[2, 3]])
            .case_with("0, 1 [-1, 2]", &[0.0, 1.0, -1.0, 2.0], |e| {
                e.picture("mean 0, deviation 1, on [−1, 2]", View::Line(between(-1.5, 2.5)))
            })
            .control("a normal number clipped to the interval", |[u, v, _], _| [normal(u, v).clamp(-1.0, 2.0), 0.0, 0.0], &["chi-square", "distance", "mean x"])
            .case("0, 1 [30, 31]", &[0.0, 1.0, 30.0, 31.0])
            .case("0, 1 [-11, -10]", &[0.0, 1.0, -11.0, -10.0])
            .control("a tail by a difference of probabilities that cancels in f32", cancelled, &["chi-square", "distance", "mean x"])
            .case("0, 1 [-1e-6, 2e-6]", &[0.0, 1.0, -1e-6, 2e-6])
            .case("5, 2 [-1000, 4]", &[5.0, 2.0, -1000.0, 4.0])
            .case("-1e4, 1 [0, 1]", &[-1e4, 1.0, 0.0, 1.0])
            .case_with("0, 1 [1e4, 1e4+1]", &[0.0, 1.0, 1e4, 1e4 + 1.0], Entry::unresolved)
            .case_with("1, 1 [1, 1.0000001]", &[1.0, 1.0, 1.0, 1.000_000_1], Entry::unresolved)
            .case("0, 1e36 [-3e36, 1e38]", &[0.0, 1e36, -3e36, 1e38])
            .seed(&[0.0, 1.0, -1.0, 2.0]).seed(&[0.0, 1.0, 30.0, 31.0]).seed(&[0.0, 1.0, -11.0, -10.0])
            .seed(&[0.0, 1.0, -1e-6, 2e-6]).seed(&[0.0, 1.0, 0.0, 0.1]).seed(&[-1e4, 1.0, 0.0, 1.0])
            .seed(&[0.0, 1.0, -13.5, 13.5]).seed(&[0.0, 1.0, -14.1, 14.5]).seed(&[0.0, 1.0, -0.75, 0.7])
            .seed(&[-15.0, 1.0, 0.0, 10.0]).seed(&[15.0, 1.0, -10.0, 0.0]).seed(&[0.0, f32::MAX, -1e38, 1e38])
            .seed(&[-1e18, 1.0, 0.0, 1e-17]).seed(&[0.0, 1e30, 0.0, 1e-30]).seed(&[-1.0, 1.0, 0.0, 1.0])
            .refuse(&[NAN, 1.0, 0.0, 1.0], NotFinite(0)).refuse(&[0.0, 1.0, 0.0, INF], NotFinite(3))
            .refuse(&[0.0, 0.0, 0.0, 1.0], NotPositive(1)).refuse(&[0.0, -1.0, 0.0, 1.0], NotPositive(1))
            .refuse(&[0.0, 1.0, 1.0, 0.0], Reversed(3)).refuse(&[0.0, 1.0, 1.0, 1.0], Empty(3))
            .refuse(&[0.0, 1.0, 0.0, TINY], Empty(Error::NO_PLACE)).refuse(&[0.0, TINY, 0.0, 1.0], Empty(Error::NO_PLACE))
            .refuse(&[0.0, 1.0, 1e19, 2e19], OutOfRange(Error::NO_PLACE)).refuse(&[0.0, 1e38, -f32::MAX, f32::MAX], TooLarge(3))
            .gives_back(|p| TruncatedNormal::<T>::new(p[0], p[1], p[2], p[3]).map(|warp| vec![warp.mean(), warp.std_dev(), warp.low(), warp.high()]))
            .without("constant", "its constructor is no constant function: it takes roots"),
        Registered::new("TruncatedNormal", "above", &[Any, Positive, Any], |p| {
            truncated_normal::<T>("TruncatedNormal above", p, [p[2], INF], TruncatedNormal::above(p[0], p[1], p[2]))
        })
            .case_with("0, 1 [0, ∞)", &[0.0, 1.0, 0.0], |e| e.picture("the same on [0, ∞)", View::Line(between(-0.5, 4.0))))
            .moment(&[0.0, 1.0, 0.0], "z^4", |z, _| z.powi(4), 3.0, 1e-6).moment(&[0.0, 1.0, 0.0], "z^8", |z, _| z.powi(8), 105.0, 3e-6)
            .without("peer", "rand_distr has none")
            .case("0, 1 [10, ∞)", &[0.0, 1.0, 10.0])
            .case("-100, 1 [0, ∞)", &[-100.0, 1.0, 0.0])
            .case("0, 1 [-1.5, ∞)", &[0.0, 1.0, -1.5])
            .case("0, 1e36 [-1e38, ∞)", &[0.0, 1e36, -1e38])
            .seed(&[0.0, 1.0, 0.0]).seed(&[0.0, 1.0, 10.0]).seed(&[-100.0, 1.0, 0.0]).seed(&[0.0, 1.0, -1.5])
            .seed(&[-14.9, 1.0, 0.0]).seed(&[-1.0, 1.0, 0.0]).seed(&[0.0, 1e37, 0.0]).seed(&[-1e18, 1.0, 0.0])
            .seed(&[0.0, 1.0, -14.1])
            .refuse(&[NAN, 1.0, 0.0], NotFinite(0)).refuse(&[0.0, 1.0, -INF], NotFinite(2)).refuse(&[0.0, 0.0, 0.0], NotPositive(1))
            .refuse(&[0.0, 1e38, 0.0], TooLarge(Error::NO_PLACE)).refuse(&[0.0, 1.0, 1e19], OutOfRange(Error::NO_PLACE)).refuse(&[0.0, TINY, 0.0], Empty(Error::NO_PLACE)),
        Registered::new("TruncatedNormal", "below", &[Any, Positive, Any], |p| {
            truncated_normal::<T>("TruncatedNormal below", p, [-INF, p[2]], TruncatedNormal::below(p[0], p[1], p[2]))
        })
            .case_with("0, 1 (-∞, 1]", &[0.0, 1.0, 1.0], |e| e.picture("the same on (−∞, 1]", View::Line(between(-4.0, 1.5))))
            .case("0, 1 (-∞, -10]", &[0.0, 1.0, -10.0])
            .case("1e4, 1 (-∞, 0]", &[1e4, 1.0, 0.0])
            .seed(&[0.0, 1.0, 1.0]).seed(&[0.0, 1.0, -10.0]).seed(&[1e4, 1.0, 0.0]).seed(&[1.0, 1.0, 0.0])
            .seed(&[14.9, 1.0, 0.0]).seed(&[0.0, 1e37, 0.0]).seed(&[1e18, 1.0, 0.0]).seed(&[0.0, 1.0, 14.1])
            .refuse(&[NAN, 1.0, 0.0], NotFinite(0)).refuse(&[0.0, 1.0, INF], NotFinite(2)).refuse(&[0.0, -0.0, 0.0], NotPositive(1))
            .refuse(&[0.0, 1e38, 0.0], TooLarge(Error::NO_PLACE)).refuse(&[0.0, 1.0, -1e19], OutOfRange(Error::NO_PLACE)).refuse(&[0.0, TINY, 0.0], Empty(Error::NO_PLACE)),
        Registered::new("Cauchy", "", &[Any, Positive], |p| {
            Ok(located::<T, _>("Cauchy", p, Cauchy::<T>::new(p[0], p[1])?, exact!(cauchy(p[0], p[1]))).own_density().deep())
        })
            .case_with("0, 1", &[0.0, 1.0], |e| e.picture("p ∝ 1/(1 + x²)", View::Line(between(-6.0, 6.0))))
            .control("a Cauchy number of a scale slightly too large", |[u, ..], wrong| [-(1.0 + wrong) / (PI * (u + 1e-9)).tan(), 0.0, 0.0], &["chi-square", "distance"])
            // Of a law that has no mean: 1/cos(π/4).
            .moment(&[0.0, 1.0], "√|x|", |x, _| x.abs().sqrt(), 2f64.sqrt(), 4e-5)
            .peer("Cauchy", &[0.0, 1.0], "Cauchy", || peers::block(rand_distr::Cauchy::new(0.0, 1.0)))
            .case_with("100, 1", &[100.0, 1.0], Entry::no_round_trip)
            .case("0, 1e-30", &[0.0, 1e-30])
            .case("0, 2e19", &[0.0, 2e19])
            .seed(&[0.0, 1.0]).seed(&[100.0, 1.0]).seed(&[1.0e37, 1.0e19]).seed(&[0.0, 1.0e-38]).seed(&[1.0e30, 1.0e-30])
            .refuse(&[NAN, 1.0], NotFinite(0)).refuse(&[0.0, 0.0], NotPositive(1)).refuse(&[0.0, -1.0], NotPositive(1))
            .refuse(&[0.0, 1.0e20], TooLarge(1)).refuse(&[0.0, TINY], Empty(1))
            .constant(in_both!(Cauchy<T>::new(0.3, 1.7)))
            .gives_back(|p| Cauchy::<T>::new(p[0], p[1]).map(|warp| vec![warp.location(), warp.scale()])),
        Registered::new("StudentT", "", &[Positive, Any, Positive], student_t::<T>)
            .case_with("5, 0, 1", &[5.0, 0.0, 1.0], |e| e.picture("p of 5 degrees of freedom", View::Line(between(-6.0, 6.0))))
            .control("a Student's t of other degrees", |[u, v, _], wrong| [-truth::student_radius(5.0 + 50.0 * wrong, u) * (PI * v).cos(), 0.0, 0.0], &["chi-square", "distance"])
            .without("moment", "a draw takes two words, whose pairs are too many")
            .peer("Student's t", &[5.0, 0.0, 1.0], "StudentT", || peers::block(rand_distr::StudentT::new(5.0)))
            .peer("Student's t of 2 degrees", &[2.0, 0.0, 1.0], "StudentT", || peers::block(rand_distr::StudentT::new(2.0)))
            .case("2, 100, 1", &[2.0, 100.0, 1.0])
            .case("0.5, 0, 1e-30", &[0.5, 0.0, 1e-30])
            .case("1, 0, 1e20", &[1.0, 0.0, 1e20])
            .case("300, 0, 1", &[300.0, 0.0, 1.0])
            .case_with("1e12, 0, 1e36", &[1e12, 0.0, 1e36], Entry::unresolved)
            .case_with("3e38, 0, 1", &[3e38, 0.0, 1.0], Entry::unresolved)
            .seed(&[1.0, 0.0, 1.0]).seed(&[0.27, 0.0, 1.0]).seed(&[0.267, 0.0, 1e-10]).seed(&[15.9, 1e30, 1e-30]).seed(&[1e8, 100.0, 1.0])
            .seed(&[1.09e12, 0.0, 1.0]).seed(&[1.425_096_8e21, -0.000_163_293_23, 1.190_516_5e-5]).seed(&[0.300_656_57, -0.196_591_26, 1737.2739])
            .seed(&[1.0, 1e37, 1e20]).seed(&[3.0, 0.0, 1e-38])
            .refuse(&[NAN, 0.0, 1.0], NotFinite(0)).refuse(&[INF, 0.0, 1.0], NotFinite(0)).refuse(&[0.0, 0.0, 1.0], NotPositive(0))
            .refuse(&[-1.0, 0.0, 1.0], NotPositive(0)).refuse(&[1.0, NAN, 1.0], NotFinite(1)).refuse(&[1.0, 0.0, 0.0], NotPositive(2))
            .refuse(&[1.0, 0.0, -1.0], NotPositive(2)).refuse(&[0.26, 0.0, 1.0], TooLarge(0)).refuse(&[TINY, 0.0, 1.0], TooLarge(0))
            .refuse(&[1.0, 0.0, 1.0e30], TooLarge(Error::NO_PLACE)).refuse(&[1.0, 0.0, TINY], Empty(2))
            .constant(in_both!(StudentT<T>::new(2.7, 0.3, 1.7)))
            .constant(in_both!(StudentT<T>::new(1e20, 0.3, 1.7)))
            .gives_back(|p| StudentT::<T>::new(p[0], p[1], p[2]).map(|warp| vec![warp.degrees(), warp.location(), warp.scale()])),
        Registered::new("Laplace", "", &[Any, Positive], |p| {
            Ok(located::<T, _>("Laplace", p, Laplace::<T>::new(p[0], p[1])?, exact!(laplace(p[0], p[1]))).own_density().deep())
        })
            .case_with("0, 1", &[0.0, 1.0], |e| e.picture("p = exp(−|x|)/2", View::Line(between(-5.0, 5.0))))
            .control("a Laplace number that is positive slightly too often", |[u, v, _], wrong| [-(-u).ln_1p() * (0.5 + 0.5 * wrong - v).signum(), 0.0, 0.0], &["chi-square", "distance", "mean x"])
            .moment(&[0.0, 1.0], "x^4", |x, _| x.powi(4), 24.0, 4e-4).moment(&[0.0, 1.0], "x^8", |x, _| x.powi(8), 40_320.0, 4e-4)
            .without("peer", "rand_distr has none")
            .case_with("100, 1", &[100.0, 1.0], Entry::no_round_trip)
            .case("0, 1e-30", &[0.0, 1e-30])
            .case("0, 1e36", &[0.0, 1e36])
            .seed(&[0.0, 1.0]).seed(&[100.0, 1.0]).seed(&[1.0e37, 1.0e36]).seed(&[0.0, 1.0e-38]).seed(&[1.0e30, 1.0e-30])
            .refuse(&[INF, 1.0], NotFinite(0)).refuse(&[0.0, 0.0], NotPositive(1)).refuse(&[0.0, -1.0], NotPositive(1))
            .refuse(&[0.0, 1.0e37], TooLarge(1)).refuse(&[0.0, TINY], Empty(1))
            .constant(in_both!(Laplace<T>::new(0.3, 1.7)))
            .gives_back(|p| Laplace::<T>::new(p[0], p[1]).map(|warp| vec![warp.location(), warp.scale()])),
        Registered::new("Logistic", "", &[Any, Positive], |p| {
            Ok(located::<T, _>("Logistic", p, Logistic::<T>::new(p[0], p[1])?, exact!(logistic(p[0], p[1]))).or_scale(p[1]).middle().own_density_of_word())
        })
            .case_with("0, 1", &[0.0, 1.0], |e| e.picture("p = 1/(4 cosh²(x/2))", View::Line(between(-7.0, 7.0))))
            .control("a logistic number of a scale slightly too large", |[u, ..], wrong| [(1.0 + wrong) * ((u + 1e-9) / (1.0 - u)).ln(), 0.0, 0.0], &["chi-square", "distance"])
            .moment(&[0.0, 1.0], "x^4", |x, _| x.powi(4), 7.0 * PI.powi(4) / 15.0, 4e-4)
            .moment(&[0.0, 1.0], "x^8", |x, _| x.powi(8), 127.0 * PI.powi(8) / 15.0, 4e-4)
            .without("peer", "rand_distr has none")
            .case_with("100, 1", &[100.0, 1.0], Entry::no_round_trip)
            .case("0, 1e-30", &[0.0, 1e-30])
            .case("0, 1e36", &[0.0, 1e36])
            .seed(&[0.0, 1.0]).seed(&[100.0, 1.0]).seed(&[1.0e37, 1.0e36]).seed(&[0.0, 1.0e-38]).seed(&[1.0e30, 1.0e-30])
            .refuse(&[0.0, NAN], NotFinite(1)).refuse(&[0.0, 0.0], NotPositive(1)).refuse(&[0.0, -1.0], NotPositive(1))
            .refuse(&[0.0, 1.0e37], TooLarge(1)).refuse(&[0.0, TINY], Empty(1))
            .constant(in_both!(Logistic<T>::new(0.3, 1.7)))
            .gives_back(|p| Logistic::<T>::new(p[0], p[1]).map(|warp| vec![warp.location(), warp.scale()])),
        Registered::new("TruncatedLogistic", "", &[Any, Positive, Any, Any], |p| {
            truncated_logistic::<T>(p, TruncatedLogistic::new(p[0], p[1], p[2], p[3])?)
        })
            .ordered(&[[2, 3]])
            .case_with("538, 69.4 [360, 830]", &[538.0, 69.444_44, 360.0, 830.0], |e| {
                e.picture("visible wavelengths in nm, after pbrt", View::Line(between(330.0, 860.0)))
            })
            .control("a logistic number clipped to the interval", |[u, ..], _| [(538.0 + 69.444_44 * ((u + 1e-9) / (1.0 - u)).ln()).clamp(360.0, 830.0), 0.0, 0.0], &["chi-square", "distance", "mean x"])
            .moment(&[0.0, 1.0, -700.0, 700.0], "x^4", |x, _| x.powi(4), 7.0 * PI.powi(4) / 15.0, 4e-4)
            .without("peer", "rand_distr has none")
            .case("0, 1 [-1, 2]", &[0.0, 1.0, -1.0, 2.0])
            .case("0, 0.2 [-π, π]", &[0.0, 0.2, -std::f32::consts::PI, std::f32::consts::PI])
            .case("0, 1 [30, 31]", &[0.0, 1.0, 30.0, 31.0])
            .case("0, 1 [-500, -10]", &[0.0, 1.0, -500.0, -10.0])
            .case("0, 1 [-1e-6, 2e-6]", &[0.0, 1.0, -1e-6, 2e-6])
            .case("5, 2 [-1000, 4]", &[5.0, 2.0, -1000.0, 4.0])
            .case_with("0, 1 [1e4, 1e4+1]", &[0.0, 1.0, 1e4, 1e4 + 1.0], Entry::unresolved)
            .case_with("1, 1 [1, 1.0000001]", &[1.0, 1.0, 1.0, 1.000_000_1], Entry::unresolved)
            .case("0, 1e36 [-3e36, 3e37]", &[0.0, 1e36, -3e36, 3e37])
            .seed(&[0.0, 1.0, -1.0, 2.0]).seed(&[0.0, 1.0, 30.0, 31.0]).seed(&[0.0, 1.0, -11.0, -10.0])
            .seed(&[0.0, 1.0, -1e-6, 2e-6]).seed(&[0.0, 1.0, 0.0, 0.1]).seed(&[538.0, 69.444_44, 360.0, 830.0])
            .seed(&[0.0, 1.0, -2.0, 2.0]).seed(&[0.0, 1.0, -1.999, 2.0]).seed(&[0.0, 1.0, -1.0, 3.5]).seed(&[0.0, 1.0, -1e-3, 100.0])
            .seed(&[0.0, 1.0, -100.0, 110.0]).seed(&[1e30, 1.0, 0.0, 1e-17]).seed(&[0.0, 1e30, 0.0, 1e-30]).seed(&[0.0, 1.0, -1.0, 0.0])
            .seed(&[0.0, 1e-30, 1.0, 2.0]).seed(&[0.0, 1e37, -1e37, 2e37]).seed(&[0.0, 1e-38, 0.0, 1.0]).seed(&[0.0, 1.0, 1.0, 70.0])
            .seed(&[0.0, 4e-39, -7.9e-39, 7.9e-39]).refuse(&[0.0, 6e-40, -1.2e-39, 1.19e-39], Empty(Error::NO_PLACE))
            .refuse(&[NAN, 1.0, 0.0, 1.0], NotFinite(0)).refuse(&[0.0, 1.0, 0.0, INF], NotFinite(3)).refuse(&[0.0, INF, 0.0, 1.0], NotFinite(1))
            .refuse(&[0.0, 0.0, 0.0, 1.0], NotPositive(1)).refuse(&[0.0, -1.0, 0.0, 1.0], NotPositive(1))
            .refuse(&[0.0, 1.0, 1.0, 0.0], Reversed(3)).refuse(&[0.0, 1.0, 1.0, 1.0], Empty(3))
            .refuse(&[0.0, 1.0, 0.0, TINY], Empty(Error::NO_PLACE)).refuse(&[0.0, TINY, 0.0, 1.0], Empty(Error::NO_PLACE))
            .refuse(&[0.0, 1e38, 0.0, 1.0], TooLarge(Error::NO_PLACE)).refuse(&[0.0, 1.0, -f32::MAX, f32::MAX], TooLarge(Error::NO_PLACE))
            .constant(in_both!(TruncatedLogistic<T>::new(538.0, 69.444_44, 360.0, 830.0)))
            .constant(in_both!(TruncatedLogistic<T>::new(0.3, 1.7, 5.1, 5.2)))
            .gives_back(|p| TruncatedLogistic::<T>::new(p[0], p[1], p[2], p[3]).map(|warp| vec![warp.location(), warp.scale(), warp.low(), warp.high()])),
        Registered::new("Gumbel", "", &[Any, Positive], |p| {
            Ok(located::<T, _>("Gumbel", p, Gumbel::<T>::new(p[0], p[1])?, exact!(gumbel(p[0], p[1]))).or_scale(p[1]).middle().own_density_of_word())
        })
            .case_with("0, 1", &[0.0, 1.0], |e| e.picture("p = exp(−x − exp(−x))", View::Line(between(-3.0, 7.0))))
            .control("a Gumbel number of minima", |[u, ..], _| [(-(-u).ln_1p() + 1e-9).ln(), 0.0, 0.0], &["chi-square", "distance", "mean x"])
            // Γ(1 − k) of e^(kx).
            .moment(&[0.0, 1.0], "e^(x/2)", |x, _| (0.5 * x).exp(), PI.sqrt(), 4e-5).moment(&[0.0, 1.0], "e^(-4x)", |x, _| (-4.0 * x).exp(), 24.0, 1e-5)
            .peer("Gumbel", &[0.0, 1.0], "Gumbel", || peers::block(rand_distr::Gumbel::new(0.0, 1.0)))
            .case_with("100, 1", &[100.0, 1.0], Entry::no_round_trip)
            .case("0, 1e-30", &[0.0, 1e-30])
            .case("0, 1e36", &[0.0, 1e36])
            .seed(&[0.0, 1.0]).seed(&[100.0, 1.0]).seed(&[1.0e37, 1.0e36]).seed(&[0.0, 1.0e-38]).seed(&[1.0e30, 1.0e-30])
            .refuse(&[0.0, INF], NotFinite(1)).refuse(&[0.0, 0.0], NotPositive(1)).refuse(&[0.0, -1.0], NotPositive(1))
            .refuse(&[0.0, 1.0e37], TooLarge(1)).refuse(&[0.0, TINY], Empty(1))
            .constant(in_both!(Gumbel<T>::new(0.3, 1.7)))
            .gives_back(|p| Gumbel::<T>::new(p[0], p[1]).map(|warp| vec![warp.location(), warp.scale()])),
        Registered::new("Rayleigh", "", &[Positive], |p| {
            Ok(from_zero(in_ulp::<T, _>("Rayleigh", Rayleigh::<T>::new(p[0])?, exact!(rayleigh(p[0])))).own_density().deep())
        })
            .case_with("1", &[1.0], |e| e.picture("p = x exp(−x²/2)", View::Line(between(-0.3, 5.0))))
            .control("a Rayleigh number without its factor of 2", |[u, ..], _| [(-(-u).ln_1p()).sqrt(), 0.0, 0.0], &["chi-square", "distance", "mean x"])
            .moment(&[1.0], "x^8", |x, _| x.powi(8), 384.0, 5e-6).moment(&[1.0], "1/x", |x, _| 1.0 / x, (0.5 * PI).sqrt(), 2e-5)
            .without("peer", "rand_distr has none")
            .case("1e-30", &[1e-30])
            .case("4e37", &[4e37])
            .seed(&[1.0]).seed(&[3.0e-39]).seed(&[4.8e37])
            .refuse(&[NAN], NotFinite(0)).refuse(&[0.0], NotPositive(0)).refuse(&[-1.0], NotPositive(0))
            .refuse(&[1.0e38], TooLarge(0)).refuse(&[TINY], Empty(0))
            .constant(in_both!(Rayleigh<T>::new(0.3)))
            .gives_back(|p| Rayleigh::<T>::new(p[0]).map(|warp| vec![warp.scale()])),
        Registered::new("Weibull", "", &[Positive, Positive], |p| {
            let entry = in_ulp::<T, _>("Weibull", Weibull::<T>::new(p[0], p[1])?, exact!(weibull(p[0], p[1])));
            Ok(from_zero(entry).middle().own_density_of_word().variables(&[("k", p[1].into())]))
        })
            .case_with("1, 1.5", &[1.0, 1.5], |e| e.picture("p ∝ √x exp(−x^1.5)", View::Line(between(-0.2, 3.5))))
            .control("a Weibull number of a shape slightly off", |[u, ..], wrong| [(-(-u).ln_1p()).powf((1.0 + wrong) / 1.5), 0.0, 0.0], &["chi-square", "distance"])
            .moment(&[2.0, 0.5], "(x/2)^2", |x, _| (0.5 * x).powi(2), 24.0, 5e-6)
            .peer("Weibull", &[1.0, 1.5], "Weibull", || peers::block(rand_distr::Weibull::new(1.0, 1.5)))
            .case("1, 1", &[1.0, 1.0])
            .case("1000, 0.5", &[1000.0, 0.5])
            .case("1, 0.2", &[1.0, 0.2])
            // Of every 300 samples one is too small for `f32`.
            .case_with("1e-20, 0.1", &[1e-20, 0.1], Entry::unresolved)
            .case("1e20, 10", &[1e20, 10.0])
            .case("3, 100", &[3.0, 100.0])
            .case_with("1, 1e6", &[1.0, 1e6], Entry::unresolved)
            .seed(&[1.0, 1.0]).seed(&[1.0, 0.036]).seed(&[1.0e-38, 0.02]).seed(&[1.0, 1.0e30]).seed(&[3.0e38, 200.0])
            .seed(&[2.0, 1.0e7]).seed(&[1.0e-30, 1.0e5]).seed(&[1.0, 1.0e-1])
            .refuse(&[NAN, 1.0], NotFinite(0)).refuse(&[1.0, INF], NotFinite(1)).refuse(&[0.0, 1.0], NotPositive(0))
            .refuse(&[1.0, 0.0], NotPositive(1)).refuse(&[1.0, 0.03], TooLarge(1)).refuse(&[1.0, TINY], TooLarge(1))
            .refuse(&[1e-30, 1e30], Empty(1))
            .constant(in_both!(Weibull<T>::new(0.3, 1.7)))
            .gives_back(|p| Weibull::<T>::new(p[0], p[1]).map(|warp| vec![warp.scale(), warp.shape()])),
        Registered::new("Pareto", "", &[Positive, Positive], |p| {
            let entry = in_ulp::<T, _>("Pareto", Pareto::<T>::new(p[0], p[1])?, exact!(pareto(p[0], p[1])));
            let mut entry = half_line(entry).middle().own_density_of_word();
            entry.open = false;
            Ok(entry.variables(&[("k", p[1].into())]))
        })
            .case_with("1, 2", &[1.0, 2.0], |e| e.picture("p = 2/x³ from 1", View::Line(between(0.5, 6.0))))
            .control("a Pareto number of a shape slightly off", |[u, ..], wrong| [(1.0 - u).powf(-0.5 * (1.0 + wrong)), 0.0, 0.0], &["chi-square", "distance"])
            .moment(&[1.0, 2.0], "x", |x, _| x, 2.0, 2e-5)
            .peer("Pareto", &[1.0, 2.5], "Pareto", || peers::block(rand_distr::Pareto::new(1.0, 2.5)))
            .case("1, 0.3", &[1.0, 0.3])
            .case("1e-30, 0.2", &[1e-30, 0.2])
            .case("1e20, 10", &[1e20, 10.0])
            .case("3, 100", &[3.0, 100.0])
            .case_with("1, 1e6", &[1.0, 1e6], Entry::unresolved)
            .seed(&[1.0, 1.0]).seed(&[1.0, 0.26]).seed(&[1.0e-38, 0.14]).seed(&[1.0, 1.0e30]).seed(&[3.0e38, 200.0])
            .seed(&[2.0, 1.0e7]).seed(&[1.0e-30, 1.0e5])
            .refuse(&[NAN, 1.0], NotFinite(0)).refuse(&[1.0, INF], NotFinite(1)).refuse(&[0.0, 1.0], NotPositive(0))
            .refuse(&[1.0, -1.0], NotPositive(1)).refuse(&[1.0, 0.25], TooLarge(1)).refuse(&[1.0, TINY], TooLarge(1))
            .refuse(&[1e-30, 1e30], Empty(1))
            .constant(in_both!(Pareto<T>::new(0.3, 1.7)))
            .gives_back(|p| Pareto::<T>::new(p[0], p[1]).map(|warp| vec![warp.minimum(), warp.shape()])),
        Registered::new("LogNormal", "", &[Any, Positive], |p| {
            let warp = LogNormal::<T>::new(p[0], p[1])?;
            let deviation = f64::from(p[1]);
            let entry = in_ulp::<T, _>("LogNormal", warp, exact!(log_normal(p[0], p[1]))).with(|e| {
                e.ends = Ends::None;
                e.inside = |x| x[0] > 0.0;
                e.deep = true;
            });
            Ok(entry.middle().own_density().variables(&[("d", deviation), ("w", 1.0 / deviation)]).outside(&[[0.0; 3], [-1.0, 0.0, 0.0]]))
        })
            .case_with("0, 0.5", &[0.0, 0.5], |e| e.picture("p ∝ exp(−2 ln²x)/x", View::Line(between(-0.1, 4.0))))
            .control("a log-normal number of a deviation slightly too large", |[u, v, _], wrong| [(0.5 * (1.0 + wrong) * normal(u, v)).exp(), 0.0, 0.0], &["chi-square", "distance"])
            .moment(&[0.0, 1.0], "x^2", |x, _| x.powi(2), 2f64.exp(), 1e-5)
            .peer("log-normal", &[0.0, 0.5], "LogNormal", || peers::block(rand_distr::LogNormal::new(0.0, 0.5)))
            .case("0, 1", &[0.0, 1.0])
            .case("-40, 10", &[-40.0, 10.0])
            .case("80, 1", &[80.0, 1.0])
            .case_with("5, 1e-4", &[5.0, 1e-4], Entry::unresolved)
            .seed(&[0.0, 1.0]).seed(&[-87.0, 25.0]).seed(&[88.0, 0.05]).seed(&[0.0, 1.0e-5]).seed(&[-80.0, 1.0e-3])
            .refuse(&[NAN, 1.0], NotFinite(0)).refuse(&[0.0, INF], NotFinite(1)).refuse(&[0.0, 0.0], NotPositive(1))
            .refuse(&[0.0, -1.0], NotPositive(1)).refuse(&[0.0, 14.0], TooLarge(1)).refuse(&[-100.0, 1.0], Empty(1))
            .refuse(&[0.0, TINY], Empty(1))
            .constant(in_both!(LogNormal<T>::new(0.3, 1.7)))
            .gives_back(|p| LogNormal::<T>::new(p[0], p[1]).map(|warp| vec![warp.mean_of_log(), warp.std_dev_of_log()])),
    ]
}

/// An exponential number below 3.
fn cut(u: f64, rate: f64) -> f64 {
    -(u * (-3.0 * rate).exp_m1()).ln_1p() / rate
}

/// A normal number between -11 and -10, through probabilities in `f32`.
fn cancelled([u, ..]: [f64; 3], _: f64) -> [f64; 3] {
    let below = [-11.0, -10.0].map(|t| (1.0 - truth::normal_cdf(-t)) as f32);
    let p = f64::from(below[0] + u as f32 * (below[1] - below[0]));
    let point = truth::normal_quantile_lower(p.max(1e-45));
    [point.clamp(-11.0, -10.0), 0.0, 0.0]
}

/// What laws of a location and a scale have in common: no end, and digits of the location or of the distance from it.
fn located<T: Tier, W>(name: &'static str, p: &[f32], warp: W, truth: Arc<dyn Truth>) -> Entry
where
    W: Invert<Uniforms = f32, Point = f32, Density = f32> + Send + Sync + 'static,
{
    let (location, scale) = (f64::from(p[0]), f64::from(p[1]));
    let mut entry = entry::<T, _>(
        name,
        Domain::Line,
        Measure::UlpFrom(location, 0.0),
        warp,
        truth,
    );
    entry.ends = Ends::None;
    entry.open = false;
    entry
        .variables(&[("w", location.abs() / scale)])
        .outside(&[])
}

/// Many pairs of uniforms share their point.
fn student_t<T: Tier>(p: &[f32]) -> Result<Entry, Error> {
    let [degrees, location, scale] = [p[0], p[1], p[2]];
    let warp = StudentT::<T>::new(degrees, location, scale)?;
    let mut entry = entry::<T, _>(
        "StudentT",
        Domain::Line,
        Measure::UlpFrom(location.into(), 0.0),
        warp,
        exact!(student_t(degrees, location, scale)),
    );
    entry.ends = Ends::None;
    entry.open = false;
    entry.folds = true;
    entry.round_trip = false;
    let far = f64::from(location).abs() / f64::from(scale);
    Ok(entry
        .deep()
        .chart(truth::student_t_line(degrees, location, scale))
        .variables(&[("w", far)])
        .outside(&[]))
}

/// An interval of a normal law, of which one end may be infinite; the errors count from the point nearest to the mean.
fn truncated_normal<T: Tier>(
    name: &'static str,
    p: &[f32],
    [low, high]: [f32; 2],
    warp: Result<TruncatedNormal<T>, Error>,
) -> Result<Entry, Error> {
    let warp = warp?;
    let [mean, deviation, a, b] = [p[0], p[1], low, high].map(f64::from);
    let nearest = mean.clamp(a, b);
    let least = if nearest > a && nearest < b {
        deviation.min((b - mean).max(mean - a))
    } else {
        0.0
    };
    let away = (nearest - mean).abs() / deviation;
    let open = truth::TruncatedNormal::new(p[0], p[1], low, high).beyond_low() < f64::from(TINY);
    let truth = exact!(TruncatedNormal::new(p[0], p[1], low, high));
    let measure = Measure::UlpFrom(nearest, least);
    let mut entry = entry::<T, _>(name, Domain::Line, measure, warp, truth);
    entry.open = open;
    entry.deep = true;
    if a.is_infinite() || b.is_infinite() {
        entry.ends = Ends::None;
    }
    let steep = nearest.abs() * (1.0 + away) / deviation;
    Ok(entry
        .middle()
        .own_density()
        .variables(&[("w", steep)])
        .outside(&[]))
}

/// An interval of a logistic law; the errors count from the location in a wide one, else from the end nearer to it.
fn truncated_logistic<T: Tier>(p: &[f32], warp: TruncatedLogistic<T>) -> Result<Entry, Error> {
    let [location, scale, low, high] = [p[0], p[1], p[2], p[3]].map(f64::from);
    let about = low < location && location < high && (p[3] - p[2]) / p[1] >= 4.0;
    let (from, least) = if about {
        (location, scale)
    } else if p[3] - p[0] < p[0] - p[2] {
        (high, 0.0)
    } else {
        (low, 0.0)
    };
    let cut = truth::TruncatedLogistic::new(p[0], p[1], p[2], p[3]).is_cut();
    let measure = Measure::UlpFrom(from, least);
    let truth = exact!(TruncatedLogistic::new(p[0], p[1], p[2], p[3]));
    let mut entry = entry::<T, _>("TruncatedLogistic", Domain::Line, measure, warp, truth);
    entry.open = false;
    if cut {
        entry.ends = Ends::None;
    }
    Ok(entry
        .middle()
        .own_density_of_word()
        .variables(&[("w", from.abs() / scale)])
        .outside(&[[f32::MAX, 0.0, 0.0], [-f32::MAX, 0.0, 0.0]]))
}

/// What laws from some number up have in common. The ends are not bounds of a domain but the last sample.
fn half_line(mut entry: Entry) -> Entry {
    entry.ends = Ends::Samples;
    entry.outside(&[[-1e-45, 0.0, 0.0]])
}

/// The same from 0 up, where u = 0 counts as 2^-149.
fn from_zero(mut entry: Entry) -> Entry {
    entry.open = true;
    half_line(entry)
}

fn interval<T: Tier>(
    name: &'static str,
    p: &[f32],
    warp: Result<Interval, Error>,
    increasing: bool,
) -> Result<Entry, Error> {
    let scale = Measure::UlpOf(p[0].abs().max(p[1].abs()).into());
    let truth = exact!(interval(p[0], p[1], increasing));
    let entry = entry::<T, _>(name, Domain::Line, scale, warp?, truth);
    Ok(entry.outside(&[[f32::MAX, 0.0, 0.0], [-f32::MAX, 0.0, 0.0]]))
}
