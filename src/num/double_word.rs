//! Numbers of two `f32`, a rounded part and a rest, which together have twice the digits; and sums of three.

use super::{head, remainder, two_product, two_sum};

/// A number as a rounded part and a rest.
pub(crate) type DoubleWord = (f32, f32);

/// The product; not rounded again, unlike [`num::product`](super::product).
pub(crate) const fn times(p: DoubleWord, q: DoubleWord) -> DoubleWord {
    let (product, dropped) = two_product(p.0, q.0);
    (product, dropped + (p.0 * q.1 + p.1 * q.0))
}

pub(crate) fn plus(p: DoubleWord, q: DoubleWord) -> DoubleWord {
    let (sum, dropped) = two_sum(p.0, q.0);
    (sum, dropped + (p.1 + q.1))
}

/// a·b − c·d.
pub(crate) fn determinant(
    a: DoubleWord,
    b: DoubleWord,
    c: DoubleWord,
    d: DoubleWord,
) -> DoubleWord {
    plus(times(a, b), times((-c.0, -c.1), d))
}

/// 1/x and its rounding error; infinite where it overflows.
pub(crate) const fn reciprocal(x: f32) -> DoubleWord {
    let inverse = 1.0 / x;
    (inverse, remainder(1.0, inverse, x) / x)
}

/// 64 times a number: a head of 12 bits and the rest.
pub(crate) const fn by_64((x, rest): DoubleWord) -> DoubleWord {
    let high = head(64.0 * x);
    (high, (64.0 * x - high) + 64.0 * rest)
}

/// A number divided by a rounded one, rounded once.
pub(crate) const fn quotient((x, rest): DoubleWord, by: f32) -> f32 {
    let quotient = x / by;
    quotient + (remainder(x, quotient, by) + rest) / by
}

/// A sum of a few numbers, as if computed with three times as many digits.
pub(crate) struct TripleWord(f32, f32, f32);

impl TripleWord {
    pub(crate) const ZERO: Self = Self(0.0, 0.0, 0.0);

    /// a·b − c·d, summed with three times the digits, then rounded to twice.
    pub(crate) fn determinant(
        a: DoubleWord,
        b: DoubleWord,
        c: DoubleWord,
        d: DoubleWord,
    ) -> DoubleWord {
        let mut sum = Self::ZERO;
        sum.add_product(a, b);
        sum.add_product((-c.0, -c.1), d);
        sum.rounded()
    }

    pub(crate) fn add(&mut self, x: f32) {
        let (sum, dropped) = two_sum(self.0, x);
        let (rest, lost) = two_sum(self.1, dropped);
        *self = Self(sum, rest, self.2 + lost);
    }

    /// Adds a product, exact but for the last of its terms.
    pub(crate) fn add_product(&mut self, p: DoubleWord, q: DoubleWord) {
        let (a, b) = two_product(p.0, q.0);
        let (c, d) = two_product(p.0, q.1);
        let (e, f) = two_product(p.1, q.0);
        for x in &[a, c, e, b, d, f, p.1 * q.1] {
            self.add(*x);
        }
    }

    pub(crate) fn rounded(&self) -> DoubleWord {
        let (rest, lost) = two_sum(self.1, self.2);
        let (sum, rest) = two_sum(self.0, rest);
        // The last counts where the first two cancelled.
        two_sum(sum, rest + lost)
    }
}
