//! `HypergeometricRejection`: the law that all pairs of words have together, counted and not sampled; its efficiency, its pmf
//! and its refusals.

use crate::law::{Masses, assert_laws, assert_within, law, wrong_ones_are_noticed};
use host::docs::Doc;
use host::speed;
use microwarp::rejection::{HypergeometricRejection, Rejection};
use microwarp::tier::{Libm, Poly, Tier};
use microwarp::{Error, poly};

type Urn = [u32; 3];

struct Truth {
    urn: Urn,
    mean: f64,
    deviation: f64,
    ends: [u32; 2],
    masses: Masses,
}

impl Truth {
    fn new(urn: Urn) -> Self {
        let [all, marked, drawn] = urn.map(f64::from);
        let mean = marked * drawn / all;
        let deviation = (mean * (all - marked) / all * (all - drawn) / (all - 1.0)).sqrt();
        let least = (marked + drawn - all).max(0.0);
        let most = marked.min(drawn);
        let reach = 16.0 * deviation + 256.0;
        let mode = (marked + 1.0) * (drawn + 1.0) / (all + 2.0);
        let ends = [(mean - reach).max(least), (mean + reach).min(most)].map(|x| x as u32);
        let masses = Masses::around(mode as u32, ends, |k| {
            let k = f64::from(k);
            (marked - k) * (drawn - k) / ((k + 1.0) * (all - marked - drawn + k + 1.0))
        });
        Self {
            urn,
            mean,
            deviation,
            ends: [least as u32, most as u32],
            masses,
        }
    }

    /// The efficiency of an attempt, and its largest error in units of the page's.
    fn law(&self, attempt: &impl Fn([u32; 2]) -> Option<u32>) -> [f64; 2] {
        let page = Doc::find("rejection", "HypergeometricRejection")
            .unwrap()
            .text();
        assert!(page.contains(
            "relative error of 6e-6 + 1.2e-9 s + 1.5e-8 |k − nK/N|, for |k − nK/N| up to 4.5 s"
        ));
        let bound = |away: f64| 6e-6 + 1.2e-9 * self.deviation + 1.5e-8 * away.abs();
        law(
            [self.mean, self.deviation],
            self.ends,
            |k| self.masses.pmf(k),
            attempt,
            bound,
        )
    }

    fn sampler<T: Tier>(&self) -> HypergeometricRejection<T> {
        let [population, marked, drawn] = self.urn;
        HypergeometricRejection::new(population, marked, drawn).unwrap()
    }
}

/// Urns of a variance from one to another: populations of any size; few, many or nearly all marked, and drawn.
fn urns(from: f64, to: f64, number: u32) -> impl Iterator<Item = Truth> {
    (0..number).filter_map(move |i| {
        let part = |step: f64| (f64::from(i) * step + 0.377).fract();
        let variance = from * (to / from).powf(part(0.618_034));
        let all = (16.5 * variance) * (4e9 / (16.5 * variance)).powf(part(0.754_878));
        // Of as many marked as drawn, or of a share from there up.
        let least = (variance / all).sqrt().min(0.5);
        let share = match i % 3 {
            0 => 0.5,
            1 => 0.5 * (2.0 * least).powf(part(0.569_840)),
            _ => least,
        };
        let other = variance / (all * share * (1.0 - share));
        let few = 0.5 - (0.25 - other.min(0.25)).sqrt();
        let [share, few] =
            [(share, 1), (few, 2)].map(|(x, bit)| if i & bit == 0 { x } else { 1.0 - x });
        let [all, marked, drawn] = [all, all * share, all * few].map(|x| x.round() as u32);
        let sampler = poly::HypergeometricRejection::new(all, marked, drawn);
        sampler.is_ok().then(|| Truth::new([all, marked, drawn]))
    })
}

#[test]
fn all_pairs_of_words_have_the_hypergeometric_law() {
    fn in_tier<T: Tier>(laws: impl Iterator<Item = Truth>) {
        let found = laws.map(|truth| {
            let sampler = truth.sampler::<T>();
            let law = truth.law(&|words| sampler.attempt(words));
            (format!("{:?}", truth.urn), law)
        });
        assert_laws(T::NAME, found);
    }
    let few = speed::of("hypergeometric laws of a variance from 10 to 400", 30, 700);
    let more = speed::of("hypergeometric laws of a variance above 400", 2, 60);
    let wide: &[Urn] = speed::of(
        "whether the widest hypergeometric laws are tried",
        &[],
        &[
            [u32::MAX, 1 << 31, 1 << 31],
            [u32::MAX, 50_000_000, u32::MAX - 800_000_000],
        ],
    );
    // The least variances, and those where the hat is lowest.
    let special = [
        [162, 81, 81],
        [u32::MAX, 207_300, 207_300],
        [1_680_289_924, 1_680_111_264, 556_733],
        [3_040_316_883, 661_131, 341_762],
    ];
    in_tier::<Poly>(
        special
            .into_iter()
            .chain(wide.iter().copied())
            .map(Truth::new)
            .chain(urns(10.0, 400.0, few))
            .chain(urns(400.0, 20_000.0, more)),
    );
    in_tier::<Libm>(urns(10.0, 400.0, few / 3));
}

