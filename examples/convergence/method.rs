//! The six methods: their names, their theory, and the sizes at which they run.

use std::fmt;
use support::draw::colour::{Colour, INK};

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Method {
    Midpoint,
    Trapezoid,
    Simpson,
    Plain,
    Stratified,
    Importance,
}

pub const METHODS: [Method; 6] = [
    Method::Midpoint,
    Method::Trapezoid,
    Method::Simpson,
    Method::Plain,
    Method::Stratified,
    Method::Importance,
];

pub const DIMENSIONS: [u32; 3] = [1, 2, 6];

/// An exponent r of an error that falls as N^-r: a fraction in lowest terms, so that equal rates compare
/// equal.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Rate {
    above: u32,
    below: u32,
}

impl Rate {
    fn new(above: u32, below: u32) -> Self {
        let common = (1..=below).rev().find(|d| above % d == 0 && below % d == 0);
        let common = common.unwrap_or(1);
        Self {
            above: above / common,
            below: below / common,
        }
    }

    /// The slope of the error in a plot with logarithmic axes.
    pub fn slope(self) -> f64 {
        -f64::from(self.above) / f64::from(self.below)
    }
}

impl fmt::Display for Rate {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.below {
            1 => write!(f, "−{}", self.above),
            _ => write!(f, "−{}/{}", self.above, self.below),
        }
    }
}

impl Method {
    pub fn name(self) -> &'static str {
        match self {
            Self::Midpoint => "midpoint",
            Self::Trapezoid => "trapezoid",
            Self::Simpson => "Simpson",
            Self::Plain => "plain Monte Carlo",
            Self::Stratified => "stratified",
            Self::Importance => "importance-sampled",
        }
    }

    /// Apart in hue and in lightness, so that the lines stay apart without colour vision too.
    pub fn colour(self) -> Colour {
        match self {
            Self::Midpoint => [0, 92, 175, 255],
            Self::Trapezoid => [96, 178, 232, 255],
            Self::Simpson => [0, 145, 105, 255],
            Self::Plain => INK,
            Self::Stratified => [236, 150, 0, 255],
            Self::Importance => [205, 50, 110, 255],
        }
    }

    pub fn is_random(self) -> bool {
        matches!(self, Self::Plain | Self::Stratified | Self::Importance)
    }

    /// How the error falls for a smooth integrand in `s` dimensions.
    ///
    /// A rule of order r on n points a axis has N = n^s and the error n^-r. Of N jittered cells each has
    /// a variance that falls as the square of its width N^(-1/s), on top of the 1/N of plain sampling.
    pub fn theory(self, s: u32) -> Rate {
        match self {
            Self::Midpoint | Self::Trapezoid => Rate::new(2, s),
            Self::Simpson => Rate::new(4, s),
            Self::Plain | Self::Importance => Rate::new(1, 2),
            Self::Stratified => Rate::new(s + 2, 2 * s),
        }
    }

    /// Sizes to run at: intervals or strata an axis, or samples where there are no axes.
    pub fn sizes(self, s: u32) -> Vec<u32> {
        let powers = |least: u32, most: u32| (least..=most).map(|k| 1 << k).collect();
        match (self, s) {
            (Self::Simpson, 1) => powers(1, 16),
            (Self::Midpoint | Self::Trapezoid, 1) => powers(0, 20),
            (Self::Simpson, 2) => powers(1, 12),
            (Self::Midpoint | Self::Trapezoid, 2) => powers(0, 12),
            (Self::Simpson, _) => vec![2, 4, 6, 8, 12, 16, 20, 24, 28, 32],
            (Self::Midpoint | Self::Trapezoid, _) => vec![1, 2, 3, 4, 6, 8, 12, 16, 20, 24, 28, 32],
            (Self::Stratified, 1) => powers(0, 18),
            (Self::Stratified, 2) => powers(0, 9),
            (Self::Stratified, _) => (1..=8).collect(),
            (Self::Plain, _) => powers(0, 16),
            // Its exponentials cost most of the program's time.
            (Self::Importance, _) => powers(0, 15),
        }
    }

    /// The smallest size that counts as asymptotic.
    ///
    /// A rule with n + 1 points a axis has the slope (1 + 1/n) r/s in the number of its points, so that
    /// few intervals would tilt the fit; six dimensions leave no choice but 16.
    pub fn asymptotic_from(self, s: u32) -> u32 {
        match (self, s) {
            (Self::Midpoint | Self::Trapezoid | Self::Simpson, 6) => 16,
            (Self::Midpoint | Self::Trapezoid | Self::Simpson, _) => 32,
            (Self::Plain | Self::Importance, _) => 16,
            (Self::Stratified, 1) => 16,
            (Self::Stratified, 2) => 4,
            (Self::Stratified, _) => 3,
        }
    }

    /// The number of evaluations of the integrand.
    pub fn evaluations(self, size: u32, s: u32) -> u64 {
        let size = u64::from(size);
        match self {
            Self::Midpoint | Self::Stratified => size.pow(s),
            Self::Trapezoid | Self::Simpson => (size + 1).pow(s),
            Self::Plain | Self::Importance => size,
        }
    }
}
