//! Strata and Sobol' points: means over points that are spread evenly have smaller errors. Over a smooth integrand of two
//! dimensions the error of n random points is n^(-1/2), that of one point in each of n cells and of the recurrence R2 n^(-1),
//! that of scrambled Sobol' points nearly n^(-3/2). Over a jump, here the rim of a disk, all of the latter have n^(-3/4).
//!
//! `cargo run --release --example strata_and_sobol [FILE]` prints errors and fitted slopes, and draws
//! `target/strata_and_sobol.png`: 256 points of each, in the order of the table.

use microwarp::uniform::{ByPosition, Points, Recurrence, Sobol, Strata2d};
use rand_pcg::Pcg32;
use std::error::Error;
use std::f64::consts::FRAC_PI_4;
use std::fs::File;

/// Sets of points behind each error.
const SETS: u32 = 128;
/// Pixels along a side of a picture, and between two of them.
const SIDE: usize = 256;
const GAP: usize = 8;

/// Makes n points of a seed.
type Make = fn(u32, u32) -> Set;
type Set = Result<Vec<[f32; 2]>, microwarp::Error>;

fn main() -> Result<(), Box<dyn Error>> {
    let sobol: Make = |seed, n| Ok(points(Sobol::<2>::new(seed)?, n));
    let recurrence: Make = |seed, n| Ok(points(Recurrence::<2>::new(seed)?, n));
    let random: Make = |seed, n| Ok(points(ByPosition::new(seed, 0), n));
    let columns: [(&str, Make, [f64; 2]); 4] = [
        ("random", random, [-0.5, -0.5]),
        ("strata", strata, [-1.0, -0.75]),
        // Its errors come in waves about these rates.
        ("R2", recurrence, [-1.0, -0.75]),
        ("Sobol'", sobol, [-1.5, -0.75]),
    ];
    println!("n = 64 to 16,384 points, slope (theory): smooth, then a disk");
    let width = columns.len() * (SIDE + GAP) - GAP;
    let mut picture = vec![255_u8; width * SIDE];
    for (k, (name, make, theory)) in columns.iter().enumerate() {
        print!("{name:<8}");
        hold(*make, smooth, theory[0])?;
        hold(*make, disk, theory[1])?;
        println!();
        for point in make(1, 256)? {
            let [column, row] = point.map(|c| (c * SIDE as f32) as usize);
            for corner in [0, 1, width, width + 1] {
                let pixel = row.min(SIDE - 2) * width + k * (SIDE + GAP) + column.min(SIDE - 2);
                picture[pixel + corner] = 30;
            }
        }
    }

    std::fs::create_dir_all("target")?;
    let path = std::env::args().nth(1);
    let path = path.unwrap_or_else(|| "target/strata_and_sobol.png".into());
    let mut file = png::Encoder::new(File::create(&path)?, width as u32, SIDE as u32);
    file.set_color(png::ColorType::Grayscale);
    file.write_header()?.write_image_data(&picture)?;
    println!("drew {path}");
    Ok(())
}

fn points(points: impl Points, n: u32) -> Vec<[f32; 2]> {
    (0..n).map(|i| points.point(i)).collect()
}

fn strata(seed: u32, n: u32) -> Set {
    let cells = Strata2d::new(n.isqrt(), n.isqrt())?;
    let mut rng = Pcg32::new(u64::from(seed), 1);
    Ok((0..n).map(|cell| cells.draw(cell, &mut rng)).collect())
}

/// Of mean 1.
fn smooth([x, y]: [f32; 2]) -> f64 {
    4.0 / f64::from((1.0 + x) * (1.0 + y)).powi(2)
}

/// Of mean 1, with a jump.
fn disk([x, y]: [f32; 2]) -> f64 {
    f64::from(u8::from(x * x + y * y < 1.0)) / FRAC_PI_4
}

/// Holds the slope of the errors, fitted by least squares in the logarithms, to that of theory.
fn hold(make: Make, integrand: fn([f32; 2]) -> f64, theory: f64) -> Result<(), microwarp::Error> {
    // Numbers of points are 4^k, so their logarithms to base 4 are 3 to 7, and 5 is the middle.
    let mut slope = 0.0;
    for k in 3..=7 {
        let (n, mut squares) = (1 << (2 * k), 0.0);
        for seed in 0..SETS {
            let values = make(seed, n)?.into_iter().map(integrand);
            squares += (values.sum::<f64>() / f64::from(n) - 1.0).powi(2);
        }
        let error = (squares / f64::from(SETS)).sqrt();
        print!(" {error:.0e}");
        slope += f64::from(k - 5) * error.log(4.0) / 10.0;
    }
    print!("  {slope:.2} ({theory:.2})");
    // Half the distance between two of these rates.
    assert!((slope - theory).abs() < 0.125, "not the slope of theory");
    Ok(())
}
