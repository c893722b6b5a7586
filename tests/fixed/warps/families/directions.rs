//! Warps over directions.

use super::family::{Family, STEP, Subject, WORD, beyond, check, family, uniform};
use super::plane::{around, turns};
use crate::raw::{Raw, accepted, raw, signed};
use fixed::types::{U0F32, U2F62, U32F32};
use microwarp::fixed::Grade;
use microwarp::fixed::warp::{
    Cone, CosineHemisphere, Hemisphere, HenyeyGreenstein, PhongLobe, Sphere,
};
use std::f64::consts::{FRAC_1_PI, PI, TAU};

/// Sine and cosine of the polar angle at a uniform.
type Polar = Box<dyn Fn(f64) -> (f64, f64)>;
/// The density at a point.
type Height = Box<dyn Fn([f64; 3]) -> f64>;

fn directions(
    warp: Box<dyn Raw>,
    variables: Vec<(&'static str, f64)>,
    [polar, other]: [Polar; 2],
    height: Height,
    // What an error of the density is a part of (0: of the density itself), and how much of it is none.
    (peak, free): (f64, f64),
) -> Option<Subject> {
    Subject::new(variables, move |words, errors| {
        let sample = warp.sample(&words);
        let got = warp.pdf(&sample);
        check(got > 0, "no density at a sample")?;
        // Between the points of both.
        let dues = [&polar, &other].map(|polar| {
            let (sin, cos) = polar(uniform(words[0]));
            let [x, y] = around(sin, words[1]);
            [x, y, cos]
        });
        let sin = polar(uniform(words[0])).0;
        let point: [f64; 3] = signed(sample, STEP);
        let off = [0, 1, 2].map(|i| {
            let middle = 0.5 * (dues[0][i] + dues[1][i]);
            beyond(point[i] - middle, 0.5 * (dues[0][i] - dues[1][i]).abs())
        });
        let largest = |errors: &[f64]| {
            errors
                .iter()
                .fold(0.0, |a: f64, b| if b.abs() <= a { a } else { b.abs() })
        };
        errors[0] = largest(&off);
        let square: f64 = point.iter().map(|c| c * c).sum();
        errors[1] = square.sqrt() - 1.0;
        let due = height(point).max(WORD);
        let whole = if peak > 0.0 { peak } else { due };
        let density = beyond(got.to_num::<f64>() - due, free) / whole;
        let back = warp.invert(&sample);
        let first = uniform(back[0]) - uniform(words[0]);
        errors[2] = largest(&[first, turns(back[1], words[1]) * sin]);
        // Where no row states it, nothing is left.
        match errors.get_mut(3) {
            Some(error) => *error = density,
            None => check(density == 0.0, "a wrong density")?,
        }
        Ok(())
    })
}

/// The direction of 1 − cos θ.
fn of_complement(a: f64) -> (f64, f64) {
    ((a * (2.0 - a)).sqrt(), 1.0 - a)
}

fn cone<G: Grade>(p: &[u32]) -> Option<Subject> {
    let (warp, k) = if p[0] % 4 == 0 {
        let angle = PI * uniform(p[1]);
        (
            Cone::<G>::from_turns(U0F32::from_bits(p[1])),
            2.0 * angle.sin().powi(2),
        )
    } else {
        // Of all magnitudes.
        let k = (u64::from(p[1]) << 32 | u64::from(p[2])) >> ((p[0] >> 2) % 40);
        (
            Cone::<G>::from_one_minus_cos(U2F62::from_bits(k)),
            k as f64 * 0.5_f64.powi(62),
        )
    };
    cone_of(accepted(warp)?, k)
}

/// A warp beside the truth of the cone of 1 − cos θ = k.
pub(super) fn cone_of(warp: Box<dyn Raw>, k: f64) -> Option<Subject> {
    let density = 1.0 / (TAU * k);
    let size = if k < 1.0 { of_complement(k).0 } else { 1.0 };
    // Of an angle, and of the 31 digits that are kept.
    let polar = |k: f64| -> Polar { Box::new(move |u| of_complement(k * u)) };
    let kept = [k * (1.0 - STEP), (k * (1.0 + STEP)).min(2.0)].map(polar);
    let height: Height = Box::new(move |_| density);
    directions(warp, vec![("w", size)], kept, height, (density, WORD))
}

fn lobe(warp: Box<dyn Raw>, n: f64) -> Option<Subject> {
    let size = (2.0 / (n + 1.0)).sqrt().min(1.0);
    let polar =
        || -> Polar { Box::new(move |u| of_complement(-((-u).ln_1p() / (n + 1.0)).exp_m1())) };
    let peak = (n + 1.0) / TAU;
    let height: Height = Box::new(move |[x, y, z]| {
        // Near the axis z has lost what x and y still hold.
        let log = if z > 0.5 {
            (-(x * x + y * y) / (1.0 + z)).ln_1p()
        } else {
            z.ln()
        };
        peak * (n * log).exp()
    });
    directions(
        warp,
        vec![("w", size), ("n", n)],
        [polar(), polar()],
        height,
        (peak, WORD),
    )
}

/// Of 1 - |g|, to either side.
fn henyey_greenstein(warp: Box<dyn Raw>, a: f64, back: bool) -> Option<Subject> {
    let h = 1.0 - a;
    let polar = || -> Polar {
        Box::new(move |u| {
            let (u, v) = if back { (1.0 - u, u) } else { (u, 1.0 - u) };
            let d = a + 2.0 * h * v;
            let down = 2.0 * u * (a / d).powi(2) * (1.0 + h * v);
            let up = 2.0 * v * ((1.0 + h) / d).powi(2) * (a + h * v);
            let cos = if down < up { 1.0 - down } else { up - 1.0 };
            ((down * up).sqrt(), if back { -cos } else { cos })
        })
    };
    let height: Height = Box::new(move |[x, y, z]| {
        let z = if back { -z } else { z };
        let down = if z > 0.5 {
            (x * x + y * y) / (1.0 + z)
        } else {
            1.0 - z
        };
        a * (1.0 + h) / (2.0 * TAU * (a * a + 2.0 * h * down).powf(1.5))
    });
    let polars = [polar(), polar()];
    directions(warp, vec![("a", a)], polars, height, (0.0, WORD))
}

const ROWS: &[&str] = &["sample, max", "unit length", "round trip"];

pub(super) const CONE: &[&str] = &["sample, max", "unit length", "round trip", "pdf"];
const LOBE: &[&str] = &[
    "sample, max",
    "unit length",
    "round trip",
    "pdf, of that on the axis",
];

pub(super) fn families(all: &mut Vec<Family>) {
    family!(all, "Sphere", ROWS, 0, |_p, G| {
        let polar = || -> Polar { Box::new(|u| (2.0 * (u * (1.0 - u)).sqrt(), 1.0 - 2.0 * u)) };
        directions(
            raw(Sphere::<G>::new()),
            vec![],
            [polar(), polar()],
            Box::new(|_| FRAC_1_PI / 4.0),
            (1.0, 0.5 * WORD),
        )
    });
    family!(all, "Hemisphere", ROWS, 0, |_p, G| {
        let polar = || -> Polar { Box::new(|u| (((1.0 - u) * (1.0 + u)).sqrt(), u)) };
        directions(
            raw(Hemisphere::<G>::new()),
            vec![],
            [polar(), polar()],
            Box::new(|_| FRAC_1_PI / 2.0),
            (1.0, 0.5 * WORD),
        )
    });
    family!(all, "CosineHemisphere", ROWS, 0, |_p, G| {
        let polar = || -> Polar { Box::new(|u| (u.sqrt(), (1.0 - u).sqrt())) };
        directions(
            raw(CosineHemisphere::<G>::new()),
            vec![],
            [polar(), polar()],
            Box::new(|[_, _, z]| z * FRAC_1_PI),
            (1.0, 16.0 * WORD),
        )
    });
    family!(all, "Cone", CONE, 3, |p, G| cone::<G>(p));
    family!(all, "HenyeyGreenstein", CONE, 3, |p, G| {
        // 1 - |g| of all magnitudes.
        let least = (u64::from(p[1]) << 32 | u64::from(p[2])) >> (2 + (p[0] >> 1) % 18);
        let back = p[0] % 2 == 1;
        let complement = U2F62::from_bits(if back { (1 << 63) - least } else { least });
        let warp = accepted(HenyeyGreenstein::<G>::from_one_minus(complement));
        henyey_greenstein(warp?, least as f64 * 0.5_f64.powi(62), back)
    });
    family!(all, "PhongLobe", LOBE, 3, |p, G| {
        let n = (u64::from(p[1]) << 32 | u64::from(p[2])) >> (p[0] % 64);
        let warp = accepted(PhongLobe::<G>::new(U32F32::from_bits(n)));
        lobe(warp?, n as f64 * WORD)
    });
}
