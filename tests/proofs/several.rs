//! Bounds on the errors of maps of several uniforms and with parameters, over all of both.
//!
//! A map is written once more as a program (`parametric`). Its bits on `f32` are those of the crate, on `f64` it is the truth of the
//! registry, and a record of it (`tape`) bounds the difference over boxes that cover all parameters and uniforms (`cover`).
//! The azimuth is added as for the maps without parameters (`bounds`).

use crate::bounds::Roundings;
use crate::cover::{Piece, alone, binades, bins, pieces, triangle};
use crate::inputs::Uniforms;
use crate::line::stated;
use crate::maps::Row;
use crate::parametric::{Cone, Fog, Given, Polar, Triangle};
use crate::phases::{self, Cell};
use crate::products::{ball, normal_pair, rotation};
use crate::range::Range;
use crate::report::{Line, differs, table_of};
use crate::rounding::UNIT;
use crate::{bilinear, equi_angular, fisher, kept, lobe, shapes, sweeps, truncated};
use host::docs::STALE;
use host::speed;
use microwarp::tier::{Libm, Poly, Tier};
use std::fmt::Write as _;
use std::sync::LazyLock;

/// A row of a warp: its name, the title, and what is proven in `libm` and in `poly`.
pub type Proven = (&'static str, &'static str, [f64; 2]);

/// The cells of both tiers.
pub type Cells = [Vec<Cell>; 2];

/// They are swept once.
pub static CELLS: LazyLock<Cells> = LazyLock::new(|| {
    [Libm::sincos_turns, Poly::sincos_turns].map(|kernel| phases::sweep(Uniforms::Any, kernel, 0.0))
});

/// Uniforms up to a half. At 0 points are exact.
pub fn uniforms(parts: u32) -> Vec<Range> {
    binades(-44, 0.5, parts)
}

/// The parameter above a bottom, which begins the list with all down to it.
fn down_to(bottom: f64, mut binades: Vec<Range>) -> Vec<Range> {
    binades[0].low = bottom;
    binades
}

/// The largest errors of a sample over pieces and all azimuths.
pub fn samples(pieces: &[Piece], cells: &Cells, roundings: Roundings) -> [f64; 2] {
    let radii = bins(pieces);
    cells
        .each_ref()
        .map(|cells| roundings.sample(&radii, cells).bound)
}

fn sine(pieces: &[Piece]) -> [f64; 2] {
    [pieces.iter().map(|p| p.sine).fold(0.0, f64::max); 2]
}

fn cones(off: [sweeps::Halves; 2]) -> Vec<Piece> {
    // Of k up to 1, and of what k leaves of 2 where it is above.
    let ks = down_to(2.0_f64.powi(-126), binades(-20, 1.0, 4));
    let rests = down_to(0.0, binades(-44, 1.0, 4));
    let of = |wide, boxes: &[Range]| {
        let boxes: Vec<_> = boxes.iter().map(|&k| [k]).collect();
        pieces(&Cone { wide, off }, &boxes, &uniforms(4), (1.8e-7, 3))
    };
    let mut all = of(false, &ks);
    all.extend(of(true, &rests));
    all
}

fn fogs() -> Vec<Piece> {
    let mut all = Vec::new();
    for backward in [false, true] {
        for of in [Given::G, Given::OneMinusG] {
            // 1 - |g| is 2^-32 or more.
            let widths = binades(-32, 1.0, 4).into_iter().skip(1);
            let widths: Vec<_> = widths.map(|width| [width]).collect();
            let fog = Fog { backward, of };
            all.extend(pieces(&fog, &widths, &uniforms(4), (4.8e-7, 4)));
        }
    }
    all
}

/// What is proven of cones and of fog.
fn polar(cells: &Cells) -> Vec<Proven> {
    // The length is right whatever 1 - cos θ is off by, since sine and cosine are both made of it.
    let polar = bins(&alone(&Polar, &binades(-44, 1.0 + 64.0 * UNIT, 512)));
    let length = cells
        .each_ref()
        .map(|cells| Roundings::PLAIN.length(&polar, cells).bound);
    let fogs = fogs();
    let [libm, poly] = [sweeps::cone::<Libm>(), sweeps::cone::<Poly>()].map(cones);
    let cone = [
        samples(&libm, cells, Roundings::PLAIN)[0],
        samples(&poly, cells, Roundings::PLAIN)[1],
    ];
    let fog = "HenyeyGreenstein";
    vec![
        ("Cone", "sample", cone),
        ("Cone", "unit length", length),
        (fog, "sample", samples(&fogs, cells, Roundings::PLAIN)),
        (fog, "sin θ, ulp", sine(&fogs)),
        (fog, "unit length", length),
    ]
}

