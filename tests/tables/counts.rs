//! `Geometric` and `Poisson`: the words of every count against sums of high precision, which leaves no word out; the
//! densities, the refusals, and what a draw takes.

use crate::ends::{Ends, Exact, ends, excess, noticed, ratio, takes_one};
use host::speed;
use host::words::first_without;
use microwarp::Error;
use microwarp::discrete::{Geometric, Poisson};
use num_bigint::BigUint;

/// The probability of failure in units of 2⁻¹²⁸, from the ratio of success.
fn failure(successes: u128, trials: u128) -> BigUint {
    let one = BigUint::from(1_u32) << 128_u32;
    &one - (BigUint::from(successes) << 128_u32) / BigUint::from(trials)
}

/// How many words give up to each count of a geometric distribution, by multiplying step by step with 128 bits.
fn of_failure(failure: BigUint) -> impl FnMut(i64) -> u128 {
    let one = BigUint::from(1_u32) << 128_u32;
    let mut power = one.clone();
    move |count| {
        if count < 0 {
            return 0;
        }
        power = (&power * &failure) >> 128_u32;
        u128::try_from((&one - &power) >> 32_u32).unwrap()
    }
}

fn found(sampler: &Geometric, law: impl FnMut(i64) -> u128) -> Ends {
    ends(&|word| sampler.count(word), &|k| sampler.words_of(k), law)
}

/// Every word of all 2³² gives the count of its middle.
#[test]
fn geometric_counts_have_their_words() {
    let least = speed::of(
        "smallest probability of success with all its counts",
        1e-4,
        1e-6,
    );
    let mut all = 0;
    for p in [
        1.0,
        0.999_999_94,
        0.75,
        0.7,
        0.5,
        0.3,
        0.25,
        0.1,
        0.01,
        1e-3,
        1e-4,
        1e-5,
        1e-6,
    ] {
        if p < least {
            continue;
        }
        let [n, d] = ratio(p);
        let found = found(&Geometric::new(p).unwrap(), of_failure(failure(n, d)));
        println!("p = {p}: {found:?}");
        all += found.counts;
        assert!(found.doubt < 2_f64.powi(-20));
    }
    for (n, d) in [
        (1, 6),
        (1, 2),
        (5, 5),
        (999, 1000),
        (1, 3001),
        (u32::MAX - 1, u32::MAX),
    ] {
        let sampler = Geometric::from_ratio(n, d).unwrap();
        let found = found(&sampler, of_failure(failure(n.into(), d.into())));
        println!("p = {n}/{d}: {found:?}");
        all += found.counts;
        assert!(found.doubt < 2_f64.powi(-20));
    }
    assert!(all > 200_000);
}

/// (1 − p)ᵏ in units of 2⁻¹²⁸, by squaring: good to 2⁻⁹⁰.
fn power(failure: &BigUint, mut k: u32) -> BigUint {
    let mut square = failure.clone();
    let mut product = BigUint::from(1_u32) << 128_u32;
    while k > 0 {
        if k & 1 == 1 {
            product = (&product * &square) >> 128_u32;
        }
        square = (&square * &square) >> 128_u32;
        k >>= 1;
    }
    product
}

/// Words all over, for probabilities that have too many counts to see them all.
#[test]
fn the_smallest_probabilities_keep_their_words() {
    let words = speed::of("words of a small probability", 20_000, 200_000);
    let one = BigUint::from(1_u32) << 128_u32;
    for p in [5.4e-9, 6e-9, 1e-8, 5.960_464_5e-8, 1e-7, 3.3e-6] {
        let (sampler, [n, d]) = (Geometric::new(p).unwrap(), ratio(p));
        let failure = failure(n, d);
        let mut doubt = 0.0_f64;
        let mut last = 0;
        for i in 0..words {
            let word = (u64::from(u32::MAX) * i / (words - 1)) as u32;
            let count = sampler.count(word);
            assert!(count >= last);
            last = count;
            // Of k and of k + 1 failures, from 1 down, in words.
            let reached = [count, count + 1].map(|k| {
                let part = u64::try_from((&one - power(&failure, k)) >> 65_u32).unwrap();
                part as f64 / 2_f64.powi(31)
            });
            let middle = f64::from(word) + 0.5;
            doubt = doubt.max(reached[0] - middle).max(middle - reached[1]);
        }
        println!("p = {p:e}: beyond an end by {doubt:e} words, last count {last}");
        assert!(doubt < 2_f64.powi(-20));
        let end = 33.0 * std::f64::consts::LN_2 / -(-f64::from(p)).ln_1p();
        // The end is that of the last word, to one count of such a probability.
        assert!((f64::from(last) - end).abs() <= 1.0 + end * 1e-15);
    }
}

