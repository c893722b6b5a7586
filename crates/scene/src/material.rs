//! What surfaces do with light: matte, glossy (Phong's lobe over a matte ground), and rough metal (GGX).

use crate::kit::Kit;
use crate::vector::{Vector, dot, plus, scaled, unit};
use core::f32::consts::FRAC_1_PI;
use microwarp::discrete::Mixture;
use microwarp::warp::{CosineHemisphere, Frame, GgxVisible, Oriented, Reflection};
use microwarp::{Error, Invert as _, Warp};
use rand_core::Rng;

/// A direction that a lobe has drawn, what the surface sends there of the light that comes from there, cosine included, and
/// the density of the direction per steradian.
#[derive(Clone, Copy, Debug)]
pub struct Bounce {
    pub direction: Vector,
    pub value: Vector,
    pub pdf: f32,
}

/// How a place scatters light that is seen from one direction. Directions are those of the caller's frame.
pub trait Lobe {
    /// A direction by the lobe's own density; none where it takes the light.
    fn draw(&self, words: &mut impl Rng) -> Option<Bounce>;
    /// Value and density of a direction.
    fn weigh(&self, direction: Vector) -> (Vector, f32);
    /// The two numbers that [`draw`](Lobe::draw) makes this direction of, where it takes two and has an inverse.
    #[inline]
    fn invert(&self, _: Vector) -> Option<[f32; 2]> {
        None
    }
}

/// What a surface is made of.
pub trait Material: Copy {
    type Lobe<K: Kit>: Lobe;
    /// The lobe seen from a local direction, whose z is along the normal and at least 0.
    ///
    /// # Errors
    /// Those of the samplers, for parameters of the material or a view that they do not take.
    fn seen<K: Kit>(&self, view: Vector) -> Result<Self::Lobe<K>, Error>;
}

/// Lambert's law.
#[derive(Clone, Copy, Debug)]
pub struct Matte(pub Vector);

/// The lobe of [`Matte`].
pub struct MatteLobe<K: Kit> {
    albedo: Vector,
    cosine: K::Cosine,
}

impl Material for Matte {
    type Lobe<K: Kit> = MatteLobe<K>;

    #[inline]
    fn seen<K: Kit>(&self, _: Vector) -> Result<MatteLobe<K>, Error> {
        let (albedo, cosine) = (self.0, K::cosine());
        Ok(MatteLobe { albedo, cosine })
    }
}

/// Albedo times the cosine over π. The sampler's own density serves as the density alone: the value is the surface's.
#[inline]
fn lambert(albedo: Vector, [_, _, z]: Vector) -> Vector {
    scaled(albedo, FRAC_1_PI * if z > 0.0 { z } else { 0.0 })
}

impl<K: Kit> Lobe for MatteLobe<K> {
    #[inline]
    fn draw(&self, words: &mut impl Rng) -> Option<Bounce> {
        let (direction, pdf) = self.cosine.draw_with_pdf(words);
        let value = lambert(self.albedo, direction);
        Some(Bounce {
            direction,
            value,
            pdf,
        })
    }

    #[inline]
    fn weigh(&self, direction: Vector) -> (Vector, f32) {
        (lambert(self.albedo, direction), self.cosine.pdf(direction))
    }

    #[inline]
    fn invert(&self, direction: Vector) -> Option<[f32; 2]> {
        Some(CosineHemisphere::<K::Tier>::new().invert(direction))
    }
}

/// A matte ground under a glossy coat: the modified reflection of Phong, whose lobe is about the direction of a mirror. The
/// sum of both albedos is at most 1.
#[derive(Clone, Copy, Debug)]
pub struct Glossy {
    pub ground: Vector,
    pub coat: f32,
    pub exponent: f32,
}

/// The lobe of [`Glossy`].
pub struct GlossyLobe<K: Kit> {
    ground: Vector,
    coat: f32,
    exponent: f32,
    directions: Mixture<(Oriented<K::Gloss>, K::Cosine), 2>,
}

impl Material for Glossy {
    type Lobe<K: Kit> = GlossyLobe<K>;

    fn seen<K: Kit>(&self, [x, y, z]: Vector) -> Result<GlossyLobe<K>, Error> {
        let gloss = Oriented::new(K::gloss(self.exponent)?, Frame::new([-x, -y, z])?);
        let weights = [self.coat, crate::vector::largest(self.ground)];
        Ok(GlossyLobe {
            ground: self.ground,
            coat: self.coat,
            exponent: self.exponent,
            directions: Mixture::new((gloss, K::cosine()), &weights)?,
        })
    }
}

