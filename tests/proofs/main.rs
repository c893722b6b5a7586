//! Bounds on the errors of the maps of two uniforms that have no parameters, over all pairs of uniforms; and on those of laws of
//! the line, over all parameters and uniforms (`line.rs`).
//!
//! There are 2^48 pairs of the grid alone, too many to try. But each such map is a radius, made of one uniform, times sine
//! and cosine, made of the other: the error of each factor is found by trying all its inputs, and what the products
//! round is at most half an ulp. `docs/proofs.md` has the argument and the figures; here they are computed, compared
//! with what the documentation of the maps states and with the largest errors that a search finds.
//! In the quick speed one of every few inputs is tried, so that what is called proven is so only nearly.
//! `MICROWARP_WRITE=1 cargo test --test proofs` writes the figures anew.

mod angles;
mod bilinear;
mod bounds;
mod cover;
mod direct;
mod equi_angular;
mod fisher;
mod formed;
mod forms;
mod gappa;
mod ggx_visible;
mod inputs;
mod interval;
mod kept;
mod kernels;
mod laws;
mod line;
mod linear;
mod lobe;
mod maps;
mod number;
mod parametric;
mod phases;
mod powers;
mod products;
mod programs;
mod radii;
mod range;
mod reached;
mod report;
mod rounding;
mod script;
mod search;
mod segments;
mod several;
mod shapes;
mod sphere_bound;
mod sphere_lamp;
mod spread;
mod sweeps;
mod swept;
mod tables;
mod tape;
mod truncated;
mod unit;

use bounds::Roundings;
use inputs::{STRIDE, Uniforms, in_parallel};
use maps::{Kernels, MAPS, Outcome, examine};
use microwarp::tier::{Libm, Poly, Tier};
use report::{complaint, stated};

fn outcomes<T: Tier>() -> Vec<[Outcome; 2]> {
    let any = Kernels::of(Uniforms::Any, T::sincos_turns);
    let grid = Kernels::of(Uniforms::Grid, T::sincos_turns);
    let both = |name| {
        let outcome = |uniforms, kernels| {
            let radii = radii::radii::<T>(name, uniforms, 0);
            examine::<T>(
                name,
                uniforms,
                &radii,
                kernels,
                Roundings::of(name, uniforms),
            )
        };
        // A quotient of two numbers of the grid is no number of the grid.
        let kernels = if maps::is_concentric(name) {
            &any
        } else {
            &grid
        };
        let of_grid = outcome(Uniforms::Grid, kernels);
        let mut of_any = outcome(Uniforms::Any, &any);
        for (row, other) in of_any.rows.iter_mut().zip(of_grid.rows) {
            row.found = row.found.max(other.found);
        }
        [of_any, of_grid]
    };
    MAPS.into_iter().map(both).collect()
}

/// What is stated of every uniform is proven, and a search comes near what is proven.
#[test]
fn stated_errors_are_proven_for_every_uniform() {
    let (libm, poly) = (outcomes::<Libm>(), outcomes::<Poly>());
    let outcomes: Vec<_> = libm.into_iter().zip(poly).map(|(l, p)| [l, p]).collect();
    report::check(&outcomes);
}

fn maps_have_the_form_that_is_examined<T: Tier>() {
    for name in MAPS {
        let entry = maps::entry::<T>(name);
        for k in 0..(1 << 18) / *STRIDE {
            let u = [k, k + (1 << 20)].map(|k| {
                let word = search::spread(k);
                // Half of them of the grid, the others from all binades.
                if k % 2 == 0 {
                    (word >> 8) as f32 / 16_777_216.0
                } else {
                    f32::from_bits(word % 1.0_f32.to_bits())
                }
            });
            maps::assert_form::<T>(&entry, u);
        }
    }
}

#[test]
fn maps_are_a_radius_times_sine_and_cosine() {
    maps_have_the_form_that_is_examined::<Libm>();
    maps_have_the_form_that_is_examined::<Poly>();
}

