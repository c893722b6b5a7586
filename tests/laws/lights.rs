//! Lights seen from a point: what their densities integrate to, the irradiance that they estimate, and the weights of a cosine.

use host::speed;
use host::truth::{self, Point, Truth, lambert};
use microwarp::tier::{Libm, Poly, Tier};
use microwarp::warp::{SphericalRectangle, SphericalTriangle};
use microwarp::{Error, Invert, Warp, uniform};
use rand_pcg::Pcg32;
use std::f64::consts::TAU;

/// A light: its warp, and its corners in order.
struct Light {
    warp: Box<dyn Warp<Uniforms = [f32; 2], Point = [f32; 3], Density = f32>>,
    corners: Vec<Point>,
}

fn triangle<T: Tier>(point: [f32; 3], vertices: [[f32; 3]; 3]) -> Light {
    let warp = SphericalTriangle::<T>::new(point, vertices).unwrap();
    Light {
        warp: Box::new(warp),
        corners: vertices.map(|v| from(point, v)).into(),
    }
}

fn rectangle<T: Tier>(point: [f32; 3], corner: [f32; 3], edges: [[f32; 3]; 2]) -> Light {
    let warp = SphericalRectangle::<T>::new(point, corner, edges).unwrap();
    let sum = |p: Point, q: [f32; 3]| [0, 1, 2].map(|k| p[k] + f64::from(q[k]));
    let apex = from(point, corner);
    let [x, y] = edges.map(|edge| sum(apex, edge));
    Light {
        warp: Box::new(warp),
        corners: vec![apex, x, sum(x, edges[1]), y],
    }
}

fn from(point: [f32; 3], vertex: [f32; 3]) -> Point {
    [0, 1, 2].map(|k| f64::from(vertex[k]) - f64::from(point[k]))
}

/// A triangle and a rectangle above the point, at a height.
fn above<T: Tier>(height: f32) -> [Light; 2] {
    let h = height;
    [
        triangle::<T>(
            [0.1, 0.2, 0.0],
            [[1.0, 0.0, h], [-0.5, 0.9, h], [-0.5, -0.9, h]],
        ),
        rectangle::<T>(
            [0.1, 0.2, 0.0],
            [0.5, -0.7, h],
            [[0.0, 1.4, 0.0], [-1.0, 0.0, 0.0]],
        ),
    ]
}

/// From afar to as close as directions have three digits.
const HEIGHTS: [f32; 4] = [1.0, 0.05, 0.004, 0.001];

/// The irradiance that a grid of uniforms estimates with a density.
fn irradiance(light: &Light, density: impl Fn([f32; 3], f32) -> f64) -> f64 {
    let n = speed::of("uniforms a side of a light", 450, 1_400);
    let middle = |k: i32| (k as f32 + 0.5) / n as f32;
    let mut sum = 0.0;
    for i in 0..n {
        for j in 0..n {
            let (direction, pdf) = light.warp.sample_with_pdf([middle(i), middle(j)]);
            sum += f64::from(direction[2]) / density(direction, pdf);
        }
    }
    sum / f64::from(n * n)
}

/// The density that a direction has where area is sampled.
fn of_area(light: &Light, x: [f32; 3]) -> f64 {
    let [a, b, .., c] = light.corners[..] else {
        unreachable!()
    };
    let edge = |p: Point| [0, 1, 2].map(|k| p[k] - a[k]);
    let normal = truth::cross(edge(b), edge(c));
    let facing = truth::dot(normal, x.map(f64::from));
    let distance = truth::dot(normal, a) / facing;
    let halves = (light.corners.len() - 2) as f64;
    2.0 / halves * distance * distance / facing.abs()
}

