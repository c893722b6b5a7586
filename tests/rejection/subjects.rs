//! The samplers under test, each with its exact efficiency and with the map that makes its points uniform.
//!
//! A map is the exact distribution function, coordinate by coordinate, in f64; it knows nothing of the crate.

use crate::examination::{Run, histogram, p_values_of_points};
use ::fixed::types::I2F30;
use host::speed;
use microwarp::rejection::{BallRejection, Bounded, DiskRejection, Region, Rejection, budget_for};
use microwarp::warp::Aabb;
use microwarp::{
    Warp, fixed, libm, poly,
    warp::{Interval, Triangle},
};
use rand_pcg::Pcg32;
use std::f64::consts::{FRAC_PI_4, FRAC_PI_6, LN_2, PI, TAU};
use std::sync::{LazyLock, OnceLock};

/// Points of a run.
pub static POINTS: LazyLock<usize> =
    LazyLock::new(|| speed::of("points of each sampler", 300_000, 2_000_000));

/// By what factor controls are more wrong than with all points: fewer points see larger errors only.
pub static MORE: LazyLock<f64> =
    LazyLock::new(|| speed::of("factor of the errors of controls", 3.5, 1.0));

/// What came of a run.
pub struct Outcome {
    /// The p-values of the points.
    pub points: Vec<f64>,
    /// The histogram of the tries.
    pub tries: Vec<u64>,
}

/// The outcomes of all subjects, in order; every subject is run once.
pub fn outcomes() -> &'static [Outcome] {
    static OUTCOMES: OnceLock<Vec<Outcome>> = OnceLock::new();
    OUTCOMES.get_or_init(|| {
        let all = all();
        let seeded = all.iter().zip(100..);
        seeded.map(|(subject, seed)| (subject.run)(seed)).collect()
    })
}

/// A sampler whose types have been erased.
pub struct Subject {
    pub name: &'static str,
    pub efficiency: f64,
    run: Box<dyn Fn(u64) -> Outcome>,
}

/// Draws points and makes them uniform.
pub fn run<S: Rejection, const D: usize>(
    sampler: &S,
    uniform: impl Fn(S::Point) -> [f64; D],
    seed: u64,
) -> Run<D> {
    let mut rng = Pcg32::new(seed, 0xbed);
    let (mut uniforms, mut tries) = (Vec::new(), Vec::new());
    for _ in 0..*POINTS {
        let accepted = sampler.draw(&mut rng).unwrap();
        uniforms.push(uniform(accepted.point));
        tries.push(accepted.tries);
    }
    Run { uniforms, tries }
}

fn subject<S: Rejection + 'static, const D: usize>(
    name: &'static str,
    efficiency: f64,
    sampler: S,
    uniform: impl Fn(S::Point) -> [f64; D] + 'static,
) -> Subject {
    Subject {
        name,
        efficiency,
        run: Box::new(move |seed| {
            let run = run(&sampler, &uniform, seed);
            Outcome {
                points: p_values_of_points(&run.uniforms),
                tries: histogram(&run.tries),
            }
        }),
    }
}

fn turns(x: f64, y: f64) -> f64 {
    (y.atan2(x) / TAU).rem_euclid(1.0)
}

pub fn disk(point: [f32; 2]) -> [f64; 2] {
    let [x, y] = point.map(f64::from);
    [x * x + y * y, turns(x, y)]
}

pub fn fixed_disk(point: [I2F30; 2]) -> [f64; 2] {
    let [x, y] = point.map(f64::from);
    [x * x + y * y, turns(x, y)]
}

pub fn ball(point: [f32; 3]) -> [f64; 3] {
    let [x, y, z] = point.map(f64::from);
    let r = (x * x + y * y + z * z).sqrt();
    [r.powi(3), 0.5 + 0.5 * z / r, turns(x, y)]
}

/// Of density proportional to 1/(1 + r²) on the disk: the radius has the CDF ln(1 + r²)/ln 2.
pub fn bump(point: [f32; 2]) -> [f64; 2] {
    let [square, turns] = disk(point);
    [square.ln_1p() / LN_2, turns]
}

pub fn bump_density([x, y]: [f32; 2]) -> f32 {
    1.0 / (1.0 + (x * x + y * y))
}

/// The same over a box, whose corners do not belong to the disk.
pub fn bump_or_zero([x, y]: [f32; 2]) -> f32 {
    if x * x + y * y <= 1.0 {
        bump_density([x, y])
    } else {
        0.0
    }
}

/// Uniform where the first barycentric coordinate is below the second: the third has the density 2(1 - z).
pub fn half_triangle(point: [f32; 3]) -> [f64; 2] {
    let [x, y, z] = point.map(f64::from);
    [1.0 - (1.0 - z) * (1.0 - z), 2.0 * x / (x + y)]
}

/// Uniform directions within 60 degrees of the axis: z is uniform on [1/2, 1].
pub fn cap(point: [f32; 3]) -> [f64; 2] {
    let [x, y, z] = point.map(f64::from);
    [2.0 * z - 1.0, turns(x, y)]
}

