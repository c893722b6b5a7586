//! The ends: no samples, one, numbers at both ends of f32, and what is no number.

use microwarp::Error;
use microwarp::estimate::{Integral, Moments, WeightedMean};
use microwarp::tier::{Libm, Poly};

fn moments(samples: &[f32]) -> Moments {
    let mut moments = Moments::new();
    samples.iter().for_each(|&x| moments.push(x));
    moments
}

#[test]
fn nothing_and_one_sample_are_told_apart() {
    let none = Moments::new();
    assert_eq!(none, Moments::default());
    assert_eq!((none.count(), none.refused(), none.mean()), (0, 0, None));
    assert_eq!((none.variance(), none.population_variance()), (None, None));
    assert_eq!((none.std_dev(), none.standard_error()), (None, None));
    for x in [0.0, -2.5, f32::MAX, -f32::MAX, 1e-45, f32::MIN_POSITIVE] {
        let one = moments(&[x]);
        assert_eq!(
            (one.mean(), one.population_variance()),
            (Some(x), Some(0.0))
        );
        assert_eq!((one.variance(), one.standard_error()), (None, None));
        let (mut left, mut right) = (one, none);
        left.merge(&none);
        right.merge(&one);
        assert_eq!((left, right), (one, one));
    }
    let integral = Integral::new();
    assert_eq!(
        (integral.estimate(), integral.standard_error()),
        (None, None)
    );
    let one_sample = |mut integral: Integral| {
        integral.push(1.0, 0.5);
        integral
    };
    for integral in [integral, one_sample(integral)] {
        assert_eq!(integral.chebyshev_bound(0.5), Ok(f32::MAX));
        assert_eq!(integral.normal_bound::<Poly>(0.5), Ok(f32::MAX));
    }
    assert_eq!(one_sample(integral).estimate(), Some(2.0));
    let ratio = WeightedMean::new();
    assert_eq!(ratio, WeightedMean::default());
    assert_eq!((ratio.mean(), ratio.standard_error()), (None, None));
    let mut ratio = WeightedMean::new();
    ratio.push(7.0, 0.1);
    assert_eq!((ratio.mean(), ratio.standard_error()), (Some(7.0), None));
}

#[test]
fn both_ends_of_f32_are_right_or_saturate() {
    let ends = moments(&[f32::MAX, -f32::MAX]);
    assert_eq!(ends.mean(), Some(0.0));
    assert_eq!(ends.variance(), Some(f32::MAX));
    assert_eq!(ends.population_variance(), Some(f32::MAX));
    assert_eq!(ends.std_dev(), Some(f32::MAX));
    assert_eq!(ends.standard_error(), Some(f32::MAX));
    assert_eq!(moments(&[f32::MAX; 5]).mean(), Some(f32::MAX));
    let large = moments(&[1e38, 2e38, 3e38]);
    assert_eq!(large.std_dev(), Some(1e38));
    let tiny = f32::from_bits(1);
    let small = moments(&[2.0 * tiny, 4.0 * tiny, 6.0 * tiny]);
    assert_eq!(small.mean(), Some(4.0 * tiny));
    assert_eq!(small.std_dev(), Some(2.0 * tiny));
    assert_eq!(small.variance(), Some(0.0));
    // A variance that is itself subnormal.
    let low = moments(&[1e-20, 3e-20]).variance().unwrap();
    assert!((low / 1e-20 / 1e-20 - 2.0).abs() <= 1e-4, "{low:e}");
    // Both ends in one run, in any order.
    for samples in [[tiny, 3e38, 1.0], [3e38, tiny, 1.0], [1.0, tiny, 3e38]] {
        let mean = moments(&samples).mean().unwrap();
        assert!((mean / 1e38 - 1.0).abs() <= 2e-7, "{mean:e}");
    }
}

#[test]
fn what_is_no_number_leaves_no_trace() {
    let no_numbers = [f32::NAN, f32::INFINITY, f32::NEG_INFINITY];
    let mut clean = moments(&[1.0, 4.0, 5.0]);
    let mut dirty = moments(&no_numbers);
    assert_eq!((dirty.count(), dirty.refused(), dirty.mean()), (0, 3, None));
    for x in [1.0, 4.0, 5.0] {
        dirty.push(x);
        no_numbers.iter().for_each(|&x| dirty.push(x));
    }
    assert_eq!((dirty.count(), dirty.refused()), (3, 12));
    assert_eq!(
        (dirty.mean(), dirty.variance()),
        (clean.mean(), clean.variance())
    );
    clean.merge(&moments(&no_numbers));
    assert_eq!((clean.count(), clean.refused()), (3, 3));
    let mut empty = moments(&no_numbers);
    empty.merge(&dirty);
    assert_eq!((empty.count(), empty.refused()), (3, 15));

    let mut integral = Integral::new();
    for (f, pdf) in [
        (1.0, 0.0),
        (0.0, 0.0),
        (1.0, -1.0),
        (1.0, f32::NAN),
        (1.0, f32::INFINITY),
        (f32::NAN, 1.0),
        (f32::INFINITY, 1.0),
        (f32::INFINITY, f32::INFINITY),
        (1e30, 1e-30),
    ] {
        integral.push(f, pdf);
    }
    assert_eq!((integral.count(), integral.refused()), (0, 9));
    integral.push(0.0, 1e-45);
    integral.push(1e-45, 1e-45);
    integral.push(3e38, 3e38);
    integral.push(1e-45, 3e38);
    assert_eq!((integral.count(), integral.estimate()), (4, Some(0.5)));

    let mut ratio = WeightedMean::new();
    for x in no_numbers {
        ratio.push(x, 1.0);
        ratio.push(1.0, x);
        ratio.push(x, 0.0);
    }
    assert_eq!((ratio.count(), ratio.refused(), ratio.mean()), (0, 9, None));
    let mut other = WeightedMean::new();
    other.push(3.0, 2.0);
    ratio.merge(&other);
    assert_eq!(
        (ratio.count(), ratio.refused(), ratio.mean()),
        (1, 9, Some(3.0))
    );
}

