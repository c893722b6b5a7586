//! Jittered strata in one and two dimensions, without storage.

use super::{STEP, Uniforms, deep_from_word, infallible};
use crate::error::Error;
use rand_core::{Rng, TryRng};

/// The most strata along one axis: 2²³, so that every stratum holds at least two grid points, and the middle of a cell that
/// is drawn.
pub const MAX_STRATA: u32 = 1 << 23;

/// Divides [0, 1) into `count` strata of equal width; each gives one jittered point.
///
/// Domain: stratum `i` covers [i/n, (i+1)/n). Range: [0, 1). Uniforms: one a point, one word drawn.
/// A drawn point is the middle of a cell of words ([`deep_from_word`]) that (i + r)/n falls into, all 32 bits of r counted:
/// accurate to 2⁻²⁴ absolute, never 0, on average right. An explicit r gives (i + r)/n truncated to the 24-bit grid,
/// which on average lies 2⁻²⁵ low, and is 0 where r is 0 in the first stratum. A point never leaves [0, 1), and its own
/// stratum only by that rounding at a border that is not on the grid.
///
/// Source: D. P. Mitchell, "Consequences of Stratified Sampling in Graphics", 1996.
///
/// ```
/// use microwarp::uniform::Strata1d;
/// let strata = Strata1d::new(4)?;
/// assert_eq!(strata.point(3, 0.5), 0.875);
/// # Ok::<(), microwarp::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Strata1d {
    count: u32,
}

impl Strata1d {
    /// Divides the unit interval into `count` strata.
    ///
    /// # Errors
    /// [`Error::Empty`] for 0, [`Error::TooLarge`] above [`MAX_STRATA`].
    pub const fn new(count: u32) -> Result<Self, Error> {
        match count {
            0 => Err(Error::Empty),
            1..=MAX_STRATA => Ok(Self { count }),
            _ => Err(Error::TooLarge),
        }
    }

    /// The number of strata.
    #[must_use]
    pub const fn count(self) -> u32 {
        self.count
    }

    /// The point of stratum `i` (taken modulo the count) at the jitter `r`; any `f32` serves as `r`.
    #[must_use]
    #[inline]
    pub fn point(self, i: u32, r: f32) -> f32 {
        // In units of 2^-24, r is below 2^24, and its part below the unit is cut as that of the sum would be.
        let jitter = (r.canonical().get() * 16_777_216.0) as u32;
        self.place(i, jitter, 24) as f32 * STEP
    }

    /// Draws the jittered point of stratum `i` (taken modulo the count). One word.
    ///
    /// # Errors
    /// The generator's own error.
    #[inline]
    pub fn try_draw<R: TryRng + ?Sized>(self, i: u32, rng: &mut R) -> Result<f32, R::Error> {
        Ok(deep_from_word(self.place(i, rng.try_next_u32()?, 32)))
    }

    /// Draws the jittered point of stratum `i` (taken modulo the count). One word.
    #[inline]
    pub fn draw<R: Rng + ?Sized>(self, i: u32, rng: &mut R) -> f32 {
        infallible(self.try_draw(i, rng))
    }

    /// (i + r)/n in units of 2^−bits, cut, r being so many of them: below 2^bits.
    fn place(self, i: u32, jitter: u32, bits: u32) -> u32 {
        let i = remainder(i, self.count);
        // Below 2^23 and 2^32, so that integers hold the sum exactly.
        let scaled = u64::from(i).wrapping_shl(bits) | u64::from(jitter);
        scaled.checked_div(u64::from(self.count)).unwrap_or(0) as u32
    }
}

/// The remainder, without the panic of a division by 0 that the constructor has ruled out.
fn remainder(i: u32, count: u32) -> u32 {
    i.checked_rem(count).unwrap_or(0)
}

/// Divides [0, 1)² into `columns` × `rows` strata of equal area; each gives one jittered point.
///
/// Domain: stratum (i, j) covers [i/n, (i+1)/n) × [j/m, (j+1)/m). Range: [0, 1)². Uniforms: two a
/// point, two words drawn (the column's jitter first). Accuracy as for [`Strata1d`].
///
/// Source: R. L. Cook, "Stochastic Sampling in Computer Graphics", 1986.
///
/// ```
/// use microwarp::uniform::Strata2d;
/// use rand_pcg::Pcg32;
/// let (strata, mut rng) = (Strata2d::new(8, 4)?, Pcg32::new(7, 1));
/// for k in 0..strata.count() {
///     let [u, v] = strata.draw(k, &mut rng);
///     assert!(u < 1.0 && v < 1.0);
/// }
/// # Ok::<(), microwarp::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Strata2d {
    columns: Strata1d,
    rows: Strata1d,
}

impl Strata2d {
    /// Divides the unit square into `columns` × `rows` strata.
    ///
    /// # Errors
    /// [`Error::Empty`] if either is 0; [`Error::TooLarge`] above [`MAX_STRATA`] along an axis or
    /// where the number of strata exceeds `u32`.
    pub const fn new(columns: u32, rows: u32) -> Result<Self, Error> {
        match (
            Strata1d::new(columns),
            Strata1d::new(rows),
            columns.checked_mul(rows),
        ) {
            (Ok(columns), Ok(rows), Some(_)) => Ok(Self { columns, rows }),
            (Err(e), _, _) | (_, Err(e), _) => Err(e),
            _ => Err(Error::TooLarge),
        }
    }

    /// The number of strata, columns × rows.
    #[must_use]
    pub const fn count(self) -> u32 {
        self.columns.count.wrapping_mul(self.rows.count)
    }

    /// The point of stratum `k`, counted row by row and taken modulo the count, at the jitter `r`.
    #[must_use]
    #[inline]
    pub fn point(self, k: u32, r: [f32; 2]) -> [f32; 2] {
        let [x, y] = r;
        let (i, j) = self.cell(k);
        [self.columns.point(i, x), self.rows.point(j, y)]
    }

    /// Draws the jittered point of stratum `k`, counted row by row. Two words.
    ///
    /// # Errors
    /// The generator's own error.
    #[inline]
    pub fn try_draw<R: TryRng + ?Sized>(self, k: u32, rng: &mut R) -> Result<[f32; 2], R::Error> {
        let (i, j) = self.cell(k);
        Ok([self.columns.try_draw(i, rng)?, self.rows.try_draw(j, rng)?])
    }

    /// Draws the jittered point of stratum `k`, counted row by row. Two words.
    #[inline]
    pub fn draw<R: Rng + ?Sized>(self, k: u32, rng: &mut R) -> [f32; 2] {
        infallible(self.try_draw(k, rng))
    }

    fn cell(self, k: u32) -> (u32, u32) {
        let row = k.checked_div(self.columns.count).unwrap_or(0);
        (
            remainder(k, self.columns.count),
            remainder(row, self.rows.count),
        )
    }
}
