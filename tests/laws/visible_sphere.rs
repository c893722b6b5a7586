//! Spheres seen from a point: inside or outside is decided exactly, and the cone and the distance to the surface are right at
//! every height above it.

use host::docs::Doc;
use host::errors::raise;
use host::speed;
use host::truth::SeenSphere;
use microwarp::tier::{Libm, Poly, Tier};
use microwarp::uniform::{LARGEST, grid};
use microwarp::warp::VisibleSphere;
use microwarp::{Error, Warp as _};
use rand_core::Rng;
use rand_pcg::Pcg32;

/// A number with the digits of `f32` and an exponent of its own.
fn number(rng: &mut Pcg32, decades: f32) -> f32 {
    let x = grid(rng) - 0.5;
    x * 10_f32.powf(decades * (2.0 * grid(rng) - 1.0))
}

type Scene = ([f32; 3], [f32; 3], f32);

/// A point, a centre somewhere, and a radius some steps of `f32` from their distance, or a part of it.
fn scene(rng: &mut Pcg32, decades: f32) -> Scene {
    let [point, centre] = [(); 2].map(|()| [(); 3].map(|()| number(rng, decades)));
    let d = SeenSphere::new(point, centre, 1.0).distance;
    let off = match rng.next_u32() % 4 {
        0 => 0.0,
        1 => f64::from(rng.next_u32() % 65) * 2e-8 - 6.4e-7,
        2 => -(10_f64.powf(-9.0 * f64::from(grid(rng)))),
        _ => 10_f64.powf(15.0 * f64::from(grid(rng)) - 9.0),
    };
    (point, centre, (d / (1.0 + off.max(-0.999))) as f32)
}

/// Points exactly on a sphere, at sizes of all kinds, and beside it by less than any rounding keeps.
#[test]
fn the_surface_is_a_hemisphere_and_the_slightest_depth_is_inside() {
    let whole = [
        [1.0, 2.0, 2.0, 3.0],
        [2.0, 3.0, 6.0, 7.0],
        [4.0, 4.0, 7.0, 9.0],
        [0.0, 0.0, 1.0, 1.0],
    ];
    for [x, y, z, r] in whole {
        for size in [1e-45, 1e-38, 1e-20, 3.0, 1e15, 1e37]
            .map(|s: f32| f32::from_bits(s.to_bits() & 0xff80_0000).max(1e-45))
        {
            let at = |r: f32| {
                VisibleSphere::<Poly>::new([size * x, size * y, size * z], [0.0; 3], r).unwrap()
            };
            let on = at(size * r);
            assert_eq!(
                (on.is_inside(), on.solid_angle()),
                (false, std::f32::consts::TAU),
                "{on:?}"
            );
            assert_eq!(on.sample_surface([0.3, 0.7]).distance, 0.0);
            let bits = (size * r).to_bits();
            assert!(at(f32::from_bits(bits + 1)).is_inside());
            assert!(bits == 1 || !at(f32::from_bits(bits - 1)).is_inside());
        }
    }
    // d² is 1 + 1e-88, 1 - 2e-45 and 1 + 1e-90 - 2e-45 here.
    for (point, centre, inside) in [
        ([0.0, 1e-44, 0.0], [1.0, 0.0, 0.0], false),
        ([1e-45, 0.0, 0.0], [1.0, 0.0, 0.0], true),
        ([1e-45, 1e-45, 0.0], [1.0, 0.0, 0.0], true),
        ([-1e-45, 1e-45, 0.0], [1.0, 0.0, 0.0], false),
    ] {
        let seen = VisibleSphere::<Poly>::new(point, centre, 1.0).unwrap();
        assert_eq!(seen.is_inside(), inside, "{seen:?}");
    }
}

