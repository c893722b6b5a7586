//! Surfaces with their normals: of any sizes, flat ones among them, whose points the position alone does not tell apart.

use host::docs::Doc;
use host::speed;
use microwarp::tier::{Libm, Poly, Tier};
use microwarp::warp::{BoxSurface, CapsuleSurface, FrustumSurface, SurfacePoint};
use microwarp::{Invert, Warp, uniform};
use rand_core::Rng;
use rand_pcg::Pcg32;
use std::f64::consts::{PI, TAU};

/// 0, or 2 to a power between two ends.
fn size(rng: &mut Pcg32, low: f32, high: f32) -> f32 {
    match rng.next_u32() % 8 {
        0 => 0.0,
        1 => 1.0,
        _ => (low + uniform::grid(rng) * (high - low)).exp2(),
    }
}

/// A uniform of the grid, often near an end.
fn edge(rng: &mut Pcg32) -> f32 {
    let u = uniform::grid(rng);
    match rng.next_u32() % 4 {
        0 => u * u * u * u,
        1 => (1.0 - u * u * u * u).min(uniform::LARGEST),
        _ => u,
    }
}

fn apart(a: f32, b: f32) -> f64 {
    let d = (f64::from(a) - f64::from(b)).abs();
    d.min(1.0 - d)
}

fn away(found: [f32; 3], exact: [f64; 3]) -> f64 {
    let square = |k: usize| (f64::from(found[k]) - exact[k]).powi(2);
    (square(0) + square(1) + square(2)).sqrt()
}

/// What the page of a surface states of its normals.
fn stated(name: &str) -> f64 {
    Doc::of("warp", name).figure_after("The normal is right to ")
}

/// The parts of a frustum that uniforms may be on, as normals; those of both sides where `f32` does not decide.
fn normals([lower, upper]: [f64; 2], height: f64, closed: bool, u: [f32; 2]) -> Vec<[f64; 3]> {
    let slant = height.hypot(lower - upper);
    let disk = |r: f64| if closed { r * r } else { 0.0 };
    let areas = [disk(lower), (lower + upper) * slant, disk(upper)];
    let all: f64 = areas.iter().sum();
    let (first, azimuth) = (f64::from(u[0]), TAU * f64::from(u[1]));
    let [p, q] = [areas[0] / all, 1.0 - areas[2] / all];
    let side = [height / slant, (lower - upper) / slant];
    let near = 1e-6;
    let mut found = Vec::new();
    if first <= p + near && areas[0] > 0.0 {
        found.push([0.0, 0.0, -1.0]);
    }
    if first >= q - near && areas[2] > 0.0 {
        found.push([0.0, 0.0, 1.0]);
    }
    if first >= p - near && first <= q + near && areas[1] > 0.0 {
        found.push([side[0] * azimuth.cos(), side[0] * azimuth.sin(), side[1]]);
    }
    found
}

/// Returns the largest error of a normal and of a round trip.
fn frustums<T: Tier>() -> [f64; 2] {
    let mut rng = Pcg32::new(21, 4);
    let (mut worst, mut accepted, mut flat) = ([0.0_f64; 2], 0, 0);
    for _ in 0..speed::of("frustums", 60_000, 1_000_000) {
        let [lower, upper, height] = [(); 3].map(|()| size(&mut rng, -30.0, 30.0));
        let closed = rng.next_u32() & 1 == 0;
        let made = if closed {
            FrustumSurface::<T>::new([lower, upper], height)
        } else {
            FrustumSurface::<T>::tube([lower, upper], height)
        };
        let Ok(warp) = made else { continue };
        accepted += 1;
        flat += u32::from(height == 0.0);
        let u = [edge(&mut rng), edge(&mut rng)];
        let point = warp.sample(u);
        let seen = format!("{lower:e} {upper:e} {height:e} {closed} at {u:?}: {point:?}");
        let pdf = warp.pdf(point);
        assert!(pdf > 0.0, "{seen}");
        let radii = [lower, upper].map(f64::from);
        let exact = normals(radii, height.into(), closed, u);
        let error = exact.iter().map(|n| away(point.normal, *n));
        let error = error.fold(f64::INFINITY, f64::min);
        worst[0] = worst[0].max(error);
        let slant = f64::from(height).hypot(radii[0] - radii[1]);
        let disks = if closed {
            radii[0].powi(2) + radii[1].powi(2)
        } else {
            0.0
        };
        let area = PI * (disks + (radii[0] + radii[1]) * slant);
        assert!(
            (f64::from(warp.area()) / area - 1.0).abs() <= 6e-7,
            "{seen}"
        );
        // By the point as it is, with its normal; narrow rings lose digits of the first uniform.
        let back = warp.invert(point);
        let side = (radii[0] + radii[1]) * slant / (disks + (radii[0] + radii[1]) * slant);
        let g = side * radii[0].max(radii[1]).max(height.into()) / slant;
        let g = if slant > 0.0 { g } else { 0.0 };
        let first = (f64::from(back[0]) - f64::from(u[0])).abs() / (1.0 + g);
        let turned = point.position[0].hypot(point.position[1]) > 1e-30;
        let second = if turned { apart(back[1], u[1]) } else { 0.0 };
        assert!(first <= 2e-6 && second <= 1e-6, "{seen} {back:?}");
        worst[1] = worst[1].max(first).max(second);
    }
    assert!(accepted > 20_000 && flat > 1_000, "{accepted} {flat}");
    worst
}

