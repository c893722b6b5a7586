//! Whether errors stay within the bounds that the documentation states. The bounds are read at run time.

use crate::error::{Errors, Lattice};
use crate::sampler::{FromWords, Sampler};
use host::docs::{self, Doc};
use host::figures::{Exact, Figures, ROWS, density_and_inverse_error, sample_error};

/// Where a sampler exceeds its documented errors.
pub fn complaints(sampler: &Sampler, errors: &Errors, points: u64) -> Vec<String> {
    let complaints = if sampler.entry.is_some() {
        of_floats(sampler, points)
    } else if ["fine", "coarse", "compact"].contains(&sampler.tier) {
        of_integers(sampler, errors)
    } else {
        Vec::new()
    };
    let label = sampler.label();
    complaints
        .into_iter()
        .map(|c| format!("{label}: {c}"))
        .collect()
}

/// Tries this module on cases with a known outcome, and returns the complaints.
pub fn check() -> Vec<String> {
    let exceeding = [2.0, f64::NAN, f64::INFINITY]
        .iter()
        .all(|found| exceeds("", *found, 1.0).is_some());
    let grades = stated("Disk", "sample, max");
    // What is in the documentation changes, but a coarse disk is never finer than a fine one.
    let read = grades.is_some_and(|[fine, coarse, compact]| fine < coarse && compact < coarse);
    let unknown =
        stated("Disk", "sample, best").is_none() && stated("Square", "sample, max").is_none();
    let holds = exceeding && exceeds("", 1.0, 1.0).is_none() && read && unknown;
    if holds {
        Vec::new()
    } else {
        vec!["documented bounds are not read or not held".into()]
    }
}

fn exceeds(title: &str, found: f64, bound: f64) -> Option<String> {
    // Written so that NaN exceeds everything.
    let keeps = found <= bound;
    (!keeps).then(|| format!("{title}: {found:.3e} where {bound:.3e} is stated"))
}

/// The float tiers, in the units of `tests/accuracy`.
fn of_floats(sampler: &Sampler, points: u64) -> Vec<String> {
    let Some(entry) = &sampler.entry else {
        return Vec::new();
    };
    let (mut figures, lattice) = (Figures::default(), Lattice::new(entry.uniforms));
    for k in 0..points {
        let words = lattice.at(k);
        let u: [f32; 4] = std::array::from_fn(|i| {
            if i < entry.uniforms {
                f32::of(&words[i..])
            } else {
                0.0
            }
        });
        let exact = Exact::of(entry, u, true);
        let x = entry.warp.sample(u);
        sample_error(entry, &exact, x, &mut figures);
        density_and_inverse_error(entry, &exact, x, &mut figures);
    }
    let name = entry.name.split(' ').next().unwrap_or(entry.name);
    let stated = docs::of_floats(name);
    let mut complaints = Vec::new();
    for (title, row) in ROWS {
        let found = *row(&mut figures);
        let bound = stated.iter().find(|(stated, _)| stated.starts_with(title));
        match bound {
            Some((_, bounds)) => {
                // Formulas are held by the tests.
                let bound = bounds[usize::from(entry.tier != "libm")].number();
                complaints.extend(bound.and_then(|bound| exceeds(title, found, bound)));
            }
            None if found > 0.0 => complaints.push(format!("{title}: nothing is stated")),
            None => {}
        }
    }
    complaints
}

/// The figures of the three grades in the row of a doc comment.
fn stated(warp: &str, title: &str) -> Option<[f64; 3]> {
    let row = Doc::find("fixed", warp)?.row(title)?;
    // Formulas are held by the tests.
    let number = |stated: docs::Statement| stated.number().unwrap_or(f64::INFINITY);
    Some(row.statements().map(number))
}

/// A step of a density, 2⁻³².
const STEP: f64 = 1.0 / 4_294_967_296.0;

/// The integer tier: of a coordinate, in the units of the documentation.
fn of_integers(sampler: &Sampler, errors: &Errors) -> Vec<String> {
    let name = sampler.name.split(' ').next().unwrap_or("");
    let grade = ["fine", "coarse", "compact"]
        .iter()
        .position(|g| *g == sampler.tier);
    let grade = grade.unwrap_or(0);
    let Some(bound) = stated(name, "sample, max") else {
        return vec!["sample, max: nothing is stated".into()];
    };
    // Of a triangle on vertices the error is in units of its extent, beyond half a step of its format, 2⁻¹⁶. Of a
    // truncated exponential it is in means, of 1/2, beyond a step, 2⁻²⁸, and a word of the uniform, whose largest
    // effect is (e⁶ − 1)/2 words.
    let (unit, step) = match name {
        "TriangleOn" => (450.0, 0.5_f64.powi(17)),
        "TruncatedExponential" => (0.5, 0.5_f64.powi(28) + 0.5 * 6_f64.exp_m1() * STEP),
        _ => (1.0, 0.0),
    };
    let found = if name.contains("Normal") {
        errors.point.max
    } else {
        errors.coordinate
    };
    let mut complaints: Vec<String> = exceeds("sample, max", found, bound[grade] * unit + step)
        .into_iter()
        .collect();
    // The density in its own unit, or of the largest.
    let density = errors.density.max;
    for (title, unit) in [("pdf", errors.peak), ("pdf, of that on the axis", 1.0)] {
        if let Some(bound) = stated(name, title) {
            let unit = if name == "TruncatedExponential" {
                1.0
            } else {
                unit
            };
            complaints.extend(exceeds(title, density * unit, bound[grade] + STEP));
        }
    }
    complaints
}
