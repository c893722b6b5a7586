//! `BinomialRejection`: the law that all pairs of words have together, counted and not sampled; its efficiency, its pmf
//! and its refusals.

use crate::law::{EDGES, Masses, assert_laws, assert_within, law, wrong_ones_are_noticed};
use host::docs::Doc;
use host::speed;
use microwarp::rejection::{BinomialRejection, Rejection};
use microwarp::tier::{Libm, Poly, Tier};
use microwarp::{Error, poly};

struct Truth {
    trials: u32,
    mean: f64,
    deviation: f64,
    masses: Masses,
}

impl Truth {
    fn new(trials: u32, p: f32) -> Self {
        let (n, p) = (f64::from(trials), f64::from(p));
        let (mean, deviation, odds) = (n * p, (n * p * (1.0 - p)).sqrt(), p / (1.0 - p));
        let reach = 16.0 * deviation + 256.0;
        let ends = [(mean - reach).max(0.0) as u32, (mean + reach).min(n) as u32];
        let masses = Masses::around(((n + 1.0) * p) as u32, ends, |k| {
            f64::from(trials - k) / (f64::from(k) + 1.0) * odds
        });
        Self {
            trials,
            mean,
            deviation,
            masses,
        }
    }

    /// The efficiency of an attempt, and its largest error in units of the page's.
    fn law(&self, attempt: &impl Fn([u32; 2]) -> Option<u32>) -> [f64; 2] {
        let page = Doc::find("rejection", "BinomialRejection").unwrap().text();
        assert!(page.contains(
            "relative error of 5e-6 + 1e-9 s + 1.3e-8 |k − np|, for |k − np| up to 4.5 s"
        ));
        let bound = |away: f64| 5e-6 + 1e-9 * self.deviation + 1.3e-8 * away.abs();
        law(
            [self.mean, self.deviation],
            [0, self.trials],
            |k| self.masses.pmf(k),
            attempt,
            bound,
        )
    }
}

/// Trials and probabilities of a variance from one to another: p near 0, near 1 and between.
fn laws(from: f64, to: f64, number: u32) -> impl Iterator<Item = (u32, f32)> {
    (0..number).filter_map(move |i| {
        let part = |step: f64| (f64::from(i) * step + 0.377).fract();
        let variance = from * (to / from).powf(part(0.618_034));
        let p = match i % 3 {
            0 => part(0.754_878),
            1 => 0.5 * 1e-8_f64.powf(part(0.569_840)),
            _ => 1.0 - 0.5 * 1e-7_f64.powf(part(0.569_840)),
        } as f32;
        let exact = f64::from(p);
        let trials = (variance / (exact * (1.0 - exact))).ceil();
        (trials <= f64::from(u32::MAX)).then_some((trials as u32, p))
    })
}

#[test]
fn all_pairs_of_words_have_the_binomial_law() {
    fn in_tier<T: Tier>(laws: impl Iterator<Item = (u32, f32)>) {
        let found = laws.filter_map(|(trials, p)| {
            let sampler = BinomialRejection::<T>::new(trials, p).ok()?;
            let law = Truth::new(trials, p).law(&|words| sampler.attempt(words));
            Some((format!("{trials} trials, {p}"), law))
        });
        assert_laws(T::NAME, found);
    }
    let few = speed::of("binomial laws of a variance from 10 to 400", 45, 1000);
    let more = speed::of("binomial laws of a variance above 400", 3, 60);
    let wide: &[(u32, f32)] = speed::of(
        "whether the widest binomial laws are tried",
        &[],
        &[
            (u32::MAX, 0.5),
            (u32::MAX, 0.013),
            (u32::MAX, 0.999_9),
            (50_000_000, 0.3),
        ],
    );
    // The least variances, and those where the hat is lowest.
    let special = [
        (41, 0.5),
        (4_294_967_295, 2.4e-9),
        (11_000, 0.999_08),
        (60_716_805, 1.240_912_4e-6),
    ];
    in_tier::<Poly>(
        special
            .into_iter()
            .chain(laws(10.0, 400.0, few))
            .chain(laws(400.0, 20_000.0, more))
            .chain(wide.iter().copied()),
    );
    in_tier::<Libm>(laws(10.0, 400.0, few / 3));
}

/// Hörmann's constants of 1993 cover the law as well; his hat lowered by 6 % does not.
#[test]
fn a_binomial_hat_that_is_too_low_is_noticed() {
    let number = speed::of("lowered binomial hats", 20, 200);
    let of = |lowered: f64| {
        let errors = laws(10.1, 30.0, number).filter(|&(trials, p)| {
            let sampler = poly::BinomialRejection::new(trials, p).unwrap();
            let truth = Truth::new(trials, p);
            let rare = f64::from(p).min(1.0 - f64::from(p));
            let b = 1.15 + 2.53 * truth.deviation;
            let a = -0.0873 + 0.0248 * b + 0.01 * rare;
            let mode = ((f64::from(trials) + 1.0) * f64::from(p)) as u32;
            let hat = lowered * (2.83 + 5.1 / b) * truth.deviation * f64::from(sampler.pmf(mode));
            let attempt = |[place, decision]: [u32; 2]| {
                let u = (f64::from(place) + 0.5) / 4_294_967_296.0 - 0.5;
                let end = 0.5 - u.abs();
                let turned = if p > 0.5 { -u } else { u };
                let k = ((2.0 * a / end + b) * turned + f64::from(trials) * rare + 0.5).floor();
                let k = if p > 0.5 { f64::from(trials) - k } else { k };
                let k = u32::try_from(k as i64).ok().filter(|k| *k <= trials)?;
                let v = (f64::from(decision) + 0.5) / 4_294_967_296.0;
                (v * hat <= f64::from(sampler.pmf(k)) * (a / (end * end) + b)).then_some(k)
            };
            truth.law(&attempt)[1] > 1.0
        });
        errors.count()
    };
    let noticed = [of(1.0), of(0.94)];
    println!("{noticed:?} of {number}");
    assert!(noticed[0] == 0 && noticed[1] > number as usize / 2);
}

