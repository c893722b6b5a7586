//! Chains that are saved, sent as bytes, and made chains again; and what a chain costs in bytes.

use super::own::{Bits, Weighed};
use host::docs::Doc;
use microwarp::Error;
use microwarp::metropolis::{
    Chain, Chance, LogDensity, Mixture, Mutation, Saved, Start, Transition, UniformIndex,
    UniformStep, WrappedWalk,
};
use microwarp::tier::{Libm, Poly};
use microwarp::{metropolis::BoxStep, poly as mw};
use rand_pcg::Pcg32;
use std::num::NonZeroU32;

const STEPS: usize = 200;

/// What goes over a wire: each number in its bytes.
fn to_bytes(numbers: &[u64]) -> Vec<u8> {
    numbers.iter().flat_map(|n| n.to_le_bytes()).collect()
}

fn from_bytes(bytes: &[u8]) -> Vec<u64> {
    let number = |b: &[u8]| u64::from_le_bytes(b.try_into().unwrap());
    bytes.chunks(8).map(number).collect()
}

/// Cuts a run at every step, and continues what was made again out of bytes.
fn cut<X, D, M>(start: X, target: impl Fn(X) -> D, mutation: &M, back: impl Fn(&[u64]) -> (X, D))
where
    X: Copy + Bits,
    D: Weighed,
    M: Mutation<X>,
{
    let limit = NonZeroU32::new(3).unwrap();
    // Limited steps now and then, so that rejections in a row matter.
    let go = |chain: &mut Chain<X, D>, k: usize, rng: &mut Pcg32| match k % 3 {
        0 => chain.step_limited(&target, mutation, limit, rng),
        _ => chain.step(&target, mutation, rng),
    };
    let (mut rng, mut chain) = (Pcg32::new(1, 2), Chain::new(start, &target).unwrap());
    let mut uncut = Vec::new();
    let mut at = vec![(chain, rng.clone())];
    for k in 0..STEPS {
        uncut.push(go(&mut chain, k, &mut rng));
        at.push((chain, rng.clone()));
    }
    assert!(chain.accepted() > 5 && chain.accepted() < STEPS as u64 - 5);
    for (k, (chain, rng)) in at.iter().enumerate() {
        let bytes = to_bytes(&chain.save().bits());
        let numbers = from_bytes(&bytes);
        let (rest, counts) = numbers.split_at(numbers.len() - 4);
        let (state, density) = back(rest);
        let mut again = Chain::resume(Saved {
            state,
            density,
            steps: counts[0],
            accepted: counts[1],
            refused: counts[2],
            rejected_in_a_row: counts[3] as u32,
        })
        .unwrap();
        assert_eq!(again.save().bits(), chain.save().bits());
        let mut rng = rng.clone();
        for (j, step) in uncut.iter().enumerate().skip(k) {
            assert_eq!(go(&mut again, j, &mut rng).bits(), step.bits());
            assert_eq!(again.save().bits(), at[j + 1].0.save().bits(), "{k} {j}");
        }
        assert_eq!(rng, at[STEPS].1);
    }
}

fn number(bits: &u64) -> f32 {
    f32::from_bits(*bits as u32)
}

#[test]
fn a_run_that_is_cut_anywhere_goes_on_as_if_it_were_not() {
    let steps = (
        UniformStep::new(),
        WrappedWalk::new(BoxStep::new([0.1; 2]).unwrap()),
    );
    let mutation = Mixture::new(steps, &[0.3, 0.7]).unwrap();
    let holes = |[x, y]: [f32; 2]| if x < 0.2 { f32::NAN } else { (x * y).powi(4) };
    cut([0.5, 0.25], holes, &mutation, |n| {
        ([number(&n[0]), number(&n[1])], number(&n[2]))
    });
    let logs = |[x, y]: [f32; 2]| LogDensity::<Libm>::new(-30.0 * x * x - y);
    cut([0.5, 0.25], logs, &mutation, |n| {
        (
            [number(&n[0]), number(&n[1])],
            LogDensity::new(number(&n[2])),
        )
    });
    let weights = |i: usize| [1e-3, 1e30, 1e29, 0.0, 5e29][i];
    let mutation = UniformIndex::new(5).unwrap();
    cut(1, weights, &mutation, |n| (n[0] as usize, number(&n[1])));
    let weights = |i: usize| [1_u32, u32::MAX, 900_000_000, 0, 7][i];
    cut(1, weights, &mutation, |n| (n[0] as usize, n[1] as u32));
    let peak = |x: f32| mw::LogDensity::new(-x * x);
    let step = mw::NormalStep::new(2.0_f32).unwrap();
    cut(-0.0, peak, &step, |n| {
        (number(&n[0]), LogDensity::new(number(&n[1])))
    });
}

/// The number of steps saturates while the others go on; what such a chain saves is taken back.
#[test]
fn a_chain_at_the_last_step_is_resumed() {
    let mut chain = Chain::resume(Saved {
        state: 0.5_f32,
        density: 1.0_f32,
        steps: u64::MAX - 3,
        accepted: u64::MAX - 10,
        refused: 7,
        rejected_in_a_row: 7,
    })
    .unwrap();
    let mut rng = Pcg32::new(7, 7);
    for i in 0..40_u32 {
        // Moves, stays, and is refused.
        let target = move |_: f32| [1.0, 0.0, f32::NAN, 2.0][i as usize % 4];
        chain.step(target, &UniformStep::new(), &mut rng);
        let saved = chain.save();
        assert_eq!(Chain::resume(saved).map(|c| c.save()), Ok(saved), "{i}");
        assert!(saved.accepted <= saved.steps);
    }
    assert_eq!(chain.steps(), u64::MAX);
}

