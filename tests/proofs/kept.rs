//! The worst cases that searches have kept, and the largest errors there.

use host::adversary::kept;
use host::figures::{Exact, Figures, polar_error, sample_error};
use host::registry::{Registered, registered};

/// The kept cases of a constructor: parameters and uniforms.
pub fn cases(of: &Registered) -> Vec<(Vec<f32>, [f32; 4])> {
    let label = [of.name, of.constructor, of.tier];
    let words = label.into_iter().filter(|word| !word.is_empty());
    let label = words.collect::<Vec<_>>().join(" ");
    let all = kept::cases("accuracy/worst.csv").into_iter();
    let own = all.filter(|(of, ..)| *of == label);
    own.map(|(_, parameters, u)| {
        let parameters = parameters.into_iter().map(f32::from_bits);
        (parameters.collect(), u.map(f32::from_bits))
    })
    .collect()
}

/// The largest error of a row in `libm` and in `poly`.
pub fn largest(name: &str, title: &str) -> [f64; 2] {
    let mut largest = [Figures::default(); 2];
    for of in registered().iter().filter(|of| of.name == name) {
        for (parameters, u) in cases(of) {
            let entry = of.of_drawn(&parameters).expect("accepted parameters");
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
    }
    largest.map(|figures| match title {
        _ if title.starts_with("sample") => figures.sample,
        "unit length" => figures.length,
        _ => figures.sine,
    })
}
