//! A number of 237 bits, with the methods of `f64` that the truths use, and with numbers of the text beside it.

use ::f256::{consts, f256};
use std::cmp::Ordering;
use std::iter::{Product, Sum};
use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct Real(f256);

/// A number that is written in the text.
pub fn real(x: f64) -> Real {
    Real(f256::from(x))
}

macro_rules! from {
    ($($number:ty),*) => {$(
        impl From<$number> for Real {
            fn from(x: $number) -> Self {
                Self(f256::from(x))
            }
        }
    )*};
}
from!(f32, f64, i32, u8, u16, u32);

impl From<&Real> for Real {
    fn from(x: &Real) -> Self {
        *x
    }
}

/// An operator between two numbers, of which one may be a number of the text.
macro_rules! operator {
    ($($operator:ident $method:ident $assign:ident $assigned:ident),*) => {$(
        impl<T: Into<Real>> $operator<T> for Real {
            type Output = Self;
            fn $method(self, other: T) -> Self {
                Self(self.0.$method(other.into().0))
            }
        }
        impl<T: Into<Real>> $operator<T> for &Real {
            type Output = Real;
            fn $method(self, other: T) -> Real {
                (*self).$method(other)
            }
        }
        impl $operator<Real> for f64 {
            type Output = Real;
            fn $method(self, other: Real) -> Real {
                Real(f256::from(self).$method(other.0))
            }
        }
        impl<T: Into<Real>> $assign<T> for Real {
            fn $assigned(&mut self, other: T) {
                *self = self.$method(other.into());
            }
        }
    )*};
}
operator!(
    Add add AddAssign add_assign,
    Sub sub SubAssign sub_assign,
    Mul mul MulAssign mul_assign,
    Div div DivAssign div_assign
);

impl Neg for Real {
    type Output = Self;
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl Neg for &Real {
    type Output = Real;
    fn neg(self) -> Real {
        -*self
    }
}

impl PartialEq<f64> for Real {
    fn eq(&self, other: &f64) -> bool {
        self.0 == f256::from(*other)
    }
}

impl PartialOrd<f64> for Real {
    fn partial_cmp(&self, other: &f64) -> Option<Ordering> {
        self.0.partial_cmp(&f256::from(*other))
    }
}

impl<T: Into<Self>> Sum<T> for Real {
    fn sum<I: Iterator<Item = T>>(all: I) -> Self {
        all.fold(real(0.0), Self::add)
    }
}

impl Product for Real {
    fn product<I: Iterator<Item = Self>>(all: I) -> Self {
        all.fold(real(1.0), Self::mul)
    }
}

/// Methods of no argument that the number below has as well.
macro_rules! same {
    ($($method:ident),*) => {$(
        pub fn $method(self) -> Self {
            Self(self.0.$method())
        }
    )*};
}

impl Real {
    pub const INFINITY: Self = Self(f256::INFINITY);
    pub const MIN_POSITIVE: Self = Self(f256::MIN_POSITIVE);

    pub const fn of(x: f256) -> Self {
        Self(x)
    }

    same!(
        abs, acos, asin, atan, cbrt, cos, exp, exp_m1, floor, fract, ln, round, signum, sin, sqrt,
        tan
    );

    pub fn sin_cos(self) -> (Self, Self) {
        let (sin, cos) = self.0.sin_cos();
        (Self(sin), Self(cos))
    }

    /// ln(1 + x), of which the library's own is not a number for most small x.
    pub fn ln_1p(self) -> Self {
        if self.abs() < 1e-20 {
            self * (1.0 - self * (0.5 - self / 3.0))
        } else {
            (1.0 + self).ln()
        }
    }

    pub fn cosh(self) -> Self {
        0.5 * (self.exp() + (-self).exp())
    }

    pub fn atanh(self) -> Self {
        0.5 * (2.0 * self / (1.0 - self)).ln_1p()
    }

    pub fn tanh(self) -> Self {
        let twice = (self + self).exp_m1();
        twice / (twice + 2.0)
    }

    pub fn powi(self, n: i32) -> Self {
        Self(self.0.powi(n))
    }

    pub fn powf(self, n: impl Into<Self>) -> Self {
        Self(self.0.powf(&n.into().0))
    }

    /// The angle of (x, y), of which the library's own is wrong on the diagonals.
    pub fn atan2(self, x: impl Into<Self>) -> Self {
        let (y, x): (Self, Self) = (self, x.into());
        let half = Self(consts::FRAC_PI_2).copysign(y);
        if y == 0.0 && x >= 0.0 {
            y
        } else if y.abs() > x.abs() {
            half - (x / y).atan()
        } else if x < 0.0 {
            half + half + (y / x).atan()
        } else {
            (y / x).atan()
        }
    }

