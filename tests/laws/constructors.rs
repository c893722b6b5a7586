//! Constructors in constants, the parameters that getters give back, and the numbers of errors.

use microwarp::tier::{Libm, Poly, Tier};
use microwarp::warp::{
    Aabb, Annulus, Cauchy, Cone, Exponential, ExponentialTail, FrustumSurface, Gumbel,
    HenyeyGreenstein, Interval, Laplace, Linear, LogNormal, Logistic, Normal, NormalPair, Pareto,
    PhongLobe, Power, Rayleigh, Spherical, SphericalPatch, Tent, TriangleOn, TruncatedExponential,
    TruncatedNormal, Weibull,
};
use microwarp::{Error, constant};
use std::collections::BTreeSet;
use std::hint::black_box;

/// Every reason, and its number. A number that is in use is never given to another reason.
const CODES: [(Error, u16); 16] = [
    (Error::NotFinite, 1),
    (Error::Reversed, 2),
    (Error::Empty, 3),
    (Error::TooLarge, 4),
    (Error::NotPositive, 5),
    (Error::Negative, 6),
    (Error::OutOfRange, 7),
    (Error::NotNormalizable, 8),
    (Error::ZeroLength, 9),
    (Error::NoWeights, 10),
    (Error::TooManyWeights, 11),
    (Error::NotFiniteWeight(3), 12),
    (Error::NegativeWeight(3), 13),
    (Error::AllZero, 14),
    (Error::Unreachable(3), 15),
    (Error::NotATable, 16),
];

#[test]
fn the_numbers_of_errors_never_change() {
    let mut messages = BTreeSet::new();
    for (error, code) in CODES {
        assert_eq!(error.code(), code, "{error:?}");
        let of_weight = matches!(code, 12 | 13 | 15);
        assert_eq!(error.index(), of_weight.then_some(3), "{error:?}");
        assert_eq!(error.to_string().contains('3'), of_weight, "{error}");
        assert_eq!(error.to_string() == error.message(), !of_weight, "{error}");
        messages.insert(error.message());
    }
    assert_eq!(messages.len(), CODES.len(), "two reasons read alike");
    // Every reason that the enum declares stands in the table.
    let source = include_str!("../../src/error.rs");
    let (_, body) = source.split_once("pub enum Error {").unwrap();
    let (body, _) = body.split_once("\n}").unwrap();
    let reasons = body.lines().map(str::trim);
    let reasons = reasons.filter(|line| !line.starts_with("//") && line.ends_with(','));
    assert_eq!(reasons.count(), CODES.len());
}

/// A constructor gives the same bits in a constant and at run time.
fn in_both_worlds<T: Tier>() {
    macro_rules! same {
        ($($name:ident $(<$t:ty>)? :: $constructor:ident ( $($x:expr),* );)*) => {$({
            let at_run_time = $name$(::<$t>)?::$constructor($(black_box($x)),*);
            let constant = const { $name$(::<$t>)?::$constructor($($x),*) };
            assert!(at_run_time.is_ok(), "{}: {at_run_time:?}", stringify!($name));
            // The shortest digits tell every number, and every zero from its opposite.
            assert_eq!(format!("{constant:?}"), format!("{at_run_time:?}"));
        })*};
    }
    same! {
        Aabb::new([-1.0, 0.1, 1e-3], [2.0, 0.3, 1e20]);
        Cauchy<T>::new(0.3, 1.7);
        Cone<T>::from_one_minus_cos(0.3);
        Exponential<T>::from_rate(0.7);
        Exponential<T>::from_mean(0.7);
        ExponentialTail<T>::from_rate(3.0);
        ExponentialTail<T>::from_mean(3.0);
        Gumbel<T>::new(0.3, 1.7);
        HenyeyGreenstein<T>::new(-0.6);
        HenyeyGreenstein<T>::from_one_minus_g(1e-7);
        HenyeyGreenstein<T>::from_one_plus_g(0.7);
        Interval::new(0.1, 0.7);
        Interval::decreasing(-0.1, 0.7);
        Laplace<T>::new(0.3, 1.7);
        Linear::new(0.1, 0.3);
        LogNormal<T>::new(0.3, 1.7);
        Logistic<T>::new(0.3, 1.7);
        Normal<T>::new(0.3, 1.7);
        NormalPair<T>::new([0.3, 3.0], 1.7);
        Pareto<T>::new(0.3, 1.7);
        PhongLobe<T>::new(13.7);
        Power<T>::new(2.5, 0.0, 0.7);
        Power<T>::new(-1.0, 0.1, 0.7);
        Power<T>::new(-0.9999, 1e-30, 1e30);
        Power<T>::new(-0.3, 0.0, 7.0);
        Power<T>::decreasing(-2.7, 0.1, 1e20);
        Power<T>::decreasing(1e8, 1.0, 1.000_001);
        Rayleigh<T>::new(0.3);
        Spherical<T>::from_turns(1.0, 0.1, 0.3);
        Tent::new(0.3);
        TruncatedExponential<T>::from_rate(1e-7, 3.0);
        TruncatedExponential<T>::from_rate(0.7, 3.0);
        TruncatedExponential<T>::from_rate(-0.7, 3.0);
        TruncatedExponential<T>::from_rate(-700.0, 0.3);
        TruncatedExponential<T>::from_mean(0.7, 3.0);
        Weibull<T>::new(0.3, 1.7);
    }
}

