//! Contests of the rest of a renderer's kit: reflections, tables, a pixel filter, weights, choices, and the order of one set of
//! points over a picture.

use crate::args::{FLOOR, POLY, PUBLISHED};
use crate::draws::word;
use crate::lamps::{anew, contest, kept, on_the_line, view};
use host::contest::Contest;
use host::peers::kit::{self, Curve, Mitchell, Piecewise, PiecewiseRows, WeightedReservoir};
use host::peers::renderer::{Vector, Weighed};
use host::peers::{drawn, uniform};
use microwarp::Warp;
use microwarp::discrete::{
    LightReservoir, Mixture, PiecewiseConstant1d, PiecewiseConstant2d, SignedLinear1d, filter,
};
use microwarp::estimate::{balance_heuristic, power_heuristic};
use microwarp::tier::{Libm, Poly, Tier};
use microwarp::uniform::{Screen, Sobol};
use microwarp::warp::{Cone, Ggx, GgxVisible, MalleyHemisphere, Tent};
use rand_pcg::Pcg32;
use rand_pcg::rand_core::Rng;
use std::hint::black_box;

const ALPHA: [f32; 2] = [0.3, 0.2];

/// A view, and the direction into which a microfacet reflects it, another for every draw.
pub fn reflection() -> Contest<Weighed<Vector>> {
    fn ours<T: Tier>(point: Vector, alpha: [f32; 2], u: [f32; 2]) -> Weighed<Vector> {
        GgxVisible::<T>::new(view(point), alpha).map_or_else(
            |_| Default::default(),
            |normals| {
                let bounce = normals.reflect(u);
                (bounce.direction, bounce.pdf)
            },
        )
    }
    let peer = |point, alpha, u| kit::ggx_reflection(view(point), alpha, u);
    anew(ALPHA, ours::<Libm>, ours::<Poly>, peer)
}

/// What a view sees of the microfacets.
pub fn masking() -> Contest<Weighed<Vector>> {
    fn ours<T: Tier>(point: Vector, alpha: [f32; 2], _: [f32; 2]) -> Weighed<Vector> {
        let surface = Ggx::<T>::new(alpha);
        (
            point,
            surface.map_or(0.0, |surface| surface.g1(view(point))),
        )
    }
    let peer = |point, alpha, _| (point, kit::ggx_g1(view(point), alpha));
    anew(ALPHA, ours::<Libm>, ours::<Poly>, peer)
}

/// A table of N weights.
fn weights<const N: usize>(row: u32) -> [f32; N] {
    let mut rng = Pcg32::new(3, row.into());
    [(); N].map(|()| 0.1 + uniform(&mut rng))
}

pub fn piecewise() -> Contest<Weighed<f32>> {
    let weights = weights::<64>(0);
    let ours = black_box(PiecewiseConstant1d::<[u32; 64]>::new(&weights, 0.0, 2.0).unwrap());
    let peer = black_box(Piecewise::new(&weights, [0.0, 2.0]));
    on_the_line()
        .draw(POLY, move |rng| ours.draw_with_pdf(rng))
        .draw(
            PUBLISHED,
            drawn(move |[u]: [f32; 1]| {
                let (point, density, _) = peer.sample(u);
                (point, density)
            }),
        )
}

pub fn piecewise_of_rows() -> Contest<Weighed<[f32; 2]>> {
    type Table = PiecewiseConstant2d<[u32; 32], [[u32; 64]; 32]>;
    let rows: [[f32; 64]; 32] = std::array::from_fn(|row| weights(row as u32));
    let ranges = [[0.0, 2.0], [0.0, 1.0]];
    let ours = black_box(Table::new(&rows, ranges[0], ranges[1]).unwrap());
    let peer = PiecewiseRows::new(rows.iter().map(|row| row.as_slice()), ranges);
    let peer = black_box(peer);
    contest()
        .draw(POLY, move |rng| ours.draw_with_pdf(rng))
        .draw(PUBLISHED, drawn(move |u| peer.sample(u)))
}