fn unbiased<T: Tier>() {
    for height in HEIGHTS {
        for light in above::<T>(height) {
            let exact = lambert(&light.corners, [0.0, 0.0, 1.0]);
            let relative = |found: f64| (found / exact - 1.0).abs();
            let with = relative(irradiance(&light, |_, pdf| f64::from(pdf)));
            let of = relative(irradiance(&light, |x, _| f64::from(light.warp.pdf(x))));
            let mixed = relative(irradiance(&light, |x, _| of_area(&light, x)));
            println!(
                "{} at {height}: {with:.1e}, {of:.1e}, mixed {mixed:.1e}",
                T::NAME
            );
            assert!(with <= 1e-3 && of <= 1e-3, "{height}: {with} {of}");
            assert!(
                mixed > 0.02,
                "{height}: the density of area passes, {mixed}"
            );
        }
    }
}

#[test]
fn irradiance_is_that_of_lambert_at_every_height() {
    unbiased::<Poly>();
    unbiased::<Libm>();
}

/// The integral of the density over all directions, in logarithmic rings about the horizon.
fn integral(light: &Light) -> f64 {
    let (rings, turns) = speed::of("rings and turns", (800, 500), (4_000, 2_000));
    let deepest = 14.0;
    let mut sum = 0.0;
    for i in 0..rings {
        let z = (-deepest * (f64::from(i) + 0.5) / f64::from(rings)).exp();
        let sine = (1.0 - z * z).sqrt();
        for j in 0..turns {
            let (s, c) = (TAU * (f64::from(j) + 0.5) / f64::from(turns)).sin_cos();
            for up in [z, -z] {
                let direction = [sine * c, sine * s, up].map(|x| x as f32);
                sum += z * f64::from(light.warp.pdf(direction));
            }
        }
    }
    sum * deepest / f64::from(rings) * TAU / f64::from(turns)
}

#[test]
fn densities_integrate_to_one() {
    for height in HEIGHTS {
        for light in above::<Poly>(height) {
            let whole = integral(&light);
            println!("at {height}: {whole}");
            assert!((whole - 1.0).abs() <= 4e-3, "{height}: {whole}");
        }
    }
}

/// Small lights about a direction: from 1e-13 sr, a size of 3e-7, to 1e-3 of the distance.
#[test]
fn small_lights_hold_their_samples_and_nothing_that_is_clearly_outside() {
    let mut rng = Pcg32::new(3, 5);
    let mut unit = || 2.0 * uniform::grid(&mut rng) - 1.0;
    for _ in 0..speed::of("small lights", 20_000, 400_000) {
        let size = 10f32.powf(-4.7 + 1.8 * unit());
        let point = [unit(), unit(), unit() - 2.0];
        let mut vertex = || [0, 1, 2].map(|_| size * unit());
        let vertices = [vertex(), vertex(), vertex()];
        let Ok(light) = SphericalTriangle::<Poly>::new(point, vertices) else {
            continue;
        };
        for u in [[0.0, 0.0], [0.3, 0.7], [1.0, 0.0], [1.0, 1.0], [0.9, 0.5]] {
            let there = light.locate(u);
            assert!(
                light.pdf(there.direction) > 0.0,
                "{point:?} {vertices:?} {u:?}"
            );
            // Where the barycentric coordinates place it, within the triangle.
            assert!(there.barycentric.iter().all(|b| (0.0..=1.0).contains(b)));
        }
        let [x, y, z] = light.sample([0.5, 0.5]);
        assert_eq!(light.pdf([-x, -y, -z]), 0.0, "{point:?} {vertices:?}");
        // Beyond a sharp corner the rounding of two sides reaches far.
        let exact = truth::Light::triangle(point, vertices).variables();
        if exact
            .iter()
            .any(|(name, h)| *name == "h" && *h < 0.05 * f64::from(size))
        {
            continue;
        }
        let off = 4.0 * size + 1e-4;
        // At right angles to the direction, whichever coordinate is the smallest.
        let side = truth::cross([x, y, z].map(f64::from), [0.577, 0.577, -0.577]);
        let norm = truth::dot(side, side).sqrt().max(1e-3);
        let aside =
            [0, 1, 2].map(|k| (f64::from([x, y, z][k]) + side[k] / norm * f64::from(off)) as f32);
        assert_eq!(light.pdf(aside), 0.0, "{point:?} {vertices:?}");
    }
}

