//! `VonMises`: every proposed angle is accepted with its probability, counted over all decisions; its angles, its efficiency, its
//! density and its refusals.

use crate::law::EDGES;
use host::docs::Doc;
use host::errors::or_infinite;
use host::speed;
use host::words::first_without;
use microwarp::rejection::{Rejection, VonMises};
use microwarp::tier::{Libm, Poly, Tier};
use microwarp::{Error, poly};
use rand_pcg::Pcg32;
use std::f32::consts::PI as HALF;
use std::f64::consts::{PI, TAU};

/// The law of a concentration, and the wrapped Cauchy that proposes.
struct Truth {
    k: f64,
    /// The density at the mean.
    peak: f64,
    /// The tangent of half a proposed angle, over that of a uniform one.
    tangent: f64,
}

impl Truth {
    fn new(concentration: f32) -> Self {
        let k = f64::from(concentration);
        // e^(−κ(1 − cos)) over the half circle: the trapezoids of a periodic function, or Gauss's integral.
        let width = PI.min(12.0 / k.sqrt());
        let steps = 4000;
        let each = width / f64::from(steps);
        let at = |i: i32| (-2.0 * k * (0.5 * each * f64::from(i)).sin().powi(2)).exp();
        let inner: f64 = (1..steps).map(at).sum();
        let half = each * (inner + 0.5 * (at(0) + at(steps)));
        let root = (1.0 + 4.0 * k * k).sqrt();
        let t = 1.0 + root;
        let b = t + (2.0 * t).sqrt();
        // 1 − ρ of Best and Fisher, as a sum.
        let short = (1.0 + 1.0 / (root + 2.0 * k) + (2.0 * t).sqrt()) / b;
        Self {
            k,
            peak: 0.5 / half,
            tangent: short / (2.0 - short),
        }
    }

    /// What is in the exponent at an angle from the mean.
    fn decay(&self, angle: f64) -> f64 {
        2.0 * self.k * (0.5 * angle).sin().powi(2)
    }

    fn pdf(&self, angle: f64) -> f64 {
        self.peak * (-self.decay(angle)).exp()
    }

    /// The angle of the middle of a word, and how fast it grows with the word's uniform.
    fn proposed(&self, word: u32) -> [f64; 2] {
        let turn = PI * ((f64::from(word) + 0.5) / 2_f64.powi(32) - 0.5);
        let (s, c) = turn.sin_cos();
        let across = self.tangent * s;
        let slope = TAU * self.tangent / (across * across + c * c);
        [2.0 * across.atan2(c), slope]
    }

    /// How many angles of the mean 0 are tried a side; the efficiency, and the largest error of an acceptance, of an angle and of
    /// a density, in units of what the page grants.
    fn judge(
        &self,
        places: u32,
        attempt: &dyn Fn([u32; 2]) -> Option<f32>,
        pdf: &dyn Fn(f32) -> f32,
    ) -> [f64; 4] {
        let page = Doc::find("rejection", "VonMises").unwrap().text();
        for granted in [
            "relative error of 1e-5, where its density is above 1e-3 of the peak",
            "an error of 1.1e-6 of its distance from the mean",
            "a relative error of 9e-7 (1 + L), or an absolute one of 2⁻¹⁴⁸; about a mean beyond ±π",
            "and of 4e-7 rad more",
        ] {
            assert!(page.contains(granted), "{granted}");
        }
        let (mut angles, mut densities) = (0.0_f64, 0.0_f64);
        let (mut all, mut likeliest, mut ratios) = (0.0, 0.0_f64, Vec::new());
        for i in 0..places {
            let word = ((u64::from(i) << 32 | 1 << 31) / u64::from(places)) as u32;
            let [exact, slope] = self.proposed(word);
            // The first decision that rejects.
            let accepts = |decision| attempt([word, decision as u32]).is_some();
            let rejects = first_without(0..1 << 32, accepts);
            let share = rejects as f64 / 2_f64.powi(32);
            all += share / f64::from(places);
            likeliest = likeliest.max(share);
            let Some(angle) = attempt([word, 0]) else {
                continue;
            };
            let error = (f64::from(angle) - exact).abs() / exact.abs();
            angles = angles.max(or_infinite(error / 1.1e-6));
            let decay = self.decay(angle.into());
            let due = self.pdf(angle.into());
            let error = (f64::from(pdf(angle)) - due).abs();
            let bound = (9e-7 * (1.0 + decay) * due).max(2_f64.powi(-148));
            densities = densities.max(or_infinite(error / bound));
            // Accepted is a constant part of density times slope.
            if self.decay(exact) < 1e3_f64.ln() {
                ratios.push(share / (self.pdf(exact) * slope));
            }
        }
        // Of all angles together, the efficiency.
        let acceptances = ratios.iter().map(|ratio| (ratio / all - 1.0).abs() / 1e-5);
        let worst = acceptances.fold(0.0, |worst: f64, e| worst.max(or_infinite(e)));
        // The likeliest angle is always accepted.
        assert!((0.999..=1.0).contains(&likeliest), "{likeliest}");
        [all, worst, angles, densities]
    }
}

