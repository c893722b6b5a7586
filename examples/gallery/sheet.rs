//! Pages: one picture per warp with both tiers side by side, and the contact sheet of all warps.

use crate::Subject;
use crate::args::Args;
use crate::check::error_text;
use crate::check::{Figures, generator, p_text};
use crate::{area, line, strata};
use host::draw::canvas::{Area, Canvas};
use host::draw::colour::{ACCENT, BAR, INK, MUTED, POINT, WHITE, faded, ramp};
use host::draw::text::{Align, Type, thousands};
use host::registry::picture::View;
use rand_pcg::Pcg32;

/// Purposes of generators beyond those of the check.
const POINTS: u64 = 16;

const COLUMNS: usize = 5;
const MARGIN: f32 = 36.0;
const GAP: f32 = 26.0;
/// Title and caption of a cell.
const HEAD: f32 = 54.0;

/// Draws the data of a subject in one tier (by its place in the subject's rows).
pub fn panel(
    canvas: &mut Canvas,
    place: Area,
    subject: &Subject,
    tier: usize,
    args: &Args,
    unit: f32,
) {
    let mut rng = subject.entries.get(tier).map_or_else(
        || Pcg32::new(args.seed, POINTS),
        |entry| generator(args.seed, entry, POINTS),
    );
    match (subject.picture.view, subject.entries.get(tier)) {
        (View::Strata1d, _) => strata::line(canvas, place, &mut rng, unit),
        (view @ (View::Strata2d | View::Sobol | View::Recurrence | View::ByPosition), _) => {
            strata::plane(canvas, place, &mut rng, unit, view);
        }
        (View::Screen, _) => strata::draw(canvas, place, unit),
        (View::Line(axes), Some(entry)) => line::draw(canvas, place, axes, entry, &mut rng, unit),
        (view, Some(entry)) => area::draw(canvas, place, view, entry, &mut rng, args.points, unit),
        (_, None) => {}
    }
}

/// The page of one subject.
pub fn single(subject: &Subject, figures: &[Option<&Figures>], args: &Args) -> Canvas {
    let (width, height) = (1200.0, 720.0);
    let mut canvas = Canvas::new(width as u32, height as u32);
    let inner = Area::new(0.0, 0.0, width, height).inside(40.0, 0.0, 40.0, 0.0);
    let title = Type::bold(34.0);
    canvas.text(subject.name, [inner.x, 56.0], Align::Left, title, inner.w);
    let after = inner.x + canvas.width(subject.name, title) + 22.0;
    let caption = Type::plain(24.0, MUTED);
    canvas.text(
        subject.picture.caption,
        [after, 56.0],
        Align::Left,
        caption,
        inner.x + inner.w - after,
    );

    let tall = Area::new(inner.x, 96.0, inner.w, height - 96.0);
    if subject.entries.is_empty() {
        panel(
            &mut canvas,
            tall.inside(0.0, 0.0, 0.0, 30.0),
            subject,
            0,
            args,
            1.7,
        );
        return canvas;
    }
    let gap = 50.0;
    let w = (tall.w - gap) / 2.0;
    for (tier, entry) in subject.entries.iter().enumerate() {
        let half = Area {
            x: tall.x + tier as f32 * (w + gap),
            w,
            ..tall
        };
        panel(
            &mut canvas,
            half.inside(0.0, 0.0, 0.0, 96.0),
            subject,
            tier,
            args,
            1.7,
        );
        let middle = half.x + 0.5 * half.w;
        let base = half.y + half.h;
        canvas.text(
            entry.tier,
            [middle, base - 58.0],
            Align::Middle,
            Type::bold(22.0),
            w,
        );
        if let Some(Some(figures)) = figures.get(tier) {
            let text = format!(
                "{} samples · χ² p = {} · largest error {}",
                thousands(figures.shape.samples),
                p_text(&figures.shape),
                error_text(entry, figures.error)
            );
            canvas.text(
                &text,
                [middle, base - 28.0],
                Align::Middle,
                Type::plain(19.0, MUTED),
                w,
            );
        }
    }
    canvas
}

/// The picture of one subject alone, small, for its documentation.
pub fn thumbnail(subject: &Subject, tier: usize, args: &Args) -> Canvas {
    let flat = matches!(subject.picture.view, View::Line(_) | View::Strata1d);
    let (width, height) = if flat { (320, 180) } else { (240, 240) };
    let mut canvas = Canvas::new(width, height);
    let place = Area::new(0.0, 0.0, width as f32, height as f32).inside(4.0, 4.0, 4.0, 4.0);
    let args = Args {
        points: args.points.min(300),
        ..args.clone()
    };
    panel(&mut canvas, place, subject, tier, &args, 0.8);
    canvas
}

