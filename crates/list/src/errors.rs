//! The reasons for a refusal, in the order of their codes. `cargo regenerate` refuses a list that is not that of
//! `src/error.rs`.

/// Hands all reasons to the macro that is named.
#[macro_export]
macro_rules! errors {
    ($then:ident) => {
        $then! {
            Error::NotFinite,
            Error::Reversed,
            Error::Empty,
            Error::TooLarge,
            Error::NotPositive,
            Error::Negative,
            Error::OutOfRange,
            Error::NotNormalizable,
            Error::ZeroLength,
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
