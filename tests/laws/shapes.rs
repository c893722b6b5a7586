//! Triangles and patches of any shape and place: no density 0 at a sample of theirs, none above 0 far from them, and
//! shares of the points of a small triangle far off that are right to the rounding of their cells.

use host::speed;
use host::truth::{OnTriangle, Truth};
use microwarp::tier::{Libm, Poly, Tier};
use microwarp::warp::{Cone, SphericalPatch, Tent, TriangleOn};
use microwarp::{Warp, uniform};
use rand_core::Rng;
use rand_pcg::Pcg32;
use std::f64::consts::PI;

/// 2 to a power between two ends, of either sign.
fn spread(rng: &mut Pcg32, low: f32, high: f32) -> f32 {
    let x = (low + uniform::grid(rng) * (high - low)).exp2();
    if rng.next_u32() & 1 == 0 { x } else { -x }
}

fn centred(rng: &mut Pcg32) -> f32 {
    2.0 * uniform::grid(rng) - 1.0
}

/// The ends of the grid, their neighbours, and what lies between.
fn edge(rng: &mut Pcg32) -> f32 {
    let near = |rng: &mut Pcg32| (rng.next_u32() % 8) as f32 * f32::EPSILON / 2.0;
    match rng.next_u32() % 4 {
        0 => near(rng),
        1 => uniform::LARGEST - near(rng),
        _ => uniform::grid(rng),
    }
}

/// Triangles of all kinds: every second one a sliver, every third far from 0, every fourth large or small, some of them
/// with a coordinate that is small beside the others.
fn triangle<const D: usize>(rng: &mut Pcg32) -> [[f32; D]; 3] {
    let mut v = [[0.0; D]; 3].map(|p| p.map(|_: f32| centred(rng)));
    if rng.next_u32() & 1 == 0 {
        let (along, height) = (uniform::grid(rng), spread(rng, -38.0, 0.0));
        let [a, b, c] = &mut v;
        for (c, (a, b)) in c.iter_mut().zip(a.iter().zip(b.iter())) {
            *c = a + along * (b - a) + height * centred(rng);
        }
    }
    if rng.next_u32() % 3 == 0 {
        let far = spread(rng, 0.0, 20.0);
        for k in 0..D {
            let by = far * centred(rng);
            v.iter_mut().for_each(|p| p[k] += by);
        }
    }
    if rng.next_u32() & 3 == 0 {
        let scale = spread(rng, -45.0, 60.0);
        v.as_flattened_mut().iter_mut().for_each(|x| *x *= scale);
    }
    if rng.next_u32() & 7 == 0 {
        let (k, scale) = (rng.next_u32() as usize % D, spread(rng, -149.0, -10.0));
        v.iter_mut().for_each(|p| p[k] *= scale);
    }
    v.rotate_left((rng.next_u32() % 3) as usize);
    v
}

/// A vector less its components along unit vectors at right angles to each other, of length 1; and its length before.
fn unit<const D: usize>(mut x: [f64; D], axes: &[[f64; D]]) -> ([f64; D], f64) {
    let dot = |p: &[f64; D], q: &[f64; D]| p.iter().zip(q).map(|(p, q)| p * q).sum::<f64>();
    for _ in 0..2 {
        for axis in axes {
            let along = dot(&x, axis);
            x.iter_mut().zip(axis).for_each(|(x, a)| *x -= along * a);
        }
    }
    let length = dot(&x, &x).sqrt();
    (x.map(|x| x / length), length)
}

/// A point so many times as far off as `TriangleOn` states that its density is 0: beyond a side, or off the plane.
fn off<const D: usize>(v: [[f32; D]; 3], times: f64, rng: &mut Pcg32) -> [f32; D] {
    let [a, b, c] = v.map(|p| p.map(f64::from));
    let from = |p: [f64; D], q: [f64; D]| std::array::from_fn(|k| q[k] - p[k]);
    let longest = [(a, b), (b, c), (c, a)]
        .map(|(p, q)| unit(from(p, q), &[]).1)
        .into_iter()
        .fold(0.0, f64::max);
    let size = v
        .as_flattened()
        .iter()
        .fold(0.0, |m: f32, x| m.max(x.abs()));
    let (along, _) = unit(from(a, b), &[]);
    let (across, _) = unit(from(a, c), &[along]);
    let way = if D > 2 && rng.next_u32() & 1 == 0 {
        let any = [(); D].map(|()| f64::from(centred(rng)));
        unit(any, &[along, across]).0
    } else {
        across.map(|x| -x)
    };
    let far = times * (longest * 2_f64.powi(-16) + f64::from(size) * 2_f64.powi(-19));
    let part = f64::from(uniform::grid(rng));
    std::array::from_fn(|k| (a[k] + part * (b[k] - a[k]) + far * way[k]) as f32)
}

