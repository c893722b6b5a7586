//! The tries are counted: their mean is the efficiency's reciprocal and their law geometric.

use crate::examination::{
    assert_passes, assert_rejected, p_value_of_mean, p_value_of_tries, totals,
};
use crate::subjects::{self, MORE, POINTS};
use host::stats;
use microwarp::Error;
use microwarp::rejection::{BallRejection, DiskRejection, Failure, Rejection, budget_for};
use rand_pcg::Pcg32;
use std::f64::consts::{FRAC_1_PI, FRAC_PI_4, FRAC_PI_6, LN_2};

#[test]
fn tries_are_geometric_with_the_stated_efficiency() {
    for (subject, outcome) in subjects::all().iter().zip(subjects::outcomes()) {
        let (name, e, tries) = (subject.name, subject.efficiency, &outcome.tries);
        let (points, total) = totals(tries);
        let measured = points as f64 / total as f64;
        println!("{name}: measured {measured:.5}, exact {e:.5}");
        let p_values = [p_value_of_tries(tries, e), p_value_of_mean(tries, e)];
        assert_passes(name, &p_values);
        // A percent is seen in the histogram and half of it in the mean, both ways; of fewer points twice that.
        for off in [-*MORE, *MORE] {
            let histogram = p_value_of_tries(tries, (1.0 + 0.01 * off) * e);
            assert_rejected("histogram 1 % off", &[histogram]);
            let mean = p_value_of_mean(tries, (1.0 + 0.005 * off) * e);
            assert_rejected("mean 0.5 % off", &[mean]);
        }
    }
}

/// The efficiency of a density that is not normalised is (∫f)/c, not the 1/c of the documents.
#[test]
fn one_over_c_is_rejected_for_a_density_that_is_not_normalised() {
    let all = subjects::all();
    let bump = all.iter().position(|s| s.name.contains("Disk, poly"));
    let bump = bump.unwrap();
    assert_eq!(all[bump].efficiency, LN_2);
    let tries = &subjects::outcomes()[bump].tries;
    assert_rejected("1/c", &[p_value_of_mean(tries, FRAC_1_PI)]);
}

/// Tries cut short by a budget have the right start and the wrong end.
#[test]
fn truncated_tries_are_rejected() {
    let disk = &subjects::outcomes()[0].tries;
    assert_rejected("1 to 4", &[p_value_of_tries(&disk[..4], FRAC_PI_4)]);
    assert_rejected("1 to 4", &[p_value_of_mean(&disk[..4], FRAC_PI_4)]);
}

#[test]
fn a_budget_is_spent_as_often_as_it_must_be() {
    let disk = DiskRejection::new().with_budget(2).unwrap();
    let ball = BallRejection::new().with_budget(5).unwrap();
    let mut rng = Pcg32::new(500, 500);
    let (mut disks, mut balls) = (0, 0);
    for _ in 0..*POINTS {
        match disk.draw(&mut rng) {
            Ok(accepted) => assert!((1..=2).contains(&accepted.tries)),
            Err(failure) => {
                assert_eq!(failure, Failure::BudgetSpent { tries: 2 });
                disks += 1;
            }
        }
        balls += u32::from(ball.draw(&mut rng).is_err());
    }
    let p_value = |spent: u32, probability: f64| {
        let n = *POINTS as f64;
        let deviation = (n * probability * (1.0 - probability)).sqrt();
        stats::two_sided((f64::from(spent) - n * probability) / deviation)
    };
    let [d, b] = [(1.0 - FRAC_PI_4).powi(2), (1.0 - FRAC_PI_6).powi(5)];
    assert_passes("budgets", &[p_value(disks, d), p_value(balls, b)]);
    assert_rejected(
        "budget of disk",
        &[p_value(disks, (1.0 + 0.05 * *MORE) * d)],
    );
    assert_rejected(
        "budget of ball",
        &[p_value(balls, (1.0 + 0.05 * *MORE) * b)],
    );
}

#[test]
fn stated_constants_are_what_they_say() {
    assert!((f64::from(DiskRejection::EFFICIENCY) - FRAC_PI_4).abs() < 3e-8);
    assert!((f64::from(BallRejection::EFFICIENCY) - FRAC_PI_6).abs() < 3e-8);
    let rare = 2f64.powi(-64);
    for (e, budget) in [
        (FRAC_PI_4, DiskRejection::BUDGET),
        (FRAC_PI_6, BallRejection::BUDGET),
    ] {
        let spent = (1.0 - e).powi(budget as i32);
        assert!(spent < rare, "{spent}");
        // Not needlessly large either: a stuck generator should be noticed soon.
        assert!((1.0 - e).powi((budget / 2) as i32) > rare);
    }
    assert_eq!(DiskRejection::new().budget(), DiskRejection::BUDGET);
    assert_eq!(BallRejection::default().budget(), BallRejection::BUDGET);
}

#[test]
fn a_budget_for_an_efficiency_is_practically_never_spent() {
    for e in [1.1e-8, 1e-7, 1e-3, 0.1, 0.5, 0.999, 1.0_f32] {
        let budget = budget_for(e).unwrap();
        let log2_spent = f64::from(budget) * (-f64::from(e)).ln_1p() / LN_2;
        assert!(log2_spent < -64.0, "{e}: 2^{log2_spent}");
        assert!(f64::from(budget) <= 44.5 / f64::from(e) + 1.0);
    }
    assert_eq!(budget_for(7.0), budget_for(1.0));
    assert_eq!(budget_for(f32::MAX), Ok(45));
    assert_eq!(budget_for(1.09e-8), Err(Error::OutOfRange(0)));
    assert_eq!(budget_for(1e-45), Err(Error::OutOfRange(0)));
    assert_eq!(budget_for(0.0), Err(Error::NotPositive(0)));
    assert_eq!(budget_for(-0.5), Err(Error::NotPositive(0)));
    assert_eq!(budget_for(f32::NAN), Err(Error::NotFinite(0)));
    assert_eq!(budget_for(f32::INFINITY), Err(Error::NotFinite(0)));
    const AT_COMPILE_TIME: Result<u32, Error> = budget_for(0.25);
    assert_eq!(AT_COMPILE_TIME, Ok(178));
}
