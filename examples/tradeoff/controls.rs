//! Controls: maps that are wrong by an amount known in closed form, which the estimate must find. And one correct
//! map, whose bias is known because all its uniforms can be tried.

use crate::args::Args;
use crate::bias::{self, Bias, Shows};
use crate::cells;
use crate::power::{LEVEL, Power};
use crate::sampler::{Law, Map, Point, Words};
use crate::shape::{self, Shape};
use crate::study::generator;
use crate::subject::law;
use host::truth;
use microwarp::Warp;
use microwarp::uniform::grid_from_word;
use rand_core::Rng;
use rand_pcg::Pcg32;
use statrs::distribution::{ContinuousCDF, Normal};
use std::f64::consts::TAU;

/// How many standard errors an estimate may be off.
const DOUBT: f64 = 5.0;
/// Uniforms that are tried for a bias.
const TRIED: usize = 4_000_000;
/// Samples of the test that is to reject, as many as that of the samplers has unless less is asked for.
const SAMPLES: usize = 1_000_000;
/// Repetitions of a test that is to reject half of the time.
const REPETITIONS: usize = 60;

pub struct Control {
    pub name: &'static str,
    pub is_wrong: bool,
    pub shape: Shape,
    pub bias: Bias,
    /// The noncentrality a sample, in closed form or by enumeration.
    pub exact: f64,
    /// Of how many tests with the number of samples found, how many rejected.
    pub rejected: Option<(usize, usize)>,
}

impl Control {
    /// After how many samples the bias shows, by the closed form.
    pub fn due(&self) -> f64 {
        Power::of(self.bias.cells - 1).needed() / self.exact
    }

    pub fn complaints(&self, threshold: f64) -> Vec<String> {
        let mut complaints = Vec::new();
        let mut hold = |what: String, holds: bool| {
            if !holds {
                complaints.push(format!("{}: {what}", self.name));
            }
        };
        let passes = self.shape.passes(threshold);
        hold(
            format!("passes the test: {passes}"),
            passes != self.is_wrong,
        );
        let off = (self.bias.lambda - self.exact).abs();
        let near = off <= DOUBT * self.bias.error && self.bias.error <= 0.05 * self.exact;
        let (found, exact) = (self.bias.lambda, self.exact);
        hold(
            format!("noncentrality {found:.4e}, in truth {exact:.4e}"),
            near,
        );
        hold(
            "no number of samples is found".into(),
            matches!(self.bias.shows(), Shows::After(_)),
        );
        if let Some((rejected, of)) = self.rejected {
            // Half of them, to within what chance does once in a million.
            let half = 0.5 * of as f64;
            let spread = Normal::standard().inverse_cdf(1.0 - 5e-7) * (0.5 * half).sqrt();
            let plausible = (rejected as f64 - half).abs() <= spread;
            hold(
                format!("{rejected} of {of} tests reject after that many samples"),
                plausible,
            );
        }
        complaints
    }
}

/// A map of words of 32 bits.
fn map(at: impl Fn([f64; 2]) -> Point + Send + Sync + 'static) -> Map {
    let uniform = |word| f64::from(word) / 4_294_967_296.0;
    Map {
        bits: 32,
        at: Box::new(move |words: Words| (at([words[0], words[1]].map(uniform)), None)),
    }
}

/// Draws points of a map.
fn examine(map: &Map, law: &Law, samples: usize, rng: &mut Pcg32) -> Shape {
    let words = std::iter::repeat_with(|| [rng.next_u32(), rng.next_u32(), 0, 0]);
    shape::examine_points(words.take(samples).map(|words| (map.at)(words).0), law)
}

fn control(
    name: &'static str,
    map: &Map,
    law: &Law,
    exact: f64,
    repeat: bool,
    args: &Args,
) -> Control {
    let rng = &mut generator(args.seed, name, 0);
    let tried = TRIED.div_ceil(bias::borders(law.axes));
    let bias = bias::estimate(map, law, tried, rng);
    let shape = examine(map, law, SAMPLES, rng);
    let rejected = match bias.shows() {
        Shows::After(samples) if repeat => {
            let of = REPETITIONS;
            let rejects = |_: &usize| examine(map, law, samples as usize, rng).p[0] < LEVEL;
            Some(((0..of).filter(rejects).count(), of))
        }
        _ => None,
    };
    Control {
        name,
        is_wrong: true,
        shape,
        bias,
        exact,
        rejected,
    }
}

/// The disk with r = ξ, and an exponential whose mean is off by 2 %.
pub fn all(args: &Args) -> Vec<Control> {
    // Of the columns of cells, which are rings of equal area, each holds the difference of two square roots.
    let parts = cells::grid(2)[0];
    let share = |i: usize| i as f64 / parts as f64;
    let ring = |i| share(i + 1).sqrt() - share(i).sqrt();
    let disk = sum_of_squares((0..parts).map(ring));
    // Less than x is 1 − (1 − u)^(1/m) of u = 1 − e^−x, for the mean m.
    let mean = 1.02;
    let parts = cells::grid(1)[0];
    let left = |i: usize| (1.0 - i as f64 / parts as f64).powf(1.0 / mean);
    let exponential = sum_of_squares((0..parts).map(|i| left(i) - left(i + 1)));
    let wide = map(move |[u, _]| [-mean * (-u).ln_1p(), 0.0, 0.0]);
    let narrow = map(|[u, v]| [u * (TAU * v).cos(), u * (TAU * v).sin(), 0.0]);
    let mut controls = vec![
        control(
            "disk with r = u",
            &narrow,
            &law(Box::new(truth::Disk), 2),
            disk,
            false,
            args,
        ),
        control(
            "exponential of mean 1.02",
            &wide,
            &law(truth::exponential(1.0), 1),
            exponential,
            true,
            args,
        ),
    ];
    let law = law(truth::exponential(1.0), 1);
    let right = Map {
        bits: 24,
        at: Box::new(|[word, ..]| ([poly().sample(grid_from_word(word)).into(), 0.0, 0.0], None)),
    };
    let exact = enumerated(&right, &law);
    let right = control(
        "Exponential poly, as it is",
        &right,
        &law,
        exact,
        false,
        args,
    );
    controls.push(Control {
        is_wrong: false,
        ..right
    });
    controls
}

fn poly() -> microwarp::poly::Exponential {
    microwarp::poly::Exponential::from_rate(1.0).expect("a rate")
}

/// The noncentrality a sample of a map of one uniform, by all its uniforms.
fn enumerated(map: &Map, law: &Law) -> f64 {
    let mut counts = vec![0_u64; cells::count(1)];
    for number in 0..1_u32 << map.bits {
        let point = (map.at)([number << (32 - map.bits), 0, 0, 0]).0;
        counts[cells::cell(law.chart.invert(point), 1)] += 1;
    }
    let all = (1_u64 << map.bits) as f64;
    sum_of_squares(counts.iter().map(|count| *count as f64 / all))
}

/// The sum of (p − p₀)²/p₀ over cells of equal p₀; cells side by side of the same p − p₀ are one.
fn sum_of_squares(shares: impl ExactSizeIterator<Item = f64>) -> f64 {
    let due = 1.0 / shares.len() as f64;
    shares.map(|p| (p - due).powi(2) / due).sum()
}
