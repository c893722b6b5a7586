//! Laws in memory of the caller that are no warps: counts and other integers, and what is drawn by rejection. By their exports
//! goes whatever else is asked by a kind.

use crate::buffers::Buffers;
use crate::lights::LIGHTS;
use crate::parts::{NOT_LINKED, linked};
use crate::warps::{DENSITIES, refused};
use crate::{counts, lights, rejection};
use microwarp::Error;

const COUNTS: bool = linked("counts");
const REJECTIONS: bool = linked("rejections");

/// The kinds of `rejection` begin here, and end.
const FIRST: u32 = 16;
const LAST: u32 = 32;
/// Whether densities come with samples.
const DENSITIES_KIND: u32 = 48;

/// The JavaScript side has so much room for one.
const WORDS: usize = 272;

/// Writes a law to its place. How many words it has as a negative number, or the code of the refusal.
///
/// # Safety
/// There is room for [`WORDS`].
pub unsafe fn written<L>(law: Result<L, Error>, place: *mut L) -> i32 {
    const { assert!(size_of::<L>() <= 4 * WORDS && align_of::<L>() <= 16) };
    match law {
        Ok(law) => {
            // SAFETY: as the caller says.
            unsafe { place.write(law) };
            const { -(size_of::<L>().div_ceil(4) as i32) }
        }
        Err(refusal) => refused(refusal) as i32,
    }
}

/// Writes a law to its place by its kind, from parameters that lie one behind the other, and integers. As [`written`] returns.
///
/// # Safety
/// All its parameters lie there, and two at least; there is room for [`WORDS`].
#[unsafe(no_mangle)]
pub unsafe extern "C" fn law(
    place: *mut u32,
    kind: u32,
    parameters: *const f32,
    trials: u32,
    part: u32,
    whole: u32,
) -> i32 {
    // SAFETY: as the caller says.
    unsafe {
        match kind {
            FIRST..LAST if REJECTIONS => {
                rejection::made(kind.wrapping_sub(FIRST), place, parameters)
            }
            0..FIRST if COUNTS => counts::made(kind, place, parameters, [trials, part, whole]),
            _ => NOT_LINKED as i32,
        }
    }
}

/// Asks a law: see `counts::asked` and `rejection::asked`, whose words are drawn where `random` is above 0; or, by the last kind,
/// whether the module hands over densities with samples; and `lights::asked` of the kinds between. What is not linked is 0.
///
/// # Safety
/// `law` has written it by this kind, as `asked` says.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn ask(
    kind: u32,
    what: u32,
    law: *const u32,
    buffers: &mut Buffers,
    count: usize,
    random: usize,
) -> u32 {
    // SAFETY: as the caller says.
    unsafe {
        match kind {
            DENSITIES_KIND => DENSITIES.into(),
            LAST..DENSITIES_KIND if LIGHTS => {
                lights::asked(kind, what, law, buffers, count, random)
            }
            FIRST..LAST if REJECTIONS => {
                rejection::asked(kind.wrapping_sub(FIRST), what, law, buffers, random > 0)
            }
            0..FIRST if COUNTS => counts::asked(kind, what, law, buffers, count, random),
            _ => 0,
        }
    }
}
