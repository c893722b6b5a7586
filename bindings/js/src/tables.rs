//! Tables of weights, in memory of the caller: a head of six numbers and the entries behind it.

use crate::buffers::{Arrays, Buffers};
use crate::flat::{get, put};
use crate::lights::LIGHTS;
use crate::mixture::{self, MIXTURES, kind};
use crate::parts::{NOT_LINKED, linked};
use crate::warps::{DRAW, SAMPLE, all, refused_weight};
use core::slice::{from_raw_parts, from_raw_parts_mut};
use microwarp::Error;
use microwarp::discrete::{
    Alias, AliasEntry, Cdf, PiecewiseConstant1d, PiecewiseConstant2d, PiecewiseLinear1d, Selection,
};
use microwarp::poly::{GgxVisible, LatLongMap, Reflected};
use microwarp_js_hot::{by_alias, by_cdf};

/// Tables of indices, and densities made of pieces.
const INDICES: bool = linked("indices");
const PIECES: bool = linked("pieces");

/// The kinds of a mixture and of reflections, whose normals are the table.
const MIXTURE: u32 = 6;
const REFLECTED: u32 = 7;

/// Whether the module has tables of a kind.
const fn has(kind: u32) -> bool {
    match kind {
        0 | 1 => INDICES,
        MIXTURE => MIXTURES,
        REFLECTED => LIGHTS,
        _ => PIECES,
    }
}

/// What a density made of pieces may be mixed with.
pub const fn kind_of(table: u32) -> Option<u8> {
    match table {
        2 | 3 => Some(kind::<PiecewiseConstant1d<&[u32]>>()),
        4 => Some(kind::<PiecewiseConstant2d<&[u32], &[u32]>>()),
        5 => Some(kind::<LatLongMap<&[u32], &[u32]>>()),
        REFLECTED => Some(kind::<Reflected>()),
        _ => None,
    }
}

/// What lies in front of the entries.
#[derive(Clone, Copy)]
#[repr(C)]
pub struct Head {
    /// How many entries there are a row, and how many rows.
    shape: [usize; 2],
    /// The bounds of the domain, along each coordinate.
    bounds: [[f32; 2]; 2],
}

/// The entries behind the head, so many words.
unsafe fn behind<'a>(table: *mut Head, words: usize) -> &'a mut [u32] {
    // SAFETY: the caller has room for them.
    unsafe { from_raw_parts_mut(table.add(1).cast(), words) }
}

/// Makes a table of a kind of the weights at `weights`, by the head at `table`: 0 `Cdf`, 1 `Alias`, 2 constant on
/// pieces, 3 linear on pieces, 4 constant on cells, 5 a sky; 6 the chooser of a mixture, which has a head of its own. 0, or the
/// code of the refusal and the index of a weight times 32.
///
/// # Safety
/// The weights lie there; there is room for a word each, and for each row; with `Alias` for three words a bin.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tabulate(kind: u32, table: *mut Head, weights: *const f32) -> u32 {
    if !has(kind) {
        return NOT_LINKED;
    }
    if kind == MIXTURE {
        // SAFETY: as the caller says.
        return unsafe { mixture::made(table.cast(), weights) };
    }
    // SAFETY: as the caller says.
    let made = unsafe {
        let Head {
            shape,
            bounds: [[low, high], [from, to]],
        } = *table;
        let [width, height] = shape;
        let count = width.wrapping_mul(height);
        let weights = from_raw_parts(weights, count);
        let words = behind(table, count.wrapping_add(height));
        match kind {
            0 => Cdf::new_in(weights, words).map(drop),
            1 => {
                let bins = from_raw_parts_mut(
                    table.add(1).cast::<AliasEntry<u32>>(),
                    count.next_power_of_two(),
                );
                Alias::new_in(weights, bins).map(drop)
            }
            2 => PiecewiseConstant1d::new_in(weights, low, high, words).map(drop),
            3 => behind(table, count.wrapping_mul(2))
                .split_at_mut_checked(count)
                .map_or(Err(Error::NoWeights), |(words, kept)| {
                    PiecewiseLinear1d::new_in(weights, low, high, words)?;
                    for (kept, weight) in kept.iter_mut().zip(weights) {
                        *kept = weight.to_bits();
                    }
                    Ok(())
                }),
            _ => {
                let Some((rows, cells)) = words.split_at_mut_checked(height) else {
                    return 0;
                };
                if kind == 4 {
                    PiecewiseConstant2d::new_in(
                        weights,
                        shape,
                        [low, high],
                        [from, to],
                        rows,
                        cells,
                    )
                    .map(drop)
                } else {
                    LatLongMap::new_in(weights, shape, rows, cells).map(drop)
                }
            }
        }
    };
    made.map_or_else(refused_weight, |()| 0)
}

