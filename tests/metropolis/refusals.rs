//! What is no density or no ratio is never accepted, whatever the words; and is counted as what it is.

use super::acceptance::{positive, step};
use super::own::given;
use host::generators::Cycle;
use microwarp::Error;
use microwarp::metropolis::{
    Chain, HastingsCounts, HastingsRatio, LogDensity, Mixture, Outcome, StateSource, Symmetric,
    Transition, UniformIndex,
};
use microwarp::rejection::Failure;
use microwarp::tier::{Libm, Poly};
use rand_core::Rng as _;
use rand_pcg::Pcg32;

const FROM: [f32; 5] = [1e-45, f32::MIN_POSITIVE, 1.0, 3e38, f32::MAX];
const NOT_A_NUMBER: [u32; 4] = [0x7fc0_0000, 0xffc0_0000, 0x7f80_0001, 0xff92_3456];

/// Any bits, every second time those of zeros, ends, and what is no number.
fn any(rng: &mut Pcg32) -> f32 {
    const ODD: [f32; 7] = [
        0.0,
        -0.0,
        f32::INFINITY,
        f32::NEG_INFINITY,
        -1e-45,
        -1.0,
        f32::MIN,
    ];
    let bits = rng.next_u32();
    let k = (bits >> 1) as usize % 32;
    match (bits & 1, k) {
        (0, _) => f32::from_bits(rng.next_u32()),
        (_, 0..7) => ODD[k],
        (_, 7..12) => FROM[k - 7],
        (_, 12..16) => f32::from_bits(NOT_A_NUMBER[k - 12]),
        _ => 1.0,
    }
}

/// Whether a number is a density, and whether it is positive; by its bits.
fn is_density(x: f32) -> (bool, bool) {
    let bits = x.to_bits();
    let zero = bits << 1 == 0;
    let positive = bits >> 31 == 0 && !zero && bits < 0x7f80_0000;
    (zero || positive, positive)
}

#[test]
fn any_bits_have_the_outcome_that_they_must_have() {
    let mut rng = Pcg32::new(4, 4);
    let mut seen = [0_u32; 4];
    for round in 0..2_000_000 {
        let from = match round % 3 {
            0 => FROM[round / 15 % 5],
            _ => positive(&mut rng),
        };
        let [to, forward, backward] = [(); 3].map(|()| any(&mut rng));
        let word = match rng.next_u32() {
            word if round % 5 == 0 => [0, 1, 1 << 31, u32::MAX - 1, u32::MAX][word as usize % 5],
            word => word,
        };
        let ratio = HastingsRatio::new(forward, backward);
        let one = match round % 2 {
            0 => step(from, to, Symmetric, word),
            _ => step(from, to, ratio, word),
        };
        let ((density, possible), (there, forth), (back, returns)) =
            (is_density(to), is_density(forward), is_density(backward));
        let ratio_counts = round % 2 == 1;
        let due = if !density || (ratio_counts && !(there && forth && back)) {
            Outcome::Refused
        } else if !possible || (ratio_counts && !returns) {
            Outcome::Rejected
        } else if u64::from(word) < (f64::from(one.acceptance) * 2_f64.powi(32)).round() as u64 {
            Outcome::Accepted
        } else {
            Outcome::Rejected
        };
        assert_eq!(one.outcome, due, "{from:e} -> {to:e}, {ratio:?}");
        assert_eq!(one.proposed_density.to_bits(), to.to_bits());
        // What can never be accepted has no acceptance.
        let acceptable = due != Outcome::Refused && possible && (!ratio_counts || returns);
        assert!(acceptable || one.acceptance == 0.0);
        seen[due as usize] += 1;
    }
    assert!(seen[0].min(seen[1]).min(seen[2]) > 100_000, "{seen:?}");
    for word in [0, u32::MAX] {
        let outcome = |there, back| {
            let ratio = HastingsRatio::from_counts(there, back);
            step(1.0, 1.0, ratio, word).outcome
        };
        assert_eq!([outcome(0, 1), outcome(0, 0)], [Outcome::Refused; 2]);
        assert_eq!(
            [outcome(1, 0), outcome(u128::MAX, 0)],
            [Outcome::Rejected; 2]
        );
    }
}

/// To the nearest of 2^32 steps, halves upwards.
#[test]
fn an_acceptance_is_realised_to_the_nearest_step() {
    let half = 2_f32.powi(-33);
    let below = f32::from_bits(half.to_bits() - 1);
    let accepts = |a: f32, word: u32| step(1.0, a, Symmetric, word).is_accepted();
    for (a, words) in [
        (1e-45, 0),
        (1e-20, 0),
        (below, 0),
        (half, 1),
        (3.0 * half, 2),
        (f32::from_bits((3.0 * half).to_bits() - 1), 1),
        (1e-9, 4),
        (0.5, 1 << 31),
        (1.0 - f32::EPSILON / 2.0, u32::MAX - 255),
    ] {
        assert_eq!(step(1.0, a, Symmetric, 0).acceptance, a);
        assert!(words == 0 || accepts(a, words - 1), "{a:e}");
        assert!(!accepts(a, words), "{a:e}");
    }
    assert!(accepts(1.0, u32::MAX) && accepts(f32::MAX, u32::MAX));
}

