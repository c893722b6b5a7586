//! The constructors of the warps over directions.

use super::Constructor;
use microwarp::tier::Tier;
use microwarp::warp::*;
use microwarp::{Frame, Warp};
use std::f32::consts::PI;
use support::adversary::words::Kind::{Any, Positive, Within};
use support::registry::directions::exact_frame;
use support::{
    registry::{Domain, Entry, Measure, entry},
    truth,
};
use truth::Truth;

pub(super) fn constructors<T: Tier>() -> Vec<Constructor> {
    let plain = |name, build| Constructor {
        name,
        constructor: "",
        parameters: &[],
        build,
        seeds: Vec::new(),
    };
    vec![
        plain("Sphere", |_| {
            Some(of::<T, _>("Sphere", Sphere::<T>::new(), truth::sphere()))
        }),
        plain("Hemisphere", |_| {
            Some(of::<T, _>(
                "Hemisphere",
                Hemisphere::<T>::new(),
                truth::hemisphere(),
            ))
        }),
        plain("CosineHemisphere", |_| {
            Some(of::<T, _>(
                "CosineHemisphere",
                CosineHemisphere::<T>::new(),
                truth::cosine_hemisphere(),
            ))
        }),
        plain("MalleyHemisphere", |_| {
            Some(of::<T, _>(
                "MalleyHemisphere",
                MalleyHemisphere::<T>::new(),
                Box::new(truth::Malley),
            ))
        }),
        Constructor {
            name: "PhongLobe",
            constructor: "",
            parameters: &[Positive],
            build: |p| {
                Some(of::<T, _>(
                    "PhongLobe",
                    PhongLobe::<T>::new(p[0]).ok()?,
                    truth::phong(p[0]),
                ))
            },
            seeds: vec![vec![50.0], vec![1e8]],
        },
        Constructor {
            name: "Cone",
            constructor: "from_one_minus_cos",
            parameters: &[Within(0.0, 2.0)],
            build: |p| {
                let k = f64::from(p[0]);
                Some(of::<T, _>(
                    "Cone",
                    Cone::<T>::from_one_minus_cos(p[0]).ok()?,
                    truth::cone(k, 2.0 - k),
                ))
            },
            seeds: Vec::new(),
        },
        Constructor {
            name: "Cone",
            constructor: "from_angle",
            parameters: &[Within(0.0, PI)],
            build: |p| {
                let (k, rest) = (truth::one_minus_cos(p[0]), truth::one_plus_cos(p[0]));
                Some(of::<T, _>(
                    "Cone",
                    Cone::<T>::from_angle(p[0]).ok()?,
                    truth::cone(k, rest),
                ))
            },
            seeds: vec![vec![1.05]],
        },
        Constructor {
            name: "Cone",
            constructor: "from_sphere",
            parameters: &[Within(0.0, 1.0)],
            build: |p| {
                let s = f64::from(p[0]);
                let k = s * s / (1.0 + ((1.0 - s) * (1.0 + s)).sqrt());
                Some(of::<T, _>(
                    "Cone",
                    Cone::<T>::from_sphere(p[0]).ok()?,
                    truth::cone(k, 2.0 - k),
                ))
            },
            seeds: Vec::new(),
        },
        Constructor {
            name: "SphericalPatch",
            constructor: "",
            parameters: &[
                Within(0.0, 0.5),
                Within(0.0, 0.5),
                Within(-1.0, 1.0),
                Within(-1.0, 2.0),
            ],
            build: |p| {
                let warp = SphericalPatch::<T>::new(p[0], p[1], p[2], p[3]).ok()?;
                let [theta, phi] = [[p[0], p[1]], [p[2], p[3]]].map(|a| a.map(f64::from));
                let truth = truth::Patch { theta, phi };
                let variables = [
                    ("c", truth.drop()),
                    ("q", truth.reach()),
                    ("w", truth.width()),
                ];
                Some(of::<T, _>("SphericalPatch", warp, Box::new(truth)).variables(&variables))
            },
            seeds: vec![
                vec![0.499_999_85, 0.5, 0.0, 1.0],
                vec![0.0, 0.25, 0.0, 0.25],
            ],
        },
        turned("Hemisphere", &[Any; 3], |p| {
            about::<T, _>(p, Hemisphere::<T>::new(), truth::hemisphere())
        }),
        turned("CosineHemisphere", &[Any; 3], |p| {
            about::<T, _>(p, CosineHemisphere::<T>::new(), truth::cosine_hemisphere())
        }),
        turned("MalleyHemisphere", &[Any; 3], |p| {
            about::<T, _>(p, MalleyHemisphere::<T>::new(), Box::new(truth::Malley))
        }),
        turned("Cone", &[Any, Any, Any, Within(0.0, 2.0)], |p| {
            let k = f64::from(p[3]);
            about::<T, _>(
                p,
                Cone::<T>::from_one_minus_cos(p[3]).ok()?,
                truth::cone(k, 2.0 - k),
            )
        }),
        turned("PhongLobe", &[Any, Any, Any, Within(1.0, 1e8)], |p| {
            about::<T, _>(p, PhongLobe::<T>::new(p[3]).ok()?, truth::phong(p[3]))
        }),
    ]
}

fn of<T: Tier, W>(name: &'static str, warp: W, truth: Box<dyn Truth>) -> Entry
where
    W: Warp<Uniforms = [f32; 2], Point = [f32; 3], Density = f32> + Send + Sync + 'static,
{
    entry::<T, _>(
        name,
        "",
        Domain::Directions,
        Measure::Length(1.0),
        warp,
        truth,
    )
}

fn turned(
    constructor: &'static str,
    parameters: &'static [support::adversary::words::Kind],
    build: fn(&[f32]) -> Option<Entry>,
) -> Constructor {
    Constructor {
        name: "Oriented",
        constructor,
        parameters,
        build,
        seeds: Vec::new(),
    }
}

/// A warp about the normal that the first three parameters are.
fn about<T: Tier, W>(p: &[f32], warp: W, inner: Box<dyn Truth>) -> Option<Entry>
where
    W: Warp<Uniforms = [f32; 2], Point = [f32; 3], Density = f32> + Send + Sync + 'static,
{
    let normal = [p[0], p[1], p[2]];
    let frame = Frame::new(normal).ok()?;
    let axes = exact_frame(normal);
    let truth: Box<dyn Truth> = Box::new(truth::Turned { inner, axes });
    let world = Domain::World;
    Some(entry::<T, _>(
        "Oriented",
        "",
        world,
        Measure::Length(1.0),
        Oriented::new(warp, frame),
        truth,
    ))
}
