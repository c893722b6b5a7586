//! The test of distribution: points, mapped back by the exact inverse, are uniform; by chi-square over cells and by
//! Kolmogorov and Smirnov's distance along each axis.

use crate::bias::Shows;
use crate::cells;
use crate::power::Power;
use crate::sampler::{Fill, Law, Point};
use host::stats;
use rand_pcg::Pcg32;

/// Places along an axis where the distance is read.
const PLACES: usize = 1 << 15;
const CHUNK: usize = 1 << 12;

/// The test results of a sampler's points.
#[derive(Clone, Debug)]
pub struct Shape {
    pub samples: usize,
    /// Chi-square and its degrees of freedom.
    pub chi2: f64,
    pub freedom: usize,
    /// The p-value of chi-square, then those of the distances.
    pub p: Vec<f64>,
}

/// How many tests there are of a point of so many axes.
pub fn tests(axes: usize) -> usize {
    1 + axes
}

/// Draws points and tests them.
pub fn examine(fill: &Fill, law: &Law, samples: usize, rng: &mut Pcg32) -> Shape {
    let mut tally = Tally::new(law);
    let mut points = vec![[0.0; 3]; CHUNK];
    let mut left = samples;
    while left > 0 {
        let chunk = &mut points[..left.min(CHUNK)];
        left -= chunk.len();
        fill(rng, chunk);
        chunk.iter().for_each(|point| tally.count(*point));
    }
    tally.judge()
}

/// Tests points that have been drawn.
pub fn examine_points(points: impl Iterator<Item = Point>, law: &Law) -> Shape {
    let mut tally = Tally::new(law);
    points.for_each(|point| tally.count(point));
    tally.judge()
}

/// How many points there are where.
struct Tally<'a> {
    law: &'a Law,
    samples: usize,
    observed: Vec<u64>,
    places: Vec<Vec<u64>>,
    /// Whether some point had no cell.
    astray: bool,
}

impl<'a> Tally<'a> {
    fn new(law: &'a Law) -> Self {
        Self {
            law,
            samples: 0,
            observed: vec![0; cells::count(law.axes)],
            places: vec![vec![0; PLACES]; law.axes],
            astray: false,
        }
    }

    fn count(&mut self, point: Point) {
        let axes = self.law.axes;
        let u = self.law.chart.invert(point);
        self.astray |= !u[..axes].iter().all(|u| u.is_finite());
        self.observed[cells::cell(u, axes)] += 1;
        for (places, u) in self.places.iter_mut().zip(u) {
            places[cells::part(u, PLACES)] += 1;
        }
        self.samples += 1;
    }

    fn judge(self) -> Shape {
        let n = self.samples as f64;
        let count = self.observed.len();
        let expected = vec![n / count as f64; count];
        let (chi2, freedom, p) = match stats::chi_square(&self.observed, &expected) {
            Ok(outcome) if !self.astray => outcome,
            _ => (f64::NAN, 1, f64::NAN),
        };
        let mut p = vec![p];
        for places in self.places {
            let (mut below, mut distance) = (0, 0.0_f64);
            for (i, count) in (1..).zip(places) {
                below += count;
                distance = distance.max((below as f64 / n - f64::from(i) / PLACES as f64).abs());
            }
            p.push(stats::kolmogorov(distance, n));
        }
        Shape {
            samples: self.samples,
            chi2,
            freedom,
            p,
        }
    }
}

impl Shape {
    /// The lowest p-value; NaN if one is.
    pub fn worst(&self) -> f64 {
        let least = |a: f64, b: f64| if a < b || a.is_nan() { a } else { b };
        self.p.iter().copied().fold(f64::INFINITY, least)
    }

    pub fn passes(&self, threshold: f64) -> bool {
        stats::passes(&self.p, threshold)
    }

    /// What so many samples say of a bias: less than would have made chi-square larger than it is.
    pub fn bound(&self) -> Shows {
        let power = Power::of(self.freedom);
        // A value that is lower than it should be is luck, and rules out no more than the value to be expected.
        let value = self.chi2.max(self.freedom as f64);
        let lambda = power.ruled_out(value) / self.samples as f64;
        Shows::NotBelow(power.needed() / lambda)
    }
}
