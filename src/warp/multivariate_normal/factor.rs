//! A covariance matrix taken apart: by elimination with pivots, in twice the digits of `f32`, in units of powers of two near
//! the standard deviations. So neither the condition of the matrix nor the units of its coordinates cost digits.

use crate::error::Error;
use crate::num::double_word::{DoubleWord, plus, times};
use crate::num::{Scaled, quick_two_sum, remainder, two_sum};
use crate::tier::sqrt;

/// The rows of a matrix.
pub(super) type Rows<X, const D: usize> = [[X; D]; D];

/// What sampling and densities need of a covariance matrix.
pub(super) struct Factors<const D: usize> {
    /// A with Σ = A Aᵀ. The column of a coordinate that others determine is 0.
    pub factor: Rows<f32, D>,
    /// A⁻¹, in two parts. The row of a coordinate that others determine gives how far it is from what they say, in a unit of
    /// its own.
    pub inverse: Rows<DoubleWord, D>,
    /// Whether a coordinate has randomness of its own.
    pub free: [bool; D],
    /// The product of the diagonal of A.
    pub content: Scaled,
}

/// Half the exponent of a number.
#[inline]
fn half_exponent(x: f32) -> i32 {
    Scaled::of(x).parts().1 >> 1
}

/// x/2^by, exactly but for what is subnormal then.
fn lowered(x: f32, by: i32) -> f32 {
    if x.abs() > 0.0 {
        let raised = Scaled::of(x.abs()).raised(by.wrapping_neg());
        raised.value().copysign(x)
    } else {
        0.0
    }
}

/// a/b to twice the digits.
fn quotient(a: DoubleWord, b: DoubleWord) -> DoubleWord {
    let first = a.0 / b.0;
    let rest = (remainder(a.0, first, b.0) + (a.1 - first * b.1)) / b.0;
    quick_two_sum(first, rest)
}

/// √a to twice the digits.
fn root(a: DoubleWord) -> DoubleWord {
    let first = sqrt(a.0);
    let rest = (remainder(a.0, first, first) + a.1) / (first + first);
    quick_two_sum(first, rest)
}

/// Subtracts a multiple of one row from another.
fn subtract<const D: usize>(row: &mut [DoubleWord; D], by: DoubleWord, other: &[DoubleWord; D]) {
    let by = (-by.0, -by.1);
    for (x, y) in row.iter_mut().zip(other) {
        let (sum, rest) = plus(*x, times(by, *y));
        *x = two_sum(sum, rest);
    }
}

/// The number at a place, and 0 beyond the last.
#[inline]
fn at<const D: usize>(row: &[DoubleWord; D], place: usize) -> DoubleWord {
    row.get(place).copied().unwrap_or((0.0, 0.0))
}

/// A matrix in units of powers of two, of which half the exponents are told, and its diagonal, which then lies in [1, 4).
/// There a variance counts as at least the smallest normal number: smaller ones have lost digits.
type InOwnUnits<const D: usize> = (Rows<DoubleWord, D>, [i32; D], [f32; D]);

fn in_own_units<const D: usize>(
    covariance: &Rows<f32, D>,
    room: f32,
) -> Result<InOwnUnits<D>, Error> {
    let mut halves = [0; D];
    let mut variances = [0.0; D];
    for (i, (row, (half, variance))) in (covariance.iter())
        .zip(halves.iter_mut().zip(&mut variances))
        .enumerate()
    {
        if !row.iter().all(|x| x.is_finite()) {
            return Err(Error::NotFinite(1));
        }
        let own = row.get(i).copied().unwrap_or(0.0);
        if own < 0.0 {
            return Err(Error::Negative(1));
        }
        let own = own.max(f32::MIN_POSITIVE);
        *half = half_exponent(own);
        *variance = lowered(own, half.wrapping_add(*half));
    }
    let mut matrix = [[(0.0, 0.0); D]; D];
    for (i, row) in matrix.iter_mut().enumerate() {
        let (half, variance) = (halves.get(i), variances.get(i));
        let (half, variance) = (*half.unwrap_or(&0), *variance.unwrap_or(&0.0));
        let line = covariance.get(i).unwrap_or(&[0.0; D]);
        let across = covariance.iter().filter_map(|other| other.get(i));
        for ((to, (x, mirrored)), (other, v)) in
            (row.iter_mut().zip(line.iter().zip(across))).zip(halves.iter().zip(&variances))
        {
            let by = half.wrapping_add(*other);
            let (a, b) = (lowered(*x, by), lowered(*mirrored, by));
            let apart = a - b;
            let same = x.to_bits() == mirrored.to_bits();
            if !(same || apart * apart <= room * room * (variance * v)) {
                return Err(Error::OutOfRange(1));
            }
            // No covariance is larger than the root of the product of the variances, which is below 4.
            if !(a.abs() < 5.0 && b.abs() < 5.0) {
                return Err(Error::NotNormalizable(1));
            }
            *to = two_sum(0.5 * a, 0.5 * b);
        }
    }
    Ok((matrix, halves, variances))
}

