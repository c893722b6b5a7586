//! Resampling: counts against exact fractions, over every offset where there are few, and their means.

use host::generators::{Broken, Counting, Cycle, Failing};
use host::speed;
use microwarp::Error;
use microwarp::discrete::MAX_ENTRIES;
use microwarp::discrete::resampling::*;
use rand_core::Rng;
use rand_pcg::Pcg32;

type Scheme = fn(&mut [u32], u32, u32) -> Result<(), Error>;

/// The schemes that take one word.
const SCHEMES: [(&str, Scheme); 2] = [("systematic", systematic), ("residual", residual)];

fn sum(numbers: &[u32]) -> u128 {
    numbers.iter().map(|n| u128::from(*n)).sum()
}

/// How many counts are not within `slack` of what is due.
fn wrong(weights: &[u32], counts: &[u32], copies: u32, slack: u128) -> usize {
    let total = sum(weights);
    let off = |(w, count): (&u32, &u32)| {
        let due = u128::from(*w) * u128::from(copies);
        (u128::from(*count) * total).abs_diff(due) >= slack * total
    };
    weights.iter().zip(counts).filter(|pair| off(*pair)).count()
}

/// Random weights of very different sizes, some of them 0.
fn random_weights(rng: &mut Pcg32, count: usize) -> Vec<u32> {
    let mut weights: Vec<u32> = (0..count)
        .map(|_| (rng.next_u32() >> (rng.next_u32() & 31)) * u32::from(rng.next_u32() % 5 > 0))
        .collect();
    weights[0] = weights[0].max(1);
    weights
}

/// Counts by sums of `f32`, as they are often written.
fn by_float_sums(weights: &[u32], copies: u32, word: u32) -> Vec<u32> {
    let total: f32 = weights.iter().map(|w| *w as f32).sum();
    let offset = word as f32 / 4_294_967_296.0;
    let (mut counts, mut below) = (vec![0; weights.len()], 0.0_f32);
    let mut copy = 0;
    for (count, w) in counts.iter_mut().zip(weights) {
        below += *w as f32 / total;
        while copy < copies && (copy as f32 + offset) / (copies as f32) < below {
            *count += 1;
            copy += 1;
        }
    }
    counts
}

#[test]
fn counts_are_what_is_due_to_less_than_one() {
    let mut rng = Pcg32::new(14, 1);
    let mut seen = 0;
    for count in [1, 2, 3, 10, 128, 4096] {
        for _ in 0..50 {
            let weights = random_weights(&mut rng, count);
            let word = rng.next_u32();
            for copies in [count as u32, 1, 7, 10_000] {
                for (name, scheme) in SCHEMES {
                    let mut counts = weights.clone();
                    assert_eq!(scheme(&mut counts, copies, word), Ok(()));
                    assert_eq!(sum(&counts), u128::from(copies), "{name}");
                    assert_eq!(wrong(&weights, &counts, copies, 1), 0, "{name} of {count}");
                    seen += count;
                }
                let mut counts = weights.clone();
                assert_eq!(stratified(&mut counts, copies, &mut rng), Ok(()));
                assert_eq!(sum(&counts), u128::from(copies));
                assert_eq!(wrong(&weights, &counts, copies, 2), 0);
            }
        }
    }
    println!("{seen} counts");
}

#[test]
fn a_whole_number_that_is_due_is_given() {
    let mut rng = Pcg32::new(15, 1);
    let (mut all, mut wrong_by_floats) = (0, 0);
    // The first and the last words put a point at each border of a share, as near as it may be.
    for word in [0, 1, 1000, 0x8000_0000, u32::MAX - 1, u32::MAX] {
        let due: Vec<u32> = (0..4096).map(|_| rng.next_u32() % 4).collect();
        let copies = due.iter().sum();
        for (name, scheme) in SCHEMES {
            for unit in [1, 3, 1_000_003] {
                let mut counts: Vec<u32> = due.iter().map(|w| w * unit).collect();
                assert_eq!(scheme(&mut counts, copies, word), Ok(()));
                assert!(counts == due, "{name}");
            }
        }
        let counts = by_float_sums(&due, copies, word);
        wrong_by_floats += counts.iter().zip(&due).filter(|(c, d)| c != d).count();
        all += due.len();
    }
    println!("sums of f32 get {wrong_by_floats} of {all} wrong");
    assert!(wrong_by_floats > 10, "the control is not rejected");
}

