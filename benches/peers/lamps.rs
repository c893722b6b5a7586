//! Contests of what renderers sample, each with its density: ours beside the published maps.

use crate::args::{FLOOR, LIBM, POLY, PUBLISHED};
use crate::draws::word;
use host::contest::Contest;
use host::peers::drawn;
use host::peers::renderer::{self, Vector, Weighed};
use microwarp::Warp;
use microwarp::tier::{Libm, Poly, Tier};
use microwarp::warp::{
    Bilinear, Cone, DiskConcentric, Exponential, GgxVisible, HenyeyGreenstein, Logistic,
    MalleyHemisphere, Normal, SphericalRectangle, SphericalTriangle, VisibleSphere,
};
use rand_pcg::Pcg32;
use std::hint::black_box;

/// A contest of points and their densities, with the generator alone.
pub fn contest<const N: usize>() -> Contest<Weighed<[f32; N]>> {
    Contest::new(([0.0; N], 0.0)).draw(FLOOR, |rng| {
        let mut point = [0.0; N];
        if let [x, y, ..] = point.as_mut_slice() {
            *x = word(rng);
            *y = word(rng);
        }
        (point, 0.0)
    })
}

pub fn on_the_line() -> Contest<Weighed<f32>> {
    Contest::new((0.0, 0.0)).draw(FLOOR, |rng| (word(rng), 0.0))
}

/// Kept warps, made once.
pub fn kept<L, W, P: Copy + 'static>(
    contest: Contest<Weighed<P>>,
    libm: L,
    poly: W,
    peer: impl Fn(&mut Pcg32) -> Weighed<P> + 'static,
) -> Contest<Weighed<P>>
where
    L: Warp<Point = P, Density = f32> + 'static,
    W: Warp<Point = P, Density = f32> + 'static,
{
    let (libm, poly) = (black_box(libm), black_box(poly));
    contest
        .draw(LIBM, move |rng| libm.draw_with_pdf(rng))
        .draw(POLY, move |rng| poly.draw_with_pdf(rng))
        .draw(PUBLISHED, peer)
}

/// A uniform of 23 bits, without a conversion: on x86-64 one waits for what its register held, so that whether a draw waits for the
/// one before would hang on the compiler's choice of registers.
#[inline]
fn uniform(rng: &mut Pcg32) -> f32 {
    f32::from_bits(1.0_f32.to_bits() | (word(rng).to_bits() >> 9)) - 1.0
}

/// A point beside the middle of the scene, another for every draw.
fn seen_from(rng: &mut Pcg32) -> Vector {
    [0.5 * uniform(rng), 0.5 * uniform(rng), 0.0]
}

const CENTRE: Vector = [0.3, -0.2, 3.0];
const TRIANGLE: [Vector; 3] = [[-1.0, -1.0, 3.0], [1.2, -0.8, 2.8], [0.1, 1.0, 3.3]];
const CORNER: Vector = [-1.0, -1.0, 3.0];
const EDGES: [Vector; 2] = [[2.0, 0.0, 0.0], [0.0, 2.0, 0.0]];

/// What is made anew at every draw takes a point and two uniforms; none of it may be known beforehand.
pub fn anew<S: Copy + 'static>(
    shape: S,
    libm: impl Fn(Vector, S, [f32; 2]) -> Weighed<Vector> + 'static,
    poly: impl Fn(Vector, S, [f32; 2]) -> Weighed<Vector> + 'static,
    peer: impl Fn(Vector, S, [f32; 2]) -> Weighed<Vector> + 'static,
) -> Contest<Weighed<Vector>> {
    fn drawn<S: Copy>(
        shape: S,
        sample: impl Fn(Vector, S, [f32; 2]) -> Weighed<Vector>,
    ) -> impl Fn(&mut Pcg32) -> Weighed<Vector> {
        let shape = black_box(shape);
        move |rng| {
            let point = seen_from(rng);
            sample(point, shape, [uniform(rng), uniform(rng)])
        }
    }
    Contest::new(([0.0; 3], 0.0))
        .draw(FLOOR, |rng| {
            let point = seen_from(rng);
            (point, uniform(rng) + uniform(rng))
        })
        .draw(LIBM, drawn(shape, libm))
        .draw(POLY, drawn(shape, poly))
        .draw(PUBLISHED, drawn(shape, peer))
}

pub fn sphere() -> Contest<Weighed<Vector>> {
    fn ours<T: Tier>(point: Vector, radius: f32, u: [f32; 2]) -> Weighed<Vector> {
        let lamp = VisibleSphere::<T>::new(point, CENTRE, radius);
        lamp.map_or_else(|_| Default::default(), |lamp| lamp.sample_with_pdf(u))
    }
    let peer = |point, radius, u| renderer::sphere_lamp(point, CENTRE, radius, u);
    anew(1.0, ours::<Libm>, ours::<Poly>, peer)
}

pub fn triangle() -> Contest<Weighed<Vector>> {
    fn ours<T: Tier>(point: Vector, vertices: [Vector; 3], u: [f32; 2]) -> Weighed<Vector> {
        let lamp = SphericalTriangle::<T>::new(point, vertices);
        lamp.map_or_else(|_| Default::default(), |lamp| lamp.sample_with_pdf(u))
    }
    anew(
        TRIANGLE,
        ours::<Libm>,
        ours::<Poly>,
        renderer::triangle_lamp,
    )
}

