//! The figure: the picture and its copies, the two recordings one above the other, and their errors.

use crate::copy::{Recording, Snapshot, errors};
use crate::scene::SHAPE;
use crate::study::{DRAWN, Study};
use support::draw::canvas::{Area, Canvas};
use support::draw::colour::{ACCENT, Colour, INK, MUTED, POINT};
use support::draw::panel::cells;
use support::draw::plot::Plot;
use support::draw::scale::Scale;
use support::draw::text::{Align, Type, signed, thousands};
use support::draw::tone::tone;

/// Pixels per texel: a whole number, so that texels stay sharp.
const SCALE: usize = 2;
const MARGIN: f32 = 40.0;
const GAP: f32 = 28.0;
const TOP: f32 = 148.0;
const HEAD: f32 = 54.0;
const FOOT: f32 = 62.0;
const TEXT: f32 = 31.0;

/// Both recordings in the order of the rows, with their colours in the plot.
const ROWS: [(Recording, Colour); 2] = [(Recording::Plain, POINT), (Recording::Weighted, ACCENT)];

pub fn draw(study: &Study, texels: &[[f32; 3]]) -> Canvas {
    let [w, h] = SHAPE.map(|n| (n * SCALE) as f32);
    let width = 2.0 * MARGIN + 4.0 * w + 3.0 * GAP;
    let row = HEAD + h + FOOT;
    let height = TOP + 2.0 * row + 6.0;
    let mut canvas = Canvas::new(width as u32, height as u32);
    let inner = width - 2.0 * MARGIN;
    let title = Type::bold(52.0);
    let text = "A picture copied by a chain over its pixels";
    canvas.text(text, [MARGIN, 70.0], Align::Left, title, inner);
    let text = "The density is the brightness, the mutation is any pixel. Above, each step records its state; below, \
                at the same cost, both its states, weights 1 − a and a.";
    let style = Type::plain(TEXT, MUTED);
    canvas.text(text, [MARGIN, 120.0], Align::Left, style, inner);

    let place = |column: usize, line: usize| {
        let x = MARGIN + column as f32 * (w + GAP);
        Area::new(x, TOP + line as f32 * row, w, row)
    };
    let original = place(0, 0);
    head(&mut canvas, original, "the picture");
    let inside = original.inside(0.0, HEAD, 0.0, FOOT);
    cells(&mut canvas, inside, SHAPE, |i| {
        tone(texels[i].map(f64::from))
    });
    let brightest = study.exact.iter().copied().fold(0.0, f64::max) * study.exact.len() as f64;
    let text = format!(
        "{} × {}, brightest {brightest:.0} times the mean",
        SHAPE[0], SHAPE[1]
    );
    foot(&mut canvas, original, &text);
    plot(&mut canvas, place(0, 1), study);

    for (line, (recording, _)) in ROWS.into_iter().enumerate() {
        for (column, (count, snapshot)) in DRAWN.iter().zip(&study.drawn).enumerate() {
            let area = place(column + 1, line);
            let many = if *count == 1 { "mutation" } else { "mutations" };
            head(
                &mut canvas,
                area,
                &format!("{count} {many} a pixel, {}", recording.name()),
            );
            copy(&mut canvas, area, study, texels, snapshot, recording);
        }
    }
    canvas
}

fn head(canvas: &mut Canvas, area: Area, text: &str) {
    let at = [area.x, area.y + HEAD - 16.0];
    canvas.text(text, at, Align::Left, Type::bold(32.0), area.w);
}

fn foot(canvas: &mut Canvas, area: Area, text: &str) {
    let at = [area.x, area.y + area.h - FOOT + 38.0];
    canvas.text(text, at, Align::Left, Type::plain(TEXT, INK), area.w);
}

/// A copy: each pixel keeps its colour, and its brightness is how often it was recorded.
fn copy(
    canvas: &mut Canvas,
    area: Area,
    study: &Study,
    texels: &[[f32; 3]],
    snapshot: &Snapshot,
    recording: Recording,
) {
    let shares = &snapshot.shares[recording as usize];
    let inside = area.inside(0.0, HEAD, 0.0, FOOT);
    cells(canvas, inside, SHAPE, |i| {
        let exact = study.exact[i];
        let gain = if exact > 0.0 { shares[i] / exact } else { 0.0 };
        tone(texels[i].map(|c| gain * f64::from(c)))
    });
    let off = errors(shares, &study.exact);
    let text = format!("RMSE {:.3} of the mean · TV {:.3}", off.rmse, off.variation);
    foot(canvas, area, &text);
}

/// Errors against mutations a pixel, over the lines of theory.
fn plot(canvas: &mut Canvas, area: Area, study: &Study) {
    let counts = [study.counts[0], study.counts[study.counts.len() - 1]].map(|n| n as f64);
    let all = |recording| (0..study.counts.len()).map(move |k| study.rmse(k, recording));
    let (high, low) = (
        all(Recording::Plain).fold(0.0, f64::max),
        all(Recording::Weighted).fold(f64::INFINITY, f64::min),
    );
    let log = |from, to| Scale {
        from,
        to,
        log: true,
    };
    let title = format!("RMSE of {} copies", thousands(study.repetitions()));
    let place = area.inside(-18.0, 5.0, 0.0, 0.0);
    let names = [title.as_str(), "mutations a pixel"];
    let x = log(0.8 * counts[0], 1.25 * counts[1]);
    let plot = Plot::sized(canvas, place, 28.0, names, x, log(0.6 * low, 1.6 * high));
    for (recording, colour) in ROWS {
        let right = usize::from(recording == Recording::Weighted);
        let theory = |n: f64| [n, study.theory.error[right] / n.sqrt()];
        plot.curve(canvas, counts.map(theory), 2.6, colour);
        for (count, error) in study.counts.iter().zip(all(recording)) {
            canvas.disc(plot.place([*count as f64, error]), 6.5, colour);
        }
    }
    // Errors fall from the upper left to the lower right; names go into the free corners.
    let inside = plot.inside();
    let mut base = inside.y + inside.h - 88.0;
    for (recording, colour) in ROWS {
        let slope = signed(study.slope(recording).mean, 3);
        let at = [inside.x + 14.0, base];
        let text = format!("{}: slope {slope}", recording.name());
        canvas.text(&text, at, Align::Left, Type::plain(28.0, colour), inside.w);
        base += 36.0;
    }
    let (at, style) = ([inside.x + 14.0, base], Type::plain(28.0, MUTED));
    canvas.text("lines: theory", at, Align::Left, style, inside.w);
    let wrong = Recording::AcceptedOnly;
    let points = study.counts.iter().zip(all(wrong));
    let pixels: Vec<_> = points
        .map(|(count, error)| plot.place([*count as f64, error]))
        .collect();
    canvas.line(pixels.iter().copied().map(Some), 2.0, MUTED);
    if let Some([x, y]) = pixels.last() {
        canvas.text(wrong.name(), [*x, y - 36.0], Align::Right, style, inside.w);
    }
}
