//! Rings, polygons, rotations and simplices.

use super::family::{
    Family, STEP, Subject, WORD, beyond, check, density_error, family, in_format, one, uniform,
};
use super::plane::{around, turns};
use crate::raw::{OfWords, Raw, accepted, raw, signed};
use host::truth;
use microwarp::fixed::Grade;
use microwarp::fixed::warp::{Annulus, RegularPolygon, Rotation, Simplex};
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

/// Outer radii of all magnitudes, and inner ones that are 0, anything, or near them.
fn radii(p: &[u32]) -> [u32; 2] {
    let outer = ((p[1] >> 1).min((1 << 30) + 1)) >> (p[0] >> 8 & 31);
    let inner = match p[0] >> 13 & 3 {
        0 => 0,
        1 => ((u64::from(p[2]) * u64::from(outer)) >> 32) as u32 >> (p[0] >> 20 & 15),
        _ => outer.saturating_sub(p[2] >> (p[0] >> 15 & 31)),
    };
    [inner, outer]
}

/// The sides of a sector; none of a whole ring.
fn sides(p: &[u32]) -> Option<[u32; 2]> {
    let width = p[4] >> (p[0] >> 24 & 31);
    (p[0] >> 7 & 1 != 0).then_some([p[3], p[3].wrapping_add(width)])
}

fn annulus(
    warp: Box<dyn Raw>,
    one: f64,
    [inner, outer]: [u32; 2],
    sides: Option<[u32; 2]>,
    slack: f64,
) -> Option<Subject> {
    let (start, width) = match sides {
        None => (0, 1 << 32),
        Some([first, second]) => (first, u64::from(second.wrapping_sub(first))),
    };
    let [low, n] = [inner, outer].map(f64::from);
    let steps = (n - low) * (n + low);
    let w = width as f64 * WORD;
    let density = one * one / (PI * steps * w);
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
        let sample = warp.sample(&words);
        let point: [f64; 2] = signed(sample, 1.0);
        errors[0] = largest(&[0, 1].map(|i| beyond(point[i] - due[i], 0.5) / n));
        let got = warp.pdf(&sample);
        check(got > 0, "no density at a sample")?;
        errors[1] = density_error(got, density, density.max(WORD));
        let back = warp.invert(&sample);
        errors[2] = uniform(back[0]) - u;
        let off = uniform(back[1]) - v;
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
        let any = any.map(|c| c as u32);
        let got = warp.pdf(&any);
        check(outside > 0.0 || got > 0, "no density inside")?;
        check(outside <= n * slack + 4.0 || got == 0, "density outside")?;
        let _ = warp.invert(&words);
        check(
            warp.pdf(&warp.sample(&warp.invert(&any))) > 0,
            "no density at an inverse",
        )
    })
}

fn polygon(warp: Box<dyn Raw>, corners: u16, slack: f64) -> Option<Subject> {
    let n = f64::from(corners);
    let density = 2.0 / (n * (TAU / n).sin());
    let apothem = (PI / n).cos();
    let corner = move |k: u64| {
        let (s, c) = (TAU * (k as f64 / n)).sin_cos();
        [c, s]
    };
    Subject::new(vec![], move |words, errors| {
        let root = uniform(words[0]).sqrt();
        let place = u64::from(words[1]) * u64::from(corners);
        let (side, along) = (place >> 32, uniform(place as u32));
        let (a, b) = (corner(side), corner(side + 1));
        let sample = warp.sample(&words);
        let point: [f64; 2] = signed(sample, STEP);
        errors[0] = largest(&[0, 1].map(|i| point[i] - root * (a[i] + along * (b[i] - a[i]))));
        let got = warp.pdf(&sample);
        check(got > 0, "no density at a sample")?;
        errors[1] = got.to_num::<f64>() - density;
        let back = warp.invert(&sample);
        let first = uniform(back[0]) - uniform(words[0]);
        errors[2] = largest(&[first, turns(back[1], words[1]) * root]);
        // Anywhere.
        let [x, y] = words.map(|word| f64::from(word as i32) * STEP);
        let middle = (y.atan2(x) / TAU * n - 0.5).round() + 0.5;
        let (s, c) = (TAU * middle / n).sin_cos();
        let beyond = x * c + y * s - apothem;
        let got = warp.pdf(&words);
        check(beyond > 0.0 || got > 0, "no density inside")?;
        check(beyond <= slack || got == 0, "density outside")?;
        check(
            warp.pdf(&warp.sample(&warp.invert(&words))) > 0,
            "no density at an inverse",
        )
    })
}

