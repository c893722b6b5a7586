//! What the table is for: the light of the sky by Monte Carlo, with directions from the table, uniform directions and
//! cosine-weighted ones, against the exact values.

use crate::study::Truth;
use microwarp::discrete::PiecewiseConstant2d;
use microwarp::{Warp, poly as mw};
use rand_pcg::Pcg32;
use std::f64::consts::{PI, TAU};

/// Directions in one estimate, and how often it is repeated for the error.
pub const DIRECTIONS: usize = 1000;
pub const REPETITIONS: usize = 1000;

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
            if (way.mean - exact).abs() > 6.0 * sigma {
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
    table: &PiecewiseConstant2d<&[u32], &[u32]>,
    truth: &Truth,
    luminance: &[f64],
    seed: u64,
) -> [Quantity; 2] {
    let [columns, rows] = truth.shape;
    let texel = |[phi, theta]: [f32; 2]| luminance[truth.cell([phi, theta])];
    let look = |direction: [f32; 3]| {
        let place = mw::Spherical::from_cartesian(direction);
        // The nadir is a row's end that belongs to no row.
        texel([place.phi_turns(), place.theta_turns().min(0.499_999)])
    };
    // A direction from the table, with the reciprocal of its density per steradian.
    let mut rng = Pcg32::new(seed, 20);
    let mut from_table = || {
        let [phi, theta] = table.draw(&mut rng);
        let place =
            mw::Spherical::from_turns(1.0, theta, phi).expect("a sample lies in the rectangle");
        let jacobian = TAU * TAU * f64::from(place.solid_angle_jacobian());
        let density = f64::from(table.pdf([phi, theta]));
        (
            texel([phi, theta]),
            place.to_cartesian(),
            jacobian / density,
        )
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
