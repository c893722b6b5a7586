//! Every bound warp by its number: constructed, and evaluated over arrays. The numbers are those of the list in
//! `crates/list/src/warps.rs`; the JavaScript side has them by `cargo regenerate`.

use crate::buffers::{Arrays, Buffers};
use crate::flat::{Both, Flat, get, put};
use crate::mixture::kind;
use crate::parts::{NOT_LINKED, linked};
use core::slice::{from_raw_parts, from_raw_parts_mut};
use microwarp::{Error, Invert};
use microwarp_js_hot::{Words, fill};

/// What is done to each element of an array.
pub const DRAW: u32 = 0;
pub const SAMPLE: u32 = 1;
pub const PDF: u32 = 2;
pub const INVERT: u32 = 3;
pub const SAMPLE_WITH_PDF: u32 = 4;
pub const DRAW_WITH_PDF: u32 = 5;

/// Densities with samples.
pub const DENSITIES: bool = linked("densities");

/// Does one thing to every element, of a warp of any type.
///
/// # Safety
/// As for [`element`].
pub unsafe fn all<W>(warp: &W, what: u32, mut arrays: Arrays)
where
    W: Invert<Density = f32, Point: Flat, Uniforms: Flat>,
{
    while arrays.count > 0 {
        // SAFETY: as the caller says.
        unsafe { element(warp, what, &arrays) };
        arrays.next();
    }
}

/// Does one thing to one element; to all where the warp has a loop for it, and says so.
type Run = unsafe fn(u32, *const f32, &Arrays) -> bool;
/// Reads parameters and writes a warp; how many words it has as a negative number, or the code of the refusal.
type New = unsafe fn(*const f32, *mut f32) -> i32;

/// Does one thing to the first element, of a warp of any type.
///
/// # Safety
/// The warp is of this type, and the arrays have its numbers.
unsafe fn element<W>(warp: &W, what: u32, arrays: &Arrays)
where
    W: Invert<Density = f32, Point: Flat, Uniforms: Flat>,
{
    let Arrays { input, output, .. } = *arrays;
    // SAFETY: as the caller says.
    unsafe {
        match what {
            DRAW => put(output, warp.draw(&mut Words::new(input.cast()))),
            SAMPLE => put(output, warp.sample(get(input))),
            PDF => put(output, warp.pdf(get(input))),
            SAMPLE_WITH_PDF if DENSITIES => both(output, warp.sample_with_pdf(get(input))),
            DRAW_WITH_PDF if DENSITIES => {
                both(output, warp.draw_with_pdf(&mut Words::new(input.cast())));
            }
            _ => put(output, warp.invert(get(input))),
        }
    }
}

/// Writes a point, and its density behind it.
unsafe fn both<P: Flat>(to: *mut f32, (point, density): (P, f32)) {
    // SAFETY: as for `put`.
    unsafe {
        to.cast::<Both<P::Raw, f32>>()
            .write_unaligned(Both(point.raw(), density));
    }
}

unsafe fn run<W>(what: u32, warp: *const f32, arrays: &Arrays) -> bool
where
    W: Invert<Density = f32, Point: Flat, Uniforms: Flat> + 'static,
{
    let Arrays {
        input,
        output,
        inputs,
        outputs,
        count,
    } = *arrays;
    // SAFETY: the caller passes what `construct` wrote by the same number, and arrays of its numbers.
    unsafe {
        let warp = &*warp.cast::<W>();
        if what == DRAW {
            let words = from_raw_parts(input.cast(), inputs * count);
            if fill(warp, words, from_raw_parts_mut(output, outputs * count)) {
                return true;
            }
        }
        element(warp, what, arrays);
        false
    }
}

fn write<W>(made: Result<W, Error>, warp: *mut f32) -> i32 {
    match made {
        // SAFETY: the caller has room for the largest warp.
        Ok(made) => unsafe { warp.cast::<W>().write(made) },
        Err(refusal) => return refused(refusal) as i32,
    }
    const { -((size_of::<W>() / 4) as i32) }
}

