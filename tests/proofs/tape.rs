//! How far what a program of `f32` returns may be from what the same program in real numbers returns, over a box of inputs.
//!
//! Operation i returns its exact result times 1 + δᵢ, or plus δᵢ: what was rounded. With all δᵢ the program is the one of `f32`,
//! with none the one in real numbers. By the mean value theorem the two differ by the sum of δᵢ times the derivative by δᵢ,
//! taken for some numbers between. The derivatives are worked out backwards in ranges that hold all numbers between.

use crate::number::Number;
use crate::range::Range;
use crate::rounding::Lost;
use std::cell::{Cell, RefCell};

#[derive(Clone, Copy)]
pub enum Op {
    Input,
    Add(usize, usize),
    Sub(usize, usize),
    Mul(usize, usize),
    Div(usize, usize),
    Sqrt(usize),
    /// Of turns, within a quarter either way.
    Sine(usize),
}

pub struct Node {
    op: Op,
    /// The value with all rounding, with none, and on the way between.
    pub value: Range,
    /// With all rounding.
    pub rounded: Range,
    /// How far apart these may be, relatively.
    drift: f64,
    pub lost: Lost,
}

/// Values that are no farther apart than this are as good as one where an error is relative to them.
pub const NEAR: f64 = 1e-5;

/// The record of a run.
#[derive(Default)]
pub struct Tape {
    pub nodes: RefCell<Vec<Node>>,
    exact: Cell<bool>,
    /// The answers to questions that the ranges leave open, and how many were asked.
    pub answers: Cell<u32>,
    pub asked: Cell<u32>,
    /// Whether what is said of a number leaves none.
    pub impossible: Cell<bool>,
}

#[derive(Clone, Copy)]
pub struct Traced<'a> {
    pub tape: &'a Tape,
    pub index: usize,
}

