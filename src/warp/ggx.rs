//! Microfacet normals of Trowbridge and Reitz (GGX): all of them, and those that a viewer sees.

mod masking;

use super::contract::drawn_by;
use super::direction::{azimuth, is_direction, length, normalised};
use super::planar::{PlanarMap, planar};
use super::{Invert, Warp};
use crate::error::{Error, positive, tried};
use crate::num::vector::{copied, is_ordinary, scaled};
use crate::num::{above_zero, into_unit, remainder, representable};
use crate::tier::{Tier, sqrt};
use core::f32::consts::FRAC_1_PI;
use core::marker::PhantomData;

/// The roughnesses that are accepted.
const SMOOTHEST: f32 = 1e-4;
const ROUGHEST: f32 = 1.0;

const fn checked_alpha(alpha: f32, place: usize) -> Result<f32, Error> {
    match positive(alpha, place) {
        Ok(alpha) if alpha < SMOOTHEST || alpha > ROUGHEST => Err(Error::OutOfRange(place)),
        other => other,
    }
}

const fn checked_alphas([x, y]: [f32; 2], place: usize) -> Result<[f32; 2], Error> {
    Ok([
        tried!(checked_alpha(x, place)),
        tried!(checked_alpha(y, place)),
    ])
}

/// (x/αx)² + (y/αy)² and z², whose sum is 1/√(π αx αy D).
#[inline]
fn slopes([ax, ay]: [f32; 2], [x, y, z]: [f32; 3]) -> (f32, f32) {
    let (x, y) = (x / ax, y / ay);
    (x * x + y * y, z * z)
}

/// D(m) π αx αy.
#[inline]
fn shape(alpha: [f32; 2], normal: [f32; 3]) -> f32 {
    let (flat, up) = slopes(alpha, normal);
    let sum = flat + up;
    // Vectors far from unit length overflow or underflow here.
    1.0 / above_zero(sum * sum)
}

/// The unit vector along (αx x, αy y, z), and the cube of the length that it had.
#[inline]
fn squeezed<T: Tier>([ax, ay]: [f32; 2], [x, y, z]: [f32; 3]) -> ([f32; 3], f32) {
    let (x, y) = (ax * x, ay * y);
    let square = x * x + y * y + z * z;
    let length = T::sqrt(square);
    ([x / length, y / length, z / length], square * length)
}

/// 1/(π αx αy).
const fn sharpness([ax, ay]: [f32; 2]) -> f32 {
    FRAC_1_PI / (ax * ay)
}

