//! The integer kernels: raw words in, raw words out.
//!
//! Here live the products and the elementary functions behind [`Grade`](super::Grade). Each function states the Q formats
//! of its words: a number in Qn has n fraction bits. Plain operators never overflow here, as builds with overflow checks
//! prove over all inputs; wrapping is explicit.
#![expect(
    clippy::arithmetic_side_effects,
    clippy::cast_possible_wrap,
    reason = "debug builds check every operation over all inputs"
)]

/// Calls the variant of a function that suits this core. Tests call both and compare the bits.
macro_rules! on_this_core {
    ($function:ident($($argument:expr),*)) => {{
        #[cfg(test)]
        assert!($function::<true>($($argument),*) == $function::<false>($($argument),*));
        $function::<{ $crate::num::NARROW }>($($argument),*)
    }};
}

pub(super) mod angle;
pub(super) mod exp;
pub(super) mod float;
pub(super) mod log;
pub(super) mod product;
pub(super) mod quotient;
pub(super) mod root;
pub(super) mod sine;
mod tables;
#[cfg(test)]
mod tests;
