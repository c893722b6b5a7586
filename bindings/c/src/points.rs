//! Points that are a function of indices: Sobol', a recurrence, and random numbers by position; strata.

use crate::error::{Code, code};
use crate::warps::{as_declared, makers};
use core_crate::uniform::{ByPosition, Points, Recurrence, Sobol, Strata1d, Strata2d};

macro_rules! sets {
    ($($name:literal $dimensions:literal $set:ty;)*) => {$(
        const _: () = {
            const _: () = as_declared::<$set>(&["mw_", $name]);

            #[unsafe(export_name = concat!("mw_", $name, "_init"))]
            unsafe extern "C" fn init(set: *mut $set, seed: u32) -> Code {
                // SAFETY: the promise of the header.
                code(<$set>::new(seed), |made| unsafe { set.write(made) })
            }

            #[unsafe(export_name = concat!("mw_", $name, "_point"))]
            unsafe extern "C" fn point(set: &$set, index: u32, u: *mut [f32; $dimensions]) {
                // SAFETY: the promise of the header.
                unsafe { u.write(set.point(index)) }
            }

            #[unsafe(export_name = concat!("mw_", $name, "_words"))]
            unsafe extern "C" fn words(set: &$set, index: u32, words: *mut [u32; $dimensions]) {
                // SAFETY: the promise of the header.
                unsafe { words.write(set.words(index)) }
            }
        };
    )*};
}

sets! {
    "sobol_1d" 1 Sobol<1>;
    "sobol_2d" 2 Sobol<2>;
    "sobol_3d" 3 Sobol<3>;
    "sobol_4d" 4 Sobol<4>;
    "sobol_8d" 8 Sobol<8>;
    "recurrence_1d" 1 Recurrence<1>;
    "recurrence_2d" 2 Recurrence<2>;
    "recurrence_3d" 3 Recurrence<3>;
}

#[unsafe(export_name = "mw_word_by_position")]
extern "C" fn by_position(seed: u32, pixel: u32, index: u32, dimension: u32) -> u32 {
    ByPosition::new(seed, pixel).word(index, dimension)
}

const _: () = as_declared::<Strata1d>(&["mw_strata_1d"]);
const _: () = as_declared::<Strata2d>(&["mw_strata_2d"]);

makers! {
    "strata_1d_init" Strata1d, (count: u32) { Strata1d::new(count) }
    "strata_2d_init" Strata2d, (columns: u32, rows: u32) { Strata2d::new(columns, rows) }
}

#[unsafe(export_name = "mw_strata_1d_point")]
extern "C" fn line_point(strata: &Strata1d, i: u32, u: f32) -> f32 {
    strata.point(i, u)
}

#[unsafe(export_name = "mw_strata_2d_point")]
unsafe extern "C" fn square_point(
    strata: &Strata2d,
    i: u32,
    u: *const [f32; 2],
    point: *mut [f32; 2],
) {
    // SAFETY: the promise of the header.
    unsafe { point.write(strata.point(i, u.read())) }
}
