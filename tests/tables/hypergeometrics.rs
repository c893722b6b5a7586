//! `Hypergeometric`: the words of every count against binomial coefficients and against sums of 512 bits; its pmf, its ends and
//! its refusals, and what a draw takes.

use crate::ends::{Ends, Exact, ends, excess, noticed, off_in_floats, takes_one};
use host::errors::or_infinite;
use host::speed;
use microwarp::discrete::{Binomial, Hypergeometric};
use microwarp::{Error, constant};
use num_bigint::BigUint;
use rand_pcg::Pcg32;
use rand_pcg::rand_core::Rng;

type Urn = [u32; 3];

fn range([population, marked, drawn]: Urn) -> [u32; 2] {
    let least = (u64::from(marked) + u64::from(drawn)).saturating_sub(population.into());
    [least as u32, marked.min(drawn)]
}

/// What multiplies and what divides the probability from k − 1 to k.
fn ratio([population, marked, drawn]: Urn) -> impl Fn(u32) -> [u128; 2] {
    let [population, marked, drawn] = [population, marked, drawn].map(i128::from);
    move |k| {
        let k = i128::from(k);
        let more = (marked - k + 1) * (drawn - k + 1);
        let less = k * (population - marked - drawn + k);
        [more, less].map(|x| u128::try_from(x).unwrap())
    }
}

fn chosen(all: u32, some: u32) -> BigUint {
    let some = some.min(all - some);
    (0..some).fold(BigUint::from(1_u32), |product, i| {
        product * (all - i) / (i + 1)
    })
}

/// By binomial coefficients, which are integers, so that every quotient is one.
fn by_coefficients(urn @ [population, marked, drawn]: Urn) -> Exact {
    let [least, most] = range(urn);
    let first = chosen(marked, least) * chosen(population - marked, drawn - least);
    let law = Exact::around(least, first, [least, most], &BigUint::ZERO, ratio(urn));
    assert_eq!(law.whole, chosen(population, drawn));
    law
}

/// By neighbours from the mode, normalised.
fn from_the_mode(urn @ [population, marked, drawn]: Urn) -> Exact {
    let [least, most] = range(urn);
    let [all, marked, drawn] = [population, marked, drawn].map(u128::from);
    let mode = ((marked + 1) * (drawn + 1) / (all + 2)) as u32;
    let (one, end) = (
        BigUint::from(1_u32) << 512_u32,
        BigUint::from(1_u32) << 300_u32,
    );
    Exact::around(
        mode.clamp(least, most),
        one,
        [least, most],
        &end,
        ratio(urn),
    )
}

fn made([population, marked, drawn]: Urn) -> Hypergeometric {
    Hypergeometric::new(population, marked, drawn).unwrap()
}

fn found(sampler: &Hypergeometric, exact: &Exact) -> Ends {
    ends(&|word| sampler.count(word), &|k| sampler.words_of(k), |k| {
        exact.words(k)
    })
}

/// A population of any size; a sample of a variance up to 100, of few items or of nearly all.
fn any(rng: &mut Pcg32) -> Urn {
    let mut part = || (f64::from(rng.next_u32()) + 0.5) / 2_f64.powi(32);
    let all = 2_f64.powf(32.0 * part()).floor();
    let share = match (3.0 * part()) as u32 {
        0 => part(),
        1 => all.powf(-part()),
        _ => 1.0 - all.powf(-part()),
    };
    let marked = (all * share).round();
    let variance = 99.999 * if part() < 0.5 { 1.0 } else { part() };
    let limit = variance * (all - 1.0).max(1.0) / (marked * (1.0 - marked / all)).max(1e-9);
    let few = (0.5 - (0.25 - (limit / all).min(0.25)).sqrt()) * all;
    let drawn = if part() < 0.5 {
        few.floor()
    } else {
        all - few.floor()
    };
    [all, marked, drawn].map(|x| x as u32)
}

#[test]
fn all_small_urns_have_the_words_of_binomial_coefficients() {
    let most = speed::of("largest population of which all samples are tried", 14, 45);
    let (mut laws, mut counts, mut doubt) = (0, 0, 0.0_f64);
    for population in 0..=most {
        for marked in 0..=population {
            for drawn in 0..=population {
                let urn = [population, marked, drawn];
                let found = found(&made(urn), &by_coefficients(urn));
                assert!(found.doubt < 2_f64.powi(-20), "{urn:?}: {found:?}");
                (laws, counts) = (laws + 1, counts + found.counts);
                doubt = doubt.max(found.doubt);
            }
        }
    }
    println!("{counts} counts of {laws} laws, in doubt by {doubt:e}");
}

#[test]
fn hypergeometric_counts_have_their_words() {
    let number = speed::of("hypergeometric laws with all their words", 150, 20_000);
    let mut rng = Pcg32::new(33, 8);
    let special = [
        [1598, 799, 799],
        [u32::MAX, 1 << 31, 400],
        [u32::MAX, 655_360, 655_360],
        [u32::MAX, u32::MAX - 655_360, 655_360],
        [u32::MAX, u32::MAX - 655_360, u32::MAX - 655_360],
        [u32::MAX, u32::MAX, u32::MAX],
        [u32::MAX, 1, 1],
        [100_000, 400, 50_000],
        [3000, 200, 2800],
        [52, 4, 13],
    ];
    let (mut counts, mut moved, mut widest) = (0, 0, 0);
    for urn in special
        .into_iter()
        .chain((0..number).map(|_| any(&mut rng)))
    {
        let sampler = made(urn);
        let law = if urn[0] < 2000 {
            by_coefficients(urn)
        } else {
            from_the_mode(urn)
        };
        let found = found(&sampler, &law);
        assert!(found.doubt < 2_f64.powi(-20), "{urn:?}: {found:?}");
        (counts, moved) = (counts + found.counts, moved + found.moved);
        widest = widest.max(sampler.count(u32::MAX) - sampler.count(0) + 1);
    }
    println!("{counts} counts, {moved} ends in doubt; at most {widest} counts of a law");
    assert!(widest <= 128);
}

