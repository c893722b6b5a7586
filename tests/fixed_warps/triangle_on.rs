//! Triangles on vertices.

use crate::figures::{Figures, WORD, hold, over_pairs};
use fixed::FixedI32;
use fixed::types::extra::{LeEqU32, U0, U16};
use fixed::types::{I16F16, I32F0, U0F32};
use microwarp::fixed::warp::TriangleOn;
use microwarp::fixed::{Coarse, Compact, Fine, Grade};
use microwarp::{Error, Invert, Warp};

const PAIRS: u64 = 1 << 16;

fn new<Frac: LeEqU32, const D: usize, G: Grade>(vertices: [[i32; D]; 3]) -> TriangleOn<Frac, D, G> {
    TriangleOn::new(vertices.map(|v| v.map(FixedI32::from_bits))).unwrap()
}

fn weights([u, v]: [u32; 2]) -> [f64; 3] {
    let (s, v) = ((f64::from(u) * WORD).sqrt(), f64::from(v) * WORD);
    [1.0 - s, s * v, s * (1.0 - v)]
}

/// Points against the truth, of the extent of a coordinate beyond half a step; inside the box, of the density that
/// the area has, and with an inverse that leads back.
fn sample_error<const D: usize, G: Grade>(vertices: [[i32; D]; 3]) -> Figures {
    let warp = new::<U16, D, G>(vertices);
    let [a, b, c] = vertices;
    let low: Vec<i32> = (0..D).map(|k| a[k].min(b[k]).min(c[k])).collect();
    let high: Vec<i32> = (0..D).map(|k| a[k].max(b[k]).max(c[k])).collect();
    let density = density(vertices) * 2_f64.powi(32);
    over_pairs(PAIRS, |pair, observe| {
        let point = warp.sample(pair.map(U0F32::from_bits));
        let [u, v, w] = weights(pair);
        for k in 0..D {
            let x = point[k].to_bits();
            assert!((low[k]..=high[k]).contains(&x), "{vertices:?} {pair:x?}");
            let due = f64::from(a[k]) * u + f64::from(b[k]) * v + f64::from(c[k]) * w;
            let extent = f64::from(high[k]) - f64::from(low[k]);
            let error = (f64::from(x) - due).abs() - 0.5;
            if extent > 0.0 {
                observe(error.max(0.0) / extent);
            }
        }
        let got = warp.pdf(point).to_num::<f64>();
        assert!(got > 0.0, "{vertices:?} {pair:x?}");
        assert!(
            (got - density.max(WORD)).abs() <= WORD + 1e-8 * density,
            "{got} for {density}"
        );
        let again = warp.sample(warp.invert(point));
        for k in 0..D {
            // Steps that a grade's error in a root is, and those of a point off the plane by its own rounding.
            let extent = f64::from(high[k]) - f64::from(low[k]);
            let off = f64::from(again[k].to_bits()) - f64::from(point[k].to_bits());
            let bound = 3.0 + 4e-5 * extent;
            assert!(off.abs() <= bound, "{vertices:?} {pair:x?}: {off}, {bound}");
        }
    })
}

/// 1/area in steps, by exact minors.
fn density<const D: usize>([a, b, c]: [[i32; D]; 3]) -> f64 {
    let side = |v: [i32; D], k: usize| i128::from(v[k]) - i128::from(a[k]);
    let mut squares = 0.0;
    for i in 0..D {
        for j in 0..i {
            let minor = side(b, i) * side(c, j) - side(b, j) * side(c, i);
            squares += (minor as f64).powi(2);
        }
    }
    2.0 / squares.sqrt()
}

const FLAT: [[[i32; 2]; 3]; 5] = [
    [[0, 0], [4 << 16, 0], [0, 2 << 16]],
    [[-7, 3], [5, 3], [1, 9]],
    [[i32::MIN, 0], [-2, i32::MAX], [-1, 0]],
    [[0, 0], [i32::MAX, i32::MAX], [i32::MAX, i32::MAX - 3000]],
    [
        [1 << 30, -(1 << 30)],
        [1 << 30, (1 << 30) - 1],
        [-(1 << 30) + 1, 5],
    ],
];

const SOLID: [[[i32; 3]; 3]; 4] = [
    [[0, 0, 0], [4 << 16, 0, 1 << 16], [0, 2 << 16, 3 << 16]],
    [[-7, 3, 2], [50, 3, -40], [1, 90, 7]],
    [[i32::MIN, 0, 3], [-2, i32::MAX, 1 << 30], [-1, 0, 5]],
    [[7, 1 << 20, 0], [7, 0, 1 << 24], [7, 1 << 22, 1 << 26]],
];

