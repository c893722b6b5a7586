//! The error type: why a constructor refused its parameters.
//!
//! Sampling does not fail. The error of a failing generator passes through unchanged.

use core::fmt;

/// Why a constructor refused its parameters.
///
/// Where the parameters are constants, [`constant!`](crate::constant) checks them at compile time. A log or another
/// language can use the number that [`Error::code`] gives each reason.
///
/// # Examples
/// ```
/// use microwarp::{Error, poly as mw};
/// assert_eq!(mw::Interval::new(2.0, 1.0), Err(Error::Reversed));
/// assert_eq!(mw::Exponential::from_rate(f32::NAN), Err(Error::NotFinite));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum Error {
    /// A parameter is NaN or infinite.
    NotFinite,
    /// The lower bound is above the upper bound.
    Reversed,
    /// The domain has no extent, or so little that its density overflows `f32`; a range holds no integer.
    Empty,
    /// The domain is so large that its density is below the smallest positive `f32`, or that its size overflows. In the
    /// integer tier: so large that its points overflow their format. A mean, a variance or a sum of weights is beyond what the
    /// sampler holds.
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
    /// No weights were given.
    NoWeights,
    /// There are more weights than a table may hold, or than its storage has room for.
    TooManyWeights,
    /// The weight at this index is NaN or infinite.
    NotFiniteWeight(usize),
    /// The weight at this index is negative.
    NegativeWeight(usize),
    /// Every weight is zero.
    AllZero,
    /// The weight at this index is positive, but so small beside the others that no word of the table selects it.
    Unreachable(usize),
    /// The entries given as a finished table do not form one.
    NotATable,
}

impl Error {
    /// The number of this reason, for a log or another language. It never changes, and no reason has the number 0.
    ///
    /// ```
    /// use microwarp::Error;
    /// assert_eq!(Error::NotPositive.code(), 5);
    /// assert_eq!(Error::NegativeWeight(7).code(), 13);
    /// ```
    #[must_use]
    pub const fn code(self) -> u16 {
        match self {
            Self::NotFinite => 1,
            Self::Reversed => 2,
            Self::Empty => 3,
            Self::TooLarge => 4,
            Self::NotPositive => 5,
            Self::Negative => 6,
            Self::OutOfRange => 7,
            Self::NotNormalizable => 8,
            Self::ZeroLength => 9,
            Self::NoWeights => 10,
            Self::TooManyWeights => 11,
            Self::NotFiniteWeight(_) => 12,
            Self::NegativeWeight(_) => 13,
            Self::AllZero => 14,
            Self::Unreachable(_) => 15,
            Self::NotATable => 16,
        }
    }

    /// The reason in words. [`Error::index`] says which weight is meant.
    #[must_use]
    pub const fn message(self) -> &'static str {
        match self {
            Self::NotFinite => "a parameter is NaN or infinite",
            Self::Reversed => "the lower bound is above the upper bound",
            Self::Empty => "the domain or range is empty, or too small for a finite density",
            Self::TooLarge => "the domain, a parameter or a sum is too large, or samples overflow",
            Self::NotPositive => "a parameter that must be positive is not",
            Self::Negative => "a parameter that must not be negative is",
            Self::OutOfRange => "a parameter is outside its stated range",
            Self::NotNormalizable => "the density has no finite integral over the domain",
            Self::ZeroLength => "a direction has no length",
            Self::NoWeights => "there are no weights",
            Self::TooManyWeights => "there are more weights than the table holds",
            Self::NotFiniteWeight(_) => "a weight is NaN or infinite",
            Self::NegativeWeight(_) => "a weight is negative",
            Self::AllZero => "every weight is zero",
            Self::Unreachable(_) => "a weight is too small beside the others to be reached",
            Self::NotATable => "the entries do not form a table",
        }
    }

    /// The index of the weight that was refused, if the reason lies in one weight.
    ///
    /// ```
    /// use microwarp::Error;
    /// assert_eq!(Error::NegativeWeight(7).index(), Some(7));
    /// assert_eq!(Error::AllZero.index(), None);
    /// ```
    #[must_use]
    pub const fn index(self) -> Option<usize> {
        match self {
            Self::NotFiniteWeight(index)
            | Self::NegativeWeight(index)
            | Self::Unreachable(index) => Some(index),
            _ => None,
        }
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::NotFiniteWeight(index) => write!(f, "weight {index} is NaN or infinite"),
            Self::NegativeWeight(index) => write!(f, "weight {index} is negative"),
            Self::Unreachable(index) => {
                write!(
                    f,
                    "weight {index} is too small beside the others to be reached"
                )
            }
            _ => f.write_str(self.message()),
        }
    }
}

impl core::error::Error for Error {}

/// Makes a sampler at compile time: the value of a `Result` whose parameters are constants.
///
/// A refused parameter stops the compilation with its [message](Error::message). Nothing is left to fail at run time,
/// and the sampler is read-only data.
///
/// ```
/// use microwarp::{Warp, constant, poly as mw};
/// use rand_pcg::Pcg32;
///
/// const NOISE: mw::Normal = constant!(mw::Normal::new(20.0, 0.5));
///
/// let mut rng = Pcg32::new(42, 54);
/// let temperature = NOISE.draw(&mut rng);
/// let delay = constant!(mw::Exponential::from_mean(250.0)).draw(&mut rng); // in place, too
/// assert!(temperature > 10.0 && delay >= 0.0);
/// ```
///
/// In the integer tier the type parameter counts the bits behind the point, and constants are written by `lit`:
/// `const DELAY: mw::Exponential<U16> = constant!(mw::Exponential::from_mean(U16F16::lit("20")));`, with `U16` from
/// `fixed::types::extra`.
///
/// Without this macro the compiler refuses `unwrap` (E0015, "cannot call non-const method") and `?` (E0572, "return
/// statement outside of function body") in a constant. Its message does not name the index of a weight;
/// [`Error::index`] does, at run time.
///
/// ```compile_fail
/// use microwarp::{constant, poly as mw};
/// const NOISE: mw::Normal = constant!(mw::Normal::new(20.0, -0.5)); // "a parameter that must be positive is not"
/// ```
#[macro_export]
macro_rules! constant {
    ($result:expr $(,)?) => {
        const {
            match $result {
                ::core::result::Result::Ok(value) => value,
                ::core::result::Result::Err(error) => {
                    ::core::panic!("{}", $crate::Error::message(error))
                }
            }
        }
    };
}

/// The value of a result, or a return of its error: what `?` does, which no constant function may use yet.
macro_rules! tried {
    ($result:expr) => {
        match $result {
            Ok(value) => value,
            Err(error) => return Err(error),
        }
    };
}
pub(crate) use tried;

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
    if tried!(finite(x)) > 0.0 {
        Ok(x)
    } else {
        Err(Error::NotPositive)
    }
}
