//! The grades: three trades of accuracy, speed and flash for the integer kernels.

use super::kernel::{angle, exp, log, product, root, sine};
use ::fixed::types::{I2F30, U0F32, U5F27, U16F16};

mod sealed {
    /// The kernels of a grade on raw words.
    pub trait Kernels {
        /// The largest radius of a disk, in Q32, for which r² (sin² + cos²) is at most 1 at every phase.
        const RIM: u32;
        /// Below this z, in Q32, the truncated exponential uses four terms of its series. They are at least as accurate
        /// there as the logarithm, whose error is divided by z.
        const SERIES: u64;
        /// The largest relative excess, in Q31, of r² (sin² + cos²) over the exact r²: twice the errors of root, sine and
        /// cosine, and the rounding of the products.
        const BEYOND: u32;
        /// More than the error of a point of the unit disk that is turned about the centre and found again by its angle,
        /// in Q32.
        const ASTRAY: u32;
        fn sincos(phase: u32) -> (i32, i32);
        fn root(x: u32) -> u32;
        fn log(u: u32) -> u32;
        fn exp(x: u32) -> u32;
        fn angle(y: i32, x: i32) -> u32;
        /// A length in Q32 times a sine or cosine, in the format of the latter.
        fn scaled(length: u32, by: i32) -> i32;
    }
}
pub(super) use sealed::Kernels;

/// Elementary functions on fixed-point numbers, in one of three trades of speed, accuracy and flash.
///
/// [`Fine`] is the usual one, [`Coarse`] the fastest, [`Compact`] the smallest. Every warp of this tier takes a grade as a
/// parameter. The trait is sealed: no other grades exist. Each function accepts every word.
///
/// # Accuracy
/// The table holds the largest, the rms and the mean absolute error of the result. They cover all 2³² arguments, so that
/// the largest is proven, with two exceptions: `pow` covers one argument of every 8, and `atan2_turns`, whose errors are
/// in turns, 2²⁸ points of all magnitudes, so that its largest error is the largest found.
///
/// | function | [`Fine`] | [`Coarse`] | [`Compact`] |
/// |---|--:|--:|--:|
/// | `sincos_turns` | 1e-6, 2e-7, 0 | 8.3e-5, 4.3e-5, -1.3e-7 | 6.5e-7, 3.1e-7, 0 |
/// | `sqrt` | 2e-7, 4.2e-8, -7.4e-10 | 1.8e-5, 9e-6, -7.8e-6 | 6.1e-8, 2e-8, -1.6e-8 |
/// | `neg_ln_1m` | 5.2e-7, 1.8e-7, 1.7e-7 | 3.3e-5, 1.3e-5, 1.1e-5 | 4.2e-7, 1.2e-7, -8.5e-9 |
/// | `exp_neg` | 8e-7, 2.7e-8, -5.5e-11 | 6.9e-5, 3.6e-6, -6.7e-7 | 9.9e-8, 8.3e-9, 5.8e-10 |
/// | `exp_m1_neg` | 7.3e-7, 2.4e-8, -3.8e-10 | 6e-5, 3.2e-6, 5.9e-7 | 4.2e-7, 9.3e-9, -8.4e-10 |
/// | `exp_m1_neg`, x < 1/8 | 4.2e-7, 8.5e-8, -4.1e-8 | 4.2e-7, 8.5e-8, -4.1e-8 | 4.2e-7, 8.5e-8, -4.1e-8 |
/// | `pow`, y = 0.0196 | 8e-7, 1.9e-7, -3.6e-8 | 7e-5, 2.8e-5, -2.1e-5 | 1.1e-7, 6.4e-8, 6e-8 |
/// | `pow`, y = 0.5 | 9e-7, 1.6e-7, -5.4e-8 | 7.2e-5, 2.4e-5, -1.8e-5 | 2.3e-7, 6.3e-8, 1.9e-8 |
/// | `pow`, y = 2.071 | 1.5e-6, 1.8e-7, -1.1e-7 | 8.4e-5, 2e-5, -1.4e-5 | 4.6e-7, 8.9e-8, 1.2e-8 |
/// | `pow`, y = 50 | 1.6e-5, 9.2e-7, -1.6e-7 | 4.2e-4, 3.4e-5, -6.3e-6 | 4.6e-6, 5.3e-7, -7.7e-8 |
/// | `atan2_turns` | 4.2e-8, 1.2e-8, 0 | 1.1e-5, 5.7e-6, 0 | 4.2e-8, 1.2e-8, 0 |
///
/// Rising and falling functions are monotone up to a few last places. The table holds the most by which the result steps
/// back from one argument to the next, in last places.
///
/// | function | [`Fine`] | [`Coarse`] | [`Compact`] |
/// |---|--:|--:|--:|
/// | `sqrt` | 641 | 0 | 138 |
/// | `neg_ln_1m` | 0 | 0 | 4 |
/// | `exp_neg` | 598 | 39068 | 232 |
/// | `exp_m1_neg` | 992 | 37114 | 992 |
pub trait Grade:
    Kernels + Copy + Default + core::fmt::Debug + PartialEq + Eq + Send + Sync + 'static
{
    /// The name of the grade, as in tables.
    const NAME: &'static str;

    /// `(sin(2πt), cos(2πt))` of a phase `t` in turns. Quarter turns give exactly 0 and ±1.
    #[must_use]
    #[inline]
    fn sincos_turns(t: U0F32) -> (I2F30, I2F30) {
        let (sin, cos) = Self::sincos(t.to_bits());
        (I2F30::from_bits(sin), I2F30::from_bits(cos))
    }

    /// The angle of the point `(x, y)` in turns, in `[0, 1)`; 0 at the origin, exact on the axes.
    #[must_use]
    #[inline]
    fn atan2_turns(y: I2F30, x: I2F30) -> U0F32 {
        U0F32::from_bits(Self::angle(y.to_bits(), x.to_bits()))
    }

    /// The square root. It is below 1 for every argument.
    #[must_use]
    #[inline]
    fn sqrt(x: U0F32) -> U0F32 {
        U0F32::from_bits(Self::root(x.to_bits()))
    }

    /// −ln(1 − u): exactly 0 at 0, and 22.18 at the last word.
    #[must_use]
    #[inline]
    fn neg_ln_1m(u: U0F32) -> U5F27 {
        U5F27::from_bits(Self::log(u.to_bits()))
    }

    /// e⁻ˣ. The result at 0 is one of the two largest words, 1 − 2⁻³¹ or 1 − 2⁻³².
    #[must_use]
    #[inline]
    fn exp_neg(x: U5F27) -> U0F32 {
        U0F32::from_bits(Self::exp(x.to_bits()))
    }

    /// 1 − e⁻ˣ, accurate for small x too.
    #[must_use]
    #[inline]
    fn exp_m1_neg(x: U5F27) -> U0F32 {
        let x = x.to_bits();
        U0F32::from_bits(if x < exp::SMALL {
            exp::one_minus_small(x, 27) << 5
        } else {
            !Self::exp(x)
        })
    }

    /// `x^y`, where 1 counts as the largest word; `0^0` is 1.
    ///
    /// The exponent y multiplies the error of the logarithm.
    #[must_use]
    #[inline]
    fn pow(x: U0F32, y: U16F16) -> U0F32 {
        let (x, y) = (x.to_bits(), y.to_bits());
        if y == 0 {
            return U0F32::MAX;
        }
        if x == 0 {
            return U0F32::ZERO;
        }
        let log = Self::log(x.wrapping_neg());
        let whole = y >> 16;
        let fraction = product::by_half(log, y & 0xffff);
        // With an exponent of 32 or more the power is below a step.
        let exponent = match log.wrapping_mul(whole).checked_add(fraction) {
            Some(exponent) if product::high(log, whole) == 0 => exponent,
            _ => u32::MAX,
        };
        U0F32::from_bits(Self::exp(exponent))
    }
}

