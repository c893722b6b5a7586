//! The chain: where it is, what it counts, and how it is kept.

use super::target_value::TargetValue;
use crate::error::Error;

/// A Markov chain with a given stationary density, by the rule of Metropolis and Hastings.
///
/// At x, a mutation proposes x′, and with probability a = min(1, f(x′)T(x′→x)/(f(x)T(x→x′))) the chain goes
/// there; otherwise it stays, to the last bit. The target f and the mutation are handed to each step: the
/// chain itself is a plain value: one state, one density, three counts of 64 bits and one of 32. A [`Transition`](super::Transition)
/// has two states and two densities.
///
/// | bytes, of states that are | `f32` | `[f32; 2]` | `[f32; 32]` | `usize` of 64 bits |
/// |---|--:|--:|--:|--:|
/// | [`Chain`], [`Saved`] | 40 | 40 | 160 | 40 |
/// | [`Transition`](super::Transition) | 28 | 36 | 276 | 40 |
/// | of integer weights | 40 | 48 | 288 | 48 |
///
/// - States: any `Copy` type: an index, a point of ℝᴰ, the uniforms of a warp.
/// - Densities: `f32`, or [`LogDensity`](super::LogDensity), known up to a factor. Any positive finite ones
///   may meet in one chain: nothing over- or underflows on the way to the acceptance. Or integer weights, `u32`:
///   then the acceptance is exact, a [`Chance`](super::Chance), and no floating-point operation takes place.
/// - Words (`u32`) a step: those of the mutation and one more, which is drawn whether it decides or not.
/// - Error of the acceptance: half an ulp at a symmetric mutation, 2 ulp at one with a
///   [`HastingsRatio`](super::HastingsRatio); of logarithms, see [`LogDensity`](super::LogDensity). It is realised in steps
///   of 2⁻³², to the nearest: a proposal of an acceptance below 2⁻³³ is never taken. (In [`Transition::recorded`](super::Transition::recorded) it
///   counts all the same.)
/// - A proposal whose density is NaN, infinite or negative is never accepted; it counts in
///   [`Chain::refused`].
///
/// Sources: N. Metropolis, A. W. Rosenbluth, M. N. Rosenbluth, A. H. Teller, E. Teller, "Equation of State
/// Calculations by Fast Computing Machines", 1953; W. K. Hastings, "Monte Carlo Sampling Methods Using Markov
/// Chains and Their Applications", 1970.
///
/// ```
/// use microwarp::metropolis::{BoxStep, Chain, Mixture, UniformStep, WrappedWalk};
/// use rand_pcg::Pcg32;
///
/// // Two humps at the ends of [0, 1). Small steps alone would hardly cross the valley.
/// let f = |x: f32| (x - 0.5) * (x - 0.5);
/// let small = WrappedWalk::new(BoxStep::new(0.1)?);
/// let mutation = Mixture::new((small, UniformStep::new()), &[0.9, 0.1])?;
///
/// let mut rng = Pcg32::new(42, 54);
/// let mut chain = Chain::new(0.1, f)?;
/// chain.burn_in(f, &mutation, 1000, &mut rng);
/// let mut right = 0.0;
/// for _ in 0..10_000 {
///     for (x, weight) in chain.step(f, &mutation, &mut rng).recorded() {
///         right += if x < 0.5 { 0.0 } else { weight };
///     }
/// }
/// assert!((right / 10_000.0 - 0.5).abs() < 0.1);
/// # Ok::<(), microwarp::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Chain<X, D = f32> {
    at: Saved<X, D>,
}

impl<X: Copy, D: TargetValue> Chain<X, D> {
    /// A chain that starts at a state of one's own.
    ///
    /// # Errors
    /// [`Error::NotPositive`] if the density is 0 there, [`Error::Negative`] and [`Error::NotFinite`] if it
    /// is no density. Where no state of positive density is known, [`Chain::search`] looks for one.
    #[inline]
    pub fn new(start: X, target: impl FnOnce(X) -> D) -> Result<Self, Error> {
        let density = target(start);
        density.positive()?;
        Ok(Self::at(start, density))
    }

    /// A chain at a state of this density, which must be positive.
    #[inline]
    pub(super) const fn at(state: X, density: D) -> Self {
        let at = Saved {
            state,
            density,
            steps: 0,
            accepted: 0,
            refused: 0,
            rejected_in_a_row: 0,
        };
        Self { at }
    }

