//! What is drawn: four samplers, each with its exact efficiency and the exact law of its points' radius.

use microwarp::rejection::{
    Accepted, BallRejection, Bounded, DiskRejection, Failure, Region, Rejection, budget_for,
};
use microwarp::uniform::grid;
use microwarp::warp::Aabb;
use microwarp::{Warp, poly as mw};
use rand_core::Rng;
use rand_pcg::Pcg32;
use std::f32::consts::PI;
use std::f64::consts::{FRAC_PI_4, FRAC_PI_6, FRAC_PI_8, LN_2, TAU};

/// A proposed point and whether it was accepted.
pub type Proposal = ([f64; 3], bool);
type Draw = Box<dyn Fn(&mut Pcg32) -> Result<Accepted<[f64; 3]>, Failure>>;

pub struct Scene {
    pub file: &'static str,
    pub name: &'static str,
    pub proposal: &'static str,
    pub caption: &'static str,
    /// The efficiency, and how it is written.
    pub efficiency: f64,
    pub formula: &'static str,
    pub budget: u32,
    /// Where the efficiency shown is one in a slice |z| ≤ this.
    pub slice: Option<f64>,
    /// The exact density of an accepted point's radius.
    pub radius_density: fn(f64) -> f64,
    /// The border of the region.
    pub outline: fn(f64) -> [f64; 2],
    /// One try with explicit uniforms, whose point is seen even where it is rejected.
    pub propose: Box<dyn Fn(&mut Pcg32) -> Proposal>,
    /// A point, and the tries it took.
    pub draw: Draw,
}

fn wide<const N: usize>(point: [f32; N]) -> [f64; 3] {
    std::array::from_fn(|i| point.get(i).map_or(0.0, |c| f64::from(*c)))
}

fn draws<const N: usize, S>(sampler: S) -> Draw
where
    S: Rejection<Point = [f32; N]> + 'static,
{
    Box::new(move |rng| {
        let Accepted { point, tries } = sampler.draw(rng)?;
        let point = wide(point);
        Ok(Accepted { point, tries })
    })
}

fn circle(turns: f64) -> [f64; 2] {
    let (s, c) = (TAU * turns).sin_cos();
    [c, s]
}

/// r = |cos(5θ/2)|: five petals, which cover half of the unit disk.
fn rose(turns: f64) -> [f64; 2] {
    let r = (2.5 * TAU * turns).cos().abs();
    circle(turns).map(|c| r * c)
}

/// The same as a predicate without angles: cos² of half an angle, and cos 5θ by Chebyshev's polynomial.
fn in_rose([x, y]: [f32; 2]) -> bool {
    let square = x * x + y * y;
    let c2 = x * x / square;
    // cos 5θ = c (16 c⁴ - 20 c² + 5), and c = x/r where r is the root of the square.
    let five = x / square.sqrt() * ((16.0 * c2 - 20.0) * c2 + 5.0);
    square <= 0.5 + 0.5 * five
}

fn bump([x, y]: [f32; 2]) -> f32 {
    1.0 / (1.0 + (x * x + y * y))
}

pub fn all() -> Result<Vec<Scene>, microwarp::Error> {
    Ok(vec![disk()?, inverse_square()?, rose_in_a_box()?, ball()?])
}

fn disk() -> Result<Scene, microwarp::Error> {
    let square = Aabb::new([-1.0; 2], [1.0; 2])?;
    Ok(Scene {
        file: "disk",
        name: "uniform disk",
        proposal: "square",
        caption: "DiskRejection: points of the square, kept where x² + y² < 1",
        efficiency: FRAC_PI_4,
        formula: "π/4",
        budget: DiskRejection::BUDGET,
        slice: None,
        radius_density: |r| 2.0 * r,
        outline: circle,
        propose: Box::new(move |rng| {
            let u = [grid(rng), grid(rng)];
            let kept = DiskRejection::new().attempt(u);
            (wide(kept.unwrap_or(square.sample(u))), kept.is_some())
        }),
        draw: draws(DiskRejection::new()),
    })
}

fn inverse_square() -> Result<Scene, microwarp::Error> {
    let disk = mw::Disk::new();
    // The efficiency is the integral of f, π ln 2, over c = π, the largest f/p.
    let budget = budget_for(LN_2 as f32)?;
    let sampler = Bounded::new(disk, bump, PI)?.with_budget(budget)?;
    Ok(Scene {
        file: "inverse-square",
        name: "1/(1 + r²) on the disk",
        proposal: "uniform disk",
        caption: "Bounded: points of Disk (p = 1/π), kept with probability f/(c p) for c = π",
        efficiency: LN_2,
        formula: "∫f/c = ln 2",
        budget,
        slice: None,
        radius_density: |r| 2.0 * r / (1.0 + r * r) / LN_2,
        outline: circle,
        propose: Box::new(move |rng| {
            let u = [grid(rng), grid(rng)];
            let kept = sampler.attempt(u, rng.next_u32());
            let kept = kept.expect("f does not exceed its bound");
            (wide(disk.sample(u)), kept.is_some())
        }),
        draw: draws(sampler),
    })
}

fn rose_in_a_box() -> Result<Scene, microwarp::Error> {
    let square = Aabb::new([-1.0; 2], [1.0; 2])?;
    let budget = budget_for(FRAC_PI_8 as f32)?;
    let sampler = Region::new(square, in_rose).with_budget(budget)?;
    Ok(Scene {
        file: "rose",
        name: "uniform rose",
        proposal: "box",
        caption: "Region: points of a box, kept where a predicate says so: r ≤ |cos 5θ/2|",
        efficiency: FRAC_PI_8,
        formula: "π/8",
        budget,
        slice: None,
        // Of the angles, the share 1 - (2/π) asin r has petals as long as r; their area is π/2.
        radius_density: |r| 4.0 * r * (1.0 - r.asin() / std::f64::consts::FRAC_PI_2),
        outline: rose,
        propose: Box::new(move |rng| {
            let u = [grid(rng), grid(rng)];
            (wide(square.sample(u)), sampler.attempt(u).is_some())
        }),
        draw: draws(sampler),
    })
}

fn ball() -> Result<Scene, microwarp::Error> {
    let cube = Aabb::new([-1.0; 3], [1.0; 3])?;
    Ok(Scene {
        file: "ball",
        name: "uniform ball",
        proposal: "cube",
        caption: "BallRejection: points of the cube, kept where x² + y² + z² < 1",
        efficiency: FRAC_PI_6,
        formula: "π/6",
        budget: BallRejection::BUDGET,
        slice: Some(0.1),
        radius_density: |r| 3.0 * r * r,
        outline: circle,
        propose: Box::new(move |rng| {
            let u = [grid(rng), grid(rng), grid(rng)];
            let kept = BallRejection::new().attempt(u);
            (wide(kept.unwrap_or(cube.sample(u))), kept.is_some())
        }),
        draw: draws(BallRejection::new()),
    })
}
