//! The disk and the normals.

use super::family::{Family, Subject, beyond, check, density_error, family, in_format, uniform};
use fixed::types::extra::LeEqU32;
use fixed::types::{U0F32, U32F0};
use fixed::{FixedI32, types::I5F27};
use microwarp::fixed::Grade;
use microwarp::fixed::warp::{Bilinear, Disk, NormalPair, StandardNormalPair};
use microwarp::{Invert, Warp};
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
pub fn turns(got: U0F32, phase: u32) -> f64 {
    f64::from(got.to_bits().wrapping_sub(phase) as i32) * super::family::WORD
}

fn disk<G: Grade>() -> Option<Subject> {
    let warp = Disk::<G>::new();
    Subject::new(vec![], move |words, errors| {
        let point = warp.sample(words.map(U0F32::from_bits));
        let [x, y] = point.map(|c| i64::from(c.to_bits()));
        check(x * x + y * y <= 1 << 60, "outside")?;
        check(warp.pdf(point) > 0, "no density at a sample")?;
        let r = uniform(words[0]).sqrt();
        let due = around(r, words[1]);
        errors[0] = [0, 1]
            .map(|i| (point[i].to_num::<f64>() - due[i]).abs())
            .into_iter()
            .fold(0.0, f64::max);
        let back = warp.invert(point);
        let first = (back[0].to_num::<f64>() - uniform(words[0])).abs();
        errors[1] = first.max((turns(back[1], words[1]) * r).abs());
        Ok(())
    })
}

fn radius(u: u32) -> f64 {
    (-2.0 * (-uniform(u)).ln_1p()).sqrt()
}

/// The round trip of the first uniform, and of the second as a distance along the circle of the radius.
fn back_error(back: [U0F32; 2], words: [u32; 2]) -> f64 {
    let first = (back[0].to_num::<f64>() - uniform(words[0])).abs();
    first.max((turns(back[1], words[1]) * TAU * radius(words[0]).min(1.0)).abs())
}

fn standard<G: Grade>() -> Option<Subject> {
    let warp = StandardNormalPair::<G>::new();
    Subject::new(vec![], move |words, errors| {
        let sample = warp.sample(words.map(U0F32::from_bits));
        check(sample.iter().all(|c| c.abs() <= 6.661), "outside")?;
        check(warp.pdf(sample) > 0, "no density at a sample")?;
        let due = around(radius(words[0]), words[1]);
        let [dx, dy] = [0, 1].map(|i| sample[i].to_num::<f64>() - due[i]);
        errors[0] = dx.hypot(dy);
        for point in [sample, words.map(|w| I5F27::from_bits(w as i32))] {
            let [x, y] = point.map(|c| c.to_num::<f64>());
            let due = (-0.5 * (x * x + y * y)).exp() / TAU;
            errors[1] = errors[1].max(density_error(warp.pdf(point), due, 1.0));
        }
        errors[2] = back_error(warp.invert(sample), words);
        Ok(())
    })
}

fn normal<Frac: LeEqU32 + 'static, G: Grade>(means: [u32; 2], deviation: u32) -> Option<Subject> {
    let bits = FixedI32::<Frac>::from_bits;
    let d = f64::from(deviation);
    // Means anywhere that the deviation leaves room for.
    let room = (i64::from(i32::MAX) - ((i64::from(deviation) * 427) >> 6) - 1).max(0);
    let means = means.map(|m| ((i64::from(m as i32) * room) >> 31) as i32);
    let warp = NormalPair::<Frac, G>::new(means.map(bits), bits(deviation as i32)).ok()?;
    let sigma = d / 2_f64.powi(Frac::U32 as i32);
    let peak = 1.0 / (TAU * sigma * sigma);
    let density = move |point: [FixedI32<Frac>; 2]| {
        let [x, y] = [0, 1].map(|i| (f64::from(point[i].to_bits()) - f64::from(means[i])) / d);
        peak * (-0.5 * (x * x + y * y)).exp()
    };
    Subject::new(vec![("n", d)], move |words, errors| {
        let sample = warp.sample(words.map(U0F32::from_bits));
        check(warp.pdf(sample) > 0, "no density at a sample")?;
        let due = around(radius(words[0]), words[1]);
        let off = [0, 1].map(|i| {
            let due = f64::from(means[i]) + due[i] * d;
            beyond(f64::from(sample[i].to_bits()) - due, 0.5) / d
        });
        errors[0] = off[0].hypot(off[1]);
        let any = [0, 1].map(|i| {
            let off = (i64::from(words[i] as i32) * i64::from(deviation)) >> 29;
            bits((i64::from(means[i]) + off).clamp(i32::MIN.into(), i32::MAX.into()) as i32)
        });
        for point in [sample, any] {
            errors[1] = errors[1].max(density_error(warp.pdf(point), density(point), peak));
        }
        errors[2] = back_error(warp.invert(sample), words);
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

fn bilinear<G: Grade>(weights: [[u32; 2]; 2]) -> Option<Subject> {
    let words = weights.map(|row| row.map(U32F0::from_bits));
    let warp = Bilinear::<G>::new(words).ok()?;
    let exact = weights.map(|row| row.map(f64::from));
    let [low, high] = exact.map(|[a, b]| a + b);
    let scale = 4.0 / (low + high);
    let peak = scale * exact.into_iter().flatten().fold(0.0, f64::max);
    let ends = move |y: f64| [0, 1].map(|x| (1.0 - y) * exact[0][x] + y * exact[1][x]);
    Subject::new(vec![], move |words, errors| {
        let words = words.map(U0F32::from_bits);
        let sample = warp.sample(words);
        let [u, v] = words.map(|u| u.to_num::<f64>());
        let [x, y] = sample.map(|c| c.to_num::<f64>());
        check(warp.pdf(sample) > 0, "no density at a sample")?;
        // x for the y that is returned.
        let off = [x - linear(ends(y), u), y - linear([low, high], v)];
        errors[0] = off[0].abs().max(off[1].abs());
        for point in [sample, words] {
            let [x, y] = point.map(|c| c.to_num::<f64>());
            let [a, b] = ends(y);
            let due = scale * ((1.0 - x) * a + x * b);
            errors[1] = errors[1].max(density_error(warp.pdf(point), due, peak));
        }
        let back = warp.invert(sample).map(|u| u.to_num::<f64>());
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
        |_p, G| disk::<G>()
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
        bilinear::<G>([[some(0), some(1)], [some(2), some(3)]])
    });
    family!(all, "StandardNormalPair", ROWS, 0, |_p, G| {
        standard::<G>()
    });
    family!(all, "NormalPair", ROWS, 4, |p, G| in_format!(
        p[0],
        normal,
        G,
        [p[1], p[2]],
        p[3]
    ));
}
