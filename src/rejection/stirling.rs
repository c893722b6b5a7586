//! What mass functions of counts are made of, deviances and the error of Stirling's formula, and where both hats of counts
//! bend.

use crate::num::LARGEST;
use crate::tier::Tier;

/// 1/√2π.
pub(super) const PEAK: f32 = 0.398_942_3;

/// Where the tails of a hat begin, as a part of the words on each side.
pub(super) const TAILS: f32 = 0.07;

/// k ln(k/m) − (k − m) of a count k above 0, from k − m, without cancellation where k is near m.
#[inline]
pub(super) fn deviance<T: Tier>(k: f32, mean: f32, away: f32) -> f32 {
    let v = away / (2.0 * mean + away);
    if v.abs() < 0.5 {
        let w = v * v;
        let mut series = 1.0 / 25.0;
        for odd in [23.0, 21.0, 19.0, 17.0, 15.0, 13.0, 11.0, 9.0, 7.0, 5.0, 3.0] {
            series = 1.0 / odd + w * series;
        }
        away * v + 2.0 * k * (v * w * series)
    } else {
        // Far below a large mean the quotient rounds to −1, of which the logarithm is infinite.
        k * T::ln_1p((away / mean).max(-LARGEST)) - away
    }
}

/// By how much the logarithm of k! is above Stirling's formula, for a count above 0.
#[inline]
pub(super) fn excess(count: u32) -> f32 {
    let r = 1.0 / count as f32;
    let s = r * r;
    if count == 1 {
        0.081_061_47
    } else {
        r * (1.0 / 12.0 - s * (1.0 / 360.0 - s * (1.0 / 1260.0 - s * (1.0 / 1680.0))))
    }
}
