//! What the table is for: the light of the sky by Monte Carlo, with directions from the table, uniform directions and
//! cosine-weighted ones, against the exact values.

use microwarp::{Warp, poly as mw};
use rand_pcg::Pcg32;
use std::f64::consts::{PI, TAU};

/// Directions in one estimate, and how often it is repeated for the error.
pub const DIRECTIONS: usize = 1000;
pub const REPETITIONS: usize = 1000;

/// The relative error of a density, as the page of `LatLongMap` states it.
const DENSITY: f64 = 4.3e-7;

/// The result of one way to choose directions.
pub struct Way {
    pub name: &'static str,
    pub mean: f64,
    /// Root of the mean square of the repetitions' errors.
    pub rms: f64,
}

pub struct Quantity {
    pub name: &'static str,
    pub exact: f64,
    pub ways: Vec<Way>,
    pub complaints: Vec<String>,
}

/// Repeats an estimate, the mean of `one` over [`DIRECTIONS`] directions.
fn repeat(name: &'static str, exact: f64, mut one: impl FnMut() -> f64) -> Way {
    let (mut sum, mut squares) = (0.0, 0.0);
    for _ in 0..REPETITIONS {
        let mean = (0..DIRECTIONS).map(|_| one()).sum::<f64>() / DIRECTIONS as f64;
        sum += mean;
        squares += (mean - exact) * (mean - exact);
    }
    Way {
        name,
        mean: sum / REPETITIONS as f64,
        rms: (squares / REPETITIONS as f64).sqrt(),
    }
}

impl Quantity {
    fn new(name: &'static str, exact: f64, ways: Vec<Way>) -> Self {
        let mut complaints = Vec::new();
        for way in &ways {
            let sigma = way.rms / (REPETITIONS as f64).sqrt();
            // Where the light is the very density, no deviation is left, but the rounding of the density.
            let rounding = DENSITY * exact;
            let within = (way.mean - exact).abs() <= 6.0 * sigma + rounding;
            if !within {
                let off = (way.mean - exact) / sigma;
                complaints.push(format!("{name}, {}: {off:.1} deviations off", way.name));
            }
        }
        Self {
            name,
            exact,
            ways,
            complaints,
        }
    }
}

/// The light of a sky of this luminance on a level plane, and its mean over all directions.
pub fn quantities(
    sky: &mw::LatLongMap<&[u32], &[u32]>,
    luminance: &[f64],
    seed: u64,
) -> [Quantity; 2] {
    let [columns, rows] = sky.shape();
    let texel = |[column, row]: [usize; 2]| luminance[row * columns + column];
    let look = |direction: [f32; 3]| texel(sky.pixel(direction));
    // Light, its direction, and the reciprocal of the density per steradian.
    let mut rng = Pcg32::new(seed, 20);
    let mut from_table = || {
        let sample = sky.draw_pixel(&mut rng);
        let weight = 1.0 / f64::from(sample.pdf);
        (texel(sample.pixel), sample.direction, weight)
    };
    let level = |direction: [f32; 3]| f64::from(direction[2].max(0.0));
    let (sphere, cosine) = (mw::Sphere::new(), mw::CosineHemisphere::new());

    // Within a texel the integrals are elementary.
    let angle = |row: usize| PI * row as f64 / rows as f64;
    let over = |weigh: &dyn Fn(f64, f64) -> f64| -> f64 {
        let texels = luminance.iter().enumerate();
        let sum = texels.map(|(i, l)| l * weigh(angle(i / columns), angle(i / columns + 1)));
        sum.sum::<f64>() * TAU / columns as f64
    };
    let mean = over(&|from, to| from.cos() - to.cos()) / (4.0 * PI);
    let irradiance = over(&|from, to| {
        let [from, to] = [from, to].map(|t| t.min(0.5 * PI).sin());
        0.5 * (to * to - from * from)
    });

    let on_plane = vec![
        repeat("table", irradiance, || {
            let (radiance, direction, weight) = from_table();
            radiance * level(direction) * weight
        }),
        {
            let mut rng = Pcg32::new(seed, 21);
            repeat("cosine", irradiance, || look(cosine.draw(&mut rng)) * PI)
        },
        {
            let mut rng = Pcg32::new(seed, 22);
            repeat("uniform", irradiance, || {
                let direction = sphere.draw(&mut rng);
                look(direction) * level(direction) * 4.0 * PI
            })
        },
    ];
    let all_round = vec![
        repeat("table", mean, || {
            let (radiance, _, weight) = from_table();
            radiance * weight / (4.0 * PI)
        }),
        {
            let mut rng = Pcg32::new(seed, 23);
            repeat("uniform", mean, || look(sphere.draw(&mut rng)))
        },
    ];
    [
        Quantity::new("irradiance of a level plane", irradiance, on_plane),
        Quantity::new("mean radiance", mean, all_round),
    ]
}
