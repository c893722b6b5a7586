//! The law that all pairs of words of a transformed rejection have together, counted and not sampled.

use host::errors::or_infinite;
use host::words::first_without;

/// Words at which products of words turn: the ends, the middle, and a neighbour of a power of two.
pub const EDGES: [u32; 8] = [
    0,
    1,
    255,
    (1 << 31) - 1,
    1 << 31,
    (1 << 31) + 1,
    u32::MAX - 1,
    u32::MAX,
];

/// The first word that proposes this count or more. Counts increase with the word; no decision accepts those at the ends.
fn first(count: i64, attempt: &impl Fn([u32; 2]) -> Option<u32>) -> u64 {
    first_without(0..1 << 32, |word| match attempt([word as u32, 0]) {
        Some(k) => i64::from(k) < count,
        None => word < 1 << 31,
    })
}

/// Gauss and Legendre's rule of five points on [0, 1].
const RULE: [(f64, f64); 5] = [
    (0.046_910_077_030_668, 0.118_463_442_528_094_5),
    (0.230_765_344_947_158_5, 0.239_314_335_249_683_2),
    (0.5, 0.284_444_444_444_444_4),
    (0.769_234_655_052_841_5, 0.239_314_335_249_683_2),
    (0.953_089_922_969_332, 0.118_463_442_528_094_5),
];

/// How many pairs are accepted, of the first words from one up to another that propose one count, on one side of the
/// middle.
///
/// There the hat rises outwards, so that an outer word is accepted by more decisions. All words are accepted by the
/// decisions of the innermost; each decision from there to those of the outermost is counted by how many words it
/// accepts. That number falls smoothly as the decision grows, even where the hat is too low and the outer words are
/// accepted by all decisions.
fn pairs(attempt: &impl Fn([u32; 2]) -> Option<u32>, from: u64, to: u64) -> f64 {
    if to <= from {
        return 0.0;
    }
    let accepts = |word: u64, decision: u64| attempt([word as u32, decision as u32]).is_some();
    let share = |word| first_without(0..1 << 32, |decision| accepts(word, decision));
    let upper = from >= 1 << 31;
    let ends = if upper {
        (from, to - 1)
    } else {
        (to - 1, from)
    };
    let (least, most) = (share(ends.0), share(ends.1));
    let of_all = least as f64 * (to - from) as f64;
    if most <= least {
        return of_all;
    }
    let words = |decision: f64| {
        let decision = least + decision.clamp(0.0, (most - least - 1) as f64) as u64;
        let words = if upper {
            to - first_without(from..to, |word| !accepts(word, decision))
        } else {
            first_without(from..to, |word| accepts(word, decision)) - from
        };
        words as f64
    };
    let decisions = (most - least) as f64;
    let at = |(x, w): &(f64, f64)| {
        // A sum over integers is an integral from half a step before the first; between two of them, a straight line.
        let x = x * decisions - 0.5;
        let (below, above) = (words(x.floor()), words(x.floor() + 1.0));
        w * decisions * (below + (above - below) * (x - x.floor()))
    };
    of_all + RULE.iter().map(at).sum::<f64>()
}

/// Probabilities of counts in a row, normalised.
pub struct Masses {
    pub from: u32,
    pub each: Vec<f64>,
}

impl Masses {
    /// From the mode both ways, each from its neighbour: no logarithm and no factorial. `ratio` is that of the probability of the
    /// next count and of this one.
    pub fn around(mode: u32, [from, to]: [u32; 2], ratio: impl Fn(u32) -> f64) -> Self {
        let mut each = Vec::new();
        let mut weight = 1.0;
        for k in (from..mode).rev() {
            weight /= ratio(k);
            each.push(weight);
        }
        each.reverse();
        each.push(1.0);
        weight = 1.0;
        for k in mode..to {
            weight *= ratio(k);
            each.push(weight);
        }
        let sum: f64 = each.iter().sum();
        each.iter_mut().for_each(|weight| *weight /= sum);
        Self { from, each }
    }

    pub fn pmf(&self, count: u32) -> f64 {
        let place = count.checked_sub(self.from).map(|place| place as usize);
        place
            .and_then(|place| self.each.get(place))
            .copied()
            .unwrap_or(0.0)
    }

