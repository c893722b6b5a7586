//! Densities that are linear between vertices: the area of every trapezoid, edges and zeros, jumps, storage, refusals.

use crate::{Given, edge, step_below};
use microwarp::Error::{
    AllZero, Empty, NegativeWeight, NoWeights, NotATable, NotFiniteWeight, Reversed, TooManyWeights,
};
use microwarp::discrete::{Cdf, PiecewiseLinear1d};
use microwarp::{Invert, Warp, constant};

type Lent<'a> = PiecewiseLinear1d<&'a [u32], &'a [f32]>;

/// Weights of many kinds.
fn kinds(count: usize) -> Vec<Vec<f32>> {
    let mixed = |j: usize| (j as u32).wrapping_mul(2_654_435_761) >> 16;
    vec![
        vec![1.0; count],
        (0..count).map(|j| (mixed(j) % 1000) as f32).collect(),
        (0..count).map(|j| (j % 2) as f32).collect(),
        (0..count).map(|j| ((j + 1) % 3 / 2) as f32).collect(),
        (0..count).map(|j| 10f32.powi(-((j % 7) as i32))).collect(),
        (0..count)
            .map(|j| if j + 1 == count { 3e38 } else { 1e38 })
            .collect(),
    ]
}

const RANGES: [[f32; 2]; 6] = [
    [0.0, 1.0],
    [-3.0, 5.0],
    [1e6, 1e6 + 4096.0],
    [-3e38, 3e38],
    [0.0, 1e-30],
    [-1.0, 0.0],
];

/// The exact number of words of a cell, of 2³²: within one of its area's share.
#[test]
fn every_cell_has_the_area_of_its_trapezoid() {
    for count in [2, 3, 7, 10, 100, 1001] {
        for weights in kinds(count) {
            let mut memory = vec![0_u32; count];
            let table = Lent::new_in(&weights, 0.0, 1.0, &mut memory).unwrap();
            let area = |j: usize| f64::from(weights[j]) + f64::from(weights[j + 1]);
            let total: f64 = (0..count - 1).map(area).sum();
            for j in 0..count - 1 {
                let share = area(j) / total * 2f64.powi(32);
                let numerator = table.cdf().numerator(j) as f64;
                assert!(
                    (numerator - share).abs() <= 1.0 + 1e-5,
                    "{weights:?}: cell {j}"
                );
                assert_eq!(numerator > 0.0, area(j) > 0.0);
            }
            assert_eq!(table.cdf().numerator(count - 1), 0);
        }
    }
}

/// At the ends of every cell: the density is that of its vertices, 0 at a vertex of weight zero, and no sample of the
/// outermost words leaves its cell or has density 0; samples rise.
#[test]
fn edges_have_the_densities_of_their_vertices() {
    let (mut jumps, mut checked) = (0.0_f64, 0);
    for range in RANGES {
        for count in [2, 3, 7, 100, 1001] {
            for weights in kinds(count) {
                let mut memory = vec![0_u32; count];
                let table = Lent::new_in(&weights, range[0], range[1], &mut memory).unwrap();
                let mut before = f32::NEG_INFINITY;
                for j in 0..count - 1 {
                    let (low, high) = (edge(range, count - 1, j), edge(range, count - 1, j + 1));
                    let Some(words) = table.cdf().words_of(j) else {
                        assert_eq!((table.pdf(low), table.pdf(high.next_down())), (0.0, 0.0));
                        continue;
                    };
                    assert_eq!(table.pdf(low) > 0.0, weights[j] > 0.0, "{range:?} {low:e}");
                    let (first, last) = (*words.start(), *words.end());
                    for word in [
                        first,
                        first + (last - first) / 3,
                        last - (last - first) / 3,
                        last,
                    ] {
                        let x = table.draw(&mut Given(&[word]));
                        assert!(
                            x >= low && x < high && x >= before,
                            "{range:?}: {x:e} in {j}"
                        );
                        assert!(table.pdf(x) > 0.0, "{range:?}: density 0 at {x:e}");
                        assert!((0.0..1.0).contains(&table.invert(x)));
                        before = x;
                    }
                    // The jump at the lower vertex, within what the page says.
                    if j > 0 && weights[j] > 0.0 && table.pdf(low) >= f32::MIN_POSITIVE {
                        let [below_it, at] =
                            [table.pdf(low.next_down()), table.pdf(low)].map(f64::from);
                        let p = [j - 1, j].map(|j| f64::from(table.cdf().pmf(j)));
                        let width =
                            (f64::from(range[1]) - f64::from(range[0])) / (count - 1) as f64;
                        let m = f64::from(range[0].abs().max(range[1].abs()));
                        let bound = 2f64.powi(-32) * (1.0 / p[0] + 1.0 / p[1])
                            + 10.0 * 2f64.powi(-24) * m / width;
                        // And the step from the float below to the vertex, and the rounding of both densities.
                        let slope =
                            f64::from(weights[j - 1].max(weights[j])) / f64::from(weights[j]);
                        let step = step_below(range[0].abs().max(range[1].abs())) / width * slope;
                        let jump = (below_it - at).abs() / at;
                        assert!(
                            jump <= bound + 2.0 * step + 1.1e-6,
                            "{range:?} {count} {j}: {jump:e}"
                        );
                        jumps = jumps.max(jump / bound);
                        checked += 1;
                    }
                }
                assert_eq!(table.pdf(range[1]) > 0.0, weights[count - 1] > 0.0);
                assert_eq!(
                    [
                        table.pdf(range[1].next_up()),
                        table.pdf(range[0].next_down())
                    ],
                    [0.0; 2]
                );
            }
        }
    }
    println!("{checked} jumps, at most {jumps:.2} of the bound, with rounding");
    assert!(checked > 5_000);
}

