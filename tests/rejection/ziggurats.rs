//! The numbers of the ziggurats have their laws, the tails included; a ziggurat with any of the known flaws fails the
//! very same tests.

use crate::curves::{CURVES, Curve, Geometry};
use crate::examination::{FAMILY, histogram, p_value_of_mean, p_value_of_tries};
use crate::layers::{attempt, word};
use host::{speed, stats};
use microwarp::rejection::{Rejection, ZigguratStandardExponential, ZigguratStandardNormal};
use rand_core::Rng;
use rand_pcg::Pcg32;
use std::sync::LazyLock;

/// Numbers of a run.
static NUMBERS: LazyLock<usize> =
    LazyLock::new(|| speed::of("numbers of each ziggurat", 2_000_000, 10_000_000));

/// By what factor controls are more wrong than with all numbers, as those are 2.2² times as many.
static MORE: LazyLock<f64> =
    LazyLock::new(|| speed::of("factor of the errors of controls of ziggurats", 2.3, 1.0));

/// What is wrong with a ziggurat.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Flaw {
    None,
    /// Layer and place are read from the same end of the word.
    SharedHighBits,
    /// What lies beyond the inner part is handed out.
    NoWedge,
    /// What lies beyond the inner part is not.
    InnerAlone,
    /// The tail is exponential, as it is proposed and not yet accepted.
    WrongTail,
    /// There is none.
    NoTail,
}

/// A ziggurat in f64, independent of the crate's.
struct Reference {
    curve: Curve,
    geometry: Geometry,
    flaw: Flaw,
    rng: Pcg32,
}

impl Reference {
    fn new(curve: Curve, flaw: Flaw) -> Self {
        Self {
            curve,
            geometry: curve.geometry(),
            flaw,
            rng: Pcg32::new(77, 7),
        }
    }

    fn uniform(&mut self) -> f64 {
        (f64::from(self.rng.next_u32()) + 0.5) / 4_294_967_296.0
    }

    fn tail(&mut self) -> f64 {
        let start = self.geometry.start;
        if self.curve == Curve::Exponential {
            // Not as steep where it is to be wrong.
            let slope = if self.flaw == Flaw::WrongTail {
                0.95
            } else {
                1.0
            };
            return start - self.uniform().ln() / slope;
        }
        loop {
            let x = -self.uniform().ln() / start;
            let y = -self.uniform().ln();
            if self.flaw == Flaw::WrongTail || 2.0 * y > x * x {
                return start + x;
            }
        }
    }

    fn number(&mut self) -> f64 {
        loop {
            let word = self.rng.next_u32();
            let bits = match self.flaw {
                Flaw::SharedHighBits => word >> 24,
                _ => word & 0xff,
            };
            let (layer, share) = (bits as usize, f64::from(word >> 9) + 0.5);
            let (width, inner) = (self.geometry.widths[layer], self.geometry.widths[layer + 1]);
            let x = share / 8_388_608.0 * width;
            let size = if x < inner {
                x
            } else if layer == 0 {
                if self.flaw == Flaw::NoTail {
                    continue;
                }
                self.tail()
            } else {
                let accepted = match self.flaw {
                    Flaw::NoWedge => true,
                    Flaw::InnerAlone => false,
                    _ => {
                        self.uniform() * self.curve.excess(width, inner)
                            < self.curve.excess(width, x)
                    }
                };
                if !accepted {
                    continue;
                }
                x
            };
            let negative = self.curve == Curve::Normal && word & 0x100 != 0;
            return if negative { -size } else { size };
        }
    }

    fn numbers(&mut self) -> Vec<f64> {
        (0..*NUMBERS).map(|_| self.number()).collect()
    }
}

/// Cells of equal probability, beyond the first and last of which there are ever smaller ones.
fn borders(curve: Curve) -> Vec<f64> {
    let mut borders: Vec<f64> = (1..1023).map(|k| f64::from(k) / 1023.0).collect();
    for k in 11..21 {
        borders.push(1.0 - 2f64.powi(-k));
        if curve == Curve::Normal {
            borders.push(2f64.powi(-k));
        }
    }
    borders.sort_by(f64::total_cmp);
    borders
}

/// Chi-square, Kolmogorov and Smirnov's distance, the numbers beyond the start of the tail, five moments.
fn p_values_of_numbers(curve: Curve, numbers: &[f64]) -> Vec<f64> {
    let n = numbers.len() as f64;
    // Upper probabilities keep their digits in the tail of the normal law only on the other side.
    let mut uniforms: Vec<f64> = numbers.iter().map(|x| curve.cdf(*x)).collect();
    uniforms.sort_unstable_by(f64::total_cmp);
    assert!(uniforms[0] >= 0.0 && uniforms[uniforms.len() - 1] <= 1.0);
    let borders = borders(curve);
    let mut counts = Vec::new();
    let mut expected = Vec::new();
    let (mut before, mut below) = (0, 0.0);
    for border in borders.iter().copied().chain([1.0]) {
        let reached = uniforms.partition_point(|u| *u < border);
        let reached = if border < 1.0 {
            reached
        } else {
            uniforms.len()
        };
        counts.push((reached - before) as u64);
        expected.push((border - below) * n);
        (before, below) = (reached, border);
    }
    let (_, _, chi_square) = stats::chi_square(&counts, &expected).unwrap();
    let start = curve.geometry().start;
    let beyond = numbers.iter().filter(|x| x.abs() > start).count() as f64;
    let total = curve.beyond(0.0);
    let due = n * curve.beyond(start) / total;
    let mut p_values = vec![
        chi_square,
        stats::p_value_of_uniforms(&mut uniforms),
        stats::two_sided((beyond - due) / due.sqrt()),
    ];
    for power in 1..=5 {
        let mean = numbers.iter().map(|x| x.powi(power)).sum::<f64>() / n;
        let (due, squares) = (curve.moment(power), curve.moment(2 * power));
        let deviation = ((squares - due * due) / n).sqrt();
        p_values.push(stats::two_sided((mean - due) / deviation));
    }
    p_values
}

