//! What is wrong with a density, a bound or a proposal is reported, and any magnitude is decided right.

use host::words::first_without;
use microwarp::rejection::{Bounded, Failure, Rejection, SLACK};
use microwarp::uniform::LARGEST;
use microwarp::{
    Error, Warp,
    warp::{Interval, Inversion},
};
use rand_pcg::Pcg32;

/// The smallest positive `f32`.
const TINY: f32 = f32::from_bits(1);

/// A proposal of one point, 0.5, with any density one likes.
fn anywhere(pdf: f32) -> impl Warp<Uniforms = f32, Point = f32, Density = f32> {
    Inversion::new(|_| 0.5, move |_| pdf, |_| 0.5)
}

fn attempt(f: f32, p: f32, c: f32, word: u32) -> Result<Option<f32>, Failure> {
    let bounded = Bounded::new(anywhere(p), |_| f, c)
        .unwrap()
        .with_budget(1)
        .unwrap();
    bounded.attempt(0.0, word)
}

/// How many of the 2³² words accept.
fn words_that_accept(f: f32, p: f32, c: f32) -> u64 {
    let accepts = |word: u64| attempt(f, p, c, word as u32).unwrap().is_some();
    first_without(0..1 << 32, accepts)
}

#[test]
fn an_impossible_bound_is_refused() {
    let line = Interval::new(0.0, 1.0).unwrap();
    let new = |c| {
        Bounded::new(line, |_| 1.0, c)
            .and_then(|sampler| sampler.with_budget(1))
            .err()
    };
    for c in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
        assert_eq!(new(c), Some(Error::NotFinite(2)), "{c}");
    }
    for c in [0.0, -0.0, -TINY, -1.0, f32::MIN] {
        assert_eq!(new(c), Some(Error::NotPositive(2)), "{c}");
    }
    for c in [TINY, f32::MIN_POSITIVE, 1.0, f32::MAX] {
        assert_eq!(new(c), None, "{c}");
    }
}

#[test]
fn an_impossible_density_is_reported() {
    for word in [0, 1, u32::MAX] {
        for f in [f32::NAN, -f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
            assert_eq!(attempt(f, 1.0, 1.0, word), Err(Failure::NotFinite), "{f}");
        }
        for f in [-1.0, -TINY, f32::MIN] {
            assert_eq!(attempt(f, 1.0, 1.0, word), Err(Failure::Negative), "{f}");
        }
        for p in [0.0, -0.0, -1.0, f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
            // Even where f is 0: a proposal like that is wrong anywhere.
            for f in [0.0, 1.0] {
                assert_eq!(
                    attempt(f, p, 1.0, word),
                    Err(Failure::ProposalDensity),
                    "{p}"
                );
            }
        }
    }
    // Through a generator too, and at once.
    let line = Interval::new(0.0, 1.0).unwrap();
    let later = |x: f32| if x > 0.9 { f32::NAN } else { 0.0 };
    let bounded = Bounded::new(line, later, 1.0).unwrap();
    assert_eq!(bounded.draw(&mut Pcg32::new(1, 1)), Err(Failure::NotFinite));
}

#[test]
fn a_density_above_its_bound_is_reported_with_the_ratio() {
    let ratio = |f, p, c| match attempt(f, p, c, 0) {
        Err(Failure::BoundExceeded { ratio }) => ratio,
        other => panic!("{f} over {c} · {p}: {other:?}"),
    };
    assert_eq!(ratio(2.0, 1.0, 1.0), 2.0);
    assert_eq!(ratio(3.0, 0.5, 4.0), 1.5);
    assert_eq!(ratio(1.0 + 4.0 * SLACK, 1.0, 1.0), 1.0 + 4.0 * SLACK);
    // What f/p or c p alone would overflow; and what f32 does not hold.
    assert_eq!(ratio(f32::MAX, 0.125, f32::MAX), 8.0);
    assert_eq!(ratio(3.0 * TINY, 1.0, TINY), 3.0);
    assert_eq!(ratio(f32::MAX, TINY, TINY), f32::INFINITY);
    // Whatever the word, and through a generator: it is seen as soon as such a point is proposed.
    assert!(attempt(2.0, 1.0, 1.0, u32::MAX).is_err());
    let line = Interval::new(0.0, 1.0).unwrap();
    let rare = Bounded::new(line, |x: f32| if x > 0.99 { 1.5 } else { 0.0 }, 1.0)
        .unwrap()
        .with_budget(5000)
        .unwrap();
    let failure = rare.draw(&mut Pcg32::new(1, 1)).unwrap_err();
    assert_eq!(failure, Failure::BoundExceeded { ratio: 1.5 });
    assert_eq!(failure.to_string(), "the density is 1.5 times its bound");
}

/// Rounding may lift f/(c p) above 1; that much is granted, and no more.
#[test]
fn rounding_does_not_exceed_a_bound() {
    assert_eq!(SLACK, 2.0_f32.powi(-20));
    assert_eq!(attempt(1.0 + SLACK, 1.0, 1.0, u32::MAX), Ok(Some(0.5)));
    let beyond = 1.0 + SLACK + f32::EPSILON;
    assert_eq!(
        attempt(beyond, 1.0, 1.0, 0),
        Err(Failure::BoundExceeded { ratio: beyond })
    );
    // f = c p in truth, at many roundings of each.
    let mut rng = Pcg32::new(2, 2);
    let line = Interval::new(0.1, 3.0).unwrap();
    for _ in 0..100_000 {
        let (p, c) = (line.draw(&mut rng), line.draw(&mut rng));
        assert_eq!(attempt(p * c, p, c, 0), Ok(Some(0.5)), "{p} {c}");
    }
}

