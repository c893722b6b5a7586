//! The figure: error against cost, a column for each target and a row for each family.

use crate::advice::traded;
use crate::canvas::{ACCENT, Area, Canvas, HAIR, INK, MUTED, POINT, faded};
use crate::front::{Trade, front};
use crate::labels::{self, Named};
use crate::list::PICTURED;
use crate::scale::Scale;
use crate::study::{Study, TARGETS};
use crate::text::{Align, Type};

const WIDTH: f32 = 2000.0;
const MARGIN: f32 = 36.0;
/// Room for the names of the families and the errors.
const LEFT: f32 = 120.0;
const TOP: f32 = 170.0;
const ROW: f32 = 262.0;
const GAP: f32 = 16.0;
const FOOT: f32 = 126.0;
const LABEL: f32 = 19.0;

/// Errors below are drawn on the floor, so that those of `f32` stay apart.
const FLOOR: f64 = 1.5e-8;
const CEILING: f64 = 2e-1;

/// What is measured along the costs of each target.
const UNITS: [&str; TARGETS.len()] = [
    "nanoseconds a sample, drawn one by one",
    "instructions a sample",
    "instructions a sample",
    "instructions a sample",
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
            panel(
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
            Type::plain(LABEL, MUTED),
            wide,
        );
    }
    for (row, family) in families.iter().enumerate() {
        let y = TOP + row as f32 * ROW;
        let mut lines = family.splitn(2, ' ');
        for (line, dy) in lines.by_ref().zip([22.0, 48.0]) {
            canvas.text(line, [MARGIN, y + dy], Align::Left, Type::bold(23.0), LEFT);
        }
        for error in errors().ticks(4.0) {
            let at = y + (ROW - GAP) * (1.0 - errors().at(error) as f32);
            let anchor = [MARGIN + LEFT - 10.0, at + 7.0];
            canvas.text(
                &errors().label(error),
                anchor,
                Align::Right,
                Type::plain(LABEL, MUTED),
                LEFT,
            );
        }
    }
    legend(&mut canvas, height - 34.0);
    canvas
}

fn errors() -> Scale {
    Scale {
        from: FLOOR,
        to: CEILING,
        log: true,
    }
}