/// Does to each element what `evaluate` does, for a table by its kind. Of `Cdf` and `Alias` the drawn points are indices,
/// samples are an index, its probability and the leftover uniform, and densities are probabilities. Draws `random` words first.
///
/// # Safety
/// `tabulate` has written the table by this kind, whose elements have so many numbers.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn look_up(
    kind: u32,
    what: u32,
    table: *mut Head,
    buffers: &mut Buffers,
    inputs: usize,
    outputs: usize,
    count: usize,
    random: usize,
) {
    if !has(kind) {
        return;
    }
    buffers.random(random);
    let arrays = buffers.arrays(inputs, outputs, count);
    let Arrays {
        input,
        output,
        count,
        ..
    } = arrays;
    // SAFETY: as the caller says. Finished tables are taken as they are, in constant time; none is refused.
    unsafe {
        let entries = || {
            let [width, height] = (*table).shape;
            let words: &[u32] = behind(table, width.wrapping_mul(height));
            words
        };
        match kind {
            0 => {
                if let Ok(cdf) = Cdf::from_trusted_words(entries()) {
                    if what == DRAW {
                        by_cdf(
                            cdf,
                            from_raw_parts(input.cast(), count),
                            from_raw_parts_mut(output.cast(), count),
                        );
                    } else {
                        chosen(
                            what,
                            arrays,
                            |u| cdf.select_uniform(u),
                            |index| cdf.pmf(index),
                        );
                    }
                }
            }
            1 => {
                let words = entries();
                let bins = from_raw_parts(
                    words.as_ptr().cast::<AliasEntry<u32>>(),
                    words.len().next_power_of_two(),
                );
                if let Ok(alias) = Alias::from_trusted_bins(bins, words.len()) {
                    if what == DRAW {
                        by_alias(
                            alias,
                            from_raw_parts(input.cast(), count),
                            from_raw_parts_mut(output.cast(), count),
                        );
                    } else {
                        chosen(
                            what,
                            arrays,
                            |u| alias.select_uniform(u),
                            |index| alias.pmf(index),
                        );
                    }
                }
            }
            MIXTURE => mixture::all(table.cast(), what, arrays),
            _ => piece(kind, what, table, arrays),
        }
    }
}

/// The same for a density made of pieces, and for reflections.
///
/// # Safety
/// As for [`look_up`].
pub unsafe fn piece(kind: u32, what: u32, table: *mut Head, arrays: Arrays) {
    if kind == REFLECTED && LIGHTS {
        // SAFETY: as the caller says.
        return unsafe { all(&Reflected::new(*table.cast::<GgxVisible>()), what, arrays) };
    }
    if !PIECES {
        return;
    }
    // SAFETY: as the caller says. Finished tables are taken as they are, in constant time; none is refused.
    unsafe {
        let Head {
            shape: [width, height],
            bounds: [[low, high], [from, to]],
        } = *table;
        let cells = width.wrapping_mul(height);
        let words: &[u32] = behind(table, cells);
        match kind {
            2 => {
                if let Ok(warp) = Cdf::from_trusted_words(words)
                    .and_then(|cdf| PiecewiseConstant1d::from_cdf(cdf, low, high))
                {
                    all(&warp, what, arrays);
                }
            }
            3 => {
                let weights = from_raw_parts(words.as_ptr_range().end.cast(), cells);
                if let Ok(warp) = Cdf::from_trusted_words(words)
                    .and_then(|cdf| PiecewiseLinear1d::from_cdf(cdf, weights, low, high))
                {
                    all(&warp, what, arrays);
                }
            }
            _ => {
                let Some((rows, cells)) =
                    behind(table, cells.wrapping_add(height)).split_at_checked(height)
                else {
                    return;
                };
                if kind == 4 {
                    if let Ok(warp) = PiecewiseConstant2d::from_trusted_words(
                        rows,
                        cells,
                        [low, high],
                        [from, to],
                    ) {
                        all(&warp, what, arrays);
                    }
                } else if let Ok(warp) = LatLongMap::from_trusted_words(rows, cells) {
                    all(&warp, what, arrays);
                }
            }
        }
    }
}

/// Selects by a uniform, or tells the probability of an index, element by element.
unsafe fn chosen(
    what: u32,
    mut arrays: Arrays,
    select: impl Fn(f32) -> Selection,
    pmf: impl Fn(usize) -> f32,
) {
    while arrays.count > 0 {
        // SAFETY: as the caller of `look_up` says.
        unsafe {
            if what == SAMPLE {
                let of = select(get(arrays.input));
                let index = f32::from_bits(of.index as u32);
                put(arrays.output, [index, of.pmf, of.leftover]);
            } else {
                put(arrays.output, pmf(get::<u32>(arrays.input) as usize));
            }
        }
        arrays.next();
    }
}