#[test]
fn inside_and_outside_are_decided_as_in_integers() {
    let n = speed::of("points beside a sphere", 20_000, 1_000_000);
    let mut rng = Pcg32::new(41, 3);
    let (mut inside, mut plain_wrong) = (0, 0);
    for _ in 0..n {
        let mut integer = || {
            let word = i64::from(rng.next_u32() >> 8) - 8_388_608;
            (word << (rng.next_u32() % 35)) as f32
        };
        let [point, centre] = [(); 2].map(|()| [(); 3].map(|()| integer()));
        let sides = [0, 1, 2].map(|i| centre[i] as i128 - point[i] as i128);
        let square: i128 = sides.iter().map(|s| s * s).sum();
        let radius =
            f32::from_bits(((square as f64).sqrt() as f32).to_bits() + rng.next_u32() % 3 - 1);
        if radius <= 1.0 {
            continue;
        }
        let exact = square < (radius as i128).pow(2);
        let seen = VisibleSphere::<Poly>::new(point, centre, radius).unwrap();
        assert_eq!(seen.is_inside(), exact, "{point:?} {centre:?} {radius}");
        assert_eq!(SeenSphere::new(point, centre, radius).is_inside(), exact);
        inside += u32::from(exact);
        let rounded = [0, 1, 2].map(|i| centre[i] - point[i]);
        let plain = rounded.iter().map(|s| s * s).sum::<f32>() < radius * radius;
        plain_wrong += u32::from(plain != exact);
    }
    println!("{inside} of {n} inside; plain f32 is wrong for {plain_wrong}");
    assert!(inside > n / 4 && inside < n - n / 4 && plain_wrong > n / 10);
}

/// What the documentation states of k and of the distance.
const STATED: [f64; 2] = [8e-7, 1.9e-6];

/// What a search that climbs has found for each: a point, a centre, a radius, and the first uniform.
const FOUND: [([f32; 3], [f32; 3], f32, f32); 2] = [
    (
        [-0.001_273_474_7, 0.001_179_047_9, -0.001_261_831],
        [-0.016_905_086, 0.001_040_926_3, 4.692_149e-5],
        0.013_401_213,
        0.5,
    ),
    (
        [-0.099_056_36, -0.001_029_692_5, -0.119_526_56],
        [-2.122_223, -0.147_682_43, 0.038_621_545],
        1.760_744_9,
        0.010_545_046,
    ),
];

fn edge(rng: &mut Pcg32) -> f32 {
    match rng.next_u32() % 8 {
        0 => 0.0,
        1 => LARGEST,
        2 => 0.5,
        3 => LARGEST - grid(rng) * 1e-5,
        4 => 0.5 + (grid(rng) - 0.5) * 1e-5,
        _ => grid(rng),
    }
}

/// The largest errors of k and of the distance over scenes of any kind.
fn errors<T: Tier>(n: usize) -> [f64; 2] {
    let mut rng = Pcg32::new(43, 5);
    let (mut worst, mut judged) = ([0.0, 0.0], 0);
    for i in 0..n {
        let (point, centre, radius) = match FOUND.get(i) {
            Some(&(point, centre, radius, _)) => (point, centre, radius),
            None => scene(&mut rng, [0.0, 2.0, 30.0][i % 3]),
        };
        let seen = match VisibleSphere::<T>::new(point, centre, radius) {
            Ok(seen) => seen,
            Err(error) => {
                let all = Error::NO_PLACE;
                let reasons = [
                    Error::TooLarge(all),
                    Error::Empty(all),
                    Error::NotPositive(2),
                ];
                assert!(reasons.contains(&error));
                continue;
            }
        };
        let exact = SeenSphere::new(point, centre, radius);
        let label = format!("{point:?} {centre:?} {radius}");
        assert_eq!(seen.is_inside(), exact.is_inside(), "{label}");
        let k = f64::from(seen.one_minus_cos());
        if raise(&mut worst[0], (k / exact.k() - 1.0).abs()) {
            println!("k {:e} off at {label}", worst[0]);
        }
        for _ in 0..4 {
            let first = FOUND.get(i).map_or_else(|| edge(&mut rng), |found| found.3);
            let u = [first, grid(&mut rng)];
            let found = seen.sample_surface(u);
            assert_eq!((found.direction, found.pdf), seen.sample_with_pdf(u));
            assert_eq!(found.pdf, seen.density());
            assert!(
                (0.0..=f32::MAX).contains(&found.distance),
                "{label} at {u:?}: {found:?}"
            );
            let due = exact.distance_along(f64::from(u[0]));
            // As near as the page says.
            let near = exact.gap.abs() < 2e-37 * exact.radius.powi(2);
            if !near && due >= 1e-37 && due <= f64::from(f32::MAX) {
                judged += 1;
                let error = (f64::from(found.distance) / due - 1.0).abs();
                if raise(&mut worst[1], error) {
                    println!("distance {error:e} off at {u:?} of {label}");
                }
            }
        }
    }
    assert!(judged > n, "{judged} distances of {n} scenes");
    worst
}

