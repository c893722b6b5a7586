//! Metropolis sampling: a Markov chain whose states have a density that is known up to a factor only.
//!
//! Here live the [`Chain`], a plain value of fixed size, and one [`Transition`] of it; what is proposed
//! ([`Mutation`] and those that are ready made), how a chain is started, and how its health is read. What
//! one does with the states is not the chain's business: the tallies of [`estimate`](crate::estimate) are at
//! hand.
//!
//! | mutation | states | proposes | T(x′→x)/T(x→x′) | words (`u32`) |
//! |---|---|---|---|---|
//! | [`UniformStep`] | unit cube | a new point of the cube | 1 | one a coordinate |
//! | [`UniformIndex`] | indices | any index | 1 | 2 |
//! | [`Independence`] | any | a draw of a warp or a table | p(x)/p(x′), of a table as two counts | those of the draw |
//! | [`TransitionTable`] | indices | a draw of the table of x | of two pmfs, as counts | those of the draw |
//! | [`BoxStep`] | ℝᴰ | x + a step, uniform in a box | 1 | one a coordinate |
//! | [`NormalStep`] | ℝᴰ | x + a normal step | 1 | one a coordinate |
//! | [`LogUniformStep`] | ℝᴰ | x + a step of any size within bounds, on a logarithmic scale | 1 | one a coordinate |
//! | [`RandomWalk`] | ℝᴰ | x + a step of a law of one's own | 1 | one a coordinate |
//! | [`WrappedWalk`] | unit cube | the same steps, modulo 1 | 1 | those of the step |
//! | [`Subset`] | ℝᴰ, unit cube | changes of some coordinates | that of the change | those of the change |
//! | [`OneCoordinate`] | ℝᴰ, unit cube | a change of one coordinate, picked at random | that of the change | 1, and those of the change |
//! | [`Mixture`] | any | what one of several mutations does, picked by weight | that of the one picked | 1, and those of the one picked |
//!
//! A step takes the words of its mutation and then one, which decides, whatever comes of it.
//!
//! # What a right chain needs
//! - *Detailed balance*, f(x) T(x→x′) a(x→x′) = f(x′) T(x′→x) a(x′→x), makes f stationary. The acceptance
//!   a = min(1, f(x′)T(x′→x)/(f(x)T(x→x′))) has it, for every mutation that states its ratio truly.
//! - *Irreducibility*: every state of positive density can be reached from every other. A small step alone
//!   crosses a gap of density 0 wider than itself never, and a deep valley rarely. A [`Mixture`] with some
//!   [`UniformStep`] or [`Independence`] proposals does.
//! - *Aperiodicity*: a rejection now and then, or a step that may stay, is enough.
//!
//! # Integer weights
//! A target may return a `u32` instead of a density. The acceptance is then a [`Chance`], an exact number of the
//! 2³² words that decide, [`Transition::recorded`] gives integers that sum to 2³², and nothing in a step is a
//! floating-point operation: not with [`UniformIndex`], not with [`Independence`] of a table and
//! [`TransitionTable`], which state [`HastingsCounts`], nor with a [`Mixture`] of them (by [`Mixture::from_table`]). A
//! chain starts by [`Chain::new`] or [`Chain::search`]; [`Chain::resample`] and
//! [`Chain::acceptance_rate`] are for floats.
//!
//! # Primary sample space
//! A chain in the unit cube drives any warp: its state is the warp's uniforms, its density f/p at the point.
//! See [`primary_density`].
//!
//! # Start-up bias
//! A chain that does not start with the density f needs time to forget its start. Either wait
//! ([`Chain::burn_in`]), or let another sampler start it, with a weight that removes the bias from the first
//! step on ([`Start`]).

mod autocorrelation;
mod chain;
mod chance;
mod coordinates;
mod hastings_correction;
mod hastings_ratio;
mod independence;
mod index;
mod mixture;
mod mutation;
mod primary;
mod r_hat;
mod random_walk;
mod rule;
mod start;
mod step_law;
mod subset;
mod target_density;
mod target_value;
mod transition;

pub use self::autocorrelation::Autocorrelation;
pub use self::chain::{Chain, Saved};
pub use self::chance::Chance;
pub use self::coordinates::Coordinates;
pub use self::hastings_correction::{HastingsCorrection, Symmetric};
pub use self::hastings_ratio::{HastingsCounts, HastingsRatio};
pub use self::independence::{Independence, StateSource, UniformStep};
pub use self::index::{TransitionTable, UniformIndex};
pub use self::mixture::{LargeSmall, Mixture, Mutations};
pub use self::mutation::{Mutation, Proposal};
pub use self::primary::primary_density;
pub use self::r_hat::{Halves, r_hat, split_r_hat};
pub use self::random_walk::{RandomWalk, WrappedWalk, wrapping_add};
pub use self::start::Start;
pub use self::step_law::{BoxStep, LogUniformStep, NormalStep, StepLaw};
pub use self::subset::{OneCoordinate, Subset};
pub use self::target_density::{LogDensity, TargetDensity};
pub use self::target_value::TargetValue;
pub use self::transition::{Outcome, Transition};
