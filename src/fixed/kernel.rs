//! The integer kernels: raw words in, raw words out.
//!
//! Here live the products and the elementary functions behind [`Grade`](super::Grade). What a word means is said at
//! each function, as Q formats: of a number in Qn, the n lowest bits are its fraction. Plain operators never
//! overflow here, which builds with overflow checks prove over all inputs; where wrapping is meant, it says so.
#![expect(
    clippy::arithmetic_side_effects,
    clippy::cast_possible_wrap,
    reason = "debug builds check every operation over all inputs"
)]

/// Calls a function in the way of this core. Tests call it in both ways, for the same bits.
macro_rules! on_this_core {
    ($function:ident($($argument:expr),*)) => {{
        #[cfg(test)]
        assert!($function::<true>($($argument),*) == $function::<false>($($argument),*));
        $function::<{ $crate::fixed::kernel::NARROW }>($($argument),*)
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

/// Whether the core multiplies 32 bits by 32 to 32 bits only. Of the Arm cores, those without
/// compare-and-swap are the ones.
pub(super) const NARROW: bool = cfg!(all(target_arch = "arm", not(target_has_atomic = "32")));
