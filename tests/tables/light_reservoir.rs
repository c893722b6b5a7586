//! `LightReservoir`: its expectation summed over all candidates and all decisions, in fractions; then its words, counts and refusals.
//!
//! Every decision of a sum is made by the reservoir itself, with a uniform on either side of the border that a fraction says. So the
//! sum is that of the code, up to the rounding of a weight.

mod sums;

use host::generators::{Counting, Failing};
use microwarp::Error;
use microwarp::discrete::{LightReservoir, Normaliser};
use rand_pcg::Pcg32;

#[test]
fn refusals_leave_it_as_it_was() {
    let mut rng = Pcg32::new(1, 1);
    let mut held = LightReservoir::default();
    held.offer('x', 2.0, 0.5, &mut rng).unwrap();
    let before = held;
    for wrong in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
        assert_eq!(
            held.offer('y', wrong, 1.0, &mut rng),
            Err(Error::NotFinite(1))
        );
        assert_eq!(
            held.offer('y', 1.0, wrong, &mut rng),
            Err(Error::NotFinite(2))
        );
        assert_eq!(
            held.absorb(before, wrong, &mut rng),
            Err(Error::NotFinite(1))
        );
    }
    assert_eq!(
        held.offer('y', -1e-45, 1.0, &mut rng),
        Err(Error::Negative(1))
    );
    assert_eq!(held.absorb(before, -1.0, &mut rng), Err(Error::Negative(1)));
    for wrong in [0.0, -0.0, -1e-45] {
        let refused = held.offer('y', 1.0, wrong, &mut rng);
        assert_eq!(refused, Err(Error::NotPositive(2)), "{wrong}");
    }
    assert_eq!(held, before);
    assert_eq!((held.count(), held.contribution()), (1, 2.0));
    // Nothing, and what has no target here, is never taken; the candidates count.
    for (other, target) in [(LightReservoir::new(), 1.0), (before, 0.0), (before, -0.0)] {
        let mut held = before;
        assert_eq!(held.absorb(other, target, &mut rng), Ok(false));
        assert_eq!((held.item(), held.count()), (Some(&'x'), 1 + other.count()));
    }
}

#[test]
fn a_decision_takes_two_words_and_passes_a_failure_on() {
    let held = || {
        let mut held = LightReservoir::new();
        held.offer_with(7, 1.0, 1.0, 0).unwrap();
        held
    };
    let rules = [
        Normaliser::Support,
        Normaliser::Balance,
        Normaliser::Pairwise,
    ];
    for left in 0..12 {
        let driver = || Counting::new(Failing { word: 9, left });
        let mut rng = driver();
        for target in [1.0, 0.0, f32::NAN] {
            let (before, words) = (held(), rng.words);
            let mut after = before;
            match after.try_offer(8, target, 1.0, &mut rng) {
                Ok(_) => assert_eq!(rng.words, words + 2),
                Err(_) => assert_eq!(after, before),
            }
            let (before, words) = (after, rng.words);
            match after.try_absorb(held(), target, &mut rng) {
                Ok(_) => assert_eq!(rng.words, words + 2),
                Err(_) => assert_eq!(after, before),
            }
        }
        for rule in rules {
            let mut rng = driver();
            let sources = [held(), LightReservoir::new(), held()];
            let whole = LightReservoir::try_combine(&sources, 0, rule, |_, _| 1.0, &mut rng);
            assert_eq!(whole.is_ok(), left >= 6);
            assert_eq!(rng.words, left.min(6));
        }
    }
}

/// A reservoir of one candidate, offered and capped so that it counts for `count`.
fn of_count(target: f32, count: u32) -> LightReservoir<u32> {
    let mut held = LightReservoir::new();
    held.offer_with(0, target, 0.5, 0).unwrap();
    // Doubled as long as that fits, then filled up.
    while held.count() <= u32::MAX >> 1 {
        held.absorb_with(held, target, u64::MAX).unwrap();
    }
    let mut rest = held;
    rest.cap(u32::MAX - held.count());
    held.absorb_with(rest, target, u64::MAX).unwrap();
    assert_eq!(held.count(), u32::MAX);
    held.cap(count);
    held
}

