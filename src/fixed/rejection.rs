//! The unit disk by rejection from its square, on integers alone.

#![expect(
    clippy::arithmetic_side_effects,
    reason = "builds with overflow checks show that nothing overflows"
)]
#![expect(
    clippy::cast_possible_wrap,
    reason = "words are read as signed numbers"
)]

use super::Density;
use super::disk::uniform_density;
use crate::rejection::{Failure, budgeted, short_tries};
use ::fixed::types::{I2F30, U0F32};

/// The squared radius, in the units of h² + k².
const RIM: u32 = 1 << 30;

/// h² + k². It differs by less than 2¹⁸ from 2³⁰(x² + y²) if 2¹⁵x and 2¹⁵y differ by at most 1 from h and k.
#[inline]
const fn squares(h: i32, k: i32) -> u32 {
    (h * h) as u32 + (k * k) as u32
}

/// Whether a point lies inside. Its sum of squares tells where it differs from the rim by more than 2²³, as in 98.8 tries of
/// 100, and one instruction compares it; elsewhere `exact` tells.
#[inline]
fn inside(sum: u32, exact: impl FnOnce() -> bool) -> bool {
    const NEAR: u32 = 1 << 23;
    sum < RIM - NEAR || (sum < RIM + NEAR && exact())
}

/// Whether the sum of the squares of two odd numbers is below 2⁶⁰, exactly, by products of 64 bits.
#[cold]
#[inline(never)]
const fn long_inside(x: i32, y: i32) -> bool {
    let (x, y) = (x as i64, y as i64);
    x * x + y * y < 1 << 60
}

/// Uniform on the unit disk, by rejection from the square around it, from two words a try.
///
/// # Density
/// 1/π per unit area where x² + y² ≤ 1, to 2⁻³³; 0 elsewhere.
///
/// # Domain
/// - Point: x² + y² < 1, exactly. Coordinates are odd multiples of 2⁻³⁰, symmetric about 0. Each such point of the disk
///   is equally likely.
/// - Words a try: two, of which only the first 30 bits count. They are read as signed numbers: a coordinate is 2u for u
///   below ½, and 2u − 2 from there on.
///
/// # Accuracy
/// Samples are exact.
///
/// # Cost
/// Efficiency: π/4. Only 1 try in 85 needs a product of 64 bits. There is no division and no table.
///
/// # Examples
/// ```
/// use microwarp::{fixed as mw, rejection::Rejection};
/// use rand_pcg::Pcg32;
/// let disk = mw::DiskRejection::new();
/// let [x, y] = disk.draw(&mut Pcg32::new(1, 1))?.point;
/// assert!(x * x + y * y < 1);
/// assert_eq!(disk.attempt([mw::Uniform::from_num(0.49); 2]), None); // in a corner of the square
/// # Ok::<(), microwarp::rejection::Failure>(())
/// ```
///
/// # See also
/// - [`DiskRejection16`] takes one word a try, for coordinates of 16 bits.
/// - [`Disk`](super::Disk) takes a fixed number of words.
/// - [`rejection::DiskRejection`](crate::rejection::DiskRejection) gives points in `f32`.
///
/// # Source
/// J. von Neumann, "Various Techniques Used in Connection with Random Digits", National Bureau of Standards Applied
/// Mathematics Series 12, 1951.
#[doc(alias = "circle")]
#[doc(alias = "uniform")]
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct DiskRejection {
    budget: u32,
}

/// Uniform on the unit disk, by rejection from the square around it, from one word a try: 16 bits a coordinate.
///
/// # Density
/// 1/π per unit area where x² + y² ≤ 1, spread over the cells of the grid, to 2⁻³³; 0 elsewhere.
///
/// # Domain
/// - Point: x² + y² < 1, exactly. Coordinates are odd multiples of 2⁻¹⁶, symmetric about 0. Each of the 3,373,259,248 such
///   points of the disk belongs to one word.
/// - Words a try: one. Its halves are x, then y, as signed numbers.
///
/// # Accuracy
/// Samples are exact.
///
/// # Cost
/// Efficiency: π/4, less 4.1e-8. There is no product of 64 bits, no division and no table.
///
/// # Examples
/// ```
/// use microwarp::{fixed as mw, rejection::Rejection};
/// use rand_pcg::Pcg32;
/// let disk = mw::DiskRejection16::new();
/// let [x, y] = disk.draw(&mut Pcg32::new(1, 1))?.point;
/// assert!(x * x + y * y < 1);
/// assert_eq!(disk.attempt(0x7fff_7fff), None); // a corner of the square
/// # Ok::<(), microwarp::rejection::Failure>(())
/// ```
///
/// # See also
/// - [`DiskRejection`] has coordinates of 30 bits, from two words a try.
/// - [`Disk`](super::Disk) takes a fixed number of words.
///
/// # Source
/// J. von Neumann, "Various Techniques Used in Connection with Random Digits", National Bureau of Standards Applied
/// Mathematics Series 12, 1951.
#[doc(alias = "circle")]
#[doc(alias = "uniform")]
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct DiskRejection16 {
    budget: u32,
}

impl DiskRejection {
    /// The share of proposals that is accepted, π/4.
    pub const EFFICIENCY: U0F32 = U0F32::FRAC_PI_4;

    /// One try with the given uniforms; `None` if the point lies outside.
    #[must_use]
    #[inline]
    pub fn attempt(&self, u: [U0F32; 2]) -> Option<[I2F30; 2]> {
        let [a, b] = u.map(|u| u.to_bits() as i32);
        let (x, y) = (a >> 1 | 1, b >> 1 | 1);
        let sum = squares(a >> 16, b >> 16);
        let accepted = inside(sum, || long_inside(x, y));
        accepted.then(|| [x, y].map(I2F30::from_bits))
    }
}

impl DiskRejection16 {
    /// The share of proposals that is accepted, exactly.
    pub const EFFICIENCY: U0F32 = U0F32::from_bits(3_373_259_248);

    /// One try with the given word; `None` if the point lies outside.
    #[must_use]
    #[inline]
    pub fn attempt(&self, word: u32) -> Option<[I2F30; 2]> {
        let word = word as i32;
        let (h, k) = (word >> 16, word << 16 >> 16);
        let sum = squares(h, k);
        // (2h + 1)² + (2k + 1)² < 2³², divided by 4. The sum is then an integer and 1/2.
        let accepted = inside(sum, || (sum as i32) + h + k < RIM as i32);
        let [x, y] = [h, k].map(|h| (2 * h + 1) << 14);
        accepted.then(|| [x, y].map(I2F30::from_bits))
    }
}

/// What both disks have in common.
macro_rules! disks {
    ($($name:ident, $rng:ident => $words:expr;)*) => {$(
        budgeted!($name, 32);
        short_tries!($name: [I2F30; 2], |disk, $rng| Ok(disk.attempt($words)));

        impl $name {
            /// The density at a point; 0 outside.
            #[must_use]
            #[inline]
            pub fn pdf(&self, point: [I2F30; 2]) -> Density {
                uniform_density(point)
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