#[test]
fn the_number_of_accepting_words_is_the_ratio() {
    let whole = 2f64.powi(32);
    let (mut p, mut c) = (1.0, 1.0);
    let mut rng = Pcg32::new(3, 3);
    let unit = Interval::new(0.5, 2.0).unwrap();
    for k in 0..2000 {
        // Every magnitude, then roundings of p and c as well.
        let f = unit.draw(&mut rng) * 0.5 * 2.0_f32.powi(-(k % 36));
        if k > 500 {
            (p, c) = (unit.draw(&mut rng), unit.draw(&mut rng));
        }
        let f = f * (p * c);
        let exact = f64::from(f) / (f64::from(p) * f64::from(c));
        let slack = 0.5
            + 1e-6
            + if k > 500 {
                exact * whole * 2f64.powi(-23)
            } else {
                0.0
            };
        let words = words_that_accept(f, p, c) as f64;
        let off = (words - exact * whole).abs();
        assert!(off <= slack, "{f} over {p} · {c}: {words} words");
    }
    assert_eq!(words_that_accept(1.0, 1.0, 1.0), 1 << 32);
    assert_eq!(words_that_accept(LARGEST, 1.0, 1.0), (1 << 32) - 256);
    assert_eq!(words_that_accept(0.0, 1.0, 1.0), 0);
    for (power, words) in [(-31, 2), (-32, 1), (-33, 1), (-34, 0), (-149, 0)] {
        assert_eq!(
            words_that_accept(2.0_f32.powi(power), 1.0, 1.0),
            words,
            "2^{power}"
        );
    }
    // Integers of words whose half would round: 2²³ + 1 and the like.
    for words in [
        (1 << 22) + 1,
        (1 << 23) - 1,
        (1 << 23) + 1,
        (1 << 24) - 1,
        (1 << 24) + 2,
    ] {
        let f = words as f32 * 2.0_f32.powi(-32);
        assert_eq!(words_that_accept(f, 1.0, 1.0), words);
    }
}

/// Only the quotient counts, not the magnitudes it is made of.
#[test]
fn magnitudes_cancel() {
    let half = 1 << 31;
    for (f, p, c) in [
        (TINY, 1.0, 2.0 * TINY),
        (3.0 * TINY, 6.0 * TINY, 1.0),
        (2.0_f32.powi(127), 2.0_f32.powi(64), 2.0_f32.powi(64)),
        (2.0_f32.powi(-149), 2.0_f32.powi(-21), 2.0_f32.powi(-127)),
    ] {
        assert_eq!(words_that_accept(f, p, c), half, "{f} {p} {c}");
    }
    // The largest bound: accepted by no word, and by half of them where f is as large.
    assert_eq!(words_that_accept(1.0, 1.0, f32::MAX), 0);
    assert_eq!(words_that_accept(0.5 * f32::MAX, 1.0, f32::MAX), half);
    assert_eq!(words_that_accept(f32::MAX, 2.0, f32::MAX), half);
    // The smallest: a density of 0 is still rejected, and TINY is the bound itself.
    assert_eq!(words_that_accept(TINY, 1.0, TINY), 1 << 32);
    assert_eq!(words_that_accept(0.0, 1.0, TINY), 0);
    assert_eq!(words_that_accept(-0.0, TINY, TINY), 0);
}

/// Over all pairs of extreme magnitudes: accepted, rejected or reported, as exact arithmetic has it.
#[test]
fn any_magnitudes_are_decided_right() {
    let powers = [
        -149, -140, -127, -126, -125, -64, -24, -1, 0, 1, 24, 64, 126, 127,
    ];
    let values: Vec<f32> = powers
        .iter()
        .flat_map(|&k| [1.0, 1.5, 1.999_999_9].map(|m| (m * 2f64.powi(k)) as f32))
        .chain([f32::MAX])
        .collect();
    for &f in &values {
        for &p in &values {
            for &c in &values {
                let exact = f64::from(f) / f64::from(p) / f64::from(c);
                match attempt(f, p, c, 0x7fff_ffff) {
                    Ok(Some(_)) => assert!((0.499_999..=1.000_001).contains(&exact), "{exact}"),
                    Ok(None) => assert!(exact < 0.500_001, "{exact}"),
                    Err(Failure::BoundExceeded { ratio }) => {
                        assert!(exact > 1.000_000_9, "{exact}");
                        let ratio = f64::from(ratio) / exact;
                        let overflown = exact > 3.4e38 && ratio == f64::INFINITY;
                        assert!(
                            (ratio - 1.0).abs() < 2.5e-7 || overflown,
                            "{exact}: {ratio}"
                        );
                    }
                    Err(other) => panic!("{f} {p} {c}: {other}"),
                }
            }
        }
    }
}
