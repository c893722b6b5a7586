//! The generator alone, for those rows that contain it, and others of rand's family beside it: a word of each, and a disk
//! of the integer tier drawn from each.

use crate::measured::count::Entry;
use crate::measured::registry::{entry, kernels, loaded, made};
use microwarp::{Error, Warp, fixed, uniform::grid};
use rand_core::{Rng, SeedableRng};

kernels! {
    "pcg32_word" (rng) -> u32 = rng.next_u32();
    "pcg32_two_words" (rng) -> [u32; 2] = [rng.next_u32(), rng.next_u32()];
    "pcg32_uniform" (rng) -> f32 = grid(rng);
    "pcg32_two_uniforms" (rng) -> [f32; 2] = [grid(rng), grid(rng)];
}

/// Generators of 32-bit arithmetic. Their state is where a prepared warp would be.
macro_rules! others {
    ($($word:literal $disk:literal $generator:ty;)*) => {
        /// Every entry; a measurement leaves one.
        pub static OTHERS: &[Entry] = &[$(
            #[cfg(any(not(one_kernel), kernel = $word))]
            entry!(($word) (_none) -> u32 = loaded(seeded::<$generator>).next_u32(), _ = made(seeded::<$generator>)),
            #[cfg(any(not(one_kernel), kernel = $disk))]
            entry!(
                ($disk) (_none) -> [::fixed::types::I2F30; 2] = fixed::Disk::new().draw(loaded(seeded::<$generator>)),
                _ = made(seeded::<$generator>)
            ),
        )*];
    };
}

fn seeded<G: SeedableRng>() -> Result<G, Error> {
    Ok(G::seed_from_u64(42))
}

others! {
    "sfc32_word" "sfc32_disk" rand_sfc::Sfc32;
    "xorshift_word" "xorshift_disk" rand_xorshift::XorShiftRng;
    "xoroshiro64_word" "xoroshiro64_disk" rand_xoshiro::Xoroshiro64Star;
    "xoshiro128_word" "xoshiro128_disk" rand_xoshiro::Xoshiro128PlusPlus;
}
