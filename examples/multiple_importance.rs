//! Multiple importance sampling: what a glossy surface reflects of a lamp, by directions to the lamp, by directions of the
//! lobe, and by one of each with weights. A small lamp wants its own directions, a sharp lobe wants the lobe's. The weights
//! need not be told which: they do well in both scenes, where each way alone is bad in one of them.
//!
//! `cargo run --release --example multiple_importance` prints four estimates in each of two scenes, with
//! their relative deviations for one direction.

use microwarp::estimate::{Moments, balance_heuristic, power_heuristic};
use microwarp::{Error, Warp, poly as mw};
use rand_pcg::Pcg32;

const SAMPLES: u32 = 200_000;

fn main() -> Result<(), Error> {
    // The lobe (n + 1)/2π cosⁿ θ and the lamp, a cone of radiance 1, both about +z.
    let small_lamp = reflect(5.0, 0.1)?;
    let sharp_lobe = reflect(200.0, 0.2)?;
    let [lamp, lobe] = [0, 1].map(|k| [small_lamp[k], sharp_lobe[k]]);
    assert!(3.0 * lamp[0] < lobe[0] && 3.0 * lobe[1] < lamp[1]);
    // Over both scenes, neither way alone is as good as the two together.
    for k in [2, 3] {
        let together = small_lamp[k].max(sharp_lobe[k]);
        assert!(together < lamp[1] && together < lobe[0]);
    }
    Ok(())
}

/// The relative deviations for one direction: by the lamp, by the lobe, and together by either heuristic.
fn reflect(exponent: f32, angle: f32) -> Result<[f64; 4], Error> {
    let lobe = mw::PhongLobe::new(exponent)?;
    let lamp = mw::Cone::from_radians(angle)?;
    // What the lobe puts into the cone: 1 − cosⁿ⁺¹ of its angle.
    let exact = 1.0 - f64::from(angle).cos().powf(f64::from(exponent) + 1.0);
    println!("exponent {exponent}, lamp of {angle} rad: exactly {exact:.5}");

    let mut rng = Pcg32::new(42, 54);
    let mut estimates = [Moments::new(); 4];
    for _ in 0..SAMPLES {
        let (to_lamp, by_lamp) = lamp.draw_with_pdf(&mut rng);
        let (reflected, by_lobe) = lobe.draw_with_pdf(&mut rng);
        let (lamp_there, lobe_there) = (lamp.pdf(reflected), lobe.pdf(to_lamp));
        // The integrand is the density of the lobe, within the cone.
        let first = lobe_there / by_lamp;
        let second = if lamp_there > 0.0 { 1.0 } else { 0.0 };
        estimates[0].push(first);
        estimates[1].push(second);
        for (k, heuristic) in [
            (2, balance_heuristic as fn(u32, f32, u32, f32) -> f32),
            (3, power_heuristic),
        ] {
            let first = first * heuristic(1, by_lamp, 1, lobe_there);
            let second = second * heuristic(1, by_lobe, 1, lamp_there);
            estimates[k].push(first + second);
        }
    }

    let mut deviations = [0.0; 4];
    let names = ["lamp", "lobe", "balance heuristic", "power heuristic"];
    for (k, estimate) in estimates.iter().enumerate() {
        let mean = f64::from(estimate.mean().unwrap_or(f32::NAN));
        let error = f64::from(estimate.standard_error().unwrap_or(f32::NAN));
        // The weighted sums take two directions.
        let directions = if k < 2 { 1.0 } else { 2.0 };
        deviations[k] = error * (directions * f64::from(SAMPLES)).sqrt() / exact;
        println!(
            "  {:<18} {mean:.5}, deviation {:.3}",
            names[k], deviations[k]
        );
        assert!((mean - exact).abs() <= 6.0 * error, "biased");
    }
    // E. Veach, L. J. Guibas, 1995, theorem 1: the variance of the balance heuristic exceeds that of the better way, with one
    // direction, by half the square of the integral at most. 1 % is left for its own error.
    let [best, balance] = [deviations[0].min(deviations[1]), deviations[2]].map(|d| d * d);
    assert!(0.5 * balance <= 1.01 * best + 0.5);
    Ok(deviations)
}
