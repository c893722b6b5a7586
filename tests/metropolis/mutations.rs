//! What the constructors of mutations refuse, and that whatever they accept proposes in range: with random
//! parameters, from any state.

use host::generators::Cycle;
use host::speed;
use microwarp::Error;
use microwarp::metropolis::{
    BoxStep, LogUniformStep, Mixture, Mutation, NormalStep, OneCoordinate, StepLaw, Subset,
    Symmetric, UniformIndex, UniformStep, WrappedWalk,
};
use microwarp::tier::{Libm, Poly, Tier};
use rand_core::Rng;
use rand_pcg::Pcg32;

const TINY: f32 = f32::from_bits(1);

/// Widths that the constructors of both walks refuse, and why.
fn widths_refused(new: impl Fn([f32; 2]) -> Option<Error>) {
    for bad in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
        assert_eq!(new([bad, 1.0]), Some(Error::NotFinite(0)));
        assert_eq!(new([1.0, bad]), Some(Error::NotFinite(0)));
    }
    for bad in [-TINY, -1.0, f32::MIN] {
        assert_eq!(new([bad, 1.0]), Some(Error::Negative(0)));
        assert_eq!(new([0.0, bad]), Some(Error::Negative(0)));
    }
    assert_eq!(new([0.0, -0.0]), Some(Error::NotPositive(0)));
    for good in [[0.0, TINY], [TINY, 0.0], [1.0, 2.0], [6e37, 1e-38]] {
        assert_eq!(new(good), None, "{good:?}");
    }
}

fn refusals<T: Tier>() {
    widths_refused(|w| NormalStep::<_, T>::new(w).err());
    for (deviation, error) in [
        (6e37, None),
        (6.000_001e37, Some(Error::TooLarge(0))),
        (f32::MAX, Some(Error::TooLarge(0))),
    ] {
        assert_eq!(NormalStep::<_, T>::new(deviation).err(), error);
        assert_eq!(NormalStep::<_, T>::new([1.0, deviation]).err(), error);
    }
    let exponential = |a, b| LogUniformStep::<T>::new(a, b).err();
    for bad in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
        assert_eq!(exponential(bad, 1.0), Some(Error::NotFinite(0)));
        assert_eq!(exponential(1.0, bad), Some(Error::NotFinite(1)));
    }
    for bad in [0.0, -0.0, -TINY, -1.0] {
        assert_eq!(exponential(bad, 1.0), Some(Error::NotPositive(0)));
        assert_eq!(exponential(1.0, bad), Some(Error::NotPositive(1)));
    }
    assert_eq!(
        exponential(1.0, 1.0 - f32::EPSILON / 2.0),
        Some(Error::Reversed(1))
    );
    assert_eq!(exponential(f32::MAX, TINY), Some(Error::Reversed(1)));
    for (a, b) in [
        (TINY, TINY),
        (TINY, f32::MAX),
        (f32::MAX, f32::MAX),
        (1.0, 1.0),
    ] {
        assert_eq!(exponential(a, b), None);
    }
}

/// The quotient of the sizes, times the smaller one, may be rounded beyond the largest `f32`.
#[test]
fn sizes_up_to_the_largest_number_are_sizes() {
    let mut rng = Pcg32::new(17, 1);
    for _ in 0..100_000 {
        let smallest = f32::from_bits(rng.next_u32() % f32::MAX.to_bits() + 1);
        for word in [0, u32::MAX / 3, u32::MAX / 2] {
            let step = LogUniformStep::<Poly>::new(smallest, f32::MAX).unwrap();
            let size = StepLaw::<f32>::displacement(&step, 0, word);
            // Rounded, a size may lie a few units beyond the bounds.
            assert!(
                size >= 0.999_999 * smallest && size <= f32::MAX,
                "{smallest:e}"
            );
        }
    }
}

#[test]
fn impossible_steps_are_refused() {
    widths_refused(|w| BoxStep::new(w).err());
    assert_eq!(BoxStep::new(f32::MAX).err(), None);
    // Without coordinates there is nothing to move.
    assert_eq!(BoxStep::new([0.0; 0]).err(), Some(Error::NotPositive(0)));
    refusals::<Libm>();
    refusals::<Poly>();
}

/// Any bit pattern, half of them of a moderate size.
fn any(rng: &mut Pcg32) -> f32 {
    let x = f32::from_bits(rng.next_u32());
    match rng.next_u32() % 4 {
        0 => 1e3 * (rng.next_u32() as f32 * 2f32.powi(-32)),
        1 => x.abs(),
        _ => x,
    }
}