impl Curve {
    /// The mean of x^k: (k − 1)!! or 0, and k!.
    fn moment(self, k: i32) -> f64 {
        let product =
            |from: i32, step: usize| (from..=k).step_by(step).map(f64::from).product::<f64>();
        match self {
            Curve::Normal if k % 2 == 1 => 0.0,
            Curve::Normal => product(1, 2) / if k % 2 == 0 { 1.0 } else { f64::from(k) },
            Curve::Exponential => product(1, 1),
        }
    }

    fn efficiency(self) -> f64 {
        self.beyond(0.0) / (256.0 * self.geometry().area)
    }
}

/// Numbers as f64, and tries.
fn draw(sampler: &impl Rejection<Point = f32>, seed: u64) -> (Vec<f64>, Vec<u32>) {
    let mut rng = Pcg32::new(seed, 0x2199);
    let draws = (0..*NUMBERS).map(|_| {
        let accepted = sampler.draw(&mut rng).unwrap();
        (f64::from(accepted.point), accepted.tries)
    });
    draws.unzip()
}

#[test]
fn moments_are_known() {
    let normal = [0.0, 1.0, 0.0, 3.0, 0.0, 15.0, 0.0, 105.0];
    let exponential = [1.0, 2.0, 6.0, 24.0, 120.0, 720.0, 5040.0, 40320.0];
    for (k, (n, e)) in (1..).zip(normal.into_iter().zip(exponential)) {
        assert_eq!(Curve::Normal.moment(k), n);
        assert_eq!(Curve::Exponential.moment(k), e);
    }
}

#[test]
fn numbers_have_their_law_and_tries_theirs() {
    for curve in CURVES {
        let (numbers, tries) = match curve {
            Curve::Normal => draw(&ZigguratStandardNormal::new(), 1),
            Curve::Exponential => draw(&ZigguratStandardExponential::new(), 2),
        };
        let mut p_values = p_values_of_numbers(curve, &numbers);
        let (tries, e) = (histogram(&tries), curve.efficiency());
        p_values.extend([p_value_of_tries(&tries, e), p_value_of_mean(&tries, e)]);
        assert_eq!(p_values.len(), 10);
        FAMILY.assert_passes(&format!("{curve:?}"), &p_values);
        // A thousandth more or fewer is seen both ways; of fewer numbers three.
        for wrong in [(1.0 - 0.001 * *MORE) * e, (1.0 + 0.001 * *MORE) * e] {
            FAMILY.assert_rejected("histogram", &[p_value_of_tries(&tries, wrong)]);
            FAMILY.assert_rejected("mean", &[p_value_of_mean(&tries, wrong)]);
        }
        let stated = match curve {
            Curve::Normal => ZigguratStandardNormal::EFFICIENCY,
            Curve::Exponential => ZigguratStandardExponential::EFFICIENCY,
        };
        assert_eq!(stated, e as f32);
    }
}

/// The tests themselves: a right ziggurat passes, and every flaw is seen.
#[test]
fn flawed_ziggurats_are_rejected() {
    for curve in CURVES {
        let of = |flaw| p_values_of_numbers(curve, &Reference::new(curve, flaw).numbers());
        FAMILY.assert_passes(&format!("{curve:?}, reference"), &of(Flaw::None));
        for flaw in [
            Flaw::SharedHighBits,
            Flaw::NoWedge,
            Flaw::InnerAlone,
            Flaw::NoTail,
        ] {
            FAMILY.assert_rejected(&format!("{curve:?}, {flaw:?}"), &of(flaw));
        }
    }
}

/// Chi-square and distance of numbers beyond the tail's start.
fn p_values_of_tail(curve: Curve, numbers: impl Iterator<Item = f64>) -> Vec<f64> {
    let start = curve.geometry().start;
    let share = |x: f64| [1.0 - curve.beyond(x) / curve.beyond(start)];
    let uniforms: Vec<[f64; 1]> = numbers.map(share).collect();
    crate::examination::p_values_of_points(&uniforms)
}

/// Numbers of the tail alone, which takes one layer of 256.
#[test]
fn tails_have_their_law() {
    for curve in CURVES {
        let mut rng = Pcg32::new(5, 5);
        let first = word(curve, 0, (1 << 24) - 1);
        let count = speed::of("numbers of each tail", 200_000, 1_000_000);
        let numbers = (0..count).map(|_| {
            let words = [first, rng.next_u32(), rng.next_u32()];
            f64::from(attempt(curve, words).unwrap())
        });
        let name = format!("{curve:?}, tail");
        FAMILY.assert_passes(&name, &p_values_of_tail(curve, numbers));
        let of = |flaw| {
            let mut reference = Reference::new(curve, flaw);
            let numbers: Vec<f64> = (0..count).map(|_| reference.tail()).collect();
            p_values_of_tail(curve, numbers.into_iter())
        };
        FAMILY.assert_passes(&name, &of(Flaw::None));
        FAMILY.assert_rejected(&name, &of(Flaw::WrongTail));
    }
}
