//! The statistics behind the tests of distributions: p-values, the threshold of a family of tests, and
//! the cells and quadrature nodes along one axis of a chart's unit square.
//!
//! What is tallied in the cells, and for which warps, is not said here: see `tests/distributions`.

use crate::errors::or_infinite;
use crate::registry::{Entry, Measure};
use statrs::distribution::{ChiSquared, ContinuousCDF, Normal};
use std::sync::atomic::{AtomicUsize, Ordering};

/// The chance that a correct crate fails anywhere in a suite of tests; a tenth of what is promised,
/// because the statistics follow their limiting laws only nearly.
const FAMILY: f64 = 1e-7;

/// The p-value below which one of `tests` independent tests rejects, after Sidak.
pub fn threshold(tests: usize) -> f64 {
    -((-FAMILY).ln_1p() / tests as f64).exp_m1()
}

/// Whether no p-value is below the threshold. Written so that NaN does not pass.
pub fn passes(p_values: &[f64], threshold: f64) -> bool {
    !p_values.is_empty() && p_values.iter().all(|p| *p >= threshold)
}

pub fn assert_passes(what: &str, p_values: &[f64], threshold: f64) {
    println!("{what}: {p_values:.3?}");
    assert!(passes(p_values, threshold), "{what}: {p_values:?}");
}

pub fn assert_rejected(what: &str, p_values: &[f64], threshold: f64) {
    println!("{what}: {p_values:?}");
    assert!(!passes(p_values, threshold), "{what} passes: {p_values:?}");
}

/// A family of tests in one program: no more p-values of what is right than are foreseen, which are counted as they come.
pub struct Family {
    tests: usize,
    judged: AtomicUsize,
}

impl Family {
    pub const fn of(tests: usize) -> Self {
        let judged = AtomicUsize::new(0);
        Self { tests, judged }
    }

    pub fn assert_passes(&self, what: &str, p_values: &[f64]) {
        let before = self.judged.fetch_add(p_values.len(), Ordering::Relaxed);
        assert!(before + p_values.len() <= self.tests, "{what}: more tests");
        assert_passes(what, p_values, threshold(self.tests));
    }

    pub fn assert_rejected(&self, what: &str, p_values: &[f64]) {
        assert_rejected(what, p_values, threshold(self.tests));
    }
}

/// Chi-square, degrees of freedom and p-value, cells that expect fewer than 5 being pooled.
///
/// A sample where none can be, and an expectation that is not a number, are errors and not p-values.
pub fn chi_square(observed: &[u64], expected: &[f64]) -> Result<(f64, usize, f64), String> {
    assert_eq!(observed.len(), expected.len());
    let (mut cells, mut pool) = (Vec::new(), (0.0, 0.0));
    for (&o, &e) in observed.iter().zip(expected) {
        if !(e >= 0.0 && e.is_finite()) {
            return Err(format!("a cell expects {e} samples"));
        }
        if e == 0.0 && o > 0 {
            return Err(format!("{o} samples in a cell of zero density"));
        }
        if e >= 5.0 {
            cells.push((o as f64, e));
        } else {
            pool = (pool.0 + o as f64, pool.1 + e);
        }
    }
    // A pool that is itself too small goes to a cell that is not.
    match cells.last_mut() {
        Some(last) if pool.1 < 5.0 => *last = (last.0 + pool.0, last.1 + pool.1),
        _ => cells.push(pool),
    }
    let dof = cells.len() - 1;
    let chi2: f64 = cells.iter().map(|(o, e)| (o - e) * (o - e) / e).sum();
    let law = ChiSquared::new(dof as f64).map_err(|e| format!("{dof} degrees of freedom: {e}"))?;
    Ok((chi2, dof, law.sf(chi2)))
}

