//! The grades: how accurately, and in how much flash, the integer kernels compute.

use ::fixed::types::{I2F30, U0F32, U5F27};

mod sealed {
    pub trait Sealed {}
    impl Sealed for super::Fine {}
    impl Sealed for super::Coarse {}
    impl Sealed for super::Compact {}
}

/// Elementary functions on fixed-point numbers, in one of three trades of speed, accuracy and flash.
///
/// The trait is sealed: [`Fine`], [`Coarse`] and [`Compact`] implement it and nothing else can. Each function
/// is total: it takes every word there is.
pub trait Grade:
    sealed::Sealed + Copy + Default + core::fmt::Debug + PartialEq + Eq + Send + Sync + 'static
{
    /// The name of the grade, as it is written in tables.
    const NAME: &'static str;

    /// `(sin(2πt), cos(2πt))` of a phase `t` in turns. Quarter turns give exactly 0 and ±1.
    #[must_use]
    fn sincos_turns(t: U0F32) -> (I2F30, I2F30);

    /// The angle of the point `(x, y)` in turns, in `[0, 1)`; 0 at the origin.
    #[must_use]
    fn atan2_turns(y: I2F30, x: I2F30) -> U0F32;

    /// The square root; below 1 for every argument.
    #[must_use]
    fn sqrt(x: U0F32) -> U0F32;

    /// −ln(1 − u), exactly 0 at 0 and 22.18 at the last word.
    #[must_use]
    fn neg_ln_1m(u: U0F32) -> U5F27;

    /// e^−x; 1 counts as the largest word, 1 − 2⁻³².
    #[must_use]
    fn exp_neg(x: U5F27) -> U0F32;

    /// 1 − e^−x, accurate where x is small.
    #[must_use]
    fn exp_m1_neg(x: U5F27) -> U0F32;

    /// `x^y` of `y` ≥ 0, where 1 counts as the largest word.
    #[must_use]
    fn pow(x: U0F32, y: ::fixed::types::U16F16) -> U0F32;
}

/// Largest errors about 1e-6, with tables of 2 KB that all functions share.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Fine;

/// Largest errors about 1e-4, in the fewest instructions: for sound, light and dithering.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Coarse;

/// Largest errors about 1e-6 without tables, in the least flash.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Compact;
