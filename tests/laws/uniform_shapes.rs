//! Rings, balls, rotations, polygons and simplices: what the registry's three coordinates do not show, and laws that
//! hold for a shape alone.

use host::docs::{Doc, row_of};
use host::errors::ulp;
use host::{speed, stats, truth};
use microwarp::tier::{Libm, Poly, Tier};
use microwarp::uniform::grid;
use microwarp::warp::{Annulus, Ball, Disk, RegularPolygon, Rotation, Simplex};
use microwarp::{Invert, Warp};
use rand_core::Rng;
use rand_pcg::Pcg32;
use std::f64::consts::PI;

const STEP: f32 = 1.0 / 16_777_216.0;

/// A uniform of the grid, every second time next to one of its ends.
fn edgy(rng: &mut Pcg32) -> f32 {
    let near = f32::from(rng.next_u32() as u16 & 63) * STEP;
    match rng.next_u32() % 4 {
        0 => near,
        1 => 1.0 - STEP - near,
        _ => grid(rng),
    }
}

/// The bound of a row in the column of a tier, for the value of its only parameter if it has one.
fn stated<T: Tier>(name: &str, row: &str, value: f64) -> f64 {
    let cell = row_of(name, T::NAME, row).expect("a row of the table");
    cell.eval(&vec![value; cell.names().len()])
}

fn page(name: &str) -> String {
    Doc::find("warp", name).unwrap().text()
}

/// The largest of many errors; NaN counts as infinite.
fn worst(errors: impl Iterator<Item = f64>) -> f64 {
    errors.fold(0.0, |most, e| {
        if e <= most {
            most
        } else if e.is_nan() {
            f64::INFINITY
        } else {
            e
        }
    })
}

fn root_error(root: impl Fn(f32) -> f32) -> f64 {
    let stride = speed::of("one cube root tried of every", 61, 1);
    // Three octaves hold every fraction with every rest of an exponent by three; others are numbers off the grid.
    let octaves = 0.125_f32.to_bits()..1.0_f32.to_bits();
    let small = (1..0.125_f32.to_bits()).step_by(100_003);
    let all = octaves.step_by(stride).chain(small);
    worst(all.map(|bits| {
        let u = f32::from_bits(bits);
        let exact = f64::from(u).cbrt();
        (f64::from(root(u)) - exact).abs() / ulp(exact)
    }))
}

#[test]
fn the_radius_of_a_ball_is_a_cube_root() {
    // Towards +z the height is the radius.
    let error = root_error(|u| Ball::<Poly>::new().sample([u, 0.0, 0.0])[2]);
    println!("cube root: {error:.4} ulp");
    assert!(page("Ball").contains("to 0.51 units in the last place"));
    assert!((0.499..=0.51).contains(&error), "{error}");
    assert_eq!(Ball::<Libm>::new().sample([0.0, 0.3, 0.3]), [0.0; 3]);
    let plain = root_error(|u| u.powf(1.0 / 3.0));
    assert!(plain > 0.51, "a power of a rounded third passes: {plain}");
}

/// The largest errors of rotations in all four coordinates: of the sample, of its length, after the round trip.
fn rotation_errors<T: Tier>() -> [f64; 3] {
    let warp = Rotation::<T>::new();
    let mut rng = Pcg32::new(4, 4);
    let mut most = [0.0; 3];
    for _ in 0..speed::of("rotations", 300_000, 1 << 24) {
        let u = [edgy(&mut rng), edgy(&mut rng), edgy(&mut rng)];
        let q = warp.sample(u);
        assert!(q[3] >= 0.0, "{u:?}: {q:?}");
        let [a, b, c] = u.map(f64::from);
        let exact = truth::Rotations::quaternion([a, b, c, 0.0]);
        let wide = q.map(f64::from);
        let square = |v: [f64; 4]| v.iter().map(|x| x * x).sum::<f64>();
        let off = square(std::array::from_fn(|k| wide[k] - exact[k])).sqrt();
        let back = warp.invert(q);
        let lost = [false, false, q[0] == 0.0 && q[1] == 0.0];
        let trip = worst((0..3).filter(|k| !lost[*k]).map(|k| {
            let apart = f64::from(back[k] - u[k]).abs();
            if k == 2 {
                apart.min(1.0 - apart)
            } else {
                apart
            }
        }));
        let here = [off, (square(wide).sqrt() - 1.0).abs(), trip];
        most = std::array::from_fn(|k| worst([most[k], here[k]].into_iter()));
        let negative = q.map(|c| -c);
        if q[3] > 0.0 {
            assert_eq!(warp.invert(negative), back);
        }
    }
    most
}

