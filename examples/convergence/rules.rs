//! The classical rules, as product rules in several dimensions, in f64.

use crate::integrand::{EXACT, factor};
use crate::method::Method;

/// Below this, rounding in f64 may weigh as much as the error of a rule.
pub const FLOOR: f64 = 64.0 * f64::EPSILON;

/// The absolute error of a rule with `n` intervals along each of `s` axes.
pub fn error(rule: Method, n: u32, s: u32) -> f64 {
    // A point's weight and value are products over the axes, so both come from one table. The sum still
    // visits every point: nothing is saved that the number of evaluations would hide.
    let axis: Vec<f64> = match rule {
        Method::Midpoint => (0..n)
            .map(|i| factor((f64::from(i) + 0.5) / f64::from(n)) / f64::from(n))
            .collect(),
        _ => (0..=n)
            .map(|i| weight(rule, i, n) * factor(f64::from(i) / f64::from(n)) / f64::from(n))
            .collect(),
    };
    (sum(&axis, 1.0, s) - EXACT).abs()
}

/// The weight of end `i` of an interval, in interval widths.
fn weight(rule: Method, i: u32, n: u32) -> f64 {
    let end = i == 0 || i == n;
    match (rule, end) {
        (Method::Simpson, true) => 1.0 / 3.0,
        (Method::Simpson, false) if i % 2 == 1 => 4.0 / 3.0,
        (Method::Simpson, false) => 2.0 / 3.0,
        (_, true) => 0.5,
        (_, false) => 1.0,
    }
}

/// The sum over all points of the remaining axes. Row by row, so that rounding does not pile up along a
/// billion terms.
fn sum(axis: &[f64], before: f64, axes: u32) -> f64 {
    if axes > 1 {
        axis.iter().map(|x| sum(axis, before * x, axes - 1)).sum()
    } else {
        let row = |row: &[f64]| row.iter().map(|x| before * x).sum::<f64>();
        axis.chunks(256).map(row).sum()
    }
}
