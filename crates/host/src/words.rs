//! Words over which kernels are tried, and where among words something ends.

use crate::speed;
use std::ops::Range;

/// The first of the numbers in a range, or its end, of which something no longer holds that holds of those before; by bisection.
pub fn first_without(range: Range<u64>, holds: impl Fn(u64) -> bool) -> u64 {
    let Range { mut start, mut end } = range;
    while start < end {
        let middle = u64::midpoint(start, end);
        if holds(middle) {
            start = middle + 1;
        } else {
            end = middle;
        }
    }
    start
}

/// Where kernels tend to break: the first and the last words, powers of two, quarters, and the borders of the cells
/// of every table, each with its neighbours. In the quick speed there are fewer neighbours.
pub fn edges() -> Vec<u32> {
    let first = speed::of("first and last words", 1 << 13, 1 << 16);
    let near = |full: u32| speed::of("neighbours of edges", full / 4, full);
    let every = speed::of("one leading half or head tried of every", 8, 1);
    let mut edges: Vec<u32> = (0..first).flat_map(|w: u32| [w, !w]).collect();
    let mut around = |centre: u32, reach: u32| {
        edges.extend((0..=2 * reach).map(|i| centre.wrapping_add(i).wrapping_sub(reach)));
    };
    (0..32).for_each(|bit| around(1 << bit, 64));
    (0..8).for_each(|eighth| around(eighth << 29, 1000));
    // Of all tables on a grid of phases or numbers.
    (0..1 << 10).for_each(|cell| around(cell << 22, 8));
    // Of logarithms and roots below 1, after normalising.
    for shift in 0..26 {
        for cell in 0..256 {
            around((cell << 24) >> shift, near(8));
            around(((cell << 24) >> shift).wrapping_neg(), near(8));
        }
    }
    // Of exponentials: cells that are found from the leading half, halvings, and of small numbers where the leading
    // 16 bits change.
    let leading = || (0..1 << 16).step_by(every);
    leading().for_each(|half| around(half << 16, 2));
    let halving = std::f64::consts::LN_2 * f64::from(1 << 27);
    (0..47).for_each(|i| around((f64::from(i) * halving) as u32, 8));
    leading().for_each(|head| around(head << 8, 1));
    edges.sort_unstable();
    edges.dedup();
    edges
}
