//! The warps of the plane and of triangles in space.

use super::{Domain, Entry, Measure, entry};
use crate::truth::{self, Truth};
use microwarp::tier::Tier;
use microwarp::warp::*;

pub(crate) fn entries<T: Tier>() -> Vec<Entry> {
    use Domain::{Plane, Space};
    use Measure::Length;
    let mut t = vec![
        entry::<T, _>(
            "Disk",
            "",
            Plane,
            Length(1.0),
            Disk::<T>::new(),
            Box::new(truth::Disk) as Box<dyn Truth>,
        ),
        entry::<T, _>(
            "DiskConcentric",
            "",
            Plane,
            Length(1.0),
            DiskConcentric::<T>::new(),
            Box::new(truth::DiskConcentric) as Box<dyn Truth>,
        )
        .chart(Box::new(truth::Disk) as Box<dyn Truth>),
        entry::<T, _>(
            "Triangle",
            "",
            Space,
            Length(1.0),
            Triangle::new(),
            Box::new(truth::Barycentric) as Box<dyn Truth>,
        ),
    ];
    for (label, mean, deviation) in [
        ("0, 1", [0.0, 0.0], 1.0),
        ("(3, -2), 0.5", [3.0, -2.0], 0.5),
        ("0, 1e-18", [0.0, 0.0], 1e-18),
        ("0, 1e18", [0.0, 0.0], 1e18),
    ] {
        let far = mean[0] != 0.0;
        let e = entry::<T, _>(
            "NormalPair",
            label,
            Plane,
            Length(truth::normal_pair_size(mean, deviation)),
            NormalPair::<T>::new(mean, deviation).unwrap(),
            Box::new(truth::NormalPair {
                mean: mean.map(f64::from),
                deviation: f64::from(deviation),
            }) as Box<dyn Truth>,
        );
        t.push(if far || deviation < 1e-10 {
            e.no_round_trip()
        } else {
            e
        });
    }
    let wide = |v: [f32; 2]| [f64::from(v[0]), f64::from(v[1]), 0.0];
    for (label, vertices, size) in [
        ("plane", [[0.0, 0.0], [4.0, 0.0], [1.0, 3.0]], 4.0),
        (
            "plane 1e18",
            [[-1e18, 0.0], [1e18, -1e18], [0.0, 1e18]],
            2e18,
        ),
        ("plane sliver", [[0.0, 0.0], [1.0, 0.0], [0.5, 1e-5]], 1.0),
    ] {
        let e = entry::<T, _>(
            "TriangleOn",
            label,
            Plane,
            Length(size),
            TriangleOn::new(vertices).unwrap(),
            Box::new(truth::OnTriangle(vertices.map(wide))) as Box<dyn Truth>,
        );
        t.push(if label != "plane" {
            e.no_round_trip()
        } else {
            e
        });
    }
    let vertices = [[1.0, 0.0, 0.0], [0.0, 2.0, 0.5], [-1.0, 0.0, 3.0_f32]];
    t.push(
        entry::<T, _>(
            "TriangleOn",
            "space",
            Space,
            Length(4.0),
            TriangleOn::new(vertices).unwrap(),
            Box::new(truth::OnTriangle(vertices.map(|v| v.map(f64::from)))) as Box<dyn Truth>,
        )
        .no_round_trip(),
    );
    for (label, low, high) in [
        ("[-1, 1] x [2, 2.5]", [-1.0, 2.0], [1.0, 2.5]),
        ("[0, 1e-30] x [-1e30, 0]", [0.0, -1e30], [1e-30, 0.0]),
        ("[-3e38, 3e38] x [0, 1e-38]", [-3e38, 0.0], [3e38, 1e-38]),
    ] {
        let ends = low.iter().chain(&high);
        let size = ends.fold(0.0, |size: f32, x: &f32| size.max(x.abs()));
        t.push(entry::<T, _>(
            "Aabb",
            label,
            Plane,
            Length(size.into()),
            Aabb::new(low, high).unwrap(),
            Box::new(truth::Sides(vec![
                [low[0].into(), high[0].into()],
                [low[1].into(), high[1].into()],
            ])) as Box<dyn Truth>,
        ));
    }
    t.push(below_diagonal::<T>());
    t
}

/// Uniform below the diagonal: p(x) = 2x, p(y | x) = 1/x.
pub fn below_diagonal<T: Tier>() -> Entry {
    let conditional = |x: f32| Interval::new(0.0, x).unwrap_or(Interval::new(0.0, 1.0).unwrap());
    entry::<T, _>(
        "MarginalConditional",
        "0<y<x<1",
        Domain::Plane,
        Measure::Length(1.0),
        MarginalConditional::new(Linear::new(0.0, 1.0).unwrap(), conditional),
        Box::new(truth::Product {
            marginal: truth::linear(0.0, 1.0),
            conditional: |x: f64| {
                Box::new(truth::Line {
                    quantile: move |u| u * x,
                    pdf: move |_| 1.0 / x,
                    cdf: move |y| y / x,
                }) as Box<dyn Truth>
            },
        }) as Box<dyn Truth>,
    )
}
