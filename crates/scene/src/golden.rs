//! Small pictures whose hashes every target must reproduce, and the five scenes by type.

use crate::camera::View;
use crate::film::{Colour, Echo};
use crate::kit::Kit;
use crate::metropolis::{Run, Walk};
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

    /// A chain of paths, as [`Scene::metropolis`](crate::Scene::metropolis) says.
    ///
    /// # Errors
    /// Its own.
    fn metropolis<K: Kit>(
        view: &View<K>,
        walk: &Walk,
        splat: impl FnMut([u32; 2], Vector),
    ) -> Result<Run, Error>;
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

            #[inline]
            fn metropolis<K: Kit>(
                view: &View<K>,
                walk: &Walk,
                splat: impl FnMut([u32; 2], Vector),
            ) -> Result<Run, Error> {
                scenes::$scene::SCENE.metropolis::<K, Power, $film>(view, walk, splat)
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

/// How a picture is taken by Metropolis light transport: there are as many steps of the chain as samples are asked for.
pub const CHAIN: Plan = Plan {
    samples: 4096,
    ..PLAN
};

/// The pixels of a picture in shades of grey, which take 6 KB.
pub type Grey = [f32; 48 * 32];

/// The chain of a picture that is taken so.
#[must_use]
pub const fn walk(plan: &Plan) -> Walk {
    Walk {
        size: plan.size,
        guesses: 256,
        candidates: 256,
        steps: plan.samples,
        seed: plan.seed,
    }
}

/// A picture by Metropolis light transport, row by row, in grey: the mean of the three channels, three times.
///
/// # Errors
/// Those of [`View::new`].
pub fn chain<C: Shot, K: Kit>(plan: &Plan, grey: &mut Grey) -> Result<Hash, Error> {
    let ([width, _], view) = (plan.size, C::view::<K>(plan.size)?);
    C::metropolis::<K>(&view, &walk(plan), |[column, row], [r, g, b]| {
        let index = row.wrapping_mul(width).wrapping_add(column) as usize;
        if let Some(pixel) = grey.get_mut(index) {
            *pixel += (r + g + b) * (1.0 / 3.0);
        }
    })?;
    Ok(grey
        .iter()
        .fold(Hash::EMPTY, |hash, light| hash.with([*light; 3])))
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

/// The slit by Metropolis light transport.
#[inline]
pub fn slit<K: Kit>(tier: &'static str) -> Case {
    Case {
        scene: Slit::NAME,
        tier,
        points: "metropolis",
        plan: CHAIN,
        hash: |plan| chain::<Slit, K>(plan, &mut [0.0; 48 * 32]),
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

/// Every scene in both tiers of `f32`, from every source of points; and one by Metropolis light transport. Compiled where it is used.
#[inline]
pub fn cases() -> impl Iterator<Item = Case> {
    let scenes = [
        of::<Room>(),
        of::<Fog>(),
        of::<Slivers>(),
        of::<Slit>(),
        of::<Sensor>(),
    ];
    let chains = [slit::<Poly>("poly"), slit::<Libm>("libm")];
    scenes.into_iter().flatten().flatten().chain(chains)
}
