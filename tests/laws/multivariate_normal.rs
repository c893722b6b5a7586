//! Correlated normal numbers: their law, their subspace, what is refused, and what scales and orders leave alone.

use super::multivariate_errors::{Rank, matrix};
use host::generators::Counting;
use host::speed;
use host::stats::{assert_passes, assert_rejected, p_value_of_uniforms, threshold, two_sided};
use host::truth;
use microwarp::Error::{self, *};
use microwarp::tier::{Libm, Poly, Tier};
use microwarp::uniform::grid;
use microwarp::warp::{Each, MultivariateNormal, Normal};
use microwarp::{Invert, Warp};
use rand_core::Rng;
use rand_pcg::Pcg32;
use statrs::distribution::{ChiSquared, ContinuousCDF};
use std::array::from_fn;

const MEAN: [f32; 3] = [1.0, -2.0, 0.5];
/// The second coordinate is eliminated last: the pivots are not in order.
const COVARIANCE: [[f32; 3]; 3] = [[4.0, 1.8, 0.5], [1.8, 1.0, -0.25], [0.5, -0.25, 2.0]];

fn exact<const D: usize>(
    mean: [f32; D],
    covariance: [[f32; D]; D],
) -> truth::MultivariateNormal<D> {
    let law = MultivariateNormal::<Poly, D>::new(mean, covariance).unwrap();
    truth::MultivariateNormal::new(mean, covariance, law.factor(), law.free())
}

/// p-values of points under the law: of the squares of their z, of which the means should be those of the identity, and of |z|².
fn p_values(exact: &truth::MultivariateNormal<3>, draw: &mut dyn FnMut() -> [f64; 3]) -> Vec<f64> {
    let n = speed::of("points of correlated numbers", 60_000, 2_000_000);
    let chi = ChiSquared::new(3.0).unwrap();
    let (mut sums, mut products, mut distances) = ([0.0; 3], [[0.0; 3]; 3], Vec::new());
    for _ in 0..n {
        let z = exact.whiten(draw());
        for ((sum, row), a) in sums.iter_mut().zip(&mut products).zip(z) {
            *sum += a;
            row.iter_mut()
                .zip(z)
                .for_each(|(product, b)| *product += a * b);
        }
        distances.push(chi.cdf(z.iter().map(|z| z * z).sum()));
    }
    let scale = f64::from(n).sqrt();
    let mut found = vec![p_value_of_uniforms(&mut distances)];
    found.extend(sums.map(|sum| two_sided(sum / scale)));
    for (i, row) in products.iter().enumerate() {
        for (j, product) in row.iter().enumerate().take(i + 1) {
            let (due, spread) = if i == j {
                (1.0, 2_f64.sqrt())
            } else {
                (0.0, 1.0)
            };
            found.push(two_sided((product / f64::from(n) - due) * scale / spread));
        }
    }
    found
}

#[test]
fn samples_have_the_mean_and_the_covariance() {
    let exact = exact(MEAN, COVARIANCE);
    assert_eq!(exact.order, [0, 2, 1]);
    let limit = threshold(20);
    fn drawn<T: Tier>(exact: &truth::MultivariateNormal<3>) -> Vec<f64> {
        let law = MultivariateNormal::<T, 3>::new(MEAN, COVARIANCE).unwrap();
        assert_eq!((law.mean(), law.rank()), (MEAN, 3));
        let mut rng = Pcg32::new(3, 4);
        p_values(exact, &mut || law.draw(&mut rng).map(f64::from))
    }
    assert_passes("libm", &drawn::<Libm>(&exact), limit);
    assert_passes("poly", &drawn::<Poly>(&exact), limit);
    // Wrong factors: an off-diagonal 2 % off, the transpose, and rows in the order of elimination.
    let right = exact.factor;
    let (mut off, mut permuted) = (right, right);
    off[1][0] *= 1.02;
    permuted.swap(1, 2);
    let transposed = from_fn(|i| from_fn(|j| right[j][i]));
    for (what, wrong) in [
        ("an entry that is 2 % off", off),
        ("a transpose", transposed),
        ("rows in another order", permuted),
    ] {
        let mut rng = Pcg32::new(3, 4);
        let map = truth::MultivariateNormal {
            mean: exact.mean,
            factor: wrong,
            order: exact.order.clone(),
            passed_over: 0.0,
        };
        let mut draw = || {
            let u = from_fn(|_| (f64::from(rng.next_u32()) + 0.5) / 4_294_967_296.0);
            map.point(u)
        };
        assert_rejected(what, &p_values(&exact, &mut draw), limit);
    }
}

