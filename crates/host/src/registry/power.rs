//! The power laws, and the largest of several uniforms.

use super::line::in_ulp;
use super::picture::{View, between};
use super::{Entry, Flat, Registered, in_both};
use crate::adversary::words::Kind::{self, Any, Positive, Within};
use crate::truth::exact;
use microwarp::Error::{self, *};
use microwarp::tier::Tier;
use microwarp::warp::{Power, PowerMax};

const NAN: f32 = f32::NAN;
const INF: f32 = f32::INFINITY;

const TINY: f32 = 1.0e-45;

/// Exponent and range under which every law runs, and whether `f32` resolves the distribution.
#[rustfmt::skip]
const CASES: [(&str, [f32; 3], bool); 27] = [
    ("n=0 [1, 3]", [0.0, 1.0, 3.0], true),
    ("n=1 [0, 2]", [1.0, 0.0, 2.0], true),
    ("n=2.5 [0, 1]", [2.5, 0.0, 1.0], true),
    ("n=-0.5 [0, 4]", [-0.5, 0.0, 4.0], true),
    ("n=-1 [1, 100]", [-1.0, 1.0, 100.0], true),
    ("n=-0.9999999 [1, 100]", [-0.999_999_9, 1.0, 100.0], true),
    ("n=-1.000001 [1, 100]", [-1.000_001, 1.0, 100.0], true),
    ("n=-2.5 [1, 1e20]", [-2.5, 1.0, 1e20], true),
    ("n=-0.99 [1e-10, 1e10]", [-0.99, 1e-10, 1e10], true),
    ("n=-0.95 [1e-10, 1e10]", [-0.95, 1e-10, 1e10], true),
    ("n=1 [1e20, 1e21]", [1.0, 1e20, 1e21], true),
    ("n=2 [1e-30, 1e-29]", [2.0, 1e-30, 1e-29], true),
    ("n=-1 [1e-37, 1e37]", [-1.0, 1e-37, 1e37], true),
    ("n=1000 [1, 2]", [1000.0, 1.0, 2.0], true),
    ("n=-1000 [1, 2]", [-1000.0, 1.0, 2.0], true),
    ("n=1e8 [1, 2]", [1e8, 1.0, 2.0], false),
    ("n=3 [1, 1.0001]", [3.0, 1.0, 1.0001], false),
    ("n=-0.7427 [3.5e-3, 2.5e13]", [-0.742_730_2, 3.537_985e-3, 2.506_938_2e13], true),
    ("n=-0.9 [0, 1e30]", [-0.9, 0.0, 1e30], true),
    ("n=1e6 [1, 3]", [1e6, 1.0, 3.0], false),
    ("n=1e8 [1, 3]", [1e8, 1.0, 3.0], false),
    ("n=-1.005 [1e-37, 1e38]", [-1.005, 1e-37, 1e38], true),
    ("n=-1.007 [1e-30, 1e30]", [-1.007, 1e-30, 1e30], true),
    ("n=-3 [1e-20, 1e20]", [-3.0, 1e-20, 1e20], true),
    ("n=-0.748 [127, 7.3e6]", [-0.748, 127.0, 7.3e6], true),
    ("n=-1 [1e-40, 1]", [-1.0, 1e-40, 1.0], true),
    ("n=-0.9974 [1.6e-38, 4e28]", [-0.997_436_5, 1.595_427_9e-38, 4.033_297e28], true),
];