    /// The chain is at the proposed state.
    #[inline]
    pub(super) const fn moved(&mut self, state: X, density: D) {
        self.at.state = state;
        self.at.density = density;
        self.at.steps = self.at.steps.saturating_add(1);
        self.at.accepted = self.at.accepted.saturating_add(1);
        self.at.rejected_in_a_row = 0;
    }

    /// The chain is where it was.
    #[inline]
    pub(super) fn stayed(&mut self, refused: bool) {
        self.at.steps = self.at.steps.saturating_add(1);
        self.at.refused = self.at.refused.saturating_add(u64::from(refused));
        self.at.rejected_in_a_row = self.at.rejected_in_a_row.saturating_add(1);
    }

    /// Sets all counts to 0, the rejections in a row included.
    #[inline]
    pub const fn reset_counts(&mut self) {
        self.at.steps = 0;
        self.at.accepted = 0;
        self.at.refused = 0;
        self.at.rejected_in_a_row = 0;
    }

    /// Where the chain is.
    #[must_use]
    #[inline]
    pub const fn state(&self) -> X {
        self.at.state
    }

    /// The density there, as the target gave it.
    #[must_use]
    #[inline]
    pub const fn density(&self) -> D {
        self.at.density
    }

    /// The steps taken since the start or the end of the burn-in.
    #[must_use]
    #[inline]
    pub const fn steps(&self) -> u64 {
        self.at.steps
    }

    /// How many of them went to the proposed state, forced ones included.
    #[must_use]
    #[inline]
    pub const fn accepted(&self) -> u64 {
        self.at.accepted
    }

    /// How many proposals were refused because their density was NaN, infinite or negative, or their ratio
    /// none.
    #[must_use]
    #[inline]
    pub const fn refused(&self) -> u64 {
        self.at.refused
    }

    /// How many steps in a row, the last one included, have stayed where they were.
    #[must_use]
    #[inline]
    pub const fn rejected_in_a_row(&self) -> u32 {
        self.at.rejected_in_a_row
    }

    /// The share of steps that went to the proposed state; [`None`] before the first.
    #[must_use]
    #[inline]
    pub fn acceptance_rate(&self) -> Option<f32> {
        (self.at.steps > 0).then(|| self.at.accepted as f32 / self.at.steps as f32)
    }

    /// The chain as plain numbers.
    #[must_use]
    #[inline]
    pub const fn save(&self) -> Saved<X, D> {
        self.at
    }

    /// A chain out of the numbers of a saved one. The density is taken as it was saved, without asking the
    /// target.
    ///
    /// # Errors
    /// Those of [`Chain::new`] for the density; [`Error::OutOfRange`] for more accepted steps than steps, and
    /// for more that are refused, or that stayed in a row, than the others.
    #[inline]
    pub fn resume(saved: Saved<X, D>) -> Result<Self, Error> {
        let Some(stayed) = saved.steps.checked_sub(saved.accepted) else {
            return Err(Error::OutOfRange);
        };
        if saved.refused > stayed || u64::from(saved.rejected_in_a_row) > stayed {
            return Err(Error::OutOfRange);
        }
        saved.density.positive()?;
        Ok(Self { at: saved })
    }
}

/// All that a chain is, as plain numbers: to be kept in flash or sent over a wire, and made a chain again.
///
/// A chain that is saved and resumed continues bit for bit, if the generator is kept too.
///
/// ```
/// use microwarp::metropolis::{Chain, Saved, UniformStep};
/// use rand_pcg::Pcg32;
/// let f = |[x, y]: [f32; 2]| x + y;
/// let mut rng = Pcg32::new(1, 1);
/// let mut chain = Chain::new([0.5, 0.25], f)?;
/// chain.step(f, &UniformStep::new(), &mut rng);
///
/// // Into storage of one's own, number by number, and back.
/// let saved = chain.save();
/// let words = [saved.state[0], saved.state[1], saved.density].map(f32::to_bits);
/// let [x, y, density] = words.map(f32::from_bits);
/// let again = Chain::resume(Saved { state: [x, y], density, ..saved })?;
/// assert_eq!(again, chain);
/// # Ok::<(), microwarp::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Saved<X, D = f32> {
    /// Where the chain is.
    pub state: X,
    /// The density there, positive.
    pub density: D,
    /// The steps taken since the start or the end of the burn-in.
    pub steps: u64,
    /// How many of them went to the proposed state, forced ones included.
    pub accepted: u64,
    /// How many proposals were refused.
    pub refused: u64,
    /// How many steps in a row, the last one included, have stayed; it saturates.
    pub rejected_in_a_row: u32,
}