#[test]
fn a_constant_has_the_bits_of_what_is_made_at_run_time() {
    in_both_worlds::<Libm>();
    in_both_worlds::<Poly>();
    // In a constant, in a static and in place.
    const NOISE: Normal<Poly> = constant!(Normal::new(10.0, 2.0));
    static BOX: Aabb<2> = constant!(Aabb::new([0.0; 2], [1.0, 2.0]));
    let tent = constant!(Tent::new(2.0));
    assert_eq!(Ok(NOISE), Normal::new(black_box(10.0), 2.0));
    assert_eq!(Ok(BOX), Aabb::new([black_box(0.0); 2], [1.0, 2.0]));
    assert_eq!(Ok(tent), Tent::new(black_box(2.0)));
}

#[test]
fn getters_give_the_parameters_back() {
    fn of_tier<T: Tier>() {
        let power = Power::<T>::decreasing(-2.5, 0.5, 7.0).unwrap();
        assert_eq!(
            (power.exponent(), power.low(), power.high()),
            (-2.5, 0.5, 7.0)
        );
        let from_zero = Power::<T>::new(2.5, 0.0, 1.0).unwrap();
        assert_eq!(from_zero.low(), microwarp::uniform::SMALLEST);
        assert_eq!(Power::<T>::new(0.0, 0.0, 1.0).unwrap().low(), 0.0);
        assert_eq!(PhongLobe::<T>::new(50.5).unwrap().exponent(), 50.5);
        assert_eq!(
            HenyeyGreenstein::<T>::new(-0.25).unwrap().asymmetry(),
            -0.25
        );
        let needle = HenyeyGreenstein::<T>::from_one_plus_g(1e-9).unwrap();
        assert_eq!((needle.asymmetry(), needle.one_minus_abs_g()), (-1.0, 1e-9));
        let normal = Normal::<T>::new(-3.0, 0.3).unwrap();
        assert_eq!((normal.mean(), normal.std_dev()), (-3.0, 0.3));
        let pair = NormalPair::<T>::new([1.0, -2.0], 0.3).unwrap();
        assert_eq!((pair.mean(), pair.std_dev()), ([1.0, -2.0], 0.3));
        macro_rules! located {
            ($($name:ident)*) => {$(
                let law = $name::<T>::new(-3.0, 0.3).unwrap();
                assert_eq!((law.location(), law.scale()), (-3.0, 0.3));
            )*};
        }
        located!(Cauchy Gumbel Laplace Logistic);
        assert_eq!(Rayleigh::<T>::new(0.3).unwrap().scale(), 0.3);
        let weibull = Weibull::<T>::new(0.3, 0.7).unwrap();
        assert_eq!((weibull.scale(), weibull.shape()), (0.3, 0.7));
        let pareto = Pareto::<T>::new(0.3, 0.7).unwrap();
        assert_eq!((pareto.minimum(), pareto.shape()), (0.3, 0.7));
        let size = LogNormal::<T>::new(-3.0, 0.3).unwrap();
        assert_eq!((size.mean_of_log(), size.std_dev_of_log()), (-3.0, 0.3));
        let segment = TruncatedExponential::<T>::from_rate(-2.5, 3.0).unwrap();
        assert_eq!((segment.rate(), segment.length()), (-2.5, 3.0));
        let narrowed = TruncatedNormal::<T>::new(0.3, 0.7, -1.0, 2.0).unwrap();
        assert_eq!((narrowed.mean(), narrowed.std_dev()), (0.3, 0.7));
        assert_eq!((narrowed.low(), narrowed.high()), (-1.0, 2.0));
        let above = TruncatedNormal::<T>::above(0.3, 0.7, 0.1).unwrap();
        assert_eq!((above.low(), above.high()), (0.1, f32::INFINITY));
        let below = TruncatedNormal::<T>::below(0.3, 0.7, 0.1).unwrap();
        assert_eq!((below.low(), below.high()), (f32::NEG_INFINITY, 0.1));
        let patch = SphericalPatch::<T>::from_turns(0.125, 0.25, -0.25, 0.5).unwrap();
        assert_eq!(patch.theta_turns(), [0.125, 0.25]);
        assert_eq!(patch.phi_turns(), [-0.25, 0.5]);
        // Their sum and difference are not of f32.
        for phi in [[0.1, 0.7], [-0.3, 0.1], [0.9, 1.3], [-1e-9, 0.7]] {
            let patch = SphericalPatch::<T>::from_turns(0.0, 0.25, phi[0], phi[1]);
            assert_eq!(patch.unwrap().phi_turns(), phi);
        }
        for radii in [[0.3, 0.7], [0.0, 3.3], [1e-45, 1e-18], [1e-35, 1e18]] {
            let sector = Annulus::<T>::sector(radii[0], radii[1], -0.3, 0.1).unwrap();
            assert_eq!([sector.inner(), sector.outer()], radii);
            assert_eq!(sector.phi_turns(), [-0.3, 0.1]);
            let tube = FrustumSurface::<T>::tube(radii, 0.3).unwrap();
            assert_eq!((tube.radii(), tube.height()), (radii, 0.3));
        }
        assert_eq!(
            Cone::<T>::from_one_minus_cos(0.3).unwrap().one_minus_cos(),
            0.3
        );
    }
    of_tier::<Libm>();
    of_tier::<Poly>();
    for (low, high) in [(-3.0, 5.0), (0.1, 0.7), (-7.0, -0.3), (-0.3, 0.0)] {
        for interval in [Interval::new(low, high), Interval::decreasing(low, high)] {
            let interval = interval.unwrap();
            assert_eq!((interval.low(), interval.high()), (low, high));
        }
    }
    let room = Aabb::new([0.1, -3.0], [0.7, -1.0]).unwrap();
    assert_eq!((room.low(), room.high()), ([0.1, -3.0], [0.7, -1.0]));
    assert_eq!(Tent::new(0.3).unwrap().radius(), 0.3);
    assert_eq!(Linear::new(1.0, 3.0).unwrap().ends(), [0.5, 1.5]);
    assert_eq!(Linear::new(0.0, 0.3).unwrap().ends(), [0.0, 2.0]);
    for vertices in [
        [[0.1, 0.7], [4.0, -0.3], [0.3, 2.0]],
        [[1e6 + 0.5, 0.1], [1e6 + 1.0, 0.3], [1e6 + 7.0, 0.2]],
    ] {
        assert_eq!(TriangleOn::new(vertices).unwrap().vertices(), vertices);
    }
}

