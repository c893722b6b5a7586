//! Budgets, words and extremes of the ziggurats.

use crate::curves::{CURVES, Curve};
use crate::layers::{attempt, word};
use host::generators::{Broken, Counting, Cycle, Failing};
use host::speed;
use microwarp::rejection::{
    Failure, Rejection, ZigguratExponential, ZigguratNormal, ZigguratStandardExponential,
    ZigguratStandardNormal, budget_for,
};
use microwarp::{Error, Warp, poly};
use rand_core::Rng;
use rand_pcg::Pcg32;

/// The place farthest out in the last layer, where no second word but the very first ones accepts.
fn rejected(curve: Curve) -> u32 {
    word(curve, 255, (1 << 24) - 1)
}

/// What a sampler does with its budget and its words.
fn keeps_its_budget(sampler: &impl Rejection<Point = f32>, curve: Curve, budget: u32) {
    assert_eq!(sampler.budget(), budget);
    let mut rng = Counting::new(Pcg32::new(1, 1));
    let mut counts = [0; 3];
    let draws = speed::of("draws of each budget", 100_000, 1_000_000);
    for _ in 0..draws {
        let before = rng.words;
        let tries = sampler.draw(&mut rng).unwrap().tries;
        let words = rng.words - before;
        // A try that is not accepted takes two, and one that is from one to three.
        let last = words - 2 * u64::from(tries - 1);
        counts[last as usize - 1] += 1;
    }
    assert!(
        counts.iter().all(|count| *count > draws / 5000),
        "{counts:?}"
    );
    // Stuck at a word that no try accepts.
    let words = [rejected(curve)];
    let mut stuck = Counting::new(Cycle::new(&words));
    let spent = Err(Failure::BudgetSpent { tries: budget });
    assert_eq!(sampler.draw(&mut stuck), spent);
    assert_eq!(stuck.words, 2 * u64::from(budget));
    // Failing before the word of any number.
    for left in 0..2 * u64::from(budget) {
        let word = rejected(curve);
        let failed = sampler.try_draw(&mut Failing { word, left });
        assert_eq!(failed, Err(Failure::Generator(Broken(17))), "{left}");
        let once = sampler.try_once(&mut Failing { word, left });
        let due = if left < 2 {
            Err(Failure::Generator(Broken(17)))
        } else {
            Ok(None)
        };
        assert_eq!(once, due);
    }
    // In the tail too.
    let tail = word(curve, 0, (1 << 24) - 1);
    for left in 0..3 {
        let failed = sampler.try_draw(&mut Failing { word: tail, left });
        assert_eq!(failed, Err(Failure::Generator(Broken(17))), "{left}");
    }
    let far = sampler.try_draw(&mut Failing {
        word: tail,
        left: 3,
    });
    assert_eq!(far.unwrap().tries, 1);
    // A word that accepts after several that did not.
    let mut cycle = vec![rejected(curve); 2 * (budget as usize - 1)];
    cycle.push(word(curve, 9, 1));
    let late = sampler.draw(&mut Cycle::new(&cycle)).unwrap();
    assert_eq!(late.tries, budget);
}

#[test]
fn budgets_are_kept_to_the_word() {
    fn of<S: Rejection<Point = f32>>(curve: Curve, make: impl Fn(u32) -> Result<S, Error>) {
        assert_eq!(make(0).err(), Some(Error::NotPositive(0)));
        let words = [rejected(curve)];
        for tries in [1, 2] {
            let spent = make(tries).unwrap().draw(&mut Cycle::new(&words));
            assert_eq!(spent, Err(Failure::BudgetSpent { tries }));
        }
        keeps_its_budget(&make(7).unwrap(), curve, 7);
    }
    let normal = ZigguratNormal::new(3.0, 2.0).unwrap();
    let path = ZigguratExponential::from_rate(3.0).unwrap();
    of(Curve::Normal, |budget| normal.with_budget(budget));
    of(Curve::Exponential, |budget| path.with_budget(budget));
    of(Curve::Normal, |budget| {
        ZigguratStandardNormal::new().with_budget(budget)
    });
    of(Curve::Exponential, |budget| {
        ZigguratStandardExponential::new().with_budget(budget)
    });
}

#[test]
fn default_budgets_are_spent_once_in_2_to_the_64() {
    let rare = 2f64.powi(-64);
    for (budget, e) in [
        (
            ZigguratStandardNormal::BUDGET,
            ZigguratStandardNormal::EFFICIENCY,
        ),
        (
            ZigguratStandardExponential::BUDGET,
            ZigguratStandardExponential::EFFICIENCY,
        ),
    ] {
        let missed = 1.0 - f64::from(e);
        assert!(missed.powi(budget as i32) < rare && missed.powi(budget as i32 - 1) > rare);
        assert!(budget <= budget_for(e).unwrap());
    }
    assert_eq!(
        ZigguratStandardNormal::default().budget(),
        ZigguratStandardNormal::BUDGET
    );
    let scaled = ZigguratNormal::new(0.0, 1.0).unwrap();
    assert_eq!(scaled.budget(), ZigguratStandardNormal::BUDGET);
    let scaled = ZigguratExponential::from_rate(1.0).unwrap();
    assert_eq!(scaled.budget(), ZigguratStandardExponential::BUDGET);
}

