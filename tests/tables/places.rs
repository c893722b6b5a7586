//! Where in its cell a word or a uniform falls, and the way back.

use crate::masses::cases;
use crate::{draw, halves, step_below};
use microwarp::discrete::{Cdf, PiecewiseConstant1d};
use microwarp::uniform::{LARGEST, grid_from_word};
use microwarp::{Invert, Warp};

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
        macro_rules! in_each_cell {
            ($table:ident, $split:expr, $coarse:expr) => {
                let mut last = f32::NEG_INFINITY;
                for j in (0..count).filter(|j| case.weights[*j] > 0) {
                    let words = $table.cdf().words_of(j).unwrap();
                    let (first, end) = (*words.start(), *words.end());
                    let numerator = $table.cdf().numerator(j) as f64;
                    let third = first + (end - first) / 3;
                    for word in [first, third, end - (end - first) / 5, end] {
                        let x = draw(&$table, &$split(word));
                        let exact = place(j, (word - first) as f64 / numerator);
                        let off = (f64::from(x) - exact).abs();
                        assert!(off <= tolerance, "{word}: {x:e} for {exact:e}");
                        assert!(x >= last && $table.cell(x) == j);
                        last = x;
                        // On the grid of uniforms, drawing is sampling.
                        let coarse: u32 = $coarse(word) & !0xff;
                        let mut words = $split(0);
                        words[0] = coarse;
                        assert_eq!(draw(&$table, &words), $table.sample(grid_from_word(coarse)));
                    }
                }
            };
        }
        in_each_cell!(narrow, |word: u32| [word], |word: u32| word);
        in_each_cell!(wide, halves, |word: u64| (word >> 32) as u32);
    }
}

/// A cell of 4 words in 2³² lies between two points of the 24-bit grid, and is drawn.
#[test]
fn drawing_reaches_cells_between_points_of_the_grid() {
    let weights = [1 << 29, 1, (1 << 29) - 1];
    let cdf = Cdf::from_integers(&weights).unwrap();
    let table = PiecewiseConstant1d::from_cdf(cdf, 0.0, 3.0).unwrap();
    assert_eq!(cdf.words_of(1), Some((1 << 31)..=(1 << 31) + 3));
    let drawn = [0, 1, 2, 3].map(|k| draw(&table, &[(1 << 31) + k]));
    assert_eq!(drawn, [1.0, 1.25, 1.5, 1.75]);
    assert_eq!(draw(&table, &[(1 << 31) + 4]), 2.0);
    // The next point of the grid is beyond it; a uniform below the grid and below a word has its own place.
    assert_eq!(table.sample(0.5), 1.0);
    assert_eq!(table.cell(table.sample(0.5 + 2f32.powi(-24))), 2);
    assert_eq!(
        PiecewiseConstant1d::from_cdf(Cdf::new(&[1.0]).unwrap(), 0.0, 1.0)
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
            for x in [
                case.edge(j).next_down(),
                case.edge(j),
                case.edge(j).next_up(),
            ] {
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
