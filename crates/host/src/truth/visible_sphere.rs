//! A sphere seen from a point, by sums that are exact before they are rounded.

use super::{Point, Real, dot, real};

/// Adds a number to an exact sum of parts that do not overlap, smallest first.
fn grow(parts: &mut Vec<Real>, mut x: Real) {
    let mut kept = Vec::new();
    for &part in &*parts {
        let (large, small) = if x.abs() < part.abs() {
            (part, x)
        } else {
            (x, part)
        };
        let sum = large + small;
        let lost = small - (sum - large);
        if lost != 0.0 {
            kept.push(lost);
        }
        x = sum;
    }
    kept.push(x);
    *parts = kept;
}

/// Adds the exact product of two numbers.
fn grow_by(parts: &mut Vec<Real>, a: Real, b: Real) {
    let product = a * b;
    grow(parts, a.mul_add(b, -product));
    grow(parts, product);
}

/// What a sphere is from a point.
pub struct SeenSphere {
    /// centre − point.
    pub axis: Point,
    /// The distance to the centre, and d² − r², rounded once; its sign is exact.
    pub distance: Real,
    pub gap: Real,
    pub radius: Real,
}

impl SeenSphere {
    pub fn new(point: [f32; 3], centre: [f32; 3], radius: f32) -> Self {
        let radius = Real::from(radius);
        let (mut gap, mut axis) = (Vec::new(), [real(0.0); 3]);
        grow_by(&mut gap, -radius, radius);
        for i in 0..3 {
            let mut side = Vec::new();
            grow(&mut side, Real::from(centre[i]));
            grow(&mut side, -Real::from(point[i]));
            for a in &side {
                for b in &side {
                    grow_by(&mut gap, *a, *b);
                }
            }
            axis[i] = side.iter().sum();
        }
        Self {
            axis,
            distance: dot(axis, axis).sqrt(),
            gap: gap.iter().sum(),
            radius,
        }
    }

    pub fn is_inside(&self) -> bool {
        self.gap < 0.0
    }

    /// cos θmax, from outside.
    fn cos(&self) -> Real {
        self.gap.sqrt() / self.distance
    }

    /// 1 − cos θmax.
    pub fn k(&self) -> Real {
        if self.is_inside() {
            real(2.0)
        } else {
            (self.radius / self.distance).powi(2) / (1.0 + self.cos())
        }
    }

    /// How far away the surface is in the direction of this first uniform.
    pub fn distance_along(&self, u: Real) -> Real {
        let d = self.distance;
        if self.is_inside() {
            let along = d * (1.0 - 2.0 * u);
            let root = (along * along - self.gap).sqrt();
            if along < 0.0 {
                -self.gap / (root - along)
            } else {
                along + root
            }
        } else {
            // The quadratic equation of the ray: (cos θ − cos θmax)(cos θ + cos θmax) is its discriminant over d².
            let (cos, rim) = ((1.0 - u) + u * self.cos(), self.cos());
            self.gap / (d * (cos + ((1.0 - u) * self.k() * (cos + rim)).sqrt()))
        }
    }
}
