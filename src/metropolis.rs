//! Metropolis sampling (MCMC): Markov chains whose states have a density that is known only up to a factor.
//!
//! Write the target as a function of the state, choose a mutation, and call [`Chain::step`] in a loop. Every step
//! returns a [`Transition`]; the estimators of [`estimate`](crate::estimate) take what you record of it.
//!
//! # Which mutation?
//!
//! | the states are | take |
//! |---|---|
//! | points of ℝᴰ | [`NormalStep`] or [`BoxStep`], about as wide as the target |
//! | points of ℝᴰ, on an unknown scale | [`LogUniformStep`] |
//! | points of ℝᴰ, many coordinates | [`OneCoordinate`] of such a step |
//! | uniforms of a warp, or another unit cube | [`Mixture::large_small`] with a [`WrappedWalk`] of such a step |
//! | indices | [`UniformIndex`], or [`Independence`] of a table close to the target |
//! | anything for which a good sampler exists | [`Independence`] of that warp or table |
//! | tuples of such parts | a [`Product`] of their mutations |
//! | anything else | your own [`Mutation`] |
//!
//! Where one mutation gets stuck, such as a small step between distant peaks, a [`Mixture`] adds another.
//!
//! # All mutations
//!
//! T(x→x′) is the density with which a chain at x proposes x′. A step takes the words of its mutation, and then one
//! word that decides.
//!
//! | mutation | states | proposes | T(x′→x)/T(x→x′) | words (`u32`) |
//! |---|---|---|---|---|
//! | [`BoxStep`] | ℝᴰ | x plus a uniform step in a box | 1 | one per coordinate |
//! | [`NormalStep`] | ℝᴰ | x plus a normal step | 1 | one per coordinate |
//! | [`LogUniformStep`] | ℝᴰ | x plus a step of log-uniform size | 1 | one per coordinate |
//! | [`RandomWalk`] | ℝᴰ | x plus a step of your own [`StepLaw`] | 1 | one per coordinate |
//! | [`WrappedWalk`] | unit cube | the same steps, modulo 1 | 1 | one per coordinate |
//! | [`UniformStep`] | unit cube | a uniform point of the cube | 1 | one per coordinate |
//! | [`UniformIndex`] | indices | any index | 1 | 2 |
//! | [`TransitionTable`] | indices | a draw from the table of x | of two pmfs, as counts | those of the draw |
//! | [`Independence`] | any | a draw from a warp or a table | p(x)/p(x′), for a table as counts | those of the draw |
//! | [`Subset`] | ℝᴰ, unit cube | a change of some coordinates | that of the change | those of the change |
//! | [`OneCoordinate`] | ℝᴰ, unit cube | a change of one random coordinate | that of the change | 1, and those of the change |
//! | [`Product`] | tuples | a change of each part | the product of those of the parts | those of the parts |
//! | [`Mixture`] | any | what one of several mutations proposes | that of the one picked | 1, and those of the one picked |
//!
//! # What a correct chain needs
//!
//! - *Detailed balance*, f(x) T(x→x′) a(x→x′) = f(x′) T(x′→x) a(x′→x), makes f stationary. The acceptance
//!   a = min(1, f(x′)T(x′→x)/(f(x)T(x→x′))) has it, as long as the mutation states its ratio correctly.
//! - *Irreducibility*: the chain can get from every state of positive density to every other. A small step alone never
//!   crosses a gap of density 0 wider than itself, and rarely a deep valley. A [`Mixture`] with some [`UniformStep`]
//!   or [`Independence`] proposals crosses both.
//! - *Aperiodicity*: an occasional rejection, or a step that may stay, is enough.
//!
//! # What a target finds beside the density
//!
//! A path has a colour and falls on a pixel. A target may return these [`WithPayload`]; the chain keeps them with the state,
//! and [`Transition::recorded_values`] hands them out.
//!
//! # Integer weights
//!
//! A target may return a `u32` instead of a density. The acceptance is then a [`Chance`], an exact number of the
//! 2³² words that decide, and [`Transition::recorded`] gives integers that sum to 2³². No floating-point operation
//! takes place in a step of [`UniformIndex`], of [`Independence`] of a table, of [`TransitionTable`], or of a
//! [`Mixture`] of them (by [`Mixture::from_table`]). Start such a chain with [`Chain::new`] or [`Chain::search`];
//! [`Chain::resample`] and [`Chain::acceptance_rate`] compute with floats.
//!
//! For weights f of x and f′ of x′, and counts T of the way there and T′ of the way back, the first ⌈2³² f′T′/(fT)⌉ words accept,
//! or all of them: the acceptance, rounded up by less than 2⁻³², and never 0 for a proposal that the rule allows.
//!
//! ```
//! use microwarp::metropolis::{Chain, UniformIndex};
//! use rand_pcg::Pcg32;
//! const WEIGHTS: [u32; 2] = [9, 1];
//! let weight = |i: usize| WEIGHTS[i];
//! let (mut chain, mut rng) = (Chain::new(0, weight)?, Pcg32::new(1, 1));
//! let (mutation, mut histogram) = (UniformIndex::new(2)?, [0; 2]);
//! for _ in 0..1000 {
//!     let step = chain.step(weight, &mutation, &mut rng);
//!     if (step.from, step.proposed) == (0, 1) {
//!         assert_eq!(step.acceptance.words(), (1_u64 << 32).div_ceil(9));
//!     }
//!     for (state, words) in step.recorded() {
//!         histogram[state] += words; // both together 2³²
//!     }
//! }
//! assert_eq!(histogram[0] + histogram[1], 1000 << 32);
//! assert!(histogram[0] > 850 << 32 && histogram[0] < 950 << 32);
//! # Ok::<(), microwarp::Error>(())
//! ```
//!
//! # Primary sample space
//!
//! A chain in the unit cube can drive any warp: its state is the warp's uniforms, and its density is f/p at the
//! point. See [`primary_density`].
//!
//! # How wide?
//!
//! [`Tuning`] finds the scale of a step while the chain burns in, and freezes it then.
//!
//! # Start-up bias
//!
//! A chain that does not start with the density f needs time to forget its start. Either wait ([`Chain::burn_in`]), or
//! let another sampler start it, with a weight that removes the bias from the first step on ([`Chain::resample`]).
//!
//! # Has it converged?
//!
//! | you have | take |
//! |---|---|
//! | one run, no memory for it | [`Autocorrelation`]: how many steps are worth one independent sample, the error of the mean |
//! | several runs, no memory for them | [`split_r_hat()`]: whether they agree |
//! | several runs in memory | [`Draws`]: R̂ by ranks, effective sizes of bulk and tails, the error of the mean |
//!
//! None notices a peak that no run has visited.