impl<const D: usize> Factors<D> {
    /// The share of a variance that counts as rounding of a matrix, and so as 0.
    const TOLERANCE: f32 = D as f32 * 2.0 * f32::EPSILON;
    /// How far a matrix may be from a symmetric one, and from one that is semi-definite.
    const ROOM: f32 = 4.0 * Self::TOLERANCE;

    pub(super) fn new(covariance: &Rows<f32, D>) -> Result<Self, Error> {
        let (mut left, halves, variances) = in_own_units(covariance, Self::ROOM)?;
        let mut inverse = [[(0.0, 0.0); D]; D];
        let mut own = [[(0.0, 0.0); D]; D];
        for (i, row) in inverse.iter_mut().enumerate() {
            if let Some(one) = row.get_mut(i) {
                *one = (1.0, 0.0);
            }
        }
        let (mut free, mut content) = ([false; D], Scaled::ONE);
        for _ in 0..D {
            // The coordinate of which the others leave the largest share; the first of equals.
            let (mut most, mut pivot) = (Self::TOLERANCE, None);
            for (i, (row, (variance, taken))) in
                (left.iter()).zip(variances.iter().zip(&free)).enumerate()
            {
                let share = at(row, i).0 / variance;
                if !taken && share > most {
                    (most, pivot) = (share, Some((i, *row)));
                }
            }
            let Some((p, column)) = pivot else { break };
            let diagonal = root(at(&column, p));
            let along = column.map(|x| quotient(x, diagonal));
            let mut mine = *inverse.get(p).unwrap_or(&[(0.0, 0.0); D]);
            mine = mine.map(|x| quotient(x, diagonal));
            for (i, ((row, to), (from, taken))) in (left.iter_mut().zip(&mut inverse))
                .zip(own.iter_mut().zip(&mut free))
                .enumerate()
            {
                let (mut part, this) = (at(&along, i), i == p);
                if this {
                    (*to, *taken, part) = (mine, true, diagonal);
                } else if *taken {
                    continue;
                } else {
                    subtract(row, part, &along);
                    subtract(to, part, &mine);
                }
                if let Some(entry) = from.get_mut(p) {
                    *entry = part;
                }
            }
            let half = halves.get(p).copied().unwrap_or(0);
            content = content.times(Scaled::of(diagonal.0).raised(half));
        }
        for (i, (row, (variance, taken))) in
            (left.iter()).zip(variances.iter().zip(&free)).enumerate()
        {
            for (j, (x, (other, known))) in row.iter().zip(variances.iter().zip(&free)).enumerate()
            {
                let room = Self::ROOM * Self::ROOM * (variance * other);
                let nothing = x.0 * x.0 <= room || i == j && x.0 >= 0.0;
                if !(*taken || *known || nothing) {
                    return Err(Error::NotNormalizable(1));
                }
            }
        }
        Ok(Self {
            factor: scaled(own, halves, |half, _| half).map(|row| row.map(|x| x.0)),
            inverse: scaled(inverse, halves, |_, half: i32| half.wrapping_neg()),
            free,
            content,
        })
    }
}

/// Each entry times the power of two whose exponent comes of those of its row and of its column.
fn scaled<const D: usize>(
    mut matrix: Rows<DoubleWord, D>,
    halves: [i32; D],
    by: impl Fn(i32, i32) -> i32,
) -> Rows<DoubleWord, D> {
    for (row, half) in matrix.iter_mut().zip(&halves) {
        for (x, other) in row.iter_mut().zip(&halves) {
            let by = by(*half, *other).wrapping_neg();
            *x = (lowered(x.0, by), lowered(x.1, by));
        }
    }
    matrix
}
