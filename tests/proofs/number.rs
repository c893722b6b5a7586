//! The numbers over which a program is written: `f32`, `f64`, and those that record what is done with them.

use crate::range::Range;
use crate::rounding::Lost;
use crate::tape::{NEAR, Op, Traced};
use std::ops::{Add, Div, Mul, Sub};

/// Numbers in which a program may be run: `f32`, `f64`, and those that record it.
pub trait Number:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self>
{
    /// A constant of the program.
    fn like(self, x: f32) -> Self;
    fn sqrt(self) -> Self;
    fn below(self, other: Self) -> bool;
    /// Says that the number as it is rounded is at most this, and without that at most a 10⁻⁵th of it more.
    fn at_most(self, _: f64) -> Self {
        self
    }
}

impl Number for f32 {
    fn like(self, x: f32) -> Self {
        x
    }
    fn sqrt(self) -> Self {
        self.sqrt()
    }
    fn below(self, other: Self) -> bool {
        self < other
    }
}

impl Number for f64 {
    fn like(self, x: f32) -> Self {
        x.into()
    }
    fn sqrt(self) -> Self {
        self.sqrt()
    }
    fn below(self, other: Self) -> bool {
        self < other
    }
}

impl Traced<'_> {
    /// Whether a question that the ranges leave open is answered with yes.
    fn answer(self) -> bool {
        let asked = self.tape.asked.get();
        self.tape.asked.set(asked + 1);
        self.tape.answers.get() >> asked & 1 == 1
    }

    /// Takes away what is above, of the rounded values and of all.
    fn clip(self, rounded: f64, all: f64) {
        let node = &mut self.tape.nodes.borrow_mut()[self.index];
        node.rounded.high = node.rounded.high.min(rounded);
        node.value.high = node.value.high.min(all);
        if node.value.low > node.value.high || node.rounded.low > node.rounded.high {
            self.tape.impossible.set(true);
            node.value.low = node.value.high;
            node.rounded.low = node.rounded.high;
        }
    }

    /// Says that the number is at least this, with all rounding and with none.
    pub fn at_least(self, x: f64) -> Self {
        let node = &mut self.tape.nodes.borrow_mut()[self.index];
        node.rounded.low = node.rounded.low.max(x);
        node.value.low = node.value.low.max(x);
        if node.value.low > node.value.high || node.rounded.low > node.rounded.high {
            self.tape.impossible.set(true);
            node.value.high = node.value.low;
            node.rounded.high = node.rounded.low;
        }
        self
    }

    /// The sine of turns, within a quarter either way.
    pub fn sine(self) -> Self {
        self.of(self, Op::Sine(self.index), |x, _| x.sine(), Lost::of)
    }

    fn is_power_of_two(self) -> bool {
        let Range { low, high } = self.rounded();
        low == high && low.to_bits() << 12 == 0
    }
}

impl Number for Traced<'_> {
    fn like(self, x: f32) -> Self {
        self.tape.input(Range::only(x.into()))
    }

    fn sqrt(self) -> Self {
        let op = Op::Sqrt(self.index);
        self.of(self, op, |x, _| x.sqrt(), Lost::of)
    }

    fn below(self, other: Self) -> bool {
        let (a, b) = (self.rounded(), other.rounded());
        if a.high < b.low {
            return true;
        }
        if a.low >= b.high {
            return false;
        }
        self.answer()
    }

    fn at_most(self, x: f64) -> Self {
        self.clip(x, x * (1.0 + NEAR));
        self
    }
}

impl Add for Traced<'_> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        self.of(
            other,
            Op::Add(self.index, other.index),
            Range::add,
            Lost::of,
        )
    }
}

impl Sub for Traced<'_> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        let (a, b) = (self.rounded(), other.rounded());
        // The difference of two numbers of which neither is more than twice the other is exact.
        let near = b.low >= 0.5 * a.high && b.high <= 2.0 * a.low;
        let lost = |rounded| {
            if near {
                Lost::NOTHING
            } else {
                Lost::of(rounded)
            }
        };
        self.of(other, Op::Sub(self.index, other.index), Range::sub, lost)
    }
}

impl Mul for Traced<'_> {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        // Powers of two move the exponent alone.
        let moves = self.is_power_of_two() || other.is_power_of_two();
        let lost = |rounded| match Lost::of(rounded) {
            lost if moves => Lost {
                absolute: lost.floor,
                relative: 0.0,
                ..lost
            },
            lost => lost,
        };
        self.of(other, Op::Mul(self.index, other.index), Range::mul, lost)
    }
}

impl Div for Traced<'_> {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        self.of(
            other,
            Op::Div(self.index, other.index),
            Range::div,
            Lost::of,
        )
    }
}
