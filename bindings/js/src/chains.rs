//! Metropolis chains whose target is a function of the caller's: a step is a proposal, the caller's density of it, and
//! the decision. The caller keeps the state and the counts.

use crate::buffers::{BLOCK, Buffers};
use crate::parts::{NOT_LINKED, linked};
use core::slice::{from_raw_parts, from_raw_parts_mut};
use microwarp::Error;
use microwarp::metropolis::{
    BoxStep, Chain, LogDensity, Mixture, Mutation, NormalStep, Proposal, RandomWalk, Saved,
    Symmetric, TargetDensity, UniformStep, WrappedWalk,
};
use microwarp::tier::Poly;
use microwarp_js_hot::Words;
use rand_core::TryRng;

/// How a chain moves.
#[derive(Clone, Copy)]
#[repr(C)]
pub struct Step {
    /// Whether the step is normal, and not uniform in a box.
    normal: u32,
    /// Whether the states are points of the unit cube, whose opposite faces meet.
    wrapped: u32,
    /// The probability of a uniform point of the cube; below 0 for states that lie in none.
    large: f32,
}

/// The state that a step proposes, in place of the state in the output, of so many coordinates; the widths lie behind the
/// step. The words lie in the input: one for each coordinate, with one before them that picks the kind in the cube. Draws
/// `random` words first. 0, or the code of the refusal.
///
/// # Safety
/// The widths lie there.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn propose(
    step: *const Step,
    buffers: &mut Buffers,
    coordinates: usize,
    random: usize,
) -> u32 {
    if !const { linked("chains") } {
        return NOT_LINKED;
    }
    buffers.random(random);
    // SAFETY: as the caller says; coordinates and words beyond the buffers have none.
    unsafe {
        let coordinates = coordinates.min(BLOCK - 2);
        let words = Words::new(buffers.input.as_ptr());
        let state = from_raw_parts_mut(buffers.output.as_mut_ptr().cast(), coordinates);
        let widths = from_raw_parts(step.add(1).cast(), coordinates);
        proposed(&*step, widths, words, state)
    }
    .map_or_else(|refusal| refusal.code().into(), |()| 0)
}

fn proposed(step: &Step, widths: &[f32], mut words: Words, state: &mut [f32]) -> Result<(), Error> {
    let large = if step.wrapped > 0 {
        let Ok(word) = words.try_next_u32();
        Mixture::large_small(step.large, ())?.table().index(word) == 0
    } else {
        false
    };
    if widths.iter().all(|width| *width == 0.0) {
        return Err(Error::NotPositive(1));
    }
    for (x, &width) in state.iter_mut().zip(widths) {
        let words = &mut words;
        // One coordinate alone may not stand still.
        if width == 0.0 && !large {
            let Ok(_) = words.try_next_u32();
            continue;
        }
        *x = match (large, step.normal > 0, step.wrapped > 0) {
            (true, ..) => moved(*x, UniformStep::new(), words),
            (_, false, false) => moved(*x, RandomWalk::new(BoxStep::new(width)?), words),
            (_, false, true) => moved(*x, WrappedWalk::new(BoxStep::new(width)?), words),
            (_, true, false) => moved(
                *x,
                RandomWalk::new(NormalStep::<f32, Poly>::new(width)?),
                words,
            ),
            (_, true, true) => moved(
                *x,
                WrappedWalk::new(NormalStep::<f32, Poly>::new(width)?),
                words,
            ),
        };
    }
    Ok(())
}

fn moved(x: f32, by: impl Mutation<f32>, words: &mut Words) -> f32 {
    let Ok(Proposal { state, .. }) = by.try_propose(x, words);
    state
}

/// A proposal that has been made.
struct Made;

impl Mutation<()> for Made {
    type Correction = Symmetric;
    fn try_propose<R: TryRng + ?Sized>(
        &self,
        (): (),
        _: &mut R,
    ) -> Result<Proposal<(), Symmetric>, R::Error> {
        Ok(Proposal::new((), Symmetric))
    }
}

/// Decides whether a proposal of density `proposed` is taken at a state of density `density`, by a word; with `log` both are
/// logarithms. Writes the acceptance to the output, and returns 0 for no, 1 for yes, 2 where the density is none and the
/// proposal refused; 3 where the chain has no density to start from.
#[unsafe(no_mangle)]
pub extern "C" fn settle(
    buffers: &mut Buffers,
    density: f32,
    proposed: f32,
    word: u32,
    log: u32,
) -> u32 {
    if !const { linked("chains") } {
        return 3;
    }
    let [acceptance, ..] = &mut buffers.output;
    if log > 0 {
        let [density, proposed] = [density, proposed].map(LogDensity::<Poly>::new);
        settled(density, proposed, word, acceptance)
    } else {
        settled(density, proposed, word, acceptance)
    }
}

fn settled<D: TargetDensity + Copy>(
    density: D,
    proposed: D,
    word: u32,
    acceptance: &mut u32,
) -> u32 {
    let saved = Saved {
        state: (),
        density,
        steps: 0,
        accepted: 0,
        refused: 0,
        rejected_in_a_row: 0,
    };
    let Ok(mut chain) = Chain::resume(saved) else {
        return 3;
    };
    // SAFETY: a step whose proposal is made takes one word.
    let mut words = unsafe { Words::new(&raw const word) };
    let step = chain.step(|()| proposed, &Made, &mut words);
    *acceptance = step.acceptance.to_bits();
    if chain.refused() > 0 {
        2
    } else {
        step.is_accepted().into()
    }
}