/// The determinant and the inverse of Hilbert's matrix of four rows are integers, and so is 420 times the matrix.
#[test]
fn the_density_is_that_of_the_inverse_and_the_determinant() {
    let inverse = [
        [16.0, -120.0, 240.0, -140.0],
        [-120.0, 1200.0, -2700.0, 1680.0],
        [240.0, -2700.0, 6480.0, -4200.0],
        [-140.0, 1680.0, -4200.0, 2800.0],
    ];
    let matrix = from_fn(|i| from_fn(|j| 420.0 / (i + j + 1) as f32));
    let determinant: f64 = 420_f64.powi(4) / 6_048_000.0;
    let mean = [1.0, 2.0, 3.0, 4.0];
    fn of_tier<T: Tier>(
        mean: [f32; 4],
        matrix: [[f32; 4]; 4],
        due: impl Fn([f32; 4]) -> f64,
    ) -> f64 {
        let law = MultivariateNormal::<T, 4>::new(mean, matrix).unwrap();
        let (mut rng, mut worst) = (Pcg32::new(5, 6), 0.0_f64);
        for _ in 0..2_000 {
            let x = law.draw(&mut rng);
            let (due, found) = (due(x), f64::from(law.ln_pdf(x)));
            assert!((f64::from(law.pdf(x)) / due.exp() - 1.0).abs() <= 1e-3);
            worst = worst.max((found - due).abs());
        }
        worst
    }
    let due = |x: [f32; 4]| {
        let t: [f64; 4] = from_fn(|i| f64::from(x[i]) - f64::from(mean[i]));
        let terms = (0..16).map(|k| t[k / 4] * inverse[k / 4][k % 4] * t[k % 4] / 420.0);
        -0.5 * (terms.sum::<f64>() + determinant.ln()) - 2.0 * std::f64::consts::TAU.ln()
    };
    let (libm, poly) = (
        of_tier::<Libm>(mean, matrix, due),
        of_tier::<Poly>(mean, matrix, due),
    );
    println!("of Hilbert's matrix: {libm:.1e} {poly:.1e}");
    assert!(libm <= 4e-6 && poly <= 3e-4);
}

#[test]
fn a_diagonal_is_normal_numbers_side_by_side() {
    let deviations = [0.5, 2.0, 3.0];
    let covariance = from_fn(|i| {
        from_fn(|j| {
            if i == j {
                deviations[i] * deviations[i]
            } else {
                0.0
            }
        })
    });
    let law = MultivariateNormal::<Poly, 3>::new(MEAN, covariance).unwrap();
    let each = Each::new(from_fn(|i| {
        Normal::<Poly>::new(MEAN[i], deviations[i]).unwrap()
    }));
    let mut rng = Pcg32::new(1, 2);
    for _ in 0..2_000 {
        let u = from_fn(|_| grid(&mut rng));
        assert_eq!(law.sample(u), each.sample(u));
        let (x, density) = law.sample_with_pdf(u);
        assert!((density / each.pdf(x) - 1.0).abs() <= 2e-5);
        assert!((law.pdf(x) / each.pdf(x) - 1.0).abs() <= 2e-5);
        let (a, b) = (law.invert(x), each.invert(x));
        assert!(a.iter().zip(b).all(|(a, b)| (a - b).abs() <= 4e-7));
    }
    let (mut one, mut other) = (Counting::new(Pcg32::new(1, 1)), Pcg32::new(1, 1));
    assert_eq!((law.draw(&mut one), one.words), (each.draw(&mut other), 3));
    let (x, density) = law.draw_with_pdf(&mut Pcg32::new(1, 1));
    assert!(x == each.draw(&mut Pcg32::new(1, 1)) && (density / law.pdf(x) - 1.0).abs() <= 1e-5);
}

