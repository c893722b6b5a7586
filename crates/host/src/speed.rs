//! The speeds of the tests, by one switch: the environment variable `MICROWARP_FULL`.
//!
//! - Without it tests are quick: a minute for all of them. Samples are fewer and strides longer; every promise is still
//!   held, every negative control still rejected.
//! - `MICROWARP_FULL=1` is what CI runs: sweeps are exhaustive wherever that takes minutes, distributions take all their
//!   samples, and what the documentation says was measured is measured again and compared.
//! - `MICROWARP_FULL=all` also tries every one of the 2³² words in the kernels of the integer tier, which takes half an
//!   hour, every `f32` and every word in those of the line, which takes some hours of a processor, and every input of every
//!   sampler of one uniform (`tests/accuracy/inputs.rs`): of the grid in half an hour, of words in days.
//!
//! Each choice is printed, past the test harness, which keeps to itself what passing tests print.

use std::collections::BTreeSet;
use std::fmt::Debug;
use std::io::Write as _;
use std::ops::Range;
use std::sync::{Mutex, PoisonError};

#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Speed {
    Quick,
    Full,
    /// Every word there is.
    All,
}

impl Speed {
    fn parse(value: Option<&str>) -> Self {
        match value {
            None | Some("" | "0") => Self::Quick,
            Some("all") => Self::All,
            Some("1") => Self::Full,
            Some(other) => panic!("MICROWARP_FULL is 1 or all, not {other:?}"),
        }
    }
}

/// What was asked for. What is written into the documentation is always measured in full.
pub fn speed() -> Speed {
    let asked = Speed::parse(std::env::var("MICROWARP_FULL").ok().as_deref());
    let writes = std::env::var_os("MICROWARP_WRITE").is_some();
    asked.max(if writes { Speed::Full } else { Speed::Quick })
}

/// Whether exhaustive and long runs were asked for.
pub fn full() -> bool {
    speed() >= Speed::Full
}

/// Whether every word there is was asked for.
pub fn all() -> bool {
    speed() == Speed::All
}

/// Whether tests that try one family after another are to try this one: `MICROWARP_FAMILY=name` asks for those alone that
/// begin with that name.
pub fn wants(family: &str) -> bool {
    std::env::var("MICROWARP_FAMILY").map_or(true, |name| family.starts_with(&name))
}

/// Whether `MICROWARP_FAMILY` leaves some families out.
pub fn is_narrowed() -> bool {
    std::env::var_os("MICROWARP_FAMILY").is_some()
}

/// One of two numbers of samples, strides or the like, by the speed. Says which.
pub fn of<T: Debug>(what: &str, quick: T, full: T) -> T {
    of_three(what, [quick, full], None)
}

/// Likewise with a number of its own for every word there is.
pub fn or_all<T: Debug>(what: &str, quick: T, full: T, all: T) -> T {
    of_three(what, [quick, full], Some(all))
}

fn of_three<T: Debug>(what: &str, [quick, full]: [T; 2], all: Option<T>) -> T {
    let speed = speed();
    let chosen = match (speed, all) {
        (Speed::Quick, _) => quick,
        (Speed::All, Some(all)) => all,
        _ => full,
    };
    say(&format!("{speed:?} speed: {what}: {chosen:?}"));
    chosen
}

/// The numbers below `count`, in blocks of 256 neighbours: all of them, or one of every `quick` in the quick speed.
pub fn blocks(what: &str, count: u32, quick: usize) -> impl Iterator<Item = Range<u32>> {
    let stride = of(
        &format!("{what}: one block of 256 tried of every"),
        quick,
        1,
    );
    let starts = (0..count.div_ceil(256)).step_by(stride);
    starts.map(move |block| 256 * block..(256 * (block + 1)).min(count))
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

/// Prints a line once.
fn say(line: &str) {
    static SAID: Mutex<BTreeSet<String>> = Mutex::new(BTreeSet::new());
    let mut said = SAID.lock().unwrap_or_else(PoisonError::into_inner);
    if said.insert(line.to_owned()) {
        // Nobody may be listening.
        let _ = writeln!(std::io::stderr(), "{line}");
    }
}

#[cfg(test)]
mod tests {
    use super::{Speed, sampled};

    #[test]
    fn the_switch_is_read() {
        assert_eq!(Speed::parse(None), Speed::Quick);
        assert_eq!(Speed::parse(Some("1")), Speed::Full);
        assert_eq!(Speed::parse(Some("all")), Speed::All);
        assert!(Speed::Quick < Speed::Full && Speed::Full < Speed::All);
        assert!(std::panic::catch_unwind(|| Speed::parse(Some("yes"))).is_err());
    }

    #[test]
    fn a_stride_of_1_leaves_nothing_out() {
        assert!(sampled(5..100_000, 1).eq(5..100_000));
        let some: Vec<u32> = sampled(5..100_000, 64).collect();
        assert_eq!((some[0], some[some.len() - 1]), (5, 99_999));
        assert!(some.is_sorted() && some.len() < 10_000);
        assert!(some.windows(2).all(|w| w[0] < w[1] && w[1] <= w[0] + 64));
    }
}
