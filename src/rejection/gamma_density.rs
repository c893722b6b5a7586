//! Densities of the gamma family: products of powers that nearly cancel. Their logarithms are summed as pairs of floats before
//! the one exponential, so that a shape of a million costs few digits. Both tiers share this file.

use crate::num::{
    Scaled, above_zero, pair, power_of_two, product, remainder, representable, two_sum,
};
use crate::tier::{LOG2_E, log2_of_sum, times};

/// A quotient, (significand + rest)·2^exponent.
#[derive(Clone, Copy)]
struct Ratio {
    significand: f32,
    rest: f32,
    exponent: i32,
}

impl Ratio {
    /// Of two positive numbers.
    #[inline]
    const fn of(x: f32, divisor: f32) -> Self {
        let (significand, exponent) = Scaled::of(x).parts();
        let whole = Self {
            significand,
            rest: 0.0,
            exponent,
        };
        whole.over(divisor)
    }

    #[inline]
    const fn over(self, divisor: f32) -> Self {
        let (divisor, exponent) = Scaled::of(divisor).parts();
        let significand = self.significand / divisor;
        let short = remainder(self.significand, significand, divisor);
        Self {
            significand,
            rest: (short + self.rest) / divisor,
            exponent: self.exponent.wrapping_sub(exponent),
        }
    }

    /// The binary logarithm, a head and a rest, good to 2^-33 of itself.
    #[inline]
    const fn log2(self) -> (f32, f32) {
        log2_of_sum(self.significand, self.rest, -(self.exponent as f32))
    }

    /// The number and its rest; at least 2^-121 and below 2^121.
    #[inline]
    fn value(self) -> (f32, f32) {
        let scale = power_of_two(self.exponent.clamp(-120, 120));
        (self.significand * scale, self.rest * scale)
    }
}

/// More than the exponents of any product.
const FAR: f32 = 2e6;

/// A sum of binary logarithms, as a number and a rest.
#[derive(Clone, Copy)]
struct Bits(f32, f32);

impl Bits {
    #[inline]
    const fn plus(self, (exact, small): (f32, f32)) -> Self {
        let (sum, dropped) = two_sum(self.0, exact);
        Self(sum, self.1 + (dropped + small))
    }

    /// A number times 2 to this power.
    #[inline]
    const fn of(self, number: Scaled) -> Scaled {
        let (sum, rest) = two_sum(self.0, self.1);
        // Beyond this any density is 0 or infinite, and the power takes no more.
        if sum > FAR {
            number.raised(FAR as i32)
        } else if sum < -FAR {
            number.raised(-FAR as i32)
        } else {
            number.times_exp2(sum, rest)
        }
    }
}

/// √(a/2π)/e^x of a shape, x what ln Γ(a + 1) has above Stirling's formula: the density a Γ(a + 1)⁻¹ (a/e)^a of x = a, times a.
///
/// A small shape is raised to 8 and more by Γ(a + 1) = a Γ(a).
// With a loop that counts, so that the compiler sees that it ends, and leaves it out where no density is asked for.
#[allow(clippy::inline_always, reason = "what is not used is not computed")]
#[cfg_attr(not(target_family = "wasm"), inline(always))]
pub(super) const fn peak(shape: f32) -> Scaled {
    // ½ log₂ 2π.
    const LOG2_SQRT_TAU: (f32, f32) = pair(1.325_748_064_736_159_3);
    let (mut rising, mut steps, mut top) = ((1.0, 0.0), 0.0, (shape, 0.0));
    let mut left = 8_u32;
    while left > 0 && top.0 < 8.0 {
        left = left.wrapping_sub(1);
        rising = product(rising, top);
        steps += 1.0;
        top = two_sum(shape, steps);
    }
    let r = 1.0 / top.0;
    let s = r * r;
    let excess = r * (1.0 / 12.0 - s * (1.0 / 360.0 - s * (1.0 / 1260.0 - s * (1.0 / 1680.0))));
    let log = log2_of_sum(top.0, top.1, 0.0);
    let mut bits = Bits(
        -LOG2_SQRT_TAU.0,
        -LOG2_SQRT_TAU.1 + rising.1 / rising.0 * LOG2_E.0,
    )
    .plus(times(log, 0.5))
    .plus(times(LOG2_E, -excess));
    if steps > 0.0 {
        bits = bits
            .plus(times(LOG2_E, steps))
            .plus(times(Scaled::of(shape).log2(), shape))
            .plus(times(log, -top.0))
            .plus((0.0, -top.1 * log.0));
    }
    bits.of(Scaled::of(rising.0))
}

/// The density of a gamma number x above 0, peak/x·(y/a)^a e^(a − y), y = x/scale.
#[inline]
pub(super) fn of_number(x: f32, shape: f32, scale: f32, peak: Scaled) -> f32 {
    let y = Ratio::of(x, scale);
    let (near, rest) = y.value();
    let (away, dropped) = two_sum(shape, -near);
    let bits = Bits(0.0, (dropped - rest) * core::f32::consts::LOG2_E)
        .plus(times(y.over(shape).log2(), shape))
        .plus(times(LOG2_E, away));
    representable(bits.of(peak.over(Scaled::of(x))).value())
}

/// The density of shares with respect to all but the largest, which counts as what the others leave; `peak` is the product of
/// those of the shapes, over that of their sum. 0 where a share is negative or the sum is not 1 to rounding.
pub(super) fn of_shares<const N: usize>(
    shares: [f32; N],
    shapes: impl Iterator<Item = f32>,
    total: (f32, f32),
    peak: Scaled,
) -> f32 {
    let (mut largest, mut others) = (0.0, (0.0, 0.0));
    for &share in &shares {
        let smaller = if share > largest { largest } else { share };
        largest = if share > largest { share } else { largest };
        let (near, dropped) = two_sum(others.0, smaller);
        others = (near, others.1 + dropped);
    }
    let (left, dropped) = two_sum(1.0, -others.0);
    let (left, left_rest) = two_sum(left, dropped - others.1);
    let whole = (left - largest).abs() <= (N as f32 + 2.0) * f32::EPSILON && left > 0.0;
    if !(whole && shares.iter().all(|share| *share >= 0.0)) {
        return 0.0;
    }
    let (mut bits, mut number, mut met) = (Bits(0.0, 0.0), peak, false);
    for (&share, shape) in shares.iter().zip(shapes) {
        // The first of the largest.
        let last = !met && share >= largest;
        met |= last;
        let (share, rest) = if last {
            (left, left_rest)
        } else {
            (above_zero(share), 0.0)
        };
        let (significand, exponent) = Scaled::of(share).parts();
        // The largest of the shares is far from the smallest numbers, and only it has a rest.
        let rest = rest * power_of_two(0_i32.wrapping_sub(exponent).min(100));
        let expected = product(total, (significand, rest));
        let ratio = Ratio {
            significand: expected.0,
            rest: expected.1,
            exponent,
        };
        bits = bits.plus(times(ratio.over(shape).log2(), shape));
        number = number.over(Scaled::of(share));
    }
    representable(bits.of(number).value())
}
