//! How many words a mutation takes, and a step with it. A failure at any word passes through and leaves the chain as it was.

use super::own::{Bits, Weighed, given};
use host::generators::{Broken, Counting, Failing};
use microwarp::discrete::{Alias, AliasEntry, Cdf};
use microwarp::metropolis::{
    BoxStep, Chain, Independence, LogUniformStep, Mixture, Mutation, NormalStep, OneCoordinate,
    Product, Subset, Symmetric, TransitionTable, UniformIndex, UniformStep, WrappedWalk,
};
use microwarp::poly as mw;
use microwarp::rejection::Failure;
use microwarp::tier::{Libm, Poly};
use rand_pcg::Pcg32;

/// Takes exactly so many words of any generator, and hands on its error at each of them.
fn takes<X, M>(name: &str, mutation: &M, from: X, words: u64)
where
    X: Copy + std::fmt::Debug + PartialEq,
    M: Mutation<X>,
    M::Correction: PartialEq + std::fmt::Debug,
{
    for seed in 0..100 {
        let mut rng = Counting::new(Pcg32::new(seed, 1));
        let Ok(_) = mutation.try_propose(from, &mut rng);
        assert_eq!(rng.words, words, "{name}");
    }
    // Above the words of the last of a mixture's mutations too.
    for word in [0, 0x3000_0000, 0x9000_0000, u32::MAX] {
        for left in 0..words {
            let failed = mutation.try_propose(from, &mut Failing { word, left });
            assert_eq!(failed.err(), Some(Broken(17)), "{name} at word {left}");
        }
        let mut enough = Failing { word, left: words };
        assert!(mutation.try_propose(from, &mut enough).is_ok(), "{name}");
        assert_eq!(enough.left, 0, "{name}");
    }
}

#[test]
fn every_mutation_takes_the_words_stated() {
    let point = [0.5_f32; 3];
    takes("UniformStep", &UniformStep::new(), point, 3);
    takes("UniformStep", &UniformStep::new(), 0.5_f32, 1);
    takes("UniformStep", &UniformStep::new(), [0.5_f32; 0], 0);
    takes("UniformIndex", &UniformIndex::new(6).unwrap(), 0, 2);
    let boxed = BoxStep::new([0.1; 3]).unwrap();
    takes("BoxStep", &boxed, point, 3);
    takes("BoxStep", &BoxStep::new([0.1, 0.0]).unwrap(), [0.0; 2], 2);
    takes("BoxStep", &BoxStep::new(0.1).unwrap(), 0.0, 1);
    let normal = NormalStep::<_, Libm>::new([1.0; 3]).unwrap();
    takes("NormalStep", &normal, point, 3);
    let exponential = LogUniformStep::<Poly>::new(0.01, 1.0).unwrap();
    takes("LogUniformStep", &exponential, point, 3);
    takes("LogUniformStep", &exponential, 0.5_f32, 1);
    takes("WrappedWalk", &WrappedWalk::new(boxed), point, 3);
    // Where a step would leave the range of f32, they are taken all the same.
    let most = BoxStep::new([f32::MAX; 3]).unwrap();
    takes("BoxStep", &most, [f32::MAX; 3], 3);
    takes("BoxStep", &boxed, [f32::NAN; 3], 3);

    let pair = Independence::new(mw::NormalPair::new([0.0; 2], 1.0).unwrap());
    takes("Independence", &pair, [0.0; 2], 2);
    let table = Cdf::<[u32; 2]>::new(&[1.0, 3.0]).unwrap();
    takes("Independence", &Independence::new(table), 0, 1);
    let long = Alias::<[AliasEntry<u64>; 2]>::new_u64(&[1.0, 3.0]).unwrap();
    takes("Independence", &Independence::new(long), 0, 2);
    let rows = TransitionTable::new([table; 2]).unwrap();
    takes("TransitionTable", &rows, 1, 1);
    takes("TransitionTable", &rows, 9, 1);
    let wide = Cdf::<[u64; 2]>::new_u64(&[1.0, 3.0]).unwrap();
    takes("Independence", &Independence::new(wide), 0, 2);
    let rows = TransitionTable::new([wide; 2]).unwrap();
    takes("TransitionTable", &rows, 1, 2);

    let two = Subset::<_, 2, 3>::new(UniformStep::new(), [2, 0]).unwrap();
    takes("Subset", &two, point, 2);
    let one = OneCoordinate::new(exponential);
    takes("OneCoordinate", &one, point, 2);
    takes("OneCoordinate", &one, [0.5; 0], 2);
    takes(
        "OneCoordinate",
        &OneCoordinate::new(given(0.5, Symmetric)),
        point,
        1,
    );
    let product = Product::new((two, UniformIndex::new(6).unwrap()));
    takes("Product", &product, (point, 0), 4);
    let mixture = Mixture::new((boxed, UniformStep::new()), &[1.0, 1.0]).unwrap();
    takes("Mixture", &mixture, point, 4);
    let outer = Mixture::new([mixture; 3], &[1.0; 3]).unwrap();
    takes("Mixture of mixtures", &outer, point, 5);
    takes("Mixture by reference", &&outer, point, 5);
    let large_small = Mixture::large_small(0.5, WrappedWalk::new(boxed)).unwrap();
    takes("LargeSmall", &large_small, point, 4);
    let line = OneCoordinate::new(large_small_line());
    takes("OneCoordinate of a mixture", &line, point, 3);
}