#[test]
fn the_pmf_of_a_hypergeometric_is_that_of_the_formula() {
    let (mut worst, mut rng) = (0.0_f64, Pcg32::new(33, 9));
    for _ in 0..speed::of("hypergeometric laws with their pmf", 60, 2000) {
        let urn = any(&mut rng);
        let (sampler, law) = (made(urn), from_the_mode(urn));
        for k in law.from..law.from + law.each.len() as u32 {
            let error = excess(sampler.pmf(k), law.pmf(k));
            worst = worst.max(or_infinite(error));
        }
        let [least, most] = range(urn);
        for beyond in [least.checked_sub(1), most.checked_add(1)]
            .into_iter()
            .flatten()
        {
            assert_eq!(sampler.pmf(beyond), 0.0);
        }
        assert!(sampler.pmf(sampler.count(rng.next_u32())) > 0.0);
    }
    println!("{worst:.3} of the bound");
    assert!(worst <= 1.0);
}

/// What can have one count alone has it; marked and drawn change places; those that are not marked are the mirror image.
#[test]
fn ends_of_urns_are_exact() {
    let large = u32::MAX;
    for (urn, count) in [
        ([0, 0, 0], 0),
        ([1, 1, 1], 1),
        ([9, 0, 4], 0),
        ([9, 9, 4], 4),
        ([9, 4, 9], 4),
        ([9, 4, 0], 0),
        ([large, large, large], large),
        ([large, large, 1 << 31], 1 << 31),
    ] {
        let sampler = made(urn);
        assert_eq!((sampler.count(0), sampler.count(u32::MAX)), (count, count));
        assert_eq!(sampler.words_of(count), Some(0..=u32::MAX));
        assert_eq!(sampler.pmf(count), 1.0);
        assert_eq!(sampler.pmf(count.wrapping_add(1)), 0.0);
        assert_eq!(
            [sampler.population(), sampler.marked(), sampler.drawn()],
            urn
        );
    }
    for [all, marked, drawn] in [[52, 4, 13], [1000, 300, 70], [80_000, 50_000, 200]] {
        let sampler = made([all, marked, drawn]);
        let (swapped, other) = (made([all, drawn, marked]), made([all, all - marked, drawn]));
        for i in 0..4096_u32 {
            let word = i.wrapping_mul(0x9e37_79b9);
            assert_eq!(sampler.count(word), swapped.count(word));
            assert_eq!(sampler.count(word), drawn - other.count(!word));
        }
    }
}

#[test]
fn urns_out_of_range_are_refused() {
    for (urn, error) in [
        ([0, 1, 0], Error::OutOfRange(1)),
        ([9, 10, 3], Error::OutOfRange(1)),
        ([9, 3, 10], Error::OutOfRange(2)),
        ([1600, 800, 800], Error::TooLarge(Error::NO_PLACE)),
        ([u32::MAX, 1 << 31, 401], Error::TooLarge(Error::NO_PLACE)),
        (
            [u32::MAX, 1 << 31, 1 << 31],
            Error::TooLarge(Error::NO_PLACE),
        ),
        (
            [u32::MAX, u32::MAX - 656_000, 656_000],
            Error::TooLarge(Error::NO_PLACE),
        ),
    ] {
        let [population, marked, drawn] = urn;
        assert_eq!(
            Hypergeometric::new(population, marked, drawn),
            Err(error),
            "{urn:?}"
        );
    }
}

#[test]
fn a_hypergeometric_draw_takes_one_word() {
    const FAULTY: Hypergeometric = constant!(Hypergeometric::new(10_000, 300, 500));
    assert_eq!(size_of::<Hypergeometric>(), 552);
    takes_one(|rng| FAULTY.try_draw(rng), |word| FAULTY.count(word));
    for (u, word) in [(f32::NAN, 0), (0.25, 1 << 30), (7.0, 0xffff_ff00)] {
        assert_eq!(FAULTY.sample(u), FAULTY.count(word));
    }
}

/// Other numbers, drawing with replacement, and sums in `f32`.
#[test]
fn wrong_hypergeometric_laws_are_noticed() {
    let (urn, sampler) = ([1000, 300, 100], made([1000, 300, 100]));
    let law = by_coefficients(urn);
    let of = |urn| noticed(&|| found(&sampler, &by_coefficients(urn)));
    assert!(!of(urn));
    assert!(of([1001, 300, 100]) && of([1000, 301, 100]) && of([1000, 300, 99]));
    let again = Binomial::from_ratio(100, 3, 10).unwrap();
    assert!(noticed(&|| {
        ends(&|word| again.count(word), &|k| again.words_of(k), |k| {
            law.words(k)
        })
    }));
    assert!(off_in_floats(|k| sampler.pmf(k), &law) > 10);
}
