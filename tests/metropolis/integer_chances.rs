//! How many words accept, of integer weights: the exact number, for weights and ratios of any magnitude.

use super::own::given;
use host::generators::Cycle;
use host::speed;
use microwarp::metropolis::{
    Chain, Chance, HastingsCorrection, HastingsCounts, HastingsRatio, Outcome, Symmetric,
    Transition,
};
use num_bigint::BigUint;
use rand_core::Rng as _;
use rand_pcg::Pcg32;

/// All decision words, and all words of the widest table.
pub const ALL: u64 = 1 << 32;
pub const MOST: u128 = 1 << 64;

pub const WEIGHTS: [u32; 12] = [
    1,
    2,
    3,
    7,
    0xffff,
    0x1_0001,
    0x7fff_ffff,
    0x8000_0000,
    0x8000_0001,
    0xaaaa_aaab,
    u32::MAX - 1,
    u32::MAX,
];
const COUNTS: [u128; 13] = [
    1,
    2,
    3,
    0xffff_fffe,
    0xffff_ffff,
    1 << 32,
    (1 << 32) + 1,
    0x5555_5555_5555,
    (1 << 63) - 1,
    1 << 63,
    MOST - 2,
    MOST - 1,
    MOST,
];

/// ⌈2³² part/whole⌉, or all.
pub fn ceiling(part: BigUint, whole: &BigUint) -> u64 {
    let words = ((part << 32_u32) + whole - 1_u32) / whole;
    words.try_into().unwrap_or(ALL).min(ALL)
}

/// How many words accept, by integers of any size.
pub fn due(from: u32, to: u32, counts: [u128; 2]) -> u64 {
    let [forward, backward] = counts.map(BigUint::from);
    ceiling(backward * to, &(forward * from))
}

/// The step of a chain at a state of weight `from` to which one of weight `to` is proposed.
fn step<C: HastingsCorrection>(
    from: u32,
    to: u32,
    correction: C,
    word: u32,
) -> (Transition<usize, u32, Chance>, Chain<usize, u32>) {
    let weight = |state: usize| if state == 0 { from } else { to };
    let mut chain = Chain::new(0, weight).unwrap();
    let step = chain.step(weight, &given(1, correction), &mut Cycle::new(&[word]));
    assert_eq!(chain.state(), step.state());
    assert_eq!(chain.density(), step.density());
    assert_eq!(chain.accepted(), u64::from(step.is_accepted()));
    (step, chain)
}

/// The words that the step reports, after asking the words on both sides of the border, and the ends.
pub fn words<C: HastingsCorrection>(from: u32, to: u32, correction: C) -> u64 {
    let words = step(from, to, correction, 0).0.acceptance.words();
    assert!(words <= ALL);
    let border = [words.checked_sub(2), words.checked_sub(1), Some(words)];
    let beyond = [Some(words + 1), Some(0), Some(ALL - 1)];
    for word in border.into_iter().chain(beyond).flatten() {
        let Ok(word) = u32::try_from(word) else {
            continue;
        };
        let (step, _) = step(from, to, correction, word);
        let accepts = u64::from(word) < words;
        assert_eq!(step.is_accepted(), accepts, "{from} -> {to}, word {word}");
        assert_eq!(step.acceptance.accepts(word), accepts);
        let outcome = [Outcome::Rejected, Outcome::Accepted][usize::from(accepts)];
        assert_eq!(step.outcome, outcome);
        // Both shares, whatever the word.
        assert_eq!(step.recorded(), [(0, ALL - words), (1, words)]);
    }
    words
}

/// Any number of up to `bits` bits, each length as likely as the next; never 0.
fn any(rng: &mut Pcg32, bits: u32) -> u64 {
    let leading = rng.next_u32() % bits;
    (rng.next_u64() >> (64 - bits) >> leading).max(1)
}

fn weight(rng: &mut Pcg32) -> u32 {
    any(rng, 32) as u32
}

#[test]
fn symmetric_proposals_are_accepted_by_the_exact_number_of_words() {
    let check = |from, to| {
        assert_eq!(words(from, to, Symmetric), due(from, to, [1, 1]));
    };
    for from in WEIGHTS {
        for to in WEIGHTS {
            check(from, to);
        }
    }
    let mut rng = Pcg32::new(1, 1);
    let rounds = speed::of("rounds", 60_000, 300_000);
    for _ in 0..rounds {
        check(weight(&mut rng), weight(&mut rng));
    }
    // Next to each other, where all but a few words accept, and far apart.
    for _ in 0..rounds / 3 {
        let from = rng.next_u32() | 1 << 31;
        check(from, from - rng.next_u32() % 3);
        check(from, 1 + rng.next_u32() % 3);
    }
}

