//! Rejection: the accepted points have the law that is stated, the tries are counted and geometric, budgets
//! are kept to the word, and nothing that is wrong with a density or a generator is hidden.

mod binomial;
mod bounds;
mod budgets;
mod curves;
mod distributions;
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
