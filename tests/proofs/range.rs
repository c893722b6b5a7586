//! Intervals of numbers.

/// The least and the largest of some numbers.
#[derive(Clone, Copy, Debug)]
pub struct Range {
    pub low: f64,
    pub high: f64,
}

impl Range {
    pub const NONE: Self = Self {
        low: f64::INFINITY,
        high: f64::NEG_INFINITY,
    };

    pub fn join(&mut self, other: Self) {
        self.low = self.low.min(other.low);
        self.high = self.high.max(other.high);
    }

    /// The largest magnitude.
    pub fn size(self) -> f64 {
        self.high.max(-self.low)
    }

    pub fn of(numbers: &[f64]) -> Self {
        let mut range = Self::NONE;
        range.take_all(numbers);
        range
    }

    pub fn times(self, sign: f64) -> Self {
        if sign < 0.0 {
            Self {
                low: -self.high,
                high: -self.low,
            }
        } else {
            self
        }
    }

    /// As many numbers as a multiple of 4, in four lanes.
    #[inline]
    pub fn take_all(&mut self, numbers: &[f64]) {
        let (mut low, mut high, mut sum) = ([self.low; 4], [self.high; 4], [0.0; 4]);
        for four in numbers.chunks_exact(4) {
            for j in 0..4 {
                low[j] = if four[j] < low[j] { four[j] } else { low[j] };
                high[j] = if four[j] > high[j] { four[j] } else { high[j] };
                sum[j] += four[j];
            }
        }
        // Not a number loses every comparison, but not in a sum.
        assert!(sum.iter().sum::<f64>().is_finite());
        self.low = low.into_iter().fold(self.low, f64::min);
        self.high = high.into_iter().fold(self.high, f64::max);
    }
}
