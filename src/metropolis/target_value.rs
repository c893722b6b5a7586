//! What a target returns for a state.

use super::acceptance::Acceptance;
use super::standing::Standing;
use crate::error::Error;

mod sealed {
    use super::{Error, Standing};

    pub trait Weighing: Copy {
        fn standing(self) -> Standing;
        /// Accepts only a weight at which a chain can be, and says what is wrong with any other. It comes from the parameter of
        /// that place.
        #[inline]
        fn positive(self, place: usize) -> Result<(), Error> {
            match self.standing() {
                Standing::Positive => Ok(()),
                Standing::Zero => Err(Error::NotPositive(place)),
                Standing::Unsound => Err(self.fault(place)),
            }
        }
        /// The error for an unsound weight.
        fn fault(self, place: usize) -> Error;
    }
}
pub(super) use sealed::Weighing;

/// What the target of a chain returns for a state: a [`TargetDensity`](super::TargetDensity), which is an `f32` or a
/// [`LogDensity`](super::LogDensity), or an integer weight, `u32`; or one of them [`WithPayload`](super::WithPayload). The
/// trait is sealed.
///
/// A chain never enters a state of value 0.
#[diagnostic::on_unimplemented(
    message = "a target of a chain returns `f32`, `LogDensity` or `u32`, not `{Self}`",
    label = "not a value of a target",
    note = "what else the target finds goes along as `WithPayload::new(density, payload)`"
)]
pub trait TargetValue: Weighing {
    /// The acceptance of a step: an `f32`, or a [`Chance`](super::Chance) for integer weights.
    type Acceptance: Acceptance<Self>;
}
