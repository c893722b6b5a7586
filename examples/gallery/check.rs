//! The numbers of the table: each warp is compared with its density, with its exact counterpart and
//! with the clock.

use crate::catalogue::{Domain, Entry, Measure, Point, Uniforms};
use crate::table::p_text;
use microwarp::uniform;
use rand_pcg::Pcg32;
use statrs::distribution::{ChiSquared, ContinuousCDF};
use std::time::Instant;

/// A p-value below this is no accident in any number of runs.
pub const ALARM: f64 = 1e-9;

/// Cells of the chart along the axes, odd so that no symmetry of a warp falls onto a border.
const LINE_CELLS: [usize; 2] = [501, 1];
const AREA_CELLS: [usize; 2] = [61, 33];

/// Points drawn at a time: a block stays in the nearest cache.
const BLOCK: usize = 512;

/// The generator of one purpose (`purpose`) for one row of the table.
pub fn generator(seed: u64, entry: &Entry, purpose: u64) -> Pcg32 {
    // FNV-1a over the label, so that a row keeps its numbers when another is added above it.
    let hash = |hash: u64, byte| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
    let stream = entry.label().bytes().fold(0xcbf2_9ce4_8422_2325, hash);
    Pcg32::new(seed, stream ^ purpose)
}

/// What was measured for one warp in one tier.
pub struct Figures {
    pub samples: usize,
    /// None where `f32` does not resolve the distribution.
    pub p: Option<f64>,
    /// Samples at which the density is 0, or that are not numbers.
    pub astray: usize,
    /// The largest error of a sample, in the measure of the entry.
    pub error: f64,
    pub nanoseconds: f64,
}

impl Figures {
    /// What is wrong, if anything is.
    pub fn complaint(&self) -> Option<String> {
        if self.astray > 0 {
            Some(format!("{} samples where the density is 0", self.astray))
        } else {
            self.p.filter(|&p| p.is_nan() || p < ALARM).map(|p| {
                format!(
                    "samples do not follow the density, p-value {}",
                    p_text(Some(p))
                )
            })
        }
    }
}

pub fn measure(entry: &Entry, seed: u64, samples: usize) -> Figures {
    let nanoseconds = time(entry, &mut generator(seed, entry, 0));
    let error = largest_error(entry, &mut generator(seed, entry, 1), samples);
    let (p, astray) = shape(entry, &mut generator(seed, entry, 2), samples);
    Figures {
        samples,
        p: entry.resolved.then_some(p),
        astray,
        error,
        nanoseconds,
    }
}

/// Nanoseconds a sample through `fill`: the quickest of many blocks, as other work only slows one down.
fn time(entry: &Entry, rng: &mut Pcg32) -> f64 {
    let block = |rng: &mut Pcg32| {
        let start = Instant::now();
        for _ in 0..8 {
            std::hint::black_box(entry.warp.fill(rng, BLOCK));
        }
        start.elapsed().as_secs_f64() * 1e9 / (8 * BLOCK) as f64
    };
    (0..200).map(|_| block(rng)).fold(f64::INFINITY, f64::min)
}

/// The largest error of samples at drawn uniforms.
fn largest_error(entry: &Entry, rng: &mut Pcg32, samples: usize) -> f64 {
    let mut largest = 0.0_f64;
    for _ in 0..samples {
        let mut u: Uniforms = [0.0; 4];
        for u in &mut u[..entry.uniforms] {
            *u = uniform::grid(rng);
        }
        let exact = entry.truth.sample(u.map(f64::from));
        let got = entry.warp.sample(u).map(f64::from);
        let distance = (0..3)
            .map(|k| (got[k] - exact[k]).powi(2))
            .sum::<f64>()
            .sqrt();
        let error = match entry.measure {
            Measure::Ulp => distance / ulp(exact[0]),
            Measure::UlpOf(scale) => distance / ulp(scale),
            Measure::Length(length) => distance / length,
        };
        // Of a number and NaN, `max` takes the number; here NaN is an error without bound.
        largest = largest.max(if error.is_nan() { f64::INFINITY } else { error });
    }
    largest
}

