//! A hall of a thousand lamps: how many shadow rays a reservoir of candidates saves at equal error.

use host::docs::Doc;
use host::speed;
use microwarp::discrete::{Cdf, LightReservoir};
use microwarp::uniform::{grid, up_to};
use microwarp_scene::vector::{Vector, dot, length, minus, scaled};
use microwarp_scene::{Ray, Shape, Sphere};
use rand_pcg::Pcg32;

const LAMPS: usize = 1000;
/// The edge of the hall, in metres.
const EDGE: f32 = 40.0;

struct Hall {
    lamps: Vec<(Vector, f32)>,
    balls: Vec<Sphere>,
    by_power: Cdf<Vec<u32>>,
}

impl Hall {
    /// Lamps 1 to 4 metres up, of powers over two decades, above balls on the floor.
    fn new() -> Self {
        let mut rng = Pcg32::new(34, 1);
        let mut within = |low: f32, high: f32| low + (high - low) * grid(&mut rng);
        let lamps: Vec<_> = (0..LAMPS)
            .map(|_| {
                let place = [within(0.0, EDGE), within(0.0, EDGE), within(1.0, 4.0)];
                (place, 10_f32.powf(within(0.0, 2.0)))
            })
            .collect();
        let balls = (0..120).map(|_| {
            let radius = within(0.25, 0.6);
            Sphere {
                centre: [within(0.0, EDGE), within(0.0, EDGE), radius],
                radius,
            }
        });
        let balls = balls.collect();
        let powers: Vec<f32> = lamps.iter().map(|(_, power)| *power).collect();
        let by_power = Cdf::<Vec<u32>>::from_slice(&powers).unwrap();
        Self {
            lamps,
            balls,
            by_power,
        }
    }

    /// What a lamp sends to a place on the floor if nothing is between.
    fn unshadowed(&self, from: Vector, lamp: usize) -> f32 {
        let (place, power) = self.lamps[lamp];
        let to = minus(place, from);
        let square = dot(to, to);
        power * to[2] / (square * square.sqrt())
    }

    fn sees(&self, from: Vector, lamp: usize) -> bool {
        let to = minus(self.lamps[lamp].0, from);
        let way = length(to);
        let ray = Ray {
            origin: from,
            direction: scaled(to, 1.0 / way),
        };
        self.balls.iter().all(|ball| ball.hit(ray, way).is_none())
    }

    /// Places on a grid of the floor that no ball covers.
    fn places(&self, side: u32) -> Vec<Vector> {
        let at = |i: u32| EDGE * (i as f32 + 0.5) / side as f32;
        let places = (0..side * side).map(|i| [at(i % side), at(i / side), 0.0]);
        let free = |place: &Vector| {
            let clear = |ball: &Sphere| length(minus(ball.centre, *place)) > ball.radius + 0.01;
            self.balls.iter().all(clear)
        };
        places.filter(free).collect()
    }
}

/// The mean over places of the relative variance of one shadow ray, and by how many standard errors the mean is off 1.
struct Found {
    variance: f64,
    off: f64,
}

impl Found {
    /// From the estimates of each place, over the truth there.
    fn of(places: &[Vec<f64>]) -> Self {
        let (mut variance, mut off, mut square) = (0.0, 0.0, 0.0);
        for estimates in places {
            let n = estimates.len() as f64;
            let mean = estimates.iter().sum::<f64>() / n;
            let own = estimates.iter().map(|e| (e - mean).powi(2)).sum::<f64>() / (n - 1.0);
            variance += own / places.len() as f64;
            off += mean - 1.0;
            square += own / n;
        }
        let off = off / square.sqrt();
        Self { variance, off }
    }
}

#[test]
fn a_reservoir_saves_most_shadow_rays_of_a_thousand_lamps() {
    let hall = Hall::new();
    let places = hall.places(speed::of("places of the hall, a side", 12, 24));
    let runs = speed::of("shadow rays a place", 300, 2_000);
    // What each lamp sends to each place, and the sum.
    let lit: Vec<(Vector, Vec<f64>, f64)> = places
        .iter()
        .map(|&place| {
            let light = |lamp| match hall.sees(place, lamp) {
                true => f64::from(hall.unshadowed(place, lamp)),
                false => 0.0,
            };
            let light: Vec<f64> = (0..LAMPS).map(light).collect();
            let sum = light.iter().sum();
            (place, light, sum)
        })
        .collect();
    let dark = lit.iter().flat_map(|(_, light, _)| light);
    let dark = dark.filter(|light| **light == 0.0).count() as f64;
    let pairs = (places.len() * LAMPS) as f64;
    // The mean over places of Σ f²/p over the square of the sum, less 1: exact.
    let exact = |p: &dyn Fn(usize) -> f64| {
        let each = lit.iter().map(|(_, light, sum)| {
            let square = |(lamp, f): (usize, &f64)| f * f / p(lamp);
            light.iter().enumerate().map(square).sum::<f64>() / (sum * sum) - 1.0
        });
        each.sum::<f64>() / places.len() as f64
    };
    let uniform = exact(&|_| 1.0 / LAMPS as f64);
    let by_power = exact(&|lamp| f64::from(hall.by_power.pmf(lamp)));
    // One shadow ray by so many candidates, from the powers or not, divided by `counted` of them.
    let resampled = |candidates: u32, from_power: bool, counted: u32| {
        let mut rng = Pcg32::new(u64::from(candidates), 7);
        let each = lit.iter().map(|(place, light, sum)| {
            let estimate = |_| {
                let mut held = LightReservoir::new();
                for _ in 0..candidates {
                    let (lamp, density) = if from_power {
                        let drawn = hall.by_power.draw(&mut rng);
                        (drawn.index, drawn.pmf)
                    } else {
                        (
                            up_to(LAMPS as u32 - 1, &mut rng) as usize,
                            1.0 / LAMPS as f32,
                        )
                    };
                    let target = hall.unshadowed(*place, lamp);
                    held.offer(lamp, target, density, &mut rng).unwrap();
                }
                held.normalise(counted);
                let light = held.item().map_or(0.0, |&lamp| light[lamp]);
                light * f64::from(held.contribution()) / sum
            };
            (0..runs).map(estimate).collect()
        });
        Found::of(&each.collect::<Vec<_>>())
    };
    println!(
        "{} places, {:.0} % of pairs in shadow; relative variance of a ray {uniform:.1} uniformly, {by_power:.1} by power",
        places.len(),
        100.0 * dark / pairs
    );
    let gain = |candidates, from_power| {
        let found = resampled(candidates, from_power, candidates);
        let gain = uniform / found.variance;
        println!(
            "{candidates} candidates, by power {from_power}: {gain:.1} times fewer rays; {:+.1} σ",
            found.off
        );
        assert!(found.off.abs() <= 6.0, "{candidates}: {}", found.off);
        gain
    };
    let stated = Doc::of("discrete", "LightReservoir").figure_after("drawn by power, stands for");
    let gains = [gain(8, true), gain(8, false), gain(4, true)];
    assert!(gains[0] >= stated && stated >= 15.0, "{gains:?}");
    assert!(gains[0] <= 1.5 * stated, "{gains:?}: {stated} is stale");
    // Neither fewer candidates nor the powers alone do that.
    assert!(gains[1] < 15.0 && gains[2] < 15.0 && uniform / by_power < 15.0);
    // The mean of a wrong count is far off.
    assert!(resampled(8, true, 7).off.abs() > 6.0);
}