/// The test that once told inside from outside in the plane: barycentric coordinates of one accuracy for all sides.
fn once_inside(v: [[f32; 2]; 3], x: [f32; 2]) -> bool {
    let from = |p: [f32; 2]| [p[0] - v[0][0], p[1] - v[0][1]];
    let (p, q, to) = (from(v[1]), from(v[2]), from(x));
    let wedge = |a: [f32; 2], b: [f32; 2]| a[0] * b[1] - a[1] * b[0];
    let norm = |a: [f32; 2]| (a[0] * a[0] + a[1] * a[1]).sqrt();
    let cross = wedge(p, q);
    let (b, c) = (wedge(to, q) / cross, wedge(p, to) / cross);
    let largest = v.as_flattened().iter().fold(0.0_f32, |m, c| m.max(c.abs()));
    let reach = norm(p) + norm(q);
    let slack = 2.0 * f32::EPSILON * (0.5 * largest + reach) * reach / cross.abs();
    b >= -slack && c >= -slack && 1.0 - b - c >= -slack
}

fn own_samples<const D: usize>(mut once: impl FnMut([[f32; D]; 3], [f32; D]) -> bool) -> u32 {
    let mut rng = Pcg32::new(13, D as u64);
    let count = speed::of("triangles", 60_000, 1_200_000);
    let (mut lost, mut accepted, mut near) = (0, 0, 0);
    for _ in 0..count {
        let v = triangle::<D>(&mut rng);
        let Ok(warp) = TriangleOn::new(v) else {
            continue;
        };
        accepted += 1;
        for _ in 0..3 {
            let u = [edge(&mut rng), edge(&mut rng)];
            let x = warp.sample(u);
            assert!(warp.pdf(x) > 0.0, "{v:?} at {u:?}: {x:?}");
            lost += u32::from(!once(v, x));
        }
        if D < 4 {
            let away = off(v, 1.1, &mut rng);
            assert!(warp.pdf(away) == 0.0, "{v:?}: {away:?}");
            near += u32::from(warp.pdf(off(v, 0.01, &mut rng)) > 0.0);
        }
    }
    assert!(accepted > count / 4 * 3);
    // What is nearer by far does count, so the bound above is one.
    assert!(D > 3 || near > count / 20, "{near}");
    lost
}

#[test]
fn no_triangle_has_density_zero_at_its_samples() {
    let lost = own_samples::<2>(once_inside);
    assert!(lost > 100, "the old test passes: {lost}");
    own_samples::<3>(|_, _| true);
    own_samples::<7>(|_, _| true);
}

/// Bits of triangles that had a density of 0 at these uniforms, in steps of 2⁻²⁴: the slack was that of what a search had
/// found, not of a proof.
const LOST: [([u32; 9], [u32; 2]); 5] = [
    (
        [
            0xbdd6_3fb6,
            0xbe1f_9e51,
            0x3e54_2384,
            0x3e84_82f7,
            0x3d01_b859,
            0x3e23_8410,
            0xbdb3_cf1a,
            0x3e4c_64fb,
            0x3e3d_ac7e,
        ],
        [0xff_ffff, 0],
    ),
    (
        [
            0x3e4e_86a0,
            0x3e44_73c0,
            0xbe8c_69c0,
            0xbf1b_d1b2,
            0x3f4c_4d4c,
            0x3d4d_6400,
            0xbf46_64de,
            0xbedb_24f8,
            0x3e90_2588,
        ],
        [0xff_fffd, 0xff_ffff],
    ),
    (
        [
            0xbf5f_4470,
            0x3f68_cee6,
            0xbef7_7cd8,
            0x3f36_75c8,
            0xbe7d_87b0,
            0xbd66_04c0,
            0xbf79_98ac,
            0xbf5e_1c58,
            0x3ea2_f17c,
        ],
        [0xff_fffe, 0],
    ),
    (
        [
            0xbdcf_3c10,
            0xbe4e_f8d0,
            0xbf13_ead0,
            0x3f24_34e4,
            0xbece_2a80,
            0x3ef8_f320,
            0xbf2a_e476,
            0xbefd_49e0,
            0x3f40_e9ce,
        ],
        [0xff_ffff, 0xff_ffff],
    ),
    (
        [
            0xbf1d_c80a,
            0xbd75_91c0,
            0x3eda_8e94,
            0x3f2f_0528,
            0x3f4f_cdd6,
            0x3f06_5ff4,
            0x3f4b_2da8,
            0xbf36_c198,
            0xbe2c_3788,
        ],
        [1, 0],
    ),
];

#[test]
fn samples_that_once_had_no_density_have_it() {
    for (bits, steps) in LOST {
        let x = bits.map(f32::from_bits);
        let v = [[x[0], x[1], x[2]], [x[3], x[4], x[5]], [x[6], x[7], x[8]]];
        let warp = TriangleOn::new(v).unwrap();
        let sample = warp.sample(steps.map(|k| k as f32 * f32::EPSILON / 2.0));
        assert_eq!(warp.pdf(sample) * warp.area(), 1.0, "{v:?}");
    }
}