#[test]
fn proposals_with_counts_are_accepted_by_the_exact_number_of_words() {
    let mut rng = Pcg32::new(2, 2);
    let mut seen = [0_u32; 3];
    let mut check = |from, to, counts: [u128; 2]| {
        let got = words(from, to, HastingsCounts::new(counts[0], counts[1]));
        assert_eq!(
            got,
            due(from, to, counts),
            "{from} -> {to}, counts {counts:?}"
        );
        seen[match got {
            1 => 0,
            ALL => 2,
            _ => 1,
        }] += 1;
    };
    for from in WEIGHTS {
        for to in WEIGHTS {
            for forward in COUNTS {
                for backward in COUNTS {
                    check(from, to, [forward, backward]);
                }
            }
        }
    }
    let rounds = speed::of("rounds", 60_000, 300_000);
    for round in 0..rounds {
        // Those of tables of u32, then those of u64 as well.
        let bits = if round % 2 == 0 { 32 } else { 64 };
        let counts = [any(&mut rng, bits), any(&mut rng, bits)].map(u128::from);
        check(weight(&mut rng), weight(&mut rng), counts);
    }
    // Products that agree but for a little: T' is what makes f'T' next to fT, or to a whole number of words of it.
    for _ in 0..rounds {
        let (from, to) = (weight(&mut rng), weight(&mut rng));
        let forward = u128::from(any(&mut rng, 64));
        let whole = u128::from(from) * forward;
        let part = match rng.next_u32() % 2 {
            0 => whole,
            _ => (whole >> 32) * u128::from(rng.next_u32()),
        };
        let around = u128::from(rng.next_u32() % 3);
        let backward = (part / u128::from(to) + around).clamp(1, MOST);
        check(from, to, [forward, backward]);
    }
    println!("one word, some, all: {seen:?}");
    assert!(seen.iter().all(|n| *n > rounds / 30));
}

/// A ratio in floating point is an integer of 24 bits times a power of two, and counts as that.
#[test]
fn proposals_with_a_ratio_are_accepted_by_the_exact_number_of_words() {
    let mut rng = Pcg32::new(3, 3);
    let mut seen = [0_u32; 2];
    let rounds = speed::of("rounds", 60_000, 300_000);
    for round in 0..rounds {
        let (from, to) = (weight(&mut rng), weight(&mut rng));
        // Any bit pattern, or one that makes an acceptance between 2^-40 and 2.
        let ratio = match round % 2 {
            0 => f32::from_bits(1 + rng.next_u32() % (f32::INFINITY.to_bits() - 1)),
            _ => {
                let near = from as f32 / to as f32 * 2_f32.powi(-((rng.next_u32() % 40) as i32));
                f32::from_bits(near.to_bits() ^ rng.next_u32() >> 10)
            }
        };
        let bits = ratio.to_bits();
        let (field, fraction) = (bits >> 23, bits & 0x7f_ffff);
        let (digits, exponent) = match field {
            0 => (fraction, -149),
            _ => (fraction | 0x80_0000, field as i32 - 150),
        };
        let (part, whole) = (BigUint::from(digits) * to, BigUint::from(from));
        let exact = match exponent {
            0.. => ceiling(part << exponent as u32, &whole),
            _ => ceiling(part, &(whole << exponent.unsigned_abs())),
        };
        let got = words(from, to, HastingsRatio::new(1.0, ratio));
        assert_eq!(got, exact, "{from} -> {to}, ratio {ratio:e}");
        seen[usize::from(got > 1 && got < ALL)] += 1;
    }
    println!("one word or all, and others: {seen:?}");
    assert!(seen.iter().all(|n| *n > rounds / 6));
}

#[test]
fn a_proposal_without_a_way_is_never_accepted() {
    for from in WEIGHTS {
        for word in [0, 1, u32::MAX] {
            let never = [
                step(from, 0, Symmetric, word),
                step(from, 0, HastingsCounts::new(1, 1), word),
                step(from, 0, HastingsCounts::new(1, MOST), word),
                step(from, 0, HastingsRatio::new(1e-38, 1e38), word),
                step(from, 5, HastingsCounts::new(1, 0), word),
                step(from, 5, HastingsRatio::from_counts(1, 0), word),
            ];
            for (step, chain) in never {
                assert_eq!((step.acceptance.words(), step.state()), (0, 0));
                assert_eq!((step.outcome, chain.refused()), (Outcome::Rejected, 0));
                assert_eq!(step.recorded(), [(0, ALL), (1, 0)]);
            }
            let refused = [
                step(from, 5, HastingsCounts::new(0, 1), word),
                step(from, 0, HastingsCounts::new(0, 0), word),
                step(from, 5, HastingsRatio::new(f32::NAN, 1.0), word),
            ];
            for (step, chain) in refused {
                assert_eq!((step.acceptance.words(), step.state()), (0, 0));
                assert_eq!((step.outcome, chain.refused()), (Outcome::Refused, 1));
            }
        }
    }
}

#[test]
fn chances_are_equal_if_the_same_words_accept() {
    let chance = |from, to, counts: [u128; 2]| {
        let counts = HastingsCounts::new(counts[0], counts[1]);
        step(from, to, counts, 0).0.acceptance
    };
    assert_eq!(
        chance(2, 1, [1, 1]),
        chance(u32::MAX - 1, u32::MAX / 2, [7, 7])
    );
    assert_eq!(chance(2, 1, [1, 1]), chance(1, 1, [MOST, MOST / 2]));
    assert_eq!(chance(1, 1, [MOST, 1]), chance(u32::MAX, 1, [1 << 40, 1]));
    assert_eq!(chance(1, 2, [1, 1]), chance(1, 1, [1, 1]));
    assert_ne!(chance(3, 1, [1, 1]), chance(3, 2, [1, 1]));
    assert_ne!(chance(u32::MAX, 2, [1, 1]), chance(u32::MAX, 1, [1, 1]));
}