/// Normals of the microfacets of a rough surface, after Trowbridge and Reitz (GGX).
///
#[cfg_attr(doc, doc = include_str!("../pictures/ggx.html"))]
///
/// The normal is the unit vector along (αx √u₁ cos φ, αy √u₁ sin φ, √(1 − u₁)), φ = u₂ turns. For reflection towards a
/// known viewer take [`GgxVisible`], which wastes no normals that face away.
///
/// # Density
/// D(m) cos θ per steradian for z > 0, with D = 1/(π αx αy ((x/αx)² + (y/αy)² + z²)²). All terms are positive, so that
/// nothing cancels at small roughness. [`sample_with_pdf`](Warp::sample_with_pdf) takes it from the uniforms, which is
/// cheaper and does not count the rounding of the normal.
///
/// # Domain
/// - Point: unit vectors with z > 0, about the surface normal +z.
/// - Uniforms: two, polar then azimuth; the pole is at u₁ = 0.
/// - Parameters: roughness αx and αy from 1e-4 to 1.
///
/// # Accuracy
/// *Sample* is the distance from the exact normal, *unit length* the error of the length. sin θ and cos θ count units
/// in the last place (ulp). *Pdf* and *realised density* are relative, *inverse* and *round trip* are absolute errors
/// of the uniforms; s and r are what one ulp of the normal changes in density and inverse. [What each row
/// means](crate::warp#stated-errors).
///
/// | error | `libm` | `poly` | kind |
/// |---|--:|--:|---|
/// | sample, of the size | 3.3e-7 | 3.2e-7 | proven |
/// | sin θ, ulp | 6.2 | 6.2 | found |
/// | cos θ, ulp | 5.1 | 5.1 | found |
/// | unit length | 2.2e-7 | 2.2e-7 | found |
/// | pdf, relative | 1.3e-6 | 1.3e-6 | found |
/// | realised density, relative | 1.5e-6 + 1.8*s | 1.5e-6 + 1.8*s | found |
/// | pdf with the sample, relative | 1.6e-6 | 1.7e-6 | found |
/// | inverse | 1.7e-7 | 1.7e-7 | found |
/// | round trip | 2.1e-7 + 0.66*r | 2.1e-7 + 0.66*r | found |
///
/// The error of a sample is proven for all roughnesses and every pair of uniforms: see `docs/proofs.md`.
///
/// # Cost
/// One draw in `poly`, PCG32 included, takes <!-- figure: cost Ggx -->99 instructions and 432 bytes of code on an M4F, 5,536 instructions on an M0<!-- -->.
///
/// # Examples
/// ```
/// use microwarp::{Warp, poly as mw};
/// let brushed = mw::Ggx::new([0.05, 0.3])?;
/// let normal = brushed.sample([0.5, 0.25]);
/// assert!(normal[1] > 0.2 && brushed.pdf(normal) > 0.0);
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// # See also
/// [`GgxVisible`]; [`PhongLobe`](super::PhongLobe), a lobe of directions instead of normals;
/// [`Oriented`](super::Oriented) turns either onto a surface.
///
/// # Source
/// T. S. Trowbridge and K. P. Reitz, "Average Irregularity Representation of a Rough Surface for Ray Reflection", 1975,
/// <https://doi.org/10.1364/JOSA.65.000531>; B. Walter and others, "Microfacet Models for Refraction through Rough
/// Surfaces", 2007, <https://doi.org/10.2312/EGWR/EGSR07/195-206>.
#[doc(alias = "trowbridge_reitz")]
#[doc(alias = "microfacet")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Ggx<T> {
    alpha: [f32; 2],
    /// 1/(π αx αy).
    sharpness: f32,
    tier: PhantomData<T>,
}

impl<T: Tier> Ggx<T> {
    /// Normals of roughness `alpha` along x and along y; equal ones are isotropic.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for NaN or infinity, [`Error::NotPositive`] for 0 or less, [`Error::OutOfRange`] below 1e-4
    /// and above 1.
    pub const fn new(alpha: [f32; 2]) -> Result<Self, Error> {
        let alpha = tried!(checked_alphas(alpha, 0));
        Ok(Self {
            alpha,
            sharpness: sharpness(alpha),
            tier: PhantomData,
        })
    }

    /// The roughness along x and along y.
    #[must_use]
    pub const fn alpha(&self) -> [f32; 2] {
        self.alpha
    }
}

impl<T: Tier> PlanarMap<3> for Ggx<T> {
    #[inline]
    fn map_to(&self, u1: f32, u2: f32, to: &mut [f32; 3]) {
        let _ = self.put(u1, u2, to);
    }

    /// Of a normal that had length L before it was scaled to a unit vector, D is L⁴/(π αx αy) and cos θ is √(1 − u₁)/L.
    #[inline]
    fn put(&self, u1: f32, u2: f32, to: &mut [f32; 3]) -> f32 {
        let (x, y) = T::polar(T::sqrt(u1), u2);
        let z = T::sqrt(1.0 - u1);
        let (normal, cube) = squeezed::<T>(self.alpha, [x, y, z]);
        *to = normal;
        cube * z * self.sharpness
    }
}

impl<T: Tier> Warp for Ggx<T> {
    planar!(3, with its density, where T::VECTORS);

    #[inline]
    fn pdf(&self, normal: [f32; 3]) -> f32 {
        let [_, _, z] = normal;
        if z > 0.0 && is_direction(normal) {
            representable(shape(self.alpha, normal) * z * self.sharpness)
        } else {
            0.0
        }
    }
}

impl<T: Tier> Invert for Ggx<T> {
    #[inline]
    fn invert(&self, normal: [f32; 3]) -> [f32; 2] {
        let ([ax, ay], [x, y, _]) = (self.alpha, normal);
        let (flat, up) = slopes(self.alpha, normal);
        [into_unit(flat / (flat + up)), azimuth::<T>(x / ax, y / ay)]
    }
}

