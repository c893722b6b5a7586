//! Rings, polygons, rotations and simplices.

use super::family::{
    Family, Subject, WORD, beyond, check, density_error, family, in_format, uniform,
};
use super::plane::{around, turns};
use fixed::FixedI32;
use fixed::types::extra::LeEqU32;
use fixed::types::{I2F30, U0F32};
use host::truth;
use microwarp::fixed::Grade;
use microwarp::fixed::warp::{Annulus, RegularPolygon, Rotation, Simplex};
use microwarp::{Invert, Warp};
use std::f64::consts::{PI, TAU};

/// The largest magnitude; NaN counts as that.
fn largest(errors: &[f64]) -> f64 {
    let worse = |a: f64, b: &f64| if b.abs() <= a { a } else { b.abs() };
    errors.iter().fold(0.0, worse)
}

/// More than a grade allows for the error of a point at the edge of a shape, of its size.
fn slack<G: Grade>() -> f64 {
    if G::NAME == "coarse" {
        2.0_f64.powi(-10)
    } else {
        2.0_f64.powi(-17)
    }
}

fn annulus<Frac: LeEqU32 + 'static, G: Grade>(p: &[u32]) -> Option<Subject> {
    let bits = FixedI32::<Frac>::from_bits;
    // Outer radii of all magnitudes, and inner ones that are 0, anything, or near them.
    let outer = ((p[1] >> 1).min((1 << 30) + 1)) >> (p[0] >> 8 & 31);
    let inner = match p[0] >> 13 & 3 {
        0 => 0,
        1 => ((u64::from(p[2]) * u64::from(outer)) >> 32) as u32 >> (p[0] >> 20 & 15),
        _ => outer.saturating_sub(p[2] >> (p[0] >> 15 & 31)),
    };
    let [inner_radius, radius] = [inner, outer].map(|r| bits(r as i32));
    let whole = p[0] >> 7 & 1 == 0;
    let width = p[4] >> (p[0] >> 24 & 31);
    let (warp, start, width) = if whole {
        (Annulus::<Frac, G>::new(inner_radius, radius), 0, 1 << 32)
    } else {
        let sides = [p[3], p[3].wrapping_add(width)].map(U0F32::from_bits);
        let warp = Annulus::<Frac, G>::sector(inner_radius, radius, sides);
        (warp, p[3], u64::from(width))
    };
    let warp = warp.ok()?;
    let [low, n] = [inner, outer].map(f64::from);
    let steps = (n - low) * (n + low);
    let w = width as f64 * WORD;
    let density = 4_f64.powi(Frac::U32 as i32) / (PI * steps * w);
    let variables = vec![("n", n), ("s", steps / (n * n)), ("w", w)];
    Subject::new(variables, move |words, errors| {
        let [u, v] = words.map(uniform);
        let r = (low * low + u * steps).sqrt();
        // The azimuth in turns from the first side, then from the nearest quarter turn.
        let turn = v * w + f64::from(start) * WORD;
        let quarter = (4.0 * turn).round();
        let [x, y] = around(r, ((quarter as u64 % 4) << 30) as u32);
        let (sin, cos) = (TAU * (turn - 0.25 * quarter)).sin_cos();
        let due = [x * cos - y * sin, y * cos + x * sin];
        let sample = warp.sample(words.map(U0F32::from_bits));
        let point = sample.map(|c| f64::from(c.to_bits()));
        errors[0] = largest(&[0, 1].map(|i| beyond(point[i] - due[i], 0.5) / n));
        let got = warp.pdf(sample);
        check(got > 0, "no density at a sample")?;
        errors[1] = density_error(got, density, density.max(WORD));
        let back = warp.invert(sample);
        errors[2] = back[0].to_num::<f64>() - u;
        let off = back[1].to_num::<f64>() - v;
        // Where the gap is narrower than the sector, its sides are next to each other.
        let off = if w > 0.5 { off - off.round() } else { off };
        errors[3] = off * r / n;
        // Anywhere about the ring.
        let any = words.map(|word| ((i64::from(word as i32) * i64::from(outer)) >> 30) as i32);
        let there = any.map(f64::from);
        let r = there[0].hypot(there[1]);
        let turn = (there[1].atan2(there[0]) / TAU - f64::from(start) * WORD).rem_euclid(1.0);
        let aside = if turn <= w {
            0.0
        } else {
            (turn - w).min(1.0 - turn)
        };
        // How far outside, at least: the sine is at least this beside its angle.
        let outside = (low - r).max(r - n).max(4.0 * aside.min(0.25) * r);
        let got = warp.pdf(any.map(bits));
        check(outside > 0.0 || got > 0, "no density inside")?;
        check(
            outside <= n * slack::<G>() + 4.0 || got == 0,
            "density outside",
        )?;
        let _ = warp.invert(words.map(|word| bits(word as i32)));
        check(
            warp.pdf(warp.sample(warp.invert(any.map(bits)))) > 0,
            "no density at an inverse",
        )
    })
}

