//! The order of a set over a picture: every index once, blocks by the bits above them, errors that cancel between neighbours.

use host::{speed, stats};
use microwarp::Error;
use microwarp::uniform::{ByPosition, LatinHypercube, Permutation, Points, Screen, Sobol};
use std::collections::BTreeSet;

fn of(size: [u32; 2], log2_samples: u32, seed: u32) -> Screen<Sobol<2>> {
    Screen::new(Sobol::new(seed).unwrap(), size, log2_samples, seed).unwrap()
}

/// The indices of all samples of a picture.
fn indices(screen: Screen<Sobol<2>>, [width, height]: [u32; 2]) -> Vec<u32> {
    let pixels = (0..height).flat_map(|y| (0..width).map(move |x| screen.pixel(x, y)));
    let samples = 0..1 << screen.log2_samples();
    pixels
        .flat_map(|pixel| samples.clone().map(move |s| pixel.index(s)))
        .collect()
}

#[test]
fn every_index_is_taken_once() {
    for (side, k) in [0, 1, 2, 3, 5]
        .into_iter()
        .flat_map(|b| (0..5).map(move |k| (1 << b, k)))
    {
        for seed in 0..4 {
            let mut taken = indices(of([side; 2], k, seed), [side; 2]);
            taken.sort_unstable();
            assert!(
                taken.into_iter().eq(0..(side * side) << k),
                "{side}, {k}, seed {seed}"
            );
        }
    }
    // Other pictures are parts of a square one.
    for size in [[1, 9], [7, 5], [33, 20], [1, 2], [100, 1]] {
        let taken = indices(of(size, 2, 9), size);
        let different: BTreeSet<u32> = taken.iter().copied().collect();
        assert_eq!(different.len(), taken.len());
        let side = size[0].max(size[1]).next_power_of_two();
        assert!(different.last() < Some(&((side * side) << 2)));
        let square = of([side; 2], 2, 9);
        assert_eq!(
            of(size, 2, 9).pixel(0, 0).index(3),
            square.pixel(0, 0).index(3)
        );
    }
}

/// Whether the block of 2^bits indices that a sample is in depends on its place by the bits above alone.
fn in_blocks(order: impl Fn(u32) -> u32, bits: u32, total: u32) -> bool {
    (0..1_u32 << total).all(|along| order(along) >> bits == order(along >> bits << bits) >> bits)
}

#[test]
fn blocks_are_permuted_by_the_bits_above_alone() {
    let place = |along: u32| {
        let every_other = |bits: u32| (0..3).map(|b| (bits >> (2 * b) & 1) << b).sum::<u32>();
        [every_other(along >> 3), every_other(along >> 4)]
    };
    for seed in 0..50 {
        let screen = of([8, 8], 3, seed);
        let order = |along: u32| {
            let [x, y] = place(along);
            screen.pixel(x, y).index(along & 7)
        };
        assert!((0..9).all(|bits| in_blocks(order, bits, 9)));
        // A permutation of all is not one of blocks.
        let any = Permutation::new(512, seed).unwrap();
        assert!(!(1..9).any(|bits| in_blocks(|along| any.get(along).unwrap(), bits, 9)));
    }
    // The eight orders of four pixels whose pairs stay together are equally likely, and so are the places of one.
    let seeds = speed::of("seeds of orders of four pixels", 20_000, 400_000);
    let counted = |count: usize, cell: &dyn Fn(Screen<Sobol<2>>) -> u32| {
        let mut counts = vec![0; count];
        (0..seeds).for_each(|seed| counts[cell(of([64, 64], 2, seed)) as usize] += 1);
        let expected = vec![f64::from(seeds) / count as f64; count];
        stats::chi_square(&counts, &expected).map_or(f64::NAN, |found| found.2)
    };
    let four = |screen: Screen<Sobol<2>>| {
        let at = |x, y| screen.pixel(x, y).index(0) >> 2;
        (at(6, 8) >> 1 & 1) << 2 | (at(6, 8) & 1) << 1 | at(6, 9) & 1
    };
    let found = [
        counted(8, &four),
        counted(256, &|screen| screen.pixel(0, 0).index(0) >> 6),
        counted(256, &|screen| screen.pixel(63, 21).index(3) >> 6),
        counted(16, &|screen| {
            screen.pixel(63, 21).index(0) & 3 | (screen.pixel(62, 21).index(0) & 3) << 2
        }),
    ];
    let threshold = stats::threshold(found.len());
    stats::assert_passes("orders", &found, threshold);
    let upper = counted(8, &|screen| four(screen) & 5);
    stats::assert_rejected("a pair that is never exchanged", &[upper], threshold);
}

#[test]
fn pictures_beyond_32_bits_are_refused_and_any_place_has_words() {
    let made = |size, k| Screen::new(ByPosition::new(1, 2), size, k, 3).map(|_| ());
    for (size, k) in [
        ([1 << 16; 2], 0),
        ([1, 1 << 16], 0),
        ([1920, 1080], 10),
        ([1, 1], 32),
        ([2, 1], 30),
    ] {
        assert_eq!(made(size, k), Ok(()), "{size:?}, {k}");
    }
    for (size, k) in [
        ([1 << 16; 2], 1),
        ([65_537, 1], 0),
        ([u32::MAX; 2], 0),
        ([1, 1], 33),
        ([2, 2], 31),
        ([5, 5], u32::MAX),
    ] {
        assert_eq!(made(size, k), Err(Error::TooLarge(2)), "{size:?}, {k}");
    }
    for size in [[0, 1], [1, 0], [0, 0], [0, u32::MAX]] {
        assert_eq!(made(size, 0), Err(Error::Empty(1)));
    }
    for (size, k) in [([1, 1], 32), ([1, 1], 0), ([1 << 16; 2], 0), ([9, 4], 3)] {
        let screen = Screen::new(Sobol::<3>::new(1).unwrap(), size, k, 3).unwrap();
        for (x, y, s) in [
            (0, 0, u32::MAX),
            (u32::MAX, u32::MAX, 1 << 31),
            (1 << 16, 3, 7),
        ] {
            let pixel = screen.pixel(x, y);
            let largest = u64::from(size[0].max(size[1]).next_power_of_two()).pow(2) << k;
            assert!(u64::from(pixel.index(s)) < largest);
            assert_eq!(pixel.words::<3>(s), [0, 1, 2].map(|d| pixel.word(s, d)));
        }
    }
    // One sample of one pixel alone; all 2³² of it.
    assert_eq!(of([1, 1], 0, 5).pixel(0, 0).index(9), 0);
    let whole = of([1, 1], 32, 5).pixel(7, 7);
    assert_eq!((whole.index(77) ^ whole.index(78)) >> 2, 0);
    let set = Sobol::<2>::new(5).unwrap();
    assert_eq!(whole.word(u32::MAX, 1), set.word(whole.index(u32::MAX), 1));
    // The set may have as many points as there are samples.
    let cube = LatinHypercube::new(256, 7).unwrap();
    let screen = Screen::new(cube, [8, 8], 2, 7).unwrap();
    let strata: BTreeSet<u32> = (0..256)
        .map(|i| screen.pixel(i >> 2 & 7, i >> 5).word(i & 3, 4) >> 24)
        .collect();
    assert_eq!(strata.len(), 256);
    assert_eq!((screen.points(), size_of::<Screen<()>>()), (cube, 12));
}