#[test]
fn frustums_keep_their_normals_and_their_inverse() {
    for (name, [normal, back]) in [("libm", frustums::<Libm>()), ("poly", frustums::<Poly>())] {
        println!("{name}: normals {normal:.2e}, round trips {back:.2e}");
        let stated = stated("FrustumSurface");
        assert!(
            normal <= stated && stated <= 2.5 * normal,
            "{name}: {normal:e}"
        );
    }
    // What is measured sees a normal of the other disk, and one that is turned.
    let exact = normals([1.0, 0.5], 2.0, true, [0.1, 0.0]);
    assert_eq!(exact, [[0.0, 0.0, -1.0]]);
    let side = normals([1.0, 0.5], 2.0, true, [0.5, 0.3]);
    let turned = normals([1.0, 0.5], 2.0, true, [0.5, 0.300_001]);
    let off = away(side[0].map(|x| x as f32), turned[0]);
    assert!(off > stated("FrustumSurface"), "{off:e}");
}

fn capsules<T: Tier>() -> f64 {
    let mut rng = Pcg32::new(22, 4);
    let mut worst = 0.0_f64;
    for _ in 0..speed::of("capsules", 60_000, 1_000_000) {
        let [mut height, mut radius] = [(); 2].map(|()| size(&mut rng, -30.0, 30.0));
        let mut u = [edge(&mut rng), edge(&mut rng)];
        if rng.next_u32() % 8 == 0 {
            // As thin as `f32` can say, at heights that make up for it.
            radius = (70.0 * uniform::grid(&mut rng) - 149.0).exp2();
            height = 2e-38 / radius * (30.0 * uniform::grid(&mut rng)).exp2();
            // On a half sphere so small that only the smallest uniforms are.
            u[0] *= radius / (height + 2.0 * radius);
        }
        let Ok(warp) = CapsuleSurface::<T>::new(height, radius) else {
            assert_eq!(radius, 0.0);
            continue;
        };
        let SurfacePoint { normal, .. } = warp.sample(u);
        let (h, r) = (f64::from(height), f64::from(radius));
        let [up, down] = [f64::from(u[0]), 1.0 - f64::from(u[0])].map(|u| u * (h + 2.0 * r));
        let q = (up.min(down) / r).min(1.0);
        let z = (1.0 - q) * if up < down { -1.0 } else { 1.0 };
        let (s, c) = (TAU * f64::from(u[1])).sin_cos();
        let ring = (q * (2.0 - q)).sqrt();
        worst = worst.max(away(normal, [ring * c, ring * s, z]));
        let area = TAU * r * (h + 2.0 * r);
        assert!((f64::from(warp.area()) / area - 1.0).abs() <= 4e-7);
    }
    worst
}

#[test]
fn capsules_keep_their_normals() {
    for (name, normal) in [("libm", capsules::<Libm>()), ("poly", capsules::<Poly>())] {
        println!("{name}: normals {normal:.2e}");
        let stated = stated("CapsuleSurface");
        assert!(
            normal <= stated && stated <= 2.5 * normal,
            "{name}: {normal:e}"
        );
    }
}

/// Boxes of all kinds: each sample on its face, and back; a flat one has two faces, which the normal tells apart.
#[test]
fn boxes_tell_their_faces_by_the_normal() {
    let mut rng = Pcg32::new(23, 4);
    let mut flat = 0;
    for _ in 0..speed::of("boxes", 100_000, 1_000_000) {
        let low = [(); 3].map(|()| size(&mut rng, -20.0, 10.0) - size(&mut rng, -20.0, 10.0));
        let high = low.map(|x| x + size(&mut rng, -20.0, 10.0));
        let Ok(warp) = BoxSurface::new(low, high) else {
            continue;
        };
        let u = [edge(&mut rng), edge(&mut rng)];
        let point = warp.sample(u);
        let seen = format!("{low:?} {high:?} at {u:?}: {point:?}");
        let side = |k: usize| f64::from(high[k]) - f64::from(low[k]);
        let k = (0..3).find(|k| point.normal[*k] != 0.0).expect("a face");
        let across = side((k + 1) % 3) * side((k + 2) % 3);
        assert!(across > 0.0, "a face without area: {seen}");
        let due = if point.normal[k] > 0.0 {
            high[k]
        } else {
            low[k]
        };
        assert_eq!(point.position[k], due, "{seen}");
        assert_eq!(
            point.normal.iter().map(|x| x.abs()).sum::<f32>(),
            1.0,
            "{seen}"
        );
        let within = (0..3).all(|k| (low[k]..=high[k]).contains(&point.position[k]));
        assert!(within && warp.pdf(point) > 0.0, "{seen}");
        let area = 2.0 * (side(0) * side(1) + side(1) * side(2) + side(2) * side(0));
        assert!(
            (f64::from(warp.area()) / area - 1.0).abs() <= 6e-7,
            "{seen}"
        );
        if side(k) == 0.0 {
            flat += 1;
            // The same position on the other face.
            let normal = point.normal.map(|x| -x);
            let other = warp.invert(SurfacePoint { normal, ..point });
            let back = warp.invert(point);
            let off = (f64::from(other[1]) - f64::from(back[1])).abs();
            assert!((off - 0.5).abs() <= 1.2e-7, "{seen}: {off}");
            assert_eq!(other[0], back[0], "{seen}");
        }
    }
    assert!(flat > 1_000, "{flat}");
    let cube = BoxSurface::new([0.0; 3], [1.0; 3]).unwrap();
    let there = |position, normal| cube.pdf(SurfacePoint { position, normal });
    assert!(there([0.5, 0.5, 1.0], [0.0, 0.0, 1.0]) > 0.0);
    assert_eq!(there([0.5, 0.5, 1.0], [0.0, 0.0, -1.0]), 0.0);
    assert_eq!(there([0.5, 0.5, 1.0], [f32::NAN; 3]), 0.0);
    assert_eq!(there([0.5, 1.5, 1.0], [0.0, 0.0, 1.0]), 0.0);
}
