//! Rejection: the accepted points have the law that is stated, the tries are counted and geometric, budgets
//! are kept to the word, and nothing that is wrong with a density or a generator is hidden.

#[path = "rejection/bounds.rs"]
mod bounds;
#[path = "rejection/budgets.rs"]
mod budgets;
mod catalogue;
#[path = "rejection/curves.rs"]
mod curves;
#[path = "rejection/distributions.rs"]
mod distributions;
mod drivers;
#[path = "rejection/efficiency.rs"]
mod efficiency;
#[path = "rejection/exact.rs"]
mod exact;
#[path = "rejection/examination.rs"]
mod examination;
#[path = "rejection/integers.rs"]
mod integers;
#[path = "rejection/layers.rs"]
mod layers;
#[path = "rejection/subjects.rs"]
mod subjects;
#[path = "rejection/ziggurat_budgets.rs"]
mod ziggurat_budgets;
#[path = "rejection/ziggurats.rs"]
mod ziggurats;

use catalogue::stats;

/// No fewer than the p-values that are computed in this file; `p_values_are_counted` counts them.
const TESTS: usize = 150;

/// The p-value below which a test rejects.
fn threshold() -> f64 {
    stats::threshold(TESTS)
}

#[test]
fn p_values_are_counted() {
    // Chi-square and a distance an axis, for points; chi-square and a mean, for tries; five on their own; and the ziggurats'.
    let points: usize = subjects::all().iter().map(|s| 1 + s.axes).sum();
    let computed = points + 2 * subjects::all().len() + 5 + ziggurats::P_VALUES;
    assert!(computed <= TESTS, "{computed}");
}
