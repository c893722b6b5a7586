//! What one run of samples gave, and what is to be objected to it.

/// What a run of samples gave.
pub struct Report {
    pub chi2: f64,
    pub dof: usize,
    /// Each test with its p-value: chi-square first, then the distances, then the moments.
    pub tests: Vec<(String, f64)>,
    /// What no chance excuses.
    pub faults: Vec<String>,
}

impl Report {
    /// Every fault, and every test whose p-value is not at least the threshold.
    pub fn objections(&self, threshold: f64) -> Vec<String> {
        let low = |(_, p): &&(String, f64)| {
            let passed = *p >= threshold;
            !passed // so that NaN is an objection
        };
        let rejected = self
            .tests
            .iter()
            .filter(low)
            .map(|(name, p)| format!("{name}: p = {p:.1e}"));
        self.faults.iter().cloned().chain(rejected).collect()
    }

    /// The lowest p-value of the tests whose name starts so; NaN if one of them is.
    pub fn lowest(&self, start: &str) -> f64 {
        let tests = self
            .tests
            .iter()
            .filter(|(name, _)| name.starts_with(start));
        tests.map(|t| t.1).fold(
            f64::INFINITY,
            |a, b| if a < b || a.is_nan() { a } else { b },
        )
    }
}
