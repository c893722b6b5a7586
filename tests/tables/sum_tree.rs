//! `SumTree`: its words by exact integer arithmetic, through any changes, and what it refuses. Wrong trees are rejected by the
//! same check.

use crate::Given;
use crate::cases::counts;
use host::generators::{Broken, Counting, Failing};
use host::speed;
use microwarp::Error;
use microwarp::discrete::{Cdf, MAX_ENTRIES, SumTree, Word};
use rand_pcg::Pcg32;
use rand_pcg::rand_core::Rng;
use std::ops::{AddAssign, RangeInclusive, Sub};

/// The words of each entry as whole numbers say: from ⌈c·2ᵇ/W⌉ to the next such number.
fn words_of(weights: &[u128], bits: u32) -> Vec<Option<RangeInclusive<u128>>> {
    let total: u128 = weights.iter().sum();
    let mut before = 0;
    // The product may overflow for the total itself.
    let first = |sum: u128| match sum {
        sum if sum == total => 1 << bits,
        sum => (sum << bits).div_ceil(total),
    };
    let of = weights.iter().map(|&weight| {
        let from = before;
        before += weight;
        (weight > 0).then(|| first(from)..=first(before) - 1)
    });
    of.collect()
}

/// A word of a tree, by its number.
trait Numbered: Word + Into<u128> + TryFrom<u128> {
    fn of(number: u128) -> Self {
        number.try_into().ok().unwrap()
    }
}
impl Numbered for u32 {}
impl Numbered for u64 {}

fn plain<W: Numbered>(weights: &[W]) -> Vec<u128> {
    weights.iter().map(|&weight| weight.into()).collect()
}

/// The first objection to what the first and the last word of each entry select.
fn objection<W: Numbered>(weights: &[W], index: impl Fn(W) -> Option<usize>) -> Option<String> {
    let plain = plain(weights);
    if plain.iter().all(|&weight| weight == 0) {
        let found = index(W::of(0));
        return found.map(|found| format!("{found} of zeros"));
    }
    let words = words_of(&plain, W::BITS);
    let ends = words.iter().enumerate().filter_map(|(entry, words)| {
        let words = words.as_ref()?;
        Some([(entry, *words.start()), (entry, *words.end())])
    });
    let mut wrong = ends.flatten().filter_map(|(entry, word)| {
        let found = index(W::of(word));
        (found != Some(entry)).then(|| format!("word {word:x}: {found:?} for {entry}"))
    });
    wrong.next()
}

/// What changes weights and selects.
trait Tree<W> {
    fn set(&mut self, index: usize, weight: W) -> W;
    fn index(&self, word: W) -> Option<usize>;
}

impl<W: Word> Tree<W> for SumTree<&mut [W]> {
    fn set(&mut self, index: usize, weight: W) -> W {
        SumTree::set(self, index, weight).unwrap()
    }
    fn index(&self, word: W) -> Option<usize> {
        SumTree::index(self, word)
    }
}

/// The same tree as textbooks write it, of other numbers or with another comparison.
struct Textbook<N> {
    weights: Vec<N>,
    sums: Vec<N>,
    number: fn(u32) -> N,
    point: fn(u32, N) -> N,
    passes: fn(&N, &N) -> bool,
}

impl<N: Copy + Default + PartialOrd + AddAssign + Sub<Output = N>> Textbook<N> {
    fn total(&self) -> N {
        let (mut total, mut at) = (N::default(), self.sums.len());
        while at > 0 {
            total += self.sums[at - 1];
            at &= at - 1;
        }
        total
    }
}

impl<N: Copy + Default + PartialOrd + AddAssign + Sub<Output = N>> Tree<u32> for Textbook<N> {
    fn set(&mut self, index: usize, weight: u32) -> u32 {
        let weight = (self.number)(weight);
        let difference = weight - self.weights[index];
        self.weights[index] = weight;
        let mut at = index + 1;
        while at <= self.sums.len() {
            self.sums[at - 1] += difference;
            at += 1 << at.trailing_zeros();
        }
        0
    }
    fn index(&self, word: u32) -> Option<usize> {
        let total = self.total();
        let mut point = (self.point)(word, total);
        let (mut at, mut step) = (0, 1 << self.sums.len().ilog2());
        while step > 0 {
            if at + step <= self.sums.len() && (self.passes)(&self.sums[at + step - 1], &point) {
                point = point - self.sums[at + step - 1];
                at += step;
            }
            step /= 2;
        }
        (total > N::default()).then_some(at)
    }
}

