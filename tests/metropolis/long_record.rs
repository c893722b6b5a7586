//! What is kept of a long run, and what must hold of every one.

use crate::densities::parabola;
use microwarp::metropolis::{Chain, Halves, Transition, split_r_hat};

const BATCHES: u64 = 400;

/// Cells of equal width.
pub const CELLS: usize = 32;

fn cell(x: f32) -> usize {
    (x * CELLS as f32) as usize
}

/// Everything about a run that is compared with the truth.
pub struct Record {
    /// Steps after which the chain's density was not that of its state, to the bit.
    pub stale: u64,
    /// Steps after which the state or the density was nothing that it may be.
    pub unsound: u64,
    /// Steps whose two weights did not sum to 1, and the sum of all weights.
    pub uneven: u64,
    pub weights: f64,
    pub moved: u64,
    /// The most steps in a row that stayed.
    pub longest: u32,
    /// Shares in the cells batch by batch, of plain and of weighted states.
    pub shares: [Vec<Vec<f64>>; 2],
    /// Of the proposals of kind 0, by tenths of the run: the count, and the sum of the densities.
    pub large: [(f64, f64); 10],
    pub halves: Halves,
}

impl Record {
    /// Takes the steps on the parabola; `walk` gives each together with the chain after it.
    pub fn of(steps: u64, mut walk: impl FnMut() -> (Transition<f32>, Chain<f32>)) -> Self {
        let mut record = Record {
            stale: 0,
            unsound: 0,
            uneven: 0,
            weights: 0.0,
            moved: 0,
            longest: 0,
            shares: [Vec::new(), Vec::new()],
            large: [(0.0, 0.0); 10],
            halves: Halves::new(steps / 2),
        };
        let batch = steps / BATCHES;
        let mut in_a_row = 0;
        for index in 0..BATCHES {
            let mut counts = [(); 2].map(|()| vec![0.0; CELLS]);
            let tenth = (10 * index / BATCHES) as usize;
            for _ in 0..batch {
                let (step, chain) = walk();
                let (state, density) = (chain.state(), chain.density());
                let fresh = parabola(state).to_bits() == density.to_bits();
                record.stale += u64::from(!fresh);
                let sound = (0.0..1.0).contains(&state) && density > 0.0 && density <= f32::MAX;
                record.unsound += u64::from(!sound);
                in_a_row = if step.is_accepted() { 0 } else { in_a_row + 1 };
                record.longest = record.longest.max(in_a_row);
                record.moved += u64::from(step.is_accepted());
                let [(from, stays), (to, goes)] = step.recorded();
                record.uneven += u64::from(stays + goes != 1.0);
                for (state, weight) in [(from, stays), (to, goes)] {
                    if weight > 0.0 {
                        counts[1][cell(state)] += f64::from(weight);
                        record.weights += f64::from(weight);
                    }
                }
                counts[0][cell(state)] += 1.0;
                if step.kind == 0 {
                    record.large[tenth].0 += 1.0;
                    record.large[tenth].1 += f64::from(step.proposed_density);
                }
                record.halves.push(state);
            }
            for (shares, counts) in record.shares.iter_mut().zip(counts) {
                shares.push(counts.iter().map(|c| c / batch as f64).collect());
            }
        }
        record
    }
}

/// What must hold for every record, whatever the target.
pub fn assert_sound(record: &Record, chain: &Chain<f32>, steps: u64) {
    assert_eq!((record.stale, record.unsound, record.uneven), (0, 0, 0));
    assert_eq!((chain.steps(), chain.accepted()), (steps, record.moved));
    assert_eq!(chain.refused(), 0);
    // Each pair sums to 1 as f32; before that sum is rounded, it is off by 2⁻²⁵ at most.
    let off = (record.weights / steps as f64 - 1.0).abs();
    assert!(off <= 2_f64.powi(-25), "{off}");
    // V/W of two halves is about their time over their length: 1e-6 for a time of 50.
    let r_hat = f64::from(split_r_hat(&[record.halves]).unwrap());
    println!(
        "weights off by {off:.1e} of the steps, R-hat - 1 = {:.1e}",
        r_hat - 1.0
    );
    assert!((r_hat - 1.0).abs() <= 1e-5, "{r_hat}");
}
