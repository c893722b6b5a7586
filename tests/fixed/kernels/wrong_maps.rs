//! Negative controls of the distributions: maps that are wrong by a little are rejected by the same examination,
//! with as few samples and cells as any grade gets.

use super::distributions::{examine, threshold};
use super::shapes::{Shape, fewest, pose, shapes};
use host::truth::{self, Truth};
use rand_core::Rng;
use rand_pcg::Pcg32;
use std::f64::consts::TAU;
use std::sync::LazyLock;

/// By what factor an error is larger where there are fewer samples.
static MORE: LazyLock<f64> = LazyLock::new(|| fewest().1);

/// A point of two uniforms.
type Map = fn([f64; 2]) -> [f64; 3];

fn shape(name: &str, axes: usize, map: Map, truth: Box<dyn Truth>) -> Shape {
    let fill = move |rng: &mut Pcg32, uniforms: &mut [[f64; 2]]| {
        for uniforms in uniforms {
            let word = |rng: &mut Pcg32| f64::from(rng.next_u32()) / 4_294_967_296.0;
            let u = [word(rng), if axes == 2 { word(rng) } else { 0.0 }];
            let [u, v, ..] = truth.invert(map(u));
            *uniforms = [u, v];
        }
        None
    };
    Shape::new(name.to_owned(), axes, Box::new(fill))
}

fn turned(r: f64, v: f64, z: f64) -> [f64; 3] {
    [r * (TAU * v).cos(), r * (TAU * v).sin(), z]
}

fn normal(u: f64, v: f64) -> [f64; 3] {
    turned((-2.0 * (-u).ln_1p()).sqrt(), v, 0.0)
}

fn lobe(power: f64, [u, v]: [f64; 2]) -> [f64; 3] {
    let cos = (1.0 - u).powf(1.0 / power);
    turned((1.0 - cos * cos).sqrt(), v, cos)
}

/// The law that `pose` leads back from, but for the sign of its last correlation.
fn turned_pose() -> Shape {
    let fill = |rng: &mut Pcg32, uniforms: &mut [[f64; 2]]| {
        for uniforms in uniforms {
            let mut pair = || {
                let [u, v] = [(); 2].map(|()| f64::from(rng.next_u32()) / 4_294_967_296.0);
                normal(u, v)
            };
            let ([x, y, _], [z, ..]) = (pair(), pair());
            let z = -0.3 * x + 0.91_f64.sqrt() * z;
            // Of x with 0.5, and of z with -0.4.
            let part = |of: f64, other: f64| (of + 0.3 * other) / 0.91;
            let (a, c) = (part(0.5, -0.4), part(-0.4, 0.5));
            let left = 1.0 - 0.5 * a + 0.4 * c;
            let y = a * x + c * z + left.sqrt() * y;
            let [u, v, _] = pose([100.0 + 5.0 * x, -20.0 + 20.0 * y, 3.0 + 50.0 * z]);
            *uniforms = [u, v];
        }
        None
    };
    Shape::new(
        "three normals with a wrong sign of one correlation".to_owned(),
        2,
        Box::new(fill),
    )
}

fn disk() -> Box<dyn Truth> {
    Box::new(truth::Disk)
}

fn normals() -> Box<dyn Truth> {
    Box::new(truth::NormalPair {
        mean: [0.0; 2],
        deviation: 1.0,
    })
}

