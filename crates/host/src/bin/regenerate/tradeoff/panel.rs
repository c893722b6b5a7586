//! A panel of the picture: one family on one target.

use super::labels::{self, Named};
use super::{Point, front};
use microwarp_host::draw::canvas::{Area, Canvas};
use microwarp_host::draw::colour::{ACCENT, Colour, HAIR, INK, MUTED, POINT, faded};
use microwarp_host::draw::scale::Scale;
use microwarp_host::draw::text::{Align, Type, thousands};

/// Text beside the axes.
pub const LABEL: f32 = 19.0;

/// All panels share the axis of errors. Those below it are drawn on the floor, so that those of `f32` stay apart.
pub const ERRORS: Scale = Scale {
    from: 1.5e-8,
    to: 2e-1,
    log: true,
};

/// Draws it; the last of a column has numbers below. Returns how many names lie badly, as [`labels::write`] does.
pub fn draw(
    canvas: &mut Canvas,
    area: Area,
    points: &[Point],
    costs: Scale,
    is_last: bool,
) -> [usize; 2] {
    let across = |cost: f64| area.x + area.w * costs.at(cost) as f32;
    let height = |error: f64| {
        let error = error.clamp(ERRORS.from, ERRORS.to);
        area.y + area.h * (1.0 - ERRORS.at(error) as f32)
    };
    let floor = area.y + area.h;
    let (ours, peers): (Vec<Point>, Vec<Point>) = points.iter().cloned().partition(|p| p.ours);
    let place = |point: &Point| [across(point.cost), height(point.error)];
    let front = front(&ours);
    let corners: Vec<_> = front.iter().map(|i| place(&ours[*i])).collect();
    let border = cover(canvas, area, &corners);
    for y in ERRORS.ticks(8.0).into_iter().map(height) {
        canvas.segment([area.x, y], [area.x + area.w, y], 1.0, faded(HAIR, 0.8));
    }
    for cost in ticks(costs) {
        let x = across(cost);
        canvas.segment([x, area.y], [x, floor], 1.0, faded(HAIR, 0.8));
        if is_last {
            let (text, style) = (thousands(cost.round() as usize), Type::plain(LABEL, MUTED));
            canvas.text(&text, [x, floor + 20.0], Align::Middle, style, 80.0);
        }
    }
    canvas.segment([area.x, floor], [area.x + area.w, floor], 1.3, INK);
    let mut named = Vec::new();
    let mut lines: Vec<_> = border.windows(2).map(|ends| [ends[0], ends[1]]).collect();
    let mut reach = |canvas: &mut Canvas, point: &Point, colour| {
        if let Some(longest) = point.longest {
            let (at, to) = (place(point), across(longest));
            lines.push([at, [to, at[1]]]);
            whisker(canvas, at, to, colour);
        }
    };
    for (i, point) in ours.iter().enumerate() {
        let leads = front.contains(&i);
        let is_first = ours.iter().position(|p| p.tier == point.tier) == Some(i);
        // What is neither on the front nor a tier's own sampler would only crowd the others out.
        let is_named =
            leads || is_first && !["coarse in f32", "compact in f32"].contains(&&*point.tier);
        let (radius, colour) = match (leads, is_named) {
            (true, _) => (6.0, POINT),
            (_, true) => (4.5, faded(POINT, 0.55)),
            _ => (2.5, faded(POINT, 0.4)),
        };
        canvas.disc(place(point), radius, colour);
        if is_named {
            reach(canvas, point, colour);
            let name = if is_first {
                String::new()
            } else {
                format!(", {}", point.name)
            };
            named.push(Named {
                at: place(point),
                text: format!("{}{name}", point.tier),
                colour: if leads { INK } else { MUTED },
            });
        }
    }
    for point in &peers {
        diamond(canvas, place(point), 7.5);
        reach(canvas, point, faded(ACCENT, 0.6));
        named.push(Named {
            at: place(point),
            text: point.tier.clone(),
            colour: ACCENT,
        });
    }
    labels::write(canvas, area.inside(2.0, 2.0, 2.0, 2.0), &named, &lines)
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
    let (mut border, mut above) = (Vec::new(), area.y);
    for (at, end) in front.iter().zip(ends) {
        let step = Area::new(at[0], area.y, end - at[0], at[1] - area.y);
        canvas.rectangle(step, faded(POINT, 0.09));
        border.extend([[at[0], above], *at, [end, at[1]]]);
        above = at[1];
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
