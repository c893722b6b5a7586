//! Light and paper: how bright a texel is, and what is seen of it in print.

/// Radiance as the eye weighs its colours, relative: the luminance of Rec. 709.
pub fn luminance(texel: [f32; 3]) -> f64 {
    let [r, g, b] = texel.map(f64::from);
    0.2126 * r + 0.7152 * g + 0.0722 * b
}

/// A radiance on paper: film that saturates slowly, and the exponent of a screen.
pub fn tone(texel: [f64; 3]) -> [f64; 3] {
    texel.map(|c| 255.0 * (1.0 - (-1.5 * c).exp()).powf(1.0 / 2.2))
}
