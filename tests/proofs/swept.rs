//! The largest relative errors of functions of one number, over every `f32`, by parts of binades.

use crate::inputs::in_parallel;
use crate::kernels::MARGIN;
use crate::range::Range;
use crate::rounding::UNIT;
use host::errors::raise;
use host::speed;

/// A relative error in units of 2⁻²⁴.
pub fn relative(x: f32, exact: f64) -> f64 {
    (f64::from(x) - exact).abs() / exact.abs() / UNIT
}

/// Eighths of a binade of an argument, of which the first begins here, and the largest relative error of each in units of 2⁻²⁴.
pub struct Swept {
    first: u32,
    most: Vec<f64>,
}

impl Swept {
    /// Of arguments from one to another, of several errors of each.
    pub fn of<const N: usize>(
        [low, high]: [f32; 2],
        stride: u32,
        errors: impl Fn(f32) -> [f64; N] + Sync,
    ) -> [Self; N] {
        let [first, last] = [low, high].map(|x| x.to_bits() >> 20);
        let most = in_parallel(last - first + 1, |i| {
            let mut worst = [0.0; N];
            let start = (first + i) << 20;
            for bits in (start..=start + (1 << 20)).step_by(stride as usize) {
                let errors = errors(f32::from_bits(bits));
                for (worst, error) in worst.iter_mut().zip(errors) {
                    raise(worst, error);
                }
            }
            worst
        });
        std::array::from_fn(|i| {
            let most = most.iter().map(|worst| worst[i] + MARGIN).collect();
            Self { first, most }
        })
    }

    /// Of a kernel.
    pub fn kernel(
        ends: [f32; 2],
        kernel: impl Fn(f32) -> f32 + Sync,
        exact: impl Fn(f64) -> f64 + Sync,
    ) -> Self {
        let stride = speed::or_all("one argument of a logarithm tried of every", 8009, 61, 1);
        let [swept] = Self::of(ends, stride, |x| [relative(kernel(x), exact(x.into()))]);
        swept
    }

    /// The largest over a range. Of smaller arguments it is that of the first.
    pub fn over(&self, Range { low, high }: Range) -> f64 {
        let place = |x: f64| (x as f32).to_bits() >> 20;
        let [low, high] = [low * (1.0 - 1e-6), high * (1.0 + 1e-6)].map(place);
        let last = self.first + self.most.len() as u32 - 1;
        let [low, high] = [low, high].map(|x| x.clamp(self.first, last) - self.first);
        let all = &self.most[low as usize..=high as usize];
        all.iter().copied().fold(0.0, f64::max)
    }
}
