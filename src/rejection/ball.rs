//! The unit disk and the unit ball by rejection from their boxes, on integers.

use super::{Failure, budgeted, short_tries};
use crate::uniform::Uniforms;
use core::f32::consts::{FRAC_1_PI, FRAC_PI_4, FRAC_PI_6};
use rand_core::TryRng;

/// 2²⁴, the radius in units of the grid.
const RADIUS: u32 = 1 << 24;

/// The odd number from −(2²⁴ − 1) to 2²⁴ − 1 with this index, counted from 0.
#[inline]
#[expect(
    clippy::cast_possible_wrap,
    reason = "two's complement is what is meant"
)]
const fn odd(index: u32) -> i32 {
    // The index is below 2²⁴.
    ((index << 1) | 1).wrapping_sub(RADIUS) as i32
}

/// The grid point of any uniforms, of which the first 24 bits count.
#[inline]
fn of_uniforms<const N: usize>(u: [f32; N]) -> [i32; N] {
    u.canonical().get().map(|u| odd((u * 16_777_216.0) as u32))
}

/// Draws a grid point, one word a coordinate. It is the one that [`of_uniforms`] returns for the uniforms of these words.
#[inline]
fn draw<const N: usize, R: TryRng + ?Sized>(rng: &mut R) -> Result<[i32; N], Failure<R::Error>> {
    let mut grid = [0; N];
    for m in &mut grid {
        *m = odd(rng.try_next_u32().map_err(Failure::Generator)? >> 8);
    }
    Ok(grid)
}

/// The point if it lies inside. Integers make this exact, and cheaper on cores without a floating-point unit.
#[inline]
fn accepted<const N: usize>(grid: [i32; N]) -> Option<[f32; N]> {
    // N squares of 48 bits fit easily in 63. Squares of odd numbers are 1 modulo 8, so their sum is never the squared
    // radius, and no point lies on the rim.
    let square = grid.iter().fold(0_i64, |sum, &m| {
        sum.wrapping_add(i64::from(m).wrapping_mul(i64::from(m)))
    });
    let inside = ((square >> 32) as u32) < 1 << 16;
    inside.then(|| grid.map(|m| m as f32 * (f32::EPSILON / 2.0)))
}

/// Uniform on the unit disk, by rejection from the square around it.
///
/// It uses no elementary function, and hence has no tier.
///
/// # Density
/// 1/π per unit area inside; 0 outside.
///
/// # Domain
/// - Point: x² + y² < 1, exactly. Coordinates are odd multiples of 2⁻²⁴, symmetric about 0. Each such point of the disk is
///   equally likely.
/// - Words a try: two, of which only the first 24 bits count.
///
/// # Accuracy
/// Samples are exact. The density has a relative error of 4.5e-8.
///
/// # Cost
/// Efficiency: π/4, so 1.27 tries a point on average.
///
/// # Examples
/// ```
/// use microwarp::rejection::{DiskRejection, Rejection};
/// use rand_pcg::Pcg32;
/// let disk = DiskRejection::new();
/// let [x, y] = disk.draw(&mut Pcg32::new(1, 1))?.point;
/// assert!(x * x + y * y <= 1.0);
/// assert_eq!(disk.attempt([0.0, 0.0]), None); // a corner of the square
/// # Ok::<(), microwarp::rejection::Failure>(())
/// ```
///
/// # See also
/// - [`warp::Disk`](crate::warp::Disk) and [`warp::DiskConcentric`](crate::warp::DiskConcentric) take a fixed number of
///   uniforms.
/// - [`BallRejection`] is the ball.
/// - `fixed::DiskRejection` and `fixed::DiskRejection16` give fixed-point numbers.
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

/// Uniform in the unit ball, by rejection from the cube around it.
///
/// It uses no elementary function, and hence has no tier.
///
/// # Density
/// 3/(4π) per unit volume inside; 0 outside.
///
/// # Domain
/// - Point: x² + y² + z² < 1, exactly. Coordinates are odd multiples of 2⁻²⁴, symmetric about 0. Each such point of the
///   ball is equally likely.
/// - Words a try: three, of which only the first 24 bits count.
///
/// # Accuracy
/// Samples are exact. The density has a relative error of 3e-8.
///
/// # Cost
/// Efficiency: π/6, so 1.91 tries a point on average.
///
/// # Examples
/// ```
/// use microwarp::rejection::{BallRejection, Rejection};
/// use rand_pcg::Pcg32;
/// let ball = BallRejection::new();
/// let point = ball.draw(&mut Pcg32::new(1, 1))?.point;
/// assert!((ball.pdf(point) - 0.238_732_4).abs() < 1e-7);
/// # Ok::<(), microwarp::rejection::Failure>(())
/// ```
///
/// # See also
/// - [`DiskRejection`] is the disk.
/// - [`warp::Sphere`](crate::warp::Sphere) is the surface of the ball.
/// - [`Region`](super::Region) keeps any part of a box.
///
/// # Source
/// J. von Neumann, "Various Techniques Used in Connection with Random Digits", National Bureau of Standards Applied
/// Mathematics Series 12, 1951.
#[doc(alias = "sphere")]
#[doc(alias = "uniform")]
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct BallRejection {
    budget: u32,
}

/// What disk and ball have in common.
macro_rules! unit_ball {
    ($name:ident, $dimensions:literal, $efficiency:expr, $budget:literal, $density:expr, $rim:expr) => {
        budgeted!($name, $budget);

        impl $name {
            /// The share of proposals that is accepted, by theory.
            pub const EFFICIENCY: f32 = $efficiency;

            /// One try with the given uniforms; `None` if the point lies outside.
            ///
            /// Any `f32` serves: the rule of [`Uniforms::canonical`] brings it into [0, 1).
            #[must_use]
            #[inline]
            pub fn attempt(&self, u: [f32; $dimensions]) -> Option<[f32; $dimensions]> {
                accepted(of_uniforms(u))
            }

            /// The density at a point. It is 0 outside and for NaN, and never 0 at a drawn point; rounding blurs
            /// the rim.
            #[must_use]
            #[inline]
            pub fn pdf(&self, point: [f32; $dimensions]) -> f32 {
                let square: f32 = point.iter().map(|c| c * c).sum();
                if square <= $rim { $density } else { 0.0 }
            }
        }

        short_tries!($name: [f32; $dimensions], |_sampler, rng| draw(rng).map(accepted));
    };
}

// Two squares whose exact sum is below 1 round to at most 1, three to at most the next `f32`.
unit_ball!(DiskRejection, 2, FRAC_PI_4, 32, FRAC_1_PI, 1.0);
unit_ball!(
    BallRejection,
    3,
    FRAC_PI_6,
    64,
    0.238_732_41,
    1.0 + f32::EPSILON
);