#[test]
fn rotations_keep_their_statements_in_four_coordinates() {
    fn of_tier<T: Tier>() {
        let [sample, length, trip] = rotation_errors::<T>();
        println!(
            "{}: sample {sample:.3e}, length {length:.3e}, round trip {trip:.3e}",
            T::NAME
        );
        let (of_sample, of_trip) = (
            stated::<T>("Rotation", "sample", 0.0),
            stated::<T>("Rotation", "round trip", 0.0),
        );
        assert!(
            sample <= of_sample && length <= of_sample,
            "{sample} {length}"
        );
        assert!(trip <= of_trip, "{trip}");
        assert!(
            sample >= 0.4 * of_sample && trip >= 0.4 * of_trip,
            "twice too large"
        );
    }
    of_tier::<Libm>();
    of_tier::<Poly>();
}

type Quaternion = [f64; 4];

/// The rotation q after p.
fn after([a, b, c, d]: Quaternion, [x, y, z, w]: Quaternion) -> Quaternion {
    [
        d * x + a * w + b * z - c * y,
        d * y - a * z + b * w + c * x,
        d * z + a * y - b * x + c * w,
        d * w - a * x - b * y - c * z,
    ]
}

/// p-values of what is uniform for uniform rotations: the share of angles up to one's own, (θ − sin θ)/π; and the
/// inverse's uniforms, before and after another rotation.
fn p_values(mut draw: impl FnMut() -> Quaternion) -> Vec<f64> {
    let turn = [0.1, -0.7, 0.3, (1.0_f64 - 0.59).sqrt()];
    let n = speed::of("rotations whose angles are tested", 100_000, 2_000_000);
    let mut shares = vec![Vec::new(); 7];
    for _ in 0..n {
        let q = draw();
        let sine = (q[0] * q[0] + q[1] * q[1] + q[2] * q[2]).sqrt();
        let angle = 2.0 * sine.atan2(q[3].abs());
        shares[0].push((angle - angle.sin()) / PI);
        let warp = Rotation::<Libm>::new();
        let [before, behind] =
            [after(q, turn), after(turn, q)].map(|q| warp.invert(q.map(|c| c as f32)));
        for (k, u) in before.into_iter().chain(behind).enumerate() {
            shares[1 + k].push(f64::from(u));
        }
    }
    let distance = |mut shares: Vec<f64>| {
        shares.sort_by(f64::total_cmp);
        let steps = shares.iter().enumerate();
        let due = |i: usize| i as f64 / n as f64;
        worst(steps.map(|(i, s)| (s - due(i)).abs().max((s - due(i + 1)).abs())))
    };
    shares
        .into_iter()
        .map(|s| stats::kolmogorov(distance(s), n as f64))
        .collect()
}

