//! Student's t in the plane.

use super::degrees::{Degrees, Square};
use super::direction::azimuth;
use super::location_scale::peak_of_pair;
use super::planar::{PlanarMap, planar};
use super::{Invert, Warp};
use crate::error::{Error, tried};
use crate::tier::Tier;
use core::marker::PhantomData;

/// Student's t in the plane: a point whose coordinates are two Student's t of one outlier, with common degrees of freedom.
///
/// Radius σ√ν √((1 − u₁)^(−2/ν) − 1), angle u₂ turns, Bailey's form. Each coordinate alone is a [`StudentT`](super::StudentT);
/// they are not independent, since a far point is far in both.
///
#[cfg_attr(doc, doc = include_str!("../pictures/student_pair.html"))]
///
/// # Density
/// (1 + r²/νσ²)^(−(ν+2)/2)/(2πσ²) per unit area, at least 2⁻¹⁴⁹ for every finite point.
///
/// # Domain
/// - Point: drawn samples end at √ν √(4^(33/ν) − 1) σ from the location: 8.6e9σ for one degree of freedom, 6.8σ for many.
/// - Uniforms: two, radius and angle. u₁ = 0 gives the location itself. Drawing takes all 32 bits of the word of the radius, as
///   the middle of their cell.
/// - Parameters: degrees of freedom above 0 that need not be whole, a finite location and a scale above 0, for which neither
///   samples nor the density overflow: at a scale of 1, from 0.27 degrees on.
///
/// # Accuracy
/// *Sample* is the distance from the exact point, relative to the farther of the exact point's distance from the location and
/// of the location's coordinates from 0, and at least to 2⁻¹²⁶. *Pdf* and *realised density* are relative, *inverse* and *round trip* are absolute
/// errors of the uniforms. [What each row means](crate::warp#stated-errors).
///
/// | error | bound | kind |
/// |---|--:|---|
/// | sample, of the distance or the location | 8.3e-7 | found |
/// | pdf, relative | 7.4e-7 | found |
/// | realised density, relative | 8.6e-7 + 12*s/max(0, 1 - w/1e6) | found |
/// | inverse | 2.1e-7 | found |
/// | round trip | 3e-7 + 4.5*r | found |
///
/// w is the larger |location| over σ; no realised density is stated from 1e6 on. s and r are the relative change of the density
/// and the change of the inverse when the point moves by 2⁻²⁴ of the unit of the sample's error.
///
/// # Cost
/// One draw in `poly`, PCG32 included, takes <!-- figure: cost StudentPair -->148 instructions and 672 bytes of code on an M4F, 7,198 instructions on an M0<!-- -->.
///
/// # Examples
/// ```
/// use microwarp::{Invert, Warp, poly as mw};
/// let track = mw::StudentPair::new(3.0, [0.0, 0.0], 1.0)?; // of three degrees of freedom
/// assert_eq!(track.sample([0.0, 0.7]), [0.0, 0.0]);
/// let [u1, _] = track.invert([1.0, 1.0]);
/// assert!((u1 - 0.535_241_9).abs() < 1e-6); // 1 - (5/3)^(-3/2)
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// # See also
/// - [`StudentT`](super::StudentT): one number.
/// - [`NormalPair`](super::NormalPair): many degrees of freedom, at a lower cost.
///
/// # Source
/// R. W. Bailey, "Polar Generation of Random Variates with the t-Distribution", 1994,
/// <https://doi.org/10.1090/S0025-5718-1994-1219702-8>. The forms free of cancellation are this crate's own.
#[doc(alias = "t_distribution")]
#[doc(alias = "bivariate_t")]
#[doc(alias = "moffat")]
#[doc(alias = "heavy_tail")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct StudentPair<T> {
    degrees: Degrees,
    location: [f32; 2],
    scale: f32,
    /// The density at the location.
    peak: f32,
    tier: PhantomData<T>,
}

impl<T: Tier> StudentPair<T> {
    /// Student's t with these degrees of freedom about a location, with a scale of each coordinate.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for NaN or infinity, [`Error::NotPositive`] for degrees or a scale of 0 or less,
    /// [`Error::TooLarge`] if a sample could overflow or the density vanish, [`Error::Empty`] if the density could overflow.
    pub const fn new(degrees: f32, location: [f32; 2], scale: f32) -> Result<Self, Error> {
        let (degrees, reach) = tried!(Degrees::new(degrees));
        Ok(Self {
            degrees,
            location,
            scale,
            peak: tried!(peak_of_pair(location, scale, reach, 1)),
            tier: PhantomData,
        })
    }

    /// The degrees of freedom.
    #[must_use]
    pub const fn degrees(&self) -> f32 {
        self.degrees.count
    }

    /// The location.
    #[must_use]
    pub const fn location(&self) -> [f32; 2] {
        self.location
    }

    /// The scale of each coordinate.
    #[must_use]
    pub const fn scale(&self) -> f32 {
        self.scale
    }

    /// The squared distance of a point from the location, in units of the scale.
    #[inline]
    fn square(&self, [x, y]: [f32; 2]) -> Square {
        let [a, b] = self.location;
        Square::of(x, a, self.scale).plus(Square::of(y, b, self.scale))
    }
}

impl<T: Tier> PlanarMap<2> for StudentPair<T> {
    #[inline]
    fn first(&self, u1: f32) -> f32 {
        self.scale * self.degrees.radius(u1)
    }

    #[inline]
    fn first_of_word(&self, word: u32) -> f32 {
        self.scale * self.degrees.radius_of_word(word)
    }

    #[inline]
    fn map_to(&self, radius: f32, u2: f32, to: &mut [f32; 2]) {
        let [a, b] = self.location;
        let (x, y) = T::polar(radius, u2);
        *to = [a + x, b + y];
    }
}

impl<T: Tier> Warp for StudentPair<T> {
    // One by one: the logarithm of a word is by a table.
    planar!(2, where false);

    #[inline]
    fn pdf(&self, point: [f32; 2]) -> f32 {
        let [x, y] = point;
        if x.is_finite() && y.is_finite() {
            let square = self.square(point);
            self.degrees.density::<T>(self.peak, square, 2.0)
        } else {
            0.0
        }
    }
}

impl<T: Tier> Invert for StudentPair<T> {
    #[inline]
    fn invert(&self, point: [f32; 2]) -> [f32; 2] {
        let ([x, y], [a, b]) = (point, self.location);
        let u1 = self.degrees.uniform::<T>(self.square(point));
        [u1, azimuth::<T>(x - a, y - b)]
    }
}