/// At the largest radius every phase is tried: all coordinates of a smaller one are no larger, since rounding never
/// changes an order, and so is the sum of squares that the density asks for.
fn no_point_leaves_the_disk_of<T: Tier>() {
    let rim = radii::rim(T::sincos_turns);
    // Below the first phase the sine is below 2e-4, and its square less than 1 - r² = 2^-23.
    let first = (1.0_f32 / 32_768.0).to_bits();
    let last = 0.125_f32.to_bits();
    in_parallel(64, |part| {
        for bits in (first + part..=last).step_by(64 * *STRIDE as usize) {
            let (y, x) = rim(f32::from_bits(bits));
            let square = |x: f32| f64::from(x) * f64::from(x);
            // A sum that is not below 1 would not be rounded to below 1.
            assert!(square(x) + square(y) < 1.0, "{} {bits:x}", T::NAME);
            assert!(x * x + y * y <= 1.0, "{} {bits:x}", T::NAME);
        }
    });
}

#[test]
fn no_point_of_any_uniforms_leaves_the_disk() {
    no_point_leaves_the_disk_of::<Libm>();
    no_point_leaves_the_disk_of::<Poly>();
}

/// What is wrong with the sample error of a map, when a part of the argument is changed.
fn judged<T: Tier>(
    (name, uniforms): (&str, Uniforms),
    wrong: u32,
    kernels: &Kernels,
    change: impl Fn(Roundings) -> Roundings,
) -> Option<String> {
    let radii = radii::radii::<T>(name, uniforms, wrong);
    let roundings = change(Roundings::of(name, uniforms));
    let [sample, ..] = examine::<T>(name, uniforms, &radii, kernels, roundings).rows;
    let [[libm, poly], ..] = stated(name);
    complaint(sample, if T::NAME == "libm" { libm } else { poly })
}

#[test]
fn a_broken_link_of_the_argument_is_noticed() {
    let disk = ("Disk", Uniforms::Grid);
    let sincos = Poly::sincos_turns;
    let kernels = Kernels::of(Uniforms::Grid, sincos);
    let products = |all| Roundings {
        products: false,
        ..all
    };
    assert_eq!(judged::<Poly>(disk, 0, &kernels, |all| all), None);
    assert!(judged::<Poly>(disk, 0, &kernels, products).is_some());
    assert!(judged::<Poly>(disk, 2, &kernels, |all| all).is_some());
    // The first coefficient of the sine, 6.28, is off by 8 ulp.
    let flawed = Kernels::of(Uniforms::Grid, |t| {
        let (s, c) = sincos(t);
        (s + 8.0 * 4.768_371_6e-7 * t, c)
    });
    assert!(judged::<Poly>(disk, 0, &flawed, |all| all).is_some());

    let concentric = "DiskConcentric";
    let kernels = Kernels::of(Uniforms::Any, Libm::sincos_turns);
    let quotient = |all| Roundings {
        quotient: false,
        ..all
    };
    let square = |all| Roundings {
        square: false,
        ..all
    };
    for (uniforms, left_out) in [
        (Uniforms::Grid, quotient as fn(Roundings) -> Roundings),
        (Uniforms::Any, square),
    ] {
        let map = (concentric, uniforms);
        assert_eq!(judged::<Libm>(map, 0, &kernels, |all| all), None);
        assert!(judged::<Libm>(map, 0, &kernels, left_out).is_some());
    }
}

/// The series that sines and cosines are compared with is right to far less than is said of it.
#[test]
fn the_series_of_sine_and_cosine_is_exact() {
    for k in 0..=1 << 16 {
        let t = f64::from(k) / f64::from(1 << 19);
        let ((s, c), (sine, cosine)) = (phases::sincos(t), (std::f64::consts::TAU * t).sin_cos());
        assert!(
            (s - sine).abs() <= 1e-15 && (c - cosine).abs() <= 1e-15,
            "{t}"
        );
    }
}
