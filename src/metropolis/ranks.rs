//! Ranks of numbers in a slice, and the normal numbers that stand for them. The order is found without recursion.

use crate::num::{power_of_two, two_sum};
use crate::tier::{Poly, Tier as _};

/// Sorts numbers, none of them NaN, in at most 2 n log₂ n comparisons: a heap sort.
pub(super) fn sort(numbers: &mut [f32]) {
    for root in (0..numbers.len() >> 1).rev() {
        sift(numbers, root);
    }
    let mut heap = numbers;
    while let [first, .., last] = &mut *heap {
        core::mem::swap(first, last);
        let Some((_, rest)) = heap.split_last_mut() else {
            return;
        };
        sift(rest, 0);
        heap = rest;
    }
}

/// Moves the number at a place down until neither child is larger.
fn sift(heap: &mut [f32], mut place: usize) {
    let Some(&x) = heap.get(place) else { return };
    loop {
        let left = place.saturating_mul(2).saturating_add(1);
        let right = left.saturating_add(1);
        let Some(&child) = heap.get(left) else { break };
        let (to, child) = match heap.get(right) {
            Some(&other) if other > child => (right, other),
            _ => (left, child),
        };
        if child <= x {
            break;
        }
        if let Some(slot) = heap.get_mut(place) {
            *slot = child;
        }
        place = to;
    }
    if let Some(slot) = heap.get_mut(place) {
        *slot = x;
    }
}

/// Puts normal numbers in place of numbers by their ranks r among all n, in order: the quantile of (r − 3/8)/(n + 1/4). Equal ones
/// have the mean of their ranks.
pub(super) fn rank_scores(numbers: &mut [f32], sorted: &[f32]) {
    for x in numbers {
        let below = sorted.partition_point(|y| *y < *x);
        let up_to = sorted.partition_point(|y| *y <= *x);
        *x = score(below, up_to, sorted.len());
    }
}

/// The same by the ranks of |x − m| for the median m, which are exact, of an even count.
pub(super) fn folded_scores(numbers: &mut [f32], sorted: &[f32]) {
    let at = |place: usize| sorted.get(place).copied().unwrap_or_default();
    // So that no sum overflows; only beside such numbers do those below 2^-124 lose digits.
    let high = power_of_two(126);
    let huge = at(0) <= -high || at(sorted.len().saturating_sub(1)) >= high;
    let scale = if huge { 0.25 } else { 1.0 };
    // Sums of two numbers and what their rounding has left out are in the order of the exact sums.
    let sum = |x: f32, y: f32| two_sum(scale * x, scale * y);
    let upper = sorted.len() >> 1;
    let twice_median = sum(at(upper.saturating_sub(1)), at(upper));
    for x in numbers {
        // How many are farther down than x is up, or as far; and below x, or up to it.
        let farther = sorted.partition_point(|y| sum(*x, *y) < twice_median);
        let as_far = sorted.partition_point(|y| sum(*x, *y) <= twice_median);
        let below = sorted.partition_point(|y| *y < *x);
        let up_to = sorted.partition_point(|y| *y <= *x);
        let (nearer, at_most) = if sum(*x, *x) >= twice_median {
            (below.saturating_sub(as_far), up_to.saturating_sub(farther))
        } else {
            (farther.saturating_sub(up_to), as_far.saturating_sub(below))
        };
        *x = score(nearer, at_most, sorted.len());
    }
}

/// The normal number of a rank: of the mean of those of equal numbers, of which so many are below, and up to them.
fn score(below: usize, up_to: usize, count: usize) -> f32 {
    // Twice the mean rank is one more than the sum of both; times 4 all terms are integers, but for the half.
    let sum = below.saturating_add(up_to);
    let lower = 2.0 * sum as f32;
    let upper = 2.0 * count.saturating_mul(2).saturating_sub(sum) as f32;
    let tail = |part: f32| Poly::normal_quantile_lower((part + 0.5) / (4.0 * count as f32 + 1.0));
    if lower <= upper {
        tail(lower)
    } else {
        -tail(upper)
    }
}
