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
        let inside = area.inside(62.0, 34.0, 14.0, 58.0);
        let this = Self { inside, x, y };
        let label = Type::plain(17.0, MUTED);
        let heading = Type::bold(21.0);
        canvas.text(
            title,
            [inside.x, area.y + 20.0],
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
            let anchor = [inside.x - 8.0, at + 6.0];
            canvas.text(&y.label(value), anchor, Align::Right, label, 54.0);
        }
        canvas.segment([inside.x, floor], [inside.x + inside.w, floor], 1.3, INK);
        for value in x.ticks(8.0) {
            let [at, _] = this.place([value, y.from]);
            canvas.segment([at, floor], [at, floor + 5.0], 1.3, INK);
            canvas.text(
                &x.label(value),
                [at, floor + 24.0],
                Align::Middle,
                label,
                60.0,
            );
        }
        let middle = inside.x + 0.5 * inside.w;
        canvas.text(
            x_name,
            [middle, floor + 47.0],
            Align::Middle,
            label,
            inside.w,
        );
        this
    }

    /// The pixel of a place, kept inside the frame's height.
    fn place(&self, [x, y]: [f64; 2]) -> [f32; 2] {
        let y = y.clamp(self.y.from, self.y.to);
        [
            self.inside.x + self.inside.w * self.x.at(x) as f32,
            self.inside.y + self.inside.h * (1.0 - self.y.at(y) as f32),
        ]
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
}
