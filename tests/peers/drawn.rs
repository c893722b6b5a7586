//! The peers of the benches draw what they are said to draw, so that times and errors compare like with like.
//!
//! How accurate they are is not promised here: `benches/tradeoff.rs` measures it.

use host::peers::{drawn, micro, rejecting, textbook};
use host::registry::{Registered, evidence::Peer, of_poly};
use rand_pcg::Pcg32;
use std::f64::consts::TAU;

/// The exponent of the lobe.
const N: f64 = 50.0;
const POWER: f32 = 1.0 / 51.0;

/// Uniforms in the middle of the cells of a grid of 64 in each direction.
fn grid<const D: usize>() -> impl Iterator<Item = [f32; D]> {
    (0..64_usize.pow(D as u32)).map(|mut cell| {
        [(); D].map(|()| {
            let place = cell % 64;
            cell /= 64;
            (place as f32 + 0.5) / 64.0
        })
    })
}

/// The larger of two errors; what is not a number is larger than any, and stays.
fn larger(most: f64, error: f64) -> f64 {
    if most.is_nan() || error <= most {
        most
    } else {
        error
    }
}

/// The largest error of any coordinate of a map.
fn largest_error<const D: usize, const E: usize>(
    map: impl Fn([f32; D]) -> [f32; E],
    truth: impl Fn([f64; D]) -> [f64; E],
) -> f64 {
    let errors = grid().flat_map(|u| {
        let (mapped, exact) = (map(u), truth(u.map(f64::from)));
        std::array::from_fn::<f64, E, _>(|i| (f64::from(mapped[i]) - exact[i]).abs())
    });
    errors.fold(0.0, larger)
}

fn at_height(z: f64, turn: f64) -> [f64; 3] {
    let sine = z.acos().sin();
    [sine * (TAU * turn).cos(), sine * (TAU * turn).sin(), z]
}

fn polar(r: f64, turn: f64) -> [f64; 2] {
    [r * (TAU * turn).cos(), r * (TAU * turn).sin()]
}

fn exact_ball([u1, u2, u3]: [f64; 3]) -> [f64; 3] {
    at_height(1.0 - 2.0 * u1, u2).map(|x| u3.powf(1.0 / 3.0) * x)
}

/// Both families of formulas within an error.
macro_rules! maps_agree {
    ($peer:ident, $most:expr) => {
        let errors = [
            largest_error($peer::disk, |[u, v]| polar(u.sqrt(), v)),
            largest_error($peer::circle, |[u]| polar(1.0, u)),
            largest_error($peer::sphere, |[u, v]| at_height(1.0 - 2.0 * u, v)),
            largest_error($peer::hemisphere, |[u, v]| at_height(u, v)),
            largest_error($peer::cosine_hemisphere, |[u, v]| {
                at_height((1.0 - u).sqrt(), v)
            }),
            largest_error(
                |u| $peer::lobe(POWER, u),
                |[u, v]| at_height(u.powf(1.0 / (N + 1.0)), v),
            ),
            largest_error(|u| [$peer::exponential(u)], |[u]| [-(-u).ln_1p()]),
            largest_error($peer::normal_pair, |[u, v]| {
                polar((-2.0 * (-u).ln_1p()).sqrt(), v)
            }),
        ];
        for (family, error) in errors.into_iter().enumerate() {
            assert!(error <= $most, "family {family}: {error}");
        }
    };
}

#[test]
fn the_formulas_over_libm_are_the_maps_they_are_said_to_be() {
    maps_agree!(textbook, 2e-6);
    assert!(largest_error(textbook::ball, exact_ball) <= 2e-6);
    let halved = largest_error(
        |u| [textbook::exponential_of_rate(2.0, u)],
        |[u]| [-0.5 * (-u).ln_1p()],
    );
    assert!(halved <= 1e-6, "{halved}");
}

#[test]
fn the_formulas_over_micromath_are_those_maps_roughly() {
    // Its logarithm is off by as much as 0.12.
    maps_agree!(micro, 0.2);
}

#[test]
fn another_map_does_not_pass() {
    let other = largest_error(textbook::hemisphere, |[u, v]| at_height(1.0 - 2.0 * u, v));
    assert!(other > 0.9);
    let swapped = largest_error(|[u, v]| textbook::disk([v, u]), |[u, v]| polar(u.sqrt(), v));
    assert!(swapped > 0.9);
    let hole = |[u]: [f32; 1]| [if u < 0.1 { f32::NAN } else { u }];
    assert!(largest_error(hole, |u| u).is_nan());
}

/// How many standard errors the mean of a statistic over samples is off the truth.
fn deviation<P>(mut draw: impl FnMut(&mut Pcg32) -> P, of: impl Fn(P) -> f64, truth: f64) -> f64 {
    const SAMPLES: u32 = 1 << 18;
    let mut rng = Pcg32::new(7, 11);
    let (mut sum, mut squares) = (0.0, 0.0);
    for _ in 0..SAMPLES {
        let off = of(draw(&mut rng)) - truth;
        sum += off;
        squares += off * off;
    }
    let count = f64::from(SAMPLES);
    let (mean, variance) = (sum / count, squares / count - (sum / count).powi(2));
    mean / (variance / count).sqrt()
}