fn judged<T: Tier>(concentration: f32, places: u32) -> [f64; 4] {
    let sampler = VonMises::<T>::new(0.0, concentration).unwrap();
    Truth::new(concentration).judge(places, &|words| sampler.attempt(words), &|x| sampler.pdf(x))
}

#[test]
fn angles_are_accepted_with_their_probability() {
    fn in_tier<T: Tier>(number: u32, places: u32) {
        let special = [
            0.0, 1e-30, 1e-8, 0.5, 1.0, 11.999_999, 12.0, 9.9e8, 1.01e9, 1e30,
        ];
        let drawn = (0..number).map(|i| {
            let part = (f64::from(i) * 0.618_034).fract();
            10_f64.powf(if i % 3 == 0 {
                60.0 * part - 30.0
            } else {
                4.0 * part - 1.0
            }) as f32
        });
        let mut worst = [0.0_f64; 3];
        for concentration in special.into_iter().chain(drawn) {
            let [efficiency, errors @ ..] = judged::<T>(concentration, places);
            assert!((0.657..=1.0).contains(&efficiency), "{concentration:e}");
            // The default budget.
            assert!((1.0 - efficiency).powi(42) < 2_f64.powi(-64));
            assert!(
                errors.iter().all(|e| *e <= 1.0),
                "{concentration:e}: {errors:?}"
            );
            for (worst, error) in worst.iter_mut().zip(errors) {
                *worst = worst.max(error);
            }
        }
        println!("{}: {worst:.3?} of the bounds", T::NAME);
    }
    let number = speed::of("concentrations of von Mises", 12, 150);
    let places = speed::of("angles of each", 1024, 8192);
    in_tier::<Poly>(number, places);
    in_tier::<Libm>(number / 3, places);
}