#[test]
fn angles_of_rotations_follow_one_minus_cos() {
    let threshold = stats::threshold(14);
    fn right<T: Tier>() -> Vec<f64> {
        let (warp, mut rng) = (Rotation::<T>::new(), Pcg32::new(9, 1));
        p_values(|| warp.draw(&mut rng).map(f64::from))
    }
    stats::assert_passes("libm", &right::<Libm>(), threshold);
    stats::assert_passes("poly", &right::<Poly>(), threshold);
    let mut rng = Pcg32::new(9, 2);
    let wrong = p_values(|| {
        let axis = microwarp::libm::Sphere::new().draw(&mut rng).map(f64::from);
        let (sin, cos) = (0.5 * PI * f64::from(grid(&mut rng))).sin_cos();
        [sin * axis[0], sin * axis[1], sin * axis[2], cos]
    });
    // Every single one: the angle, and what another rotation leaves.
    println!("uniform axis and angle: {wrong:?}");
    stats::assert_rejected("uniform axis and angle, its angle", &wrong[..1], threshold);
    stats::assert_rejected("uniform axis and angle, turned", &wrong[1..], threshold);
}

/// By how much uniforms differ from those of the points of a ring, beyond the half step to which a radius is rounded.
fn radial_error(inner: f32, outer: f32, radius: impl Fn(f32) -> f32) -> f64 {
    let [low, high] = [inner, outer].map(f64::from);
    let area = (high - low) * (high + low);
    let stride = speed::of("one radius tried of every", 1_021, 7);
    worst((0..1_u32 << 24).step_by(stride).map(|k| {
        let u = k as f32 * STEP;
        let r = f64::from(radius(u));
        let back = (r - low) * (r + low) / area;
        let rounding = 0.5 * ulp(r) * 2.0 * r / area;
        (back - f64::from(u)).abs() - rounding
    }))
}

#[test]
fn rings_of_any_width_get_their_share() {
    let mut plain_worst = 0.0_f64;
    for (inner, outer) in [
        (1.0, 2.0),
        (0.3, 0.301),
        (1.0, 1.000_01),
        (1.0, 1.000_001),
        (3e-15, 3.000_01e-15),
        (0.0, 5.0),
    ] {
        let ring = Annulus::<Poly>::new(inner, outer).unwrap();
        let error = radial_error(inner, outer, |u| ring.sample([u, 0.0])[0]);
        let plain = radial_error(inner, outer, |u| {
            (inner * inner + u * (outer * outer - inner * inner)).sqrt()
        });
        println!("{inner} to {outer}: {error:.2e}, plainly {plain:.2e}");
        assert!(error <= 3.3e-7, "{inner} to {outer}: {error:e}");
        plain_worst = plain_worst.max(plain);
    }
    assert!(plain_worst > 1e-3, "the plain form passes: {plain_worst:e}");
    assert!(page("Annulus").contains("3.3e-7"));
}

#[test]
fn a_ring_without_a_hole_is_a_disk() {
    let (disk, ring) = (Disk::<Libm>::new(), Annulus::<Libm>::new(0.0, 1.0).unwrap());
    let mut rng = Pcg32::new(1, 2);
    for _ in 0..10_000 {
        let u = [edgy(&mut rng), edgy(&mut rng)];
        let (a, b) = (disk.sample(u), ring.sample(u));
        assert!(
            (0..2).all(|k| (a[k] - b[k]).abs() <= 3e-7),
            "{u:?}: {a:?}, {b:?}"
        );
    }
    assert_eq!(ring.sample([0.0, 0.7]), [0.0, 0.0]);
    assert_eq!(ring.pdf([0.0, 0.0]), core::f32::consts::FRAC_1_PI);
}

/// The longest step between the points of neighbouring uniforms along the rim, in steps of the grid.
fn longest_step(corners: u16, map: impl Fn(f32) -> [f32; 2]) -> f64 {
    let around = |k: u32| (0..400_u32).map(move |i| k.saturating_sub(200) + i);
    let borders = (0..u32::from(corners))
        .flat_map(|c| around((u64::from(c) << 24).div_ceil(u64::from(corners)) as u32));
    let step = |k: u32| {
        let [a, b] = [k, (k + 1) % (1 << 24)].map(|k| map(k as f32 * STEP).map(f64::from));
        (a[0] - b[0]).hypot(a[1] - b[1])
    };
    worst(borders.chain((1 << 24) - 200..1 << 24).map(step)) / f64::from(STEP)
}

