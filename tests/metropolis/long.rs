//! A hundred million steps: nothing drifts, nothing sticks, nothing is lost.

use crate::densities::parabola;
use crate::targets::{FAMILY, hotelling};
use host::{speed, stats};
use microwarp::metropolis::{
    BoxStep, Chain, Halves, LargeSmall, Mixture, Saved, Transition, WrappedWalk, split_r_hat,
};
use rand_pcg::Pcg32;

/// The steps of the full form.
const FULL: u64 = 100_000_000;

fn steps() -> u64 {
    speed::of("steps", 4_000_000, FULL)
}

/// How much farther off than in the full form a control has to be, to be seen as well.
fn farther() -> f64 {
    (FULL as f64 / steps() as f64).sqrt()
}

/// The probabilities of 32 cells of equal width, of (x − c)².
fn probabilities(c: f64) -> Vec<f64> {
    let below = |i: usize| (i as f64 / CELLS as f64 - c).powi(3);
    let all = below(CELLS) - below(0);
    (0..CELLS)
        .map(|i| (below(i + 1) - below(i)) / all)
        .collect()
}

fn mutation() -> LargeSmall<WrappedWalk<BoxStep<f32>>> {
    Mixture::large_small(0.1, WrappedWalk::new(BoxStep::new(0.1).unwrap())).unwrap()
}

/// The probability to stay at x, by the midpoint rule.
fn staying(x: f64) -> f64 {
    let square = |x: f64| (x - 0.5) * (x - 0.5);
    let nodes = |count: usize| (0..count).map(move |i| (i as f64 + 0.5) / count as f64);
    let accepted = |y: f64| (square(y) / square(x)).min(1.0);
    let large = nodes(500).map(accepted).sum::<f64>() / 500.0;
    let small = nodes(500).map(|t| accepted((x + 0.1 * (t - 0.5)).rem_euclid(1.0)));
    1.0 - 0.1 * large - 0.9 * small.sum::<f64>() / 500.0
}

/// Lengths that the longest stay can hardly fall short of, nor exceed.
fn plausible_stays(steps: u64) -> std::ops::RangeInclusive<u32> {
    let places = (0..400).map(|i| (f64::from(i) + 0.5) / 400.0);
    let stays: Vec<[f64; 2]> = places
        .map(|x| [3.0 * (2.0 * x - 1.0).powi(2) / 400.0, staying(x)])
        .collect();
    // How many stays of a length are expected, each begun by a move; and at most, wherever the chain is.
    let expected = |length: i32| -> f64 {
        let terms = stays.iter().map(|[p, r]| p * (1.0 - r) * r.powi(length));
        steps as f64 * terms.sum::<f64>()
    };
    let worst = stays.iter().map(|s| s[1]).fold(staying(0.0), f64::max);
    let least = (1..).take_while(|l| expected(*l) > 100.0).last().unwrap();
    let most = (1..)
        .find(|l| steps as f64 * worst.powi(*l) < 1e-9)
        .unwrap();
    least as u32..=most as u32
}

#[test]
fn a_hundred_million_steps_leave_the_chain_as_it_should_be() {
    let mut rng = Pcg32::new(8, 8);
    let mut chain = Chain::new(0.1, parabola).unwrap();
    chain.burn_in(parabola, &mutation(), 10_000, &mut rng);
    let mutation = mutation();
    let steps = steps();
    let record = Record::of(steps, || {
        let step = chain.step(parabola, &mutation, &mut rng);
        (step, chain)
    });
    assert_sound(&record, &chain, steps);
    let plausible = plausible_stays(steps);
    println!("longest stay {}, plausible {plausible:?}", record.longest);
    assert!(plausible.contains(&record.longest));
    for (way, shares) in ["plain", "weighted"].into_iter().zip(&record.shares) {
        FAMILY.assert_passes(way, &[hotelling(shares, &probabilities(0.5))]);
        let other = probabilities(0.5 + 0.001 * farther());
        FAMILY.assert_rejected("off by 0.001", &[hotelling(shares, &other)]);
    }
    // Of uniform x, (x − ½)² has the mean 1/12 and the variance 1/80 − 1/144.
    let (mean, variance) = (1.0 / 12.0, 1.0 / 80.0 - 1.0 / 144.0);
    let z = |(count, sum): (f64, f64)| (sum / count - mean) / (variance / count).sqrt();
    let [first, last] = [record.large[0], record.large[9]];
    let all = record
        .large
        .iter()
        .fold((0.0, 0.0), |a, b| (a.0 + b.0, a.1 + b.1));
    let drift = |first: (f64, f64), last: (f64, f64)| (z(last) - z(first)) / 2_f64.sqrt();
    let [a, b, c] = [first, last, all].map(|x| x.1 / x.0);
    println!("integral {a:.7} at first, {b:.7} at last, {c:.7} in all, exact {mean:.7}");
    let z_values = [z(first), z(last), drift(first, last), z(all)];
    FAMILY.assert_passes("normalisation", &z_values.map(stats::two_sided));
    // The control: densities that grow by 1 % in the end, 1e-10 a step of the full form.
    let grown = (last.0, last.1 * (1.0 + 0.95 * 0.01 * farther()));
    FAMILY.assert_rejected("a drift", &[stats::two_sided(drift(first, grown))]);
}

/// The control of the record: a cached density that drifts by one place a step is seen.
#[test]
fn a_density_that_drifts_is_noticed() {
    let mut rng = Pcg32::new(9, 9);
    let mut chain = Chain::new(0.1, parabola).unwrap();
    let mutation = mutation();
    let steps = 40_000;
    let record = Record::of(steps, || {
        let step = chain.step(parabola, &mutation, &mut rng);
        let saved = chain.save();
        let density = saved.density * (1.0 + f32::EPSILON);
        chain = Chain::resume(Saved { density, ..saved }).unwrap();
        (step, chain)
    });
    println!("drifting: {} of {steps} steps stale", record.stale);
    assert!(record.stale > steps / 2);
    // A chain that is stuck is one whose stays are beyond what is plausible.
    let mut stuck = Chain::resume(Saved {
        density: 1e30,
        ..chain.save()
    })
    .unwrap();
    let record = Record::of(steps, || {
        let step = stuck.step(parabola, &mutation, &mut rng);
        (step, stuck)
    });
    assert!(!plausible_stays(FULL).contains(&record.longest));
}

// What is kept of a long run, and what must hold of every one.

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