fn large_small_line() -> impl Mutation<f32, Correction = Symmetric> {
    Mixture::large_small(0.5, WrappedWalk::new(BoxStep::new(0.1).unwrap())).unwrap()
}

/// Where the parts take different numbers of words, so does the mixture.
#[test]
fn a_mixture_takes_the_words_of_the_part_picked() {
    let one = OneCoordinate::new(BoxStep::new(0.1).unwrap());
    let mixture = Mixture::new((UniformStep::new(), one), &[1.0, 1.0]).unwrap();
    for (word, words) in [(0, 65), (u32::MAX, 3)] {
        let mut rng = Failing { word, left: 100 };
        assert!(mixture.try_propose([0.5; 64], &mut rng).is_ok());
        assert_eq!(100 - rng.left, words);
    }
}

/// A step takes the words of its mutation and one that decides, whatever comes of the proposal. Where the generator fails at any
/// of them, the chain is as it was, to the last bit, and goes on from there.
fn words<X, M>(name: &str, start: X, mutation: &M, stated: impl Fn(u32) -> u64)
where
    X: Copy + Bits,
    M: Mutation<X>,
{
    words_of(
        [1.0, 1.0, 2e-3, 0.0, f32::NAN],
        name,
        start,
        mutation,
        &stated,
    );
    words_of([500, 500, 1, 0], name, start, mutation, &stated);
}

/// With targets that have the first weight at the start, and another one elsewhere.
fn words_of<W, X, M, const N: usize>(
    weights: [W; N],
    name: &str,
    start: X,
    mutation: &M,
    stated: &impl Fn(u32) -> u64,
) where
    W: Weighed,
    X: Copy + Bits,
    M: Mutation<X>,
{
    let mut outcomes = [0_u32; 4];
    for (seed, weight) in weights.into_iter().skip(1).enumerate() {
        let target = |x: X| match x.bits() == start.bits() {
            true => weights[0],
            false => weight,
        };
        let mut chain = Chain::new(start, target).unwrap();
        let mut rng = Pcg32::new(seed as u64, 1);
        for _ in 0..50 {
            let mut counted = Counting::new(rng.clone());
            let before = chain;
            let step = chain.step(target, mutation, &mut counted);
            assert_eq!(counted.words, stated(step.kind) + 1, "{name}");
            outcomes[step.outcome as usize] += 1;
            rng = counted.inner;
            // The same step, with a generator that fails at one word after the other.
            for left in 0..counted.words {
                let mut cut = before;
                let mut failing = Failing { word: 0, left };
                let end = cut.try_step(target, mutation, &mut failing);
                // A mixture may take fewer words with this one.
                if let Err(error) = end {
                    assert_eq!(error, Broken(17));
                    assert_eq!(cut.save().bits(), before.save().bits(), "{name}");
                } else {
                    assert!(name.contains("Mixture"), "{name}");
                }
            }
            let mut failing = Failing { word: 0, left: 99 };
            let mut cut = before;
            let whole = cut.try_step(target, mutation, &mut failing).unwrap();
            assert_eq!(99 - failing.left, stated(whole.kind) + 1, "{name}");
        }
    }
    println!("{name}: {} words, outcomes {outcomes:?}", stated(0) + 1);
    assert!(outcomes[0] > 0, "{name}");
}

