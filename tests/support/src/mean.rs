//! Means of repetitions and of batches, held against what they should be.

use crate::draw::text::signed;
use statrs::distribution::{ContinuousCDF, StudentsT};

#[derive(Clone, Copy)]
pub struct Mean {
    pub mean: f64,
    /// The standard error.
    pub error: f64,
    count: usize,
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
            count: values.len(),
        }
    }

    /// How far off the truth, in standard errors.
    pub fn deviation(self, truth: f64) -> f64 {
        (self.mean - truth) / self.error
    }

    /// The chance of being as far off the truth as that.
    pub fn p(self, truth: f64) -> f64 {
        let law = StudentsT::new(0.0, 1.0, (self.count - 1) as f64).expect("there are some");
        2.0 * law.sf(self.deviation(truth).abs())
    }

    /// The mean in units of 1/factor, and how far off the truth it is.
    pub fn beside(self, truth: f64, digits: usize, factor: f64) -> String {
        let off = deviation_text(self.deviation(truth));
        format!("{:.digits$} ({off})", factor * self.mean)
    }
}

/// So many standard errors, with the sign.
pub fn deviation_text(deviation: f64) -> String {
    let sign = if deviation < 0.0 { "" } else { "+" };
    format!("{sign}{} σ", signed(deviation, 1))
}
