//! Mutations that cross a valley, or do not. The target (x − 1/2)² has two humps and nothing between them. Small steps alone
//! cross once in 32,000 steps: each run sees one hump, and only two runs from different starts reveal it. One large step in
//! ten cures that, at little cost in acceptance.
//!
//! `cargo run --release --example valley` prints acceptance and crossings of ten million steps beside their exact integrals, the
//! time spent on the left, and split R̂ of two runs of 10,000 steps, one from each hump.

use microwarp::Error;
use microwarp::metropolis::{BoxStep, Chain, Halves, Mixture, Mutation, UniformStep, split_r_hat};
use rand_pcg::Pcg32;

/// A box step goes up to half of this to either side.
const WIDTH: f32 = 0.1;

fn main() -> Result<(), Error> {
    let (anywhere, small) = (UniformStep::new(), BoxStep::new(WIDTH)?);
    let mixture = Mixture::new((small, anywhere), &[0.9, 0.1])?;
    println!("mutation   accepted    exact   crossings    exact   left   split R̂");
    let [left, large] = run("uniform", &anywhere, 0.0)?;
    let [_, stuck] = run("box 0.1", &small, 1.0)?;
    let [left_cured, cured] = run("mixture", &mixture, 0.9)?;
    assert!((left - 0.5).abs() <= 0.005 && (left_cured - 0.5).abs() <= 0.01);
    // Well above 1, runs disagree.
    assert!(large <= 1.05 && cured <= 1.05, "runs that cross disagree");
    assert!(stuck > 1.5, "runs that do not cross seem to agree");
    Ok(())
}

fn target(x: f32) -> f32 {
    if (0.0..=1.0).contains(&x) {
        (x - 0.5) * (x - 0.5)
    } else {
        0.0
    }
}

/// Holds ten million steps of a mutation, of which this share is small, to the exact integrals. Returns the share of time on
/// the left, and split R̂.
fn run<M: Mutation<f32>>(name: &str, mutation: &M, small: f64) -> Result<[f32; 2], Error> {
    const STEPS: u32 = 10_000_000;
    let mut rng = Pcg32::new(42, 5);
    let mut chain = Chain::new(0.1, target)?;
    let (mut crossed, mut left) = (0, 0);
    for _ in 0..STEPS {
        let step = chain.step(target, mutation, &mut rng);
        crossed += u32::from((step.from < 0.5) != (step.state() < 0.5));
        left += u32::from(step.state() < 0.5);
    }
    let accepted = f64::from(chain.acceptance_rate().unwrap_or(f32::NAN));
    let [accepts, crosses] = exact(small);
    let crossings = f64::from(crossed) / f64::from(STEPS);

    let mut halves = [Halves::new(5_000); 2];
    for (half, start) in halves.iter_mut().zip([0.1, 0.9]) {
        let mut chain = Chain::new(start, target)?;
        for _ in 0..10_000 {
            half.push(chain.step(target, mutation, &mut rng).state());
        }
    }
    let r_hat = split_r_hat(&halves).unwrap_or(f32::NAN);
    let share = left as f32 / STEPS as f32;
    println!(
        "{name:<8}  {accepted:>9.4}  {accepts:>7.4}  {crossed:>10}  {:>7.0}  {share:>5.2}  {r_hat:>8.3}",
        crosses * f64::from(STEPS)
    );
    assert!((accepted - accepts).abs() <= 0.005, "wrong acceptance");
    // Crossings come in bunches, which may triple the variance of independent ones.
    let close = (crossings - crosses).abs() <= 6.0 * (3.0 * crosses / f64::from(STEPS)).sqrt();
    assert!(close, "the number of crossings is wrong");
    Ok([share, r_hat])
}

/// The probabilities that a step is accepted and that it crosses: over all pairs of states the step's density times the
/// smaller of both densities, by the midpoint rule.
fn exact(small: f64) -> [f64; 2] {
    const CELLS: usize = 1000;
    let x = |i: usize| (i as f64 + 0.5) / CELLS as f64;
    let density = |i: usize| 12.0 * (x(i) - 0.5).powi(2);
    let half = (0.5 * f64::from(WIDTH) * CELLS as f64).round() as usize;
    let mut sums = [0.0; 2];
    for (i, j) in (0..CELLS).flat_map(|i| (0..CELLS).map(move |j| (i, j))) {
        // Cells at the very edge of the box are in it by half.
        let within = match i.abs_diff(j) {
            d if d < half => 1.0,
            d if d == half => 0.5,
            _ => 0.0,
        };
        let step = small * within / f64::from(WIDTH) + (1.0 - small);
        let flow = step * density(i).min(density(j)) / (CELLS * CELLS) as f64;
        sums[0] += flow;
        sums[1] += if (i < CELLS / 2) == (j < CELLS / 2) {
            0.0
        } else {
            flow
        };
    }
    sums
}