    /// The largest error of a pmf over all counts, or a thousand of them, where 5e-7 (1 + L) is granted, L = −ln of it, or 2⁻¹⁴⁸.
    pub fn worst_pmf(&self, found: impl Fn(u32) -> f32) -> f64 {
        let stride = self.each.len() / 1000 + 1;
        let places = self.each.iter().zip(self.from..).step_by(stride);
        let errors = places.map(|(&exact, k)| {
            let bound = 5e-7 * (1.0 - exact.ln()) * exact;
            (f64::from(found(k)) - exact).abs() / bound.max(2_f64.powi(-148))
        });
        errors.fold(0.0, |worst, e| worst.max(or_infinite(e)))
    }
}

/// The efficiency, and the largest error of a probability in units of a bound. The law has a mean, a standard deviation, a least
/// and a largest count.
pub fn law(
    [m, deviation]: [f64; 2],
    [least, most]: [u32; 2],
    pmf: impl Fn(u32) -> f64,
    attempt: &impl Fn([u32; 2]) -> Option<u32>,
    bound: impl Fn(f64) -> f64,
) -> [f64; 2] {
    let reach = 7.0 * deviation;
    let last = ((m + reach) as i64).min(most.into());
    let mut all = Vec::new();
    let mut k = ((m - reach) as i64).max(least.into());
    let mut start = first(k, attempt);
    // Few pairs of words lie beyond; what they have is counted as well.
    let mut sum = 0.0;
    while k <= last {
        let end = first(k + 1, attempt);
        let middle = 1 << 31;
        let share = pairs(attempt, start, end.min(middle)) + pairs(attempt, start.max(middle), end);
        sum += share;
        all.push((k as u32, share));
        (start, k) = (end, k + 1);
    }
    let mut worst = 0.0_f64;
    for (k, share) in all {
        if (f64::from(k) - m).abs() > 4.5 * deviation {
            continue;
        }
        let exact = pmf(k);
        let error = (share / sum / exact - 1.0).abs() / bound(f64::from(k) - m);
        worst = worst.max(or_infinite(error));
    }
    [sum / 2.0_f64.powi(64), worst]
}

/// Efficiencies of laws and their errors in units of what is granted.
pub fn assert_laws(tier: &str, found: impl Iterator<Item = (String, [f64; 2])>) {
    let (mut number, mut worst, mut lowest) = (0, 0.0_f64, 1.0_f64);
    for (law, [efficiency, error]) in found {
        assert!(efficiency > 0.76 && efficiency < 0.9, "{law}: {efficiency}");
        // The default budget.
        assert!((1.0 - efficiency).powi(32) < 2_f64.powi(-64));
        assert!(error <= 1.0, "{law}: {error} of the bound");
        (number, lowest) = (number + 1, lowest.min(efficiency));
        worst = worst.max(error);
    }
    println!("{tier}, {number} laws: efficiency from {lowest:.4}, at most {worst:.3} of the bound");
    assert!(number > 0);
}

/// No pair of words leaves a range, or has a count of no probability; counts increase with the first word.
pub fn assert_within(
    range: std::ops::RangeInclusive<u32>,
    pmf: impl Fn(u32) -> f32,
    attempt: impl Fn([u32; 2]) -> Option<u32>,
) {
    let sound = |k| range.contains(&k) && pmf(k) > 0.0 && pmf(k) <= 1.0;
    let places = (0..=4096_u32).map(|i| (i << 20).saturating_sub(1));
    let mut last = 0;
    for place in places.chain(EDGES) {
        for decision in EDGES {
            let count = attempt([place, decision]);
            assert!(count.is_none_or(sound), "{range:?}: {count:?}");
        }
    }
    for k in (0..=4096_u32).filter_map(|i| attempt([(i << 20).saturating_sub(1), 0])) {
        assert!(k >= last);
        last = k;
    }
    assert!(last > 0);
}

/// The law of other parameters, another count, and a squeeze that accepts too much are noticed: `error` is the largest one
/// of an attempt in units of what is granted.
pub fn wrong_ones_are_noticed(
    right: impl Fn([u32; 2]) -> Option<u32>,
    other: impl Fn([u32; 2]) -> Option<u32>,
    error: impl Fn(&dyn Fn([u32; 2]) -> Option<u32>) -> f64,
) {
    for wrong in [
        &other as &dyn Fn([u32; 2]) -> Option<u32>,
        &|words| right(words).map(|k| k + 1),
        &|[a, b]| {
            let squeezed = b < 0xf000_0000 && a.abs_diff(1 << 31) < 0x6e00_0000;
            right([a, if squeezed { 0 } else { b }])
        },
    ] {
        let worst = error(wrong);
        println!("wrong: {worst:.1} of the bound");
        assert!(worst > 1.5, "{worst}");
    }
}