#[test]
fn a_mean_is_the_rate_that_is_its_reciprocal() {
    fn of_tier<T: Tier>() {
        for mean in [3e-39, 1e-30, 0.3, 1.0, 250.0, 3.2e36] {
            let rate = 1.0 / mean;
            let (by_mean, by_rate) = (
                Exponential::<T>::from_mean(mean),
                Exponential::from_rate(rate),
            );
            assert!(by_mean.is_ok(), "{mean}");
            assert_eq!(by_mean, by_rate);
            assert_eq!(by_mean.unwrap().rate(), rate);
            assert_eq!(by_mean.unwrap().mean(), 1.0 / rate);
            let tail = ExponentialTail::<T>::from_mean(mean);
            assert!(tail.is_ok(), "{mean}");
            assert_eq!(tail, ExponentialTail::from_rate(rate));
            assert_eq!(
                (tail.unwrap().rate(), tail.unwrap().mean()),
                (rate, 1.0 / rate)
            );
            let segment = TruncatedExponential::<T>::from_mean(mean, 1.0);
            assert!(segment.is_ok(), "{mean}");
            assert_eq!(segment, TruncatedExponential::from_rate(rate, 1.0));
        }
        let refused = [
            (f32::NAN, Error::NotFinite),
            (f32::INFINITY, Error::NotFinite),
            (0.0, Error::NotPositive),
            (-1.0, Error::NotPositive),
            (2.9e-39, Error::Empty),
            (3.3e36, Error::TooLarge),
        ];
        for (mean, error) in refused {
            assert_eq!(
                Exponential::<T>::from_mean(mean).err(),
                Some(error),
                "{mean}"
            );
            assert_eq!(
                ExponentialTail::<T>::from_mean(mean).err(),
                Some(error),
                "{mean}"
            );
            let truncated = TruncatedExponential::<T>::from_mean(mean, 1.0).err();
            // An interval ends the tail, which cannot overflow then.
            let due = Some(error).filter(|error| *error != Error::TooLarge);
            assert_eq!(truncated, due, "{mean}");
        }
        let mean = TruncatedExponential::<T>::from_mean;
        assert_eq!(mean(1.0, 0.0).err(), Some(Error::NotPositive));
        assert_eq!(mean(1e-45, f32::NAN).err(), Some(Error::NotFinite));
        assert_eq!(mean(1.0, 1e-45).err(), Some(Error::Empty));
    }
    of_tier::<Libm>();
    of_tier::<Poly>();
}