#[test]
fn counts_that_do_not_fit_are_capped_and_contributions_stay() {
    for count in [1, 3, u32::MAX >> 1, u32::MAX - 1, u32::MAX] {
        let held = of_count(3.0, count);
        assert_eq!((held.count(), held.contribution()), (count, 2.0));
    }
    let mut full = of_count(3.0, u32::MAX);
    full.offer_with(1, 3.0, 0.5, 0).unwrap();
    assert_eq!((full.count(), full.contribution()), (1 << 31, 2.0));
    let mut full = of_count(3.0, u32::MAX);
    full.absorb_with(of_count(1.0, 1 << 31), 1.0, u64::MAX)
        .unwrap();
    assert_eq!(full.count(), u32::MAX - 1);
    // Half of each: the sum of 3·2 and 1·2 over 2·3.
    assert!((full.contribution() - 4.0 / 3.0).abs() < 1e-6);
    let mut rng = Pcg32::new(1, 1);
    let sources = [of_count(3.0, u32::MAX); 5];
    let whole = LightReservoir::combine(&sources, 0, Normaliser::Balance, |_, _| 3.0, &mut rng);
    assert_eq!(whole.count(), 5 * (u32::MAX >> 3));
    assert!((whole.contribution() - 2.0).abs() < 1e-6);
    // Nothing is left of no candidates.
    let mut none = of_count(3.0, 5);
    none.cap(0);
    assert_eq!(none, LightReservoir::new());
    let mut none = of_count(3.0, 5);
    none.normalise(0);
    assert_eq!(
        (none.item(), none.count(), none.contribution()),
        (None, 5, 0.0)
    );
    none.normalise(3);
    assert_eq!((none.item(), none.count()), (None, 5));
}

#[test]
fn any_targets_and_densities_give_finite_contributions() {
    const NUMBERS: [f32; 8] = [
        1e-45,
        1e-40,
        f32::MIN_POSITIVE,
        1e-19,
        1.0,
        3e7,
        1e30,
        f32::MAX,
    ];
    for target in NUMBERS {
        for density in NUMBERS {
            let mut held = LightReservoir::new();
            held.offer_with(0, target, density, 0).unwrap();
            let exact = (1.0 / f64::from(density)).min(f64::from(f32::MAX));
            let off = (f64::from(held.contribution()) - exact).abs();
            assert!(
                off <= 1.3e-7 * exact + 1e-45,
                "{target:e} {density:e}: {off:e}"
            );
            // There and back over all places, many times.
            for there in NUMBERS.into_iter().cycle().take(10_000) {
                let mut next = LightReservoir::new();
                next.absorb_with(held, there, u64::MAX).unwrap();
                let contribution = next.contribution();
                assert!(contribution > 0.0 && contribution <= f32::MAX);
                held = next;
            }
        }
    }
    let mut rng = Pcg32::new(1, 1);
    let sources = NUMBERS.map(|target| of_count(target, 4));
    for odd in [f32::NAN, f32::INFINITY, -1.0, 0.0, f32::MAX, 1e-45] {
        for rule in [
            Normaliser::Support,
            Normaliser::Balance,
            Normaliser::Pairwise,
        ] {
            for here in 0..9 {
                let targets = |k, _: &u32| if k == 3 { odd } else { 1e30 };
                let whole = LightReservoir::combine(&sources, here, rule, targets, &mut rng);
                let contribution = whole.contribution();
                assert!((0.0..=f32::MAX).contains(&contribution));
                assert_eq!(contribution > 0.0, whole.item().is_some());
                assert_eq!(whole.count(), 32);
            }
        }
    }
    let nothing =
        LightReservoir::<u32>::combine(&[], 0, Normaliser::Pairwise, |_, _| 1.0, &mut rng);
    assert_eq!(nothing, LightReservoir::new());
}

/// 2²⁰ offers of a weight that no `f32` holds: a sum in `f32` is off by more than 1e-4.
#[test]
fn sums_keep_their_digits_over_a_million_candidates() {
    let (mut rng, mut held, mut plain) = (Pcg32::new(3, 3), LightReservoir::new(), 0.0_f32);
    for _ in 0..1 << 20 {
        held.offer((), 0.1, 0.3, &mut rng).unwrap();
        plain += 0.1 / 0.3;
    }
    let off = |contribution: f64| (contribution * 0.3 - 1.0).abs();
    let by_f32 = f64::from(plain) / f64::from(1 << 20) / 0.1;
    assert!(off(held.contribution().into()) <= 1.5e-7);
    assert!(off(by_f32) > 1e-4, "{}", off(by_f32));
}

/// Of targets whose quotients leave the range of `f32`, by logarithms in `f64`.
#[test]
fn shares_of_any_size_keep_their_digits() {
    let mut rng = Pcg32::new(4, 4);
    let mut judged = 0;
    for density in [1e-38, 1e-30, 1e-8, 1.0] {
        for here in [1.5, 1e20, 3e38] {
            for there in [3e-45, 1e-45, 1e-30, 1.0] {
                let [mut own, mut other] = [LightReservoir::new(), LightReservoir::new()];
                own.offer_with(1, 0.0, density, 0).unwrap();
                other.offer_with(7, there, density, 0).unwrap();
                let targets = |k, _: &u32| [here, there][k];
                let rule = Normaliser::Balance;
                let whole = LightReservoir::combine(&[own, other], 0, rule, targets, &mut rng);
                let [here, there, density] = [here, there, density].map(f64::from);
                let exact = there / (here + there) / density;
                if exact > 1e-37 && exact < f64::from(f32::MAX) {
                    let off = (f64::from(whole.contribution()) / exact - 1.0).abs();
                    assert!(off <= 3e-7, "{here:e} {there:e} {density:e}: {off:e}");
                    judged += 1;
                }
            }
        }
    }
    assert!(judged > 20, "{judged}");
}