#[test]
fn weights_of_a_cosine_are_those_of_the_corners() {
    let triangle = SphericalTriangle::<Poly>::new(
        [0.0; 3],
        [[0.0, 0.0, 2.0], [3.0, 0.0, 4.0], [0.0, 4.0, -3.0]],
    )
    .unwrap();
    let near = |a: [[f32; 2]; 2], b: [[f32; 2]; 2]| {
        let pairs = a.as_flattened().iter().zip(b.as_flattened());
        pairs.into_iter().all(|(a, b)| (a - b).abs() <= 2e-7)
    };
    let up = triangle.cosine_weights([0.0, 0.0, 7.0]).unwrap();
    assert!(near(up, [[1.0, 0.8], [1.0, 0.0]]), "{up:?}");
    assert_eq!(
        triangle.cosine_weights([-1.0, -1.0, 0.0]),
        Err(Error::AllZero)
    );
    assert_eq!(triangle.cosine_weights([0.0; 3]), Err(Error::ZeroLength(0)));
    assert_eq!(
        triangle.cosine_weights([f32::NAN, 0.0, 0.0]),
        Err(Error::NotFinite(0))
    );
    let corner = [-1.0, -1.0, 1.0];
    let edges = [[2.0, 0.0, 0.0], [0.0, 2.0, 0.0]];
    let rectangle = SphericalRectangle::<Poly>::new([0.0; 3], corner, edges).unwrap();
    let third = 1.0 / 3f32.sqrt();
    let up = rectangle.cosine_weights([0.0, 0.0, 1.0]).unwrap();
    assert!(near(up, [[third; 2]; 2]), "{up:?}");
    // Only the fourth corner is above this horizon, and then none is.
    let last = rectangle.cosine_weights([1.0, 1.0, -1.5]).unwrap();
    let (low, high) = (0.0, 0.5 * third / (4.25_f32 / 4.0).sqrt() / 2.0);
    assert!(near(last, [[low, high], [low, high]]), "{last:?} {high}");
    assert_eq!(
        rectangle.cosine_weights([0.0, 0.0, -1.0]),
        Err(Error::AllZero)
    );
}

/// The lights of the floors that the form is held to: tiny ones, slivers, from the edge, and close to the inside.
#[test]
fn directions_keep_their_digits_in_every_setting() {
    let mut worst = [[0.0_f64; 2]; 5];
    let mut rng = Pcg32::new(11, 4);
    for k in 0..speed::of("settings", 20_000, 1_000_000) {
        let mut unit = || 2.0 * uniform::grid(&mut rng) - 1.0;
        let mut vector = |size: f32| [0, 1, 2].map(|_| size * unit());
        let flat = |p: [f32; 3]| [p[0], p[1], 0.0];
        let (point, vertices) = match k % 5 {
            0 => (vector(1.0), [vector(1.0), vector(1.0), vector(1.0)]),
            1 => {
                let size = (7.0 * vector(1.0)[0] - 8.0).exp();
                (vector(1.0), [vector(size), vector(size), vector(size)])
            }
            2 => {
                let ([a, b], off, part) = (
                    [vector(1.0), vector(1.0)],
                    vector(1e-4),
                    vector(1.0)[0].abs(),
                );
                let between = [0, 1, 2].map(|k| a[k] + part * (b[k] - a[k]) + off[k]);
                ([0.0; 3], [a, b, between])
            }
            3 => {
                let height = (2.3 * vector(1.0)[0] - 13.8).exp();
                let vertices = [vector(1.0), vector(1.0), vector(1.0)].map(flat);
                ([3.0 + vector(1.0)[0], vector(1.0)[1], height], vertices)
            }
            _ => {
                let height = (3.0 * vector(1.0)[0] - 4.0).exp();
                let at = vector(0.1);
                let vertices = [[1.0, 0.0, 0.0], [-0.5, 0.866, 0.0], [-0.5, -0.866, 0.0]];
                ([at[0], at[1], height], vertices)
            }
        };
        let Ok(warp) = SphericalTriangle::<Poly>::new(point, vertices) else {
            continue;
        };
        let exact = truth::Light::triangle(point, vertices);
        let mut uniform = || uniform::grid(&mut rng);
        let u = [uniform(), uniform()];
        let due = exact.sample([u[0].into(), u[1].into(), 0.0, 0.0]);
        let found = warp.sample(u).map(f64::from);
        let nearness = exact.variables()[0].1;
        let [area, off] = &mut worst[k % 5];
        let error = (f64::from(warp.solid_angle()) / exact.solid_angle() - 1.0).abs();
        *area = area.max(error / (2.0 + nearness));
        let away = [0, 1, 2].map(|k| found[k] - due[k]);
        *off = off.max(truth::dot(away, away).sqrt() / nearness);
        assert!(*off <= 6e-7, "{off:e}: {point:?} {vertices:?} {u:?}");
    }
    let names = ["any", "small", "slivers", "from the edge", "close"];
    for (name, [area, off]) in names.iter().zip(worst) {
        println!("{name}: solid angle {area:.1e} (2 + q), directions {off:.1e} q");
        assert!(area <= 3e-7, "{name}: {area}");
    }
}

