//! What is measured: the tries of each point, the radii, and the running efficiency.

use crate::args::Args;
use crate::scenes::{Proposal, Scene};
use microwarp::rejection::Failure;
use rand_pcg::Pcg32;
use std::time::Instant;

/// Bars of the histogram of radii.
pub const BARS: usize = 40;
/// Tries after which the running efficiency is first marked.
pub const FIRST: f64 = 100.0;
/// Marks of the running efficiency a decade of tries.
const MARKS: f64 = 24.0;

pub struct Measured {
    pub points: usize,
    pub tries: usize,
    /// How many points took one try, two, and so on.
    pub histogram: Vec<usize>,
    /// How many radii lie in each of the equal bars from 0 to 1.
    pub radii: [usize; BARS],
    /// Tries so far and the efficiency so far.
    pub running: Vec<(f64, f64)>,
    pub shown: Vec<Proposal>,
    pub nanoseconds: f64,
}

impl Measured {
    pub fn efficiency(&self) -> f64 {
        self.points as f64 / self.tries as f64
    }

    /// How far the efficiency is off, in standard errors.
    pub fn deviation(&self, scene: &Scene) -> f64 {
        (self.efficiency() - scene.efficiency) / spread(scene.efficiency, self.tries as f64)
    }

    /// The most tries that a point took.
    pub fn most(&self) -> usize {
        self.histogram.len()
    }
}

/// The standard error of an efficiency measured over so many tries.
pub fn spread(efficiency: f64, tries: f64) -> f64 {
    (efficiency * (1.0 - efficiency) / tries).sqrt()
}

pub fn measure(scene: &Scene, args: &Args) -> Result<Measured, Failure> {
    let mut rng = Pcg32::new(args.seed, 1);
    let (mut histogram, mut radii) = (Vec::new(), [0; BARS]);
    let mut tries = 0;
    let start = Instant::now();
    for _ in 0..args.points {
        let accepted = (scene.draw)(&mut rng)?;
        let k = accepted.tries as usize;
        tries += k;
        if histogram.len() < k {
            histogram.resize(k, 0);
        }
        histogram[k - 1] += 1;
        let r = accepted.point.iter().map(|c| c * c).sum::<f64>().sqrt();
        radii[((r * BARS as f64) as usize).min(BARS - 1)] += 1;
    }
    let nanoseconds = start.elapsed().as_secs_f64() * 1e9 / args.points as f64;
    Ok(Measured {
        points: args.points,
        tries,
        histogram,
        radii,
        running: running(scene, args, tries),
        shown: shown(scene, args),
        nanoseconds,
    })
}

/// The running efficiency, after more and more tries up to all.
fn running(scene: &Scene, args: &Args, tries: usize) -> Vec<(f64, f64)> {
    let mut rng = Pcg32::new(args.seed, 2);
    let (mut marks, mut next, mut accepted) = (Vec::new(), FIRST, 0_usize);
    for k in 1..=tries {
        accepted += usize::from((scene.propose)(&mut rng).1);
        if k as f64 >= next {
            marks.push((k as f64, accepted as f64 / k as f64));
            next *= 10f64.powf(1.0 / MARKS);
        }
    }
    marks
}

fn shown(scene: &Scene, args: &Args) -> Vec<Proposal> {
    let mut rng = Pcg32::new(args.seed, 3);
    let proposals = std::iter::repeat_with(|| (scene.propose)(&mut rng));
    let visible = |p: &Proposal| scene.slice.is_none_or(|half| p.0[2].abs() <= half);
    proposals.filter(visible).take(args.shown).collect()
}