/// p-values of equal frequencies in the cells of two and of three of the nine words of neighbours i, i + 1 and i + 2, one
/// of them being of i. Twelve bits make a cell, as many of each word, from its highest but `shift` on.
pub fn dependences(neighbours: &[[u32; 3]], shifts: &[u32]) -> Vec<f64> {
    let expected = vec![neighbours.len().saturating_sub(2) as f64 / 4096.0; 4096];
    let p = |shift: u32, chosen: &[usize]| {
        let width = 12 / chosen.len() as u32;
        let mut cells = vec![0; 4096];
        for row in neighbours.windows(3) {
            let bits = |k: usize| row[k / 3][k % 3].rotate_left(shift + width) & ((1 << width) - 1);
            let cell = |cell: u32, &k: &usize| cell << width | bits(k);
            cells[chosen.iter().fold(0, cell) as usize] += 1;
        }
        chi_square(&cells, &expected).map_or(f64::NAN, |found| found.2)
    };
    let mut found = Vec::new();
    for &shift in shifts {
        for (a, b) in (0..3).flat_map(|a| (a + 1..9).map(move |b| (a, b))) {
            found.push(p(shift, &[a, b]));
            found.extend((b + 1..9).map(|c| p(shift, &[a, b, c])));
        }
    }
    found
}

/// The chance of a Kolmogorov-Smirnov distance of at least `d` among `n` samples.
///
/// statrs has the test but sorts its samples for it, and 10^7 of them in every entry take too long; it
/// does not offer the law alone, whose series this is. `tests/distributions` compares the two.
pub fn kolmogorov(d: f64, n: f64) -> f64 {
    let x = d * n.sqrt();
    if x < 0.2 {
        // Where the series converges slowly the chance is 1 to 12 digits; NaN goes on to the series.
        return 1.0;
    }
    let term = |k: i32| (-2.0 * f64::from(k * k) * x * x).exp();
    2.0 * (1..50)
        .map(|k| if k % 2 == 1 { term(k) } else { -term(k) })
        .sum::<f64>()
}

/// The p-value of numbers that should be uniform in [0, 1], by Kolmogorov and Smirnov's distance; sorts them.
pub fn p_value_of_uniforms(numbers: &mut [f64]) -> f64 {
    numbers.sort_unstable_by(f64::total_cmp);
    let n = numbers.len() as f64;
    let off = |(i, u): (usize, &f64)| (u - i as f64 / n).abs().max((u - (i + 1) as f64 / n).abs());
    let distance = numbers.iter().enumerate().map(off);
    // So that NaN is rejected.
    let distance = distance.fold(0.0_f64, |worst, off| worst.max(or_infinite(off)));
    kolmogorov(distance, n)
}

/// The chance that a standard normal is at least as far from 0 as `z`.
pub fn two_sided(z: f64) -> f64 {
    2.0 * Normal::standard().sf(z.abs())
}

/// Nodes and weights of Gauss and Legendre's rule of five points on [0, 1], by Newton's method.
fn gauss_legendre() -> [(f64, f64); 5] {
    std::array::from_fn(|i| {
        let mut x = (std::f64::consts::PI * (i as f64 + 0.75) / 5.5).cos();
        let mut slope = 0.0;
        for _ in 0..20 {
            let (mut before, mut p) = (1.0, x);
            for k in 2..=5 {
                let k = f64::from(k);
                (before, p) = (p, ((2.0 * k - 1.0) * x * p - (k - 1.0) * before) / k);
            }
            slope = 5.0 * (x * p - before) / (x * x - 1.0);
            x -= p / slope;
        }
        (0.5 + 0.5 * x, 1.0 / ((1.0 - x * x) * slope * slope))
    })
}

/// A division of one axis of the unit square into cells, and of each cell into finer ones for
/// Kolmogorov and Smirnov's distance, which is thus read at some 3e4 places and not at every sample.
/// That can only make it smaller, by at most a tenth of its standard deviation.
pub struct Axis {
    pub borders: Vec<f64>,
    /// Fine cells in a cell.
    pub fine: usize,
}

impl Axis {
    pub fn new(cells: usize, place: impl Fn(f64) -> f64) -> Self {
        let fine = 32_768 / cells;
        let count = cells * fine;
        let mut borders = vec![0.0; count + 1];
        for i in 1..count {
            borders[i] = place(i as f64 / count as f64).max(borders[i - 1]);
        }
        borders[count] = 1.0;
        Self { borders, fine }
    }

    /// An axis that does not exist.
    pub fn none() -> Self {
        Self {
            borders: vec![0.0, 1.0],
            fine: 1,
        }
    }

    pub fn count(&self) -> usize {
        self.borders.len() - 1
    }

    pub fn cells(&self) -> usize {
        self.count() / self.fine
    }

