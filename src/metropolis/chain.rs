//! The chain: its state, its counts, and how to save it.

use super::target_value::TargetValue;
use crate::error::Error;

/// A Markov chain with a given stationary density: the Metropolis–Hastings algorithm (MCMC).
///
/// At x, a mutation proposes x′. With probability a = min(1, f(x′)T(x′→x)/(f(x)T(x→x′))) the chain moves there;
/// otherwise its state stays as it is, to the last bit. Each step is handed the target f and the mutation. The chain
/// itself is a plain value: one state, one density, three counts of 64 bits and one of 32.
///
/// # Domain
///
/// - States: any `Copy` type, such as an index, a point of ℝᴰ, or the uniforms of a warp.
/// - Targets return an `f32` or a [`LogDensity`](super::LogDensity), known up to a factor. The ratio of any two
///   positive finite densities is formed without overflow or underflow. Or they return integer weights, `u32`: then the
///   acceptance is exact, a [`Chance`](super::Chance), and no floating-point operation takes place.
/// - A proposal whose density is NaN, infinite or negative is never accepted. [`Chain::refused`] counts it.
/// - Words (`u32`) a step: those of the mutation, and one more, which is drawn even where it does not decide.
///
/// # Accuracy
///
/// The acceptance is within half an ulp (a unit in the last place) for a symmetric mutation, and within 2.5 ulp for one
/// with a [`HastingsRatio`](super::HastingsRatio). For logarithms, see [`LogDensity`](super::LogDensity). It is realised
/// in steps of 2⁻³², to the nearest: a proposal with an acceptance below 2⁻³³ is never taken, although
/// [`Transition::recorded`](super::Transition::recorded) still counts it.
///
/// # Cost
///
/// | bytes, of states that are | `f32` | `[f32; 2]` | `[f32; 32]` | `usize` of 64 bits |
/// |---|--:|--:|--:|--:|
/// | [`Chain`], [`Saved`] | 40 | 40 | 160 | 40 |
/// | [`Transition`](super::Transition) | 28 | 36 | 276 | 40 |
/// | of integer weights | 40 | 48 | 288 | 48 |
///
/// # Examples
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
///
/// # See also
///
/// - [The list of mutations](crate::metropolis#which-mutation), to choose what the chain proposes.
/// - [`primary_density`](super::primary_density), to drive a warp with a chain.
/// - [`Autocorrelation`](super::Autocorrelation) and [`split_r_hat`](super::split_r_hat()), to judge a run.
///
/// # Source
///
/// N. Metropolis, A. W. Rosenbluth, M. N. Rosenbluth, A. H. Teller, E. Teller, "Equation of State Calculations by Fast
/// Computing Machines", 1953, [doi:10.1063/1.1699114](https://doi.org/10.1063/1.1699114); W. K. Hastings, "Monte Carlo
/// Sampling Methods Using Markov Chains and Their Applications", 1970,
/// [doi:10.1093/biomet/57.1.97](https://doi.org/10.1093/biomet/57.1.97).
#[doc(alias = "metropolis_hastings")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Chain<X, D = f32> {
    at: Saved<X, D>,
}

