//! Metropolis chains of `float[D]`, whose target is a callback. The state lies open in a struct of the caller.

use crate::error::{Code, code};
use crate::generators::{Pcg32, Source};
use crate::rejection::Callback;
use crate::value::Value;
use core_crate::metropolis::{
    BoxStep, Chain, HastingsRatio, LogDensity, Mutation, Outcome, Proposal, RandomWalk, Saved,
    TargetDensity, Transition, UniformStep, WrappedWalk,
};
use core_crate::tier::Poly;
use core_crate::{Error, poly};
use rand_core::TryRng;

/// What a target of C returns: a density, or the logarithm of one.
pub trait Kind: Copy {
    type Density: TargetDensity;
    fn of(returned: f32) -> Self::Density;
    fn returned(density: Self::Density) -> f32;
    /// What a chain holds that was made, and a struct of zeros does not.
    const MADE: Self;
    fn is_made(self) -> bool;
}

/// A density. A struct of zeros has none, which no chain is at.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct Plain;

impl Kind for Plain {
    type Density = f32;
    const MADE: Self = Self;

    #[inline]
    fn of(returned: f32) -> f32 {
        returned
    }

    #[inline]
    fn returned(density: f32) -> f32 {
        density
    }

    #[inline]
    fn is_made(self) -> bool {
        true
    }
}

/// A logarithm, which may be 0.
#[repr(transparent)]
#[derive(Clone, Copy)]
pub struct Logarithm(u32);

impl Kind for Logarithm {
    type Density = LogDensity<Poly>;
    const MADE: Self = Self(1);

    #[inline]
    fn of(returned: f32) -> LogDensity<Poly> {
        LogDensity::new(returned)
    }

    #[inline]
    fn returned(density: LogDensity<Poly>) -> f32 {
        density.get()
    }

    #[inline]
    fn is_made(self) -> bool {
        self.0 > 0
    }
}

/// `mw_chain_*` and `mw_log_chain_*`
#[repr(C)]
#[derive(Clone, Copy)]
pub struct InC<X, K> {
    steps: u64,
    accepted: u64,
    refused: u64,
    rejected_in_a_row: u32,
    made: K,
    density: f32,
    state: X,
}

impl<X: Copy, K: Kind> InC<X, K> {
    /// # Errors
    /// Where no chain was made, or counts contradict each other, which no chain writes.
    #[inline]
    fn chain(&self) -> Result<Chain<X, K::Density>, Error> {
        if !self.made.is_made() {
            return Err(Error::NotPositive(0));
        }
        Chain::resume(Saved {
            state: self.state,
            density: K::of(self.density),
            steps: self.steps,
            accepted: self.accepted,
            refused: self.refused,
            rejected_in_a_row: self.rejected_in_a_row,
        })
    }

    #[inline]
    fn of(chain: &Chain<X, K::Density>) -> Self {
        let saved = chain.save();
        Self {
            steps: saved.steps,
            accepted: saved.accepted,
            refused: saved.refused,
            rejected_in_a_row: saved.rejected_in_a_row,
            made: K::MADE,
            density: K::returned(saved.density),
            state: saved.state,
        }
    }

    /// One step; the chain is unchanged after an error.
    #[inline]
    fn step<R: TryRng<Error: Into<Code>>>(
        &mut self,
        target: impl FnOnce(X) -> f32,
        mutation: &impl Mutation<X>,
        rng: &mut R,
    ) -> Result<Step<X>, Code> {
        let mut chain = self.chain()?;
        let step = chain.try_step(|x| K::of(target(x)), mutation, rng);
        let step = step.map_err(Into::into)?;
        *self = Self::of(&chain);
        Ok(Step::of::<K>(step))
    }
}

/// `mw_transition_*`
#[repr(C)]
pub struct Step<X> {
    from_density: f32,
    proposed_density: f32,
    acceptance: f32,
    outcome: u32,
    from: X,
    proposed: X,
}

impl<X> Step<X> {
    #[inline]
    fn of<K: Kind>(step: Transition<X, K::Density>) -> Self {
        Self {
            from_density: K::returned(step.from_density),
            proposed_density: K::returned(step.proposed_density),
            acceptance: step.acceptance,
            outcome: match step.outcome {
                Outcome::Accepted => 0,
                Outcome::Refused => 2,
                _ => 1,
            },
            from: step.from,
            proposed: step.proposed,
        }
    }
}

