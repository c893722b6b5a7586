//! Inversion of a histogram: a uniform number is looked up in the sums of the weights, and what is left of it places the
//! point within its bar. Bars come back in proportion to their weights, and a bar of weight 0 never does.
//!
//! `cargo run --release --example histogram` prints the shares of a million points beside the weights.

use microwarp::discrete::PiecewiseConstant1d;
use microwarp::{Error, Invert, Warp};
use rand_pcg::Pcg32;

const POINTS: u32 = 1_000_000;
/// Hours of a day by the speed of the wind, in bars of 2 m/s.
const HOURS: [f32; 8] = [1.0, 4.0, 7.5, 6.0, 0.0, 3.5, 1.5, 0.5];

fn main() -> Result<(), Error> {
    let wind = PiecewiseConstant1d::new(&HOURS, 0.0, 16.0)?;

    // By hand: 12.5 of 24 hours are below 6 m/s. A quarter of the fourth bar's 6 hours more, and the speed is 6.5 m/s.
    let speed = wind.sample(14.0 / 24.0);
    println!(
        "u = 14/24 gives {speed} m/s, which gives {} back",
        wind.invert(speed)
    );
    assert!((speed - 6.5).abs() <= 1e-5);
    assert!((wind.invert(speed) - 14.0 / 24.0).abs() <= 1e-6);

    let mut rng = Pcg32::new(42, 54);
    let (mut counts, mut sum) = ([0_u32; HOURS.len()], 0.0);
    for _ in 0..POINTS {
        let speed = wind.draw(&mut rng);
        assert!(wind.pdf(speed) > 0.0);
        counts[(speed / 2.0) as usize] += 1;
        sum += f64::from(speed);
    }
    println!("   m/s   share    due");
    for (i, count) in counts.iter().enumerate() {
        let (share, due) = (f64::from(*count) / f64::from(POINTS), due(&HOURS, i));
        let bar = "#".repeat((100.0 * share).round() as usize);
        println!(
            "{:>2} - {:>2}  {share:.4} {due:.4}  {bar}",
            2 * i,
            2 * i + 2
        );
    }

    let mean = sum / f64::from(POINTS);
    let middles = (0..HOURS.len()).map(|i| (2 * i + 1) as f64 * due(&HOURS, i));
    let exact = middles.sum::<f64>();
    println!("mean {mean:.4} m/s, exact {exact:.4} m/s");
    assert!((mean - exact).abs() <= 0.02);
    assert_eq!(counts[4], 0, "a bar of weight 0 was drawn");

    // Of the seven bars with a weight: with six degrees of freedom χ² exceeds 52 twice in a billion. That of weights which
    // are a little off must be larger.
    let mut off = HOURS;
    off[2] += 0.15;
    let [right, wrong] = [HOURS, off].map(|weights| chi_square(&counts, &weights));
    println!("χ² = {right:.1}; with one weight 2 % larger it would be {wrong:.1}");
    assert!(right <= 52.0);
    assert!(wrong > 52.0, "the test lets wrong weights pass");
    Ok(())
}

/// The share that a bar is due.
fn due(weights: &[f32; HOURS.len()], bar: usize) -> f64 {
    let sum: f64 = weights.iter().map(|&w| f64::from(w)).sum();
    f64::from(weights[bar]) / sum
}

fn chi_square(counts: &[u32; HOURS.len()], weights: &[f32; HOURS.len()]) -> f64 {
    let bars = (0..HOURS.len()).filter(|&i| weights[i] > 0.0);
    bars.map(|i| {
        let expected = f64::from(POINTS) * due(weights, i);
        (f64::from(counts[i]) - expected).powi(2) / expected
    })
    .sum()
}
