//! Particles resampled: a walker on a line is followed by 20,000 guesses of where it is. A noisy reading weighs the guesses,
//! and resampling copies the likely ones in place of the unlikely. Here everything is normal, so that Kalman's filter has
//! the exact answer. The guesses agree with it to within a few errors of as many
//! independent ones.
//!
//! `cargo run --release --example particles` prints both, for systematic and for residual resampling, and how many equal
//! guesses the weighted ones are worth before they are resampled.

use microwarp::discrete::resampling::{rearrange, residual, systematic, to_integers};
use microwarp::{Error, Warp, poly as mw};
use rand_pcg::{Pcg32, rand_core::Rng};

const GUESSES: usize = 20_000;
/// In metres: a step, the deviation of a step, and that of a reading.
const STRIDE: f32 = 1.0;
const SWAY: f32 = 0.3;
const NOISE: f32 = 0.5;

fn main() -> Result<(), Error> {
    let mut rng = Pcg32::new(42, 54);
    let start = mw::Normal::new(0.0, 2.0)?;
    let sway = mw::Normal::new(0.0, SWAY)?;
    let noise = mw::Normal::new(0.0, NOISE)?;

    let mut walker = start.draw(&mut rng);
    let mut crowds = [(); 2].map(|()| vec![0.0; GUESSES]);
    for crowd in &mut crowds {
        start.fill(&mut rng, crowd);
    }
    let (mut mean, mut variance) = (0.0_f32, 4.0_f32);
    let mut squares = [0.0; 2];
    println!("step   walker  reading   Kalman  systematic  residual  worth");
    for step in 1..=20 {
        walker += STRIDE + sway.draw(&mut rng);
        let reading = walker + noise.draw(&mut rng);
        // Kalman's filter: predict, then correct.
        variance += SWAY * SWAY;
        let gain = variance / (variance + NOISE * NOISE);
        mean += STRIDE;
        mean += gain * (reading - mean);
        variance *= 1.0 - gain;

        let resamplings = [systematic, residual];
        let mut worth = [0.0; 2];
        for (k, crowd) in crowds.iter_mut().enumerate() {
            for guess in crowd.iter_mut() {
                *guess += STRIDE + sway.draw(&mut rng);
            }
            let weights: Vec<f32> = crowd
                .iter()
                .map(|guess| noise.pdf(reading - guess))
                .collect();
            worth[k] = effective(&weights);
            let mut counts = vec![0; GUESSES];
            to_integers(&weights, &mut counts)?;
            resamplings[k](&mut counts, GUESSES as u32, rng.next_u32())?;
            rearrange(&mut counts, crowd)?;
        }

        let error = (variance / GUESSES as f32).sqrt();
        let means = crowds
            .each_ref()
            .map(|crowd| crowd.iter().sum::<f32>() / GUESSES as f32);
        let [a, b] = means;
        println!(
            "{step:>4}  {walker:>7.3}  {reading:>7.3}  {mean:>7.3}  {a:>10.3}  {b:>8.3}  {:.0}",
            worth[0]
        );
        for (square, found) in squares.iter_mut().zip(means) {
            *square += ((found - mean) / error).powi(2) / 20.0;
        }
        // A walker is seldom three of Kalman's deviations away, and five less than
        // once in a million steps.
        assert!((walker - mean).abs() <= 5.0 * variance.sqrt());
        assert!(worth[0] < GUESSES as f32 && worth[0] > 0.1 * GUESSES as f32);
    }
    let [a, b] = squares.map(f32::sqrt);
    println!(
        "off Kalman's mean by {a:.1} and {b:.1} times the error of as many independent guesses"
    );
    assert!(a <= 4.0 && b <= 4.0, "the guesses have lost the walker");
    Ok(())
}

/// The number of equal weights that have the same variance: (Σ w)²/Σ w².
fn effective(weights: &[f32]) -> f32 {
    let sum: f32 = weights.iter().sum();
    sum * sum / weights.iter().map(|w| w * w).sum::<f32>()
}