fn wrong() -> Vec<Shape> {
    vec![
        turned_pose(),
        shape("disk with r = u", 2, |[u, v]| turned(u, v, 0.0), disk()),
        shape(
            "disk whose angles lean the more the farther out",
            2,
            |[u, v]| turned(u.sqrt(), v + 0.01 * *MORE * u * (TAU * v).sin(), 0.0),
            disk(),
        ),
        shape(
            "disk turned unevenly",
            2,
            |[u, v]| turned(u.sqrt(), v.powf(1.0 + 0.01 * *MORE), 0.0),
            disk(),
        ),
        shape(
            "ring with r linear",
            2,
            |[u, v]| turned(30.0 + 20.0 * u, v, 0.0),
            Box::new(truth::Annulus {
                radii: [30.0, 50.0],
                turns: [0.0, 1.0],
            }),
        ),
        shape(
            "polygon with equal angles along a side",
            2,
            |[u, v]| {
                // As far out as the side is at that angle.
                let off = (6.0 * v).fract() - 0.5;
                let rim = (TAU / 12.0).cos() / (TAU * off / 6.0).cos();
                turned(u.sqrt() * rim, v, 0.0)
            },
            Box::new(truth::RegularPolygon(6)),
        ),
        shape(
            "rotations with an angle uniform in its half",
            2,
            |[u, v]| {
                let angle = TAU / 4.0 * u;
                let z = angle.cos() * (TAU / 2.0 * (v - 0.5)).sin();
                turned(angle.sin(), 0.3, z)
            },
            Box::new(truth::Rotations),
        ),
        shape(
            "simplex of shares in proportion to uniforms",
            2,
            |[u, v]| [u / (u + v + 0.5), v / (u + v + 0.5), 0.5 / (u + v + 0.5)],
            Box::new(truth::Simplex(2)),
        ),
        shape(
            "sphere with theta linear",
            2,
            |[u, v]| turned((TAU * u / 2.0).sin(), v, (TAU * u / 2.0).cos()),
            truth::sphere(),
        ),
        shape(
            "cosine hemisphere with z = u",
            2,
            |[u, v]| turned((1.0 - u * u).sqrt(), v, u),
            truth::cosine_hemisphere(),
        ),
        shape(
            "lobe of n + 1 = 51.3 or more",
            2,
            |u| lobe(51.0 + 0.3 * *MORE, u),
            truth::phong(50.0),
        ),
        shape(
            "triangle without the root",
            2,
            |[u, v]| [1.0 - u, u * v, u * (1.0 - v)],
            Box::new(truth::Barycentric),
        ),
        shape(
            "exponential of a mean 1 % too large or more",
            1,
            |[u, _]| [-(1.0 + 0.01 * *MORE) * (-u).ln_1p(), 0.0, 0.0],
            truth::exponential(1.0),
        ),
        shape(
            "normals whose halves are correlated by 2 % or more",
            2,
            |[u, v]| {
                let [x, y, _] = normal(u, v);
                let r = 0.02 * *MORE;
                [x, r * x + (1.0 - r * r).sqrt() * y, 0.0]
            },
            normals(),
        ),
        shape(
            "normals of deviation 1.003 or more",
            2,
            |[u, v]| normal(u, v).map(|x| (1.0 + 0.003 * *MORE) * x),
            normals(),
        ),
        shape(
            "tent that is 1 % too narrow or more",
            1,
            |[u, _]| truth::tent(2.0 - 0.02 * *MORE as f32).sample([u; 4]),
            truth::tent(2.0),
        ),
        shape(
            "interval with a gap",
            1,
            |[u, _]| {
                [
                    8.0 * u - 3.0 + 0.01 * *MORE * (8.0 * u).floor() / 8.0,
                    0.0,
                    0.0,
                ]
            },
            truth::interval(-3.0, 5.0, true),
        ),
        shape(
            "not a number",
            1,
            |[u, _]| [if u < 1e-5 { f64::NAN } else { u }, 0.0, 0.0],
            truth::interval(0.0, 1.0, true),
        ),
    ]
}

#[test]
fn wrong_maps_are_rejected() {
    let threshold = threshold(&shapes());
    for (seed, shape) in (0xbad..).zip(wrong()) {
        let report = examine(&shape, seed);
        println!("{}: {:?} {:?}", shape.name, report.p, report.fault);
        assert!(!report.passes(threshold), "{} passes", shape.name);
    }
}