/// The contact sheet, in the tier whose place is `tier`.
pub fn contact(subjects: &[Subject], tier: usize, args: &Args) -> Canvas {
    let width = 1600.0;
    let cell = (width - 2.0 * MARGIN - (COLUMNS - 1) as f32 * GAP) / COLUMNS as f32;
    // Rows of histograms need less height than rows of squares.
    let row_height = |row: &[Subject]| {
        let flat = row.iter().all(|s| matches!(s.picture.view, View::Line(_)));
        HEAD + if flat { 0.64 * cell } else { 0.88 * cell }
    };
    let header = 128.0;
    let rows = subjects.chunks(COLUMNS);
    let height = header + rows.clone().map(|row| row_height(row) + GAP).sum::<f32>() + 92.0;
    let mut canvas = Canvas::new(width as u32, height as u32);

    canvas.text(
        "microwarp",
        [MARGIN, 66.0],
        Align::Left,
        Type::bold(46.0),
        width,
    );
    let name = subjects
        .iter()
        .find_map(|s| s.entries.get(tier))
        .map_or("", |entry| entry.tier);
    let text = format!(
        "every warp over its density: {name} tier, Pcg32, seed {}",
        args.seed
    );
    canvas.text(
        &text,
        [MARGIN, 100.0],
        Align::Left,
        Type::plain(23.0, MUTED),
        width - 2.0 * MARGIN,
    );

    let mut y = header;
    for row in rows {
        let h = row_height(row);
        for (column, subject) in row.iter().enumerate() {
            let place = Area::new(MARGIN + column as f32 * (cell + GAP), y, cell, h);
            canvas.text(
                subject.name,
                [place.x, y + 20.0],
                Align::Left,
                Type::bold(21.0),
                cell,
            );
            let caption = Type::plain(17.5, MUTED);
            canvas.text(
                subject.picture.caption,
                [place.x, y + 43.0],
                Align::Left,
                caption,
                cell,
            );
            panel(
                &mut canvas,
                place.inside(0.0, HEAD, 0.0, 0.0),
                subject,
                tier,
                args,
                1.0,
            );
        }
        y += h + GAP;
    }
    legend(&mut canvas, [MARGIN, y + 22.0]);
    canvas
}

/// The legend: one row for pictures over the line, one for pictures over an area.
fn legend(canvas: &mut Canvas, [left, y]: [f32; 2]) {
    type Mark = fn(&mut Canvas, f32, f32);
    let histogram = format!("histogram of {} samples", thousands(line::SAMPLES));
    let image = format!(
        "image of a grid of {0} × {0} on the unit square of uniforms",
        area::GRID
    );
    let marks: [[(Mark, &str); 3]; 2] = [
        [
            (bar, &histogram),
            (curve, "density"),
            (ticks, "single samples, the darker the larger their uniform"),
        ],
        [
            (dot, "sample; directions in Lambert's equal-area projection"),
            (tile, "density"),
            (cross, &image),
        ],
    ];
    let style = Type::plain(18.0, INK);
    for (row, marks) in marks.into_iter().enumerate() {
        let (mut x, y) = (left, y + 32.0 * row as f32);
        for (mark, text) in marks {
            mark(canvas, x, y - 6.0);
            canvas.text(text, [x + 34.0, y], Align::Left, style, 1000.0);
            x += 34.0 + canvas.width(text, style) + 36.0;
        }
    }
}

fn bar(canvas: &mut Canvas, x: f32, y: f32) {
    canvas.rectangle(Area::new(x, y - 8.0, 24.0, 16.0), BAR);
}

fn curve(canvas: &mut Canvas, x: f32, y: f32) {
    canvas.segment([x, y], [x + 24.0, y], 2.2, ACCENT);
}

fn dot(canvas: &mut Canvas, x: f32, y: f32) {
    canvas.disc([x + 12.0, y], 3.2, POINT);
}

fn ticks(canvas: &mut Canvas, x: f32, y: f32) {
    for i in 0..4 {
        let x = x + 4.0 + 5.0 * i as f32;
        canvas.segment(
            [x, y - 7.0],
            [x, y + 7.0],
            1.4,
            faded(POINT, 0.15 + 0.25 * i as f32),
        );
    }
}

fn tile(canvas: &mut Canvas, x: f32, y: f32) {
    canvas.shade(Area::new(x, y - 8.0, 24.0, 16.0), |px, _| {
        Some(ramp(f64::from((px - x) / 24.0)))
    });
}

fn cross(canvas: &mut Canvas, x: f32, y: f32) {
    let [r, g, b] = ramp(1.0).map(|c| c as u8);
    canvas.rectangle(Area::new(x, y - 8.0, 24.0, 16.0), [r, g, b, 255]);
    canvas.segment([x, y], [x + 24.0, y], 1.4, WHITE);
    canvas.segment([x + 12.0, y - 8.0], [x + 12.0, y + 8.0], 1.4, WHITE);
}
