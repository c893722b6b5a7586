//! What only the kernels themselves can show: products and quotients against wider ones, the tables entry by entry,
//! and that both kinds of cores compute the same bits.
#![allow(
    clippy::cast_lossless,
    clippy::float_cmp,
    clippy::integer_division_remainder_used,
    clippy::indexing_slicing,
    clippy::unwrap_used,
    reason = "tests run where there are panics and floats"
)]

mod both_ways;
mod quotients;
mod table_entries;

use std::vec;
use std::vec::Vec;

/// Operands whose halves are all pairs of the ends of 16 bits and of powers of two.
fn structured() -> Vec<u32> {
    let mut halves = vec![
        0, 1, 2, 3, 0x00ff, 0x5555, 0x7ffe, 0x7fff, 0xaaaa, 0xfffe, 0xffff,
    ];
    halves.extend((2..16).map(|bit| 1 << bit));
    let high = halves.iter().map(|half| half << 16);
    high.flat_map(|high| halves.iter().map(move |low| high | low))
        .collect()
}
