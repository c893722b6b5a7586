//! The shapes of `shapes` are what is examined there, bit by bit, and in real numbers their truths.

use crate::laws::by_constructor;
use crate::linear::two_sum;
use crate::maps::mirrored;
use crate::parametric::{Form, Ring, Vertices};
use crate::programs::{DRAWS, between, kept, uniform};
use crate::search::spread;
use host::registry::{Registered, registered};
use microwarp::Warp;
use microwarp::tier::{Libm, Poly, Tier};
use microwarp::warp::{Annulus, Exponential, Ggx, PhongLobe, RegularPolygon, TriangleOn};
use std::f32::consts::TAU;

/// A number and what it has been rounded by, of a double.
fn apart(x: f64) -> (f32, f32) {
    (x as f32, (x - f64::from(x as f32)) as f32)
}

/// Turned by a small angle.
fn nudged([x, y]: [f32; 2], angle: f32) -> [f32; 2] {
    [x - angle * y, y + angle * x]
}

/// Coordinates of three vertices, of all sizes or close to one another, and what is added to sums with their offsets.
fn vertices(k: u32) -> ([f32; 3], f32) {
    let of = |i: u32| uniform(spread(7 * k + i)) - 0.5;
    let far = if k % 2 == 0 { 0.0 } else { 4.0 * of(3) };
    let all = [0, 1, 2].map(|i| far + of(i));
    let [low, high] = [f32::min, f32::max].map(|end| all.into_iter().reduce(end).expect("three"));
    let (near, reach) = (
        if low.abs() < high.abs() { low } else { high },
        low.abs().max(high.abs()),
    );
    (all, if high - low <= 0.5 * reach { near } else { 0.0 })
}

/// A point of a triangle by the program, whose first offset is so many steps off.
fn of_triangle(of: &[([f32; 3], f32); 3], [u, v]: [f32; 2], wrong: u32) -> [f32; 3] {
    of.map(|(all, anchor)| {
        let mut offsets = all.map(|x| x - anchor);
        let [low, high] =
            [f32::min, f32::max].map(|end| offsets.into_iter().reduce(end).expect("three"));
        offsets[0] = f32::from_bits(offsets[0].to_bits() + wrong);
        let form = Vertices { once_more: false };
        anchor + form.place(&offsets, &[u, 1.0 - u, v, 1.0 - v])[0].clamp(low, high)
    })
}

#[test]
fn triangles_of_vertices_have_the_form_that_is_examined() {
    let mut noticed = 0;
    for k in 0..*DRAWS {
        let of = [0, 1, 2].map(|i| vertices(3 * k + i));
        let corners = [0, 1, 2].map(|i| of.map(|(all, _)| all[i]));
        let Ok(triangle) = TriangleOn::new(corners) else {
            continue;
        };
        let u = [k, k + *DRAWS].map(uniform);
        assert_eq!(
            triangle.sample(u),
            of_triangle(&of, u, 0),
            "{corners:?} {u:?}"
        );
        noticed += u32::from(triangle.sample(u) != of_triangle(&of, u, 1));
    }
    assert!(
        noticed > *DRAWS / 4,
        "{noticed} differ by a step of a coordinate"
    );
}

/// A point of a ring's sector, whose area is so many steps off.
fn of_ring<T: Tier>(ring: &Annulus<T>, [u1, u2]: [f32; 2], wrong: u32) -> [f32; 2] {
    let [low, high, area, scale, start, width, rest] =
        ["low", "high", "area", "scale", "start", "width", "rest"].map(|name| kept(ring, name));
    let area = f32::from_bits(area.to_bits() + wrong);
    let r = Ring.place(&[low, area], &[u1, 1.0 - u1])[0].min(high);
    let (turn, dropped) = two_sum(start, u2 * width);
    let ((s, c), r) = (mirrored::<T>(turn), r * scale);
    nudged([r * c, r * s], (dropped + u2 * rest) * TAU)
}

