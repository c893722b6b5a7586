//! Each warp keeps the error bounds that its documentation states.
//!
//! The bounds are read out of the documentation itself: the table in each warp's doc comment, and the
//! table of every parameter set in `docs/accuracy.md`. Measured errors must not exceed them, and a bound
//! more than a quarter above what is measured fails too, so that none goes stale.
//! `MICROWARP_WRITE=1 cargo test --test accuracy` measures and writes both anew.

mod catalogue;
#[path = "accuracy/figures.rs"]
mod figures;
#[path = "accuracy/tables.rs"]
mod tables;

use catalogue::{Domain, Entry, Uniforms, entries};
use figures::{Exact, Figures, density_and_inverse_error, polar_error, sample_error};
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

const GRID: u32 = 1 << 24;
const STEP: f32 = 1.0 / 16_777_216.0;

/// Uniforms at which maps break: the ends, the middle, and values off the grid.
const EDGES: [f32; 16] = [
    0.0,
    1.0e-45,
    1.0e-40,
    f32::MIN_POSITIVE,
    1.0e-20,
    STEP,
    2.0 * STEP,
    1.0e-3,
    0.25,
    0.5 - STEP,
    0.5,
    0.5 + STEP,
    0.75,
    1.0 - 2.0 * STEP,
    1.0 - STEP,
    0.333_333_34,
];

/// One warp with one parameter set, in both tiers.
type Pair = (Entry, Entry);

fn pairs() -> Vec<Pair> {
    let (libm, poly): (Vec<_>, Vec<_>) = entries().into_iter().partition(|e| e.tier == "libm");
    assert_eq!(libm.len(), poly.len());
    libm.into_iter().zip(poly).collect()
}

/// Measures both tiers of one warp: over every grid input where the input is one number, over a
/// dense grid with all edges where it is two. Further parameter sets of the same warp are swept with a
/// prime stride, which visits every residue.
fn measure((libm, poly): &Pair, first_of_name: bool) -> [Figures; 2] {
    let stride = if first_of_name { 1 } else { 29 };
    let mut figures = [Figures::default(); 2];
    let mut at = |u: Uniforms, deep: bool, polar: bool| {
        let exact = Exact::of(libm, u, deep);
        for (entry, figures) in [libm, poly].into_iter().zip(&mut figures) {
            let x = entry.warp.sample(u);
            if polar {
                polar_error(entry, &exact, x, figures);
            }
            sample_error(entry, &exact, x, figures);
            if deep {
                density_and_inverse_error(entry, &exact, x, figures);
            }
        }
    };
    match libm.uniforms {
        1 => {
            for k in (0..GRID).step_by(stride) {
                at([k as f32 * STEP, 0.0, 0.0, 0.0], true, false);
            }
            for u in EDGES {
                // Generators yield nothing between 0 and 2^-64; samples hold there all the same.
                at([u, 0.0, 0.0, 0.0], u == 0.0 || u >= 5.0e-20, false);
            }
        }
        2 => {
            if libm.domain == Domain::Directions
                && libm.name != "MalleyHemisphere"
                && libm.name != "SphericalPatch"
            {
                for k in (0..GRID).step_by(stride) {
                    at([k as f32 * STEP, 0.0, 0.0, 0.0], false, true);
                }
            }
            // An odd stride walks through all residues of the grid, not just round numbers.
            let n = 640;
            let axis: Vec<f32> = (0..n)
                .map(|i| ((i * 21_845 + 11) % GRID) as f32 * STEP)
                .chain(EDGES)
                .collect();
            for &u1 in &axis {
                for &u2 in &axis {
                    at([u1, u2, 0.0, 0.0], true, false);
                }
            }
        }
        n => {
            for k in 0..GRID / 16 {
                let u = [0x9e37_79b9, 0x85eb_ca6b, 0xc2b2_ae35_u32, 0x27d4_eb2f]
                    .map(|m| (k.wrapping_mul(m) >> 8) as f32 * STEP);
                let u = std::array::from_fn(|i| if i < n { u[i] } else { 0.0 });
                at(u, true, false);
            }
            for u in EDGES {
                at([u; 4], true, false);
            }
        }
    }
    figures
}

#[test]
fn every_warp_keeps_its_stated_error() {
    let pairs = pairs();
    let next = AtomicUsize::new(0);
    let measured = Mutex::new(vec![[Figures::default(); 2]; pairs.len()]);
    let threads = std::thread::available_parallelism().map_or(2, usize::from);
    std::thread::scope(|scope| {
        for _ in 0..threads {
            scope.spawn(|| {
                loop {
                    let i = next.fetch_add(1, Ordering::Relaxed);
                    let Some(pair) = pairs.get(i) else { break };
                    let first_of_name = i == 0 || pairs[i - 1].0.name != pair.0.name;
                    let figures = measure(pair, first_of_name);
                    measured.lock().unwrap()[i] = figures;
                }
            });
        }
    });
    let measured = measured.into_inner().unwrap();
    let rows: Vec<_> = pairs
        .iter()
        .zip(measured)
        .map(|((libm, _), figures)| tables::Measured {
            name: libm.name,
            parameters: libm.parameters,
            measure: libm.measure,
            figures,
        })
        .collect();
    if std::env::var_os("MICROWARP_WRITE").is_some() {
        tables::write(&rows);
    }
    tables::check(&rows);
}

/// The measurement itself notices an error of the size it is there to find.
#[test]
fn a_wrong_warp_is_noticed() {
    let pairs = pairs();
    let find = |name: &str| &pairs.iter().find(|(e, _)| e.name == name).unwrap().1;
    let (disk, exponential) = (find("Disk"), find("Exponential"));
    let u = [0.3, 0.7, 0.0, 0.0];
    let exact = Exact::of(disk, u, true);
    let mut figures = Figures::default();
    sample_error(
        disk,
        &exact,
        [0.3 * -0.309_017, 0.3 * -0.951_056_5, 0.0],
        &mut figures,
    );
    assert!(
        figures.sample > 0.2,
        "the disk with r = u passes: {figures:?}"
    );
    let exact = Exact::of(exponential, u, true);
    let x = exponential.warp.sample(u);
    let off = f32::from_bits(x[0].to_bits() + 4);
    let mut figures = Figures::default();
    sample_error(exponential, &exact, [off, 0.0, 0.0], &mut figures);
    assert!(figures.sample > 3.0, "four steps off pass: {figures:?}");
    let mut figures = Figures::default();
    sample_error(exponential, &exact, [f32::NAN, 0.0, 0.0], &mut figures);
    assert!(figures.sample == f64::INFINITY, "NaN passes: {figures:?}");
}
