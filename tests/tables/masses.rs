//! What a cell reports is what its words realise: probabilities and densities.

use crate::edge;
use microwarp::Warp;
use microwarp::discrete::{Cdf, PiecewiseConstant1d, Word};

/// Three roundings: of the mass, of the width, of their quotient.
const DENSITY: f64 = 1.5 * f32::EPSILON as f64;

pub struct Case {
    pub weights: Vec<u32>,
    pub range: [f32; 2],
}

impl Case {
    pub fn edge(&self, j: usize) -> f32 {
        edge(self.range, self.weights.len(), j)
    }

    /// How wide a cell is, in its actual floats.
    pub fn width(&self, j: usize) -> f64 {
        f64::from(self.edge(j + 1)) - f64::from(self.edge(j))
    }

    pub fn larger(&self) -> f32 {
        self.range[0].abs().max(self.range[1].abs())
    }

    pub fn narrow<'a>(&self, memory: &'a mut [u32]) -> PiecewiseConstant1d<&'a [u32]> {
        let cdf = Cdf::<&[u32]>::from_integers_in(&self.weights, memory).unwrap();
        PiecewiseConstant1d::from_cdf(cdf, self.range[0], self.range[1]).unwrap()
    }

    pub fn wide<'a>(&self, memory: &'a mut [u64]) -> PiecewiseConstant1d<&'a [u64]> {
        let cdf = Cdf::<&[u64]>::from_integers_in(&self.weights, memory).unwrap();
        PiecewiseConstant1d::from_cdf(cdf, self.range[0], self.range[1]).unwrap()
    }
}

/// Weights of every kind over ranges of every kind.
pub fn cases() -> Vec<Case> {
    let mut cases = Vec::new();
    for range in [
        [0.0, 1.0],
        [-3.0, 5.0],
        [1e6, 1e6 + 4096.0],
        [-3e38, 3e38],
        [0.0, 1e-30],
        [-1e-3, 0.7],
    ] {
        for count in [1, 2, 7, 10, 100, 1001] {
            let mixed = |j: u32| j.wrapping_mul(2_654_435_761) >> 16;
            let mut kinds: Vec<Vec<u32>> = vec![
                vec![1; count],
                (0..count as u32).map(|j| mixed(j) % 1000 + 1).collect(),
                (0..count as u32)
                    .map(|j| (mixed(j) % 5).saturating_sub(2))
                    .collect(),
                (0..count as u32).map(|j| 1 << (j % 24)).collect(),
            ];
            kinds.retain(|weights| weights.iter().any(|w| *w > 0));
            cases.extend(kinds.into_iter().map(|weights| Case { weights, range }));
        }
    }
    cases
}

/// Floats of a cell: all of them where they are few, the ends and some between otherwise.
fn floats(lower: f32, upper: f32) -> Vec<f32> {
    let mut all = vec![lower];
    while all.len() < 48 && all[all.len() - 1].next_up() < upper {
        all.push(all[all.len() - 1].next_up());
    }
    let between = (1..16).map(|k| (0.0625 * k as f32).mul_add(upper - lower, lower));
    all.extend(between.filter(|x| *x >= lower && *x < upper));
    all.push(upper.next_down());
    all
}

/// The density is one number in all of a cell, and times the width of the cell in floats the probability
/// of its words. Returns the worst relative error.
fn realised<W>(case: &Case, density: &dyn Fn(f32) -> f32, numerator: &dyn Fn(usize) -> f64) -> f64
where
    W: Word,
{
    let mut worst = 0.0_f64;
    let mut sum = 0.0;
    for j in 0..case.weights.len() {
        let (lower, upper) = (case.edge(j), case.edge(j + 1));
        let pdf = density(lower);
        for x in floats(lower, upper) {
            assert_eq!(density(x).to_bits(), pdf.to_bits(), "{x:e} in cell {j}");
        }
        let mass = f64::from(pdf) * case.width(j);
        let exact = numerator(j) * f64::from(W::STEP);
        assert_eq!(mass > 0.0, case.weights[j] > 0);
        // A density below the normal range is as near as its steps allow.
        if exact > 0.0 && pdf >= f32::MIN_POSITIVE {
            worst = worst.max((mass / exact - 1.0).abs());
        }
        sum += mass;
    }
    let normal = case.range[1] < 1e30;
    assert!(!normal || (sum - 1.0).abs() <= DENSITY, "{sum}");
    worst
}

#[test]
fn the_density_of_a_cell_is_the_one_its_words_realise() {
    let mut worst = [0.0_f64; 2];
    for case in cases() {
        let count = case.weights.len();
        let total: u128 = case.weights.iter().map(|w| u128::from(*w)).sum();
        let (mut narrow, mut wide) = (vec![0; count], vec![0; count]);
        let (narrow, wide) = (case.narrow(&mut narrow), case.wide(&mut wide));
        let mut sums = [0_u128; 2];
        for (j, &weight) in case.weights.iter().enumerate() {
            let n = u128::from(narrow.cdf().numerator(j));
            let w = wide.cdf().numerator(j);
            // Within a step of the share of the weight, exactly.
            let weight = u128::from(weight);
            assert!(
                (n * total).abs_diff(weight << 32) < total,
                "{:?}, {count}: {j}",
                case.range
            );
            assert!((w * total).abs_diff(weight << 64) < total);
            sums = [sums[0] + n, sums[1] + w];
        }
        assert_eq!(sums, [1 << 32, 1 << 64]);
        let found = [
            realised::<u32>(&case, &|x| narrow.pdf(x), &|j| {
                narrow.cdf().numerator(j) as f64
            }),
            realised::<u64>(&case, &|x| wide.pdf(x), &|j| wide.cdf().numerator(j) as f64),
        ];
        worst = [0, 1].map(|i| worst[i].max(found[i]));
        for x in [
            case.range[0].next_down(),
            case.range[1].next_up(),
            f32::NAN,
            f32::INFINITY,
        ] {
            assert_eq!((narrow.pdf(x), wide.pdf(x)), (0.0, 0.0), "{x:e}");
        }
    }
    println!("density times width against the words: {worst:?}");
    assert!(worst.iter().all(|worst| *worst <= DENSITY), "{worst:?}");
}

/// The check above notices a density over the width that a cell should have, and one of a CDF that was
/// summed in `f32`.
#[test]
fn plain_densities_are_noticed() {
    let case = Case {
        weights: vec![1; 1001],
        range: [1e6, 1e6 + 4096.0],
    };
    let mut memory = vec![0; 1001];
    let table = case.narrow(&mut memory);
    let nominal = |x: f32| table.cdf().pmf(table.cell(x)) / (4096.0 / 1001.0);
    let worst = (0..1001).map(|j| {
        let exact = table.cdf().numerator(j) as f64 * f64::from(u32::STEP);
        (f64::from(nominal(case.edge(j))) * case.width(j) / exact - 1.0).abs()
    });
    let worst = worst.fold(0.0, f64::max);
    assert!(worst > 1e4 * DENSITY, "{worst}");

    let count = 1 << 20;
    let (mut sum, mut before, mut worst) = (0.0_f32, 0.0_f32, 0.0_f64);
    for _ in 0..count {
        sum += 0.1 / count as f32;
        let share = f64::from(sum / 0.1) - f64::from(before / 0.1);
        worst = worst.max((share - 1.0 / count as f64).abs());
        before = sum;
    }
    assert!(worst > f64::from(u32::STEP), "{worst:e}");
    println!(
        "a sum in f32: {:.0} steps off, in one cell",
        worst / f64::from(u32::STEP)
    );
}
