//! The functions of every warp, made of the lists of `crates/list`.

use crate::error::{Code, code};
use crate::generators::{Pcg32, Source};
use crate::layout::LAYOUT;
use crate::value::Value;
use core::slice;
use core_crate::{Invert, Warp};
use fixed::types::extra::U16;
use fixed::types::{I2F30, I16F16, U0F32, U2F62, U16F16, U32F32};
use microwarp_list::{float_warps, integer_warps};

pub type Given<T> = <T as Value>::Given;
pub type Place<T> = <T as Value>::Place;
pub type Yielded<T> = <T as Value>::Result;
pub type InMemory<T> = <T as Value>::C;
pub type Uniforms<W> = <W as Warp>::Uniforms;
pub type Point<W> = <W as Warp>::Point;
pub type DensityOf<W> = <W as Warp>::Density;

/// The memory of C that is to be filled.
///
/// # Safety
/// It is valid for writes of so many elements, or there are none.
#[inline]
pub unsafe fn memory<'a, T>(start: *mut T, count: usize) -> &'a mut [T] {
    if count == 0 {
        return &mut [];
    }
    // SAFETY: the caller's promise. Nothing reads an element before it is written.
    unsafe { slice::from_raw_parts_mut(start, count) }
}

/// Memory of C that is read.
///
/// # Safety
/// It is valid for reads of so many elements as long as it is used, or there are none.
#[inline]
pub unsafe fn given<'a, T>(start: *const T, count: usize) -> &'a [T] {
    if count == 0 {
        return &[];
    }
    // SAFETY: the caller's promise.
    unsafe { slice::from_raw_parts(start, count) }
}

/// Stops the build for a target on which a type does not fit into its struct of the header: so many pointers, and then
/// words. Where a `usize` is short, it may take less.
pub const fn as_declared<W>(symbol: &[&str]) {
    let mut i = 0;
    while i < LAYOUT.len() {
        let (name, pointers, bytes, align) = LAYOUT[i];
        if is(name.as_bytes(), symbol) {
            let (room, align) = match pointers {
                0 => (bytes, align),
                _ => (
                    (pointers * size_of::<usize>() + bytes).next_multiple_of(align_of::<usize>()),
                    align_of::<usize>(),
                ),
            };
            assert!(
                size_of::<W>() <= room && align_of::<W>() <= align,
                "cargo regenerate"
            );
            return;
        }
        i += 1;
    }
    panic!("layout.rs lacks a struct: cargo regenerate");
}

/// Whether a name is made of these parts.
const fn is(mut name: &[u8], parts: &[&str]) -> bool {
    let mut i = 0;
    while i < parts.len() {
        let mut part = parts[i].as_bytes();
        while let ([a, rest @ ..], [b, others @ ..]) = (name, part) {
            if *a != *b {
                return false;
            }
            (name, part) = (rest, others);
        }
        if !part.is_empty() {
            return false;
        }
        i += 1;
    }
    name.is_empty()
}

/// The functions of one warp, whose symbols begin alike. `$this` is the first argument; a warp without parameters has none.
macro_rules! functions {
    ($tier:literal $name:literal $warp:ty, ($($this:ident)?) $made:expr) => {
        #[unsafe(export_name = concat!("mw_", $tier, $name, "_sample"))]
        unsafe extern "C" fn sample(
            $($this: &$warp,)? uniforms: Given<Uniforms<$warp>>, point: Place<Point<$warp>>,
        ) -> Yielded<Point<$warp>> {
            // SAFETY: the promise of the header.
            unsafe { $made.sample(Value::read(uniforms)).yielded(point) }
        }

        #[unsafe(export_name = concat!("mw_", $tier, $name, "_sample_with_pdf"))]
        unsafe extern "C" fn sample_with_pdf(
            $($this: &$warp,)? uniforms: Given<Uniforms<$warp>>, point: *mut InMemory<Point<$warp>>,
        ) -> DensityOf<$warp> {
            // SAFETY: the promise of the header.
            unsafe {
                let (sampled, density) = $made.sample_with_pdf(Value::read(uniforms));
                point.write(sampled.to_c());
                density
            }
        }

        #[unsafe(export_name = concat!("mw_", $tier, $name, "_draw"))]
        unsafe extern "C" fn draw(
            $($this: &$warp,)? rng: &mut Pcg32, point: Place<Point<$warp>>,
        ) -> Yielded<Point<$warp>> {
            crate::generators::forget_registers();
            // SAFETY: the promise of the header.
            unsafe { $made.draw(rng).yielded(point) }
        }

        #[unsafe(export_name = concat!("mw_", $tier, $name, "_draw_from"))]
        unsafe extern "C" fn draw_from(
            $($this: &$warp,)? source: &Source, point: *mut InMemory<Point<$warp>>,
        ) -> Code {
            crate::generators::forget_registers();
            // SAFETY: the promise of the header.
            code($made.try_draw(&mut { *source }), |drawn| unsafe { point.write(drawn.to_c()) })
        }

        #[unsafe(export_name = concat!("mw_", $tier, $name, "_fill"))]
        unsafe extern "C" fn fill(
            $($this: &$warp,)? rng: &mut Pcg32, points: *mut InMemory<Point<$warp>>, count: usize,
        ) {
            // SAFETY: the promise of the header.
            let points = unsafe { memory(points, count) };
            let Ok(()) = Point::<$warp>::fill($made, rng, points);
        }

        #[unsafe(export_name = concat!("mw_", $tier, $name, "_fill_from"))]
        unsafe extern "C" fn fill_from(
            $($this: &$warp,)? source: &Source, points: *mut InMemory<Point<$warp>>, count: usize,
        ) -> Code {
            // SAFETY: the promise of the header.
            let points = unsafe { memory(points, count) };
            code(Point::<$warp>::fill($made, &mut { *source }, points), |()| ())
        }

        #[unsafe(export_name = concat!("mw_", $tier, $name, "_pdf"))]
        unsafe extern "C" fn pdf($($this: &$warp,)? point: Given<Point<$warp>>) -> DensityOf<$warp> {
            // SAFETY: the promise of the header.
            unsafe { $made.pdf(Value::read(point)) }
        }

        #[unsafe(export_name = concat!("mw_", $tier, $name, "_invert"))]
        unsafe extern "C" fn invert(
            $($this: &$warp,)? point: Given<Point<$warp>>, uniforms: Place<Uniforms<$warp>>,
        ) -> Yielded<Uniforms<$warp>> {
            // SAFETY: the promise of the header.
            unsafe { $made.invert(Value::read(point)).yielded(uniforms) }
        }
    };
}