fn patches<T: Tier>() {
    let mut rng = Pcg32::new(14, 4);
    let mut accepted = 0;
    for _ in 0..400_000 {
        let mut theta = [(); 2].map(|()| match rng.next_u32() % 3 {
            0 => spread(&mut rng, -80.0, -1.0).abs(),
            1 => 0.5 - spread(&mut rng, -25.0, -1.0).abs(),
            _ => 0.5 * uniform::grid(&mut rng),
        });
        if rng.next_u32() % 4 == 0 {
            theta[1] = f32::from_bits(theta[0].to_bits() + rng.next_u32() % 8).min(0.5);
        }
        theta.sort_by(f32::total_cmp);
        let (phi, width) = (centred(&mut rng), spread(&mut rng, -20.0, 0.0).abs());
        let [low, high] = theta;
        let Ok(patch) = SphericalPatch::<T>::from_turns(low, high, phi, phi + width) else {
            continue;
        };
        accepted += 1;
        let u = [edge(&mut rng), edge(&mut rng)];
        let x = patch.sample(u);
        assert!(
            patch.pdf(x) > 0.0,
            "{theta:?} {phi} {width} at {u:?}: {x:?}"
        );
    }
    assert!(accepted > 300_000);
}

#[test]
fn no_patch_has_density_zero_at_its_samples() {
    patches::<Libm>();
    patches::<Poly>();
}

/// A patch beside the lower pole has the solid angle of its mirror image beside the upper one.
#[test]
fn patches_at_both_poles_have_the_same_solid_angle() {
    for steps in [1, 2, 5, 1000] {
        let width = steps as f32 / 33_554_432.0;
        let patch = |from, to| {
            SphericalPatch::<Poly>::from_turns(from, to, 0.0, 1.0)
                .unwrap()
                .solid_angle()
        };
        let (south, north) = (patch(0.5 - width, 0.5), patch(0.0, width));
        assert!(
            (south / north - 1.0).abs() <= 5e-7,
            "{steps}: {south} {north}"
        );
    }
}

/// The first coordinate of a triangle far off, in steps of its rounding from the first vertex: the largest difference
/// between the distribution of points and the exact one at the borders of cells.
fn distance(sample: impl Fn([f32; 2]) -> f32, v: [[f32; 2]; 3]) -> f64 {
    const SIDE: u32 = 2048;
    let step = f64::from(f32::from_bits(v[0][0].to_bits() + 1) - v[0][0]);
    let truth = OnTriangle(v.map(|[x, y]| [f64::from(x), f64::from(y), 0.0]));
    let cell = |x: f64| ((x - f64::from(v[0][0])) / step).round() as usize;
    let cells = cell(f64::from(v[1][0].max(v[2][0]))) + 1;
    let (mut found, mut exact) = (vec![0_i64; cells], vec![0_i64; cells]);
    for i in 0..SIDE * SIDE {
        // Off the multiples of the grid's step, as midpoints of its cells.
        let u = [i / SIDE, i % SIDE].map(|k| (k as f32 + 0.5) / SIDE as f32);
        found[cell(f64::from(sample(u)))] += 1;
        let [a, b] = u.map(f64::from);
        exact[cell(truth.sample([a, b, 0.0, 0.0])[0])] += 1;
    }
    let mut off = (0, 0_i64);
    for (f, e) in found.into_iter().zip(exact) {
        off.1 += f - e;
        off.0 = off.0.max(off.1.abs());
    }
    off.0 as f64 / f64::from(SIDE * SIDE)
}

#[test]
fn a_small_triangle_far_off_is_flat() {
    let v = [[1e6, 1e6], [1_000_001.0, 1e6], [1_000_000.5, 1_000_001.0]];
    let warp = TriangleOn::new(v).unwrap();
    let found = distance(|u| warp.sample(u)[0], v);
    assert!(found <= 2e-6, "{found:.1e}");
    // The combination of the vertices themselves rounds three times.
    let plain = distance(
        |[u1, u2]| {
            let s = u1.sqrt();
            ((1.0 - u1) / (1.0 + s) * v[0][0] + s * u2 * v[1][0] + s * (1.0 - u2) * v[2][0])
                .clamp(v[0][0], v[1][0])
        },
        v,
    );
    assert!(plain > 5e-3, "the plain form passes: {plain:.1e}");
}

fn an_angle_has_its_density<T: Tier>() {
    for k in 1..=10_000_u16 {
        let angle = 1.2 * f32::from(k) / 1e4;
        let density = Cone::<T>::from_radians(angle).unwrap().pdf([0.0, 0.0, 1.0]);
        let solid_angle = 4.0 * PI * (f64::from(angle) / 2.0).sin().powi(2);
        let error = (f64::from(density) * solid_angle - 1.0).abs();
        // What the warp states of every cone.
        assert!(error <= 3.0e-7, "{angle}: {error}");
    }
}

#[test]
fn a_cone_of_any_angle_has_the_density_of_its_solid_angle() {
    an_angle_has_its_density::<Libm>();
    an_angle_has_its_density::<Poly>();
}

#[test]
fn a_tent_has_no_density_at_its_ends() {
    for radius in [1e-30, 0.1, 1.0, 1e30] {
        let tent = Tent::new(radius).unwrap();
        assert_eq!([-radius, radius].map(|x| tent.pdf(x)), [0.0; 2]);
        assert!(tent.pdf(radius.next_down()) > 0.0);
    }
}
