//! What a picture records of the light that arrives.

use crate::vector::{Vector, plus, scaled};

/// The light of one path, as it comes in: a sum of contributions.
pub trait Film: Default {
    /// A radiance that has come this far.
    fn add(&mut self, light: Vector, way: f32);
    fn value(&self) -> Vector;
}

/// Colours.
#[derive(Clone, Copy, Debug, Default)]
pub struct Colour(Vector);

impl Film for Colour {
    #[inline]
    fn add(&mut self, light: Vector, _: f32) {
        self.0 = plus(self.0, light);
    }

    #[inline]
    fn value(&self) -> Vector {
        self.0
    }
}

/// The echo of a range sensor with a lamp of its own: how much light comes back, the same times the way that it went, and
/// times the square of that. The second over the first is twice the distance that the sensor reports.
#[derive(Clone, Copy, Debug, Default)]
pub struct Echo(Vector);

impl Film for Echo {
    #[inline]
    fn add(&mut self, [light, _, _]: Vector, way: f32) {
        self.0 = plus(self.0, scaled([1.0, way, way * way], light));
    }

    #[inline]
    fn value(&self) -> Vector {
        self.0
    }
}
