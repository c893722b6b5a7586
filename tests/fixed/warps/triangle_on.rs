//! Triangles on vertices.

use super::figures::{Figures, WORD, hold, over_pairs};
use crate::raw::{Raw, Words, accepted, raw, vertices_of_bits};
use fixed::FixedI32;
use fixed::types::extra::{LeEqU32, U0, U16};
use fixed::types::{I16F16, I32F0, U0F32};
use host::speed;
use microwarp::fixed::warp::TriangleOn;
use microwarp::fixed::{Coarse, Compact, Fine, Grade};
use microwarp::{Error, Invert, Warp};
use num_bigint::BigUint;
use rand_core::Rng;
use rand_pcg::Pcg32;

const PAIRS: u64 = 1 << 16;

fn new<Frac: LeEqU32, const D: usize, G: Grade>(vertices: [[i32; D]; 3]) -> TriangleOn<Frac, D, G> {
    TriangleOn::new(vertices_of_bits(&vertices)).unwrap()
}

fn weights([u, v]: [u32; 2]) -> [f64; 3] {
    let (s, v) = ((f64::from(u) * WORD).sqrt(), f64::from(v) * WORD);
    [1.0 - s, s * v, s * (1.0 - v)]
}

/// Points against the truth, of the extent of a coordinate beyond half a step; inside the box, of the density that
/// the area has, and with an inverse that leads back.
fn sample_error<const D: usize>(
    warp: Box<dyn Raw>,
    stated: f64,
    vertices: [[i32; D]; 3],
) -> Figures {
    let [a, b, c] = vertices;
    let low: Vec<i32> = (0..D).map(|k| a[k].min(b[k]).min(c[k])).collect();
    let high: Vec<i32> = (0..D).map(|k| a[k].max(b[k]).max(c[k])).collect();
    let density = density(vertices) * 2_f64.powi(32);
    over_pairs(PAIRS, |pair, observe| {
        let point = warp.sample(&pair);
        let [u, v, w] = weights(pair);
        for k in 0..D {
            let x = point[k] as i32;
            assert!((low[k]..=high[k]).contains(&x), "{vertices:?} {pair:x?}");
            let due = f64::from(a[k]) * u + f64::from(b[k]) * v + f64::from(c[k]) * w;
            let extent = f64::from(high[k]) - f64::from(low[k]);
            let error = (f64::from(x) - due).abs() - 0.5;
            if extent > 0.0 {
                observe(error.max(0.0) / extent);
            }
        }
        let got = warp.pdf(&point).to_num::<f64>();
        assert!(got > 0.0, "{vertices:?} {pair:x?}");
        assert!(
            (got - density.max(WORD)).abs() <= WORD + 1e-8 * density,
            "{got} for {density}"
        );
        let again = warp.sample(&warp.invert(&point));
        let (off, bound) = returned(vertices, stated, point, again);
        assert!(off <= bound, "{vertices:?} {pair:x?}: {off}, {bound}");
    })
}

