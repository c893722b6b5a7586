//! What constructors make of their parameter, tried of every one.

use crate::inputs::{STRIDE, in_parallel};
use host::errors::raise;
use microwarp::tier::Tier;
use microwarp::warp::Cone;
use std::f32::consts::PI;

/// The largest errors, in halves of an ulp of the exact number: of numbers below 1/8, and of each quarter of a binade up to 2.
pub type Halves = [f64; 17];

/// Which of them is that of a number.
pub fn of_size(x: f64) -> usize {
    let quarters = |x: f64| x.to_bits() >> 50;
    let above = (quarters(x) + 1).saturating_sub(quarters(0.125));
    (above as usize).min(16)
}

fn larger(a: Halves, b: Halves) -> Halves {
    std::array::from_fn(|i| a[i].max(b[i]))
}

/// Of every `f32` from one to another.
fn worst(from: f32, to: f32, error: impl Fn(f32) -> (f32, f64) + Sync) -> Halves {
    let parts = in_parallel(256, |part| {
        let mut worst = [0.0; 17];
        for bits in (from.to_bits() + part..=to.to_bits()).step_by(256 * *STRIDE as usize) {
            let (is, due) = error(f32::from_bits(bits));
            let half = f64::from_bits(((due.to_bits() >> 52) - 24) << 52);
            let halves = (f64::from(is) - due).abs() / half;
            let worst = &mut worst[of_size(due)];
            raise(worst, halves);
        }
        worst
    });
    parts.into_iter().fold([0.0; 17], larger)
}

/// Every angle and every sine from here on is tried.
const FIRST: f32 = 1.0 / 8192.0;
const FIRST_SINE: f32 = 1.0 / 33_554_432.0;

/// What k of a cone and 2 - k are off by.
pub fn cone<T: Tier>() -> [Halves; 2] {
    let by_angle = |x: f32| Cone::<T>::from_radians(x).map_or(0.0, |cone| cone.one_minus_cos());
    let angles = worst(FIRST, PI, |x| {
        (by_angle(x), 2.0 * (0.5 * f64::from(x)).sin().powi(2))
    });
    let sines = worst(FIRST_SINE, 1.0, |s| {
        let cone = Cone::<T>::from_sine(s).expect("a sine");
        let s = f64::from(s);
        let cos = ((1.0 - s) * (1.0 + s)).sqrt();
        (cone.one_minus_cos(), s * s / (1.0 + cos))
    });
    // Of obtuse angles 1 + cos is 1 - cos of what they leave of π, which is less than its `f32` by the second number.
    let excess = (f64::from(PI) - std::f64::consts::PI) as f32;
    let rests = worst(0.5 * PI, PI, |x| {
        // An even function; π itself is left by a negative angle.
        let left = ((PI - x) - excess).abs();
        (by_angle(left), 2.0 * (0.5 * f64::from(x)).cos().powi(2))
    });
    // Below the first angle k is x²/2, which is put right by less than a 2^-23rd of it and rounded once; next to the smallest
    // cone the rounding error of the square underflows. Below the first sine it is half the square.
    let mut k = larger(angles, sines);
    k[0] = k[0].max(2.1);
    [k, rests]
}
