//! `DiscreteGaussian` and `DiscreteLaplace`: the words of every integer against exponentials of 512 bits, which leaves no word out;
//! their pmf, their ends and their refusals, and what a draw takes.

use crate::ends::{Ends, Exact, ends, excess, noticed, takes_one};
use host::errors::or_infinite;
use host::speed;
use microwarp::discrete::{DiscreteGaussian, DiscreteLaplace};
use microwarp::{Error, constant};
use num_bigint::{BigInt, BigUint};
use rand_pcg::Pcg32;
use rand_pcg::rand_core::Rng;

const BITS: u32 = 512;

/// e⁻ˣ of a ratio in units of 2⁻⁵¹²: the series of x over a power of 2, and squares of it.
fn exp_neg(part: &BigUint, whole: &BigUint) -> BigUint {
    let one = BigUint::from(1_u32) << BITS;
    let halvings = (part / whole).bits() as u32 + 1;
    if halvings > 12 {
        return BigUint::ZERO;
    }
    let x = BigInt::from((part << (BITS - halvings)) / whole);
    let (mut sum, mut term) = (BigInt::from(one.clone()), BigInt::from(one));
    for n in 1..110 {
        term = -((term * &x) >> BITS) / n;
        sum += &term;
    }
    let mut power = sum.to_biguint().unwrap();
    for _ in 0..halvings {
        power = (&power * &power) >> BITS;
    }
    power
}

/// An `f32` in units of 2⁻¹⁴⁹.
fn units(x: f32) -> BigInt {
    let bits = x.abs().to_bits();
    let (exponent, fraction) = (bits >> 23, bits & 0x007f_ffff);
    let size = match exponent {
        0 => BigInt::from(fraction),
        _ => BigInt::from(fraction | 0x0080_0000) << (exponent - 1),
    };
    if x < 0.0 { -size } else { size }
}

/// Integers as counts from the smallest one.
fn count_of(integer: i32) -> u32 {
    integer as u32 ^ 1 << 31
}

fn integer_of(count: u32) -> i32 {
    (count ^ 1 << 31) as i32
}

/// The Gaussian about a centre, as far as its tails are above 2⁻²⁰⁰ of it.
fn gaussian(centre: f32, scale: f32) -> Exact {
    let (c, s) = (units(centre), units(scale));
    let reach = (17.0 * scale) as i32 + 2;
    let first = (f64::from(centre).floor() as i32).saturating_sub(reach);
    let whole = s.pow(2).to_biguint().unwrap() << 1_u32;
    // From the nearest integer's own, which may be far below 1.
    let square = |k: i32| {
        let away: BigInt = (BigInt::from(k) << 149_u32) - &c;
        away.pow(2).to_biguint().unwrap()
    };
    let range = first..=first + 2 * reach + 1;
    let least = range.clone().map(square).min().unwrap();
    let each = range.map(|k| exp_neg(&(square(k) - &least), &whole));
    Exact::of(count_of(first), each.collect())
}

fn found(sampler: &DiscreteGaussian, exact: &Exact) -> Ends {
    ends(
        &|word| count_of(sampler.integer(word)),
        &|count| sampler.words_of(integer_of(count)),
        |count| exact.words(count),
    )
}

/// A centre and a scale of any size.
fn any(rng: &mut Pcg32) -> (f32, f32) {
    let mut part = || (f64::from(rng.next_u32()) + 0.5) / 2_f64.powi(32);
    let scale = match (3.0 * part()) as u32 {
        0 => 20.0 * part(),
        _ => 20.0 * 1e-3_f64.powf(part()),
    };
    let centre = match (4.0 * part()) as u32 {
        0 => (8.0 * part()).floor() / 2.0 - 2.0,
        1 => part() - 0.5,
        2 => 2e9 * (part() - 0.5),
        _ => 1e-9_f64.powf(part()),
    };
    (centre as f32, scale as f32)
}

#[test]
fn integers_of_a_gaussian_have_their_words() {
    let number = speed::of("discrete Gaussians with all their words", 60, 1500);
    let mut rng = Pcg32::new(35, 1);
    let special = [
        (0.0, 20.0),
        (0.5, 20.0),
        (-2.5, 1.0),
        (0.5, 1e-45),
        (-0.5, 1e-6),
        (0.499_999_97, 1e-3),
        (0.499_999_97, 1e-4),
        (8_388_607.5, 0.3),
        (-1_073_741_824.0, 20.0),
        (1_073_741_824.0, 20.0),
        (1e-45, 0.2),
        (3.0, 1e-20),
    ];
    let (mut counts, mut moved) = (0, 0);
    let drawn = (0..number).map(|_| any(&mut rng));
    for (centre, scale) in special.into_iter().chain(drawn) {
        let sampler = DiscreteGaussian::new(centre, scale).unwrap();
        assert_eq!((sampler.centre(), sampler.scale()), (centre, scale));
        let found = found(&sampler, &gaussian(centre, scale));
        assert!(
            found.doubt < 2_f64.powi(-16),
            "{centre:e}, {scale:e}: {found:?}"
        );
        (counts, moved) = (counts + found.counts, moved + found.moved);
    }
    println!("{counts} integers, {moved} ends in doubt");
}