/// A reflection off a microfacet: its normal, where the light goes, and the density of that direction.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Reflection {
    /// The normal of the microfacet, which is the half vector of view and direction.
    pub normal: [f32; 3],
    /// The reflected direction, a unit vector; below the surface where z < 0.
    pub direction: [f32; 3],
    /// The density of the direction, per steradian.
    pub pdf: f32,
}

/// Normals of GGX microfacets that a viewer sees, in proportion to their visible area.
///
#[cfg_attr(doc, doc = include_str!("../pictures/ggx_visible.html"))]
///
/// A direction uniform on a spherical cap and the viewer's, both in the space where the surface is a hemisphere, add up to the normal
/// (Dupuy and Benyoub). The azimuth u₂ is counted from the viewer's, so that the sum has no cancellation.
/// [`sample_with_pdf`](Warp::sample_with_pdf) takes the density from the length of that sum, in which w·m does not cancel
/// either.
///
/// # Density
/// `2 (w·m) D(m)/(w_z + ℓ)` per steradian where w·m > 0, with the view w, `ℓ = √(αx² w_x² + αy² w_y² + w_z²)` and D as for
/// [`Ggx`].
/// The reflected direction has density `D(m)/(2(w_z + ℓ))`. [`GgxVisible::reflected_pdf`] gives it. [`GgxVisible::bounded`]
/// divides by `k w_z + ℓ` instead, with k ≤ 1.
///
/// # Domain
/// - Point: unit vectors with z > 0, about the surface normal +z.
/// - Uniforms: two, polar then azimuth about the axis of the cap.
/// - Parameters: views up to the horizon, of any length; roughness αx and αy from 1e-4 to 1.
///
/// Carry the normal of a reflection, or its density: computed again from the two rounded directions, the half vector
/// loses all its digits at small roughness (1e-4: errors of 0.3 % at 40°, of 100 % near the horizon).
///
/// # Accuracy
/// *Sample* is the distance from the exact normal, *unit length* the error of the length. *Pdf* and *realised density*
/// are relative, *inverse* and *round trip* are absolute errors of the uniforms; s and r are what one ulp of the normal
/// changes in density and inverse. [What each row means](crate::warp#stated-errors).
///
/// | error | bound | kind |
/// |---|--:|---|
/// | sample, of the size | 6.6e-7 + 6.3e-7*q | found |
/// | unit length | 2.4e-7 | found |
/// | pdf, relative | 1.2e-6 + 2.8*s | found |
/// | realised density, relative | 1.4e-6 + 8.3·s + 8.4e-7·q | found |
/// | pdf with the sample, relative | 1.2e-6 + 9.7e-7*q | found |
/// | inverse | 8e-7 + 9.8*r | found |
/// | round trip | 8.3e-7 + 9.9*r | found |
///
/// Here q is the larger roughness over the smaller one: where they differ, the azimuth of the normal is that much more
/// sensitive than the azimuth of the sum. The azimuth of the inverse is not held where u₁ is below 2⁻⁴⁰, next to the pole
/// of the cap: there it is the rounding of the normal. The grid has no such u₁ but 0.
///
/// # Cost
/// One draw in `poly`, PCG32 included, takes <!-- figure: cost GgxVisible -->129 instructions and 592 bytes of code on an M4F, 6,813 instructions on an M0<!-- -->.
///
/// # Examples
/// ```
/// use microwarp::{Warp, poly as mw};
/// let gloss = mw::GgxVisible::new([0.6, 0.0, 0.8], [0.1, 0.1])?;
/// let bounce = gloss.reflect([0.25, 0.5]);
/// assert!(bounce.direction[2] > 0.0 && bounce.pdf > 0.0);
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// In a renderer, take `.ok()` instead of `?`: a view below the horizon reflects nothing, and a roughness below 1e-4 is a mirror.
///
/// # See also
/// [`Ggx`], all normals; [`PhongLobe`](super::PhongLobe), an older lobe of directions.
///
/// # Source
/// E. Heitz, "Sampling the GGX Distribution of Visible Normals", 2018, <https://jcgt.org/published/0007/04/01/>;
/// J. Dupuy and A. Benyoub, "Sampling Visible GGX Normals with Spherical Caps", 2023,
/// <https://doi.org/10.1111/cgf.14867>; Y. Tokuyoshi and K. Eto, "Bounded VNDF Sampling for Smith-GGX Reflections", 2023,
/// <https://doi.org/10.1145/3610543.3626163>.
#[doc(alias = "vndf")]
#[doc(alias = "microfacet")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct GgxVisible<T> {
    alpha: [f32; 2],
    view: [f32; 3],
    /// The view where the surface is a hemisphere: its azimuth, as a unit vector, its sine and its cosine.
    axis: [f32; 2],
    sin: f32,
    cos: f32,
    /// 1 − cos, which keeps its digits.
    down: f32,
    /// The slopes of the direction half way between it and the normal.
    half_way: [f32; 2],
    /// ℓ, the length that the view had there.
    length: f32,
    /// The height of the cap, 1 + k cos.
    height: f32,
    /// What the cap lacks of the whole one, (1 − k) cos.
    short: f32,
    /// 1/(π αx αy) over the height.
    sharpness: f32,
    tier: PhantomData<T>,
}

