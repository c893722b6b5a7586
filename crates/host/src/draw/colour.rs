//! The palette that all pictures share.

/// Red, green, blue, opacity.
pub type Colour = [u8; 4];

/// Text, axes.
pub const INK: Colour = [31, 42, 55, 255];
/// Secondary text.
pub const MUTED: Colour = [98, 110, 124, 255];
/// Hair lines behind the data.
pub const HAIR: Colour = [205, 212, 220, 255];
/// What is computed rather than sampled: density curves, axes of lobes.
pub const ACCENT: Colour = [200, 78, 48, 255];
/// Samples.
pub const POINT: Colour = [18, 52, 88, 255];
/// Histogram bars.
pub const BAR: Colour = [183, 206, 228, 255];
pub const WHITE: Colour = [255, 255, 255, 255];

/// The colour of a density between 0 and 1, where 1 is the largest in the picture.
pub fn ramp(t: f64) -> [f64; 3] {
    const STOPS: [[f64; 3]; 3] = [
        [255.0, 255.0, 255.0],
        [208.0, 223.0, 237.0],
        [150.0, 186.0, 219.0],
    ];
    let t = 2.0 * t.clamp(0.0, 1.0);
    let (from, to, t) = if t < 1.0 { (0, 1, t) } else { (1, 2, t - 1.0) };
    std::array::from_fn(|k| STOPS[from][k] + t * (STOPS[to][k] - STOPS[from][k]))
}

/// The same colour at the given opacity.
pub fn faded(colour: Colour, opacity: f32) -> Colour {
    let [r, g, b, a] = colour;
    [r, g, b, (f32::from(a) * opacity) as u8]
}

// Light and paper: what is seen of a texel in print.

/// A radiance on paper: film that saturates slowly, and the exponent of a screen.
pub fn tone(texel: [f64; 3]) -> [f64; 3] {
    texel.map(|c| 255.0 * (1.0 - (-1.5 * c).exp()).powf(1.0 / 2.2))
}
