//! What is drawn by lot: integers of a range, one lamp of many, orders; and a point of a set that lies in memory, by its index,
//! among the first 1,024 where the bits of the index count.

use crate::measured::registry::{kernels, loaded, made, store};
use microwarp::discrete::LightReservoir;
use microwarp::estimate::{balance_heuristic_of, power_heuristic_of, roulette};
use microwarp::uniform::{
    ByPosition, Chance, LatinHypercube, Permutation, Points, Range, Recurrence, Screen, Sobol,
    choose, shuffle, shuffle_each,
};
use microwarp::{Error, constant};

/// One that has seen a candidate.
fn started() -> LightReservoir<u32> {
    let mut held = LightReservoir::new();
    let _ = held.offer_with(0, 1.5, 0.25, 0);
    held
}

fn deck() -> [u8; 52] {
    core::array::from_fn(|card| card as u8)
}

fn pixel() -> Result<ByPosition, Error> {
    Ok(ByPosition::new(7, 1))
}

fn screen() -> Result<Screen<Sobol<2>>, Error> {
    Screen::new(Sobol::new(7)?, [2048, 2048], 4, 7)
}

kernels! {
    // Integers of a range that lies in memory, and whether an event of a chance there happens.
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

    // One lamp of many, and how a path is weighed.
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

    // Shuffles of items on the stack, which are laid out first; and a number of a permutation in memory, by its place.
    "shuffle_52_pcg32" (rng) -> u32 = { let mut deck = deck(); shuffle(&mut deck, rng); deck[0].into() };
    "shuffle_each_52_pcg32" (rng) -> u32 = { let mut deck = deck(); shuffle_each(&mut deck, rng); deck[0].into() };
    "choose_52_5_pcg32" (rng) -> u32 = { let mut deck = deck(); u32::from(choose(&mut deck, 5, rng).is_ok()) + u32::from(deck[4]) };
    "permutation_16" (place: u32) -> u32 = loaded(|| Permutation::new(16, 7)).get(place >> 28).unwrap_or(0),
        _ = made(|| Permutation::new(16, 7));
    "permutation_1000" (place: u32) -> u32 = loaded(|| Permutation::new(1000, 7)).get(place >> 23).unwrap_or(0),
        _ = made(|| Permutation::new(1000, 7));
    "permutation_1000_inverse" (number: u32) -> u32 = loaded(|| Permutation::new(1000, 7)).index_of(number >> 23).unwrap_or(0),
        _ = made(|| Permutation::new(1000, 7));

    "sobol_2d" (index: u32) -> [u32; 2] = loaded(|| Sobol::<2>::new(7)).words(index),
        _ = made(|| Sobol::<2>::new(7));
    "sobol_8d" (index: u32) -> u32 =
        loaded(|| Sobol::<8>::new(7)).words::<8>(index >> 22).into_iter().fold(0, |all, word| all ^ word),
        _ = made(|| Sobol::<8>::new(7));
    "recurrence_2d" (index: u32) -> [u32; 2] = loaded(|| Recurrence::<2>::new(7)).words(index),
        _ = made(|| Recurrence::<2>::new(7));
    "latin_hypercube_1000" (index: u32) -> [u32; 2] = loaded(|| LatinHypercube::new(1000, 7)).words(index >> 23),
        _ = made(|| LatinHypercube::new(1000, 7));
    "screen_sobol_2d" (place: u32) -> [u32; 2] = loaded(screen).pixel(place >> 21, place >> 10 & 0x7ff).words(place >> 6 & 15),
        _ = made(screen);
    "by_position_2" (index: u32) -> [u32; 2] = loaded(pixel).words(index), _ = made(pixel);
}
