//! The tent.

use super::figures::{Figures, WORD, hold, over_words, sample_rows};
use fixed::FixedI32;
use fixed::types::extra::{LeEqU32, U0, U16, U30, U32};
use fixed::types::{I2F30, I16F16, U0F32};
use microwarp::fixed::warp::Tent;
use microwarp::fixed::{Coarse, Compact, Fine, Grade};
use microwarp::{Error, Invert, Warp};

/// In radii.
fn truth(w: u32) -> f64 {
    let u = f64::from(w) * WORD;
    if u < 0.5 {
        (2.0 * u).sqrt() - 1.0
    } else {
        1.0 - (2.0 - 2.0 * u).sqrt()
    }
}

/// Of a radius that is the largest of its format, so that its step counts for nothing.
fn largest<G: Grade>() -> Tent<U30, G> {
    Tent::new(I2F30::MAX).unwrap()
}

fn sample_error<G: Grade>() -> Figures {
    let warp = largest::<G>();
    let radius = I2F30::MAX.to_num::<f64>();
    over_words(509, |w, observe| {
        let x = warp.sample(U0F32::from_bits(w));
        assert!(x.to_bits().unsigned_abs() < I2F30::MAX.to_bits() as u32);
        observe(x.to_num::<f64>() / radius - truth(w));
    })
}

fn round_trip<G: Grade>() -> Figures {
    let warp = largest::<G>();
    over_words(2003, |w, observe| {
        let back = warp.invert(warp.sample(U0F32::from_bits(w)));
        observe((f64::from(back.to_bits()) - f64::from(w)) * WORD);
    })
}

#[test]
fn the_tent_keeps_its_stated_errors() {
    let samples = [
        sample_error::<Fine>(),
        sample_error::<Coarse>(),
        sample_error::<Compact>(),
    ];
    let back = [
        round_trip::<Fine>(),
        round_trip::<Coarse>(),
        round_trip::<Compact>(),
    ];
    let mut rows = sample_rows(samples).to_vec();
    rows.push(("round trip", back.map(|f| f.max)));
    hold("Tent", &rows);
}

fn is_inside_and_true<Frac: LeEqU32>(radius: i32, error: f64) {
    let bits = FixedI32::<Frac>::from_bits;
    let warp = Tent::<Frac, Fine>::new(bits(radius)).unwrap();
    let one = 2_f64.powi(Frac::U32 as i32);
    let scale = f64::from(radius);
    for k in 0..1_u32 << 16 {
        for w in [k, !k, k << 16, !(k << 16), (1 << 31) - k, (1 << 31) + k] {
            let x = warp.sample(U0F32::from_bits(w));
            let raw = f64::from(x.to_bits());
            assert!(raw.abs() < scale);
            assert!(
                (raw - truth(w) * scale).abs() <= 1.0 + error * scale,
                "{radius} {w:#x}"
            );
            let due = ((scale - raw.abs()) / scale / scale * one).min(4_294_967_296.0);
            let got = warp.pdf(x);
            assert!(got > 0);
            let got = got.to_num::<f64>();
            assert!(
                (got - due).abs() <= WORD + 4.0 * WORD * one / scale,
                "{radius} {x}: {got} for {due}"
            );
            let back = f64::from(warp.invert(x).to_bits()) * WORD;
            let off = (back - f64::from(w) * WORD).abs();
            assert!(off <= 1.0 / scale + 2.0 * error, "{radius} {w:#x}: {back}");
        }
    }
}

#[test]
fn a_sample_is_inside_and_its_density_above_0_in_every_format() {
    for radius in [1, 2, 3, 100, 65_536, 0x1234_5678, i32::MAX] {
        is_inside_and_true::<U0>(radius, 1e-6);
        is_inside_and_true::<U16>(radius, 1e-6);
        is_inside_and_true::<U32>(radius, 1e-6);
    }
}

#[test]
fn the_tent_rises_to_the_middle_and_ends_at_the_radius() {
    let warp = Tent::<U16, Fine>::new(I16F16::from_num(2)).unwrap();
    assert_eq!(warp.sample(U0F32::from_num(0.5)), 0);
    assert_eq!(warp.pdf(I16F16::ZERO), 0.5);
    assert_eq!(warp.pdf(I16F16::from_num(1)), 0.25);
    for end in [
        I16F16::from_num(2),
        I16F16::from_num(-2),
        I16F16::MIN,
        I16F16::MAX,
    ] {
        assert_eq!(warp.pdf(end), 0);
    }
    assert_eq!(warp.invert(I16F16::MIN), 0);
    let middle = warp.invert(I16F16::ZERO).to_num::<f64>();
    assert!((middle - 0.5).abs() <= 2.0 * WORD, "{middle}");
    assert_eq!(warp.sample(U0F32::ZERO).to_bits(), -(2 << 16) + 1);
    assert!(warp.sample(U0F32::MAX).to_num::<f64>() > 1.9999);
    // The root of the last word is that of a word, 2·2⁻³², and not of 0.
    let last = largest::<Fine>().sample(U0F32::MAX).to_num::<f64>() / 2.0;
    assert!((last - truth(u32::MAX)).abs() < 1e-9, "{last}");
}

#[test]
fn a_radius_of_0_or_less_is_refused() {
    for radius in [0, -1, i32::MIN] {
        let refused = Tent::<U16, Fine>::new(I16F16::from_bits(radius));
        assert_eq!(refused, Err(Error::NotPositive(0)));
    }
    const CHECKED: Result<Tent<U16, Fine>, Error> = Tent::new(I16F16::from_bits(1));
    assert_eq!(CHECKED.unwrap().sample(U0F32::ZERO), 0);
}
