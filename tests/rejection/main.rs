//! Rejection: the accepted points have the law that is stated, the tries are counted and geometric, budgets
//! are kept to the word, and nothing that is wrong with a density or a generator is hidden.

mod binomial;
mod bounds;
mod budgets;
mod curves;
mod distributions;
mod efficiency;
mod exact;
mod examination;
mod gamma;
mod gamma_density;
mod gamma_law;
mod hypergeometric;
mod integers;
mod law;
mod layers;
mod poisson;
mod shares;
mod subjects;
mod von_mises;
mod ziggurat_budgets;
mod ziggurats;

use examination::TESTS;

#[test]
fn p_values_are_counted() {
    // Chi-square and a distance an axis, for points; chi-square and a mean, for tries; five on their own; and the ziggurats'.
    let points: usize = subjects::all().iter().map(|s| 1 + s.axes).sum();
    let computed = points + 2 * subjects::all().len() + 5 + ziggurats::P_VALUES;
    assert!(computed <= TESTS, "{computed}");
}
