//! Tables of two dimensions: the probability of every cell, dark rows and columns, single bright texels,
//! tables made by the compiler.

use crate::{draw, edge, halves};
use microwarp::discrete::{PiecewiseConstant2d, Word};
use microwarp::{Error, Warp, constant};

type Narrow<'a> = PiecewiseConstant2d<&'a [u32], &'a [u32]>;
type Wide<'a> = PiecewiseConstant2d<&'a [u64], &'a [u64]>;

const U: [f32; 2] = [-3.0, 5.0];
const V: [f32; 2] = [0.1, 0.7];

/// Whole weights as floats; they must be so small that floats hold them.
fn floats(weights: &[u32]) -> Vec<f32> {
    assert!(weights.iter().all(|w| *w <= 1 << 24));
    weights.iter().map(|w| *w as f32).collect()
}

/// Four roundings and two of the masses.
const DENSITY: f64 = 3.0 * f32::EPSILON as f64;

/// Judges every cell: its probability is the product of two numerators, within 2 steps of its share, its
/// density that probability over its area, and its outermost words lead into it.
fn judge(weights: &[u32], [columns, rows]: [usize; 2]) {
    let (mut marginal, mut conditional) = (vec![0; rows], vec![0; columns * rows]);
    let table = Narrow::new_in(
        &floats(weights),
        [columns, rows],
        U,
        V,
        &mut marginal,
        &mut conditional,
    );
    let table = table.unwrap();
    assert_eq!(table.shape(), [columns, rows]);
    let total: u128 = weights.iter().map(|w| u128::from(*w)).sum();
    let mut sum = 0_u128;
    for row in 0..rows {
        let along_v = u128::from(table.marginal().cdf().numerator(row));
        let conditional = table.conditional(row);
        let v = [edge(V, rows, row), edge(V, rows, row + 1)];
        for column in 0..columns {
            let weight = u128::from(weights[row * columns + column]);
            let numerator = along_v * u128::from(conditional.cdf().numerator(column));
            sum += numerator;
            let off = (numerator * total).abs_diff(weight << 64);
            assert!(off < total << 33, "cell {column}, {row}: {off}");
            let u = [edge(U, columns, column), edge(U, columns, column + 1)];
            let pdf = table.pdf([u[0], v[0]]);
            assert_eq!(pdf, table.pdf([u[1].next_down(), v[1].next_down()]));
            assert_eq!(table.cell([u[0], v[0]]), [column, row]);
            assert_eq!(
                table.cell([u[1].next_down(), v[1].next_down()]),
                [column, row]
            );
            if weight == 0 {
                assert_eq!((numerator, pdf), (0, 0.0), "cell {column}, {row}");
                continue;
            }
            let area = (f64::from(u[1]) - f64::from(u[0])) * (f64::from(v[1]) - f64::from(v[0]));
            let mass = numerator as f64 / 2f64.powi(64);
            let error = (f64::from(pdf) * area / mass - 1.0).abs();
            assert!(error <= DENSITY, "cell {column}, {row}: {error:e}");
            let along_v = table.marginal().cdf().words_of(row).unwrap();
            let along_u = conditional.cdf().words_of(column).unwrap();
            for words in [
                [*along_u.start(), *along_v.start()],
                [*along_u.end(), *along_v.end()],
            ] {
                let x = draw(&table, &words);
                assert_eq!(table.cell(x), [column, row]);
                assert!(
                    x[0] >= u[0] && x[0] < u[1] && x[1] >= v[0] && x[1] < v[1],
                    "{x:?}"
                );
                assert!(table.pdf(x) > 0.0);
                let grid = words.map(|w| microwarp::uniform::grid_from_word(w & !0xff));
                assert!(table.pdf(table.sample(grid)) > 0.0);
            }
        }
    }
    assert_eq!(sum, 1 << 64);
    // A finished table is taken back as it was, and cells of equal words are equal tables.
    let (marginal, conditional) = table.as_words();
    assert_eq!(Narrow::from_words(marginal, conditional, U, V), Ok(table));
}

#[test]
fn every_cell_has_the_product_of_its_two_probabilities() {
    let mixed = |j: usize| (j as u32).wrapping_mul(2_654_435_761) >> 20;
    for shape in [
        [1, 1],
        [1, 2],
        [2, 1],
        [1, 257],
        [257, 1],
        [3, 2],
        [7, 5],
        [32, 16],
        [100, 99],
    ] {
        let [columns, rows] = shape;
        let cells = columns * rows;
        judge(&vec![1; cells], shape);
        judge(&(0..cells).map(|j| mixed(j) + 1).collect::<Vec<_>>(), shape);
        // Dark cells, dark columns, dark rows, at the ends too, and a single bright texel in the dark.
        let dark: Vec<u32> = (0..cells)
            .map(|j| (mixed(j) % 4) * u32::from(j % 3 < 2))
            .collect();
        let column: Vec<u32> = (0..cells)
            .map(|j| u32::from(j % columns % 3 == 1))
            .collect();
        let row: Vec<u32> = (0..cells)
            .map(|j| 7 * u32::from(j / columns % 3 == 1))
            .collect();
        let only: Vec<u32> = (0..cells).map(|j| u32::from(j == cells / 2)).collect();
        for weights in [dark, column, row, only] {
            if weights.iter().any(|w| *w > 0) {
                judge(&weights, shape);
            }
        }
    }
}

#[test]
fn a_bright_texel_among_a_million_keeps_its_share() {
    let shape = [1000, 1000];
    let mut weights = vec![1; 1_000_000];
    weights[637_411] = 1_000_000;
    judge(&weights, shape);
}

