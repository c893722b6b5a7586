//! `PoissonRejection`: the law that all pairs of words have together, counted and not sampled; its efficiency, its pmf
//! and its refusals.

use host::docs::Doc;
use host::errors::or_infinite;
use host::speed;
use microwarp::rejection::{PoissonRejection, Rejection};
use microwarp::tier::{Libm, Poly, Tier};
use microwarp::{Error, poly};
use statrs::function::gamma::ln_gamma;

fn ln_pmf(mean: f64, k: u32) -> f64 {
    let k = f64::from(k);
    k * mean.ln() - mean - ln_gamma(k + 1.0)
}

fn law(
    mean: f32,
    attempt: &impl Fn([u32; 2]) -> Option<u32>,
    bound: impl Fn(f64) -> f64,
) -> [f64; 2] {
    let m = f64::from(mean);
    let pmf = |k| ln_pmf(m, k).exp();
    crate::law::law([m, m.sqrt()], [0, u32::MAX], pmf, attempt, bound)
}

/// The bound of the page at a distance from the mean.
fn granted() -> impl Fn(f64) -> f64 {
    let page = Doc::find("rejection", "PoissonRejection").unwrap().text();
    assert!(page.contains("relative error of 2e-6 + 3.5e-7 |k − m|, for |k − m| up to 4.5√m"));
    |away| 2e-6 + 3.5e-7 * away.abs()
}

/// Means in equal ratios from one up to another, not round.
fn means(from: f64, to: f64, number: u32) -> impl Iterator<Item = f32> {
    let part = move |i| (f64::from(i) + 0.377) / f64::from(number);
    (0..number).map(move |i| (from * (to / from).powf(part(i))) as f32)
}

#[test]
fn all_pairs_of_words_have_the_stated_law() {
    fn in_tier<T: Tier>(means: impl Iterator<Item = f32>) {
        let found = means.map(|mean| {
            let sampler = PoissonRejection::<T>::new(mean).unwrap();
            let law = law(mean, &|words| sampler.attempt(words), granted());
            (format!("mean {mean}"), law)
        });
        crate::law::assert_laws(T::NAME, found);
    }
    let few = speed::of("means from 10 to 400 of the law of all pairs", 30, 700);
    let more = speed::of("means above 400 of the law of all pairs", 3, 60);
    let all = |share: u32| {
        // Where Hörmann's hat is lowest, and the ends.
        [10.0, 16.5367, 14.999_999]
            .into_iter()
            .chain(means(10.0, 400.0, few / share))
            .chain(means(400.0, 20_000.0, more / share))
            .chain(
                speed::of(
                    "whether the largest means are tried",
                    &[][..],
                    &[65_536.0, 221_739.2, 1_048_576.0],
                )
                .iter()
                .copied(),
            )
    };
    in_tier::<Poly>(all(1));
    in_tier::<Libm>(all(3));
}

/// The same sampler with the constants of 1993, whose hat is too low above means up to 2000.
#[test]
fn the_hat_of_1993_is_noticed() {
    let number = speed::of("means of the hat of 1993", 20, 200);
    let noticed = means(10.0, 50.0, number).filter(|&mean| {
        let sampler = poly::PoissonRejection::new(mean).unwrap();
        let slope = 0.931 + 2.53 * mean.sqrt();
        let tail = 0.02483 * slope - 0.059;
        let attempt = |[place, decision]: [u32; 2]| {
            let u = (f64::from(place) + 0.5) / 4_294_967_296.0 - 0.5;
            let end = 0.5 - u.abs();
            let (a, b) = (f64::from(tail), f64::from(slope));
            let k = ((2.0 * a / end + b) * u + f64::from(mean) + 0.43).floor() as i64;
            let k = u32::try_from(k).ok()?;
            let v = (f64::from(decision) + 0.5) / 4_294_967_296.0;
            let hat = (1.1239 + 1.1328 / (b - 3.4)) / (a / (end * end) + b);
            (v * hat <= f64::from(sampler.pmf(k))).then_some(k)
        };
        let [_, worst] = law(mean, &attempt, granted());
        worst > 1.0
    });
    let noticed = noticed.count();
    println!("{noticed} of {number} means");
    assert!(noticed > number as usize / 2);
}