impl<K: Kit> Lobe for GlossyLobe<K> {
    fn draw(&self, words: &mut impl Rng) -> Option<Bounce> {
        let direction = self.directions.draw(words);
        let (value, pdf) = self.weigh(direction);
        (pdf > 0.0).then_some(Bounce {
            direction,
            value,
            pdf,
        })
    }

    /// The lobe's value is its density but for the norm, (n + 2)/(n + 1), and the cosine. Below the horizon it is 0, though
    /// the density is not.
    fn weigh(&self, direction: Vector) -> (Vector, f32) {
        let (gloss, cosine) = self.directions.parts();
        let [gloss, diffuse] = [gloss.pdf(direction), cosine.pdf(direction)];
        let [_, _, z] = direction;
        let z = if z > 0.0 { z } else { 0.0 };
        let coat = self.coat * gloss * z * ((self.exponent + 2.0) / (self.exponent + 1.0));
        let value = plus(lambert(self.ground, direction), [coat; 3]);
        (value, self.directions.pdf_of([gloss, diffuse]))
    }
}

/// A rough metal of GGX microfacets: the colour that it has head on, and its roughness.
#[derive(Clone, Copy, Debug)]
pub struct Metal {
    pub colour: Vector,
    pub roughness: f32,
}

/// The lobe of [`Metal`].
pub struct MetalLobe<K: Kit> {
    colour: Vector,
    normals: GgxVisible<K::Tier>,
}

impl Material for Metal {
    type Lobe<K: Kit> = MetalLobe<K>;

    fn seen<K: Kit>(&self, view: Vector) -> Result<MetalLobe<K>, Error> {
        Ok(MetalLobe {
            colour: self.colour,
            normals: GgxVisible::new(view, [self.roughness; 2])?,
        })
    }
}

impl<K: Kit> MetalLobe<K> {
    /// The value of a direction that a microfacet of this normal reflects to. Of the density D/(2(v + ℓ)) it is Fresnel's part,
    /// after Schlick, times the light that leaves without being masked, given that the normal is seen.
    fn value(&self, direction: Vector, normal: Vector, pdf: f32) -> Vector {
        let unmasked = self.normals.unmasked(direction);
        let cosine = dot(normal, direction);
        let past = if cosine < 1.0 { 1.0 - cosine } else { 0.0 };
        let square = past * past;
        let fresnel = self.colour.map(|c| c + (1.0 - c) * square * square * past);
        scaled(fresnel, unmasked * pdf)
    }
}

impl<K: Kit> Lobe for MetalLobe<K> {
    fn draw(&self, words: &mut impl Rng) -> Option<Bounce> {
        let Reflection {
            direction,
            normal,
            pdf,
        } = self.normals.draw_reflection(words);
        (pdf > 0.0).then(|| Bounce {
            direction,
            value: self.value(direction, normal, pdf),
            pdf,
        })
    }

    fn weigh(&self, direction: Vector) -> (Vector, f32) {
        let normal = unit(plus(direction, self.normals.view()));
        let pdf = self.normals.reflected_pdf(normal);
        (self.value(direction, normal, pdf), pdf)
    }
}

/// Any of the three.
#[derive(Clone, Copy, Debug)]
pub enum Any {
    Matte(Matte),
    Glossy(Glossy),
    Metal(Metal),
}

/// The lobe of [`Any`].
pub enum AnyLobe<K: Kit> {
    Matte(MatteLobe<K>),
    Glossy(GlossyLobe<K>),
    Metal(MetalLobe<K>),
}

impl Material for Any {
    type Lobe<K: Kit> = AnyLobe<K>;

    fn seen<K: Kit>(&self, view: Vector) -> Result<AnyLobe<K>, Error> {
        Ok(match self {
            Self::Matte(matte) => AnyLobe::Matte(matte.seen(view)?),
            Self::Glossy(glossy) => AnyLobe::Glossy(glossy.seen(view)?),
            Self::Metal(metal) => AnyLobe::Metal(metal.seen(view)?),
        })
    }
}

impl<K: Kit> Lobe for AnyLobe<K> {
    fn draw(&self, words: &mut impl Rng) -> Option<Bounce> {
        match self {
            Self::Matte(lobe) => lobe.draw(words),
            Self::Glossy(lobe) => lobe.draw(words),
            Self::Metal(lobe) => lobe.draw(words),
        }
    }

    fn weigh(&self, direction: Vector) -> (Vector, f32) {
        match self {
            Self::Matte(lobe) => lobe.weigh(direction),
            Self::Glossy(lobe) => lobe.weigh(direction),
            Self::Metal(lobe) => lobe.weigh(direction),
        }
    }

    #[inline]
    fn invert(&self, direction: Vector) -> Option<[f32; 2]> {
        match self {
            Self::Matte(lobe) => lobe.invert(direction),
            _ => None,
        }
    }
}