/// The two-sided geometric from its least to its largest size.
fn laplace([part, whole]: &[BigUint; 2], most: u32) -> Exact {
    let ratio = exp_neg(whole, part);
    let mut side = vec![BigUint::from(1_u32) << BITS];
    for _ in 0..most {
        let next = (side.last().unwrap() * &ratio) >> BITS;
        side.push(next);
    }
    let below = side.iter().skip(1).rev();
    let each = below.chain(&side).cloned().collect();
    Exact::of(count_of(-(most as i32)), each)
}

fn found_laplace(sampler: &DiscreteLaplace, scale: &[BigUint; 2]) -> Ends {
    let most = sampler.integer(u32::MAX);
    let exact = laplace(scale, most as u32 + 100 + 30 * most as u32 / 23);
    ends(
        &|word| count_of(sampler.integer(word)),
        &|count| sampler.words_of(integer_of(count)),
        |count| exact.words(count),
    )
}

fn ratio(scale: f32) -> [BigUint; 2] {
    [
        units(scale).to_biguint().unwrap(),
        BigUint::from(1_u32) << 149_u32,
    ]
}

#[test]
fn integers_of_a_laplace_law_have_their_words() {
    let number = speed::of("discrete Laplace laws with all their words", 40, 500);
    let most = speed::of("the largest scale of them", 30.0, 300.0);
    let mut rng = Pcg32::new(35, 2);
    let (mut counts, mut moved) = (0, 0);
    let drawn = (0..number).map(|_| {
        let part = (f64::from(rng.next_u32()) + 0.5) / 2_f64.powi(32);
        (0.04 * (most / 0.04_f64).powf(part)) as f32
    });
    let special = [
        1e-45,
        1e-30,
        0.02,
        0.5,
        1.0,
        2.0,
        1.999_999_9,
        2.000_000_2,
        16.0,
    ];
    for scale in special.into_iter().chain(drawn) {
        let sampler = DiscreteLaplace::new(scale).unwrap();
        let found = found_laplace(&sampler, &ratio(scale));
        assert!(found.doubt < 2_f64.powi(-16), "{scale:e}: {found:?}");
        (counts, moved) = (counts + found.counts, moved + found.moved);
        assert!((sampler.scale() / scale - 1.0).abs() < 1.2e-7 || scale < 1e-38);
    }
    for [part, whole] in [[5_u32, 2], [1, 1], [7, 3], [1, u32::MAX]] {
        let sampler = DiscreteLaplace::from_ratio(part, whole).unwrap();
        let found = found_laplace(&sampler, &[part, whole].map(BigUint::from));
        assert!(found.doubt < 2_f64.powi(-16), "{part}/{whole}: {found:?}");
    }
    println!("{counts} integers, {moved} ends in doubt");
}

/// Of the largest scales some integers stand for all.
#[test]
fn integers_of_a_wide_laplace_law_have_their_words() {
    for scale in [1e4, 1e6, 6e6, 9e7_f32] {
        let sampler = DiscreteLaplace::new(scale).unwrap();
        let [part, whole] = ratio(scale);
        let one = BigUint::from(1_u32) << BITS;
        let both = &one + exp_neg(&whole, &part);
        let most = sampler.integer(u32::MAX);
        assert!(f64::from(most) < 22.9 * f64::from(scale));
        let mut tried = 0;
        for i in 0..400 {
            let size = (f64::from(most).powf(f64::from(i) / 399.0)) as i32;
            let Some(words) = sampler.words_of(-size) else {
                continue;
            };
            tried += 1;
            // All words of this size or more on the lower side, in units of 2⁻³².
            let power = exp_neg(&(&whole * size as u32), &part);
            let exact = u128::try_from(((power << 64_u32) << 32_u32) / &both).unwrap();
            let found = u64::from(*words.end()) + 1;
            let off = (found as f64 - exact as f64 * 2_f64.powi(-64)).abs();
            assert!(off < 0.5 + 2_f64.powi(-16), "{scale}, {size}: {off}");
            assert_eq!(sampler.integer(*words.end()), -size);
            assert_eq!(sampler.integer(!*words.end()), size);
            // The next word is of the next integer that has words.
            assert!(sampler.integer(*words.end() + 1) > -size);
            assert_eq!(sampler.integer(*words.start()), -size);
        }
        assert!(tried > 200, "{scale}: {tried}");
        // Between the ends of integers nothing steps back.
        let mut rng = Pcg32::new(35, 4);
        for _ in 0..speed::of("words of wide Laplace laws", 2_000, 100_000) {
            let word = rng.next_u32() >> (rng.next_u32() & 31);
            let integer = sampler.integer(word);
            assert!(sampler.words_of(integer).unwrap().contains(&word), "{word}");
        }
    }
}