pub fn rectangle() -> Contest<Weighed<Vector>> {
    fn ours<T: Tier>(
        point: Vector,
        (corner, edges): Parallelogram,
        u: [f32; 2],
    ) -> Weighed<Vector> {
        let lamp = SphericalRectangle::<T>::new(point, corner, edges);
        lamp.map_or_else(|_| Default::default(), |lamp| lamp.sample_with_pdf(u))
    }
    let peer = |point, (corner, edges), u| renderer::rectangle_lamp(point, corner, edges, u);
    anew((CORNER, EDGES), ours::<Libm>, ours::<Poly>, peer)
}

type Parallelogram = (Vector, [Vector; 2]);

/// The density alone, for a direction that another technique has found; the peer's comes with its sample.
pub fn rectangle_density() -> Contest<Weighed<Vector>> {
    fn ours<T: Tier>(
        point: Vector,
        (corner, edges): Parallelogram,
        _: [f32; 2],
    ) -> Weighed<Vector> {
        let density = SphericalRectangle::<T>::density_of(point, corner, edges);
        (point, density.unwrap_or(0.0))
    }
    let peer = |point, (corner, edges), u| renderer::rectangle_lamp(point, corner, edges, u);
    anew((CORNER, EDGES), ours::<Libm>, ours::<Poly>, peer)
}

/// Likewise.
pub fn triangle_density() -> Contest<Weighed<Vector>> {
    fn ours<T: Tier>(point: Vector, vertices: [Vector; 3], _: [f32; 2]) -> Weighed<Vector> {
        let density = SphericalTriangle::<T>::density_of(point, vertices);
        (point, density.unwrap_or(0.0))
    }
    anew(
        TRIANGLE,
        ours::<Libm>,
        ours::<Poly>,
        renderer::triangle_lamp,
    )
}

/// A view of a surface.
pub fn view([x, y, _]: Vector) -> Vector {
    [x, y, (1.0 - x * x - y * y).sqrt()]
}

/// Normals that another view meets at every draw.
pub fn ggx() -> Contest<Weighed<Vector>> {
    fn ours<T: Tier>(point: Vector, alpha: [f32; 2], u: [f32; 2]) -> Weighed<Vector> {
        let normals = GgxVisible::<T>::new(view(point), alpha);
        normals.map_or_else(|_| Default::default(), |normals| normals.sample_with_pdf(u))
    }
    let peer = |point, alpha, u| renderer::ggx_visible(view(point), alpha, u);
    anew([0.3, 0.2], ours::<Libm>, ours::<Poly>, peer)
}

pub fn cone() -> Contest<Weighed<Vector>> {
    const COS: f32 = 0.75;
    fn ours<T: Tier>() -> Cone<T> {
        Cone::from_one_minus_cos(1.0 - COS).unwrap()
    }
    let cos = black_box(COS);
    let peer = drawn(move |u| renderer::cone(cos, u));
    kept(contest(), ours::<Libm>(), ours::<Poly>(), peer)
}

pub fn henyey_greenstein() -> Contest<Weighed<Vector>> {
    const G: f32 = 0.8;
    fn ours<T: Tier>() -> HenyeyGreenstein<T> {
        HenyeyGreenstein::new(G).unwrap()
    }
    let g = black_box(G);
    let peer = drawn(move |u| renderer::henyey_greenstein(g, u));
    kept(contest(), ours::<Libm>(), ours::<Poly>(), peer)
}

/// It has no tier.
pub fn bilinear() -> Contest<Weighed<[f32; 2]>> {
    const WEIGHTS: [[f32; 2]; 2] = [[1.0, 2.0], [0.5, 3.0]];
    let ours = black_box(Bilinear::new(WEIGHTS).unwrap());
    let weights = black_box(WEIGHTS);
    contest()
        .draw(POLY, move |rng| ours.draw_with_pdf(rng))
        .draw(PUBLISHED, drawn(move |u| renderer::bilinear(weights, u)))
}

pub fn concentric_disk() -> Contest<Weighed<[f32; 2]>> {
    let (libm, poly) = (DiskConcentric::<Libm>::new(), DiskConcentric::<Poly>::new());
    kept(contest(), libm, poly, drawn(renderer::concentric_disk))
}

pub fn cosine_hemisphere() -> Contest<Weighed<Vector>> {
    let (libm, poly) = (
        MalleyHemisphere::<Libm>::new(),
        MalleyHemisphere::<Poly>::new(),
    );
    kept(contest(), libm, poly, drawn(renderer::cosine_hemisphere))
}

pub fn exponential() -> Contest<Weighed<f32>> {
    fn ours<T: Tier>() -> Exponential<T> {
        Exponential::from_rate(1.5).unwrap()
    }
    let rate = black_box(1.5);
    let peer = drawn(move |u| renderer::exponential(rate, u));
    kept(on_the_line(), ours::<Libm>(), ours::<Poly>(), peer)
}

pub fn logistic() -> Contest<Weighed<f32>> {
    fn ours<T: Tier>() -> Logistic<T> {
        Logistic::new(0.0, 1.5).unwrap()
    }
    let scale = black_box(1.5);
    let peer = drawn(move |u| renderer::logistic(scale, u));
    kept(on_the_line(), ours::<Libm>(), ours::<Poly>(), peer)
}

pub fn normal() -> Contest<Weighed<f32>> {
    fn ours<T: Tier>() -> Normal<T> {
        Normal::new(0.5, 1.5).unwrap()
    }
    let (mean, deviation) = black_box((0.5, 1.5));
    let peer = drawn(move |u| renderer::normal(mean, deviation, u));
    kept(on_the_line(), ours::<Libm>(), ours::<Poly>(), peer)
}
