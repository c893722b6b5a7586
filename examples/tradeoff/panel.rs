//! A panel of the figure: one family on one target.

use crate::advice::traded;
use crate::front::{Trade, front};
use crate::labels::{self, Named};
use crate::study::Study;
use host::draw::canvas::{Area, Canvas};
use host::draw::colour::{ACCENT, Colour, HAIR, INK, MUTED, POINT, faded};
use host::draw::scale::Scale;
use host::draw::text::{Align, Type, thousands};

/// Text beside the axes.
pub const LABEL: f32 = 19.0;

/// Errors below are drawn on the floor, so that those of `f32` stay apart.
const FLOOR: f64 = 1.5e-8;
const CEILING: f64 = 2e-1;

/// All panels share the axis of errors.
pub fn errors() -> Scale {
    Scale {
        from: FLOOR,
        to: CEILING,
        log: true,
    }
}

/// Draws it; the last of a column has numbers below.
pub fn draw(
    canvas: &mut Canvas,
    area: Area,
    studies: &[Study],
    family: &str,
    target: usize,
    costs: Scale,
    is_last: bool,
) {
    let across = |cost: f64| area.x + area.w * costs.at(cost) as f32;
    let place = |trade: &Trade| {
        let error = trade.error.clamp(FLOOR, CEILING);
        [
            across(trade.cost),
            area.y + area.h * (1.0 - errors().at(error) as f32),
        ]
    };
    let floor = area.y + area.h;
    let ours = traded(studies, family, target, true);
    let trades: Vec<Trade> = ours.iter().map(|(_, trade)| *trade).collect();
    let front = front(&trades);
    let border = cover(
        canvas,
        area,
        &front.iter().map(|i| place(&trades[*i])).collect::<Vec<_>>(),
    );
    for error in errors().ticks(8.0) {
        let y = area.y + area.h * (1.0 - errors().at(error) as f32);
        canvas.segment([area.x, y], [area.x + area.w, y], 1.0, faded(HAIR, 0.8));
    }
    for cost in ticks(costs) {
        let x = area.x + area.w * costs.at(cost) as f32;
        canvas.segment([x, area.y], [x, floor], 1.0, faded(HAIR, 0.8));
        if is_last {
            let anchor = [x, floor + 20.0];
            canvas.text(
                &thousands(cost.round() as usize),
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
    let mut lines: Vec<_> = border.windows(2).map(|ends| [ends[0], ends[1]]).collect();
    for (i, (study, trade)) in ours.iter().enumerate() {
        let (at, leads) = (place(trade), front.contains(&i));
        let sampler = &study.sampler;
        let is_first = ours
            .iter()
            .position(|(s, _)| s.sampler.tier == sampler.tier)
            == Some(i);
        // What is neither on the front nor a tier's own sampler would only crowd the others out.
        let is_named =
            leads || is_first && !["coarse, f32", "compact, f32"].contains(&sampler.tier);
        let (radius, colour) = match (leads, is_named) {
            (true, _) => (6.0, POINT),
            (_, true) => (4.5, faded(POINT, 0.55)),
            _ => (2.5, faded(POINT, 0.4)),
        };
        canvas.disc(at, radius, colour);
        if let (Some(longest), true) = (study.longest(target), is_named) {
            lines.push([at, [across(longest), at[1]]]);
            whisker(canvas, at, across(longest), colour);
        }
        if is_named {
            let first_word = sampler.name.split(' ').next().unwrap_or("");
            let name = if is_first { "" } else { first_word };
            let comma = if is_first { "" } else { ", " };
            named.push(Named {
                at,
                text: format!("{}{comma}{name}", sampler.tier),
                colour: if leads { INK } else { MUTED },
            });
        }
    }
    for (study, trade) in &peers {
        let at = place(trade);
        diamond(canvas, at, 7.5);
        if let Some(longest) = study.longest(target) {
            lines.push([at, [across(longest), at[1]]]);
            whisker(canvas, at, across(longest), faded(ACCENT, 0.6));
        }
        named.push(Named {
            at,
            text: study.sampler.tier.into(),
            colour: ACCENT,
        });
    }
    labels::write(canvas, area.inside(2.0, 2.0, 2.0, 2.0), &named, &lines);
}

/// Round numbers along the costs: 1, 2 and 5 where there is room for them.
fn ticks(costs: Scale) -> Vec<f64> {
    let decades = (costs.to / costs.from).log10();
    let steps: &[f64] = if decades < 2.2 {
        &[1.0, 2.0, 5.0]
    } else {
        &[1.0]
    };
    let powers = costs.from.log10().floor() as i32..=costs.to.log10().ceil() as i32;
    let all = powers.flat_map(|power| steps.iter().map(move |step| step * 10f64.powi(power)));
    all.filter(|cost| (costs.from..=costs.to).contains(cost))
        .collect()
}

/// Shades what the points of a front cover, and draws its border.
fn cover(canvas: &mut Canvas, area: Area, front: &[[f32; 2]]) -> Vec<[f32; 2]> {
    let right = area.x + area.w;
    let ends = front.iter().skip(1).map(|at| at[0]).chain([right]);
    let mut border = Vec::new();
    for (k, (at, end)) in front.iter().zip(ends).enumerate() {
        let step = Area::new(at[0], area.y, end - at[0], at[1] - area.y);
        canvas.rectangle(step, faded(POINT, 0.09));
        let above = if k == 0 { area.y } else { front[k - 1][1] };
        border.extend([[at[0], above], *at, [end, at[1]]]);
    }
    canvas.line(border.iter().copied().map(Some), 1.8, faded(POINT, 0.7));
    border
}

/// From a mean to the longest.
pub fn whisker(canvas: &mut Canvas, [x, y]: [f32; 2], to: f32, colour: Colour) {
    canvas.segment([x, y], [to, y], 1.4, colour);
    canvas.segment([to, y - 4.0], [to, y + 4.0], 1.4, colour);
}

pub fn diamond(canvas: &mut Canvas, [x, y]: [f32; 2], r: f32) {
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