/// 1/area in steps, by exact minors.
pub fn density<const D: usize>([a, b, c]: [[i32; D]; 3]) -> f64 {
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

/// How many steps lie between a point and the sample of its inverse, and how many may: four, and twice the error that the
/// page states of a sample, of the extent.
fn returned<const D: usize>(
    [a, b, c]: [[i32; D]; 3],
    stated: f64,
    point: Words,
    again: Words,
) -> (f64, f64) {
    let most = |numbers: [i64; D]| numbers.into_iter().max().unwrap() as f64;
    let extent = most(std::array::from_fn(|k| {
        let row = [a[k], b[k], c[k]].map(i64::from);
        row.into_iter().max().unwrap() - row.into_iter().min().unwrap()
    }));
    let off = most(std::array::from_fn(|k| {
        (i64::from(point[k] as i32) - i64::from(again[k] as i32)).abs()
    }));
    (off, 4.0 + 2.0 * stated * extent)
}

/// The error that the page states of a sample.
pub fn stated<G: Grade>() -> f64 {
    match G::NAME {
        "fine" => 2.0e-7,
        "coarse" => 1.9e-5,
        _ => 6.2e-8,
    }
}

/// Triangles a few steps wide, at any angle and of any length, with any vertex in the middle; every fourth one of any
/// width.
fn sliver<const D: usize>(rng: &mut Pcg32) -> [[i32; D]; 3] {
    let shift = 1 + rng.next_u32() % 2 * (rng.next_u32() % 24);
    let mut v = [[0; D]; 3].map(|p: [i32; D]| p.map(|_| rng.next_u32() as i32 >> shift));
    if rng.next_u32() & 3 > 0 {
        let part = f64::from(rng.next_u32()) * WORD;
        let part = part * [1.0, 1.0, 1e-6, 1e-3][rng.next_u32() as usize & 3];
        let width = 1 + rng.next_u32() % 32;
        let [a, b, c] = &mut v;
        for ((a, b), c) in a.iter().zip(b.iter()).zip(c) {
            let from = f64::from(*a);
            *c = (from + part * (f64::from(*b) - from)) as i32 + (rng.next_u32() % width) as i32;
        }
    }
    v.rotate_left((rng.next_u32() % 3) as usize);
    if rng.next_u32() & 1 == 0 {
        v.swap(0, 1);
    }
    v
}

/// Words at both ends, next to them, and anywhere.
fn word(rng: &mut Pcg32) -> u32 {
    let (word, by) = (rng.next_u32(), rng.next_u32() % 32);
    match rng.next_u32() % 4 {
        0 => word >> by,
        1 => !(word >> by),
        _ => word,
    }
}

/// The weights of a point's exact parts of the area, none below 0: what the inverse must not be.
fn by_parts([a, b, c]: [[i32; 2]; 3], x: Words) -> [u32; 2] {
    let [a, b, c] = [a, b, c].map(|v| v.map(i128::from));
    let x = [0, 1].map(|k| i128::from(x[k] as i32));
    let part = |p: [i128; 2], q: [i128; 2], r: [i128; 2]| {
        (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])
    };
    let sign = part(a, b, c).signum();
    let [u, v, w] =
        [part(b, c, x), part(c, a, x), part(a, b, x)].map(|part| (part * sign).max(0) as f64);
    let both = (v + w) / (u + v + w);
    let second = if v + w > 0.0 { v / (v + w) } else { 0.0 };
    [both * both, second].map(|u| U0F32::saturating_from_num(u).to_bits())
}

/// How many inverses of samples do not lead back, of those of a warp and of those by parts.
fn astray<const D: usize, G: Grade>(by_parts: fn([[i32; D]; 3], Words) -> [u32; 2]) -> [u32; 2] {
    let mut rng = Pcg32::new(21, D as u64);
    let (mut astray, mut wrong) = (0, 0);
    for _ in 0..speed::of("slivers", 20_000, 1_000_000) {
        let vertices = sliver::<D>(&mut rng);
        let Some(warp) = accepted(TriangleOn::<U16, D, G>::new(vertices_of_bits(&vertices))) else {
            continue;
        };
        let pair = [word(&mut rng), word(&mut rng)];
        let point = warp.sample(&pair);
        assert!(warp.pdf(&point) > 0, "{vertices:?} {pair:x?}");
        let again = warp.sample(&warp.invert(&point));
        let (off, bound) = returned(vertices, stated::<G>(), point, again);
        if off > bound {
            println!("{vertices:?} {pair:x?}: {off} for {bound}");
            astray += 1;
        }
        let other = warp.sample(&by_parts(vertices, point));
        let (off, bound) = returned(vertices, stated::<G>(), point, other);
        wrong += u32::from(off > bound);
    }
    [astray, wrong]
}

#[test]
fn the_inverse_leads_back_in_any_sliver() {
    let [fine, wrong] = astray::<2, Fine>(by_parts);
    // The old way is found out.
    assert!(fine == 0 && wrong > 500, "{fine} {wrong}");
    assert_eq!(astray::<2, Coarse>(by_parts)[0], 0);
    assert_eq!(astray::<2, Compact>(by_parts)[0], 0);
    assert_eq!(astray::<3, Fine>(|_, _| [0; 2])[0], 0);
    assert_eq!(astray::<5, Fine>(|_, _| [0; 2])[0], 0);
    // It once led 1.15e9 steps off, and the other one is next to the first vertex, where the first word has few digits.
    for (vertices, words) in [
        (
            [[-120, 251_835_406], [-592, -653_854_751], [10, 501_513_406]],
            [0xffc4_ac80, 0xffe0_cf41],
        ),
        (
            [
                [51_206_315, -84_799_524],
                [384_213_757, 377_681_821],
                [757_910_260, 896_672_209],
            ],
            [1, 0xe3b2_8e6c],
        ),
    ] {
        let warp = raw(new::<U16, 2, Fine>(vertices));
        let point = warp.sample(&words);
        let again = warp.sample(&warp.invert(&point));
        let (off, _) = returned(vertices, 0.0, point, again);
        assert!(off <= 4.0, "{vertices:?}: {off}");
    }
}

