//! The pictures of jittered strata and of points beside plain uniforms, in one and two dimensions.

use host::draw::canvas::{Area, Canvas};
use host::draw::colour::{Colour, MUTED, POINT, WHITE, faded, ramp};
use host::draw::text::{Align, Type};
use host::registry::picture::View;
use microwarp::uniform::{self, ByPosition, Points, Recurrence, Screen, Sobol, Strata1d, Strata2d};
use rand_pcg::Pcg32;

/// Strata along an axis.
const LINE: u32 = 24;
const PLANE: [u32; 2] = [10, 16];
/// Boxes along the axes of a picture of points.
const SQUARE: [u32; 2] = [16, 16];
/// Sets of points on the line, one above the other.
const ROWS: u32 = 7;

/// What leaves room for points on the border.
fn within(area: Area, unit: f32) -> Area {
    area.inside(2.5 * unit, 0.0, 2.5 * unit, 2.5 * unit)
}

fn background(canvas: &mut Canvas, area: Area) {
    let [r, g, b] = ramp(0.6).map(|c| c as u8);
    canvas.rectangle(area, faded(POINT, 0.35));
    canvas.rectangle(area.inside(0.7, 0.7, 0.7, 0.7), [r, g, b, 255]);
}

/// Draws sets of plain uniforms above and of jittered ones below.
pub fn line(canvas: &mut Canvas, area: Area, rng: &mut Pcg32, unit: f32) {
    let strata = Strata1d::new(LINE).expect("a number of strata");
    let title = 20.0 * unit;
    let area = within(area, unit);
    let half = Area {
        h: 0.5 * area.h - 2.0 * unit,
        ..area
    };
    let below = Area {
        y: area.y + 0.5 * area.h + 2.0 * unit,
        ..half
    };
    for (half, jittered) in [(half, false), (below, true)] {
        let name = if jittered { "jittered" } else { "plain" };
        let at = [half.x, half.y + 0.75 * title];
        canvas.text(
            name,
            at,
            Align::Left,
            Type::plain(14.5 * unit, MUTED),
            half.w,
        );
        let half = half.inside(0.0, title, 0.0, 4.0 * unit);
        background(canvas, half);
        for i in 1..LINE {
            let x = half.x + half.w * i as f32 / LINE as f32;
            canvas.segment(
                [x, half.y],
                [x, half.y + half.h],
                0.8 * unit,
                faded(WHITE, 0.9),
            );
        }
        let pitch = half.h / ROWS as f32;
        for row in 0..ROWS {
            let middle = half.y + (row as f32 + 0.5) * pitch;
            for i in 0..LINE {
                let u = if jittered {
                    strata.draw(i, rng)
                } else {
                    uniform::grid(rng)
                };
                canvas.disc(
                    [half.x + half.w * u, middle],
                    2.0 * unit,
                    faded(POINT, 0.85),
                );
            }
        }
    }
}

/// Draws plain uniforms on the left and jittered ones, or points, on the right, in boxes where each has one of those.
pub fn plane(canvas: &mut Canvas, area: Area, rng: &mut Pcg32, unit: f32, view: View) {
    let [columns, rows] = if view == View::Strata2d {
        PLANE
    } else {
        SQUARE
    };
    let strata = Strata2d::new(columns, rows).expect("a number of strata");
    let sobol = Sobol::<2>::new(7).expect("two dimensions");
    let recurrence = Recurrence::<2>::new(7).expect("two dimensions");
    let boxes = matches!(view, View::Strata2d | View::Sobol);
    let (title, gap) = (20.0 * unit, 14.0 * unit);
    let area = within(area, unit);
    // Square strata.
    let side = ((area.h - title) / rows as f32).min(0.5 * (area.w - gap) / columns as f32);
    let (w, h) = (side * columns as f32, side * rows as f32);
    let left = area.x + 0.5 * (area.w - gap) - w;
    for (x, chosen) in [(left, false), (left + w + gap, true)] {
        let name = match view {
            _ if !chosen => "plain",
            View::Sobol => "scrambled Sobol'",
            View::Recurrence => "additive recurrence",
            View::ByPosition => "by position",
            _ => "jittered",
        };
        canvas.text(
            name,
            [x, area.y + 0.75 * title],
            Align::Left,
            Type::plain(14.5 * unit, MUTED),
            w,
        );
        let place = Area::new(x, area.y + title, w, h);
        background(canvas, place);
        let white = faded(WHITE, 0.9);
        for i in (1..columns).filter(|_| boxes) {
            let x = x + side * i as f32;
            canvas.segment([x, place.y], [x, place.y + h], 0.8 * unit, white);
        }
        for j in (1..rows).filter(|_| boxes) {
            let y = place.y + side * j as f32;
            canvas.segment([x, y], [x + w, y], 0.8 * unit, white);
        }
        for k in 0..strata.count() {
            let [u, v] = match view {
                _ if !chosen => [uniform::grid(rng), uniform::grid(rng)],
                View::Sobol => sobol.point(k),
                View::Recurrence => recurrence.point(k),
                View::ByPosition => ByPosition::new(7, 1).point(k),
                _ => strata.draw(k, rng),
            };
            canvas.disc(
                [x + w * u, place.y + h * (1.0 - v)],
                1.7 * unit,
                faded(POINT, 0.85),
            );
        }
    }
}