/// The law of a mean that is a ratio. Below 2⁻³⁷ words know of no count but 0.
fn poisson([part, whole]: [u128; 2]) -> Exact {
    let one = BigUint::from(1_u32) << 512_u32;
    let least = BigUint::from(1_u32) << 300_u32;
    Exact::around((part / whole) as u32, one, [0, u32::MAX], &least, |k| {
        [part, whole * u128::from(k)]
    })
}

fn found_poisson(sampler: &Poisson, law: &Exact) -> Ends {
    ends(&|word| sampler.count(word), &|k| sampler.words_of(k), |k| {
        law.words(k)
    })
}

#[test]
fn poisson_counts_have_their_words() {
    let means = speed::of("means of the Poisson distribution", 400_u32, 20_000);
    let special = [
        1e-45, 1e-20, 1e-9, 2e-10, 1e-3, 0.5, 1.0, 1.5, 2.0, 63.999_996, 64.0, 79.999_99, 80.0,
    ];
    let mut moved = 0;
    for mean in (1..=means)
        .map(|i| 80.0 * i as f32 / means as f32)
        .chain(special)
    {
        let sampler = Poisson::new(mean).unwrap();
        let found = found_poisson(&sampler, &poisson(ratio(mean)));
        moved += found.moved;
        assert!(found.doubt < 2_f64.powi(-12), "{mean}: {found:?}");
        let (first, last) = (sampler.count(0), sampler.count(u32::MAX));
        let mode = mean as u32;
        assert!(
            last <= 143 && mode - first <= 80 && last - mode <= 80,
            "{mean}: {first}..={last}"
        );
    }
    println!("{moved} ends of {means} means in doubt");
    for (n, d) in [(7, 2), (80, 1), (1, 3), (1, u32::MAX)] {
        let sampler = Poisson::from_ratio(n, d).unwrap();
        let found = found_poisson(&sampler, &poisson([n, d].map(u128::from)));
        assert!(found.doubt < 2_f64.powi(-12), "{n}/{d}: {found:?}");
    }
}

#[test]
fn probabilities_are_those_of_the_formulas() {
    let mut worst = [0.0_f64; 2];
    for p in [1.0, 0.999_999_94, 0.5, 0.3, 0.1, 1e-3, 1e-5, 5.4e-9_f32] {
        let sampler = Geometric::new(p).unwrap();
        let rate = (-f64::from(p)).ln_1p();
        for k in (0..40)
            .chain((0..400).map(|i| (1.07_f64.powi(i) as u32).max(1)))
            .chain([u32::MAX])
        {
            let exact = if k == 0 {
                f64::from(p)
            } else {
                f64::from(p) * (rate * f64::from(k)).exp()
            };
            // The exponential of the truth is right to 1e-16 of its argument, beyond 1000 it is 0.
            worst[0] = worst[0].max(excess(sampler.pmf(k), exact));
        }
    }
    for mean in [1e-45_f32, 1e-10, 0.01, 0.9, 1.0, 7.7, 30.2, 80.0] {
        let sampler = Poisson::new(mean).unwrap();
        let law = poisson(ratio(mean));
        for k in 0..300 {
            worst[1] = worst[1].max(excess(sampler.pmf(k), law.pmf(k)));
        }
        assert_eq!(sampler.pmf(u32::MAX), 0.0);
    }
    println!("{worst:.3?} of the bounds");
    assert!(worst.iter().all(|w| *w <= 1.0), "{worst:?}");
}

/// A word of any count has a positive probability.
#[test]
fn no_count_has_probability_0() {
    let mut words = (0..1000).map(|i| 4_294_967 * i).collect::<Vec<_>>();
    words.extend([1, 2, u32::MAX - 1, u32::MAX]);
    for word in words {
        for p in [1.0, 0.9, 1e-4, 5.4e-9] {
            let sampler = Geometric::new(p).unwrap();
            assert!(sampler.pmf(sampler.count(word)) > 0.0);
        }
        for mean in [1e-45, 1e-9, 3.0, 80.0] {
            let sampler = Poisson::new(mean).unwrap();
            assert!(sampler.pmf(sampler.count(word)) > 0.0);
        }
    }
}

