//! Vectors in twice the digits of a number, for differences of coordinates and the determinants of those.

use crate::num::{product, two_sum};

/// A number as a rounded part and a rest.
pub(in crate::warp) type Two = (f32, f32);
/// A vector of those.
pub(in crate::warp) type Exact = [Two; 3];

/// p − q, exactly.
pub(in crate::warp) fn difference(p: [f32; 3], q: [f32; 3]) -> Exact {
    let ([a, b, c], [d, e, f]) = (p, q);
    [two_sum(a, -d), two_sum(b, -e), two_sum(c, -f)]
}

/// p + q, to 2⁻⁴⁷ or so.
pub(in crate::warp) fn sum(p: Exact, q: Exact) -> Exact {
    let ([a, b, c], [d, e, f]) = (p, q);
    [plus(a, d), plus(b, e), plus(c, f)]
}

/// −p.
pub(in crate::warp) fn negative(p: Exact) -> Exact {
    p.map(|(x, rest)| (-x, -rest))
}

fn plus(p: Two, q: Two) -> Two {
    let (sum, dropped) = two_sum(p.0, q.0);
    two_sum(sum, dropped + (p.1 + q.1))
}

fn minus(p: Two, q: Two) -> Two {
    plus(p, (-q.0, -q.1))
}

pub(super) fn cross(p: &Exact, q: &Exact) -> Exact {
    let ([a, b, c], [d, e, f]) = (*p, *q);
    [
        minus(product(b, f), product(c, e)),
        minus(product(c, d), product(a, f)),
        minus(product(a, e), product(b, d)),
    ]
}

pub(super) fn exact_dot(p: &Exact, q: &Exact) -> f32 {
    let ([a, b, c], [d, e, f]) = (*p, *q);
    plus(plus(product(a, d), product(b, e)), product(c, f)).0
}

/// The largest coordinate.
pub(super) fn largest(vectors: &[Exact; 3]) -> f32 {
    let mut largest = 0.0;
    for (x, _) in vectors.as_flattened() {
        if x.abs() > largest {
            largest = x.abs();
        }
    }
    largest
}

/// Multiplies vectors by a power of two.
pub(super) fn scale(vectors: &mut [Exact; 3], by: f32) {
    for (x, rest) in vectors.as_flattened_mut() {
        *x *= by;
        *rest *= by;
    }
}

/// The power of two at or below a normal number.
pub(super) fn binade(x: f32) -> f32 {
    f32::from_bits(x.to_bits() & 0x7f80_0000)
}
