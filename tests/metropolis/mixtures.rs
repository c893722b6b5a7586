//! Mixtures: each mutation by exactly the words of its table, with its own ratio and its index as the kind.

use crate::own::given;
use host::generators::Cycle;
use microwarp::discrete::{Alias, AliasEntry, Cdf};
use microwarp::metropolis::{
    BoxStep, HastingsCorrection, HastingsCounts, HastingsRatio, Independence, LargeSmall, Mixture,
    Mutation, Symmetric, TransitionTable, UniformIndex, UniformStep, WrappedWalk,
};
use microwarp::poly as mw;
use microwarp::{Error, constant};
use rand_core::Rng;
use rand_pcg::Pcg32;

/// Proposes always one number.
fn to(state: f32) -> impl Mutation<f32, Correction = Symmetric> + Copy {
    given(state, Symmetric)
}

/// The same, and states a ratio of it.
fn uneven(state: f32) -> impl Mutation<f32, Correction = HastingsRatio> + Copy {
    given(state, HastingsRatio::new(1.0, state))
}

/// Whether a mixture picks by the words that its table says, of which the weights are a fair reading.
fn picks_by_its_table<M, const N: usize>(mixture: &Mixture<M, N>, weights: &[f32; N])
where
    Mixture<M, N>: Mutation<f32>,
{
    let total: f64 = weights.iter().map(|&w| f64::from(w)).sum();
    let mut words = 0;
    for (index, &weight) in weights.iter().enumerate() {
        let Some(range) = mixture.table().words_of(index) else {
            assert_eq!(weight, 0.0);
            continue;
        };
        let count = u64::from(range.end() - range.start()) + 1;
        let share = f64::from(weight) / total * 2f64.powi(32);
        assert!((count as f64 - share).abs() <= 1.0 && weight > 0.0);
        words += count;
        let inside = range.start() + (range.end() - range.start()) / 3;
        for word in [*range.start(), inside, *range.end()] {
            let Ok(proposal) = mixture.try_propose(0.0, &mut Cycle::new(&[word]));
            assert_eq!(proposal.kind as usize, index);
            assert_eq!(proposal.state, index as f32 + 1.0);
        }
    }
    assert_eq!(words, 1 << 32);
}

#[test]
fn a_mixture_picks_by_the_words_of_its_table() {
    let weights = [0.5, 0.0, 3.0, 1e-6, 0.0, 0.1, 7.0, 0.0];
    let numbers = [1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0];
    let [a, b, c, d, e, f, g, h] = numbers.map(to);
    let odd = numbers.map(uneven);
    let array = Mixture::new([a, b, c, d, e, f, g, h], &weights).unwrap();
    picks_by_its_table(&array, &weights);
    macro_rules! tuples {
        ($($count:literal: $($part:expr => $index:literal),+;)*) => {$(
            let first: [f32; $count] = std::array::from_fn(|i| weights[i]);
            let tuple = Mixture::new(($($part,)+), &first).unwrap();
            picks_by_its_table(&tuple, &first);
            // One asymmetric part changes nothing of the picking.
            let asymmetric = Mixture::new(($(odd[$index],)+), &first).unwrap();
            picks_by_its_table(&asymmetric, &first);
        )*};
    }
    tuples! {
        1: a => 0;
        2: a => 0, b => 1;
        3: a => 0, b => 1, c => 2;
        4: a => 0, b => 1, c => 2, d => 3;
        5: a => 0, b => 1, c => 2, d => 3, e => 4;
        6: a => 0, b => 1, c => 2, d => 3, e => 4, f => 5;
        7: a => 0, b => 1, c => 2, d => 3, e => 4, f => 5, g => 6;
        8: a => 0, b => 1, c => 2, d => 3, e => 4, f => 5, g => 6, h => 7;
    }
    // A table of one's own, built by the compiler.
    const TABLE: Cdf<[u32; 2]> = constant!(Cdf::<[u32; 2]>::new(&[1.0, 2.0]));
    picks_by_its_table(&Mixture::from_table((a, b), TABLE), &[1.0, 2.0]);
    let borrowed = (&a, &b);
    picks_by_its_table(&Mixture::from_table(borrowed, TABLE), &[1.0, 2.0]);
}

