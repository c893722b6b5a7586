//! What comes of a test.

/// A p-value below this is no accident in any number of runs.
pub const ALARM: f64 = 1e-9;

/// What came of a chi-square test: its value, the degrees of freedom and the p-value, or why none.
pub type Outcome = Result<(f64, usize, f64), String>;

/// Whether the test let something pass.
pub fn passes(outcome: &Outcome) -> bool {
    matches!(outcome, Ok((_, _, p)) if *p >= ALARM)
}