#[test]
fn storage_holds_the_same_table() {
    const WEIGHTS: [f32; 5] = [0.0, 2.0, 1.0, 0.0, 4.0];
    const TABLE: PiecewiseLinear1d<[u32; 5], [f32; 5]> =
        constant!(PiecewiseLinear1d::new(&WEIGHTS, -1.0, 3.0));
    assert!(size_of_val(&TABLE) <= 8 * 5 + 24);
    let mut memory = [0_u32; 9];
    let lent = Lent::new_in(&WEIGHTS, -1.0, 3.0, &mut memory).unwrap();
    type Kept = PiecewiseLinear1d<heapless::Vec<u32, 6>, heapless::Vec<f32, 6>>;
    let kept = Kept::from_slice(&WEIGHTS, -1.0, 3.0).unwrap();
    let words = TABLE.cdf().as_words();
    assert_eq!(
        (lent.cdf().as_words(), kept.cdf().as_words()),
        (words, words)
    );
    assert_eq!(
        (lent.weights(), kept.weights()),
        (&WEIGHTS[..], &WEIGHTS[..])
    );
    let sent = Cdf::from_words(words).unwrap();
    let received = PiecewiseLinear1d::from_cdf(sent, &WEIGHTS[..], -1.0, 3.0).unwrap();
    let wide = PiecewiseLinear1d::new_u64(&WEIGHTS, -1.0, 3.0).unwrap();
    for k in 0..1000_u32 {
        let u = k as f32 / 1000.0;
        let x = TABLE.sample(u);
        assert_eq!([lent.sample(u), kept.sample(u), received.sample(u)], [x; 3]);
        assert!((wide.sample(u) - x).abs() <= 1e-6);
        assert_eq!(
            [lent.pdf(x), kept.pdf(x), received.pdf(x)],
            [TABLE.pdf(x); 3]
        );
        assert_eq!(TABLE.cell(x), lent.cell(x));
    }
    assert_eq!((TABLE.low(), TABLE.high()), (-1.0, 3.0));
}

#[test]
fn what_is_no_curve_is_refused() {
    let refused = |weights: &[f32], low, high| {
        let mut memory = [0_u32; 6];
        Lent::new_in(weights, low, high, &mut memory).err()
    };
    assert_eq!(refused(&[1.0, 2.0], 0.0, 1.0), None);
    for weights in [&[][..], &[1.0]] {
        assert_eq!(refused(weights, 0.0, 1.0), Some(NoWeights));
        let kept = PiecewiseLinear1d::<heapless::Vec<u32, 6>, heapless::Vec<f32, 6>>::from_slice(
            weights, 0.0, 1.0,
        );
        assert_eq!(kept.err(), Some(NoWeights));
    }
    assert_eq!(
        PiecewiseLinear1d::new(&[1.0], 0.0, 1.0).err(),
        Some(NoWeights)
    );
    assert_eq!(refused(&[0.0; 3], 0.0, 1.0), Some(AllZero));
    assert_eq!(
        refused(&[1.0, f32::NAN], 0.0, 1.0),
        Some(NotFiniteWeight(1))
    );
    assert_eq!(refused(&[-1.0, 1.0], 0.0, 1.0), Some(NegativeWeight(0)));
    assert_eq!(refused(&[1.0; 7], 0.0, 1.0), Some(TooManyWeights));
    assert_eq!(refused(&[1.0; 3], 1.0, 0.0), Some(Reversed(2)));
    assert_eq!(refused(&[1.0; 3], 1.0, 1.0), Some(Empty(2)));
    // A density of twice the mean must be possible.
    assert_eq!(refused(&[1.0, 0.0], 0.0, 1.1e-38), Some(Empty(2)));
    assert_eq!(refused(&[1.0, 0.0], 0.0, 1.2e-38), None);
    let cdf = || Cdf::new(&[1.0, 2.0, 0.0]).unwrap();
    let from = |weights: [f32; 3]| PiecewiseLinear1d::from_cdf(cdf(), weights, 0.0, 1.0).err();
    assert_eq!(from([1.0, 1.0, 3.0]), None);
    assert_eq!(from([1.0, f32::INFINITY, 3.0]), Some(NotFiniteWeight(1)));
    assert_eq!(from([1.0, 1.0, -3.0]), Some(NegativeWeight(2)));
    let short = PiecewiseLinear1d::from_cdf(cdf(), [1.0, 1.0], 0.0, 1.0);
    assert_eq!(short.err(), Some(NotATable));
    let full = Cdf::new(&[1.0, 2.0]).unwrap();
    let full = PiecewiseLinear1d::from_cdf(full, [1.0, 1.0], 0.0, 1.0);
    assert_eq!(full.err(), Some(NotATable));
    // Weights that do not belong to the table still give a density of their own.
    let strange = PiecewiseLinear1d::from_cdf(cdf(), [0.0, 0.0, 0.0], 0.0, 1.0).unwrap();
    for k in 0..100 {
        let x = strange.sample(k as f32 / 100.0);
        assert!((0.0..1.0).contains(&x) && strange.pdf(x).is_finite());
    }
}
