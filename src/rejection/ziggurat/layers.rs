//! The layers of a ziggurat, computed by the compiler.
#![allow(
    clippy::indexing_slicing,
    clippy::arithmetic_side_effects,
    clippy::integer_division_remainder_used,
    reason = "the compiler evaluates all of this, and a panic would stop the build"
)]

use crate::num::doubles::{exp, ln};

/// The number of layers; 8 bits choose one.
pub(super) const COUNT: usize = 256;

/// The curve over x ≥ 0 that is cut into layers.
#[derive(Clone, Copy)]
pub(super) enum Shape {
    /// e^(−x²/2).
    Normal,
    /// e^(−x).
    Exponential,
}

/// The part of a layer that every try needs.
#[derive(Clone, Copy)]
pub(super) struct Layer {
    /// In units of 2⁻²⁴ of the width: below this even number a point lies under the curve at any height.
    pub(super) inner: u32,
    /// The width over 2²⁴.
    pub(super) scale: f32,
}

/// Layers of equal area that cover a curve from below, the lowest with the tail.
pub(super) struct Layers {
    /// From the lowest up. The width of the lowest is that of a rectangle of the same height and area.
    pub(super) layers: [Layer; COUNT],
}

impl Layers {
    /// The layers of a curve, from where its tail starts and the area of a layer. With the right area the last layer
    /// ends at the peak of the curve.
    pub(super) const fn new(shape: Shape, tail: f64, area: f64) -> Self {
        let mut table = Self {
            layers: [Layer {
                inner: 0,
                scale: 0.0,
            }; COUNT],
        };
        let mut height = shape.height(tail);
        let (mut width, mut inner) = (area / height, tail);
        let mut index = 0;
        while index < COUNT {
            // Below 2²⁴, and 0 for the last.
            let half = (inner / width * 8_388_608.0 + 0.5) as u32;
            table.layers[index] = Layer {
                inner: 2 * half,
                scale: (width / 16_777_216.0) as f32,
            };
            if index > 0 {
                height += area / width;
            }
            width = inner;
            index += 1;
            // At the peak the height is 1, and its logarithm would be nothing but rounding errors.
            inner = if index + 1 < COUNT {
                shape.at_height(height + area / width)
            } else {
                0.0
            };
        }
        table
    }
}

impl Shape {
    const fn height(self, x: f64) -> f64 {
        match self {
            Self::Normal => 1.0 / exp(0.5 * x * x),
            Self::Exponential => 1.0 / exp(x),
        }
    }

    const fn at_height(self, height: f64) -> f64 {
        match self {
            Self::Normal => sqrt(-2.0 * ln(height)),
            Self::Exponential => -ln(height),
        }
    }
}

/// √x by Newton's method.
const fn sqrt(x: f64) -> f64 {
    let (mut root, mut n) = (1.0, 0);
    while n < 12 {
        root = 0.5 * (root + x / root);
        n += 1;
    }
    root
}
