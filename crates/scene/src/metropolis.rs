//! Metropolis light transport: a chain of paths, whose states are the numbers that a path takes and its place in the picture.

use crate::camera::View;
use crate::film::Film;
use crate::fog::Fog;
use crate::kit::Kit;
use crate::light::Light;
use crate::material::Material;
use crate::path::{Heuristic, NUMBERS, Scene};
use crate::picture::Plan;
use crate::shift::{NOWHERE, Shift};
use crate::sky::Sky;
use crate::source::{Numbers, Random, Source as _};
use crate::vector::{Vector, dot, scaled};
use microwarp::Error;
use microwarp::constant;
use microwarp::discrete::Cdf;
use microwarp::metropolis::{
    BoxStep, Chain, Mixture, Product, StateSource as _, UniformStep, WithPayload, WrappedWalk,
};

/// How a chain of paths runs, which takes at most [`Walk::paths`] of them: a step that finds its way blocked takes none.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Walk {
    /// Columns and rows.
    pub size: [u32; 2],
    /// Random paths for a first guess of the brightness. It decides nothing but how paths of both kinds are weighed together.
    pub guesses: u32,
    /// Random paths, one of which starts the chain. They count in the picture.
    pub candidates: u32,
    pub steps: u32,
    pub seed: u32,
}

impl Walk {
    #[must_use]
    pub const fn paths(&self) -> u32 {
        let random = self.guesses.wrapping_add(self.candidates);
        random.wrapping_add(self.steps)
    }
}

/// What became of a chain.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Run {
    /// The mean brightness of the picture, as the candidates have it: the weight of the start.
    pub brightness: f32,
    /// The share of steps that were accepted.
    pub accepted: f32,
    /// Steps that found what is no light.
    pub refused: u64,
}

/// Where a path ends up in the picture, as parts of its width and height, and its numbers.
pub type State = ([f32; 2], [f32; NUMBERS]);

/// The pixel of a place of a picture.
pub(crate) fn pixel_of([x, y]: [f32; 2], [columns, rows]: [u32; 2]) -> [u32; 2] {
    let (column, row) = ((x * columns as f32) as u32, (y * rows as f32) as u32);
    [
        column.min(columns.saturating_sub(1)),
        row.min(rows.saturating_sub(1)),
    ]
}

/// What a path finds.
#[derive(Clone, Copy, Debug)]
struct Found {
    pixel: [u32; 2],
    light: Vector,
}

/// Luminance, which says how often a path is taken. It is positive where any channel is, so that nothing is lost.
const LUMINANCE: Vector = [0.2126, 0.7152, 0.0722];

/// One step in four is large, one is small, and two move the eye's end.
static SHARES: Cdf<[u32; 3]> = constant!(Cdf::new(&[1.0, 1.0, 2.0]));

/// How far small steps go at most: in numbers of the path, and in pixels. Steps of a box are the cheapest, and there are many
/// numbers.
const NEAR: f32 = 1.0 / 64.0;
const PIXELS: f32 = 1.5;

/// How far the eye's end moves at most, as a part of the width and of the height.
const REACH: f32 = 0.1;

impl<M: Material, L: Light, E: Sky, F: Fog> Scene<'_, M, L, E, F> {
    /// Takes a picture by a chain of paths. `splat` adds light to a pixel, given by column and row: what it has got in the end
    /// is the light of the pixel, without bias however short the chain.
    ///
    /// Random paths and those of the chain are weighed together by the balance heuristic.
    ///
    /// # Errors
    /// None of a picture of one pixel or more.
    pub fn metropolis<K: Kit, H: Heuristic, P: Film>(
        &self,
        view: &View<K>,
        walk: &Walk,
        mut splat: impl FnMut([u32; 2], Vector),
    ) -> Result<Run, Error> {
        let [width, height] = walk.size.map(|n| n as f32);
        let target = |(place, path): State| {
            let pixel = pixel_of(place, walk.size);
            let light = if place == NOWHERE {
                [0.0; 3]
            } else {
                self.sample::<K, H, P>(view, pixel, &mut Numbers::new(path))
            };
            WithPayload::new(dot(light, LUMINANCE), Found { pixel, light })
        };
        let anew = Product::new((UniformStep::new(), UniformStep::new()));
        let near = Product::new((
            WrappedWalk::new(BoxStep::new([2.0 * PIXELS / width, 2.0 * PIXELS / height])?),
            WrappedWalk::new(BoxStep::new([2.0 * NEAR; NUMBERS])?),
        ));
        let shift = Shift {
            scene: self,
            view,
            size: walk.size,
            place: WrappedWalk::new(BoxStep::new([2.0 * REACH; 2])?),
        };
        let mutation = Mixture::from_table((anew, near, shift), SHARES);

        // Words of a pixel that no picture has.
        let plan = Plan {
            size: walk.size,
            samples: 0,
            seed: walk.seed,
        };
        let mut words = Random::of_pixel(&plan, [u32::MAX, 0]);
        let mut guess = 0.0;
        for _ in 0..walk.guesses {
            let Ok(state) = anew.try_draw_state(&mut words);
            let bright = target(state).density;
            guess += if bright < f32::INFINITY { bright } else { 0.0 };
        }
        guess /= walk.guesses.max(1) as f32;

        let steps = walk.steps as f32;
        let random = walk.candidates as f32 + SHARES.pmf(0) * steps;
        let pixels = width * height;
        // The densities of both kinds of paths, a chain's and random ones, in units of 1/`guess` a path.
        let mut add = |found: WithPayload<f32, Found>, share: f32| {
            let weight = share * pixels / (steps * found.density + random * guess);
            let Found { pixel, light } = found.payload;
            if share > 0.0 && weight < f32::INFINITY {
                splat(pixel, scaled(light, weight));
            }
        };
        let candidate = |state| {
            let found = target(state);
            add(found, guess);
            found
        };
        let start = Chain::resample(candidate, &anew, walk.candidates, &mut words);
        let Ok(start) = start else {
            return Ok(Run::default());
        };
        let (mut chain, brightness) = (start.chain, start.weight.density);
        for _ in 0..walk.steps {
            let step = chain.step(target, &mutation, &mut words);
            for (found, share) in step.recorded_values() {
                add(found, share * brightness);
            }
            if step.kind == 0 {
                add(step.proposed_density, guess);
            }
        }
        Ok(Run {
            brightness,
            accepted: chain.acceptance_rate().unwrap_or(0.0),
            refused: chain.refused(),
        })
    }
}
