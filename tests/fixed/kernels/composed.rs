//! The error of a point that is a radius of one word turned by another is proven, though there are 2⁶⁴ of them.
//!
//! A coordinate is R'·C' + δ, where R' is what the radius' kernel gives and C' the sine or cosine. Off the truth R·C it is by
//! (R' − R)·C' + R·(C' − C) + δ. Each factor is swept over all words of its own, its largest error kept apart for cells of its
//! size, and δ is what the product cuts. The largest sum of a pair of cells is the bound: over all words with `MICROWARP_FULL=all`,
//! over one of every 256 otherwise.

use super::inputs::{Words, edges};
use fixed::types::U0F32;
use host::docs::Doc;
use host::errors::raise;
use host::speed;
use microwarp::Warp;
use microwarp::fixed::warp::{CosineHemisphere, Disk, Hemisphere, Sphere, StandardNormalPair};
use microwarp::fixed::{Coarse, Compact, Fine, Grade};
use std::f64::consts::TAU;

const CELLS: usize = 256;
const WORD: f64 = 1.0 / 4_294_967_296.0;
/// The step of a coordinate, 2⁻³⁰, in what the product of a grade with 1 is exact.
const STEP: f64 = 4.0 * WORD;

type Cells = [f64; CELLS];

/// The largest errors of a function of a word, by the size of its results in parts of `most`.
fn by_size<const N: usize>(
    what: &str,
    most: f64,
    function: impl Fn(u32) -> [(f64, f64); N] + Sync,
) -> Cells {
    let step = |cells: &mut Cells, word: u32| {
        for (size, error) in function(word) {
            let cell = &mut cells[((size / most * CELLS as f64) as usize).min(CELLS - 1)];
            raise(cell, error.abs());
        }
    };
    let parts = Words::every(32_768, 256).fold(what, &edges(), || [0.0; CELLS], step);
    let mut all: Cells = [0.0; CELLS];
    for part in &parts {
        for (all, part) in all.iter_mut().zip(part) {
            *all = part.max(*all);
        }
    }
    all
}

/// The upper edge of a cell.
fn edge(cell: usize) -> f64 {
    (cell + 1) as f64 / CELLS as f64
}

/// The largest of what any radius and any factor of the circle add up to.
fn composed(radii: &Cells, most: f64, circle: &Cells) -> f64 {
    let sums = (0..CELLS)
        .flat_map(|i| (0..CELLS).map(move |j| radii[i] * edge(j) + most * edge(i) * circle[j]));
    sums.fold(0.0, f64::max)
}

/// Sine and cosine of a phase, to the nearest quarter turn exactly.
fn exact(phase: u32) -> [f64; 2] {
    let (s, c) = (f64::from((phase << 2) as i32) * WORD * TAU / 4.0).sin_cos();
    match phase.wrapping_add(1 << 29) >> 30 {
        0 => [s, c],
        1 => [c, -s],
        2 => [-s, -c],
        _ => [-c, s],
    }
}

/// The errors of what a product takes of sine and cosine, by size; and of both whole as one point, in the last cell.
fn circles<G: Grade>() -> [Cells; 2] {
    let cut = if G::NAME == Coarse::NAME { 14 } else { 0 };
    let whole = |phase| {
        let (s, c) = G::sincos_turns(U0F32::from_bits(phase));
        [s, c].map(|c| c.to_bits())
    };
    // The distance counts as of size 2, a size of its own.
    let all = by_size(G::NAME, 2.0, |phase| {
        let (due, got) = (exact(phase), whole(phase));
        let error = |i: usize, cut: u32| f64::from(got[i] >> cut << cut) * STEP - due[i];
        let each = [0, 1].map(|i| (due[i].abs(), error(i, cut)));
        [each[0], each[1], (2.0, error(0, 0).hypot(error(1, 0)))]
    });
    let mut circle = [0.0; CELLS];
    for (cell, circle) in circle.iter_mut().enumerate() {
        *circle = all[cell / 2];
    }
    // Sizes of 1 itself.
    circle[CELLS - 1] = circle[CELLS - 1].max(all[CELLS / 2]);
    [circle, [all[CELLS - 1]; CELLS]]
}

