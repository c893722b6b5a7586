//! The error type: why a constructor refused its parameters.
//!
//! Sampling does not fail. The error of a failing generator passes through unchanged.

use core::fmt;

/// Why a constructor refused its parameters.
///
/// Where the parameters are constants, [`constant!`](crate::constant) checks them at compile time. A log or another
/// language can use the number that [`Error::code`] gives each reason.
///
/// Most reasons carry the place of the parameter in which they lie, in the list of the function that was called: from 0, without
/// `self`. A reason that lies in two parameters, such as bounds in the wrong order, has the place of the later one. One that lies
/// in three or more, or in none, has [`Error::NO_PLACE`]. [`Error::parameter`] gives the place, and the words of [`Display`]
/// count as words do, from the first parameter.
///
/// [`Display`]: core::fmt::Display
///
/// # Examples
/// ```
/// use microwarp::{Error, poly as mw};
/// assert_eq!(mw::Interval::new(2.0, 1.0), Err(Error::Reversed(1)));
/// assert_eq!(mw::Exponential::from_rate(f32::NAN), Err(Error::NotFinite(0)));
///
/// let refused = mw::Normal::new(20.0, -0.5);
/// assert_eq!(refused, Err(Error::NotPositive(1)));
/// assert_eq!(refused.unwrap_err().to_string(), "the second parameter must be positive");
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum Error {
    /// A parameter is NaN or infinite.
    NotFinite(usize),
    /// The lower bound is above the upper bound.
    Reversed(usize),
    /// The domain has no extent, or so little that its density overflows `f32`; a range holds no integer.
    Empty(usize),
    /// The domain is so large that its density is below the smallest positive `f32`, or that its size overflows. In the
    /// integer tier: so large that its points overflow their format. A mean, a variance or a sum of weights is beyond what the
    /// sampler holds.
    TooLarge(usize),
    /// A parameter that must be positive is zero or negative.
    NotPositive(usize),
    /// A parameter that must not be negative is negative.
    Negative(usize),
    /// A parameter lies outside the range its documentation states.
    OutOfRange(usize),
    /// The density has no finite integral over the domain.
    NotNormalizable(usize),
    /// A direction has no length.
    ZeroLength(usize),
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

// Two words: a place takes that of an index.
const _: () = assert!(size_of::<Error>() <= 2 * size_of::<usize>());

impl Error {
    /// The place in a reason that lies in no single parameter: in three or more together, or in none, as a dimension of 0 does.
    pub const NO_PLACE: usize = usize::MAX;

    /// The number of this reason, for a log or another language. It never changes, and no reason has the number 0.
    ///
    /// ```
    /// use microwarp::Error;
    /// assert_eq!(Error::NotPositive(1).code(), 5);
    /// assert_eq!(Error::NegativeWeight(7).code(), 13);
    /// ```
    #[must_use]
    pub const fn code(self) -> u16 {
        match self {
            Self::NotFinite(_) => 1,
            Self::Reversed(_) => 2,
            Self::Empty(_) => 3,
            Self::TooLarge(_) => 4,
            Self::NotPositive(_) => 5,
            Self::Negative(_) => 6,
            Self::OutOfRange(_) => 7,
            Self::NotNormalizable(_) => 8,
            Self::ZeroLength(_) => 9,
            Self::NoWeights => 10,
            Self::TooManyWeights => 11,
            Self::NotFiniteWeight(_) => 12,
            Self::NegativeWeight(_) => 13,
            Self::AllZero => 14,
            Self::Unreachable(_) => 15,
            Self::NotATable => 16,
        }
    }

    /// The reason in words. [`Error::parameter`] and [`Error::index`] say which parameter or weight is meant.
    #[must_use]
    pub const fn message(self) -> &'static str {
        match self {
            Self::NotFinite(_) => "a parameter is NaN or infinite",
            Self::Reversed(_) => "the lower bound is above the upper bound",
            Self::Empty(_) => "the domain or range is empty, or too small for a finite density",
            Self::TooLarge(_) => {
                "the domain, a parameter or a sum is too large, or samples overflow"
            }
            Self::NotPositive(_) => "a parameter that must be positive is not",
            Self::Negative(_) => "a parameter that must not be negative is",
            Self::OutOfRange(_) => "a parameter is outside its stated range",
            Self::NotNormalizable(_) => "the density has no finite integral over the domain",
            Self::ZeroLength(_) => "a direction has no length",
            Self::NoWeights => "there are no weights",
            Self::TooManyWeights => "there are more weights than the table holds",
            Self::NotFiniteWeight(_) => "a weight is NaN or infinite",
            Self::NegativeWeight(_) => "a weight is negative",
            Self::AllZero => "every weight is zero",
            Self::Unreachable(_) => "a weight is too small beside the others to be reached",
            Self::NotATable => "the entries do not form a table",
        }
    }

    /// The place of the parameter in which the reason lies, from 0, in the list of the function that was called.
    ///
    /// It is `None` where the place is [`Error::NO_PLACE`], and for what only tables of weights are refused for.
    ///
    /// ```
    /// use microwarp::{Error, poly as mw};
    /// let refused = mw::TruncatedNormal::new(0.0, 1.0, 2.0, -2.0).unwrap_err();
    /// assert_eq!(refused.parameter(), Some(3)); // `high`, which is below `low`
    /// assert_eq!(Error::AllZero.parameter(), None);
    /// ```
    #[must_use]
    pub const fn parameter(mut self) -> Option<usize> {
        match self.place() {
            Some(&mut place) if place != Self::NO_PLACE => Some(place),
            _ => None,
        }
    }

    /// The same reason at another place, if it has one: for a function that hands parameters on.
    pub(crate) const fn at(mut self, to: usize) -> Self {
        if let Some(place) = self.place() {
            *place = to;
        }
        self
    }

    /// The place in a reason that has one.
    const fn place(&mut self) -> Option<&mut usize> {
        match self {
            Self::NotFinite(place)
            | Self::Reversed(place)
            | Self::Empty(place)
            | Self::TooLarge(place)
            | Self::NotPositive(place)
            | Self::Negative(place)
            | Self::OutOfRange(place)
            | Self::NotNormalizable(place)
            | Self::ZeroLength(place) => Some(place),
            _ => None,
        }
    }

    /// What is said of the parameter in which the reason lies.
    const fn predicate(self) -> Option<&'static str> {
        Some(match self {
            Self::NotFinite(_) => "is NaN or infinite",
            Self::Reversed(_) => "is below its lower bound",
            Self::Empty(_) => "leaves the domain or range empty, or too small for a finite density",
            Self::TooLarge(_) => "is too large, or lets the domain, a sum or samples be so",
            Self::NotPositive(_) => "must be positive",
            Self::Negative(_) => "must not be negative",
            Self::OutOfRange(_) => "is outside its stated range",
            Self::NotNormalizable(_) => "leaves the density no finite integral over the domain",
            Self::ZeroLength(_) => "has no length",
            _ => return None,
        })
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
        const ORDINALS: [&str; 6] = ["first", "second", "third", "fourth", "fifth", "sixth"];
        let ordinal = self.parameter().and_then(|place| ORDINALS.get(place));
        if let (Some(ordinal), Some(predicate)) = (ordinal, self.predicate()) {
            return write!(f, "the {ordinal} parameter {predicate}");
        }
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
/// statement outside of function body") in a constant. Its message names neither a parameter nor the index of a weight;
/// [`Error::parameter`] and [`Error::index`] do, at run time.
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

/// The value of a result, or a return of its error: what `?` does, which no constant function may use yet. The error may be
/// moved to the place that its parameter has here.
macro_rules! tried {
    ($result:expr $(, at $place:expr)?) => {
        match $result {
            Ok(value) => value,
            Err(error) => return Err(error$(.at($place))?),
        }
    };
}
pub(crate) use tried;

/// Refuses NaN and infinity.
pub(crate) const fn finite(x: f32, place: usize) -> Result<f32, Error> {
    if x.is_finite() {
        Ok(x)
    } else {
        Err(Error::NotFinite(place))
    }
}

/// Refuses everything but finite numbers above zero.
pub(crate) const fn positive(x: f32, place: usize) -> Result<f32, Error> {
    if tried!(finite(x, place)) > 0.0 {
        Ok(x)
    } else {
        Err(Error::NotPositive(place))
    }
}
