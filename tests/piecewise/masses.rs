//! What a cell reports is what its words realise: probabilities, densities, positions, inverses.

use crate::{above, below, draw, edge, halves, step_below};
use microwarp::Warp;
use microwarp::discrete::{Cdf, PiecewiseConstant1d, Word};
use microwarp::uniform::{LARGEST, grid_from_word};

/// Three roundings: of the mass, of the width, of their quotient.
const DENSITY: f64 = 1.5 * f32::EPSILON as f64;

struct Case {
    weights: Vec<u32>,
    range: [f32; 2],
}

impl Case {
    fn edge(&self, j: usize) -> f32 {
        edge(self.range, self.weights.len(), j)
    }

    /// How wide a cell is, in its actual floats.
    fn width(&self, j: usize) -> f64 {
        f64::from(self.edge(j + 1)) - f64::from(self.edge(j))
    }

    fn larger(&self) -> f32 {
        self.range[0].abs().max(self.range[1].abs())
    }

    fn narrow<'a>(&self, memory: &'a mut [u32]) -> PiecewiseConstant1d<&'a [u32]> {
        let cdf = Cdf::<&[u32]>::from_integers_in(&self.weights, memory).unwrap();
        PiecewiseConstant1d::new(cdf, self.range[0], self.range[1]).unwrap()
    }

    fn wide<'a>(&self, memory: &'a mut [u64]) -> PiecewiseConstant1d<&'a [u64]> {
        let cdf = Cdf::<&[u64]>::from_integers_in(&self.weights, memory).unwrap();
        PiecewiseConstant1d::new(cdf, self.range[0], self.range[1]).unwrap()
    }
}

