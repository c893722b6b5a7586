//! The truncated exponential.

use super::figures::{Figures, WORD, hold, over_words, sample_rows};
use crate::raw::{Raw, raw};
use fixed::FixedU32;
use fixed::types::extra::{LeEqU32, U0, U16, U32};
use fixed::types::{U0F32, U16F16};
use microwarp::fixed::warp::TruncatedExponential;
use microwarp::fixed::{Coarse, Compact, Fine, Grade};
use microwarp::{Error, Invert, Warp};

/// −ln(1 − u(1 − e^−z)), in means.
fn truth(w: f64, z: f64) -> f64 {
    -((w * WORD) * (-z).exp_m1()).ln_1p()
}

/// How far x, in means, lies outside what the words next to this one and a step below give.
fn beyond(x: f64, w: u32, z: f64, step: f64) -> f64 {
    let w = f64::from(w);
    let (least, most) = (
        truth((w - 1.0).max(0.0), z) - step,
        truth((w + 1.0).min(1.0 / WORD), z),
    );
    (x - x.clamp(least, most)).abs()
}

/// Means and lengths in steps: z about the border of the series and far from it, to both sides.
const SETS: [[u32; 2]; 14] = [
    [u32::MAX, 1 << 24],
    [u32::MAX, 1 << 29],
    // The borders: z is 0.21, and 0.49 in the coarse grade.
    [u32::MAX, 0x35c2_8f00],
    [u32::MAX, 0x35c2_8fff],
    [u32::MAX, 0x7d70_a300],
    [u32::MAX, 0x7d70_a3ff],
    [u32::MAX, u32::MAX],
    [1 << 30, u32::MAX],
    [1 << 29, u32::MAX],
    [1 << 28, u32::MAX],
    [193_000_000, u32::MAX],
    [1 << 27, u32::MAX],
    [1 << 26, u32::MAX],
    [1 << 24, u32::MAX],
];

/// A warp of some parameters.
type New = fn([u32; 2]) -> Box<dyn Raw>;

/// Each grade in the format of most digits.
const NEW: [New; 3] = [
    |set| raw(parameters::<U32, Fine>(set)),
    |set| raw(parameters::<U32, Coarse>(set)),
    |set| raw(parameters::<U32, Compact>(set)),
];

fn parameters<Frac: LeEqU32, G: Grade>([mean, length]: [u32; 2]) -> TruncatedExponential<Frac, G> {
    let bits = FixedU32::from_bits;
    TruncatedExponential::from_mean(bits(mean), bits(length)).unwrap()
}

/// The largest error beyond a word and a step, and the root mean square and the mean of the plain one.
fn sample_error(new: New) -> Figures {
    let mut total = Figures::default();
    for set in SETS {
        let (warp, [mean, length]) = (new(set), set.map(f64::from));
        let (z, unit) = (length / mean, (length / mean).min(1.0));
        let mut figures = over_words(100_003, |w, observe| {
            let x = f64::from(warp.sample(&[w])[0]);
            assert!(x < length, "{set:?} {w:#x}");
            observe((x / mean - truth(f64::from(w), z)) / unit);
        });
        figures.max = 0.0;
        figures.join(&over_words(100_003, |w, observe| {
            let x = f64::from(warp.sample(&[w])[0]);
            observe(beyond(x / mean, w, z, 1.0 / mean) / unit);
        }));
        total.join(&figures);
    }
    total
}

fn pdf_error(new: New) -> f64 {
    let mut worst: f64 = 0.0;
    for set in SETS {
        let (warp, [mean, length]) = (new(set), set.map(f64::from));
        let peak = 1.0 / (mean * WORD) / -(-length / mean).exp_m1();
        let figures = over_words(200_003, |w, observe| {
            let sample = warp.sample(&[w])[0];
            for x in [sample, (f64::from(w) * WORD * length) as u32] {
                let got = warp.pdf(&[x]);
                assert!(got > 0);
                let due = (-f64::from(x) / mean).exp() * peak;
                observe((got.to_num::<f64>() - due).abs() / peak);
            }
        });
        worst = worst.max(figures.max);
    }
    worst
}

