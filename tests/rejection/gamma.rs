//! `Gamma`: what each word proposes, and how many decisions accept it, beside the formulas in `f64`; its logarithms
//! and its refusals. What all words have together is in `gamma_law.rs`.

use host::docs::Doc;
use host::errors::raise;
use host::speed;
use host::truth::normal_quantile_lower;
use host::words::first_without;
use microwarp::rejection::{Gamma, Rejection};
use microwarp::tier::{Libm, Poly, Tier};
use microwarp::{Error, poly};
use rand_pcg::Pcg32;
use rand_pcg::rand_core::Rng;

/// What the page grants: of a proposal, of the root's exponent, of a logarithm, and of acceptance.
const PROPOSED: f64 = 6e-7;
const ROOT: f64 = 3e-7;
const LOG: f64 = 5.5e-7;
const ACCEPTED: f64 = 2.8e-6;

/// The middle of a word's cell, and its complement.
fn uniform(word: u32) -> f64 {
    (f64::from(word) + 0.5) / 4_294_967_296.0
}

pub fn normal(word: u32) -> f64 {
    if word < 1 << 31 {
        normal_quantile_lower(uniform(word))
    } else {
        -normal_quantile_lower(uniform(!word))
    }
}

/// What Marsaglia and Tsang's method makes of a normal number: w, the number, and the probability with which it is accepted.
pub fn proposal(shape: f64, z: f64) -> (f64, f64, f64) {
    let depth = if shape < 1.0 { shape + 1.0 } else { shape } - 1.0 / 3.0;
    let w = z / (9.0 * depth).sqrt();
    if w <= -1.0 {
        return (w, 0.0, 0.0);
    }
    let exponent = if w.abs() < 0.1 {
        let terms = (0..20).rev();
        let series = terms.fold(0.0, |sum, n| 1.0 / f64::from(n + 4) - w * sum);
        3.0 * depth * w.powi(4) * series
    } else {
        3.0 * depth * (w - w * w / 2.0 + w.powi(3) / 3.0 - w.ln_1p())
    };
    (w, depth * (1.0 + w).powi(3), (-exponent).exp())
}

/// Shapes of every size.
pub fn shapes(number: u32) -> impl Iterator<Item = f32> {
    let known = [
        1e-30,
        1e-3,
        0.1,
        0.5,
        0.999_999_94,
        1.000_000_1,
        1.5,
        2.5,
        10.0,
        1e3,
        1e6,
    ];
    let spread = (0..number).map(move |i| {
        let part = (f64::from(i) + 0.377) / f64::from(number);
        let exponent = if i % 3 == 0 {
            36.0 * part - 30.0
        } else {
            6.5 * part - 0.5
        };
        10_f64.powf(exponent) as f32
    });
    known.into_iter().chain(spread)
}

/// Random words, and those where the forms change.
pub fn words(number: u32, seed: u64) -> Vec<u32> {
    let mut rng = Pcg32::new(seed, 35);
    let mut words = vec![0, 1, 2, u32::MAX, u32::MAX - 1, 1 << 31, (1 << 31) - 1];
    for i in 0..number {
        let word = rng.next_u32() >> if i % 2 == 0 { 0 } else { rng.next_u32() & 31 };
        words.push(if i % 4 < 2 { word } else { !word });
    }
    words
}

pub fn page() -> String {
    let text = Doc::find("rejection", "Gamma").unwrap().text();
    text.replace("\n/// ", " ")
}

#[test]
fn every_word_proposes_the_number_of_the_formula() {
    fn worst<T: Tier>(
        shapes: impl Iterator<Item = f32>,
        number: u32,
    ) -> ([f64; 3], [(f32, u32); 3]) {
        let (mut worst, mut at) = ([0.0; 3], [(0.0, 0); 3]);
        for (shape, seed) in shapes.zip(1..) {
            let scale = 0.7_f32;
            let sampler = Gamma::<T>::new(shape, scale).unwrap();
            for (word, &third) in words(number, seed)
                .into_iter()
                .zip(&words(number, seed + 1))
            {
                let (w, number, probability) = proposal(shape.into(), normal(word));
                if probability < 2_f64.powi(-30) {
                    continue;
                }
                let less = if shape < 1.0 {
                    -uniform(third).ln() / f64::from(shape)
                } else {
                    0.0
                };
                let bent = 1.0 + 3.0 * (w / (1.0 + w)).abs();
                let given = [word, 0, third];
                let ln = number.ln() + f64::from(scale).ln() - less;
                let (exact, got) = (ln.exp(), f64::from(sampler.attempt(given).unwrap()));
                let granted = exact * (PROPOSED * bent + ROOT * less);
                let error = (got - exact).abs() / (granted + 1.01 * 2_f64.powi(-149));
                let got = f64::from(sampler.attempt_ln(given).unwrap());
                let granted =
                    PROPOSED * bent + LOG * (1.0 + ln.abs() + f64::from(scale).ln().abs());
                let off = (got - ln).abs() / granted;
                let share = |decision| sampler.attempt([word, decision as u32, third]).is_some();
                let accepted = first_without(0..1 << 32, share) as f64 / 4_294_967_296.0;
                let missed =
                    ((accepted - probability).abs() - 2_f64.powi(-33)).max(0.0) / probability;
                let missed = missed / (ACCEPTED * bent);
                for (k, e) in [error, off, missed].into_iter().enumerate() {
                    if raise(&mut worst[k], e) {
                        at[k] = (shape, word);
                    }
                }
            }
        }
        (worst, at)
    }
    let number = speed::of("shapes of proposals", 30, 300);
    let each = speed::of("words of a shape", 100, 2000);
    let text = page();
    assert!(text.contains(
        "relative error of 6e-7 (1 + 3|w/(1 + w)|) + 3e-7 e, plus an absolute one of 2⁻¹⁴⁹"
    ));
    assert!(
        text.contains("relative error of 2.8e-6 (1 + 3|w/(1 + w)|), plus an absolute one of 2⁻³³")
    );
    assert!(
        text.contains("absolute error of 6e-7 (1 + 3|w/(1 + w)|) + 5.5e-7 (1 + |ln x| + |ln θ|)")
    );
    for (worst, at) in [
        worst::<Poly>(shapes(number), each),
        worst::<Libm>(shapes(number / 3), each),
    ] {
        println!("number, logarithm, acceptance: {worst:.3?} of the bounds at {at:?}");
        assert!(worst.iter().all(|worst| *worst <= 1.0));
    }
}