/// The code of a refusal, and 32 times the number of the parameter it lies in, from 1, if it lies in one.
#[inline(never)]
pub fn refused(refusal: Error) -> u32 {
    let number = refusal.parameter().map_or(0, |place| place as u32 + 1);
    u32::from(refusal.code()) | number << 5
}

/// The code of a refusal, and 32 times the index of the weight it lies in, if it lies in one.
pub fn refused_weight(refusal: Error) -> u32 {
    u32::from(refusal.code()) | (refusal.index().unwrap_or(0) as u32) << 5
}

/// A warp from parameters that lie one behind the other. What takes none cannot refuse.
macro_rules! made {
    ($warp:ty, $new:ident(), $from:ident) => {{
        let _ = $from;
        Ok(<$warp>::$new())
    }};
    ($warp:ty, $new:ident($($parameter:ident: $type:ty),+), $from:ident) => {{
        let at = $from;
        $(
            // SAFETY: the caller has written all parameters.
            let ($parameter, at) = unsafe {
                (get::<$type>(at), at.byte_add(size_of::<<$type as Flat>::Raw>()))
            };
        )+
        let _ = at;
        <$warp>::$new($($parameter),+)
    }};
}

/// What stands in place of a warp that the module does not have.
unsafe fn nothing(_: u32, _: *const f32, _: &Arrays) -> bool {
    true
}

unsafe fn none(_: *const f32, _: *mut f32) -> i32 {
    NOT_LINKED as i32
}

macro_rules! numbered {
    ($([$name:literal $warp:ty] { $($new:ident $parameters:tt,)* })*) => {
        // The JavaScript side has so much room for one.
        const _: () = assert!(true $(&& size_of::<$warp>() <= 512 && align_of::<$warp>() <= 16)*);
        pub static RUN: &[Run] = &[$(if linked($name) { run::<$warp> } else { nothing }),*];
        /// What each may be mixed with.
        pub static KINDS: &[u8] = &[$(kind::<$warp>()),*];
        static NEW: &[New] = &[$($(
            if linked($name) { |from, to| write(made!($warp, $new $parameters, from), to) } else { none }
        ),*),*];
    };
}

macro_rules! bound {
    ($($type:ident {
        golden $golden:tt cost $cost:tt
        bind {
            $($name:literal = $warp:ident $(<$n:literal>)? { $($constructors:tt)* })*
            $(none $why:literal)?
        }
    })*) => {
        numbered! { $($([$name microwarp::poly::$warp $(<$n>)?] { $($constructors)* })*)* }
    };
}
microwarp_list::float_warps!(bound);

/// Makes a warp by the number of its constructor; how many words it has as a negative number, or the code of the refusal.
///
/// # Safety
/// The parameters lie there, and there is room for the largest warp.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn construct(
    constructor: usize,
    parameters: *const f32,
    warp: *mut f32,
) -> i32 {
    // SAFETY: as the caller says.
    NEW.get(constructor)
        .map_or(0, |new| unsafe { new(parameters, warp) })
}

/// Draws (0), samples (1), evaluates the density (2) or inverts (3) every element, or samples (4) or draws (5) with the density
/// behind each point, by the number of a warp; draws `random` words first.
///
/// # Safety
/// `construct` has written the warp by this number, whose elements have so many numbers.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn evaluate(
    number: usize,
    what: u32,
    warp: *const f32,
    buffers: &mut Buffers,
    inputs: usize,
    outputs: usize,
    count: usize,
    random: usize,
) {
    buffers.random(random);
    let mut arrays = buffers.arrays(inputs, outputs, count);
    if let Some(run) = RUN.get(number) {
        while arrays.count > 0 {
            // SAFETY: as the caller says.
            if unsafe { run(what, warp, &arrays) } {
                break;
            }
            arrays.next();
        }
    }
}