// The picture of a set of points for all pixels, beside one that is scrambled for each: how far each pixel is off, and how far what a
// filter makes of it.

/// Pixels along a side.
const SIDE: u32 = 32;
/// The error from which on a pixel is as dark, or as light, as can be.
const LARGEST: f64 = 1.5;

const PALE: Colour = [236, 243, 250, 255];

/// How far each pixel is off, of e^(x + y) over the unit square by one sample: by a set of its own, or by one for all.
pub fn errors(of_all: bool) -> Vec<f64> {
    let set = Sobol::<8>::new(7).expect("eight dimensions");
    let screen = Screen::new(set, [SIDE; 2], 0, 7).expect("a small picture");
    let exact = 1.0_f64.exp_m1().powi(2);
    let pixels = (0..SIDE * SIDE).map(|k| {
        let [x, y] = [k % SIDE, k / SIDE];
        let [u, v] = if of_all {
            screen.pixel(x, y).point(0)
        } else {
            Sobol::<2>::new(k).expect("two dimensions").point(0)
        };
        (f64::from(u) + f64::from(v)).exp() - exact
    });
    pixels.collect()
}

/// Means over 3 × 3 pixels, of those that there are.
pub fn filtered(errors: &[f64]) -> Vec<f64> {
    let near = |at: u32| at.saturating_sub(1)..=(at + 1).min(SIDE - 1);
    let mean = |k: u32| {
        let rows = near(k / SIDE).flat_map(|y| near(k % SIDE).map(move |x| y * SIDE + x));
        let (sum, count) = rows.fold((0.0, 0.0), |(sum, count), k| {
            (sum + errors[k as usize], count + 1.0)
        });
        sum / count
    };
    (0..SIDE * SIDE).map(mean).collect()
}

/// Draws both side by side: above as they are, below as they are filtered, three times as strong.
pub fn draw(canvas: &mut Canvas, area: Area, unit: f32) {
    let (title, gap) = (20.0 * unit, 8.0 * unit);
    let room = (0.5 * (area.h - title - gap)).min(0.5 * (area.w - gap));
    // Whole dots of the paper, so that nothing shows between the cells.
    let cell = (room / SIDE as f32).floor();
    let side = cell * SIDE as f32;
    let left = (area.x + 0.5 * (area.w - gap) - side).floor();
    for (x, of_all) in [(left, false), (left + side + gap, true)] {
        let name = if of_all {
            "one set for all"
        } else {
            "a set for each"
        };
        let style = Type::plain(14.5 * unit, MUTED);
        canvas.text(name, [x, area.y + 0.75 * title], Align::Left, style, side);
        let raw = errors(of_all);
        let smooth: Vec<f64> = filtered(&raw).iter().map(|error| 3.0 * error).collect();
        for (row, errors) in [raw, smooth].iter().enumerate() {
            let y = (area.y + title + row as f32 * (side + gap)).floor();
            for (k, error) in (0..).zip(errors) {
                let [i, j] = [k % SIDE, k / SIDE].map(|i| i as f32 * cell);
                let dark = (0.5 + 0.5 * error / LARGEST).clamp(0.0, 1.0);
                let place = Area::new(x + i, y + j, cell, cell);
                canvas.rectangle(place, PALE);
                canvas.rectangle(place, faded(POINT, dark as f32));
            }
        }
    }
}
