//! Drawn entries against their weights by chi-square, and what a draw takes from a generator.

use host::generators::{Broken, Counting, Failing};
use host::speed;
use host::stats::{chi_square, threshold};
use microwarp::discrete::{Alias, AliasEntry, Cdf, Reservoir};
use rand_pcg::Pcg32;
use rand_pcg::rand_core::Rng;
use std::sync::LazyLock;

static SAMPLES: LazyLock<usize> =
    LazyLock::new(|| speed::of("draws of each table", 1_000_000, 10_000_000));

fn p_value(
    weights: &[f32],
    seed: u64,
    mut draw: impl FnMut(&mut Pcg32) -> usize,
) -> Result<f64, String> {
    let mut rng = Pcg32::new(seed, 54);
    let mut observed = vec![0; weights.len()];
    for _ in 0..*SAMPLES {
        observed[draw(&mut rng)] += 1;
    }
    let total: f64 = weights.iter().map(|&w| f64::from(w)).sum();
    let expected: Vec<f64> = weights
        .iter()
        .map(|&w| f64::from(w) / total * *SAMPLES as f64)
        .collect();
    chi_square(&observed, &expected).map(|(_, _, p)| p)
}

fn weights() -> [(&'static str, Vec<f32>); 5] {
    [
        ("die", vec![1.0; 6]),
        (
            "1000 with zeros",
            (0..1000)
                .map(|i| [0.0, 3.0, 1.0, 0.2][i % 4] * i as f32)
                .collect(),
        ),
        ("2^16", (0..1 << 16).map(|i| 1.0 + (i % 7) as f32).collect()),
        (
            "decades",
            (0..40).map(|i| 10_f32.powf(-0.2 * i as f32)).collect(),
        ),
        ("extreme", vec![1e-38, 2e37, 1e38, 0.0, 1e-45, 3e37]),
    ]
}

#[test]
fn drawn_entries_follow_their_weights() {
    let mut all = Vec::new();
    for (k, (what, weights)) in weights().into_iter().enumerate() {
        let n = weights.len();
        let (mut narrow, mut wide) = (vec![0; n], vec![0; n]);
        let bins = n.next_power_of_two();
        let mut alias = vec![AliasEntry::<u32>::EMPTY; bins];
        let mut wide_alias = vec![AliasEntry::<u64>::EMPTY; bins];
        let seed = 10 * k as u64;
        let cdf = Cdf::<&[u64]>::new_in(&weights, &mut wide).unwrap();
        all.push((
            what,
            p_value(&weights, seed, |rng| cdf.draw(rng).index).unwrap(),
        ));
        let table = Alias::<&[AliasEntry<u64>]>::new_in(&weights, &mut wide_alias).unwrap();
        all.push((
            what,
            p_value(&weights, seed + 1, |rng| table.draw(rng).index).unwrap(),
        ));
        if what == "extreme" {
            continue;
        }
        let cdf = Cdf::<&[u32]>::new_in(&weights, &mut narrow).unwrap();
        all.push((
            what,
            p_value(&weights, seed + 2, |rng| cdf.draw(rng).index).unwrap(),
        ));
        let table = Alias::<&[AliasEntry<u32>]>::new_in(&weights, &mut alias).unwrap();
        all.push((
            what,
            p_value(&weights, seed + 3, |rng| table.draw(rng).index).unwrap(),
        ));
    }
    println!("{all:.3?}");
    let least = threshold(all.len());
    assert_eq!(all.len(), 18);
    assert!(all.iter().all(|(_, p)| *p > least), "{all:?}");
}

/// The same test rejects weights that are off by one in a hundred, of fewer draws by four, and any sample of weight zero.
#[test]
fn wrong_weights_are_rejected() {
    let mut weights = vec![1.0; 6];
    weights[2] = speed::of("weight of the control", 1.04, 1.01);
    let table = Cdf::from_integers(&[1; 6]).unwrap();
    let p = p_value(&weights, 1, |rng| table.draw(rng).index).unwrap();
    assert!(p < threshold(18), "{p}");
    weights[2] = 0.0;
    assert!(p_value(&weights, 1, |rng| table.draw(rng).index).is_err());
}

#[test]
fn a_draw_takes_the_stated_words_and_passes_a_failure_on() {
    fn driver(left: u64) -> Counting<Failing> {
        Counting::new(Failing {
            word: 0x9234_5678,
            left,
        })
    }
    fn takes<T>(words: u64, draw: impl Fn(&mut Counting<Failing>) -> Result<T, Broken>) {
        let mut rng = driver(9);
        assert!(draw(&mut rng).is_ok());
        assert_eq!(rng.words, words);
        for left in 0..words {
            assert!(draw(&mut driver(left)).is_err());
        }
    }
    const WEIGHTS: [f32; 4] = [1.0, 2.0, 0.0, 4.0];
    let narrow = Cdf::new(&WEIGHTS).unwrap();
    let wide = Cdf::new_u64(&WEIGHTS).unwrap();
    let alias = Alias::<[AliasEntry<u32>; 4]>::new(&WEIGHTS).unwrap();
    let wide_alias = Alias::<[AliasEntry<u64>; 4]>::new_u64(&WEIGHTS).unwrap();
    takes(1, |rng| narrow.try_draw(rng));
    takes(2, |rng| wide.try_draw(rng));
    takes(1, |rng| alias.try_draw(rng));
    takes(1, |rng| narrow.try_draw_index(rng));
    takes(2, |rng| wide_alias.try_draw_index(rng));
    takes(2, |rng| wide_alias.try_draw(rng));
    takes(2, |rng| Reservoir::new().try_offer(1, 0.0, rng));
    takes(2, |rng| {
        Reservoir::<u8>::new().try_merge(Reservoir::new(), rng)
    });
    // The leading word comes first.
    let mut rng = Pcg32::new(4, 4);
    let mut same = rng.clone();
    let word = u64::from(same.next_u32()) << 32 | u64::from(same.next_u32());
    assert_eq!(wide.draw(&mut rng), wide.select_word(word));
    // The index alone is that of the selection.
    let mut same = rng.clone();
    for _ in 0..1000 {
        assert_eq!(narrow.draw_index(&mut rng), narrow.draw(&mut same).index);
        assert_eq!(
            wide_alias.draw_index(&mut rng),
            wide_alias.draw(&mut same).index
        );
    }
}
