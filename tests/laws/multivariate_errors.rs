//! The errors of correlated normal numbers in any number of dimensions, with any rank, condition and units; and their subspace.

use host::docs::Doc;
use host::errors::raise;
use host::speed;
use host::truth;
use microwarp::Warp;
use microwarp::tier::{Libm, Poly, Tier};
use microwarp::uniform::LARGEST;
use microwarp::warp::MultivariateNormal;
use rand_core::Rng;
use rand_pcg::Pcg32;
use std::array::from_fn;

/// What rank a matrix has.
#[derive(Clone, Copy, PartialEq)]
pub enum Rank {
    Full,
    Of(usize),
    Any,
}

fn unit(rng: &mut Pcg32) -> f64 {
    f64::from(rng.next_u32()) / 4_294_967_296.0
}

/// A covariance matrix: of rows that are spread over orders of magnitude, or of rows that are nearly equal, in units of up to
/// so many powers of ten.
pub fn matrix<const D: usize>(rng: &mut Pcg32, rank: Rank, units: f64) -> [[f32; D]; D] {
    let rank = match rank {
        Rank::Full => D,
        Rank::Of(rank) => rank,
        Rank::Any => 1 + rng.next_u32() as usize % D,
    };
    let (spread, near) = (3.0 * unit(rng), 10_f64.powf(-3.3 * unit(rng)));
    let alike = rng.next_u32() % 2 > 0;
    let scales: [f64; D] = from_fn(|_| 10_f64.powf(units * (2.0 * unit(rng) - 1.0)));
    let common: [f64; D] = from_fn(|_| 2.0 * unit(rng) - 1.0);
    let rows: [[f64; D]; D] = from_fn(|i| {
        common.map(|common| {
            let entry = 2.0 * unit(rng) - 1.0;
            match alike {
                true if i > 0 => common + near * entry,
                true => common,
                false => entry * 10_f64.powf(-spread * unit(rng)),
            }
        })
    });
    let entry = |i: usize, j: usize| {
        let sum: f64 = (0..rank).map(|k| rows[i][k] * rows[j][k]).sum();
        (sum * scales[i] * scales[j]) as f32
    };
    from_fn(|i| from_fn(|j| entry(i.max(j), i.min(j))))
}

fn mean<const D: usize>(rng: &mut Pcg32, covariance: &[[f32; D]; D]) -> [f32; D] {
    from_fn(|i| match rng.next_u32() % 3 {
        0 => 0.0,
        1 => covariance[i][i].sqrt() * (20.0 * unit(rng) - 10.0) as f32,
        _ => ((2.0 * unit(rng) - 1.0) * 10_f64.powf(20.0 * unit(rng) - 10.0)) as f32,
    })
}

fn uniform(rng: &mut Pcg32) -> f32 {
    let step = |rng: &mut Pcg32| (rng.next_u32() % 64 + 1) as f32 * 2f32.powi(-24);
    match rng.next_u32() % 16 {
        0 => 0.0,
        1 => LARGEST,
        2 => f32::from_bits(rng.next_u32() % 0x3f80_0000),
        3 => 0.5,
        4 => step(rng),
        5 => 1.0 - step(rng),
        _ => (rng.next_u32() >> 8) as f32 * 2f32.powi(-24),
    }
}

/// The statements of the page, in their order.
const STATED: [&str; 5] = [
    "each coordinate of a sample",
    "pdf with the sample",
    "whiten",
    "the logarithm of the density",
    "the density",
];