/// Directions of density proportional to z²: z³ is uniform.
pub fn squared_cosine(point: [f32; 3]) -> [f64; 2] {
    let [x, y, z] = point.map(f64::from);
    [z.powi(3), turns(x, y)]
}

/// Uniform below the plane x + y + z = 1 in the unit cube.
pub fn simplex(point: [f32; 3]) -> [f64; 3] {
    let [x, y, z] = point.map(f64::from);
    let t = x + y + z;
    let rest = 1.0 - x / t;
    [t.powi(3), 1.0 - rest * rest, y / (y + z)]
}

pub fn half_sine(x: f32) -> [f64; 1] {
    [0.5 - 0.5 * f64::from(x).cos()]
}

pub fn budget(efficiency: f64) -> u32 {
    budget_for(efficiency as f32).unwrap()
}

/// Every sampler, over warps of both tiers.
pub fn all() -> Vec<Subject> {
    let pi = std::f32::consts::PI;
    let unit = |n: [f32; 3]| n[2] > 0.5;
    let square = Aabb::new([-1.0; 2], [1.0; 2]).unwrap();
    let cube = Aabb::new([0.0; 3], [1.0; 3]).unwrap();
    let line = Interval::new(0.0, pi).unwrap();
    let decay = poly::Exponential::from_rate(2.0).unwrap();
    let tail = libm::ExponentialTail::from_rate(2.0).unwrap();
    // Of x below 1, both: (1 - e^(-2x))/(1 - e^-2).
    let below_one = |x: f32| [(-2.0 * f64::from(x)).exp_m1() / (-2.0_f64).exp_m1()];
    let mass = -(-2.0_f64).exp_m1();
    fn region<W: Warp, P: Fn(W::Point) -> bool>(domain: W, inside: P, e: f64) -> Region<W, P> {
        Region::new(domain, inside).with_budget(budget(e)).unwrap()
    }
    let half = region(Triangle::new(), |b: [f32; 3]| b[0] < b[1], 0.5);
    let fast = region(poly::Hemisphere::new(), unit, 0.5);
    let slow = region(libm::Hemisphere::new(), unit, 0.5);
    let decay = region(decay, |x| x < 1.0, mass);
    let tail = region(tail, |x| x < 1.0, mass);
    let below = region(cube, |p: [f32; 3]| p.iter().sum::<f32>() < 1.0, 1.0 / 6.0);
    // The integral of 1/(1 + r²) over the disk is π ln 2.
    let [over_poly, over_libm] = ["1/(1 + r²) over Disk, poly", "1/(1 + r²) over Disk, libm"];
    let over_concentric = "1/(1 + r²) over DiskConcentric, twice the bound";
    let on_poly = Bounded::new(poly::Disk::new(), bump_density, pi).unwrap();
    let on_libm = Bounded::new(libm::Disk::new(), bump_density, pi).unwrap();
    let concentric = Bounded::new(poly::DiskConcentric::new(), bump_density, 2.0 * pi).unwrap();
    let in_box = Bounded::new(square, bump_or_zero, 4.0).unwrap();
    let sine = Bounded::new(line, f32::sin, pi).unwrap();
    // f/p = π z, of integral 2π/3.
    let z2 = |n: [f32; 3]| n[2] * n[2];
    let lobe_poly = Bounded::new(poly::CosineHemisphere::new(), z2, pi).unwrap();
    let lobe_libm = Bounded::new(libm::CosineHemisphere::new(), z2, pi).unwrap();
    let (long, short) = (fixed::DiskRejection::new(), fixed::DiskRejection16::new());
    vec![
        subject("disk", FRAC_PI_4, DiskRejection::new(), disk),
        subject("ball", FRAC_PI_6, BallRejection::new(), ball),
        subject("half a triangle", 0.5, half, half_triangle),
        subject("cap, poly", 0.5, fast, cap),
        subject("cap, libm", 0.5, slow, cap),
        subject("exponential below 1", mass, decay, below_one),
        subject("the same from its tail", mass, tail, below_one),
        subject("simplex in a box", 1.0 / 6.0, below, simplex),
        subject(over_poly, LN_2, on_poly, bump),
        subject(over_libm, LN_2, on_libm, bump),
        subject(over_concentric, 0.5 * LN_2, concentric, bump),
        subject("1/(1 + r²) over its box", PI * LN_2 / 4.0, in_box, bump),
        subject("sin over Interval", 2.0 / PI, sine, half_sine),
        subject("z² over a lobe, poly", 2.0 / 3.0, lobe_poly, squared_cosine),
        subject("z² over a lobe, libm", 2.0 / 3.0, lobe_libm, squared_cosine),
        subject("integers, two words", FRAC_PI_4, long, fixed_disk),
        subject("integers, one word", FRAC_PI_4, short, fixed_disk),
    ]
}
