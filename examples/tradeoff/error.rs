//! The errors of points and densities against the exact ones of the same uniforms.

use crate::sampler::{Law, Point, Sampler, Way, Words};
use host::contest::generator;
use host::errors::raise;

/// Errors over a sweep. NaN counts as infinite.
#[derive(Clone, Copy, Debug, Default)]
pub struct Figures {
    pub max: f64,
    squares: f64,
    sum: Point,
    count: f64,
}

impl Figures {
    fn observe(&mut self, error: Point) {
        self.raise(length(error));
        self.squares += error.iter().map(|e| e * e).sum::<f64>();
        (0..3).for_each(|k| self.sum[k] += error[k]);
        self.count += 1.0;
    }

    /// An error that counts for the largest alone, of words that are tried for their place.
    fn raise(&mut self, size: f64) {
        raise(&mut self.max, size);
    }

    pub fn rms(&self) -> f64 {
        (self.squares / self.count).sqrt()
    }

    /// By how much the errors shift the mean of the points: of a number with its sign.
    pub fn mean(&self) -> f64 {
        let mean = self.sum.map(|sum| sum / self.count);
        if mean[1] == 0.0 && mean[2] == 0.0 {
            mean[0]
        } else {
            length(mean)
        }
    }

    pub fn is_known(&self) -> bool {
        self.count > 0.0
    }

    fn scaled(mut self, factor: f64) -> Self {
        self.max *= factor;
        self.squares *= factor * factor;
        self.sum = self.sum.map(|sum| sum * factor);
        self
    }
}

fn length(x: Point) -> f64 {
    x.iter().map(|x| x * x).sum::<f64>().sqrt()
}

/// The errors of a sampler.
#[derive(Clone, Copy, Debug, Default)]
pub struct Errors {
    /// The distance of the point from the exact one; of a table, of the probability of an entry.
    pub point: Figures,
    /// The largest error of a coordinate.
    pub coordinate: f64,
    /// The density at the returned point, in units of the largest density.
    pub density: Figures,
    /// The same error in units of the density itself.
    pub relative: f64,
    /// The largest density met.
    pub peak: f64,
}

impl Errors {
    fn observe(&mut self, exact: Point, point: Point, counts: bool) {
        let error: Point = std::array::from_fn(|k| point[k] - exact[k]);
        if counts {
            self.point.observe(error);
        } else {
            self.point.raise(length(error));
        }
        self.coordinate = error
            .iter()
            .fold(self.coordinate, |max, e| max.max(e.abs()));
    }
}

impl Errors {
    /// Holds a density that is reported to the true one.
    fn judge(&mut self, density: f64, due: f64, counts: bool) {
        let error = density - due;
        if counts {
            self.density.observe([error, 0.0, 0.0]);
        } else {
            self.density.raise(error.abs());
        }
        self.relative = self.relative.max(error.abs() / due);
        self.peak = self.peak.max(due);
    }

    /// The errors of densities in units of the largest, once that is known.
    fn of_peak(mut self) -> Self {
        if self.peak > 0.0 {
            self.density = self.density.scaled(1.0 / self.peak);
        }
        self
    }
}

/// 2⁻³².
const WORD: f64 = 1.0 / 4_294_967_296.0;

impl Law {
    /// The exact uniforms of which a map makes a point.
    fn uniforms(&self, words: Words, bits: u32) -> [f64; 4] {
        let smallest = if self.open {
            f64::from(f32::from_bits(1))
        } else {
            0.0
        };
        words.map(|word| match word >> (32 - bits) {
            0 => smallest,
            number => f64::from(number << (32 - bits)) * WORD,
        })
    }
}

/// The words next to powers of two, where maps change their form.
fn edges(bits: u32) -> Vec<u32> {
    let near = (0..=bits).flat_map(|k| [-1, 0, 1].map(|d| (1_i64 << k) + d));
    near.map(|number| ((number as u64) << (32 - bits)) as u32)
        .collect()
}

/// The errors of a sampler over so many points, and over all edges.
pub fn measure(sampler: &Sampler, points: u64) -> Errors {
    match &sampler.way {
        Way::Map(map) => {
            let at = |words| {
                let exact = sampler
                    .law
                    .truth
                    .sample(sampler.law.uniforms(words, map.bits));
                let (point, density) = (map.at)(words);
                (exact, point, density)
            };
            sweep(&sampler.law, map.bits, points, at)
        }
        // The points of an exact law, each rounded to the nearest that the sampler can return.
        Way::Rejection(numbers) => {
            let rounded = sweep(&sampler.law, 24, points, |words| {
                let exact = sampler.law.truth.sample(sampler.law.uniforms(words, 24));
                (exact, exact.map(|x| numbers.nearest(x)), None)
            });
            Errors {
                point: rounded.point,
                coordinate: rounded.coordinate,
                ..densities(sampler, points)
            }
        }
        Way::Repaired(repaired) => {
            let mut drawn = vec![[0.0; 3]; points as usize];
            (sampler.fill)(&mut generator(), &mut drawn);
            let mut errors = Errors::default();
            for point in drawn {
                errors.observe(repaired(point), point, true);
            }
            errors
        }
        Way::Table(entries) => {
            let mut errors = Errors::default();
            for entry in entries {
                errors.observe([entry.due, 0.0, 0.0], [entry.realised, 0.0, 0.0], true);
                if let Some(reported) = entry.reported {
                    errors.judge(reported, entry.realised, true);
                }
            }
            errors.of_peak()
        }
        Way::Opaque => Errors::default(),
    }
}

/// The errors of densities at points that are drawn.
fn densities(sampler: &Sampler, points: u64) -> Errors {
    let (mut errors, mut rng) = (Errors::default(), generator());
    if let Some(judged) = &sampler.judged {
        for _ in 0..points {
            let (point, density) = judged(&mut rng);
            errors.judge(density, sampler.law.truth.pdf(point), true);
        }
    }
    errors.of_peak()
}

fn sweep(
    law: &Law,
    bits: u32,
    points: u64,
    at: impl Fn(Words) -> (Point, Point, Option<f64>),
) -> Errors {
    let mut errors = Errors::default();
    let mut look = |words: Words, counts: bool| {
        let (exact, point, density) = at(words);
        errors.observe(exact, point, counts);
        if let Some(density) = density {
            errors.judge(density, law.truth.pdf(point), counts);
        }
    };
    let steps = Lattice::new(law.uniforms);
    for k in 0..points {
        look(steps.at(k), true);
    }
    let edges = edges(bits);
    let second = if law.uniforms > 1 { &edges[..] } else { &[0] };
    for &a in &edges {
        for &b in second {
            look([a, b, b, a], false);
        }
    }
    errors.of_peak()
}

/// Points that fill the unit cube more evenly than any generator's: the multiples of numbers that are badly
/// approximable together, the inverse powers of the root of x^(d + 1) = x + 1.
///
/// Source: M. Roberts, "The Unreasonable Effectiveness of Quasirandom Sequences", 2018.
pub struct Lattice([u64; 4]);

impl Lattice {
    pub fn new(axes: usize) -> Self {
        let degree = axes as f64 + 1.0;
        let root = (0..64).fold(1.5, |root: f64, _| (1.0 + root).powf(1.0 / degree));
        // Odd, so that all words occur.
        Self([1, 2, 3, 4].map(|k| (root.powi(-k) / WORD / WORD) as u64 | 1))
    }

    pub fn at(&self, k: u64) -> Words {
        self.0.map(|step| (step.wrapping_mul(k + 1) >> 32) as u32)
    }
}