/// Writes a transition where it is wanted.
///
/// # Safety
/// The pointer is valid for writes, or null.
#[inline]
unsafe fn told<X>(step: Result<Step<X>, Code>, to: *mut Step<X>) -> Code {
    code(step, |step| {
        if !to.is_null() {
            // SAFETY: the caller's promise.
            unsafe { to.write(step) }
        }
    })
}

/// What the caller has proposed, with the ratio of the ways there and back.
struct Proposed<X>(X, HastingsRatio);

impl<X: Copy> Mutation<X> for Proposed<X> {
    type Correction = HastingsRatio;

    #[inline]
    fn try_propose<R: TryRng + ?Sized>(
        &self,
        _: X,
        _: &mut R,
    ) -> Result<Proposal<X, HastingsRatio>, R::Error> {
        Ok(Proposal::new(self.0, self.1))
    }
}

/// The chains, and their steps: `"name" (parameter: type) mutation`.
macro_rules! chains {
    ($($name:literal $state:ty, $kind:ty;)*) => {$(
        const _: () = {
            type State = $state;
            type OfC = InC<$state, $kind>;
            type Target = Callback<$state, f32>;

            #[unsafe(export_name = concat!("mw_", $name, "_init"))]
            unsafe extern "C" fn init(
                chain: *mut OfC, start: <State as Value>::Given, target: &Target,
            ) -> Code {
                // SAFETY: the promise of the header.
                unsafe {
                    let made = Chain::new(State::read(start), |x| <$kind>::of(target.of(x)));
                    code(made, |made| chain.write(InC::of(&made)))
                }
            }

            chains! { @ $name;
                "_step_normal" (std_devs: <State as Value>::Given)
                    poly::NormalStep::new(State::read(std_devs)).map(RandomWalk::new);
                "_step_box" (widths: <State as Value>::Given)
                    BoxStep::new(State::read(widths)).map(RandomWalk::new);
                "_step_wrapped" (std_devs: <State as Value>::Given)
                    poly::NormalStep::new(State::read(std_devs)).map(WrappedWalk::new);
                "_step_uniform" () Ok::<_, Error>(UniformStep::new());
                "_step_to" (proposed: <State as Value>::Given, forward: f32, backward: f32)
                    Ok::<_, Error>(Proposed(
                        State::read(proposed), HastingsRatio::new(forward, backward),
                    ));
            }
        };
    )*};
    (@ $name:literal; $($step:literal ($($parameter:ident: $type:ty),*) $mutation:expr;)*) => {$(
        const _: () = {
            #[unsafe(export_name = concat!("mw_", $name, $step))]
            unsafe extern "C" fn step(
                chain: &mut OfC, $($parameter: $type,)* target: &Target, rng: &mut Pcg32,
                transition: *mut Step<State>,
            ) -> Code {
                // SAFETY: the promise of the header.
                unsafe {
                    match $mutation {
                        Ok(mutation) => told(
                            chain.step(|x| target.of(x), &mutation, rng),
                            transition,
                        ),
                        Err(error) => error.into(),
                    }
                }
            }

            #[unsafe(export_name = concat!("mw_", $name, $step, "_from"))]
            unsafe extern "C" fn step_from(
                chain: &mut OfC, $($parameter: $type,)* target: &Target, source: &Source,
                transition: *mut Step<State>,
            ) -> Code {
                // SAFETY: the promise of the header.
                unsafe {
                    match $mutation {
                        Ok(mutation) => told(
                            chain.step(|x| target.of(x), &mutation, &mut { *source }),
                            transition,
                        ),
                        Err(error) => error.into(),
                    }
                }
            }
        };
    )*};
}

chains! {
    "chain_1d" f32, Plain;
    "chain_2d" [f32; 2], Plain;
    "chain_3d" [f32; 3], Plain;
    "chain_4d" [f32; 4], Plain;
    "chain_6d" [f32; 6], Plain;
    "chain_8d" [f32; 8], Plain;
    "log_chain_1d" f32, Logarithm;
    "log_chain_2d" [f32; 2], Logarithm;
    "log_chain_3d" [f32; 3], Logarithm;
    "log_chain_4d" [f32; 4], Logarithm;
    "log_chain_6d" [f32; 6], Logarithm;
    "log_chain_8d" [f32; 8], Logarithm;
}
