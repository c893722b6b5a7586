//! The warps over triangles and rectangles that are seen from a point.

use super::picture::View::Sky;
use super::{Domain, Entry, Measure, Registered, Uniforms, entry};
use crate::adversary::words::Kind::{self, Within};
use crate::truth::{Light, Truth, dot, exact};
use microwarp::Error::{self, *};
use microwarp::Invert;
use microwarp::tier::Tier;
use microwarp::warp::*;
use std::f64::consts::FRAC_PI_2;
use std::sync::Arc;

const NAN: f32 = f32::NAN;
const UNIT: Kind = Within(-1.0, 1.0);

fn at(p: &[f32], k: usize) -> [f32; 3] {
    [p[k], p[k + 1], p[k + 2]]
}

/// A vector times a power of two from 1 down to 2⁻³¹.
fn shrunk(x: [f32; 3], by: f32) -> [f32; 3] {
    // What is no number of halvings is no light either.
    let scale = if by.is_finite() {
        (-by.floor()).exp2()
    } else {
        f32::NAN
    };
    x.map(|x| x * scale)
}

fn seen<T: Tier, W>(name: &'static str, warp: W, light: Light, truth: Arc<dyn Truth>) -> Entry
where
    W: Invert<Uniforms = [f32; 2], Point = [f32; 3], Density = f32> + Send + Sync + 'static,
{
    let variables = light.variables();
    let mut entry = entry::<T, _>(name, Domain::World, Measure::Length(1.0), warp, truth);
    entry.azimuth = false;
    entry
        .variables(&variables)
        .own_density()
        .outside(&[[0.0, 0.0, -1.0], [0.6, 0.0, -0.8]])
}

fn triangle<T: Tier>(point: [f32; 3], vertices: [[f32; 3]; 3]) -> Result<Entry, Error> {
    let warp = SphericalTriangle::<T>::new(point, vertices)?;
    let light = Light::triangle(point, vertices);
    let place = move |u: Uniforms| {
        let found = warp.locate([u[0], u[1]]).barycentric;
        (found, light.place(u.map(f64::from)))
    };
    let mut entry = seen::<T, _>(
        "SphericalTriangle",
        warp,
        light,
        exact!(Light::triangle(point, vertices)),
    );
    entry.place = Some(Arc::new(place));
    let alone = SphericalTriangle::<T>::density_of(point, vertices);
    entry.alone = Some(alone.unwrap_or(f32::NAN));
    Ok(entry)
}

fn rectangle<T: Tier>(
    point: [f32; 3],
    corner: [f32; 3],
    edges: [[f32; 3]; 2],
) -> Result<Entry, Error> {
    let warp = SphericalRectangle::<T>::new(point, corner, edges)?;
    let light = Light::rectangle(point, corner, edges);
    let place = move |u: Uniforms| {
        let [s, t] = warp.locate([u[0], u[1]]).st;
        ([s, t, 0.0], light.place(u.map(f64::from)))
    };
    let mut entry = seen::<T, _>(
        "SphericalRectangle",
        warp,
        light,
        exact!(Light::rectangle(point, corner, edges)),
    );
    entry.place = Some(Arc::new(place));
    let alone = SphericalRectangle::<T>::density_of(point, corner, edges);
    entry.alone = Some(alone.unwrap_or(f32::NAN));
    Ok(entry)
}

/// What `f32` directions do not resolve.
fn tiny(mut entry: Entry) -> Entry {
    entry.slack = f64::INFINITY;
    entry.unresolved()
}

/// The direction to a point of a light with a corner at (-0.6, -0.5, 0.8), by shares of both edges there.
fn toward(edges: [[f64; 3]; 2], [s, t]: [f64; 2]) -> [f64; 3] {
    let corner = [-0.6, -0.5, 0.8];
    let point = [0, 1, 2].map(|k| corner[k] + s * edges[0][k] + t * edges[1][k]);
    point.map(|c| c / dot(point, point).sqrt())
}

/// So far may the inverse of a rounded direction lie outside.
fn loose(mut entry: Entry, slack: f64) -> Entry {
    entry.slack = slack;
    entry
}

#[rustfmt::skip] // one line a case
pub(super) fn registered<T: Tier>() -> Vec<Registered> {
    vec![
        Registered::new("SphericalTriangle", "", &[UNIT; 12], |p| {
            triangle::<T>(at(p, 0), [at(p, 3), at(p, 6), at(p, 9)])
        })
            .parameters(&[0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1, 1])
            .case_with("1 sr", &[0.0, 0.0, 0.0, -0.6, -0.5, 0.8, 0.7, -0.4, 0.9, 0.1, 0.8, 0.6], |e| {
                loose(e.picture("a triangle seen from a point", Sky(FRAC_PI_2)), 3e-5)
            })
            .control("points that are uniform on a triangle", |[u, v, _], _| toward([[1.3, 0.1, 0.1], [0.7, 1.3, -0.2]], [u.sqrt() * (1.0 - v), u.sqrt() * v]), &["chi-square", "distance"])
            .case_with("2e-3 sr", &[0.9, -0.7, -1.0, 0.1, 0.0, 1.0, 0.0, 0.1, 0.9, -0.1, -0.1, 1.0], |e| loose(e, 1e-4))
            .case_with("sliver", &[0.0, 0.0, 0.0, -0.6, 0.0, 0.8, 0.7, 0.3, 0.9, 0.055, 0.151, 0.85], |e| loose(e, 1e-2))
            .case_with("above", &[0.0, 0.1, 0.0, 1.0, 0.0, 0.05, -0.5, 0.9, 0.05, -0.5, -0.9, 0.05], |e| loose(e, 1e-4))
            .case_with("close", &[0.0, 0.1, 0.0, 1.0, 0.0, 0.003, -0.5, 0.9, 0.003, -0.5, -0.9, 0.003], |e| loose(e, 1e-3))
            .case_with("from its edge", &[0.0, 0.0, 0.0, 0.7, 0.3, 0.000_2, 0.8, -0.5, 0.000_2, 0.3, 0.1, 0.000_2], |mut e| {
                e.outside = Some(&[[0.0, 0.0, -1.0], [-1.0, 0.0, 0.0], [-0.9, -0.4, 0.0]]);
                tiny(e)
            })
            .seed(&[0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0])
            .seed(&[0.0, 0.1, 0.0, 1.0, 0.0, 0.03, -0.5, 0.9, 0.03, -0.5, -0.9, 0.03])
            .seed(&[0.0, 0.1, 0.0, 1.0, 0.0, 0.001, -0.5, 0.9, 0.001, -0.5, -0.9, 0.001])
            .seed(&[0.0, 0.1, 0.0, 0.03, 1.0, 0.01, 0.03, -1.0, 0.01, 1.0, 0.2, 0.3])
            .seed(&[0.0, 0.1, 0.0, 0.01, 1.0, 0.01, 1.0, 0.2, -0.3, 0.01, -1.0, 0.01])
            .seed(&[0.0, 0.0, 0.0, -0.6, 0.0, 0.8, 0.7, 0.3, 0.9, 0.05, 0.150_1, 0.85])
            .refuse(&[NAN; 12], NotFinite(0))
            .refuse(&[0.0, 0.0, 0.0, 1e20, 0.0, 1.0, 0.0, 1.0, 1.0, 0.0, 0.0, 1.0], TooLarge(1))
            .refuse(&[0.0, 0.0, 0.0, 1.0, 0.0, 1.0, 1.0, 0.0, 1.0, 0.0, 1.0, 1.0], Empty(1))
            .refuse(&[0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0], Empty(1))
            .refuse(&[0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 2.0, 2.0, 2.0, 3.0, 3.0, 3.0], Empty(1))
            .refuse(&[0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 2.0, 1.0, 0.0, 1.0, 1.0, 0.0], Empty(1))
            .refuse(&[0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 1.0, 0.0, 1.0, 1.0], NotNormalizable(1))
            .refuse(&[0.0, 0.0, 0.0, 1.0, 0.0, 0.0, -1.0, 1.0, 0.0, -1.0, -1.0, 0.0], NotNormalizable(1))
            .refuse(&[0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, -1.0, 0.0, 1.0, 0.0, 0.0], NotNormalizable(1))
            .without("constant", "its constructor is no constant function: it takes roots")
            .without("getters", "it keeps what its map needs"),
        Registered::new("SphericalTriangle", "small", &[Within(0.0, 31.0), UNIT, UNIT, UNIT, UNIT, UNIT, UNIT, UNIT, UNIT, UNIT, UNIT, UNIT, UNIT], |p| {
            triangle::<T>(at(p, 1), [at(p, 4), at(p, 7), at(p, 10)].map(|v| shrunk(v, p[0])))
        })
            .parameters(&[1, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1, 1])
            .case_with("1e-13 sr", &[22.0, 0.6, 0.0, -0.8, 0.5, 0.5, 0.1, 0.0, -0.5, 0.1, -0.5, 0.5, -0.3], |mut e| {
                e.outside = Some(&[[0.6, 0.0, -0.8], [-0.599, 0.001, 0.8]]);
                tiny(e)
            })
            .seed(&[3.0, 0.6, 0.0, -0.8, 0.5, 0.5, 0.1, 0.0, -0.5, 0.1, -0.5, 0.5, -0.3])
            .refuse(&[0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0], Empty(1)),
        Registered::new("SphericalRectangle", "", &[UNIT; 12], |p| {
            rectangle::<T>(at(p, 0), at(p, 3), [at(p, 6), at(p, 9)])
        })
            .parameters(&[0, 0, 0, 1, 1, 1, 2, 2, 2, 2, 2, 2])
            .case_with("1 sr", &[0.0, 0.0, 0.0, -0.6, -0.5, 0.8, 1.2, 0.1, 0.1, -0.1, 1.0, 0.2], |e| {
                loose(e.picture("a rectangle seen from a point", Sky(FRAC_PI_2)), 3e-5)
            })
            .control("points that are uniform on a rectangle", |[u, v, _], _| toward([[1.2, 0.1, 0.1], [-0.1, 1.0, 0.2]], [u, v]), &["chi-square", "distance"])
            .case_with("2e-3 sr", &[0.9, -0.7, -1.0, 0.1, 0.0, 1.0, 0.0, 0.05, 0.1, -0.1, 0.0, 0.0], |e| loose(e, 1e-4))
            .case_with("strip", &[0.0, 0.0, 0.0, -0.6, 0.0, 0.8, 1.3, 0.3, 0.1, -0.0003, 0.0012, 0.0], |e| loose(e, 1e-2))
            .case_with("above", &[0.1, 0.2, 0.0, 0.5, -0.7, 0.1, 0.0, 1.4, 0.0, -1.0, 0.0, 0.0], |e| loose(e, 1e-4))
            .case_with("close", &[0.1, 0.2, 0.0, 0.5, -0.7, 0.004, 0.0, 1.4, 0.0, -1.0, 0.0, 0.0], |e| loose(e, 1e-3))
            .seed(&[0.0, 0.0, 0.0, -0.6, -0.5, 0.8, 1.0, 0.1, 0.1, -0.1, 1.0, 0.2])
            .seed(&[0.1, 0.2, 0.0, 0.5, -0.7, 0.03, 0.0, 1.0, 0.0, -1.0, 0.0, 0.0])
            .seed(&[0.1, 0.2, 0.0, 0.5, -0.7, 0.002, 0.0, 1.0, 0.0, -1.0, 0.0, 0.0])
            .seed(&[0.0, 0.0, 0.0, -0.6, 0.01, 0.01, 1.0, 0.0, 0.0, 0.0, 0.5, 0.3])
            .refuse(&[0.0, 0.0, NAN, -0.6, -0.5, 0.8, 1.0, 0.1, 0.1, -0.1, 1.0, 0.2], NotFinite(0))
            .refuse(&[0.0, 0.0, 0.0, -0.6, -0.5, 0.8, 1e20, 0.1, 0.1, -0.1, 1.0, 0.2], TooLarge(Error::NO_PLACE))
            .refuse(&[0.0, 0.0, 0.0, -0.6, -0.5, 0.8, 0.0, 0.0, 0.0, -0.1, 1.0, 0.2], ZeroLength(2))
            .refuse(&[0.0, 0.0, 0.0, 0.0, 0.0, 1e-20, 1e-20, 0.0, 0.0, 0.0, 0.0, 0.0], ZeroLength(2))
            .refuse(&[0.0, 0.0, 0.0, -0.6, -0.5, 0.8, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0], Empty(Error::NO_PLACE))
            .refuse(&[0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0], Empty(Error::NO_PLACE))
            .refuse(&[0.0, 0.0, 0.0, -0.5, -0.6, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0], NotNormalizable(Error::NO_PLACE))
            .without("constant", "its constructor is no constant function: it takes roots")
            .without("getters", "it keeps what its map needs"),
        Registered::new("SphericalRectangle", "small", &[Within(0.0, 31.0), UNIT, UNIT, UNIT, UNIT, UNIT, UNIT, UNIT, UNIT, UNIT, UNIT, UNIT, UNIT], |p| {
            let [corner, ex, ey] = [at(p, 4), at(p, 7), at(p, 10)].map(|v| shrunk(v, p[0]));
            rectangle::<T>(at(p, 1), corner, [ex, ey])
        })
            .parameters(&[1, 0, 0, 0, 1, 1, 1, 2, 2, 2, 2, 2, 2])
            .case_with("1e-13 sr", &[22.0, 0.6, 0.0, -0.8, 0.5, 0.5, 0.1, -0.8, 0.5, 0.1, 0.5, 0.5, -0.3], |mut e| {
                e.outside = Some(&[[0.6, 0.0, -0.8], [-0.599, 0.001, 0.8]]);
                tiny(e)
            })
            .seed(&[3.0, 0.6, 0.0, -0.8, 0.5, 0.5, 0.1, -0.8, 0.5, 0.1, 0.5, 0.5, -0.3])
            .refuse(&[0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0], ZeroLength(2)),
    ]
}
