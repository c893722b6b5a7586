//! The programs of `parametric` are the maps of the crate, bit by bit, and in real numbers their truths.

use crate::laws::by_constructor;
use crate::maps::mirrored;
use crate::parametric::{Cone, Fog, Form, Given, Triangle};
use crate::search::spread;
use host::registry::{Registered, registered};
use host::speed;
use microwarp::tier::{Libm, Poly, Tier};
use microwarp::warp::{self, HenyeyGreenstein};
use microwarp::{Warp, poly};
use std::f32::consts::PI;
use std::fmt::Debug;
use std::sync::LazyLock;

/// How many parameters and uniforms are drawn.
pub static DRAWS: LazyLock<u32> =
    LazyLock::new(|| speed::of("draws of programs", 1 << 10, 1 << 16));

/// A uniform of a counter: of the grid, or of all binades.
pub fn uniform(k: u32) -> f32 {
    let word = spread(k);
    if word % 3 == 0 {
        f32::from_bits(spread(word) % 1.0_f32.to_bits())
    } else {
        (word >> 8) as f32 / 16_777_216.0
    }
}

/// A number of all binades between two.
pub fn between(k: u32, low: f32, high: f32) -> f32 {
    let [low, high] = [low, high].map(f32::to_bits);
    f32::from_bits(low + spread(k ^ 0x5bd1_e995) % (high - low + 1))
}

/// What a warp keeps under a name. The shortest digits tell every number.
pub fn kept(warp: &impl Debug, name: &str) -> f32 {
    let text = format!("{warp:?}");
    let (_, value) = text.split_once(&format!(" {name}: ")).expect("a field");
    let end = value.find([',', ' ']).expect("its end");
    value[..end].parse().expect("a number")
}

/// Holds a direction of a warp to the program.
fn assert_bits<T: Tier>(
    form: &impl Form,
    warp: &impl Warp<Uniforms = [f32; 2], Point = [f32; 3]>,
    fields: &[f32],
    u: [f32; 2],
) {
    let place = form.place(fields, &[u[0], 1.0 - u[0]]);
    let (s, c) = mirrored::<T>(u[1]);
    let expected = [place[0] * c, place[0] * s, place[1]];
    assert_eq!(warp.sample(u), expected, "{} {fields:?} {u:?}", T::NAME);
}

fn cones_are_programs<T: Tier>() {
    let excess = (f64::from(PI) - std::f64::consts::PI) as f32;
    for k in 0..*DRAWS {
        let u = [k, k + *DRAWS].map(uniform);
        let off = [[0.0; 17]; 2];
        let of = |cone: warp::Cone<T>| {
            let [lifted, rest] = ["lifted", "rest"].map(|name| kept(&cone, name));
            let wide = cone.one_minus_cos() > 1.0;
            assert_bits::<T>(&Cone { wide, off }, &cone, &[lifted, rest], u);
            rest
        };
        let one_minus_cos = between(k, f32::MIN_POSITIVE, 2.0);
        let cone = warp::Cone::<T>::from_one_minus_cos(one_minus_cos).expect("a cone");
        assert_eq!(cone.one_minus_cos(), one_minus_cos);
        assert_eq!(of(cone), 2.0 - one_minus_cos);
        of(warp::Cone::from_sine(between(k, 1e-18, 1.0)).expect("a cone"));
        of(warp::Cone::from_radians(between(k, 1e-18, PI)).expect("a cone"));
        // An obtuse one, of which 1 + cos is 1 - cos of the angle that it leaves.
        let angle = between(k, 0.5 * PI, 3.0);
        let left = warp::Cone::<T>::from_radians((PI - angle) - excess).expect("a cone");
        let rest = of(warp::Cone::from_radians(angle).expect("a cone"));
        assert_eq!(rest, left.one_minus_cos());
    }
}

fn fog_is_a_program<T: Tier>() {
    for k in 0..*DRAWS {
        let u = [k, k + *DRAWS].map(uniform);
        let [g, width] = [
            between(k, 1e-30, 1.0 - 0.5 * f32::EPSILON),
            between(k, 2.0_f32.powi(-32), 1.0),
        ];
        let fogs = [
            (Given::G, HenyeyGreenstein::<T>::new(g), 1.0 - f64::from(g)),
            (Given::G, HenyeyGreenstein::new(-g), 1.0 - f64::from(g)),
            (
                Given::OneMinusG,
                HenyeyGreenstein::from_one_minus_g(width),
                width.into(),
            ),
            (
                Given::OneMinusG,
                HenyeyGreenstein::from_one_plus_g(width),
                width.into(),
            ),
        ];
        for (i, (of, warp, exact)) in fogs.into_iter().enumerate() {
            let warp = warp.expect("an asymmetry");
            let fog = Fog {
                backward: i % 2 == 1,
                of,
            };
            let h = warp.asymmetry().abs();
            let [least, ahead, behind] = ["least", "ahead", "behind"].map(|name| kept(&warp, name));
            let fields = [h, least, ahead, behind];
            // Of 1 - |g| = 1 the asymmetry is 0, and has no sign.
            if h > 0.0 {
                assert_bits::<T>(&fog, &warp, &fields, u);
            }
            let due = fog.fields(&[exact]);
            let off = fog.off(&[crate::range::Range::only(exact)]);
            for ((is, due), halves) in fields.into_iter().zip(due).zip(off) {
                // 1 - |g| itself is a double here.
                let half = 0.5 * f64::from(f32::EPSILON) * due.abs();
                let lost = 2.0 * f64::EPSILON * due.abs().max(1.0);
                let apart = (f64::from(is) - due).abs();
                assert!(apart <= halves * half + lost, "{is} {due} {exact}");
            }
        }
    }
}

