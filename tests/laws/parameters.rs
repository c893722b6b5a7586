//! Bad parameters get a typed error from the constructor, and nothing is built.

use microwarp::uniform::{MAX_STRATA, Strata1d, Strata2d};
use microwarp::{Error, libm, poly};

const NAN: f32 = f32::NAN;
const INF: f32 = f32::INFINITY;
const TINY: f32 = 1.0e-45;

/// Checks the same refusals in both tiers.
macro_rules! refused {
    ($($name:ident :: $constructor:ident ( $($argument:expr),* ) => $error:ident;)*) => {
        $(
            assert_eq!(libm::$name::$constructor($($argument),*).err(), Some(Error::$error),
                "libm {} {:?}", stringify!($name), ($($argument,)*));
            assert_eq!(poly::$name::$constructor($($argument),*).err(), Some(Error::$error),
                "poly {} {:?}", stringify!($name), ($($argument,)*));
        )*
    };
}

#[test]
fn impossible_parameters_are_refused_by_name() {
    refused! {
        Interval::new(NAN, 1.0) => NotFinite;
        Interval::new(0.0, INF) => NotFinite;
        Interval::new(1.0, 0.0) => Reversed;
        Interval::new(1.0, 1.0) => Empty;
        Interval::new(0.0, TINY) => Empty;
        Interval::decreasing(-INF, 1.0) => NotFinite;
        Interval::decreasing(1.0, 0.0) => Reversed;
        Interval::decreasing(2.0, 2.0) => Empty;
        Power::new(NAN, 0.0, 1.0) => NotFinite;
        Power::new(1.0, 0.0, INF) => NotFinite;
        Power::new(1.0, -1.0, 1.0) => Negative;
        Power::new(1.0, 2.0, 1.0) => Reversed;
        Power::new(1.0, 1.0, 1.0) => Empty;
        Power::new(1.0, 0.0, TINY) => Empty;
        Power::new(-1.0, TINY, 1.0) => Empty;
        Power::new(-1.0, 0.0, 1.0) => NotNormalizable;
        Power::new(-3.0, 0.0, 1.0) => NotNormalizable;
        Power::decreasing(-1.0, 0.0, 1.0) => NotNormalizable;
        Exponential::new(NAN) => NotFinite;
        Exponential::new(0.0) => NotPositive;
        Exponential::new(-1.0) => NotPositive;
        Exponential::new(1.0e-40) => TooLarge;
        ExponentialTail::new(INF) => NotFinite;
        ExponentialTail::new(-0.0) => NotPositive;
        ExponentialTail::new(TINY) => TooLarge;
        TruncatedExponential::new(NAN, 1.0) => NotFinite;
        TruncatedExponential::new(1.0, NAN) => NotFinite;
        TruncatedExponential::new(1.0, 0.0) => NotPositive;
        TruncatedExponential::new(1.0, -1.0) => NotPositive;
        TruncatedExponential::new(1.0, TINY) => Empty;
        Tent::new(NAN) => NotFinite;
        Tent::new(0.0) => NotPositive;
        Tent::new(TINY) => Empty;
        Linear::new(NAN, 1.0) => NotFinite;
        Linear::new(1.0, INF) => NotFinite;
        Linear::new(-1.0, 1.0) => Negative;
        Linear::new(0.0, 0.0) => NotPositive;
        Normal::new(NAN, 1.0) => NotFinite;
        Normal::new(0.0, 0.0) => NotPositive;
        Normal::new(0.0, -1.0) => NotPositive;
        Normal::new(0.0, 1.0e38) => TooLarge;
        Normal::new(0.0, TINY) => Empty;
        NormalPair::new([0.0, NAN], 1.0) => NotFinite;
        NormalPair::new([0.0, 0.0], -1.0) => NotPositive;
        NormalPair::new([0.0, 0.0], 1.0e-30) => Empty;
        NormalPair::new([0.0, 0.0], 1.0e30) => TooLarge;
        Cone::from_angle(NAN) => NotFinite;
        Cone::from_angle(0.0) => NotPositive;
        Cone::from_angle(3.2) => OutOfRange;
        Cone::from_angle(1.0e-20) => Empty;
        Cone::from_one_minus_cos(2.1) => OutOfRange;
        Cone::from_one_minus_cos(TINY) => Empty;
        Cone::from_sphere(1.5) => OutOfRange;
        Cone::from_sphere(-0.1) => NotPositive;
        PhongLobe::new(NAN) => NotFinite;
        PhongLobe::new(-0.1) => Negative;
        SphericalPatch::new(0.0, 0.25, NAN, 0.5) => NotFinite;
        SphericalPatch::new(0.3, 0.2, 0.0, 0.5) => Reversed;
        SphericalPatch::new(0.0, 0.6, 0.0, 0.5) => OutOfRange;
        SphericalPatch::new(0.0, 0.5, 0.0, 1.5) => OutOfRange;
        SphericalPatch::new(0.1, 0.1, 0.0, 0.5) => Empty;
        SphericalPatch::new(0.1, 0.2, 0.5, 0.5) => Empty;
        Spherical::new(-1.0, 0.1, 0.0) => Negative;
        Spherical::new(1.0, 0.6, 0.0) => OutOfRange;
        Spherical::new(1.0, 0.1, INF) => NotFinite;
        Frame::new([0.0, 0.0, 0.0]) => ZeroLength;
        Frame::new([0.0, NAN, 0.0]) => NotFinite;
        TriangleOn::new([[0.0, 0.0], [1.0, 1.0], [2.0, 2.0]]) => Empty;
        TriangleOn::new([[0.0, 0.0], [0.0, 0.0], [0.0, 0.0]]) => Empty;
        TriangleOn::new([[NAN, 0.0], [1.0, 0.0], [0.0, 1.0]]) => NotFinite;
        TriangleOn::new([[0.0, 0.0], [1e30, 0.0], [0.0, 1e30]]) => TooLarge;
        TriangleOn::new([[0.0, 0.0], [1e-30, 0.0], [0.0, 1e-30]]) => Empty;
    }
    assert_eq!(Strata1d::new(0), Err(Error::Empty));
    assert_eq!(Strata1d::new(MAX_STRATA + 1), Err(Error::TooLarge));
    assert_eq!(Strata2d::new(0, 3), Err(Error::Empty));
    assert_eq!(Strata2d::new(MAX_STRATA, MAX_STRATA), Err(Error::TooLarge));
}