fn round_trip(new: New) -> f64 {
    let mut worst: f64 = 0.0;
    for set in SETS {
        let warp = new(set);
        let figures = over_words(200_003, |w, observe| {
            let back = warp.invert(&warp.sample(&[w]))[0];
            observe((f64::from(back) - f64::from(w)) * WORD);
        });
        worst = worst.max(figures.max);
    }
    worst
}

#[test]
fn the_truncated_exponential_keeps_its_stated_errors() {
    let mut rows = sample_rows(NEW.map(sample_error)).to_vec();
    rows.push(("pdf", NEW.map(pdf_error)));
    rows.push(("round trip", NEW.map(round_trip)));
    hold("TruncatedExponential", &rows);
}

/// Extreme parameters: samples below the length, in order of their size but for the error, of positive density.
fn holds_at<Frac: LeEqU32, G: Grade>(set: [u32; 2]) {
    let (warp, [mean, length]) = (parameters::<Frac, G>(set), set.map(f64::from));
    let (z, unit) = (length / mean, mean.min(length));
    for k in 0..2048_u32 {
        for w in [k, !k, k << 21, !(k << 21)] {
            let x = warp.sample(U0F32::from_bits(w));
            let steps = f64::from(x.to_bits());
            assert!(steps < length, "{set:?} {w:#x}");
            let error = beyond(steps / mean, w, z, 1.0 / mean) * mean;
            assert!(
                error <= 1.3e-4 * unit,
                "{set:?} {w:#x}: {steps}, off by {error}"
            );
            assert!(warp.pdf(x) > 0, "{set:?} {w:#x}");
            let _ = warp.invert(x);
        }
    }
    for outside in [set[1], u32::MAX] {
        assert_eq!(warp.pdf(FixedU32::from_bits(outside)), 0);
        let last = warp.invert(FixedU32::from_bits(set[1] - 1));
        assert_eq!(warp.invert(FixedU32::from_bits(outside)), last);
    }
    assert_eq!(warp.sample(U0F32::ZERO), 0);
    assert_eq!(warp.invert(FixedU32::ZERO), 0);
}

#[test]
fn no_sample_reaches_the_length_whatever_the_parameters() {
    let extremes = [
        1,
        2,
        3,
        5,
        100,
        65_537,
        1 << 27,
        0x5555_5555,
        1 << 31,
        u32::MAX - 1,
        u32::MAX,
    ];
    for mean in extremes {
        for length in extremes {
            holds_at::<U0, Fine>([mean, length]);
            holds_at::<U16, Coarse>([mean, length]);
            holds_at::<U32, Compact>([mean, length]);
        }
    }
}

#[test]
fn a_long_mean_gives_the_uniform_distribution() {
    let warp = parameters::<U16, Fine>([u32::MAX, 1000]);
    for w in (0..=u32::MAX).step_by(65_537) {
        let due = (u64::from(w) * 1000) >> 32;
        let got = u64::from(warp.sample(U0F32::from_bits(w)).to_bits());
        assert!(got == due || got + 1 == due, "{w:#x}");
    }
    let density = warp.pdf(U16F16::ZERO).to_num::<f64>();
    assert!((density - 65.536).abs() < 1e-4, "{density}");
}

#[test]
fn a_mean_or_a_length_of_0_is_refused() {
    let new = |mean, length| {
        TruncatedExponential::<U16, Fine>::from_mean(
            U16F16::from_bits(mean),
            U16F16::from_bits(length),
        )
    };
    for (mean, length) in [(0, 0), (0, 1), (1, 0), (u32::MAX, 0), (0, u32::MAX)] {
        assert_eq!(
            new(mean, length),
            Err(Error::NotPositive(usize::from(mean > 0)))
        );
    }
    const CHECKED: Result<TruncatedExponential<U16, Fine>, Error> =
        TruncatedExponential::from_mean(U16F16::from_bits(1 << 16), U16F16::from_bits(1));
    assert_eq!(CHECKED.unwrap().sample(U0F32::MAX), 0);
}
