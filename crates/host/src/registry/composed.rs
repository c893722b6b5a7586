//! What users compose, by examples: inversions, transforms, a marginal with its conditional, products, and mixtures.

use super::picture::{EQUILATERAL, View, between, window};
use super::plane::square;
use super::{Domain, Ends, Entry, Measure, Registered, entry};
use crate::adversary::words::Kind::Positive;
use crate::truth::{self, Truth, exact};
use microwarp::Error;
use microwarp::discrete::Mixture;
use microwarp::tier::Tier;
use microwarp::warp::*;
use microwarp_list::Mixed;

/// An example without parameters of its own.
fn example(
    name: &'static str,
    constructor: &'static str,
    label: &'static str,
    build: fn(&[f32]) -> Result<Entry, Error>,
    change: fn(Entry) -> Entry,
) -> Registered {
    Registered::new(name, constructor, &[], build).case_with(label, &[], change)
}

/// Marks a map whose functions are the example's own.
fn own(mut entry: Entry) -> Entry {
    entry.composed = true;
    entry.closures = true;
    if entry.name == "Transform" {
        entry.own_density = true;
        entry.ends = Ends::Samples;
    }
    entry
}

pub(super) fn registered<T: Tier>() -> Vec<Registered> {
    vec![
        Registered::new("Composed", "", &[Positive; 4], |p| {
            let then = Triangle::new();
            let truth = exact!(Composed(
                Bilinear(square(p).map(|row| row.map(Real::from))),
                Barycentric
            ));
            let warp = Composed::new(Bilinear::new(square(p))?, then);
            let unit = Measure::Length(1.0);
            let mut entry = entry::<T, _>("Composed", Domain::Barycentric, unit, warp, truth);
            (entry.composed, entry.open) = (true, false);
            Ok(entry
                .own_density()
                .outside(&[[0.5, 0.6, 0.1], [-0.1, 0.6, 0.5]]))
        })
        .parameters(&[0; 4])
        .case_with("4 4 / 1 0", &[4.0, 4.0, 1.0, 0.0], |e| {
            e.picture("a bilinear weight on a triangle", EQUILATERAL)
        })
        .control(
            "a triangle without its weights",
            |[u, v, _], _| [1.0 - u.sqrt(), u.sqrt() * (1.0 - v), u.sqrt() * v],
            &["chi-square", "distance", "mean x"],
        )
        .case("1 2 / 3 4", &[1.0, 2.0, 3.0, 4.0])
        .seed(&[1.0; 4])
        .seed(&[4.0, 4.0, 1.0, 0.0])
        .seed(&[0.0, 1.0, 1.0, 2.0])
        .refuse(&[0.0; 4], Error::NotPositive(0)),
        example(
            "Inversion",
            "",
            "p=1/2+x",
            |_| Ok(own(inversion::<T>().outside(&[]))),
            |e| {
                e.picture(
                    "a user's inverse CDF: p = ½ + x",
                    View::Line(between(-0.1, 1.1)),
                )
            },
        )
        .control(
            "a uniform that is not inverted",
            |[u, ..], _| [u, 0.0, 0.0],
            &["chi-square", "distance", "mean x"],
        ),
        example(
            "Transform",
            "sine",
            "y=sin x",
            |_| Ok(own(sine::<T>().outside(&[]))),
            |e| e.picture("y = sin x, with p(x) = 2x", View::Line(between(-0.1, 1.0))),
        )
        .control(
            "the sine of a plain uniform",
            |[u, ..], _| [u.sin(), 0.0, 0.0],
            &["chi-square", "distance", "mean x"],
        ),
        example(
            "Transform",
            "logarithm",
            "y=2 ln x - ln 2",
            |_| Ok(own(logarithm::<T>().outside(&[]))),
            |e| e,
        ),
        example(
            "MarginalConditional",
            "",
            "0<y<x<1",
            |_| {
                let mut entry = below_diagonal::<T>().outside(&[[0.5, 0.6, 0.0], [1.5, 0.5, 0.0]]);
                entry.composed = true;
                Ok(entry.own_density())
            },
            |e| e.picture("p(x) = 2x, p(y | x) = 1/x", window(0.5, 0.5, 0.51)),
        )
        .control(
            "a marginal that is uniform",
            |[u, v, _], _| [u, u * v, 0.0],
            &["chi-square", "distance", "mean x"],
        ),
        example(
            "Product",
            "",
            "a cylinder",
            |_| Ok(cylinder::<T>().outside(&[[0.9, 0.9, 1.0], [0.1, 0.1, -0.1], [0.1, 0.1, 2.1]])),
            |e| e.picture("a cylinder from above", window(0.0, 0.0, 1.02)),
        )
        .control(
            "a disk with r = xi for its square root",
            |[u, v, w], _| {
                let [x, y, _] = truth::DiskConcentric.sample([u, v, 0.0, 0.0]);
                let r = x.hypot(y);
                [x * r, y * r, 2.0 * w]
            },
            &["chi-square", "distance", "mean x²"],
        ),
        example(
            "Each",
            "",
            "two tents",
            |_| Ok(tents::<T>().outside(&[[1.1, 0.0, 0.0], [0.0, -1.1, 0.0]])),
            |e| e.picture("two tents", window(0.0, 0.0, 1.02)),
        )
        .control(
            "a box for the second tent",
            |[u, v, _], _| {
                let [x, ..] = truth::tent(1.0).sample([u; 4]);
                [x, 2.0 * v - 1.0, 0.0]
            },
            &["chi-square", "distance", "mean y²"],
        )
        .without("moment", "a draw takes two words")
        .without("peer", "rand_distr has none"),
        example(
            "Mixture",
            "",
            "three intervals",
            |_| Ok(intervals::<T>().outside(&[[-0.1, 0.0, 0.0], [1.5, 0.0, 0.0], [5.1, 0.0, 0.0]])),
            |e| {
                e.picture(
                    "three intervals, of weights 1, 4 and 3",
                    View::Line(between(-0.2, 5.2)),
                )
            },
        )
        .control(
            "parts by equal chances",
            |[u, ..], _| {
                let part = (3.0 * u).floor();
                [2.0 * part + (3.0 * u - part), 0.0, 0.0]
            },
            &["chi-square", "distance", "mean x"],
        )
        .without(
            "moment",
            "its draws are those of its parts, and tests/tables counts them",
        )
        .without("peer", "rand_distr has none"),
    ]
}

