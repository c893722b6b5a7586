//! How near the hashes are to what they stand for: Owen's scrambling, and independent random words.

use host::speed;
use host::stats::{chi_square, passes, threshold, two_sided};
use microwarp::uniform::{ByPosition, Points, Sobol};
use rand_pcg::Pcg32;
use rand_pcg::rand_core::Rng;
use std::collections::HashSet;

/// A scrambling of reversed bits: of a word, by a seed.
type Scrambling = fn(u32, u32) -> u32;

/// The crate's: the first coordinate before it is scrambled is the index.
fn ours(x: u32, seed: u32) -> u32 {
    Sobol::<1>::new(seed).unwrap().word(x, 0).reverse_bits()
}

/// Burley's of 2020.
fn burley(x: u32, seed: u32) -> u32 {
    let factors = [0x6c50_b47c, 0xb82f_1e52, 0xc7af_e638, 0x8d22_f6e6_u32];
    let sum = x.wrapping_add(Pcg32::new(seed.into(), 1).next_u32());
    factors
        .into_iter()
        .fold(sum, |x, factor| x ^ x.wrapping_mul(factor))
}

/// The largest distance from 1/2 of the chance that a changed bit changes the flip of a later one.
fn tree_bias(scrambling: Scrambling, words: u32) -> f64 {
    let mut rng = Pcg32::new(5, 1);
    let mut changed = [[0_u32; 32]; 32];
    for _ in 0..words {
        let (x, seed) = (rng.next_u32(), rng.next_u32());
        let flipped = scrambling(x, seed);
        for (bit, later) in changed.iter_mut().enumerate() {
            let difference = flipped ^ scrambling(x ^ 1 << bit, seed);
            assert_eq!(difference.trailing_zeros() as usize, bit, "not nested");
            for (k, count) in later.iter_mut().enumerate().skip(bit + 1) {
                *count += difference >> k & 1;
            }
        }
    }
    let chances = (0..32).flat_map(|bit| changed[bit][bit + 1..].to_vec());
    let off = chances.map(|count| (f64::from(count) / f64::from(words) - 0.5).abs());
    off.fold(0.0, f64::max)
}

#[test]
fn each_bit_is_flipped_independently_of_those_before_it() {
    let words = speed::of("words scrambled", 1 << 14, 1 << 18);
    // Five standard deviations, for 496 pairs of bits.
    let noise = 2.5 / f64::from(words).sqrt();
    let [ours, burley] = [ours as Scrambling, burley].map(|s| tree_bias(s, words));
    println!("tree bias {ours:.4}, Burley's {burley:.3}, noise {noise:.4}");
    assert!(ours <= noise);
    assert!(burley > 0.2);
}

/// p-values, over seeds: each node of the first levels of the tree flips half the time, each two independently.
fn nodes(scrambling: Scrambling, seeds: u32) -> Vec<f64> {
    const LEVELS: u32 = 5;
    let nodes = || (0..LEVELS).flat_map(|level| (0..1_u32 << level).map(move |x| (level, x)));
    let signs: Vec<Vec<i32>> = nodes()
        .map(|(level, x)| {
            let flip = |seed| (scrambling(x, seed) ^ x) >> level & 1;
            (0..seeds).map(|seed| 1 - 2 * flip(seed) as i32).collect()
        })
        .collect();
    let p = |sum: i32| two_sided(f64::from(sum) / f64::from(seeds).sqrt());
    let mut found: Vec<f64> = signs.iter().map(|s| p(s.iter().sum())).collect();
    for (k, one) in signs.iter().enumerate() {
        let others = &signs[..k];
        found.extend(
            others
                .iter()
                .map(|s| p(s.iter().zip(one).map(|(a, b)| a * b).sum())),
        );
    }
    found
}

#[test]
fn the_first_bits_are_flipped_pairwise_independently_over_seeds() {
    let seeds = speed::of("seeds of a tree", 1 << 14, 1 << 18);
    let found = nodes(ours, seeds);
    let limit = threshold(found.len());
    println!(
        "{} pairs, smallest p {:.1e}",
        found.len(),
        found.iter().copied().fold(1.0, f64::min)
    );
    assert!(passes(&found, limit));
    assert!(!passes(&nodes(burley, seeds), limit));
}

/// A word from seed, pixel, sample and dimension.
type Hash = fn([u32; 4]) -> u32;

fn by_position([seed, pixel, sample, dimension]: [u32; 4]) -> u32 {
    ByPosition::new(seed, pixel).word(sample, dimension)
}

/// Sums of products, and one more product: what is often written in a hurry.
fn hurried([seed, pixel, sample, dimension]: [u32; 4]) -> u32 {
    let sum = seed.wrapping_mul(0x9e37_79b9) ^ pixel.wrapping_mul(0x85eb_ca6b);
    let sum =
        sum.wrapping_add(sample.wrapping_mul(0xc2b2_ae35)) ^ dimension.wrapping_mul(0x27d4_eb2f);
    (sum ^ sum >> 15).wrapping_mul(0x2c1b_3c6d)
}

