//! The densities of `Gamma`, `Beta` and `Dirichlet` beside their formulas in `f64`.

use crate::gamma::shapes;
use crate::{gamma, shares};
use host::errors::{or_infinite, raise};
use host::speed;
use microwarp::poly;
use microwarp::rejection::Rejection;
use rand_pcg::Pcg32;
use rand_pcg::rand_core::Rng;
use statrs::function::gamma::ln_gamma;
use std::f64::consts::TAU;

fn ln_pdf(shape: f32, scale: f32, x: f32) -> f64 {
    let (a, y) = (f64::from(shape), f64::from(x) / f64::from(scale));
    if a > 30.0 {
        // Stirling's formula, of which what is left out is below 1e-10, and a deviance in which nothing cancels.
        let excess = 1.0 / (12.0 * a) - 1.0 / (360.0 * a.powi(3));
        let away = (y - a) / a;
        let deviance = a * (away - away.ln_1p());
        return 0.5 * (a / TAU).ln() - excess - deviance - f64::from(x).ln();
    }
    (a - 1.0) * y.ln() - y - ln_gamma(a) - f64::from(scale).ln()
}

#[test]
fn the_density_is_that_of_the_formula() {
    fn worst(number: u32, each: u32) -> (f64, f32, f32) {
        let mut worst = (0.0, 0.0, 0.0);
        for (shape, seed) in shapes(number).chain([1.0]).zip(1..) {
            let mut rng = Pcg32::new(seed, 36);
            for i in 0..each {
                let unit = |rng: &mut Pcg32| f64::from(rng.next_u32()) / 4_294_967_296.0;
                let scale = 10_f64.powf(4.0 * unit(&mut rng) - 2.0) as f32;
                let sampler = poly::Gamma::new(shape, scale).unwrap();
                let deviation = f64::from(shape).sqrt();
                let y = if i % 3 == 0 {
                    10_f64.powf(70.0 * unit(&mut rng) - 45.0)
                } else {
                    f64::from(shape) + deviation * (24.0 * unit(&mut rng) - 12.0)
                };
                let x = (y * f64::from(scale)) as f32;
                if !(x > 0.0 && x < f32::MAX) {
                    continue;
                }
                let ln = ln_pdf(shape, scale, x);
                if !(-87.0..88.0).contains(&ln) {
                    continue;
                }
                let exact = ln.exp();
                let y = f64::from(x) / f64::from(scale);
                let far = (y / f64::from(shape)).ln().abs() * f64::from(shape);
                let bound = 3.5e-7 + 2e-10 * far;
                let error = (f64::from(sampler.pdf(x)) / exact - 1.0).abs() / bound;
                if raise(&mut worst.0, error) {
                    (worst.1, worst.2) = (shape, x / scale);
                }
            }
        }
        worst
    }
    assert!(
        gamma::page()
            .contains("relative error of 3.5e-7 + 2e-10 a|ln(x/aθ)|, or an absolute one of 2⁻¹⁴⁸")
    );
    let worst = worst(speed::of("shapes of densities", 100, 3000), 300);
    println!("{worst:.3?} of the bound");
    assert!(worst.0 <= 1.0, "{worst:?}");
    // Small numbers, and densities that f32 does not hold.
    let half = poly::Gamma::new(0.5, 2.0).unwrap();
    assert_eq!(half.pdf(0.0), half.pdf(f32::from_bits(1)));
    assert_eq!(poly::Gamma::new(1e-3, 1.0).unwrap().pdf(0.0), f32::MAX);
    let stride = speed::of("bits between densities", 0x0101_0101, 0x0011_0101);
    for shape in shapes(200) {
        let sampler = poly::Gamma::new(shape, 1.0).unwrap();
        for bits in (0..0x7f80_0000).step_by(stride) {
            let density = sampler.pdf(f32::from_bits(bits));
            assert!(density > 0.0 && density <= f32::MAX, "{shape} {bits}");
        }
    }
    // Of whole shapes, without a gamma function.
    let three = poly::Gamma::new(3.0, 1.0).unwrap();
    for x in [0.1_f32, 1.0, 2.0, 9.5, 50.0] {
        let exact = 0.5 * f64::from(x) * f64::from(x) * (-f64::from(x)).exp();
        assert!((f64::from(three.pdf(x)) / exact - 1.0).abs() <= 3.6e-7);
    }
    // The bound notices a wrong shape.
    let (wrong, exact) = (
        poly::Gamma::new(3.000_01, 1.0).unwrap(),
        ln_pdf(3.0, 1.0, 9.5).exp(),
    );
    assert!((f64::from(wrong.pdf(9.5)) / exact - 1.0).abs() > 2e-6);
}

