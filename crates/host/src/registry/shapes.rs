//! The uniform shapes: rings, balls, rotations, polygons and simplices.

use super::evidence::{direction, disk};
use super::picture::{EQUILATERAL, window};
use super::{Domain, Entry, Measure, Registered, entry, in_both};
use crate::adversary::words::Kind::{Positive, Within};
use crate::truth::{self, exact};
use microwarp::Error::{self, *};
use microwarp::tier::Tier;
use microwarp::warp::*;
use std::f64::consts::PI;

const NAN: f32 = f32::NAN;

fn annulus<T: Tier>(radii: [f32; 2], turns: [f32; 2]) -> Result<Entry, Error> {
    let warp = Annulus::<T>::sector(radii[0], radii[1], turns[0], turns[1])?;
    let width = truth::width(turns.map(f64::from));
    let truth = exact!(Annulus {
        radii: radii.map(Real::from),
        turns: turns.map(Real::from),
    });
    let size = Measure::Length(f64::from(radii[1]));
    let mut entry = entry::<T, _>("Annulus", Domain::Plane, size, warp, truth);
    // A side that is rounded onto the other one, which lies next to it.
    entry.azimuth = width > 1.0 - 1e-6;
    Ok(entry.variables(&[("w", width)]))
}

fn polygon<T: Tier>(p: &[f32]) -> Result<Entry, Error> {
    if !p[0].is_finite() {
        return Err(NotFinite(0));
    }
    let corners = p[0] as u16;
    let warp = RegularPolygon::<T>::new(corners)?;
    let truth = exact!(RegularPolygon(corners));
    let size = Measure::Length(1.0);
    let mut entry = entry::<T, _>("RegularPolygon", Domain::Plane, size, warp, truth);
    entry.azimuth = true;
    entry.inside = |[x, y, _]| x * x + y * y <= 1.0 + 6e-7;
    Ok(entry.outside(&[[1.0, 0.1, 0.0], [-0.8, 0.7, 0.0], [-1.1, 0.0, 0.0]]))
}

