//! The reasons for a refusal, in the order of their codes. `cargo regenerate` refuses a list that is not that of
//! `src/error.rs`.

/// Hands all reasons to the macro that is named.
#[macro_export]
macro_rules! errors {
    ($then:ident) => {
        $then! {
            Error::NotFinite(Error::NO_PLACE),
            Error::Reversed(Error::NO_PLACE),
            Error::Empty(Error::NO_PLACE),
            Error::TooLarge(Error::NO_PLACE),
            Error::NotPositive(Error::NO_PLACE),
            Error::Negative(Error::NO_PLACE),
            Error::OutOfRange(Error::NO_PLACE),
            Error::NotNormalizable(Error::NO_PLACE),
            Error::ZeroLength(Error::NO_PLACE),
            Error::NoWeights,
            Error::TooManyWeights,
            Error::NotFiniteWeight(0),
            Error::NegativeWeight(0),
            Error::AllZero,
            Error::Unreachable(0),
            Error::NotATable,
        }
    };
}
