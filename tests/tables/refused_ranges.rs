//! Bad weights, ranges, shapes and words get a typed error, with the index of the weight at fault.

use microwarp::Error::{
    AllZero, Empty, NegativeWeight, NoWeights, NotATable, NotFinite, NotFiniteWeight, OutOfRange,
    Reversed, TooLarge, TooManyWeights, Unreachable,
};
use microwarp::discrete::{Cdf, PiecewiseConstant1d, PiecewiseConstant2d, Word};
use microwarp::{Error, Warp};

const NAN: f32 = f32::NAN;
const INF: f32 = f32::INFINITY;
const UNIT: [f32; 2] = [0.0, 1.0];

fn line<const N: usize>(weights: [f32; N], low: f32, high: f32) -> Option<Error> {
    let narrow = PiecewiseConstant1d::new(&weights, low, high).err();
    let wide = PiecewiseConstant1d::new_u64(&weights, low, high).err();
    assert!(narrow == wide || matches!(narrow, Some(Unreachable(_))));
    narrow
}

/// The same refusal from borrowed memory as from an array. The shape of what is borrowed is a parameter before the ranges.
fn borrowed_too<W: Word, const C: usize, const R: usize>(
    weights: [[f32; C]; R],
    [u, v]: [[f32; 2]; 2],
    array: Option<Error>,
) -> Option<Error> {
    let flat = weights.as_flattened();
    let (mut rows, mut cells) = ([W::from_bits(0); R], vec![W::from_bits(0); C * R]);
    type Lent<'a, W> = PiecewiseConstant2d<&'a [W], &'a [W]>;
    let borrowed = Lent::new_in(flat, [C, R], u, v, &mut rows, &mut cells).err();
    let told = |error: Error| (error.code(), error.index(), error.parameter());
    let later = |(code, index, place): (_, _, Option<usize>)| (code, index, place.map(|p| p + 1));
    assert_eq!(array.map(told).map(later), borrowed.map(told));
    array
}

/// The refusal of both words.
fn plane<const C: usize, const R: usize>(
    weights: [[f32; C]; R],
    u: [f32; 2],
    v: [f32; 2],
) -> Option<Error> {
    let narrow = PiecewiseConstant2d::new(&weights, u, v).err();
    let wide = PiecewiseConstant2d::new_u64(&weights, u, v).err();
    let narrow = borrowed_too::<u32, C, R>(weights, [u, v], narrow);
    let wide = borrowed_too::<u64, C, R>(weights, [u, v], wide);
    assert!(narrow == wide || matches!(narrow, Some(Unreachable(_))));
    narrow
}

#[test]
fn bad_weights_are_named_by_their_index() {
    assert_eq!(line([], 0.0, 1.0), Some(NoWeights));
    assert_eq!(line([0.0, -0.0], 0.0, 1.0), Some(AllZero));
    assert_eq!(line([1.0, NAN], 0.0, 1.0), Some(NotFiniteWeight(1)));
    assert_eq!(line([INF, 1.0], 0.0, 1.0), Some(NotFiniteWeight(0)));
    assert_eq!(line([1.0, 1.0, -1e-45], 0.0, 1.0), Some(NegativeWeight(2)));
    assert_eq!(line([1.0, 1e-20, 1.0, 1e-30], 0.0, 1.0), None);
    assert_eq!(line([1e-45, f32::MAX], 0.0, 1.0), None);
    assert_eq!(plane::<0, 0>([], UNIT, UNIT), Some(NoWeights));
    assert_eq!(plane([[], []], UNIT, UNIT), Some(NoWeights));
    assert_eq!(plane([[0.0; 3]; 2], UNIT, UNIT), Some(AllZero));
    let mut weights = [[1.0; 5]; 4];
    weights[2][3] = NAN;
    assert_eq!(plane(weights, UNIT, UNIT), Some(NotFiniteWeight(13)));
    weights[2][3] = -1.0;
    assert_eq!(plane(weights, UNIT, UNIT), Some(NegativeWeight(13)));
    weights[2][3] = INF;
    weights[0][4] = -INF;
    assert_eq!(plane(weights, UNIT, UNIT), Some(NotFiniteWeight(4)));
    // A row that is not reached is blamed on its first light, a cell on itself. Two such weights are
    // needed: a single one may take its word from a neighbour within the bound.
    let dim = [0.0, 1e-12, 1e-12];
    assert_eq!(
        plane([[1.0; 3], dim, dim, dim], UNIT, UNIT),
        Some(Unreachable(4))
    );
    assert_eq!(
        plane([[1.0; 5], [1.0, 1e-12, 1e-13, 1e-12, 1e-12]], UNIT, UNIT),
        Some(Unreachable(7))
    );
}