/// The largest part of each statement that an error reaches.
fn reached<T: Tier, const D: usize>(rounds: usize) -> [f64; 5] {
    let (mut rng, mut most) = (Pcg32::new(D as u64, 9), [0.0; 5]);
    let n = D as f64;
    for round in 0..rounds {
        let covariance = matrix::<D>(&mut rng, Rank::Full, if round % 2 > 0 { 17.0 } else { 2.0 });
        let mean = mean(&mut rng, &covariance);
        let law = MultivariateNormal::<T, D>::new(mean, covariance).unwrap();
        if law.rank() < D {
            continue;
        }
        let exact = truth::MultivariateNormal::new(mean, covariance, law.factor(), law.free());
        assert!(exact.passed_over <= 1.0 + 1e-6, "a smaller share was taken");
        let c = exact.inflation().max(1.0);
        for _ in 0..8 {
            let u: [f32; D] = from_fn(|_| uniform(&mut rng));
            let z = u.map(|u| truth::normal_quantile(u.into()));
            let (x, due) = (law.sample(u), exact.at(z));
            let length = z.iter().map(|z| z * z).sum::<f64>().sqrt().max(1.0);
            for i in 0..D {
                let size = due[i].abs()
                    + f64::from(mean[i].abs())
                    + f64::from(covariance[i][i]).sqrt() * length;
                raise(
                    &mut most[0],
                    (f64::from(x[i]) - due[i]).abs() / size / 3.2e-7,
                );
            }
            let drawn = exact.ln_density(z);
            let on_grid = u.iter().all(|u| *u >= 2f32.powi(-24));
            if on_grid && (-87.0..88.0).contains(&drawn) {
                let (_, density) = law.sample_with_pdf(u);
                let off = (f64::from(density) / drawn.exp() - 1.0).abs();
                raise(&mut most[1], off / (7e-7 + 1.3e-7 * n));
            }
            let z = exact.whiten(x.map(f64::from));
            let q = z.iter().map(|z| z * z).sum::<f64>();
            let own = |libm: f64, poly: f64| if T::NAME == "libm" { libm } else { poly };
            for (found, due) in law.whiten(x).iter().zip(z) {
                let room = own(9e-8 * q.sqrt(), 6e-7 * (c * q).sqrt());
                // Of a point so near to the mean the offset itself is subnormal.
                if q > 1e-12 {
                    raise(&mut most[2], (f64::from(*found) - due).abs() / room);
                }
            }
            let log = exact.ln_density(z);
            let room = 1.1e-7 * (n + 4.0 + log.abs()) + own(2.2e-14 * c * q, 3.5e-7 * c.sqrt() * q);
            raise(&mut most[3], (f64::from(law.ln_pdf(x)) - log).abs() / room);
            if (-87.0..88.0).contains(&log) {
                let off = (f64::from(law.pdf(x)) / log.exp() - 1.0).abs();
                raise(
                    &mut most[4],
                    off / (1.1e-7 * (n + 4.0) + own(2.2e-14 * c * q, 3.5e-7 * c.sqrt() * q)),
                );
            }
        }
    }
    println!("{} {D}: {most:.2?}", T::NAME);
    most
}

#[test]
fn no_dimension_condition_or_unit_costs_more_digits_than_stated() {
    fn of_tier<T: Tier>() {
        let rounds = speed::of("matrices of each dimension", 400, 60_000);
        let all = [
            reached::<T, 1>(rounds),
            reached::<T, 2>(rounds),
            reached::<T, 3>(rounds),
            reached::<T, 6>(rounds / 2),
            reached::<T, 12>(rounds / 8),
        ];
        for (k, what) in STATED.iter().enumerate() {
            let mut most = 0.0;
            for reached in all {
                raise(&mut most, reached[k]);
            }
            println!("{}: {what}: {most:.3} of what is stated", T::NAME);
            assert!((0.3..=1.0).contains(&most), "{}: {what}: {most}", T::NAME);
        }
    }
    of_tier::<Libm>();
    of_tier::<Poly>();
    let page = Doc::find("warp", "MultivariateNormal").unwrap().text();
    for stated in [
        "3.2e-7",
        "7e-7 + 1.3e-7·D",
        "9e-8·√q",
        "6e-7·√(c·q)",
        "1.1e-7·(D + 4 + |ln p|)",
        "2.2e-14·c·q",
        "3.5e-7·√c·q",
    ] {
        assert!(page.contains(stated), "{stated}");
    }
}

