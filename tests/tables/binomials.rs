//! `Binomial`: the words of every count against sums of 512 bits, which leaves no word out; its pmf, its ends and its
//! refusals, and what a draw takes.

use crate::ends::{Ends, Exact, ends, excess, noticed, off_in_floats, ratio, takes_one};
use host::errors::or_infinite;
use host::speed;
use microwarp::discrete::Binomial;
use microwarp::{Error, constant};
use num_bigint::BigUint;
use rand_pcg::Pcg32;
use rand_pcg::rand_core::Rng;

/// The law of trials with a probability that is a ratio.
fn exact(trials: u32, [part, whole]: [u128; 2]) -> Exact {
    let mode = (u128::from(trials) + 1) * part / whole;
    let least = BigUint::from(1_u32) << 300_u32;
    let one = BigUint::from(1_u32) << 512_u32;
    // Without the common divisor, a power of two, of p as an `f32`.
    let shift = part.trailing_zeros().min(whole.trailing_zeros());
    let (part, other) = (part >> shift, (whole - part) >> shift);
    let mode = mode.min(trials.into()) as u32;
    Exact::around(mode, one, [0, trials], &least, |k| {
        [u128::from(trials - k + 1) * part, u128::from(k) * other]
    })
}

fn found(sampler: &Binomial, law: &Exact) -> Ends {
    ends(&|word| sampler.count(word), &|k| sampler.words_of(k), |k| {
        law.words(k)
    })
}

/// A probability of any size, and as many trials as it allows or fewer.
fn any(rng: &mut Pcg32) -> (u32, f32) {
    let part = |rng: &mut Pcg32| (f64::from(rng.next_u32()) + 0.5) / 2_f64.powi(32);
    let p = match rng.next_u32() % 4 {
        0 => 1e-9_f64.powf(part(rng)),
        1 => 1.0 - 1e-7_f64.powf(part(rng)),
        _ => part(rng),
    } as f32;
    let most = (99.9999 / (f64::from(p) * (1.0 - f64::from(p)))).min(f64::from(u32::MAX));
    let trials = if rng.next_u32() % 3 == 0 {
        most
    } else {
        most.powf(part(rng))
    };
    (trials as u32, p)
}

#[test]
fn binomial_counts_have_their_words() {
    let number = speed::of("binomial distributions with all their words", 150, 20_000);
    let mut rng = Pcg32::new(33, 4);
    let special = [
        (1, 0.5),
        (1, 1e-45),
        (3, f32::MIN_POSITIVE),
        (u32::MAX, 1e-45),
        (u32::MAX, 2.3e-8),
        (400, 0.5),
        (1_677_721_600, 0.999_999_94),
        (1111, 0.1),
        (1111, 0.9),
    ];
    let (mut counts, mut moved) = (0, 0);
    for (trials, p) in special
        .into_iter()
        .chain((0..number).map(|_| any(&mut rng)))
    {
        let sampler = Binomial::new(trials, p).unwrap();
        let found = found(&sampler, &exact(trials, ratio(p)));
        assert!(found.doubt < 2_f64.powi(-20), "{trials}, {p:e}: {found:?}");
        (counts, moved) = (counts + found.counts, moved + found.moved);
    }
    for (trials, part, whole) in [
        (10, 1, 6),
        (1, 1, 2),
        (7, 5, 5),
        (360, 1, 3),
        (u32::MAX, 1, u32::MAX),
        (u32::MAX, u32::MAX - 90, u32::MAX),
    ] {
        let sampler = Binomial::from_ratio(trials, part, whole).unwrap();
        let found = found(&sampler, &exact(trials, [part.into(), whole.into()]));
        assert!(
            found.doubt < 2_f64.powi(-20),
            "{trials}, {part}/{whole}: {found:?}"
        );
    }
    println!("{counts} counts, {moved} ends in doubt");
}

#[test]
fn the_pmf_of_a_binomial_is_that_of_the_formula() {
    let mut worst = 0.0_f64;
    let mut rng = Pcg32::new(33, 5);
    for _ in 0..speed::of("binomial distributions with their pmf", 60, 2000) {
        let (trials, p) = any(&mut rng);
        let (sampler, law) = (Binomial::new(trials, p).unwrap(), exact(trials, ratio(p)));
        for k in (law.from..).take(law.each.len()) {
            let error = excess(sampler.pmf(k), law.pmf(k));
            worst = worst.max(or_infinite(error));
        }
        assert!(sampler.pmf(sampler.count(rng.next_u32())) > 0.0);
        assert_eq!(
            sampler.pmf(trials.saturating_add(1)),
            [0.0, sampler.pmf(trials)][usize::from(trials == u32::MAX)]
        );
    }
    println!("{worst:.3} of the bound");
    assert!(worst <= 1.0);
}