/// The spacing of `f32` at a magnitude.
fn ulp(x: f64) -> f64 {
    let exponent = x.abs().max(f64::from(f32::MIN_POSITIVE)).log2().floor();
    2f64.powi(exponent as i32 - 23)
}

/// The p-value of the chi-square test of samples against the density, and how many samples have none.
fn shape(entry: &Entry, rng: &mut Pcg32, samples: usize) -> (f64, usize) {
    let [columns, rows] = match entry.domain {
        Domain::Line => LINE_CELLS,
        _ => AREA_CELLS,
    };
    let mut counts = vec![0_u32; columns * rows];
    let (mut left, mut astray) = (samples, 0);
    while left > 0 {
        let block = left.min(BLOCK);
        for point in entry.warp.fill(rng, block) {
            let [u, v, ..] = entry.chart.invert(point.map(f64::from));
            if u.is_finite() && v.is_finite() && entry.warp.pdf(point) > 0.0 {
                let cell =
                    |u: f64, cells: usize| ((u * cells as f64).max(0.0) as usize).min(cells - 1);
                counts[cell(v, rows) * columns + cell(u, columns)] += 1;
            } else {
                astray += 1;
            }
        }
        left -= block;
    }
    let expected = |cell: usize| {
        samples as f64 * mass(entry, [cell % columns, cell / columns], [columns, rows])
    };
    let pairs = counts
        .iter()
        .enumerate()
        .map(|(cell, &count)| (f64::from(count), expected(cell)));
    (chi_square(pairs), astray)
}

/// The probability of a cell of the chart: the crate's own density, by quadrature in f64.
fn mass(entry: &Entry, cell: [usize; 2], cells: [usize; 2]) -> f64 {
    /// Gauss-Legendre of four nodes on [0, 1].
    const NODES: [(f64, f64); 4] = [
        (0.069_431_844_202_973_71, 0.173_927_422_568_726_93),
        (0.330_009_478_207_571_87, 0.326_072_577_431_273_07),
        (0.669_990_521_792_428_1, 0.326_072_577_431_273_07),
        (0.930_568_155_797_026_3, 0.173_927_422_568_726_93),
    ];
    let flat = cells[1] == 1;
    let rows: &[(f64, f64)] = if flat { &[(0.5, 1.0)] } else { &NODES };
    let mut sum = 0.0;
    for (s, weight_s) in NODES {
        for &(t, weight_t) in rows {
            let u = (cell[0] as f64 + s) / cells[0] as f64;
            let v = (cell[1] as f64 + t) / cells[1] as f64;
            let point: Point = entry.chart.sample([u, v, 0.0, 0.0]).map(|x| x as f32);
            // The chart's own density is the reciprocal of its Jacobian.
            let stretch = entry.chart.pdf(point.map(f64::from));
            sum += weight_s * weight_t * f64::from(entry.warp.pdf(point)) / stretch;
        }
    }
    sum / (cells[0] * cells[1]) as f64
}

/// Pearson's test of (observed, expected) counts; cells that expect fewer than 5 are pooled.
fn chi_square(pairs: impl Iterator<Item = (f64, f64)>) -> f64 {
    let (mut cells, small): (Vec<_>, Vec<_>) = pairs.partition(|pair| pair.1 >= 5.0);
    let pool = small
        .iter()
        .fold((0.0, 0.0), |sum, pair| (sum.0 + pair.0, sum.1 + pair.1));
    if pool.0 > 0.0 && pool.1 == 0.0 {
        // Samples where none can be.
        return 0.0;
    }
    match cells.last_mut() {
        // A pool that is itself too small joins a neighbour.
        Some(last) if pool.1 < 5.0 => *last = (last.0 + pool.0, last.1 + pool.1),
        _ => cells.push(pool),
    }
    let statistic: f64 = cells
        .iter()
        .map(|(seen, expected)| (seen - expected).powi(2) / expected)
        .sum();
    let freedom = cells.len().max(2) as f64 - 1.0;
    ChiSquared::new(freedom).map_or(f64::NAN, |distribution| distribution.sf(statistic))
}
