//! What goes into a kernel and comes out of it: numbers of one word each.

use fixed::types::{I2F30, I5F27, I16F16, U0F32, U5F27, U16F16, U32F32};
use microwarp::warp::SurfacePoint;

/// An input of a kernel, a word of memory.
pub trait Input: Copy {
    /// The input that a random word makes, as its bits.
    #[cfg_attr(one_kernel, allow(dead_code, reason = "a generator is no such input"))]
    fn bits(random: u32) -> u32;
}

/// What a kernel returns, as words of memory.
pub trait Output {
    /// How many words.
    const WORDS: usize;
    /// Writes them, each by one store.
    ///
    /// # Safety
    /// As many words must be writable at `to`.
    unsafe fn store(self, to: *mut u32);
}

macro_rules! inputs {
    ($($type:ty, $random:ident => $bits:expr;)*) => {$(
        impl Input for $type {
            fn bits($random: u32) -> u32 {
                $bits
            }
        }
    )*};
}

inputs! {
    u32, random => random;
    // A uniform of the 24-bit grid.
    f32, random => ((random >> 8) as f32 / 16_777_216.0).to_bits();
    // A uniform.
    U0F32, random => random;
    // A coordinate in [-1, 1).
    I2F30, random => ((random as i32) >> 1) as u32;
    // A negated exponent in [0, 8).
    U5F27, random => random >> 2;
    // An exponent in [0, 64).
    U16F16, random => random >> 10;
}

macro_rules! words {
    ($($type:ty),*) => {$(
        impl Output for $type {
            const WORDS: usize = 1;
            #[inline(always)]
            unsafe fn store(self, to: *mut u32) {
                // SAFETY: the caller's.
                unsafe { to.cast::<$type>().write_volatile(self) }
            }
        }
    )*};
}

words!(u32, i32, f32, I2F30, I5F27, I16F16, U0F32, U5F27, U16F16);

impl Output for usize {
    const WORDS: usize = 1;
    #[inline(always)]
    unsafe fn store(self, to: *mut u32) {
        // SAFETY: the caller's.
        unsafe { to.write_volatile(self as u32) }
    }
}

impl Output for SurfacePoint {
    const WORDS: usize = 6;
    #[inline(always)]
    unsafe fn store(self, to: *mut u32) {
        // SAFETY: the caller's.
        unsafe { (self.position, self.normal).store(to) }
    }
}

impl Output for U32F32 {
    const WORDS: usize = 2;
    #[inline(always)]
    unsafe fn store(self, to: *mut u32) {
        let bits = self.to_bits();
        // SAFETY: the caller's.
        unsafe { [bits as u32, (bits >> 32) as u32].store(to) }
    }
}

/// Without a loop, which small code might keep.
macro_rules! several {
    ($length:literal: $($name:ident)*) => {
        impl<T: Output> Output for [T; $length] {
            const WORDS: usize = $length * T::WORDS;
            #[inline(always)]
            unsafe fn store(self, to: *mut u32) {
                let [$($name),*] = self;
                // SAFETY: the caller's.
                unsafe { ($($name,)*).store(to) }
            }
        }
    };
}

several!(1: a);
several!(2: a b);
several!(3: a b c);
several!(4: a b c d);

macro_rules! tuples {
    ($first:ident $a:ident $($rest:ident $b:ident)*) => {
        impl<$first: Output, $($rest: Output),*> Output for ($first, $($rest),*) {
            const WORDS: usize = $first::WORDS $(+ $rest::WORDS)*;
            #[inline(always)]
            unsafe fn store(self, to: *mut u32) {
                let ($a, $($b),*) = self;
                // SAFETY: the caller's.
                unsafe {
                    $a.store(to);
                    ($($b,)*).store(to.add($first::WORDS));
                }
            }
        }
        tuples!($($rest $b)*);
    };
    () => {
        impl Output for () {
            const WORDS: usize = 0;
            #[inline(always)]
            unsafe fn store(self, _: *mut u32) {}
        }
    };
}

tuples!(A a B b C c D d);