/// A light and a point by the number of the setting: on the plane, on edges, on a corner, over the inside down to 2⁻³⁰, far
/// off, all at scales from 2⁻⁵⁰ to 2⁵⁰.
fn hard(k: usize, rng: &mut Pcg32) -> ([f32; 3], [[f32; 3]; 3]) {
    let mut unit = || 2.0 * uniform::grid(rng) - 1.0;
    let scale = (50.0 * unit()).round().exp2();
    let mut vector = || [0, 1, 2].map(|_| unit());
    let [mut corner, mut x, mut y] = [vector(), vector(), vector()];
    let aside = vector();
    if k % 2 == 0 {
        (corner[2], x[2], y[2]) = (0.25, 0.0, 0.0);
    }
    let [s, t, height] = match k % 8 {
        0 | 1 => [2.0 * aside[0], 2.0 * aside[1], 0.0],
        2 => [0.5 + 0.5 * aside[0], 0.0, 0.0],
        3 => [0.0, 1.0, (-30.0 * aside[2].abs()).exp2()],
        4 => [1.0, 0.0, 0.0],
        5 | 6 => [0.3, 0.3, (-30.0 * aside[2].abs()).exp2()],
        _ => [1e3 * aside[0], 1e3 * aside[1], 1e3 * aside[2]],
    };
    let off = [0.1 * aside[1] * height, 0.1 * aside[0] * height, height];
    let point = [0, 1, 2].map(|k| corner[k] + s * x[k] + t * y[k] + off[k]);
    (
        point.map(|x| x * scale),
        [corner, x, y].map(|v| v.map(|x| x * scale)),
    )
}

/// Whether what a light gives for a sample is valid: the direction, its density with the sample and by itself, the place, the
/// uniforms that lead back.
fn is_valid(direction: [f32; 3], densities: [f32; 2], place: &[f32], back: [f32; 2]) -> bool {
    let wide = direction.map(f64::from);
    let length = (truth::dot(wide, wide).sqrt() - 1.0).abs();
    let [density, same] = densities;
    let good = |x: &f32| (0.0..=1.0).contains(x);
    length <= 2e-7
        && density > 0.0
        && density.is_finite()
        && same.to_bits() == density.to_bits()
        && place.iter().all(good)
        && back.iter().all(good)
}

/// Whether the density alone is refused for the same reason as the light, or else is a density, too.
fn agree(density: Result<f32, Error>, alone: Result<f32, Error>) -> bool {
    match (density, alone) {
        (Ok(_), Ok(alone)) => alone > 0.0 && alone.is_finite(),
        (Err(light), Err(alone)) => light == alone,
        _ => false,
    }
}

