//! Maps of the line do not turn back, and where `f32` has fewer points than there are uniforms, every point
//! has its share of them.
//!
//! Listed parameter sets are walked through over the whole 24-bit grid, others are searched at random between
//! neighbours. The map that rounds twice, (1 − u)a + ub, must be found out by all of it.

use crate::any_parameters::any;
use host::errors::ulp;
use host::speed;
use microwarp::discrete::{PiecewiseConstant1d, PiecewiseLinear1d};
use microwarp::tier::{Libm, Poly, Tier};
use microwarp::{
    Error, Warp,
    warp::{EquiAngular, Interval, Linear, Tent},
};
use rand_core::Rng;
use rand_pcg::Pcg32;

const GRID: u32 = 1 << 24;
const STEP: f32 = 1.0 / 16_777_216.0;

/// By how much less is tried in the quick speed than in the full one.
const LESS: u32 = 16;

type Map = Box<dyn Fn(f32) -> f32>;

/// The map of some parameters; nothing where they are refused.
type Build = fn([f32; 6]) -> Option<Map>;

/// A map that is stated to rise with the uniform; one that falls is negated.
fn rising<W: Warp<Uniforms = f32, Point = f32> + 'static>(warp: Result<W, Error>) -> Option<Map> {
    let warp = warp.ok()?;
    Some(Box::new(move |u| warp.sample(u)))
}

fn falling<W: Warp<Uniforms = f32, Point = f32> + 'static>(warp: Result<W, Error>) -> Option<Map> {
    let map = rising(warp)?;
    Some(Box::new(move |u| -map(u)))
}

/// (1 − u)a + ub kept in [a, b), whose two products round apart.
fn rounded_twice(a: f32, b: f32) -> Map {
    Box::new(move |u| ((1.0 - u) * a + u * b).clamp(a, below(b)))
}

/// The parameter sets that are walked through, one line each.
fn listed() -> Vec<(&'static str, Option<Map>)> {
    const MAX: f32 = f32::MAX;
    vec![
        ("[1e6, 1e6+1)", rising(Interval::new(1e6, 1e6 + 1.0))),
        (
            "(1e6, 1e6+1]",
            falling(Interval::decreasing(1e6, 1e6 + 1.0)),
        ),
        ("[1e6, 1e6+1/16)", rising(Interval::new(1e6, 1e6 + 0.0625))),
        ("[-MAX, MAX)", rising(Interval::new(-MAX, MAX))),
        ("(-MAX, MAX]", falling(Interval::decreasing(-MAX, MAX))),
        ("[-1e6, 3)", rising(Interval::new(-1e6, 3.0))),
        ("(-1e6, 3]", falling(Interval::decreasing(-1e6, 3.0))),
        ("[1e38, 3e38)", rising(Interval::new(1e38, 3e38))),
        ("[0, 3e-39)", rising(Interval::new(0.0, 3e-39))),
        ("(-2, -1.3]", falling(Interval::decreasing(-2.0, -1.3))),
        ("0 to 1", rising(Linear::new(0.0, 1.0))),
        ("1e-6 to 1", rising(Linear::new(1e-6, 1.0))),
        ("0.3 to 1", rising(Linear::new(0.3, 1.0))),
        ("0.7 to 0.9", rising(Linear::new(0.7, 0.9))),
        ("1 to 1.000001", rising(Linear::new(1.0, 1.000_001))),
        ("1 to 0.3", rising(Linear::new(1.0, 0.3))),
        ("1e20 to 1e-20", rising(Linear::new(1e20, 1e-20))),
        (
            "0:1 in cells",
            rising(PiecewiseLinear1d::new(&[0.0, 1.0], 0.0, 1.0)),
        ),
        (
            "1:0.3:0.9 in cells",
            rising(PiecewiseLinear1d::new(&[1.0, 0.3, 0.9], 0.0, 1.0)),
        ),
        (
            "1:1.000001:0 in cells",
            rising(PiecewiseLinear1d::new(&[1.0, 1.000_001, 0.0], -1.0, 1e-3)),
        ),
        ("tent 1", rising(Tent::new(1.0))),
        ("tent 3e38", rising(Tent::new(3e38))),
        ("tent 1.2e-38", rising(Tent::new(1.2e-38))),
    ]
}