#[test]
fn probabilities_outside_their_range_are_refused() {
    let mut integral = Integral::new();
    integral.push(1.0, 1.0);
    integral.push(2.0, 1.0);
    for p in [0.0, 1.0, -0.5, 1.5, -0.0, 3e38] {
        assert_eq!(integral.chebyshev_bound(p), Err(Error::OutOfRange(0)));
        assert_eq!(integral.normal_bound::<Poly>(p), Err(Error::OutOfRange(0)));
    }
    for p in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
        assert_eq!(integral.chebyshev_bound(p), Err(Error::NotFinite(0)));
        assert_eq!(integral.normal_bound::<Libm>(p), Err(Error::NotFinite(0)));
    }
    for p in [1e-45, 1e-10, 0.5, 0.999_999_94] {
        assert!(integral.chebyshev_bound(p).unwrap().is_finite());
        let bound = integral.normal_bound::<Libm>(p).unwrap();
        assert!(bound.is_finite() && bound >= 0.0 && bound.is_sign_positive());
    }
    let mut large = Integral::new();
    large.push(f32::MAX, 1.0);
    large.push(-f32::MAX, 1.0);
    assert_eq!(large.chebyshev_bound(1e-10), Ok(f32::MAX));
    assert_eq!(large.normal_bound::<Poly>(0.99), Ok(f32::MAX));
}

#[test]
fn weights_without_a_sum_give_no_ratio() {
    let mut ratio = WeightedMean::new();
    ratio.push(1.0, 0.0);
    assert_eq!(
        (ratio.count(), ratio.mean(), ratio.standard_error()),
        (1, None, None)
    );
    ratio.push(2.0, 3.0);
    ratio.push(1e30, 0.0);
    assert_eq!((ratio.count(), ratio.mean()), (3, Some(2.0)));
    assert_eq!(ratio.standard_error(), Some(0.0));
    // They cancel, and what comes after counts again.
    ratio.push(5.0, -3.0);
    assert_eq!(
        (ratio.count(), ratio.mean(), ratio.standard_error()),
        (4, None, None)
    );
    ratio.push(1.0, 0.5);
    assert_eq!(ratio.mean(), Some(-17.0));
    // They nearly cancel, which carries the ratio out of f32.
    let mut ratio = WeightedMean::new();
    ratio.push(1e38, 1.0);
    ratio.push(-1e38, -0.999_999_94);
    assert_eq!(ratio.mean(), Some(f32::MAX));
    assert!(ratio.standard_error().unwrap().is_finite());
    // Values and weights at both ends.
    let mut ends = WeightedMean::new();
    for w in [f32::MAX, 1e-45, 1.0] {
        ends.push(f32::MAX, w);
        ends.push(-f32::MAX, w);
    }
    let centre = ends.mean().unwrap();
    assert!(centre.abs() <= 1e-14 * f32::MAX, "{centre:e}");
    let mut blank = WeightedMean::new();
    blank.push(9e9, 0.0);
    blank.merge(&ends);
    assert_eq!((blank.count(), blank.mean()), (7, Some(centre)));
    ends.merge(&WeightedMean::new());
    assert_eq!((ends.count(), ends.mean()), (6, Some(centre)));
}

/// The standard error of a ratio is lost where every product is too small beside the largest value times the
/// largest weight; the ratio is not.
#[test]
fn the_standard_error_of_a_ratio_reaches_as_far_down_as_stated() {
    for (far, reached) in [(1e10, true), (1e17, true), (1e25, false)] {
        for first in [true, false] {
            let mut ratio = WeightedMean::new();
            if first {
                ratio.push(far, 1e-38);
            }
            for i in 0..100_u8 {
                ratio.push(f32::from(i % 2), 1.0);
            }
            if !first {
                ratio.push(far, 1e-38);
            }
            let estimate = ratio.mean().unwrap();
            assert!((estimate - 0.5).abs() <= 1e-7, "{far:e}: {estimate}");
            // √(101/100 · 100/4)/100
            let off = ratio.standard_error().unwrap() / 0.050_249_38 - 1.0;
            assert_eq!(off.abs() <= 1e-6, reached, "{far:e}: {off:e}");
        }
    }
}

/// Far from 0, where what is measured from any other centre would lose the scatter.
#[test]
fn merging_with_nothing_changes_no_bit() {
    let (mut moments, mut ratio) = (Moments::new(), WeightedMean::new());
    for k in 0..1000 {
        let x = 16_777_000.0 + (k % 7) as f32;
        moments.push(x);
        ratio.push(x, 1.0 + (k % 3) as f32);
    }
    let mut weightless = WeightedMean::new();
    weightless.push(5.0, 0.0);
    let (mut left, mut right) = (moments, Moments::new());
    left.merge(&Moments::new());
    right.merge(&moments);
    assert_eq!((left, right), (moments, moments));
    let (mut left, mut right) = (ratio, weightless);
    left.merge(&weightless);
    right.merge(&ratio);
    let figures = |r: WeightedMean| (r.mean(), r.standard_error().map(|e| (e * 1e5).round()));
    assert_eq!(
        (figures(left), figures(right)),
        (figures(ratio), figures(ratio))
    );
}
