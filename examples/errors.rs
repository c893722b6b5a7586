//! Estimators and their errors. An `Integral` knows the standard error of its estimate, which falls as n^(-1/2) whatever the
//! dimension, here six. A density near the integrand makes it smaller, at the same rate. Bounds follow from it: the normal
//! one holds about as often as it says, Chebyshev's at least as often.
//!
//! `cargo run --release --example errors` prints both estimates and their errors, then how often bounds of 90 % are missed.

use microwarp::estimate::Integral;
use microwarp::{Error, Warp, poly as mw, uniform};
use rand_pcg::Pcg32;

const DIMENSIONS: usize = 6;
const INTEGRALS: u32 = 2000;

fn main() -> Result<(), Error> {
    // Along each axis the integrand falls from 2 to 1/2, and so does e^(-x ln 4).
    let axis = mw::TruncatedExponential::from_rate(4.0_f32.ln(), 1.0)?;
    let mut rng = Pcg32::new(42, 54);
    let mut plain = |n| {
        let draw = || (std::array::from_fn(|_| uniform::grid(&mut rng)), 1.0);
        integrate(n, draw)
    };
    let mut rng = Pcg32::new(42, 55);
    let mut near = |n| {
        integrate(n, || {
            let x = std::array::from_fn(|_| axis.draw(&mut rng));
            (x, x.map(|x| axis.pdf(x)).iter().product())
        })
    };

    println!("       n   uniform     error   · √n   near density     error   · √n");
    for n in [1 << 12, 1 << 16, 1 << 20] {
        let root = (n as f32).sqrt();
        let [[a, plain], [b, near]] = [report(&plain(n)), report(&near(n))];
        println!(
            "{n:>8}  {a:>8.4}  {plain:>8.5}  {:.3}       {b:>8.4}  {near:>8.5}  {:.3}",
            plain * root,
            near * root
        );
        assert!((a - 1.0).abs() <= 5.0 * plain && (b - 1.0).abs() <= 5.0 * near);
        assert!(near <= 0.5 * plain, "the density is of no use");
        // The variance of f/p: ∏ ∫ f²/p − 1, which is (7/6)⁶ − 1 = 1.234² without the density.
        assert!((plain * root / 1.234 - 1.0).abs() <= 0.3, "not n^(-1/2)");
    }

    let (mut normal, mut chebyshev) = (0.0, 0.0);
    for _ in 0..INTEGRALS {
        let integral = plain(1000);
        let off = (report(&integral)[0] - 1.0).abs();
        let missed = |bound: f32| {
            if off <= bound {
                0.0
            } else {
                1.0 / INTEGRALS as f32
            }
        };
        normal += missed(integral.normal_bound::<microwarp::tier::Poly>(0.9)?);
        chebyshev += missed(integral.chebyshev_bound(0.1)?);
    }
    println!(
        "of {INTEGRALS} integrals, the normal bound misses {normal:.3}, Chebyshev's {chebyshev:.3}"
    );
    assert!((normal - 0.1).abs() <= 0.03 && chebyshev <= 0.1);
    Ok(())
}

/// The integral of ∏ 2/(1 + x)² over the unit cube, which is 1.
fn integrate(n: u32, mut draw: impl FnMut() -> ([f32; DIMENSIONS], f32)) -> Integral {
    let mut integral = Integral::new();
    for _ in 0..n {
        let (x, density) = draw();
        let factors = x.map(|x| 2.0 / ((1.0 + x) * (1.0 + x)));
        integral.push(factors.iter().product(), density);
    }
    integral
}

/// The estimate and its standard error.
fn report(integral: &Integral) -> [f32; 2] {
    [integral.estimate(), integral.standard_error()].map(|x| x.unwrap_or(f32::NAN))
}
