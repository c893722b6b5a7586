//! The maps, the form in which they are examined, and what comes out.

use crate::bounds::{Roundings, Worst};
use crate::inputs::Uniforms;
use crate::phases::{self, Cell};
use crate::radii::{self, Radii};
use crate::search;
use host::errors::raise;
use host::figures::Figures;
use host::registry::{Entry, Measure, entries};
use microwarp::tier::Tier;
use microwarp::uniform::LARGEST;

pub const MAPS: [&str; 7] = [
    "Disk",
    "DiskConcentric",
    "Sphere",
    "Hemisphere",
    "CosineHemisphere",
    "MalleyHemisphere",
    "NormalPair",
];

pub fn is_concentric(name: &str) -> bool {
    matches!(name, "DiskConcentric" | "MalleyHemisphere")
}

/// The map in the catalogue; of the normal pair the standard one.
pub fn entry<T: Tier>(name: &str) -> Entry {
    let mut all = entries().into_iter();
    let entry = all.find(|e| e.name == name && e.tier == T::NAME).unwrap();
    // All are of size 1; the standard pair is measured in deviations.
    Entry {
        measure: Measure::Length(1.0),
        ..entry
    }
}

impl Roundings {
    /// What is rounded in the map of that name.
    pub fn of(name: &str, uniforms: Uniforms) -> Self {
        Self {
            quotient: is_concentric(name),
            square: is_concentric(name) && uniforms == Uniforms::Any,
            ..Self::PLAIN
        }
    }
}

/// Sine and cosine over all phases, and points of the largest radius.
pub struct Kernels {
    plain: Vec<Cell>,
    rim: Vec<Cell>,
}

impl Kernels {
    pub fn of(uniforms: Uniforms, kernel: impl Fn(f32) -> (f32, f32) + Copy + Sync) -> Self {
        Self {
            plain: phases::sweep(uniforms, kernel, 0.0),
            // Near the axis the product is one ulp, 2^-24, below the cosine, and its own rounding a thousandth of that.
            rim: phases::sweep(uniforms, radii::rim(kernel), 1.002 * 2.0_f64.powi(-24)),
        }
    }
}

/// An error as it is proven and as it is found.
#[derive(Clone, Copy, Debug, Default)]
pub struct Row {
    pub proven: f64,
    pub found: f64,
}

/// Of one map in one tier: the error of the sample, of sin θ and of cos θ in ulp, and of the length of a direction.
pub struct Outcome {
    pub rows: [Row; 4],
}

/// Bounds the errors of a map and looks for large ones where the bounds are reached.
pub fn examine<T: Tier>(
    name: &str,
    uniforms: Uniforms,
    radii: &Radii,
    kernels: &Kernels,
    roundings: Roundings,
) -> Outcome {
    let entry = entry::<T>(name);
    let mut proven = Figures {
        sine: radii.sine.max(radii.argued[0]),
        cosine: radii.cosine.max(radii.argued[1]),
        ..Figures::default()
    };
    let mut found = Figures {
        sine: radii.sine,
        cosine: radii.cosine,
        ..Figures::default()
    };
    let mut part = |radii: &Radii, cells: &[Cell], roundings: Roundings, rim: bool| {
        let (sample, length) = (
            roundings.sample(radii, cells),
            roundings.length(radii, cells),
        );
        raise(&mut proven.sample, sample.bound);
        raise(&mut proven.length, length.bound);
        let mut near = |worst: &Worst| {
            let largest = if rim {
                search::near(
                    worst,
                    &entry,
                    uniforms,
                    radii,
                    cells,
                    radii::rim(T::sincos_turns),
                )
            } else {
                search::near(worst, &entry, uniforms, radii, cells, T::sincos_turns)
            };
            found.join(largest);
        };
        near(&sample);
        if entry.domain == host::registry::Domain::Directions {
            near(&length);
        }
    };
    part(radii, &kernels.plain, roundings, false);
    if is_concentric(name) {
        // Here products are of the kernel, and the quotient, by 1, is exact.
        let roundings = Roundings {
            products: false,
            quotient: false,
            ..roundings
        };
        part(&radii::end(uniforms), &kernels.rim, roundings, true);
    }
    let row = |of: fn(&Figures) -> f64| Row {
        proven: of(&proven),
        found: of(&found),
    };
    Outcome {
        rows: [
            row(|f| f.sample),
            row(|f| f.sine),
            row(|f| f.cosine),
            row(|f| f.length),
        ],
    }
}

/// Sine and cosine of any phase by those of an eighth of a turn.
pub fn mirrored<T: Tier>(t: f32) -> (f32, f32) {
    let quarters = (4.0 * f64::from(t)).round();
    let rest = f64::from(t) - 0.25 * quarters;
    assert!(rest.abs() <= 0.125 && f64::from(rest as f32) == rest, "{t}");
    let (s, c) = T::sincos_turns(rest.abs() as f32);
    let s = if rest < 0.0 { -s } else { s };
    match quarters.rem_euclid(4.0) as u32 {
        0 => (s, c),
        1 => (c, -s),
        2 => (-s, -c),
        _ => (-c, s),
    }
}

/// A map is what is examined here: a radius made of one uniform times sine and cosine of a phase, each product rounded
/// once; the height is made of the same uniform as the radius.
pub fn assert_form<T: Tier>(entry: &Entry, u: [f32; 2]) {
    let name = entry.name;
    let sample = |u: [f32; 2]| entry.warp.sample([u[0], u[1], 0.0, 0.0]);
    let expected = if is_concentric(name) {
        let [a, b] = u.map(|u| 2.0 * u - 1.0);
        let wide = a.abs() > b.abs();
        let (along, across) = if wide { (a, b) } else { (b, a) };
        let phase = if along == 0.0 {
            0.0
        } else {
            0.125 * (across / along)
        };
        let radius = along.clamp(-LARGEST, LARGEST);
        let (s, c) = mirrored::<T>(phase);
        let (x, y) = (radius * c, radius * s);
        // The height is that of the number of the square nearest to its edge.
        let nearest = |[u, v]: [f32; 2]| {
            if u.min(1.0 - u) < v.min(1.0 - v) {
                u
            } else {
                v
            }
        };
        let [_, _, z] = sample([nearest(u), 0.5]);
        if wide { [x, y, z] } else { [y, x, z] }
    } else {
        let [r, _, z] = sample([u[0], 0.0]);
        let (s, c) = mirrored::<T>(u[1]);
        [r * c, r * s, z]
    };
    assert_eq!(sample(u), expected, "{name} {} at {u:?}", T::NAME);
}