/// Proposes from a finite state, and from states that are none.
fn stays_in_range<L>(law: L, rng: &mut Pcg32) -> [u32; 2]
where
    L: StepLaw<[f32; 2]> + Mutation<[f32; 2], Correction = Symmetric> + Copy,
{
    let (mut moved, mut stayed) = (0, 0);
    for _ in 0..8 {
        let words = [rng.next_u32(), rng.next_u32()];
        let steps: [f32; 2] = std::array::from_fn(|axis| law.displacement(axis, words[axis]));
        assert!(steps.iter().all(|s| s.is_finite()), "{steps:?}");
        let from = [any(rng), any(rng)];
        let Ok(proposal) = law.try_propose(from, &mut Cycle::new(&words));
        let sums = [from[0] + steps[0], from[1] + steps[1]];
        if sums.iter().all(|x| x.is_finite()) {
            assert_eq!(proposal.state, sums);
            moved += 1;
        } else {
            // To the bit: even what is no number stays what it was.
            assert_eq!(proposal.state.map(f32::to_bits), from.map(f32::to_bits));
            stayed += 1;
        }
        let Ok(proposal) = WrappedWalk::new(law).try_propose(from, &mut Cycle::new(&words));
        assert!(proposal.state.iter().all(|x| (0.0..1.0).contains(x)));
    }
    [moved, stayed]
}

fn random_parameters<T: Tier>() {
    let mut rng = Pcg32::new(0xa11f, 54);
    let (mut accepted, mut totals) = ([0; 3], [0; 2]);
    let rounds = speed::of("parameters", 60_000, 300_000);
    for _ in 0..rounds {
        let parameters = [any(&mut rng), any(&mut rng)];
        let [a, b] = parameters;
        let mut counts = [[0; 2]; 3];
        if let Ok(law) = BoxStep::new(parameters) {
            accepted[0] += 1;
            counts[0] = stays_in_range(law, &mut rng);
        }
        if let Ok(law) = NormalStep::<_, T>::new(parameters) {
            accepted[1] += 1;
            counts[1] = stays_in_range(law, &mut rng);
        }
        if let Ok(law) = LogUniformStep::<T>::new(a, b) {
            accepted[2] += 1;
            counts[2] = stays_in_range(law, &mut rng);
        }
        for [moved, stayed] in counts {
            totals = [totals[0] + moved, totals[1] + stayed];
        }
    }
    println!(
        "{}: {accepted:?} accepted, {totals:?} moved and stayed",
        T::NAME
    );
    assert!(accepted.iter().all(|&n| n > rounds / 6));
    assert!(totals.iter().all(|&n| n > rounds / 30));
}

#[test]
fn whatever_is_accepted_proposes_in_range() {
    random_parameters::<Libm>();
    random_parameters::<Poly>();
}

#[test]
fn beyond_the_range_of_f32_a_proposal_stays() {
    let step = BoxStep::new([f32::MAX, 1.0]).unwrap();
    for (word, x) in [(0x7fff_ffff, f32::MAX), (0x8000_0000, f32::MIN)] {
        // All coordinates, not only the one that leaves.
        let Ok(proposal) = step.try_propose([x, 0.5], &mut Cycle::new(&[word]));
        assert_eq!(proposal.state, [x, 0.5]);
        let Ok(back) = step.try_propose([x, 0.5], &mut Cycle::new(&[!word]));
        assert!(back.state[0].abs() < 0.6 * f32::MAX && back.state[1] != 0.5);
    }
}

/// Generators that are stuck give one and the same proposal, in range.
#[test]
fn a_stuck_generator_proposes_in_range() {
    for word in [0, 0xff, 0x7fff_ffff, 0x8000_0000, u32::MAX] {
        let words = [word];
        let mut rng = Cycle::new(&words);
        let small = WrappedWalk::new(LogUniformStep::<Poly>::new(1e-3, 1e-1).unwrap());
        let mixture = Mixture::large_small(0.3, small).unwrap();
        let subset = Subset::<_, 2, 3>::new(mixture, [2, 0]).unwrap();
        let one = OneCoordinate::new(mixture);
        for from in [[0.0; 3], [0.999_999_94; 3], [f32::NAN, 0.5, 7.0]] {
            let Ok(a) = UniformStep::new().try_propose(from, &mut rng);
            let Ok(b) = mixture.try_propose(from, &mut rng);
            assert!(
                [a.state, b.state]
                    .as_flattened()
                    .iter()
                    .all(|x| (0.0..1.0).contains(x))
            );
            let Ok(c) = subset.try_propose(from, &mut rng);
            assert!(
                [c.state[0], c.state[2]]
                    .iter()
                    .all(|x| (0.0..1.0).contains(x))
            );
            let Ok(d) = one.try_propose(from, &mut rng);
            let axis = if word < 0x5555_5556 {
                0
            } else if word < 0xaaaa_aaab {
                1
            } else {
                2
            };
            assert!((0.0..1.0).contains(&d.state[axis]), "{word:x} {d:?}");
        }
        for count in [1, 2, 3, 1 << 31, u32::MAX] {
            let Ok(index) = UniformIndex::new(count).unwrap().try_propose(0, &mut rng);
            assert!(index.state < count as usize);
        }
    }
}
