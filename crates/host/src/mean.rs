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

/// Means over 3 × 3 neighbours within a square picture of this side.
pub fn over_neighbours(picture: &[f64], side: usize) -> Vec<f64> {
    let inner = (1..side - 1).flat_map(|y| (1..side - 1).map(move |x| y * side + x));
    let mean = |at: usize| {
        let rows = [at - side, at, at + side];
        let near = rows.iter().flat_map(|row| &picture[row - 1..row + 2]);
        near.sum::<f64>() / 9.0
    };
    inner.map(mean).collect()
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