/// Where the sum is a power of two, that many words give every offset once.
#[test]
fn the_mean_over_all_words_is_what_is_due() {
    let cases: [&[u32]; 6] = [
        &[1, 2, 5],
        &[0, 3, 0, 13],
        &[64],
        &[31, 1, 31, 1],
        &[1; 32],
        &[100, 20, 7, 1],
    ];
    for weights in cases {
        let total = sum(weights) as u32;
        assert!(total.is_power_of_two());
        for copies in [1, 2, 3, weights.len() as u32, 17] {
            for (name, scheme) in SCHEMES {
                let mut means = vec![0; weights.len()];
                for offset in 0..total {
                    let mut counts = weights.to_vec();
                    let word = (u64::from(offset) << 32) / u64::from(total);
                    assert_eq!(scheme(&mut counts, copies, word as u32), Ok(()));
                    means.iter_mut().zip(counts).for_each(|(m, c)| *m += c);
                }
                // Summed over `total` offsets, so that the sum is what is due in all.
                let due: Vec<_> = weights.iter().map(|w| w * copies).collect();
                assert_eq!(means, due, "{name} {weights:?} {copies}");
            }
        }
    }
}

/// Three copies of weights that add up to 8: all 512 triples of offsets.
#[test]
fn stratified_counts_have_the_right_mean() {
    let weights = [1, 0, 4, 3];
    let mut sums = [0; 4];
    for triple in 0..512_u32 {
        let words = [0, 3, 6].map(|shift| triple >> shift << 29);
        let mut counts = weights;
        assert_eq!(stratified(&mut counts, 3, &mut Cycle::new(&words)), Ok(()));
        sums.iter_mut().zip(counts).for_each(|(s, c)| *s += c);
    }
    assert_eq!(sums, weights.map(|w| w * 3 * 64));
}

#[test]
fn the_largest_sums_do_not_overflow() {
    let mut weights = vec![u32::MAX; MAX_ENTRIES];
    for &word in speed::of(
        "words of the largest sums",
        &[u32::MAX][..],
        &[0, 1 << 31, u32::MAX],
    ) {
        for (_, scheme) in SCHEMES {
            weights.fill(u32::MAX);
            assert_eq!(scheme(&mut weights, MAX_ENTRIES as u32, word), Ok(()));
            assert!(weights.iter().all(|count| *count == 1));
        }
    }
    weights.fill(u32::MAX);
    assert_eq!(
        stratified(&mut weights, MAX_ENTRIES as u32, &mut Pcg32::new(1, 1)),
        Ok(())
    );
    assert!(weights.iter().all(|count| *count == 1));
    let mut lone = [u32::MAX];
    assert_eq!(systematic(&mut lone, MAX_ENTRIES as u32, u32::MAX), Ok(()));
    assert_eq!(lone, [MAX_ENTRIES as u32]);
}

#[test]
fn stratified_takes_one_word_a_copy() {
    for copies in [0, 1, 5, 100] {
        let mut rng = Counting::new(Pcg32::new(3, 3));
        assert_eq!(stratified(&mut [3, 1, 2], copies, &mut rng), Ok(()));
        assert_eq!(rng.words, u64::from(copies));
    }
}

#[test]
fn a_failing_generator_is_passed_on() {
    let mut rng = Failing { word: 7, left: 2 };
    assert!(matches!(
        try_stratified(&mut [1, 2], 3, &mut rng),
        Err(Broken(_))
    ));
    assert_eq!(
        try_stratified(&mut [0, 0], 3, &mut rng),
        Ok(Err(Error::AllZero))
    );
}

/// All counts of up to six particles that add up to their number.
fn all_counts(slots: usize, sum: u32) -> Vec<Vec<u32>> {
    if slots == 1 {
        return vec![vec![sum]];
    }
    let mut all = Vec::new();
    for first in 0..=sum {
        for mut rest in all_counts(slots - 1, sum - first) {
            rest.insert(0, first);
            all.push(rest);
        }
    }
    all
}

#[test]
fn survivors_stay_and_are_copied_as_often_as_they_count() {
    for slots in 1..=6 {
        for counts in all_counts(slots, slots as u32) {
            let mut particles: Vec<usize> = (0..slots).collect();
            let mut left = counts.clone();
            assert_eq!(rearrange(&mut left, &mut particles), Ok(()));
            assert_eq!(left, vec![1; slots]);
            for (own, count) in counts.iter().enumerate() {
                let copies = particles.iter().filter(|p| **p == own).count();
                assert_eq!(copies, *count as usize, "{counts:?}: {particles:?}");
                assert!(
                    *count == 0 || particles[own] == own,
                    "{counts:?}: {particles:?}"
                );
            }
        }
    }
}