    pub fn find(&self, u: f64) -> usize {
        let last = self.count() - 1;
        let mut i = ((u * self.count() as f64) as usize).min(last);
        while i > 0 && u < self.borders[i] {
            i -= 1;
        }
        while i < last && u >= self.borders[i + 1] {
            i += 1;
        }
        i
    }

    /// Quadrature nodes: cell, place, weight. Panels shrink by halves towards both ends, `grades`
    /// times, because there maps onto a domain have their singularities.
    pub fn nodes(&self, grades: i32) -> Vec<(usize, f64, f64)> {
        let rule = gauss_legendre();
        let mut nodes = Vec::new();
        let cells = self.cells();
        for cell in 0..cells {
            let (a, b) = (
                self.borders[cell * self.fine],
                self.borders[(cell + 1) * self.fine],
            );
            let mut cuts = vec![0.0, 1.0];
            if cell == 0 {
                cuts.extend((1..=grades).map(|g| 2f64.powi(-g)));
            }
            if cell + 1 == cells {
                cuts.extend((1..=grades).map(|g| 1.0 - 2f64.powi(-g)));
            }
            cuts.sort_by(f64::total_cmp);
            cuts.dedup();
            for cut in cuts.windows(2) {
                let (start, width) = (a + cut[0] * (b - a), (cut[1] - cut[0]) * (b - a));
                nodes.extend(rule.map(|(x, w)| (cell, start + x * width, w * width)));
            }
        }
        nodes
    }
}

/// Half an ulp: how far beyond the rounding to nearest a sample on the line is granted to be off.
const GRANTED: f64 = 0.5;

/// How many samples, and in how many cells, `f32` bears on the line.
///
/// Samples that are off by g ulp move g s of the mass across a border, s being ulp times density. Taken
/// as independent from border to border, that adds 2 N K² g² mean(s²) to a chi-square of K cells; it may
/// add no more than a quarter of its standard deviation √(2K). To √N times Kolmogorov and Smirnov's
/// distance it adds at most √N g max(s), which may be 0.1. First there are fewer cells, then fewer samples.
pub fn resolve(entry: &Entry, n: usize) -> (usize, usize) {
    let spacing = |u: f64| {
        let x = entry.chart.sample([u, 0.0, 0.0, 0.0]);
        let size = match entry.measure {
            Measure::UlpOf(size) | Measure::UlpAbove(size) => size.max(x[0].abs()),
            Measure::UlpFrom(mean, least) => mean.abs().max((x[0] - mean).abs()).max(least),
            _ => x[0].abs(),
        } as f32;
        let ulp = f64::from(f32::from_bits(size.to_bits() + 1)) - f64::from(size);
        ulp * entry.chart.pdf(x)
    };
    let steps: Vec<f64> = (0..1024)
        .map(|i| spacing((f64::from(i) + 0.5) / 1024.0))
        .collect();
    let mean_square = steps.iter().map(|s| s * s).sum::<f64>() / 1024.0;
    let largest = steps.iter().copied().fold(0.0, f64::max);
    let added = |k: f64| 2.0 * n as f64 * k * k * GRANTED * GRANTED * mean_square;
    let allowed = |k: f64| 0.25 * (2.0 * k).sqrt();
    let ladder = [511, 255, 127, 63, 31, 15];
    let bearable = ladder
        .into_iter()
        .find(|&k| added(k as f64) <= allowed(k as f64));
    let cells = bearable.unwrap_or(15);
    let few = n as f64 * (allowed(cells as f64) / added(cells as f64)).min(1.0);
    (cells, few.min((0.1 / (GRANTED * largest)).powi(2)) as usize)
}

/// The border between a float and its upper neighbour, near a quantile: there rounding to nearest
/// moves no mass across.
pub fn between_floats(entry: &Entry, u: f64) -> f64 {
    let x = entry.chart.sample([u, 0.0, 0.0, 0.0])[0] as f32 + 0.0;
    let bits = x.to_bits();
    let above = f32::from_bits(if x >= 0.0 { bits + 1 } else { bits - 1 });
    let border = 0.5 * (f64::from(x) + f64::from(above));
    entry.chart.invert([border, 0.0, 0.0])[0].clamp(0.0, 1.0)
}
