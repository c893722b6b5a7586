//! The controls of `accuracy`: formulas of textbooks over functions of three digits, and densities that are 4 % off.

use microwarp::tier::Poly;
use microwarp::uniform::Canonical;
use microwarp::warp::{
    CosineHemisphere, HenyeyGreenstein, Measured, PhongLobe, SolidAngle, Tent, TruncatedExponential,
};
use microwarp::{Error, Warp};
use microwarp_scene::Kit;
use microwarp_scene::vector::{Vector, unit};
use std::f32::consts::{FRAC_1_PI, LN_2, TAU};

/// Functions of about three digits, as the crate `micromath` and many shaders have them.
struct F;

impl F {
    /// One step of Newton's method from a guess by the exponent.
    fn sqrt(x: f32) -> f32 {
        let guess = f32::from_bits((x.to_bits() >> 1) + 0x1fbd_1df5);
        if x > 0.0 {
            0.5 * (guess + x / guess)
        } else {
            0.0
        }
    }

    /// The logarithm to base 2.
    fn log2(x: f32) -> f32 {
        let (exponent, m) = parts(x);
        exponent + ((0.158_25 * m - 1.051_88) * m + 3.047_88) * m - 2.153_62
    }

    fn exp2(x: f32) -> f32 {
        let (whole, part) = (x.floor(), x - x.floor());
        scaled((0.337_19 * part + 0.657_64) * part + 1.001_72, whole)
    }

    /// Of so many turns, from 0 to 1: a parabola over each half, and a parabola of these.
    fn sine(turns: f32) -> f32 {
        let x = if turns < 0.5 { turns } else { turns - 1.0 };
        let y = 16.0 * x * (0.5 - x.abs());
        y * (0.775 + 0.225 * y.abs())
    }
}

/// The exponent of 2, and the rest from 1 to 2.
fn parts(x: f32) -> (f32, f32) {
    let bits = x.to_bits();
    let m = f32::from_bits(bits & 0x007f_ffff | 0x3f80_0000);
    ((bits >> 23) as f32 - 127.0, m)
}

fn scaled(x: f32, exponent: f32) -> f32 {
    if exponent < -126.0 {
        0.0
    } else {
        x * f32::from_bits(((exponent + 127.0) as u32) << 23)
    }
}

/// The kit of these functions. Directions are brought to unit length, as users do.
pub struct Textbook;

/// Which of the laws of directions.
#[derive(Clone, Copy)]
enum Law {
    Cosine,
    Power(f32),
    Scatter(f32),
}

/// A law of directions about +z.
#[derive(Clone, Copy)]
pub struct Lobe(Law);

impl Measured for Lobe {
    type Measure = SolidAngle;
}

impl Warp for Lobe {
    type Uniforms = [f32; 2];
    type Point = Vector;
    type Density = f32;

    fn sample_canonical(&self, u: Canonical<[f32; 2]>) -> Vector {
        let [u, v] = u.get();
        let z = match self.0 {
            Law::Cosine => F::sqrt(1.0 - u),
            Law::Power(n) => F::exp2(F::log2(1.0 - u) / (n + 1.0)).min(1.0),
            Law::Scatter(g) => {
                let s = (1.0 - g * g) / (1.0 + g - 2.0 * g * u);
                (1.0 + g * g - s * s) / (2.0 * g)
            }
        };
        let flat = F::sqrt((1.0 - z * z).max(0.0));
        let quarter_on = if v < 0.75 { v + 0.25 } else { v - 0.75 };
        unit([flat * F::sine(quarter_on), flat * F::sine(v), z])
    }

    fn pdf(&self, [_, _, z]: Vector) -> f32 {
        match self.0 {
            Law::Cosine => z.max(0.0) * FRAC_1_PI,
            Law::Power(n) if z > 0.0 => (n + 1.0) / TAU * F::exp2(n * F::log2(z).min(0.0)),
            Law::Power(_) => 0.0,
            Law::Scatter(g) => {
                let square = 1.0 + g * g - 2.0 * g * z;
                (1.0 - g * g) / (2.0 * TAU * square * F::sqrt(square))
            }
        }
    }
}

