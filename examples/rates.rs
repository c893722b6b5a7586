//! Rates: how fast the error of an integral falls. Random points have n^(-1/2) in any number of dimensions. A classical rule of
//! order r has n^(-r/s) in s dimensions: n^(-2) for midpoint and trapezoid and n^(-4) for Simpson's in one dimension, but
//! n^(-1/3) and n^(-2/3) in six.
//!
//! `cargo run --release --example rates` prints the slopes of errors over numbers of points, in logarithms, beside theory.

use microwarp::uniform;
use rand_pcg::Pcg32;

/// Integrals behind each error of random points.
const RUNS: u32 = 256;

fn main() {
    println!("dimensions   midpoint        trapezoid       Simpson         random");
    rates::<1>();
    rates::<2>();
    rates::<6>();
}

fn rates<const S: usize>() {
    print!("{S:>10}");
    let simpson = |n| (2.0 * midpoint(n) + trapezoid(n)) / 3.0;
    hold(-2.0 / S as f64, &rule::<S>(midpoint));
    hold(-2.0 / S as f64, &rule::<S>(trapezoid));
    hold(-4.0 / S as f64, &rule::<S>(simpson));
    hold(-0.5, &random::<S>());
    println!();
}

/// One factor of the integrand, of integral 1 over [0, 1]. Its derivatives differ between the ends, so no rule is better than
/// its order.
fn factor(x: f64) -> f64 {
    2.0 / ((1.0 + x) * (1.0 + x))
}

fn midpoint(n: u32) -> f64 {
    let n = f64::from(n);
    let middles = (0..n as u32).map(|i| (f64::from(i) + 0.5) / n);
    middles.map(factor).sum::<f64>() / n
}

fn trapezoid(n: u32) -> f64 {
    let n = f64::from(n);
    let edges = (1..n as u32).map(|i| f64::from(i) / n);
    (0.5 * (factor(0.0) + factor(1.0)) + edges.map(factor).sum::<f64>()) / n
}

/// Numbers of points and errors, where an axis has n intervals: over a product, the rule of all axes is a product too.
fn rule<const S: usize>(axis: impl Fn(u32) -> f64) -> Vec<[f64; 2]> {
    let sizes = (4..9).map(|k| 1 << k);
    sizes
        .map(|n: u32| [f64::from(n), axis(n)].map(|x| x.powi(S as i32)))
        .map(|[n, x]| [n, (x - 1.0).abs()])
        .collect()
}

/// Numbers of points, and the root mean square of the errors of many integrals.
fn random<const S: usize>() -> Vec<[f64; 2]> {
    let mut rng = Pcg32::new(42, S as u64);
    let mut off = |n: u32| {
        let mut value = || -> f64 {
            (0..S)
                .map(|_| factor(f64::from(uniform::grid(&mut rng))))
                .product()
        };
        (0..n).map(|_| value()).sum::<f64>() / f64::from(n) - 1.0
    };
    let mut error = |n| {
        let squares = (0..RUNS).map(|_| off(n).powi(2)).sum::<f64>();
        [f64::from(n), (squares / f64::from(RUNS)).sqrt()]
    };
    (4..12).map(|k| error(1 << k)).collect()
}

/// Fits the slope by least squares in the logarithms, and holds it to that of theory.
fn hold(theory: f64, errors: &[[f64; 2]]) {
    let points: Vec<[f64; 2]> = errors.iter().map(|e| e.map(f64::ln)).collect();
    let mean = |k: usize| points.iter().map(|p| p[k]).sum::<f64>() / points.len() as f64;
    let [x, y] = [mean(0), mean(1)];
    let products = points.iter().map(|p| (p[0] - x) * (p[1] - y));
    let squares = points.iter().map(|p| (p[0] - x).powi(2));
    let slope = products.sum::<f64>() / squares.sum::<f64>();
    print!("   {slope:.3} ({theory:.3})");
    // Five standard deviations of a slope of random points. Different rates are at least 1/6 apart.
    assert!((slope - theory).abs() <= 0.06, "not the slope of theory");
}
