//! The minors of a triangle: its projections on the planes of two coordinates, whose squares sum up to that of its area.

/// One coordinate of the three vertices.
pub(super) type Row = [i64; 3];

/// The next coordinate of the three vertices, and their remaining coordinates.
pub(super) const fn next(rest: [&[i32]; 3]) -> Option<(Row, [&[i32]; 3])> {
    match rest {
        [[a, a_rest @ ..], [b, b_rest @ ..], [c, c_rest @ ..]] => {
            Some(([*a as i64, *b as i64, *c as i64], [a_rest, b_rest, c_rest]))
        }
        _ => None,
    }
}

/// The three numbers in ascending order.
pub(super) const fn sorted([a, b, c]: Row) -> Row {
    let (low, high) = if a < b { (a, b) } else { (b, a) };
    match c {
        _ if c < low => [c, low, high],
        _ if c > high => [low, high, c],
        _ => [low, c, high],
    }
}

/// Twice the signed area of the triangle's projection on the plane of two coordinates.
pub(super) const fn minor([a1, b1, c1]: Row, [a2, b2, c2]: Row) -> i64 {
    (b1 - a1) * (c2 - a2) - (b2 - a2) * (c1 - a1)
}

/// The two coordinates of the largest projection, and twice its area.
pub(super) const fn largest(vertices: [&[i32]; 3]) -> ([usize; 2], u64) {
    let (mut axes, mut largest, mut i, mut rest) = ([0, 0], 0, 0, vertices);
    while let Some((first, others)) = next(rest) {
        let (mut j, mut later) = (i + 1, others);
        while let Some((second, behind)) = next(later) {
            let minor = minor(first, second).unsigned_abs();
            if minor > largest {
                (axes, largest) = ([i, j], minor);
            }
            (j, later) = (j + 1, behind);
        }
        (i, rest) = (i + 1, others);
    }
    (axes, largest)
}

/// The sum of the squares of all minors, each shifted left beforehand.
pub(super) const fn squares(vertices: [&[i32]; 3], left: i32) -> u128 {
    let (mut sum, mut rest) = (0_u128, vertices);
    while let Some((first, others)) = next(rest) {
        let mut later = others;
        while let Some((second, behind)) = next(later) {
            let minor = shifted(minor(first, second).unsigned_abs(), left) as u128;
            sum += minor * minor;
            later = behind;
        }
        rest = others;
    }
    sum
}

/// A number shifted left, or right where `left` is negative.
const fn shifted(x: u64, left: i32) -> u64 {
    if left > 0 { x << left } else { x >> -left }
}
