//! `select_once`: every entry's words counted, as for a table.

use crate::cases::wild;
use crate::cases::{Exact, STEP, counts, runs};
use microwarp::discrete::{Cdf, select_once, select_once_uniform};
use microwarp::uniform::grid_from_word;

fn check(weights: &[f32]) {
    let exact = Exact::of(weights);
    let index = |word: u64| select_once(weights, word as u32).unwrap().index;
    let counted = counts(weights.len(), u32::MAX.into(), index);
    for (i, &count) in counted.iter().enumerate() {
        // What sums of 64 bits drop is below 2^-30 of a step each time.
        let slack = STEP + 4 * weights.len() as u64;
        assert!(
            exact.within(i, count, 32, slack),
            "{i}: {count} in {weights:?}"
        );
        assert!(
            weights[i] > 0.0 || count == 0,
            "{i} of weight 0 in {weights:?}"
        );
    }
}

#[test]
fn every_entry_has_its_share_of_the_words() {
    check(&[3.0]);
    check(&[1.0; 6]);
    check(&[0.0, 2.0, 0.0, 1.0, 0.0]);
    check(&[f32::MAX, f32::from_bits(1), f32::MAX, 1.0]);
    check(&[f32::from_bits(1), f32::MAX, 0.0]);
    check(&(1..=300).map(|i| 1.0 / i as f32).collect::<Vec<_>>());
    check(
        &(0..253)
            .map(|i| 10_f32.powf(i as f32 * 0.3 - 38.0))
            .collect::<Vec<_>>(),
    );
    for seed in 40_000..42_000 {
        check(&wild(seed));
    }
}

#[test]
fn the_same_bits_select_what_they_select_in_a_table() {
    let weights: Vec<f32> = (0..200).map(|i| (i * i % 97) as f32).collect();
    let mut memory = vec![0; 200];
    let table = Cdf::<&[u32]>::new_in(&weights, &mut memory).unwrap();
    for word in (0..u32::MAX).step_by(40_009) {
        let (once, chosen) = (select_once(&weights, word).unwrap(), table.select(word));
        assert_eq!(once.index, chosen.index);
        assert!((once.pmf - chosen.pmf).abs() <= 1e-9, "{once:?} {chosen:?}");
        // Borders are whole words in the table and not here.
        let word_wide = 2.0 / (chosen.pmf * 4_294_967_296.0);
        let apart = (once.leftover - chosen.leftover).abs();
        assert!(apart <= word_wide + 1e-6, "{once:?} {chosen:?}");
    }
}

#[test]
fn the_pmf_is_the_weight_over_the_sum() {
    for seed in 50_000..52_000_u32 {
        let weights = wild(seed.into());
        let total: f64 = weights.iter().map(|&w| f64::from(w)).sum();
        for bits in [
            0,
            1 << 20,
            1 << 31,
            seed.wrapping_mul(0x9e37_79b9),
            u32::MAX,
        ] {
            let chosen = select_once(&weights, bits).unwrap();
            let exact = f64::from(weights[chosen.index]) / total;
            let error = (f64::from(chosen.pmf) - exact).abs();
            assert!(
                error <= exact * 6.0e-8 + 1.5e-45 && chosen.pmf > 0.0,
                "{chosen:?} in {weights:?}"
            );
            assert!((0.0..1.0).contains(&chosen.leftover));
            // To the rounding of the sum of this test.
            let left = |p: f64| (32.0 + p.min(1.0).log2()).max(0.0).floor() as u32;
            let bits = left(exact * (1.0 - 1e-13))..=left(exact * (1.0 + 1e-13));
            assert!(bits.contains(&chosen.leftover_bits), "{chosen:?}: {bits:?}");
        }
    }
}

/// A probability that is below a power of two, but rounds to it as an `f32`, leaves what is below.
#[test]
fn what_is_just_below_a_power_of_two_leaves_a_bit_less() {
    for halvings in 0..20 {
        for below in 25..40 {
            // The first has 2^-halvings of the sum, or a little less.
            let rest: Vec<f32> = (0..halvings).map(|k| 2_f32.powi(k)).collect();
            let all = |tiny: f32| [&[1.0], &rest[..], &[tiny]].concat();
            let bits = |tiny| {
                let chosen = select_once(&all(tiny), 0).unwrap();
                assert_eq!((chosen.index, chosen.pmf), (0, 0.5_f32.powi(halvings)));
                chosen.leftover_bits
            };
            let halvings = halvings as u32;
            assert_eq!(bits(0.0), 32 - halvings);
            assert_eq!(
                bits(2_f32.powi(-below)),
                31 - halvings,
                "{halvings} {below}"
            );
        }
    }
}

#[test]
fn a_uniform_selects_what_its_bits_select() {
    let weights = [0.3, 0.0, 2.0, 1e-3, 0.7];
    for k in 0..1_u32 << 16 {
        let bits = k << 16;
        let by_bits = select_once(&weights, bits).unwrap();
        let by_uniform = select_once_uniform(&weights, grid_from_word(bits)).unwrap();
        assert_eq!(by_bits.index, by_uniform.index);
        assert_eq!(by_uniform.leftover_bits, by_bits.leftover_bits - 8);
    }
    // What an f32 has below 32 bits is left over too.
    for u in [1e-12_f32, 3e-10, 1e-20, 1e-45] {
        assert_eq!(select_once_uniform(&[7.0], u).unwrap().leftover, u);
        let half = select_once_uniform(&[1.0, 1.0], u).unwrap().leftover;
        assert!((half - 2.0 * u).abs() <= 2e-7 * u, "{u} {half}");
    }
    for u in [f32::NAN, -1.0, f32::NEG_INFINITY, 1.0, 9.0, f32::INFINITY] {
        let chosen = select_once_uniform(&weights, u).unwrap();
        assert!(chosen.pmf > 0.0 && (0.0..1.0).contains(&chosen.leftover));
    }
}

/// The check rejects the plain form of the same method, with its uniform rescaled in f32.
#[test]
fn rescaling_in_f32_is_rejected() {
    let weights: Vec<f32> = (1..=14).map(|i| 1.0 / i as f32).collect();
    let naive = |word: u64| {
        let (mut u, mut sum, mut chosen) = ((word as f32) / 4_294_967_296.0, 0.0, 0);
        for (i, &w) in weights.iter().enumerate() {
            sum += w;
            let p = w / sum;
            if u < p {
                (chosen, u) = (i, u / p);
            } else {
                u = (u - p) / (1.0 - p);
            }
        }
        chosen
    };
    let exact = Exact::of(&weights);
    let mut counts = vec![0; 14];
    for (i, count) in runs(0, u32::MAX.into(), naive) {
        counts[i] += count;
    }
    let off = (0..14)
        .filter(|&i| !exact.within(i, counts[i], 32, STEP))
        .count();
    assert!(off > 5, "{off}");
}
