//! The picture: error against cost, a column for each target and a row for each family.

use super::panel::{self, ERRORS, LABEL};
use super::{Panels, TARGETS};
use microwarp_host::draw::canvas::{Area, Canvas};
use microwarp_host::draw::colour::{INK, MUTED, POINT, faded};
use microwarp_host::draw::scale::Scale;
use microwarp_host::draw::text::{Align, Type};
use microwarp_host::upkeep::Outcome;

const WIDTH: f32 = 2040.0;
const MARGIN: f32 = 36.0;
/// Room for the names of the families and the errors.
const LEFT: f32 = 176.0;
const TOP: f32 = 170.0;
const ROW: f32 = 300.0;
const GAP: f32 = 16.0;
const FOOT: f32 = 126.0;

/// What is measured along the costs of each target.
const UNITS: [&str; TARGETS.len()] = [
    "nanoseconds a sample, drawn one by one",
    "cycles a sample, to the longest",
    "cycles a sample, to the longest",
    "executed operators a sample",
];

const BELOW_THE_TITLE: &str = "Largest error of a point against the cost of a sample, PCG32 included, on four targets. \
    Shaded: what this crate covers, by a point as cheap and as accurate.";

/// Draws it. Names lie neither on each other nor outside of their panels, which they would if each had its first place.
pub fn draw(panels: &Panels) -> Outcome<Canvas> {
    let height = TOP + panels.len() as f32 * ROW + FOOT;
    let mut canvas = Canvas::new(WIDTH as u32, height as u32);
    let inner = WIDTH - 2.0 * MARGIN;
    let mut left = |text: &str, at, style, fit| canvas.text(text, at, Align::Left, style, fit);
    left(
        "What accuracy costs",
        [MARGIN, 62.0],
        Type::bold(44.0),
        inner,
    );
    left(
        BELOW_THE_TITLE,
        [MARGIN, 104.0],
        Type::plain(25.0, MUTED),
        inner,
    );

    let wide = (inner - LEFT - GAP * (TARGETS.len() - 1) as f32) / TARGETS.len() as f32;
    let small = Type::plain(LABEL, MUTED);
    let mut faults = [0, 0];
    for (column, (title, _)) in TARGETS.iter().enumerate() {
        let x = MARGIN + LEFT + column as f32 * (wide + GAP);
        canvas.text(title, [x, TOP - 16.0], Align::Left, Type::bold(26.0), wide);
        let scale = costs(panels, column);
        for (row, (_, columns)) in panels.iter().enumerate() {
            let area = Area::new(x, TOP + row as f32 * ROW, wide, ROW - GAP);
            let is_last = row + 1 == panels.len();
            let of_panel = panel::draw(&mut canvas, area, &columns[column], scale, is_last);
            faults = [faults[0] + of_panel[0], faults[1] + of_panel[1]];
        }
        let middle = [x + 0.5 * wide, TOP + panels.len() as f32 * ROW + 42.0];
        canvas.text(UNITS[column], middle, Align::Middle, small, wide);
    }
    for (row, (family, _)) in panels.iter().enumerate() {
        let y = TOP + row as f32 * ROW;
        for (line, dy) in family.splitn(2, ' ').zip([22.0, 48.0]) {
            let style = Type::bold(20.0);
            canvas.text(line, [MARGIN, y + dy], Align::Left, style, LEFT - 62.0);
        }
        for error in ERRORS.ticks(8.0) {
            let at = y + (ROW - GAP) * (1.0 - ERRORS.at(error) as f32);
            let anchor = [MARGIN + LEFT - 10.0, at + 7.0];
            canvas.text(&ERRORS.label(error), anchor, Align::Right, small, LEFT);
        }
    }
    legend(&mut canvas, height - 34.0);
    let [placed, first] = faults;
    if placed == 0 && first > 0 {
        Ok(canvas)
    } else {
        Err(format!(
            "{placed} names lie badly, and {first} at their first places"
        ))
    }
}

/// The costs of all families on a target.
fn costs(panels: &Panels, target: usize) -> Scale {
    let points = panels.iter().flat_map(|(_, columns)| &columns[target]);
    let all = points.flat_map(|point| [point.cost, point.longest.unwrap_or(point.cost)]);
    let (from, to) = all.fold((f64::INFINITY, 0.0_f64), |(from, to), cost| {
        (from.min(cost), to.max(cost))
    });
    Scale {
        from: from / 1.35,
        to: to * 1.6,
        log: true,
    }
}

fn legend(canvas: &mut Canvas, base: f32) {
    let style = Type::plain(23.0, INK);
    let mut x = MARGIN;
    let y = base - 8.0;
    let marks = [
        "this crate, on its front",
        "covered by it",
        "second of a tier",
        "somebody else's",
        "to the longest call",
        "errors below 1.5e-8 stand there; what gives one normal is drawn twice",
    ];
    for (mark, text) in marks.iter().enumerate() {
        match mark {
            0 => canvas.disc([x + 10.0, y], 6.0, POINT),
            1 => canvas.disc([x + 10.0, y], 4.5, faded(POINT, 0.55)),
            2 => canvas.disc([x + 10.0, y], 2.5, faded(POINT, 0.4)),
            3 => panel::diamond(canvas, [x + 10.0, y], 7.5),
            4 => panel::whisker(canvas, [x, y], x + 20.0, POINT),
            _ => canvas.segment([x, y + 6.0], [x + 20.0, y + 6.0], 1.3, INK),
        }
        x += 30.0;
        canvas.text(text, [x, base], Align::Left, style, 1000.0);
        x += canvas.width(text, style) + 38.0;
    }
}
