//! The slope of a line in a diagram of two logarithmic axes.

/// The straight line of least squares through the logarithms (base 10) of points.
pub struct Fit {
    pub slope: f64,
}

impl Fit {
    pub fn of_logarithms(points: impl Iterator<Item = [f64; 2]>) -> Self {
        let logs: Vec<[f64; 2]> = points.map(|point| point.map(f64::log10)).collect();
        let count = logs.len() as f64;
        let sum = |of: &dyn Fn(&[f64; 2]) -> f64| logs.iter().map(of).sum::<f64>();
        let [x, y] = [sum(&|p| p[0]) / count, sum(&|p| p[1]) / count];
        let spread = sum(&|p| (p[0] - x).powi(2));
        let slope = sum(&|p| (p[0] - x) * (p[1] - y)) / spread;
        Self { slope }
    }
}
