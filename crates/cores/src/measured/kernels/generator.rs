//! The generator alone, for those rows that contain it, and others of rand's family beside it: a word of each, and a disk
//! of the integer tier drawn from each.

use crate::measured::registry::{kernels, loaded, made};
use ::fixed::types::I2F30;
use microwarp::{Error, Warp, fixed, uniform::grid};
use rand_core::{Rng, SeedableRng};
use rand_sfc::Sfc32;
use rand_xorshift::XorShiftRng;
use rand_xoshiro::{Xoroshiro64Star, Xoshiro128PlusPlus};

fn seeded<G: SeedableRng>() -> Result<G, Error> {
    Ok(G::seed_from_u64(42))
}

kernels! {
    "pcg32_word" (rng) -> u32 = rng.next_u32();
    "pcg32_two_words" (rng) -> [u32; 2] = [rng.next_u32(), rng.next_u32()];
    "pcg32_uniform" (rng) -> f32 = grid(rng);
    "pcg32_two_uniforms" (rng) -> [f32; 2] = [grid(rng), grid(rng)];

    // Of 32-bit arithmetic. Their state is where a prepared warp would be.
    "sfc32_word" (_none) -> u32 = loaded(seeded::<Sfc32>).next_u32(), _ = made(seeded::<Sfc32>);
    "sfc32_disk" (_none) -> [I2F30; 2] = fixed::Disk::new().draw(loaded(seeded::<Sfc32>)), _ = made(seeded::<Sfc32>);
    "xorshift_word" (_none) -> u32 = loaded(seeded::<XorShiftRng>).next_u32(), _ = made(seeded::<XorShiftRng>);
    "xorshift_disk" (_none) -> [I2F30; 2] = fixed::Disk::new().draw(loaded(seeded::<XorShiftRng>)), _ = made(seeded::<XorShiftRng>);
    "xoroshiro64_word" (_none) -> u32 = loaded(seeded::<Xoroshiro64Star>).next_u32(), _ = made(seeded::<Xoroshiro64Star>);
    "xoroshiro64_disk" (_none) -> [I2F30; 2] = fixed::Disk::new().draw(loaded(seeded::<Xoroshiro64Star>)), _ = made(seeded::<Xoroshiro64Star>);
    "xoshiro128_word" (_none) -> u32 = loaded(seeded::<Xoshiro128PlusPlus>).next_u32(), _ = made(seeded::<Xoshiro128PlusPlus>);
    "xoshiro128_disk" (_none) -> [I2F30; 2] = fixed::Disk::new().draw(loaded(seeded::<Xoshiro128PlusPlus>)), _ = made(seeded::<Xoshiro128PlusPlus>);
}