/// Of √(a/2π)/x·…: the logarithm of a^a/(e^a Γ(a)).
fn ln_peak(a: f64) -> f64 {
    if a > 30.0 {
        0.5 * (a / TAU).ln() - 1.0 / (12.0 * a) + 1.0 / (360.0 * a.powi(3))
    } else {
        a * a.ln() - a - ln_gamma(a)
    }
}

/// The density of shares, of which the largest is what the others leave; and how much its exponents have in all.
fn ln_pdf_of_shares<const N: usize>(shapes: [f32; N], shares: [f32; N]) -> (f64, f64) {
    let mut x = shares.map(f64::from);
    let last = (1..N).fold(0, |most, i| if x[i] > x[most] { i } else { most });
    x[last] = 1.0 - (0..N).filter(|i| *i != last).map(|i| x[i]).sum::<f64>();
    let total: f64 = shapes.iter().copied().map(f64::from).sum();
    let (mut ln, mut far) = (-ln_peak(total), 0.0);
    for (&a, x) in shapes.iter().zip(x) {
        let a = f64::from(a);
        let away = (total * x - a) / a;
        let power = a * if away.abs() < 0.1 {
            away.ln_1p()
        } else {
            (total * x / a).ln()
        };
        ln += ln_peak(a) - x.ln() + power;
        far += power.abs();
    }
    (ln, far)
}

#[test]
fn the_density_of_shares_is_that_of_the_formula() {
    fn worst<const N: usize>(seed: u64, number: u32) -> f64 {
        let (mut rng, mut worst) = (Pcg32::new(seed, 4), 0.0_f64);
        let unit = |rng: &mut Pcg32| f64::from(rng.next_u32()) / 4_294_967_296.0;
        for i in 0..number {
            let lowest = if i % 4 == 0 { -30.0 } else { -1.5 };
            let shapes =
                [0; N].map(|_| 10_f64.powf(lowest + (6.0 - lowest) * unit(&mut rng)) as f32);
            let sampler = poly::Dirichlet::new(shapes).unwrap();
            for _ in 0..20 {
                let near = if unit(&mut rng) < 0.7 { 0.2 } else { 1.0 };
                let drawn = sampler.draw(&mut rng).unwrap();
                // Drawn, and moved away.
                let moved = drawn.point.map(|x| {
                    f64::from(x)
                        * (near * (2.0 * unit(&mut rng) - 1.0)
                            / f64::from(sampler.shapes()[0]).max(1.0).sqrt())
                        .exp()
                });
                let sum: f64 = moved.iter().sum();
                let shares = moved.map(|x| (x / sum) as f32);
                let (ln, far) = ln_pdf_of_shares(shapes, shares);
                if !(-87.0..88.0).contains(&ln) || shares.contains(&0.0) {
                    continue;
                }
                let bound = 3e-7 + 1.5e-7 * N as f64 + 2e-10 * far;
                let error = (f64::from(sampler.pdf(shares)) / ln.exp() - 1.0).abs() / bound;
                worst = worst.max(or_infinite(error));
            }
        }
        worst
    }
    assert!(shares::page().contains("relative error of 3e-7 + 1.5e-7 N + 2e-10 Σ α|ln(nx/α)|, where n is Σα, or an absolute one of 2⁻¹⁴⁸"));
    let number = speed::of("sets of shapes", 300, 20_000);
    let all = [
        worst::<2>(1, number),
        worst::<3>(2, number),
        worst::<7>(3, number / 2),
    ];
    println!("{all:.3?} of the bound");
    assert!(all.iter().all(|worst| *worst <= 1.0), "{all:?}");
    // Of whole shapes, without a gamma function; a wrong one is noticed.
    let close = |law: poly::Beta, [x, y]: [f32; 2]| {
        let [x64, y64] = [x, y].map(f64::from);
        let [x64, y64] = if x < y {
            [x64, 1.0 - x64]
        } else {
            [1.0 - y64, y64]
        };
        let exact = 12.0 * x64 * y64 * y64;
        (f64::from(law.pdf([x, y])) / exact - 1.0).abs() <= 6e-7
    };
    for x in [1e-30_f32, 0.125, 0.25, 0.5, 0.75] {
        assert!(close(poly::Beta::new(2.0, 3.0).unwrap(), [x, 1.0 - x]));
        assert!(!close(poly::Beta::new(3.0, 2.0).unwrap(), [x, 1.0 - x]) || x == 0.5);
        assert!(!close(
            poly::Beta::new(2.000_01, 3.0).unwrap(),
            [x, 1.0 - x]
        ));
    }
    let even = poly::Dirichlet::new([1.0; 4]).unwrap();
    assert!((even.pdf([0.1, 0.2, 0.3, 0.4]) - 6.0).abs() < 5e-6);
}