/// Another mean, another count, and a squeeze that accepts too much are noticed.
#[test]
fn wrong_laws_are_noticed() {
    let mean = 100.0;
    let sampler = poly::PoissonRejection::new(mean).unwrap();
    let other = poly::PoissonRejection::new(100.05).unwrap();
    crate::law::wrong_ones_are_noticed(
        |words| sampler.attempt(words),
        |words| other.attempt(words),
        |wrong| law(mean, &wrong, granted())[1],
    );
}

#[test]
fn the_pmf_is_that_of_the_formula() {
    let page = Doc::find("rejection", "PoissonRejection").unwrap().text();
    assert!(page.contains(
        "a relative error of 5e-7 (1 + L), where L is −ln of it, or an absolute one of 2⁻¹⁴⁸"
    ));
    fn worst<T: Tier>(mean: f32, counts: impl Iterator<Item = u32>) -> f64 {
        let sampler = PoissonRejection::<T>::new(mean).unwrap();
        let errors = counts.map(|k| {
            let ln = ln_pmf(f64::from(mean), k);
            let (found, exact) = (f64::from(sampler.pmf(k)), ln.exp());
            let bound = 5e-7 * (1.0 - ln) * exact;
            (found - exact).abs() / bound.max(2_f64.powi(-148))
        });
        errors.fold(0.0, |worst, e| worst.max(or_infinite(e)))
    }
    let stride = speed::of("stride of the means of the pmf", 40, 1);
    let mut both = [0.0_f64; 2];
    for i in (0..1000).step_by(stride) {
        let mean = 10.0 * 104_857.6_f32.powf(i as f32 / 999.0);
        let mean = mean.clamp(10.0, 1_048_576.0);
        let reach = 16.0 * mean.sqrt();
        let low = (mean - reach).max(0.0) as u32;
        let counts = || {
            (0..2000)
                .map(move |j| low + (2.0 * reach * j as f32 / 1999.0) as u32)
                .chain([0, 1, 2, 3])
        };
        both[0] = both[0].max(worst::<Poly>(mean, counts()));
        both[1] = both[1].max(worst::<Libm>(mean, counts()));
    }
    println!("{both:.3?} of the bound");
    assert!(both.iter().all(|w| *w <= 1.0), "{both:?}");
    let sampler = poly::PoissonRejection::new(10.0).unwrap();
    assert_eq!((sampler.pmf(1 << 31), sampler.pmf(u32::MAX)), (0.0, 0.0));
}

#[test]
fn means_out_of_range_are_refused() {
    for (mean, error) in [
        (f32::NAN, Error::NotFinite(0)),
        (f32::INFINITY, Error::NotFinite(0)),
        (-12.0, Error::OutOfRange(0)),
        (0.0, Error::OutOfRange(0)),
        (9.999_999, Error::OutOfRange(0)),
        (1_048_576.1, Error::OutOfRange(0)),
    ] {
        assert_eq!(poly::PoissonRejection::new(mean), Err(error), "{mean}");
    }
    let sampler = poly::PoissonRejection::new(12.5).unwrap();
    assert_eq!(sampler.mean(), 12.5);
    assert_eq!(sampler.budget(), poly::PoissonRejection::BUDGET);
    assert_eq!(sampler.with_budget(0), Err(Error::NotPositive(0)));
    assert_eq!(sampler.with_budget(3).unwrap().budget(), 3);
}

#[test]
fn no_pair_of_words_goes_wrong() {
    for mean in [10.0, 65.4, 1_048_576.0] {
        let sampler = poly::PoissonRejection::new(mean).unwrap();
        let attempt = |words| sampler.attempt(words);
        crate::law::assert_within(0..=u32::MAX, |k| sampler.pmf(k), attempt);
    }
}