/// A Aᵀ is the matrix, of any rank, to a rounding of each entry of A, and to what counts as 0.
fn product_is_the_matrix<const D: usize>(rounds: usize) {
    let mut rng = Pcg32::new(D as u64, 10);
    for _ in 0..rounds {
        let covariance = matrix::<D>(&mut rng, Rank::Any, 17.0);
        let law = MultivariateNormal::<Poly, D>::new([0.0; D], covariance).unwrap();
        let (a, left) = (law.factor(), if law.rank() < D { 1.0 } else { 0.0 });
        for i in 0..D {
            for j in 0..D {
                let made: f64 = (0..D)
                    .map(|k| f64::from(a[i][k]) * f64::from(a[j][k]))
                    .sum();
                let size = |i: usize| f64::from(covariance[i][i].max(f32::MIN_POSITIVE)).sqrt();
                let off = (made - f64::from(covariance[i][j])).abs() / (size(i) * size(j));
                let room = 1.2e-7 + left * 4.0 * 2.4e-7 * D as f64;
                assert!(off <= room, "{off} {i} {j} of {covariance:?}");
            }
        }
    }
}

#[test]
fn the_factor_times_its_transpose_is_the_matrix() {
    let rounds = speed::of("matrices multiplied", 1_000, 100_000);
    product_is_the_matrix::<1>(rounds);
    product_is_the_matrix::<2>(rounds);
    product_is_the_matrix::<3>(rounds);
    product_is_the_matrix::<6>(rounds / 2);
    product_is_the_matrix::<12>(rounds / 8);
}

/// Samples lie on the subspace, and points beside it do not.
fn subspace<T: Tier, const D: usize>(rank: usize, rounds: usize) {
    let (mut rng, mut above) = (Pcg32::new(D as u64, 11), 0);
    for round in 0..rounds {
        let covariance = matrix::<D>(
            &mut rng,
            Rank::Of(rank),
            if round % 2 > 0 { 15.0 } else { 2.0 },
        );
        let mean = mean(&mut rng, &covariance);
        let law = MultivariateNormal::<T, D>::new(mean, covariance).unwrap();
        // Rows that are nearly equal leave rounding that is larger than what counts as 0, but seldom.
        above += usize::from(law.rank() > rank);
        for _ in 0..4 {
            let u: [f32; D] = from_fn(|_| uniform(&mut rng));
            let (x, density) = law.sample_with_pdf(u);
            let (pdf, log) = (law.pdf(x), law.ln_pdf(x));
            assert!(
                pdf > 0.0 && density > 0.0 && log.is_finite(),
                "{x:?} of {covariance:?}"
            );
            let z = law.whiten(x);
            for i in (0..D).filter(|i| !law.free()[*i]) {
                assert_eq!(z[i], 0.0);
                // Far beyond what rounding of any coordinate could do to this one.
                let mut beside = x;
                let reach = (law.factor()[i].iter())
                    .zip(law.factor())
                    .fold(0.0, |sum: f32, (a, _)| sum + a.abs());
                beside[i] +=
                    0.1 * reach + 1e-3 * x[i].abs() + 1e-3 * mean[i].abs() + f32::MIN_POSITIVE;
                let known = (0..D).all(|j| mean[j].abs() <= 100.0 * covariance[j][j].sqrt());
                if known && z.iter().all(|z| z.abs() < 6.0) {
                    assert_eq!(
                        (law.pdf(beside), law.ln_pdf(beside)),
                        (0.0, f32::NEG_INFINITY)
                    );
                }
            }
        }
    }
    println!(
        "{} {D}: {above} of {rounds} matrices of rank {rank} have a larger one",
        T::NAME
    );
    assert!(200 * above <= rounds, "{above} of {rounds}");
    for bad in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
        let law = MultivariateNormal::<T, D>::new([0.0; D], [[1.0; D]; D]).unwrap();
        assert_eq!((law.rank(), law.pdf([bad; D])), (1, 0.0));
        assert!(law.whiten([bad; D]).iter().all(|z| z.is_finite()));
    }
}

#[test]
fn singular_laws_have_a_density_on_their_subspace_alone() {
    fn of_tier<T: Tier>() {
        let rounds = speed::of("singular matrices", 400, 60_000);
        subspace::<T, 2>(1, rounds);
        subspace::<T, 3>(1, rounds);
        subspace::<T, 3>(2, rounds);
        subspace::<T, 6>(4, rounds / 4);
        subspace::<T, 12>(9, rounds / 16);
    }
    of_tier::<Libm>();
    of_tier::<Poly>();
}