/// Zeros, small weights and large ones, of which any `n` fit a word together.
fn any<W: Numbered>(n: usize, rng: &mut Pcg32) -> W {
    let most = ((1_u128 << W::BITS) - 1) / n as u128;
    W::of(match rng.next_u32() % 4 {
        0 => 0,
        1 => most.min((1 + rng.next_u32() % 3).into()),
        2 => most,
        _ => (u128::from(rng.next_u32()) << 32 | u128::from(rng.next_u32())) % (most + 1),
    })
}

/// Changes the weights of a tree of zeros and of a plain array at random, and goes on to check the tree. The number of words, or
/// the first objection.
fn changed<W: Numbered>(
    tree: &mut impl Tree<W>,
    n: usize,
    changes: usize,
) -> Result<usize, String> {
    let mut rng = Pcg32::new(n as u64, 33);
    let mut weights = vec![W::of(0); n];
    for change in 0..changes {
        if let Some(objection) = objection(&weights, |word| tree.index(word)) {
            return Err(format!("{n} after {change}: {objection}"));
        }
        let index = rng.next_u32() as usize % n;
        weights[index] = any(n, &mut rng);
        tree.set(index, weights[index]);
    }
    Ok(2 * n * changes)
}

fn changed_tree<W: Numbered>(n: usize, changes: usize) -> Result<usize, String> {
    let mut memory = vec![W::of(0); n];
    changed(&mut SumTree::new_in(&mut memory[..]).unwrap(), n, changes)
}

fn whole(passes: fn(&i128, &i128) -> bool, n: usize) -> Textbook<i128> {
    Textbook {
        weights: vec![0; n],
        sums: vec![0; n],
        number: i128::from,
        point: |word, total| (i128::from(word) * total) >> 32,
        passes,
    }
}

#[test]
fn through_any_changes_each_entry_has_the_words_of_whole_numbers() {
    let changes = speed::of("changes of a tree", 60, 1000);
    let mut words = 0;
    for n in (1..40).chain([63, 64, 65, 100, 255, 257, 1000]) {
        words += changed_tree::<u32>(n, changes).unwrap();
        words += changed_tree::<u64>(n, changes).unwrap();
        words += changed(&mut whole(|sum, left| sum <= left, n), n, changes).unwrap();
    }
    println!("{words} words");
    // The control stops a descent where the point is at a border.
    let early = changed(&mut whole(|sum, left| sum < left, 64), 64, changes);
    println!("{}", early.unwrap_err());
    // This one keeps sums of floats.
    let mut floats = Textbook {
        weights: vec![0.0; 64],
        sums: vec![0.0; 64],
        number: |weight| weight as f32,
        point: |word, total| word as f32 / 4_294_967_296.0 * total,
        passes: |sum: &f32, left: &f32| sum <= left,
    };
    println!("{}", changed(&mut floats, 64, changes).unwrap_err());
    floats.sums.fill(0.0);
    floats.weights.fill(0.0);
    for (index, weight) in [(0, 3), (1, 1 << 25), (1, 0), (0, 0)] {
        floats.set(index, weight);
    }
    let residue = objection(&[0_u32; 64], |word| floats.index(word));
    println!("sums of floats leave {}", residue.unwrap());
}

/// All words of all trees of up to five weights with small sums, as runs.
#[test]
fn all_words_of_small_sums_are_counted() {
    let largest = speed::of("largest sum", 5, 8_u32);
    let mut trees = 0;
    for n in 1..=5_usize {
        for code in 0..(largest + 1).pow(n as u32) {
            let weights: Vec<u32> = (0..n as u32)
                .map(|i| code / (largest + 1).pow(i) % (largest + 1))
                .collect();
            let total: u32 = weights.iter().sum();
            if total == 0 || total > largest {
                continue;
            }
            let words = words_of(&plain(&weights), 32);
            let due: Vec<u128> = words
                .iter()
                .map(|words| words.as_ref().map_or(0, |w| w.end() - w.start() + 1))
                .collect();
            let tree = SumTree::new_in(weights.clone()).unwrap();
            let index = |word: u64| tree.index(word as u32).unwrap();
            assert_eq!(counts(n, u32::MAX.into(), index), due, "{weights:?}");
            let stated: Vec<u128> = (0..n).map(|i| tree.numerator(i).into()).collect();
            assert_eq!(stated, due, "{weights:?}");
            trees += 1;
        }
    }
    println!("{trees} trees");
}

