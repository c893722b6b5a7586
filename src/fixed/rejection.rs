//! The unit disk by rejection from its square, on integers alone.

#![expect(
    clippy::arithmetic_side_effects,
    reason = "nothing overflows, which builds with overflow checks show"
)]

use super::Density;
use crate::error::Error;
use crate::rejection::{Failure, Rejection, checked_budget};
use ::fixed::types::{I2F30, U0F32};
use rand_core::TryRng;

/// The odd number from −65535 to 65535 whose index, counted from 0, is the upper half of a word.
#[inline]
#[expect(clippy::cast_possible_wrap, reason = "17 bits at most")]
const fn coarse(word: u32) -> i32 {
    ((word >> 16) << 1 | 1) as i32 - (1 << 16)
}

/// The odd number from −(2³⁰ − 1) to 2³⁰ − 1 whose index is the first 30 bits of a word: within the cell of the
/// coarse one, by less than half of its width of 2¹⁵.
#[inline]
#[expect(clippy::cast_possible_wrap, reason = "31 bits at most")]
const fn fine(word: u32) -> i32 {
    (word >> 1 | 1) as i32 - (1 << 30)
}

/// The sum of the squares of two coarse numbers, and whether it is beyond 2³², modulo which it is given.
#[inline]
const fn squares(x: i32, y: i32) -> (u32, bool) {
    // A square has 32 bits at most, so that no sign is lost by multiplying without.
    let x = (x as u32).wrapping_mul(x as u32);
    let y = (y as u32).wrapping_mul(y as u32);
    x.overflowing_add(y)
}

/// Whether two fine numbers are those of a point of the disk: exactly, by products of 64 bits.
#[cold]
#[inline(never)]
const fn inside(x: i32, y: i32) -> bool {
    let (x, y) = (x as i64, y as i64);
    // Squares of odd numbers are 1 modulo 8, so that their sum is never that of the radius.
    x * x + y * y < 1 << 60
}

/// 1/π and 0, in steps of 2⁻³².
#[inline]
fn density([x, y]: [I2F30; 2]) -> Density {
    let square = |c: I2F30| {
        let c = u64::from(c.to_bits().unsigned_abs());
        c * c
    };
    // At most 2^62 each.
    if square(x) + square(y) <= 1 << 60 {
        Density::FRAC_1_PI
    } else {
        Density::ZERO
    }
}

/// Uniform on the unit disk, by rejection from the square around it, from two words a try.
///
/// - Uniforms: two, a try. Words a try: two. Only the first 30 bits of each count.
/// - Range: x² + y² < 1, exactly. Coordinates are odd multiples of 2⁻³⁰, symmetric about 0; each such point of
///   the disk is equally likely.
/// - Density: 1/π per unit area, off by 2⁻³³ at most.
/// - Efficiency: π/4.
/// - No product of 64 bits but in 2 tries of 10,000, no division, no table; where the number of tries must be
///   constant, take a warp.
///
/// Source: J. von Neumann, "Various Techniques Used in Connection with Random Digits", 1951.
///
/// ```
/// use microwarp::{fixed as mw, rejection::Rejection};
/// use rand_pcg::Pcg32;
/// let disk = mw::DiskRejection::new();
/// let [x, y] = disk.draw(&mut Pcg32::new(1, 1))?.point;
/// assert!(x * x + y * y < 1);
/// assert_eq!(disk.attempt([mw::Uniform::ZERO; 2]), None); // a corner of the square
/// # Ok::<(), microwarp::rejection::Failure>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct DiskRejection {
    budget: u32,
}

/// Uniform on the unit disk, by rejection from the square around it, from one word a try: 16 bits a coordinate.
///
/// - Words a try: one. Its upper half is x, the lower y.
/// - Range: x² + y² < 1, exactly. Coordinates are odd multiples of 2⁻¹⁶, symmetric about 0; each of the
///   3,373,259,248 such points of the disk is one word.
/// - Density: 1/π per unit area, of the cells of the grid; off by 2⁻³³ at most.
/// - Efficiency: π/4, less 4.1e-8.
/// - No product of 64 bits, no division, no table.
///
/// Source: J. von Neumann, "Various Techniques Used in Connection with Random Digits", 1951.
///
/// ```
/// use microwarp::{fixed as mw, rejection::Rejection};
/// use rand_pcg::Pcg32;
/// let disk = mw::DiskRejection16::new();
/// let [x, y] = disk.draw(&mut Pcg32::new(1, 1))?.point;
/// assert!(x * x + y * y < 1);
/// assert_eq!(disk.attempt(0x8000_7fff), Some([mw::Coordinate::from_bits(1 << 14), mw::Coordinate::from_bits(-1 << 14)]));
/// # Ok::<(), microwarp::rejection::Failure>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct DiskRejection16 {
    budget: u32,
}

