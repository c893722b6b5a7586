//! `NegativeBinomial`: the words of every count against sums of 512 bits, its pmf, its ends and its refusals, and what a draw
//! takes.

use crate::ends::{Ends, Exact, ends, excess, noticed, off_in_floats, ratio, takes_one};
use host::errors::or_infinite;
use host::speed;
use microwarp::discrete::{Binomial, Geometric, NegativeBinomial};
use microwarp::{Error, constant};
use num_bigint::BigUint;
use rand_pcg::Pcg32;
use rand_pcg::rand_core::Rng;

/// The law of r successes, in units of 2⁻³¹, of a probability that is a ratio.
fn exact(successes: u64, [part, whole]: [u128; 2]) -> Exact {
    let (r, other) = (u128::from(successes), whole - part);
    let mode = (r.saturating_sub(1 << 31) * other / part) >> 31;
    let least = BigUint::from(1_u32) << 300_u32;
    let one = BigUint::from(1_u32) << 512_u32;
    Exact::around(mode as u32, one, [0, u32::MAX], &least, |k| {
        let k = u128::from(k);
        // Without the common divisor, a power of two, of p as an `f32`.
        let shift = part.trailing_zeros().min(whole.trailing_zeros());
        [
            (((k - 1) << 31) + r) * (other >> shift),
            (k << 31) * (whole >> shift),
        ]
    })
}

fn found(sampler: &NegativeBinomial, exact: &Exact) -> Ends {
    ends(&|word| sampler.count(word), &|k| sampler.words_of(k), |k| {
        exact.words(k)
    })
}

fn units(successes: f32) -> u64 {
    (f64::from(successes) * 2_f64.powi(31)) as u64
}

/// A probability of success, and as many successes as it allows or fewer.
fn any(rng: &mut Pcg32) -> (f32, f32) {
    let mut part = || (f64::from(rng.next_u32()) + 0.5) / 2_f64.powi(32);
    let p = match (4.0 * part()) as u32 {
        0 => 1.0 - 0.899_999_f64.min(1e-7_f64.powf(part())),
        _ => 0.100_000_1 * 9.9_f64.powf(part()),
    } as f32;
    let most = (199.999 * f64::from(p) * f64::from(p) / (1.0 - f64::from(p))).min(4e9);
    let least = 2_f64.powi(-7);
    let successes = match (3.0 * part()) as u32 {
        0 => most,
        _ => least * (most / least).powf(part()),
    };
    (successes as f32, p)
}

#[test]
fn negative_binomial_counts_have_their_words() {
    let number = speed::of("negative binomial laws with all their words", 100, 20_000);
    let mut rng = Pcg32::new(33, 6);
    let special = [
        (0.007_812_5, 0.1),
        (1.0, 0.1),
        (2.222_222, 0.1),
        (199.999, 0.618_034),
        (100.0, 0.5),
        (3_300_000_000.0, 0.999_999_94),
        (0.3, 0.999_999_94),
    ];
    let (mut counts, mut moved, mut doubt, mut widest) = (0, 0, 0.0_f64, 0);
    for (successes, p) in special
        .into_iter()
        .chain((0..number).map(|_| any(&mut rng)))
    {
        let sampler = NegativeBinomial::new(successes, p).unwrap();
        let found = found(&sampler, &exact(units(successes), ratio(p)));
        assert!(found.doubt < 2_f64.powi(-16), "{successes}, {p}: {found:?}");
        (counts, moved) = (counts + found.counts, moved + found.moved);
        widest = widest.max(sampler.count(u32::MAX) - sampler.count(0) + 1);
        doubt = doubt.max(found.doubt);
    }
    println!(
        "{counts} counts, {moved} ends in doubt by {doubt:e}; at most {widest} counts of a law"
    );
    assert!(widest <= 256);
    for (successes, part, whole) in [
        (3, 3, 4),
        (1, 1, 10),
        (2, 1, 10),
        (77, 11, 12),
        (u32::MAX, u32::MAX - 190, u32::MAX),
    ] {
        let sampler = NegativeBinomial::from_ratio(successes, part, whole).unwrap();
        let law = exact(u64::from(successes) << 31, [part.into(), whole.into()]);
        let found = found(&sampler, &law);
        assert!(found.doubt < 2_f64.powi(-16), "{successes}: {found:?}");
    }
}

/// The truth of the other tests: its first weight is pʳ of the whole.
#[test]
fn the_sum_of_negative_binomial_weights_is_a_power() {
    for (successes, part, whole) in [(1, 1, 10), (2, 1, 10), (9, 3, 7), (40, 2, 3)] {
        let law = exact(successes << 31, [part, whole]);
        let power = |x: u128| BigUint::from(x).pow(successes as u32);
        let exact = (power(part) << 200_u32) / power(whole);
        let found = (&law.each[0] << 200_u32) / &law.whole;
        assert_eq!(law.from, 0);
        assert!(exact.clone().max(found.clone()) - exact.min(found) < BigUint::from(1_u32 << 20));
    }
}

