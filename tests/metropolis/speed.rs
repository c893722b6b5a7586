//! The two speeds of a long test: its quick form by itself, its full one with `MICROWARP_FULL=1`.

use std::fmt::Debug;
use std::ops::Range;

/// Whether the full forms are asked for.
pub fn full() -> bool {
    std::env::var_os("MICROWARP_FULL").is_some()
}

/// A number of rounds, a stride or the like in the full form and in the quick one. It is printed.
pub fn of<T: Debug>(what: &str, full: T, quick: T) -> T {
    let it = if self::full() { full } else { quick };
    println!("{what}: {it:?}");
    it
}

/// How many numbers at either end of a range are never left out.
const EDGE: u32 = 4096;

/// One of every `stride` numbers of a range, and all that are near its ends.
pub fn sampled(range: Range<u32>, stride: u32) -> impl Iterator<Item = u32> + Clone {
    let inner = range.start + EDGE..range.end - EDGE;
    let edges = [range.start..inner.start, inner.end..range.end];
    let [first, last] = edges;
    first.chain(inner.step_by(stride as usize)).chain(last)
}

#[test]
fn a_stride_of_1_leaves_nothing_out() {
    assert!(sampled(5..100_000, 1).eq(5..100_000));
    let some: Vec<u32> = sampled(5..100_000, 64).collect();
    assert_eq!((some[0], some[some.len() - 1]), (5, 99_999));
    assert!(some.is_sorted() && some.len() < 10_000);
    assert!(some.windows(2).all(|w| w[0] < w[1] && w[1] <= w[0] + 64));
}