/// The largest error of the density of random triangles, beyond a step, relative; by the exact sum of all squared minors.
fn density_error<const D: usize>(count: u32) -> f64 {
    let mut rng = Pcg32::new(22, D as u64);
    let mut most = 0.0_f64;
    for _ in 0..count {
        // Of density 2³² at most, and not so small that its steps hide the error.
        let shift = 22 + rng.next_u32() % 6;
        let flat = rng.next_u32() & 1 == 0;
        let v = [[0; D]; 3].map(|p: [i32; D]| {
            let mut k = 0;
            p.map(|_| {
                k += 1;
                rng.next_u32() as i32 >> if flat && k > 2 { 29 } else { shift }
            })
        });
        let Ok(warp) = TriangleOn::<U16, D, Fine>::new(vertices_of_bits(&v)) else {
            continue;
        };
        let [a, b, c] = v;
        let side = |v: [i32; D], k: usize| i64::from(v[k]) - i64::from(a[k]);
        let (p, q): (Vec<_>, Vec<_>) = (0..D).map(|k| (side(b, k), side(c, k))).unzip();
        let mut squares = BigUint::ZERO;
        for i in 0..D {
            for j in 0..i {
                let minor =
                    i128::from(p[i]) * i128::from(q[j]) - i128::from(p[j]) * i128::from(q[i]);
                squares += BigUint::from(minor.unsigned_abs()).pow(2);
            }
        }
        // 2/area in steps, times 2³² for each of a coordinate's 2¹⁶ and for the density's own bits; 40 bits more.
        let due = (BigUint::from(1_u32) << 145_u32) / (squares << 80_u32).sqrt();
        let due = u128::try_from(due).unwrap() as f64 / 2_f64.powi(40);
        let got = warp.pdf(warp.vertices()[0]).to_bits() as f64;
        most = most.max(((got - due).abs() - 1.0).max(0.0) / due);
    }
    most
}

#[test]
fn the_density_is_right_in_any_dimension() {
    let count = speed::of("triangles of each dimension", 2_000, 200_000);
    let found = [
        density_error::<2>(count),
        density_error::<3>(count),
        density_error::<4>(count),
        density_error::<9>(count),
        density_error::<600>(count / 500),
    ];
    println!("{found:?}");
    assert!(found.iter().all(|error| *error <= 1.2e-9), "{found:?}");
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
    let stated = stated::<G>();
    let flat = FLAT.map(|v| sample_error(raw(new::<U16, 2, G>(v)), stated, v));
    let solid = SOLID.map(|v| sample_error(raw(new::<U16, 3, G>(v)), stated, v));
    flat.iter().chain(&solid).map(|f| f.max).fold(0.0, f64::max)
}

#[test]
fn a_point_is_in_the_box_right_to_a_step_and_of_the_area_s_density() {
    let worst = [worst::<Fine>(), worst::<Coarse>(), worst::<Compact>()];
    hold("TriangleOn", &[("sample, max", worst)]);
}

#[test]
fn four_dimensions_are_no_obstacle() {
    let vertices = [
        [0, 1, 2, 3],
        [1 << 20, -(1 << 19), 40, -5],
        [77, 1 << 18, -(1 << 20), 1 << 22],
    ];
    let warp = raw(new::<U16, 4, Fine>(vertices));
    let figures = sample_error(warp, stated::<Fine>(), vertices);
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

/// A point of the box that both sides at an obtuse vertex turn away from leads to that vertex, whichever of the three it is.
#[test]
fn a_point_beyond_a_vertex_leads_to_it() {
    let mut vertices = [[0, 0], [60 << 10, 40 << 10], [100 << 10, 100 << 10]];
    for _ in 0..3 {
        let warp = new::<U16, 2, Fine>(vertices);
        let beyond = [100 << 10, 0].map(FixedI32::from_bits);
        let found = warp.sample(warp.invert(beyond)).map(FixedI32::to_bits);
        let off = [found[0] - (60 << 10), found[1] - (40 << 10)];
        assert!(off.iter().all(|x| x.abs() <= 4), "{vertices:?}: {found:?}");
        vertices.rotate_left(1);
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
        assert_eq!(new(on_a_line), Err(Error::Empty(0)));
    }
    // Half a square step, of density 2³³.
    assert_eq!(
        new([[100, 100], [101, 100], [100, 101]]),
        Err(Error::Empty(0))
    );
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
        assert_eq!(new(too_far), Err(Error::TooLarge(0)));
    }
}
