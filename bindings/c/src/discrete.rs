//! Counts and other integers, one selection from weights that are seen once, and resampling.

use crate::error::{Code, code};
use crate::generators::{Pcg32, Source};
use crate::tables::Selection;
use crate::warps::{as_declared, given, makers, memory};
use core_crate::discrete::{
    Binomial, DiscreteGaussian, DiscreteLaplace, Geometric, LightReservoir, Poisson, Reservoir,
    resampling, select_once, select_once_uniform,
};

macro_rules! counts {
    ($($name:literal $law:ty, $number:ident by $of_word:ident;)*) => {$(
        const _: () = {
            const _: () = as_declared::<$law>(&["mw_", $name]);

            #[unsafe(export_name = concat!("mw_", $name, "_sample"))]
            extern "C" fn sample(law: &$law, u: f32) -> $number {
                law.sample(u)
            }

            #[unsafe(export_name = concat!("mw_", $name, "_", stringify!($of_word)))]
            extern "C" fn of_word(law: &$law, word: u32) -> $number {
                law.$of_word(word)
            }

            #[unsafe(export_name = concat!("mw_", $name, "_draw"))]
            extern "C" fn draw(law: &$law, rng: &mut Pcg32) -> $number {
                law.draw(rng)
            }

            #[unsafe(export_name = concat!("mw_", $name, "_draw_from"))]
            extern "C" fn draw_from(law: &$law, source: &Source, number: &mut $number) -> Code {
                code(law.try_draw(&mut { *source }), |drawn| *number = drawn)
            }

            #[unsafe(export_name = concat!("mw_", $name, "_pmf"))]
            extern "C" fn pmf(law: &$law, number: $number) -> f32 {
                law.pmf(number)
            }
        };
    )*};
}

counts! {
    "geometric" Geometric, u32 by count;
    "poisson" Poisson, u32 by count;
    "binomial" Binomial, u32 by count;
    "discrete_gaussian" DiscreteGaussian, i32 by integer;
    "discrete_laplace" DiscreteLaplace, i32 by integer;
}

makers! {
    "geometric_init" Geometric, (p: f32) { Geometric::new(p) }
    "geometric_init_from_ratio" Geometric, (successes: u32, trials: u32) { Geometric::from_ratio(successes, trials) }
    "poisson_init" Poisson, (mean: f32) { Poisson::new(mean) }
    "poisson_init_from_ratio" Poisson, (events: u32, intervals: u32) { Poisson::from_ratio(events, intervals) }
    "binomial_init" Binomial, (trials: u32, p: f32) { Binomial::new(trials, p) }
    "binomial_init_from_ratio" Binomial, (trials: u32, part: u32, whole: u32) { Binomial::from_ratio(trials, part, whole) }
    "discrete_gaussian_init" DiscreteGaussian, (centre: f32, scale: f32) { DiscreteGaussian::new(centre, scale) }
    "discrete_laplace_init" DiscreteLaplace, (scale: f32) { DiscreteLaplace::new(scale) }
    "discrete_laplace_init_from_ratio" DiscreteLaplace, (part: u32, whole: u32) { DiscreteLaplace::from_ratio(part, whole) }
}

const _: () = as_declared::<Reservoir<u32>>(&["mw_reservoir"]);

// A struct of zeros is an empty reservoir on every target for which this compiles.
const _: () = {
    // SAFETY: the compiler evaluates this, and refuses zeros that are no reservoir.
    let zeros: Reservoir<u32> = unsafe { core::mem::zeroed() };
    assert!(zeros.item().is_none());
};

#[unsafe(export_name = "mw_reservoir_init")]
unsafe extern "C" fn reservoir(reservoir: *mut Reservoir<u32>) {
    // SAFETY: the promise of the header.
    unsafe { reservoir.write(Reservoir::new()) }
}

#[unsafe(export_name = "mw_reservoir_offer")]
extern "C" fn offer(
    reservoir: &mut Reservoir<u32>,
    item: u32,
    weight: f32,
    rng: &mut Pcg32,
    taken: &mut bool,
) -> Code {
    code(reservoir.offer(item, weight, rng), |was| *taken = was)
}

#[unsafe(export_name = "mw_reservoir_offer_from")]
extern "C" fn offer_from(
    reservoir: &mut Reservoir<u32>,
    item: u32,
    weight: f32,
    source: &Source,
    taken: &mut bool,
) -> Code {
    match reservoir.try_offer(item, weight, &mut { *source }) {
        Ok(offered) => code(offered, |was| *taken = was),
        Err(failed) => failed.into(),
    }
}

#[unsafe(export_name = "mw_reservoir_item")]
extern "C" fn item(reservoir: &Reservoir<u32>, item: &mut u32) -> bool {
    match reservoir.item() {
        Some(held) => {
            *item = *held;
            true
        }
        None => false,
    }
}

#[unsafe(export_name = "mw_reservoir_pmf")]
extern "C" fn pmf(reservoir: &Reservoir<u32>) -> f32 {
    reservoir.pmf()
}

const _: () = as_declared::<LightReservoir<u32>>(&["mw_light_reservoir"]);

// A struct of zeros is an empty one, as above.
const _: () = {
    // SAFETY: the compiler evaluates this, and refuses zeros that are no reservoir.
    let zeros: LightReservoir<u32> = unsafe { core::mem::zeroed() };
    assert!(zeros.item().is_none() && zeros.count() == 0);
};