    pub fn hypot(self, y: impl Into<Self>) -> Self {
        Self(self.0.hypot(y.into().0))
    }

    pub fn max(self, other: impl Into<Self>) -> Self {
        Self(self.0.max(other.into().0))
    }

    pub fn min(self, other: impl Into<Self>) -> Self {
        Self(self.0.min(other.into().0))
    }

    pub fn clamp(self, low: impl Into<Self>, high: impl Into<Self>) -> Self {
        self.max(low).min(high)
    }

    pub fn copysign(self, other: Self) -> Self {
        Self(self.0.copysign(other.0))
    }

    pub fn mul_add(self, factor: Self, term: Self) -> Self {
        Self(self.0.mul_add(factor.0, term.0))
    }

    pub fn rem_euclid(self, other: impl Into<Self>) -> Self {
        Self(self.0.rem_euclid(other.into().0))
    }

    pub fn is_finite(self) -> bool {
        self.0.is_finite()
    }

    pub fn is_infinite(self) -> bool {
        self.0.is_infinite()
    }

    pub fn is_nan(self) -> bool {
        self.0.is_nan()
    }

    pub fn total_cmp(&self, other: &Self) -> Ordering {
        self.0.total_cmp(&other.0)
    }
}

/// The nearest double, or one of the two nearest below its normal range.
pub fn to_f64(x: Real) -> f64 {
    const FRACTION: u32 = 108;
    if x.0.is_nan() || x.0.is_infinite() || x.0.eq_zero() {
        let sign = if x.0.is_sign_negative() { -1.0 } else { 1.0 };
        return match (x.0.is_nan(), x.0.is_infinite()) {
            (true, _) => f64::NAN,
            (_, true) => sign * f64::INFINITY,
            _ => sign * 0.0,
        };
    }
    let (high, low) = x.0.to_bits();
    let exponent = (high >> FRACTION) as i32 & 0x7_ffff;
    // The first 64 bits, of which the last one stands for all that follow.
    let significand = (1 << FRACTION) | (high & ((1 << FRACTION) - 1));
    let rest = significand & ((1 << (FRACTION - 63)) - 1) != 0 || low != 0;
    let first = (significand >> (FRACTION - 63)) as u64 | u64::from(rest);
    let power = (exponent - 0x3_ffff - 63).clamp(-2000, 2000);
    let half = power / 2;
    let size = first as f64 * 2_f64.powi(half) * 2_f64.powi(power - half);
    if x.0.is_sign_negative() { -size } else { size }
}

/// The error function, by a series of which all terms have one sign.
pub fn erf(x: Real) -> Real {
    let twice = 2.0 * x * x;
    let (mut term, mut sum) = (x, x);
    for n in 1..2000 {
        term *= twice / Real::from(2 * n + 1);
        sum += term;
        if term.abs() <= 1e-75 * sum.abs() {
            break;
        }
    }
    sum * (-x * x).exp() * Real(consts::FRAC_2_SQRT_PI)
}

/// The complementary error function; farther out by Laplace's continued fraction.
pub fn erfc(x: Real) -> Real {
    if x < 6.0 {
        return 1.0 - erf(x);
    }
    let fraction = (1..=400)
        .rev()
        .fold(x, |below, n| x + 0.5 * Real::from(n) / below);
    (-x * x).exp() / fraction / Real(consts::SQRT_PI)
}

/// ln Γ of a number above 0: far out by Stirling's series, nearer by what numbers between add.
pub fn ln_gamma(x: Real) -> Real {
    // The Bernoulli numbers over 2k(2k − 1).
    const SERIES: [(f64, f64); 10] = [
        (1.0, 12.0),
        (-1.0, 360.0),
        (1.0, 1260.0),
        (-1.0, 1680.0),
        (1.0, 1188.0),
        (-691.0, 360_360.0),
        (1.0, 156.0),
        (-3617.0, 122_400.0),
        (43_867.0, 244_188.0),
        (-174_611.0, 125_400.0),
    ];
    let (mut far, mut below) = (x, real(1.0));
    while far < 80.0 {
        below *= far;
        far += 1.0;
    }
    let mut power = 1.0 / far;
    let mut rest = real(0.0);
    for (over, under) in SERIES {
        rest += real(over) / under * power;
        power = power / far / far;
    }
    let half_of_log = 0.5 * Real(consts::TAU).ln();
    (far - 0.5) * far.ln() - far + half_of_log + rest - below.ln()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_number_of_237_bits_is_rounded_to_the_nearest_double() {
        for x in [
            1.0,
            -1.5,
            0.1,
            f64::MAX,
            f64::MIN_POSITIVE,
            5e-324,
            1e-310,
            -3e300,
            0.0,
        ] {
            assert_eq!(to_f64(real(x)).to_bits(), x.to_bits(), "{x}");
            // A quarter of the last place changes nothing, three quarters do.
            if x.abs() > 1e-290 && x.abs() < 1e300 {
                let ulp = real(x.next_up()) - x;
                assert_eq!(to_f64(real(x) + 0.25 * ulp), x);
                assert_eq!(to_f64(real(x) + 0.75 * ulp), x.next_up());
            }
        }
        assert!(to_f64(0.0 * Real::INFINITY).is_nan());
        assert_eq!(to_f64(-Real::INFINITY), -f64::INFINITY);
    }

    /// Methods of a number, and of a number and another one.
    #[allow(clippy::type_complexity, reason = "a table of functions")]
    const METHODS: [(&str, fn(Real, Real) -> Real, fn(f64, f64) -> f64); 24] = [
        ("/", |x, y| x / y, |x, y| x / y),
        ("acos", |x, _| x.acos(), |x, _| x.acos()),
        ("asin", |x, _| x.asin(), |x, _| x.asin()),
        ("atan", |x, _| x.atan(), |x, _| x.atan()),
        ("atan2", |x, y| x.atan2(y), f64::atan2),
        ("atanh", |x, _| x.atanh(), |x, _| x.atanh()),
        ("cbrt", |x, _| x.cbrt(), |x, _| x.cbrt()),
        ("cos", |x, _| x.cos(), |x, _| x.cos()),
        ("cosh", |x, _| x.cosh(), |x, _| x.cosh()),
        ("exp", |x, _| x.exp(), |x, _| x.exp()),
        ("exp_m1", |x, _| x.exp_m1(), |x, _| x.exp_m1()),
        ("hypot", |x, y| x.hypot(y), f64::hypot),
        ("ln", |x, _| x.ln(), |x, _| x.ln()),
        ("ln_1p", |x, _| x.ln_1p(), |x, _| x.ln_1p()),
        ("max", |x, y| x.max(y), f64::max),
        ("min", |x, y| x.min(y), f64::min),
        (
            "mul_add",
            |x, y| x.mul_add(y, real(1.0)),
            |x, y| x.mul_add(y, 1.0),
        ),
        ("powf", |x, y| x.powf(y), f64::powf),
        ("powi", |x, _| x.powi(-3), |x, _| x.powi(-3)),
        ("round", |x, _| x.round(), |x, _| x.round()),
        ("signum", |x, _| x.signum(), |x, _| x.signum()),
        ("sin", |x, _| x.sin_cos().0, |x, _| x.sin()),
        ("sqrt", |x, _| x.sqrt(), |x, _| x.sqrt()),
        ("tan", |x, _| x.tan(), |x, _| x.tan()),
    ];

    /// The library is young, and two of its functions are not used because of what this found.
    #[test]
    fn methods_have_the_digits_of_those_of_doubles() {
        let mut hash = 1_u64;
        let mut next = || {
            hash = hash
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            (hash >> 11) as f64 / (1_u64 << 53) as f64
        };
        for k in 0..4000 {
            let [x, y] = [(); 2].map(|()| {
                let size = (0.5 + next()) * 2_f64.powi((next() * 80.0 - 70.0) as i32);
                if next() < 0.5 { -size } else { size }
            });
            // Also of equal size, and almost.
            let y = [y, x, -x, x * (1.0 + 1e-9)][k % 4];
            for (name, precise, double) in METHODS {
                let (found, due) = (to_f64(precise(real(x), real(y))), double(x, y));
                // Doubles may differ in their own last places.
                let near = (found - due).abs() <= 4e-15 * due.abs();
                let same = found.to_bits() == due.to_bits() || found.is_nan() && due.is_nan();
                let beyond = due == 0.0 || !due.is_normal() || due.abs() > 1e300;
                assert!(
                    near || same || beyond,
                    "{name} of {x:e}, {y:e}: {found:e}, {due:e}"
                );
            }
        }
    }

    #[test]
    fn special_functions_have_the_digits_of_the_tables() {
        for x in [-3.0, -0.5, 0.1, 1.0, 2.5, 5.9, 6.1, 20.0] {
            assert!((to_f64(erf(real(x))) - libm::erf(x)).abs() <= 3e-16);
            let (found, due) = (to_f64(erfc(real(x))), libm::erfc(x));
            assert!((found / due - 1.0).abs() <= 1e-14, "{x}: {found} {due}");
        }
        for x in [0.3, 1.5, 17.0, 79.9, 80.1, 1e6] {
            let due = statrs::function::gamma::ln_gamma(x);
            assert!((to_f64(ln_gamma(real(x))) - due).abs() <= 1e-13 * due.abs());
        }
        // Both forms meet.
        let series = 1.0 - erf(real(6.0));
        assert!((series / erfc(real(6.0)) - 1.0).abs() <= 1e-50);
    }
}
