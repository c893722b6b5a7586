//! The largest relative errors of functions of one number, over every `f32`, by parts of binades.

use crate::inputs::in_parallel;
use crate::kernels::MARGIN;
use crate::range::Range;
use crate::rounding::UNIT;
use host::errors::raise;
use host::speed;

/// What is added to errors of either sign.
const ABOVE_0: f64 = 8.0;

/// A relative error in units of 2⁻²⁴.
pub fn relative(x: f32, exact: f64) -> f64 {
    (f64::from(x) - exact).abs() / exact.abs() / UNIT
}

/// Parts of a binade of an argument, each of so many bits, of which the first begins here, and the largest relative error of each in
/// units of 2⁻²⁴.
pub struct Swept {
    bits: u32,
    first: u32,
    most: Vec<f64>,
}

impl Swept {
    /// Of eighths of a binade, of arguments from one to another, of several errors of each.
    pub fn of<const N: usize>(
        ends: [f32; 2],
        stride: u32,
        errors: impl Fn(f32) -> [f64; N] + Sync,
    ) -> [Self; N] {
        Self::of_parts(20, ends, stride, errors)
    }

    /// The same of parts of so many bits.
    fn of_parts<const N: usize>(
        bits: u32,
        [low, high]: [f32; 2],
        stride: u32,
        errors: impl Fn(f32) -> [f64; N] + Sync,
    ) -> [Self; N] {
        let [first, last] = [low, high].map(|x| x.to_bits() >> bits);
        let most = in_parallel(last - first + 1, |i| {
            let mut worst = [0.0; N];
            let start = (first + i) << bits;
            for x in (start..=start + (1 << bits)).step_by(stride as usize) {
                let errors = errors(f32::from_bits(x));
                for (worst, error) in worst.iter_mut().zip(errors) {
                    raise(worst, error);
                }
            }
            worst
        });
        std::array::from_fn(|i| {
            let most = most.iter().map(|worst| worst[i] + MARGIN).collect();
            Self { bits, first, most }
        })
    }

    /// Of a kernel.
    pub fn kernel(
        ends: [f32; 2],
        kernel: impl Fn(f32) -> f32 + Sync,
        exact: impl Fn(f64) -> f64 + Sync,
    ) -> Self {
        let stride = speed::or_all("one argument of a logarithm tried of every", 32_003, 61, 1);
        let [swept] = Self::of(ends, stride, |x| [relative(kernel(x), exact(x.into()))]);
        swept
    }

    /// The same of 64 parts of a binade, upward and downward: of every argument, or in the quick speed of some.
    pub fn both_ways(
        ends: [f32; 2],
        kernel: impl Fn(f32) -> f32 + Sync,
        exact: impl Fn(f64) -> f64 + Sync,
    ) -> [Self; 2] {
        let stride = speed::or_all(
            "one argument of a sine or an angle tried of every",
            509,
            61,
            1,
        );
        Self::of_parts(17, ends, stride, |x| {
            let exact = exact(x.into());
            let error = (f64::from(kernel(x)) / exact - 1.0) / UNIT;
            [error, -error].map(|error| ABOVE_0 + error)
        })
    }

    /// Of errors of both ways over a range: the middle one, and how far others are from it.
    pub fn about([up, down]: &[Self; 2], range: Range) -> [f64; 2] {
        let [high, low] = [up.over(range) - ABOVE_0, ABOVE_0 - down.over(range)];
        [0.5 * (high + low), 0.5 * (high - low)]
    }

    /// The largest over a range. Of smaller arguments it is that of the first.
    pub fn over(&self, Range { low, high }: Range) -> f64 {
        let place = |x: f64| (x as f32).to_bits() >> self.bits;
        let [low, high] = [low * (1.0 - 1e-6), high * (1.0 + 1e-6)].map(place);
        let last = self.first + self.most.len() as u32 - 1;
        let [low, high] = [low, high].map(|x| x.clamp(self.first, last) - self.first);
        let all = &self.most[low as usize..=high as usize];
        all.iter().copied().fold(0.0, f64::max)
    }
}
