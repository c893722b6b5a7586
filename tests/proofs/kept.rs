//! The largest errors that searches have met, of the worst cases that are kept.

use host::adversary::kept;
use host::figures::{Exact, Figures, polar_error, sample_error};
use host::registry::{Entry, registered};

/// Every kept case of a warp: the entry, and its uniforms.
pub fn cases(name: &str) -> Vec<(Entry, [f32; 4])> {
    let cases = kept::cases("accuracy/worst.csv");
    let mut all = Vec::new();
    for of in registered().iter().filter(|of| of.name == name) {
        let label = [of.name, of.constructor, of.tier];
        let words = label.iter().filter(|word| !word.is_empty());
        let label = words.copied().collect::<Vec<_>>().join(" ");
        for (_, parameters, u) in cases.iter().filter(|(of, ..)| *of == label) {
            let parameters: Vec<_> = parameters.iter().map(|&x| f32::from_bits(x)).collect();
            let entry = (of.build)(&parameters).expect("accepted parameters");
            all.push((entry, u.map(f32::from_bits)));
        }
    }
    all
}

/// The largest error of a row in `libm` and in `poly`.
pub fn largest(name: &str, title: &str) -> [f64; 2] {
    let mut largest = [Figures::default(); 2];
    for (entry, u) in cases(name) {
        let tiers = match entry.tier {
            "libm" => 0..1,
            _ if entry.tiered => 1..2,
            _ => 0..2,
        };
        for figures in &mut largest[tiers] {
            let x = entry.warp.sample(u);
            sample_error(&entry, &Exact::of(&entry, u, false), x, figures);
            if entry.polar {
                let u = [u[0], 0.0, 0.0, 0.0];
                let x = entry.warp.sample(u);
                polar_error(&entry, &Exact::of(&entry, u, false), x, figures);
            }
        }
    }
    largest.map(|figures| match title {
        "sample" => figures.sample,
        "unit length" => figures.length,
        _ => figures.sine,
    })
}
