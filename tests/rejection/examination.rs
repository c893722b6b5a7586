//! What is asked of a sampler's points and tries, and the p-values of the answers; the mean of the tries is the efficiency's
//! reciprocal, and their law geometric.

use crate::subjects::{self, MORE};
use host::stats::{self, Family};
use microwarp::Error;
use microwarp::rejection::{BallRejection, DiskRejection, Rejection, budget_for};
use std::f64::consts::{FRAC_1_PI, FRAC_PI_4, FRAC_PI_6, LN_2};

/// What is judged of samplers.
pub static FAMILY: Family = Family::of(150);

/// The points of a run in coordinates that are uniform if the sampler is right, and the tries of each.
pub struct Run<const D: usize> {
    pub uniforms: Vec<[f64; D]>,
    pub tries: Vec<u32>,
}

/// Cells along each axis for D axes: some 2e3 in all.
fn cells<const D: usize>() -> [usize; D] {
    let cells: &[usize] = match D {
        1 => &[511],
        2 => &[31, 63],
        _ => &[15, 11, 13],
    };
    std::array::from_fn(|i| cells[i])
}

/// Chi-square over equal cells, then Kolmogorov and Smirnov's distance along each axis.
pub fn p_values_of_points<const D: usize>(points: &[[f64; D]]) -> Vec<f64> {
    let n = points.len() as f64;
    let cells = cells::<D>();
    let mut observed = vec![0; cells.iter().product()];
    for point in points {
        let index = point.iter().zip(cells).fold(0, |index, (&u, count)| {
            // The points are f32: a coordinate may lie outside by their rounding, NaN by nothing.
            assert!((-1e-4..=1.0001).contains(&u), "{point:?}");
            index * count + ((u * count as f64) as usize).min(count - 1)
        });
        observed[index] += 1;
    }
    let expected = vec![n / observed.len() as f64; observed.len()];
    let (_, _, p) = stats::chi_square(&observed, &expected).unwrap();
    let mut p_values = vec![p];
    for axis in 0..D {
        let mut along: Vec<f64> = points.iter().map(|p| p[axis]).collect();
        p_values.push(stats::p_value_of_uniforms(&mut along));
    }
    p_values
}

/// How many points took one try, two, and so on.
pub fn histogram(tries: &[u32]) -> Vec<u64> {
    let most = tries.iter().max().map_or(0, |k| *k as usize);
    let mut counts = vec![0; most];
    for &k in tries {
        counts[k as usize - 1] += 1;
    }
    counts
}

/// Points, and tries in all.
pub fn totals(histogram: &[u64]) -> (u64, u64) {
    let tries = (1..).zip(histogram).map(|(k, n)| k * n).sum();
    (histogram.iter().sum(), tries)
}

/// The mean against 1/e, with the spread of the geometric law.
pub fn p_value_of_mean(histogram: &[u64], e: f64) -> f64 {
    let (points, tries) = totals(histogram);
    let n = points as f64;
    let mean = tries as f64 / n;
    stats::two_sided((mean - 1.0 / e) / ((1.0 - e) / (e * e * n)).sqrt())
}

/// The histogram against e (1 - e)^(k - 1), the tail in a cell of its own.
pub fn p_value_of_tries(histogram: &[u64], e: f64) -> f64 {
    let n = totals(histogram).0 as f64;
    let most = histogram.len() as i32;
    let mut expected: Vec<f64> = (0..most).map(|k| n * e * (1.0 - e).powi(k)).collect();
    expected.push(n * (1.0 - e).powi(most));
    let observed = [histogram, &[0]].concat();
    stats::chi_square(&observed, &expected).unwrap().2
}

#[test]
fn tries_are_geometric_with_the_stated_efficiency() {
    for (subject, outcome) in subjects::all().iter().zip(subjects::outcomes()) {
        let (name, e, tries) = (subject.name, subject.efficiency, &outcome.tries);
        let (points, total) = totals(tries);
        let measured = points as f64 / total as f64;
        println!("{name}: measured {measured:.5}, exact {e:.5}");
        let p_values = [p_value_of_tries(tries, e), p_value_of_mean(tries, e)];
        FAMILY.assert_passes(name, &p_values);
        // A percent is seen in the histogram and half of it in the mean, both ways; of fewer points twice that.
        for off in [-*MORE, *MORE] {
            let histogram = p_value_of_tries(tries, (1.0 + 0.01 * off) * e);
            FAMILY.assert_rejected("histogram 1 % off", &[histogram]);
            let mean = p_value_of_mean(tries, (1.0 + 0.005 * off) * e);
            FAMILY.assert_rejected("mean 0.5 % off", &[mean]);
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
    FAMILY.assert_rejected("1/c", &[p_value_of_mean(tries, FRAC_1_PI)]);
}

/// Tries cut short by a budget have the right start and the wrong end.
#[test]
fn truncated_tries_are_rejected() {
    let disk = &subjects::outcomes()[0].tries;
    FAMILY.assert_rejected("1 to 4", &[p_value_of_tries(&disk[..4], FRAC_PI_4)]);
    FAMILY.assert_rejected("1 to 4", &[p_value_of_mean(&disk[..4], FRAC_PI_4)]);
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