#[test]
fn bad_input_is_refused_and_changes_nothing() {
    let many = MAX_ENTRIES as u32 + 1;
    for (_, scheme) in SCHEMES {
        assert_eq!(scheme(&mut [], 1, 0), Err(Error::NoWeights));
        assert_eq!(scheme(&mut [0, 0], 1, 0), Err(Error::AllZero));
        let mut weights = [4, 5];
        assert_eq!(scheme(&mut weights, many, 0), Err(Error::TooLarge(1)));
        assert_eq!(weights, [4, 5]);
        assert_eq!(
            scheme(&mut vec![1; many as usize], 1, 0),
            Err(Error::TooManyWeights)
        );
        assert_eq!(scheme(&mut weights, 0, u32::MAX), Ok(()));
        assert_eq!(weights, [0, 0]);
    }
    let mut rng = Counting::new(Pcg32::new(1, 1));
    assert_eq!(stratified(&mut [], 1, &mut rng), Err(Error::NoWeights));
    assert_eq!(rng.words, 0);

    let mut particles = [1, 2, 3];
    for counts in [
        &mut [1, 2][..],
        &mut [1, 1, 2],
        &mut [1, 0, 1],
        &mut [1; 4],
        &mut [u32::MAX, 4, 0],
    ] {
        assert_eq!(rearrange(counts, &mut particles), Err(Error::NotATable));
    }
    assert_eq!(particles, [1, 2, 3]);
    assert_eq!(rearrange::<u8>(&mut [], &mut []), Ok(()));

    let mut integers = [9; 2];
    for (weights, error) in [
        (&[][..], Error::NoWeights),
        (&[1.0], Error::NotATable),
        (&[1.0; 3], Error::NotATable),
        (&[0.0, -0.0], Error::AllZero),
        (&[1.0, f32::NAN], Error::NotFiniteWeight(1)),
        (&[f32::INFINITY, 1.0], Error::NotFiniteWeight(0)),
        (&[1.0, -1.0], Error::NegativeWeight(1)),
    ] {
        assert_eq!(to_integers(weights, &mut integers), Err(error));
    }
    assert_eq!(integers, [9; 2]);
}

#[test]
fn integers_are_in_the_ratio_of_the_weights() {
    let mut rng = Pcg32::new(8, 1);
    for count in [1, 2, 1000] {
        for exponent in [-149.0, -140.0, -126.0, -30.0, 0.0, 90.0] {
            let scale = 2_f64.powf(exponent);
            let weights: Vec<f32> = (0..count)
                .map(|_| (scale * (f64::from(rng.next_u32() % 16_777_216) / 997.0)) as f32)
                .map(|weight: f32| weight.max(f32::from_bits(1)))
                .collect();
            let mut integers = vec![0; count];
            assert_eq!(to_integers(&weights, &mut integers), Ok(()));
            let most = weights.iter().copied().fold(0.0, f32::max);
            let unit = f64::from(integers[weights.iter().position(|w| *w == most).unwrap()])
                / f64::from(most);
            assert!(*integers.iter().max().unwrap() >= 1 << 31);
            for (integer, weight) in integers.iter().zip(&weights) {
                let off = (f64::from(*weight) * unit - f64::from(*integer)).abs();
                assert!(off < 1.0, "{weight:e}: {integer}");
            }
        }
    }
    let mut integers = [0; 4];
    let extremes = [f32::MAX, f32::from_bits(1), 0.0, f32::MAX / 2.0];
    assert_eq!(to_integers(&extremes, &mut integers), Ok(()));
    assert_eq!(integers[1..3], [0, 0]);
    assert_eq!(integers[0] / 2, integers[3]);
}

/// A largest weight of few bits is scaled as any other, and what is below a step of it gets nothing.
#[test]
fn what_deserves_nothing_gets_nothing() {
    for bits in [1, 2, 3, 0x7f_ffff, 0x80_0000, 0x80_0001] {
        let largest = f32::from_bits(bits);
        let mut integers = [9; 3];
        assert_eq!(to_integers(&[0.0, largest, -0.0], &mut integers), Ok(()));
        assert_eq!(integers, [0, bits << bits.leading_zeros(), 0]);
    }
    for (tiny, due) in [(1e-30, 0), (4.6e-10, 0), (4.7e-10, 1), (1e-9, 2)] {
        let mut integers = [9; 2];
        assert_eq!(to_integers(&[1.0, tiny], &mut integers), Ok(()));
        assert_eq!(integers, [1 << 31, due], "{tiny:e}");
    }
    // Of a million particles all but one are dead.
    let mut weights = vec![1e-30; 1_000_000];
    weights[765_432] = 1.0;
    let mut counts = vec![0; weights.len()];
    to_integers(&weights, &mut counts).unwrap();
    systematic(&mut counts, 1_000_000, 0x1234_5678).unwrap();
    let copies_of_dead = 1_000_000 - counts[765_432];
    assert_eq!(copies_of_dead, 0);
}
