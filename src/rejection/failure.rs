//! Why a rejection sampler returned no point.

use core::convert::Infallible;
use core::error::Error;
use core::fmt;

/// Why a rejection sampler returned no point; `E` is the error of the generator.
///
/// # Examples
/// ```
/// use microwarp::rejection::{Failure, Region, Rejection};
/// use microwarp::warp::Interval;
/// use rand_pcg::Pcg32;
/// let nowhere = Region::new(Interval::new(0.0, 1.0)?, |_| false).with_budget(10)?;
/// assert_eq!(nowhere.draw(&mut Pcg32::new(1, 1)), Err(Failure::BudgetSpent { tries: 10 }));
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// A `Failure` is not a [`microwarp::Error`](crate::Error), which constructors return, and `?` does not convert one into
/// the other. Both implement [`core::error::Error`], so a function that constructs and draws returns a box of that, or
/// without a heap maps them to an error type of its own:
/// ```
/// use microwarp::rejection::{Failure, Rejection, ZigguratNormal};
/// use rand_pcg::Pcg32;
///
/// fn boxed(rng: &mut Pcg32) -> Result<f32, Box<dyn core::error::Error>> {
///     Ok(ZigguratNormal::new(10.0, 2.0)?.draw(rng)?.point)
/// }
///
/// enum Fault {
///     Parameter(microwarp::Error),
///     Draw(Failure),
/// }
/// fn mapped(rng: &mut Pcg32) -> Result<f32, Fault> {
///     let height = ZigguratNormal::new(10.0, 2.0).map_err(Fault::Parameter)?;
///     Ok(height.draw(rng).map_err(Fault::Draw)?.point)
/// }
///
/// let (one, other) = (boxed(&mut Pcg32::new(1, 1)), mapped(&mut Pcg32::new(1, 1)));
/// assert!(matches!((one, other), (Ok(x), Ok(y)) if x == y));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum Failure<E = Infallible> {
    /// The generator failed.
    Generator(E),
    /// The budget is spent, and no point was accepted.
    BudgetSpent {
        /// The number of proposed points, which is the budget.
        tries: u32,
    },
    /// The density at a proposed point lies above the bound.
    BoundExceeded {
        /// f/(c p) at that point, which is above 1, and infinite where it overflows `f32`. The bound has to be at least
        /// c times this.
        ratio: f32,
    },
    /// The density at a proposed point is NaN or infinite.
    NotFinite,
    /// The density at a proposed point is negative.
    Negative,
    /// The density that the proposal reports for its point is not a positive finite number. This happens only with
    /// warps from outside this crate, or made of closures.
    ProposalDensity,
}

impl<E: fmt::Display> fmt::Display for Failure<E> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Generator(error) => return write!(f, "the generator failed: {error}"),
            Self::BudgetSpent { tries } => {
                return write!(f, "no point was accepted in {tries} tries");
            }
            Self::BoundExceeded { ratio } => {
                return write!(f, "the density is {ratio} times its bound");
            }
            Self::NotFinite => "the density is NaN or infinite",
            Self::Negative => "the density is negative",
            Self::ProposalDensity => "the proposal's density is not positive and finite",
        })
    }
}

impl<E: Error + 'static> Error for Failure<E> {
    fn source(&self) -> Option<&(dyn Error + 'static)> {
        match self {
            Self::Generator(error) => Some(error),
            _ => None,
        }
    }
}