/// Whether a triangle is seen; then its sample is valid.
fn seen_triangle(point: [f32; 3], vertices: [[f32; 3]; 3], u: [f32; 2]) -> bool {
    let light = SphericalTriangle::<Poly>::new(point, vertices);
    let alone = SphericalTriangle::<Poly>::density_of(point, vertices);
    assert!(agree(light.map(|light| light.density()), alone));
    light.is_ok_and(|light| {
        let there = light.locate(u);
        let densities = [there.pdf, light.pdf(there.direction)];
        let back = light.invert(there.direction);
        assert!(
            is_valid(there.direction, densities, &there.barycentric, back),
            "{there:?} {densities:?} {back:?}: {point:?} {vertices:?} {u:?}"
        );
        true
    })
}

/// The same of a rectangle.
fn seen_rectangle(point: [f32; 3], corner: [f32; 3], edges: [[f32; 3]; 2], u: [f32; 2]) -> bool {
    let light = SphericalRectangle::<Poly>::new(point, corner, edges);
    let alone = SphericalRectangle::<Poly>::density_of(point, corner, edges);
    assert!(agree(light.map(|light| light.density()), alone));
    light.is_ok_and(|light| {
        let there = light.locate(u);
        let densities = [there.pdf, light.pdf(there.direction)];
        let back = light.invert(there.direction);
        assert!(
            is_valid(there.direction, densities, &there.st, back),
            "{there:?} {densities:?} {back:?}: {point:?} {corner:?} {edges:?} {u:?}"
        );
        true
    })
}

/// A light is refused, or all that it gives is valid.
#[test]
fn whatever_the_point_a_light_is_refused_or_valid() {
    let mut rng = Pcg32::new(5, 7);
    let (mut seen, mut refused) = (0, 0);
    for k in 0..speed::of("hard lights", 100_000, 4_000_000) {
        let (point, [corner, x, y]) = hard(k, &mut rng);
        let mut uniform = || uniform::grid(&mut rng);
        let u = match k % 3 {
            0 => [uniform(), uniform()],
            1 => [1.0 - 1e-5 * uniform(), 0.0],
            _ => [uniform(), 1.0],
        };
        let other = |edge: [f32; 3]| [0, 1, 2].map(|k| corner[k] + edge[k]);
        // A side far shorter than the others, across from the first vertex.
        let short = 1e-3 * uniform();
        let third = [0, 1, 2].map(|k| corner[k] + x[k] + short * y[k]);
        for light in [
            seen_triangle(point, [corner, other(x), other(y)], u),
            seen_triangle(point, [corner, other(x), third], [1.0 - 1e-6 * u[0], u[1]]),
            seen_rectangle(point, corner, [x, y], u),
        ] {
            *if light { &mut seen } else { &mut refused } += 1;
        }
    }
    println!("{seen} lights, {refused} refused");
    assert!(seen > 0 && refused > 0);
    // What disagrees is noticed.
    let reasons = [Error::Empty(0), Error::NotNormalizable(0)];
    assert!(!agree(Ok(1.0), Err(reasons[0])) && !agree(Err(reasons[0]), Ok(1.0)));
    assert!(!agree(Err(reasons[0]), Err(reasons[1])) && !agree(Ok(1.0), Ok(f32::NAN)));
}