/// Weights of every kind over ranges of every kind.
fn cases() -> Vec<Case> {
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
    while all.len() < 48 && above(all[all.len() - 1]) < upper {
        all.push(above(all[all.len() - 1]));
    }
    let between = (1..16).map(|k| (0.0625 * k as f32).mul_add(upper - lower, lower));
    all.extend(between.filter(|x| *x >= lower && *x < upper));
    all.push(below(upper));
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
            below(case.range[0]),
            above(case.range[1]),
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

/// A word's place in its cell is its place among the words of the cell.
#[test]
fn drawing_uses_every_bit_of_its_words() {
    for case in cases() {
        let count = case.weights.len();
        let (mut narrow, mut wide) = (vec![0; count], vec![0; count]);
        let (narrow, wide) = (case.narrow(&mut narrow), case.wide(&mut wide));
        let place = |j: usize, share: f64| f64::from(case.edge(j)) + share * case.width(j);
        // Two for the share, which is kept below 1 and whose cell may reach from one end to the other, and the
        // rounding of the sum.
        let tolerance = 2.5 * step_below(case.larger()) + 1e-45;
        let mut last = [f32::NEG_INFINITY; 2];
        for j in (0..count).filter(|j| case.weights[*j] > 0) {
            let words = narrow.cdf().words_of(j).unwrap();
            let (first, end) = (*words.start(), *words.end());
            let numerator = narrow.cdf().numerator(j) as f64;
            for word in [
                first,
                first + (end - first) / 3,
                end - (end - first) / 5,
                end,
            ] {
                let x = draw(&narrow, &[word]);
                let exact = place(j, f64::from(word - first) / numerator);
                assert!(
                    (f64::from(x) - exact).abs() <= tolerance,
                    "{word}: {x:e} for {exact:e}"
                );
                assert!(x >= last[0] && narrow.cell(x) == j);
                last[0] = x;
                // On the grid of uniforms, drawing is sampling.
                let coarse = word & !0xff;
                let drawn = draw(&narrow, &[coarse]);
                assert_eq!(drawn, narrow.sample(grid_from_word(coarse)));
            }
            let words = wide.cdf().words_of(j).unwrap();
            let (first, end) = (*words.start(), *words.end());
            let numerator = wide.cdf().numerator(j) as f64;
            for word in [
                first,
                first + (end - first) / 3,
                end - (end - first) / 5,
                end,
            ] {
                let x = draw(&wide, &halves(word));
                let exact = place(j, (word - first) as f64 / numerator);
                assert!(
                    (f64::from(x) - exact).abs() <= tolerance,
                    "{word}: {x:e} for {exact:e}"
                );
                assert!(x >= last[1] && wide.cell(x) == j);
                last[1] = x;
                let high = (word >> 32) as u32 & !0xff;
                let drawn = draw(&wide, &[high, 0]);
                assert_eq!(drawn, wide.sample(grid_from_word(high)));
            }
        }
    }
}

/// A cell of 4 words in 2³² lies between two points of the 24-bit grid, and is drawn.
#[test]
fn drawing_reaches_cells_between_points_of_the_grid() {
    let weights = [1 << 29, 1, (1 << 29) - 1];
    let cdf = Cdf::<[u32; 3]>::from_integers(&weights).unwrap();
    let table = PiecewiseConstant1d::new(cdf, 0.0, 3.0).unwrap();
    assert_eq!(cdf.words_of(1), Some((1 << 31)..=(1 << 31) + 3));
    let drawn = [0, 1, 2, 3].map(|k| draw(&table, &[(1 << 31) + k]));
    assert_eq!(drawn, [1.0, 1.25, 1.5, 1.75]);
    assert_eq!(draw(&table, &[(1 << 31) + 4]), 2.0);
    // The next point of the grid is beyond it; a uniform below the grid and below a word has its own place.
    assert_eq!(table.sample(0.5), 1.0);
    assert_eq!(table.cell(table.sample(0.5 + 2f32.powi(-24))), 2);
    assert_eq!(
        PiecewiseConstant1d::new(Cdf::<[u32; 1]>::new(&[1.0]).unwrap(), 0.0, 1.0)
            .unwrap()
            .sample(1e-20),
        1e-20
    );
}

/// A larger uniform never gives a smaller point, even where steps of the grid are far below those of `f32`.
#[test]
fn samples_increase_with_the_uniform() {
    for case in cases() {
        let mut memory = vec![0; case.weights.len()];
        let table = case.narrow(&mut memory);
        let mut before = f32::NEG_INFINITY;
        for k in (0..1 << 14).chain((1 << 21)..(1 << 21) + (1 << 14)) {
            let x = table.sample(k as f32 / 16_777_216.0);
            assert!(
                x >= before,
                "{:?} at {k}: {x:e} after {before:e}",
                case.range
            );
            before = x;
        }
    }
}

/// u after sample and inverse, as far as the steps of `f32` in a cell go; x after inverse and sample.
#[test]
fn round_trips_lead_back() {
    for case in cases() {
        let count = case.weights.len();
        let mut memory = vec![0; count];
        let table = case.narrow(&mut memory);
        let step = step_below(case.larger()) * 2.0;
        let mut before = 0.0_f32;
        for k in 0..1 << 12 {
            let u = grid_from_word(k * 1_048_573);
            let x = table.sample(u);
            let back = table.invert(x);
            let density = f64::from(table.pdf(x));
            let error = (f64::from(back) - f64::from(u)).abs();
            assert!(
                error <= 1.5e-7 + 1.5 * step * density,
                "{:?}: {u} gave {back}",
                case.range
            );
            assert!((0.0..1.0).contains(&back));
            // And once more: the second point has the first's place, as far as a uniform can tell.
            let again = table.sample(back);
            let moved = (f64::from(table.invert(again)) - f64::from(back)).abs();
            assert!(moved <= 1.5e-7 + 1.5 * step * density.max(f64::from(table.pdf(again))));
        }
        // The inverse increases, through cells of weight zero too, but for the rounding of its sum.
        for j in 0..=count {
            for x in [below(case.edge(j)), case.edge(j), above(case.edge(j))] {
                let u = table.invert(x);
                assert!(
                    u >= before - f32::EPSILON / 2.0 && u <= LARGEST,
                    "{:?}, {count}: {x:e}",
                    case.range
                );
                before = u;
            }
        }
        assert_eq!(table.invert(f32::NEG_INFINITY), 0.0);
        assert_eq!(table.invert(f32::INFINITY), LARGEST);
        assert!((0.0..1.0).contains(&table.invert(f32::NAN)));
    }
}
