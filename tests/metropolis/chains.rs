//! The chain as a value: what a rejected and a refused step leave, counts, burning in, and what is recorded.

use super::own::{Bits, to};
use host::generators::{Broken, Cycle, Failing};
use microwarp::metropolis::{Chain, Outcome, UniformStep};
use rand_core::Rng as _;
use rand_pcg::Pcg32;

/// Zeros of either sign, subnormals, infinities, quiet and signalling NaN with a payload.
const ODD: [u32; 12] = [
    0,
    0x8000_0000,
    1,
    0x8000_0001,
    0x007f_ffff,
    0x7f80_0000,
    0xff80_0000,
    0x7fc0_0000,
    0x7fc1_2345,
    0xffed_cba9,
    0x7f80_0001,
    0xffa5_5aa5,
];

#[test]
fn a_rejected_or_refused_step_leaves_no_trace_in_the_state() {
    let mut seen = 0;
    for (i, a) in ODD.into_iter().enumerate() {
        for b in ODD {
            let start = [a, b, ODD[(i + 5) % 12], 0x3f80_0000].map(f32::from_bits);
            let other = [b, a ^ 0x8000_0000, 0, 7].map(f32::from_bits);
            for (proposed, outcome) in [
                (0.0, Outcome::Rejected),
                (-0.0, Outcome::Rejected),
                (1e-45, Outcome::Rejected),
                (1.5, Outcome::Rejected),
                (f32::NAN, Outcome::Refused),
                (f32::INFINITY, Outcome::Refused),
                (-1.0, Outcome::Refused),
                (3.0, Outcome::Accepted),
            ] {
                let mut chain = Chain::new(start, |_| 3.0).unwrap();
                let step = chain.step(|_| proposed, &to(other), &mut Cycle::new(&[u32::MAX]));
                assert_eq!(step.outcome, outcome);
                let (state, density) = match outcome {
                    Outcome::Accepted => (other, proposed),
                    _ => (start, 3.0),
                };
                assert_eq!(chain.state().bits(), state.bits());
                assert_eq!(step.state().bits(), state.bits());
                assert_eq!(step.from.bits(), start.bits());
                assert_eq!(step.proposed.bits(), other.bits());
                assert_eq!(chain.density().to_bits(), f32::to_bits(density));
                assert_eq!(step.density().to_bits(), density.to_bits());
                seen += 1;
            }
        }
    }
    assert_eq!(seen, 12 * 12 * 8);
}

/// A density with holes in it: zeros, and places where it is none.
fn holes(x: f32) -> f32 {
    match (x * 16.0) as u32 % 8 {
        0 => 0.0,
        1 => f32::NAN,
        2 => -1.0,
        3 => f32::INFINITY,
        _ => x * x,
    }
}

#[test]
fn counts_are_those_of_the_outcomes() {
    let mut rng = Pcg32::new(5, 5);
    let mut chain = Chain::new(0.3, holes).unwrap();
    assert_eq!(chain.acceptance_rate(), None);
    let (mut of, mut in_a_row) = ([0_u64; 4], 0);
    for steps in 1..=10_000 {
        let before = chain;
        let step = chain.step(holes, &UniformStep::new(), &mut rng);
        of[step.outcome as usize] += 1;
        in_a_row = if step.is_accepted() { 0 } else { in_a_row + 1 };
        assert_eq!(
            (step.from, step.from_density),
            (before.state(), before.density())
        );
        assert_eq!(
            step.proposed_density.to_bits(),
            holes(step.proposed).to_bits()
        );
        assert_eq!(
            (chain.state(), chain.density()),
            (step.state(), step.density())
        );
        assert_eq!(chain.density(), holes(chain.state()));
        assert_eq!(chain.steps(), steps);
        assert_eq!(chain.accepted(), of[Outcome::Accepted as usize]);
        assert_eq!(chain.refused(), of[Outcome::Refused as usize]);
        assert_eq!(chain.rejected_in_a_row(), in_a_row);
        let rate = chain.accepted() as f64 / chain.steps() as f64;
        // Both counts and the quotient are rounded.
        let off = f64::from(chain.acceptance_rate().unwrap()) - rate;
        assert!(off.abs() <= 3.0 * 2_f64.powi(-24) * rate);
    }
    assert!(of[0].min(of[1]).min(of[2]) > 1000 && of[3] == 0, "{of:?}");
}

#[test]
fn a_burn_in_takes_its_steps_and_forgets_them() {
    let mutation = UniformStep::new();
    for steps in [0, 1, 7, 1000] {
        let (mut rng, mut again) = (Pcg32::new(6, 6), Pcg32::new(6, 6));
        let mut chain = Chain::new(0.3, holes).unwrap();
        chain.step(holes, &mutation, &mut rng);
        let mut other = Chain::new(0.3, holes).unwrap();
        other.step(holes, &mutation, &mut again);
        chain.burn_in(holes, &mutation, steps, &mut rng);
        for _ in 0..steps {
            other.step(holes, &mutation, &mut again);
        }
        assert_eq!(rng, again);
        assert_ne!(chain, other);
        other.reset_counts();
        assert_eq!(chain, other);
        assert_eq!(
            (
                chain.steps(),
                chain.accepted(),
                chain.refused(),
                chain.rejected_in_a_row()
            ),
            (0, 0, 0, 0)
        );
        assert_eq!(chain.acceptance_rate(), None);
    }
    // Where the generator fails, the steps before are taken and counted.
    for left in 0..20 {
        let mut chain = Chain::new(0.3, holes).unwrap();
        let mut failing = Failing {
            word: 1 << 31,
            left,
        };
        let end = chain.try_burn_in(holes, &mutation, 10, &mut failing);
        assert_eq!(end, Err(Broken(17)));
        assert_eq!(chain.steps(), left / 2);
    }
}

#[test]
fn recorded_weights_sum_to_1() {
    let (mut rng, mut worst) = (Pcg32::new(7, 7), 0.0_f64);
    let mut record = |from: f32, density: f32| -> [f32; 2] {
        let mut chain = Chain::new(0, |_| from).unwrap();
        let step = chain.step(|_| density, &to(1), &mut Cycle::new(&[0]));
        let [(first, stays), (second, goes)] = step.recorded();
        assert_eq!(
            (first, second, goes.to_bits()),
            (0, 1, step.acceptance.to_bits())
        );
        assert!(stays >= 0.0 && goes >= 0.0);
        assert_eq!(stays + goes, 1.0);
        worst = worst.max((f64::from(stays) + f64::from(goes) - 1.0).abs());
        [stays, goes]
    };
    for _ in 0..2_000_000 {
        let a = (f64::from(rng.next_u32()) * 2_f64.powi(-32 - (rng.next_u32() % 40) as i32)) as f32;
        record(1.0, a.max(1e-45));
        record(rng.next_u32() as f32 + 1.0, rng.next_u32() as f32 + 1.0);
    }
    assert_eq!(record(1.0, 0.0), [1.0, 0.0]);
    assert_eq!(record(1.0, f32::NAN), [1.0, 0.0]);
    assert_eq!(record(1.0, 2.0), [0.0, 1.0]);
    println!("recorded weights: 1 to {:.3} 2^-25", worst * 2_f64.powi(25));
    assert!(worst <= 2_f64.powi(-25) && worst > 0.9 * 2_f64.powi(-25));
}