#[test]
fn the_pmf_of_a_negative_binomial_is_that_of_the_formula() {
    let (mut worst, mut rng) = (0.0_f64, Pcg32::new(33, 7));
    for _ in 0..speed::of("negative binomial laws with their pmf", 40, 2000) {
        let (successes, p) = any(&mut rng);
        let sampler = NegativeBinomial::new(successes, p).unwrap();
        let law = exact(units(successes), ratio(p));
        for k in (0..law.from + law.each.len() as u32 + 40).step_by(17) {
            let error = excess(sampler.pmf(k), law.pmf(k));
            worst = worst.max(or_infinite(error));
        }
        assert!(sampler.pmf(sampler.count(rng.next_u32())) > 0.0);
        assert_eq!(sampler.pmf(u32::MAX), 0.0);
    }
    println!("{worst:.3} of the bound");
    assert!(worst <= 1.0);
}

/// p = 1 gives one count; one success is the geometric distribution.
#[test]
fn ends_of_negative_binomial_parameters_are_exact() {
    for successes in [0.007_812_5, 1.0, 4_294_967_040.0] {
        let sampler = NegativeBinomial::new(successes, 1.0).unwrap();
        assert_eq!((sampler.count(0), sampler.count(u32::MAX)), (0, 0));
        assert_eq!(sampler.words_of(0), Some(0..=u32::MAX));
        assert_eq!(sampler.words_of(1), None);
        assert_eq!([0, 1, u32::MAX].map(|k| sampler.pmf(k)), [1.0, 0.0, 0.0]);
        assert_eq!((sampler.successes(), sampler.success()), (successes, 1.0));
    }
    for (part, whole) in [(1, 10), (1, 6), (2, 3)] {
        let geometric = Geometric::from_ratio(part, whole).unwrap();
        let one = NegativeBinomial::from_ratio(1, part, whole).unwrap();
        for k in 0..300 {
            assert_eq!(
                one.words_of(k),
                geometric.words_of(k),
                "{part}/{whole}: {k}"
            );
        }
    }
    assert_eq!(
        NegativeBinomial::from_ratio(9, 3, 8),
        NegativeBinomial::new(9.0, 0.375)
    );
}

#[test]
fn negative_binomial_parameters_out_of_range_are_refused() {
    for (successes, p, error) in [
        (f32::NAN, 0.5, Error::NotFinite(0)),
        (f32::INFINITY, 0.5, Error::NotFinite(0)),
        (3.0, f32::NAN, Error::NotFinite(1)),
        (0.0, 0.5, Error::NotPositive(0)),
        (-1.0, 0.5, Error::NotPositive(0)),
        (3.0, 0.0, Error::NotPositive(1)),
        (3.0, -0.5, Error::NotPositive(1)),
        (0.007_812_4, 0.5, Error::OutOfRange(0)),
        (3.0, 1.000_000_1, Error::OutOfRange(1)),
        (1.0, 0.099_999_99, Error::TooLarge(1)),
        (2.222_223, 0.1, Error::TooLarge(1)),
        (100.001, 0.5, Error::TooLarge(1)),
        (4_294_967_300.0, 1.0, Error::TooLarge(0)),
        (f32::MAX, 1.0, Error::TooLarge(0)),
        (1e-45, 1e-45, Error::OutOfRange(0)),
    ] {
        assert_eq!(
            NegativeBinomial::new(successes, p),
            Err(error),
            "{successes}, {p}"
        );
    }
    for (successes, part, whole, error) in [
        (0, 1, 2, Error::NotPositive(0)),
        (3, 0, 2, Error::NotPositive(1)),
        (3, 1, 0, Error::NotPositive(2)),
        (3, 3, 2, Error::OutOfRange(2)),
        (1, 1, 11, Error::TooLarge(2)),
        (101, 1, 2, Error::TooLarge(Error::NO_PLACE)),
    ] {
        assert_eq!(
            NegativeBinomial::from_ratio(successes, part, whole),
            Err(error)
        );
    }
}

#[test]
fn a_negative_binomial_draw_takes_one_word() {
    const LOST: NegativeBinomial = constant!(NegativeBinomial::new(3.5, 0.25));
    assert_eq!(size_of::<NegativeBinomial>(), 1104);
    takes_one(|rng| LOST.try_draw(rng), |word| LOST.count(word));
    for (u, word) in [(f32::NAN, 0), (0.25, 1 << 30), (7.0, 0xffff_ff00)] {
        assert_eq!(LOST.sample(u), LOST.count(word));
    }
}

/// Another p, another r, successes that count as trials, and sums in `f32`.
#[test]
fn wrong_negative_binomial_laws_are_noticed() {
    let sampler = NegativeBinomial::from_ratio(12, 3, 10).unwrap();
    let of = |r: f64, part, whole| {
        let law = exact((r * 2_f64.powi(31)) as u64, [part, whole]);
        noticed(&|| found(&sampler, &law))
    };
    assert!(!of(12.0, 3, 10));
    assert!(of(12.0, 30_000_001, 100_000_000) && of(12.000_001, 3, 10) && of(13.0, 3, 10));
    let law = exact(12 << 31, [3, 10]);
    let trials = Binomial::from_ratio(40, 7, 10).unwrap();
    assert!(noticed(&|| {
        ends(&|word| trials.count(word), &|k| trials.words_of(k), |k| {
            law.words(k)
        })
    }));
    assert!(off_in_floats(|k| sampler.pmf(k), &law) > 10);
}