/// At shape 1 a word gives the exponential distribution.
#[test]
fn shape_1_takes_one_word() {
    let sampler = poly::Gamma::new(1.0, 0.7).unwrap();
    for word in words(1000, 1) {
        let exact = -f64::from(0.7_f32) * uniform(!word).ln();
        let x = f64::from(sampler.attempt([word, word, word]).unwrap());
        assert!((x / exact - 1.0).abs() <= PROPOSED, "{word}");
        let ln = f64::from(sampler.attempt_ln([word, 0, 0]).unwrap());
        let granted = PROPOSED + LOG * (1.0 + exact.ln().abs() + 0.36);
        assert!((ln - exact.ln()).abs() <= granted, "{word}");
    }
    let (mut rng, mut once) = (Pcg32::new(1, 1), Pcg32::new(1, 1));
    let drawn = sampler.draw(&mut rng).unwrap();
    assert_eq!(Some(drawn.point), sampler.attempt([once.next_u32(), 0, 0]));
    assert_eq!((rng, drawn.tries), (once, 1));
}

#[test]
fn parameters_out_of_range_are_refused() {
    for (shape, scale, error) in [
        (f32::NAN, 1.0, Error::NotFinite(0)),
        (f32::INFINITY, 1.0, Error::NotFinite(0)),
        (1.0, f32::NAN, Error::NotFinite(1)),
        (1.0, f32::INFINITY, Error::NotFinite(1)),
        (0.0, 1.0, Error::NotPositive(0)),
        (-1.0, 1.0, Error::NotPositive(0)),
        (1.0, 0.0, Error::NotPositive(1)),
        (1.0, -0.0, Error::NotPositive(1)),
        (1.0, -2.0, Error::NotPositive(1)),
        (0.99e-30, 1.0, Error::OutOfRange(0)),
        (1_000_000.1, 1.0, Error::OutOfRange(0)),
        (2.0, 2.3e-38, Error::Empty(1)),
        (2.0, 1e38, Error::TooLarge(1)),
        (1e6, 3.4e32, Error::TooLarge(1)),
    ] {
        assert_eq!(
            poly::Gamma::new(shape, scale),
            Err(error),
            "{shape} {scale}"
        );
    }
    let sampler = poly::Gamma::chi_squared(5.0).unwrap();
    assert_eq!((sampler.shape(), sampler.scale()), (2.5, 2.0));
    assert_eq!(poly::Gamma::chi_squared(0.0), Err(Error::NotPositive(0)));
    assert_eq!(poly::Gamma::chi_squared(3e6), Err(Error::OutOfRange(0)));
    assert_eq!(sampler.budget(), poly::Gamma::BUDGET);
    assert_eq!(sampler.with_budget(0), Err(Error::NotPositive(0)));
    assert_eq!(
        [f32::NAN, -1e-30, f32::INFINITY].map(|x| sampler.pdf(x)),
        [0.0; 3]
    );
}

/// At the largest scale that a shape accepts, the furthest proposal is finite, and not far below the largest number.
#[test]
fn no_accepted_scale_overflows() {
    for shape in shapes(speed::of("shapes of largest scales", 100, 1000)) {
        let accepts = |bits: u64| poly::Gamma::new(shape, f32::from_bits(bits as u32)).is_ok();
        let [one, end] = [1.0, f32::INFINITY].map(|x: f32| u64::from(x.to_bits()));
        let scale = f32::from_bits(first_without(one..end, accepts) as u32 - 1);
        let sampler = poly::Gamma::new(shape, scale).unwrap();
        let furthest = [0, u32::MAX].map(|place| sampler.attempt([place, 0, u32::MAX]));
        let largest = furthest.into_iter().flatten().fold(0.0, f32::max);
        assert!(largest.is_finite(), "{shape} {scale:e}");
        // Of the smallest shapes even the last word makes a number small.
        assert!(
            shape < 0.1 || largest >= 0.4 * f32::MAX,
            "{shape} {scale:e}: {largest:e}"
        );
    }
}
