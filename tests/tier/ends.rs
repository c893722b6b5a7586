//! The ends of every function's domain and what lies beyond: the documented values, and no panic anywhere.

use crate::sweep::EDGES;
use microwarp::tier::{Libm, Poly, Tier};

fn ends_are_as_documented<T: Tier>() {
    const INF: f32 = f32::INFINITY;
    let equal = |what: &str, got: f32, expected: f32| {
        assert!(got == expected, "{} {what}: {got} for {expected}", T::NAME);
    };
    for zero in [0.0, -0.0] {
        equal("atan2(0, 0)", T::atan2_turns(zero, -zero), 0.0);
        equal("ln 0", T::ln(zero), -INF);
        equal("exp 0", T::exp(zero), 1.0);
        equal("exp_m1 0", T::exp_m1(zero), 0.0);
        equal("ln_1p 0", T::ln_1p(zero), 0.0);
        equal("0^0", T::pow(zero, zero), 1.0);
        equal("0^y", T::pow(zero, 3.0), 0.0);
        equal("0^-y", T::pow(zero, -3.0), INF);
        equal("Φ(0)", T::normal_cdf_lower(zero), 0.5);
    }
    equal("ln ∞", T::ln(INF), INF);
    equal("ln_1p -1", T::ln_1p(-1.0), -INF);
    equal("ln_1p ∞", T::ln_1p(INF), INF);
    equal("exp ∞", T::exp(INF), INF);
    equal("exp -∞", T::exp(-INF), 0.0);
    equal("exp 89", T::exp(89.0), INF);
    equal("exp -104", T::exp(-104.0), 0.0);
    equal("exp_m1 ∞", T::exp_m1(INF), INF);
    equal("exp_m1 -∞", T::exp_m1(-INF), -1.0);
    equal("∞^y", T::pow(INF, 0.5), INF);
    equal("∞^-y", T::pow(INF, -0.5), 0.0);
    equal("½^∞", T::pow(0.5, INF), 0.0);
    equal("2^∞", T::pow(2.0, INF), INF);
    equal("1^∞", T::pow(1.0, INF), 1.0);
    equal("NaN^0", T::pow(f32::NAN, 0.0), 1.0);
    equal("Φ(-∞)", T::normal_cdf_lower(-INF), 0.0);
    equal("Φ(-20)", T::normal_cdf_lower(-20.0), 0.0);
    for half in [0.5, 0.75, INF, f32::NAN] {
        equal("Φ⁻¹(½)", T::normal_quantile_lower(half), 0.0);
    }
    let least = T::normal_quantile_lower(f32::from_bits(1));
    assert!(least > -14.2 && least < -14.0, "{least}");
    for below in [0.0, -0.0, -1.0, -INF] {
        equal("Φ⁻¹(0)", T::normal_quantile_lower(below), least);
    }
    // What is smaller than every rounding error passes unchanged.
    for x in [1.0e-45, -1.0e-45, 1.0e-39, -1.0e-20, 1.0e-9, -1.0e-9] {
        equal("exp_m1", T::exp_m1(x), x);
        equal("ln_1p", T::ln_1p(x), x);
    }
}

#[test]
fn ends_are_as_documented_in_both_tiers() {
    ends_are_as_documented::<Libm>();
    ends_are_as_documented::<Poly>();
}

/// Whatever comes in, nothing panics, and where a number is promised a number comes out.
fn is_total<T: Tier>() {
    let special = [
        f32::INFINITY,
        f32::NAN,
        f32::from_bits(0x7f80_0001),
        0.3,
        88.73,
        104.0,
    ];
    let positive: Vec<f32> = EDGES.into_iter().chain(special).collect();
    let all: Vec<f32> = positive.iter().flat_map(|&x| [x, -x]).collect();
    for &x in &all {
        let (s, c) = T::sincos_turns(x);
        assert!(s.abs() <= 1.0 && c.abs() <= 1.0, "{} sincos {x}", T::NAME);
        assert!(
            (-14.2..=0.0).contains(&T::normal_quantile_lower(x)),
            "{} {x}",
            T::NAME
        );
        assert!(
            (0.0..=0.5).contains(&T::normal_cdf_lower(x)),
            "{} {x}",
            T::NAME
        );
        assert!(T::ln(x).is_nan() != (x >= 0.0), "{} ln {x}", T::NAME);
        assert!(T::ln_1p(x).is_nan() != (x >= -1.0), "{} ln_1p {x}", T::NAME);
        assert!(T::exp(x) >= 0.0 || x.is_nan(), "{} exp {x}", T::NAME);
        assert!(T::exp_m1(x) >= -1.0 || x.is_nan(), "{} exp_m1 {x}", T::NAME);
        for &y in &all {
            assert!(
                T::atan2_turns(y, x).abs() <= 0.5,
                "{} atan2 {y} {x}",
                T::NAME
            );
            let power = T::pow(x, y);
            assert!(
                power >= 0.0 || x < 0.0 || x.is_nan() || y.is_nan(),
                "{} {x}^{y}",
                T::NAME
            );
        }
    }
}

#[test]
fn every_function_is_total_in_both_tiers() {
    is_total::<Libm>();
    is_total::<Poly>();
}
