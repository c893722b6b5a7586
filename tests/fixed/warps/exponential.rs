//! The exponential distributions.

use super::figures::{Figures, WORD, hold, over_words, sample_rows};
use fixed::FixedU32;
use fixed::types::extra::{LeEqU32, U0, U8, U16, U27, U32};
use fixed::types::{U0F32, U5F27, U16F16, U32F0};
use microwarp::fixed::warp::{Exponential, StandardExponential};
use microwarp::fixed::{Coarse, Compact, Fine, Grade};
use microwarp::{Error, Invert, Warp};

fn word(w: u32) -> U0F32 {
    U0F32::from_bits(w)
}

fn sample_error<G: Grade>() -> Figures {
    let warp = StandardExponential::<G>::new();
    over_words(509, |w, observe| {
        let truth = -(-f64::from(w) * WORD).ln_1p();
        observe(warp.sample(word(w)).to_num::<f64>() - truth);
    })
}

/// At every length there is, by steps.
fn pdf_error<G: Grade>() -> Figures {
    let warp = StandardExponential::<G>::new();
    over_words(2003, |w, observe| {
        let x = U5F27::from_bits(w);
        observe(warp.pdf(x).to_num::<f64>() - (-x.to_num::<f64>()).exp());
    })
}

fn round_trip<G: Grade>() -> Figures {
    let warp = StandardExponential::<G>::new();
    over_words(2003, |w, observe| {
        let back = warp.invert(warp.sample(word(w)));
        observe(f64::from(back.to_bits()) * WORD - f64::from(w) * WORD);
    })
}

#[test]
fn the_standard_exponential_keeps_its_stated_errors() {
    let samples = [
        sample_error::<Fine>(),
        sample_error::<Coarse>(),
        sample_error::<Compact>(),
    ];
    let pdf = [
        pdf_error::<Fine>(),
        pdf_error::<Coarse>(),
        pdf_error::<Compact>(),
    ];
    let back = [
        round_trip::<Fine>(),
        round_trip::<Coarse>(),
        round_trip::<Compact>(),
    ];
    let mut rows = sample_rows(samples).to_vec();
    rows.push(("pdf", pdf.map(|f| f.max)));
    rows.push(("round trip", back.map(|f| f.max)));
    hold("StandardExponential", &rows);
}

fn edges_of<G: Grade>() {
    let warp = StandardExponential::<G>::new();
    assert_eq!(warp.sample(word(0)), 0);
    // 32 ln 2, to what a word is there.
    let last = warp.sample(word(u32::MAX)).to_num::<f64>();
    assert!((last - 22.180_709_777_918_25).abs() < 1e-4, "{last}");
    assert!(warp.pdf(U5F27::from_bits(u32::MAX)) > 0);
    assert_eq!(warp.invert(U5F27::ZERO), 0);
    assert!(warp.invert(U5F27::MAX) > U0F32::from_num(0.999_999_9));
}

#[test]
fn the_standard_exponential_is_0_at_0_and_22_18_at_the_last_word() {
    edges_of::<Fine>();
    edges_of::<Coarse>();
    edges_of::<Compact>();
}

/// Each sample is the standard one times the mean, cut, by long integers.
fn product_is_exact<Frac: LeEqU32 + Sync, G: Grade>(mean: u32) {
    let warp = Exponential::<Frac, G>::from_mean(FixedU32::from_bits(mean)).unwrap();
    let standard = StandardExponential::<G>::new();
    for k in 0..1_u32 << 16 {
        for w in [k, !k, k << 16, !(k << 16), k.wrapping_mul(0x9e37_79b9)] {
            let product = u64::from(standard.sample(word(w)).to_bits()) * u64::from(mean);
            let got = warp.sample(word(w)).to_bits();
            assert_eq!(u64::from(got), product >> 27, "{mean} {w:#x}");
        }
    }
}

/// The largest mean whose 22.19-fold fits 32 bits.
const LARGEST: u32 = (((1_u64 << 32) - 1) * 100 / 2219) as u32;

#[test]
fn a_sample_is_the_standard_one_times_the_mean_cut_to_its_step() {
    for mean in [1, 2, 3, 1000, 65_536, 0x1234_5678, 1 << 27, LARGEST]
        .into_iter()
        .filter(|m| *m <= LARGEST)
    {
        product_is_exact::<U16, Fine>(mean);
        product_is_exact::<U0, Coarse>(mean);
        product_is_exact::<U27, Compact>(mean);
        product_is_exact::<U32, Fine>(mean);
    }
}

fn density_is_true<Frac: LeEqU32, G: Grade>(mean: u32, of_peak: f64) {
    let m = FixedU32::<Frac>::from_bits(mean);
    let warp = Exponential::<Frac, G>::from_mean(m).unwrap();
    let step = 2_f64.powi(-(Frac::U32 as i32));
    let (mean, peak) = (f64::from(mean) * step, 1.0 / (f64::from(mean) * step));
    for k in 0..4096_u32 {
        let w = k << 20 | k;
        let x = warp.sample(word(w));
        for x in [
            x,
            FixedU32::from_bits(x.to_bits() / 2),
            FixedU32::from_bits(w),
        ] {
            let means = f64::from(x.to_bits()) * step / mean;
            let truth = ((-means).exp() * peak).min(4_294_967_296.0 - WORD);
            let got = warp.pdf(x);
            assert!(got > 0);
            let error = (got.to_num::<f64>() - truth).abs();
            assert!(
                error <= of_peak * peak + WORD,
                "{mean} {x:?}: {got} for {truth}"
            );
        }
    }
}

#[test]
fn a_density_is_right_to_the_grade_and_a_step() {
    for mean in [1, 3, 1000, 65_536, 0x0123_4567, LARGEST] {
        density_is_true::<U0, Fine>(mean, 1.5e-6);
        density_is_true::<U16, Compact>(mean, 1e-6);
        density_is_true::<U32, Coarse>(mean, 1.2e-4);
        density_is_true::<U8, Fine>(mean, 1.5e-6);
    }
}

#[test]
fn the_inverse_gives_the_uniform_back_to_the_step_of_the_format() {
    for mean in [16_u32, 1000, 65_536, 0x0123_4567, LARGEST] {
        let warp = Exponential::<U16, Fine>::from_mean(U16F16::from_bits(mean)).unwrap();
        for k in 0..65_536_u32 {
            let w = k << 16 | k;
            let back = f64::from(warp.invert(warp.sample(word(w))).to_bits());
            let error = (back - f64::from(w)).abs() * WORD;
            // A step of x is at most a step/mean of u.
            assert!(
                error <= 1.6e-6 + 1.0 / f64::from(mean),
                "{mean} {w:#x}: {error}"
            );
        }
    }
}

#[test]
fn a_mean_of_0_or_beyond_the_format_is_refused() {
    type Wide = Exponential<U0, Fine>;
    assert_eq!(
        Wide::from_mean(U32F0::from_bits(0)),
        Err(Error::NotPositive(0))
    );
    assert!(Wide::from_mean(U32F0::from_bits(1)).is_ok());
    assert!(Wide::from_mean(U32F0::from_bits(LARGEST)).is_ok());
    for mean in [LARGEST + 1, 1 << 28, u32::MAX] {
        assert_eq!(
            Wide::from_mean(U32F0::from_bits(mean)),
            Err(Error::TooLarge(0))
        );
    }
    const CHECKED: Result<Exponential<U16, Fine>, Error> =
        Exponential::from_mean(U16F16::from_bits(1 << 16));
    assert!(CHECKED.is_ok());
}
