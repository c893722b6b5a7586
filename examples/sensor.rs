//! A range sensor with noise, in integers only, as a core without floating point would simulate it: feature `fixed`. Readings
//! are normal about the distance, but one in sixteen is an echo from anywhere. Echoes spoil the mean of five readings. The
//! median of five is close to the distance nevertheless.
//!
//! `cargo run --release --example sensor` prints mean and deviation of single readings beside theory, and the deviations of
//! both filters.

use microwarp::discrete::Cdf;
use microwarp::estimate::Moments;
use microwarp::fixed::{Deviate, Interval, NormalPair};
use microwarp::{Error, Warp};
use rand_pcg::Pcg32;

const PAIRS: u32 = 200_000;
/// What comes back, as a table that the compiler builds: the target fifteen times in sixteen, or an echo.
const ECHO: Cdf<[u32; 2]> = microwarp::constant!(Cdf::from_integers(&[15, 1]));

/// Metres in a 32-bit number with 27 bits behind the point. Any other format of the crate `fixed` will do.
type Metres = Deviate;

fn main() -> Result<(), Error> {
    let distance = Metres::from_num(3);
    let noise = NormalPair::new([distance; 2], Metres::ONE / 20)?;
    let anywhere = Interval::<Metres>::new(Metres::ZERO, Metres::from_num(8))?;

    let mut rng = Pcg32::new(42, 54);
    let mut reading = |clean: Metres| match ECHO.draw_index(&mut rng) {
        0 => clean,
        _ => anywhere.draw(&mut rng),
    };
    let mut rng = Pcg32::new(42, 55);
    let (mut single, mut means, mut medians) = (Moments::new(), Moments::new(), Moments::new());
    for _ in 0..PAIRS {
        // Five pairs of normal numbers make two fives.
        let pairs: [[Metres; 2]; 5] = std::array::from_fn(|_| noise.draw(&mut rng));
        for half in [0, 1] {
            let mut five = pairs.map(|pair| reading(pair[half]));
            five.sort_unstable();
            let sum = five[1..].iter().fold(five[0] / 5, |sum, r| sum + r / 5);
            // What is measured for the report may be in floating point.
            five.iter().for_each(|r| single.push(r.to_num()));
            means.push(sum.to_num());
            medians.push(five[2].to_num());
        }
    }

    // A mixture: 15/16 about 3 m with a variance of 1/400, 1/16 about 4 m with one of 8²/12.
    let mean = 3.0 + 1.0 / 16.0;
    let deviation = f32::sqrt(15.0 / 16.0 / 400.0 + 64.0 / 12.0 / 16.0 + 15.0 / 256.0);
    let of = |moments: &Moments| [moments.mean(), moments.std_dev()].map(|x| x.unwrap_or(f32::NAN));
    println!("in metres          mean   exact   deviation   exact");
    let five = deviation / 5.0_f32.sqrt();
    for (name, moments, deviation) in [
        ("single", &single, deviation),
        ("mean of five", &means, five),
    ] {
        let [found, spread] = of(moments);
        println!("{name:<14} {found:>8.4}  {mean:.4}  {spread:>10.4}  {deviation:.4}");
        assert!((found - mean).abs() <= 6.0 * deviation / (moments.count() as f32).sqrt());
        assert!(
            (spread / deviation - 1.0).abs() <= 0.02,
            "{name}: the deviation is wrong"
        );
    }
    let [found, spread] = of(&medians);
    println!("median of five {found:>8.4}          {spread:>10.4}");
    assert!(
        (found - 3.0).abs() <= 0.01 && 2.0 * spread < five,
        "the median is no better"
    );
    Ok(())
}
