//! The rest of a renderer's kit by hand, as pbrt-v4 has it: a reflection off a rough surface, tables, a pixel filter, weights,
//! choices, and the order of one set of points over a picture. As in [`renderer`](super::renderer), all is written anew from the
//! formulas.

use super::renderer::{Vector, Weighed, between, dot, ggx_visible, linear};
use std::f32::consts::PI;

const BELOW_ONE: f32 = 1.0 - f32::EPSILON / 2.0;

/// Where a microfacet that a view meets reflects it to.
///
/// Source: B. Walter et al., "Microfacet Models for Refraction through Rough Surfaces", 2007,
/// <https://doi.org/10.2312/EGWR/EGSR07/195-206>.
#[inline]
pub fn ggx_reflection(view: Vector, alpha: [f32; 2], u: [f32; 2]) -> Weighed<Vector> {
    let (normal, density) = ggx_visible(view, alpha, u);
    let cos = dot(view, normal);
    let [a, b, c] = [0, 1, 2].map(|k| 2.0 * cos * normal[k] - view[k]);
    ([a, b, c], density / (4.0 * cos.abs()))
}

/// The part of microfacets that a direction sees, by the tangent of its angle and the cosine of its azimuth.
#[inline]
pub fn ggx_g1([x, y, z]: Vector, [ax, ay]: [f32; 2]) -> f32 {
    let sin2 = (1.0 - z * z).max(0.0);
    let tan2 = sin2 / (z * z);
    if tan2.is_infinite() {
        return 0.0;
    }
    let sin = sin2.sqrt();
    let [cos_phi, sin_phi] = if sin == 0.0 {
        [1.0, 0.0]
    } else {
        [x / sin, y / sin].map(|c| c.clamp(-1.0, 1.0))
    };
    let [a, b] = [cos_phi * ax, sin_phi * ay];
    let lambda = ((1.0 + (a * a + b * b) * tan2).sqrt() - 1.0) / 2.0;
    1.0 / (1.0 + lambda)
}

/// A density that is constant between equally spaced ends, by its cumulative sums in floats and a binary search.
#[derive(Clone, Debug)]
pub struct Piecewise {
    values: Vec<f32>,
    sums: Vec<f32>,
    integral: f32,
    range: [f32; 2],
}

impl Piecewise {
    pub fn new(values: &[f32], range: [f32; 2]) -> Self {
        let values: Vec<f32> = values.iter().map(|value| value.abs()).collect();
        let width = (range[1] - range[0]) / values.len() as f32;
        let mut sums = vec![0.0];
        let mut sum = 0.0;
        for value in &values {
            sum += value * width;
            sums.push(sum);
        }
        sums.iter_mut().for_each(|part| *part /= sum);
        Self {
            values,
            sums,
            integral: sum,
            range,
        }
    }

    /// A point, its density, and its cell.
    #[inline]
    pub fn sample(&self, u: f32) -> (f32, f32, usize) {
        let cell = self.sums.partition_point(|sum| *sum <= u).max(1) - 1;
        let cell = cell.min(self.values.len() - 1);
        let (low, high) = (self.sums[cell], self.sums[cell + 1]);
        let mut part = u - low;
        if high > low {
            part /= high - low;
        }
        let density = if self.integral > 0.0 {
            self.values[cell] / self.integral
        } else {
            0.0
        };
        let place = (cell as f32 + part) / self.values.len() as f32;
        (between(place, self.range[0], self.range[1]), density, cell)
    }
}

/// The same over a rectangle, a table a row.
#[derive(Clone, Debug)]
pub struct PiecewiseRows {
    rows: Vec<Piecewise>,
    marginal: Piecewise,
}

