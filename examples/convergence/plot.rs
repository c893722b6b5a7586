//! One plot of the figure: its axes, the lines of errors, and the theory as dashed lines.

use crate::fit::{Line, Use};
use support::draw::canvas::{Area, Canvas};
use support::draw::colour::{Colour, HAIR, INK, MUTED, WHITE, faded};
use support::draw::scale::ten_to;
use support::draw::text::{Align, Type};

/// The size of the text.
pub const TEXT: f32 = 26.0;
/// Room for the labels of the vertical axis.
pub const LABELS: f32 = 78.0;

/// Of a plot, in powers of ten.
#[derive(Clone, Copy)]
struct Axes {
    x: [f32; 2],
    y: [f32; 2],
    /// Decades between the labels of the vertical axis.
    step: i32,
}

/// Each number of dimensions has its own scale. On a common one the lines of six dimensions would merge.
fn axes(dimension: u32) -> Axes {
    let (x, y, step) = match dimension {
        1 => ([0.0, 6.4], [-16.6, 0.6], 2),
        2 => ([0.0, 7.6], [-15.6, 0.6], 2),
        _ => ([0.0, 9.4], [-6.2, 0.8], 1),
    };
    Axes { x, y, step }
}

pub struct Scale {
    plot: Area,
    axes: Axes,
}

impl Scale {
    pub fn new(plot: Area, dimension: u32) -> Self {
        Self {
            plot,
            axes: axes(dimension),
        }
    }

    /// The pixel of a pair of logarithms.
    fn at(&self, x: f64, y: f64) -> [f32; 2] {
        let Axes {
            x: [x0, x1],
            y: [y0, y1],
            ..
        } = self.axes;
        [
            self.plot.x + self.plot.w * (x as f32 - x0) / (x1 - x0),
            self.plot.y + self.plot.h * (y1 - y as f32) / (y1 - y0),
        ]
    }

    pub fn grid(&self, canvas: &mut Canvas) {
        let (plot, style) = (self.plot, Type::plain(TEXT, INK));
        let (right, base) = (plot.x + plot.w, plot.y + plot.h);
        let Axes { x, y, step } = self.axes;
        for power in y[0].ceil() as i32..=y[1].floor() as i32 {
            let [_, at] = self.at(0.0, f64::from(power));
            let labelled = power % step == 0;
            if labelled {
                canvas.segment([plot.x, at], [right, at], 1.0, HAIR);
                let anchor = [plot.x - 14.0, at + 8.0];
                canvas.text(&ten_to(power), anchor, Align::Right, style, LABELS);
            }
            let tick = if labelled { 9.0 } else { 5.0 };
            canvas.segment([plot.x - tick, at], [plot.x, at], 1.5, INK);
        }
        for power in x[0].ceil() as i32..=x[1].floor() as i32 {
            let [at, _] = self.at(f64::from(power), 0.0);
            let labelled = power % 2 == 0;
            if labelled {
                canvas.segment([at, plot.y], [at, base], 1.0, HAIR);
                canvas.text(
                    &ten_to(power),
                    [at, base + 36.0],
                    Align::Middle,
                    style,
                    LABELS,
                );
            }
            let tick = if labelled { 9.0 } else { 5.0 };
            canvas.segment([at, base], [at, base + tick], 1.5, INK);
        }
        let frame = [[plot.x, plot.y], [plot.x, base], [right, base]];
        canvas.line(frame.map(Some), 1.5, INK);
        canvas.text(
            "evaluations of the integrand",
            [plot.x + 0.5 * plot.w, base + 70.0],
            Align::Middle,
            Type::plain(TEXT, MUTED),
            plot.w,
        );
    }

    /// The straight line of the theoretical slope through the middle of the points fitted, dashed, from
    /// edge to edge: what lies off it is before the asymptotics or on the floor.
    pub fn theory(&self, canvas: &mut Canvas, line: &Line) {
        let [x, y] = line.fit.through;
        let slope = line.theory().slope();
        let [low, high] = self.axes.y.map(f64::from);
        let ends = self.axes.x.map(f64::from);
        // Slopes are negative: the line enters at the top and leaves at the bottom.
        let from = (x + (high - y) / slope).max(ends[0]);
        let to = (x + (low - y) / slope).min(ends[1]);
        let pixel = |x_at: f64| self.at(x_at, y + slope * (x_at - x));
        let ([x0, y0], [x1, y1]) = (pixel(from), pixel(to));
        let (dash, gap) = (9.0, 7.0);
        let length = (x1 - x0).hypot(y1 - y0);
        let along = |t: f32| [x0 + (x1 - x0) * t / length, y0 + (y1 - y0) * t / length];
        let colour = faded(line.method.colour(), 0.6);
        for i in 0..(length / (dash + gap)).ceil() as u32 {
            let start = i as f32 * (dash + gap);
            canvas.segment(along(start), along((start + dash).min(length)), 1.8, colour);
        }
    }

    pub fn data(&self, canvas: &mut Canvas, line: &Line) {
        let colour = line.method.colour();
        let bottom = f64::from(self.axes.y[0]);
        // An error of 0, which rounding may give, has no place on the axis and lifts the pen.
        let pixels: Vec<Option<[f32; 2]>> = line
            .points
            .iter()
            .map(|point| {
                let [x, y] = [point.evaluations.log10(), point.error.log10()];
                (y >= bottom).then(|| self.at(x, y))
            })
            .collect();
        canvas.line(pixels.iter().copied(), 2.6, colour);
        for (pixel, point) in pixels.iter().zip(&line.points) {
            if let Some(pixel) = *pixel {
                dot(canvas, pixel, point.used, colour);
            }
        }
        self.name_floor(canvas, line);
    }

    /// Writes why a line stops falling above its last points, if there are at least three of them.
    fn name_floor(&self, canvas: &mut Canvas, line: &Line) {
        let Some(last) = line.points.last() else {
            return;
        };
        let lost = line.points.iter().filter(|p| p.used == Use::Floor).count();
        if lost < 3 {
            return;
        }
        let text = "rounding in f64";
        let [_, y] = self.at(0.0, last.error.log10());
        let anchor = [self.plot.x + self.plot.w, y - 20.0];
        let style = Type::plain(0.85 * TEXT, line.method.colour());
        canvas.text(text, anchor, Align::Right, style, self.plot.w);
    }
}

pub fn dot(canvas: &mut Canvas, at: [f32; 2], used: Use, colour: Colour) {
    if used == Use::Fitted {
        canvas.disc(at, 5.5, colour);
    } else {
        canvas.disc(at, 5.2, WHITE);
        canvas.ring(at, 4.4, 2.0, colour);
    }
}