mod acceptance;
mod autocorrelation;
mod chain;
mod chance;
mod coordinates;
mod draws;
mod effective;
mod hastings_correction;
mod hastings_ratio;
mod independence;
mod index;
mod mixture;
mod mutation;
mod payload;
mod primary;
mod product;
mod r_hat;
mod random_walk;
mod ranks;
mod rule;
mod scalable;
mod standing;
mod start;
mod step_law;
mod subset;
mod target_density;
mod target_value;
mod transition;
mod tuning;

pub use self::autocorrelation::Autocorrelation;
pub use self::chain::{Chain, Saved};
pub use self::coordinates::Coordinates;
pub use self::draws::Draws;
pub use self::hastings_correction::{HastingsCorrection, Symmetric};
pub use self::hastings_ratio::{HastingsCounts, HastingsRatio};
pub use self::independence::{Independence, StateSource, UniformStep};
pub use self::index::{TransitionTable, UniformIndex};
pub use self::mixture::{LargeSmall, Mixture, Mutations};
pub use self::mutation::{Mutation, Proposal};
pub use self::payload::WithPayload;
pub use self::primary::primary_density;
pub use self::product::Product;
pub use self::r_hat::{Halves, r_hat, split_r_hat};
pub use self::random_walk::{RandomWalk, WrappedWalk, wrapping_add};
pub use self::scalable::Scalable;
pub use self::start::Start;
pub use self::step_law::{BoxStep, LogUniformStep, NormalStep, StepLaw};
pub use self::subset::{OneCoordinate, Subset};
pub use self::target_density::{LogDensity, TargetDensity};
pub use self::target_value::TargetValue;
pub use self::transition::{Outcome, Transition};
pub use self::tuning::Tuning;
pub use crate::uniform::Chance;
