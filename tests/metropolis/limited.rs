//! What a limit of rejections does to a chain, exactly: the chain of state and rejections in a row, whose
//! transitions are counted over all words of the real step.

use super::enumeration::runs;
use super::known::{Matrix, stationary, table};
use super::own::neighbour;
use host::generators::Cycle;
use host::speed;
use microwarp::metropolis::{Chain, Mutation, Outcome, Saved, UniformIndex};
use std::num::NonZeroU32;

/// A chain with a limit, expanded: place x (limit + 1) + r for state x after r rejections.
struct Expanded {
    limit: usize,
    states: usize,
    matrix: Matrix,
    /// How often a step from each state would go elsewhere, stay by a rejection, and stay by a proposal of
    /// itself, without a limit.
    shares: Vec<[f64; 3]>,
}

/// 2^64 proposals by 2^32 decisions.
const ALL: u128 = 1 << 96;

fn expanded<M: Mutation<usize>>(f: &[f32], mutation: &M, bits: u32, limit: usize) -> Expanded {
    let cap = NonZeroU32::new(limit as u32).unwrap();
    let step = |state: usize, rejected: usize, word: u64, decision: u64| {
        let saved = Saved {
            state,
            density: f[state],
            steps: 1000,
            accepted: 0,
            refused: 0,
            rejected_in_a_row: rejected as u32,
        };
        let mut chain = Chain::resume(saved).unwrap();
        let words = match bits {
            64 => vec![(word >> 32) as u32, word as u32, decision as u32],
            _ => vec![word as u32, decision as u32],
        };
        let step = chain.step_limited(|i: usize| f[i], mutation, cap, &mut Cycle::new(&words));
        let rejected = chain.rejected_in_a_row() as usize;
        (step.proposed, chain.state(), rejected, step.outcome)
    };
    let (states, depth) = (f.len(), limit + 1);
    let mut matrix = vec![vec![0.0; states * depth]; states * depth];
    let mut shares = vec![[0.0; 3]; states];
    for state in (0..states).filter(|i| f[*i] > 0.0) {
        for rejected in 0..depth {
            let mut total = 0;
            let last = u64::MAX >> (64 - bits);
            let both = |word: u64| [0, u32::MAX].map(|d| step(state, rejected, word, d.into()));
            for (_, first, last) in runs(0, last, &both) {
                let words = (u128::from(last - first) + 1) << (64 - bits);
                let decisions = runs(0, u32::MAX.into(), &|d| step(state, rejected, first, d));
                for ((proposed, to, then, outcome), first, last) in decisions {
                    let count = words * u128::from(last - first + 1);
                    total += count;
                    let share = count as f64 / ALL as f64;
                    // A proposal of density 0 may go beyond the limit, where nothing changes any more.
                    let place = to * depth + then.min(limit);
                    matrix[state * depth + rejected][place] += share;
                    assert_eq!(outcome == Outcome::Rejected, then == rejected + 1);
                    assert!(outcome != Outcome::Forced || rejected == limit);
                    assert!(then <= limit || f[proposed] == 0.0);
                    if rejected == 0 {
                        let what = match outcome {
                            Outcome::Rejected => 1,
                            _ if proposed == state => 2,
                            _ => 0,
                        };
                        shares[state][what] += share;
                    }
                }
            }
            assert_eq!(total, ALL);
        }
    }
    // States of density 0 are never entered; they only must not be a matrix of zeros.
    for place in (0..states * depth).filter(|p| f[p / depth] == 0.0) {
        matrix[place][0] = 1.0;
    }
    Expanded {
        limit,
        states,
        matrix,
        shares,
    }
}

impl Expanded {
    /// The time spent in each state, and the mean time of a stay there over what it would be without a limit.
    fn time_and_stays(&self) -> (Vec<f64>, Vec<f64>) {
        let (pi, depth) = (stationary(&self.matrix), self.limit + 1);
        let places = |x: usize| x * depth..(x + 1) * depth;
        let time = |x: usize| places(x).map(|p| pi[p]).sum::<f64>();
        let left = |x: usize| -> f64 {
            let inside = |p: usize| places(x).map(|q| self.matrix[p][q]).sum::<f64>();
            places(x).map(|p| pi[p] * (1.0 - inside(p))).sum()
        };
        let stay = |x: usize| time(x) / left(x) * self.shares[x][0];
        (
            (0..self.states).map(time).collect(),
            (0..self.states).map(stay).collect(),
        )
    }

    /// What the documentation states, of a state where nothing but others of positive density is proposed.
    fn stated(&self, x: usize) -> f64 {
        1.0 - (1.0 - self.shares[x][0]).powi(self.limit as i32 + 1)
    }

