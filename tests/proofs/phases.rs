//! The error of sine and cosine over every phase of the first eighth of a turn. The other seven are its mirror
//! images: a phase is reduced exactly, and the kernels are odd and even.

use crate::inputs::{STRIDE, Uniforms, in_parallel};
use crate::range::Range;
use std::f64::consts::{PI, TAU};

/// The error is measured along this many axes of the plane, a half turn in all. A vector is longer than the
/// longest of its projections by no more than [`MISSED`].
pub const AXES: usize = 16;

/// 1/cos(π/32).
pub const MISSED: f64 = 1.004_838_572_4;

/// Every `f32` from here to the eighth is tried. Below, see [`Cell::near_the_axis`].
const FIRST: f32 = 1.0 / 128.0;
const LAST: f32 = 0.125;

/// Phases that are worked out together.
const BLOCK: usize = 64;

/// What sine and cosine do over neighbouring phases.
pub struct Cell {
    /// The phases, in turns.
    pub turns: Range,
    /// The largest sine and cosine.
    pub s: f64,
    pub c: f64,
    /// Projections of the error onto each axis.
    pub along: [Range; AXES],
    /// The same onto the direction of the point itself.
    pub radial: Range,
    /// Whose phases these are, and which.
    uniforms: Uniforms,
    steps: std::ops::Range<u32>,
}

/// The k-th axis.
pub fn axis(k: usize) -> [f64; 2] {
    let (s, c) = (PI * k as f64 / AXES as f64).sin_cos();
    [c, s]
}

/// Sine and cosine of at most an eighth of a turn by Taylor's series: the first terms left out are below 5e-17 and
/// 3e-18, and the roundings together below 1e-15.
#[inline]
pub fn sincos(turns: f64) -> (f64, f64) {
    let x = TAU * turns;
    let z = x * x;
    let (mut s, mut c) = (1.0, 1.0);
    for k in (0..8).rev().map(|j| 2.0 * f64::from(j)) {
        s = 1.0 - z * (1.0 / ((k + 2.0) * (k + 3.0))) * s;
        c = 1.0 - z * (1.0 / ((k + 1.0) * (k + 2.0))) * c;
    }
    (x * s, c)
}

/// The i-th phase.
#[inline]
fn phase(uniforms: Uniforms, i: u32) -> f32 {
    match uniforms {
        Uniforms::Grid => i as f32 / 16_777_216.0,
        Uniforms::Any => f32::from_bits(FIRST.to_bits() + i),
    }
}

impl Cell {
    /// Measures a kernel, which returns sine and cosine, over the phases of one cell.
    fn of(
        kernel: impl Fn(f32) -> (f32, f32),
        uniforms: Uniforms,
        steps: std::ops::Range<u32>,
    ) -> Self {
        let axes: [_; AXES] = std::array::from_fn(axis);
        let [mut turns, mut sine, mut cosine, mut radial] = [Range::NONE; 4];
        let mut along = [Range::NONE; AXES];
        let stride = *STRIDE;
        for start in steps.clone().step_by(BLOCK * stride as usize) {
            let [mut t, mut s, mut c, mut x, mut y, mut r] = [[0.0; BLOCK]; 6];
            for j in 0..BLOCK {
                // The last block is filled up with the last phase.
                let phase = phase(uniforms, (start + j as u32 * stride).min(steps.end - 1));
                let (found_s, found_c) = kernel(phase);
                (t[j], s[j], c[j]) = (f64::from(phase), f64::from(found_s), f64::from(found_c));
                let (exact_s, exact_c) = sincos(t[j]);
                (x[j], y[j]) = (c[j] - exact_c, s[j] - exact_s);
                r[j] = x[j] * exact_c + y[j] * exact_s;
            }
            turns.take_all(&t);
            sine.take_all(&s);
            cosine.take_all(&c);
            radial.take_all(&r);
            for (along, [ax, ay]) in along.iter_mut().zip(axes) {
                along.take_all(&std::array::from_fn::<_, BLOCK, _>(|j| {
                    x[j] * ax + y[j] * ay
                }));
            }
        }
        Self {
            turns,
            s: sine.high,
            c: cosine.high,
            along,
            radial,
            uniforms,
            steps,
        }
    }

    /// All phases below the first that is tried. The cosine is 1 less at most 1.3e-3: its last rounding is worth 2^-25,
    /// and the ones before, 2^-22 of 1.3e-3 together, 3e-10. The sine, below 0.05, has an error of 2e-8
    /// even if it is off by 2^-21 of itself, which four roundings cannot bring about. What comes on top is `more` along
    /// the axis, and less than a tenth of it across.
    fn near_the_axis(more: f64) -> Self {
        Self {
            turns: Range {
                low: 0.0,
                high: f64::from(FIRST),
            },
            s: 0.05,
            c: 1.0,
            along: std::array::from_fn(|k| {
                let [ax, ay] = axis(k);
                Range::both((3.02e-8 + more) * ax.abs() + (2.4e-8 + 0.1 * more) * ay.abs())
            }),
            radial: Range::both(3.02e-8 + 0.05 * 2.4e-8 + 1.01 * more),
            uniforms: Uniforms::Any,
            steps: 0..0,
        }
    }

    /// The phases whose errors along a direction are largest.
    pub fn worst(
        &self,
        kernel: impl Fn(f32) -> (f32, f32),
        [dx, dy]: [f64; 2],
        count: usize,
    ) -> Vec<f32> {
        let error = |t: f32| {
            let ((s, c), (exact_s, exact_c)) = (kernel(t), sincos(f64::from(t)));
            (f64::from(c) - exact_c) * dx + (f64::from(s) - exact_s) * dy
        };
        let phases = self.steps.clone().map(|i| phase(self.uniforms, i));
        let mut found: Vec<_> = phases.map(|t| (error(t), t)).collect();
        found.sort_by(|a, b| b.0.total_cmp(&a.0));
        found.into_iter().take(count).map(|(_, t)| t).collect()
    }
}

/// Measures a kernel over all phases: of the grid, or every `f32` there is. It may be off by `more` than sine and
/// cosine are by themselves.
pub fn sweep(
    uniforms: Uniforms,
    kernel: impl Fn(f32) -> (f32, f32) + Sync,
    more: f64,
) -> Vec<Cell> {
    // So many phases, the last included, in cells of so many.
    let (count, cell) = match uniforms {
        Uniforms::Grid => (1 << 21, 1 << 14),
        Uniforms::Any => (LAST.to_bits() - FIRST.to_bits(), 1 << 17),
    };
    let mut cells = in_parallel(count / cell, |i| {
        Cell::of(&kernel, uniforms, i * cell..(i + 1) * cell + 1)
    });
    if uniforms == Uniforms::Any {
        cells.push(Cell::near_the_axis(more));
    }
    cells
}
