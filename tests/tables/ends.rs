//! The words of every count of a table against exact sums, which leaves no word out.

use crate::counts::Ends;
use num_bigint::BigUint;
use std::ops::RangeInclusive;

/// Goes through all counts that words reach. `exact` says how many words give up to a count, in units of 2⁻⁶⁴.
pub fn ends(
    count: &dyn Fn(u32) -> u32,
    words_of: &dyn Fn(u32) -> Option<RangeInclusive<u32>>,
    exact: &dyn Fn(i64) -> u128,
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
