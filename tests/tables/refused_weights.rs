//! Weights that are none, tables that are none, and uniforms of every kind.

use crate::cases::wild;
use host::upkeep::errors;
use microwarp::Error::{
    AllZero, NegativeWeight, NoWeights, NotATable, NotFiniteWeight, TooManyWeights, Unreachable,
};
use microwarp::discrete::{Alias, AliasEntry, Cdf, MAX_ENTRIES, select_once};
use rand_pcg::Pcg32;
use rand_pcg::rand_core::Rng;

#[test]
fn bad_weights_are_named() {
    let nan = f32::NAN;
    for (weights, error) in [
        (vec![], NoWeights),
        (vec![0.0], AllZero),
        (vec![0.0, -0.0, 0.0], AllZero),
        (vec![1.0, -1.0, nan], NegativeWeight(1)),
        (vec![1.0, 2.0, -1e-45], NegativeWeight(2)),
        (vec![nan], NotFiniteWeight(0)),
        (vec![0.0, f32::INFINITY, -1.0], NotFiniteWeight(1)),
        (vec![1.0, f32::NEG_INFINITY], NotFiniteWeight(1)),
    ] {
        let (mut narrow, mut wide) = ([5_u32; 4], [5_u64; 4]);
        let mut bins = [AliasEntry::<u32>::EMPTY; 4];
        let mut wide_bins = [AliasEntry::<u64>::EMPTY; 4];
        let refused = [
            Cdf::<&[u32]>::new_in(&weights, &mut narrow).err(),
            Cdf::<&[u64]>::new_in(&weights, &mut wide).err(),
            Cdf::<heapless::Vec<u32, 4>>::from_slice(&weights).err(),
            Cdf::<heapless::Vec<u64, 4>>::from_slice(&weights).err(),
            Alias::<&[AliasEntry<u32>]>::new_in(&weights, &mut bins).err(),
            Alias::<&[AliasEntry<u64>]>::new_in(&weights, &mut wide_bins).err(),
            Alias::<heapless::Vec<AliasEntry<u32>, 4>>::from_slice(&weights).err(),
            Alias::<heapless::Vec<AliasEntry<u64>, 4>>::from_slice(&weights).err(),
            select_once(&weights, 0).err(),
        ];
        assert_eq!(refused, [Some(error); 9]);
        assert_eq!((narrow, wide), ([5; 4], [5; 4]), "memory was touched");
    }
    assert_eq!(Cdf::new(&[1.0, nan]), Err(NotFiniteWeight(1)));
    assert_eq!(Cdf::new(&[]), Err(NoWeights));
    assert_eq!(Cdf::from_integers_u64(&[0; 3]), Err(AllZero));
    assert_eq!(
        Alias::<[AliasEntry<u32>; 2]>::new(&[-1.0]),
        Err(NegativeWeight(0))
    );
    assert_eq!(
        Alias::<[AliasEntry<u32>; 2]>::from_integers(&[]),
        Err(NoWeights)
    );
}

#[test]
fn too_many_weights_are_refused() {
    let mut memory = [0; 3];
    assert_eq!(
        Cdf::<&[u32]>::new_in(&[1.0; 4], &mut memory),
        Err(TooManyWeights)
    );
    assert_eq!(
        Cdf::<heapless::Vec<u32, 3>>::from_slice(&[1.0; 4]),
        Err(TooManyWeights)
    );
    assert_eq!(
        Alias::<[AliasEntry<u32>; 4]>::new(&[1.0; 5]),
        Err(TooManyWeights)
    );
    // A vector of five has no room for eight bins.
    let vector = Alias::<heapless::Vec<AliasEntry<u32>, 5>>::from_slice(&[1.0; 5]);
    assert_eq!(vector, Err(TooManyWeights));
    let weights = vec![1.0; MAX_ENTRIES + 1];
    let mut memory = vec![0; MAX_ENTRIES + 1];
    assert_eq!(
        Cdf::<&[u32]>::new_in(&weights, &mut memory),
        Err(TooManyWeights)
    );
    let most = Cdf::<&[u32]>::new_in(&weights[1..], &mut memory).unwrap();
    assert_eq!(
        (most.entries(), most.numerator(MAX_ENTRIES - 1)),
        (MAX_ENTRIES, 256)
    );
}

