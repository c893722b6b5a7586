//! The ends of what can be pushed: counts at their limit, and any bits at all.

use microwarp::estimate::{Integral, Moments, WeightedMean};
use microwarp::uniform;
use rand_pcg::Pcg32;
use rand_pcg::rand_core::Rng;

fn moments(samples: &[f32]) -> Moments {
    let mut moments = Moments::new();
    samples.iter().for_each(|&x| moments.push(x));
    moments
}

/// Everything finite that can be asked.
fn assert_finite(moments: &Moments) {
    for figure in [
        moments.mean(),
        moments.variance(),
        moments.population_variance(),
        moments.std_dev(),
        moments.standard_error(),
    ] {
        assert!(figure.is_none_or(f32::is_finite), "{moments:?}: {figure:?}");
    }
    for spread in [moments.variance(), moments.standard_error()]
        .into_iter()
        .flatten()
    {
        assert!(spread >= 0.0, "{moments:?}");
    }
}

#[test]
fn the_count_stops_at_its_limit() {
    // Doubling 63 times gives half of what fits; then one less than the limit, and the limit.
    let weighted = |samples: &[f32]| {
        let mut ratio = WeightedMean::new();
        samples.iter().for_each(|&x| ratio.push(x, 1.0));
        ratio
    };
    let (mut half, mut ratio) = (moments(&[1.0, 3.0]), weighted(&[1.0, 3.0]));
    let (mut parts, mut ratios) = (moments(&[2.0]), weighted(&[2.0]));
    for _ in 1..63 {
        parts.merge(&half);
        half.merge(&half.clone());
        ratios.merge(&ratio);
        ratio.merge(&ratio.clone());
    }
    assert_eq!((half.count(), ratio.count()), (1 << 63, 1 << 63));
    assert_eq!(
        (parts.count(), ratios.count()),
        ((1 << 63) - 1, (1 << 63) - 1)
    );
    let (mut full, mut full_ratio) = (half, ratio);
    full.merge(&parts);
    full_ratio.merge(&ratios);
    assert_eq!((full.count(), full_ratio.count()), (u64::MAX, u64::MAX));
    assert_eq!((full.mean(), full.variance()), (Some(2.0), Some(1.0)));
    assert_eq!(full_ratio.mean(), Some(2.0));
    let error = full_ratio.standard_error().unwrap();
    assert!((error * 2f32.powi(32) - 1.0).abs() <= 1e-6, "{error}");

    full.push(1000.0);
    full_ratio.push(1000.0, 1.0);
    assert_eq!(
        (full.count(), full.refused(), full.mean()),
        (u64::MAX, 1, Some(2.0))
    );
    assert_eq!((full_ratio.count(), full_ratio.refused()), (u64::MAX, 1));
    half.merge(&half.clone());
    ratio.merge(&ratio.clone());
    assert_eq!((half.count(), half.refused()), (1 << 63, 1 << 63));
    assert_eq!((ratio.count(), ratio.refused()), (1 << 63, 1 << 63));
    full.merge(&full.clone());
    full.merge(&full.clone());
    assert_eq!(
        (full.refused(), full.mean(), full.variance()),
        (u64::MAX, Some(2.0), Some(1.0))
    );
    full.push(f32::NAN);
    assert_eq!(full.refused(), u64::MAX);
}

#[test]
fn any_bits_at_all_give_finite_figures() {
    let mut rng = Pcg32::new(71, 54);
    let any = |rng: &mut Pcg32| f32::from_bits(rng.next_u32());
    for _ in 0..200_000 {
        let n = (6.0 * uniform::grid(&mut rng)) as usize;
        let (mut a, mut b) = (Moments::new(), Moments::new());
        let (mut c, mut d) = (WeightedMean::new(), WeightedMean::new());
        let mut integral = Integral::new();
        for _ in 0..n {
            let [x, y, z, w] = [(); 4].map(|()| any(&mut rng));
            a.push(x);
            b.push(y);
            c.push(x, z);
            d.push(y, w);
            integral.push(x, y);
        }
        a.merge(&b);
        c.merge(&d);
        assert_eq!(a.count() + a.refused(), 2 * n as u64);
        assert_eq!(c.count() + c.refused(), 2 * n as u64);
        assert_eq!(integral.count() + integral.refused(), n as u64);
        assert_finite(&a);
        assert_finite(integral.moments());
        for figure in [c.mean(), c.standard_error()].into_iter().flatten() {
            assert!(figure.is_finite(), "{c:?}: {figure}");
        }
        assert!(integral.chebyshev_bound(0.01).unwrap() >= 0.0);
    }
}
