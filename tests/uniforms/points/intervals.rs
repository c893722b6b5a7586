//! Every elementary interval of the unit square holds its share of Sobol' points, and no coordinate is off the textbook's.

use super::{Set, plain, second_pair, sobol};
use host::speed;
use microwarp::Error;
use microwarp::uniform::{MAX_DIMENSIONS, Points, Recurrence, Sobol};
use rand_pcg::Pcg32;
use rand_pcg::rand_core::Rng;

/// How many of the partitions of the square into as many equal boxes as there are points have a box without its point.
fn violated(points: &[[u32; 2]]) -> usize {
    let bits = points.len().ilog2();
    let leading = |word: u32, count: u32| u64::from(word) >> (32 - count);
    let partitions = 0..=bits;
    let is_violated = |columns: &u32| {
        let mut taken = vec![false; points.len()];
        let place = |[x, y]: &[u32; 2]| {
            let row = leading(*y, bits - columns);
            (row << columns | leading(*x, *columns)) as usize
        };
        points
            .iter()
            .any(|point| std::mem::replace(&mut taken[place(point)], true))
    };
    partitions.filter(is_violated).count()
}

/// Over all powers of two of points up to 2^16, from the start and from a later block.
fn violations(set: Set, seed: u32) -> [usize; 2] {
    let (mut broken, mut tried) = (0, 0);
    for bits in 0..=16 {
        for block in [0, 5_u32] {
            let points = (block << bits..(block + 1) << bits).map(|index| set(seed, index));
            broken += violated(&points.collect::<Vec<_>>());
            tried += bits as usize + 1;
        }
    }
    [broken, tried]
}

#[test]
fn every_elementary_interval_has_its_point() {
    for set in [sobol as Set, second_pair] {
        let mut tried = 0;
        for seed in 0..speed::of("seeds of elementary intervals", 2, 32) {
            let [broken, partitions] = violations(set, seed);
            assert_eq!(broken, 0, "seed {seed}");
            tried += partitions;
        }
        println!("{tried} partitions");
    }
}

/// A rotation by a random shift, and a hash that is not nested.
#[test]
fn what_is_no_nested_scrambling_violates_intervals() {
    let rotated: Set = |seed, index| {
        let [x, y] = plain(index);
        let shift = seed.wrapping_mul(0x9e37_79b9);
        [x.wrapping_add(shift), y.wrapping_add(shift << 7 | 1 << 20)]
    };
    let swapped: Set = |seed, index| sobol(seed, index).map(|x| x.rotate_left(1));
    for set in [rotated, swapped] {
        let [broken, tried] = violations(set, 7);
        println!("{broken} of {tried} partitions violated");
        assert!(broken > tried / 2, "{broken} of {tried}");
    }
    let shifted: Set = |_, index| plain(index).map(|x| x ^ 0x1234_5678);
    assert_eq!(violations(shifted, 0)[0], 0);
}

/// Degree, inner coefficients and first odd numbers, from the file `new-joe-kuo-6.21201`, its lines 3 to 8.
const JOE_KUO: [(u32, u32, &[u64]); 6] = [
    (2, 1, &[1, 3]),
    (3, 1, &[1, 3, 1]),
    (3, 2, &[1, 1, 1]),
    (4, 1, &[1, 1, 3, 3]),
    (4, 4, &[1, 3, 5, 13]),
    (5, 2, &[1, 1, 5, 5, 17]),
];

/// The columns of a dimension's matrix, by Bratley and Fox's recurrence of odd numbers.
fn columns(dimension: usize) -> [u32; 32] {
    if dimension < 2 {
        return std::array::from_fn(|k| plain(1 << k)[dimension]);
    }
    let (degree, inner, first) = JOE_KUO[dimension - 2];
    let mut odd = first.to_vec();
    for k in odd.len()..32 {
        let back = |steps: u32| odd[k - steps as usize];
        let ends = back(degree) ^ back(degree) << degree;
        let inside = (1..degree).filter(|i| inner >> (degree - 1 - i) & 1 == 1);
        odd.push(inside.fold(ends, |sum, i| sum ^ back(i) << i));
    }
    std::array::from_fn(|k| (odd[k] << (31 - k)) as u32)
}

