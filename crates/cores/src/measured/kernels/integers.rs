//! Integers of a range that lies in memory, and whether an event of a chance there happens.

use crate::measured::registry::{kernels, loaded, made};
use microwarp::constant;
use microwarp::uniform::{Chance, Range};

kernels! {
    "range_below" (word: u32) -> u32 = loaded(|| Range::below(1000)).select(word).0, _ = made(|| Range::below(1000));
    "range_below_pcg32" (rng) -> u32 = loaded(|| Range::below(1000)).draw(rng), _ = made(|| Range::below(1000));
    "range_wide_pcg32" (rng) -> u32 = loaded(|| Range::below(1000)).draw_wide(rng), _ = made(|| Range::below(1000));
    "range_u64_pcg32" (rng) -> u32 = loaded(|| Range::of_u64(0, 1 << 40)).draw(rng) as u32,
        _ = made(|| Range::of_u64(0, 1 << 40));
    "chance" (word: u32) -> u32 = loaded(|| Chance::new(0.1)).accepts(word).into(), _ = made(|| Chance::new(0.1));
    "chance_pcg32" (rng) -> u32 = loaded(|| Chance::new(0.1)).draw(rng).into(), _ = made(|| Chance::new(0.1));
    "chance_constant_pcg32" (rng) -> u32 = constant!(Chance::new(0.1)).draw(rng).into();
    "chance_from_ratio_pcg32" (rng) -> u32 = loaded(|| Chance::from_ratio(1, 6)).draw(rng).into(),
        _ = made(|| Chance::from_ratio(1, 6));
}
