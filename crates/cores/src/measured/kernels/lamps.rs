//! One lamp of many, and how a path is weighed.

use crate::measured::registry::{kernels, loaded, store};
use microwarp::discrete::LightReservoir;
use microwarp::estimate::{balance_heuristic_of, power_heuristic_of, roulette};

/// One that has seen a candidate.
fn started() -> LightReservoir<u32> {
    let mut held = LightReservoir::new();
    let _ = held.offer_with(0, 1.5, 0.25, 0);
    held
}

kernels! {
    "light_reservoir_offer" (target: f32, density: f32, word: u32) -> u32 = {
        let held: &mut LightReservoir<u32> = loaded(|| Ok(started()));
        u32::from(held.offer_with(word, target, density + 0.5, u64::from(word) << 32) == Ok(true))
    }, store(started());
    "light_reservoir_absorb" (target: f32, word: u32) -> u32 = {
        let held: &mut LightReservoir<u32> = loaded(|| Ok(started()));
        let mut other = *held;
        u32::from(other.absorb_with(*held, target, u64::from(word) << 32) == Ok(true))
    }, store(started());
    "light_reservoir_contribution" (by: u32) -> f32 = {
        let held: &mut LightReservoir<u32> = loaded(|| Ok(started()));
        let mut held = *held;
        held.cap(by | 1);
        held.contribution()
    }, store(started());
    "balance_heuristic_of_3" (a: f32, b: f32, c: f32) -> f32 =
        balance_heuristic_of(&[1, 1, 4], &[a, b, c], 0);
    "power_heuristic_of_3" (a: f32, b: f32, c: f32) -> f32 =
        power_heuristic_of(&[1, 1, 4], &[a, b, c], 0);
    "roulette" (chance: f32, word: u32) -> f32 = roulette(chance, word).unwrap_or(0.0);
}
