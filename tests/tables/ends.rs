//! The words of every count of a table against exact sums, which leaves no word out; and what else is asked of all counts.

use host::generators::{Broken, Counting, Failing};
use num_bigint::BigUint;
use std::ops::RangeInclusive;

/// How far the ends of the counts are from where they should be.
#[derive(Debug, Default)]
pub struct Ends {
    pub counts: u32,
    /// Ends that are not the nearest integer to the exact one.
    pub moved: u32,
    /// How far the exact end of such a one lies from the middle between two words, in words.
    pub doubt: f64,
}

/// Goes through all counts that words reach, in their order. `exact` says how many words give up to a count, in units of 2⁻⁶⁴.
pub fn ends(
    count: &dyn Fn(u32) -> u32,
    words_of: &dyn Fn(u32) -> Option<RangeInclusive<u32>>,
    mut exact: impl FnMut(i64) -> u128,
) -> Ends {
    let mut found = Ends::default();
    let (first, last) = (count(0), count(u32::MAX));
    let mut start = 0_u64;
    for k in i64::from(first) - 1..=i64::from(last) + 1 {
        let exact = exact(k);
        let nearest = ((exact + (1 << 63)) >> 64) as u64;
        let words = u32::try_from(k).ok().and_then(words_of);
        // In a tail a count may have less than a word, and none.
        assert!(words.is_some() || k != i64::from(first) && k != i64::from(last));
        assert!(words.is_none() || (i64::from(first)..=i64::from(last)).contains(&k));
        if let Some(words) = words {
            assert_eq!(u64::from(*words.start()), start, "count {k}");
            for word in [*words.start(), *words.end()] {
                assert_eq!(i64::from(count(word)), k, "word {word}");
            }
            start = u64::from(*words.end()) + 1;
            found.counts += 1;
        }
        assert!(
            start.abs_diff(nearest) <= 1,
            "{start} words up to {k}, not {nearest}"
        );
        if start != nearest {
            found.moved += 1;
            let fraction = exact as u64 as f64 / 2_f64.powi(64);
            found.doubt = found.doubt.max((fraction - 0.5).abs());
        }
    }
    assert_eq!(start, 1 << 32);
    found
}

/// Weights of counts in a row and their sums, all of one unit, of which `whole` is the sum of all counts.
pub struct Exact {
    pub from: u32,
    pub each: Vec<BigUint>,
    sums: Vec<BigUint>,
    pub whole: BigUint,
}

impl Exact {
    /// From a count and its weight both ways, each weight from its neighbour: `ratio` is that of a count and the one before.
    /// A weight below `least` ends the row, where none that follows is larger.
    pub fn around(
        mode: u32,
        weight: BigUint,
        [lowest, highest]: [u32; 2],
        least: &BigUint,
        ratio: impl Fn(u32) -> [u128; 2],
    ) -> Self {
        let (mut each, mut from, mut next) = (vec![], mode, weight.clone());
        while from > lowest && &next >= least {
            let [more, less] = ratio(from);
            next = next * less / more;
            each.push(next.clone());
            from -= 1;
        }
        each.reverse();
        each.push(weight.clone());
        let (mut up, mut next) = (mode, weight);
        while up < highest && &next >= least {
            up += 1;
            let [more, less] = ratio(up);
            next = next * more / less;
            each.push(next.clone());
        }
        Self::of(from, each)
    }

    /// Weights of a count and of those behind it.
    pub fn of(from: u32, each: Vec<BigUint>) -> Self {
        let mut sum = BigUint::ZERO;
        let sums = each.iter().map(|weight| {
            sum += weight;
            sum.clone()
        });
        Self {
            from,
            sums: sums.collect(),
            each,
            whole: sum,
        }
    }

    /// How many words give up to this count, in units of 2⁻⁶⁴.
    pub fn words(&self, count: i64) -> u128 {
        match usize::try_from(count - i64::from(self.from)) {
            Err(_) => 0,
            Ok(place) => self.sums.get(place).map_or(1 << 96, |sum| {
                u128::try_from((sum << 96_u32) / &self.whole).unwrap()
            }),
        }
    }

    pub fn pmf(&self, count: u32) -> f64 {
        let place = count.checked_sub(self.from).map(|place| place as usize);
        let Some(weight) = place.and_then(|place| self.each.get(place)) else {
            return 0.0;
        };
        let scaled = (weight << 512_u32) / &self.whole;
        let cut = scaled.bits().max(64) - 64;
        u64::try_from(&scaled >> cut).unwrap() as f64 * 2_f64.powi(cut as i32 - 512)
    }
}

/// An `f32` as a ratio; below 2⁻³⁷, where no word tells it from 0, as that.
pub fn ratio(p: f32) -> [u128; 2] {
    if p < 2_f32.powi(-37) {
        return [0, 1];
    }
    let exact = f64::from(p) * 2_f64.powi(60);
    assert_eq!(exact.fract(), 0.0);
    [exact as u128, 1 << 60]
}

/// The error of an `f32`, in units of what the page grants.
pub fn excess(found: f32, exact: f64) -> f64 {
    (f64::from(found) - exact).abs() / (6.2e-8 * exact).max(2_f64.powi(-149))
}

/// One word, the count of it, and a failure of the generator.
pub fn takes_one<C: PartialEq + std::fmt::Debug>(
    draw: impl Fn(&mut Counting<Failing>) -> Result<C, Broken>,
    count: impl Fn(u32) -> C,
) {
    let word = 0x9234_5678;
    let mut rng = Counting::new(Failing { word, left: 1 });
    assert_eq!(draw(&mut rng).ok(), Some(count(word)));
    assert_eq!(rng.words, 1);
    assert!(draw(&mut rng).is_err());
}

pub fn noticed(judge: &dyn Fn() -> Ends) -> bool {
    std::panic::catch_unwind(std::panic::AssertUnwindSafe(judge)).is_err()
}

/// How many of the first ends are off by a word and more where a pmf is summed in `f32`.
pub fn off_in_floats(pmf: impl Fn(u32) -> f32, law: &Exact) -> usize {
    let mut sum = 0.0_f32;
    let off = |k: &u32| {
        sum += pmf(*k);
        let exact = (law.words((*k).into()) >> 64) as f64;
        (f64::from(sum) * 2_f64.powi(32) - exact).abs() > 1.0
    };
    (0..100).filter(off).count()
}
