//! What all lamps give direct lighting: the distance is that of the place, and belongs to the direction.

use host::speed;
use host::truth::dot;
use microwarp::tier::{Libm, Poly, Tier};
use microwarp::uniform::{self, grid};
use microwarp::warp::{LightSample, SphericalRectangle, SphericalTriangle, VisibleSphere};
use rand_core::Rng;
use rand_pcg::Pcg32;

/// The errors that the documentation states, of the reach: of the distance, and of direction times distance.
const STATED: [f64; 2] = [4e-7, 4.8e-7];

type Wide = [f64; 3];

/// A point, a corner and two edges: of any size, often close to the plane or to the lamp, now and then thin.
struct Quad {
    point: [f32; 3],
    corner: [f32; 3],
    edges: [[f32; 3]; 2],
}

fn quad(rng: &mut Pcg32) -> Quad {
    let size = (60.0 * grid(rng) - 30.0).exp2();
    let mut vector =
        |length: f32| -> [f32; 3] { std::array::from_fn(|_| length * (2.0 * grid(rng) - 1.0)) };
    let [first, second, away, point] = [1.0, 1.0, 3.0, 2.0].map(|length| vector(length * size));
    let narrow = [1.0, 1.0, 1e-3][rng.next_u32() as usize % 3];
    let second = second.map(|x| narrow * x);
    // The way to the corner: anywhere, or in the plane but for a small part.
    let height = (-14.0 * grid(rng)).exp2();
    let (a, b) = (4.0 * grid(rng) - 2.0, 4.0 * grid(rng) - 2.0);
    let corner = std::array::from_fn(|k| {
        let way = match rng.next_u32() % 2 {
            0 => away[k],
            _ => a * first[k] + b * second[k] + height * away[k],
        };
        point[k] + way
    });
    Quad {
        point,
        corner,
        edges: [first, second],
    }
}

fn length(v: Wide) -> f64 {
    dot(v, v).sqrt()
}

/// The errors of a distance, and of a direction times that, where the place is known, of the reach.
fn errors(quad: &Quad, seen: &LightSample, distance: f64) -> [f64; 2] {
    let [s, t] = seen.place.map(f64::from);
    let [first, second] = quad.edges.map(|edge| edge.map(f64::from));
    let way: Wide = std::array::from_fn(|k| f64::from(quad.corner[k]) - f64::from(quad.point[k]));
    let place: Wide = std::array::from_fn(|k| way[k] + s * first[k] + t * second[k]);
    let reach = length(way) + length(first) + length(second);
    let off = std::array::from_fn(|k| f64::from(seen.direction[k]) * distance - place[k]);
    [(distance - length(place)).abs(), length(off)].map(|error| error / reach)
}

/// The distance that the plane gives for the direction, in f32.
fn by_the_plane(quad: &Quad, direction: [f32; 3]) -> f32 {
    let [[a, b, c], [d, e, f]] = quad.edges;
    let normal = [b * f - c * e, c * d - a * f, a * e - b * d];
    let along = |v: [f32; 3]| normal[0] * v[0] + normal[1] * v[1] + normal[2] * v[2];
    let way = std::array::from_fn(|k| quad.corner[k] - quad.point[k]);
    along(way) / along(direction)
}

fn measured<T: Tier>() {
    let n = speed::of("places on lamps", 60_000, 6_000_000);
    let mut rng = Pcg32::new(34, 2);
    let mut worst = [[0.0_f64; 2]; 2];
    let mut of_plane = 0.0_f64;
    for _ in 0..n {
        let quad = quad(&mut rng);
        let u = [grid(&mut rng), grid(&mut rng)];
        let vertices = {
            let [a, b] = quad
                .edges
                .map(|edge| std::array::from_fn(|k| quad.corner[k] + edge[k]));
            [quad.corner, a, b]
        };
        // The edges of a triangle are differences of its vertices, which are rounded.
        let exact = Quad {
            edges: [1, 2].map(|i: usize| std::array::from_fn(|k| vertices[i][k] - vertices[0][k])),
            ..quad
        };
        let lamps = [
            SphericalRectangle::<T>::new(quad.point, quad.corner, quad.edges).map(|lamp| {
                let there = lamp.locate(u);
                let seen = lamp.sample_light(u);
                assert_eq!(
                    (seen.direction, seen.pdf, seen.place),
                    (there.direction, there.pdf, there.st)
                );
                seen
            }),
            SphericalTriangle::<T>::new(quad.point, vertices).map(|lamp| {
                let (there, seen) = (lamp.locate(u), lamp.sample_light(u));
                let [_, second, third] = there.barycentric;
                assert_eq!(
                    (seen.direction, seen.pdf, seen.place),
                    (there.direction, there.pdf, [second, third])
                );
                seen
            }),
        ];
        for ((seen, quad), worst) in lamps.into_iter().zip([&quad, &exact]).zip(&mut worst) {
            let Ok(seen) = seen else { continue };
            assert!(seen.distance > 0.0 && seen.distance <= f32::MAX, "{seen:?}");
            let found = errors(quad, &seen, seen.distance.into());
            for ((worst, error), stated) in worst.iter_mut().zip(found).zip(STATED) {
                assert!(
                    error <= stated,
                    "{error:e}: {:?} {:?} {:?} {seen:?}",
                    quad.point,
                    quad.corner,
                    quad.edges
                );
                *worst = worst.max(error);
            }
            let plane = by_the_plane(quad, seen.direction);
            if plane.is_finite() {
                of_plane = of_plane.max(errors(quad, &seen, plane.into())[0]);
            }
        }
    }
    for ([distance, place], lamp) in worst.into_iter().zip(["rectangle", "triangle"]) {
        let tier = T::NAME;
        println!("{lamp} {tier}: {distance:.2e} and {place:.2e}; by the plane {of_plane:.1e}");
        assert!(distance >= STATED[0] / 2.5 && place >= STATED[1] / 2.5);
    }
    assert!(
        of_plane > 1e3 * STATED[0],
        "the control passes: {of_plane:e}"
    );
}

#[test]
fn the_distance_of_a_lamp_is_that_of_the_place_even_from_its_edge() {
    measured::<Libm>();
    measured::<Poly>();
}

#[test]
fn a_sphere_gives_the_same_as_a_lamp() {
    let mut rng = Pcg32::new(5, 34);
    for _ in 0..1_000 {
        let centre = std::array::from_fn(|_| 8.0 * uniform::grid(&mut rng) - 4.0);
        let lamp = VisibleSphere::<Poly>::new([0.0; 3], centre, 0.1 + grid(&mut rng)).unwrap();
        let u = [grid(&mut rng), grid(&mut rng)];
        let (seen, there) = (lamp.sample_light(u), lamp.sample_surface(u));
        assert_eq!(
            (seen.direction, seen.distance, seen.pdf),
            (there.direction, there.distance, there.pdf)
        );
        assert_eq!(seen.place, [0.0; 2]);
        // The place is on the sphere.
        let place: Wide =
            std::array::from_fn(|k| f64::from(seen.direction[k]) * f64::from(seen.distance));
        let from_centre: Wide = std::array::from_fn(|k| place[k] - f64::from(centre[k]));
        let radius = f64::from(lamp.radius());
        assert!((length(from_centre) - radius).abs() <= 4e-6 * (length(place) + radius));
    }
}