/// Uniform in a cylinder of radius 1 and height 2.
fn cylinder<T: Tier>() -> Entry {
    let mut entry = entry::<T, _>(
        "Product",
        Domain::Solid,
        Measure::Length(1.0),
        Product::new(DiskConcentric::<T>::new(), Interval::new(0.0, 2.0).unwrap()),
        exact!(Beside(
            Box::new(DiskConcentric),
            interval(0.0, 2.0, true),
            2,
        )),
    );
    entry.composed = true;
    entry
}

/// The tents of both axes of a pixel.
fn tents<T: Tier>() -> Entry {
    let mut entry = entry::<T, _>(
        "Each",
        Domain::Plane,
        Measure::Length(1.0),
        Each::new([Tent::new(1.0).unwrap(); 2]),
        exact!(Beside(tent(1.0), tent(1.0), 1)),
    );
    (entry.composed, entry.deep) = (true, true);
    entry.own_density()
}

/// Uniform in three intervals, one with an eighth, one with a half of the points.
fn intervals<T: Tier>() -> Entry {
    let parts = [0.0, 2.0, 4.0].map(|low| Interval::new(low, low + 1.0).unwrap());
    let mut entry = entry::<T, _>(
        "Mixture",
        Domain::Line,
        Measure::Ulp,
        Mixed(Mixture::new(parts, &[1.0, 4.0, 3.0]).unwrap()),
        exact!(Line {
            quantile: |u: Real| match 8.0 * u {
                u if u < 1.0 => u,
                u if u < 5.0 => 2.0 + (u - 1.0) / 4.0,
                u => 4.0 + (u - 5.0) / 3.0,
            },
            pdf: |x: Real| match x {
                x if x <= 1.0 => Real::from(0.125),
                x if x <= 3.0 => Real::from(0.5),
                _ => Real::from(0.375),
            },
            cdf: |x: Real| match x {
                x if x <= 1.0 => x / 8.0,
                x if x <= 3.0 => (1.0 + 4.0 * (x - 2.0).max(0.0)) / 8.0,
                x => (5.0 + 3.0 * (x - 4.0).max(0.0)) / 8.0,
            },
        }),
    );
    (entry.composed, entry.deep, entry.jumps) = (true, true, true);
    entry
}

