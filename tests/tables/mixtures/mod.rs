//! `Mixture`: which part a word picks and what is left of the word, by whole numbers; its density, its inverse, and what it refuses.
//! Wrong mixtures are rejected by the same checks.

mod choice;
mod density;
mod inverse;

use microwarp::Warp;
use microwarp::discrete::Mixture;
use microwarp::uniform::Canonical;
use microwarp::warp::{Interval, Length, Measured};
use rand_core::TryRng;

/// The uniform itself, with densities to choose; none may be asked for where there is a `None`.
#[derive(Clone, Copy, Debug)]
struct Known {
    density: Option<f32>,
    with_sample: f32,
}

fn known(density: f32) -> Known {
    Known {
        density: Some(density),
        with_sample: density,
    }
}

impl Warp for Known {
    type Uniforms = f32;
    type Point = f32;
    type Density = f32;

    fn sample_canonical(&self, u: Canonical<f32>) -> f32 {
        u.get()
    }
    fn pdf(&self, _: f32) -> f32 {
        self.density.expect("this density is never asked for")
    }
    fn sample_canonical_with_pdf(&self, u: Canonical<f32>) -> (f32, f32) {
        (u.get(), self.with_sample)
    }
    fn try_draw_with_pdf<R: TryRng + ?Sized>(&self, rng: &mut R) -> Result<(f32, f32), R::Error> {
        Ok((self.try_draw(rng)?, self.with_sample))
    }
}

impl Measured for Known {
    type Measure = Length;
}

/// Uniform in unit intervals from 0 on, each by its weight.
fn steps<const N: usize>(weights: [f32; N]) -> Mixture<[Interval; N], N>
where
    [Interval; N]: microwarp::discrete::Parts<N>,
{
    let parts = std::array::from_fn(|i| Interval::new(i as f32, i as f32 + 1.0).unwrap());
    Mixture::new(parts, &weights).unwrap()
}
