//! Mutations of the whole cube, of indices and of some coordinates: what they pick, by exact counts, and what they
//! keep.

use host::generators::Cycle;
use host::words::first_without;
use microwarp::Error;
use microwarp::metropolis::{
    BoxStep, HastingsRatio, Independence, Mutation, NormalStep, OneCoordinate, Subset, Symmetric,
    UniformIndex, UniformStep,
};
use microwarp::poly as mw;
use microwarp::tier::{Libm, Poly};
use rand_core::Rng;
use rand_pcg::Pcg32;

#[test]
fn a_uniform_step_is_the_words_on_the_grid() {
    let mut rng = Pcg32::new(0x0517, 54);
    for _ in 0..10_000 {
        let words: [u32; 3] = std::array::from_fn(|_| rng.next_u32());
        let from = std::array::from_fn(|_| f32::from_bits(rng.next_u32()));
        let Ok(proposal) = UniformStep::new().try_propose(from, &mut Cycle::new(&words));
        let on_grid = words.map(|word| f64::from(word >> 8) / 2f64.powi(24));
        assert_eq!(proposal.state.map(f64::from), on_grid);
        assert_eq!((proposal.correction, proposal.kind), (Symmetric, 0));
        let Ok(one) = UniformStep::new().try_propose(from[0], &mut Cycle::new(&words));
        assert_eq!(f64::from(one.state), on_grid[0]);
    }
}

fn index_of(mutation: UniformIndex, fraction: u64) -> usize {
    let words = [(fraction >> 32) as u32, fraction as u32];
    let Ok(proposal) = mutation.try_propose(7, &mut Cycle::new(&words));
    proposal.state
}

/// The first 64-bit fraction that gives at least an index; 2⁶⁴ if none does.
fn first_of(mutation: UniformIndex, index: usize) -> u128 {
    let below = |fraction| index_of(mutation, fraction) < index;
    if below(u64::MAX) {
        1 << 64
    } else {
        first_without(0..u64::MAX, below).into()
    }
}

#[test]
fn every_index_has_its_share_of_fractions() {
    assert_eq!(UniformIndex::new(0), Err(Error::NotPositive(0)));
    let mut rng = Pcg32::new(0x1d8, 54);
    let mut largest = 0;
    for count in (1..40).chain([1000, 65_537, (1 << 31) - 1, 1 << 31, u32::MAX - 1, u32::MAX]) {
        let mutation = UniformIndex::new(count).unwrap();
        assert_eq!(index_of(mutation, 0), 0);
        assert_eq!(index_of(mutation, u64::MAX), count as usize - 1);
        let mut indices: Vec<u32> = (0..count.min(40)).collect();
        indices.extend((0..20).map(|_| rng.next_u32() % count));
        indices.push(count - 1);
        for index in indices {
            // Index i is of the fractions from i 2⁶⁴/n up to the next, and so to 2⁻⁶⁴.
            let (n, i) = (u128::from(count), u128::from(index));
            let starts = |i: u128| (i << 64).div_ceil(n);
            let first = first_of(mutation, index as usize);
            let beyond = first_of(mutation, index as usize + 1);
            assert_eq!(
                (first, beyond),
                (starts(i), starts(i + 1)),
                "{index} of {count}"
            );
            largest = largest.max(((beyond - first) * n).abs_diff(1 << 64) / n);
        }
        for _ in 0..2000 {
            let fraction = u64::from(rng.next_u32()) << 32 | u64::from(rng.next_u32());
            let exact = (u128::from(fraction) * u128::from(count)) >> 64;
            assert_eq!(index_of(mutation, fraction) as u128, exact);
        }
    }
    assert_eq!(largest, 0, "a share is off by a whole fraction");
    // The common shortcut of one word gives shares that differ by far more.
    let short = |n: u64, i: u64| ((i + 1) << 32).div_ceil(n) - (i << 32).div_ceil(n);
    assert_eq!(short(3 << 30, 0), 2);
    assert_eq!(short(3 << 30, 1), 1);
}