#[test]
fn a_step_takes_a_word_more_and_a_failed_one_leaves_no_trace() {
    let weights = [1.0, 2.0, 3.0, 4.0];
    words("UniformIndex", 0, &UniformIndex::new(4).unwrap(), |_| 2);
    // A state that the table does not have.
    let cdf = Cdf::<[u32; 4]>::new(&weights).unwrap();
    let rows = TransitionTable::new([cdf; 4]).unwrap();
    words("TransitionTable", 9, &rows, |_| 1);
    let of_box = WrappedWalk::new(BoxStep::new([0.1, 0.0, 0.3]).unwrap());
    words("WrappedWalk", [-0.0_f32, 1e-40, 0.5], &of_box, |_| 3);
    let normal = mw::NormalStep::new([0.1; 2]).unwrap();
    let subset = Subset::<_, 2, 4>::new(normal, [3, 1]).unwrap();
    words("Subset", [f32::NAN, 0.5, -0.0, 1.0], &subset, |_| 2);
    let one = OneCoordinate::new(BoxStep::new(0.1).unwrap());
    let mixture = Mixture::new((UniformStep::new(), one, subset), &[0.2, 0.3, 0.5]).unwrap();
    words("Mixture", [0.5_f32; 4], &mixture, |kind| {
        [5, 3, 3][kind as usize]
    });
}

#[test]
fn starts_take_the_words_they_say() {
    let mut rng = Counting::new(Pcg32::new(3, 3));
    let flat = |_: [f32; 3]| 1.0;
    Chain::try_resample(flat, &UniformStep::new(), 10, &mut rng).unwrap();
    assert_eq!(rng.words, 10 * (3 + 1));
    Chain::try_search(flat, &UniformStep::new(), 10, &mut rng).unwrap();
    assert_eq!(rng.words, 40 + 3);
    // Whatever the densities are.
    let none = |x: f32| if x < 0.9 { f32::NAN } else { x };
    let normal = mw::Normal::new(0.0, 1.0).unwrap();
    rng.words = 0;
    let _ = Chain::try_resample(none, &normal, 100, &mut rng);
    assert_eq!(rng.words, 100 * (1 + 1));
}

#[test]
fn failing_generators_pass_through() {
    for left in 0..8 {
        let mut rng = Failing { word: 7, left };
        let found = Chain::try_resample(|_: f32| 1.0, &UniformStep::new(), 4, &mut rng);
        assert_eq!(found, Err(Failure::Generator(Broken(17))), "{left}");
        let mut rng = Failing { word: 7, left };
        let found = Chain::try_search(|_: f32| 0.0, &UniformStep::new(), 9, &mut rng);
        assert_eq!(found, Err(Failure::Generator(Broken(17))), "{left}");
    }
    let mut rng = Failing { word: 7, left: 8 };
    assert!(Chain::try_resample(|_: f32| 1.0, &UniformStep::new(), 4, &mut rng).is_ok());
}
