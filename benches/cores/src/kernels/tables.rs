//! Tables in flash, which belong to no tier: the index that a word selects, or a point of the tabulated density.

use crate::count::Entry;
use crate::registry::{entry, ok};
use microwarp::Warp;
use microwarp::discrete::{Alias, AliasEntry, Cdf, PiecewiseConstant1d, PiecewiseConstant2d};
use rand_core::Rng;

/// Weights of a table, no two neighbours alike.
const fn weights<const N: usize>() -> [f32; N] {
    let mut weights = [0.0; N];
    let mut index = 0;
    while index < N {
        weights[index] = (index * 37 % 101 + 1) as f32;
        index += 1;
    }
    weights
}

/// Weights of a picture.
const fn picture() -> [[f32; 16]; 8] {
    let (flat, mut picture, mut index) = (weights::<128>(), [[0.0; 16]; 8], 0);
    while index < 128 {
        picture[index / 16][index % 16] = flat[index];
        index += 1;
    }
    picture
}

/// Two kernels and the table of both, which the compiler builds with no other function: by inputs from memory, and
/// drawn.
macro_rules! tables {
    ($(
        $name:literal $drawn:literal $table:ident: $type:ty = $value:expr,
        ($($input:ident: $number:ident),+) -> $out:ty = $body:expr, $rng:ident => $drawn_body:expr;
    )*) => {
        $(
            #[cfg(any(not(one_kernel), kernel = $name, kernel = $drawn))]
            static $table: $type = ok($value);
        )*

        /// Every entry; a measurement leaves one.
        pub static ENTRIES: &[Entry] = &[$(
            #[cfg(any(not(one_kernel), kernel = $name))]
            entry!(($name) ($($input: $number),+) -> $out = $body, {}),
            #[cfg(any(not(one_kernel), kernel = $drawn))]
            entry!(($drawn) ($rng) -> $out = $drawn_body, {}),
        )*];
    };
}

type AliasOf<const N: usize> = Alias<[AliasEntry<u32>; N]>;
type CdfOf<const N: usize> = Cdf<[u32; N]>;
type Pieces<const N: usize> = PiecewiseConstant1d<[u32; N]>;
type Picture<const U: usize, const V: usize> = PiecewiseConstant2d<[u32; V], [[u32; U]; V]>;

const UNIT: [f32; 2] = [0.0, 1.0];

tables! {
    "alias_8" "alias_8_pcg32" ALIAS_8: AliasOf<8> = AliasOf::<8>::new(&weights::<8>()),
        (word: u32) -> usize = ALIAS_8.index(word), rng => ALIAS_8.index(rng.next_u32());
    "alias_64" "alias_64_pcg32" ALIAS_64: AliasOf<64> = AliasOf::<64>::new(&weights::<64>()),
        (word: u32) -> usize = ALIAS_64.index(word), rng => ALIAS_64.index(rng.next_u32());
    "alias_1024" "alias_1024_pcg32" ALIAS_1024: AliasOf<1024> = AliasOf::<1024>::new(&weights::<1024>()),
        (word: u32) -> usize = ALIAS_1024.index(word), rng => ALIAS_1024.index(rng.next_u32());
    "cdf_8" "cdf_8_pcg32" CDF_8: CdfOf<8> = CdfOf::<8>::new(&weights()),
        (word: u32) -> usize = CDF_8.index(word), rng => CDF_8.index(rng.next_u32());
    "cdf_64" "cdf_64_pcg32" CDF_64: CdfOf<64> = CdfOf::<64>::new(&weights()),
        (word: u32) -> usize = CDF_64.index(word), rng => CDF_64.index(rng.next_u32());
    "cdf_1024" "cdf_1024_pcg32" CDF_1024: CdfOf<1024> = CdfOf::<1024>::new(&weights()),
        (word: u32) -> usize = CDF_1024.index(word), rng => CDF_1024.index(rng.next_u32());
    "piecewise_constant_1d_64" "piecewise_constant_1d_64_pcg32"
        PIECES_64: Pieces<64> = Pieces::<64>::new(&weights(), 0.0, 1.0),
        (u: f32) -> f32 = PIECES_64.sample(u), rng => PIECES_64.draw(rng);
    "piecewise_constant_2d_16_8" "piecewise_constant_2d_16_8_pcg32"
        PICTURE_16_8: Picture<16, 8> = Picture::<16, 8>::new(&picture(), UNIT, UNIT),
        (u: f32, v: f32) -> [f32; 2] = PICTURE_16_8.sample([u, v]), rng => PICTURE_16_8.draw(rng);
}
