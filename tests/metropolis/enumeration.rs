//! The transitions of the step itself: not sampled, but counted over all words that it may draw.
//!
//! The real step is driven by a generator that replays given words. Words next to each other that propose the
//! same form runs, whose ends are found by galloping and halving; so is the number of decision words that
//! accept. What galloping takes for granted is then asked of random words.

use super::own::{Bits, Weighed};
use host::generators::{Counting, Cycle};
use microwarp::metropolis::{Chain, Mutation, Outcome, TargetValue, Transition};
use num_bigint::BigUint;
use rand_core::Rng as _;
use rand_pcg::Pcg32;

/// All words are counted in units of 2^-128: 2^32 words pick, 2^64 propose and 2^32 decide. Of fewer words
/// each counts as often as the missing ones would have made it.
pub const TOTAL_BITS: u32 = 128;

/// The words that a mutation takes.
pub enum Words {
    /// One fraction of 32 or 64 bits, which falls into equal parts: in each of them what is proposed comes in
    /// runs, and not twice.
    Fraction { bits: u32, parts: u64 },
    /// One word that picks, and then those of the mutation picked.
    Picked(Vec<Words>),
}

impl Words {
    pub const ONE: Self = Self::Fraction { bits: 32, parts: 1 };
    pub const TWO: Self = Self::Fraction { bits: 64, parts: 1 };
}

/// All words that propose one thing.
#[derive(Clone, Debug)]
pub struct Path {
    pub to: usize,
    pub kind: u32,
    /// How many words, of 2^96.
    pub proposals: BigUint,
    /// The bits of the acceptance that the step reports: of integer weights, how many words accept.
    pub acceptance: u64,
    /// How many decision words accept, of 2^32.
    pub accepted: u64,
}

/// A number of up to some hundred bits, rounded.
pub fn rounded(x: &BigUint) -> f64 {
    let shift = x.bits().saturating_sub(64);
    let leading = (x >> shift).iter_u64_digits().next().unwrap_or(0);
    leading as f64 * 2_f64.powi(shift as i32)
}

/// Words from `first` to `last` in runs of the same key, by galloping and halving.
pub fn runs<K: PartialEq>(first: u64, last: u64, key: &dyn Fn(u64) -> K) -> Vec<(K, u64, u64)> {
    let (mut runs, mut start) = (Vec::new(), first);
    loop {
        let own = key(start);
        let (mut same, mut stride) = (start, 1_u64);
        let mut other = loop {
            let next = same.checked_add(stride).map_or(last, |n| n.min(last));
            if key(next) != own {
                break Some(next);
            }
            same = next;
            if next == last {
                break None;
            }
            stride = stride.saturating_mul(2);
        };
        while let Some(beyond) = other.filter(|o| o - same > 1) {
            let middle = same + (beyond - same) / 2;
            if key(middle) == own {
                same = middle;
            } else {
                other = Some(middle);
            }
        }
        runs.push((own, start, same));
        match other {
            Some(next) => start = next,
            None => return runs,
        }
    }
}

/// Takes a real step from a state with some words, and says how many of them it took.
type Take<'a, D> = dyn Fn(usize, &[u32]) -> (Step<D>, u64) + 'a;
type Step<D> = Transition<usize, D, <D as TargetValue>::Acceptance>;

/// What is enumerated: the steps of a target and a mutation, of types erased, and the words.
pub struct Driven<'a, D: Weighed> {
    take: Box<Take<'a, D>>,
    words: &'a Words,
}

