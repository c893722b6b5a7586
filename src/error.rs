//! The one error type: why a constructor refused its parameters.
//!
//! Samplers do not fail; a failing generator's own error passes through them untouched.

use core::fmt;

/// Why a constructor refused its parameters. Nothing is built when one of these is returned.
///
/// ```
/// use microwarp::{Error, poly as mw};
/// assert_eq!(mw::Interval::new(2.0, 1.0), Err(Error::Reversed));
/// assert_eq!(mw::Exponential::new(f32::NAN), Err(Error::NotFinite));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum Error {
    /// A parameter is NaN or infinite.
    NotFinite,
    /// The lower bound is above the upper bound.
    Reversed,
    /// The domain has no extent, or so little that its density overflows `f32`.
    Empty,
    /// The domain is so large that its density is below the smallest positive `f32`, or its own
    /// measure overflows; in the integer tier, that points of it overflow their format.
    TooLarge,
    /// A parameter that must be positive is zero or negative.
    NotPositive,
    /// A parameter that must not be negative is negative.
    Negative,
    /// A parameter lies outside the range its documentation states.
    OutOfRange,
    /// The density has no finite integral over the domain.
    NotNormalizable,
    /// A direction has no length.
    ZeroLength,
    /// There is nothing to choose from: no weight was given.
    NoWeights,
    /// More weights than a table may hold, or than its storage has room for.
    TooManyWeights,
    /// The weight at this index is NaN or infinite.
    NotFiniteWeight(usize),
    /// The weight at this index is negative.
    NegativeWeight(usize),
    /// Every weight is zero.
    AllZero,
    /// The weight at this index is positive but so small beside the others that the words of the table
    /// would not reach it.
    Unreachable(usize),
    /// Entries handed over as a finished table are not one.
    NotATable,
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::NotFiniteWeight(index) => return write!(f, "weight {index} is NaN or infinite"),
            Self::NegativeWeight(index) => return write!(f, "weight {index} is negative"),
            Self::Unreachable(index) => {
                return write!(
                    f,
                    "weight {index} is too small beside the others to be reached"
                );
            }
            Self::NoWeights => "there are no weights",
            Self::TooManyWeights => "there are more weights than the table holds",
            Self::AllZero => "every weight is zero",
            Self::NotATable => "the entries do not form a table",
            Self::NotFinite => "a parameter is NaN or infinite",
            Self::Reversed => "the lower bound is above the upper bound",
            Self::Empty => "the domain has no extent, or too little for a finite density",
            Self::TooLarge => "the domain is too large for its density or its numbers",
            Self::NotPositive => "a parameter that must be positive is not",
            Self::Negative => "a parameter that must not be negative is",
            Self::OutOfRange => "a parameter is outside its stated range",
            Self::NotNormalizable => "the density has no finite integral over the domain",
            Self::ZeroLength => "a direction has no length",
        })
    }
}

impl core::error::Error for Error {}

/// Refuses NaN and infinity.
pub(crate) const fn finite(x: f32) -> Result<f32, Error> {
    if x.is_finite() {
        Ok(x)
    } else {
        Err(Error::NotFinite)
    }
}

/// Refuses everything but finite numbers above zero.
pub(crate) const fn positive(x: f32) -> Result<f32, Error> {
    match finite(x) {
        Ok(x) if x > 0.0 => Ok(x),
        Ok(_) => Err(Error::NotPositive),
        Err(e) => Err(e),
    }
}
