//! The pictures, one by one and together.

use crate::args::Args;
use crate::render::Pixels;
use crate::shots::Shot;
use crate::study::{SAMPLES, Study};
use std::path::Path;
use support::draw::canvas::{Area, Canvas, save_rgb};
use support::draw::colour::{MUTED, WHITE};
use support::draw::panel::{HEAD, cells, head};
use support::draw::text::{Align, Type};

const MARGIN: f32 = 40.0;
const GAP: f32 = 30.0;
const TOP: f32 = 118.0;
const COLUMNS: usize = 3;

/// The scene whose noise is shown.
pub const NOISY: usize = 0;

/// The columns that a picture has on the sheet, about.
const WIDE: u32 = 576;

pub fn save(path: &Path, shot: &Shot, pixels: &Pixels, size: [u32; 2]) -> Result<(), String> {
    let bytes: Vec<u8> = pixels
        .iter()
        .flat_map(|light| (shot.develop)(*light).map(|c| c.round() as u8))
        .collect();
    save_rgb(path, size, &bytes)
}

pub fn draw(shots: &[Shot], studies: &[Study], rough: &[Pixels; 2], args: &Args) -> Canvas {
    let size = args.size;
    let scale = (WIDE / size[0]).max(1) as f32;
    let [w, h] = size.map(|n| n as f32 * scale);
    let rows = (shots.len() + 1).div_ceil(COLUMNS) as f32;
    let width = 2.0 * MARGIN + COLUMNS as f32 * (w + GAP) - GAP;
    let height = TOP + rows * (HEAD + h) + MARGIN;
    let mut canvas = Canvas::new(width as u32, height as u32);
    let fit = width - 2.0 * MARGIN;
    let title = "One path tracer, six scenes, every random number from microwarp";
    canvas.text(title, [MARGIN, 62.0], Align::Left, Type::bold(40.0), fit);
    let text = format!(
        "{} × {} pixels, {} samples each of Owen-scrambled Sobol' points, tier poly",
        size[0], size[1], args.samples
    );
    canvas.text(
        &text,
        [MARGIN, 100.0],
        Align::Left,
        Type::plain(24.0, MUTED),
        fit,
    );
    let place = |i: usize| {
        let (column, row) = ((i % COLUMNS) as f32, (i / COLUMNS) as f32);
        Area::new(
            MARGIN + column * (w + GAP),
            TOP + row * (HEAD + h),
            w,
            HEAD + h,
        )
    };
    let size = size.map(|n| n as usize);
    for (i, (shot, study)) in shots.iter().zip(studies).enumerate() {
        let place = head(&mut canvas, place(i), shot.title, shot.text);
        let place = Area { h, ..place };
        cells(&mut canvas, place, size, |k| {
            (shot.develop)(study.picture[k])
        });
    }
    let text = format!("{} samples: random, Sobol'", SAMPLES[0]);
    let place = head(&mut canvas, place(shots.len()), "Noise", &text);
    let place = Area { h, ..place };
    let [left, right] = rough;
    cells(&mut canvas, place, size, |k| {
        let side = if k % size[0] < size[0] / 2 {
            left
        } else {
            right
        };
        (shots[NOISY].develop)(side[k])
    });
    let middle = place.x + 0.5 * w;
    canvas.segment([middle, place.y], [middle, place.y + h], 2.0, WHITE);
    canvas
}