#[test]
fn the_smallest_weight_that_cannot_be_reached_is_named() {
    assert_eq!(Cdf::new(&[1.0, 1e-20, 0.0, 1e-30]), Err(Unreachable(3)));
    assert!(Cdf::new_u64(&[1.0, 1e-20, 0.0, 1e-30]).is_ok());
    // One tiny weight finds room.
    assert!(Cdf::new(&[1.0, 1e-30, 0.0, 2.0]).is_ok());
}

#[test]
fn words_that_are_no_table_are_refused() {
    assert_eq!(Cdf::from_words([0_u32; 0]), Err(NoWeights));
    assert_eq!(Cdf::from_words([1_u32]), Err(NotATable));
    assert_eq!(Cdf::from_words([5_u32, 4, 2]), Err(NotATable));
    assert_eq!(Cdf::from_words([4_u32, 5, 1]), Err(NotATable));
    assert_eq!(Cdf::from_words([4_u32, 5, 3]), Err(NotATable));
    // An index beyond 32 bits is none on targets of 32 bits either.
    assert_eq!(Cdf::from_words([4_u64, 5, 1 << 32 | 2]), Err(NotATable));
    assert!(Cdf::from_words([4_u64, 5, 2]).is_ok());
    assert!(Cdf::from_words([4_u32, 5, 2]).is_ok());
    assert!(Cdf::from_words([4_u32, u32::MAX, 1]).is_ok());
    // Whatever is accepted is a table: its words are all somebody's.
    let mut rng = Pcg32::new(8, 8);
    let mut accepted = 0;
    for _ in 0..200_000 {
        let mut words = [0_u32; 5];
        for word in &mut words {
            *word = match rng.next_u32() % 4 {
                0 => 0,
                1 => u32::MAX,
                2 => rng.next_u32() % 6,
                _ => rng.next_u32(),
            };
        }
        if let Ok(table) = Cdf::from_words(words) {
            accepted += 1;
            let sum: u64 = (0..5).map(|i| table.numerator(i)).sum();
            assert_eq!(sum, 1 << 32, "{words:?}");
            for word in [0, 1, rng.next_u32(), u32::MAX] {
                let index = table.index(word);
                assert!(table.words_of(index).unwrap().contains(&word), "{words:?}");
            }
        }
    }
    assert!(accepted > 1000);
    // And what a constructor made is accepted.
    for seed in 0..2_000 {
        let weights = wild(seed);
        let mut memory = [0_u64; 24];
        let table = Cdf::<&[u64]>::new_in(&weights, &mut memory).unwrap();
        assert_eq!(Cdf::from_words(table.as_words()), Ok(table));
    }
}

#[test]
fn any_uniform_selects_an_entry_of_positive_weight() {
    let any = [
        f32::NAN,
        -1.0,
        -0.0,
        0.0,
        1e-45,
        1e-20,
        0.5,
        0.999_999_94,
        1.0,
        7.0,
        f32::MAX,
        f32::INFINITY,
        f32::NEG_INFINITY,
    ];
    for seed in 0..5_000 {
        let weights = wild(seed);
        let (mut ends, mut bins) = ([0_u64; 24], [AliasEntry::<u64>::EMPTY; 32]);
        let cdf = Cdf::<&[u64]>::new_in(&weights, &mut ends).unwrap();
        let alias = Alias::<&[AliasEntry<u64>]>::new_in(&weights, &mut bins).unwrap();
        for u in any {
            for chosen in [cdf.select_uniform(u), alias.select_uniform(u)] {
                assert!(weights[chosen.index] > 0.0 && chosen.pmf > 0.0);
                assert!((0.0..1.0).contains(&chosen.leftover));
            }
        }
    }
}

/// What an error prints names the weight, and no two print the same.
#[test]
fn every_error_says_which_it_is() {
    let indexed = [NotFiniteWeight(17), NegativeWeight(17), Unreachable(17)];
    assert!(indexed.iter().all(|e| e.to_string().contains("17")));
    let all = errors().unwrap();
    let mut texts = Vec::from_iter(all.iter().map(|(error, _)| error.to_string()));
    assert!(texts.iter().all(|text| text.len() > 10), "{texts:?}");
    texts.sort();
    texts.dedup();
    assert_eq!(texts.len(), all.len());
}
