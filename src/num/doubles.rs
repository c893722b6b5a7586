//! Functions of doubles for tables that the compiler fills: no double reaches the target.

/// e^x for 0 ≤ x ≤ 8, by its series.
pub(crate) const fn exp(x: f64) -> f64 {
    let (mut term, mut sum, mut n) = (1.0, 0.0, 1.0);
    while n < 60.0 {
        sum += term;
        term *= x / n;
        n += 1.0;
    }
    sum
}

/// ln x for 0 < x ≤ 1: the powers of 2 apart, then the series of artanh near 1.
pub(crate) const fn ln(x: f64) -> f64 {
    let (mut near, mut twos) = (x, 0.0);
    while near < core::f64::consts::FRAC_1_SQRT_2 {
        near *= 2.0;
        twos += 1.0;
    }
    let s = (near - 1.0) / (near + 1.0);
    let (mut power, mut sum, mut n) = (2.0 * s, 0.0, 1.0);
    while n < 40.0 {
        sum += power / n;
        power *= s * s;
        n += 2.0;
    }
    sum - twos * core::f64::consts::LN_2
}