impl<X: Copy, D: TargetValue> Chain<X, D> {
    /// A chain that starts at this state.
    ///
    /// Where you know no state of positive density, let [`Chain::search`] look for one.
    ///
    /// # Errors
    /// [`Error::NotPositive`] if the density there is 0, [`Error::Negative`] and [`Error::NotFinite`] if it is not a density.
    #[inline]
    pub fn new(start: X, target: impl FnOnce(X) -> D) -> Result<Self, Error> {
        let density = target(start);
        density.positive(1)?;
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

    /// Sets all counts to 0, including the rejections in a row.
    #[inline]
    pub const fn reset_counts(&mut self) {
        self.at.steps = 0;
        self.at.accepted = 0;
        self.at.refused = 0;
        self.at.rejected_in_a_row = 0;
    }

    /// The current state.
    #[must_use]
    #[inline]
    pub const fn state(&self) -> X {
        self.at.state
    }

    /// The density of the current state, as the target returned it.
    #[must_use]
    #[inline]
    pub const fn density(&self) -> D {
        self.at.density
    }

    /// How many steps the chain has taken since its start or the end of its burn-in.
    #[must_use]
    #[inline]
    pub const fn steps(&self) -> u64 {
        self.at.steps
    }

    /// How many steps moved to the proposed state, including forced ones.
    #[must_use]
    #[inline]
    pub const fn accepted(&self) -> u64 {
        self.at.accepted
    }

    /// How many proposals were refused: their density was NaN, infinite or negative, or their Hastings ratio was not valid.
    #[must_use]
    #[inline]
    pub const fn refused(&self) -> u64 {
        self.at.refused
    }

    /// How many of the latest steps in a row stayed where they were.
    #[must_use]
    #[inline]
    pub const fn rejected_in_a_row(&self) -> u32 {
        self.at.rejected_in_a_row
    }

    /// The share of steps that moved to the proposed state, or [`None`] before the first step.
    #[must_use]
    #[inline]
    pub fn acceptance_rate(&self) -> Option<f32> {
        (self.at.steps > 0).then(|| self.at.accepted as f32 / self.at.steps as f32)
    }

    /// The chain as plain numbers. [`Chain::resume`] takes them back.
    #[must_use]
    #[inline]
    pub const fn save(&self) -> Saved<X, D> {
        self.at
    }

    /// The chain that was saved as these numbers. The saved density is trusted; the target is not called.
    ///
    /// # Errors
    /// For the density, those of [`Chain::new`]. [`Error::OutOfRange`] if the counts contradict each other: more steps
    /// accepted than taken, or more refused, or rejected in a row, than were not accepted.
    #[inline]
    pub fn resume(saved: Saved<X, D>) -> Result<Self, Error> {
        let Some(stayed) = saved.steps.checked_sub(saved.accepted) else {
            return Err(Error::OutOfRange(0));
        };
        // All of them are counts of the same steps until their number saturates.
        let counted = saved.steps < u64::MAX;
        if counted && (saved.refused > stayed || u64::from(saved.rejected_in_a_row) > stayed) {
            return Err(Error::OutOfRange(0));
        }
        saved.density.positive(0)?;
        Ok(Self { at: saved })
    }
}

/// The state of a [`Chain`] as plain numbers, to keep in flash or send over a wire.
///
/// A chain that is saved and resumed continues bit for bit, as long as you keep the generator's state too.
///
/// # Examples
///
/// ```
/// use microwarp::metropolis::{Chain, Saved, UniformStep};
/// use rand_pcg::Pcg32;
/// let f = |[x, y]: [f32; 2]| x + y;
/// let mut rng = Pcg32::new(1, 1);
/// let mut chain = Chain::new([0.5, 0.25], f)?;
/// chain.step(f, &UniformStep::new(), &mut rng);
///
/// // Save the chain number by number, and restore it.
/// let saved = chain.save();
/// let words = [saved.state[0], saved.state[1], saved.density].map(f32::to_bits);
/// let [x, y, density] = words.map(f32::from_bits);
/// let again = Chain::resume(Saved { state: [x, y], density, ..saved })?;
/// assert_eq!(again, chain);
/// # Ok::<(), microwarp::Error>(())
/// ```
#[doc(alias = "serialize")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Saved<X, D = f32> {
    /// The current state.
    pub state: X,
    /// The density of the current state, positive.
    pub density: D,
    /// How many steps the chain has taken since its start or the end of its burn-in.
    pub steps: u64,
    /// How many steps moved to the proposed state, including forced ones.
    pub accepted: u64,
    /// How many proposals were refused.
    pub refused: u64,
    /// How many of the latest steps in a row stayed where they were; it saturates.
    pub rejected_in_a_row: u32,
}
