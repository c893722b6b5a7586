//! The warps as textbooks give them, in radians, over whatever elementary functions there are. They take the same
//! uniforms as microwarp's: numbers of the 24-bit grid, a word each.

use core::f32::consts::TAU;
use microwarp::uniform::grid;
use rand_pcg::Pcg32;

/// Elementary functions, and the warps made of them.
pub trait Textbook {
    /// Square root.
    fn sqrt(x: f32) -> f32;
    /// Sine and cosine of an angle in radians.
    fn sin_cos(x: f32) -> (f32, f32);
    /// Natural logarithm.
    fn ln(x: f32) -> f32;
    /// x to the power of y.
    fn powf(x: f32, y: f32) -> f32;

    /// At a distance from the origin, in the direction of a uniform.
    #[inline(always)]
    fn polar(radius: f32, u: f32) -> [f32; 2] {
        let (sin, cos) = Self::sin_cos(TAU * u);
        [radius * cos, radius * sin]
    }

    /// A unit vector of given z.
    #[inline(always)]
    fn around(z: f32, u: f32) -> [f32; 3] {
        let [x, y] = Self::polar(Self::sqrt(1.0 - z * z), u);
        [x, y, z]
    }

    /// A point of the unit disk.
    #[inline(always)]
    fn disk(rng: &mut Pcg32) -> [f32; 2] {
        let radius = Self::sqrt(grid(rng));
        Self::polar(radius, grid(rng))
    }

    /// A unit vector.
    #[inline(always)]
    fn sphere(rng: &mut Pcg32) -> [f32; 3] {
        let z = 1.0 - 2.0 * grid(rng);
        Self::around(z, grid(rng))
    }

    /// A unit vector with z of at least 0.
    #[inline(always)]
    fn hemisphere(rng: &mut Pcg32) -> [f32; 3] {
        let z = grid(rng);
        Self::around(z, grid(rng))
    }

    /// One of density proportional to z.
    #[inline(always)]
    fn cosine_hemisphere(rng: &mut Pcg32) -> [f32; 3] {
        let square = grid(rng);
        let [x, y] = Self::polar(Self::sqrt(square), grid(rng));
        [x, y, Self::sqrt(1.0 - square)]
    }

    /// One of density proportional to zⁿ.
    #[inline(always)]
    fn phong_lobe(n: f32, rng: &mut Pcg32) -> [f32; 3] {
        let z = Self::powf(1.0 - grid(rng), 1.0 / (n + 1.0));
        Self::around(z, grid(rng))
    }

    /// An exponential number of rate 1.
    #[inline(always)]
    fn exponential(rng: &mut Pcg32) -> f32 {
        -Self::ln(1.0 - grid(rng))
    }

    /// Two standard normal numbers (Box and Muller, 1958).
    #[inline(always)]
    fn normal_pair(rng: &mut Pcg32) -> [f32; 2] {
        let radius = Self::sqrt(-2.0 * Self::ln(1.0 - grid(rng)));
        Self::polar(radius, grid(rng))
    }
}

/// The functions of `micromath`.
pub struct Micromath;

impl Textbook for Micromath {
    #[inline(always)]
    fn sqrt(x: f32) -> f32 {
        micromath::F32Ext::sqrt(x)
    }
    #[inline(always)]
    fn sin_cos(x: f32) -> (f32, f32) {
        micromath::F32Ext::sin_cos(x)
    }
    #[inline(always)]
    fn ln(x: f32) -> f32 {
        micromath::F32Ext::ln(x)
    }
    #[inline(always)]
    fn powf(x: f32, y: f32) -> f32 {
        micromath::F32Ext::powf(x, y)
    }
}

/// The functions of `libm`, which are the C library's. Sine and cosine come from one call, which is cheaper than two.
pub struct PlainLibm;

impl Textbook for PlainLibm {
    #[inline(always)]
    fn sqrt(x: f32) -> f32 {
        libm::sqrtf(x)
    }
    #[inline(always)]
    fn sin_cos(x: f32) -> (f32, f32) {
        libm::sincosf(x)
    }
    #[inline(always)]
    fn ln(x: f32) -> f32 {
        libm::logf(x)
    }
    #[inline(always)]
    fn powf(x: f32, y: f32) -> f32 {
        libm::powf(x, y)
    }
}
