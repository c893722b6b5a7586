//! Pictures within a picture: cells of their own colours below a title and a caption.

use super::canvas::{Area, Canvas};
use super::colour::MUTED;
use super::text::{Align, Type};

/// Title and caption of a panel.
pub const HEAD: f32 = 66.0;

/// Draws what `colour` says of each cell of a panel.
pub fn cells(
    canvas: &mut Canvas,
    place: Area,
    [columns, rows]: [usize; 2],
    colour: impl Fn(usize) -> [f64; 3],
) {
    let colours: Vec<[f64; 3]> = (0..columns * rows).map(colour).collect();
    canvas.shade(place, |x, y| {
        let column = ((x - place.x) / place.w * columns as f32) as usize;
        let row = ((y - place.y) / place.h * rows as f32) as usize;
        colours.get(row * columns + column).copied()
    });
}

/// Writes the head of a panel; what is left is the panel.
pub fn head(canvas: &mut Canvas, place: Area, title: &str, text: &str) -> Area {
    let style = Type::bold(26.0);
    canvas.text(
        title,
        [place.x, place.y + 42.0],
        Align::Left,
        style,
        place.w,
    );
    let after = place.x + canvas.width(title, style) + 16.0;
    canvas.text(
        text,
        [after, place.y + 42.0],
        Align::Left,
        Type::plain(21.0, MUTED),
        place.x + place.w - after,
    );
    place.inside(0.0, HEAD - 10.0, 0.0, 10.0)
}
