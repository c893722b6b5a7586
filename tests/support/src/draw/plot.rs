//! A plot: a frame with a title and two axes, and places inside it.

use super::canvas::{Area, Canvas};
use super::colour::{HAIR, INK, MUTED, faded};
use super::scale::Scale;
use super::text::{Align, Type};

pub struct Plot {
    inside: Area,
    x: Scale,
    y: Scale,
}

/// Text beside an axis, unless said otherwise.
const LABEL: f32 = 17.0;

impl Plot {
    /// Draws the frame in `area`.
    pub fn new(
        canvas: &mut Canvas,
        area: Area,
        title: &str,
        x_name: &str,
        x: Scale,
        y: Scale,
    ) -> Self {
        Self::sized(canvas, area, LABEL, [title, x_name], x, y)
    }

    /// The same with text beside the axes of another size, to which all else keeps its proportion.
    pub fn sized(
        canvas: &mut Canvas,
        area: Area,
        size: f32,
        [title, x_name]: [&str; 2],
        x: Scale,
        y: Scale,
    ) -> Self {
        let of = |length: f32| length * (size / LABEL);
        let inside = area.inside(of(62.0), of(34.0), of(14.0), of(58.0));
        let this = Self { inside, x, y };
        let label = Type::plain(size, MUTED);
        let heading = Type::bold(of(21.0));
        canvas.text(
            title,
            [inside.x, area.y + of(20.0)],
            Align::Left,
            heading,
            inside.w,
        );
        let floor = inside.y + inside.h;
        for value in y.ticks(3.5) {
            let [_, at] = this.place([x.from, value]);
            canvas.segment(
                [inside.x, at],
                [inside.x + inside.w, at],
                1.0,
                faded(HAIR, 0.8),
            );
            let anchor = [inside.x - of(8.0), at + of(6.0)];
            canvas.text(&y.label(value), anchor, Align::Right, label, of(54.0));
        }
        canvas.segment([inside.x, floor], [inside.x + inside.w, floor], 1.3, INK);
        for value in x.ticks(8.0) {
            let [at, _] = this.place([value, y.from]);
            canvas.segment([at, floor], [at, floor + of(5.0)], 1.3, INK);
            canvas.text(
                &x.label(value),
                [at, floor + of(24.0)],
                Align::Middle,
                label,
                of(60.0),
            );
        }
        let middle = inside.x + 0.5 * inside.w;
        canvas.text(
            x_name,
            [middle, floor + of(47.0)],
            Align::Middle,
            label,
            inside.w,
        );
        this
    }

    /// The pixel of a place, kept inside the frame's height.
    pub fn place(&self, [x, y]: [f64; 2]) -> [f32; 2] {
        let y = y.clamp(self.y.from, self.y.to);
        [
            self.inside.x + self.inside.w * self.x.at(x) as f32,
            self.inside.y + self.inside.h * (1.0 - self.y.at(y) as f32),
        ]
    }

    /// A bar from the floor, with a hair of air on either side.
    pub fn bar(&self, canvas: &mut Canvas, from: f64, to: f64, height: f64, colour: [u8; 4]) {
        let [left, top] = self.place([from, height]);
        let [right, floor] = self.place([to, self.y.from]);
        let bar = Area::new(left + 0.5, top, right - left - 1.0, floor - top);
        canvas.rectangle(bar, colour);
    }

    /// A line, where it fits into the frame.
    pub fn curve(
        &self,
        canvas: &mut Canvas,
        points: impl IntoIterator<Item = [f64; 2]>,
        width: f32,
        colour: [u8; 4],
    ) {
        let fits = |[_, y]: &[f64; 2]| (self.y.from..=self.y.to).contains(y);
        let pixels: Vec<_> = points
            .into_iter()
            .map(|p| fits(&p).then(|| self.place(p)))
            .collect();
        canvas.line(pixels, width, colour);
    }

    /// Where there is data.
    pub fn inside(&self) -> Area {
        self.inside
    }

    /// Where the plot's upper right corner is, for a legend.
    pub fn corner(&self) -> [f32; 2] {
        [self.inside.x + self.inside.w, self.inside.y]
    }
}
