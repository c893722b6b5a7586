//! Negative controls: the sweep that accepts the kernels rejects them with one fault in them.
//!
//! The faults are put where they would show, in front of a right kernel or behind it. A sweep over fewer words than
//! the real one tries cannot find more, so it is one of every 256, or 8192 in the quick speed, that must reject.

use super::cases::{Case, GRADES, cases};
use super::figures::{self, Figures, stated};
use super::inputs::{Words, edges};
use super::measured::measure;
use fixed::types::{U0F32, U5F27};
use host::speed;
use microwarp::fixed::{Compact, Fine, Grade};
use std::f64::consts::TAU;

const Q30: f64 = 1.0 / 1_073_741_824.0;
const Q32: f64 = 1.0 / 4_294_967_296.0;

fn fine_sincos(phase: u32) -> [f64; 2] {
    let (s, c) = Fine::sincos_turns(U0F32::from_bits(phase));
    [s, c].map(|c| f64::from(c.to_bits()) * Q30)
}

/// How far a phase is from the nearest of 256 points of the turn.
fn from_nearest(phase: u32) -> i32 {
    phase.wrapping_shl(8) as i32 >> 8
}

/// A function, its grade, what is wrong, and the wrong kernel.
type Control = (
    &'static str,
    &'static str,
    &'static str,
    fn(u32) -> [f64; 2],
);

const CONTROLS: [Control; 8] = [
    ("`sincos_turns`", "fine", "as it should be", fine_sincos),
    ("`sincos_turns`", "fine", "an entry off by 2^-16", |phase| {
        let [s, c] = fine_sincos(phase);
        let spoilt = phase.wrapping_add(1 << 23) >> 24 == 77;
        [if spoilt { s + 1.0 / 65_536.0 } else { s }, c]
    }),
    ("`sincos_turns`", "fine", "radians off in bit 12", |phase| {
        fine_sincos(phase.wrapping_add_signed(from_nearest(phase) >> 12))
    }),
    ("`sincos_turns`", "fine", "the point to the left", |phase| {
        // As the kernel goes on from the nearest one: to the quadratic term.
        let angle = f64::from(phase & 0xff_ffff) * Q32 * TAU;
        let [s, c] = fine_sincos(phase & 0xff00_0000);
        let short = 1.0 - 0.5 * angle * angle;
        [s * short + c * angle, c * short - s * angle]
    }),
    ("`sqrt`", "compact", "no bias", |word| {
        let root = Compact::sqrt(U0F32::from_bits(word));
        [f64::from(root.to_bits()) * Q32 + 1.5e-8, f64::NAN]
    }),
    ("`sqrt`", "fine", "the next cell", |word| {
        let root = Fine::sqrt(U0F32::from_bits(word.saturating_add(1 << 24)));
        [f64::from(root.to_bits()) * Q32, f64::NAN]
    }),
    ("`exp_neg`", "compact", "log2 e off in bit 12", |x| {
        let power = Compact::exp_neg(U5F27::from_bits(x.saturating_add(x >> 12)));
        [f64::from(power.to_bits()) * Q32, f64::NAN]
    }),
    (
        "`exp_neg`",
        "compact",
        "not a number at one word in 2^16",
        |x| {
            let power = Compact::exp_neg(U5F27::from_bits(x));
            let nan = x & 0xffff == 0x3c71;
            [
                if nan {
                    f64::NAN
                } else {
                    f64::from(power.to_bits()) * Q32
                },
                f64::NAN,
            ]
        },
    ),
];

#[test]
fn a_fault_in_a_kernel_is_noticed() {
    let (edges, all, stated) = (edges(), cases(), stated());
    for (name, grade, what, wrong) in CONTROLS {
        let case = all.iter().find(|case| case.name == name).unwrap();
        let (_, figures) = stated.iter().find(|row| row.0 == name).unwrap();
        let column = GRADES.iter().position(|g| *g == grade).unwrap();
        let case = Case {
            words: Words {
                bits: 32,
                stride: speed::of("one word tried of every, of controls", 8192, 256),
            },
            grades: [wrong; 3],
            ..case.clone()
        };
        let measured = figures::figures(&measure(&case, &edges)[column]);
        println!("{name} {grade}, {what}: {measured:?}");
        assert_eq!(
            figures[column].agree_with(measured, speed::full()),
            what == "as it should be",
            "{name} {grade}, {what}: {measured:?}, {:?}",
            figures[column]
        );
    }
}

/// Spoils figures.
type Change = fn(&mut Figures);

/// Figures that are broken, and figures that hold but are stale.
#[test]
fn wrong_and_stale_figures_are_noticed() {
    let measured = Figures {
        max: 1.0,
        rms: 0.5,
        mean: -0.1,
    };
    let spoilt: [(bool, Change); 12] = [
        (true, |_| ()),
        (true, |f| f.max = 1.1),
        (false, |f| f.max = 0.99),
        (false, |f| f.max = 1.3),
        (true, |f| f.rms = 0.55),
        (false, |f| f.rms = 0.49),
        (false, |f| f.rms = 0.65),
        (true, |f| f.mean = -0.11),
        (false, |f| f.mean = -0.09),
        (false, |f| f.mean = -0.14),
        (false, |f| f.mean = 0.11),
        (false, |f| f.mean = 0.0),
    ];
    for (holds, change) in spoilt {
        let mut stated = measured;
        change(&mut stated);
        assert_eq!(stated.agree_with(measured, true), holds, "{stated:?}");
        // A largest error that is stale is not noticed where few words are tried.
        let kept = holds || stated.max > 1.1;
        assert_eq!(stated.agree_with(measured, false), kept, "{stated:?}");
    }
    for nan in [f64::NAN, f64::INFINITY] {
        let measured = Figures {
            max: nan,
            ..measured
        };
        for many in [true, false] {
            assert!(!measured.agree_with(measured, many), "{nan} passes");
        }
    }
}
