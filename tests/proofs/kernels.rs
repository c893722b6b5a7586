//! The largest errors of a kernel over its inputs: every `f32` in [0, 1), or every word.

use crate::inputs::in_parts;
use crate::rounding::UNIT;
use crate::unit::{Unit, middle};
use host::errors::{raise, ulp};
use host::speed;
use std::sync::LazyLock;

/// The errors of the f64 truths and sums, many times over.
pub const MARGIN: f64 = 1e-5;

/// An error, and the input where it was met.
#[derive(Clone, Copy, Debug, Default)]
pub struct Extreme {
    pub error: f64,
    at: u32,
}

impl Extreme {
    fn raise(&mut self, error: f64, at: u32) {
        // Not a number would win.
        if error > self.error || error.is_nan() {
            *self = Self { error, at };
        }
    }
}

/// The largest errors towards 0 and away from it, and inputs of large ones.
#[derive(Clone, Debug, Default)]
pub struct Reach {
    pub inward: Extreme,
    pub outward: Extreme,
    /// The largest error away from 0 in steps of `f32`.
    pub steps: f64,
    pub inputs: Vec<u32>,
}

/// How many inputs of large errors of either direction are kept.
const KEPT: usize = 48;

impl Reach {
    /// `least` is the smallest size that an error is compared with.
    fn note(&mut self, found: f32, exact: f64, least: f64, at: u32) {
        let off = f64::from(found) - exact;
        let error = if off == 0.0 {
            0.0
        } else {
            // In ulp of a number just below a power of 2.
            off.abs() / exact.abs().max(least) / UNIT
        };
        if (off > 0.0) == (exact > 0.0) {
            self.outward.raise(error, at);
            raise(&mut self.steps, off.abs() / ulp(exact));
        } else {
            self.inward.raise(error, at);
        }
    }

    /// Of several parts.
    fn of(parts: &[Self]) -> Self {
        let mut reach = Self::default();
        for direction in [|part: &Self| part.inward, |part: &Self| part.outward] {
            let mut extremes: Vec<_> = parts.iter().map(direction).collect();
            extremes.sort_by(|a, b| b.error.total_cmp(&a.error));
            let kept = extremes.iter().take(KEPT).map(|extreme| extreme.at);
            reach.inputs.extend(kept);
        }
        for part in parts {
            reach.inward.raise(part.inward.error, part.inward.at);
            reach.outward.raise(part.outward.error, part.outward.at);
            raise(&mut reach.steps, part.steps);
        }
        reach
    }

    pub fn most(&self) -> f64 {
        self.inward.error.max(self.outward.error)
    }
}

/// One of how many inputs is tried: of every `f32`, of the grid, and of words.
static EVERY: LazyLock<u32> =
    LazyLock::new(|| speed::or_all("one f32 of [0, 1) tried of every", 32_003, 61, 1));
static GRID: LazyLock<u32> =
    LazyLock::new(|| speed::of("one uniform of the grid tried of every", 251, 1));
static WORDS: LazyLock<u32> =
    LazyLock::new(|| speed::or_all("one word tried of every", 40_009, 257, 1));

/// A control, whose faults show anywhere, tries one of so many of these inputs.
pub static FEWER: LazyLock<u32> =
    LazyLock::new(|| speed::of("one input of a control of every", 1, 17));

/// The same over one of every `fewer` uniforms of [0, 1), and over those at which earlier searches met the most; `note` takes
/// one and its bits.
fn over_uniforms(unit: &Unit, fewer: u32, note: impl Fn(&mut Reach, f32, u32) + Sync) -> Reach {
    let each = |reach: &mut Reach, u: f32| note(reach, u, u.to_bits());
    let last = 1.0_f32.to_bits() - 1;
    let mut parts = in_parts(last, *EVERY * fewer, |reach, bits| {
        each(reach, f32::from_bits(bits));
    });
    if *EVERY > 1 {
        parts.extend(in_parts((1 << 24) - 1, *GRID * fewer, |reach, i| {
            each(reach, i as f32 / 16_777_216.0);
        }));
    }
    for u in unit.kept() {
        each(&mut parts[0], u);
    }
    Reach::of(&parts)
}

/// A number so many steps of `f32` farther out.
fn out(x: f32, steps: u32) -> f32 {
    f32::from_bits(x.to_bits() + if x == 0.0 { 0 } else { steps })
}

/// Of samples of uniforms, taken `wrong` steps of `f32` too far out.
pub fn of_uniforms(unit: &Unit, least: f64, wrong: u32, fewer: u32) -> Reach {
    over_uniforms(unit, fewer, |reach, u, at| {
        let x = unit.sample(u);
        reach.note(out(x, wrong), unit.exact(u.into(), x), least, at);
    })
}

/// The same, and of words where a draw keeps the bound.
pub fn of_samples(unit: &Unit, least: f64, wrong: u32, fewer: u32) -> [Reach; 2] {
    let of_words = if unit.has_words() {
        Reach::of(&in_parts(
            u32::MAX,
            *WORDS * fewer,
            |reach: &mut Reach, word| {
                let x = unit.drawn(word);
                reach.note(out(x, wrong), unit.exact(middle(word), x), least, word);
            },
        ))
    } else {
        Reach::default()
    };
    [of_uniforms(unit, least, wrong, fewer), of_words]
}

/// Of densities with samples.
pub fn of_densities(unit: &Unit) -> Reach {
    over_uniforms(unit, 1, |reach, u, at| {
        reach.note(unit.density(u), unit.exact_density(u.into()), 0.0, at);
    })
}

/// How a number is made of its kernel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum By {
    Quotient,
    Product,
    /// A location is added, too.
    ProductAndSum,
}

/// By how many ulp of the exact number it is off at most, whose kernel is off by so many.
///
/// An ulp of numbers below 2ᵏ is 2ᵏ⁻²⁴, and the kernel's relative error counts for most just below 2ᵏ. The rounding of a product
/// or a quotient adds half an ulp. From 2ᵏ on numbers are two ulp apart, and it adds one, but leads back to 2ᵏ what is less
/// than one beyond. A quotient gets there only if its kernel passes 2ᵏ times the divisor, which is a number of `f32`, and so
/// is off by more than a step.
///
/// The sum of two numbers below 2ᵏ is below 2ᵏ⁺¹, where its rounding adds one ulp at most. A sum that the kernel's error takes
/// beyond is no farther off: the product goes beyond 2ᵏ by 6 ulp at most and in steps of two, the other number is at least
/// one below, and numbers beyond 2ᵏ⁺¹ are four ulp apart.
pub fn rounded(reach: &Reach, by: By) -> f64 {
    let [inward, outward] = [reach.inward.error, reach.outward.error];
    let passes = match by {
        By::Quotient => reach.steps >= 1.0,
        _ => outward >= 1.0,
    };
    let beyond = if passes { 1.0 } else { 0.5 };
    let once = (inward + 0.5).max(outward + beyond) + MARGIN;
    if by == By::ProductAndSum {
        assert!(outward < 7.0);
        once + 1.0
    } else {
        once
    }
}

/// What is relatively off at most, of a product that is rounded so often after its kernel.
pub fn rounded_relatively(reach: &Reach, roundings: i32) -> f64 {
    (1.0 + (reach.most() + MARGIN) * UNIT) * (1.0 + UNIT).powi(roundings) - 1.0
}