fn square(x: f32) -> f64 {
    f64::from(x) * f64::from(x)
}

#[test]
fn what_rejects_has_the_moments_of_its_distribution() {
    let lobe = |rng: &mut Pcg32| rejecting::lobe(POWER, rng);
    let deviations = [
        deviation(rejecting::disk, |[x, _]| square(x), 1.0 / 4.0),
        deviation(rejecting::disk, |[_, y]| square(y), 1.0 / 4.0),
        deviation(rejecting::circle, |[x, _]| square(x), 1.0 / 2.0),
        deviation(rejecting::sphere, |[_, y, _]| square(y), 1.0 / 3.0),
        deviation(rejecting::sphere, |[_, _, z]| f64::from(z), 0.0),
        deviation(rejecting::hemisphere, |[_, _, z]| f64::from(z), 1.0 / 2.0),
        deviation(
            rejecting::cosine_hemisphere,
            |[_, _, z]| f64::from(z),
            2.0 / 3.0,
        ),
        deviation(lobe, |[_, _, z]| f64::from(z), (N + 1.0) / (N + 2.0)),
        // E[1 − z²]/2, as E[z²] = (n + 1)/(n + 3).
        deviation(lobe, |[x, _, _]| square(x), 1.0 / (N + 3.0)),
        deviation(rejecting::exponential, f64::from, 1.0),
        deviation(rejecting::normal, f64::from, 0.0),
        deviation(rejecting::normal, square, 1.0),
        deviation(rejecting::ball, |[x, _, _]| square(x), 1.0 / 5.0),
        deviation(drawn(textbook::disk), |[x, y]| f64::from(x * y), 0.0),
    ];
    for (index, deviation) in deviations.into_iter().enumerate() {
        assert!(
            deviation.abs() < 5.0,
            "{index}: {deviation} standard errors"
        );
    }
    // The very same figure tells a disk from a circle, and a mean from one that is two percent off.
    assert!(deviation(rejecting::disk, |[x, _]| square(x), 1.0 / 2.0).abs() > 5.0);
    assert!(deviation(rejecting::exponential, f64::from, 1.02).abs() > 5.0);
}

/// How far the quantiles of a peer's numbers under our law are from uniform: the first two moments, in standard errors.
fn beside(of: &Registered, peer: &Peer, parameters: &[f32]) -> [f64; 2] {
    let chart = (of.build)(parameters).unwrap().chart;
    [(1, 1.0 / 2.0), (2, 1.0 / 3.0)].map(|(power, due)| {
        let (mut block, mut points) = ((peer.block)(), [0.0; 1]);
        let draw = |_: &mut Pcg32| {
            block(&mut points);
            points[0]
        };
        let quantile = |x: f32| chart.invert([x.into(), 0.0, 0.0])[0].powi(power);
        deviation(draw, quantile, due)
    })
}

#[test]
fn the_peers_of_registered_laws_have_their_parameters() {
    let mut seen = 0;
    for of in of_poly() {
        for peer in &of.peers {
            let worst = |all: [f64; 2]| all[0].abs().max(all[1].abs());
            let off = worst(beside(&of, peer, &peer.parameters));
            assert!(off < 5.0, "{}: {off} standard errors", peer.law);
            let last = peer.parameters.len() - 1;
            let mut other = peer.parameters.clone();
            other[last] *= 1.1;
            let off = worst(beside(&of, peer, &other));
            assert!(off > 5.0, "{}: others pass by {off}", peer.law);
            seen += 1;
        }
    }
    assert!(seen > 5, "{seen}");
}

#[test]
fn tables_choose_in_proportion_to_the_weights() {
    let weights = [0.5, 0.0, 3.0, 1.25, 7.0];
    let total: f32 = weights.iter().sum();
    let sums = textbook::Sums::new(&weights);
    let cumulative = rejecting::cumulative(&weights);
    let aliases = rejecting::aliases(&weights);
    let tables: [&dyn Fn(&mut Pcg32) -> usize; 3] =
        [&cumulative, &aliases, &drawn(|u| sums.index(u))];
    for table in tables {
        for (index, weight) in weights.into_iter().enumerate() {
            let share = f64::from(weight / total);
            let chosen = |i: usize| if i == index { 1.0 } else { 0.0 };
            if weight == 0.0 {
                // No variance: a single one would be seen.
                assert!(deviation(table, chosen, 0.0).is_nan());
            } else {
                assert!(deviation(table, chosen, share).abs() < 5.0);
                assert!(deviation(table, chosen, 1.2 * share).abs() > 5.0);
            }
        }
    }
}
