//! The warps over directions.

use super::{Domain, Entry, Measure, entry};
use crate::truth::{self, Truth};
use microwarp::Frame;
use microwarp::tier::Tier;
use microwarp::warp::{self, *};

pub(crate) fn entries<T: Tier>() -> Vec<Entry> {
    use Domain::{Directions, World};
    use Measure::Length;
    let mut t = vec![
        entry::<T, _>(
            "Sphere",
            "",
            Directions,
            Length(1.0),
            Sphere::<T>::new(),
            truth::sphere(),
        ),
        entry::<T, _>(
            "Hemisphere",
            "",
            Directions,
            Length(1.0),
            Hemisphere::<T>::new(),
            truth::hemisphere(),
        ),
        entry::<T, _>(
            "CosineHemisphere",
            "",
            Directions,
            Length(1.0),
            CosineHemisphere::<T>::new(),
            truth::cosine_hemisphere(),
        ),
        entry::<T, _>(
            "MalleyHemisphere",
            "",
            Directions,
            Length(1.0),
            MalleyHemisphere::<T>::new(),
            Box::new(truth::Malley) as Box<dyn Truth>,
        )
        .chart(truth::cosine_hemisphere()),
    ];
    for (label, n) in [
        ("n=0", 0.0),
        ("n=1", 1.0),
        ("n=1.4136", 1.413_630_8),
        ("n=3.4715", 3.471_497_3),
        ("n=50", 50.0),
        ("n=1e4", 1e4),
        ("n=1e6", 1e6),
        ("n=1e8", 1e8),
    ] {
        t.push(entry::<T, _>(
            "PhongLobe",
            label,
            Directions,
            Length(1.0),
            PhongLobe::<T>::new(n).unwrap(),
            truth::phong(n),
        ));
    }
    for (label, angle) in [
        ("1e-7 rad", 1e-7),
        ("1e-4 rad", 1e-4),
        ("3.9e-3 rad", 0.003_918_659),
        ("1e-2 rad", 1e-2),
        ("1.6e-2 rad", 0.016_239_65),
        ("0.1 rad", 0.1),
        ("1.5 rad", 1.5),
        ("3 rad", 3.0),
    ] {
        t.push(entry::<T, _>(
            "Cone",
            label,
            Directions,
            Length(1.0),
            Cone::<T>::from_angle(angle).unwrap(),
            truth::cone(truth::one_minus_cos(angle), truth::one_plus_cos(angle)),
        ));
    }
    t.push(entry::<T, _>(
        "Cone",
        "sphere at 1e-3",
        Directions,
        Length(1.0),
        Cone::<T>::from_sphere(1e-3).unwrap(),
        {
            let s = f64::from(1e-3_f32);
            let k = s * s / (1.0 + (1.0 - s * s).sqrt());
            truth::cone(k, 2.0 - k)
        },
    ));
    for (label, theta, phi) in [
        ("octant", [0.0, 0.25], [0.0, 0.25]),
        ("band", [0.2, 0.3], [-0.5, 0.5]),
        ("south", [0.45, 0.5], [0.1, 0.6]),
        ("1e-3 tile", [0.125, 0.126], [0.3, 0.301]),
    ] {
        let [[t0, t1], [p0, p1]]: [[f32; 2]; 2] = [theta, phi];
        t.push(entry::<T, _>(
            "SphericalPatch",
            label,
            Directions,
            Length(1.0),
            SphericalPatch::<T>::new(t0, t1, p0, p1).unwrap(),
            Box::new(truth::Patch {
                theta: theta.map(f64::from),
                phi: phi.map(f64::from),
            }) as Box<dyn Truth>,
        ));
    }
    for (label, normal) in [
        ("cosine about (1, 2, 3)", [1.0, 2.0, 3.0]),
        ("cosine about -z", [0.0, 0.0, -1.0]),
        ("cosine about (1e-4, 0, -1)", [1e-4, 0.0, -1.0]),
    ] {
        let frame = Frame::new(normal).unwrap();
        t.push(entry::<T, _>(
            "Oriented",
            label,
            World,
            Length(1.0),
            Oriented::new(warp::CosineHemisphere::<T>::new(), frame),
            Box::new(truth::Turned {
                inner: truth::cosine_hemisphere(),
                axes: exact_frame(normal),
            }) as Box<dyn Truth>,
        ));
    }
    t
}

/// The frame of Duff and others in f64.
pub fn exact_frame(normal: [f32; 3]) -> [truth::Point; 3] {
    let n = normal.map(f64::from);
    let length = truth::dot(n, n).sqrt();
    let [x, y, z] = n.map(|c| c / length);
    let sign = 1f64.copysign(z);
    // The same tangent vectors without the cancellation of 1 + a x² near the equator's pole.
    let a = -1.0 / (sign + z);
    [
        [1.0 + sign * x * x * a, sign * x * y * a, -sign * x],
        [x * y * a, sign + y * y * a, -y],
        [x, y, z],
    ]
}