/// Draws in whole numbers and floats are those of the searched table of the same weights.
#[test]
fn the_same_bits_select_as_in_a_cdf() {
    let mut rng = Pcg32::new(5, 33);
    for n in [1, 2, 3, 7, 64, 300] {
        for _ in 0..speed::of("trees beside a Cdf", 20, 500) {
            let mut weights: Vec<u32> = (0..n).map(|_| any(n, &mut rng)).collect();
            weights[rng.next_u32() as usize % n] |= 1;
            let cdf = Cdf::<Vec<u32>>::from_integer_slice(&weights).unwrap();
            let tree = SumTree::new_in(weights).unwrap();
            for word in [0, u32::MAX, rng.next_u32(), rng.next_u32()] {
                assert_eq!(tree.select(word), Some(cdf.select(word)));
                assert_eq!(tree.select_exact(word), Some(cdf.select_exact(word)));
                let u = word as f32 / 4_294_967_296.0;
                assert_eq!(tree.select_uniform(u), Some(cdf.select_uniform(u)));
                assert_eq!(
                    tree.draw_exact(&mut Given(&[word])),
                    Some(cdf.select_exact(word))
                );
            }
            for index in 0..=n {
                assert_eq!(tree.numerator(index), cdf.numerator(index));
                assert_eq!(tree.pmf(index), cdf.pmf(index));
            }
        }
    }
}

#[test]
fn words_of_64_bits_are_counted_too() {
    let mut rng = Pcg32::new(6, 33);
    for n in [1, 2, 5, 33] {
        let mut weights: Vec<u64> = (0..n).map(|_| any(n, &mut rng)).collect();
        weights[0] |= 1;
        let words = words_of(&plain(&weights), 64);
        let tree = SumTree::new_in(weights).unwrap();
        for (index, words) in words.iter().enumerate() {
            let due = words.as_ref().map_or(0, |w| w.end() - w.start() + 1);
            assert_eq!(tree.numerator(index), due);
            let Some(words) = words else { continue };
            let last = tree.select_exact_word(*words.end() as u64).unwrap();
            assert_eq!((last.index, last.numerator), (index, due));
            assert!(due < 1 << 32 || last.leftover == u32::MAX);
            let first = tree.select_word(*words.start() as u64).unwrap();
            assert_eq!((first.index, first.leftover), (index, 0.0));
        }
        let sum: u128 = (0..n).map(|index| tree.numerator(index)).sum();
        assert_eq!(sum, 1 << 64);
        let mut source = Counting::new(Pcg32::new(1, 1));
        assert!(tree.draw(&mut source).is_some());
        assert_eq!(source.words, 2);
    }
}

#[test]
fn weights_come_back() {
    let mut rng = Pcg32::new(7, 33);
    for n in (1..70).chain([127, 128, 129, 1000]) {
        let mut weights: Vec<u64> = (0..n).map(|_| any(n, &mut rng)).collect();
        let mut tree = SumTree::new_in(weights.clone()).unwrap();
        for _ in 0..10 {
            let (index, weight) = (rng.next_u32() as usize % n, any(n, &mut rng));
            assert_eq!(tree.set(index, weight), Ok(weights[index]));
            weights[index] = weight;
            assert_eq!(tree.total(), weights.iter().sum::<u64>());
            assert!((0..n).all(|i| tree.get(i) == Some(weights[i])));
        }
        assert_eq!((tree.get(n), tree.entries()), (None, n));
        let again = SumTree::from_trusted_sums(tree.as_sums().to_vec());
        assert_eq!(again.as_ref(), Ok(&tree));
        assert_eq!(tree.into_weights(), weights);
    }
    let in_a_vec = heapless::Vec::<u32, 8>::from_slice(&[1, 2, 3]).unwrap();
    let tree = SumTree::new_in(in_a_vec.clone()).unwrap();
    assert_eq!((tree.total(), tree.into_weights()), (6, in_a_vec));
    let mut array = [4_u32, 0, 9];
    assert_eq!(SumTree::new_in(&mut array).unwrap().pmf(1), 0.0);
}

