//! The published maps of renderers have the distributions of our warps, so that the benches compare like with like.

use host::peers::renderer::{self, Weighed};
use microwarp::{Warp, poly as mw};

/// Cells of a grid of uniforms, in each direction.
const CELLS: u16 = 128;

fn grid() -> impl Iterator<Item = [f32; 2]> {
    let place = |i: u16| (f32::from(i) + 0.5) / f32::from(CELLS);
    (0..CELLS).flat_map(move |i| (0..CELLS).map(move |j| [place(i), place(j)]))
}

/// How far the two are apart: the largest relative difference of densities at the peer's points, and the largest difference of
/// means, of mean squares and of mean products of coordinates.
pub fn apart<W, const N: usize>(
    ours: &W,
    theirs: impl Fn([f32; 2]) -> Weighed<[f32; N]>,
) -> (f64, f64)
where
    W: Warp<Uniforms = [f32; 2], Point = [f32; N], Density = f32>,
{
    let mut densities = 0.0;
    let mut means = vec![0.0; N + N * N];
    for u in grid() {
        let (point, density) = theirs(u);
        let difference = f64::from((density / ours.pdf(point) - 1.0).abs());
        // What is not a number stays.
        densities = if difference <= densities {
            densities
        } else {
            difference
        };
        for (sign, point) in [(1.0, point), (-1.0, ours.sample(u))] {
            let point = point.map(f64::from);
            let products = point.iter().flat_map(|x| point.iter().map(move |y| x * y));
            for (mean, x) in means.iter_mut().zip(point.iter().copied().chain(products)) {
                *mean += sign * x / f64::from(CELLS).powi(2);
            }
        }
    }
    (
        densities,
        means.iter().fold(0.0, |most, x| most.max(x.abs())),
    )
}

const POINT: [f32; 3] = [0.1, 0.2, 0.0];
const TRIANGLE: [[f32; 3]; 3] = [[-1.0, -1.0, 3.0], [1.2, -0.8, 2.8], [0.1, 1.0, 3.3]];
const CORNER: [f32; 3] = [-1.0, -1.0, 3.0];
const EDGES: [[f32; 3]; 2] = [[2.0, 0.0, 0.0], [0.0, 2.0, 0.0]];
const WEIGHTS: [[f32; 2]; 2] = [[1.0, 2.0], [0.5, 3.0]];
pub const ALPHA: [f32; 2] = [0.3, 0.2];
pub const VIEW: [f32; 3] = [0.48, 0.36, 0.8];

#[test]
fn directions_and_points_have_the_distributions_of_ours() -> Result<(), microwarp::Error> {
    let sphere = mw::VisibleSphere::new(POINT, [0.3, -0.2, 3.0], 1.0)?;
    let triangle = mw::SphericalTriangle::new(POINT, TRIANGLE)?;
    let rectangle = mw::SphericalRectangle::new(POINT, CORNER, EDGES)?;
    let cone = mw::Cone::from_one_minus_cos(0.25)?;
    let lobe = mw::HenyeyGreenstein::new(0.8)?;
    let normals = mw::GgxVisible::new(VIEW, ALPHA)?;
    let bilinear = mw::Bilinear::new(WEIGHTS)?;
    let pairs = [
        apart(&sphere, |u| {
            renderer::sphere_lamp(POINT, [0.3, -0.2, 3.0], 1.0, u)
        }),
        apart(&triangle, |u| renderer::triangle_lamp(POINT, TRIANGLE, u)),
        apart(&rectangle, |u| {
            renderer::rectangle_lamp(POINT, CORNER, EDGES, u)
        }),
        apart(&cone, |u| renderer::cone(0.75, u)),
        apart(&lobe, |u| renderer::henyey_greenstein(0.8, u)),
        apart(&normals, |u| renderer::ggx_visible(VIEW, ALPHA, u)),
        apart(&bilinear, |u| renderer::bilinear(WEIGHTS, u)),
        apart(&mw::DiskConcentric::new(), renderer::concentric_disk),
        apart(&mw::MalleyHemisphere::new(), renderer::cosine_hemisphere),
    ];
    for (map, (densities, means)) in pairs.into_iter().enumerate() {
        assert!(
            densities <= 2e-3,
            "map {map}: densities {densities:e} apart"
        );
        assert!(means <= 2e-3, "map {map}: means {means:e} apart");
    }
    Ok(())
}

/// How far maps of the line and their densities are apart.
pub fn apart_on_the_line(
    ours: &impl Warp<Uniforms = f32, Point = f32, Density = f32>,
    theirs: impl Fn([f32; 1]) -> Weighed<f32>,
) -> f32 {
    (1..256_u16).fold(0.0, |most, i| {
        let u = f32::from(i) / 256.0;
        let ((x, p), (y, q)) = (ours.sample_with_pdf(u), theirs([u]));
        let difference = (x - y).abs().max((p - q).abs());
        if difference <= most { most } else { difference }
    })
}

#[test]
fn laws_of_the_line_are_the_maps_of_ours() -> Result<(), microwarp::Error> {
    let exponential = mw::Exponential::from_rate(1.5)?;
    let logistic = mw::Logistic::new(0.0, 1.5)?;
    let normal = mw::Normal::new(0.5, 1.5)?;
    assert!(apart_on_the_line(&exponential, |u| renderer::exponential(1.5, u)) <= 1e-5);
    // The peer's 1/u - 1 loses digits near 1.
    assert!(apart_on_the_line(&logistic, |u| renderer::logistic(1.5, u)) <= 1e-4);
    assert!(apart_on_the_line(&normal, |u| renderer::normal(0.5, 1.5, u)) <= 1e-5);
    assert!(apart_on_the_line(&normal, |u| renderer::normal(0.5, 1.6, u)) > 1e-2);
    Ok(())
}

#[test]
fn another_distribution_does_not_pass() -> Result<(), microwarp::Error> {
    let cone = mw::Cone::from_one_minus_cos(0.25)?;
    let (densities, means) = apart(&cone, |u| renderer::cone(0.7, u));
    assert!(densities.is_nan() || densities > 0.1, "{densities}");
    assert!(means > 0.01, "{means}");
    let (densities, _) = apart(&cone, |u| (renderer::cone(0.75, u).0, f32::NAN));
    assert!(densities.is_nan());
    Ok(())
}
