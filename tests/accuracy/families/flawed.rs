//! A sampler with a planted defect, which the search must find within its quick budget.

use host::adversary::words::Kind::{Any, Positive};
use host::{
    registry::{Domain, Measure, Registered, entry, power},
    truth,
};
use microwarp::tier::Tier;
use microwarp::uniform::Canonical;
use microwarp::warp::Power;
use microwarp::{Error, Invert, Warp};

/// The power law by the exponential of one quotient, which leaves the range of `f32` where the sample does not; a clamp
/// hides it. It is right to some 60 ulp for most parameters and wrong over many decades near n = −1.
#[derive(Clone, Copy)]
struct Overflowing<T> {
    warp: Power<T>,
    m: f32,
    a: f32,
    b: f32,
}

impl<T: Tier> Warp for Overflowing<T> {
    type Uniforms = f32;
    type Point = f32;
    type Density = f32;

    fn sample_canonical(&self, u: Canonical<f32>) -> f32 {
        let Self { m, a, b, .. } = *self;
        let u = u.get();
        let span = T::ln(b) - T::ln(a);
        let (anchor, near, away) = if m < 0.0 {
            (a, 1.0 - u, u)
        } else {
            (b, u, 1.0 - u)
        };
        let mixed = near + away * T::exp(-m.abs() * span);
        (anchor * T::exp(T::ln(mixed) / m)).clamp(a, b)
    }

    fn pdf(&self, x: f32) -> f32 {
        self.warp.pdf(x)
    }
}

impl<T: Tier> Invert for Overflowing<T> {
    fn invert(&self, x: f32) -> f32 {
        self.warp.invert(x)
    }
}

pub(super) fn overflowing<T: Tier>() -> Registered {
    let constructor = "with an exponential that overflows alone";
    let takes = &[Any, Positive, Positive];
    let mut of = Registered::new("Power", constructor, takes, |p| {
        let [n, a, b] = [p[0], p[1], p[2]];
        let warp = Power::<T>::new(n, a, b)?;
        // What it does at n = −1 exactly and from 0 is another branch.
        let m = n + 1.0;
        if m == 0.0 || a == 0.0 {
            return Err(Error::OutOfRange(0));
        }
        let warp = Overflowing { warp, m, a, b };
        let truth = truth::power(n, a, b, true);
        let entry = entry::<T, _>("Power", Domain::Line, Measure::Ulp, warp, truth);
        Ok(entry.variables(&power::variables(p)))
    });
    of.tier = T::NAME;
    of
}
