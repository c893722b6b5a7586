//! How the error of one warp is measured in one tier, and the figures that come out.

use crate::errors::{apart, raise, ulp};
use crate::registry::{Domain, Entry, Measure, Point, Uniforms};
use crate::truth::{Truth, complements};
use microwarp::uniform::LARGEST;

/// The largest errors met in a sweep. Not-a-number counts as infinite.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Figures {
    /// The sample, in the unit of the entry's measure.
    pub sample: f64,
    /// sin θ in ulp, directions only.
    pub sine: f64,
    /// cos θ in ulp, directions only.
    pub cosine: f64,
    /// The length of a direction, from 1.
    pub length: f64,
    /// The place on a light that a direction leads to, in its coordinates there.
    pub place: f64,
    /// The density at the returned point, relative.
    pub pdf: f64,
    /// The density at the returned point against the one with which u is mapped there, relative.
    pub realised: f64,
    /// The density handed over with the sample, against the one with which u is mapped there, relative; only of warps
    /// that do not hand over that of the returned point.
    pub with_sample: f64,
    /// The inverse at the returned point, absolute.
    pub inverse: f64,
    /// u after sample and inverse, absolute.
    pub round_trip: f64,
}

/// Reaches one figure.
type Row = fn(&mut Figures) -> &mut f64;

/// The rows of an accuracy table: their titles and how to reach them.
pub const ROWS: [(&str, Row); 10] = [
    ("sample", |f| &mut f.sample),
    ("sin θ, ulp", |f| &mut f.sine),
    ("cos θ, ulp", |f| &mut f.cosine),
    ("unit length", |f| &mut f.length),
    ("place on it", |f| &mut f.place),
    ("pdf, relative", |f| &mut f.pdf),
    ("realised density, relative", |f| &mut f.realised),
    ("pdf with the sample, relative", |f| &mut f.with_sample),
    ("inverse", |f| &mut f.inverse),
    ("round trip", |f| &mut f.round_trip),
];

impl Figures {
    pub fn join(&mut self, mut other: Figures) {
        for (_, row) in ROWS {
            let theirs = *row(&mut other);
            raise(row(self), theirs);
        }
    }
}

pub fn wide(x: Point) -> [f64; 3] {
    x.map(f64::from)
}

/// What a uniform of 0 counts as where a warp's documentation says so.
const SMALLEST: f64 = f32::from_bits(1) as f64;

/// The first point of the grid above 0. Below it a point next to an end where the density is 0 may round
/// onto a neighbour whose density is a multiple of its own.
const GRID_STEP: f64 = 1.0 / 16_777_216.0;

/// What is exact for one input, worked out once for both tiers.
pub struct Exact {
    pub u: [f64; 4],
    pub point: [f64; 3],
    pub fourth: Option<f64>,
    pub density: f64,
}

impl Exact {
    pub fn of(entry: &Entry, u: Uniforms, with_density: bool) -> Self {
        let zero = if entry.open { SMALLEST } else { 0.0 };
        let u = u.map(|u| if u == 0.0 { zero } else { f64::from(u) });
        Self::at(entry, u, with_density)
    }

    /// The point at the middle of a word.
    pub fn drawn(entry: &Entry, word: u32) -> Self {
        let middle = (f64::from(word) + 0.5) * 2f64.powi(-32);
        Self::at(entry, [middle, 0.0, 0.0, 0.0], false)
    }

    fn at(entry: &Entry, u: [f64; 4], with_density: bool) -> Self {
        let truth: &dyn Truth = entry.truth.as_ref();
        let point = truth.sample(u);
        let density = if with_density { truth.density(u) } else { 0.0 };
        Self {
            u,
            point,
            fourth: truth.fourth(u),
            density,
        }
    }
}