/// Parameters at the very edge of what is accepted still give finite samples of finite density.
#[test]
fn accepted_extremes_are_total() {
    use microwarp::Warp;
    let edge = [0.0, 1.0e-45, 0.5, 0.999_999_94];
    let line = |label: &str, sample: &dyn Fn(f32) -> (f32, f32)| {
        for u in edge {
            let (x, pdf) = sample(u);
            assert!(
                x.is_finite() && pdf > 0.0 && pdf.is_finite(),
                "{label} at {u}: {x}, {pdf}"
            );
        }
    };
    macro_rules! total {
        ($($label:literal => $warp:expr;)*) => {
            $(let warp = $warp.unwrap(); line($label, &|u| { let x = warp.sample(u); (x, warp.pdf(x)) });)*
        };
    }
    total! {
        "interval of everything" => poly::Interval::new(-f32::MAX, f32::MAX);
        "narrowest interval" => poly::Interval::new(0.0, 3.0e-39);
        "interval of one step" => poly::Interval::new(1.0, 1.000_000_1);
        "power 3e38" => poly::Power::new(3.0e38, 0.0, 1.0);
        "power -3e38" => poly::Power::new(-3.0e38, 1.0, 2.0);
        "power over nearly all floats" => poly::Power::new(-1.0, 1.0e-36, f32::MAX);
        "power of nearly -1 from 0" => poly::Power::new(-0.999_999_94, 0.0, 1.0);
        "power to the largest float" => poly::Power::new(0.5, 0.0, f32::MAX);
        "power over one step" => poly::Power::new(7.0, 1.0, 1.000_000_1);
        "smallest rate" => poly::Exponential::new(3.06e-37);
        "smallest rate, tail" => poly::ExponentialTail::new(3.06e-37);
        "largest rate" => poly::ExponentialTail::new(f32::MAX);
        "truncated to the largest length" => poly::TruncatedExponential::new(-f32::MAX, f32::MAX);
        "truncated, rate 0, largest length" => poly::TruncatedExponential::new(0.0, f32::MAX);
        "truncated, subnormal product" => poly::TruncatedExponential::new(TINY, 1.0);
        "largest tent" => poly::Tent::new(f32::MAX);
        "smallest tent" => poly::Tent::new(f32::MIN_POSITIVE);
        "linear of subnormals" => poly::Linear::new(TINY, 0.0);
        "linear of the largest" => poly::Linear::new(f32::MAX, f32::MAX);
        "widest normal" => poly::Normal::new(1.0e37, 1.0e37);
        "narrowest normal" => poly::Normal::new(0.0, 1.0e-38);
        "narrow normal far away" => poly::Normal::new(1.0e30, 1.0e-30);
    }
    // The product of a quotient and its divisor may be rounded beyond the largest float.
    for start in (0..1000_u16).map(|i| 1.0 + f32::from(i) * 0.001_7) {
        line("power from 1 or more to the largest float", &|u| {
            let warp = poly::Power::new(-1.0, start, f32::MAX).unwrap();
            let x = warp.sample(u);
            (x, warp.pdf(x))
        });
    }
    for n in [0.0, TINY, 1.0e20, f32::MAX] {
        let lobe = poly::PhongLobe::new(n).unwrap();
        for u in edge {
            let x = lobe.sample([u, u]);
            let pdf = lobe.pdf(x);
            assert!(
                x.iter().all(|c| c.is_finite()) && pdf > 0.0 && pdf.is_finite(),
                "{n} {u} {x:?} {pdf}"
            );
        }
    }
}
