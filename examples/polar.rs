//! Polar coordinates, and why there is a root. A disk grows with the square of its radius, so uniform points need r = √u.
//! With r = u, half of the points lie in a quarter of the disk, and the mean radius is 1/2 instead of 2/3.
//!
//! `cargo run --release --example polar [FILE]` counts the points in ten rings of equal area, for both, and draws
//! `target/polar.png`: on the left with the root, on the right without.

use microwarp::{Warp, poly as mw, uniform};
use rand_pcg::Pcg32;
use std::error::Error;
use std::fs::File;

const POINTS: u32 = 1_000_000;
const RINGS: usize = 10;
/// Pixels along a side of a picture, and how many points it shows.
const SIDE: usize = 320;
const SHOWN: u32 = 6_000;

fn main() -> Result<(), Box<dyn Error>> {
    let disk = mw::Disk::new();
    let mut rng = Pcg32::new(42, 54);
    let mut with_root = || disk.draw(&mut rng);
    let mut rng = Pcg32::new(42, 55);
    let mut without = || {
        let (r, turns) = (uniform::grid(&mut rng), uniform::grid(&mut rng));
        let (sin, cos) = (std::f32::consts::TAU * turns).sin_cos();
        [r * cos, r * sin]
    };

    let mut picture = vec![255_u8; 2 * SIDE * SIDE];
    let [mean, chi_square] = examine("r = √u", &mut with_root, &mut picture, 0);
    let [wrong_mean, wrong_chi_square] = examine("r = u ", &mut without, &mut picture, SIDE);

    // Six standard errors of a mean radius, of variance 1/18 with the root and 1/12 without. With nine degrees of freedom
    // χ² exceeds 60 once in a billion.
    let error = |variance: f64| 6.0 * (variance / f64::from(POINTS)).sqrt();
    assert!((mean - 2.0 / 3.0).abs() <= error(1.0 / 18.0));
    assert!(chi_square <= 60.0);
    assert!((wrong_mean - 0.5).abs() <= error(1.0 / 12.0));
    assert!(
        wrong_chi_square > 1000.0,
        "the test lets the wrong map pass"
    );
    save("target/polar.png", 2 * SIDE, &picture)
}

/// The mean radius, and χ² of the numbers of points in the rings. Draws the first points from this column on.
fn examine(
    name: &str,
    draw: &mut dyn FnMut() -> [f32; 2],
    picture: &mut [u8],
    from: usize,
) -> [f64; 2] {
    let (mut sum, mut rings) = (0.0, [0_u32; RINGS]);
    for i in 0..POINTS {
        let [x, y] = draw();
        let square = x * x + y * y;
        sum += f64::from(square).sqrt();
        // Rings of equal area have borders at equal distances of r².
        rings[((square * RINGS as f32) as usize).min(RINGS - 1)] += 1;
        if i < SHOWN {
            let [column, row] = [x, y].map(|c| (0.5 * (c + 1.0) * SIDE as f32) as usize);
            picture[row.min(SIDE - 1) * 2 * SIDE + from + column.min(SIDE - 1)] = 40;
        }
    }
    let mean = sum / f64::from(POINTS);
    let due = f64::from(POINTS) / RINGS as f64;
    let squares = rings.iter().map(|&n| (f64::from(n) - due).powi(2));
    let chi_square = squares.sum::<f64>() / due;
    println!("{name}: mean radius {mean:.4}, χ² = {chi_square:.1}, rings {rings:?}");
    [mean, chi_square]
}

/// Writes to the path given as an argument, or to this one.
fn save(path: &str, width: usize, pixels: &[u8]) -> Result<(), Box<dyn Error>> {
    std::fs::create_dir_all("target")?;
    let path = std::env::args().nth(1).unwrap_or_else(|| path.into());
    let height = pixels.len() / width;
    let mut file = png::Encoder::new(File::create(&path)?, width as u32, height as u32);
    file.set_color(png::ColorType::Grayscale);
    file.write_header()?.write_image_data(pixels)?;
    println!("drew {path}");
    Ok(())
}