/// A function that makes a struct: its name, what it takes, and what it calls.
macro_rules! makers {
    ($($name:literal $made:ty, ($($parameter:ident: $type:ty),*) $body:block)*) => {$(
        const _: () = {
            unsafe fn made($($parameter: $type),*) -> Result<$made, core_crate::Error> {
                // SAFETY: the promise of the header.
                #[allow(unused_unsafe, reason = "not all read memory")]
                unsafe { $body }
            }

            #[unsafe(export_name = concat!("mw_", $name))]
            unsafe extern "C" fn make(place: *mut $made, $($parameter: $type),*) -> crate::error::Code {
                // SAFETY: the promise of the header.
                unsafe { crate::error::code(made($($parameter),*), |made| place.write(made)) }
            }
        };
    )*};
}

pub(crate) use makers;

macro_rules! init {
    ($tier:literal $name:literal $warp:ty, new $parameters:tt) => {
        init!(@ [$tier, $name, "_init"] $warp, new $parameters);
    };
    ($tier:literal $name:literal $warp:ty, $constructor:ident $parameters:tt) => {
        init!(@ [$tier, $name, "_init_", stringify!($constructor)] $warp, $constructor $parameters);
    };
    (@ [$($symbol:tt)*] $warp:ty, $constructor:ident ($($parameter:ident: $type:ty),*)) => {
        const _: () = {
            #[unsafe(export_name = concat!("mw_", $($symbol)*))]
            unsafe extern "C" fn init(warp: *mut $warp, $($parameter: Given<$type>),*) -> Code {
                // SAFETY: the promise of the header.
                unsafe {
                    let made = <$warp>::$constructor($(<$type as Value>::read($parameter)),*);
                    code(made, |made| warp.write(made))
                }
            }
        };
    };
}

/// One entry of a block: what is bound under one name.
macro_rules! bound {
    ($tier:literal $name:literal $warp:ty { new(), }) => {
        const _: () = {
            const _: () = assert!(size_of::<$warp>() == 0, "a warp without a struct");
            functions! { $tier $name $warp, () &<$warp>::new() }
        };
    };
    ($tier:literal $name:literal $warp:ty { $($constructor:ident $parameters:tt,)* }) => {
        const _: () = {
            const _: () = as_declared::<$warp>(&["mw_", $tier, $name]);
            functions! { $tier $name $warp, (this) this }
        };
        $(init! { $tier $name $warp, $constructor $parameters })*
    };
}

pub(crate) use {bound, functions};

/// The blocks of a list, under the prefix of a tier; of the integer tier those that have grades, or the others.
macro_rules! blocks {
    ($tier:literal in every grade { $($graded:tt)* } with floats $floats:tt without grade $plain:tt) => {
        blocks! { $tier $($graded)* }
    };
    (in every grade $graded:tt with floats $floats:tt without grade { $($plain:tt)* }) => {
        blocks! { "fixed_" $($plain)* }
    };
    ($tier:literal $($type:ident { golden $golden:tt cost $cost:tt bind $bind:tt })*) => {
        $(blocks!(@ $tier $bind);)*
    };
    (@ $tier:literal { none $reason:literal }) => {};
    (@ $tier:literal { $($name:literal = $warp:ty { $($constructors:tt)* })* }) => {
        $(bound! { $tier $name $warp { $($constructors)* } })*
    };
}

mod poly {
    use super::*;
    use core_crate::poly::*;
    float_warps!(blocks "");
}

/// The integer tier, a module for each grade.
mod fine {
    use super::*;
    use core_crate::fixed::*;
    integer_warps!(blocks "fixed_");
}

mod coarse {
    use super::*;
    use core_crate::fixed::coarse::*;
    integer_warps!(blocks "coarse_");
}

mod compact {
    use super::*;
    use core_crate::fixed::compact::*;
    integer_warps!(blocks "compact_");
}

mod plain {
    use super::*;
    use core_crate::fixed::Interval;
    integer_warps!(blocks);
}