/// Ours takes a table for each axis; the weights stand in the place of a density.
pub fn mitchell() -> Contest<Weighed<[f32; 2]>> {
    const THIRD: f32 = 1.0 / 3.0;
    let vertices = filter::mitchell::<65>(THIRD, THIRD);
    let ours = black_box(SignedLinear1d::new(&vertices, -2.0, 2.0).unwrap());
    let peer = black_box(Mitchell::new(2, THIRD, THIRD));
    contest()
        .draw(POLY, move |rng| {
            let [(x, across), (y, down)] = [ours.draw(rng), ours.draw(rng)];
            ([x, y], across * down)
        })
        .draw(PUBLISHED, drawn(move |u| peer.sample(u)))
}

pub fn tent() -> Contest<Weighed<f32>> {
    let ours = black_box(Tent::new(1.5).unwrap());
    let radius = black_box(1.5);
    on_the_line()
        .draw(POLY, move |rng| ours.draw_with_pdf(rng))
        .draw(PUBLISHED, drawn(move |u| kit::tent(radius, u)))
}

/// The weight of a sample by two densities.
fn of_densities(
    ours: impl Fn(f32, f32) -> f32 + 'static,
    peer: impl Fn(f32, f32) -> f32 + 'static,
) -> Contest<f32> {
    Contest::new(0.0)
        .draw(FLOOR, |rng| word(rng) + word(rng))
        .draw(POLY, drawn(move |[own, other]| ours(own, other)))
        .draw(PUBLISHED, drawn(move |[own, other]| peer(own, other)))
}

pub fn balance() -> Contest<f32> {
    of_densities(
        |own, other| balance_heuristic(1, own, 1, other),
        kit::balance_heuristic,
    )
}

pub fn power() -> Contest<f32> {
    of_densities(
        |own, other| power_heuristic(1, own, 1, other),
        kit::power_heuristic,
    )
}

/// Lights that are offered for each that is chosen.
const OFFERS: u8 = 16;

/// A light of several by its target, and how often it stands for the others; each offer counts. Ours takes two words for a
/// decision, and the density by which a light was drawn.
pub fn reservoir() -> Contest<Weighed<u32>> {
    let density = black_box(1.0 / f32::from(OFFERS));
    Contest::new((0, 0.0))
        .draw(FLOOR, |rng| {
            let sum = (0..OFFERS).map(|_| word(rng) + word(rng)).sum();
            (0, sum)
        })
        .draw(POLY, move |rng| {
            let mut held = LightReservoir::new();
            for light in 0..OFFERS {
                let target = uniform(rng);
                let _ = held.offer(u32::from(light), target, density, rng);
            }
            (held.item().map_or(0, |light| *light), held.contribution())
        })
        .draw(PUBLISHED, move |rng| {
            let mut held = WeightedReservoir::default();
            for light in 0..OFFERS {
                let target = uniform(rng);
                held.add(u32::from(light), target / density, uniform(rng));
            }
            held.held()
        })
        .counting(OFFERS.into())
}

/// A lobe by the cosine and one over a cone, with the density of both.
pub fn mixture() -> Contest<Weighed<Vector>> {
    const COS: f32 = 0.75;
    fn ours<T: Tier>() -> Mixture<(MalleyHemisphere<T>, Cone<T>), 2> {
        let cone = Cone::from_one_minus_cos(1.0 - COS).unwrap();
        Mixture::new((MalleyHemisphere::new(), cone), &[1.0, 2.0]).unwrap()
    }
    let (share, cos) = black_box((1.0 / 3.0, COS));
    let peer = drawn(move |u| kit::two_lobes(share, cos, u));
    kept(contest(), ours::<Libm>(), ours::<Poly>(), peer)
}

/// The index of a sample of any pixel of a picture of 1920 × 1080, of 16 each.
pub fn screen() -> Contest<u32> {
    const SIZE: [u32; 2] = [1920, 1080];
    fn pixel(word: u32) -> ([u32; 2], u32) {
        ([word >> 21, word >> 10 & 0x3ff], word & 15)
    }
    let points = Sobol::<2>::new(7).unwrap();
    let ours = black_box(Screen::new(points, SIZE, 4, 7).unwrap());
    let (peer, dimension) = black_box((Curve::new(SIZE, 4), 2));
    Contest::new(0)
        .draw(FLOOR, |rng| rng.next_u32())
        .draw(POLY, move |rng| {
            let ([x, y], sample) = pixel(rng.next_u32());
            ours.pixel(x, y).index(sample)
        })
        .draw(PUBLISHED, move |rng| {
            let (at, sample) = pixel(rng.next_u32());
            peer.index(at, sample, dimension) as u32
        })
}