/// Lights whose samples had the density 0: by a short side as the difference of two long ones, and as thin ones that are not.
#[test]
fn lights_close_to_a_corner_hold_their_samples() {
    let short = [
        [0.0, 0.685_387_13, 0.434_981],
        [0.001_487_560_8, -5.723_265_4e-7, -1.931_348_6e-10],
        [0.001_387_175_4, 0.000_118_080_02, -0.000_114_193_29],
    ];
    let point = [-3.374_303_9e-12, 0.0, 0.000_245_040_72];
    assert!(seen_triangle(point, short, [0.999_999_94, 0.999_999_9]));
    let wide = [
        [0.000_676_762_7, 2.574_766_8e-12, -0.920_582_4],
        [0.220_916_51, 9.633_087e-6, 0.883_860_6],
        [0.182_811_29, 7.966_4e-6, 0.557_833_8],
    ];
    let point = [0.215_406_28, 0.000_147_024_23, 0.837_386_7];
    assert!(seen_triangle(point, wide, [0.0, 0.0]));
    let corner = [4.484_983_5e-9, 1.0, 0.059_467_435];
    let edges = [
        [-4.484_983_5e-9, -1.0, -0.059_467_435],
        [0.244_213_82, -1.957_674_7, -0.059_467_435],
    ];
    let point = [0.244_213_82, -0.957_679, 4.543_207_4e-12];
    for k in 0..10_000_u16 {
        let [i, j] = [k / 100, k % 100].map(|i| f32::from(i) / 100.0);
        assert!(seen_rectangle(point, corner, edges, [i * i * i * i, j]));
    }
}

/// A light is the same at every size: products of three lengths overflowed from 2⁴³ on.
#[test]
fn lights_are_the_same_at_every_size() {
    let (vertices, edges) = (
        [[1.0, -0.5, 0.05], [1.0, 0.5, 0.05], [2.0, 0.1, 0.05]],
        [[0.0, 1.0, 0.0], [1.0, 0.0, 0.0]],
    );
    let [corner, ..] = vertices;
    for exponent in -58..=59_i16 {
        let scale = f32::from(exponent).exp2();
        let scaled = |v: [f32; 3]| v.map(|x| scale * x);
        let triangle = SphericalTriangle::<Poly>::new([0.0; 3], vertices.map(scaled)).unwrap();
        let rectangle =
            SphericalRectangle::<Poly>::new([0.0; 3], scaled(corner), edges.map(scaled)).unwrap();
        let of_one = (
            SphericalTriangle::<Poly>::new([0.0; 3], vertices).unwrap(),
            SphericalRectangle::<Poly>::new([0.0; 3], corner, edges).unwrap(),
        );
        let u = [0.25, 0.75];
        let same = (triangle.sample(u), rectangle.sample(u));
        assert_eq!(
            same,
            (of_one.0.sample(u), of_one.1.sample(u)),
            "2^{exponent}"
        );
        let angles = [triangle.solid_angle(), rectangle.solid_angle()];
        assert_eq!(
            angles,
            [of_one.0.solid_angle(), of_one.1.solid_angle()],
            "2^{exponent}"
        );
    }
    // All that the page promises, and more than it does.
    let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let of = |scale: f32| axes.map(|v| v.map(|x| scale * x));
    assert!(seen_triangle([0.0; 3], of(60.0_f32.exp2()), [0.5, 0.5]));
    let huge = SphericalTriangle::<Poly>::new([0.0; 3], of(62.0_f32.exp2()));
    assert_eq!(huge.err(), Some(Error::TooLarge(1)));
}

/// A thin light whose sample is carried over a side by its rounding: clamped without being moved back, its first uniform was
/// off by .017.
#[test]
fn a_sample_beside_a_thin_light_keeps_its_first_uniform() {
    let of = |words: [u32; 3]| words.map(f32::from_bits);
    let light = SphericalTriangle::<Poly>::new(
        of([0xbfa3_50a5, 0xc07b_6a08, 0xbea8_f4c8]),
        [
            of([0xbb61_6500, 0xc019_7492, 0xbf76_a7f0]),
            of([0xbd8c_4bf8, 0xc024_806a, 0xbf84_864a]),
            of([0xbfac_ec38, 0xc07e_ec1c, 0xbe81_c60d]),
        ],
    )
    .unwrap();
    let u = [0x3f7f_ffc0, 0x3222_61eb].map(f32::from_bits);
    let [first, _] = light.invert(light.sample(u));
    assert!((first - u[0]).abs() <= 1e-4, "{first} for {}", u[0]);
}