macro_rules! grade {
    ($(#[$doc:meta])* $grade:ident {
        kernels: $kernel:ident, product: $scaled:ident, rotations: $rotations:literal,
        rim: $rim:literal, series: $series:literal, beyond: $beyond:expr, astray: $astray:expr,
    }) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
        #[cfg_attr(feature = "defmt", derive(defmt::Format))]
        pub struct $grade;

        impl Grade for $grade {
            const NAME: &'static str = stringify!($kernel);
        }

        impl Kernels for $grade {
            const RIM: u32 = $rim;
            const SERIES: u64 = $series;
            const BEYOND: u32 = $beyond;
            const ASTRAY: u32 = $astray;

            #[inline]
            fn sincos(phase: u32) -> (i32, i32) {
                sine::$kernel(phase)
            }

            #[inline]
            fn root(x: u32) -> u32 {
                root::$kernel(x)
            }

            #[inline]
            fn log(u: u32) -> u32 {
                log::$kernel(u)
            }

            #[inline]
            fn exp(x: u32) -> u32 {
                exp::$kernel(x)
            }

            #[inline]
            fn angle(y: i32, x: i32) -> u32 {
                angle::vectoring(y, x, $rotations)
            }

            #[inline]
            fn scaled(length: u32, by: i32) -> i32 {
                product::$scaled(length, by)
            }
        }
    };
}

grade! {
    /// The usual grade: largest errors about 1e-6, with tables of 2 KB that all functions share.
    Fine {
        kernels: fine, product: near_signed, rotations: 23,
        rim: 0xffff_f99c, series: 0x35c2_8f5c, beyond: 1 << 12, astray: 1 << 14,
    }
}

grade! {
    /// The fastest grade: largest errors about 1e-4, in the fewest instructions, for sound, light and dithering.
    ///
    /// It shares the tables of [`Fine`]. Coordinates of disks and directions are products of 15 bits, right to 1.4e-4 of
    /// the size, also in narrow cones and lobes.
    Coarse {
        kernels: coarse, product: rough_signed, rotations: 14,
        rim: 0xffff_ffff, series: 0x7d70_a3d7, beyond: 1 << 17, astray: 1 << 21,
    }
}

grade! {
    /// The smallest grade: largest errors about 1e-6 without tables, in the least flash.
    Compact {
        kernels: compact, product: near_signed, rotations: 23,
        rim: 0xffff_f9a8, series: 0x35c2_8f5c, beyond: 1 << 12, astray: 1 << 14,
    }
}
