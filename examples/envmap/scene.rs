//! The sky that `sky.png` shows, from formulas: a gradient, a sun 10⁴ times as bright, clouds, a city
//! without a light in it and dark land.
//!
//! Only `f32` arithmetic and this crate's own `poly` functions are used, so that `--make-picture` makes
//! the same picture wherever it runs.

use crate::picture::Picture;
use microwarp::poly as mw;

const SHAPE: [usize; 2] = [256, 128];
/// The texel in whose middle the sun stands: 58 degrees from the zenith.
const SUN: [usize; 2] = [92, 41];
/// The radiance in the middle of the sun; that of the blue sky is about 0.4.
const SUN_RADIANCE: f32 = 9000.0;
/// Half the width of the sun, in radians. It is a bell rather than a disk, or its edge would be all
/// that the texels show.
const SUN_SIZE: f32 = 0.016;

/// Rows that are black all along: the shore, and the tripod below the camera.
const SHORE: std::ops::Range<usize> = 64..66;
const TRIPOD: std::ops::Range<usize> = 118..128;
/// Columns that are black from top to bottom: where the panorama was not closed.
const SEAM: std::ops::Range<usize> = 253..256;
/// The columns of the city, and its highest roof above the shore.
const CITY: std::ops::Range<usize> = 131..236;
const ROOFS: u32 = 15;

pub fn sky() -> Picture {
    let [columns, rows] = SHAPE;
    let [phi, theta] = middle(SUN[0], SUN[1]);
    let sun = direction(phi, theta);
    let mut texels = Vec::with_capacity(columns * rows);
    for row in 0..rows {
        for column in 0..columns {
            let [phi, theta] = middle(column, row);
            texels.push(if is_black(column, row) {
                [0.0; 3]
            } else {
                radiance(direction(phi, theta), sun)
            });
        }
    }
    let picture = Picture {
        shape: SHAPE,
        texels,
    };
    picture.rounded()
}

/// Azimuth and polar angle of the middle of a texel, in turns.
fn middle(column: usize, row: usize) -> [f32; 2] {
    let [columns, rows] = SHAPE.map(|n| n as f32);
    [
        (column as f32 + 0.5) / columns,
        (row as f32 + 0.5) / (2.0 * rows),
    ]
}

fn direction(phi: f32, theta: f32) -> [f32; 3] {
    mw::Spherical::from_turns(1.0, theta, phi)
        .expect("the middle of a texel is on the sphere")
        .to_cartesian()
}

fn is_black(column: usize, row: usize) -> bool {
    if SHORE.contains(&row) || TRIPOD.contains(&row) || SEAM.contains(&column) {
        return true;
    }
    if !CITY.contains(&column) || row >= SHORE.start {
        return false;
    }
    // Houses of four columns and, in every seventh or so, a spire of one; low at the ends of the city.
    let house = (column / 4) as i32;
    let from_end = (column - CITY.start).min(CITY.end - 1 - column) as u32;
    let spire = hash(house, 9) % 7 == 0 && column % 4 == 1;
    let height = 2 + hash(house, 5) % (ROOFS - 6) + if spire { 5 } else { 0 };
    SHORE.start - row <= (height.min(1 + from_end / 2)) as usize
}

fn radiance([x, y, z]: [f32; 3], sun: [f32; 3]) -> [f32; 3] {
    let cosine = x * sun[0] + y * sun[1] + z * sun[2];
    // 2 − 2 cos is the square of the chord: the squared angle near the sun, and finite everywhere.
    let chord = (2.0 - 2.0 * cosine).max(0.0);
    if z < 0.0 {
        return land(x, y, -z);
    }
    let bell = 1.0 + chord / (SUN_SIZE * SUN_SIZE);
    let disk = SUN_RADIANCE / (bell * bell * bell);
    let glow = 1.0 / (1.0 + 14.0 * chord);

    let low = (1.0 - z) * (1.0 - z);
    let haze = low * low * low;
    let blue = mix([0.10, 0.26, 0.66], [0.34, 0.58, 0.95], low);
    let clear = mix(blue, [1.05, 0.86, 0.68], haze);

    // Clouds lie on a plane overhead: they crowd towards the horizon, and end in its haze.
    let (u, v) = (2.1 * x / (z + 0.13), 2.1 * y / (z + 0.13));
    let thick = fractal(u, v);
    // Thinner on the side of the sun than here: this side is lit.
    let toward = fractal(u + 0.22 * sun[0], v + 0.22 * sun[1]);
    let cover = smooth((thick - 0.47) / 0.22) * smooth(z / 0.16);
    let lit = (0.72 + 2.2 * (thick - toward)).clamp(0.30, 1.25);
    let cloud = [1.0, 0.97, 0.94].map(|c| c * lit * (0.85 + 2.0 * glow));

    let veiled = mix(clear, cloud, 0.93 * cover);
    let warm = [1.0, 0.80, 0.52];
    let through = disk * (1.0 - 0.6 * cover);
    std::array::from_fn(|k| veiled[k] + 1.1 * glow * glow * warm[k] + through * warm[k].max(0.7))
}

fn land(x: f32, y: f32, down: f32) -> [f32; 3] {
    let (u, v) = (3.0 * x / (down + 0.08), 3.0 * y / (down + 0.08));
    let rough = fractal(u, v);
    let soil = mix([0.030, 0.036, 0.016], [0.105, 0.085, 0.045], rough);
    mix(soil, [0.16, 0.13, 0.11], smooth(1.0 - down / 0.25))
}

fn mix(a: [f32; 3], b: [f32; 3], t: f32) -> [f32; 3] {
    std::array::from_fn(|k| a[k] + t * (b[k] - a[k]))
}

/// From 0 to 1 with level ends.
fn smooth(t: f32) -> f32 {
    let t = t.clamp(0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}

/// Value noise in five octaves, from 0 to 1.
fn fractal(x: f32, y: f32) -> f32 {
    let (mut sum, mut size, mut scale) = (0.0, 0.5, 1.0);
    for octave in 0..5 {
        // Each octave is moved, or all of them would have a corner at the zenith.
        let shift = 17.3 * octave as f32;
        sum += size * noise(x * scale + shift, y * scale - shift);
        size *= 0.5;
        scale *= 2.0;
    }
    sum / 0.96875
}

/// Random values on the corners of a lattice, smoothly joined.
fn noise(x: f32, y: f32) -> f32 {
    let (column, row) = (x.floor(), y.floor());
    let (s, t) = (smooth(x - column), smooth(y - row));
    let (column, row) = (column as i32, row as i32);
    let value = |i, j| hash(column + i, row + j) as f32 / 16_777_216.0;
    let upper = value(0, 0) + s * (value(1, 0) - value(0, 0));
    let lower = value(0, 1) + s * (value(1, 1) - value(0, 1));
    upper + t * (lower - upper)
}

/// 24 bits that look random: rounds of multiplication and of folding the upper half onto the lower.
fn hash(x: i32, y: i32) -> u32 {
    let mut h = (x as u32).wrapping_mul(0x8da6_b343) ^ (y as u32).wrapping_mul(0xd816_3841);
    for _ in 0..2 {
        h = (h ^ h >> 16).wrapping_mul(0x7feb_352d);
        h = (h ^ h >> 15).wrapping_mul(0x846c_a68b);
    }
    (h ^ h >> 16) >> 8
}
