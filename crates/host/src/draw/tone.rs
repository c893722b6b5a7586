//! Light and paper: what is seen of a texel in print.

/// A radiance on paper: film that saturates slowly, and the exponent of a screen.
pub fn tone(texel: [f64; 3]) -> [f64; 3] {
    texel.map(|c| 255.0 * (1.0 - (-1.5 * c).exp()).powf(1.0 / 2.2))
}
