//! The power law over all of its parameters: what the exponential of one branch alone would over- or
//! underflow is right, nothing steps back, and a start is the start. The map that was there before, whose
//! clamp hid the overflow, fails here.

use host::errors::ulps;
use host::{speed, truth};
use microwarp::tier::{Libm, Poly, Tier};
use microwarp::warp::{Power, PowerMax};
use microwarp::{Invert, Warp, libm, poly as mw};
use rand_core::Rng;
use rand_pcg::Pcg32;

const STEP: f32 = 1.0 / 16_777_216.0;

/// What the documentation states of `libm`, in ulp, and of `poly`.
const STATED: f64 = 1.0;
fn stated([n, a, b]: [f32; 3]) -> f64 {
    let (k, d) = (
        (f64::from(n) + 1.0).abs(),
        (f64::from(b) / f64::from(a)).log2(),
    );
    3.2 + 4.2 * f64::min(1.0 / k, k * d * d)
}

/// Parameters at which a map of one `f32` overflows, or loses most digits.
const SETS: [[f32; 3]; 8] = [
    [-1.005, 1e-37, 1e38],
    [-1.007, 1e-30, 1e30],
    [-3.0, 1e-20, 1e20],
    [-0.748, 127.0, 7.3e6],
    [-0.95, 1e-10, 1e10],
    [-0.997_436_5, 1.595_427_9e-38, 4.033_297e28],
    [-0.999_999_94, 1.0, 3.0],
    [0.5, 1.0, 2.0],
];

/// The map as it was, whose exponential stood alone in one branch, before a clamp; the other branch, which
/// was right here, in f64.
fn clamped(n: f32, a: f32, b: f32, u: f32) -> f32 {
    let m = n + 1.0;
    let (anchor, near, away) = if m < 0.0 {
        (a, 1.0 - u, u)
    } else {
        (b, u, 1.0 - u)
    };
    let z = m.abs() * (Poly::ln(b) - Poly::ln(a));
    let mixed = near + away * Poly::exp(-z);
    let x = if mixed < 0.5 {
        (f64::from(anchor) * (f64::from(mixed).ln() / f64::from(m)).exp()) as f32
    } else {
        anchor * Poly::exp(Poly::ln_1p(away * Poly::exp_m1(-z)) / m)
    };
    if x >= b {
        b
    } else if x > a {
        x
    } else {
        a
    }
}

/// The worst error in ulp and the number of steps back over the grid.
fn walked([n, a, b]: [f32; 3], increasing: bool, map: impl Fn(f32) -> f32) -> (f64, u32) {
    let truth = truth::power(n, a, b, increasing);
    let (mut worst, mut back, mut last) = (0.0, 0, map(0.0));
    let blocks = speed::blocks("the grid of a power", 1 << 24, 16);
    for k in blocks.flatten() {
        let u = k as f32 * STEP;
        let x = map(u);
        back += u32::from(if increasing { x < last } else { x > last });
        last = x;
        if k % 64 == 1 {
            let [exact, ..] = truth.sample([f64::from(u), 0.0, 0.0, 0.0]);
            let error = ulps(x, exact);
            assert!(!error.is_nan());
            worst = f64::max(worst, error);
        }
    }
    (worst, back)
}

#[test]
fn power_laws_near_minus_one_over_many_decades_are_right_and_never_step_back() {
    for (k, set @ [n, a, b]) in SETS.into_iter().enumerate() {
        let (increasing, bound, (worst, back)) = if k % 2 == 0 {
            let up = Power::<Poly>::new(n, a, b).unwrap();
            (true, stated(set), walked(set, true, |u| up.sample(u)))
        } else {
            let down = Power::<Libm>::decreasing(n, a, b).unwrap();
            (false, STATED, walked(set, false, |u| down.sample(u)))
        };
        assert!(
            worst <= bound && back == 0,
            "{set:?} {increasing}: {worst} ulp, {back} steps back"
        );
    }
}

/// The map that was there fails in both ways.
#[test]
fn an_overflow_behind_a_clamp_is_noticed() {
    for set @ [n, a, b] in [SETS[0], SETS[1]] {
        let (worst, back) = walked(set, true, |u| clamped(n, a, b, u));
        assert!(
            worst > 1e6 && back > 0,
            "{set:?}: {worst} ulp, {back} steps back"
        );
    }
}

/// The issue's own cases, and what was refused although its density is finite.
#[test]
fn the_cases_that_were_found_are_mended() {
    let near = |x: f32, exact: f64| {
        assert!(
            (f64::from(x) - exact).abs() <= 1e-7 * exact,
            "{x} for {exact}"
        );
    };
    near(
        libm::Power::new(-1.005, 1e-37, 1e38).unwrap().sample(0.65),
        8_887.705_070_407_62,
    );
    near(
        libm::Power::new(-1.007, 1e-30, 1e30).unwrap().sample(0.8),
        3_099_580_141_218.55,
    );
    let falling = mw::Power::decreasing(-3.0, 1e-20, 1e20).unwrap();
    for start in [0.0, -1.0, f32::NAN] {
        assert!(falling.sample(start) == 1e20);
    }
    let flat = mw::Power::new(0.0, -0.0, 1.0).unwrap();
    assert!(flat.sample(0.0) == 0.0 && flat.invert(0.0) == 0.0 && flat.pdf(-0.0) == 1.0);
    let log = mw::Power::new(-1.0, 1e-40, 1.0).unwrap();
    let density = f64::from(log.pdf(1e-40));
    near(log.pdf(1.0), 1.0 / -f64::from(1e-40_f32).ln());
    assert!((density * f64::from(1e-40_f32) * -f64::from(1e-40_f32).ln() - 1.0).abs() <= 1e-6);
}

