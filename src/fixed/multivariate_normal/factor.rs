//! A matrix of correlations taken apart: by elimination with pivots, in integers and at compile time. The parts that are left of
//! the variances are exact to a few 2⁻⁶⁰.

use super::super::Coordinate;
use crate::error::Error;
use crate::num::division::scaled;

/// The rows of a matrix.
pub(super) type Rows<X, const D: usize> = [[X; D]; D];

/// 1 in Q60.
const WHOLE: i64 = 1 << 60;
/// 2⁻⁴⁰.
const EQUAL: i64 = 1 << 20;

/// What sampling and densities need of a matrix of correlations.
pub(super) struct Factors<const D: usize> {
    /// L with C = L Lᵀ, in Q32. The column of a coordinate that others determine is 0.
    pub factor: Rows<i64, D>,
    /// The diagonal of L, of the free coordinates: 32 bits, of which the first is set, and how many of them are a fraction.
    pub diagonal: [(u32, i32); D],
    /// First the free coordinates, in the order of elimination, then the others.
    pub order: [u8; D],
    /// How many are free.
    pub rank: usize,
}

/// The number at a place.
pub(super) const fn at<X: Copy>(row: &[X], place: usize, beyond: X) -> X {
    match row.split_at_checked(place) {
        Some((_, [x, ..])) => *x,
        _ => beyond,
    }
}

/// Writes the number at a place.
pub(super) const fn put<X: Copy>(row: &mut [X], place: usize, x: X) {
    if let Some((_, [slot, ..])) = row.split_at_mut_checked(place) {
        *slot = x;
    }
}

/// The number in a row and a column.
pub(super) const fn entry<const D: usize>(rows: &Rows<i64, D>, i: usize, j: usize) -> i64 {
    at(&at(rows, i, [0; D]), j, 0)
}

const fn put_entry<const D: usize>(rows: &mut Rows<i64, D>, i: usize, j: usize, x: i64) {
    if let Some((_, [row, ..])) = rows.split_at_mut_checked(i) {
        put(row, j, x);
    }
}

/// |a|·2^bits/b with the sign of a, cut, for b above half of |a|.
const fn divided(a: i128, b: u128, bits: u32) -> i64 {
    let magnitude = scaled(a.unsigned_abs(), b, bits).0 as i64;
    if a < 0 { -magnitude } else { magnitude }
}

/// A matrix of correlations in Q60.
const fn checked<const D: usize>(
    correlations: &Rows<Coordinate, D>,
) -> Result<Rows<i64, D>, Error> {
    let mut left = [[0; D]; D];
    let mut i = 0;
    while i < D {
        let row = at(correlations, i, [Coordinate::ZERO; D]);
        let mut j = 0;
        while j < D {
            let x = at(&row, j, Coordinate::ZERO).to_bits() as i64;
            let across = at(correlations, j, [Coordinate::ZERO; D]);
            let mirrored = at(&across, i, Coordinate::ZERO).to_bits() as i64;
            let x = x << 30;
            if mirrored << 30 != x || x.unsigned_abs() > WHOLE as u64 || i == j && x != WHOLE {
                return Err(Error::OutOfRange(2));
            }
            put_entry(&mut left, i, j, x);
            j += 1;
        }
        i += 1;
    }
    Ok(left)
}

impl<const D: usize> Factors<D> {
    /// The part of a variance that counts as rounding of a matrix, and so as 0; in Q60.
    const TOLERANCE: i64 = (D as i64) << 31;
    /// How far a matrix may be from one that is semi-definite.
    const ROOM: i64 = 4 * Self::TOLERANCE;

    /// Of the coordinates that vary.
    pub(super) const fn new(
        correlations: &Rows<Coordinate, D>,
        varies: [bool; D],
    ) -> Result<Self, Error> {
        let mut left = match checked(correlations) {
            Ok(left) => left,
            Err(error) => return Err(error),
        };
        let mut all = Self {
            factor: [[0; D]; D],
            diagonal: [(0, 0); D],
            order: [0; D],
            rank: 0,
        };
        let mut open = varies;
        while let Some(p) = Self::pivot(&left, &open) {
            let most = entry(&left, p, p);
            let zeros = most.leading_zeros() & !1;
            let root = ((most as u64) << zeros).isqrt();
            put(
                &mut all.diagonal,
                p,
                (root as u32, (30 + (zeros >> 1)) as i32),
            );
            // The root in Q60.
            let diagonal = (root as u128) << (30 - (zeros >> 1));
            put(&mut open, p, false);
            put_entry(&mut all.factor, p, p, (diagonal >> 28) as i64);
            let mut i = 0;
            while i < D {
                let part = entry(&left, i, p);
                if at(&open, i, false) {
                    // Of a matrix that is semi-definite the square of a part is at most the product of the variances.
                    let (square, own) =
                        (part as i128 * part as i128, entry(&left, i, i) + Self::ROOM);
                    if square > most as i128 * own as i128 {
                        return Err(Error::NotNormalizable(2));
                    }
                    put_entry(&mut all.factor, i, p, divided(part as i128, diagonal, 32));
                }
                i += 1;
            }
            Self::eliminate(&mut left, &open, p);
            put(&mut all.order, all.rank, p as u8);
            all.rank += 1;
        }
        if Self::is_left(&left, &open) {
            return Err(Error::NotNormalizable(2));
        }
        let (mut i, mut place) = (0, all.rank);
        while i < D {
            if at(&open, i, false) || !at(&varies, i, false) {
                put(&mut all.order, place, i as u8);
                place += 1;
            }
            i += 1;
        }
        Ok(all)
    }

    /// The open coordinate of which the others leave the largest part; the first of those that are equal but for rounding.
    const fn pivot(left: &Rows<i64, D>, open: &[bool; D]) -> Option<usize> {
        let (mut most, mut pivot, mut i) = (Self::TOLERANCE, None, 0);
        while i < D {
            if at(open, i, false) && entry(left, i, i) > most {
                (most, pivot) = (entry(left, i, i) + EQUAL, Some(i));
            }
            i += 1;
        }
        pivot
    }

    /// Takes from the open coordinates what one determines of them.
    const fn eliminate(left: &mut Rows<i64, D>, open: &[bool; D], p: usize) {
        let most = entry(left, p, p) as u128;
        let mut i = 0;
        while i < D {
            let mut j = 0;
            while j < D && at(open, i, false) {
                if at(open, j, false) {
                    let product = entry(left, i, p) as i128 * entry(left, j, p) as i128;
                    let rest = entry(left, i, j) - divided(product, most << 60, 60);
                    put_entry(left, i, j, rest);
                }
                j += 1;
            }
            i += 1;
        }
    }

    /// Whether more than rounding is left between open coordinates.
    const fn is_left(left: &Rows<i64, D>, open: &[bool; D]) -> bool {
        let mut i = 0;
        while i < D {
            let mut j = 0;
            while j < D && at(open, i, false) {
                let rest = entry(left, i, j);
                // A variance is at most the tolerance here.
                if at(open, j, false) && rest.unsigned_abs() > Self::ROOM as u64 {
                    return true;
                }
                j += 1;
            }
            i += 1;
        }
        false
    }
}
