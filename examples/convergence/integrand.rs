//! The integrand and the density that imitates it.

use microwarp::Warp;
use microwarp::poly as mw;
use rand_pcg::Pcg32;

/// One factor: 2/(1 + x)² on [0, 1], of integral 1.
///
/// Analytic, and special for no rule: every derivative differs between the ends, and the differences of
/// the first and third are the leading errors of midpoint, trapezoid and Simpson.
pub fn factor(x: f64) -> f64 {
    2.0 / ((1.0 + x) * (1.0 + x))
}

/// The integral of the product of factors, in any dimension.
pub const EXACT: f64 = 1.0;

/// The product of factors at a point that `f32` holds.
pub fn integrand<const S: usize>(x: [f32; S]) -> f64 {
    // One division for all factors.
    let root: f64 = x.iter().map(|&x| 1.0 + f64::from(x)).product();
    f64::from(1_u32 << S) / (root * root)
}

/// A density that falls as the integrand does: along each axis e^(-cx) with c = ln 4, because a factor
/// falls from 2 to 1/2.
pub struct Importance {
    axis: mw::TruncatedExponential,
}

impl Importance {
    pub fn new() -> Self {
        let axis = mw::TruncatedExponential::from_rate(4.0_f32.ln(), 1.0);
        Self {
            axis: axis.expect("a rate and a length"),
        }
    }

    /// A point and its density.
    pub fn draw<const S: usize>(&self, rng: &mut Pcg32) -> ([f32; S], f64) {
        let x: [f32; S] = std::array::from_fn(|_| self.axis.draw(rng));
        let density = x.iter().map(|&x| f64::from(self.axis.pdf(x))).product();
        (x, density)
    }
}
