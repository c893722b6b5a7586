//! Latin hypercubes: each stratum has its point, words and dimensions are random, and means have the errors of the page.

use host::docs::Doc;
use host::{speed, stats};
use microwarp::Error;
use microwarp::uniform::{ByPosition, LatinHypercube, Points};
use rand_pcg::Pcg32;
use rand_pcg::rand_core::Rng;

fn of(count: u32, seed: u32) -> LatinHypercube {
    LatinHypercube::new(count, seed).unwrap()
}

/// How many strata are without a point.
fn empty(count: u32, word: impl Fn(u32) -> u32) -> usize {
    let mut taken = vec![false; count as usize];
    for index in 0..count {
        let stratum = (u64::from(word(index)) * u64::from(count)) >> 32;
        taken[stratum as usize] = true;
    }
    taken.iter().filter(|taken| !**taken).count()
}

#[test]
fn every_stratum_has_its_point() {
    let largest = speed::of("points of the largest Latin hypercube", 20_011, 1_000_003);
    for count in (1..300).chain([1000, 1024, 1025, largest]) {
        let seeds = if count < 300 { 3 } else { 1 };
        for (seed, dimension) in (0..seeds).flat_map(|seed| [0, 1, 1 << 31].map(|d| (seed, d))) {
            let points = of(count, seed);
            let missing = empty(count, |index| points.word(index, dimension));
            assert_eq!(
                missing, 0,
                "{count} points, seed {seed}, dimension {dimension}"
            );
        }
    }
    // Random points leave strata empty, and so do points on the 8-bit grid.
    let random = ByPosition::new(7, 0);
    assert!(empty(300, |index| random.word(index, 0)) > 80);
    assert!(empty(300, |index| of(300, 7).word(index, 0) & 0xff00_0000) > 0);
}

/// A word of one of so many points is in a stratum with the rounded division's first word and last word.
#[test]
fn words_of_many_points_are_in_their_strata_and_reach_their_ends() {
    let mut rng = Pcg32::new(1, 1);
    for count in [3_000_000_019_u64 as u32, (1 << 31) + 1, u32::MAX, 1 << 31] {
        let points = of(count, 5);
        let mut reached = [false; 2];
        for _ in 0..2000 {
            let index = rng.next_u32() % count;
            let word = points.word(index, 3);
            let stratum = (u64::from(word) * u64::from(count)) >> 32;
            // Strata have one word or two here.
            let first = (stratum << 32).div_ceil(count.into());
            reached[(u64::from(word) - first) as usize] = true;
        }
        assert!(reached[0] && reached[1] == (count < u32::MAX));
    }
}

#[test]
fn words_are_uniform_and_dimensions_independent() {
    let seeds = speed::of("seeds of words of Latin hypercubes", 60_000, 1_000_000);
    let cells = |count: usize, cell: &dyn Fn(u32) -> usize| {
        let mut cells = vec![0; count];
        (0..seeds).for_each(|seed| cells[cell(seed)] += 1);
        let expected = vec![f64::from(seeds) / count as f64; count];
        stats::chi_square(&cells, &expected).map_or(f64::NAN, |found| found.2)
    };
    let share = |word: u32, cells: u64| ((u64::from(word) * cells) >> 32) as usize;
    let two = |seed: u32, [(i, d), (j, e)]: [(u32, u32); 2]| {
        let points = of(7, seed);
        7 * share(points.word(i, d), 7) + share(points.word(j, e), 7)
    };
    let p = [
        cells(256, &|seed| share(of(3, seed).word(1, 0), 256)),
        cells(256, &|seed| share(of(1000, seed).word(999, 9), 256)),
        // Within a stratum, whatever the stratum.
        cells(64, &|seed| {
            share(of(50, seed).word(20, 1).wrapping_mul(50), 64)
        }),
        cells(49, &|seed| two(seed, [(2, 0), (2, 1)])),
        cells(49, &|seed| two(seed, [(0, 5), (6, 6)])),
    ];
    let threshold = stats::threshold(p.len());
    stats::assert_passes("words and pairs of dimensions", &p, threshold);
    let same = cells(49, &|seed| two(seed, [(2, 0), (2, 0)]));
    stats::assert_rejected("one dimension twice", &[same], threshold);
}

#[test]
fn points_behind_the_last_are_random_ones() {
    let points = of(5, 7);
    for dimension in [0, 1, 99] {
        assert_eq!(
            points.word(5, dimension),
            ByPosition::new(7, 0).word(5, dimension)
        );
        assert_ne!(
            points.word(4, dimension),
            ByPosition::new(7, 0).word(4, dimension)
        );
    }
    assert_eq!(LatinHypercube::new(0, 1), Err(Error::Empty(0)));
    assert_eq!((points.count(), size_of::<LatinHypercube>()), (5, 24));
}

#[test]
fn errors_of_means_are_those_of_the_page() {
    let page = Doc::find("uniform", "LatinHypercube").unwrap().text();
    type Integrand = fn([f64; 4]) -> f64;
    let integrands: [(&str, Integrand, f64); 3] = [
        (
            "the sum of the squares of the coordinates",
            |x| x.iter().map(|x| x * x).sum(),
            4.0 / 3.0,
        ),
        (
            "the product of the factors ½ + x",
            |x| x.iter().map(|x| 0.5 + x).product(),
            1.0,
        ),
        (
            "a half of the cube, by a diagonal plane",
            |x| f64::from(u8::from(x.iter().sum::<f64>() > 2.0)),
            0.5,
        ),
    ];
    let seeds = speed::of("seeds of means of Latin hypercubes", 600, 20_000);
    for (name, f, mean) in integrands {
        let rms = |word: &dyn Fn(u32, u32, u32) -> u32| {
            let off = |seed| {
                let middle = |word: u32| (f64::from(word) + 0.5) / 4_294_967_296.0;
                let point = |i| std::array::from_fn(|d| middle(word(seed, i, d as u32)));
                let sum: f64 = (0..100).map(|i| f(point(i))).sum();
                sum / 100.0 - mean
            };
            let squares = (0..seeds).map(off).map(|off| off * off);
            (squares.sum::<f64>() / f64::from(seeds)).sqrt()
        };
        let random = rms(&|seed, i, d| ByPosition::new(seed, 1).word(i, d));
        let latin = rms(&|seed, i, d| of(100, seed).word(i, d));
        let row = page.lines().find(|line| line.contains(name)).expect(name);
        let stated: f64 = row
            .trim_matches(['/', ' ', '|'])
            .rsplit('|')
            .next()
            .unwrap()
            .trim()
            .parse()
            .unwrap();
        println!("{name}: {:.2}, stated {stated}", random / latin);
        assert!((random / latin / stated - 1.0).abs() <= 0.15);
        // The control has one order for all dimensions.
        let wrong = rms(&|seed, i, _| of(100, seed).word(i, 0));
        assert!((random / wrong / stated - 1.0).abs() > 0.15);
    }
}