fn worst<G: Grade>() -> f64 {
    let flat = FLAT.map(sample_error::<2, G>);
    let solid = SOLID.map(sample_error::<3, G>);
    flat.iter().chain(&solid).map(|f| f.max).fold(0.0, f64::max)
}

#[test]
fn a_point_is_in_the_box_right_to_a_step_and_of_the_area_s_density() {
    let worst = [worst::<Fine>(), worst::<Coarse>(), worst::<Compact>()];
    hold("TriangleOn", &[("sample, max", worst)]);
}

#[test]
fn four_dimensions_are_no_obstacle() {
    let figures = sample_error::<4, Fine>([
        [0, 1, 2, 3],
        [1 << 20, -(1 << 19), 40, -5],
        [77, 1 << 18, -(1 << 20), 1 << 22],
    ]);
    assert!(figures.max <= 5e-7, "{figures:?}");
}

#[test]
fn the_density_is_0_outside_and_its_edge_is_a_step_wide() {
    let warp = new::<U0, 2, Fine>([[0, 0], [1000, 0], [0, 500]]);
    let pdf = |x, y| warp.pdf([I32F0::from_bits(x), I32F0::from_bits(y)]);
    let inside = pdf(10, 10);
    assert_eq!(
        inside.to_bits(),
        ((1_u64 << 32) as f64 / 250_000.0).round() as u64
    );
    for x in -3..1003 {
        for y in -3..503 {
            // Twice the area beyond the slanted side, and what a step in both coordinates is of it.
            let beyond = x * 500 + y * 1000 - 500_000;
            let in_box = (0..=1000).contains(&x) && (0..=500).contains(&y);
            let due = in_box && beyond <= 1500;
            assert_eq!(pdf(x, y) != 0, due, "{x} {y}");
        }
    }
    // The other way round it is the same triangle.
    let turned = new::<U0, 2, Fine>([[0, 0], [0, 500], [1000, 0]]);
    assert_eq!(turned.pdf([I32F0::from_bits(10); 2]), inside);
    assert_eq!(
        turned.pdf([I32F0::from_bits(700), I32F0::from_bits(400)]),
        0
    );
    // Off the plane of a solid one.
    let solid = new::<U0, 3, Fine>([[0, 0, 0], [1000, 0, 1000], [0, 1000, 1000]]);
    let pdf = |p: [i32; 3]| solid.pdf(p.map(I32F0::from_bits));
    assert!(pdf([200, 200, 400]) > 0);
    assert!(pdf([200, 200, 402]) > 0);
    assert_eq!(pdf([200, 200, 410]), 0);
    assert_eq!(pdf([200, 200, 390]), 0);
}

#[test]
fn any_point_has_an_inverse() {
    let ends = [i32::MIN, -1, 0, 1, i32::MAX];
    for vertices in FLAT {
        let warp = new::<U16, 2, Fine>(vertices);
        for x in ends {
            for y in ends {
                let point = [x, y].map(FixedI32::from_bits);
                let _ = warp.pdf(point);
                assert!(warp.pdf(warp.sample(warp.invert(point))) > 0);
            }
        }
    }
    for vertices in SOLID {
        let warp = new::<U16, 3, Fine>(vertices);
        for x in ends {
            for y in ends {
                let point = [x, y, x].map(FixedI32::from_bits);
                let _ = warp.pdf(point);
                assert!(warp.pdf(warp.sample(warp.invert(point))) > 0);
            }
        }
    }
}

#[test]
fn vertices_too_far_apart_or_on_a_line_are_refused() {
    let new = |vertices: [[i32; 2]; 3]| {
        TriangleOn::<U16, 2, Fine>::new(vertices.map(|v| v.map(I16F16::from_bits)))
    };
    for on_a_line in [
        [[0, 0]; 3],
        [[0, 0], [5, 5], [9, 9]],
        [[1, 7], [1, 8], [1, i32::MAX]],
    ] {
        assert_eq!(new(on_a_line), Err(Error::Empty));
    }
    // Half a square step, of density 2³³.
    assert_eq!(new([[100, 100], [101, 100], [100, 101]]), Err(Error::Empty));
    assert!(new([[100, 100], [102, 100], [100, 102]]).is_ok());
    const FACET: Result<TriangleOn<U16, 2>, Error> = TriangleOn::new([
        [I16F16::ZERO, I16F16::ZERO],
        [I16F16::from_bits(1 << 18), I16F16::ZERO],
        [I16F16::ZERO, I16F16::from_bits(1 << 17)],
    ]);
    assert_eq!(FACET.unwrap().pdf([I16F16::ZERO; 2]), 0.25);
    for too_far in [
        [[-1, 0], [i32::MAX, 0], [5, 5]],
        [[0, i32::MIN], [1, 0], [2, i32::MAX]],
    ] {
        assert_eq!(new(too_far), Err(Error::TooLarge));
    }
}
