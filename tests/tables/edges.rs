//! Every edge and its neighbours are found in the right cell; samples are in the cell that was selected.

use crate::{draw, edge, equal, step_below};
use host::speed;
use microwarp::discrete::{Cdf, PiecewiseConstant1d};
use microwarp::uniform::grid_from_word;
use microwarp::{Error, Invert, Warp};

const RANGES: [[f32; 2]; 10] = [
    [0.0, 1.0],
    [-3.0, 5.0],
    [1e6, 1e6 + 1.0],
    [-3e38, 3e38],
    [0.0, 1e-30],
    [-1.0, 1.0],
    [-1e-3, 0.7],
    [-0.9, 1e-20],
    [1.000_1, 1.999],
    [-f32::MAX, -1e38],
];

/// The narrowest cells that are granted, of the larger bound.
const LEAST: f64 = 1.0 / 1_048_576.0;

/// How far an edge may be from the exact one, in steps of `f32` below the larger bound.
const ROUNDING: f64 = 2.0;

/// What a walk over all edges saw.
#[derive(Default)]
struct Walk {
    edges: usize,
    /// Places that a look-up without the edges would have put into a wrong cell.
    naive: usize,
    /// The largest error of an edge, in steps.
    off: f64,
}

impl Walk {
    fn judge(&self) {
        let Self { edges, naive, off } = self;
        println!("{edges} edges, at most {off:.2} steps off; a naive look-up: {naive}");
        assert!(*off <= ROUNDING, "{off}");
    }
}

/// Walks over all edges of equal cells of equal weight; nothing where they are too narrow.
fn walk(range: [f32; 2], count: usize, seen: &mut Walk) -> bool {
    let [low, high] = range;
    let larger = low.abs().max(high.abs());
    let width = (f64::from(high) - f64::from(low)) / count as f64;
    let mut memory = vec![0; count];
    let cdf = equal(count, &mut memory);
    let table = match PiecewiseConstant1d::from_cdf(cdf, low, high) {
        Ok(table) => table,
        Err(error) => {
            assert_eq!(error, Error::Empty(2));
            assert!(
                width <= LEAST * f64::from(larger) * (1.0 + 1e-6),
                "{range:?}, {count} cells"
            );
            return false;
        }
    };
    assert!(width >= LEAST * f64::from(larger) * (1.0 - 1e-6));
    let naive = |x: f32| {
        let share = (x - low) / (high - low);
        ((share * count as f32) as usize).min(count - 1)
    };
    assert_eq!([edge(range, count, 0), edge(range, count, count)], range);
    for j in 0..count {
        let (lower, upper) = (edge(range, count, j), edge(range, count, j + 1));
        assert!(upper > lower, "{range:?}, {count} cells: edges {j}");
        let exact = f64::from(low) + width * (j as f64 + 1.0);
        seen.off = seen
            .off
            .max((f64::from(upper) - exact).abs() / step_below(larger));
        for x in [lower, lower.next_up(), upper.next_down()] {
            assert_eq!(table.cell(x), j, "{range:?}, {count} cells: {x:e}");
            seen.naive += usize::from(naive(x) != j);
        }
        // The search through a table that no cache holds takes longest: 300 entries and every 16th beyond.
        if j > 300 && j % 16 != 0 && j + 300 < count {
            continue;
        }
        let words = table.cdf().words_of(j).unwrap();
        let (first, last) = (*words.start(), *words.end());
        for word in [first, first + (last - first) / 2, last] {
            let x = draw(&table, &[word]);
            let inside = x >= lower && x < upper && table.pdf(x) > 0.0;
            assert!(
                inside,
                "{range:?}, {count} cells: word {word} gave {x:e}, not in {j}"
            );
            assert_eq!(table.cell(x), j);
            let u = grid_from_word(word);
            let selected = table.cdf().select_uniform(u).index;
            assert_eq!(table.cell(table.sample(u)), selected);
        }
    }
    assert_eq!(table.cell(high), count - 1);
    seen.edges += count;
    true
}

#[test]
fn every_edge_of_few_cells_is_found() {
    let mut seen = Walk::default();
    for range in RANGES {
        for count in (1..=300).chain([1000, 4096]) {
            walk(range, count, &mut seen);
        }
    }
    seen.judge();
    assert!(seen.edges > 9 * 50_000);
}