/// Another p, another count, and a squeeze that accepts too much are noticed.
#[test]
fn wrong_laws_of_rejection_are_noticed() {
    let (trials, p) = (300, 0.3);
    let sampler = poly::BinomialRejection::new(trials, p).unwrap();
    let other = poly::BinomialRejection::new(trials, 0.3001).unwrap();
    let truth = Truth::new(trials, p);
    assert!(truth.law(&|words| sampler.attempt(words))[1] <= 1.0);
    wrong_ones_are_noticed(
        |words| sampler.attempt(words),
        |words| other.attempt(words),
        |wrong| truth.law(&wrong)[1],
    );
}

#[test]
fn the_pmf_of_a_large_binomial_is_that_of_the_formula() {
    let page = Doc::find("rejection", "BinomialRejection").unwrap().text();
    assert!(page.contains(
        "a relative error of 5e-7 (1 + L), where L is −ln of it, or an absolute one of 2⁻¹⁴⁸"
    ));
    fn worst<T: Tier>(truth: &Truth, p: f32) -> f64 {
        let sampler = BinomialRejection::<T>::new(truth.trials, p).unwrap();
        truth.masses.worst_pmf(|k| sampler.pmf(k))
    }
    let number = speed::of("binomial laws of the pmf", 60, 2000);
    let mut both = [0.0_f64; 2];
    for (trials, p) in laws(10.1, 1e6, number) {
        let truth = Truth::new(trials, p);
        both[0] = both[0].max(worst::<Poly>(&truth, p));
        both[1] = both[1].max(worst::<Libm>(&truth, p));
    }
    println!("{both:.3?} of the bound");
    assert!(both.iter().all(|w| *w <= 1.0), "{both:?}");
    let sampler = poly::BinomialRejection::new(100, 0.3).unwrap();
    assert_eq!((sampler.pmf(101), sampler.pmf(u32::MAX)), (0.0, 0.0));
    // So far from a large mean that the quotient of both rounds to −1.
    for (trials, p) in [(100_000_000, 0.5), (u32::MAX, 0.5), (u32::MAX, 0.013)] {
        let far = poly::BinomialRejection::new(trials, p).unwrap();
        for k in [0, 1, 2, 60, trials - 60, trials - 2, trials - 1, trials] {
            assert_eq!(far.pmf(k), 0.0, "{trials} {p}: {k}");
        }
    }
    let far = poly::BinomialRejection::new(4_294_961_541, 0.3492).unwrap();
    assert_eq!(far.attempt([0x15dc, u32::MAX]), None);
}

#[test]
fn trials_and_probabilities_out_of_range_are_refused() {
    for (trials, p, error) in [
        (1000, f32::NAN, Error::NotFinite(1)),
        (1000, f32::INFINITY, Error::NotFinite(1)),
        (1000, -0.1, Error::OutOfRange(1)),
        (1000, 1.000_000_1, Error::OutOfRange(1)),
        (u32::MAX, 0.0, Error::OutOfRange(1)),
        (u32::MAX, 1.0, Error::OutOfRange(1)),
        (u32::MAX, 2.3e-9, Error::OutOfRange(1)),
        (39, 0.5, Error::OutOfRange(1)),
        (0, 0.5, Error::OutOfRange(1)),
    ] {
        assert_eq!(
            poly::BinomialRejection::new(trials, p),
            Err(error),
            "{trials}, {p}"
        );
    }
    let sampler = poly::BinomialRejection::new(40, 0.5).unwrap();
    assert_eq!((sampler.trials(), sampler.success()), (40, 0.5));
    assert_eq!(sampler.budget(), poly::BinomialRejection::BUDGET);
    assert_eq!(sampler.with_budget(0), Err(Error::NotPositive(0)));
    assert_eq!(sampler.with_budget(3).unwrap().budget(), 3);
}

/// No pair of words leaves 0 to n, counts increase with the first word, and p and 1 − p are mirror images.
#[test]
fn no_pair_of_words_goes_beyond_the_trials() {
    for (trials, p) in [
        (40, 0.5),
        (2000, 0.01),
        (2000, 0.99),
        (u32::MAX, 0.5),
        (u32::MAX, 2.4e-9),
        (u32::MAX, 0.75),
        (u32::MAX, 0.999_999_9),
    ] {
        let sampler = poly::BinomialRejection::new(trials, p).unwrap();
        let attempt = |words| sampler.attempt(words);
        assert_within(0..=trials, |k| sampler.pmf(k), attempt);
        if p > 0.5 {
            let mirror = poly::BinomialRejection::new(trials, 1.0 - p).unwrap();
            let places = (0..=4096_u32).map(|i| (i << 20).saturating_sub(1));
            for pair in places.chain(EDGES).flat_map(|a| EDGES.map(|b| [a, b])) {
                let other = mirror.attempt([!pair[0], pair[1]]);
                assert_eq!(sampler.attempt(pair), other.map(|k| trials - k));
            }
        }
    }
}
