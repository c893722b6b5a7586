//! The exact normal distribution of a covariance matrix: by elimination in doubles, in the order of pivots that it is given.

use super::{Point, Real, TAU, Truth, Uniforms, normal_cdf, normal_quantile, real};
use std::array::from_fn;

/// A matrix of D coordinates.
pub type Matrix<const D: usize> = [[Real; D]; D];

pub struct MultivariateNormal<const D: usize> {
    pub mean: [Real; D],
    /// A, with A Aᵀ = Σ. Its columns that are not free are 0.
    pub factor: Matrix<D>,
    /// The free coordinates in the order of their elimination.
    pub order: Vec<usize>,
    /// How many times more than the one that was chosen an elimination left of another variance, as a share of it.
    pub passed_over: Real,
}

impl<const D: usize> MultivariateNormal<D> {
    /// The order is that of the chosen pivots, as a factor shows it: a row has a number for each coordinate that went before.
    pub fn new(
        mean: [f32; D],
        covariance: [[f32; D]; D],
        factor: &[[f32; D]; D],
        free: [bool; D],
    ) -> Self {
        let mut order: Vec<usize> = (0..D).filter(|i| free[*i]).collect();
        order.sort_by_key(|&i| factor[i].iter().filter(|x| **x != 0.0).count());
        let mut left: Matrix<D> = from_fn(|i| {
            from_fn(|j| 0.5 * (Real::from(covariance[i][j]) + Real::from(covariance[j][i])))
        });
        let variances: [Real; D] = from_fn(|i| left[i][i].max(Real::from(f32::MIN_POSITIVE)));
        let (mut factor, mut passed_over) = ([[real(0.0); D]; D], real(0.0));
        for (k, &p) in order.iter().enumerate() {
            let root = left[p][p].sqrt();
            let share = left[p][p] / variances[p];
            factor[p][p] = root;
            let later: Vec<usize> = (0..D).filter(|i| !order[..=k].contains(i)).collect();
            for &i in &later {
                passed_over = passed_over.max(left[i][i] / variances[i] / share);
                factor[i][p] = left[i][p] / root;
            }
            for &i in &later {
                for &j in &later {
                    left[i][j] -= factor[i][p] * factor[j][p];
                }
            }
        }
        Self {
            mean: mean.map(Real::from),
            factor,
            order,
            passed_over,
        }
    }

    pub fn at(&self, z: [Real; D]) -> [Real; D] {
        from_fn(|i| self.mean[i] + (0..D).map(|j| self.factor[i][j] * z[j]).sum::<Real>())
    }

    pub fn point(&self, u: [Real; D]) -> [Real; D] {
        self.at(u.map(normal_quantile))
    }

    /// z of a point; 0 where a coordinate is not free.
    pub fn whiten(&self, x: [Real; D]) -> [Real; D] {
        self.whiten_offset(from_fn(|i| x[i] - self.mean[i]))
    }

    fn whiten_offset(&self, t: [Real; D]) -> [Real; D] {
        let mut z = [real(0.0); D];
        for (k, &p) in self.order.iter().enumerate() {
            let before = &self.order[..k];
            let known: Real = before.iter().map(|&j| self.factor[p][j] * z[j]).sum();
            z[p] = (t[p] - known) / self.factor[p][p];
        }
        z
    }

    /// The logarithm of the density at z.
    pub fn ln_density(&self, z: [Real; D]) -> Real {
        let each = |&i: &usize| -0.5 * z[i] * z[i] - (self.factor[i][i] * TAU.sqrt()).ln();
        self.order.iter().map(each).sum()
    }

    /// The mean over the coordinates of what their variances are divided by where all others are known: at most the condition
    /// number of the correlations.
    pub fn inflation(&self) -> Real {
        let unit = |j: usize| from_fn(|i| real(if i == j { 1.0 } else { 0.0 }));
        let columns = (0..D).map(|j| {
            let variance: Real = self.factor[j].iter().map(|a| a * a).sum();
            self.whiten_offset(unit(j))
                .iter()
                .map(|z| z * z * variance)
                .sum::<Real>()
        });
        columns.sum::<Real>() / Real::from(D as u32)
    }
}

impl<const D: usize> Truth for MultivariateNormal<D> {
    fn sample(&self, u: Uniforms) -> Point {
        let x = self.point(from_fn(|i| u[i]));
        from_fn(|i| x.get(i).copied().unwrap_or(real(0.0)))
    }
    fn pdf(&self, x: Point) -> Real {
        self.ln_density(self.whiten(from_fn(|i| x[i]))).exp()
    }
    fn density(&self, u: Uniforms) -> Real {
        self.ln_density(from_fn(|i| normal_quantile(u[i]))).exp()
    }
    fn invert(&self, x: Point) -> Uniforms {
        let z = self.whiten(from_fn(|i| x[i]));
        from_fn(|i| z.get(i).copied().map_or(real(0.0), normal_cdf))
    }
}
