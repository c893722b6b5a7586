//! The effective size of sequences: how many independent numbers would estimate their mean with the same error.

use crate::estimate::{Moments, Scale, Sum};
use crate::tier::{Poly, Tier as _};

pub(super) fn moments<'a>(run: impl IntoIterator<Item = &'a f32>) -> Moments {
    let mut moments = Moments::new();
    for &x in run {
        moments.push(x);
    }
    moments
}

/// The effective size of sequences of this length, from which it takes their means.
pub(super) fn effective(scores: &mut [f32], length: usize) -> f32 {
    let (count, length, n) = (scores.len() as f32, length.max(1), length as f32);
    let sequences = scores.chunks_exact(length).map(moments);
    let scale = sequences.fold(Scale::FINEST, |scale, s| scale.joined(s.scale()));
    let (mut centre, mut means, mut variances) = (None, Moments::new(), Moments::new());
    for sequence in scores.chunks_exact_mut(length) {
        let moments = moments(&*sequence);
        let own = moments.centre_on(scale);
        let common = *centre.get_or_insert(own);
        let from = |centre| moments.seen_from(scale, centre).unwrap_or_default();
        let (rest, std_dev) = from(own);
        means.push(from(common).0);
        variances.push(std_dev * std_dev);
        for x in sequence {
            *x = (scale.apply(*x) - own) - rest;
        }
    }
    let within = variances.mean().unwrap_or_default();
    let pooled = within * ((n - 1.0) / n) + means.variance().unwrap_or_default();
    if pooled > 0.0 {
        let rho = |lag: usize| {
            let mut sum = Sum::ZERO;
            // Not 0 either way, but the compiler has to see it here.
            for sequence in scores.chunks_exact(length.max(1)) {
                for (x, y) in sequence.iter().zip(sequence.get(lag..).unwrap_or_default()) {
                    sum = sum.plus(x * y);
                }
            }
            1.0 - (within - sum.value() / count) / pooled
        };
        count / time(rho, length, count)
    } else {
        count
    }
}

/// The integrated time by the initial monotone sequence, of autocorrelations within sequences of this length; at least 1/lg of the
/// number of draws.
fn time(rho: impl Fn(usize) -> f32, length: usize, count: f32) -> f32 {
    let (mut sum, mut least) = (Sum::ZERO.plus(-1.0), f32::MAX);
    let (mut lag, mut even, mut pair) = (1, 1.0, 1.0 + rho(1));
    while lag < length.saturating_sub(3) && pair > 0.0 {
        least = if pair < least { pair } else { least };
        sum = sum.plus(2.0 * least);
        even = rho(lag.saturating_add(1));
        pair = even + rho(lag.saturating_add(2));
        lag = lag.saturating_add(2);
    }
    // Of the pair at which the series ends, the first counts once.
    if even > 0.0 || pair >= 0.0 {
        sum = sum.plus(even);
    }
    let least = core::f32::consts::LN_10 / Poly::ln(count);
    let time = sum.value();
    if time > least { time } else { least }
}