#[test]
fn cone_and_distance_are_right_at_every_height() {
    let [k, distance] = STATED;
    let page = Doc::find("warp", "VisibleSphere").unwrap().text();
    let stated = format!("k is right to {k:e} and the distance to {distance:e}");
    assert!(page.contains(&stated), "the page does not say {stated:?}");
    let n = speed::of("spheres and points", 60_000, 1_000_000);
    for (tier, worst) in [("libm", errors::<Libm>(n)), ("poly", errors::<Poly>(n))] {
        println!("{tier}: {worst:?}");
        for (worst, stated) in worst.into_iter().zip(STATED) {
            assert!(worst <= stated && worst >= 0.5 * stated, "{tier}: {worst}");
        }
    }
}

/// The place at the distance in the direction lies on the sphere; that of the far side, or of a direction beside, does not.
#[test]
fn the_place_in_the_direction_lies_on_the_sphere() {
    let n = speed::of("places on spheres", 20_000, 1_000_000);
    let mut rng = Pcg32::new(47, 5);
    let (mut worst, mut control) = (0.0_f64, 0);
    for _ in 0..n {
        let (point, centre, radius) = scene(&mut rng, 1.0);
        let Ok(seen) = VisibleSphere::<Poly>::new(point, centre, radius) else {
            continue;
        };
        let exact = SeenSphere::new(point, centre, radius);
        if exact.distance < 0.1 * exact.radius {
            continue;
        }
        let found = seen.sample_surface([grid(&mut rng), grid(&mut rng)]);
        let off = |distance: f64| {
            let place = [0, 1, 2].map(|i| exact.axis[i] - distance * f64::from(found.direction[i]));
            let reach = place.iter().map(|c| c * c).sum::<f64>().sqrt();
            (reach - exact.radius).abs() / (exact.distance + exact.radius)
        };
        let error = off(f64::from(found.distance));
        assert!(error <= 8e-7, "{error:e} at {point:?} {centre:?} {radius}");
        worst = worst.max(error);
        control += usize::from(off(f64::from(found.distance) + 1e-3 * exact.radius) > 8e-7);
    }
    println!("off the sphere by {worst:e} of its reach");
    assert!(control > n / 3, "{control} of {n}");
}

/// However narrow a lamp is, its samples have a density: those of the lamp of which turning there and back takes a direction
/// farthest, too.
#[test]
fn the_narrowest_lamps_have_a_density_at_their_samples() {
    let n = speed::of("narrow spheres", 100_000, 3_000_000);
    let mut rng = Pcg32::new(53, 5);
    let worst = (
        [-1.258_091_3, 1.488_191_7, -0.197_889_73],
        [-0.386_841_5, 2.037_279_1, -0.196_723_5],
    );
    let random = (0..n).map(|_| {
        let [point, centre] = [(); 2].map(|()| [(); 3].map(|()| number(&mut rng, 2.0)));
        (point, centre)
    });
    let mut judged = 0;
    for (point, centre) in random.chain([worst]).collect::<Vec<_>>() {
        let Ok(lamp) = VisibleSphere::<Poly>::new(point, centre, 2e-10) else {
            continue;
        };
        let x = lamp.sample([grid(&mut rng), grid(&mut rng)]);
        assert!(lamp.pdf(x) == lamp.density(), "{point:?} {centre:?}");
        let beside = [x[1] * 2e-6 + x[0], x[1] - x[0] * 2e-6, x[2] + 2e-6];
        judged += usize::from(lamp.pdf(beside) == 0.0);
    }
    assert!(judged > n / 2, "{judged} of {n}");
}