/// A normal by the operations that are examined.
fn of_ggx<T: Tier>([ax, ay]: [f32; 2], [u1, u2]: [f32; 2]) -> [f32; 3] {
    let ((s, c), root) = (mirrored::<T>(u2), u1.sqrt());
    let [x, y, z] = [ax * (root * c), ay * (root * s), (1.0 - u1).sqrt()];
    let length = (x * x + y * y + z * z).sqrt();
    [x / length, y / length, z / length]
}

/// A point of a regular polygon by the operations that are examined, with an apothem so many steps off.
fn of_polygon<T: Tier>(
    polygon: &RegularPolygon<T>,
    corners: u16,
    [u1, u2]: [f32; 2],
    wrong: u32,
) -> [f32; 2] {
    let [apothem, half_side] = ["apothem", "half_side"].map(|name| kept(polygon, name));
    let apothem = f32::from_bits(apothem.to_bits() + wrong);
    let corners = f32::from(corners);
    let (place, dropped) = apart(f64::from(u2) * f64::from(corners));
    let (side, along) = (place.floor(), (place - place.floor()) + dropped);
    let (side, along) = if along < 0.0 {
        (side - 1.0, along + 1.0)
    } else {
        (side, along)
    };
    let root = u1.sqrt();
    let (out, across) = (root * apothem, root * (half_side * (2.0 * along - 1.0)));
    let (parts, of) = (side + side + 1.0, corners + corners);
    let turn = parts / of;
    let left = (f64::from(parts) - f64::from(turn) * f64::from(of)) as f32;
    let (s, c) = mirrored::<T>(turn);
    nudged(
        [out * c - across * s, out * s + across * c],
        left / of * TAU,
    )
}

fn shapes_are_what_is_examined<T: Tier>() {
    let mut noticed = [0, 0];
    for k in 0..*DRAWS {
        // Rounding errors of a phase that are themselves no numbers of f32 turn no point.
        let u = [uniform(k), uniform(k + *DRAWS).max(1e-12)];
        let inner = uniform(k + 1);
        let outer = inner + between(k, 1e-6, 1e6);
        let from = 2.0 * uniform(k + 2).max(1e-9) - 1.0;
        let ring = Annulus::<T>::sector(inner, outer, from, from + between(k + 3, 1e-3, 0.99))
            .expect("a ring");
        assert_eq!(ring.sample(u), of_ring(&ring, u, 0), "{ring:?} {u:?}");
        noticed[0] += u32::from(ring.sample(u) != of_ring(&ring, u, 1));
        let [low, high, area] = ["low", "high", "area"].map(|name| f64::from(kept(&ring, name)));
        assert!(
            (area / ((high - low) * (high + low)) - 1.0).abs() <= 1.001 * crate::rounding::UNIT
        );

        let alpha = [k + 4, k + 5].map(|k| between(k, 1e-4, 1.0));
        let ggx = Ggx::<T>::new(alpha).expect("a roughness");
        assert_eq!(ggx.sample(u), of_ggx::<T>(alpha, u), "{alpha:?} {u:?}");

        let n = between(k + 6, 1e-6, 1e9);
        let log = T::neg_ln_1m(u[0]);
        assert_eq!(
            Exponential::<T>::from_rate(1.0)
                .expect("a law")
                .sample(u[0]),
            log
        );
        let ((cos, rest), (s, c)) = (T::exp_neg_pair(log / (n + 1.0)), mirrored::<T>(u[1]));
        let sin = (rest * (1.0 + cos)).sqrt();
        let lobe = PhongLobe::<T>::new(n).expect("a lobe");
        // Where less is left of 1 the sine comes by another way, and is below 2⁻⁴⁹.
        if rest >= 8e-31 {
            assert_eq!(lobe.sample(u), [sin * c, sin * s, cos], "{n} {u:?}");
        }

        let corners = (3 + spread(k) % if k % 2 == 0 { 9 } else { 65_533 }) as u16;
        let polygon = RegularPolygon::<T>::new(corners).expect("a polygon");
        let (is, due) = (polygon.sample(u), of_polygon(&polygon, corners, u, 0));
        assert_eq!(is, due, "{corners} {u:?}");
        noticed[1] += u32::from(is != of_polygon(&polygon, corners, u, 1));
    }
    assert!(
        noticed.iter().all(|count| *count > *DRAWS / 4),
        "{noticed:?} differ"
    );
}