#[test]
fn every_edge_of_many_cells_is_found() {
    let mut seen = Walk::default();
    for range in RANGES {
        let mut most = 0;
        let largest = speed::of("most cells", 1 << 18, 1 << 20);
        for count in [65_536, 249_999, 1_000_000, largest] {
            if count > largest {
                continue;
            }
            if walk(range, count, &mut seen) {
                most = count;
            }
        }
        assert!(
            most == largest || range[0] >= 1.0 || range[1] < -1.0,
            "{range:?}: {most}"
        );
    }
    seen.judge();
}

/// As narrow as they are granted, where the guess is worst.
#[test]
fn every_edge_of_the_narrowest_cells_is_found() {
    let mut seen = Walk::default();
    let ranges: [[f32; 2]; 6] = [
        [0.0, 1.0],
        [-1.0, 1.0],
        [-0.9, 1.0],
        [-0.7, 0.3],
        [0.1, 1.1],
        [-3e38, 3e38],
    ];
    let every = speed::of("one range of narrow cells tried of every", 3, 1);
    for range in ranges.into_iter().step_by(every) {
        let larger = f64::from(range[0].abs().max(range[1]));
        let length = f64::from(range[1]) - f64::from(range[0]);
        let most = (length / (LEAST * larger)) as usize;
        for count in [most + 2, most - 1, most / 2 + 1] {
            let granted = walk(range, count, &mut seen);
            assert_eq!(granted, count < most, "{range:?}: {count}");
        }
    }
    seen.judge();
}

/// The walk would not pass without the edges: the plain formula puts many of them into wrong cells.
#[test]
fn a_look_up_without_the_edges_is_wrong() {
    for (range, count, least) in [
        ([0.0, 1.0], 1000, 20),
        ([0.0, 1.0], 1_000_000, 20_000),
        ([-3.0, 5.0], 1000, 20),
    ] {
        let mut seen = Walk::default();
        assert!(walk(range, count, &mut seen));
        println!("{range:?}, {count} cells: {} wrong", seen.naive);
        assert!(seen.naive >= least, "{}", seen.naive);
    }
}

/// Zero cells at the ends, in the middle and in runs: no word leads into them, and none of their points has
/// a density.
#[test]
fn no_sample_lies_in_a_zero_cell() {
    let patterns: [fn(usize) -> bool; 6] = [
        |j| j % 2 == 1,
        |j| j % 2 == 0,
        |j| j == 0,
        |j| j % 7 < 5,
        |j| j % 3 == 1,
        |_| false,
    ];
    for range in RANGES
        .into_iter()
        .filter(|range| range[1] - range[0] != 1.0 || range[0] == 0.0)
    {
        for count in [1, 2, 3, 5, 8, 31, 100, 257] {
            for zero in patterns {
                let weights: Vec<f32> = (0..count)
                    .map(|j| if zero(j) { 0.0 } else { 1.0 + (j % 5) as f32 })
                    .collect();
                let mut memory = vec![0_u32; count];
                let Ok(cdf) = Cdf::<&[u32]>::new_in(&weights, &mut memory) else {
                    assert!(weights.iter().all(|w| *w == 0.0));
                    continue;
                };
                let table = PiecewiseConstant1d::from_cdf(cdf, range[0], range[1]).unwrap();
                for (j, weight) in weights.iter().enumerate() {
                    let (lower, upper) = (edge(range, count, j), edge(range, count, j + 1));
                    for x in [lower, lower.next_up(), upper.next_down()] {
                        assert_eq!(table.pdf(x) > 0.0, *weight > 0.0, "{range:?}: {x:e}");
                        assert!((0.0..1.0).contains(&table.invert(x)));
                    }
                    let Some(words) = table.cdf().words_of(j) else {
                        assert_eq!(*weight, 0.0);
                        continue;
                    };
                    for word in [*words.start(), *words.end()] {
                        let x = draw(&table, &[word]);
                        assert!(x >= lower && x < upper && table.pdf(x) > 0.0);
                    }
                }
                for k in 0..4096_u32 {
                    let x = table.sample(grid_from_word(k << 20 | k));
                    let j = table.cell(x);
                    assert!(weights[j] > 0.0, "{range:?}, {count} cells: {x:e} in {j}");
                    assert!(x >= range[0] && x < range[1]);
                }
            }
        }
    }
}