#[test]
fn a_mutation_of_weight_0_is_never_picked() {
    let mixture = Mixture::new([1.0, 2.0, 3.0].map(to), &[1.0, 0.0, 1e-9]).unwrap();
    let mut rng = Pcg32::new(0x3377, 54);
    let mut kinds = [0; 3];
    for word in [0, 1, u32::MAX, 1 << 31]
        .into_iter()
        .chain((0..1 << 20).map(|_| rng.next_u32()))
    {
        let Ok(proposal) = mixture.try_propose(0.0, &mut Cycle::new(&[word]));
        kinds[proposal.kind as usize] += 1;
    }
    assert_eq!(kinds[1], 0);
    assert!(kinds[2] > 0, "the word of the last is among those tried");
}

#[test]
fn the_weights_of_a_mixture_are_those_of_a_table() {
    let new = |weights: [f32; 3]| Mixture::new([to(1.0); 3], &weights).err();
    assert_eq!(new([0.0; 3]), Some(Error::AllZero));
    assert_eq!(new([1.0, -1.0, 1.0]), Some(Error::NegativeWeight(1)));
    assert_eq!(new([1.0, 1.0, f32::NAN]), Some(Error::NotFiniteWeight(2)));
    assert_eq!(new([0.0, 1e-30, 0.0]), None);
    let nothing = [0.0; 0].map(to);
    assert_eq!(Mixture::new(nothing, &[]).err(), Some(Error::NoWeights));
}

/// Compiles only for a mutation whose correction is this one.
fn states<C: HastingsCorrection, X, M: Mutation<X, Correction = C>>(_: &M) {}

#[test]
fn a_mixture_is_symmetric_where_all_its_parts_are() {
    let (even, odd) = (to(1.0), uneven(2.0));
    states::<Symmetric, f32, _>(&Mixture::new((even,), &[1.0]).unwrap());
    states::<Symmetric, f32, _>(&Mixture::new((even, even), &[1.0; 2]).unwrap());
    states::<Symmetric, f32, _>(&Mixture::new((even, even, even), &[1.0; 3]).unwrap());
    states::<Symmetric, f32, _>(&Mixture::new([even; 5], &[1.0; 5]).unwrap());
    states::<HastingsRatio, f32, _>(&Mixture::new((odd,), &[1.0]).unwrap());
    states::<HastingsRatio, f32, _>(&Mixture::new((odd, even), &[1.0; 2]).unwrap());
    states::<HastingsRatio, f32, _>(&Mixture::new((even, odd), &[1.0; 2]).unwrap());
    states::<HastingsRatio, f32, _>(&Mixture::new((even, odd, even), &[1.0; 3]).unwrap());
    states::<HastingsRatio, f32, _>(&Mixture::new([odd; 5], &[1.0; 5]).unwrap());
    let eight = (even, even, even, even, even, even, even, even);
    states::<Symmetric, f32, _>(&Mixture::new(eight, &[1.0; 8]).unwrap());
    let last_odd = (even, even, even, even, even, even, even, odd);
    states::<HastingsRatio, f32, _>(&Mixture::new(last_odd, &[1.0; 8]).unwrap());
    let wrapped = WrappedWalk::new(BoxStep::new([0.1; 2]).unwrap());
    let large_small = Mixture::large_small(0.5, wrapped).unwrap();
    states::<Symmetric, [f32; 2], _>(&large_small);
    let with_source = (wrapped, Independence::new(UniformStep::new()));
    states::<HastingsRatio, [f32; 2], _>(&Mixture::new(with_source, &[1.0; 2]).unwrap());
    states::<HastingsRatio, [f32; 2], _>(&Independence::new(mw::Disk::new()));
    states::<HastingsRatio, f32, _>(&Independence::new(UniformStep::new()));
    // Of indices it states counts, but for those beside a ratio.
    type Counts = HastingsCounts;
    let row = Cdf::<[u32; 2]>::from_integers(&[1, 2]).unwrap();
    let bins = Alias::<[AliasEntry<u64>; 2]>::from_integers_u64(&[1, 2]).unwrap();
    let (cdf, alias) = (Independence::new(row), Independence::new(bins));
    let (rows, index) = (
        TransitionTable::new([row; 2]).unwrap(),
        UniformIndex::new(2).unwrap(),
    );
    states::<Counts, usize, _>(&Independence::new(index));
    states::<Symmetric, usize, _>(&Mixture::from_table((index, index), row));
    states::<Counts, usize, _>(&Mixture::from_table((index, cdf), row));
    states::<Counts, usize, _>(&Mixture::from_table((alias, index), row));
    states::<Counts, usize, _>(&Mixture::from_table((rows, alias), row));
    let ratio = given(1, HastingsRatio::ONE);
    states::<HastingsRatio, usize, _>(&Mixture::from_table((&ratio, cdf), row));
    states::<HastingsRatio, usize, _>(&Mixture::from_table((cdf, &ratio), row));
    states::<HastingsRatio, usize, _>(&Mixture::from_table((index, &ratio), row));
}