fn rotation(warp: Box<dyn Raw>) -> Option<Subject> {
    Subject::of_four(vec![], move |[a, b, c, d], errors| {
        let words = [a, b, c];
        let [u, v, _] = words.map(uniform);
        let sample = warp.sample(&words);
        let point: [f64; 4] = signed(sample, STEP);
        check(point[3] >= 0.0, "a negative w")?;
        let [x, y] = around(u.sqrt(), c);
        let (sin, cos) = (PI * (v - 0.5)).sin_cos();
        let rest = (1.0 - u).sqrt();
        let due = [x, y, rest * sin, rest * cos];
        errors[0] = largest(&[0, 1, 2, 3].map(|i| point[i] - due[i]));
        errors[1] = point.iter().map(|c| c * c).sum::<f64>().sqrt() - 1.0;
        let density = warp.pdf(&sample).to_num::<f64>() - 1.0 / (PI * PI);
        check(density.abs() <= 0.5 * WORD, "a wrong density")?;
        let back = warp.invert(&sample);
        let [first, second] = [(0, u), (1, v)].map(|(i, u)| uniform(back[i]) - u);
        errors[2] = largest(&[first, second * rest, turns(back[2], c) * u.sqrt()]);
        // Any quaternion and its negative are one rotation.
        let any = [a, b, c, d];
        let same = any.contains(&(1 << 31)) || d == 0;
        check(
            same || warp.invert(&any) == warp.invert(&any.map(u32::wrapping_neg)),
            "two inverses of a rotation",
        )
    })
}

/// Uniforms after the fourth are parameters.
fn simplex(warp: Box<dyn Raw>, n: usize, p: &[u32]) -> Option<Subject> {
    let more: Vec<u32> = p[1..].to_vec();
    let density: f64 = (1..=n).map(|k| k as f64).product();
    Subject::of_four(vec![("n", n as f64)], move |words, errors| {
        let uniforms: Vec<u32> = words.iter().chain(&more).copied().take(n).collect();
        let sample = warp.sample(&uniforms);
        let point: Vec<i32> = sample[..=n].iter().map(|x| *x as i32).collect();
        let sum: i64 = point.iter().map(|x| i64::from(*x)).sum();
        check(point.iter().all(|x| *x >= 0) && sum == 1 << 30, "outside")?;
        check(warp.pdf(&sample) == density, "no density at a sample")?;
        let u: Vec<f64> = uniforms.iter().map(|word| uniform(*word)).collect();
        let due = truth::Simplex::shares(&u);
        let shares = point.iter().map(|x| f64::from(*x) * STEP);
        let off: Vec<f64> = shares.zip(&due).map(|(x, due)| x - due).collect();
        errors[0] = largest(&off);
        let back = warp.invert(&sample);
        let left = |j: usize| due[j..].iter().sum::<f64>();
        let off: Vec<f64> = (0..n)
            .map(|j| (uniform(back[j]) - u[j]) * left(j))
            .collect();
        errors[1] = largest(&off);
        // Anywhere: the words themselves as shares, and a rest beside them.
        let mut any = uniforms;
        any.push(words[0].rotate_left(7));
        let there: Vec<f64> = any.iter().map(|x| f64::from(*x as i32) * STEP).collect();
        let outside = there.iter().any(|x| *x < 0.0);
        let whole = (there.iter().sum::<f64>() - 1.0).abs() <= 1e-6;
        check(warp.pdf(&any) == 0 || whole && !outside, "density outside")?;
        let again = warp.sample(&warp.invert(&any));
        check(warp.pdf(&again) > 0, "no density at an inverse")
    })
}

fn simplices<G: Grade>() -> [Box<dyn Raw>; 12] {
    macro_rules! of {
        ($($n:literal)*) => { [$(raw(Simplex::<$n, G>::new())),*] };
    }
    of!(1 2 3 4 5 6 7 8 9 10 11 12)
}

const RING: &[&str] = &[
    "sample, max",
    "pdf",
    "round trip, first",
    "round trip, second",
];
const POLYGON: &[&str] = &["sample, max", "pdf", "round trip"];

pub(super) fn families(all: &mut Vec<Family>) {
    family!(all, "Annulus", RING, 5, |p, G| {
        let (radii, sides) = (radii(p), sides(p));
        let warp = in_format!(p[0], F, {
            let (inner, outer) = (OfWords::of(&radii), OfWords::of(&radii[1..]));
            accepted(match sides {
                None => Annulus::<F, G>::new(inner, outer),
                Some(sides) => Annulus::<F, G>::sector(inner, outer, OfWords::of(&sides)),
            })
        });
        annulus(warp?, one(p[0]), radii, sides, slack::<G>())
    });
    family!(all, "RegularPolygon", POLYGON, 2, |p, G| {
        // Of all magnitudes, and often few.
        let corners = (p[0] >> 16 >> (p[1] % 14)).max(3) as u16;
        let warp = accepted(RegularPolygon::<G>::new(corners));
        polygon(warp?, corners, slack::<G>())
    });
    family!(all, "Rotation", &["sample, max", "unit length", "round trip"], 0, words 4, |_p, G| {
        rotation(raw(Rotation::<G>::new()))
    });
    family!(all, "Simplex", &["sample, max", "round trip"], 9, words 4, |p, G| {
        let place = p[0] as usize % 12;
        simplex(simplices::<G>().into_iter().nth(place)?, place + 1, p)
    });
}