fn polygon<G: Grade>(corners: u32) -> Option<Subject> {
    let warp = RegularPolygon::<G>::new(corners as u16).ok()?;
    let n = f64::from(warp.corners());
    let density = 2.0 / (n * (TAU / n).sin());
    let apothem = (PI / n).cos();
    let corner = move |k: u64| {
        let (s, c) = (TAU * (k as f64 / n)).sin_cos();
        [c, s]
    };
    Subject::new(vec![], move |words, errors| {
        let root = uniform(words[0]).sqrt();
        let place = u64::from(words[1]) * u64::from(warp.corners());
        let (side, along) = (place >> 32, uniform(place as u32));
        let (a, b) = (corner(side), corner(side + 1));
        let sample = warp.sample(words.map(U0F32::from_bits));
        let point = sample.map(|c| c.to_num::<f64>());
        errors[0] = largest(&[0, 1].map(|i| point[i] - root * (a[i] + along * (b[i] - a[i]))));
        let got = warp.pdf(sample);
        check(got > 0, "no density at a sample")?;
        errors[1] = got.to_num::<f64>() - density;
        let back = warp.invert(sample);
        let first = back[0].to_num::<f64>() - uniform(words[0]);
        errors[2] = largest(&[first, turns(back[1], words[1]) * root]);
        // Anywhere.
        let any = words.map(|word| I2F30::from_bits(word as i32));
        let [x, y] = any.map(|c| c.to_num::<f64>());
        let middle = (y.atan2(x) / TAU * n - 0.5).round() + 0.5;
        let (s, c) = (TAU * middle / n).sin_cos();
        let beyond = x * c + y * s - apothem;
        let got = warp.pdf(any);
        check(beyond > 0.0 || got > 0, "no density inside")?;
        check(beyond <= slack::<G>() || got == 0, "density outside")?;
        check(
            warp.pdf(warp.sample(warp.invert(any))) > 0,
            "no density at an inverse",
        )
    })
}

fn rotation<G: Grade>() -> Option<Subject> {
    let warp = Rotation::<G>::new();
    Subject::of_four(vec![], move |[a, b, c, d], errors| {
        let words = [a, b, c];
        let [u, v, _] = words.map(uniform);
        let sample = warp.sample(words.map(U0F32::from_bits));
        check(sample[3] >= 0, "a negative w")?;
        let [x, y] = around(u.sqrt(), c);
        let (sin, cos) = (PI * (v - 0.5)).sin_cos();
        let rest = (1.0 - u).sqrt();
        let due = [x, y, rest * sin, rest * cos];
        let point = sample.map(|c| c.to_num::<f64>());
        errors[0] = largest(&[0, 1, 2, 3].map(|i| point[i] - due[i]));
        errors[1] = point.iter().map(|c| c * c).sum::<f64>().sqrt() - 1.0;
        let density = warp.pdf(sample).to_num::<f64>() - 1.0 / (PI * PI);
        check(density.abs() <= 0.5 * WORD, "a wrong density")?;
        let back = warp.invert(sample);
        let [first, second] = [(0, u), (1, v)].map(|(i, u)| back[i].to_num::<f64>() - u);
        errors[2] = largest(&[first, second * rest, turns(back[2], c) * u.sqrt()]);
        // Any quaternion and its negative are one rotation.
        let any = [a, b, c, d].map(|word| I2F30::from_bits(word as i32));
        let turned = any.map(I2F30::saturating_neg);
        let same = any.contains(&I2F30::MIN) || any[3] == 0;
        check(
            same || warp.invert(any) == warp.invert(turned),
            "two inverses of a rotation",
        )
    })
}

