//! The reasons for a refusal, in the order of their codes, each of the first parameter or weight. `cargo regenerate` refuses
//! a list that is not that of `src/error.rs`.

/// Hands all reasons to the macro that is named.
#[macro_export]
macro_rules! errors {
    ($then:ident) => {
        $then! {
            Error::NotFinite(0),
            Error::Reversed(0),
            Error::Empty(0),
            Error::TooLarge(0),
            Error::NotPositive(0),
            Error::Negative(0),
            Error::OutOfRange(0),
            Error::NotNormalizable(0),
            Error::ZeroLength(0),
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
