//! `Beta` and `Dirichlet`: shares of the gamma numbers of the same words, their law and their refusals.

use host::docs::Doc;
use host::errors::or_infinite;
use host::{speed, stats};
use microwarp::rejection::{Dirichlet, Gamma, Rejection};
use microwarp::tier::{Libm, Poly, Tier};
use microwarp::{Error, poly};
use rand_pcg::Pcg32;
use statrs::function::beta::beta_reg;

pub fn page() -> String {
    let text = Doc::find("rejection", "Dirichlet").unwrap().text();
    text.replace("\n/// ", " ")
}

/// A draw takes the words of gamma numbers in a row.
#[test]
fn shares_are_those_of_gamma_numbers() {
    fn worst<T: Tier, const N: usize>(shapes: [f32; N], seed: u64) -> f64 {
        let sampler = Dirichlet::<T, N>::new(shapes).unwrap();
        let (mut rng, mut again) = (Pcg32::new(seed, 1), Pcg32::new(seed, 1));
        let mut worst = 0.0_f64;
        for _ in 0..speed::of("draws of shares", 2000, 50_000) {
            let drawn = sampler.draw(&mut rng).unwrap();
            let (mut tries, mut forked) = (0, again.clone());
            let parts = shapes.map(|shape| {
                let one = Gamma::<T>::new(shape, 1.0).unwrap();
                let number = one.draw(&mut forked).unwrap();
                tries += number.tries;
                (number.point, one.draw_ln(&mut again).unwrap().point)
            });
            assert_eq!((drawn.tries, &forked), (tries, &again));
            let logarithms = parts.iter().any(|(number, _)| *number < 2_f32.powi(-80));
            let values = parts.map(|(number, ln)| {
                if logarithms {
                    f64::from(ln)
                } else {
                    f64::from(number).ln()
                }
            });
            let most = values.iter().copied().fold(f64::MIN, f64::max);
            let sum: f64 = values.iter().map(|ln| (ln - most).exp()).sum();
            for (share, ln) in drawn.point.iter().zip(values) {
                let exact = (ln - most).exp() / sum;
                let below = if logarithms { most - ln } else { 0.0 };
                let bound = (N as f64 + 4.0 + below) * 2_f64.powi(-24) * exact;
                let error = (f64::from(*share) - exact).abs() / (bound + 1.01 * 2_f64.powi(-149));
                worst = worst.max(or_infinite(error));
                assert!(*share > 0.0 && *share <= 1.0);
            }
            assert!(sampler.pdf(drawn.point) > 0.0, "{drawn:?}");
        }
        assert_eq!(rng, again);
        worst
    }
    assert!(page().contains("relative error of (N + 4 + l) 2⁻²⁴, plus an absolute one of 2⁻¹⁴⁹"));
    let all = [
        worst::<Poly, 2>([1e-3, 1e-3], 1),
        worst::<Poly, 2>([1e-30, 1e6], 2),
        worst::<Poly, 2>([2.0, 5.0], 3),
        worst::<Libm, 2>([0.5, 3.0], 4),
        worst::<Libm, 3>([1.0, 1.0, 7.5], 5),
        worst::<Poly, 8>([0.1, 0.2, 0.4, 1.0, 2.0, 4.0, 8.0, 16.0], 6),
        worst::<Poly, 40>([3.0; 40], 7),
        worst::<Poly, 1>([0.2], 8),
    ];
    println!("{all:.3?} of the bound");
    assert!(all.iter().all(|worst| *worst <= 1.0), "{all:?}");
}

/// The p-value of a share, and of its part of the first two.
fn p_values<const N: usize>(points: &[[f32; N]], shapes: [f32; N]) -> Vec<f64> {
    let total: f64 = shapes.iter().copied().map(f64::from).sum();
    let mut all = Vec::new();
    for i in 0..N {
        let a = f64::from(shapes[i]);
        let mut uniforms: Vec<f64> = points
            .iter()
            .map(|point| {
                // From the nearer end, so that the digits of the rest count.
                if point[i] < 0.5 {
                    beta_reg(a, total - a, point[i].into())
                } else {
                    let rest: f64 = (0..N)
                        .filter(|j| *j != i)
                        .map(|j| f64::from(point[j]))
                        .sum();
                    1.0 - beta_reg(total - a, a, rest)
                }
            })
            .collect();
        all.push(stats::p_value_of_uniforms(&mut uniforms));
    }
    if N > 2 {
        let part = |p: &[f32; N]| {
            beta_reg(
                shapes[0].into(),
                shapes[1].into(),
                f64::from(p[0]) / (f64::from(p[0]) + f64::from(p[1])),
            )
        };
        let mut uniforms: Vec<f64> = points.iter().map(part).collect();
        all.push(stats::p_value_of_uniforms(&mut uniforms));
    }
    all
}