/// A view of any length, in some unit.
struct View {
    unit: [f32; 3],
    length: f32,
    z: f32,
    /// x and y in a unit of their own, and that unit.
    flat: [f32; 2],
    part: f32,
}

impl View {
    /// An ordinary one, of this square. Its numbers are those of `of_any`, but for powers of two.
    #[inline]
    fn of(view: [f32; 3], square: f32) -> Self {
        let [x, y, z] = view;
        let length = sqrt(square);
        Self {
            unit: view.map(|c| c / length),
            length,
            z,
            flat: [x, y],
            part: 1.0,
        }
    }

    #[cold]
    #[inline(never)]
    fn of_any(view: [f32; 3]) -> Result<Self, Error> {
        let unit = normalised(view, 0)?;
        let (scale, scaled_view) = scaled(view);
        let ([x, y, _], [_, _, z]) = (view, scaled_view);
        // The azimuth has a scale of its own, so that beside a far larger z neither squares nor digits are lost.
        let (flat_scale, [x, y, _]) = scaled([x, y, 0.0]);
        Ok(Self {
            unit,
            length: length(scaled_view),
            z,
            flat: [x, y],
            part: flat_scale / scale,
        })
    }
}

impl<T: Tier> GgxVisible<T> {
    /// The normals seen from `view`, a direction of any length, of roughness `alpha` along x and along y.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for NaN or infinity, [`Error::ZeroLength`] for a view without a length,
    /// [`Error::OutOfRange`] for a view below the surface and for a roughness below 1e-4 or above 1,
    /// [`Error::NotPositive`] for a roughness of 0 or less.
    pub fn new(view: [f32; 3], alpha: [f32; 2]) -> Result<Self, Error> {
        Self::of(view, alpha, false)
    }

    /// The same without the normals whose reflections all lie below the surface.
    ///
    /// # Errors
    /// Those of [`GgxVisible::new`].
    pub fn bounded(view: [f32; 3], alpha: [f32; 2]) -> Result<Self, Error> {
        Self::of(view, alpha, true)
    }

