//! Normals of GGX that a viewer sees, written over any kind of number: how much all roundings make together, to the first order, at a
//! place. It is no proof for all views and roughnesses, but says what a bound may not be below.

use crate::kept::cases;
use crate::maps::mirrored;
use crate::number::Number;
use crate::programs::{DRAWS, between, uniform};
use crate::range::Range;
use crate::rounding::UNIT;
use crate::search::spread;
use crate::spread::{Spread, Vector, length, times};
use crate::tape::Tape;
use host::docs::{self, Statement};
use host::errors::raise;
use host::figures::{Exact, Figures, sample_error};
use host::registry::{Registered, registered};
use host::speed;
use microwarp::Warp;
use microwarp::tier::{Libm, Poly, Tier};
use microwarp::warp::GgxVisible;
use std::f64::consts::{FRAC_PI_2, TAU};
use std::sync::LazyLock;

/// What a constructor keeps: the azimuth of the view, its sine and cosine, 1 - cos, the height of the cap, and what it lacks.
struct Fields<N>([N; 7]);

fn fields<N: Number>([x, y, z]: [N; 3], [ax, ay]: [N; 2], bounded: bool) -> Fields<N> {
    let (one, zero) = (z.like(1.0), z.like(0.0));
    let (stretched_x, stretched_y) = (ax * x, ay * y);
    let flat = (stretched_x * stretched_x + stretched_y * stretched_y).sqrt();
    let squeezed = (flat * flat + z * z).sqrt();
    let (sin, cos) = (flat / squeezed, z / squeezed);
    let down = sin * (flat / (squeezed + z));
    let short = if bounded {
        let length = (x * x + y * y + z * z).sqrt();
        let [x, y, z] = [x, y, z].map(|c| c / length);
        let narrow = if ax.below(ay) { ax } else { ay };
        let (s, a2) = (one + (x * x + y * y).sqrt(), narrow * narrow);
        a2 * (s * s + z * z) / (s * s + a2 * z * z) * cos
    } else {
        zero
    };
    let height = (one + cos) - short;
    let [x, y] = [stretched_x / flat, stretched_y / flat];
    Fields([x, y, sin, cos, down, height, short])
}

/// The sum of the view and a point of the cap, of a uniform, what it leaves of 1, and cosine and sine of the other's azimuth.
fn half<N: Number>(of: &Fields<N>, [u, v]: [N; 2], [c, s]: [N; 2]) -> [N; 3] {
    let Fields([x, y, view_sin, cos, down, height, short]) = *of;
    let off = u * height;
    let k = v * height + short;
    let sin = (off * (k + down)).sqrt();
    let along = if c.below(c.like(0.0)) {
        let lower = if cos.below(c.like(0.5)) {
            k - c.like(2.0) * cos
        } else {
            down - off
        };
        k * lower / (view_sin + sin) + sin * (s * s / (c.like(1.0) - c))
    } else {
        view_sin + sin * c
    };
    let side = sin * s;
    [along * x - side * y, along * y + side * x, k]
}

/// The unit vector along a sum that is squeezed.
fn squeezed<N: Number>([ax, ay]: [N; 2], [x, y, z]: [N; 3]) -> [N; 3] {
    let (x, y) = (ax * x, ay * y);
    let length = (x * x + y * y + z * z).sqrt();
    [x, y, z].map(|c| c / length)
}

/// A view, two roughnesses, a uniform and an azimuth in turns.
#[derive(Clone, Copy, Debug)]
struct Place {
    view: [f32; 3],
    alpha: [f32; 2],
    u: [f32; 2],
    bounded: bool,
}

/// How far all roundings together lead to the first order, with sine and cosine that are off by so much; in a control without what
/// the sum of the view and a point of the cap rounds.
fn sum(of: &Place, off: [f64; 2], control: bool) -> f64 {
    let tape = Tape::default();
    let number = |x: f64| tape.input(Range::only(x));
    let [view, alpha] =
        [&of.view[..], &of.alpha].map(|x| x.iter().map(|&x| number(x.into())).collect::<Vec<_>>());
    let (view, alpha) = ([view[0], view[1], view[2]], [alpha[0], alpha[1]]);
    let kept = fields(view, alpha, of.bounded);
    let u = number(of.u[0].into());
    let (sin, cos) = (TAU * f64::from(of.u[1])).sin_cos();
    let azimuth = [cos, sin].map(number);
    let make = || half(&kept, [u, u.like(1.0) - u], azimuth);
    let made = if control { tape.exactly(make) } else { make() };
    let made = squeezed(alpha, made);
    let (derivatives, mut all) = (Spread::of(&tape, made), Vec::<Vector>::new());
    derivatives.rounded(&tape, &mut all);
    for (x, off) in azimuth.into_iter().zip(off) {
        let [by, _] = derivatives.by(x);
        all.push(times(by, Range::both(off)));
    }
    length(&all)
}

/// The sum at a place, where sine and cosine are off by what most are at most, and what is stated there.
fn beside_stated(of: &Place) -> [f64; 2] {
    let (sin, cos) = (TAU * f64::from(of.u[1])).sin_cos();
    let off = [cos, sin].map(|x| UNIT * if x.abs() < 0.5 { 1.4 * x.abs() } else { 0.7 });
    [sum(of, off, false), stated(of.alpha)]
}

/// What is stated of a sample.
static STATED: LazyLock<Statement> = LazyLock::new(|| {
    let mut rows = docs::of_floats("GgxVisible").into_iter();
    let (_, [bound, _]) = rows
        .find(|(title, _)| title.starts_with("sample"))
        .expect("a row");
    bound
});

fn stated([ax, ay]: [f32; 2]) -> f64 {
    STATED.eval(&[f64::from(ax / ay).max((ay / ax).into())])
}