impl<'a, D: Weighed + 'a> Driven<'a, D> {
    pub fn new(
        target: impl Fn(usize) -> D + 'a,
        mutation: &'a impl Mutation<usize>,
        words: &'a Words,
    ) -> Self {
        let take = move |from: usize, words: &[u32]| {
            let mut chain = Chain::new(from, &target).unwrap();
            let mut rng = Counting::new(Cycle::new(words));
            let step = chain.step(&target, mutation, &mut rng);
            assert_eq!((step.from, step.state()), (from, chain.state()));
            assert_ne!(step.outcome, Outcome::Refused);
            (step, rng.words)
        };
        let take = Box::new(take);
        Self { take, words }
    }

    /// One real step. It takes the words given, all of them, and no other.
    fn step(&self, from: usize, words: &[u32]) -> Step<D> {
        let (step, taken) = (self.take)(from, words);
        assert_eq!(taken, words.len() as u64);
        step
    }

    /// All paths out of a state.
    pub fn paths(&self, from: usize) -> Vec<Path> {
        let mut rng = Pcg32::new(from as u64, 96);
        let all = BigUint::from(1_u64 << 32);
        match self.words {
            Words::Fraction { bits, parts } => {
                self.proposals(from, &[], (*bits, *parts), &all, &mut rng)
            }
            Words::Picked(each) => {
                let kind = |word: u64| {
                    // What follows does not matter: the longest there is, cut to what is taken.
                    let step = |n: usize| self.kind(from, word as u32, n);
                    each.iter().find_map(|w| step(w.count())).unwrap()
                };
                let picks = runs(0, u64::from(u32::MAX), &kind);
                let mut paths = Vec::new();
                for (kind, first, last) in picks {
                    let Words::Fraction { bits, parts } = each[kind as usize] else {
                        unreachable!("mixtures of mixtures are not enumerated")
                    };
                    let count = BigUint::from(last - first + 1);
                    for pick in [first, last] {
                        let pick = [pick as u32];
                        let found = self.proposals(from, &pick, (bits, parts), &count, &mut rng);
                        if pick[0] == first as u32 {
                            paths.extend(found);
                        }
                    }
                    for _ in 0..20 {
                        let word = first + u64::from(rng.next_u32()) % (last - first + 1);
                        let n = each[kind as usize].count();
                        assert_eq!(self.kind(from, word as u32, n), Some(kind));
                    }
                }
                paths
            }
        }
    }

    /// The kind of a mixture at this picking word, if it takes `n` words after that one.
    fn kind(&self, from: usize, pick: u32, n: usize) -> Option<u32> {
        let mut words = vec![0x5555_5555; n + 2];
        words[0] = pick;
        let (step, taken) = (self.take)(from, &words);
        (taken == words.len() as u64).then_some(step.kind)
    }

    /// The paths whose words begin with `pick`, of which there are `picks`.
    fn proposals(
        &self,
        from: usize,
        pick: &[u32],
        (bits, parts): (u32, u64),
        picks: &BigUint,
        rng: &mut Pcg32,
    ) -> Vec<Path> {
        let step = |word: u64, decision: u32| {
            let mut words = pick.to_vec();
            if bits == 64 {
                words.push((word >> 32) as u32);
            }
            words.extend([word as u32, decision]);
            self.step(from, &words)
        };
        let key = |word: u64| {
            let s = step(word, u32::MAX);
            (s.proposed, s.kind, s.acceptance)
        };
        let part = (1_u128 << bits) / u128::from(parts);
        let mut paths = Vec::new();
        for index in 0..u128::from(parts) {
            let (first, last) = (index * part, (index + 1) * part - 1);
            let found = runs(first as u64, last as u64, &key);
            for _ in 0..50 {
                let random = u128::from(rng.next_u64()) % part + first;
                let run = found.iter().find(|r| u128::from(r.2) >= random).unwrap();
                assert_eq!(key(random as u64), run.0);
            }
            for (key, first, last) in found {
                let accepts = |word: u64, decision: u64| step(word, decision as u32).is_accepted();
                let accepted = border(|d| accepts(first, d));
                assert_eq!(accepted, border(|d| accepts(last, d)));
                for _ in 0..20 {
                    let decision = u64::from(rng.next_u32());
                    let word =
                        first + (rng.next_u64() as u128 % (u128::from(last - first) + 1)) as u64;
                    assert_eq!(accepts(word, decision), decision < accepted);
                }
                let words = BigUint::from(u128::from(last - first) + 1);
                paths.push(Path {
                    to: key.0,
                    kind: key.1,
                    proposals: (picks * words) << (64 - bits),
                    acceptance: key.2.bits()[0],
                    accepted,
                });
            }
        }
        paths
    }
}

impl Words {
    /// How many, without the one that picks and the one that decides.
    fn count(&self) -> usize {
        match self {
            Self::Fraction { bits, .. } => *bits as usize / 32,
            Self::Picked(_) => unreachable!("mixtures of mixtures are not enumerated"),
        }
    }
}

/// How many of the 2^32 words accept, which are the lowest ones: it steps on both sides of the border.
pub fn border(accepts: impl Fn(u64) -> bool) -> u64 {
    let found = runs(0, u64::from(u32::MAX), &accepts);
    match found[..] {
        [(true, _, last), (false, ..)] => last + 1,
        [(true, ..)] => 1 << 32,
        [(false, ..)] => 0,
        _ => panic!("acceptance is not monotone in the decision word: {found:?}"),
    }
}