#[test]
fn the_pmf_of_integers_is_that_of_the_formulas() {
    let mut worst = [0.0_f64; 2];
    let mut rng = Pcg32::new(35, 3);
    for _ in 0..speed::of("discrete laws with their pmf", 30, 600) {
        let (centre, scale) = any(&mut rng);
        let sampler = DiscreteGaussian::new(centre, scale).unwrap();
        let exact = gaussian(centre, scale);
        for count in (exact.from..).take(exact.each.len()) {
            let error = excess(sampler.pmf(integer_of(count)), exact.pmf(count));
            worst[0] = worst[0].max(or_infinite(error));
        }
        let sampler = DiscreteLaplace::new(scale).unwrap();
        let exact = laplace(&ratio(scale), (130.0 * scale) as u32 + 1);
        for count in (exact.from..).take(exact.each.len()) {
            let error = excess(sampler.pmf(integer_of(count)), exact.pmf(count));
            worst[1] = worst[1].max(or_infinite(error));
        }
        for far in [i32::MIN, i32::MAX] {
            assert_eq!(sampler.pmf(far), 0.0);
        }
    }
    println!("{worst:.3?} of the bound");
    assert!(worst.iter().all(|w| *w <= 1.0), "{worst:?}");
}

#[test]
fn integer_laws_out_of_range_are_refused() {
    for (centre, scale, error) in [
        (f32::NAN, 1.0, Error::NotFinite(0)),
        (f32::INFINITY, 1.0, Error::NotFinite(0)),
        (0.0, f32::NAN, Error::NotFinite(1)),
        (0.0, f32::INFINITY, Error::NotFinite(1)),
        (0.0, 0.0, Error::NotPositive(1)),
        (0.0, -1.0, Error::NotPositive(1)),
        (0.0, 20.000_002, Error::TooLarge(1)),
        (1_073_741_952.0, 1.0, Error::OutOfRange(0)),
        (-3e38, 1.0, Error::OutOfRange(0)),
    ] {
        assert_eq!(DiscreteGaussian::new(centre, scale), Err(error));
    }
    for (scale, error) in [
        (f32::NAN, Error::NotFinite(0)),
        (f32::INFINITY, Error::NotFinite(0)),
        (0.0, Error::NotPositive(0)),
        (-1.0, Error::NotPositive(0)),
        (9.000_001e7, Error::TooLarge(0)),
    ] {
        assert_eq!(DiscreteLaplace::new(scale), Err(error));
    }
    for ([part, whole], place) in [([0, 1], 0), ([1, 0], 1), ([0, 0], 0)] {
        let refused = DiscreteLaplace::from_ratio(part, whole);
        assert_eq!(refused, Err(Error::NotPositive(place)));
    }
    let wide = DiscreteLaplace::from_ratio(90_000_001, 1);
    assert_eq!(wide, Err(Error::TooLarge(1)));
}

#[test]
fn a_draw_of_an_integer_takes_one_word() {
    const GAUSSIAN: DiscreteGaussian = constant!(DiscreteGaussian::new(0.25, 20.0));
    const LAPLACE: DiscreteLaplace = constant!(DiscreteLaplace::from_ratio(100, 3));
    assert_eq!(size_of::<DiscreteGaussian>(), 1080);
    assert_eq!(size_of::<DiscreteLaplace>(), 352);
    takes_one(|rng| GAUSSIAN.try_draw(rng), |word| GAUSSIAN.integer(word));
    takes_one(|rng| LAPLACE.try_draw(rng), |word| LAPLACE.integer(word));
    for (u, word) in [
        (f32::NAN, 0),
        (-1.0, 0),
        (0.25, 1 << 30),
        (7.0, 0xffff_ff00),
    ] {
        assert_eq!(GAUSSIAN.sample(u), GAUSSIAN.integer(word));
        assert_eq!(LAPLACE.sample(u), LAPLACE.integer(word));
    }
    for i in 0..4096_u32 {
        let word = i.wrapping_mul(0x9e37_79b9);
        assert_eq!(LAPLACE.integer(word), -LAPLACE.integer(!word));
    }
}

/// Another centre, another scale, and a Laplace law of another scale.
#[test]
fn wrong_laws_of_integers_are_noticed() {
    let sampler = DiscreteGaussian::new(0.25, 3.0).unwrap();
    let of = |centre, scale| noticed(&|| found(&sampler, &gaussian(centre, scale)));
    assert!(!of(0.25, 3.0));
    assert!(of(0.250_000_03, 3.0) && of(0.25, 3.000_000_2));
    let side = DiscreteLaplace::from_ratio(5, 2).unwrap();
    let of = |part: u32| noticed(&|| found_laplace(&side, &[part, 200_000_000].map(BigUint::from)));
    assert!(!of(500_000_000) && of(500_000_010));
}
