//! The banner of README.md: a dozen warps beside the path tracer's room.

use crate::Subject;
use crate::args::Args;
use crate::sheet::panel;
use host::draw::canvas::{Area, Canvas};
use host::draw::colour::{HAIR, MUTED};
use host::draw::panel::cells;
use host::draw::text::{Align, Type};

/// What is shown, by name.
pub const SHOWN: [&str; 12] = [
    "TruncatedNormal",
    "Disk",
    "DiskConcentric",
    "RegularPolygon",
    "Bilinear",
    "CosineHemisphere",
    "GgxVisible",
    "SphericalTriangle",
    "PiecewiseLinear1d",
    "LatLongMap",
    "BoxSurface",
    "CapsuleSurface",
];

const WIDTH: f32 = 1240.0;
/// A reader sees it before the first line of text.
const HIGHEST: f32 = 520.0;
const MARGIN: f32 = 14.0;
const COLUMNS: usize = 4;
/// Between the columns, and between the warps and the room.
const GAP: f32 = 16.0;
const NAME: f32 = 22.0;
/// Points of a panel, which is small.
const POINTS: usize = 400;

pub fn draw(subjects: &[Subject], room: &([u32; 2], Vec<u8>), args: &Args) -> Canvas {
    let (size, rgb) = room;
    let [w, h] = size.map(|n| n as f32);
    let wide = (WIDTH - 2.0 * MARGIN - w - 2.0 * GAP - 3.0 * GAP) / COLUMNS as f32;
    let rows = SHOWN.len() / COLUMNS;
    let pitch = (HIGHEST - 2.0 * MARGIN + GAP) / rows as f32;
    let mut canvas = Canvas::new(WIDTH as u32, HIGHEST as u32);
    let args = Args {
        points: POINTS,
        ..args.clone()
    };
    for (i, name) in SHOWN.iter().enumerate() {
        let Some(subject) = subjects.iter().find(|s| s.name == *name) else {
            continue;
        };
        let [column, row] = [i % COLUMNS, i / COLUMNS].map(|n| n as f32);
        let [x, y] = [MARGIN + column * (wide + GAP), MARGIN + row * pitch];
        let style = Type::bold(16.0);
        canvas.text(name, [x, y + 15.0], Align::Left, style, wide);
        let place = Area::new(x, y + NAME, wide, pitch - GAP - NAME);
        panel(&mut canvas, place, subject, crate::SHEET_TIER, &args, 0.85);
    }
    let x = WIDTH - MARGIN - w;
    let y = MARGIN + 0.5 * (HIGHEST - 2.0 * MARGIN - h - 40.0);
    let place = Area::new(x, y, w, h);
    cells(&mut canvas, place, size.map(|n| n as usize), |k| {
        [0, 1, 2].map(|c| f64::from(rgb[3 * k + c]))
    });
    canvas.segment([x, y + h], [x + w, y + h], 0.9, HAIR);
    let lines = [
        "A room by a path tracer, 1,000 samples a pixel.",
        "Every sample in it, and on the left, is drawn by microwarp.",
    ];
    for (line, dy) in lines.iter().zip([24.0, 45.0]) {
        let style = Type::plain(16.5, MUTED);
        canvas.text(line, [x, y + h + dy], Align::Left, style, w);
    }
    canvas
}
