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
        let count = values.len() as f64;
        let mean = values.iter().sum::<f64>() / count;
        let squares: f64 = values.iter().map(|v| (v - mean).powi(2)).sum();
        Self {
            mean,
            error: (squares / (count - 1.0) / count).sqrt(),
        }
    }

    /// How far off the truth, in standard errors.
    pub fn deviation(self, truth: f64) -> f64 {
        (self.mean - truth) / self.error
    }
}
