//! The generator alone, for those rows that contain it.

use crate::registry::kernels;
use microwarp::uniform::grid;
use rand_core::Rng;

kernels! {
    "pcg32_word" (rng) -> u32 = rng.next_u32();
    "pcg32_two_words" (rng) -> [u32; 2] = [rng.next_u32(), rng.next_u32()];
    "pcg32_uniform" (rng) -> f32 = grid(rng);
    "pcg32_two_uniforms" (rng) -> [f32; 2] = [grid(rng), grid(rng)];
}
