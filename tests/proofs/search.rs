//! A search for the largest error of a map, near where its bound is reached.

use crate::bounds::Worst;
use crate::inputs::Uniforms;
use crate::phases::Cell;
use crate::radii::Radii;
use host::figures::{Exact, Figures, sample_error};
use host::registry::Entry;

/// Phases and first uniforms that are tried with each other.
const PHASES: usize = 64;
const RADII: u32 = 4096;

/// A hash of a counter.
pub fn spread(k: u32) -> u32 {
    let mixed = k.wrapping_add(1).wrapping_mul(0x9e37_79b9);
    let mixed = (mixed ^ (mixed >> 15)).wrapping_mul(0x85eb_ca6b);
    mixed ^ (mixed >> 13)
}

/// The nearest uniform, of the grid if so asked.
fn uniform(uniforms: Uniforms, u: f64) -> f32 {
    match uniforms {
        Uniforms::Grid => ((u * 16_777_216.0).round() / 16_777_216.0) as f32,
        Uniforms::Any => u as f32,
    }
}

/// The largest errors found where a bound is reached.
pub fn near(
    worst: &Worst,
    entry: &Entry,
    uniforms: Uniforms,
    radii: &Radii,
    cells: &[Cell],
    kernel: impl Fn(f32) -> (f32, f32),
) -> Figures {
    let concentric = matches!(entry.name, "DiskConcentric" | "MalleyHemisphere");
    let phases = cells[worst.cell].worst(kernel, worst.direction, PHASES);
    let mut within = radii.bins[worst.bin].uniforms;
    if concentric {
        // A bin is at both ends of the square; numbers of the square are rounded at the lower one.
        within.high = within.high.min(within.low + 1.0 / 64.0);
    }
    let mut figures = Figures::default();
    let mut at = |u1: f32, u2: f32| {
        let u = [u1, u2, 0.0, 0.0];
        let x = entry.warp.sample(u);
        sample_error(entry, &Exact::of(entry, u, false), x, &mut figures);
    };
    for i in 0..RADII {
        let share = f64::from(spread(i)) / 4_294_967_296.0;
        let u1 = uniform(uniforms, within.low + share * (within.high - within.low));
        for &phase in &phases {
            if concentric {
                // The second number of the square for this quotient, of either sign.
                let b = 8.0 * f64::from(phase) * (2.0 * f64::from(u1) - 1.0);
                at(u1, uniform(uniforms, 0.5 + 0.5 * b));
                at(u1, uniform(uniforms, 0.5 - 0.5 * b));
            } else {
                at(u1, uniform(uniforms, f64::from(phase)));
            }
        }
    }
    figures
}