    fn of(view: [f32; 3], alpha: [f32; 2], bounded: bool) -> Result<Self, Error> {
        let [ax, ay] = checked_alphas(alpha, 1)?;
        let [x, y, z] = view;
        let flat = x * x + y * y;
        let square = flat + z * z;
        let View {
            unit,
            length,
            z,
            flat: [x, y],
            part,
        } = if is_ordinary(flat) && is_ordinary(square) {
            View::of(view, square)
        } else {
            View::of_any(copied(view))?
        };
        if z < 0.0 {
            return Err(Error::OutOfRange(0));
        }
        let (x, y) = (ax * x, ay * y);
        let flat = sqrt(x * x + y * y);
        let axis = if flat > 0.0 {
            [x / flat, y / flat]
        } else {
            [1.0, 0.0]
        };
        // From here on the view is measured in units of its scale: it is rounded to a unit vector only for the angle
        // between it and a normal.
        let flat = flat * part;
        let squeezed = sqrt(flat * flat + z * z);
        let (sin, cos, twice) = (flat / squeezed, z / squeezed, squeezed + z);
        // 1 - k; k is 1 where the cap is whole.
        let lost = if bounded {
            let [x, y, z] = unit;
            let a = if ax < ay { ax } else { ay };
            let s = 1.0 + sqrt(x * x + y * y);
            let a2 = a * a;
            a2 * (s * s + z * z) / (s * s + a2 * z * z)
        } else {
            0.0
        };
        let short = lost * cos;
        let height = (1.0 + cos) - short;
        Ok(Self {
            alpha,
            view: unit,
            axis,
            sin,
            cos,
            down: sin * (flat / twice),
            half_way: [x * part / twice, y * part / twice],
            length: squeezed / length,
            height,
            short,
            sharpness: sharpness(alpha) / height,
            tier: PhantomData,
        })
    }

    /// The roughness along x and along y.
    #[must_use]
    pub const fn alpha(&self) -> [f32; 2] {
        self.alpha
    }

    /// The view, a unit vector.
    #[must_use]
    pub const fn view(&self) -> [f32; 3] {
        self.view
    }

    /// The sum of the view and of a point of the cap, where the surface is a hemisphere.
    #[inline]
    fn half(&self, u1: f32, u2: f32) -> [f32; 3] {
        let (v, off) = (1.0 - u1, u1 * self.height);
        let k = v * self.height + self.short;
        // Of the point of the cap, 1 - cos is `off` and 1 + cos is the sum of these two.
        let sin = T::sqrt(off * (k + self.down));
        let (c, s) = T::polar(1.0, u2);
        let along = if c < 0.0 {
            // The difference of both sines, whose squares differ by k times the difference of the cosines, and what the
            // azimuth adds to it.
            let lower = if self.cos < 0.5 {
                k - 2.0 * self.cos
            } else {
                self.down - off
            };
            k * lower / above_zero(self.sin + sin) + sin * (s * s / (1.0 - c))
        } else {
            self.sin + sin * c
        };
        let side = sin * s;
        let [ax, ay] = self.axis;
        [along * ax - side * ay, along * ay + side * ax, k]
    }

    /// A normal where the surface is a hemisphere: along the azimuth of the view, beside it, and up.
    #[inline]
    fn stretched(&self, [x, y, z]: [f32; 3]) -> [f32; 3] {
        let [ax, ay] = self.alpha;
        let [along, side] = self.turned([x / ax, y / ay]);
        [along, side, z]
    }

    /// The same two parts of any horizontal vector.
    #[inline]
    fn turned(&self, [x, y]: [f32; 2]) -> [f32; 2] {
        let [cos, sin] = self.axis;
        [x * cos + y * sin, y * cos - x * sin]
    }

    /// The height of the sum of the view and a point of the cap, where that sum is along a stretched normal.
    #[inline]
    fn rise(&self, [along, side, z]: [f32; 3]) -> f32 {
        let square = along * along + side * side + z * z;
        2.0 * (self.sin * along + self.cos * z) * z / square
    }

    /// The reflection of the view off the normal of two uniforms.
    ///
    /// Its density needs no cosine between view and normal, so that nothing cancels in it.
    #[must_use]
    pub fn reflect(&self, u: [f32; 2]) -> Reflection {
        let normal = self.sample(u);
        let twice = 2.0 * self.towards(normal);
        let ([mx, my, mz], [wx, wy, wz]) = (normal, self.view);
        Reflection {
            normal,
            direction: [twice * mx - wx, twice * my - wy, twice * mz - wz],
            pdf: self.reflected_pdf(normal),
        }
    }

    drawn_by! {
        /// Draws a reflection of the view: [`reflect`](Self::reflect) of a generator.
        draw_reflection, try_draw_reflection, reflect -> Reflection
    }