/// Whatever a constructor accepts, one line a family.
fn families() -> Vec<(&'static str, Build)> {
    fn ordered([a, b, ..]: [f32; 6]) -> (f32, f32) {
        (a.min(b), a.max(b))
    }
    vec![
        ("Interval", |p| {
            let (a, b) = ordered(p);
            rising(Interval::new(a, b))
        }),
        ("Interval decreasing", |p| {
            let (a, b) = ordered(p);
            falling(Interval::decreasing(a, b))
        }),
        ("narrow Interval", |p| rising(narrow(p, Interval::new))),
        ("narrow Interval decreasing", |p| {
            falling(narrow(p, Interval::decreasing))
        }),
        ("Linear", |p| rising(Linear::new(p[0].abs(), p[1].abs()))),
        ("Tent", |p| rising(Tent::new(p[0]))),
        ("PiecewiseConstant1d", |p| {
            let ((a, b), [_, _, weights @ ..]) = (ordered(p), p.map(f32::abs));
            rising(PiecewiseConstant1d::new(&weights, a, b))
        }),
        ("PiecewiseLinear1d", |p| {
            let ((a, b), [_, _, weights @ ..]) = (ordered(p), p.map(f32::abs));
            rising(PiecewiseLinear1d::new(&weights, a, b))
        }),
        ("PiecewiseLinear1d of a cell", |p| {
            let ((a, b), [_, _, c, d, ..]) = (ordered(p), p.map(f32::abs));
            rising(PiecewiseLinear1d::new(&[c, d], a, b))
        }),
    ]
}

/// An interval of up to some thousand points that begins at the first of the parameters.
fn narrow<W>([a, b, ..]: [f32; 6], of: fn(f32, f32) -> Result<W, Error>) -> Result<W, Error> {
    of(a, a + a.abs() * (b % 2e-3).abs())
}

fn above(x: f32) -> f32 {
    -below(-x)
}

fn below(x: f32) -> f32 {
    match x {
        0.0 => -f32::from_bits(1),
        x if x > 0.0 => f32::from_bits(x.to_bits() - 1),
        _ => f32::from_bits(x.to_bits() + 1),
    }
}

/// How often a map steps back between neighbours of the grid.
fn steps_back(map: &Map) -> u32 {
    let mut before = map(0.0);
    let blocks = speed::blocks("the grid", GRID, LESS as usize);
    let back = blocks.flatten().map(|k| {
        let x = map(k as f32 * STEP);
        let forth = x >= before;
        before = x;
        u32::from(!forth)
    });
    back.sum()
}

/// How often a map of random parameters steps back between random neighbours: of the grid, and of `f32`.
fn steps_back_somewhere(build: impl Fn([f32; 6]) -> Option<Map>) -> u32 {
    let mut rng = Pcg32::new(2_026, 13);
    let (mut back, mut accepted) = (0, 0);
    let sets = speed::of("parameters of each family", 4_000 / LESS, 4_000);
    while accepted < sets {
        let parameters = std::array::from_fn(|_| any(&mut rng));
        let Some(map) = build(parameters) else {
            continue;
        };
        accepted += 1;
        for _ in 0..100 {
            let k = (rng.next_u32() >> 8).min(GRID - 2) as f32;
            let fine = f32::from_bits(rng.next_u32() % (1.0_f32.to_bits() - 1));
            for (u, next) in [(k * STEP, (k + 1.0) * STEP), (fine, above(fine))] {
                let forth = map(next) >= map(u);
                back += u32::from(!forth);
            }
        }
    }
    back
}

#[test]
fn listed_maps_never_turn_back() {
    for (label, map) in listed() {
        let back = steps_back(&map.expect(label));
        assert!(back == 0, "{label} steps back {back} times");
    }
    let wrong = steps_back(&rounded_twice(1e6, 1e6 + 1.0));
    println!("rounded twice: {wrong} steps back");
    assert!(wrong > 10_000 / LESS);
}

#[test]
fn maps_of_any_parameters_never_turn_back() {
    for (label, build) in families() {
        let back = steps_back_somewhere(build);
        assert!(back == 0, "{label} steps back {back} times");
    }
    let wrong = steps_back_somewhere(|p| {
        narrow(p, Interval::new).ok()?;
        narrow(p, |a, b| Ok(rounded_twice(a, b))).ok()
    });
    println!("rounded twice: {wrong} steps back");
    assert!(wrong > 1_000 / LESS);
}

/// By how many units in the last place a map steps back at most between neighbours of the grid, and how often; one of a length
/// where its points are smaller.
fn steps_back_by(map: &Map, least: f32) -> (f64, u32) {
    let (mut worst, mut count, mut before) = (0.0_f64, 0, f64::from(map(0.0)));
    for k in speed::blocks("the grid", GRID, LESS as usize).flatten() {
        let x = f64::from(map(k as f32 * STEP));
        if before > x {
            worst = worst.max((before - x) / ulp(x.abs().max(least.into())));
            count += 1;
        }
        before = x;
    }
    (worst, count)
}

