//! Shows a histogram: the picture it samples, and colours for differences.

use crate::picture::{Picture, sin_of_row};

/// Standard deviations at the ends of the colour scale.
pub const FAR: f64 = 4.0;
const BELOW: [f64; 3] = [26.0, 84.0, 148.0];
const ABOVE: [f64; 3] = [200.0, 78.0, 48.0];
/// Cells where there is nothing to expect: the colour of ink, which has a place of its own in the palette.
pub const BLACK: [f64; 3] = [31.0, 42.0, 55.0];

/// From blue over white to red, for so many standard deviations, in thirds of one: the file's 256 colours
/// are not enough for more, and would make unequal steps.
pub fn diverging(deviations: f64) -> [f64; 3] {
    let end = if deviations < 0.0 { BELOW } else { ABOVE };
    let t = (deviations.abs().min(FAR) * 3.0).round() / (3.0 * FAR);
    end.map(|c| 250.0 + t * (c - 250.0))
}

/// The picture that a histogram samples. Each sample has the colour of its texel; the texel's brightness is the number
/// of its samples over sin θ.
pub fn developed(picture: &Picture, histogram: &[u64]) -> Vec<[f64; 3]> {
    let [columns, rows] = picture.shape;
    let samples: u64 = histogram.iter().sum();
    let weights: f64 = picture.weights().iter().map(|&w| f64::from(w)).sum();
    let luminance = picture.luminance();
    let texels = picture.texels.iter().zip(histogram).enumerate();
    let develop = |(i, (texel, &n)): (usize, (&[f32; 3], &u64))| {
        let seen = n as f64 / samples as f64 * weights / sin_of_row(i / columns, rows);
        let gain = if n > 0 { seen / luminance[i] } else { 0.0 };
        texel.map(|c| f64::from(c) * gain)
    };
    texels.map(develop).collect()
}