    /// The density of the direction into which a microfacet of this normal reflects the view, per steradian.
    ///
    /// The direction itself does not serve: see the domain above.
    #[must_use]
    pub fn reflected_pdf(&self, normal: [f32; 3]) -> f32 {
        if self.sees(normal) {
            representable(self.share(0.5, normal))
        } else {
            0.0
        }
    }

    /// `D(m)/(ℓ + k w_z)`, times a factor.
    #[inline]
    pub(super) fn share(&self, factor: f32, normal: [f32; 3]) -> f32 {
        shape(self.alpha, normal) * (factor * self.sharpness / self.length)
    }

    /// Whether the view may be reflected into a direction, of which the normal half way and the length of the sum with the view are known.
    /// A shortened cap lacks only normals that reflect below the surface. The shorter the sum, the less is known of its normal.
    #[inline]
    pub(super) fn reaches(&self, direction: [f32; 3], normal: [f32; 3], length: f32) -> bool {
        let ([_, _, z], [ax, ay]) = (direction, self.alpha);
        let narrow = if ax < ay { ax } else { ay };
        let slack = RIM_SLACK * (1.0 + 4.0 / (length * narrow));
        z >= 0.0 || self.short <= slack || self.rise(self.stretched(normal)) >= self.short - slack
    }

    /// Whether a normal is one that the sampler may give, but for rounding.
    #[inline]
    fn sees(&self, normal: [f32; 3]) -> bool {
        let [_, _, z] = normal;
        if !(z > 0.0 && is_direction(normal) && self.towards(normal) > -RIM_SLACK) {
            return false;
        }
        if self.short > 0.0 {
            return self.rise(self.stretched(normal)) >= self.short - RIM_SLACK;
        }
        true
    }

    /// w·m.
    #[inline]
    fn towards(&self, [x, y, z]: [f32; 3]) -> f32 {
        let [wx, wy, wz] = self.view;
        wx * x + wy * y + wz * z
    }
}

/// How far beyond the rim a normal still counts as seen: the rounding of a sample on it.
pub(super) const RIM_SLACK: f32 = 4.0 * f32::EPSILON;

impl<T: Tier> PlanarMap<3> for GgxVisible<T> {
    #[inline]
    fn map_to(&self, u1: f32, u2: f32, to: &mut [f32; 3]) {
        let _ = self.put(u1, u2, to);
    }

    /// With h the sum of the view and a point of the cap, and L the length of it squeezed, w·m is ℓh²/(2L) and D is
    /// L⁴/(π αx αy h⁴): nothing cancels, and the rounding of the normal does not count.
    #[inline]
    fn put(&self, u1: f32, u2: f32, to: &mut [f32; 3]) -> f32 {
        let half = self.half(u1, u2);
        let (normal, cube) = squeezed::<T>(self.alpha, half);
        *to = normal;
        let [x, y, z] = half;
        cube / (x * x + y * y + z * z) * self.sharpness
    }
}

impl<T: Tier> Warp for GgxVisible<T> {
    planar!(3, with its density, where T::VECTORS);

    #[inline]
    fn pdf(&self, normal: [f32; 3]) -> f32 {
        if self.sees(normal) {
            representable(self.share(2.0, normal) * self.towards(normal))
        } else {
            0.0
        }
    }
}

impl<T: Tier> Invert for GgxVisible<T> {
    #[inline]
    fn invert(&self, normal: [f32; 3]) -> [f32; 2] {
        let stretched = self.stretched(normal);
        let u1 = 1.0 - (self.rise(stretched) - self.short) / self.height;
        // The point of the cap is above all where the normal is half way to the view: what it differs from that by loses
        // no digits here, and is turned only then.
        let ([ax, ay], [x, y, z], [along, _, _]) = (self.alpha, normal, stretched);
        let off = |x: f32, slope: f32| remainder(x, slope, z);
        let [ahead, side] =
            self.turned([off(x / ax, self.half_way[0]), off(y / ay, self.half_way[1])]);
        let x = ahead * (self.sin * along + (1.0 + self.cos) * z) - self.sin * (side * side);
        let y = 2.0 * (self.sin * along + self.cos * z) * side;
        [into_unit(u1), azimuth::<T>(x, y)]
    }
}
