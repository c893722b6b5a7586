//! Every entry of the tables that the compiler computes, against `f64` and exact integers.

use crate::fixed::kernel::tables;
use crate::fixed::{Coarse, Grade};
use ::fixed::types::U0F32;
use std::f64::consts::{LN_2, TAU};
use std::vec::Vec;

/// Which entries of a table are not the given ones.
fn wrong<T: Copy + Into<i64>>(table: &[T], right: impl Fn(usize) -> i64) -> Vec<usize> {
    let entries = table.iter().enumerate();
    let wrong = entries.filter(|(i, entry)| (**entry).into() != right(*i));
    wrong.map(|(i, _)| i).collect()
}

/// The nearest word to x in Q format. `f64` has digits enough: the word is not one that a rounding error decides.
fn nearest(x: f64, bits: i32) -> i64 {
    let scaled = x * 2f64.powi(bits);
    let fraction = scaled - scaled.floor();
    assert!((fraction - 0.5).abs() > 1e-6, "{x} is a tie in Q{bits}");
    scaled.round() as i64
}

/// Cut towards zero.
fn sine(i: usize) -> i64 {
    // By the nearer axis, where f64 is exact.
    let (octant, rest) = (i / 32 % 8, (i % 64) as f64);
    let (s, c) = (if rest > 32.0 { 64.0 - rest } else { rest } * TAU / 256.0).sin_cos();
    let magnitude = if [0, 3, 4, 7].contains(&octant) && rest != 32.0 {
        s
    } else {
        c
    };
    let magnitude = magnitude * 2f64.powi(30);
    let cut = magnitude.floor();
    assert!(
        cut == magnitude || magnitude - cut > 1e-6 && magnitude - cut < 1.0 - 1e-6,
        "{i}"
    );
    if octant < 4 {
        cut as i64
    } else {
        -(cut as i64)
    }
}

/// ⌊√(i/256)⌋ in Q16, of the entries that are used, and below 1.
fn root(i: usize) -> i64 {
    let square = (i as i64) << 24;
    let root = (0..=1_i64 << 16)
        .find(|r| (r + 1) * (r + 1) > square)
        .unwrap();
    if i < 64 { 0 } else { root.min(0xffff) }
}

fn log(i: usize) -> i64 {
    nearest(-((64.0 + i as f64) / 128.0).ln(), 27)
}

fn power(j: usize) -> i64 {
    nearest((-(j as f64) / 32.0 * LN_2).exp(), 31)
}

/// Of the rotation by atan(2^−(i + 1)).
fn rotation(i: usize) -> i64 {
    nearest(2f64.powi(-1 - i as i32).atan() / TAU, 32)
}

const NONE: [usize; 0] = [];

#[test]
fn tables_hold_the_nearest_words() {
    assert_eq!(wrong(&tables::SINE, sine), NONE);
    assert_eq!(wrong(&tables::ROOT, root), NONE);
    assert_eq!(wrong(&tables::LOG, log), NONE);
    assert_eq!(wrong(&tables::POWER, power), NONE);
    assert_eq!(wrong(&tables::ROTATION, rotation), NONE);
    assert_eq!(i64::from(tables::LN_2), nearest(LN_2, 27));
    assert_eq!(i64::from(tables::LN_2_32ND), nearest(LN_2 / 32.0, 27));
    // A turn and a quarter with its end, all of [1/4, 1], all of [1/2, 1], and an octave.
    let lengths = [
        tables::SINE.len(),
        tables::ROOT.len(),
        tables::LOG.len(),
        tables::POWER.len(),
    ];
    assert_eq!(lengths, [321, 257, 65, 32]);
    assert_eq!(tables::entry(&tables::SINE, 64), 1 << 30);
    assert_eq!(tables::entry(&tables::SINE, 321), 0);
    // A last place off is seen.
    let mut off = tables::SINE;
    off[77] += 1;
    assert_eq!(wrong(&off, sine), [77_usize]);
    let mut off = tables::LOG;
    off[64] += 1;
    off[0] -= 1;
    assert_eq!(wrong(&off, log), [0_usize, 64]);
}

/// A kernel reads the entry that belongs to its argument.
#[test]
fn points_of_the_table_are_where_they_belong() {
    for i in 0..256 {
        let (s, c) = Coarse::sincos_turns(U0F32::from_bits((i as u32) << 24));
        assert_eq!(i64::from(s.to_bits()), sine(i), "{i}");
        assert_eq!(i64::from(c.to_bits()), sine(i + 64), "{i}");
    }
    for i in 64..256 {
        let root_of = Coarse::sqrt(U0F32::from_bits((i as u32) << 24));
        assert_eq!(i64::from(root_of.to_bits() >> 16), root(i), "{i}");
    }
}
