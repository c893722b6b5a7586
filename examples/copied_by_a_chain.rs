//! A picture copied by a Metropolis chain: the state is a pixel, the target its brightness, and what is counted is how long
//! the chain stays. Over n mutations a pixel its error falls as n^(-1/2). Counting both states of a step, each with
//! its probability, costs no evaluation and has the smaller error.
//!
//! `cargo run --release --example copied_by_a_chain [FILE]` prints the errors, in units of the mean brightness, and draws
//! `target/copied_by_a_chain.png`: the picture, and its copies after 1, 8 and 256 mutations a pixel.

use microwarp::metropolis::{Chain, UniformIndex};
use rand_pcg::Pcg32;
use std::error::Error;
use std::fs::File;

const WIDTH: usize = 160;
const HEIGHT: usize = 120;
const PIXELS: usize = WIDTH * HEIGHT;

fn main() -> Result<(), Box<dyn Error>> {
    let picture: Vec<f32> = (0..PIXELS).map(brightness).collect();
    let mean = picture.iter().sum::<f32>() / PIXELS as f32;
    let target = |pixel: usize| picture[pixel];

    // A uniform pixel is proposed. The first state is chosen among a thousand by brightness, so that no burn-in is needed.
    let mut rng = Pcg32::new(1997, 0);
    let mutation = UniformIndex::new(PIXELS as u32)?;
    let mut chain = Chain::resample(target, &mutation, 1000, &mut rng)?.chain;

    let (mut visits, mut weights) = (vec![0.0; PIXELS], vec![0.0; PIXELS]);
    let (mut sheet, mut first) = (shown(&picture), None);
    println!("mutations   visits    · √n   both states   · √n");
    for n in [1.0_f32, 8.0, 256.0] {
        while chain.steps() < n as u64 * PIXELS as u64 {
            let step = chain.step(target, &mutation, &mut rng);
            visits[step.state()] += 1.0;
            // The proposed state with the probability a that it is accepted, the other with 1 - a.
            for (pixel, weight) in step.recorded() {
                weights[pixel] += weight;
            }
        }
        // The chain gives shares; the mean brightness makes a picture of them.
        let copies =
            [&visits, &weights].map(|w| w.iter().map(|w| w / n * mean).collect::<Vec<_>>());
        let [plain, both] = copies.each_ref().map(|copy| {
            let squares = copy.iter().zip(&picture).map(|(c, p)| (c - p).powi(2));
            (squares.sum::<f32>() / PIXELS as f32).sqrt() / mean
        });
        let [a, b] = [plain, both].map(|error| error * n.sqrt());
        println!("{n:>9}   {plain:>6.3}  {a:>6.2}   {both:>11.3}  {b:>5.2}");
        let first = *first.get_or_insert(b);
        let copied = |(c, p): (&f32, &f32)| *p > 0.0 || *c == 0.0;
        assert!(
            copies[1].iter().zip(&picture).all(copied),
            "black pixels are lit"
        );
        assert!(b < a && (b / first - 1.0).abs() <= 0.1, "not n^(-1/2)");
        sheet.extend(shown(&copies[1]));
    }
    println!(
        "accepted: {:.2} of the proposals",
        chain.acceptance_rate().unwrap_or(f32::NAN)
    );

    std::fs::create_dir_all("target")?;
    let path = std::env::args().nth(1);
    let path = path.unwrap_or_else(|| "target/copied_by_a_chain.png".into());
    let mut file = png::Encoder::new(File::create(&path)?, WIDTH as u32, 4 * HEIGHT as u32);
    file.set_color(png::ColorType::Grayscale);
    file.write_header()?.write_image_data(&sheet)?;
    println!("drew {path}");
    Ok(())
}

/// A ball under a lamp, over a chequered floor and before a black sky.
fn brightness(pixel: usize) -> f32 {
    let x = (pixel % WIDTH) as f32 / HEIGHT as f32 - 0.667;
    let y = 0.5 - (pixel / WIDTH) as f32 / HEIGHT as f32;
    let inside = 0.09 - x * x - y * y;
    if inside > 0.0 {
        let light = (inside.sqrt() * 0.6 + y * 0.6 - x * 0.5) / 0.3;
        return 0.02 + light.max(0.0) + 8.0 * light.max(0.0).powi(60);
    }
    if y > -0.1 {
        return 0.0;
    }
    let (across, away) = ((x / -y * 3.0).floor(), (1.0 / -y).floor());
    if (across + away) % 2.0 == 0.0 {
        0.5
    } else {
        0.08
    }
}

fn shown(picture: &[f32]) -> Vec<u8> {
    let grey = |p: &f32| (255.0 * p.min(1.0).powf(1.0 / 2.2)) as u8;
    picture.iter().map(grey).collect()
}
