//! What is asked of a sampler's points and tries, and the p-values of the answers.

use host::stats;

/// No fewer than the p-values that are computed in these files; `p_values_are_counted` counts them.
pub const TESTS: usize = 150;

/// The p-value below which a test rejects.
pub fn threshold() -> f64 {
    stats::threshold(TESTS)
}

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

pub fn assert_passes(what: &str, p_values: &[f64]) {
    stats::assert_passes(what, p_values, threshold());
}

pub fn assert_rejected(what: &str, p_values: &[f64]) {
    stats::assert_rejected(what, p_values, threshold());
}
