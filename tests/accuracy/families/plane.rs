//! The constructors of the warps of the plane and of triangles in space.

use super::Constructor;
use microwarp::Warp;
use microwarp::tier::Tier;
use microwarp::warp::*;
use support::adversary::words::Kind::Any;
use support::{
    registry::{Domain, Entry, Measure, entry},
    truth,
};
use truth::Truth;

pub(super) fn constructors<T: Tier>() -> Vec<Constructor> {
    vec![
        Constructor {
            name: "Disk",
            constructor: "",
            parameters: &[],
            build: |_| {
                let truth: Box<dyn Truth> = Box::new(truth::Disk);
                Some(planar::<T, _>("Disk", Disk::<T>::new(), truth))
            },
            seeds: Vec::new(),
        },
        Constructor {
            name: "DiskConcentric",
            constructor: "",
            parameters: &[],
            build: |_| {
                let truth: Box<dyn Truth> = Box::new(truth::DiskConcentric);
                Some(planar::<T, _>(
                    "DiskConcentric",
                    DiskConcentric::<T>::new(),
                    truth,
                ))
            },
            seeds: Vec::new(),
        },
        Constructor {
            name: "Triangle",
            constructor: "",
            parameters: &[],
            build: |_| {
                Some(entry::<T, _>(
                    "Triangle",
                    "",
                    Domain::Space,
                    Measure::Length(1.0),
                    Triangle::new(),
                    Box::new(truth::Barycentric) as Box<dyn Truth>,
                ))
            },
            seeds: Vec::new(),
        },
        Constructor {
            name: "TriangleOn",
            constructor: "plane",
            parameters: &[Any; 6],
            build: |p| on_vertices::<T, 2>(p, Domain::Plane),
            seeds: vec![
                vec![0.0, 0.0, 4.0, 0.0, 1.0, 3.0],
                vec![0.0, 0.0, 1.0, 0.0, 0.5, 1e-11],
                vec![0.1, 0.2, 0.7, 0.9, 0.4, 0.55],
                vec![1e6, 0.1, 1_000_001.0, -0.3, 1e6, 0.7],
            ],
        },
        Constructor {
            name: "TriangleOn",
            constructor: "space",
            parameters: &[Any; 9],
            build: |p| on_vertices::<T, 3>(p, Domain::Space),
            seeds: vec![
                vec![1.0, 0.0, 0.0, 0.0, 2.0, 0.5, -1.0, 0.0, 3.0],
                vec![0.1, 0.2, 0.3, 0.7, 0.9, -0.4, 0.4, 0.55, -0.05],
                vec![
                    1e6,
                    0.1,
                    -7e3,
                    1_000_001.0,
                    -0.3,
                    -7001.0,
                    1e6,
                    0.7,
                    -7002.0,
                ],
            ],
        },
    ]
}

fn planar<T: Tier, W>(name: &'static str, warp: W, truth: Box<dyn Truth>) -> Entry
where
    W: Warp<Uniforms = [f32; 2], Point = [f32; 2], Density = f32> + Send + Sync + 'static,
{
    entry::<T, _>(name, "", Domain::Plane, Measure::Length(1.0), warp, truth)
}

fn on_vertices<T: Tier, const D: usize>(p: &[f32], domain: Domain) -> Option<Entry>
where
    [f32; D]: support::registry::Flat<3>,
{
    let vertices: [[f32; D]; 3] = std::array::from_fn(|i| std::array::from_fn(|k| p[i * D + k]));
    let warp = TriangleOn::new(vertices).ok()?;
    let size = p.iter().fold(0.0_f32, |size, x| size.max(x.abs()));
    let wide = vertices.map(|v| std::array::from_fn(|k| v.get(k).copied().map_or(0.0, f64::from)));
    let truth = truth::OnTriangle(wide);
    let height = truth.height() / f64::from(size);
    let truth: Box<dyn Truth> = Box::new(truth);
    let e = entry::<T, _>(
        "TriangleOn",
        "",
        domain,
        Measure::Length(size.into()),
        warp,
        truth,
    );
    Some(e.variables(&[("h", height)]))
}