#[test]
fn parameters_out_of_range_are_refused() {
    for (p, error) in [
        (f32::NAN, Error::NotFinite(0)),
        (f32::INFINITY, Error::NotFinite(0)),
        (0.0, Error::NotPositive(0)),
        (-0.5, Error::NotPositive(0)),
        (1.000_000_1, Error::OutOfRange(0)),
        (5.3e-9, Error::TooLarge(0)),
        (1e-45, Error::TooLarge(0)),
    ] {
        assert_eq!(Geometric::new(p), Err(error), "{p}");
    }
    for (mean, error) in [
        (f32::NAN, Error::NotFinite(0)),
        (f32::NEG_INFINITY, Error::NotFinite(0)),
        (0.0, Error::NotPositive(0)),
        (-1.0, Error::NotPositive(0)),
        (80.000_01, Error::TooLarge(0)),
        (f32::MAX, Error::TooLarge(0)),
    ] {
        assert_eq!(Poisson::new(mean), Err(error), "{mean}");
    }
    for (n, d, place) in [(0, 1, 0), (1, 0, 1), (0, 0, 0)] {
        assert_eq!(Geometric::from_ratio(n, d), Err(Error::NotPositive(place)));
        assert_eq!(Poisson::from_ratio(n, d), Err(Error::NotPositive(place)));
    }
    assert_eq!(Geometric::from_ratio(4, 3), Err(Error::OutOfRange(1)));
    assert_eq!(
        Geometric::from_ratio(1, 200_000_000),
        Err(Error::TooLarge(1))
    );
    assert_eq!(Poisson::from_ratio(81, 1), Err(Error::TooLarge(1)));
    // Parameters are kept.
    for p in [1.0, 0.3, 5.4e-9] {
        assert_eq!(Geometric::new(p).unwrap().success(), p);
    }
    for mean in [1e-45, 0.1, 80.0] {
        assert_eq!(Poisson::new(mean).unwrap().mean(), mean);
    }
    assert_eq!(Geometric::from_ratio(3, 8), Geometric::new(0.375));
    assert_eq!(Poisson::from_ratio(15, 4), Poisson::new(3.75));
}

#[test]
fn a_draw_takes_one_word_and_passes_a_failure_on() {
    let (geometric, poisson) = (Geometric::new(0.1).unwrap(), Poisson::new(20.0).unwrap());
    takes_one(|rng| geometric.try_draw(rng), |word| geometric.count(word));
    takes_one(|rng| poisson.try_draw(rng), |word| poisson.count(word));
    // Any f32 has the count of its first bits.
    for (u, word) in [
        (f32::NAN, 0),
        (-1.0, 0),
        (0.25, 1 << 30),
        (7.0, 0xffff_ff00),
        (1e-9, 4),
    ] {
        assert_eq!(geometric.sample(u), geometric.count(word));
        assert_eq!(poisson.sample(u), poisson.count(word));
    }
}

/// ⌊L/λ⌋ in `f32` fails where all counts are looked at.
#[test]
fn counts_by_logarithms_are_noticed() {
    let count = |word: u32| {
        let tail = (0x1_0000_0000_u64 - u64::from(word)) as f32 / 4_294_967_296.0;
        (tail.ln() / (-1e-3_f32).ln_1p()) as u32
    };
    let reaching = |least: u32| first_without(0..1 << 32, |word| count(word as u32) < least);
    let words_of = |k| {
        let (start, end) = (reaching(k), reaching(k + 1));
        (start < end).then(|| start as u32..=(end - 1) as u32)
    };
    let [n, d] = ratio(1e-3);
    let law = || of_failure(failure(n, d));
    assert!(noticed(&|| ends(&count, &words_of, law())));
}

#[test]
fn a_mean_off_by_a_millionth_is_noticed() {
    let sampler = Poisson::new(12.5).unwrap();
    let of = |part| noticed(&|| found_poisson(&sampler, &poisson([part, 1_000_000])));
    assert!(of(12_500_012) && !of(12_500_000));
}
