//! Importance sampling: the variance falls as the density approaches the integrand, to nothing where they
//! are proportional.

use crate::Z;
use microwarp::estimate::Integral;
use microwarp::{Warp, poly as mw, uniform};
use rand_pcg::Pcg32;

const SAMPLES: u32 = 1_000_000;

/// ∫ x^k/p^(k−1) over [0, 1], the k-th moment of f/p for f = x and p = 1 − t + 2tx.
fn moment(k: i32, t: f64) -> f64 {
    let cells = 100_000;
    let at = |i: u32| (f64::from(i) + 0.5) / f64::from(cells);
    let terms = (0..cells)
        .map(at)
        .map(|x| x.powi(k) / (1.0 - t + 2.0 * t * x).powi(k - 1));
    terms.sum::<f64>() / f64::from(cells)
}

/// The variance of x/p, and the standard deviation of its estimate.
fn exact(t: f64) -> (f64, f64) {
    let [m2, m3, m4] = [2, 3, 4].map(|k| moment(k, t));
    let variance = m2 - 0.25;
    let fourth = m4 - 2.0 * m3 + 1.5 * m2 - 3.0 / 16.0;
    (
        variance,
        ((fourth - variance * variance).max(0.0) / f64::from(SAMPLES)).sqrt(),
    )
}

/// The integral of x over [0, 1], sampled with density 1 − t + 2tx, or falling instead of rising.
fn integrate(t: f32, falling: bool) -> Integral {
    let warp = mw::Linear::new(1.0 - t, 1.0 + t).unwrap();
    let mut rng = Pcg32::new(31, 54);
    let mut integral = Integral::new();
    for _ in 0..SAMPLES {
        let x = warp.draw(&mut rng);
        integral.push(if falling { 1.0 - x } else { x }, warp.pdf(x));
    }
    integral
}

fn falls(variances: &[f32]) -> bool {
    variances.windows(2).all(|pair| pair[1] < pair[0])
}

#[test]
fn the_variance_falls_as_the_density_approaches_the_integrand() {
    let steps = [0.0_f32, 0.25, 0.5, 0.75, 0.875, 0.9375, 1.0];
    println!("density           variance, exact   measured  standard error");
    let mut variances = Vec::new();
    for t in steps {
        let integral = integrate(t, false);
        let variance = integral.moments().variance().unwrap();
        let error = integral.standard_error().unwrap();
        let (exact, spread) = exact(f64::from(t));
        println!(
            "{:.4} + {:.4}x  {exact:>14.3e}  {variance:>10.3e}  {error:>14.2e}",
            1.0 - t,
            2.0 * t
        );
        let off = (f64::from(variance) - exact).abs();
        assert!(off <= Z * spread + 1e-10, "t = {t}: {off:e}, {spread:e}");
        let off = f64::from(integral.estimate().unwrap()) - 0.5;
        assert!(off.abs() <= Z * f64::from(error) + 1e-7, "t = {t}: {off:e}");
        variances.push(variance);
    }
    assert!(falls(&variances));

    // The control: a density that turns away from the integrand.
    let away = [0.0, 0.25, 0.5, 0.75].map(|t| integrate(t, true).moments().variance().unwrap());
    println!("turning away: {away:?}");
    assert!(!falls(&away));
}

#[test]
fn a_proportional_density_leaves_no_variance() {
    let mut rng = Pcg32::new(32, 54);
    let warp = mw::Linear::new(0.0, 1.0).unwrap();
    let (mut integral, mut control) = (Integral::new(), Integral::new());
    for _ in 0..SAMPLES {
        let x = warp.draw(&mut rng);
        integral.push(x, 2.0 * x);
        control.push(x + 1e-3 * uniform::grid(&mut rng), 2.0 * x);
    }
    assert_eq!(integral.estimate(), Some(0.5));
    assert_eq!(integral.moments().variance(), Some(0.0));
    assert!(control.moments().variance().unwrap() > 0.0);
}
