//! A sky as a distribution of directions: a picture by latitude and longitude, whose pixels are chosen by their light. A sun
//! of one pixel in 8,192 gives most of the light. Directions that know nothing of it find it rarely, and their estimate of
//! the light on a level plane is noisy.
//!
//! `cargo run --release --example sky [FILE]` prints that light by three ways to choose directions beside the exact value,
//! and draws `target/sky.png`: the sky, and below it where half a million directions of its distribution fell.

use microwarp::estimate::Integral;
use microwarp::{Warp, poly as mw};
use rand_pcg::Pcg32;
use std::error::Error;
use std::f64::consts::{PI, TAU};
use std::fs::File;

const COLUMNS: usize = 128;
const ROWS: usize = 64;
const DIRECTIONS: u32 = 500_000;

fn main() -> Result<(), Box<dyn Error>> {
    let row = |row| std::array::from_fn(|column| radiance(row, column));
    let sky: [[f32; COLUMNS]; ROWS] = std::array::from_fn(row);
    let map = mw::LatLongMap::new(&sky)?;
    let look = |direction| {
        let [column, row] = map.pixel(direction);
        sky[row][column]
    };

    // ∫ L cos θ dω over the upper half, where L is constant in a pixel.
    let mut exact = 0.0;
    for (row, line) in sky.iter().enumerate().take(ROWS / 2) {
        let zone = edge(row + 1).sin().powi(2) - edge(row).sin().powi(2);
        let light: f32 = line.iter().sum();
        exact += f64::from(light) * 0.5 * zone * TAU / COLUMNS as f64;
    }
    println!("exactly {exact:.4}");
    let [by_map, by_cosine, by_uniform] = [
        light("the map   ", &map, look, exact),
        light("the cosine", &mw::CosineHemisphere::new(), look, exact),
        light("uniform   ", &mw::Sphere::new(), look, exact),
    ];
    let times = by_uniform / by_map;
    println!("as good an estimate takes {times:.0} times as many uniform directions");
    assert!(100.0 * by_map < by_cosine && by_cosine < by_uniform);

    // A pixel's share of directions, times all light over the solid angle of the pixel, is its radiance again.
    let mut copy = [[0.0; COLUMNS]; ROWS];
    let mut rng = Pcg32::new(7, 7);
    for _ in 0..DIRECTIONS {
        let sample = map.draw_pixel(&mut rng);
        let [column, row] = sample.pixel;
        assert!(sky[row][column] > 0.0, "a black pixel was drawn");
        let angle = TAU / COLUMNS as f64 * (edge(row).cos() - edge(row + 1).cos());
        copy[row][column] += sky[row][column] / sample.pdf / (angle as f32 * DIRECTIONS as f32);
    }

    std::fs::create_dir_all("target")?;
    let path = std::env::args().nth(1);
    let path = path.unwrap_or_else(|| "target/sky.png".into());
    let grey = |l: f32| (255.0 * (l / (0.5 + l)).powf(0.6)) as u8;
    let both = [sky, copy].concat();
    let pixels: Vec<u8> = both.into_iter().flatten().map(grey).collect();
    let mut file = png::Encoder::new(File::create(&path)?, COLUMNS as u32, 2 * ROWS as u32);
    file.set_color(png::ColorType::Grayscale);
    file.write_header()?.write_image_data(&pixels)?;
    println!("drew {path}");
    Ok(())
}

/// The polar angle of the upper edge of a row.
fn edge(row: usize) -> f64 {
    PI * row as f64 / ROWS as f64
}

/// Blue, brighter about a sun, over dark land; the horizon is black.
fn radiance(row: usize, column: usize) -> f32 {
    match row.abs_diff(17).pow(2) + column.abs_diff(40).pow(2) {
        0 => 4000.0,
        away if row < 30 => 0.2 + 20.0 / (10.0 + away as f32),
        _ if row < 34 => 0.0,
        _ => 0.08,
    }
}

/// The light on a level plane by directions of this distribution. Returns the variance of an estimate.
fn light<W>(name: &str, directions: &W, look: impl Fn([f32; 3]) -> f32, exact: f64) -> f64
where
    W: Warp<Point = [f32; 3], Density = f32>,
{
    let mut rng = Pcg32::new(42, 54);
    let mut integral = Integral::new();
    for _ in 0..DIRECTIONS {
        let (direction, pdf) = directions.draw_with_pdf(&mut rng);
        integral.push(look(direction) * direction[2].max(0.0), pdf);
    }
    let [estimate, error] =
        [integral.estimate(), integral.standard_error()].map(|x| f64::from(x.unwrap_or(f32::NAN)));
    println!("{name} {estimate:.4} ± {error:.4}");
    assert!((estimate - exact).abs() <= 6.0 * error, "{name} is biased");
    error * error
}
