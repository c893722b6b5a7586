//! The disk and the normals.

use super::family::{Family, Subject, beyond, check, density_error, family, in_format, uniform};
use fixed::types::U0F32;
use fixed::types::extra::LeEqU32;
use fixed::{FixedI32, types::I5F27};
use microwarp::fixed::Grade;
use microwarp::fixed::warp::{Disk, NormalPair, StandardNormalPair};
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

const ROWS: &[&str] = &["sample, max", "pdf", "round trip"];

pub(super) fn families(all: &mut Vec<Family>) {
    family!(
        all,
        "Disk",
        &["sample, max", "round trip"],
        0,
        |_p, G| disk::<G>()
    );
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
