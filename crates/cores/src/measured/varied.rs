//! Kernels of warps whose parameters are in memory, made by the constructors that `bind` in the lists of warps names. Between
//! calls the sweep makes the warp of other parameters.

use crate::measured::count::{Kernel, empty};
use crate::measured::registry::stored_at;
use crate::measured::words::{Input, Output};
use fixed::types::{I2F30, I16F16, U0F32, U2F62, U16F16, U32F32};
use microwarp::Warp;

/// `LIST ("prefix_" module "room ") Type { bind block } ...`: what has parameters is `prefix_name_any`.
macro_rules! varied_entries {
    ($list:ident $tier:tt $($type:ident $bind:tt)*) => {
        /// Every entry; a measurement leaves one.
        pub static $list: &[&[Option<$crate::measured::count::Entry>]] =
            &[$($crate::measured::varied::varied_entries!(@ $tier $type $bind)),*];
    };
    (@ $tier:tt $type:ident { none $reason:literal }) => { &[] };
    (@ ($prefix:literal $module:ident $room:literal) $type:ident { $($name:literal = $warp:ty { $($made:tt)* })* }) => {
        &[$(
            #[cfg(any(not(one_kernel), all(prefix = $prefix, warp = $name, varied)))]
            $crate::measured::varied::varied!(
                (concat!($prefix, $name, "_any")) (concat!($room, stringify!($type))) $module $warp { $($made)* }
            ),
        )*]
    };
}

/// One of them.
macro_rules! varied {
    ($name:tt $listed:tt $module:ident $warp:ty { new(), }) => { None };
    (($name:expr) ($listed:expr) $module:ident $warp:ty {
        $($constructor:ident($($parameter:ident: $number:ty),*),)*
    }) => {{
        use $module::*;
        type Uniforms = <$warp as microwarp::Warp>::Uniforms;
        #[unsafe(export_name = $name)]
        #[inline(never)]
        extern "C" fn kernel(at: *mut u32, to: *mut u32) {
            // SAFETY: the entry says how many words there are, and what has been made.
            unsafe { $crate::measured::varied::sample::<$warp>(at, to) }
        }
        fn make(constructor: &str, words: &mut dyn Iterator<Item = u32>) -> Option<()> {
            match constructor {
                $(stringify!($constructor) => {
                    $(let $parameter = <$number as $crate::measured::varied::Parameter>::read(words)?;)*
                    $crate::measured::registry::store(<$warp>::$constructor($($parameter),*).ok()?);
                })*
                _ => return None,
            }
            Some(())
        }
        Some($crate::measured::count::Entry {
            kernel,
            empty: $crate::measured::varied::empty_of::<<$warp as microwarp::Warp>::Point>(<Uniforms as $crate::measured::varied::Given>::BITS.len()),
            inputs: <Uniforms as $crate::measured::varied::Given>::BITS,
            outputs: <<$warp as microwarp::Warp>::Point as $crate::measured::words::Output>::WORDS,
            prepare: || {},
            warp: $listed,
            vary: Some($crate::measured::count::Vary { constructors: &[$(stringify!($constructor)),*], make }),
        })
    }};
}

pub(crate) use {varied, varied_entries};

/// Uniforms as the inputs of a kernel.
pub trait Given: Sized {
    /// How a random word becomes each of them.
    const BITS: &'static [fn(u32) -> u32];
    /// Loads them, each by one instruction.
    ///
    /// # Safety
    /// As many words must be readable at `at`.
    unsafe fn load(at: *mut u32) -> Self;
}

impl<T: Input> Given for T {
    const BITS: &'static [fn(u32) -> u32] = &[T::bits];
    #[inline(always)]
    unsafe fn load(at: *mut u32) -> Self {
        // SAFETY: the caller's.
        unsafe { at.cast::<T>().read_volatile() }
    }
}

macro_rules! several {
    ($($count:literal: $($index:literal)*;)*) => {$(
        impl<T: Input> Given for [T; $count] {
            const BITS: &'static [fn(u32) -> u32] = {
                let bits: fn(u32) -> u32 = T::bits;
                &[bits; $count]
            };
            #[inline(always)]
            unsafe fn load(at: *mut u32) -> Self {
                // SAFETY: the caller's.
                unsafe { [$(T::load(at.wrapping_add($index))),*] }
            }
        }
    )*};
}

several! { 1: 0; 2: 0 1; 3: 0 1 2; 4: 0 1 2 3; }

/// The kernel that does nothing with so many.
pub const fn empty_of<O: Output>(inputs: usize) -> Kernel {
    match inputs {
        1 => empty::<1, O>,
        2 => empty::<2, O>,
        3 => empty::<3, O>,
        _ => empty::<4, O>,
    }
}

/// The body of a kernel.
///
/// # Safety
/// `at` and `to` are as in a kernel, and the warp has been stored.
#[inline(always)]
pub unsafe fn sample<W: Warp>(at: *mut u32, to: *mut u32)
where
    W::Uniforms: Given,
    W::Point: Output,
{
    // SAFETY: the caller's.
    unsafe { (*stored_at::<W>()).sample(Given::load(at)).store(to) }
}

/// A parameter that is made of words.
pub trait Parameter: Sized {
    /// Nothing where there are too few.
    fn read(words: &mut dyn Iterator<Item = u32>) -> Option<Self>;
}

macro_rules! parameters {
    ($($type:ty: $word:ident => $made:expr;)*) => {$(
        impl Parameter for $type {
            fn read(words: &mut dyn Iterator<Item = u32>) -> Option<Self> {
                words.next().map(|$word| $made)
            }
        }
    )*};
}

parameters! {
    f32: word => Self::from_bits(word);
    u32: word => word;
    i32: word => word as i32;
    u16: word => word as u16;
    I2F30: word => Self::from_bits(word as i32);
    I16F16: word => Self::from_bits(word as i32);
    U0F32: word => Self::from_bits(word);
    U16F16: word => Self::from_bits(word);
}

macro_rules! long {
    ($($type:ty)*) => {$(
        impl Parameter for $type {
            fn read(words: &mut dyn Iterator<Item = u32>) -> Option<Self> {
                let [low, high] = [words.next()?, words.next()?];
                Some(Self::from_bits(u64::from(high) << 32 | u64::from(low)))
            }
        }
    )*};
}

long!(U2F62 U32F32);

impl<T: Parameter + Default + Copy, const N: usize> Parameter for [T; N]
where
    Self: Default,
{
    fn read(words: &mut dyn Iterator<Item = u32>) -> Option<Self> {
        let mut all = Self::default();
        for one in &mut all {
            *one = T::read(words)?;
        }
        Some(all)
    }
}