#[test]
fn maps_are_the_programs_that_are_recorded() {
    cones_are_programs::<Libm>();
    cones_are_programs::<Poly>();
    fog_is_a_program::<Libm>();
    fog_is_a_program::<Poly>();
    let mut noticed = 0;
    for k in 0..*DRAWS {
        let [a, b, c] = [k, k + *DRAWS, k + 2 * *DRAWS].map(uniform);
        let place = |once_more| Triangle { once_more }.place(&[], &[a, 1.0 - a, b, 1.0 - b]);
        let point = warp::Triangle::new().sample([a, b]);
        assert_eq!(place(false), point);
        noticed += u32::from(place(true) != point);
        products::<Libm>([a, b, c]);
        products::<Poly>([a, b, c]);
    }
    assert!(
        noticed > *DRAWS / 100,
        "{noticed} bits differ where one rounding more is done"
    );
    // A coefficient that is off by an ulp is noticed.
    let cone = poly::Cone::from_one_minus_cos(0.3).expect("a cone");
    let [lifted, rest] = ["lifted", "rest"].map(|name| kept(&cone, name));
    let wrong = f32::from_bits(lifted.to_bits() + 1);
    let off = [[0.0; 17]; 2];
    let form = Cone { wide: false, off };
    let place = |lifted, u: f32| form.place(&[lifted, rest], &[u, 1.0 - u]);
    let noticed = (0..100).filter(|&k| place(lifted, uniform(k)) != place(wrong, uniform(k)));
    assert!(noticed.count() > 50);
}

/// The ball is a direction times a radius, a rotation two points of a disk, a normal pair the standard one scaled and moved.
fn products<T: Tier>([a, b, c]: [f32; 3]) {
    let [_, _, r] = warp::Ball::<T>::new().sample([a, 0.0, 0.0]);
    let [sin, _, cos] = warp::Sphere::<T>::new().sample([b, 0.0]);
    let (y, x) = mirrored::<T>(c);
    let ball = [r * sin * x, r * sin * y, r * cos];
    assert_eq!(warp::Ball::<T>::new().sample([a, b, c]), ball);
    let ((z, w), [near, far]) = (mirrored::<T>(0.5 * b - 0.25), [a, 1.0 - a].map(f32::sqrt));
    let rotation = [near * x, near * y, far * z, (far * w).abs()];
    assert_eq!(warp::Rotation::<T>::new().sample([a, b, c]), rotation);
    let pair = |mean, deviation| warp::NormalPair::<T>::new(mean, deviation).expect("a pair");
    let [r, _] = pair([0.0; 2], 1.0).sample([a, 0.0]);
    let (mean, deviation) = ([100.0 * (b - 0.5), 1.0 - a], 1e-6 + 3.0 * b);
    let far = deviation * r;
    let point = [mean[0] + far * x, mean[1] + far * y];
    assert_eq!(pair(mean, deviation).sample([a, c]), point);
}

/// Without rounding a program gives what the registry calls the truth.
fn assert_truth(of: &Registered, parameter: f32, form: &impl Form, exact: f64, u: f64) {
    let entry = (of.build)(&[parameter]).expect("an accepted parameter");
    let place = form.place(&form.fields(&[exact]), &[u, 1.0 - u]);
    let due = entry.truth.sample([u, 0.0, 0.0, 0.0]);
    let apart = (place[0] - due[0]).hypot(place[1] - due[2]);
    assert!(
        apart <= 1e-10,
        "{} {parameter} {u}: {place:?} {due:?}",
        of.name
    );
}

#[test]
fn programs_of_real_numbers_are_the_truth() {
    let all = registered();
    let find = |name, constructor| by_constructor(&all, name, constructor);
    let fogs = ["from_one_minus_g", "from_one_plus_g"].map(|by| find("HenyeyGreenstein", by));
    let cones = find("Cone", "from_one_minus_cos");
    let triangle = (find("Triangle", "").build)(&[]).expect("a triangle");
    for k in 0..*DRAWS {
        let [u, v] = [k, k + *DRAWS].map(|k| f64::from(uniform(k)));
        let cone = between(k, f32::MIN_POSITIVE, 2.0);
        let wide = cone > 1.0;
        let exact = f64::from(cone);
        let exact = if wide { 2.0 - exact } else { exact };
        let off = [[0.0; 17]; 2];
        assert_truth(cones, cone, &Cone { wide, off }, exact, u);
        let width = between(k, 2.0_f32.powi(-32), 1.0);
        for (backward, of) in [false, true].into_iter().zip(fogs) {
            let given = Given::OneMinusG;
            let fog = Fog {
                backward,
                of: given,
            };
            assert_truth(of, width, &fog, width.into(), u);
        }
        let once_more = false;
        let place = Triangle { once_more }.place(&[], &[u, 1.0 - u, v, 1.0 - v]);
        let due = triangle.truth.sample([u, v, 0.0, 0.0]);
        let apart = (0..3).map(|i| (place[i] - due[i]).abs());
        assert!(apart.fold(0.0, f64::max) <= 1e-10, "{place:?} {due:?}");
    }
}