impl DiskRejection {
    /// The share of proposals that is accepted, π/4.
    pub const EFFICIENCY: U0F32 = U0F32::FRAC_PI_4;

    /// One try with uniforms of one's own; `None` if the point lies outside.
    #[must_use]
    #[inline]
    pub fn attempt(&self, u: [U0F32; 2]) -> Option<[I2F30; 2]> {
        /// How near to the rim the coarse numbers do not decide, in units of their squares: a fine number is off
        /// its cell's middle by d < 2^14 units of 2^-30, its square by less than 2^31 d + d², and both together by
        /// less than 2^18 + 2 of these units.
        const NEAR: u32 = 1 << 19;
        let [a, b] = u.map(U0F32::to_bits);
        let (x, y) = (fine(a), fine(b));
        let (square, beyond) = squares(coarse(a), coarse(b));
        // Near 0, which is as good as 2^32 here, the products of 64 bits say the same.
        let accepted = if square.wrapping_add(NEAR) < 2 * NEAR {
            inside(x, y)
        } else {
            !beyond
        };
        accepted.then(|| [x, y].map(I2F30::from_bits))
    }
}

impl DiskRejection16 {
    /// The share of proposals that is accepted, exactly.
    pub const EFFICIENCY: U0F32 = U0F32::from_bits(3_373_259_248);

    /// One try with a word of one's own; `None` if the point lies outside.
    #[must_use]
    #[inline]
    pub fn attempt(&self, word: u32) -> Option<[I2F30; 2]> {
        let (x, y) = (coarse(word), coarse(word << 16));
        // A sum of 2^32 itself there is none: squares of odd numbers are 1 modulo 8.
        let (_, beyond) = squares(x, y);
        (!beyond).then(|| [x, y].map(|c| I2F30::from_bits(c << 14)))
    }
}

/// What both have in common.
macro_rules! disks {
    ($($name:ident, $rng:ident => $words:expr;)*) => {$(
        impl $name {
            /// The budget of [`Self::new`]. A true random generator spends it with a probability below
            /// 2⁻⁶⁴.
            pub const BUDGET: u32 = 32;

            /// With the default budget.
            #[must_use]
            pub const fn new() -> Self {
                Self {
                    budget: Self::BUDGET,
                }
            }

            /// With at most `budget` tries a point.
            ///
            /// # Errors
            /// [`Error::NotPositive`] for a budget of 0.
            pub const fn with_budget(budget: u32) -> Result<Self, Error> {
                match checked_budget(budget) {
                    Ok(budget) => Ok(Self { budget }),
                    Err(e) => Err(e),
                }
            }

            /// The density at a point; 0 outside.
            #[must_use]
            #[inline]
            pub fn pdf(&self, point: [I2F30; 2]) -> Density {
                density(point)
            }
        }

        impl Default for $name {
            fn default() -> Self {
                Self::new()
            }
        }

        impl Rejection for $name {
            type Point = [I2F30; 2];

            #[inline]
            fn budget(&self) -> u32 {
                self.budget
            }

            #[inline]
            fn try_once<R: TryRng + ?Sized>(
                &self,
                $rng: &mut R,
            ) -> Result<Option<[I2F30; 2]>, Failure<R::Error>> {
                Ok(self.attempt($words))
            }
        }
    )*};
}

disks! {
    DiskRejection, rng => [
        U0F32::from_bits(rng.try_next_u32().map_err(Failure::Generator)?),
        U0F32::from_bits(rng.try_next_u32().map_err(Failure::Generator)?),
    ];
    DiskRejection16, rng => rng.try_next_u32().map_err(Failure::Generator)?;
}
