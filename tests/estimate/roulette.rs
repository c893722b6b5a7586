//! Roulette keeps the mean by the chance that it realises; the usual ways to weigh or to decide fail the same test.

use host::speed;
use microwarp::estimate::roulette;
use microwarp::uniform::{Chance, grid_from_word};
use rand_pcg::Pcg32;
use rand_pcg::rand_core::Rng;

type Roulette = fn(f32, u32) -> Option<f32>;

const ALL: f64 = 4_294_967_296.0;

/// By how much the mean of the weights of all words is off 1. The words that go on are the smallest, all with one weight.
fn off(roulette: Roulette, p: f32) -> f64 {
    let weight = roulette(p, 0).map_or(0.0, f64::from);
    let (mut below, mut from) = (0_u64, 1_u64 << 32);
    while below < from {
        let middle = (below + from) / 2;
        match u32::try_from(middle)
            .ok()
            .and_then(|word| roulette(p, word))
        {
            Some(also) => {
                assert_eq!(f64::from(also), weight);
                below = middle + 1;
            }
            None => from = middle,
        }
    }
    (below as f64 / ALL * weight - 1.0).abs()
}

/// The largest over chances above 1e-5, where a weight is rounded and chances are not whole words.
fn worst(roulette: Roulette, chances: u32) -> f64 {
    let mut rng = Pcg32::new(63, 54);
    let chance = |_| 1e-5_f32.powf(grid_from_word(rng.next_u32()));
    (0..chances)
        .map(chance)
        .map(|p| off(roulette, p))
        .fold(0.0, f64::max)
}

#[test]
fn what_goes_on_keeps_the_mean() {
    let chances = speed::of("chances of roulette", 20_000, 1_000_000);
    let ours = worst(roulette, chances);
    let by_p = worst(
        |p, word| Chance::new(p).unwrap().accepts(word).then(|| 1.0 / p),
        chances,
    );
    let by_24_bits = worst(
        |p, word| (grid_from_word(word) < p).then(|| 1.0 / p),
        chances,
    );
    println!("off the mean: {ours:.1e}; weight 1/p {by_p:.1e}; 24 bits {by_24_bits:.1e}");
    assert!(ours <= 6e-8);
    assert!(by_p > 1e-5 && by_24_bits > 1e-3);
    // Down to the least chance, which is one word.
    for p in [1.0_f32.next_down(), 0.95, 1e-9, 1e-38, 1e-45] {
        assert!(off(roulette, p) <= 6e-8, "{p:e}");
    }
}

#[test]
fn any_chance_has_an_end() {
    let mut rng = Pcg32::new(64, 54);
    for word in [0, 1, u32::MAX]
        .into_iter()
        .chain((0..100).map(|_| rng.next_u32()))
    {
        for sure in [1.0, 1.5, f32::MAX, f32::INFINITY] {
            assert_eq!(roulette(sure, word), Some(1.0));
        }
        for none in [0.0, -0.0, -1e-45, -1.0, f32::NEG_INFINITY, f32::NAN] {
            assert_eq!(roulette(none, word), None);
        }
    }
    assert_eq!(
        (roulette(1e-45, 0), roulette(1e-45, 1)),
        (Some(ALL as f32), None)
    );
    assert_eq!(Chance::new(0.0).unwrap().weight(), 0.0);
    assert_eq!(Chance::from_ratio(1, 5).unwrap().weight(), 5.0);
}