/// The error of a sample alone.
pub fn sample_error(entry: &Entry, exact: &Exact, x: Point, figures: &mut Figures) {
    let x = wide(x);
    let distance = {
        let [a, b, c] = [0, 1, 2].map(|k| x[k] - exact.point[k]);
        let found = || f64::from(entry.warp.fourth(exact.u.map(|u| u as f32)));
        let d = exact.fourth.map_or(0.0, |due| found() - due);
        if entry.domain == Domain::Line {
            a.abs()
        } else {
            (a * a + b * b + c * c + d * d).sqrt()
        }
    };
    let unit = match entry.measure {
        Measure::Ulp => ulp(exact.point[0]),
        Measure::UlpOf(scale) => ulp(scale),
        Measure::UlpFrom(mean, least) => {
            ulp((exact.point[0] - mean).abs().max(mean.abs()).max(least))
        }
        Measure::UlpAbove(least) => ulp(exact.point[0].abs().max(least)),
        Measure::Length(length) => length,
        Measure::From(middle) => Measure::far(middle, exact.point),
    };
    raise(&mut figures.sample, distance / unit);
    if matches!(entry.domain, Domain::Directions | Domain::World) {
        let norm = (x[0] * x[0] + x[1] * x[1] + x[2] * x[2]).sqrt();
        raise(&mut figures.length, (norm - 1.0).abs());
    }
}

/// The errors of two draws against the exact points at the middle of their words: of a word whose upper digits are a
/// uniform's, and of the word as far from the other end.
pub fn draw_error(entry: &Entry, u: f32, figures: &mut Figures) {
    if entry.middle {
        let word =
            (f64::from(u) * 2f64.powi(32)) as u32 ^ (u.to_bits().wrapping_mul(0x9e37_79b9) >> 24);
        for word in [word, !word] {
            sample_error(
                entry,
                &Exact::drawn(entry, word),
                entry.warp.drawn(word),
                figures,
            );
        }
    }
}

/// sin θ and cos θ of a direction sampled with azimuth 0, where x is sin θ itself.
///
/// Where cos θ passes through 0 its error in ulp means nothing, and is left out.
pub fn polar_error(entry: &Entry, exact: &Exact, x: Point, figures: &mut Figures) {
    let [sine, _, cosine] = exact.point;
    raise(
        &mut figures.sine,
        (f64::from(x[0]) - sine).abs() / ulp(sine),
    );
    if entry.cosine {
        raise(
            &mut figures.cosine,
            (f64::from(x[2]) - cosine).abs() / ulp(cosine),
        );
    }
}

/// The error of the place on a light, of a warp that tells it.
pub fn place_error(entry: &Entry, u: Uniforms, figures: &mut Figures) {
    if let Some(place) = &entry.place {
        let (found, exact) = place(u);
        for (found, exact) in found.into_iter().zip(exact) {
            raise(&mut figures.place, (f64::from(found) - exact).abs());
        }
    }
}

/// How far the exact place on a light moves when each uniform and each coordinate of the direction does by 2⁻²⁴; 0 for a warp
/// that tells no place.
pub fn place_moved(entry: &Entry, u: Uniforms, exact: &Exact) -> f64 {
    let Some(place) = &entry.place else {
        return 0.0;
    };
    let here = place(u).1;
    let away = |u: Uniforms| {
        let mut most = 0.0;
        for (a, b) in here.iter().zip(place(u).1) {
            raise(&mut most, (a - b).abs());
        }
        most
    };
    // By more than that, for a step of `f32` anywhere.
    let step = 0.5_f32.powi(22);
    let mut sum = 0.0;
    for k in 0..3 {
        let mut most: f64 = 0.0;
        for step in [-step, step] {
            if k < 2 {
                let mut moved = u;
                moved[k] = (u[k] + step).clamp(0.0, LARGEST);
                most = most.max(away(moved));
            }
            let mut there = exact.point;
            there[k] += f64::from(step);
            let back = entry.truth.invert(there);
            most = most.max(away(back.map(|u| (u as f32).clamp(0.0, LARGEST))));
        }
        sum += most / 4.0;
    }
    sum
}

