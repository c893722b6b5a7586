//! The Rayleigh distribution.

use super::direction::{Scaled, UNIT};
use super::exponential::in_means;
use super::grade::{Fine, Grade};
use super::kernel::product::wide;
use super::normal::{bell, outside, radius};
use super::{Density, Uniform};
use crate::error::Error;
use crate::uniform::Canonical;
use crate::warp::{Invert, Warp};
use ::fixed::FixedU32;
use ::fixed::types::extra::LeEqU32;
use core::marker::PhantomData;

/// The Rayleigh distribution, increasing with the uniform: the distance of a [`NormalPair`](super::NormalPair) from its
/// mean, the envelope of narrow-band noise, the size of waves.
///
/// x = σ√(−2 ln(1 − u)).
///
/// # Density
/// x/σ²·e^(−x²/2σ²), at least 2⁻³².
///
/// # Domain
/// - Point: [0, 6.661σ], in the format of σ, cut to its step below.
/// - Uniforms: one word.
/// - Parameter: σ > 0, the standard deviation of the normals, in any unsigned format of 32 bits in which 6.67σ fits.
///
/// # Accuracy
/// *Sample* is relative to σ, beyond a step of the format. *Pdf* is relative to 1/σ, beyond a step of 2⁻³². *Round trip*
/// is the error of the uniform after `sample` and `invert`. σ is n steps of the format.
///
/// | error | fine | coarse | compact | kind |
/// |---|--:|--:|--:|---|
/// | sample, max | 3.3e-6 | 2e-4 | 1.3e-6 | found |
/// | pdf | 7.5e-7 | 5.2e-5 | 1.3e-7 | found |
/// | round trip | 1.4e-6 + 0.81/n | 9.2e-5 + 0.81/n | 1.1e-6 + 0.81/n | found |
///
/// # Cost
/// One draw in `fine`, PCG32 included, takes <!-- figure: cost fixed Rayleigh -->159 instructions and 408 bytes of code on an M0, 76 instructions on an M3<!-- -->.
///
/// # Examples
/// ```
/// use fixed::types::{U0F32, U16F16};
/// use microwarp::{Invert, Warp, fixed as mw};
/// let envelope = mw::Rayleigh::new(U16F16::from_num(5))?;
/// let x = envelope.sample(U0F32::from_num(0.864_664_7_f64));
/// assert!((x.to_num::<f64>() - 10.0).abs() < 3e-5);
/// assert!((envelope.pdf(U16F16::from_num(5)).to_num::<f64>() - 0.121_306_1).abs() < 1e-6);
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// # See also
/// - [`NormalPair`](super::NormalPair) is the point at this distance.
/// - [`Exponential`](super::Exponential) is its square.
///
/// # Source
/// G. E. P. Box and M. E. Muller, "A Note on the Generation of Random Normal Deviates", 1958,
/// <https://doi.org/10.1214/aoms/1177706645>.
#[doc(alias = "envelope")]
#[doc(alias = "fading")]
#[doc(alias = "waves")]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Rayleigh<Frac, G = Fine> {
    sigma: u32,
    /// 1/σ.
    height: Scaled,
    format: PhantomData<(Frac, G)>,
}

/// The largest σ in steps: 6.67σ still fits.
const LARGEST: u32 = 643_923_132;

impl<Frac: LeEqU32, G: Grade> Rayleigh<Frac, G> {
    /// The distance of a pair of normals with this standard deviation from their mean.
    ///
    /// # Errors
    /// [`Error::NotPositive`] for 0, [`Error::TooLarge`] if 6.67σ overflows the format.
    pub const fn new(sigma: FixedU32<Frac>) -> Result<Self, Error> {
        match sigma.to_bits() {
            0 => Err(Error::NotPositive(0)),
            bits if bits > LARGEST => Err(Error::TooLarge(0)),
            bits => Ok(Self {
                sigma: bits,
                height: UNIT.over(Scaled::of(bits as u64, Frac::I32)),
                format: PhantomData,
            }),
        }
    }

    /// σ, which is also the mode.
    #[must_use]
    pub const fn sigma(&self) -> FixedU32<Frac> {
        FixedU32::from_bits(self.sigma)
    }

    /// The distance in units of σ (Q27), below 32.
    #[inline]
    fn standardised(&self, x: FixedU32<Frac>) -> u32 {
        in_means(x.to_bits(), self.sigma).to_bits()
    }
}

impl<Frac: LeEqU32, G: Grade> Warp for Rayleigh<Frac, G> {
    type Uniforms = Uniform;
    type Point = FixedU32<Frac>;
    type Density = Density;

    #[inline]
    fn sample_canonical(&self, u: Canonical<Uniform>) -> FixedU32<Frac> {
        // The radius is in Q29.
        let product = wide(radius::<G>(u.get().to_bits()), self.sigma);
        FixedU32::from_bits((product >> 29) as u32)
    }

    #[inline]
    fn pdf(&self, x: FixedU32<Frac>) -> Density {
        let r = u64::from(self.standardised(x));
        // At most 0.61.
        let shape = (r * u64::from(bell::<G>(r * r))) >> 27;
        self.height.density(shape as u32)
    }
}

impl<Frac: LeEqU32, G: Grade> Invert for Rayleigh<Frac, G> {
    #[inline]
    fn invert(&self, x: FixedU32<Frac>) -> Uniform {
        let r = u64::from(self.standardised(x));
        Uniform::from_bits(outside::<G>(r * r))
    }
}

#[cfg(feature = "defmt")]
impl<Frac, G> defmt::Format for Rayleigh<Frac, G> {
    fn format(&self, f: defmt::Formatter<'_>) {
        defmt::write!(f, "Rayleigh {{ sigma: {=u32} }}", self.sigma);
    }
}
