//! The disk and the normals.

use super::family::{
    Family, STEP, Subject, beyond, check, density_error, family, in_format, one, uniform,
};
use crate::raw::{OfWords, Raw, Words, accepted, raw, signed};
use fixed::types::U32F0;
use microwarp::fixed::warp::{Bilinear, Disk, NormalPair, StandardNormalPair};
use std::f64::consts::TAU;

/// The point of a radius at a phase.
pub fn around(radius: f64, phase: u32) -> [f64; 2] {
    // The phase to the nearest quarter exactly.
    let (sin, cos) = (f64::from((phase << 2) as i32) * super::family::WORD * TAU / 4.0).sin_cos();
    let [x, y] = match phase.wrapping_add(1 << 29) >> 30 {
        0 => [cos, sin],
        1 => [-sin, cos],
        2 => [-cos, -sin],
        _ => [sin, -cos],
    };
    [radius * x, radius * y]
}

/// The distance of a number of turns from a phase.
pub fn turns(got: u32, phase: u32) -> f64 {
    f64::from(got.wrapping_sub(phase) as i32) * super::family::WORD
}

fn disk(warp: Box<dyn Raw>) -> Option<Subject> {
    Subject::new(vec![], move |words, errors| {
        let sample = warp.sample(&words);
        let [x, y] = [0, 1].map(|i| i64::from(sample[i] as i32));
        check(x * x + y * y <= 1 << 60, "outside")?;
        check(warp.pdf(&sample) > 0, "no density at a sample")?;
        let r = uniform(words[0]).sqrt();
        let (point, due): ([f64; 2], _) = (signed(sample, STEP), around(r, words[1]));
        errors[0] = [0, 1]
            .map(|i| (point[i] - due[i]).abs())
            .into_iter()
            .fold(0.0, f64::max);
        let back = warp.invert(&sample);
        let first = (uniform(back[0]) - uniform(words[0])).abs();
        errors[1] = first.max((turns(back[1], words[1]) * r).abs());
        Ok(())
    })
}

fn radius(u: u32) -> f64 {
    (-2.0 * (-uniform(u)).ln_1p()).sqrt()
}

/// The round trip of the first uniform, and of the second as a distance along the circle of the radius.
fn back_error(back: Words, words: [u32; 2]) -> f64 {
    let first = (uniform(back[0]) - uniform(words[0])).abs();
    first.max((turns(back[1], words[1]) * TAU * radius(words[0]).min(1.0)).abs())
}

fn standard(warp: Box<dyn Raw>) -> Option<Subject> {
    const STEP: f64 = 1.0 / 134_217_728.0;
    Subject::new(vec![], move |words, errors| {
        let sample = warp.sample(&words);
        let point: [f64; 2] = signed(sample, STEP);
        check(point.iter().all(|c| c.abs() <= 6.661), "outside")?;
        check(warp.pdf(&sample) > 0, "no density at a sample")?;
        let due = around(radius(words[0]), words[1]);
        errors[0] = (point[0] - due[0]).hypot(point[1] - due[1]);
        for point in [[sample[0], sample[1]], words] {
            let [x, y] = point.map(|c| f64::from(c as i32) * STEP);
            let due = (-0.5 * (x * x + y * y)).exp() / TAU;
            errors[1] = errors[1].max(density_error(warp.pdf(&point), due, 1.0));
        }
        errors[2] = back_error(warp.invert(&sample), words);
        Ok(())
    })
}

/// Means anywhere that the deviation leaves room for.
fn room(means: [u32; 2], deviation: u32) -> [u32; 2] {
    let room = (i64::from(i32::MAX) - ((i64::from(deviation) * 427) >> 6) - 1).max(0);
    means.map(|m| ((i64::from(m as i32) * room) >> 31) as u32)
}