#[test]
fn a_subset_changes_its_coordinates_as_the_mutation_does() {
    let steps = NormalStep::<_, Poly>::new([0.1, 1.0, 10.0]).unwrap();
    let mut rng = Pcg32::new(0x5b5e, 54);
    for axes in [[0, 1, 2], [4, 2, 0], [3, 4, 1], [2, 0, 4]] {
        let subset = Subset::<_, 3, 5>::new(steps, axes).unwrap();
        for _ in 0..2000 {
            let words: [u32; 3] = std::array::from_fn(|_| rng.next_u32());
            let from: [f32; 5] = std::array::from_fn(|_| f32::from_bits(rng.next_u32()));
            let Ok(whole) = subset.try_propose(from, &mut Cycle::new(&words));
            let Ok(part) = steps.try_propose(axes.map(|a| from[a]), &mut Cycle::new(&words));
            for (axis, (x, before)) in whole.state.iter().zip(from).enumerate() {
                let place = axes.iter().position(|a| *a == axis);
                let expected = place.map_or(before, |k| part.state[k]);
                assert_eq!(x.to_bits(), expected.to_bits());
            }
        }
    }
    // The ratio and the kind are those of the mutation.
    let far = Independence::new(mw::NormalPair::new([0.0; 2], 1.0).unwrap());
    let subset = Subset::<_, 2, 3>::new(far, [2, 1]).unwrap();
    let Ok(whole) = subset.try_propose([9.0, 2.0, 1.0], &mut Pcg32::new(3, 1));
    let Ok(part) = far.try_propose([1.0, 2.0], &mut Pcg32::new(3, 1));
    assert_eq!(whole.correction, part.correction);
    assert_ne!(whole.correction, HastingsRatio::ONE);
}

#[test]
fn impossible_axes_are_refused() {
    let whole = UniformStep::new();
    let two = |axes| Subset::<_, 2, 3>::new(whole, axes).err();
    for good in [[0, 1], [1, 0], [2, 0], [1, 2]] {
        assert_eq!(two(good), None);
    }
    for bad in [
        [0, 0],
        [2, 2],
        [0, 3],
        [3, 0],
        [usize::MAX, 1],
        [1, usize::MAX],
    ] {
        assert_eq!(two(bad), Some(Error::OutOfRange(1)), "{bad:?}");
    }
    let none = Subset::<_, 0, 3>::new(whole, []);
    assert_eq!(none.err(), Some(Error::OutOfRange(1)));
    let out_of_none = Subset::<_, 1, 0>::new(whole, [0]);
    assert_eq!(out_of_none.err(), Some(Error::OutOfRange(1)));
    let many = Subset::<_, 4, 3>::new(whole, [0, 1, 2, 1]);
    assert_eq!(many.err(), Some(Error::OutOfRange(1)));
    let all = Subset::<_, 3, 3>::new(whole, [2, 1, 0]);
    assert_eq!(all.err(), None);
    // At compile time too.
    const LENS: Result<Subset<UniformStep, 2, 5>, Error> = Subset::new(UniformStep::new(), [3, 4]);
    assert!(LENS.is_ok());
}

/// The coordinate that a word picks, found by what changes: exactly one.
fn picked<const D: usize>(word: u32) -> usize {
    let one = OneCoordinate::new(BoxStep::new(1.0).unwrap());
    let from: [f32; D] = std::array::from_fn(|axis| axis as f32);
    let second = 0x6000_0000;
    let Ok(proposal) = one.try_propose(from, &mut Cycle::new(&[word, second]));
    let changed: Vec<usize> = (0..D).filter(|&a| proposal.state[a] != from[a]).collect();
    let [axis] = changed[..] else {
        panic!("{changed:?} changed");
    };
    // And by the mutation, of the second word.
    let Ok(alone) = BoxStep::new(1.0)
        .unwrap()
        .try_propose(from[axis], &mut Cycle::new(&[second]));
    assert_eq!(proposal.state[axis], alone.state);
    axis
}

fn each_has_its_words<const D: usize>() {
    let mut start = 0;
    for axis in 0..D as u64 {
        let up_to = |word: u64| picked::<D>(word as u32) <= axis as usize;
        let end = first_without(start..1 << 32, up_to);
        let words = end - start;
        assert!(
            words * (D as u64) < (1 << 32) + D as u64,
            "{axis} of {D}: {words}"
        );
        assert!((words + 1) * D as u64 > 1 << 32, "{axis} of {D}: {words}");
        start = end;
    }
    assert_eq!(start, 1 << 32);
}

#[test]
fn one_coordinate_is_picked_evenly_and_changed_alone() {
    each_has_its_words::<1>();
    each_has_its_words::<2>();
    each_has_its_words::<3>();
    each_has_its_words::<5>();
    each_has_its_words::<7>();
    each_has_its_words::<64>();
    each_has_its_words::<1000>();
}

#[test]
fn a_point_of_no_coordinates_stays() {
    let one = OneCoordinate::new(NormalStep::<f32, Libm>::new(1.0).unwrap());
    let mut rng = Cycle::new(&[u32::MAX, 5]);
    let Ok(proposal) = one.try_propose([0.0_f32; 0], &mut rng);
    assert_eq!(proposal.state, [0.0_f32; 0]);
}
