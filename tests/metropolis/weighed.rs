//! What a harness asks of densities and integer weights alike, so that one harness serves both kinds of chain.

use microwarp::metropolis::{Chance, LogDensity, Saved, TargetValue, Transition};
use microwarp::tier::Tier;
use std::fmt::Debug;

/// A weight, whose acceptances can be compared.
pub trait Weighed:
    TargetValue<Acceptance: Copy + PartialEq + Debug + Bits> + Bits + PartialEq + Debug
{
}

impl Weighed for f32 {}
impl<T: Tier> Weighed for LogDensity<T> {}
impl Weighed for u32 {}

/// What consists of bits: NaN is equal to itself, and 0 is not -0.
pub trait Bits {
    fn bits(&self) -> Vec<u64>;
}

impl Bits for usize {
    fn bits(&self) -> Vec<u64> {
        vec![*self as u64]
    }
}

impl Bits for u32 {
    fn bits(&self) -> Vec<u64> {
        vec![(*self).into()]
    }
}

impl Bits for Chance {
    fn bits(&self) -> Vec<u64> {
        vec![self.words()]
    }
}

impl Bits for f32 {
    fn bits(&self) -> Vec<u64> {
        vec![self.to_bits().into()]
    }
}

impl<const N: usize> Bits for [f32; N] {
    fn bits(&self) -> Vec<u64> {
        self.iter().map(|x| x.to_bits().into()).collect()
    }
}

impl<T: Tier> Bits for LogDensity<T> {
    fn bits(&self) -> Vec<u64> {
        self.get().bits()
    }
}

impl<X: Bits, D: Bits> Bits for Saved<X, D> {
    fn bits(&self) -> Vec<u64> {
        let counts = [
            self.steps,
            self.accepted,
            self.refused,
            self.rejected_in_a_row.into(),
        ];
        [self.state.bits(), self.density.bits(), counts.to_vec()].concat()
    }
}

impl<X: Bits, D: Bits, A: Bits> Bits for Transition<X, D, A> {
    fn bits(&self) -> Vec<u64> {
        let rest = [self.outcome as u64, self.kind.into()];
        let from = [self.from.bits(), self.from_density.bits()].concat();
        let to = [self.proposed.bits(), self.proposed_density.bits()].concat();
        [from, to, self.acceptance.bits(), rest.to_vec()].concat()
    }
}
