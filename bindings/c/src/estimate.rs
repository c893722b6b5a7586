//! Estimators: means, weighted means, integrals and their errors; and the weights of multiple importance sampling.

use crate::warps::{as_declared, given};
use core_crate::estimate::{
    Integral, Moments, WeightedMean, balance_heuristic, balance_heuristic_of, power_heuristic,
    power_heuristic_of, roulette,
};

/// An estimator as it starts, in the place of one that has seen nothing: that may be a struct of zeros.
#[inline]
fn started<T>(of: &mut T, count: u64, refused: u64, new: T) -> &mut T {
    if count == 0 && refused == 0 {
        *of = new;
    }
    of
}

/// What every estimator has: a start, values, a sum of two, and counts.
macro_rules! estimators {
    ($($name:literal $estimator:ty, push($($value:ident),*) { $($figure:literal $get:ident;)* })*) => {$(
        const _: () = {
            const _: () = as_declared::<$estimator>(&["mw_", $name]);

            #[unsafe(export_name = concat!("mw_", $name, "_init"))]
            unsafe extern "C" fn init(of: *mut $estimator) {
                // SAFETY: the promise of the header.
                unsafe { of.write(<$estimator>::new()) }
            }

            #[unsafe(export_name = concat!("mw_", $name, "_push"))]
            extern "C" fn push(of: &mut $estimator, $($value: f32),*) {
                let (count, refused) = (of.count(), of.refused());
                started(of, count, refused, <$estimator>::new()).push($($value),*);
            }

            #[unsafe(export_name = concat!("mw_", $name, "_merge"))]
            unsafe extern "C" fn merge(of: *mut $estimator, other: *const $estimator) {
                // SAFETY: the promise of the header; both may be one.
                let other = unsafe { *other };
                // SAFETY: the same.
                let of = unsafe { &mut *of };
                let (count, refused) = (of.count(), of.refused());
                started(of, count, refused, <$estimator>::new()).merge(&other);
            }

            #[unsafe(export_name = concat!("mw_", $name, "_count"))]
            extern "C" fn count(of: &$estimator) -> u64 {
                of.count()
            }

            #[unsafe(export_name = concat!("mw_", $name, "_refused"))]
            extern "C" fn refused(of: &$estimator) -> u64 {
                of.refused()
            }
        };
        $(const _: () = {
            #[unsafe(export_name = concat!("mw_", $name, $figure))]
            extern "C" fn figure(of: &$estimator, to: &mut f32) -> bool {
                match of.$get() {
                    Some(x) => {
                        *to = x;
                        true
                    }
                    None => false,
                }
            }
        };)*
    )*};
}

estimators! {
    "moments" Moments, push(x) {
        "_mean" mean;
        "_variance" variance;
        "_population_variance" population_variance;
        "_std_dev" std_dev;
        "_standard_error" standard_error;
    }
    "weighted_mean" WeightedMean, push(value, weight) {
        "_mean" mean;
        "_standard_error" standard_error;
    }
    "integral" Integral, push(f, pdf) {
        "_estimate" estimate;
        "_standard_error" standard_error;
    }
}

#[unsafe(export_name = "mw_balance_heuristic")]
extern "C" fn balance(n_f: u32, p_f: f32, n_g: u32, p_g: f32) -> f32 {
    balance_heuristic(n_f, p_f, n_g, p_g)
}

#[unsafe(export_name = "mw_power_heuristic")]
extern "C" fn power(n_f: u32, p_f: f32, n_g: u32, p_g: f32) -> f32 {
    power_heuristic(n_f, p_f, n_g, p_g)
}

#[unsafe(export_name = "mw_balance_heuristic_of")]
unsafe extern "C" fn balance_of(
    counts: *const u32,
    densities: *const f32,
    techniques: usize,
    own: usize,
) -> f32 {
    // SAFETY: the promise of the header.
    let (counts, densities) = unsafe { (given(counts, techniques), given(densities, techniques)) };
    balance_heuristic_of(counts, densities, own)
}

#[unsafe(export_name = "mw_power_heuristic_of")]
unsafe extern "C" fn power_of(
    counts: *const u32,
    densities: *const f32,
    techniques: usize,
    own: usize,
) -> f32 {
    // SAFETY: the promise of the header.
    let (counts, densities) = unsafe { (given(counts, techniques), given(densities, techniques)) };
    power_heuristic_of(counts, densities, own)
}

#[unsafe(export_name = "mw_roulette")]
extern "C" fn survives(chance: f32, word: u32, weight: &mut f32) -> bool {
    match roulette(chance, word) {
        Some(by) => {
            *weight = by;
            true
        }
        None => false,
    }
}
