//! Particles resampled: a robot rolls along a corridor and is followed by 20,000 guesses of its pose. Two noisy readings weigh
//! the guesses, and resampling copies the likely ones in place of the unlikely. The noise of odometry is correlated and its
//! covariance singular: what wheels move sideways follows from their turn. Everything is normal and linear, so that Kalman's
//! filter has the exact answer. The guesses agree with it to within a few errors of as many independent ones.
//!
//! `cargo run --release --example particles` prints both, for systematic and for residual resampling, how many equal guesses
//! the weighted ones are worth, and the mean of Mahalanobis' squared distance at the end, which is 3.

use microwarp::discrete::resampling::{rearrange, residual, systematic, to_integers};
use microwarp::{Error, Warp, poly as mw};
use rand_pcg::{Pcg32, rand_core::Rng};
use std::array::from_fn;

const GUESSES: usize = 20_000;
/// Metres along the corridor and across it, and the heading in radians.
type Pose = [f32; 3];
const START: [Pose; 3] = [[4.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 0.01]];
/// A step of a metre turns by 0.02; what is across is half of that.
const SLIP: [Pose; 3] = [[0.09, 0.0, 0.0], [0.0, 1e-4, 2e-4], [0.0, 2e-4, 4e-4]];
/// Of both readings, which are along and across.
const NOISE: f32 = 0.5;

fn moved([along, across, heading]: Pose, [x, y, turn]: Pose) -> Pose {
    [along + 1.0 + x, across + heading + y, heading + turn]
}

fn main() -> Result<(), Error> {
    let mut rng = Pcg32::new(42, 54);
    let start = mw::MultivariateNormal::new([0.0; 3], START)?;
    let slip = mw::MultivariateNormal::new([0.0; 3], SLIP)?;
    let noise = mw::Normal::new(0.0, NOISE)?;
    assert_eq!(slip.rank(), 2);

    let mut robot = start.draw(&mut rng);
    let mut crowds = [(); 2].map(|()| vec![robot; GUESSES]);
    for crowd in &mut crowds {
        start.fill(&mut rng, crowd);
    }
    let (mut mean, mut spread) = ([0.0; 3], START);
    let mut squares = [0.0; 2];
    println!("step    robot   Kalman  [systematic, residual]  worth");
    for step in 1..=20 {
        robot = moved(robot, slip.draw(&mut rng));
        let readings = [0, 1].map(|k| robot[k] + noise.draw(&mut rng));
        // Kalman's filter: predict, then correct by each reading.
        mean = moved(mean, [0.0; 3]);
        spread[1] = from_fn(|j| spread[1][j] + spread[2][j]);
        for (row, slip) in spread.iter_mut().zip(SLIP) {
            row[1] += row[2];
            *row = from_fn(|j| row[j] + slip[j]);
        }
        for (k, reading) in readings.into_iter().enumerate() {
            let (p, off) = (spread, reading - mean[k]);
            let gain: Pose = from_fn(|i| p[i][k] / (p[k][k] + NOISE * NOISE));
            mean = from_fn(|i| mean[i] + gain[i] * off);
            spread = from_fn(|i| from_fn(|j| p[i][j] - gain[i] * p[k][j]));
        }

        let mut worth = 0.0;
        for (crowd, resample) in crowds.iter_mut().zip([systematic, residual]) {
            let mut weights = vec![0.0; GUESSES];
            for (guess, weight) in crowd.iter_mut().zip(&mut weights) {
                *guess = moved(*guess, slip.draw(&mut rng));
                *weight = noise.pdf(readings[0] - guess[0]) * noise.pdf(readings[1] - guess[1]);
            }
            // The number of equal weights that have the same variance.
            let of_squares: f32 = weights.iter().map(|w| w * w).sum();
            worth = weights.iter().sum::<f32>().powi(2) / of_squares;
            let mut counts = vec![0; GUESSES];
            to_integers(&weights, &mut counts)?;
            resample(&mut counts, GUESSES as u32, rng.next_u32())?;
            rearrange(&mut counts, crowd)?;
        }
        let means = crowds.each_ref().map(|crowd| mean_of(crowd, |g| g[1]));
        let (at, y, deviation) = (robot[1], mean[1], spread[1][1].sqrt());
        println!("{step:>4}  {at:>7.3}  {y:>7.3}  {means:>9.3?}  {worth:.0}");
        for (square, found) in squares.iter_mut().zip(means) {
            *square += ((found - y) / deviation).powi(2) * GUESSES as f32 / 20.0;
        }
        // The robot is farther than five of Kalman's deviations less than once in a million steps.
        assert!((at - y).abs() <= 5.0 * deviation && worth > 0.05 * GUESSES as f32);
    }
    let known = mw::MultivariateNormal::new(mean, spread)?;
    for (crowd, square) in crowds.iter().zip(squares) {
        let distance = mean_of(crowd, |g| known.whiten(*g).iter().map(|z| z * z).sum());
        let off = square.sqrt();
        println!("off by {off:.1} errors of so many guesses; Mahalanobis {distance:.2}");
        assert!(off <= 5.0, "the guesses have lost the robot");
        assert!((distance - 3.0).abs() < 0.3, "another spread");
    }
    Ok(())
}

fn mean_of(crowd: &[Pose], of: impl Fn(&Pose) -> f32) -> f32 {
    crowd.iter().map(of).sum::<f32>() / GUESSES as f32
}