/// Any word whatever that a generator is stuck at ends in a number or with the budget.
#[test]
fn a_stuck_generator_ends() {
    let (normal, wait) = (
        ZigguratStandardNormal::new(),
        ZigguratStandardExponential::new(),
    );
    let mut rng = Pcg32::new(2, 2);
    let mut ends = [0; 2];
    for k in 0..1_000_000 {
        let word = match k {
            0 => 0,
            1 => u32::MAX,
            _ => rng.next_u32(),
        };
        for drawn in [
            normal.draw(&mut Cycle::new(&[word])),
            wait.draw(&mut Cycle::new(&[word])),
        ] {
            match drawn {
                Ok(accepted) => {
                    assert!(accepted.tries == 1 && accepted.point.is_finite());
                    ends[0] += 1;
                }
                Err(failure) => {
                    assert!(matches!(failure, Failure::BudgetSpent { tries: 9 | 10 }));
                    ends[1] += 1;
                }
            }
        }
    }
    assert!(ends[1] > 1000, "{ends:?}");
}

#[test]
fn drawing_is_attempting_at_the_drawn_words() {
    let normal = ZigguratNormal::new(-2.0, 3.0).unwrap();
    let path = ZigguratExponential::from_rate(0.7).unwrap();
    let mut rng = Pcg32::new(3, 3);
    for k in 0..1_000_000 {
        let mut words = [rng.next_u32(), rng.next_u32(), rng.next_u32()];
        // The lowest layer and the last one more often.
        match k % 16 {
            0 => words[0] &= !0xff,
            1 => words[0] |= 0xff,
            _ => {}
        }
        let [z, e] = CURVES.map(|curve| attempt(curve, words));
        assert_eq!(normal.attempt(words), z.map(|z| -2.0 + 3.0 * z));
        assert_eq!(path.attempt(words), e.map(|e| e / 0.7));
        assert_eq!(
            normal.try_once(&mut Cycle::new(&words)),
            Ok(normal.attempt(words))
        );
        assert_eq!(
            path.try_once(&mut Cycle::new(&words)),
            Ok(path.attempt(words))
        );
        let (standard, wait) = (
            ZigguratStandardNormal::new(),
            ZigguratStandardExponential::new(),
        );
        assert_eq!(standard.try_once(&mut Cycle::new(&words)), Ok(z));
        assert_eq!(wait.try_once(&mut Cycle::new(&words)), Ok(e));
        if let Some(z) = z {
            assert_eq!(standard.draw(&mut Cycle::new(&words)).unwrap().point, z);
        }
    }
}

#[test]
fn parameters_are_refused_as_by_the_warps() {
    let values = [
        f32::NAN,
        f32::INFINITY,
        f32::NEG_INFINITY,
        -1.0,
        -0.0,
        0.0,
        1e-45,
        1e-39,
        1e-38,
        3e-37,
        1.0,
        1e36,
        1e37,
        2e37,
        1e38,
        f32::MAX,
    ];
    for a in values {
        for b in values {
            let due = poly::Normal::new(a, b).err();
            assert_eq!(ZigguratNormal::new(a, b).err(), due, "{a} {b}");
        }
        let due = poly::Exponential::from_rate(a).err();
        // A little less far down, since its tail reaches a little farther.
        let due = if a == 3.1e-37 {
            Some(Error::TooLarge(0))
        } else {
            due
        };
        assert_eq!(ZigguratExponential::from_rate(a).err(), due, "{a}");
    }
    assert_eq!(
        ZigguratExponential::from_rate(3.0e-37),
        Err(Error::TooLarge(0))
    );
    assert!(ZigguratExponential::from_rate(3.1e-37).is_ok());
}