/// Distances in fog, by their rate and the part that is scattered before the end.
pub struct Free(f32, f32);

impl Warp for Free {
    type Uniforms = f32;
    type Point = f32;
    type Density = f32;

    fn sample_canonical(&self, u: Canonical<f32>) -> f32 {
        let Self(rate, mass) = *self;
        (F::log2(1.0 - u.get() * mass) * -LN_2 / rate).max(0.0)
    }

    fn pdf(&self, way: f32) -> f32 {
        let Self(rate, mass) = *self;
        rate * F::exp2(-rate * way / LN_2) / mass
    }
}

/// Places in a pixel.
pub struct Filter(f32);

impl Warp for Filter {
    type Uniforms = f32;
    type Point = f32;
    type Density = f32;

    fn sample_canonical(&self, u: Canonical<f32>) -> f32 {
        let u = u.get();
        self.0
            * if u < 0.5 {
                F::sqrt(2.0 * u) - 1.0
            } else {
                1.0 - F::sqrt(2.0 - 2.0 * u)
            }
    }

    fn pdf(&self, x: f32) -> f32 {
        (self.0 - x.abs()).max(0.0) / self.0 / self.0
    }
}

impl Kit for Textbook {
    type Tier = Poly;
    type Cosine = Lobe;
    type Gloss = Lobe;
    type Phase = Lobe;
    type Free = Free;
    type Filter = Filter;

    fn cosine() -> Lobe {
        Lobe(Law::Cosine)
    }

    fn gloss(exponent: f32) -> Result<Lobe, Error> {
        Ok(Lobe(Law::Power(exponent)))
    }

    fn phase(asymmetry: f32) -> Result<Lobe, Error> {
        Ok(Lobe(Law::Scatter(asymmetry)))
    }

    fn free(rate: f32, length: f32) -> Result<Free, Error> {
        let mass = 1.0 - F::exp2(-rate * length / LN_2);
        if mass > 0.0 {
            Ok(Free(rate, mass))
        } else {
            Err(Error::Empty(1))
        }
    }

    fn filter(radius: f32) -> Result<Filter, Error> {
        Ok(Filter(radius))
    }
}

/// Densities that are 4 % too large.
#[derive(Clone, Copy)]
pub struct Off<W>(W);

impl<W: Measured<Density = f32>> Measured for Off<W> {
    type Measure = W::Measure;
}

impl<W: Warp<Density = f32>> Warp for Off<W> {
    type Uniforms = W::Uniforms;
    type Point = W::Point;
    type Density = f32;

    fn sample_canonical(&self, u: Canonical<W::Uniforms>) -> W::Point {
        self.0.sample_canonical(u)
    }

    fn pdf(&self, x: W::Point) -> f32 {
        1.04 * self.0.pdf(x)
    }
}

/// The tier `poly` with such densities.
pub struct FourPercent;

impl Kit for FourPercent {
    type Tier = Poly;
    type Cosine = Off<CosineHemisphere<Poly>>;
    type Gloss = Off<PhongLobe<Poly>>;
    type Phase = Off<HenyeyGreenstein<Poly>>;
    type Free = Off<TruncatedExponential<Poly>>;
    type Filter = Tent;

    fn cosine() -> Self::Cosine {
        Off(Poly::cosine())
    }

    fn gloss(exponent: f32) -> Result<Self::Gloss, Error> {
        Poly::gloss(exponent).map(Off)
    }

    fn phase(asymmetry: f32) -> Result<Self::Phase, Error> {
        Poly::phase(asymmetry).map(Off)
    }

    fn free(rate: f32, length: f32) -> Result<Self::Free, Error> {
        Poly::free(rate, length).map(Off)
    }

    fn filter(radius: f32) -> Result<Tent, Error> {
        Poly::filter(radius)
    }
}
