//! Jittered strata in one and two dimensions, without storage.

use super::{STEP, Uniforms, deep_from_word, infallible};
use crate::error::Error;
use rand_core::{Rng, TryRng};

/// The largest number of strata along one axis: 2²³. Every stratum then holds at least two points of the grid, and the
/// middle of a cell.
pub const MAX_STRATA: u32 = 1 << 23;

/// Jittered sampling of [0, 1): `count` strata of equal width, each with one point at random.
///
/// Uniforms for a warp: the points of all strata cover [0, 1) more evenly than independent ones.
///
#[cfg_attr(doc, doc = include_str!("../pictures/strata1d.html"))]
///
/// # Domain
/// - Stratum `i` covers [i/n, (i+1)/n).
/// - Uniforms: one for each point, the jitter r; one word where it is drawn.
/// - Parameters: 1 to [`MAX_STRATA`] strata.
///
/// # Accuracy
/// A drawn point is the middle of the cell of words ([`deep_from_word`]) that (i + r)/n falls into, with all 32 bits of r:
/// accurate to 2⁻²⁴ absolute, never 0, and without bias. An explicit r gives (i + r)/n truncated to the 24-bit grid, which
/// lies 2⁻²⁵ low on average, and is 0 for r = 0 in the first stratum. A point never leaves [0, 1). It leaves its stratum
/// only by that rounding, at a border that is not on the grid.
///
/// # Examples
/// ```
/// use microwarp::uniform::Strata1d;
/// let strata = Strata1d::new(4)?;
/// assert_eq!(strata.point(3, 0.5), 0.875);
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// # See also
/// - [`Strata2d`]: the unit square.
///
/// # Source
/// D. P. Mitchell, "Consequences of Stratified Sampling in Graphics", 1996, <https://doi.org/10.1145/237170.237265>.
#[doc(alias = "stratified")]
#[doc(alias = "jitter")]
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
            0 => Err(Error::Empty(0)),
            1..=MAX_STRATA => Ok(Self { count }),
            _ => Err(Error::TooLarge(0)),
        }
    }

    /// The number of strata.
    #[must_use]
    pub const fn count(self) -> u32 {
        self.count
    }

    /// The point of stratum `i` (modulo the count) at the jitter `r` in [0, 1). Other `r`, and NaN, are brought into range.
    #[must_use]
    #[inline]
    pub fn point(self, i: u32, r: f32) -> f32 {
        // In units of 2^-24. Truncating r truncates the sum in the same way.
        let jitter = (r.canonical().get() * 16_777_216.0) as u32;
        self.place(i, jitter, 24) as f32 * STEP
    }

    /// Draws the jittered point of stratum `i` (modulo the count) from a generator that can fail. One word.
    ///
    /// # Errors
    /// The generator's own error.
    #[inline]
    pub fn try_draw<R: TryRng + ?Sized>(self, i: u32, rng: &mut R) -> Result<f32, R::Error> {
        Ok(deep_from_word(self.place(i, rng.try_next_u32()?, 32)))
    }

    /// Draws the jittered point of stratum `i` (modulo the count). One word.
    #[inline]
    pub fn draw<R: Rng + ?Sized>(self, i: u32, rng: &mut R) -> f32 {
        infallible(self.try_draw(i, rng))
    }

    /// (i + r)/n in units of 2^−bits, truncated. `jitter` is r in these units.
    fn place(self, i: u32, jitter: u32, bits: u32) -> u32 {
        let i = remainder(i, self.count);
        // i is below 2^23 and the jitter below 2^32, so the sum is exact.
        let scaled = u64::from(i).wrapping_shl(bits) | u64::from(jitter);
        scaled.checked_div(u64::from(self.count)).unwrap_or(0) as u32
    }
}

/// The remainder, without the panic of a division by 0. The constructor has excluded that.
fn remainder(i: u32, count: u32) -> u32 {
    i.checked_rem(count).unwrap_or(0)
}

/// Jittered sampling of [0, 1)²: `columns` × `rows` strata of equal area, each with one point at random.
///
#[cfg_attr(doc, doc = include_str!("../pictures/strata2d.html"))]
///
/// # Domain
/// - Stratum (i, j) covers [i/n, (i+1)/n) × [j/m, (j+1)/m).
/// - Uniforms: two for each point, the jitter of the column first; two words where they are drawn.
/// - Parameters: 1 to [`MAX_STRATA`] columns and rows, fewer than 2³² strata.
///
/// # Accuracy
/// That of [`Strata1d`] in each coordinate.
///
/// # Examples
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
///
/// # See also
/// - [`Strata1d`]: the unit interval.
/// - [`warp::DiskConcentric`](crate::warp::DiskConcentric),
///   [`warp::MalleyHemisphere`](crate::warp::MalleyHemisphere): warps that keep strata compact.
///
/// # Source
/// R. L. Cook, "Stochastic Sampling in Computer Graphics", 1986, <https://doi.org/10.1145/7529.8927>.
#[doc(alias = "stratified")]
#[doc(alias = "jitter")]
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
    /// [`Error::Empty`] if either is 0, [`Error::TooLarge`] above [`MAX_STRATA`] along an axis, or if the number of strata
    /// exceeds `u32`.
    pub const fn new(columns: u32, rows: u32) -> Result<Self, Error> {
        match (
            Strata1d::new(columns),
            Strata1d::new(rows),
            columns.checked_mul(rows),
        ) {
            (Ok(columns), Ok(rows), Some(_)) => Ok(Self { columns, rows }),
            (Err(e), _, _) => Err(e),
            (_, Err(e), _) => Err(e.at(1)),
            _ => Err(Error::TooLarge(1)),
        }
    }

    /// The number of strata, columns × rows.
    #[must_use]
    pub const fn count(self) -> u32 {
        self.columns.count.wrapping_mul(self.rows.count)
    }

    /// The point of stratum `k`, counted row by row modulo the count, at the jitter `r`.
    #[must_use]
    #[inline]
    pub fn point(self, k: u32, r: [f32; 2]) -> [f32; 2] {
        let [x, y] = r;
        let (i, j) = self.cell(k);
        [self.columns.point(i, x), self.rows.point(j, y)]
    }

    /// Draws the jittered point of stratum `k`, counted row by row, from a generator that can fail. Two words.
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