#[test]
fn bad_ranges_are_refused() {
    type Reason = fn(usize) -> Error;
    let refused: [([f32; 2], Reason, usize); 10] = [
        ([NAN, 1.0], NotFinite, 1),
        ([0.0, INF], NotFinite, 2),
        ([-INF, 1.0], NotFinite, 1),
        ([1.0, 0.0], Reversed, 2),
        ([2.0, 2.0], Empty, 2),
        ([0.0, 0.0], Empty, 2),
        ([1.0, 1.000_000_1], Empty, 2),
        ([0.0, 1e-45], Empty, 2),
        ([0.0, 1e-38], Empty, 2),
        ([-1e6, -1e6 + 1.0], Empty, 2),
    ];
    for (range, error, place) in refused {
        let of_line = line([1.0; 4], range[0], range[1]);
        assert_eq!(of_line, Some(error(place)), "{range:?}");
        let (of_u, of_v) = (
            plane([[1.0; 4]; 3], range, UNIT),
            plane([[1.0; 3]; 4], UNIT, range),
        );
        assert_eq!((of_u, of_v), (Some(error(1)), Some(error(2))), "{range:?}");
    }
    for range in [
        [-f32::MAX, f32::MAX],
        [0.0, 2.8e-38],
        [-1e-30, 1e30],
        [1e6, 1e6 + 4.0],
    ] {
        assert_eq!(line([1.0; 4], range[0], range[1]), None, "{range:?}");
    }
    // Of a rectangle it is the area that counts.
    for (u, v, error) in [
        ([-f32::MAX, f32::MAX], [0.0, 2.8e-38], None),
        ([-f32::MAX, f32::MAX], UNIT, Some(TooLarge(2))),
        ([0.0, 2e19], [0.0, 2e19], Some(TooLarge(2))),
        ([0.0, 9e18], [0.0, 9e18], None),
        ([0.0, 1e-18], [0.0, 1e-18], None),
        ([0.0, 1e-19], [0.0, 1e-19], Some(Empty(2))),
        ([1e6, 1e6 + 4.0], [1e6, 1e6 + 4.0], None),
    ] {
        assert_eq!(plane([[1.0; 4]; 4], u, v), error, "{u:?} {v:?}");
    }
}

#[test]
fn shapes_and_memory_must_fit() {
    type Table<'a> = PiecewiseConstant2d<&'a [u32], &'a [u32]>;
    let weights = [1.0; 6];
    let build = |shape: [usize; 2], rows: usize, cells: usize| {
        let (mut rows, mut cells) = (vec![0; rows], vec![0; cells]);
        Table::new_in(&weights, shape, UNIT, UNIT, &mut rows, &mut cells).err()
    };
    assert_eq!(build([3, 2], 2, 6), None);
    assert_eq!(build([3, 2], 9, 9), None);
    for shape in [
        [2, 2],
        [4, 2],
        [0, 6],
        [6, 0],
        [usize::MAX, 2],
        [1 << 63, 1 << 63],
    ] {
        assert_eq!(build(shape, 6, 6), Some(OutOfRange(1)), "{shape:?}");
    }
    assert_eq!(build([3, 2], 1, 6), Some(TooManyWeights));
    assert_eq!(build([3, 2], 2, 5), Some(TooManyWeights));
    for shape in [[0, 0], [0, 5], [5, 0]] {
        let none = Table::new_in(&[], shape, UNIT, UNIT, &mut [], &mut []).err();
        assert_eq!(none, Some(NoWeights), "{shape:?}");
    }
}

#[test]
fn words_that_are_no_table_are_refused() {
    type Table<'a> = PiecewiseConstant2d<&'a [u32], &'a [u32]>;
    let half = 1 << 31;
    let build = |rows: &[u32], cells: &[u32]| Table::from_words(rows, cells, UNIT, UNIT).err();
    assert_eq!(build(&[half, 1], &[half, 1, u32::MAX, 0]), None);
    assert_eq!(build(&[], &[]), Some(NoWeights));
    assert_eq!(build(&[half, 1], &[half, 1, 1]), Some(NotATable));
    assert_eq!(build(&[half, 1], &[half]), Some(NotATable));
    assert_eq!(build(&[half, 1], &[half, 1, half, 2]), Some(NotATable));
    assert_eq!(build(&[half, 2], &[half, 1, half, 1]), Some(NotATable));
    assert_eq!(build(&[half, 0], &[half, 1, half, 1]), Some(NotATable));
    assert_eq!(build(&[0], &[half, 1, 2]), Some(NotATable));
    assert_eq!(build(&[half, 1], &[half, 1, half, 0]), Some(NotATable));
    assert_eq!(build(&[half, 1], &[]), Some(NoWeights));
    let reversed = Table::from_words(&[half, 1], &[0, 0], [1.0, 0.0], UNIT).err();
    assert_eq!(reversed, Some(Reversed(2)));

    let line = Cdf::from_words([half, 1]).unwrap();
    let table = PiecewiseConstant1d::from_cdf(line, 0.0, 8.0).unwrap();
    assert_eq!(table.sample(0.25), 2.0);
    let bounded = Cdf::<heapless::Vec<u32, 4>>::from_slice(&[1.0, 1.0]).unwrap();
    let table = PiecewiseConstant1d::from_cdf(bounded, 0.0, 8.0).unwrap();
    assert_eq!((table.sample(0.25), table.sample(0.75)), (2.0, 6.0));
}
