//! The cells of the chi-square test: equal parts of the unit interval, square or cube of exact uniforms.

/// How many along each axis; odd, so that no symmetry of a map falls onto a border. Those of `tests/distributions`.
pub fn grid(axes: usize) -> &'static [usize] {
    match axes {
        1 => &[511],
        2 => &[63, 31],
        _ => &[15, 11, 13],
    }
}

pub fn count(axes: usize) -> usize {
    grid(axes).iter().product()
}

/// The part of a uniform, which may be a little outside of the unit interval.
pub fn part(u: f64, parts: usize) -> usize {
    ((u * parts as f64) as usize).min(parts - 1)
}

/// The cell of some uniforms.
pub fn cell(u: [f64; 4], axes: usize) -> usize {
    let parts = grid(axes).iter().zip(u);
    parts.fold(0, |cell, (&parts, u)| cell * parts + part(u, parts))
}
