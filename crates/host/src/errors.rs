//! Errors of numbers: in units of the last place, relative, and the figures of many.

/// The spacing of `f32` at the magnitude of an exact value; that of the subnormals below them.
pub fn ulp(x: f64) -> f64 {
    let exponent = ((x.abs().to_bits() >> 52) as i32 - 1023).clamp(-126, 127);
    f64::from_bits(((exponent - 23 + 1023) as u64) << 52)
}

/// The error of a number in ulp of the exact value.
pub fn ulps(got: f32, exact: f64) -> f64 {
    (f64::from(got) - exact).abs() / ulp(exact)
}

/// The error of a number in parts of the exact value; 0 where both are the same, infinite ones among them.
pub fn relative(got: f64, exact: f64) -> f64 {
    if got == exact {
        0.0
    } else {
        (got - exact).abs() / exact.abs()
    }
}

/// NaN, which would lose every comparison, as infinite.
pub fn or_infinite(error: f64) -> f64 {
    if error.is_nan() { f64::INFINITY } else { error }
}

/// Raises a maximum, and says whether it did. NaN counts as infinite.
pub fn raise(maximum: &mut f64, error: f64) -> bool {
    let error = or_infinite(error);
    let higher = error > *maximum;
    if higher {
        *maximum = error;
    }
    higher
}

/// The distance of two uniforms, across the seam where they are turns.
pub fn apart(a: f64, b: f64, turns: bool) -> f64 {
    let d = (a - b).abs();
    if turns { d.min((1.0 - d).abs()) } else { d }
}

/// Errors with their signs: the largest magnitude and where it was met, the root of the mean square, and the mean.
#[derive(Clone, Copy, Debug, Default)]
pub struct Errors<At> {
    pub max: f64,
    pub at: At,
    squares: f64,
    sum: f64,
    count: f64,
}

impl<At: Copy> Errors<At> {
    pub fn observe(&mut self, at: At, error: f64) {
        self.observe_extreme(at, error);
        self.squares += error * error;
        self.sum += error;
        self.count += 1.0;
    }

    /// An error that counts for the largest alone, of inputs that are tried for their place: there are more of them
    /// than in a fair sample.
    pub fn observe_extreme(&mut self, at: At, error: f64) {
        if raise(&mut self.max, error.abs()) {
            self.at = at;
        }
    }

    pub fn join(&mut self, other: &Self) {
        self.join_extreme(other);
        self.squares += other.squares;
        self.sum += other.sum;
        self.count += other.count;
    }

    pub fn join_extreme(&mut self, other: &Self) {
        self.observe_extreme(other.at, other.max);
    }

    pub fn rms(&self) -> f64 {
        (self.squares / self.count).sqrt()
    }

    pub fn mean(&self) -> f64 {
        self.sum / self.count
    }
}

#[test]
fn a_maximum_is_raised_by_what_is_no_number() {
    let mut most = 1.0;
    assert!(!raise(&mut most, 0.5) && raise(&mut most, 2.0) && most == 2.0);
    assert!(raise(&mut most, f64::NAN) && most == f64::INFINITY && !raise(&mut most, f64::NAN));
    assert_eq!(ulp(1.0), f64::from(f32::EPSILON));
    assert_eq!(ulp(0.0), f64::from(f32::from_bits(1)));
    assert_eq!(ulps(1.0, 1.0 + 3.0 * ulp(1.0)), 3.0);
    let mut errors = Errors::default();
    for (at, error) in [(1, -3.0), (2, 1.0), (3, -2.0), (4, 2.0)] {
        errors.observe(at, error);
    }
    errors.observe_extreme(5, 7.0);
    assert_eq!((errors.max, errors.at), (7.0, 5));
    assert_eq!((errors.rms(), errors.mean()), (4.5_f64.sqrt(), -0.5));
}