#[unsafe(export_name = "mw_light_reservoir_init")]
unsafe extern "C" fn light_reservoir(reservoir: *mut LightReservoir<u32>) {
    // SAFETY: the promise of the header.
    unsafe { reservoir.write(LightReservoir::new()) }
}

#[unsafe(export_name = "mw_light_reservoir_offer")]
extern "C" fn offer_light(
    reservoir: &mut LightReservoir<u32>,
    item: u32,
    target: f32,
    density: f32,
    rng: &mut Pcg32,
    taken: &mut bool,
) -> Code {
    code(reservoir.offer(item, target, density, rng), |was| {
        *taken = was
    })
}

#[unsafe(export_name = "mw_light_reservoir_offer_from")]
extern "C" fn offer_light_from(
    reservoir: &mut LightReservoir<u32>,
    item: u32,
    target: f32,
    density: f32,
    source: &Source,
    taken: &mut bool,
) -> Code {
    match reservoir.try_offer(item, target, density, &mut { *source }) {
        Ok(offered) => code(offered, |was| *taken = was),
        Err(failed) => failed.into(),
    }
}

#[unsafe(export_name = "mw_light_reservoir_absorb")]
unsafe extern "C" fn absorb_lights(
    reservoir: *mut LightReservoir<u32>,
    other: *const LightReservoir<u32>,
    target: f32,
    rng: &mut Pcg32,
    taken: &mut bool,
) -> Code {
    // SAFETY: the promise of the header; both may be one.
    let other = unsafe { *other };
    // SAFETY: the same.
    let reservoir = unsafe { &mut *reservoir };
    code(reservoir.absorb(other, target, rng), |was| *taken = was)
}

#[unsafe(export_name = "mw_light_reservoir_cap")]
extern "C" fn cap(reservoir: &mut LightReservoir<u32>, limit: u32) {
    reservoir.cap(limit);
}

#[unsafe(export_name = "mw_light_reservoir_normalise")]
extern "C" fn normalise(reservoir: &mut LightReservoir<u32>, candidates: u32) {
    reservoir.normalise(candidates);
}

#[unsafe(export_name = "mw_light_reservoir_item")]
extern "C" fn light(reservoir: &LightReservoir<u32>, item: &mut u32) -> bool {
    match reservoir.item() {
        Some(held) => {
            *item = *held;
            true
        }
        None => false,
    }
}

#[unsafe(export_name = "mw_light_reservoir_target")]
extern "C" fn target(reservoir: &LightReservoir<u32>) -> f32 {
    reservoir.target()
}

#[unsafe(export_name = "mw_light_reservoir_count")]
extern "C" fn candidates(reservoir: &LightReservoir<u32>) -> u32 {
    reservoir.count()
}

#[unsafe(export_name = "mw_light_reservoir_contribution")]
extern "C" fn contribution(reservoir: &LightReservoir<u32>) -> f32 {
    reservoir.contribution()
}

#[unsafe(export_name = "mw_select_once")]
unsafe extern "C" fn once(
    weights: *const f32,
    entries: usize,
    word: u32,
    chosen: *mut Selection,
) -> Code {
    // SAFETY: the promise of the header.
    unsafe {
        code(select_once(given(weights, entries), word), |made| {
            chosen.write(made.into());
        })
    }
}

#[unsafe(export_name = "mw_select_once_uniform")]
unsafe extern "C" fn once_uniform(
    weights: *const f32,
    entries: usize,
    u: f32,
    chosen: *mut Selection,
) -> Code {
    // SAFETY: the promise of the header.
    unsafe {
        code(select_once_uniform(given(weights, entries), u), |made| {
            chosen.write(made.into());
        })
    }
}

#[unsafe(export_name = "mw_resample_to_integers")]
unsafe extern "C" fn to_integers(weights: *const f32, entries: usize, integers: *mut u32) -> Code {
    // SAFETY: the promise of the header.
    let (weights, integers) = unsafe { (given(weights, entries), memory(integers, entries)) };
    code(resampling::to_integers(weights, integers), drop)
}

#[unsafe(export_name = "mw_resample_systematic")]
unsafe extern "C" fn systematic(weights: *mut u32, entries: usize, copies: u32, word: u32) -> Code {
    // SAFETY: the promise of the header.
    let weights = unsafe { memory(weights, entries) };
    code(resampling::systematic(weights, copies, word), drop)
}

#[unsafe(export_name = "mw_resample_residual")]
unsafe extern "C" fn residual(weights: *mut u32, entries: usize, copies: u32, word: u32) -> Code {
    // SAFETY: the promise of the header.
    let weights = unsafe { memory(weights, entries) };
    code(resampling::residual(weights, copies, word), drop)
}

#[unsafe(export_name = "mw_resample_stratified")]
unsafe extern "C" fn stratified(
    weights: *mut u32,
    entries: usize,
    copies: u32,
    rng: &mut Pcg32,
) -> Code {
    // SAFETY: the promise of the header.
    let weights = unsafe { memory(weights, entries) };
    code(resampling::stratified(weights, copies, rng), drop)
}

#[unsafe(export_name = "mw_resample_stratified_from")]
unsafe extern "C" fn stratified_from(
    weights: *mut u32,
    entries: usize,
    copies: u32,
    source: &Source,
) -> Code {
    // SAFETY: the promise of the header.
    let weights = unsafe { memory(weights, entries) };
    match resampling::try_stratified(weights, copies, &mut { *source }) {
        Ok(resampled) => code(resampled, drop),
        Err(failed) => failed.into(),
    }
}
