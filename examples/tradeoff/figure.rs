//! The figure: error against cost, a column for each target and a row for each family.

use crate::advice::traded;
use crate::panel;
use crate::study::{Study, TARGETS};
use host::draw::canvas::{Area, Canvas};
use host::draw::colour::{INK, MUTED, POINT, faded};
use host::draw::scale::Scale;
use host::draw::text::{Align, Type};
use host::registry::family::PICTURED;

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

pub fn draw(studies: &[Study]) -> Canvas {
    let shown = |family: &&&str| studies.iter().any(|s| s.sampler.family == **family);
    let families: Vec<&str> = PICTURED.iter().filter(shown).copied().collect();
    let height = TOP + families.len() as f32 * ROW + FOOT;
    let mut canvas = Canvas::new(WIDTH as u32, height as u32);
    let inner = WIDTH - 2.0 * MARGIN;
    canvas.text(
        "What accuracy costs",
        [MARGIN, 62.0],
        Align::Left,
        Type::bold(44.0),
        inner,
    );
    let text = "Largest error of a point against the cost of a sample, PCG32 included, on four targets. \
                Shaded: what this crate covers, by a point as cheap and as accurate.";
    canvas.text(
        text,
        [MARGIN, 104.0],
        Align::Left,
        Type::plain(25.0, MUTED),
        inner,
    );

    let wide = (inner - LEFT - GAP * (TARGETS.len() - 1) as f32) / TARGETS.len() as f32;
    for (column, title) in TARGETS.iter().enumerate() {
        let x = MARGIN + LEFT + column as f32 * (wide + GAP);
        let title = title.split(',').next().unwrap_or(title);
        canvas.text(title, [x, TOP - 16.0], Align::Left, Type::bold(26.0), wide);
        let scale = costs(studies, column);
        for (row, family) in families.iter().enumerate() {
            let area = Area::new(x, TOP + row as f32 * ROW, wide, ROW - GAP);
            panel::draw(
                &mut canvas,
                area,
                studies,
                family,
                column,
                scale,
                row + 1 == families.len(),
            );
        }
        let middle = [x + 0.5 * wide, TOP + families.len() as f32 * ROW + 42.0];
        canvas.text(
            UNITS[column],
            middle,
            Align::Middle,
            Type::plain(panel::LABEL, MUTED),
            wide,
        );
    }
    for (row, family) in families.iter().enumerate() {
        let y = TOP + row as f32 * ROW;
        let mut lines = family.splitn(2, ' ');
        for (line, dy) in lines.by_ref().zip([22.0, 48.0]) {
            canvas.text(
                line,
                [MARGIN, y + dy],
                Align::Left,
                Type::bold(20.0),
                LEFT - 62.0,
            );
        }
        for error in panel::errors().ticks(8.0) {
            let at = y + (ROW - GAP) * (1.0 - panel::errors().at(error) as f32);
            let anchor = [MARGIN + LEFT - 10.0, at + 7.0];
            canvas.text(
                &panel::errors().label(error),
                anchor,
                Align::Right,
                Type::plain(panel::LABEL, MUTED),
                LEFT,
            );
        }
    }
    legend(&mut canvas, height - 34.0);
    canvas
}

/// The costs of all families on a target.
fn costs(studies: &[Study], target: usize) -> Scale {
    let costs = PICTURED.iter().flat_map(|family| {
        let all = [true, false]
            .into_iter()
            .flat_map(|ours| traded(studies, family, target, ours));
        all.flat_map(|(study, trade)| [trade.cost, study.longest(target).unwrap_or(trade.cost)])
            .collect::<Vec<_>>()
    });
    let (from, to) = costs.fold((f64::INFINITY, 0.0_f64), |(from, to), cost| {
        (from.min(cost), to.max(cost))
    });
    let (from, to) = if from <= to {
        (from, to)
    } else {
        (10.0, 1000.0)
    };
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