fn equi_angular_steps_back_a_little<T: Tier>() {
    for [d, a, b] in [
        [2.0, -5.0, 15.0],
        [0.5, -9.0, -0.25],
        [1.0, 0.0, 3.0],
        [0.960_701_64, 0.022_278_361, 3.047_427_8e9],
        [36.727_047, -34.715_28, -0.015_181_692],
        [6_689_529.5, -0.030_632_349, 0.002_439_673_5],
        [1.0, 1000.0, 1000.01],
        [0.0, 1.0, 1e6],
    ] {
        let warp = EquiAngular::<T>::new(d, a, b);
        let passed = a < 0.0 && b > 0.0;
        let least = if passed { d.min(b.max(-a)) } else { 0.0 };
        let (worst, count) = steps_back_by(&rising(warp).unwrap(), least);
        println!("{d} beside [{a}, {b}]: {count} steps back, by up to {worst} ulp");
        assert!(worst <= 7.0, "{d} beside [{a}, {b}]: {worst} ulp");
    }
}

#[test]
fn equi_angular_steps_back_by_no_more_than_its_page_says() {
    equi_angular_steps_back_a_little::<Libm>();
    equi_angular_steps_back_a_little::<Poly>();
    // The textbook's tangent of an angle.
    let (low, high) = ((-9.0_f32 / 0.5).atan(), (-0.25_f32 / 0.5).atan());
    let tangent: Map = Box::new(move |u| 0.5 * ((1.0 - u) * low + u * high).tan());
    let (worst, _) = steps_back_by(&tangent, 0.0);
    assert!(worst > 7.0, "the tangent passes: {worst} ulp");
}

/// How uneven the points of [a, b) are, in uniforms of the grid, a coarser one in the quick speed: the largest error of a single point's share, and
/// that of the number of uniforms up to a point (Kolmogorov's distance times their number). Exact counts of sorted samples.
fn uneven(map: &Map, a: f32, b: f32) -> [f64; 2] {
    let less = speed::of("one uniform counted of every", LESS, 1);
    let count = GRID / less;
    let mut points: Vec<f32> = (0..count).map(|k| map((k * less) as f32 * STEP)).collect();
    if !points.is_sorted() {
        points.sort_unstable_by(f32::total_cmp);
    }
    let [low, high] = [a, b].map(f64::from);
    let last = *points.last().unwrap();
    // The uniforms of an exact map up to half-way to the next point; all of them at the last one.
    let due = |x: f32| {
        let edge = 0.5 * (f64::from(x) + f64::from(above(x)));
        let share = if x == last {
            1.0
        } else {
            (edge - low) / (high - low)
        };
        f64::from(count) * share
    };
    let (mut share, mut distance, mut start) = (0.0_f64, 0.0_f64, 0);
    while let Some(&x) = points.get(start) {
        let end = start + points[start..].iter().take_while(|y| **y <= x).count();
        let due = [if x > a { due(below(x)) } else { 0.0 }, due(x)];
        let apart = |count: usize, due: f64| (count as f64 - due).abs();
        share = share.max(apart(end - start, due[1] - due[0]));
        distance = distance.max(apart(start, due[0])).max(apart(end, due[1]));
        start = end;
    }
    [share, distance]
}

#[test]
fn every_point_has_its_share_of_the_uniforms() {
    let negative = |map: Map| -> Map { Box::new(move |u| -map(u)) };
    for (a, b) in [
        (1e6, 1e6 + 1.0),
        (1e6, 1e6 + 0.0625),
        (-1e6, -1e6 + 100.0),
        (1.0, 1.01),
        (-f32::MAX, f32::MAX),
        (-1e6, 3.0),
        (1e38, 3e38),
    ] {
        let up = rising(Interval::new(a, b)).unwrap();
        let down = falling(Interval::decreasing(a, b)).unwrap();
        for (map, a, b) in [(up, a, b), (down, -b, -a)] {
            let off = uneven(&map, a, b);
            println!("[{a:e}, {b:e}): off by {off:?} uniforms");
            assert!(off[0] <= 3.0 && off[1] <= 2.0, "[{a:e}, {b:e}): {off:?}");
        }
    }
    let up = uneven(&rounded_twice(1e6, 1e6 + 1.0), 1e6, 1e6 + 1.0);
    let down = negative(Box::new(|u| rounded_twice(1e6, 1e6 + 1.0)(1.0 - u)));
    let down = uneven(&down, -1e6 - 1.0, -1e6);
    println!("rounded twice: off by {up:?} and {down:?} uniforms");
    let most = 1e5 / f64::from(LESS);
    assert!(up.iter().chain(&down).all(|off| *off > most));
}
