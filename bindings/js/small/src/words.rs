//! Where the words of draws come from: the generator, or points of a set; and strata, which are uniforms.

use crate::parts::{NOT_LINKED, linked};
use core::slice::from_raw_parts_mut;
use microwarp::uniform::{
    ByPosition, Points, Sobol, Strata1d, Strata2d, deep_from_word, grid_from_word,
};
use microwarp_js_hot::Pcg32;
use rand_core::Rng;

/// Seeds the generator at `state`.
///
/// # Safety
/// There is room for it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn seed(state: *mut Pcg32, seed: u64, stream: u64) {
    // SAFETY: as the caller says.
    unsafe { state.write(Pcg32::new(seed, stream)) }
}

/// Seeds the generator at `state` as one of many, by words by position: `SeedableRng::from_rng` of `rand_pcg`.
///
/// # Safety
/// There is room for it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn seed_at(state: *mut Pcg32, seed: u32, index: u32) {
    let mut words = ByPosition::new(seed, index).at(0);
    let seed = words.next_u64();
    // SAFETY: as the caller says.
    unsafe { state.write(Pcg32::new(seed, words.next_u64() >> 1)) }
}

/// Draws words.
///
/// # Safety
/// The generator lies at `state`, and there is room for the words.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn random(state: *mut Pcg32, words: *mut u32, count: usize) {
    // SAFETY: as the caller says.
    unsafe { (*state).fill(from_raw_parts_mut(words, count)) }
}

/// The words of points `index` and on in `each` dimensions from `dimension` on: of a Sobol' sequence of eight dimensions, or
/// with `by_position` of random numbers by the position `pixel`.
///
/// # Safety
/// There is room for the words.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn points(
    by_position: u32,
    seed: u32,
    pixel: u32,
    index: u32,
    dimension: u32,
    words: *mut u32,
    each: usize,
    count: usize,
) {
    if !const { linked("points") } {
        return;
    }
    // SAFETY: as the caller says.
    let words = unsafe { from_raw_parts_mut(words, each.wrapping_mul(count)) };
    if by_position > 0 {
        write(ByPosition::new(seed, pixel), index, dimension, words, each);
    } else if let Ok(set) = Sobol::<8>::new(seed) {
        write(set, index, dimension, words, each);
    }
}

fn write(set: impl Points, mut index: u32, from: u32, words: &mut [u32], each: usize) {
    let mut dimension = 0;
    for word in words {
        *word = set.word(index, from.wrapping_add(dimension));
        dimension = dimension.wrapping_add(1);
        if dimension as usize >= each {
            (dimension, index) = (0, index.wrapping_add(1));
        }
    }
}

/// Turns random uniforms into those of strata `from` and on, in place: of `columns` intervals, or with `rows` of the cells
/// of a grid. 0, or the code of the refusal.
///
/// # Safety
/// The uniforms lie there, one or two for each of `count` strata.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn strata(
    columns: u32,
    rows: u32,
    from: u32,
    uniforms: *mut f32,
    count: usize,
) -> u32 {
    if !const { linked("points") } {
        return NOT_LINKED;
    }
    // SAFETY: as the caller says.
    let refused = unsafe {
        if rows == 0 {
            let uniforms = from_raw_parts_mut(uniforms, count);
            Strata1d::new(columns).map(|strata| {
                for (i, u) in (from..).zip(uniforms) {
                    *u = strata.point(i, *u);
                }
            })
        } else {
            let uniforms = from_raw_parts_mut(uniforms.cast::<[f32; 2]>(), count);
            Strata2d::new(columns, rows).map(|strata| {
                for (i, u) in (from..).zip(uniforms) {
                    *u = strata.point(i, *u);
                }
            })
        }
    };
    refused.map_or_else(|refusal| refusal.code().into(), |()| 0)
}

/// The uniforms of words, in place: on the 24-bit grid, or with `deep` the middles of their cells.
///
/// # Safety
/// The words lie there.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn uniforms(words: *mut u32, count: usize, deep: u32) {
    let of = if deep > 0 {
        deep_from_word
    } else {
        grid_from_word
    };
    // SAFETY: as the caller says.
    for word in unsafe { from_raw_parts_mut(words, count) } {
        *word = of(*word).to_bits();
    }
}
