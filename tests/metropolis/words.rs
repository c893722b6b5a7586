//! Words: how many a step takes, and what is left of one that fails for want of them.

use super::weighed::{Bits, Weighed};
use host::generators::{Broken, Counting, Failing};
use microwarp::discrete::{Alias, AliasEntry, Cdf};
use microwarp::metropolis::{
    BoxStep, Chain, Independence, Mixture, Mutation, OneCoordinate, Subset, TransitionTable,
    UniformIndex, UniformStep, WrappedWalk,
};
use microwarp::poly as mw;
use rand_pcg::Pcg32;

/// A mutation takes the words that the documentation says, and one decides, whatever comes of the proposal;
/// where the generator fails at any of them, the chain is as it was, to the last bit, and goes on from there.
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
            let step = W::step(&mut chain, target, mutation, None, &mut counted);
            assert_eq!(counted.words, stated(step.kind) + 1, "{name}");
            outcomes[step.outcome as usize] += 1;
            rng = counted.inner;
            // The same step, with a generator that fails at one word after the other.
            for left in 0..counted.words {
                let mut cut = before;
                let mut failing = Failing { word: 0, left };
                let end = W::try_step(&mut cut, target, mutation, None, &mut failing);
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
            let whole = W::try_step(&mut cut, target, mutation, None, &mut failing).unwrap();
            assert_eq!(99 - failing.left, stated(whole.kind) + 1, "{name}");
        }
    }
    println!("{name}: {} words, outcomes {outcomes:?}", stated(0) + 1);
    assert!(outcomes[0] > 0, "{name}");
}

#[test]
fn steps_take_the_words_stated_and_failed_ones_leave_no_trace() {
    let weights = [1.0, 2.0, 3.0, 4.0];
    let cdf = Cdf::<[u32; 4]>::new(&weights).unwrap();
    let wide = Cdf::<[u64; 4]>::new_u64(&weights).unwrap();
    let alias = Alias::<[AliasEntry<u32>; 4]>::new(&weights).unwrap();
    let wide_alias = Alias::<[AliasEntry<u64>; 4]>::new_u64(&weights).unwrap();
    words("UniformIndex", 0, &UniformIndex::new(4).unwrap(), |_| 2);
    words("Independence(Cdf)", 0, &Independence::new(cdf), |_| 1);
    words("Independence(Cdf u64)", 0, &Independence::new(wide), |_| 2);
    words("Independence(Alias)", 0, &Independence::new(alias), |_| 1);
    words(
        "Independence(Alias u64)",
        0,
        &Independence::new(wide_alias),
        |_| 2,
    );
    words(
        "TransitionTable",
        0,
        &TransitionTable::new([cdf; 4]).unwrap(),
        |_| 1,
    );
    words(
        "TransitionTable u64",
        0,
        &TransitionTable::new([wide; 4]).unwrap(),
        |_| 2,
    );
    // A state that the table does not have.
    words(
        "TransitionTable",
        9,
        &TransitionTable::new([cdf; 4]).unwrap(),
        |_| 1,
    );
    words(
        "Independence(Disk)",
        [0.5, 0.25],
        &Independence::new(mw::Disk::new()),
        |_| 2,
    );
    words("UniformStep", [0.5_f32; 5], &UniformStep::new(), |_| 5);
    words("UniformStep", 0.5_f32, &UniformStep::new(), |_| 1);
    let of_box = BoxStep::new([0.1, 0.0, 0.3]).unwrap();
    words("BoxStep", [-0.0_f32, 1e-40, 5.0], &of_box, |_| 3);
    words(
        "WrappedWalk(BoxStep)",
        [-0.0_f32, 1e-40, 0.5],
        &WrappedWalk::new(of_box),
        |_| 3,
    );
    let normal = mw::NormalStep::new([0.1; 2]).unwrap();
    words("NormalStep", [0.5_f32, -0.0], &normal, |_| 2);
    let exponential = mw::LogUniformStep::new(0.001, 0.1).unwrap();
    words("LogUniformStep", [0.5_f32; 7], &exponential, |_| 7);
    let subset = Subset::<_, 2, 4>::new(normal, [3, 1]).unwrap();
    words("Subset", [f32::NAN, 0.5, -0.0, 1.0], &subset, |_| 2);
    let one = OneCoordinate::new(BoxStep::new(0.1).unwrap());
    words("OneCoordinate", [0.5_f32; 32], &one, |_| 2);
    let mixture = Mixture::new((UniformStep::new(), one, subset), &[0.2, 0.3, 0.5]).unwrap();
    words("Mixture", [0.5_f32; 4], &mixture, |kind| {
        [5, 3, 3][kind as usize]
    });
}
