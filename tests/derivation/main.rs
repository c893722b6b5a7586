//! Every coefficient in the tiers' sources is derived here, and the sources hold exactly these bits.
//!
//! `cargo test --test derivation -- --nocapture` prints the errors of all fits. After a change to a fit,
//! `MICROWARP_WRITE=1 cargo test --test derivation` writes the new coefficients into the sources.
//! Functions are summed from their series; only erf, erfc, exp and log of the normal distribution come
//! from `libm`, in f64 and pure Rust, so that every host derives the same bits.

mod integer_targets;
mod integers;
mod minimax;
mod source;
mod targets;
mod words;

use minimax::{Problem, points};
use targets::{Point, Polynomial, Rational, Split};

/// What one derivation hands over: constants by name, and the error with and without rounding.
struct Derived {
    constants: Vec<(&'static str, Vec<f32>)>,
    ideal: f64,
    rounded: f64,
}

/// The nearest f32.
fn to_f32(x: f64) -> f64 {
    f64::from(x as f32)
}

/// Numbers that are f32 already.
fn narrow(list: &[f64]) -> Vec<f32> {
    list.iter().map(|&x| x as f32).collect()
}

fn powers(x: f64, count: usize) -> impl Iterator<Item = f64> {
    std::iter::successors(Some(1.0), move |p| Some(p * x)).take(count)
}

fn sum(coefficients: &[f32], x: f64) -> f64 {
    coefficients
        .iter()
        .rev()
        .fold(0.0, |sum, &c| sum * x + f64::from(c))
}

impl Polynomial {
    fn derive(&self) -> Derived {
        let at = |x| {
            let Point { x, value, weight } = (self.target)(x);
            (powers(x, self.terms).collect(), value, weight)
        };
        let problem = Problem::new(points(self.interval).into_iter().map(at));
        let coefficients = problem.solve_rounded(&vec![None; self.terms], to_f32);
        Derived {
            ideal: problem.largest_error(&problem.solve()),
            rounded: problem.largest_error(&coefficients),
            constants: vec![(self.name, narrow(&coefficients))],
        }
    }
}

impl Rational {
    /// Fits numerator - value · denominator, divided by the denominator of the previous round, until
    /// the denominator stands still (Loeb's algorithm); then rounds the denominator and fits the
    /// numerator over the rounded one.
    fn derive(&self) -> Derived {
        let points: Vec<Point> = points(self.interval)
            .into_iter()
            .map(|x| (self.target)(x))
            .collect();
        let first = self.first.map(f64::from);
        let free = self.numerator - usize::from(first.is_some());
        let mut denominators = vec![1.0; points.len()];
        let mut solution = Vec::new();
        let mut ideal = f64::INFINITY;
        for _ in 0..30 {
            let problem = Problem::new(points.iter().zip(&denominators).map(|(p, d)| {
                let skipped = usize::from(first.is_some());
                let numerator = powers(p.x, self.numerator).skip(skipped);
                let denominator = powers(p.x, self.denominator + 1).skip(1);
                let basis = numerator.chain(denominator.map(|power| -p.value * power));
                let target = p.value - first.unwrap_or(0.0);
                (basis.collect(), target, p.weight / d)
            }));
            solution = problem.solve();
            for (p, d) in points.iter().zip(&mut denominators) {
                let powers = powers(p.x, self.denominator + 1).skip(1);
                *d = 1.0
                    + powers
                        .zip(&solution[free..])
                        .map(|(a, b)| a * b)
                        .sum::<f64>();
            }
            let error = points.iter().zip(&denominators).map(|(p, d)| {
                let numerator = first.unwrap_or(0.0)
                    + powers(p.x, self.numerator)
                        .skip(usize::from(first.is_some()))
                        .zip(&solution)
                        .map(|(a, b)| a * b)
                        .sum::<f64>();
                (p.weight * (numerator / d - p.value)).abs()
            });
            ideal = error.fold(0.0, f64::max);
        }
        let mut denominator = vec![1.0_f32];
        denominator.extend(solution[free..].iter().map(|&c| c as f32));
        let over_rounded = Problem::new(points.iter().map(|p| {
            let d = sum(&denominator, p.x);
            let basis = powers(p.x, self.numerator).map(|power| power / d);
            (basis.collect(), p.value, p.weight)
        }));
        let mut fixed = vec![None; self.numerator];
        fixed[0] = first;
        let numerator = over_rounded.solve_rounded(&fixed, to_f32);
        Derived {
            ideal,
            rounded: over_rounded.largest_error(&numerator),
            constants: vec![
                (self.names[0], narrow(&numerator)),
                (self.names[1], denominator[1..].to_vec()),
            ],
        }
    }
}

impl Split {
    /// The upper bits of the value as one f32, what is missing as another.
    fn derive(&self) -> Derived {
        let nearest = self.value as f32;
        let high = f32::from_bits(nearest.to_bits() & (!0 << (24 - self.bits)));
        let low = (self.value - f64::from(high)) as f32;
        let values = [high, low][..self.parts].to_vec();
        let error = values
            .iter()
            .fold(self.value, |rest, &v| rest - f64::from(v));
        Derived {
            ideal: 0.0,
            rounded: error.abs() / self.value,
            constants: vec![(self.name, values)],
        }
    }
}

#[test]
fn the_sources_hold_the_derived_bits() {
    let derived = targets::polynomials()
        .iter()
        .map(Polynomial::derive)
        .chain(targets::rationals().iter().map(Rational::derive))
        .chain(targets::splits().iter().map(Split::derive))
        .collect::<Vec<_>>();
    let write = std::env::var_os("MICROWARP_WRITE").is_some();
    let mut wrong = Vec::new();
    let mut underived = source::names();
    println!("{:40} {:>9} {:>9}", "", "minimax", "in f32");
    for Derived {
        constants,
        ideal,
        rounded,
    } in derived
    {
        let names: Vec<&str> = constants.iter().map(|(name, _)| *name).collect();
        println!("{:40} {ideal:9.1e} {rounded:9.1e}", names.join(" / "));
        for (name, values) in constants {
            underived.retain(|other| other != name);
            println!("  {name} {values:?}");
            if write {
                source::write(name, &values);
            }
            let bits = |list: Vec<f32>| list.into_iter().map(f32::to_bits).collect::<Vec<_>>();
            if source::constants(name).map(bits) != Some(bits(values)) {
                wrong.push(name);
            }
        }
    }
    assert!(underived.is_empty(), "nothing derives {underived:?}");
    assert!(
        wrong.is_empty(),
        "the sources differ from the derivation: {wrong:?}"
    );
}

/// Of all polynomials of degree 4, the one nearest to x⁵ on [-1, 1] differs from it by Chebyshev's T₅/16.
#[test]
fn the_exchange_finds_what_is_known() {
    let on = points([-1.0, 1.0]).into_iter();
    let problem = Problem::new(on.map(|x| (powers(x, 5).collect(), x.powi(5), 1.0)));
    let best = problem.solve();
    let expected = [0.0, -5.0 / 16.0, 0.0, 20.0 / 16.0, 0.0];
    for (c, expected) in best.iter().zip(expected) {
        assert!((c - expected).abs() <= 1.0e-5, "{best:?}");
    }
    assert!((problem.largest_error(&best) - 1.0 / 16.0).abs() <= 1.0e-6);
    // The series of a function is not its best approximation, and the measure of errors says so.
    assert!(problem.largest_error(&[0.0; 5]) > 0.99);
}