/// Uniforms after the fourth are parameters.
fn simplex<const N: usize, G: Grade>(p: &[u32]) -> Option<Subject> {
    let warp = Simplex::<N, G>::new();
    let more: Vec<u32> = p[1..].to_vec();
    let density: f64 = (1..=N).map(|k| k as f64).product();
    Subject::of_four(vec![("n", N as f64)], move |words, errors| {
        let words: [u32; N] = std::array::from_fn(|i| if i < 4 { words[i] } else { more[i - 4] });
        let sample = warp.sample(words.map(U0F32::from_bits));
        let (shares, rest) = sample;
        let point: Vec<I2F30> = shares.into_iter().chain([rest]).collect();
        let sum: i64 = point.iter().map(|x| i64::from(x.to_bits())).sum();
        check(point.iter().all(|x| *x >= 0) && sum == 1 << 30, "outside")?;
        check(warp.pdf(sample) == density, "no density at a sample")?;
        let due = truth::Simplex::shares(&words.map(uniform));
        let off: Vec<f64> = point
            .iter()
            .zip(&due)
            .map(|(x, due)| x.to_num::<f64>() - due)
            .collect();
        errors[0] = largest(&off);
        let back = warp.invert(sample);
        let left = |j: usize| due[j..].iter().sum::<f64>();
        let off: Vec<f64> = (0..N)
            .map(|j| (back[j].to_num::<f64>() - uniform(words[j])) * left(j))
            .collect();
        errors[1] = largest(&off);
        let any = words.map(|word| I2F30::from_bits(word as i32));
        let sum = any.iter().fold(0.0, |sum, x| sum + x.to_num::<f64>());
        let rest = I2F30::from_bits(words[0].rotate_left(7) as i32);
        let outside = any.iter().any(|x| *x < 0) || rest < 0;
        let whole = (sum + rest.to_num::<f64>() - 1.0).abs() <= 1e-6;
        check(
            warp.pdf((any, rest)) == 0 || whole && !outside,
            "density outside",
        )?;
        let again = warp.sample(warp.invert((any, rest)));
        check(warp.pdf(again) > 0, "no density at an inverse")
    })
}

fn any_simplex<G: Grade>(p: &[u32]) -> Option<Subject> {
    match p[0] % 12 {
        0 => simplex::<1, G>(p),
        1 => simplex::<2, G>(p),
        2 => simplex::<3, G>(p),
        3 => simplex::<4, G>(p),
        4 => simplex::<5, G>(p),
        5 => simplex::<6, G>(p),
        6 => simplex::<7, G>(p),
        7 => simplex::<8, G>(p),
        8 => simplex::<9, G>(p),
        9 => simplex::<10, G>(p),
        10 => simplex::<11, G>(p),
        _ => simplex::<12, G>(p),
    }
}

const RING: &[&str] = &[
    "sample, max",
    "pdf",
    "round trip, first",
    "round trip, second",
];
const POLYGON: &[&str] = &["sample, max", "pdf", "round trip"];

pub(super) fn families(all: &mut Vec<Family>) {
    family!(all, "Annulus", RING, 5, |p, G| in_format!(
        p[0], annulus, G, p
    ));
    family!(all, "RegularPolygon", POLYGON, 2, |p, G| {
        // Of all magnitudes, and often few.
        polygon::<G>((p[0] >> 16 >> (p[1] % 14)).max(3))
    });
    family!(all, "Rotation", &["sample, max", "unit length", "round trip"], 0, words 4, |_p, G| {
        rotation::<G>()
    });
    family!(all, "Simplex", &["sample, max", "round trip"], 9, words 4, |p, G| {
        any_simplex::<G>(p)
    });
}
