//! `Mixture`: which part a word picks and what is left of the word, by whole numbers; its density, its inverse, and what it refuses.
//! Wrong mixtures are rejected by the same checks.

mod choice;
mod inverse;

use host::errors::or_infinite;
use host::speed;
use microwarp::discrete::Mixture;
use microwarp::uniform::{Canonical, LARGEST, SMALLEST, grid};
use microwarp::warp::{Interval, Length, Measured, Product};
use microwarp::{Warp, libm, poly as mw};
use rand_core::TryRng;
use rand_pcg::Pcg32;
use rand_pcg::rand_core::Rng;

/// The uniform itself, with densities to choose; none may be asked for where there is a `None`.
#[derive(Clone, Copy, Debug)]
struct Known {
    density: Option<f32>,
    with_sample: f32,
}

fn known(density: f32) -> Known {
    Known {
        density: Some(density),
        with_sample: density,
    }
}

impl Warp for Known {
    type Uniforms = f32;
    type Point = f32;
    type Density = f32;

    fn sample_canonical(&self, u: Canonical<f32>) -> f32 {
        u.get()
    }
    fn pdf(&self, _: f32) -> f32 {
        self.density.expect("this density is never asked for")
    }
    fn sample_canonical_with_pdf(&self, u: Canonical<f32>) -> (f32, f32) {
        (u.get(), self.with_sample)
    }
    fn try_draw_with_pdf<R: TryRng + ?Sized>(&self, rng: &mut R) -> Result<(f32, f32), R::Error> {
        Ok((self.try_draw(rng)?, self.with_sample))
    }
}

impl Measured for Known {
    type Measure = Length;
}

/// Uniform in unit intervals from 0 on, each by its weight.
fn steps<const N: usize>(weights: [f32; N]) -> Mixture<[Interval; N], N>
where
    [Interval; N]: microwarp::discrete::Parts<N>,
{
    let parts = std::array::from_fn(|i| Interval::new(i as f32, i as f32 + 1.0).unwrap());
    Mixture::new(parts, &weights).unwrap()
}

// The density of a mixture: the sum that it stands for, at every magnitude.

#[test]
fn a_part_of_weight_zero_is_not_asked() {
    let silent = Known {
        density: None,
        with_sample: f32::NAN,
    };
    let mixture = Mixture::new([silent, known(3.0), silent], &[0.0, 2.0, 0.0]).unwrap();
    assert_eq!(mixture.pdf(0.5), 3.0);
    assert_eq!(mixture.sample_with_pdf(0.25), (0.25, 3.0));
    // Its own density is not asked for with a sample, either.
    let own = Known {
        density: None,
        with_sample: 5.0,
    };
    let mixture = Mixture::new((own, known(3.0)), &[1.0, 3.0]).unwrap();
    assert_eq!(mixture.sample_with_pdf(0.125), (0.5, 3.5));
    let (_, density) = mixture.draw_with_pdf(&mut crate::Given(&[0x2000_0000]));
    assert_eq!(density, 3.5);
}

#[test]
fn no_density_leaves_the_range() {
    let of = |densities: [f32; 3], weights| {
        let mixture = Mixture::new(densities.map(known), &weights).unwrap();
        let (density, (_, with_sample)) = (mixture.pdf(0.5), mixture.sample_with_pdf(LARGEST));
        assert_eq!(density.to_bits(), with_sample.to_bits());
        density
    };
    let equal = [1.0; 3];
    // The rounded thirds have a sum above 1.
    assert_eq!(of([f32::MAX; 3], equal), f32::MAX);
    assert_eq!(of([f32::INFINITY, 1.0, 1.0], equal), f32::MAX);
    assert_eq!(of([0.0, 0.0, f32::MAX], equal), f32::MAX * (1.0 / 3.0));
    // A third of the smallest number rounds to 0.
    assert_eq!(of([0.0, 0.0, SMALLEST], equal), SMALLEST);
    assert_eq!(of([0.0, SMALLEST, 0.0], [1.0, 1e-9, 1.0]), SMALLEST);
    assert_eq!(of([0.0; 3], equal), 0.0);
    assert_eq!(of([f32::NAN, 0.0, 0.0], equal), 0.0);
    assert_eq!(of([f32::NAN, -1.0, 3.0], equal), 1.0);
    // The order of the sum is that of the parts.
    let [a, b, c] = [1.0_f32, 3e-8, 3e-8];
    let sum = 0.25 * a + 0.25 * b + 0.5 * c;
    assert_eq!(of([a, b, c], [1.0, 1.0, 2.0]), sum);
}