#[test]
fn the_rim_of_a_polygon_is_not_torn() {
    for corners in [3, 4, 5, 7, 12, 100] {
        let polygon = RegularPolygon::<Poly>::new(corners).unwrap();
        let longest = longest_step(corners, |u| polygon.sample([1.0 - STEP, u]));
        // The rim is at most 2π long; the rest is rounding.
        assert!(longest <= 2.0 * PI + 8.0, "{corners}: {longest}");
    }
    let polygon = RegularPolygon::<Poly>::new(5).unwrap();
    let torn = longest_step(5, |u| {
        let place = 5.0 * u;
        polygon.sample([1.0 - STEP, (place.floor() + (1.0 - place.fract())) / 5.0])
    });
    assert!(torn > 1e6, "sides that run backwards pass: {torn}");
}

/// The largest relative error of a share or of the rest, over its number; of the sum; of all in distance; after the round
/// trip.
fn simplex_errors<T: Tier, const N: usize>() -> [f64; 4] {
    let (warp, mut rng) = (Simplex::<T, N>::new(), Pcg32::new(N as u64, 3));
    let mut most = [0.0; 4];
    for _ in 0..speed::of("points of each simplex", 30_000, 1 << 20) {
        let u: [f32; N] = std::array::from_fn(|_| edgy(&mut rng));
        let (shares, rest) = warp.sample(u);
        let exact = truth::Simplex::shares(&u.map(f64::from));
        let found: Vec<f64> = shares.into_iter().chain([rest]).map(f64::from).collect();
        let relative = worst(found.iter().zip(&exact).enumerate().map(|(j, (x, e))| {
            if x == e {
                0.0
            } else {
                (x - e).abs() / e / (j as f64 + 1.0)
            }
        }));
        let sum = (found.iter().sum::<f64>() - 1.0).abs();
        assert_eq!(
            warp.pdf((shares, rest)),
            (1..=N).map(|k| k as f64).product::<f64>() as f32
        );
        let back = warp.invert((shares, rest));
        let trip = worst(back.into_iter().zip(u).map(|(a, b)| f64::from(a - b).abs()));
        let off = found
            .iter()
            .zip(&exact)
            .map(|(x, e)| (x - e).powi(2))
            .sum::<f64>()
            .sqrt();
        let here = [relative, sum, off, trip];
        most = std::array::from_fn(|k| worst([most[k], here[k]].into_iter()));
    }
    most
}

#[test]
fn shares_keep_their_digits_in_every_dimension() {
    fn of_tier<T: Tier>() {
        let all = [
            (1.0, simplex_errors::<T, 1>()),
            (2.0, simplex_errors::<T, 2>()),
            (3.0, simplex_errors::<T, 3>()),
            (4.0, simplex_errors::<T, 4>()),
            (8.0, simplex_errors::<T, 8>()),
            (34.0, simplex_errors::<T, 34>()),
        ];
        let mut most = [0.0; 4];
        for (n, [relative, sum, off, trip]) in all {
            let bounds = [3.5e-7, 1e-7 + 5.5e-8 * n]
                .into_iter()
                .chain(["sample", "round trip"].map(|row| stated::<T>("Simplex", row, n)));
            let errors = [relative, sum, off, trip].into_iter().zip(bounds);
            for (most, (error, bound)) in most.iter_mut().zip(errors) {
                *most = worst([*most, error / bound].into_iter());
            }
        }
        println!("{}: {most:?} of the bounds", T::NAME);
        assert!(
            most.iter().all(|part| (0.4..=1.0).contains(part)),
            "{most:?}"
        );
    }
    of_tier::<Libm>();
    of_tier::<Poly>();
    let page = page("Simplex");
    assert!(page.contains("j·3.5e-7") && page.contains("1e-7 + 5.5e-8·n"));
}