/// Other numbers, another count, and a squeeze that accepts too much are noticed; so is the law with replacement.
#[test]
fn wrong_hypergeometric_laws_of_rejection_are_noticed() {
    let truth = Truth::new([2000, 600, 300]);
    let sampler = truth.sampler::<Poly>();
    let other = poly::HypergeometricRejection::new(2000, 601, 300).unwrap();
    let again = poly::BinomialRejection::new(300, 0.3).unwrap();
    assert!(truth.law(&|words| sampler.attempt(words))[1] <= 1.0);
    assert!(truth.law(&|words| again.attempt(words))[1] > 1.5);
    wrong_ones_are_noticed(
        |words| sampler.attempt(words),
        |words| other.attempt(words),
        |wrong| truth.law(&wrong)[1],
    );
}

#[test]
fn the_pmf_of_a_large_hypergeometric_is_that_of_the_formula() {
    let page = Doc::find("rejection", "HypergeometricRejection")
        .unwrap()
        .text();
    assert!(page.contains(
        "a relative error of 6e-7 (1 + L), where L is −ln of it, or an absolute one of 2⁻¹⁴⁸"
    ));
    let number = speed::of("hypergeometric laws of the pmf", 45, 2000);
    let mut both = [0.0_f64; 2];
    for truth in urns(10.1, 1e6, number) {
        let (quick, slow) = (truth.sampler::<Poly>(), truth.sampler::<Libm>());
        // Which is in units of 5e-7.
        both[0] = both[0].max(truth.masses.worst_pmf(|k| quick.pmf(k)) / 1.2);
        both[1] = both[1].max(truth.masses.worst_pmf(|k| slow.pmf(k)) / 1.2);
    }
    println!("{both:.3?} of the bound");
    assert!(both.iter().all(|w| *w <= 1.0), "{both:?}");
    let sampler = poly::HypergeometricRejection::new(1000, 600, 500).unwrap();
    assert_eq!([0, 99, 501, u32::MAX].map(|k| sampler.pmf(k)), [0.0; 4]);
    // So far from a large mean that the quotient of both rounds to −1.
    let far = poly::HypergeometricRejection::new(u32::MAX, 1 << 31, 1 << 31).unwrap();
    for k in [
        1,
        2,
        60,
        (1 << 31) - 60,
        (1 << 31) - 2,
        (1 << 31) - 1,
        1 << 31,
    ] {
        assert_eq!(far.pmf(k), 0.0, "{k}");
    }
}

#[test]
fn urns_of_a_small_variance_are_refused() {
    for (urn, place) in [
        ([0, 0, 0], Error::NO_PLACE),
        ([1, 1, 0], Error::NO_PLACE),
        ([1, 0, 1], Error::NO_PLACE),
        ([9, 10, 3], 1),
        ([9, 3, 10], 2),
        ([158, 79, 79], Error::NO_PLACE),
        ([u32::MAX, u32::MAX, 1 << 31], Error::NO_PLACE),
        ([u32::MAX, 0, 1 << 31], Error::NO_PLACE),
        ([u32::MAX, 1 << 31, 39], Error::NO_PLACE),
    ] {
        let [population, marked, drawn] = urn;
        assert_eq!(
            poly::HypergeometricRejection::new(population, marked, drawn),
            Err(Error::OutOfRange(place)),
            "{urn:?}"
        );
    }
    let sampler = poly::HypergeometricRejection::new(162, 81, 80).unwrap();
    assert_eq!(
        [sampler.population(), sampler.marked(), sampler.drawn()],
        [162, 81, 80]
    );
    assert_eq!(sampler.budget(), poly::HypergeometricRejection::BUDGET);
    assert_eq!(sampler.with_budget(0), Err(Error::NotPositive(0)));
    assert_eq!(sampler.with_budget(3).unwrap().budget(), 3);
}

/// No pair of words leaves the range, and counts increase with the first word.
#[test]
fn no_pair_of_words_goes_beyond_the_urn() {
    for urn in [
        [162, 81, 81],
        [5000, 4900, 3000],
        [5000, 100, 3000],
        [u32::MAX, 1 << 31, 1 << 31],
        [u32::MAX, u32::MAX - 207_300, u32::MAX - 207_300],
        [u32::MAX, 41, 1 << 31],
        [u32::MAX, 1 << 31, u32::MAX - 41],
    ] {
        let [population, marked, drawn] = urn;
        let sampler = poly::HypergeometricRejection::new(population, marked, drawn).unwrap();
        let least = (u64::from(marked) + u64::from(drawn)).saturating_sub(population.into()) as u32;
        let attempt = |words| sampler.attempt(words);
        assert_within(least..=marked.min(drawn), |k| sampler.pmf(k), attempt);
    }
}