#[test]
fn the_ratio_is_that_of_the_part_picked() {
    let mixture = Mixture::new((to(1.0), uneven(2.0), uneven(3.0)), &[1.0, 1.0, 2.0]).unwrap();
    let ratio_of = |word| {
        let Ok(proposal) = mixture.try_propose(0.0, &mut Cycle::new(&[word]));
        proposal.correction
    };
    assert_eq!(ratio_of(0), HastingsRatio::ONE);
    assert_eq!(ratio_of(1 << 30), HastingsRatio::new(1.0, 2.0));
    assert_eq!(ratio_of(1 << 31), HastingsRatio::new(1.0, 3.0));
    // Within a mixture of mixtures the kind is the outer one's, the ratio the innermost one's.
    let outer = Mixture::new((to(9.0), mixture), &[1.0, 1.0]).unwrap();
    let Ok(proposal) = outer.try_propose(0.0, &mut Cycle::new(&[1 << 31, 1 << 30]));
    assert_eq!((proposal.state, proposal.kind), (2.0, 1));
    assert_eq!(proposal.correction, HastingsRatio::new(1.0, 2.0));
}

#[test]
fn large_steps_have_the_probability_asked_for() {
    type Steps = LargeSmall<WrappedWalk<mw::LogUniformStep>>;
    let small = WrappedWalk::new(mw::LogUniformStep::new(0.001, 0.1).unwrap());
    let new = |probability| Steps::large_small(probability, small);
    for bad in [
        f32::NAN,
        -1e-45,
        -1.0,
        1.0_f32.next_up(),
        2.0,
        f32::INFINITY,
    ] {
        assert_eq!(new(bad).err(), Some(Error::OutOfRange(0)), "{bad}");
    }
    let least = 2f32.powi(-33);
    for bad in [1e-45, 1e-20, least.next_down()] {
        assert_eq!(new(bad).err(), Some(Error::Unreachable(0)), "{bad:e}");
    }
    let mut rng = Pcg32::new(0x1a26e, 54);
    let mut probabilities = vec![0.0, -0.0, least, 2.0 * least, 3.0 * least, 5.0 * least];
    probabilities.extend([1e-6, 0.1, 0.3, 0.5, 1.0_f32.next_down(), 1.0]);
    probabilities.extend((0..1000).map(|_| rng.next_u32() as f32 * 2f32.powi(-32)));
    for probability in probabilities {
        let steps = new(probability).unwrap();
        // To the nearest word, halves up, in f64, where all of it is exact.
        let words = (f64::from(probability) * 2f64.powi(32) + 0.5).floor() as u64;
        let large = steps
            .table()
            .words_of(0)
            .map_or(0, |w| u64::from(w.end() - w.start()) + 1);
        assert_eq!(large, words, "{probability:e}");
        assert_eq!(steps.table().words_of(1).is_none(), words == 1 << 32);
        assert!(
            Cdf::from_words([steps.table().as_words()[0], steps.table().as_words()[1]]).is_ok()
        );
        for (word, kind) in [
            (0, u32::from(words == 0)),
            (u32::MAX, u32::from(words < 1 << 32)),
        ] {
            let Ok(proposal) = steps.try_propose([0.5; 2], &mut Cycle::new(&[word]));
            assert_eq!(proposal.kind, kind, "{probability:e}");
        }
    }
}