#[rustfmt::skip] // one line a case
pub(super) fn registered<T: Tier>() -> Vec<Registered> {
    vec![
        Registered::new("Annulus", "", &[Positive, Positive], |p| annulus::<T>([p[0], p[1]], [0.0, 1.0]))
            .ordered(&[[0, 1]])
            .case_with("1 to 2", &[1.0, 2.0], |e| {
                e.picture("radii 1 and 2", window(0.0, 0.0, 2.04))
                    .outside(&[[0.9, 0.3, 0.0], [0.0, -2.1, 0.0], [0.0, 0.0, 0.0]])
            })
            .control("a ring with r linear in xi", |[u, v, _], _| disk((1.0 + u).powi(2), v), &["chi-square", "distance", "mean x²", "mean y²"])
            .case_with("disk of 3", &[0.0, 3.0], |e| e.outside(&[[2.0, -2.4, 0.0]]))
            .case_with("1 to 1.001", &[1.0, 1.001], |mut e| {
                e.slack = 1e-3;
                e.no_round_trip().outside(&[[0.0, 0.998, 0.0], [1.003, 0.0, 0.0]])
            })
            .case_with("1e-19 to 1e-18", &[1e-19, 1e-18], |e| e.outside(&[[0.0, 9e-20, 0.0], [1.1e-18, 0.0, 0.0]]))
            .case_with("1e17 to 1e18", &[1e17, 1e18], |e| e.outside(&[[0.0, 9e16, 0.0], [1.1e18, 0.0, 0.0]]))
            .seed(&[1.0, 2.0]).seed(&[0.0, 1.0]).seed(&[1.0, 1.000_000_1]).seed(&[1.0, 1.000_01]).seed(&[0.999, 1.0]).seed(&[1e-45, 1e-18])
            .seed(&[1e21, 1.000_000_1e21]).seed(&[0.5, 0.7])
            .refuse(&[NAN, 1.0], NotFinite(0)).refuse(&[1.0, f32::INFINITY], NotFinite(1)).refuse(&[-1.0, 1.0], Negative(0))
            .refuse(&[2.0, 1.0], Reversed(1)).refuse(&[1.0, 1.0], Empty(1)).refuse(&[0.0, 0.0], Empty(1)).refuse(&[0.0, 1e-20], Empty(Error::NO_PLACE))
            .refuse(&[0.0, 1e19], TooLarge(Error::NO_PLACE))
            .gives_back(|p| Annulus::<T>::new(p[0], p[1]).map(|warp| vec![warp.inner(), warp.outer()]))
            .constant(in_both!(Annulus<T>::new(0.3, 1.7)))
            .constant(in_both!(Annulus<T>::sector(0.3, 1.7, -0.3, 0.1))),
        Registered::new("Annulus", "sector", &[Positive, Positive, Within(-1.0, 1.0), Within(-1.0, 2.0)], |p| {
            annulus::<T>([p[0], p[1]], [p[2], p[3]])
        })
            .ordered(&[[0, 1], [2, 3]])
            .case_with("sector", &[1.0, 2.0, -0.125, 0.25], |e| {
                e.outside(&[[-1.5, 0.1, 0.0], [0.1, -1.5, 0.0], [0.5, 0.0, 0.0]]).picture("radii 1 and 2, from −45° to 90°", window(0.0, 0.0, 2.04))
            })
            .case_with("fan", &[0.0, 1.0, 0.9, 1.3], |e| e.outside(&[[-0.5, 0.1, 0.0], [0.8, 0.7, 0.0]]))
            .case_with("sector of a turn", &[0.5, 1.0, -0.3, 0.7], |e| e.outside(&[[0.1, 0.1, 0.0]]))
            .seed(&[0.0, 1.0, 0.0, 1e-7]).seed(&[1.0, 1.000_001, 1.0, 1.001]).seed(&[0.0, 1e30, 0.0, 1e-30])
            .refuse(&[1.0, 2.0, NAN, 0.5], NotFinite(2)).refuse(&[1.0, 2.0, 0.0, f32::INFINITY], NotFinite(3))
            .refuse(&[1.0, 2.0, 0.5, 0.25], Reversed(3)).refuse(&[1.0, 2.0, -1.5, -1.0], OutOfRange(2))
            .refuse(&[1.0, 2.0, -0.5, 1.0], OutOfRange(3)).refuse(&[1.0, 2.0, 0.5, 0.5], Empty(3)),
        Registered::new("Ball", "", &[], |_| {
            let truth = exact!(Ball);
            let mut entry = entry::<T, _>("Ball", Domain::Solid, Measure::Length(1.0), Ball::<T>::new(), truth);
            entry.azimuth = true;
            entry.inside = |x| x.iter().map(|c| c * c).sum::<f64>() <= 1.0 + 4.8e-7;
            Ok(entry.outside(&[[1.0, 0.1, 0.0], [0.6, 0.6, 0.6], [0.0, 0.0, -1.000_001]]))
        })
            .case_with("", &[], |e| e.picture("seen from above", window(0.0, 0.0, 1.02)))
            .control("a ball with r = the square root of xi", |[u, v, w], _| direction((1.0 - 2.0 * v).acos(), w).map(|c| u.sqrt() * c), &["chi-square", "distance", "mean x²", "mean z²"]),
        Registered::new("Rotation", "", &[], |_| {
            let truth = exact!(Rotations);
            let mut entry = entry::<T, _>("Rotation", Domain::Rotations, Measure::Length(1.0), Rotation::<T>::new(), truth);
            entry.azimuth = true;
            entry.inside = |x| x.iter().map(|c| c * c).sum::<f64>() <= 1.0 + 4.8e-7;
            // What is left for w has lost digits that the quaternion has: tests/laws/uniform_shapes.rs takes all four.
            entry.slack = 0.02;
            Ok(entry.no_round_trip().outside(&[]))
        })
            .case_with("", &[], |e| e.picture("x and y of quaternions", window(0.0, 0.0, 1.02)))
            .control("rotations about a uniform axis by a uniform angle", |[u, v, w], _| direction((1.0 - 2.0 * v).acos(), w).map(|c| (0.5 * PI * u).sin() * c), &["chi-square", "distance", "mean x²", "mean z²"]),
        Registered::new("RegularPolygon", "", &[Within(3.0, 65_535.0)], polygon::<T>)
            .case_with("6 corners", &[6.0], |e| e.picture("six corners", window(0.0, 0.0, 1.02)))
            .control("the disk within a polygon", |[u, v, _], _| disk(0.75 * u, v), &["chi-square", "distance", "mean x²"])
            .case("3 corners", &[3.0])
            .case("5 corners", &[5.0])
            .case("1001 corners", &[1001.0])
            .seed(&[3.0]).seed(&[4.0]).seed(&[5.0]).seed(&[7.0]).seed(&[12.0]).seed(&[65_535.0])
            .refuse(&[2.0], OutOfRange(0)).refuse(&[0.0], OutOfRange(0))
            .gives_back(|p| RegularPolygon::<T>::new(p[0] as u16).map(|warp| vec![warp.corners().into()]))
            .without("constant", "its constructor is no constant function: it takes roots"),
        Registered::new("Simplex", "of 2 dimensions", &[], |_| {
            let truth = exact!(Simplex(2));
            let mut entry = entry::<T, _>("Simplex", Domain::Barycentric, Measure::Length(1.0), Simplex::<T, 2>::new(), truth);
            entry.inside = |x| x.iter().all(|c| *c >= 0.0) && (x.iter().sum::<f64>() - 1.0).abs() <= 2e-7;
            Ok(entry.variables(&[("n", 2.0)]).outside(&[[-0.1, 0.5, 0.6], [1.1, -0.1, 0.0], [0.3, 0.3, 0.3]]))
        })
            .case_with("triangle", &[], |e| e.picture("two shares and the rest", EQUILATERAL)),
        Registered::new("Simplex", "of 3 dimensions", &[], |_| {
            let truth = exact!(Simplex(3));
            let mut entry = entry::<T, _>("Simplex", Domain::Solid, Measure::Length(1.0), Simplex::<T, 3>::new(), truth);
            entry.inside = |x| x.iter().all(|c| *c >= 0.0) && x.iter().sum::<f64>() <= 1.0 + 2e-7;
            // The rest of three shares has lost digits that the point has, here too.
            entry.slack = 0.02;
            Ok(entry.variables(&[("n", 3.0)]).no_round_trip().outside(&[[-0.1, 0.5, 0.6], [0.5, 0.5, 0.5]]))
        })
            .case("tetrahedron", &[])
            .control("a tetrahedron of uniforms, each of what is left", |[u, v, w], _| [u, (1.0 - u) * v, (1.0 - u) * (1.0 - v) * w], &["chi-square", "distance", "mean x"]),
    ]
}
