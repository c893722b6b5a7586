//! A chain as plain numbers, and back.

use super::Chain;
use super::weight::Weight;
use crate::error::Error;

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

impl<X: Copy, D: Weight> Chain<X, D> {
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