/// What is proven of a point of a triangle or a ball, of a rotation and of a normal pair.
fn others(cells: &Cells) -> Vec<Proven> {
    let of_triangles = triangle(&Triangle { once_more: false }, &[], &uniforms(4));
    vec![
        ("Triangle", "sample", [of_triangles; 2]),
        ("Ball", "sample", ball(cells)),
        ("Rotation", "sample", rotation(cells)),
        ("NormalPair", "sample", normal_pair(cells)),
    ]
}

/// How the rows of some warps are worked out.
type Rows = fn(&Cells) -> Vec<Proven>;

/// What is proven, of the warps that are asked for.
fn rows() -> Vec<Proven> {
    let of: [(&[&str], Rows); 8] = [
        (
            &["TriangleOn", "Annulus", "Ggx", "RegularPolygon"],
            shapes::rows,
        ),
        (&["PhongLobe"], lobe::rows),
        (&["VonMisesFisher"], fisher::rows),
        (&["EquiAngular"], equi_angular::rows),
        (&["TruncatedExponential"], truncated::rows),
        (&["Bilinear"], bilinear::rows),
        (&["Triangle", "Ball", "Rotation", "NormalPair"], others),
        (&["Cone", "HenyeyGreenstein"], polar),
    ];
    let wanted = |(names, _): &(&[&str], Rows)| names.iter().any(|name| speed::wants(name));
    let wanted = of.into_iter().filter(wanted);
    wanted.flat_map(|(_, rows)| rows(&CELLS)).collect()
}

/// What is wrong with a bound. In the quick speed it is that of some of the boxes.
pub fn complaint(stated: f64, Row { proven, found }: Row) -> Option<String> {
    // Each written so that NaN fails.
    let holds = proven <= stated;
    let near = found <= proven && stated <= STALE * proven && stated <= 2.0 * found;
    let figures = || format!("{stated} stated, {proven:.4e} proven, {found:.4e} found");
    (!holds || speed::full() && !near).then(figures)
}

#[test]
fn stated_errors_are_proven_for_all_parameters() {
    let mut complaints = String::new();
    let lines = rows().into_iter().map(|(name, title, proven)| {
        let ((_, stated), found) = (stated(name, title), kept::largest(name, title));
        let rows = [0, 1].map(|tier| Row {
            proven: proven[tier],
            found: found[tier],
        });
        for (stated, row) in stated.into_iter().zip(rows) {
            if let Some(wrong) = complaint(stated, row) {
                let _ = writeln!(complaints, "{name}: {title}: {wrong}");
            }
        }
        Line {
            name,
            title: title.into(),
            stated: stated.to_vec(),
            rows: rows.to_vec(),
            formula: None,
        }
    });
    let table = table_of(&lines.collect::<Vec<_>>());
    complaints.extend(differs("## Maps with parameters", &table));
    assert!(complaints.is_empty(), "\n{complaints}");
}

#[test]
fn a_broken_link_of_the_argument_about_parameters_is_noticed() {
    // Without the errors of k a cone would be better than it is.
    let cells = &*CELLS;
    let (_, [cone, _]) = stated("Cone", "sample");
    let [found, ..] = kept::largest("Cone", "sample");
    let [left_out, ..] = samples(&cones([[0.0; 17]; 2]), cells, Roundings::PLAIN);
    assert!(left_out < found, "{left_out} proven, {found} found");
    // With more of them it is worse than stated.
    let [more, ..] = samples(&cones([[6.0; 17]; 2]), cells, Roundings::PLAIN);
    assert!(
        complaint(
            cone,
            Row {
                proven: more,
                found
            }
        )
        .is_some()
    );

    let (_, [stated, _]) = stated("Triangle", "sample");
    let [found, ..] = kept::largest("Triangle", "sample");
    let judged = |once_more| {
        let proven = triangle(&Triangle { once_more }, &[], &uniforms(4));
        complaint(stated, Row { proven, found })
    };
    assert_eq!(judged(false), None);
    assert!(judged(true).is_some());
}
