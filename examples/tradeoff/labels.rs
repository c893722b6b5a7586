//! Places the names of points so that they cover neither points nor each other.

use support::draw::canvas::{Area, Canvas};
use support::draw::colour::Colour;
use support::draw::text::{Align, Type};

/// A point with a name.
pub struct Named {
    pub at: [f32; 2],
    pub text: String,
    pub colour: Colour,
}

const SIZE: f32 = 17.0;
/// Half the extent of a mark, and the air around it.
const MARK: f32 = 7.0;

fn overlap(a: Area, b: Area) -> f32 {
    let side = |from: f32, to: f32, start: f32, end: f32| (to.min(end) - from.max(start)).max(0.0);
    side(a.x, a.x + a.w, b.x, b.x + b.w) * side(a.y, a.y + a.h, b.y, b.y + b.h)
}

/// Where a name of this width may stand beside its point, the best places first.
fn places([x, y]: [f32; 2], w: f32) -> impl Iterator<Item = Area> {
    let h = SIZE;
    let (right, left, middle) = (x + MARK, x - MARK - w, x - 0.5 * w);
    let (above, below) = (y - MARK - h + 2.0, y + MARK - 2.0);
    let near = [
        [right, y - 0.5 * h],
        [left, y - 0.5 * h],
        [middle, above],
        [middle, below],
        [right - 3.0, above],
        [right - 3.0, below],
        [left + 3.0, above],
        [left + 3.0, below],
    ];
    let far = [1.0, 2.0, 3.0].into_iter().flat_map(move |k| {
        let shift = 0.8 * h * k;
        [
            [right + 2.0, above - shift],
            [right + 2.0, below + shift],
            [left - 2.0, above - shift],
            [left - 2.0, below + shift],
            [middle, above - shift],
            [middle, below + shift],
        ]
    });
    near.into_iter()
        .chain(far)
        .map(move |[x, y]| Area::new(x, y, w, h))
}

/// Writes the names of points within an area, off a line from corner to corner where they can.
pub fn write(canvas: &mut Canvas, inside: Area, points: &[Named], line: &[[f32; 2]]) {
    let marks: Vec<Area> = points
        .iter()
        .map(|p| Area::new(p.at[0] - 5.0, p.at[1] - 5.0, 10.0, 10.0))
        .collect();
    // Its pieces run along the axes.
    let pieces: Vec<Area> = line
        .windows(2)
        .map(|ends| {
            let [from, to] =
                [0, 1].map(|k| [ends[0][k].min(ends[1][k]), ends[0][k].max(ends[1][k])]);
            Area::new(
                from[0] - 1.5,
                to[0] - 1.5,
                from[1] - from[0] + 3.0,
                to[1] - to[0] + 3.0,
            )
        })
        .collect();
    // Points with the most neighbours have the least choice, so they go first.
    let crowd = |p: &Named| {
        let near = |q: &&Named| (p.at[0] - q.at[0]).hypot((p.at[1] - q.at[1]) * 2.0) < 90.0;
        points.iter().filter(near).count()
    };
    let mut order: Vec<&Named> = points.iter().collect();
    order.sort_by_key(|p| std::cmp::Reverse(crowd(p)));
    let mut taken: Vec<Area> = Vec::new();
    for point in order {
        let style = Type::plain(SIZE, point.colour);
        let width = canvas.width(&point.text, style);
        let cost = |(rank, place): &(usize, Area)| {
            let outside = place.w * place.h - overlap(*place, inside);
            let hidden: f32 = marks
                .iter()
                .chain(&taken)
                .map(|other| overlap(*place, *other))
                .sum();
            let struck: f32 = pieces.iter().map(|piece| overlap(*place, *piece)).sum();
            20.0 * outside + hidden + struck + 1.5 * *rank as f32
        };
        let best = places(point.at, width)
            .enumerate()
            .min_by(|a, b| cost(a).total_cmp(&cost(b)));
        let Some((rank, place)) = best else { continue };
        // A name that stands away from its point is led to it.
        if rank >= 8 {
            let end = [
                point.at[0].clamp(place.x, place.x + place.w),
                if place.y > point.at[1] {
                    place.y + 2.0
                } else {
                    place.y + place.h - 1.0
                },
            ];
            canvas.segment(point.at, end, 0.8, point.colour);
        }
        let anchor = [place.x, place.y + 0.8 * place.h];
        canvas.text(&point.text, anchor, Align::Left, style, place.w + 1.0);
        taken.push(place);
    }
}