/// Any parameters at all, with the places where one branch takes over from another.
#[test]
fn no_power_law_steps_back_and_each_begins_at_its_start() {
    let mut rng = Pcg32::new(13, 2);
    let mut unit = move || f64::from(rng.next_u32()) / 4_294_967_296.0;
    let mut accepted = 0;
    while accepted < 10_000 {
        let near_one = (unit() - 0.5) * 10_f64.powf(-9.0 * unit());
        let n =
            [near_one - 1.0, 20.0 * (unit() - 0.5), 1e9 * near_one][(3.0 * unit()) as usize] as f32;
        let [x, y] = [(); 2].map(|()| 10_f64.powf(-44.0 + 82.0 * unit()));
        let y = if unit() < 0.3 { x * (1.0 + unit()) } else { y };
        let (a, b) = (x.min(y) as f32, x.max(y) as f32);
        let increasing = unit() < 0.5;
        let warp = if increasing {
            Power::<Poly>::new(n, a, b)
        } else {
            Power::<Poly>::decreasing(n, a, b)
        };
        let Ok(warp) = warp else { continue };
        accepted += 1;
        assert!(
            warp.sample(0.0) == if increasing { a } else { b },
            "{n} {a} {b}: {} at 0",
            warp.sample(0.0)
        );
        let truth = truth::power(n, a, b, increasing);
        // Where the power of two of x/R changes, where the logarithm does, and anywhere.
        let (anchor, side) = if n < -1.0 { (a, 1.0) } else { (b, -1.0) };
        let octave = 0.5 + (unit() * f64::from(b / a).log2()).floor().min(250.0);
        let places = [
            f64::from(anchor) * 2_f64.powf(side * octave),
            f64::from(anchor) * (0.71_f64.ln() / (f64::from(n) + 1.0)).exp(),
            f64::from(anchor) * 2_f64.powf(side * 0.5),
        ];
        let at = places.map(|x| truth.invert([x, 0.0, 0.0])[0]);
        for u in at.into_iter().chain([unit(), unit(), 0.0, 1.0]) {
            let middle = (u * 16_777_216.0).clamp(0.0, 16_777_207.0) as u32;
            for k in middle.max(8) - 8..middle + 8 {
                let [x, next] = [k, k + 1].map(|k| warp.sample(k as f32 * STEP));
                let back = if increasing { next < x } else { next > x };
                assert!(!back, "{n} {a} {b} {increasing} at {k}: {x:e}, {next:e}");
            }
        }
    }
}

/// The density of the largest of N, against plain powering as the control.
#[test]
fn the_density_of_the_largest_of_very_many_keeps_its_error() {
    const MANY: usize = 100_000;
    let (warp, truth) = (PowerMax::<MANY>::new(), truth::power_max(MANY as u32));
    let (mut worst, mut plain) = (0.0, 0.0);
    for k in 0..20_000 {
        let x = 1.0 - k as f32 * (0.25 * STEP);
        let exact = truth.pdf([f64::from(x), 0.0, 0.0]);
        let off = |density: f64| (density - exact).abs() / exact;
        worst = f64::max(worst, off(f64::from(warp.pdf(x))));
        let (mut power, mut square, mut left) = (1.0_f32, x, MANY - 1);
        while left > 0 {
            if left & 1 == 1 {
                power *= square;
            }
            square *= square;
            left >>= 1;
        }
        plain = f64::max(plain, off(f64::from(MANY as f32 * power)));
    }
    assert!(worst <= 1.4e-7, "{worst}");
    assert!(plain > 1e-4, "{plain}");
}

/// Moderate laws, whose rounding is all there is: the height of the density is rounded once.
#[test]
fn densities_at_both_ends_keep_their_error() {
    let mut rng = Pcg32::new(3, 4);
    let mut unit = move || f64::from(rng.next_u32()) / 4_294_967_296.0;
    for _ in 0..50_000 {
        let (n, a) = ((10.0 * unit()) as f32, (0.1 + unit()) as f32);
        let b = (f64::from(a) * (1.5 + 4.0 * unit())) as f32;
        let (law, m) = (mw::Power::new(n, a, b).unwrap(), f64::from(n) + 1.0);
        let span = f64::from(b).powf(m) - f64::from(a).powf(m);
        for x in [a, b] {
            let exact = m * f64::from(x).powf(m - 1.0) / span;
            let error = (f64::from(law.pdf(x)) / exact - 1.0).abs();
            // As the warp states.
            assert!(error <= 1.3e-7, "{n} {a} {b} at {x}: {error:e}");
        }
    }
}