impl PiecewiseRows {
    pub fn new<'a>(rows: impl Iterator<Item = &'a [f32]>, ranges: [[f32; 2]; 2]) -> Self {
        let rows: Vec<_> = rows.map(|row| Piecewise::new(row, ranges[0])).collect();
        let integrals: Vec<f32> = rows.iter().map(|row| row.integral).collect();
        let marginal = Piecewise::new(&integrals, ranges[1]);
        Self { rows, marginal }
    }

    /// A point, its density, and its column and row.
    #[inline]
    fn sample_cell(&self, [u, v]: [f32; 2]) -> Weighed<([f32; 2], [usize; 2])> {
        let (y, down, row) = self.marginal.sample(v);
        let (x, along, column) = self.rows[row].sample(u);
        (([x, y], [column, row]), along * down)
    }

    #[inline]
    pub fn sample(&self, u: [f32; 2]) -> Weighed<[f32; 2]> {
        let ((point, _), density) = self.sample_cell(u);
        (point, density)
    }
}

/// Mitchell's and Netravali's filter on both axes, sampled by a table of its size: a place and its weight.
#[derive(Clone, Debug)]
pub struct Mitchell {
    table: PiecewiseRows,
    values: Vec<Vec<f32>>,
}

impl Mitchell {
    /// Cells of the table for each unit of the radius.
    const CELLS: u16 = 32;

    pub fn new(radius: u16, b: f32, c: f32) -> Self {
        let on_axis = |x: f32| {
            let x = (2.0 * x / f32::from(radius)).abs();
            let cubic = |a3: f32, a2: f32, a1: f32, a0: f32| ((a3 * x + a2) * x + a1) * x + a0;
            let six = if x <= 1.0 {
                cubic(
                    12.0 - 9.0 * b - 6.0 * c,
                    12.0 * b + 6.0 * c - 18.0,
                    0.0,
                    6.0 - 2.0 * b,
                )
            } else if x <= 2.0 {
                cubic(
                    -b - 6.0 * c,
                    6.0 * b + 30.0 * c,
                    -12.0 * b - 48.0 * c,
                    8.0 * b + 24.0 * c,
                )
            } else {
                0.0
            };
            six / 6.0
        };
        let cells = 2 * radius * Self::CELLS;
        let axis: Vec<f32> = (0..cells)
            .map(|k| on_axis((f32::from(k) + 0.5) / f32::from(Self::CELLS) - f32::from(radius)))
            .collect();
        let row = |y: &f32| axis.iter().map(|x| x * y).collect();
        let values: Vec<Vec<f32>> = axis.iter().map(row).collect();
        let range = [-f32::from(radius), f32::from(radius)];
        let rows = values.iter().map(Vec::as_slice);
        let table = PiecewiseRows::new(rows, [range; 2]);
        Self { table, values }
    }

    #[inline]
    pub fn sample(&self, u: [f32; 2]) -> Weighed<[f32; 2]> {
        let ((place, [column, row]), density) = self.table.sample_cell(u);
        (place, self.values[row][column] / density)
    }
}

/// The tent filter, by its halves.
#[inline]
pub fn tent(radius: f32, [u]: [f32; 1]) -> Weighed<f32> {
    let x = if u < 0.5 {
        radius * (linear((2.0 * u).min(BELOW_ONE), 0.0, 1.0) - 1.0)
    } else {
        radius * linear((2.0 * (u - 0.5)).min(BELOW_ONE), 1.0, 0.0)
    };
    (x, 1.0 / radius - x.abs() / (radius * radius))
}

/// Source: E. Veach and L. J. Guibas, "Optimally Combining Sampling Techniques for Monte Carlo Rendering", 1995,
/// <https://doi.org/10.1145/218380.218498>.
#[inline]
pub fn balance_heuristic(own: f32, other: f32) -> f32 {
    own / (own + other)
}

/// Likewise, of the squares.
#[inline]
pub fn power_heuristic(own: f32, other: f32) -> f32 {
    let (a, b) = (own * own, other * other);
    if a.is_infinite() {
        return 1.0;
    }
    a / (a + b)
}

/// One item of a stream, by its weight, with a sum in floats.
///
/// Source: M. T. Chao, "A General Purpose Unequal Probability Sampling Plan", 1982, <https://doi.org/10.1093/biomet/69.3.653>.
#[derive(Clone, Copy, Debug, Default)]
pub struct WeightedReservoir {
    item: u32,
    weight: f32,
    sum: f32,
}

