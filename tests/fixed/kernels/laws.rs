//! What is exact: quarter turns, axes and mirrors, the ends of the functions.

use fixed::types::{I2F30, U0F32, U5F27, U16F16};
use microwarp::fixed::{Coarse, Compact, Fine, Grade};

const ONE: i32 = 1 << 30;

fn sincos<G: Grade>(phase: u32) -> (i32, i32) {
    let (s, c) = G::sincos_turns(U0F32::from_bits(phase));
    (s.to_bits(), c.to_bits())
}

fn sqrt<G: Grade>(x: u32) -> u32 {
    G::sqrt(U0F32::from_bits(x)).to_bits()
}

fn neg_ln_1m<G: Grade>(u: u32) -> u32 {
    G::neg_ln_1m(U0F32::from_bits(u)).to_bits()
}

fn exp_neg<G: Grade>(x: u32) -> u32 {
    G::exp_neg(U5F27::from_bits(x)).to_bits()
}

fn exp_m1_neg<G: Grade>(x: u32) -> u32 {
    G::exp_m1_neg(U5F27::from_bits(x)).to_bits()
}

fn pow<G: Grade>(x: u32, y: u32) -> u32 {
    G::pow(U0F32::from_bits(x), U16F16::from_bits(y)).to_bits()
}

fn atan2<G: Grade>(y: i32, x: i32) -> u32 {
    G::atan2_turns(I2F30::from_bits(y), I2F30::from_bits(x)).to_bits()
}

fn ends_are_exact<G: Grade>() {
    let quarters = [(0, ONE), (ONE, 0), (0, -ONE), (-ONE, 0)];
    for (i, quarter) in (0..).zip(quarters) {
        assert_eq!(sincos::<G>(i << 30), quarter, "{} {i}", G::NAME);
    }
    // By a table they are exact at its points; without one, cut below them.
    let slack = if G::NAME == Compact::NAME { 256 } else { 0 };
    for (word, root) in [(0, 0), (1, 1 << 16), (4, 2 << 16), (1 << 30, 1 << 31)] {
        let short = u32::checked_sub(root, sqrt::<G>(word));
        assert!(
            short.is_some_and(|short| short <= slack),
            "{} √{word}",
            G::NAME
        );
    }
    assert_eq!(neg_ln_1m::<G>(0), 0, "{}", G::NAME);
    // 32 ln 2, to half a place of each ln 2.
    let last = neg_ln_1m::<G>(u32::MAX).abs_diff(2_977_044_472);
    assert!(last <= 16, "{}: {last}", G::NAME);
    assert!(exp_neg::<G>(0) >= u32::MAX - 1, "{}", G::NAME);
    assert_eq!(exp_neg::<G>(u32::MAX), 0, "{}", G::NAME);
    assert_eq!(exp_m1_neg::<G>(0), 0, "{}", G::NAME);
    assert_eq!(exp_m1_neg::<G>(u32::MAX), u32::MAX, "{}", G::NAME);
    for word in [0, 1, 77, 1 << 16, 1 << 31, u32::MAX] {
        assert_eq!(pow::<G>(word, 0), u32::MAX, "{} {word}^0", G::NAME);
        if word > 0 {
            assert_eq!(pow::<G>(0, word), 0, "{} 0^{word}", G::NAME);
        }
        // However large the power, what is below 1 by more than a bit in 2¹⁶ vanishes.
        if word < 0xffc0_0000 {
            assert_eq!(pow::<G>(word, u32::MAX), 0, "{} {word}^∞", G::NAME);
        }
    }
}

#[test]
fn ends_are_exact_in_all_grades() {
    ends_are_exact::<Fine>();
    ends_are_exact::<Coarse>();
    ends_are_exact::<Compact>();
}

fn angles_are_exact_on_axes_and_mirrored<G: Grade>() {
    assert_eq!(atan2::<G>(0, 0), 0);
    for length in [1, 2, 3, 77, 1 << 16, ONE - 1, ONE, i32::MAX] {
        let around = [(0, length), (length, 0), (0, -length), (-length, 0)];
        for (quarter, (y, x)) in (0..).zip(around) {
            assert_eq!(atan2::<G>(y, x), quarter << 30, "{} {length}", G::NAME);
        }
        for across in [0, 1, 5, 1 << 10, ONE] {
            let [first, second, third, fourth] = [
                atan2::<G>(across, length),
                atan2::<G>(across, -length),
                atan2::<G>(-across, -length),
                atan2::<G>(-across, length),
            ];
            assert_eq!(second, (1_u32 << 31).wrapping_sub(first), "{}", G::NAME);
            assert_eq!(third, second.wrapping_neg(), "{}", G::NAME);
            assert_eq!(fourth, first.wrapping_neg(), "{}", G::NAME);
        }
    }
    assert_eq!(atan2::<G>(0, i32::MIN), 1 << 31);
    assert_eq!(atan2::<G>(i32::MIN, 0), 3 << 30);
}

#[test]
fn angles_are_exact_on_axes_and_mirrored_in_all_grades() {
    angles_are_exact_on_axes_and_mirrored::<Fine>();
    angles_are_exact_on_axes_and_mirrored::<Coarse>();
    angles_are_exact_on_axes_and_mirrored::<Compact>();
}