/// Units of powers of two change no digit.
#[test]
fn units_change_no_digit() {
    let mut rng = Pcg32::new(7, 8);
    for _ in 0..speed::of("matrices in other units", 300, 20_000) {
        let covariance = matrix::<4>(&mut rng, Rank::Any, 0.0);
        let shifts: [i32; 4] = from_fn(|_| (rng.next_u32() % 40) as i32 - 20);
        let by = |k: i32| 2f32.powi(k);
        let other = from_fn(|i| from_fn(|j| covariance[i][j] * by(shifts[i]) * by(shifts[j])));
        let here = MultivariateNormal::<Libm, 4>::new([0.0; 4], covariance).unwrap();
        let there = MultivariateNormal::<Libm, 4>::new([0.0; 4], other).unwrap();
        let u = from_fn(|_| grid(&mut rng));
        let x = here.sample(u);
        let y: [f32; 4] = from_fn(|i| x[i] * by(shifts[i]));
        assert_eq!(there.sample(u), y);
        assert_eq!(
            (there.whiten(y), there.free()),
            (here.whiten(x), here.free())
        );
    }
}

#[test]
fn what_is_no_covariance_is_refused() {
    fn of<const D: usize>(covariance: [[f32; D]; D]) -> Result<usize, Error> {
        let made = MultivariateNormal::<Poly, D>::new([0.0; D], covariance);
        made.map(|law| law.rank())
    }
    let (nan, infinite) = (f32::NAN, f32::INFINITY);
    assert_eq!(of::<0>([]), Err(Empty(Error::NO_PLACE)));
    assert_eq!(
        MultivariateNormal::<Poly, 1>::new([nan], [[1.0]]),
        Err(NotFinite(0))
    );
    assert_eq!(
        MultivariateNormal::<Poly, 1>::new([-infinite], [[1.0]]),
        Err(NotFinite(0))
    );
    for bad in [nan, infinite, -infinite] {
        assert_eq!(of([[1.0, bad], [0.0, 1.0]]), Err(NotFinite(1)));
        assert_eq!(of([[1.0, 0.0], [0.0, bad]]), Err(NotFinite(1)));
    }
    assert_eq!(of([[-1e-6, 0.0], [0.0, 1.0]]), Err(Negative(1)));
    assert_eq!(of([[1.0, 0.5], [0.4, 1.0]]), Err(OutOfRange(1)));
    assert_eq!(of([[1.0, 3e38], [0.0, 1.0]]), Err(OutOfRange(1)));
    assert_eq!(of([[1.0, 3e38], [3e38, 1.0]]), Err(NotNormalizable(1)));
    assert_eq!(of([[1.0, 1.001], [1.001, 1.0]]), Err(NotNormalizable(1)));
    assert_eq!(of([[0.0, 0.1], [0.1, 1.0]]), Err(NotNormalizable(1)));
    assert_eq!(of([[0.0, 1e-30], [1e-30, 0.0]]), Err(NotNormalizable(1)));
    // Each pair of three is correlated, but all are not to the opposite of all.
    let three = |r: f32| [[1.0, r, r], [r, 1.0, r], [r, r, 1.0]];
    assert_eq!(of(three(-0.5)), Ok(2));
    assert_eq!(
        (of(three(-0.51)), of(three(-0.49))),
        (Err(NotNormalizable(1)), Ok(3))
    );
    // Rounding makes such of one that is symmetric and semi-definite: in steps of 2^-23 beyond 1, and of a half.
    let step = f32::EPSILON;
    assert_eq!(of([[1.0, 1.0 + 2.0 * step], [1.0 - step, 1.0]]), Ok(1));
    assert_eq!(of([[1.0, 0.5 + 4.0 * step], [0.5, 1.0]]), Ok(2));
    assert_eq!(
        of([[1.0, 0.5 + 40.0 * step], [0.5, 1.0]]),
        Err(OutOfRange(1))
    );
    assert_eq!(
        of([[1.0, 1.0 + 40.0 * step], [1.0 + 40.0 * step, 1.0]]),
        Err(NotNormalizable(1))
    );
    assert_eq!(of([[0.0; 3]; 3]), Ok(0));
    assert_eq!(of([[1e-38, 0.0], [0.0, 3e38]]), Ok(2));
}