#[test]
fn a_sun_of_1e30_needs_words_of_64_bits() {
    let shape = [1000, 1000];
    let mut weights = vec![1.0; 1_000_000];
    weights[637_411] = 1e30;
    // The first dark row is what a table of 32 bits does not reach; its first cell stands for it.
    weights[0] = 0.0;
    let (mut marginal, mut conditional) = (vec![0; 1000], vec![0; 1_000_000]);
    let refused = Narrow::new_in(&weights, shape, U, V, &mut marginal, &mut conditional);
    assert_eq!(refused.err(), Some(Error::Unreachable(1)));
    // Where all else is dark, the row is fine and its own cells are not.
    let row = &weights[637_000..638_000];
    let (mut one, mut cells) = ([0; 1], vec![0; 1000]);
    let refused = Narrow::new_in(row, [1000, 1], U, V, &mut one, &mut cells);
    assert_eq!(refused.err(), Some(Error::Unreachable(0)));
    let mut lower = vec![0.0; 2000];
    lower[1000..].copy_from_slice(row);
    lower[1000..1005].fill(0.0);
    let (mut two, mut cells) = ([0; 2], vec![0; 2000]);
    let refused = Narrow::new_in(&lower, [1000, 2], U, V, &mut two, &mut cells);
    assert_eq!(refused.err(), Some(Error::Unreachable(1005)));

    let (mut marginal, mut conditional) = (vec![0; 1000], vec![0; 1_000_000]);
    let table = Wide::new_in(&weights, shape, U, V, &mut marginal, &mut conditional).unwrap();
    let mut sum = 0_u128;
    for row in 0..1000 {
        let along_v = table.marginal().cdf().words_of(row).unwrap();
        let conditional = table.conditional(row);
        let steps: u128 = (0..1000)
            .map(|column| conditional.cdf().numerator(column))
            .sum();
        assert_eq!(steps, u64::TOTAL);
        sum += table.marginal().cdf().numerator(row);
        for column in [0, 1, 410, 411, 412, 999] {
            let Some(along_u) = conditional.cdf().words_of(column) else {
                assert_eq!([column, row], [0, 0]);
                continue;
            };
            for (u, v) in [
                (along_u.start(), along_v.start()),
                (along_u.end(), along_v.end()),
            ] {
                let words = [halves(*u), halves(*v)].concat();
                let x = draw(&table, &words);
                assert_eq!(table.cell(x), [column, row]);
                assert!(table.pdf(x) > 0.0);
            }
        }
    }
    assert_eq!(sum, u64::TOTAL);
    let sun = table.marginal().cdf().numerator(637);
    assert!(u64::TOTAL - sun < 1 << 24, "{sun}");
}

const SKY: [[f32; 32]; 16] = {
    let mut sky = [[1.0; 32]; 16];
    sky[3] = [0.0; 32];
    sky[11][21] = 1000.0;
    let mut row = 0;
    while row < 16 {
        sky[row][9] = 0.0;
        row += 1;
    }
    sky
};

/// The compiler builds the table and flash holds it.
static TABLE: PiecewiseConstant2d<[u32; 16], [[u32; 32]; 16]> =
    constant!(PiecewiseConstant2d::new(&SKY, [0.0, 2.0], [0.0, 1.0]));

#[test]
fn a_table_of_512_cells_is_a_constant() {
    let (marginal, conditional) = TABLE.as_words();
    assert_eq!(
        size_of_val(marginal) + size_of_val(conditional),
        4 * (16 + 512)
    );
    // Beside the words only the ranges are kept.
    assert!(
        size_of_val(&TABLE) <= 4 * (16 + 512) + 48,
        "{}",
        size_of_val(&TABLE)
    );
    assert_eq!(TABLE.shape(), [32, 16]);
    // At run time the same words come out, wherever the table is kept.
    let flat: Vec<f32> = SKY.concat();
    let (mut rows, mut cells) = ([0; 17], [0; 600]);
    let table = Narrow::new_in(
        &flat,
        [32, 16],
        [0.0, 2.0],
        [0.0, 1.0],
        &mut rows,
        &mut cells,
    )
    .unwrap();
    assert_eq!(table.as_words(), TABLE.as_words());
    let rows = heapless::Vec::<u32, 20>::from_slice(marginal).unwrap();
    let cells = heapless::Vec::<u32, 512>::from_slice(conditional).unwrap();
    let bounded = PiecewiseConstant2d::from_words(rows, cells, [0.0, 2.0], [0.0, 1.0]).unwrap();
    let words = [0x1234_5678, 0x9abc_def0];
    assert_eq!(TABLE.sample_words(words), draw(&TABLE, &words));
    let mut lit = 0;
    for k in 0..100_000_u32 {
        let words = [k.wrapping_mul(0x9e37_79b9), k.wrapping_mul(0x85eb_ca6b)];
        let x = draw(&TABLE, &words);
        assert_eq!((x, x), (draw(&table, &words), draw(&bounded, &words)));
        let pdf = TABLE.pdf(x);
        assert!(pdf > 0.0 && pdf == table.pdf(x) && pdf == bounded.pdf(x));
        let [column, row] = TABLE.cell(x);
        assert!(SKY[row][column] > 0.0);
        lit += u32::from(SKY[row][column] > 1.0);
    }
    // 1000 of 1464, and the words of a counter are as even as can be.
    assert!(lit.abs_diff(68_306) < 1000, "{lit}");
}