/// p = 0, p = 1 and no trials give one count; the count of failures is the mirror image.
#[test]
fn ends_of_the_parameters_are_exact() {
    for (trials, p, count) in [
        (5, 0.0, 0),
        (5, -0.0, 0),
        (5, 1.0, 5),
        (u32::MAX, 1.0, u32::MAX),
        (u32::MAX, 0.0, 0),
        (0, 0.3, 0),
        (0, 1.0, 0),
    ] {
        let sampler = Binomial::new(trials, p).unwrap();
        for word in [0, 1, 1 << 31, u32::MAX] {
            assert_eq!(sampler.count(word), count);
        }
        assert_eq!(sampler.words_of(count), Some(0..=u32::MAX));
        assert_eq!(sampler.pmf(count), 1.0);
        for other in [0, 1, 4, 5, 6, u32::MAX - 1, u32::MAX] {
            if other != count {
                assert_eq!((sampler.pmf(other), sampler.words_of(other)), (0.0, None));
            }
        }
        assert_eq!((sampler.trials(), sampler.success()), (trials, p));
    }
    assert_eq!(Binomial::from_ratio(9, 0, 3), Binomial::new(9, 0.0));
    assert_eq!(Binomial::from_ratio(9, 7, 7), Binomial::new(9, 1.0));
    assert_eq!(Binomial::from_ratio(9, 3, 8), Binomial::new(9, 0.375));
    for (trials, part, whole) in [(40, 1, 7), (300, 2, 5), (1000, 1, 12)] {
        let rare = Binomial::from_ratio(trials, part, whole).unwrap();
        let other = Binomial::from_ratio(trials, whole - part, whole).unwrap();
        for i in 0..4096_u32 {
            let word = i.wrapping_mul(0x9e37_79b9);
            assert_eq!(rare.count(word), trials - other.count(!word));
        }
    }
}

#[test]
fn binomial_parameters_out_of_range_are_refused() {
    for (trials, p, error) in [
        (3, f32::NAN, Error::NotFinite(1)),
        (3, f32::INFINITY, Error::NotFinite(1)),
        (0, f32::NAN, Error::NotFinite(1)),
        (3, -1e-45, Error::OutOfRange(1)),
        (3, 1.000_000_1, Error::OutOfRange(1)),
        (401, 0.5, Error::TooLarge(1)),
        (u32::MAX, 0.5, Error::TooLarge(1)),
        (u32::MAX, 2.4e-8, Error::TooLarge(1)),
        (u32::MAX, 0.999_999_9, Error::TooLarge(1)),
    ] {
        assert_eq!(Binomial::new(trials, p), Err(error), "{trials}, {p}");
    }
    for (trials, part, whole, error) in [
        (3, 0, 0, Error::NotPositive(2)),
        (3, 4, 3, Error::OutOfRange(2)),
        (u32::MAX, 1, 2, Error::TooLarge(Error::NO_PLACE)),
    ] {
        assert_eq!(Binomial::from_ratio(trials, part, whole), Err(error));
    }
}

#[test]
fn a_binomial_draw_takes_one_word() {
    const COINS: Binomial = constant!(Binomial::new(100, 0.5));
    assert_eq!(size_of::<Binomial>(), 592);
    takes_one(|rng| COINS.try_draw(rng), |word| COINS.count(word));
    for (u, word) in [
        (f32::NAN, 0),
        (-1.0, 0),
        (0.25, 1 << 30),
        (7.0, 0xffff_ff00),
    ] {
        assert_eq!(COINS.sample(u), COINS.count(word));
    }
}

/// Another p, another n, sums in `f32`, and the Poisson distribution of the same mean.
#[test]
fn wrong_binomial_laws_are_noticed() {
    let sampler = Binomial::from_ratio(100, 3, 10).unwrap();
    let of = |trials, part, whole| noticed(&|| found(&sampler, &exact(trials, [part, whole])));
    assert!(!of(100, 3, 10));
    assert!(of(100, 30_000_001, 100_000_000) && of(101, 3, 10));
    // Nearly the Poisson distribution of a mean of 7, in place of that of 1,000 trials.
    let rare = Binomial::from_ratio(1_000_000, 7, 1_000_000).unwrap();
    assert!(noticed(&|| { found(&rare, &exact(1_000, [7, 1_000])) }));
    let law = exact(100, [3, 10]);
    assert!(off_in_floats(|k| sampler.pmf(k), &law) > 10);
}