#[test]
fn a_chain_starts_where_it_can_be_and_nowhere_else() {
    let start = |f: f32| Chain::new(7_usize, |_| f).err();
    for f in FROM {
        assert_eq!(start(f), None);
    }
    for bits in NOT_A_NUMBER {
        assert_eq!(start(f32::from_bits(bits)), Some(Error::NotFinite(1)));
    }
    assert_eq!(start(f32::INFINITY), Some(Error::NotFinite(1)));
    assert_eq!(start(f32::NEG_INFINITY), Some(Error::NotFinite(1)));
    assert_eq!(start(0.0), Some(Error::NotPositive(1)));
    assert_eq!(start(-0.0), Some(Error::NotPositive(1)));
    assert_eq!(start(-1e-45), Some(Error::Negative(1)));
    let log = |l: f32| Chain::new(7_usize, |_| LogDensity::<Libm>::new(l)).err();
    for l in [-0.0, f32::MIN, f32::MAX, -1e-45] {
        assert_eq!(log(l), None);
    }
    assert_eq!(log(f32::NEG_INFINITY), Some(Error::NotPositive(1)));
    assert_eq!(log(f32::INFINITY), Some(Error::NotFinite(1)));
    assert_eq!(log(f32::NAN), Some(Error::NotFinite(1)));
    assert!(Chain::new(0.5_f32, LogDensity::<Poly>::new).is_ok());
    let weight = |i: usize| [5_u32, 0, 1, 40, 0, 12][i];
    for i in 0..6 {
        match weight(i) {
            0 => assert_eq!(Chain::new(i, weight), Err(Error::NotPositive(1))),
            w => assert_eq!(
                Chain::new(i, weight).map(|c| (c.state(), c.density())),
                Ok((i, w))
            ),
        }
    }
    let (any, mut rng) = (UniformIndex::new(6).unwrap(), Pcg32::new(1, 1));
    let found = Chain::search(weight, &any, 1000, &mut rng).unwrap();
    assert!(weight(found.state()) > 0 && found.density() == weight(found.state()));
    let nowhere = Chain::search(|_: usize| 0_u32, &any, 9, &mut rng);
    assert_eq!(nowhere.err(), Some(Failure::BudgetSpent { tries: 9 }));
}

/// A ratio passes through a mixture, and what is none stays none.
#[test]
fn a_mixture_refuses_what_its_parts_refuse() {
    for (ratio, outcome, acceptance) in [
        (HastingsRatio::new(0.0, 1.0), Outcome::Refused, 0.0),
        (HastingsRatio::new(1.0, 0.0), Outcome::Rejected, 0.0),
        (HastingsRatio::new(4.0, 1.0), Outcome::Rejected, 0.25),
        (HastingsRatio::ONE, Outcome::Accepted, 1.0),
    ] {
        let mixture = Mixture::new((given(1, Symmetric), given(1, ratio)), &[0.0, 1.0]).unwrap();
        let mut chain = Chain::new(0, |_| 1.0_f32).unwrap();
        let step = chain.step(|_| 1.0, &mixture, &mut Cycle::new(&[5, u32::MAX]));
        assert_eq!(
            (step.outcome, step.acceptance, step.kind),
            (outcome, acceptance, 1)
        );
    }
}

#[test]
fn an_index_out_of_range_has_no_probability() {
    let any = UniformIndex::new(5).unwrap();
    for state in 0..8 {
        let inside = state < 5;
        assert_eq!(any.pdf_of_state(state), if inside { 0.2 } else { 0.0 });
        let count = inside.into();
        assert_eq!(any.ratio_of_states(4, state), HastingsCounts::new(count, 1));
        assert_eq!(any.ratio_of_states(state, 0), HastingsCounts::new(1, count));
    }
}

/// In a chain of densities, counts are the ratio that they are in floating point, to the last bit.
#[test]
fn counts_in_a_chain_of_densities_are_their_ratio() {
    let mut rng = Pcg32::new(6, 6);
    for _ in 0..200_000 {
        let any = |rng: &mut Pcg32| u128::from(rng.next_u64() >> (rng.next_u32() % 64));
        let (forward, backward) = (any(&mut rng), any(&mut rng));
        let counts = HastingsCounts::new(forward, backward);
        let ratio = HastingsRatio::from_counts(forward, backward);
        assert_eq!(counts.ratio(), ratio);
        let (from, to, word) = (positive(&mut rng), positive(&mut rng), rng.next_u32());
        let bits = |s: Transition<usize>| (s.acceptance.to_bits(), s.outcome);
        assert_eq!(
            bits(step(from, to, counts, word)),
            bits(step(from, to, ratio, word))
        );
        let log = |x: f32| LogDensity::<Poly>::new(x.ln());
        assert_eq!(
            step(log(from), log(to), counts, word).acceptance.to_bits(),
            step(log(from), log(to), ratio, word).acceptance.to_bits()
        );
    }
}
