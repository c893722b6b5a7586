//! The sample of a linear density, for all ends and uniforms: a quotient that is off by a few roundings, and one step of Newton's
//! method on x(a + sx) = u, of which the left side is worked out with its rounding errors.

use crate::kept;
use crate::line::stated;
use crate::maps::Row;
use crate::programs::{DRAWS, between, kept as field, uniform};
use crate::report::{Line, complaint_of_half};
use crate::rounding::UNIT;
use host::errors::{raise, ulp};
use microwarp::Warp;
use microwarp::uniform::LARGEST;
use microwarp::warp::Linear;

/// How many roundings the quotient is off by. a and b are off by two. So squares are off by 5, their products with the uniform and
/// with what it leaves of 1 by 7, the sum by 8, its root by 5, the divisor by 6 and the quotient by 7; what is left of the eighth
/// is more than the squares of all these.
const OF_QUOTIENT: f64 = 8.0;

/// What a number is off by before the last subtraction, in ulp, where a is at most so many times the density at x, or where the
/// density rises, which is as good as once.
///
/// The mean density below x, its part by the slope, twice a, and what the slope's error counts for, are 7a together at most, or as
/// many densities. What is left of the step is a sum whose terms are a rounding each of these, rounded again: by 8 of them. Its
/// divisor is off by a rounding of each, and both with the quotient by three more, in proportion to the step. Newton's method
/// leaves the slope times the square of the step, over the density. And a and the slope with what has been kept of their roundings
/// are off by squares of these: a by 8 at most, the slope by as much and by 3 more.
fn before_the_last(densities: f64) -> f64 {
    let sizes = 7.0 * densities;
    let residue = 8.0 * sizes + OF_QUOTIENT * (sizes + 3.0);
    let left = OF_QUOTIENT * OF_QUOTIENT * densities;
    let ends = 20.0 * densities;
    (residue + left + ends) * UNIT
}

/// What samples are off by, in ulp.
///
/// A falling density is at least a times the root of what the uniform leaves of 1, 2⁻¹² of it. The step is a multiple of 2⁻¹⁴⁹:
/// below 2⁻¹²⁵ that rounds it by half an ulp, and the subtraction, of multiples of 2⁻¹⁴⁹, is exact. Beyond, the step is rounded by a
/// quarter of an ulp, and from 2⁻¹¹⁹ on by less than a hundredth; there the density has not fallen yet. What is rounded to 1 becomes
/// the number before, but exact points are more than half an ulp below 1: the density is 2 there at most.
fn bound(of_small_steps: f64) -> f64 {
    let anywhere = 0.5 + 0.01 + before_the_last(1.01 * 4096.0);
    anywhere.max(0.5 + of_small_steps + before_the_last(1.01))
}

const OF_SMALL_STEPS: f64 = 0.25;

/// Its row.
pub fn line() -> Line {
    let (title, [_, stated]) = stated("Linear", "sample");
    let [found, _] = kept::largest("Linear", "sample");
    let proven = bound(OF_SMALL_STEPS);
    Line {
        name: "Linear",
        title,
        stated: vec![stated],
        rows: vec![Row { proven, found }],
        formula: None,
    }
}

/// 2⁶⁰, in which the fields count.
const ONE: f32 = (1_u64 << 60) as f32;

pub fn two_sum(a: f32, b: f32) -> (f32, f32) {
    let sum = a + b;
    let of_b = sum - a;
    (sum, (a - (sum - of_b)) + (b - of_b))
}

/// The product of two is a double.
fn two_product(a: f32, b: f32) -> (f32, f32) {
    let (product, exact) = (a * b, f64::from(a) * f64::from(b));
    (product, (exact - f64::from(product)) as f32)
}

/// The fields: a and its rest, b, the slope and its rest.
fn fields(linear: &Linear) -> [f32; 5] {
    ["a", "a_rest", "b", "slope", "slope_rest"].map(|name| field(linear, name))
}

/// The quotient, and the sample.
fn by_operations([a, a_rest, b, slope, slope_rest]: [f32; 5], u: f32) -> [f32; 2] {
    let root = ((1.0 - u) * (a * a) + u * (b * b)).sqrt();
    let x = u * (2.0 * ONE) / (a + root);
    let (bend, bend_rest) = two_product(slope, x);
    let (mean, mean_rest) = two_sum(a, bend);
    let rest = mean_rest + (bend_rest + (a_rest + slope_rest * x));
    let (mass, mass_rest) = two_product(mean, x);
    let over = (mass - u * ONE) + (mass_rest + rest * x);
    let stepped = x - over / (mean + bend);
    [x, if stepped < 1.0 { stepped } else { LARGEST }]
}

/// The sample is what is examined, its quotient and fields are as good as is said, and without the step, or without what a has been
/// rounded by, samples are off by more than is stated.
#[test]
fn linear_samples_are_a_quotient_and_a_step() {
    let (mut without_step, mut without_rest) = (0.0, 0.0);
    for k in 0..4 * *DRAWS {
        // Ends of all sizes, and close ones.
        let first = between(k, 1e-9, 1e9);
        let near = first * between(k + 1, 0.5, 2.0);
        let second = if k % 2 == 0 {
            near
        } else {
            between(k + 2, 1e-9, 1e9)
        };
        let linear = Linear::new(first, second).expect("a density");
        let of = fields(&linear);
        let u = uniform(k + 3).max(1e-30);
        let [quotient, x] = by_operations(of, u);
        assert_eq!(linear.sample(u), x, "{first} {second} {u}");
        let [a, a_rest, _, slope, slope_rest] = of.map(|x| f64::from(x) / f64::from(ONE));
        let ([p, q], u) = ([first, second].map(f64::from), f64::from(u));
        let (due, square) = (2.0 * p / (p + q), UNIT * UNIT);
        assert!((a + a_rest - due).abs() <= 8.0 * square * due);
        let off = (slope + slope_rest - (1.0 - due)).abs();
        assert!(off <= square * (11.0 * due + (1.0 - due).abs()) + 1e-16);
        let exact = u * (p + q) / (p + ((1.0 - u) * p * p + u * q * q).sqrt());
        assert!((f64::from(quotient) / exact - 1.0).abs() <= OF_QUOTIENT * UNIT);
        let off = |x: f32| (f64::from(x) - exact).abs() / ulp(exact);
        assert!(off(x) <= bound(OF_SMALL_STEPS));
        raise(&mut without_step, off(quotient));
        let [a, _, b, slope, slope_rest] = of;
        raise(
            &mut without_rest,
            off(by_operations([a, 0.0, b, slope, slope_rest], u as f32)[1]),
        );
    }
    let Line { stated, rows, .. } = line();
    assert!(
        without_step > stated[0] && without_rest > stated[0],
        "{without_step} {without_rest}"
    );
    assert_eq!(complaint_of_half(rows[0], stated[0]), None);
    let proven = bound(0.0);
    assert!(complaint_of_half(Row { proven, ..rows[0] }, stated[0]).is_some());
}