/// Places of all kinds whose squares do not underflow, of which views are from above or nearly so every other time.
fn place(i: u32) -> Place {
    let any = |j: u32| f64::from(uniform(spread(8 * i + j)));
    let psi = if i % 2 == 0 {
        (FRAC_PI_2 * any(0)).max(1e-5)
    } else {
        f64::from(between(spread(i), 1e-5, 1.0))
    };
    let (s, c) = (TAU * any(1).max(1e-9)).sin_cos();
    let view = [psi.sin() * c, psi.sin() * s, psi.cos()].map(|x| x as f32);
    let alpha = [2, 3].map(|j| between(spread(8 * i + j), 1e-4, 1.0));
    let leave = |x: f32| if i % 3 == 0 { x } else { 1.0 - x };
    let u = [
        leave(between(spread(8 * i + 4), 1e-7, 0.5)),
        any(5).max(1e-9) as f32,
    ];
    Place {
        view,
        alpha,
        u,
        bounded: i % 5 == 0,
    }
}

fn normals_are_made_so<T: Tier>(all: &[Registered]) {
    let mut noticed = 0;
    let of = |by| {
        let mut all = all.iter().filter(|of| of.name == "GgxVisible");
        all.find(|of| of.constructor == by && of.tier == T::NAME)
            .expect("normals")
    };
    let truths = ["", "bounded"].map(of);
    for i in 0..*DRAWS {
        let of = place(i);
        let Place {
            view,
            alpha,
            u,
            bounded,
        } = of;
        let warp = if bounded {
            GgxVisible::<T>::bounded(view, alpha)
        } else {
            GgxVisible::new(view, alpha)
        };
        let (x, (s, c)) = (warp.expect("a view").sample(u), mirrored::<T>(u[1]));
        let kept = fields(view, alpha, bounded);
        let made = |kept| squeezed(alpha, half(kept, [u[0], 1.0 - u[0]], [c, s]));
        assert_eq!(made(&kept), x, "{} {of:?}", T::NAME);
        let mut wrong = Fields(kept.0);
        wrong.0[5] = f32::from_bits(wrong.0[5].to_bits() + 1);
        noticed += u32::from(made(&wrong) != x);

        let ([p, q, r], [ax, ay]) = (view.map(f64::from), alpha.map(f64::from));
        let exact = u.map(f64::from);
        let (s, c) = (TAU * exact[1]).sin_cos();
        let kept = fields([p, q, r], [ax, ay], bounded);
        let made = squeezed([ax, ay], half(&kept, [exact[0], 1.0 - exact[0]], [c, s]));
        let parameters = [&view[..], &alpha].concat();
        let entry = (truths[usize::from(bounded)].build)(&parameters).expect("a view");
        let due = entry.truth.sample([exact[0], exact[1], 0.0, 0.0]);
        assert!(
            (0..3).all(|i| (made[i] - due[i]).abs() <= 1e-9),
            "{of:?}: {made:?} {due:?}"
        );
    }
    assert!(
        noticed > *DRAWS / 8,
        "{noticed} bits differ where the height is an ulp more"
    );
}

#[test]
fn normals_that_are_seen_are_a_sum_in_the_hemisphere() {
    let all = registered();
    normals_are_made_so::<Libm>(&all);
    normals_are_made_so::<Poly>(&all);
}

/// At the kept cases the sum is more than what is found, and less than what is stated; and so it is wherever it is tried.
#[test]
fn all_roundings_of_normals_that_are_seen_are_below_what_is_stated() {
    let (mut worst, mut left_out) = (0.0, 0.0);
    let all = registered();
    for of in all.iter().filter(|of| of.name == "GgxVisible") {
        let sincos = if of.tier == "libm" {
            mirrored::<Libm>
        } else {
            mirrored::<Poly>
        };
        for (p, u) in cases(of) {
            let entry = of.of_drawn(&p).expect("a view");
            let mut figures = Figures::default();
            sample_error(
                &entry,
                &Exact::of(&entry, u, false),
                entry.warp.sample(u),
                &mut figures,
            );
            let place = Place {
                view: [p[0], p[1], p[2]],
                alpha: [p[3], p[4]],
                u: [u[0], u[1]],
                bounded: of.constructor == "bounded",
            };
            // A view so short or so near to the normal that its squares underflow here has a scale of its own in the crate.
            let [x, y, z] = place.view;
            let side = x.abs().max(y.abs());
            if side < 1e-12 * z || side < 1e-18 {
                continue;
            }
            let ((s, c), (sin, cos)) = (sincos(u[1]), (TAU * f64::from(u[1])).sin_cos());
            let off = [f64::from(c) - cos, f64::from(s) - sin].map(|x| x.abs() + 1e-15);
            let (found, sum_here, stated) =
                (figures.sample, sum(&place, off, false), stated(place.alpha));
            assert!(
                found <= sum_here * (1.0 + 1e-5) && sum_here <= stated,
                "{place:?}: {found:e} {sum_here:e} {stated:e}"
            );
            if raise(&mut worst, found / stated) {
                left_out = found / sum(&place, off, true);
            }
        }
    }
    // Without what is rounded between constructor and squeezed sum it would not hold.
    assert!(left_out > 1.0, "{left_out}");
    let mut most = 0.0;
    for i in 0..speed::of("places of normals that are seen", 1 << 9, 1 << 16) {
        let of = place(i);
        let [sum, stated] = beside_stated(&of);
        assert!(sum <= stated, "{of:?} {sum:e} {stated:e}");
        raise(&mut most, sum / stated);
    }
    println!("sums of all roundings: up to {most:.3} of what is stated");
    assert!(most > 0.5, "{most}");
}
