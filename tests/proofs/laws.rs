//! The laws of the line whose samples are a kernel, made of the uniform alone, that the parameters scale and move.

use crate::kernels::By;
use host::registry::{Registered, registered};

/// How a sample is made of parameters and a kernel. Under the parameters `unit` it is the kernel itself.
pub struct Sample {
    pub unit: &'static [f32],
    pub by: fn(&[f32], f32) -> f32,
}

/// How the density with a sample is made of parameters and a kernel, and how often it is rounded then. Under the parameters `unit`
/// it is 2⁶⁰ times the kernel, a normal number for every uniform.
pub struct Density {
    pub unit: &'static [f32],
    by: fn(&[f32], f64) -> f64,
    pub roundings: i32,
}

const LIFT: f32 = (1_u64 << 60) as f32;

impl Density {
    pub fn of(&self, p: &[f32], lifted: f32) -> f32 {
        (self.by)(p, f64::from(lifted) / f64::from(LIFT)) as f32
    }
}

pub struct Law {
    pub name: &'static str,
    pub sample: Sample,
    pub form: By,
    /// Whether both tiers have the same samples.
    pub shared: bool,
    /// The error counts in ulp of the scale where the distance from the location is smaller.
    pub or_scale: bool,
    pub density: Option<Density>,
}

/// 1/√(2π) and 1/π, whose quotients by a scale are the peaks of two laws.
const FRAC_1_SQRT_TAU: f32 = 0.398_942_3;
const FRAC_1_PI: f32 = std::f32::consts::FRAC_1_PI;

const fn law(name: &'static str, form: By, by: fn(&[f32], f32) -> f32) -> Law {
    Law {
        name,
        sample: Sample { unit: &[1.0], by },
        form,
        shared: false,
        or_scale: false,
        density: None,
    }
}

impl Law {
    /// With a density in proportion to a rate.
    const fn with_rate(mut self) -> Self {
        self.density = Some(Density {
            unit: &[LIFT],
            by: |p, k| f64::from(p[0]) * k,
            roundings: 1,
        });
        self
    }

    /// With a density in proportion to a rounded quotient by the scale, the last parameter.
    const fn with_peak(mut self, unit: &'static [f32], by: fn(&[f32], f64) -> f64) -> Self {
        self.density = Some(Density {
            unit,
            by,
            roundings: 2,
        });
        self
    }

    const fn of_location_and_scale(name: &'static str) -> Self {
        Self {
            sample: Sample {
                unit: &[0.0, 1.0],
                by: |p, t| p[0] + p[1] * t,
            },
            ..law(name, By::ProductAndSum, |_, _| f32::NAN)
        }
    }

    /// One whose kernel is a table of both tiers, and that counts in ulp of the scale, too.
    const fn shared(mut self) -> Self {
        (self.shared, self.or_scale) = (true, true);
        self
    }

    /// What the smallest distance is that counts, in units of the scale.
    pub fn least(&self) -> f64 {
        f64::from(u8::from(self.or_scale))
    }

    /// Its constructor in each tier whose samples are its own.
    pub fn of_tiers(&self) -> Vec<Registered> {
        let tiers: &[_] = if self.shared {
            &["poly"]
        } else {
            &["libm", "poly"]
        };
        tiers
            .iter()
            .filter_map(|tier| self.registered(tier))
            .collect()
    }

    /// Its constructor in a tier; nothing where the type has no tier and this is not `poly`.
    pub fn registered(&self, tier: &str) -> Option<Registered> {
        registered_as(self.name, tier)
    }
}

fn registered_as(name: &str, tier: &str) -> Option<Registered> {
    let mut all = registered().into_iter();
    all.find(|of| of.name == name && of.tier == tier)
}

/// The constructor of that name among those registered.
pub fn by_constructor<'a>(all: &'a [Registered], name: &str, constructor: &str) -> &'a Registered {
    let mut all = all.iter();
    let found = all.find(|of| (of.name, of.constructor) == (name, constructor));
    found.expect("a constructor")
}

/// The constructor of that name in a tier.
pub fn by_name(name: &str, tier: &str) -> Registered {
    registered_as(name, tier).expect("a law")
}

pub const LAWS: [Law; 9] = [
    law("Exponential", By::Quotient, |p, t| t / p[0]).with_rate(),
    law("ExponentialTail", By::Quotient, |p, t| t / p[0]).with_rate(),
    law("Rayleigh", By::Product, |p, t| p[0] * t)
        .with_peak(&[1.0 / LIFT], |p, k| peak(1.0, p[0], k)),
    // The last number below the radius stands for the radius, to which a product by the last below 1 may round.
    law("Tent", By::Product, |p, t| {
        let last = f32::from_bits(p[0].to_bits() - 1);
        (p[0] * t).clamp(-last, last)
    }),
    Law::of_location_and_scale("Normal").with_peak(&[0.0, FRAC_1_SQRT_TAU / LIFT], |p, k| {
        peak(FRAC_1_SQRT_TAU, p[1], k)
    }),
    Law::of_location_and_scale("Cauchy")
        .with_peak(&[0.0, FRAC_1_PI / LIFT], |p, k| peak(FRAC_1_PI, p[1], k)),
    Law::of_location_and_scale("Laplace").with_peak(&[0.0, 0.5 / LIFT], |p, k| peak(0.5, p[1], k)),
    Law::of_location_and_scale("Logistic")
        .shared()
        .with_peak(&[0.0, 1.0 / LIFT], |p, k| peak(1.0, p[1], k)),
    Law::of_location_and_scale("Gumbel")
        .shared()
        .with_peak(&[0.0, 1.0 / LIFT], |p, k| peak(1.0, p[1], k)),
];

/// A kernel times the peak of a density.
fn peak(of_standard: f32, scale: f32, kernel: f64) -> f64 {
    f64::from(of_standard / scale) * kernel
}
