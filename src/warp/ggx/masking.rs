//! Masking and shadowing after Smith: which part of the microfacets view and light reach.

use super::{Ggx, GgxVisible, shape};
use crate::num::{above_zero, representable};
use crate::tier::Tier;
use crate::warp::direction::is_direction;

impl<T: Tier> Ggx<T> {
    /// D(m), the distribution of normals: the area of the microfacets of this normal, per area of the surface and per
    /// steradian. 0 below the surface.
    ///
    /// It is the density without its cosine, and the factor of a reflection model. For a normal given exactly it is right to
    /// 1.1e-6, relatively, for every roughness and cosines from 1 to 1e-30, by a search and with a margin. A half vector of two rounded directions has not
    /// that many digits: see the domain of [`GgxVisible`].
    #[doc(alias = "ndf")]
    #[must_use]
    #[inline]
    pub fn distribution(&self, normal: [f32; 3]) -> f32 {
        let [_, _, z] = normal;
        if z > 0.0 && is_direction(normal) {
            representable(shape(self.alpha, normal) * self.sharpness)
        } else {
            0.0
        }
    }

    /// G₁ of a unit vector, `2w_z/(w_z + ℓ(w))` with `ℓ(w) = √(αx² w_x² + αy² w_y² + w_z²)`: the visible part of the
    /// microfacets that face it, from 0 to 1. 0 on the horizon and below it.
    ///
    /// It takes no [`GgxVisible`] of that view, where only masking is asked for. For every roughness and cosines from 1
    /// to 1e-30 it is right to 3.5e-7, relatively, by a search and with a margin.
    ///
    /// # Examples
    /// ```
    /// use microwarp::poly as mw;
    /// let view = [0.6, 0.0, 0.8];
    /// let masking = mw::Ggx::new([0.3, 0.1])?.g1(view);
    /// assert!((masking - mw::GgxVisible::new(view, [0.3, 0.1])?.g1()).abs() < 1e-6);
    /// # Ok::<(), microwarp::Error>(())
    /// ```
    #[doc(alias = "smith")]
    #[doc(alias = "masking")]
    #[must_use]
    #[inline]
    pub fn g1(&self, direction: [f32; 3]) -> f32 {
        let [_, _, z] = direction;
        if z > 0.0 && is_direction(direction) {
            let part = 2.0 * (z / (z + squeezed_length::<T>(self.alpha, direction)));
            if part < 1.0 { part } else { 1.0 }
        } else {
            0.0
        }
    }
}

/// Masking and shadowing, after Smith, with heights that view and light share. With the light l and
/// `ℓ(w) = √(αx² w_x² + αy² w_y² + w_z²)` all of it is products, quotients and sums of positive numbers. The errors below hold for
/// every roughness and for cosines of view and light from 1 to 1e-30. They are found by a search, and stated with a margin.
impl<T: Tier> GgxVisible<T> {
    /// G₁ of the view, `2w_z/(w_z + ℓ(w))`: the visible part of the microfacets that face the viewer, from 0 to 1.
    ///
    /// Right to 5.5e-7, relatively. It is 0 for a view on the horizon.
    #[doc(alias = "smith")]
    #[must_use]
    #[inline]
    pub const fn g1(&self) -> f32 {
        2.0 * self.cos / (1.0 + self.cos)
    }

    /// G₂/G₁ of a light `direction`, `l_z(ℓ(w) + w_z)/(l_z ℓ(w) + w_z ℓ(l))`: which part of the light that visible microfacets
    /// reflect there leaves the surface, from 0 to 1.
    ///
    /// This and Fresnel's term are the weight of a [`reflect`](GgxVisible::reflect)ed direction, model times cosine over
    /// density. Of [`bounded`](GgxVisible::bounded) normals the density is larger, and the weight less: multiply by
    /// [`reflected_pdf`](GgxVisible::reflected_pdf) of a [`new`](GgxVisible::new) one, and divide by that of the bounded one.
    ///
    /// Right to 8.5e-7, relatively. It is 0 for directions on and below the horizon, and 1 above it for a view on the horizon.
    ///
    /// # Examples
    /// ```
    /// use microwarp::poly as mw;
    /// let gloss = mw::GgxVisible::new([0.6, 0.0, 0.8], [0.1, 0.1])?;
    /// let bounce = gloss.reflect([0.25, 0.5]);
    /// let weight = gloss.unmasked(bounce.direction); // times Fresnel's term of the colour
    /// assert!(weight > 0.99 && weight <= 1.0);
    /// // The same by distribution, visibility and cosine.
    /// let [_, _, cosine] = bounce.direction;
    /// let surface = mw::Ggx::new([0.1, 0.1])?;
    /// let model = surface.distribution(bounce.normal) * gloss.visibility(bounce.direction);
    /// assert!((model * cosine / bounce.pdf - weight).abs() < 1e-5);
    /// # Ok::<(), microwarp::Error>(())
    /// ```
    #[doc(alias = "shadowing")]
    #[doc(alias = "masking")]
    #[must_use]
    #[inline]
    pub fn unmasked(&self, direction: [f32; 3]) -> f32 {
        let Some((z, sum)) = self.joint(direction) else {
            return 0.0;
        };
        let part = z * (1.0 + self.cos) / sum;
        // A view on the horizon has the limit.
        if part < 1.0 { part } else { 1.0 }
    }

    /// `G₂/(4 w_z l_z)` of a light `direction`, `1/(2(l_z ℓ(w) + w_z ℓ(l)))`: the value of the reflection model, but for
    /// Fresnel's term and the [`distribution`](Ggx::distribution) of normals.
    ///
    /// Right to 7e-7, relatively. It is 0 for directions on and below the horizon, and finite above it.
    #[must_use]
    #[inline]
    pub fn visibility(&self, direction: [f32; 3]) -> f32 {
        match self.joint(direction) {
            Some((_, sum)) => representable(0.5 / (self.length * sum)),
            None => 0.0,
        }
    }

    /// `l_z` and `l_z + ℓ(l) w_z/ℓ(w)`, of a direction above the surface.
    #[inline]
    fn joint(&self, direction: [f32; 3]) -> Option<(f32, f32)> {
        let [_, _, z] = direction;
        if !(z > 0.0 && is_direction(direction)) {
            return None;
        }
        let length = squeezed_length::<T>(self.alpha, direction);
        Some((z, above_zero(z + self.cos * length)))
    }
}

/// ℓ(w), the length of a unit vector where the surface is a hemisphere.
#[inline]
fn squeezed_length<T: Tier>([ax, ay]: [f32; 2], [x, y, z]: [f32; 3]) -> f32 {
    let (x, y) = (ax * x, ay * y);
    T::sqrt(x * x + y * y + z * z)
}
