//! Quotients digit by digit, and conversions from and to the bits of an `f32`, against the host's own.

use super::structured;
use crate::fixed::kernel::float;
use crate::fixed::kernel::quotient::{quotient, ratio, reciprocal};
use host::speed;
use rand_core::{Rng, SeedableRng};
use rand_pcg::Pcg32;
use std::vec::Vec;

/// Pairs of structured words, and of words of all magnitudes at random.
fn pairs() -> impl Iterator<Item = (u32, u32)> {
    let structured = structured();
    let all: Vec<(u32, u32)> = structured
        .iter()
        .flat_map(|a| structured.iter().map(move |b| (*a, *b)))
        .collect();
    let mut rng = Pcg32::seed_from_u64(7);
    let count = speed::of("quotients at random", 1 << 17, 1 << 20);
    let random = (0..count).map(move |_| {
        let mut word = || rng.next_u32() >> (rng.next_u32() & 31);
        (word(), word())
    });
    all.into_iter().chain(random)
}

#[test]
fn quotients_are_exact() {
    let mut less = 0;
    for (a, b) in pairs().filter(|pair| pair.1 > 0) {
        let exact = (u64::from(a) << 32) / u64::from(b);
        assert_eq!(ratio(a, b), exact, "{a}/{b}");
        if a < b {
            assert_eq!(u64::from(quotient(a, b)), exact, "{a}/{b}");
            less += 1;
        }
    }
    assert!(less > 100_000, "{less}");
}

#[test]
fn reciprocals_are_the_nearest() {
    let whole = [1 << 32, (1 << 32) - 1];
    for b in pairs()
        .map(|pair| u64::from(pair.1))
        .chain(whole)
        .filter(|b| *b > 0)
    {
        for power in [0, 1, 31, 32, 33, 59, 64] {
            let nearest = ((1_u128 << power) + u128::from(b / 2)) / u128::from(b);
            let nearest = u64::try_from(nearest).unwrap_or(u64::MAX);
            assert_eq!(reciprocal(power, b), nearest, "2^{power}/{b}");
        }
    }
}

/// In `f64`, which holds every word and every `f32`.
#[test]
fn conversions_of_floats_are_cut() {
    let q = |fraction: u32| 2f64.powi(fraction as i32);
    for (word, other) in pairs() {
        for fraction in [0, 1, 16, 27, 30, 32] {
            let exact = f64::from(word) / q(fraction);
            let got = f64::from(f32::from_bits(float::of(word, fraction)));
            assert!(
                got <= exact && exact - got <= exact * 2f64.powi(-23),
                "{word} Q{fraction}"
            );
            assert!(
                exact as f32 as f64 != exact || got == exact,
                "{word} Q{fraction}"
            );
            // Any bits at all, NaN included.
            let bits = other ^ word << 9;
            let x = f64::from(f32::from_bits(bits)).abs();
            // Of NaN the cast makes 0, and the largest word of what is too large.
            let cut = (x * q(fraction)).floor();
            assert_eq!(
                float::magnitude(bits, fraction),
                cut as u32,
                "{x} Q{fraction}"
            );
        }
        let x = f32::from_bits(other ^ word << 9);
        let uniform = if x >= 1.0 {
            u32::MAX << 8
        } else if x > 0.0 {
            (f64::from(x) * q(32)).floor() as u32
        } else {
            0
        };
        assert_eq!(float::uniform(x.to_bits()), uniform, "{x}");
    }
}
