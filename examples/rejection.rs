//! Rejection: points of a simple domain are proposed, and some of them are kept. The share that is kept is the efficiency:
//! π/4 for the disk in its square, π/6 for the ball in its cube, ln 2 for the density 1/(1 + r²) proposed by the disk.
//! The tries that a point takes are geometric.
//!
//! `cargo run --release --example rejection [FILE]` prints both beside theory and draws `target/rejection.png`. On the left
//! are the points of the square, red where they are thrown away, on the right those of the density.

use microwarp::rejection::{BallRejection, Bounded, Failure, Region, Rejection};
use microwarp::{Warp, poly as mw};
use rand_pcg::Pcg32;
use std::error::Error;
use std::f64::consts::{FRAC_PI_4, FRAC_PI_6, LN_2};
use std::fs::File;

const POINTS: u32 = 1_000_000;
/// Pixels along a side of a picture, and how many points it shows.
const SIDE: usize = 320;
const SHOWN: usize = 6_000;

fn main() -> Result<(), Box<dyn Error>> {
    let square = mw::Aabb::new([-1.0; 2], [1.0; 2])?;
    let inside = |[x, y]: [f32; 2]| x * x + y * y <= 1.0;
    let disk = Region::new(square, inside);
    // f ≤ c p: the density of the disk is p = 1/π, so c = π is enough.
    let bump = |[x, y]: [f32; 2]| 1.0 / (1.0 + x * x + y * y);
    let bump = Bounded::new(mw::Disk::new(), bump, std::f32::consts::PI)?;

    let points_of = measure("disk in its square", &disk, FRAC_PI_4)?;
    measure("ball in its cube", &BallRejection::new(), FRAC_PI_6)?;
    measure("1/(1 + r²) by the disk", &bump, LN_2)?;
    println!("tries of the disk   share   geometric");
    for (k, count) in (1..=5).zip(points_of) {
        let due = FRAC_PI_4 * (1.0 - FRAC_PI_4).powi(k - 1);
        let share = f64::from(count) / f64::from(POINTS);
        println!("{k:>17}  {share:.5}   {due:.5}");
        let error = (due * (1.0 - due) / f64::from(POINTS)).sqrt();
        assert!((share - due).abs() <= 6.0 * error, "not geometric");
    }

    let mut rng = Pcg32::new(42, 55);
    let mut picture = vec![[255_u8; 3]; 2 * SIDE * SIDE];
    for _ in 0..SHOWN {
        let proposed = square.draw(&mut rng);
        let kept = inside(proposed);
        let colour = if kept { [20, 40, 90] } else { [220, 90, 70] };
        picture[pixel(proposed, 0)] = colour;
        picture[pixel(bump.draw(&mut rng)?.point, SIDE)] = [20, 40, 90];
    }
    save("target/rejection.png", 2 * SIDE, &picture)
}

/// Holds the efficiency to the exact one. Returns how many points took one try, two, and so on.
fn measure<S: Rejection>(name: &str, sampler: &S, exact: f64) -> Result<[u32; 12], Failure> {
    let mut rng = Pcg32::new(42, 54);
    let (mut points_of, mut tries) = ([0; 12], 0);
    for _ in 0..POINTS {
        // Every point knows how many tries it took. A spent budget would be an error, not a hang.
        let accepted = sampler.draw(&mut rng)?;
        tries += u64::from(accepted.tries);
        points_of[accepted.tries.min(12) as usize - 1] += 1;
    }
    let efficiency = f64::from(POINTS) / tries as f64;
    let off = (efficiency - exact) / (exact * (1.0 - exact) / tries as f64).sqrt();
    println!("{name}: efficiency {efficiency:.5}, exact {exact:.5}, {off:+.1} standard errors");
    assert!(off.abs() <= 6.0, "the efficiency is wrong");
    Ok(points_of)
}

/// The pixel of a point of [−1, 1)², from this column on.
fn pixel(point: [f32; 2], from: usize) -> usize {
    let [column, row] = point.map(|c| (0.5 * (c + 1.0) * SIDE as f32) as usize);
    row.min(SIDE - 1) * 2 * SIDE + from + column.min(SIDE - 1)
}

/// Writes to the path given as an argument, or to this one.
fn save(path: &str, width: usize, pixels: &[[u8; 3]]) -> Result<(), Box<dyn Error>> {
    std::fs::create_dir_all("target")?;
    let path = std::env::args().nth(1).unwrap_or_else(|| path.into());
    let height = pixels.len() / width;
    let mut file = png::Encoder::new(File::create(&path)?, width as u32, height as u32);
    file.set_color(png::ColorType::Rgb);
    let mut file = file.write_header()?;
    file.write_image_data(pixels.as_flattened())?;
    println!("drew {path}");
    Ok(())
}