#[test]
fn what_no_chain_can_be_is_not_resumed() {
    let good = Saved {
        state: 5_usize,
        density: 2.0_f32,
        steps: 10,
        accepted: 4,
        refused: 3,
        rejected_in_a_row: 6,
    };
    assert_eq!(Chain::resume(good).map(|c| c.save()), Ok(good));
    let refused = |saved: Saved<usize>| Chain::resume(saved).err();
    for density in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
        assert_eq!(
            refused(Saved { density, ..good }),
            Some(Error::NotFinite(0))
        );
    }
    for density in [0.0, -0.0] {
        assert_eq!(
            refused(Saved { density, ..good }),
            Some(Error::NotPositive(0))
        );
    }
    let density = -1.0;
    assert_eq!(refused(Saved { density, ..good }), Some(Error::Negative(0)));
    // More of one kind than there are steps, or of all.
    for (accepted, refusals) in [
        (11, 0),
        (0, 11),
        (8, 3),
        (u64::MAX, 0),
        (u64::MAX, 1),
        (u64::MAX, u64::MAX),
        (1 << 63, 1 << 63),
    ] {
        let saved = Saved {
            accepted,
            refused: refusals,
            rejected_in_a_row: 0,
            ..good
        };
        assert_eq!(refused(saved), Some(Error::OutOfRange(0)));
    }
    // More rejections in a row than rejections.
    for rejected_in_a_row in [7, 10, u32::MAX] {
        let saved = Saved {
            rejected_in_a_row,
            ..good
        };
        assert_eq!(refused(saved), Some(Error::OutOfRange(0)));
    }
    // All that a chain can be.
    for (steps, accepted, refused, rejected_in_a_row) in [
        (0, 0, 0, 0),
        (1, 0, 1, 1),
        (1, 1, 0, 0),
        (u64::MAX, 0, 0, u32::MAX),
        (u64::MAX, u64::MAX, 0, 0),
        (1 << 40, 1 << 39, 1 << 39, u32::MAX),
    ] {
        let saved = Saved {
            steps,
            accepted,
            refused,
            rejected_in_a_row,
            ..good
        };
        assert!(Chain::resume(saved).is_ok(), "{saved:?}");
    }
    // Of logarithms and of integers too.
    fn fresh<D: Weighed>(density: D) -> Option<Error> {
        let saved = Saved {
            state: 0_usize,
            density,
            steps: 0,
            accepted: 0,
            refused: 0,
            rejected_in_a_row: 0,
        };
        Chain::resume(saved).err()
    }
    for (log, error) in [
        (f32::NAN, Error::NotFinite(0)),
        (f32::INFINITY, Error::NotFinite(0)),
        (f32::NEG_INFINITY, Error::NotPositive(0)),
    ] {
        assert_eq!(fresh(LogDensity::<Poly>::new(log)), Some(error));
    }
    assert_eq!(fresh(0_u32), Some(Error::NotPositive(0)));
}

/// The table at `Chain` states the sizes, on machines whose `usize` has 64 bits.
#[test]
#[cfg(target_pointer_width = "64")]
fn sizes_are_those_stated() {
    let chain = Doc::of("metropolis", "Chain");
    fn check<X>(chain: &Doc, column: usize) {
        let sizes = [
            ("[`Chain`], [`Saved`]", size_of::<Chain<X>>()),
            ("[`Chain`], [`Saved`]", size_of::<Saved<X>>()),
            (
                "[`Chain`], [`Saved`]",
                size_of::<Chain<X, LogDensity<Libm>>>(),
            ),
            (
                "[`Chain`], [`Saved`]",
                size_of::<Chain<X, LogDensity<Poly>>>(),
            ),
            ("[`Chain`], [`Saved`]", size_of::<Chain<X, u32>>()),
            ("[`Chain`], [`Saved`]", size_of::<Saved<X, u32>>()),
            (
                "of integer weights",
                size_of::<Transition<X, u32, Chance>>(),
            ),
            (
                "[`Transition`](super::Transition)",
                size_of::<Transition<X>>(),
            ),
            (
                "[`Transition`](super::Transition)",
                size_of::<Transition<X, LogDensity<Poly>>>(),
            ),
        ];
        for (row, size) in sizes {
            assert_eq!(chain.figure(row, column), size as f64, "{row} {column}");
        }
        println!("{sizes:?}");
    }
    check::<f32>(&chain, 0);
    check::<[f32; 2]>(&chain, 1);
    check::<[f32; 32]>(&chain, 2);
    check::<usize>(&chain, 3);
    // One number is as large as an array of one.
    assert_eq!(size_of::<Chain<[f32; 1]>>(), size_of::<Chain<f32>>());
    assert_eq!(
        size_of::<Transition<[f32; 1]>>(),
        size_of::<Transition<f32>>()
    );
}

#[test]
fn chains_can_be_copied_sent_and_shared() {
    const fn plain<T: Copy + Send + Sync + 'static>() {}
    plain::<Chain<[f32; 32]>>();
    plain::<Chain<usize, LogDensity<Libm>>>();
    plain::<Transition<[f32; 2]>>();
    plain::<Transition<usize, LogDensity<Poly>>>();
    plain::<Saved<f32>>();
    plain::<Saved<f32, LogDensity<Libm>>>();
    plain::<Start<f32>>();
    // A state of one's own.
    #[derive(Clone, Copy)]
    struct Own(#[allow(dead_code, reason = "a size")] u8);
    plain::<Chain<Own>>();
    const CHAIN: fn(&Chain<Own>) -> Saved<Own> = |chain| chain.save();
    assert!(CHAIN(&Chain::new(Own(1), |_| 1.0).unwrap()).density > 0.0);
}