fn normal(warp: Box<dyn Raw>, one: f64, means: [u32; 2], deviation: u32) -> Option<Subject> {
    let (d, means) = (f64::from(deviation), means.map(|m| m as i32));
    let sigma = d / one;
    let peak = 1.0 / (TAU * sigma * sigma);
    let density = move |point: [u32; 2]| {
        let [x, y] = [0, 1].map(|i| (f64::from(point[i] as i32) - f64::from(means[i])) / d);
        peak * (-0.5 * (x * x + y * y)).exp()
    };
    Subject::new(vec![("n", d)], move |words, errors| {
        let sample = warp.sample(&words);
        check(warp.pdf(&sample) > 0, "no density at a sample")?;
        let due = around(radius(words[0]), words[1]);
        let off = [0, 1].map(|i| {
            let due = f64::from(means[i]) + due[i] * d;
            beyond(f64::from(sample[i] as i32) - due, 0.5) / d
        });
        errors[0] = off[0].hypot(off[1]);
        let any = [0, 1].map(|i| {
            let off = (i64::from(words[i] as i32) * i64::from(deviation)) >> 29;
            (i64::from(means[i]) + off).clamp(i32::MIN.into(), i32::MAX.into()) as u32
        });
        for point in [[sample[0], sample[1]], any] {
            errors[1] = errors[1].max(density_error(warp.pdf(&point), density(point), peak));
        }
        errors[2] = back_error(warp.invert(&sample), words);
        Ok(())
    })
}

/// The place of u under a density from a to b on the line.
pub fn linear([a, b]: [f64; 2], u: f64) -> f64 {
    let root = ((1.0 - u) * a * a + u * b * b).sqrt();
    if u > 0.0 {
        u * (a + b) / (a + root)
    } else {
        0.0
    }
}

fn bilinear(warp: Box<dyn Raw>, weights: [[u32; 2]; 2]) -> Option<Subject> {
    let exact = weights.map(|row| row.map(f64::from));
    let [low, high] = exact.map(|[a, b]| a + b);
    let scale = 4.0 / (low + high);
    let peak = scale * exact.into_iter().flatten().fold(0.0, f64::max);
    let ends = move |y: f64| [0, 1].map(|x| (1.0 - y) * exact[0][x] + y * exact[1][x]);
    Subject::new(vec![], move |words, errors| {
        let sample = warp.sample(&words);
        let point = [sample[0], sample[1]];
        let ([u, v], [x, y]) = (words.map(uniform), point.map(uniform));
        check(warp.pdf(&sample) > 0, "no density at a sample")?;
        // x for the y that is returned.
        let off = [x - linear(ends(y), u), y - linear([low, high], v)];
        errors[0] = off[0].abs().max(off[1].abs());
        for point in [point, words] {
            let [x, y] = point.map(uniform);
            let [a, b] = ends(y);
            let due = scale * ((1.0 - x) * a + x * b);
            errors[1] = errors[1].max(density_error(warp.pdf(&point), due, peak));
        }
        let back = warp.invert(&sample).map(uniform);
        errors[2] = (back[0] - u).abs().max((back[1] - v).abs());
        Ok(())
    })
}

const ROWS: &[&str] = &["sample, max", "pdf", "round trip"];

pub(super) fn families(all: &mut Vec<Family>) {
    family!(
        all,
        "Disk",
        &["sample, max", "round trip"],
        0,
        |_p, G| disk(raw(Disk::<G>::new()))
    );
    family!(all, "Bilinear", ROWS, 4, |p, G| {
        // Words of all magnitudes, and zeros.
        let some = |i: usize| {
            if p[i] % 5 == 0 {
                0
            } else {
                p[i] >> (p[i] % 32)
            }
        };
        let weights = [[some(0), some(1)], [some(2), some(3)]];
        let words = weights.map(|row| row.map(U32F0::from_bits));
        bilinear(accepted(Bilinear::<G>::new(words))?, weights)
    });
    family!(all, "StandardNormalPair", ROWS, 0, |_p, G| {
        standard(raw(StandardNormalPair::<G>::new()))
    });
    family!(all, "NormalPair", ROWS, 4, |p, G| {
        let (means, deviation) = (room([p[1], p[2]], p[3]), &p[3..]);
        let warp = in_format!(p[0], F, {
            accepted(NormalPair::<F, G>::new(
                OfWords::of(&means),
                OfWords::of(deviation),
            ))
        });
        normal(warp?, one(p[0]), means, p[3])
    });
}
