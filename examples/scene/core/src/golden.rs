//! Small pictures whose hashes every target must reproduce, and the five scenes by type.

use crate::camera::View;
use crate::film::{Colour, Echo};
use crate::kit::Kit;
use crate::path::Power;
use crate::picture::{Hash, Plan};
use crate::scenes;
use crate::source::{Owen, Random, Set, Source, Strata};
use crate::vector::Vector;
use core::fmt;
use microwarp::Error;
use microwarp::tier::{Libm, Poly};
use microwarp::uniform::ByPosition;

/// How each of them is taken.
pub const PLAN: Plan = Plan {
    size: [48, 32],
    samples: 4,
    seed: 1,
};

/// A scene with its camera and its film.
pub trait Shot {
    const NAME: &'static str;

    /// # Errors
    /// Those of [`View::new`].
    fn view<K: Kit>(size: [u32; 2]) -> Result<View<K>, Error>;

    /// A pixel, as [`Scene::pixel`](crate::Scene::pixel) says.
    fn pixel<K: Kit, S: Source>(view: &View<K>, pixel: [u32; 2], plan: &Plan) -> Vector;
}

macro_rules! shots {
    ($($shot:ident $scene:ident $film:ident;)*) => {$(
        #[doc = concat!("[`", stringify!($scene), "`](scenes::", stringify!($scene), ")")]
        pub struct $shot;

        impl Shot for $shot {
            const NAME: &'static str = stringify!($scene);

            #[inline]
            fn view<K: Kit>(size: [u32; 2]) -> Result<View<K>, Error> {
                View::new(scenes::$scene::CAMERA, size)
            }

            #[inline]
            fn pixel<K: Kit, S: Source>(view: &View<K>, pixel: [u32; 2], plan: &Plan) -> Vector {
                scenes::$scene::SCENE.pixel::<K, Power, $film, S>(view, pixel, plan)
            }
        }
    )*};
}

shots! {
    Room room Colour;
    Fog fog Colour;
    Slivers slivers Colour;
    Slit slit Colour;
    Sensor sensor Echo;
}

/// The hash of a picture, row by row.
///
/// # Errors
/// Those of [`View::new`].
pub fn hash<C: Shot, K: Kit, S: Source>(plan: &Plan) -> Result<Hash, Error> {
    let view = C::view::<K>(plan.size)?;
    let [width, height] = plan.size;
    let pixels = (0..height).flat_map(|row| (0..width).map(move |column| [column, row]));
    let taken = |hash: Hash, pixel| hash.with(C::pixel::<K, S>(&view, pixel, plan));
    Ok(pixels.fold(Hash::EMPTY, taken))
}

/// A picture that has a hash.
#[derive(Clone, Copy, Debug)]
pub struct Case {
    pub scene: &'static str,
    pub tier: &'static str,
    pub points: &'static str,
    pub plan: Plan,
    /// Renders it.
    pub hash: fn(&Plan) -> Result<Hash, Error>,
}

/// Scene, tier, points, size, samples a pixel, seed.
impl fmt::Display for Case {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self {
            scene,
            tier,
            points,
            plan,
            ..
        } = self;
        let ([width, height], samples, seed) = (plan.size, plan.samples, plan.seed);
        write!(
            to,
            "{scene} {tier} {points} {width}x{height} {samples} {seed}"
        )
    }
}

/// One picture, in the named tier and from the named points.
#[inline]
pub fn case<C: Shot, K: Kit, S: Source>(tier: &'static str, points: &'static str) -> Case {
    Case {
        scene: C::NAME,
        tier,
        points,
        plan: PLAN,
        hash: hash::<C, K, S>,
    }
}

#[inline]
fn in_tier<C: Shot, K: Kit>(tier: &'static str) -> [Case; 4] {
    [
        case::<C, K, Random>(tier, "pcg32"),
        case::<C, K, Set<ByPosition>>(tier, "by_position"),
        case::<C, K, Set<Strata>>(tier, "strata"),
        case::<C, K, Set<Owen>>(tier, "sobol"),
    ]
}

#[inline]
fn of<C: Shot>() -> [[Case; 4]; 2] {
    [in_tier::<C, Poly>("poly"), in_tier::<C, Libm>("libm")]
}

/// Every scene in both tiers of `f32`, from every source of points. Compiled where it is used.
#[inline]
pub fn cases() -> impl Iterator<Item = Case> {
    let scenes = [
        of::<Room>(),
        of::<Fog>(),
        of::<Slivers>(),
        of::<Slit>(),
        of::<Sensor>(),
    ];
    scenes.into_iter().flatten().flatten()
}