/// The bound of a coordinate of each warp in a grade.
fn bounds<G: Grade>() -> [f64; 5] {
    let pair = |u: u32| [u, 0].map(U0F32::from_bits);
    let coarse = G::NAME == Coarse::NAME;
    // At phase 0 the product shows what it takes of a radius, cut to a step, or to what a coarse one takes of it.
    let hidden = if coarse { 0.0 } else { 1.0 };
    let cut = if coarse { 1.0 } else { 3.0 };
    let [circle, both] = circles::<G>();
    let turned =
        |what: &str, radius: &(dyn Fn(f64) -> f64 + Sync), x: &(dyn Fn(u32) -> f64 + Sync)| {
            let radii = by_size(what, 1.0, |u| {
                let due = radius(f64::from(u) * WORD);
                [(
                    due,
                    (x(u) - due).abs().max((x(u) + hidden * STEP - due).abs()),
                )]
            });
            composed(&radii, 1.0, &circle) + cut * STEP
        };
    // The third coordinate is a function of the first word alone.
    let upright = |z: &(dyn Fn(u32) -> (f64, f64) + Sync)| {
        by_size("z", 1.0, |u| {
            let (got, due) = z(u);
            [(0.0, got - due)]
        })[0]
    };
    let root = |u: f64| u.sqrt();
    let (disk, sphere) = (Disk::<G>::new(), Sphere::<G>::new());
    let (hemisphere, cosine) = (Hemisphere::<G>::new(), CosineHemisphere::<G>::new());
    let of = |point: [fixed::types::I2F30; 3], i: usize| point[i].to_num::<f64>();
    let flat = turned("disk", &root, &|u| disk.sample(pair(u))[0].to_num());
    let about = turned("sphere", &|u| 2.0 * (u * (1.0 - u)).sqrt(), &|u| {
        of(sphere.sample(pair(u)), 0)
    });
    let half = turned("hemisphere", &|u| ((1.0 - u) * (1.0 + u)).sqrt(), &|u| {
        of(hemisphere.sample(pair(u)), 0)
    });
    let lambert = turned("cosine", &root, &|u| of(cosine.sample(pair(u)), 0));
    let high = upright(&|u| {
        (
            of(cosine.sample(pair(u)), 2),
            (1.0 - f64::from(u) * WORD).sqrt(),
        )
    });
    // Normals, whose error is the distance of two points, in steps of 2⁻²⁷ and by the long product in every grade.
    let (normal, most) = (StandardNormalPair::<G>::new(), 6.661);
    let radii = by_size("normal", most, |u| {
        let due = (-2.0 * (-f64::from(u) * WORD).ln_1p()).sqrt();
        let x: f64 = normal.sample(pair(u))[0].to_num();
        [(due, (x - due).abs().max((x + 8.0 * STEP - due).abs()))]
    });
    let turned = radii
        .iter()
        .enumerate()
        .map(|(i, e)| e + most * edge(i) * both[CELLS - 1]);
    let gauss = turned.fold(0.0, f64::max) + 3.0 * 8.0 * STEP * 2.0_f64.sqrt();
    [flat, about, half, lambert.max(high), gauss]
}

/// What the documentation states of the largest error of a sample.
fn largest_of(warp: &str) -> [f64; 3] {
    let row = Doc::of("fixed", warp).row("sample, max").unwrap();
    row.statements().map(|stated| stated.number().unwrap())
}

const WARPS: [&str; 5] = [
    "Disk",
    "Sphere",
    "Hemisphere",
    "CosineHemisphere",
    "StandardNormalPair",
];

#[test]
fn points_of_two_words_are_proven_to_keep_their_stated_errors() {
    let all = [bounds::<Fine>(), bounds::<Coarse>(), bounds::<Compact>()];
    for (i, warp) in WARPS.into_iter().enumerate() {
        let proven = all.map(|bounds| bounds[i]);
        println!("{warp}: {}", proven.map(|x| format!("{x:.4e}")).join(" "));
    }
    for (i, warp) in WARPS.into_iter().enumerate() {
        let (proven, stated) = (all.map(|bounds| bounds[i]), largest_of(warp));
        for (proven, stated) in proven.into_iter().zip(stated) {
            assert!(
                proven <= stated,
                "{warp}: {proven:e} proven, {stated:e} stated"
            );
            // A statement is the proven number to two digits, not more.
            let near = if speed::all() { 1.1 } else { 1.2 };
            assert!(
                stated <= near * proven,
                "{warp}: {proven:e} proven, {stated:e} stated"
            );
        }
    }
}

#[test]
fn an_error_of_either_factor_is_seen() {
    let (mut radii, mut circle) = ([1e-7; CELLS], [2e-7; CELLS]);
    assert!((composed(&radii, 1.0, &circle) - 3e-7).abs() < 1e-12);
    radii[CELLS / 2] = 1e-6;
    assert!(composed(&radii, 1.0, &circle) > 1.1e-6);
    circle[3] = f64::INFINITY;
    assert!(composed(&radii, 1.0, &circle) == f64::INFINITY);
    let nan = by_size("control", 1.0, |word| {
        [(0.5, if word == 77 { f64::NAN } else { 0.0 })]
    });
    assert!(nan[CELLS / 2] == f64::INFINITY);
}
