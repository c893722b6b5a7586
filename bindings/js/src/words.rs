//! Where the words of draws come from: the generator, or points of a set; strata, which are uniforms; and permutations.

use crate::buffers::Buffers;
use crate::parts::{NOT_LINKED, linked};
use microwarp::uniform::{
    ByPosition, LatinHypercube, Permutation, Points, Screen, Sobol, Strata1d, Strata2d,
    deep_from_word, grid_from_word,
};
use microwarp_js_hot::Pcg32;
use rand_core::Rng;

/// Seeds the generator.
#[unsafe(no_mangle)]
pub extern "C" fn seed(buffers: &mut Buffers, seed: u64, stream: u64) {
    buffers.rng = Pcg32::new(seed, stream);
}

/// Seeds the generator as one of many, by words by position: `SeedableRng::from_rng` of `rand_pcg`.
#[unsafe(no_mangle)]
pub extern "C" fn seed_at(buffers: &mut Buffers, seed: u32, index: u32) {
    let mut words = ByPosition::new(seed, index).at(0);
    let seed = words.next_u64();
    buffers.rng = Pcg32::new(seed, words.next_u64() >> 1);
}

/// Draws words to the input.
#[unsafe(no_mangle)]
pub extern "C" fn random(buffers: &mut Buffers, count: usize) {
    buffers.random(count);
}

/// The words of `count` points from `index` on in `each` dimensions from `dimension` on, to the input, by
/// the kind of the set: 0 a Sobol' sequence of eight dimensions, 1 random numbers by the position `pixel`, 2 a Latin hypercube of as
/// many points, 3 + 256 k + 65536 b the points of the pixel x + 65536 y of a screen of side 2ᵇ with 2ᵏ samples a pixel. 0, or the code
/// of the refusal.
#[unsafe(no_mangle)]
pub extern "C" fn points(
    buffers: &mut Buffers,
    kind: u32,
    seed: u32,
    pixel: u32,
    index: u32,
    dimension: u32,
    each: usize,
    count: usize,
) -> u32 {
    if !const { linked("points") } {
        return NOT_LINKED;
    }
    let words = buffers.input(each.wrapping_mul(count));
    match kind & 255 {
        0 => {
            if let Ok(set) = Sobol::<8>::new(seed) {
                write(set, index, dimension, words, each);
            }
        }
        3 => {
            let screen = Sobol::<8>::new(seed).and_then(|set| {
                let side = 1_u32.wrapping_shl(kind >> 16);
                Screen::new(set, [side, side], kind >> 8 & 255, seed)
            });
            match screen {
                Ok(screen) => {
                    let pixel = screen.pixel(pixel & 0xffff, pixel >> 16);
                    write(pixel, index, dimension, words, each);
                }
                Err(refusal) => return refusal.code().into(),
            }
        }
        1 => write(ByPosition::new(seed, pixel), index, dimension, words, each),
        _ => {
            if let Ok(set) = LatinHypercube::new(pixel, seed) {
                write(set, index, dimension, words, each);
            }
        }
    }
    0
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

/// Turns random uniforms in the input into those of strata `from` and on: of `columns` intervals, or with `rows` of the cells of
/// a grid, one or two uniforms for each of `count` strata. 0, or the code of the refusal.
#[unsafe(no_mangle)]
pub extern "C" fn strata(
    buffers: &mut Buffers,
    columns: u32,
    rows: u32,
    from: u32,
    count: usize,
) -> u32 {
    if !const { linked("points") } {
        return NOT_LINKED;
    }
    let refused = if rows == 0 {
        Strata1d::new(columns).map(|strata| {
            for (i, u) in (from..).zip(buffers.input(count)) {
                *u = strata.point(i, f32::from_bits(*u)).to_bits();
            }
        })
    } else {
        Strata2d::new(columns, rows).map(|strata| {
            let pairs = buffers.input(count.wrapping_mul(2)).chunks_exact_mut(2);
            for (i, pair) in (from..).zip(pairs) {
                if let [x, y] = pair {
                    let place = [*x, *y].map(f32::from_bits);
                    [*x, *y] = strata.point(i, place).map(f32::to_bits);
                }
            }
        })
    };
    refused.map_or_else(|refusal| refusal.code().into(), |()| 0)
}

/// The uniforms of words in the input, in place: on the 24-bit grid, or with `deep` the middles of their cells.
#[unsafe(no_mangle)]
pub extern "C" fn uniforms(buffers: &mut Buffers, count: usize, deep: u32) {
    let of = if deep > 0 {
        deep_from_word
    } else {
        grid_from_word
    };
    for word in buffers.input(count) {
        *word = of(*word).to_bits();
    }
}

/// Writes a permutation to its place. 0, or the code of the refusal.
///
/// # Safety
/// There is room for its 19 words.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn permutation(place: *mut Permutation, count: u32, seed: u32) -> u32 {
    const { assert!(size_of::<Permutation>() == 4 * 19 && align_of::<Permutation>() == 4) };
    if !const { linked("points") } {
        return NOT_LINKED;
    }
    match Permutation::new(count, seed) {
        Ok(made) => {
            // SAFETY: the caller's promise.
            unsafe { place.write(made) };
            0
        }
        Err(refusal) => refusal.code().into(),
    }
}

/// The number at a place of a permutation, or with `inverse` the place of a number; the largest word where there is none.
#[unsafe(no_mangle)]
pub extern "C" fn permuted(order: &Permutation, at: u32, inverse: u32) -> u32 {
    if !const { linked("points") } {
        return u32::MAX;
    }
    let found = match inverse {
        0 => order.get(at),
        _ => order.index_of(at),
    };
    found.unwrap_or(u32::MAX)
}