    /// The same where x itself may be proposed, and begins the count anew: A(1 − q)/(A + Sq) with
    /// q = R^(limit + 1), from the mean time E of a stay, E = (1 + SE)(1 + R + … + R^limit).
    fn with_itself(&self, x: usize) -> f64 {
        let [a, r, s] = self.shares[x];
        let q = r.powi(self.limit as i32 + 1);
        a * (1.0 - q) / (a + s * q)
    }
}

/// The longest takes as long as all others.
fn limits() -> &'static [usize] {
    &[1, 2, 3, 10, 30, 60][..speed::of("limits", 5, 6)]
}

const F: [f32; 2] = [9.0, 1.0];

#[test]
fn a_limit_cuts_stays_as_stated() {
    let mut worst = 0.0_f64;
    for &limit in limits() {
        let swap = expanded(&F, &table([[0.0, 1.0], [1.0, 0.0]]), 32, limit);
        let ring = expanded(&[3.0, 0.5, 7.25, 1.0, 0.01], &neighbour(5), 32, limit);
        for chain in [&swap, &ring] {
            let (_, stays) = chain.time_and_stays();
            for (x, stay) in stays.into_iter().enumerate() {
                worst = worst.max((stay / chain.stated(x) - 1.0).abs());
                assert!((stay / chain.stated(x) - 1.0).abs() <= 1e-10, "{limit} {x}");
            }
        }
        // Of two states each is left for the other, so times are as the stays: here 1/A and 1.
        let (time, _) = swap.time_and_stays();
        let odds = swap.stated(0) / swap.shares[0][0];
        println!(
            "limit {limit}: of f = (9, 1), {:.6} of the time in the first",
            time[0]
        );
        assert!((time[0] / time[1] / odds - 1.0).abs() <= 1e-10);
        // Without a limit it would be 9/10; the statement is not one about nothing.
        assert!(limit > 30 || time[0] < 0.9 * (1.0 - 1e-3));
    }
    println!("largest relative difference from what is stated: {worst:.1e}");
}

#[test]
fn a_proposal_of_the_state_itself_or_of_density_0_keeps_it_longer() {
    for &limit in limits() {
        let own = expanded(&F, &UniformIndex::new(2).unwrap(), 64, limit);
        let (time, stays) = own.time_and_stays();
        println!(
            "limit {limit}: keeps {:.6} of a stay, {:.6} if it were never proposed itself; {:.6} of the time",
            stays[0],
            own.stated(0),
            time[0]
        );
        assert!((stays[0] / own.with_itself(0) - 1.0).abs() <= 1e-10);
        assert!(stays[0] > own.stated(0) * (1.0 + 1e-3) || limit > 30);
        // The other state is left by every proposal that is not itself: nothing is ever forced.
        assert!((stays[1] - 1.0).abs() <= 1e-10);

        let gap = expanded(&[9.0, 1.0, 0.0, 2.0], &neighbour(4), 32, limit);
        let (_, stays) = gap.time_and_stays();
        for x in [1, 3] {
            assert!(stays[x] >= gap.stated(x) * (1.0 - 1e-10), "{limit} {x}");
        }
        assert!(stays[1] > gap.stated(1) * (1.0 + 1e-6) || limit > 10);
    }
}

/// A peak that is left with probability A well below 1/limit is cut to (limit + 1) A of itself.
#[test]
fn a_peak_is_cut_to_about_the_limit() {
    for (peak, limit) in [(1e6_f32, 10), (1e5, 60), (1e8, 1)] {
        let chain = expanded(&[peak, 1.0], &table([[0.0, 1.0], [1.0, 0.0]]), 32, limit);
        let (time, _) = chain.time_and_stays();
        let f = time[0] / time[1];
        let about = (limit + 1) as f64 * chain.shares[0][0] * f64::from(peak);
        println!("limit {limit}: a peak of {peak:e} counts as one of {f:.4}, about {about:.4}");
        // What the next order adds, and half a step of the decision in A.
        let next = limit as f64 * chain.shares[0][0] + 2_f64.powi(-33) * f64::from(peak);
        assert!((f / about - 1.0).abs() <= next, "{next}");
    }
}

/// With a limit far beyond 1/A nothing is left of the bias.
#[test]
fn a_limit_far_off_does_not_bias() {
    // A peak is left with probability A = 1/9, or 1/3.
    let (peak, limit) = speed::of("peak, limit", (3.0, 60), (9.0_f32, 200));
    let chain = expanded(&[peak, 1.0], &table([[0.0, 1.0], [1.0, 0.0]]), 32, limit);
    let (time, stays) = chain.time_and_stays();
    let exact = f64::from(peak) / (f64::from(peak) + 1.0);
    assert!(1.0 - stays[0] <= 1e-10 && (time[0] - exact).abs() <= 1e-8);
}