#[test]
fn shares_have_the_law() {
    fn holds<const N: usize>(shapes: [f32; N], seed: u64) {
        let number = speed::of("drawn shares", 10_000, 500_000);
        let (sampler, mut rng) = (poly::Dirichlet::new(shapes).unwrap(), Pcg32::new(seed, 2));
        let points: Vec<_> = (0..number)
            .map(|_| sampler.draw(&mut rng).unwrap().point)
            .collect();
        let (name, threshold) = (format!("{shapes:?}"), stats::threshold(60));
        stats::assert_passes(&name, &p_values(&points, shapes), threshold);
        // The controls: the first two swapped, and the first shape a few percent larger.
        let mut other = shapes;
        other.swap(0, 1);
        if shapes[0] != shapes[1] {
            stats::assert_rejected(&name, &p_values(&points, other), threshold);
        }
        other = shapes;
        other[0] *= speed::of("factor of a wrong share", 1.16, 1.08);
        stats::assert_rejected(&name, &p_values(&points, other), threshold);
    }
    holds([0.05, 0.05], 1);
    holds([0.5, 0.5], 2);
    holds([0.5, 3.0], 3);
    holds([2.0, 5.0], 4);
    holds([1e4, 30.0], 5);
    holds([1.0, 2.5], 6);
    holds([0.1, 2.0, 30.5, 1.0], 7);
    holds([3.0, 4.0, 5.0], 18);
}

/// With shapes of a thousandth one share is nearly everything, each as often as the others; nothing is 0/0.
#[test]
fn small_shapes_choose_one_share() {
    let (sampler, mut rng) = (poly::Dirichlet::new([1e-3; 3]).unwrap(), Pcg32::new(3, 3));
    let number = speed::of("draws of small shapes", 30_000, 1_000_000);
    let mut chosen = [0_u64; 3];
    for _ in 0..number {
        let point = sampler.draw(&mut rng).unwrap().point;
        assert!(point.iter().all(|x| *x > 0.0 && *x <= 1.0));
        if let Some(i) = point.iter().position(|x| *x > 0.5) {
            chosen[i] += 1;
        }
    }
    let spread = (f64::from(number) * 2.0 / 9.0).sqrt();
    for count in chosen {
        assert!(
            (count as f64 - f64::from(number) / 3.0).abs()
                < 6.0 * spread + 0.002 * f64::from(number)
        );
    }
    // Near 1 the rest has its own digits.
    let (pair, mut rest) = (poly::Beta::new(0.05, 0.05).unwrap(), 1.0_f32);
    for _ in 0..10_000 {
        let [x, y] = pair.draw(&mut rng).unwrap().point;
        assert!(x + y == 1.0 || (x + y - 1.0).abs() < 2e-7);
        rest = if x == 1.0 { rest.min(y) } else { rest };
    }
    assert!(rest < 1e-30, "{rest}");
}

#[test]
fn points_and_parameters_out_of_range_are_refused() {
    let pair = poly::Beta::new(2.0, 3.0).unwrap();
    for point in [
        [0.5, 0.6],
        [-0.1, 1.1],
        [1.1, -0.1],
        [f32::NAN, 0.5],
        [0.5, f32::NAN],
        [f32::INFINITY, 0.5],
        [f32::INFINITY, f32::NEG_INFINITY],
        [0.0, 0.0],
    ] {
        assert_eq!(pair.pdf(point), 0.0, "{point:?}");
    }
    type Reason = fn(usize) -> Error;
    let refused: [(f32, Reason); 6] = [
        (f32::NAN, Error::NotFinite),
        (f32::INFINITY, Error::NotFinite),
        (0.0, Error::NotPositive),
        (-1.0, Error::NotPositive),
        (1e-31, Error::OutOfRange),
        (1.1e6, Error::OutOfRange),
    ];
    for (bad, error) in refused {
        assert_eq!(poly::Beta::new(bad, 1.0), Err(error(0)), "{bad}");
        assert_eq!(poly::Beta::new(1.0, bad), Err(error(1)), "{bad}");
        let three = poly::Dirichlet::new([1.0, 2.0, bad]);
        assert_eq!(three, Err(error(0)), "{bad}");
    }
    assert_eq!(pair.shapes(), [2.0, 3.0]);
    assert_eq!((pair.budget(), poly::Dirichlet::<5>::BUDGET), (32, 80));
    assert_eq!(pair.with_budget(0), Err(Error::NotPositive(0)));
}
