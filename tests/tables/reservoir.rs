//! `Reservoir`: the bits that take it counted exactly, then streams and mergers sampled.

use crate::cases::runs;
use host::speed;
use host::stats::threshold;
use microwarp::Error;
use microwarp::discrete::Reservoir;
use rand_pcg::Pcg32;

/// With how many of the 2⁶⁴ bit strings a second item of weight `b` displaces the first of weight `a`.
fn taking(a: f32, b: f32) -> u128 {
    let took = |bits: u64| {
        let mut reservoir = Reservoir::new();
        assert_eq!(reservoir.offer_with('a', a, u64::MAX), Ok(a > 0.0));
        usize::from(reservoir.offer_with('b', b, bits) == Ok(false))
    };
    match runs(0, u64::MAX, took)[..] {
        [(0, taken), (1, _)] => taken,
        [(0, all)] => all,
        [(1, _)] => 0,
        ref other => panic!("{other:?}"),
    }
}

#[test]
fn an_item_takes_the_place_with_its_share_of_the_bits() {
    assert_eq!(taking(1.0, 1.0), 1 << 63);
    assert_eq!(taking(3.0, 1.0), 1 << 62);
    assert_eq!(taking(2.0, 1.0), (1 << 64) / 3);
    assert_eq!(taking(0.0, 1.0), 1 << 64);
    assert_eq!(taking(1.0, 0.0), 0);
    // A positive weight always has a bit string of its own.
    assert_eq!(taking(f32::MAX, f32::from_bits(1)), 1);
    assert_eq!(taking(f32::from_bits(1), f32::MAX), 1 << 64);
    for (a, b) in [
        (1.5e-38, 7.1e-45),
        (0.1, 0.7),
        (1e30, 3e29),
        (16_777_216.0, 1.0),
    ] {
        let share = f64::from(b) / (f64::from(a) + f64::from(b));
        let off = (taking(a, b) as f64 / 2_f64.powi(64) - share).abs();
        assert!(off <= 1e-15, "{a} {b}: {off:e}");
    }
}

const WEIGHTS: [f32; 10] = [0.0, 5.0, 1.0, 0.0, 0.25, 9.0, 3.0, 0.0, 0.7, 0.0];

/// The p-value of items held after many streams against their weights.
fn p_value(stream: impl FnMut(&mut Pcg32) -> usize, seed: u64) -> f64 {
    let total: f64 = WEIGHTS.iter().map(|&w| f64::from(w)).sum();
    let shares = WEIGHTS.map(|w| f64::from(w) / total);
    let runs = speed::of("streams", 200_000, 1_000_000);
    crate::cases::p_value(&shares, runs, seed, stream).unwrap()
}

fn part(range: std::ops::Range<usize>, rng: &mut Pcg32) -> Reservoir<usize> {
    let mut reservoir = Reservoir::new();
    for i in range {
        reservoir.offer(i, WEIGHTS[i], rng).unwrap();
    }
    reservoir
}

#[test]
fn streams_and_mergers_hold_items_by_their_weights() {
    let least = threshold(3);
    let whole = p_value(|rng| *part(0..10, rng).item().unwrap(), 1);
    let merged = p_value(
        |rng| {
            let mut parts = [
                part(0..1, rng),
                part(1..5, rng),
                part(5..6, rng),
                part(6..10, rng),
            ];
            let [a, b, c, d] = &mut parts;
            c.merge(*d, rng);
            b.merge(*c, rng);
            a.merge(*b, rng);
            *a.item().unwrap()
        },
        2,
    );
    println!("p: stream {whole:.3}, merged {merged:.3}");
    assert!(whole > least && merged > least);
    // Merging by a fair coin is rejected.
    let wrong = p_value(
        |rng| {
            let (a, b) = (part(0..5, rng), part(5..10, rng));
            let coin = rand_pcg::rand_core::Rng::next_u32(rng) >> 31;
            *[a, b][coin as usize].item().unwrap()
        },
        3,
    );
    assert!(wrong < least);
}

#[test]
fn the_pmf_of_what_is_held_is_its_weight_over_the_sum() {
    let mut rng = Pcg32::new(9, 9);
    let mut reservoir = Reservoir::new();
    assert_eq!((reservoir.pmf(), reservoir.item()), (0.0, None));
    let mut sum = 0.0;
    for i in 0..100_000_u32 {
        let weight = 10_f32.powi(i as i32 % 60 - 30);
        reservoir.offer(weight, weight, &mut rng).unwrap();
        sum += f64::from(weight);
        let exact = f64::from(*reservoir.item().unwrap()) / sum;
        let error = (f64::from(reservoir.pmf()) - exact).abs();
        assert!(error <= 6.0e-8 * exact, "{i}: {error:e}");
    }
}

#[test]
fn refusals_leave_it_as_it_was() {
    let mut rng = Pcg32::new(1, 1);
    let mut reservoir = Reservoir::default();
    assert_eq!(
        reservoir.offer('x', f32::NAN, &mut rng),
        Err(Error::NotFinite(1))
    );
    assert_eq!(
        reservoir.offer('x', f32::INFINITY, &mut rng),
        Err(Error::NotFinite(1))
    );
    assert_eq!(
        reservoir.offer('x', -1e-45, &mut rng),
        Err(Error::Negative(1))
    );
    assert_eq!(reservoir.offer('x', -0.0, &mut rng), Ok(false));
    assert_eq!(reservoir, Reservoir::new());
    assert!(!reservoir.merge(Reservoir::new(), &mut rng));
    reservoir.offer('y', 1e-45, &mut rng).unwrap();
    let before = reservoir;
    assert!(!reservoir.merge(Reservoir::new(), &mut rng));
    assert_eq!(reservoir, before);
    assert_eq!(reservoir.pmf(), 1.0);
}
