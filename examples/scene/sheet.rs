//! The pictures, one by one and together.

use crate::args::Args;
use crate::render::{Pixels, Plan, PointSet, Tier, picture};
use crate::shots::Shot;
use host::draw::canvas::{Area, Canvas, save_rgb};
use host::draw::colour::MUTED;
use host::draw::panel::{HEAD, cells, head};
use host::draw::text::{Align, Type, thousands};
use std::error::Error;
use std::path::Path;

const MARGIN: f32 = 32.0;
const GAP: f32 = 24.0;
const TOP: f32 = 112.0;
const COLUMNS: usize = 3;

/// The columns that a picture has on the sheet, about.
const WIDE: u32 = 480;

/// Renders the pictures alone, and their sheet.
pub fn run(shots: &[Shot], args: &Args) -> Result<Vec<String>, Box<dyn Error>> {
    let rows = shots.len() as u64 * u64::from(args.size[1]);
    let progress = host::cli::progress(rows, "{percent:>3} %")?;
    let mut pictures = Vec::new();
    for shot in shots {
        progress.set_message(shot.name);
        let plan = Plan {
            tier: Tier::Poly,
            points: args.points,
            size: args.size,
            samples: (f64::from(args.samples) * shot.times).ceil() as u32,
            seed: args.seed,
        };
        let pixels = picture(&*shot.scene, &plan, || progress.inc(1));
        let path = args.out.join(format!("{}.png", shot.name));
        save(&path, shot, &pixels, args.size)?;
        pictures.push(pixels);
    }
    progress.finish_and_clear();
    let path = args.out.join("scene.png");
    let all: Vec<_> = pictures.iter().collect();
    draw(shots, &all, args).save(&path)?;
    println!("The sheet is {}, each picture beside it.", path.display());
    let invalid: usize = pictures.iter().map(crate::study::invalid).sum();
    let complaint = format!("{invalid} numbers are no light");
    Ok((invalid > 0).then_some(complaint).into_iter().collect())
}

pub fn save(path: &Path, shot: &Shot, pixels: &Pixels, size: [u32; 2]) -> Result<(), String> {
    let bytes: Vec<u8> = pixels
        .iter()
        .flat_map(|light| (shot.develop)(*light).map(|c| c.round() as u8))
        .collect();
    save_rgb(path, size, &bytes)
}

pub fn draw(shots: &[Shot], pictures: &[&Pixels], args: &Args) -> Canvas {
    let size = args.size;
    let scale = (WIDE / size[0]).max(1) as f32;
    let [w, h] = size.map(|n| n as f32 * scale);
    let rows = shots.len().div_ceil(COLUMNS) as f32;
    let width = 2.0 * MARGIN + COLUMNS as f32 * (w + GAP) - GAP;
    let height = TOP + rows * (HEAD + h) + MARGIN;
    let mut canvas = Canvas::new(width as u32, height as u32);
    let fit = width - 2.0 * MARGIN;
    let title = "One path tracer, six scenes, every random number from microwarp";
    canvas.text(title, [MARGIN, 58.0], Align::Left, Type::bold(38.0), fit);
    let points = match args.points {
        PointSet::Screen => "one set of Sobol' points for all",
        _ => "Owen-scrambled Sobol' points",
    };
    let text = format!(
        "{} × {} pixels, about {} samples each of {points}, tier poly",
        size[0],
        size[1],
        thousands(args.samples as usize)
    );
    canvas.text(
        &text,
        [MARGIN, 94.0],
        Align::Left,
        Type::plain(23.0, MUTED),
        fit,
    );
    for (i, (shot, pixels)) in shots.iter().zip(pictures).enumerate() {
        let (column, row) = ((i % COLUMNS) as f32, (i / COLUMNS) as f32);
        let place = Area::new(
            MARGIN + column * (w + GAP),
            TOP + row * (HEAD + h),
            w,
            HEAD + h,
        );
        let place = head(&mut canvas, place, shot.title, shot.text);
        let size = size.map(|n| n as usize);
        cells(&mut canvas, Area { h, ..place }, size, |k| {
            (shot.develop)(pixels[k])
        });
    }
    canvas
}