/// Angles stay on the circle and increase about the mean; the density is that of the distance on the circle.
#[test]
fn angles_are_wrapped_to_a_turn_about_zero() {
    let mut rng = Pcg32::new(35, 1);
    for mean in [
        0.0,
        1.0,
        -3.0,
        HALF,
        -HALF,
        5.0,
        -6.283_185_5,
        6.283_185_5_f32,
    ] {
        for concentration in [0.0, 1e-30, 0.3, 7.0, 1e6, 1e30] {
            let sampler = poly::VonMises::new(mean, concentration).unwrap();
            let centred = poly::VonMises::new(0.0, concentration).unwrap();
            let truth = Truth::new(concentration);
            let sound = |x: f32| (-HALF..=HALF).contains(&x);
            for pair in EDGES.into_iter().flat_map(|a| EDGES.map(|b| [a, b])) {
                let found = sampler.attempt(pair);
                assert!(
                    found.is_none_or(|x| sound(x) && sampler.pdf(x) > 0.0),
                    "{pair:?}: {found:?}"
                );
            }
            for i in 0..256_u32 {
                let pair = [(i << 24) | (1 << 23), 0];
                let (Some(x), Some(away)) = (sampler.attempt(pair), centred.attempt(pair)) else {
                    continue;
                };
                let off = f64::from(mean) + f64::from(away) - f64::from(x);
                let off = off - TAU * (off / TAU).round();
                assert!(off.abs() <= 4e-7, "{mean}, {concentration:e}: {off:e}");
                let distance = f64::from(x) - f64::from(mean);
                let (decay, due) = (truth.decay(distance), truth.pdf(distance));
                let error = (f64::from(sampler.pdf(x)) - due).abs();
                // Beyond half a turn the distance is off as well.
                let off = if mean.abs() > HALF { 1e-14 } else { 0.0 };
                let away = (distance - TAU * (distance / TAU).round()).abs();
                let nearest = truth.pdf((away - off).max(0.0)) - due;
                let bound = 9e-7 * (1.0 + decay) * due + nearest.max(due - truth.pdf(away + off));
                assert!(
                    error <= bound.max(2_f64.powi(-148)),
                    "{mean}, {concentration:e} at {x}"
                );
            }
            for _ in 0..100 {
                let x = sampler.draw(&mut rng).unwrap().point;
                assert!(sound(x) && sampler.pdf(x) > 0.0);
            }
            let next = f32::from_bits(HALF.to_bits() + 1);
            for outside in [next, -next, f32::INFINITY, f32::NAN] {
                assert_eq!(sampler.pdf(outside), 0.0);
            }
        }
    }
    let sampler = poly::VonMises::new(0.0, 3.0).unwrap();
    let angles = (0..4096_u32).filter_map(|i| sampler.attempt([i << 20, 0]));
    assert!(angles.collect::<Vec<_>>().is_sorted());
}

/// Another concentration, an angle that is accepted too often, and a density that is slightly off.
#[test]
fn wrong_angles_are_noticed() {
    for concentration in [0.5, 4.0, 1e6_f32] {
        let sampler = poly::VonMises::new(0.0, concentration).unwrap();
        let truth = Truth::new(concentration);
        let judge = |attempt: &dyn Fn([u32; 2]) -> Option<f32>, by: f32| {
            truth.judge(512, attempt, &|x| by * sampler.pdf(x))
        };
        let right = judge(&|words| sampler.attempt(words), 1.0);
        assert!(right[1..].iter().all(|e| *e <= 1.0), "{right:?}");
        let other = poly::VonMises::new(0.0, 1.0001 * concentration).unwrap();
        // A large one scales its angles alone.
        let found = judge(&|words| other.attempt(words), 1.0);
        assert!(found[1].max(found[2]) > 2.0, "{found:?}");
        assert!(judge(&|[a, b]| sampler.attempt([a, b - (b >> 12)]), 1.0)[1] > 2.0);
        assert!(judge(&|[a, b]| sampler.attempt([a ^ 1 << 12, b]), 1.0)[2] > 2.0);
        assert!(judge(&|words| sampler.attempt(words), 1.000_003)[3] > 2.0);
    }
}

#[test]
fn concentrations_out_of_range_are_refused() {
    for (mean, concentration, error) in [
        (f32::NAN, 1.0, Error::NotFinite(0)),
        (f32::INFINITY, 1.0, Error::NotFinite(0)),
        (0.0, f32::NAN, Error::NotFinite(1)),
        (0.0, f32::INFINITY, Error::NotFinite(1)),
        (0.0, -1.0, Error::Negative(1)),
        (0.0, -1e-40, Error::Negative(1)),
        (0.0, 0.9e-30, Error::OutOfRange(1)),
        (0.0, 1.1e30, Error::OutOfRange(1)),
        (6.283_186, 1.0, Error::OutOfRange(0)),
        (-6.283_186, 1.0, Error::OutOfRange(0)),
    ] {
        assert_eq!(poly::VonMises::new(mean, concentration), Err(error));
    }
    let sampler = poly::VonMises::new(1.5, 0.0).unwrap();
    assert_eq!((sampler.mean(), sampler.concentration()), (1.5, 0.0));
    assert_eq!(poly::VonMises::new(1.5, -0.0).unwrap().concentration(), 0.0);
    assert_eq!(sampler.budget(), poly::VonMises::BUDGET);
    assert_eq!(sampler.with_budget(0), Err(Error::NotPositive(0)));
    assert_eq!(sampler.with_budget(3).unwrap().budget(), 3);
}
