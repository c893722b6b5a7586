//! The words that mutations take of a generator, and that its failure at any of them passes through.

use host::generators::{Broken, Counting, Failing};
use microwarp::discrete::{Alias, AliasEntry, Cdf};
use microwarp::metropolis::{
    BoxStep, Independence, LogUniformStep, Mixture, Mutation, NormalStep, OneCoordinate, Product,
    Proposal, Subset, Symmetric, TransitionTable, UniformIndex, UniformStep, WrappedWalk,
};
use microwarp::poly as mw;
use microwarp::tier::{Libm, Poly};
use rand_core::TryRng;
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
    takes(
        "NormalStep",
        &NormalStep::<_, Libm>::new([1.0; 3]).unwrap(),
        point,
        3,
    );
    let exponential = LogUniformStep::<Poly>::new(0.01, 1.0).unwrap();
    takes("LogUniformStep", &exponential, point, 3);
    takes("LogUniformStep", &exponential, 0.5_f32, 1);
    takes("WrappedWalk", &WrappedWalk::new(boxed), point, 3);
    // Where a step would leave the range of f32, they are taken all the same.
    takes(
        "BoxStep",
        &BoxStep::new([f32::MAX; 3]).unwrap(),
        [f32::MAX; 3],
        3,
    );
    takes("BoxStep", &boxed, [f32::NAN; 3], 3);

    let pair = Independence::new(mw::NormalPair::new([0.0; 2], 1.0).unwrap());
    takes("Independence", &pair, [0.0; 2], 2);
    let table = Cdf::<[u32; 2]>::new(&[1.0, 3.0]).unwrap();
    takes("Independence", &Independence::new(table), 0, 1);
    let long = Alias::<[AliasEntry<u64>; 2]>::new_u64(&[1.0, 3.0]).unwrap();
    takes("Independence", &Independence::new(long), 0, 2);
    takes(
        "TransitionTable",
        &TransitionTable::new([table; 2]).unwrap(),
        1,
        1,
    );
    takes(
        "TransitionTable",
        &TransitionTable::new([table; 2]).unwrap(),
        9,
        1,
    );

    let two = Subset::<_, 2, 3>::new(UniformStep::new(), [2, 0]).unwrap();
    takes("Subset", &two, point, 2);
    let one = OneCoordinate::new(exponential);
    takes("OneCoordinate", &one, point, 2);
    takes("OneCoordinate", &one, [0.5; 0], 2);
    takes("OneCoordinate", &OneCoordinate::new(Mirror), point, 1);
    let product = Product::new((two, UniformIndex::new(6).unwrap()));
    takes("Product", &product, (point, 0), 4);
    let mixture = Mixture::new((boxed, UniformStep::new()), &[1.0, 1.0]).unwrap();
    takes("Mixture", &mixture, point, 4);
    let outer = Mixture::new([mixture; 3], &[1.0; 3]).unwrap();
    takes("Mixture of mixtures", &outer, point, 5);
    takes("Mixture by reference", &&outer, point, 5);
    let large_small = Mixture::large_small(0.5, WrappedWalk::new(boxed)).unwrap();
    takes("LargeSmall", &large_small, point, 4);
    takes(
        "OneCoordinate of a mixture",
        &OneCoordinate::new(large_small_line()),
        point,
        3,
    );
}

fn large_small_line() -> impl Mutation<f32, Correction = Symmetric> {
    Mixture::large_small(0.5, WrappedWalk::new(BoxStep::new(0.1).unwrap())).unwrap()
}

/// A mutation that takes no word at all.
struct Mirror;

impl Mutation<f32> for Mirror {
    type Correction = Symmetric;
    fn try_propose<R: TryRng + ?Sized>(
        &self,
        from: f32,
        _: &mut R,
    ) -> Result<Proposal<f32, Self::Correction>, R::Error> {
        let to = 1.0 - from;
        Ok(Proposal::new(to, Symmetric))
    }
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