#[test]
fn a_mean_is_the_rate_of_its_reciprocal() {
    for mean in [1e-38_f32, 0.3, 1.0, 7.0, 3.2e36] {
        let of_mean = ZigguratExponential::from_mean(mean).unwrap();
        assert_eq!(of_mean, ZigguratExponential::from_rate(1.0 / mean).unwrap());
        assert_eq!(of_mean.rate(), 1.0 / mean);
        assert!(
            (of_mean.mean() / mean - 1.0).abs() <= f32::EPSILON,
            "{mean}"
        );
    }
    let refused = |mean| ZigguratExponential::from_mean(mean).err();
    for mean in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
        assert_eq!(refused(mean), Some(Error::NotFinite(0)), "{mean}");
    }
    for mean in [0.0, -0.0, -1.0, f32::MIN] {
        assert_eq!(refused(mean), Some(Error::NotPositive(0)), "{mean}");
    }
    for mean in [f32::from_bits(1), 2.9e-39] {
        assert_eq!(refused(mean), Some(Error::Empty(0)), "{mean}");
    }
    assert_eq!(refused(2.95e-39), None);
    for mean in [3.3e36, f32::MAX] {
        assert_eq!(refused(mean), Some(Error::TooLarge(0)), "{mean}");
    }
}

#[test]
fn parameters_come_back_as_they_were_given() {
    let normal = ZigguratNormal::new(-2.5, 0.1).unwrap();
    assert_eq!((normal.mean(), normal.std_dev()), (-2.5, 0.1));
    assert_eq!(ZigguratExponential::from_rate(0.1).unwrap().rate(), 0.1);
    // Compilers build them too, budgets included.
    const PATIENT: Result<ZigguratNormal, Error> = match ZigguratNormal::new(1.0, 2.0) {
        Ok(normal) => normal.with_budget(77),
        Err(e) => Err(e),
    };
    assert_eq!(PATIENT.unwrap().budget(), 77);
    assert_eq!(normal.budget(), ZigguratNormal::BUDGET);
}

/// Numbers are finite at the ends of what is accepted, their densities positive and those of the warps.
#[test]
fn extremes_of_scale_stay_finite_and_dense() {
    let mut rng = Pcg32::new(4, 4);
    let far = CURVES.map(|curve| word(curve, 0, (1 << 24) - 1));
    let deviations = [1.2e-39, 1e-30, 1.0, 1e30, 1.1e37];
    let means = [0.0, -1.0, 1e20, -1e37];
    let mut finite =
        |what: &str, odd: [[u32; 3]; 3], attempt: &dyn Fn([u32; 3]) -> Option<[f32; 3]>| {
            for k in 0..20_000 {
                let any = [rng.next_u32(), rng.next_u32(), rng.next_u32()];
                let words = odd.get(k).copied().unwrap_or(any);
                if let Some([x, pdf, due]) = attempt(words) {
                    assert!(x.is_finite() && pdf > 0.0, "{what}: {x}");
                    assert_eq!(pdf, due, "{what}: {x}");
                }
            }
        };
    for (mean, deviation) in means.into_iter().flat_map(|m| deviations.map(|d| (m, d))) {
        let Ok(normal) = ZigguratNormal::new(mean, deviation) else {
            assert!(mean.abs() >= 1e37 || deviation >= 1e37);
            continue;
        };
        let law = poly::Normal::new(mean, deviation).unwrap();
        let odd = [[far[0], 0, 0], [!far[0] & !0xff, 0, 0], [far[0], 0, 1]];
        finite(&format!("{mean} {deviation}"), odd, &|words| {
            normal
                .attempt(words)
                .map(|x| [x, normal.pdf(x), law.pdf(x)])
        });
    }
    for rate in [3.1e-37, 1e-30, 1.0, 1e30, f32::MAX] {
        let path = ZigguratExponential::from_rate(rate).unwrap();
        let law = poly::Exponential::from_rate(rate).unwrap();
        let odd = [[far[1], 0, 0], [0xff, 0, 0], [far[1], 0, 1]];
        finite(&format!("{rate}"), odd, &|words| {
            let x = path.attempt(words)?;
            assert!(x >= 0.0);
            Some([x, path.pdf(x), law.pdf(x)])
        });
    }
}

/// The standard densities against f64, at every tenth of what can be drawn.
#[test]
fn standard_densities_are_the_curves() {
    let (normal, wait) = (
        ZigguratStandardNormal::new(),
        ZigguratStandardExponential::new(),
    );
    for k in 0..850 {
        let x = k as f32 * 0.1;
        let exact = Curve::Normal.height(f64::from(x)) / std::f64::consts::TAU.sqrt();
        if exact > 1e-37 {
            for x in [x, -x] {
                let off = f64::from(normal.pdf(x)) / exact - 1.0;
                assert!(off.abs() <= 3e-6, "{x}: {off}");
            }
        }
        let exact = Curve::Exponential.height(f64::from(x));
        let off = f64::from(wait.pdf(x)) / exact - 1.0;
        assert!(off.abs() <= 3e-7, "{x}: {off}");
    }
    for nothing in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
        assert_eq!((normal.pdf(nothing), wait.pdf(nothing)), (0.0, 0.0));
    }
    assert_eq!(wait.pdf(-1e-30), 0.0);
    assert!(normal.pdf(f32::MAX) > 0.0);
}
