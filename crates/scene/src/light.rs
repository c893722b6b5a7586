//! Lights, and how one of them is chosen.

use crate::shape::{Quad, Shape, Sphere};
use crate::vector::{Vector, plus, scaled};
use microwarp::discrete::Cdf;
use rand_core::Rng;

/// A shape that sends out light, on its outer side.
pub trait Light: Copy {
    type Shape: Shape;
    fn shape(&self) -> &Self::Shape;
    fn radiance(&self) -> Vector;
    /// About where it is.
    fn middle(&self) -> Vector;
}

/// A shape with a radiance.
#[derive(Clone, Copy, Debug)]
pub struct Lamp<S> {
    pub shape: S,
    pub radiance: Vector,
}

impl Light for Lamp<Quad> {
    type Shape = Quad;

    fn shape(&self) -> &Quad {
        &self.shape
    }

    fn radiance(&self) -> Vector {
        self.radiance
    }

    fn middle(&self) -> Vector {
        let [x, y] = self.shape.edges();
        plus(self.shape.corner(), scaled(plus(x, y), 0.5))
    }
}

impl Light for Lamp<Sphere> {
    type Shape = Sphere;

    fn shape(&self) -> &Sphere {
        &self.shape
    }

    fn radiance(&self) -> Vector {
        self.radiance
    }

    fn middle(&self) -> Vector {
        self.shape.centre
    }
}

/// Chooses among the lights of a scene, and then the sky, by weights; or nothing, where there are none.
#[derive(Clone, Copy, Debug)]
pub struct Choice<'a>(Option<Cdf<&'a [u32]>>);

impl<'a> Choice<'a> {
    pub const NONE: Self = Self(None);

    /// By the weights of a table.
    pub const fn of(table: Cdf<&'a [u32]>) -> Self {
        Self(Some(table))
    }

    /// The table, if there is one.
    pub const fn table(&self) -> Option<&Cdf<&'a [u32]>> {
        self.0.as_ref()
    }

    /// An index and its probability.
    #[inline]
    pub fn draw(&self, words: &mut impl Rng) -> Option<(usize, f32)> {
        let chosen = self.0.as_ref()?.draw(words);
        Some((chosen.index, chosen.pmf))
    }

    /// The probability of an index.
    #[inline]
    pub fn pmf(&self, index: usize) -> f32 {
        self.0.as_ref().map_or(0.0, |table| table.pmf(index))
    }
}
