//! Means of repetitions and of batches, held against what they should be.

#[derive(Clone, Copy)]
pub struct Mean {
    pub mean: f64,
    /// The standard error.
    pub error: f64,
}

impl Mean {
    pub fn of(values: impl IntoIterator<Item = f64>) -> Self {
        let values: Vec<f64> = values.into_iter().collect();
        let (mean, variance) = mean_and_variance(values.iter().copied());
        Self {
            mean,
            error: (variance / values.len() as f64).sqrt(),
        }
    }

    /// How far off the truth, in standard errors.
    pub fn deviation(self, truth: f64) -> f64 {
        (self.mean - truth) / self.error
    }
}

/// Mean and unbiased variance of numbers, in two passes.
pub fn mean_and_variance(samples: impl Iterator<Item = f64> + Clone) -> (f64, f64) {
    let n = samples.clone().count() as f64;
    let mean = samples.clone().sum::<f64>() / n;
    // The mean's own rounding leaves a residue, which is taken off.
    let (squares, residue) = samples.fold((0.0, 0.0), |(squares, residue), x| {
        (squares + (x - mean) * (x - mean), residue + (x - mean))
    });
    (
        mean + residue / n,
        (squares - residue * residue / n) / (n - 1.0),
    )
}