#[test]
fn what_does_not_fit_is_refused_and_changes_nothing() {
    assert_eq!(SumTree::new([]), Err(Error::NoWeights));
    assert_eq!(
        SumTree::from_trusted_sums([0_u32; 0]),
        Err(Error::NoWeights)
    );
    assert_eq!(
        SumTree::new_in(vec![0_u32; MAX_ENTRIES + 1]),
        Err(Error::TooManyWeights)
    );
    let mut weights = [1_u32 << 31, 7, 1 << 31];
    assert_eq!(SumTree::new_in(&mut weights[..]), Err(Error::TooLarge(0)));
    assert_eq!(weights, [1 << 31, 7, 1 << 31]);
    assert_eq!(SumTree::new_u64([u64::MAX, 1]), Err(Error::TooLarge(0)));
    let mut tree = SumTree::new([u32::MAX - 5, 2, 0]).unwrap();
    let before = tree;
    assert_eq!(tree.set(2, 4), Err(Error::TooLarge(1)));
    assert_eq!(tree.set(3, 0), Err(Error::OutOfRange(0)));
    assert_eq!(tree.set(usize::MAX, 0), Err(Error::OutOfRange(0)));
    assert_eq!(tree, before);
    assert_eq!(tree.set(2, 3), Ok(0));
    assert_eq!(tree.total(), u32::MAX);
    assert_eq!(tree.index(u32::MAX), Some(2));
    // Of zeros nothing is selected, and the word is drawn all the same.
    let mut zeros = SumTree::new([0; 5]).unwrap();
    let mut rng = Counting::new(Pcg32::new(1, 1));
    assert_eq!(zeros.draw(&mut rng), None);
    assert_eq!(zeros.draw_exact(&mut rng), None);
    assert_eq!(zeros.draw_index(&mut rng), None);
    assert_eq!((zeros.numerator(0), zeros.pmf(0), rng.words), (0, 0.0, 3));
    assert_eq!(zeros.set(4, 1), Ok(0));
    assert_eq!((zeros.numerator(4), zeros.index(0)), (1 << 32, Some(4)));
}

/// Words no tree has give no panic, and an entry or the end.
#[test]
fn sums_of_no_tree_are_survived() {
    let mut rng = Pcg32::new(8, 33);
    for n in 1..50 {
        let sums: Vec<u32> = (0..n)
            .map(|_| rng.next_u32() >> (rng.next_u32() & 31))
            .collect();
        let mut tree = SumTree::from_trusted_sums(sums).unwrap();
        for _ in 0..20 {
            assert!(tree.draw_index(&mut rng).is_none_or(|index| index <= n));
            let chosen = tree.draw(&mut rng);
            assert!(
                chosen.is_none_or(
                    |c| (0.0..=1.0).contains(&c.pmf) && (0.0..1.0).contains(&c.leftover)
                )
            );
            let _ = tree.set(rng.next_u32() as usize % n, rng.next_u32());
            tree.draw_distinct(&mut [(0, 0); 3], &mut rng);
        }
    }
}

/// All pairs of points, one of the total and one of what is left, stand for all words.
#[test]
fn distinct_entries_follow_what_is_left() {
    let weights = [3, 0, 1, 4, 2_u32];
    let total: u32 = weights.iter().sum();
    let word = |point: u32, of: u32| ((u64::from(point) << 32).div_ceil(of.into())) as u32;
    let mut pairs = [[0; 5]; 5];
    let mut tree = SumTree::new(weights).unwrap();
    for point in 0..total {
        let mut one = [(9, 9)];
        let first = word(point, total);
        tree.draw_distinct(&mut one, &mut Given(&[first]));
        let left = total - one[0].1;
        for next in 0..left {
            let mut two = [(9, 9); 2];
            let drawn = tree.draw_distinct(&mut two, &mut Given(&[first, word(next, left)]));
            let [(a, weight), (b, _)] = drawn else {
                panic!("{drawn:?}")
            };
            assert_eq!((one[0].0, weights[one[0].0]), (*a, *weight));
            pairs[*a][*b] += 1;
        }
    }
    // Each of the pairs of points has the same chance, given the first.
    for (a, row) in pairs.iter().enumerate() {
        for (b, &count) in row.iter().enumerate() {
            let due = if a == b { 0 } else { weights[a] * weights[b] };
            assert_eq!(count, due, "{a} {b}");
        }
    }
}

#[test]
fn distinct_draws_take_a_word_a_place_and_restore_the_weights() {
    let mut tree = SumTree::new([3, 0, 1, 4, 2]).unwrap();
    let before = tree;
    for k in 0..8 {
        let mut chosen = vec![(9, 9); k];
        let mut rng = Counting::new(Pcg32::new(k as u64, 1));
        let drawn = tree.draw_distinct(&mut chosen, &mut rng).to_vec();
        assert_eq!((drawn.len(), rng.words), (k.min(4), k as u64));
        let mut entries: Vec<usize> = drawn.iter().map(|&(index, _)| index).collect();
        entries.sort_unstable();
        entries.dedup();
        assert_eq!(entries.len(), drawn.len());
        assert!(
            drawn
                .iter()
                .all(|&(i, w)| before.get(i) == Some(w) && w > 0)
        );
        assert_eq!(tree, before);
    }
    let mut rng = Failing { word: 7, left: 2 };
    let mut chosen = [(0, 0); 3];
    let failed = tree.try_draw_distinct(&mut chosen, &mut rng);
    assert!(matches!(failed, Err(Broken(_))));
    assert_eq!(tree, before);
}