/// Positions as they are used, all numbers small.
fn positions(count: u32) -> impl Iterator<Item = [u32; 4]> {
    (0..count).map(|k| [k >> 18, k >> 8 & 0x3ff, k >> 3 & 31, k & 7])
}

/// p-values of equally frequent bytes, and of words beside each neighbour's.
fn frequencies(hash: Hash, count: u32) -> Vec<f64> {
    let p = |cell: &dyn Fn([u32; 4]) -> u32| {
        let mut cells = [0_u64; 256];
        positions(count).for_each(|at| cells[cell(at) as usize & 255] += 1);
        chi_square(&cells, &[f64::from(count) / 256.0; 256])
            .unwrap()
            .2
    };
    let mut found: Vec<f64> = [0, 8, 16, 24]
        .map(|shift| p(&|at| hash(at) >> shift))
        .into();
    for axis in 0..4 {
        for step in [1, 2, 256] {
            for shift in [0, 12, 28] {
                let nibble = |at| hash(at) >> shift & 15;
                found.push(p(&|mut at| {
                    let here = nibble(at);
                    at[axis] += step;
                    here << 4 | nibble(at)
                }));
            }
        }
    }
    found
}

/// p-values: a changed bit of any of the four numbers changes each bit of the word half the time.
fn avalanche(hash: Hash, count: u32) -> Vec<f64> {
    let mut found = Vec::new();
    for axis in 0..4 {
        for bit in 0..32 {
            let mut changed = [0_u32; 32];
            for at in positions(count) {
                let mut other = at;
                other[axis] ^= 1 << bit;
                let difference = hash(at) ^ hash(other);
                (0..32).for_each(|k| changed[k] += difference >> k & 1);
            }
            let p = |&count_of: &u32| {
                let off = f64::from(count_of) - f64::from(count) / 2.0;
                // Where both positions are tried, a pair counts twice.
                two_sided(off / (f64::from(count) / 2.0).sqrt())
            };
            found.extend(changed.iter().map(p));
        }
    }
    found
}

#[test]
fn words_by_position_are_as_random_ones() {
    let counts = [
        speed::of("positions of frequencies", 1 << 18, 1 << 22),
        speed::of("positions of avalanche", 1 << 12, 1 << 16),
    ];
    let tests = |hash| [frequencies(hash, counts[0]), avalanche(hash, counts[1])];
    for found in tests(by_position as Hash) {
        let smallest = found.iter().copied().fold(1.0, f64::min);
        println!("{} tests, smallest p {smallest:.1e}", found.len());
        assert!(passes(&found, threshold(found.len())));
    }
    for found in tests(hurried) {
        assert!(!passes(&found, threshold(found.len())));
    }
}

/// As many equal words as chance has; and as many equal pairs of words, which is none.
#[test]
fn no_two_positions_share_their_words() {
    let count: u32 = speed::of("positions", 1 << 19, 1 << 20);
    let (mut words, mut pairs) = (HashSet::new(), HashSet::new());
    for at in positions(count) {
        words.insert(by_position(at));
        let [seed, pixel, sample, dimension] = at;
        pairs.insert([dimension, dimension + 8].map(|d| by_position([seed, pixel, sample, d])));
    }
    let equal = f64::from(count) - words.len() as f64;
    // n²/2 over 2^32.
    let expected = f64::from(count).powi(2) / 2f64.powi(33);
    println!("{equal} equal words of {count}, {expected} by chance");
    assert!((equal - expected).abs() <= 6.0 * expected.sqrt());
    assert_eq!(pairs.len(), count as usize);
}

/// The hash of two words that were joined by their difference in bits, which swaps the words of two samples.
fn symmetric([seed, pixel, sample, dimension]: [u32; 4]) -> u32 {
    let word = |seed, number| by_position([seed, 0, 0, number]);
    let both = word(seed ^ pixel, sample) ^ word(!seed ^ pixel, dimension);
    by_position([0, 0, 0, both])
}

/// How often a sample repeats the words that another has in two dimensions, in whichever order.
fn repeated_pairs(hash: Hash, dimensions: u32, [seed, pixel]: [u32; 2]) -> usize {
    let pairs = || (0..dimensions).flat_map(|d| (0..d).map(move |c| [c, d]));
    let of_sample = |sample| pairs().map(move |p| p.map(|d| hash([seed, pixel, sample, d])));
    let mut found: Vec<[u32; 2]> = (0..1 << 20).flat_map(of_sample).collect();
    found.iter_mut().for_each(|pair| pair.sort_unstable());
    found.sort_unstable();
    found.windows(2).filter(|two| two[0] == two[1]).count()
}

/// Two samples of a million share no two words: by chance 3e-8 n pairs do, n being the pairs of dimensions squared.
#[test]
fn no_two_samples_swap_their_words() {
    let dimensions = speed::of("dimensions whose words may be swapped", 2, 6);
    for place in [[0, 0], [2026, 7]] {
        assert_eq!(repeated_pairs(by_position, dimensions, place), 0);
    }
    let swapped = repeated_pairs(symmetric, 2, [0, 0]);
    println!("{swapped} pairs of samples with swapped words, where words are joined by bits");
    assert!(swapped > 60);
}
