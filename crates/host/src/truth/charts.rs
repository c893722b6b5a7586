//! Truths by their quantile, in doubles alone, which the cells of tests are laid out by.

use super::{Line, Truth, located, student_peak};
use statrs::function::beta::beta_reg;

/// Student's t by its quantile.
pub fn student_t_line(degrees: f32, location: f32, scale: f32) -> Box<dyn Truth> {
    let degrees = f64::from(degrees);
    // The probability beyond a t above 0, and the other way round by halving an interval of its logarithm.
    let tail = move |t: f64| 0.5 * beta_reg(0.5 * degrees, 0.5, degrees / (degrees + t * t));
    let beyond = move |p: f64| {
        let (mut low, mut high) = (-60.0_f64, 60.0_f64);
        for _ in 0..56 {
            let middle = 0.5 * (low + high);
            if tail(middle.exp()) > p {
                low = middle;
            } else {
                high = middle;
            }
        }
        low.exp()
    };
    let peak = student_peak(degrees);
    let standard = Line {
        quantile: move |u: f64| {
            if u < 0.5 { -beyond(u) } else { beyond(1.0 - u) }
        },
        pdf: move |t: f64| peak * (-0.5 * (degrees + 1.0) * (t * t / degrees).ln_1p()).exp(),
        cdf: move |t: f64| {
            if t < 0.0 { tail(-t) } else { 1.0 - tail(t) }
        },
    };
    located(location, scale, standard)
}