/// Indices, of which the k-th changes the unscrambled coordinate from its k-th bit on and not before: the inverse of the
/// matrix, by elimination.
fn inverse(columns: [u32; 32]) -> [u32; 32] {
    let mut rows: Vec<[u32; 2]> = (0..32).map(|k| [columns[k], 1 << k]).collect();
    for bit in 0..32 {
        let has = |row: &[u32; 2]| row[0] << bit >> 31 == 1;
        let pivot = (bit..32).find(|&k| has(&rows[k])).expect("full rank");
        rows.swap(bit, pivot);
        let chosen = rows[bit];
        for (k, row) in rows.iter_mut().enumerate() {
            if k != bit && has(row) {
                *row = [row[0] ^ chosen[0], row[1] ^ chosen[1]];
            }
        }
    }
    std::array::from_fn(|k| rows[k][1])
}

/// Scrambling keeps how many leading bits two coordinates share. So the textbook says of each two indices how many.
#[test]
fn coordinates_share_as_many_leading_bits_as_the_textbook_says() {
    let mut rng = Pcg32::new(3, 1);
    for dimension in 0..MAX_DIMENSIONS {
        let matrix = columns(dimension);
        let changes = inverse(matrix);
        // The inverse is that of a textbook's matrix, and not of the next dimension's.
        let of = |columns: [u32; 32], index: u32| {
            let chosen = (0..32).filter(|k| index >> k & 1 == 1);
            chosen.fold(0, |sum, k| sum ^ columns[k])
        };
        let wrong = columns((dimension + 1) % MAX_DIMENSIONS);
        let agrees = |matrix| (0..32).all(|k| of(matrix, changes[k]) == 1 << (31 - k));
        assert!(agrees(matrix) && !agrees(wrong));
        for seed in 0..speed::of("seeds of each matrix", 20, 2000) {
            let set = Sobol::<MAX_DIMENSIONS>::new(seed).unwrap();
            let word = |index| set.word(index, dimension as u32);
            for bit in 0..32 {
                // Anything may change behind the bit.
                let later = (bit + 1..32).filter(|_| rng.next_u32() & 1 == 1);
                let change = later.fold(changes[bit], |sum, k| sum ^ changes[k]);
                let index = rng.next_u32();
                let shared = (word(index) ^ word(index ^ change)).leading_zeros();
                assert_eq!(shared as usize, bit, "dimension {dimension}");
            }
        }
    }
}

#[test]
fn the_directions_are_of_primitive_polynomials_and_odd_numbers() {
    for (degree, inner, first) in JOE_KUO {
        let polynomial = 1 << degree | inner << 1 | 1;
        let (mut power, mut order) = (2_u32, 1);
        while power != 1 {
            power <<= 1;
            if power >> degree & 1 == 1 {
                power ^= polynomial;
            }
            order += 1;
        }
        assert_eq!(order, (1 << degree) - 1);
        let fits = |(k, odd): (usize, &u64)| odd % 2 == 1 && *odd < 2 << k;
        assert!(first.iter().enumerate().all(fits));
    }
}

/// All dimensions at once are the dimensions one by one, also where a set has fewer than are asked for.
#[test]
fn words_are_those_of_the_dimensions() {
    fn check<const D: usize, const N: usize>() {
        let set = Sobol::<D>::new(99).unwrap();
        for index in [0, 1, 2, 1000, 0x1234_5678, u32::MAX] {
            let words: [u32; N] = set.words(index);
            assert_eq!(words, std::array::from_fn(|d| set.word(index, d as u32)));
        }
    }
    check::<1, 1>();
    check::<2, 2>();
    check::<2, 5>();
    check::<3, 3>();
    check::<4, 3>();
    check::<4, 13>();
    check::<8, 8>();
    check::<8, 1>();
}

#[test]
fn dimensions_beyond_those_tabulated_are_refused() {
    fn refused<const COUNT: usize>(error: Option<Error>) {
        assert_eq!(Sobol::<COUNT>::new(1).err(), error);
        assert_eq!(Recurrence::<COUNT>::new(1).err(), error);
    }
    refused::<0>(Some(Error::Empty(Error::NO_PLACE)));
    refused::<1>(None);
    refused::<2>(None);
    refused::<8>(None);
    refused::<9>(Some(Error::TooLarge(Error::NO_PLACE)));
    refused::<1000>(Some(Error::TooLarge(Error::NO_PLACE)));
}
