//! The picture of a set of points for all pixels, beside one that is scrambled for each: how far each pixel is off, and how far what a
//! filter makes of it.

use host::draw::canvas::{Area, Canvas};
use host::draw::colour::{Colour, MUTED, POINT, faded};
use host::draw::text::{Align, Type};
use microwarp::uniform::{Points, Screen, Sobol};

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