/// Of lobes, by `f64` from the densities of the parts.
#[test]
fn the_density_is_the_sum_of_its_parts() {
    let peaks = [0.0, 0.7, -0.9, 0.999].map(|g| libm::HenyeyGreenstein::new(g).unwrap());
    let weights = [1.0, 2.0, 0.5, 1e-6];
    let mixture = Mixture::new(peaks, &weights).unwrap();
    // The probabilities with which parts are picked, and those of the weights as they were given.
    let picked = [0, 1, 2, 3].map(|i| mixture.numerator(i) as f64 / 2.0_f64.powi(32));
    let given = weights.map(|w| f64::from(w) / weights.map(f64::from).iter().sum::<f64>());
    let off = |density: f32, shares: [f64; 4], x: [f32; 3]| {
        let parts = shares.into_iter().zip(peaks);
        let exact: f64 = parts.map(|(q, peak)| q * f64::from(peak.pdf(x))).sum();
        or_infinite((f64::from(density) / exact - 1.0).abs())
    };
    let mut rng = Pcg32::new(2, 3);
    let pole = [0.0, 0.0, 1.0];
    let mut worst = [picked, picked, given].map(|shares| off(mixture.pdf(pole), shares, pole));
    for _ in 0..speed::of("densities", 20_000, 1_000_000) {
        let u = [grid(&mut rng), grid(&mut rng)];
        let (x, with_sample) = mixture.sample_with_pdf(u);
        let density = mixture.pdf(x);
        for (worst, off) in worst.iter_mut().zip([
            off(density, picked, x),
            off(with_sample, picked, x),
            off(density, given, x),
        ]) {
            *worst = worst.max(off);
        }
        assert!(density > 0.0);
    }
    println!("density, with the sample, and by the weights as given: {worst:?}");
    assert!(worst[0] <= 3e-7 && worst[1] <= 4e-6, "{worst:?}");
    assert!(worst[2] > 3e-6, "{worst:?}");
}

/// Over all words of 16 bits: the mean of f/p is the integral of f.
#[test]
fn estimates_by_a_mixture_are_not_biased() {
    let mixture = steps([1.0, 4.0, 3.0]);
    let f = |x: f32| f64::from(1.0 + x * x);
    let mean = |density: &dyn Fn(f32) -> f32| {
        let of = |k: u32| {
            let x = mixture.sample_words(k << 16 | 0x8000);
            f(x) / f64::from(density(x))
        };
        (0..1 << 16).map(of).sum::<f64>() / 65_536.0
    };
    let exact = 3.0 + 9.0;
    let (right, own) = (
        mean(&|x| mixture.pdf(x)),
        mean(&|x| mixture.parts()[x as usize].pdf(x)),
    );
    println!("{right}, by the density of the part alone {own}");
    assert!((right / exact - 1.0).abs() <= 1e-4, "{right}");
    assert!((own / exact - 1.0).abs() > 1e-2, "{own}");
}

/// Points outside, and points with a part alone.
#[test]
fn parts_count_where_they_are() {
    let mixture = steps([1.0, 4.0, 3.0]);
    for (x, density) in [
        (-0.5, 0.0),
        (0.5, 0.125),
        (1.5, 0.5),
        (2.5, 0.375),
        (3.5, 0.0),
    ] {
        assert_eq!(mixture.pdf(x), density);
    }
    assert_eq!(mixture.pdf(f32::NAN), 0.0);
    // Mixtures of products, of mixtures and of references.
    let half = Interval::new(0.0, 0.5).unwrap();
    let pair = Product::new(half, half);
    let pairs = Mixture::new([pair; 2], &[1.0, 2.0]).unwrap();
    let nested = Mixture::new((&pairs, &pair), &[1.0, 1.0]).unwrap();
    let (x, density) = nested.sample_with_pdf((0.3, 0.7));
    assert!((density / 4.0 - 1.0).abs() <= 1e-6 && x.0 < 0.5 && x.1 < 0.5);
    let directions = Mixture::new(
        (mw::CosineHemisphere::new(), mw::Sphere::new()),
        &[1.0, 1.0],
    );
    let up = directions.unwrap().pdf([0.0, 0.0, 1.0]);
    assert!((up * core::f32::consts::TAU / 1.25 - 1.0).abs() <= 1e-6);
    let mut rng = Pcg32::new(1, 2);
    assert!(directions.unwrap().sample_words([rng.next_u32(); 2])[2].abs() <= 1.0);
}
