//! Interpolation between two numbers that never steps back.

use crate::error::{Error, finite, tried};

/// Monotone interpolation from one number to another.
///
/// Between numbers of one sign it is start + t(end − start), with the difference formed once: each point gets its share of
/// the uniforms, up to the rounding of its own cell, even where points are few. Otherwise it is (1 − t)start + t end,
/// because a difference would lose digits, or overflow. Every operation is monotone in t, and so is the whole. For t < 1
/// the result does not pass the end, but may round to it.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(crate) struct Segment {
    anchor: f32,
    near: f32,
    far: f32,
}

impl Segment {
    pub(crate) const fn new(start: f32, end: f32) -> Self {
        let (anchor, near, far) = if (start > 0.0 && end > 0.0) || (start < 0.0 && end < 0.0) {
            (start, 0.0, end - start)
        } else {
            (0.0, start, end)
        };
        Self { anchor, near, far }
    }

    /// The start; exact, since one of the two is 0.
    #[inline]
    pub(crate) const fn start(&self) -> f32 {
        self.anchor + self.near
    }

    #[inline]
    pub(crate) fn at(&self, t: f32) -> f32 {
        self.anchor + ((1.0 - t) * self.near + t * self.far)
    }
}

/// Refuses bounds that are not finite or not in order. Returns a scale, which is 1, or 1/2 where the length would
/// overflow; and the length times that scale. The bounds are the parameters of these places.
pub(crate) const fn extent([a, b]: [f32; 2], places: [usize; 2]) -> Result<(f32, f32), Error> {
    tried!(finite(a, places[0]));
    tried!(finite(b, places[1]));
    if a > b {
        return Err(Error::Reversed(places[1]));
    }
    let scale = if (b - a).is_finite() { 1.0 } else { 0.5 };
    Ok((scale, b * scale - a * scale))
}

/// The representable neighbour of `from` towards a different `to`.
pub(crate) const fn neighbour(from: f32, to: f32) -> f32 {
    let bits = from.to_bits();
    let up = to > from;
    if from == 0.0 {
        return if up {
            f32::from_bits(1)
        } else {
            f32::from_bits(0x8000_0001)
        };
    }
    if (from > 0.0) == up {
        f32::from_bits(bits.wrapping_add(1))
    } else {
        f32::from_bits(bits.wrapping_sub(1))
    }
}