/// p(x) = ½ + x on [0, 1].
fn inversion<T: Tier>() -> Entry {
    entry::<T, _>(
        "Inversion",
        Domain::Line,
        Measure::Ulp,
        Inversion::new(
            |u: f32| 4.0 * u / (1.0 + T::sqrt(1.0 + 8.0 * u)),
            |x: f32| 0.5 + x,
            |x: f32| 0.5 * x * (1.0 + x),
        ),
        exact!(Line {
            quantile: |u: Real| 4.0 * u / (1.0 + (1.0 + 8.0 * u).sqrt()),
            pdf: |x: Real| 0.5 + x,
            cdf: |x: Real| 0.5 * x * (1.0 + x),
        }),
    )
}

/// Y = sin X with p(x) = 2x on [0, 1]: p(y) = 2 asin(y)/√(1 − y²) on [0, sin 1].
fn sine<T: Tier>() -> Entry {
    let sine = |x: f32| T::sincos_turns(x * (1.0 / core::f32::consts::TAU)).0;
    let cosine = |x: f32| T::sincos_turns(x * (1.0 / core::f32::consts::TAU)).1;
    let arcsine =
        |y: f32| T::atan2_turns(y, T::sqrt((1.0 - y) * (1.0 + y))) * core::f32::consts::TAU;
    entry::<T, _>(
        "Transform",
        Domain::Line,
        Measure::Ulp,
        Transform::new(Linear::new(0.0, 1.0).unwrap(), sine, arcsine, cosine),
        exact!(Line {
            quantile: |u: Real| u.sqrt().sin(),
            pdf: |y: Real| 2.0 * y.asin() / (1.0 - y * y).sqrt(),
            cdf: |y: Real| y.asin().powi(2),
        }),
    )
}

/// p(x) = x on [√2, 2] becomes p(y) = e^y on [0, ln 2] under y = 2 ln x − ln 2.
fn logarithm<T: Tier>() -> Entry {
    entry::<T, _>(
        "Transform",
        Domain::Line,
        Measure::UlpOf(0.7),
        Transform::new(
            Power::<T>::new(1.0, core::f32::consts::SQRT_2, 2.0).unwrap(),
            |x: f32| 2.0 * T::ln(x) - core::f32::consts::LN_2,
            |y: f32| T::exp(0.5 * (y + core::f32::consts::LN_2)),
            |x: f32| 2.0 / x,
        ),
        exact!(Line {
            // Exact for the interval whose lower end is the f32 nearest to the root of 2.
            quantile: |u: Real| {
                let low = Real::from(core::f32::consts::SQRT_2).powi(2);
                ((1.0 - u) * low + u * 4.0).ln() - Real::from(core::f32::consts::LN_2)
            },
            pdf: |y: Real| {
                let low = Real::from(core::f32::consts::SQRT_2).powi(2);
                (y + Real::from(core::f32::consts::LN_2)).exp() / (4.0 - low)
            },
            cdf: |y: Real| {
                let low = Real::from(core::f32::consts::SQRT_2).powi(2);
                ((y + Real::from(core::f32::consts::LN_2)).exp() - low) / (4.0 - low)
            },
        }),
    )
}

/// Uniform below the diagonal: p(x) = 2x, p(y | x) = 1/x.
fn below_diagonal<T: Tier>() -> Entry {
    let conditional = |x: f32| Interval::new(0.0, x).unwrap_or(Interval::new(0.0, 1.0).unwrap());
    entry::<T, _>(
        "MarginalConditional",
        Domain::Plane,
        Measure::Length(1.0),
        MarginalConditional::new(Linear::new(0.0, 1.0).unwrap(), conditional),
        exact!(Product {
            marginal: linear(0.0, 1.0),
            conditional: |x: Real| {
                Box::new(Line {
                    quantile: move |u| u * x,
                    pdf: move |_| 1.0 / x,
                    cdf: move |y| y / x,
                }) as Box<dyn Truth>
            },
        }),
    )
}
