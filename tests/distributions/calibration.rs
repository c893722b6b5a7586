//! The examination of correct warps is calibrated: its p-values are uniform, its distance is the one that
//! statrs computes, and its threshold keeps the whole family's promise.

use crate::controls::entry;
use crate::examination::Examination;
use crate::report::Report;
use host::{speed, stats};
use rand_pcg::Pcg32;
use statrs::distribution::{Exp, Uniform};
use statrs::stats_tests::NaNPolicy;
use statrs::stats_tests::ks_test::{KSOneSampleAlternativeMethod, ks_onesample};

#[test]
fn p_values_of_correct_warps_are_uniform() {
    let mut checked = 0;
    let samples = speed::of("samples of each run of the calibration", 12_000, 50_000);
    let runs = speed::of("runs of the calibration", 100, 200);
    for label in [
        "Exponential a=1 poly",
        "Normal 0, 1 libm",
        "DiskConcentric poly",
        "PhongLobe n=1e6 poly",
        "Oriented cosine about (1, 2, 3) libm",
    ] {
        let entry = entry(label);
        let examination = Examination::new(&entry, samples);
        let reports: Vec<Report> = (0..runs).map(|i| examination.run(1_000_000 + i)).collect();
        for (k, (name, _)) in reports[0].tests.iter().enumerate() {
            let p: Vec<f64> = reports.iter().map(|r| r.tests[k].1).collect();
            let (d, uniform) = ks_onesample(
                p,
                &Uniform::new(0.0, 1.0).unwrap(),
                KSOneSampleAlternativeMethod::TwoSidedAsymptotic,
                NaNPolicy::Error,
            )
            .unwrap();
            println!("{label}, {name}: {runs} p-values are {d:.3} from uniform, p = {uniform:.3}");
            assert!(uniform >= 1e-6, "{label}, {name}: {uniform}");
            checked += 1;
        }
    }
    assert_eq!(checked, 4 + 4 + 8 + 9 + 9);
}

#[test]
fn the_distance_agrees_with_the_one_statrs_computes() {
    let entry = entry("Exponential a=1 libm");
    for seed in 0..20 {
        let n = 100_000;
        let sample = entry.warp.fill(&mut Pcg32::new(seed, seed), n);
        let (d, p) = ks_onesample(
            sample.iter().map(|x| f64::from(x[0])).collect(),
            &Exp::new(1.0).unwrap(),
            KSOneSampleAlternativeMethod::TwoSidedAsymptotic,
            NaNPolicy::Error,
        )
        .unwrap();
        assert!(
            (stats::kolmogorov(d, n as f64) - p).abs() <= 1e-9,
            "{d}: {p}"
        );
        let ours = Examination::new(&entry, n).run(seed).lowest("distance");
        // Read at 3e4 places only, the distance may be smaller by their spacing.
        let nearest = stats::kolmogorov(d - 1.0 / 32_704.0, n as f64);
        assert!(
            ours >= p - 1e-9 && ours <= nearest + 1e-9,
            "{p} <= {ours} <= {nearest}"
        );
    }
}

#[test]
fn the_family_of_tests_stays_below_one_false_alarm_in_a_million() {
    for tests in [1, 100, 1500] {
        let none = (1.0 - stats::threshold(tests)).powi(tests as i32);
        assert!((1.0 - none) <= 1.01e-7, "{tests} tests: {}", 1.0 - none);
    }
    // Cells below 5 are pooled: 3 + 2 beside 45 and 50 make three cells.
    let (chi2, dof, p) = stats::chi_square(&[45, 50, 5, 0], &[45.0, 50.0, 3.0, 2.0]).unwrap();
    assert_eq!((chi2, dof), (0.0, 2));
    assert!(p >= 1.0);
    assert!(stats::chi_square(&[45, 50, 1], &[45.0, 51.0, 0.0]).is_err());
}