#[test]
fn shapes_have_the_form_that_is_examined() {
    shapes_are_what_is_examined::<Libm>();
    shapes_are_what_is_examined::<Poly>();
}

/// Holds what is made in real numbers to what the registry calls the truth.
fn assert_truth(of: &Registered, p: &[f32], u: [f64; 2], made: &[f64], size: f64) {
    let due = (of.build)(p)
        .expect("accepted parameters")
        .truth
        .sample([u[0], u[1], 0.0, 0.0]);
    let apart = made.iter().zip(due).map(|(x, due)| (x - due).abs());
    assert!(
        apart.fold(0.0, f64::max) <= 1e-10 * size,
        "{} {p:?} {u:?}: {made:?} {due:?}",
        of.name
    );
}

#[test]
fn shapes_in_real_numbers_are_the_truth() {
    let all = registered();
    let find = |name, constructor| by_constructor(&all, name, constructor);
    let turned = |[x, y]: [f64; 2], turns: f64| {
        let (s, c) = (std::f64::consts::TAU * turns).sin_cos();
        [x * c - y * s, x * s + y * c]
    };
    for k in 0..*DRAWS {
        let [u, v] = [k, k + *DRAWS].map(|k| f64::from(uniform(k)));
        let of = [0, 1, 2].map(|i| vertices(3 * k + i).0);
        let flat: Vec<f32> = (0..3).flat_map(|i| of.map(|all| all[i])).collect();
        let corners = [0, 1, 2].map(|i| of.map(|all| all[i]));
        if TriangleOn::new(corners).is_ok() {
            let form = Vertices { once_more: false };
            let point = of.map(|all| form.place(&all.map(f64::from), &[u, 1.0 - u, v, 1.0 - v])[0]);
            assert_truth(find("TriangleOn", "space"), &flat, [u, v], &point, 4.0);
        }
        let p = [between(k, 1e-3, 1.0), 1.5, 0.5 * uniform(k + 1) - 0.5, 0.25];
        let [inner, outer, from, to] = p.map(f64::from);
        let r = Ring.place(&Ring.fields(&[inner / outer, outer]), &[u, 1.0 - u])[0];
        assert_truth(
            find("Annulus", "sector"),
            &p,
            [u, v],
            &turned([r, 0.0], from + v * (to - from)),
            1.0,
        );

        let p = [k + 2, k + 3].map(|k| between(k, 1e-4, 1.0));
        let [[x, y], z] = [turned([u.sqrt(), 0.0], v), [(1.0 - u).sqrt(); 2]];
        let [x, y, z] = [x * f64::from(p[0]), y * f64::from(p[1]), z[0]];
        let length = (x * x + y * y + z * z).sqrt();
        assert_truth(
            find("Ggx", ""),
            &p,
            [u, v],
            &[x, y, z].map(|x| x / length),
            1.0,
        );

        let n = between(k + 4, 1e-6, 1e9);
        let x = -(-u).ln_1p() / (f64::from(n) + 1.0);
        let ([a, b], c) = (turned([(-(-2.0 * x).exp_m1()).sqrt(), 0.0], v), (-x).exp());
        assert_truth(find("PhongLobe", ""), &[n], [u, v], &[a, b, c], 1.0);

        let n = 3 + spread(k) % 100;
        let (half, place) = (std::f64::consts::PI / f64::from(n), v * f64::from(n));
        let across = half.sin() * (2.0 * place.fract() - 1.0);
        let point = [half.cos(), across].map(|x| x * u.sqrt());
        let point = turned(point, (place.floor() + 0.5) / f64::from(n));
        assert_truth(find("RegularPolygon", ""), &[n as f32], [u, v], &point, 1.0);
    }
}