/// The error of the density handed over with the sample, where that is not the density of the returned point.
pub fn density_with_sample_error(entry: &Entry, exact: &Exact, u: Uniforms, figures: &mut Figures) {
    let normal = f64::from(f32::MIN_POSITIVE)..=f64::from(f32::MAX);
    if entry.own_density && normal.contains(&exact.density) && !at_open_end(entry, u) {
        let (_, density) = entry.warp.sample_with_pdf(u);
        let error = (f64::from(density) - exact.density).abs() / exact.density;
        raise(&mut figures.with_sample, error);
    }
}

/// Whether a uniform lies between 0 and the grid's first, where a point next to an end of density 0 may round onto
/// a neighbour whose density is a multiple of its own.
pub fn at_open_end(entry: &Entry, u: Uniforms) -> bool {
    u[..entry.uniforms]
        .iter()
        .any(|u| f64::from(*u) < GRID_STEP)
}

/// The errors of density and inverse at a returned point.
pub fn density_and_inverse_error(entry: &Entry, exact: &Exact, x: Point, figures: &mut Figures) {
    let point = wide(x);
    let pdf = f64::from(entry.warp.pdf(x));
    // Outside the normal range of f32 a density is no longer accurate, only positive and finite.
    let normal = f64::from(f32::MIN_POSITIVE)..=f64::from(f32::MAX);
    let relative = |density: f64, truth: f64| (density - truth).abs() / truth;
    let at_point = entry.truth.pdf(point);
    if normal.contains(&at_point) && normal.contains(&exact.density) {
        raise(&mut figures.pdf, relative(pdf, at_point));
        if let Some(alone) = entry.alone {
            raise(&mut figures.pdf, relative(alone.into(), at_point));
        }
        if entry.resolved && exact.u[..entry.uniforms].iter().all(|u| *u >= GRID_STEP) {
            raise(&mut figures.realised, relative(pdf, exact.density));
        }
    }
    let inverse = entry.warp.invert(x).map(f64::from);
    let at_point = entry.truth.invert(point);
    for k in 0..entry.uniforms {
        if k > 0 && is_lost(entry, k, point) {
            continue;
        }
        let turns = is_azimuth(entry, k);
        let found = apart(inverse[k], at_point[k].clamp(0.0, 1.0), turns);
        raise(&mut figures.inverse, found);
        if entry.round_trip {
            raise(
                &mut figures.round_trip,
                apart(inverse[k], exact.u[k], turns),
            );
        }
    }
}

/// Whether this point is the same for all values of a later uniform, as at the centre of a disk or a pole.
fn is_lost(entry: &Entry, k: usize, x: [f64; 3]) -> bool {
    if let Some(height) = entry.variable("h") {
        // Beside the point where it is 0, the first uniform may come out a rounding below.
        let first = entry.truth.invert(x)[0].max(0.0);
        return first.sqrt() * height < 2_f64.powi(-20);
    }
    match entry.domain {
        Domain::Line => false,
        Domain::Plane => x[0] == 0.0 && x[1] == 0.0,
        Domain::Directions => {
            let (down, up) = complements(x);
            down * up == 0.0
        }
        Domain::World => {
            let local = entry.truth.invert(x)[0];
            local < 1e-6
        }
        Domain::Solid | Domain::Rotations => {
            entry.azimuth && k == 2 && x[0] == 0.0 && x[1] == 0.0 || x == [0.0; 3]
        }
        // Coordinates below the normal numbers have lost their digits.
        Domain::Space if entry.azimuth && x[0].hypot(x[1]) < 2f64.powi(-125) => true,
        Domain::Space | Domain::Barycentric => {
            x[1] == 0.0 && x[2] == 0.0 || entry.truth.invert(x)[0] == 0.0
        }
    }
}

/// Whether the k-th uniform is an azimuth, of which 0 and 1 are the same: the last one.
pub fn is_azimuth(entry: &Entry, k: usize) -> bool {
    k + 1 == entry.uniforms && entry.azimuth
}