impl WeightedReservoir {
    #[inline]
    pub fn add(&mut self, item: u32, weight: f32, u: f32) {
        self.sum += weight;
        if u < weight / self.sum {
            (self.item, self.weight) = (item, weight);
        }
    }

    /// The item, and the probability with which it is held.
    #[inline]
    pub fn held(self) -> Weighed<u32> {
        (self.item, self.weight / self.sum)
    }
}

/// A direction of one of two lobes, chosen by a uniform of its own, with the density of both together: by the cosine about +z, and
/// over a cone.
#[inline]
pub fn two_lobes(of_cosine: f32, cos_most: f32, [choice, u1, u2]: [f32; 3]) -> Weighed<Vector> {
    let (direction, _) = if choice < of_cosine {
        super::renderer::cosine_hemisphere([u1, u2])
    } else {
        super::renderer::cone(cos_most, [u1, u2])
    };
    let [_, _, z] = direction;
    let cone = if z >= cos_most {
        1.0 / (2.0 * PI * (1.0 - cos_most))
    } else {
        0.0
    };
    let density = of_cosine * z / PI + (1.0 - of_cosine) * cone;
    (direction, density)
}

/// The order of one set over the pixels of a picture: along Morton's curve, whose digits to base 4 are permuted by a hash of
/// those before.
///
/// Source: A. G. M. Ahmed and P. Wonka, "Screen-Space Blue-Noise Diffusion of Monte Carlo Sampling Error via Hierarchical
/// Ordering of Pixels", 2020, <https://doi.org/10.1145/3414685.3417881>.
#[derive(Clone, Copy, Debug)]
pub struct Curve {
    log2_samples: u32,
    digits: u32,
    permutations: [[u8; 4]; 24],
}

impl Curve {
    pub fn new([width, height]: [u32; 2], log2_samples: u32) -> Self {
        let side = width.max(height).next_power_of_two().trailing_zeros();
        Self {
            log2_samples,
            digits: side + log2_samples.div_ceil(2),
            permutations: std::array::from_fn(permutation),
        }
    }

    /// The index of a pixel's sample in a dimension.
    #[inline]
    pub fn index(&self, [x, y]: [u32; 2], sample: u32, dimension: u32) -> u64 {
        let pixel = spread(x) | spread(y) << 1;
        let place = pixel << self.log2_samples | u64::from(sample);
        let key = u64::from(dimension.wrapping_mul(0x5555_5555));
        // Of an odd number of bits, the last digit has one.
        let odd = self.log2_samples & 1;
        let mut index = 0;
        for digit in (odd..self.digits).rev() {
            let shift = 2 * digit - odd;
            let before = place >> (shift + 2);
            let number = (mixed(before ^ key) >> 24) % 24;
            let own = (place >> shift & 3) as usize;
            index |= u64::from(self.permutations[number as usize][own]) << shift;
        }
        if odd == 1 {
            index |= (place ^ mixed(place >> 1 ^ key)) & 1;
        }
        index
    }
}

/// The order of four digits that has this number, of 24.
fn permutation(number: usize) -> [u8; 4] {
    let mut left = vec![0, 1, 2, 3];
    [number / 6, number / 2 % 3, number % 2, 0].map(|place| left.remove(place))
}

/// Bits of a number, each moved to twice its place.
#[inline]
fn spread(x: u32) -> u64 {
    let mut x = u64::from(x);
    for (shift, mask) in [
        (16, 0x0000_ffff_0000_ffff),
        (8, 0x00ff_00ff_00ff_00ff),
        (4, 0x0f0f_0f0f_0f0f_0f0f),
        (2, 0x3333_3333_3333_3333),
        (1, 0x5555_5555_5555_5555),
    ] {
        x = (x ^ x << shift) & mask;
    }
    x
}

/// A hash of 64 bits.
///
/// Source of its constants: <https://zimbry.blogspot.com/2011/09/better-bit-mixing-improving-on.html>.
#[inline]
fn mixed(x: u64) -> u64 {
    let x = (x ^ x >> 31).wrapping_mul(0x7fb5_d329_728e_a185);
    let x = (x ^ x >> 27).wrapping_mul(0x81da_def4_bc2d_d44d);
    x ^ x >> 33
}
