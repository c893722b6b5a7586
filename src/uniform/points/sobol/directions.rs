//! The directions of the dimensions from the third on, made by the compiler.
//!
//! The first numbers are those of S. Joe, F. Y. Kuo, "Constructing Sobol Sequences with Better Two-Dimensional
//! Projections", 2008, <https://doi.org/10.1137/070709359>.
#![allow(
    clippy::indexing_slicing,
    clippy::arithmetic_side_effects,
    reason = "the table is computed by the compiler, which stops at an index outside it"
)]

use crate::uniform::MAX_DIMENSIONS;

/// The dimensions without a table.
const WITHOUT: usize = 2;
const DIMENSIONS: usize = MAX_DIMENSIONS - WITHOUT;

/// Degree and inner coefficients of the primitive polynomial of a dimension, and its first directions as odd numbers.
const FIRST: [(usize, u32, [u32; 5]); DIMENSIONS] = [
    (2, 1, [1, 3, 0, 0, 0]),
    (3, 1, [1, 3, 1, 0, 0]),
    (3, 2, [1, 1, 1, 0, 0]),
    (4, 1, [1, 1, 3, 3, 0]),
    (4, 4, [1, 3, 5, 13, 0]),
    (5, 2, [1, 1, 5, 5, 17]),
];

/// By the bits of an index, then by dimension: 768 bytes. Bits are reversed, as those of a coordinate are.
static DIRECTIONS: [[u32; DIMENSIONS]; 32] = {
    let mut table = [[0; DIMENSIONS]; 32];
    let mut d = 0;
    while d < DIMENSIONS {
        let (degree, coefficients, first) = FIRST[d];
        let mut k = 0;
        while k < 32 {
            table[k][d] = if k < degree {
                (first[k] << (31 - k)).reverse_bits()
            } else {
                let before = table[k - degree][d];
                let mut direction = before ^ before << degree;
                let mut i = 1;
                while i < degree {
                    if coefficients >> (degree - 1 - i) & 1 == 1 {
                        direction ^= table[k - i][d];
                    }
                    i += 1;
                }
                direction
            };
            k += 1;
        }
        d += 1;
    }
    table
};

/// The rows that the bits of an index choose, at most 32.
#[inline]
fn chosen(mut index: u32) -> impl Iterator<Item = &'static [u32; DIMENSIONS]> {
    core::iter::from_fn(move || {
        let row = DIRECTIONS.get(index.trailing_zeros() as usize)?;
        index &= index.wrapping_sub(1);
        Some(row)
    })
}

/// The sums modulo 2 of the directions that the bits of an index choose, of all dimensions from the third on.
#[inline]
pub(super) fn sums(index: u32) -> [u32; DIMENSIONS] {
    let mut sums = [0; DIMENSIONS];
    for row in chosen(index) {
        for (sum, direction) in sums.iter_mut().zip(row) {
            *sum ^= direction;
        }
    }
    sums
}

/// The sum of one dimension, from the third on.
#[inline]
pub(super) fn sum(index: u32, dimension: u32) -> u32 {
    let column = (dimension as usize).wrapping_sub(WITHOUT);
    let directions = chosen(index).filter_map(|row| row.get(column));
    directions.fold(0, |sum, direction| sum ^ direction)
}
