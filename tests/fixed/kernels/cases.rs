//! Every function of a grade with its exact counterpart in `f64`, each as a function of one word.

use super::inputs::Words;
use fixed::types::{I2F30, U0F32, U5F27, U16F16};
use host::speed;
use microwarp::fixed::{Coarse, Compact, Fine, Grade};
use std::f64::consts::{FRAC_PI_2, TAU};

/// One or two numbers of a word; where there is one, the second is NaN on both sides and not looked at.
pub type Function = fn(u32) -> [f64; 2];

/// The grades, in the order of the columns and of a case's functions.
pub const GRADES: [&str; 3] = [Fine::NAME, Coarse::NAME, Compact::NAME];

/// A row of the table.
#[derive(Clone)]
pub struct Case {
    pub name: &'static str,
    pub words: Words,
    /// Whether a word belongs to the domain.
    pub within: fn(u32) -> bool,
    pub truth: Function,
    pub grades: [Function; 3],
    /// Whether 0 and 1 are the same.
    pub turns: bool,
}

const WORD: f64 = 1.0 / 4_294_967_296.0;
const Q30: f64 = 1.0 / 1_073_741_824.0;
const Q27: f64 = 1.0 / 134_217_728.0;

fn one(x: f64) -> [f64; 2] {
    [x, f64::NAN]
}

/// To the nearest quarter turn exactly, in integers; what is left is small.
fn sincos(phase: u32) -> [f64; 2] {
    let rest = phase.wrapping_shl(2) as i32;
    let (s, c) = (f64::from(rest) * WORD * FRAC_PI_2).sin_cos();
    match phase.wrapping_add(1 << 29) >> 30 {
        0 => [s, c],
        1 => [c, -s],
        2 => [-s, -c],
        _ => [-c, s],
    }
}

/// x^y of the y that the kernel is given, in Q16.
fn power(word: u32, y: u32) -> [f64; 2] {
    one((f64::from(y) / 65_536.0 * (f64::from(word) * WORD).ln()).exp())
}

/// The point of a word: coordinates of all magnitudes and signs, at random; of the last 2¹² words, all pairs of
/// edges.
pub fn point(word: u32) -> (i32, i32) {
    const EDGES: [i32; 16] = [
        0,
        1,
        2,
        3,
        1 << 15,
        1 << 16,
        0x5a82_799a,
        (1 << 30) - 1,
        1 << 30,
        (1 << 30) + 1,
        i32::MAX,
        i32::MAX - 1,
        0x2000_0000,
        0x0fff_ffff,
        0x1000_0000,
        77_777,
    ];
    if word >= 0xffff_f000 {
        let edge = |i: u32| EDGES[i as usize & 15];
        let (x, y) = (edge(word), edge(word >> 4));
        let sign = |bit: u32, c: i32| if word >> bit & 1 == 0 { c } else { -c };
        // The most negative word has no counterpart.
        let least = |bit: u32, c: i32| if word >> bit & 1 == 0 { c } else { i32::MIN };
        return (least(10, sign(8, x)), least(11, sign(9, y)));
    }
    // splitmix64
    let mut z = (u64::from(word) + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^= z >> 31;
    let (x, y) = (z as i32, (z >> 32) as i32);
    match word % 16 {
        // On the unit circle, where points of disks and directions lie.
        0..4 => {
            let [s, c] = sincos(z as u32).map(|c| (c / Q30) as i32);
            (c, s)
        }
        4 => (x >> 2, x >> 2),
        5 => (x >> 2, -(x >> 2)),
        // Of like magnitudes, and of any.
        6..12 => (x, y),
        _ => (x >> (z >> 8 & 31), y >> (z >> 24 & 31)),
    }
}

fn angle(word: u32) -> [f64; 2] {
    let (x, y) = point(word);
    let turns = f64::from(y).atan2(f64::from(x)) / TAU;
    one(if turns < 0.0 { turns + 1.0 } else { turns })
}

/// A function over a grade `G`, in every grade.
macro_rules! grades {
    ($function:expr) => {
        [
            {
                type G = Fine;
                $function
            },
            {
                type G = Coarse;
                $function
            },
            {
                type G = Compact;
                $function
            },
        ]
    };
}

fn q32(x: U0F32) -> [f64; 2] {
    one(f64::from(x.to_bits()) * WORD)
}

fn q27(x: U5F27) -> [f64; 2] {
    one(f64::from(x.to_bits()) * Q27)
}

/// The y of the powers, in Q16: a lobe's 1/51, a square root, a square and a bit, a lobe's own.
const EXPONENTS: [u32; 4] = [1285, 1 << 15, 0x2_1234, 50 << 16];

macro_rules! power_of {
    ($i:literal, $name:literal) => {
        Case {
            name: $name,
            words: Words::all_or(8, 16_384, 128),
            within: |word| word > 0,
            truth: |word| power(word, EXPONENTS[$i]),
            grades: grades!(|word| q32(G::pow(
                U0F32::from_bits(word),
                U16F16::from_bits(EXPONENTS[$i])
            ))),
            turns: false,
        }
    };
}

pub fn cases() -> Vec<Case> {
    let case = |name, truth, grades| Case {
        name,
        words: Words::every(2048, 64),
        within: |_| true,
        truth,
        grades,
        turns: false,
    };
    vec![
        case(
            "`sincos_turns`",
            sincos,
            grades!(|word| {
                let (s, c) = G::sincos_turns(U0F32::from_bits(word));
                [s, c].map(|c| f64::from(c.to_bits()) * Q30)
            }),
        ),
        case(
            "`sqrt`",
            |word| one((f64::from(word) * WORD).sqrt()),
            grades!(|word| q32(G::sqrt(U0F32::from_bits(word)))),
        ),
        case(
            "`neg_ln_1m`",
            |word| one(-(-f64::from(word) * WORD).ln_1p()),
            grades!(|word| q27(G::neg_ln_1m(U0F32::from_bits(word)))),
        ),
        case(
            "`exp_neg`",
            |word| one((-f64::from(word) * Q27).exp()),
            grades!(|word| q32(G::exp_neg(U5F27::from_bits(word)))),
        ),
        Case {
            // For the most part the complement of the one before.
            words: Words::every(8192, 64),
            ..case(
                "`exp_m1_neg`",
                |word| one(-(-f64::from(word) * Q27).exp_m1()),
                grades!(|word| q32(G::exp_m1_neg(U5F27::from_bits(word)))),
            )
        },
        Case {
            words: Words {
                bits: 24,
                stride: speed::of("one small number tried of every", 16, 1),
            },
            within: |word| word < 1 << 24,
            ..case(
                "`exp_m1_neg`, x < 1/8",
                |word| one(-(-f64::from(word) * Q27).exp_m1()),
                grades!(|word| q32(G::exp_m1_neg(U5F27::from_bits(word)))),
            )
        },
        power_of!(0, "`pow`, y = 0.0196"),
        power_of!(1, "`pow`, y = 0.5"),
        power_of!(2, "`pow`, y = 2.071"),
        power_of!(3, "`pow`, y = 50"),
        Case {
            // Points at random: more of them where time allows it.
            words: Words {
                bits: speed::or_all("bits of the words of points", 20, 24, 28),
                stride: 1,
            },
            turns: true,
            ..case(
                "`atan2_turns`",
                angle,
                grades!(|word| {
                    let (x, y) = point(word);
                    q32(G::atan2_turns(I2F30::from_bits(y), I2F30::from_bits(x)))
                }),
            )
        },
    ]
}