/// What the bounds of a power law depend on.
pub fn variables(p: &[f32]) -> [(&'static str, f64); 2] {
    let [n, a, b] = [p[0], p[1], p[2]].map(f64::from);
    [("k", (n + 1.0).abs()), ("d", (b / a).log2())]
}

fn power<T: Tier>(p: &[f32], increasing: bool) -> Result<Entry, Error> {
    let (name, warp) = if increasing {
        ("Power", Power::<T>::new(p[0], p[1], p[2])?)
    } else {
        (
            "Power decreasing",
            Power::<T>::decreasing(p[0], p[1], p[2])?,
        )
    };
    let entry = in_ulp::<T, _>(name, warp, exact!(power(p[0], p[1], p[2], increasing)));
    let entry = entry.own_density_of_word().variables(&variables(p));
    Ok(entry.outside(&[[-1.0, 0.0, 0.0], [f32::MAX, 0.0, 0.0]]))
}

/// All cases, those with a picture or a place in comparisons included.
fn with_cases(mut of: Registered, particular: fn(&str) -> fn(Entry) -> Entry) -> Registered {
    for (label, parameters, resolved) in CASES {
        let change = if resolved {
            particular(label)
        } else {
            Entry::unresolved
        };
        of = of.case_with(label, &parameters, change);
        if label == "n=2.5 [0, 1]" {
            of = of.control(
                "a power of an exponent slightly off",
                |[u, ..], wrong| [u.powf((1.0 + wrong) / 3.5), 0.0, 0.0],
                &["chi-square", "distance", "mean x"],
            );
        }
    }
    of
}

/// Moments of -(n + 1) ln(x/b), which is an exponential number, for exponents and upper ends.
fn with_moments(mut of: Registered) -> Registered {
    for (n, b) in [(2.5, 1.0), (1.0, 2.0), (99.0, 3.0), (-0.5, 4.0)] {
        let y = move |x: f64| -(f64::from(n) + 1.0) * (x / f64::from(b)).ln();
        of = of
            .moment(&[n, 0.0, b], "y^4", move |x, _| y(x).powi(4), 24.0, 5e-6)
            .moment(
                &[n, 0.0, b],
                "y^8",
                move |x, _| y(x).powi(8),
                40_320.0,
                2e-4,
            );
    }
    of
}

fn largest<T: Tier, const N: usize>(_: &[f32]) -> Result<Entry, Error>
where
    [f32; N]: Flat<4>,
{
    let n = u32::try_from(N).expect("a small number");
    let mut entry = in_ulp::<T, _>("PowerMax", PowerMax::<N>::new(), exact!(power_max(n)));
    // Many sets of uniforms share their largest.
    entry.folds = N > 1;
    entry.round_trip = N == 1;
    if N > 1 {
        entry = entry.chart(exact!(power(N as f32 - 1.0, 0.0, 1.0, true)));
    }
    entry.composed = true;
    Ok(entry.outside(&[[-1e-7, 0.0, 0.0], [1.000_000_1, 0.0, 0.0]]))
}

#[rustfmt::skip] // one line a case
pub(super) fn registered<T: Tier>() -> Vec<Registered> {
    const NEAR: Kind = Within(-1.02, -0.98);
    vec![
        with_cases(with_moments(Registered::new("Power", "new", &[Any, Positive, Positive], |p| power::<T>(p, true)))
            // An end that is open, and one that is closed and next to one that is open.
            .width(&[1.0, 0.0, 2.0], 2.0, 2e-5).width(&[3.0, 1e-10, 1.0], 1.0, 5e-3)
            .constant(in_both!(Power<T>::new(2.5, 0.0, 0.7)))
            .constant(in_both!(Power<T>::new(-1.0, 0.1, 0.7)))
            .constant(in_both!(Power<T>::new(-0.9999, 1e-30, 1e30)))
            .constant(in_both!(Power<T>::new(-0.3, 0.0, 7.0)))
            .constant(in_both!(Power<T>::decreasing(-2.7, 0.1, 1e20)))
            .constant(in_both!(Power<T>::decreasing(1e8, 1.0, 1.000_001)))
            .without("getters", "it keeps a smallest number in place of an end of 0")
            .without("peer", "rand_distr has none"), |label| match label {
            "n=2.5 [0, 1]" => |e| e.picture("p ∝ x^2.5 on [0, 1]", View::Line(between(-0.1, 1.1))),
            "n=-1 [1, 100]" => |e| {
                let axes = between(0.794_328, 125.892_54).log_x().log_y(1e-3);
                e.picture("p ∝ 1/x on [1, 100]", View::Line(axes))
            },
            _ => |e| e,
        })
            .seed(&[3.0e38, 0.0, 1.0]).seed(&[-3.0e38, 1.0, 2.0]).seed(&[-1.0, 1.0e-36, f32::MAX])
            .seed(&[-0.999_999_94, 0.0, 1.0]).seed(&[0.5, 0.0, f32::MAX]).seed(&[7.0, 1.0, 1.000_000_1])
            .refuse(&[NAN, 0.0, 1.0], NotFinite(0)).refuse(&[1.0, 0.0, INF], NotFinite(2)).refuse(&[1.0, -1.0, 1.0], Negative(1))
            .refuse(&[1.0, 2.0, 1.0], Reversed(2)).refuse(&[1.0, 1.0, 1.0], Empty(2)).refuse(&[1.0, 0.0, TINY], Empty(Error::NO_PLACE))
            .refuse(&[-1.0, TINY, 1.0], Empty(Error::NO_PLACE)).refuse(&[-1.0, 0.0, 1.0], NotNormalizable(1))
            .refuse(&[-3.0, 0.0, 1.0], NotNormalizable(1)),
        with_cases(with_moments(Registered::new("Power", "decreasing", &[Any, Positive, Positive], |p| power::<T>(p, false))), |label| match label {
            "n=-0.5 [0, 4]" => |e| e.picture("p ∝ 1/√x on [0, 4], 4 first", View::Line(between(-0.3, 4.3).top(1.7))),
            _ => |e| e,
        })
            .refuse(&[-1.0, 0.0, 1.0], NotNormalizable(1)),
        Registered::new("Power", "near n=-1", &[NEAR, Positive, Positive], |p| power::<T>(p, true)),
        Registered::new("Power", "from 0", &[Any, Positive], |p| power::<T>(&[p[0], 0.0, p[1]], true)).parameters(&[0, 2]),
        Registered::new("PowerMax", "N=1", &[], largest::<T, 1>).case("N=1", &[]),
        Registered::new("PowerMax", "N=2", &[], largest::<T, 2>).case("N=2", &[]),
        Registered::new("PowerMax", "N=3", &[], largest::<T, 3>),
        Registered::new("PowerMax", "N=4", &[], largest::<T, 4>).case_with("N=4", &[], |e| {
            e.picture("largest of 4 uniforms: p = 4x³", View::Line(between(-0.1, 1.1)))
        })
            .control("the largest of two uniforms for that of four", |[u, v, _], _| [u.max(v), 0.0, 0.0], &["chi-square", "distance", "mean x"]),
    ]
}