impl Tape {
    /// What an operation makes of the values, and of the rounded ones, of which it rounds so much.
    fn push(
        &self,
        op: Op,
        [value, rounded]: [Range; 2],
        lost: impl Fn(Range) -> Lost,
    ) -> Traced<'_> {
        let exact = self.exact.get();
        let mut lost = if exact { Lost::NOTHING } else { lost(rounded) };
        // Rounding never changes an order.
        let nearest = |x: f64| if exact { x } else { f64::from(x as f32) };
        let rounded = Range {
            low: nearest(rounded.low),
            high: nearest(rounded.high),
        };
        let mut nodes = self.nodes.borrow_mut();
        let drift = |j: usize| nodes[j].drift;
        let before = match op {
            Op::Input => 0.0,
            Op::Add(a, b) if value.low > 0.0 => drift(a).max(drift(b)),
            Op::Add(..) => f64::INFINITY,
            Op::Sub(a, b) => {
                let [a, b] = [a, b].map(|j| nodes[j].drift * nodes[j].value.size());
                (a + b) / value.low.max(0.0)
            }
            Op::Mul(a, b) | Op::Div(a, b) => drift(a) + drift(b),
            Op::Sqrt(a) | Op::Sine(a) => drift(a),
        };
        let drift = (before + lost.relative) * (1.0 + NEAR);
        // Whether the error is written as a part of the value, or as a difference from it.
        let value = if matches!(op, Op::Input) {
            value
        } else if drift <= NEAR {
            let floor = lost.floor;
            value
                * Range {
                    low: 1.0 - lost.relative,
                    high: 1.0 + lost.relative,
                }
                .wider(0.0)
                + Range::both(floor)
        } else {
            lost.relative = f64::INFINITY;
            value.wider(lost.absolute)
        };
        nodes.push(Node {
            op,
            value,
            rounded,
            drift,
            lost,
        });
        Traced {
            tape: self,
            index: nodes.len() - 1,
        }
    }

    pub fn input(&self, value: Range) -> Traced<'_> {
        self.push(Op::Input, [value; 2], |_| Lost::NOTHING)
    }

    /// Whether no inputs of the box take this way.
    pub fn is_impossible(&self) -> bool {
        self.impossible.get()
    }

    /// Runs a part without rounding.
    pub fn exactly<T>(&self, run: impl FnOnce() -> T) -> T {
        self.exact.set(true);
        let made = run();
        self.exact.set(false);
        made
    }

    /// A bound on the error of the sum of outputs, each times a factor of a range.
    pub fn error(&self, outputs: &[(Traced, Range)]) -> f64 {
        let sums = outputs.iter();
        self.sum(sums.map(|(output, factor)| (*output, *factor, *factor * output.value())))
    }

    /// A bound on the relative error of an output.
    pub fn relative_error(&self, output: Traced) -> f64 {
        let one = Range::only(1.0);
        self.sum([(output, one / output.value(), one)])
    }

    /// Of a sum of which the derivatives by outputs are given, and these times the outputs.
    fn sum<'a>(&self, outputs: impl IntoIterator<Item = (Traced<'a>, Range, Range)>) -> f64 {
        let by = self.derivatives(outputs);
        let nodes = self.nodes.borrow();
        let mut sum = 0.0;
        for (node, [d, s]) in nodes.iter().zip(by).rev() {
            let lost = node.lost;
            let part = |size: f64, of: Range| if size == 0.0 { 0.0 } else { size * of.size() };
            // The smaller, or the one that is a number.
            sum += part(lost.absolute, d).min(part(lost.relative, s) + part(lost.floor, d));
        }
        sum * (1.0 + 3.0 * NEAR)
    }

    /// The derivatives of such a sum by all values, and these times the values.
    pub fn derivatives<'a>(
        &self,
        outputs: impl IntoIterator<Item = (Traced<'a>, Range, Range)>,
    ) -> Vec<[Range; 2]> {
        let nodes = self.nodes.borrow();
        // The derivative of the sum by each value, and that times the value.
        let mut by = vec![Range::only(0.0); nodes.len()];
        let mut scaled = by.clone();
        for (output, derivative, times_value) in outputs {
            let i = output.index;
            by[i] = by[i] + derivative;
            scaled[i] = scaled[i] + times_value;
        }
        for (i, node) in nodes.iter().enumerate().rev() {
            let value = node.value;
            scaled[i] = scaled[i].and(by[i] * value);
            by[i] = by[i].and(scaled[i] / value);
            let (d, s) = (by[i], scaled[i]);
            let mut add = |j: usize, more: Range, more_scaled: Range| {
                let v = nodes[j].value;
                by[j] = by[j] + more.and(more_scaled / v);
                scaled[j] = scaled[j] + more_scaled.and(more * v);
            };
            let minus = |x: Range| x.times(-1.0);
            match node.op {
                Op::Input => {}
                Op::Add(a, b) => {
                    let [x, y] = [a, b].map(|j| nodes[j].value);
                    add(a, d, s * x.share(y));
                    add(b, d, s * y.share(x));
                }
                Op::Sub(a, b) => {
                    let [x, y] = [a, b].map(|j| nodes[j].value);
                    add(a, d, d * x);
                    add(b, minus(d), minus(d * y));
                }
                Op::Mul(a, b) if a == b => add(
                    a,
                    d * nodes[a].value * Range::only(2.0),
                    s * Range::only(2.0),
                ),
                Op::Mul(a, b) => {
                    let [x, y] = [a, b].map(|j| nodes[j].value);
                    add(a, d * y, s);
                    add(b, d * x, s);
                }
                Op::Div(a, b) => {
                    let y = nodes[b].value;
                    add(a, d / y, s);
                    add(b, minus(d * value / y), minus(s));
                }
                Op::Sqrt(a) => add(a, d / (value * Range::only(2.0)), s * Range::only(0.5)),
                Op::Sine(a) => {
                    let turns = nodes[a].value;
                    add(a, d * turns.slope_of_sine(), s * turns.sine_relatively());
                }
            }
        }
        by.into_iter().zip(scaled).map(|(d, s)| [d, s]).collect()
    }
}

impl<'a> Traced<'a> {
    pub fn value(self) -> Range {
        self.tape.nodes.borrow()[self.index].value
    }

    pub fn rounded(self) -> Range {
        self.tape.nodes.borrow()[self.index].rounded
    }

    /// The same number with an error of its own, of so many halves of an ulp.
    pub fn off(self, halves: f64) -> Self {
        self.off_by(Lost::of(self.rounded()).times(halves))
    }

    /// The same of an error that is known otherwise.
    pub fn off_by(self, lost: Lost) -> Self {
        let ranges = [self.value(), self.rounded().wider(lost.absolute)];
        // As a product with 1.
        let one = self.like(1.0);
        let op = Op::Mul(self.index, one.index);
        self.tape.push(op, ranges, |_| lost)
    }

    pub fn of(
        self,
        other: Self,
        op: Op,
        apply: fn(Range, Range) -> Range,
        lost: impl Fn(Range) -> Lost,
    ) -> Self {
        let ranges = [
            apply(self.value(), other.value()),
            apply(self.rounded(), other.rounded()),
        ];
        self.tape.push(op, ranges, lost)
    }
}

/// Runs what makes a record, once for each way that the questions of the program may be answered.
pub fn each_way(mut run: impl FnMut(&Tape)) {
    let (mut answers, mut ways) = (0, 1);
    while answers < ways {
        let tape = Tape::default();
        tape.answers.set(answers);
        run(&tape);
        answers += 1;
        ways = ways.max(1 << tape.asked.get());
    }
}