/// The costs of all families on a target.
fn costs(studies: &[Study], target: usize) -> Scale {
    let costs = PICTURED.iter().flat_map(|family| {
        let all = [true, false]
            .into_iter()
            .flat_map(|ours| traded(studies, family, target, ours));
        all.map(|(_, trade)| trade.cost).collect::<Vec<_>>()
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

fn panel(
    canvas: &mut Canvas,
    area: Area,
    studies: &[Study],
    family: &str,
    target: usize,
    costs: Scale,
    is_last: bool,
) {
    let place = |trade: &Trade| {
        let error = trade.error.clamp(FLOOR, CEILING);
        [
            area.x + area.w * costs.at(trade.cost) as f32,
            area.y + area.h * (1.0 - errors().at(error) as f32),
        ]
    };
    let floor = area.y + area.h;
    let ours = traded(studies, family, target, true);
    let trades: Vec<Trade> = ours.iter().map(|(_, trade)| *trade).collect();
    let front = front(&trades);
    cover(
        canvas,
        area,
        &front.iter().map(|i| place(&trades[*i])).collect::<Vec<_>>(),
    );
    for error in errors().ticks(4.0) {
        let y = area.y + area.h * (1.0 - errors().at(error) as f32);
        canvas.segment([area.x, y], [area.x + area.w, y], 1.0, faded(HAIR, 0.8));
    }
    for cost in costs.ticks(6.0) {
        let x = area.x + area.w * costs.at(cost) as f32;
        canvas.segment([x, area.y], [x, floor], 1.0, faded(HAIR, 0.8));
        if is_last {
            let anchor = [x, floor + 20.0];
            canvas.text(
                &costs.label(cost),
                anchor,
                Align::Middle,
                Type::plain(LABEL, MUTED),
                80.0,
            );
        }
    }
    canvas.segment([area.x, floor], [area.x + area.w, floor], 1.3, INK);
    let peers = traded(studies, family, target, false);
    if ours.is_empty() && peers.is_empty() {
        let middle = [area.x + 0.5 * area.w, area.y + 0.5 * area.h];
        canvas.text(
            "not measured",
            middle,
            Align::Middle,
            Type::plain(LABEL, MUTED),
            area.w,
        );
        return;
    }
    let mut named = Vec::new();
    for (i, (study, trade)) in ours.iter().enumerate() {
        let at = place(trade);
        let colour = if front.contains(&i) {
            POINT
        } else {
            faded(POINT, 0.55)
        };
        canvas.disc(at, if front.contains(&i) { 6.0 } else { 4.5 }, colour);
        let first = ours
            .iter()
            .position(|(s, _)| s.sampler.tier == study.sampler.tier)
            == Some(i);
        named.push(Named {
            at,
            text: name(study, first),
            colour: if front.contains(&i) { INK } else { MUTED },
        });
    }
    for (study, trade) in &peers {
        let at = place(trade);
        diamond(canvas, at, 7.5);
        named.push(Named {
            at,
            text: study.sampler.tier.into(),
            colour: ACCENT,
        });
    }
    labels::write(canvas, area.inside(2.0, 2.0, 2.0, 2.0), &named);
}

/// What a point is called: by its tier, the further ones of a tier by themselves.
fn name(study: &Study, is_first: bool) -> String {
    let sampler = &study.sampler;
    match sampler.name.split(' ').next() {
        Some(name) if sampler.tier == "rejection" => name.to_owned(),
        Some(name) if !is_first => format!("{}, {name}", sampler.tier),
        _ => sampler.tier.to_owned(),
    }
}

/// Shades what the points of a front cover, and draws its border.
fn cover(canvas: &mut Canvas, area: Area, front: &[[f32; 2]]) {
    let right = area.x + area.w;
    let ends = front.iter().skip(1).map(|at| at[0]).chain([right]);
    let mut border = Vec::new();
    for (k, (at, end)) in front.iter().zip(ends).enumerate() {
        let step = Area::new(at[0], area.y, end - at[0], at[1] - area.y);
        canvas.rectangle(step, faded(POINT, 0.09));
        let above = if k == 0 { area.y } else { front[k - 1][1] };
        border.extend([Some([at[0], above]), Some(*at), Some([end, at[1]])]);
    }
    canvas.line(border, 1.8, faded(POINT, 0.7));
}

fn diamond(canvas: &mut Canvas, [x, y]: [f32; 2], r: f32) {
    let corners = [
        [x, y - r],
        [x + r, y],
        [x, y + r],
        [x - r, y],
        [x, y - r],
        [x + r, y],
    ];
    canvas.line(corners.map(Some), 2.4, ACCENT);
}

fn legend(canvas: &mut Canvas, base: f32) {
    let style = Type::plain(23.0, INK);
    let mut x = MARGIN;
    let y = base - 8.0;
    for (mark, text) in [
        "on the front of this crate",
        "this crate, covered by its front",
        "somebody else's",
        "errors below 1.5e-8, at the floor; two normals: one at a time is drawn twice",
    ]
    .iter()
    .enumerate()
    {
        match mark {
            0 => canvas.disc([x + 10.0, y], 6.0, POINT),
            1 => canvas.disc([x + 10.0, y], 4.5, faded(POINT, 0.55)),
            2 => diamond(canvas, [x + 10.0, y], 7.5),
            _ => canvas.segment([x, y], [x + 20.0, y], 1.3, INK),
        }
        x += 30.0;
        canvas.text(text, [x, base], Align::Left, style, 1000.0);
        x += canvas.width(text, style) + 40.0;
    }
}
