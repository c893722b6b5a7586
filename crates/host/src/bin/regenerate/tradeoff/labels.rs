//! Places the names of points so that they cover neither points, whiskers, borders nor each other.

use microwarp_host::draw::canvas::{Area, Canvas};
use microwarp_host::draw::colour::Colour;
use microwarp_host::draw::text::{Align, Type};

/// A point with a name.
pub struct Named {
    pub at: [f32; 2],
    pub text: String,
    pub colour: Colour,
}

const SIZE: f32 = 17.0;
/// Half the extent of a mark, and the air around it.
const MARK: f32 = 8.0;

/// The box about a line along an axis.
fn piece(from: [f32; 2], to: [f32; 2]) -> Area {
    let [low, high] = [f32::min, f32::max].map(|end| [0, 1].map(|k| end(from[k], to[k])));
    let [w, h] = [0, 1].map(|k| high[k] - low[k] + 3.0);
    Area::new(low[0] - 1.5, low[1] - 1.5, w, h)
}

/// Where a name of this size may stand beside its point, the best places first: beside it, and then farther and farther off.
fn places([x, y]: [f32; 2], w: f32) -> impl Iterator<Item = Area> {
    let h = SIZE;
    let (right, left, middle) = (x + MARK, x - MARK - w, x - 0.5 * w);
    let (above, below) = (y - MARK - h + 1.0, y + MARK - 1.0);
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
    let far = (1..=14).flat_map(move |k| {
        let shift = 0.5 * h * k as f32;
        let aside = [
            0.0, 0.25, -0.25, 0.5, -0.5, 0.75, -0.75, 1.0, -1.0, 1.5, -1.5, 2.0, -2.0,
        ];
        let columns = aside.map(|part| middle + part * (w + 2.0 * MARK) * 0.75);
        columns
            .into_iter()
            .flat_map(move |x| [[x, above - shift], [x, below + shift]])
    });
    let all = near.into_iter().chain(far);
    all.map(move |[x, y]| Area::new(x, y, w, h))
}

/// A name's place, and how far down the list of places it is.
#[derive(Clone, Copy, Debug)]
struct Placed {
    area: Area,
    rank: usize,
}

/// So much of a lead from a point to its name lies on an area, at least: by steps along it.
fn led_over([x, y]: [f32; 2], [x1, y1]: [f32; 2], area: Area) -> f32 {
    let inside = |k: &i32| {
        let t = *k as f32 / 16.0;
        let at = [x + t * (x1 - x), y + t * (y1 - y)];
        at[0] > area.x && at[0] < area.x + area.w && at[1] > area.y && at[1] < area.y + area.h
    };
    (0..=16).filter(inside).count() as f32
}

/// The end of a lead at its name.
fn end([x, y]: [f32; 2], place: Area) -> [f32; 2] {
    let edge = if place.y > y {
        place.y + 2.0
    } else {
        place.y + place.h - 1.0
    };
    [x.clamp(place.x + 2.0, place.x + place.w - 2.0), edge]
}

/// Where the names of points go within an area, by their widths: off marks, and off lines along the axes.
fn layout(inside: Area, points: &[([f32; 2], f32)], lines: &[[[f32; 2]; 2]]) -> Vec<Placed> {
    let marks: Vec<Area> = points
        .iter()
        .map(|([x, y], _)| Area::new(x - 6.0, y - 6.0, 12.0, 12.0))
        .collect();
    let pieces: Vec<Area> = lines.iter().map(|[from, to]| piece(*from, *to)).collect();
    // Points with the most neighbours have the least choice, so they go first.
    let crowd = |p: &usize| {
        let [x, y] = points[*p].0;
        let near = |q: &&([f32; 2], f32)| (x - q.0[0]).hypot((y - q.0[1]) * 2.0) < 90.0;
        points.iter().filter(near).count()
    };
    let mut order: Vec<usize> = (0..points.len()).collect();
    order.sort_by_key(|p| std::cmp::Reverse(crowd(p)));
    let mut placed: Vec<Option<Placed>> = vec![None; points.len()];
    for p in order {
        let (at, width) = points[p];
        let cost = |(rank, place): &(usize, Area)| {
            let outside = place.w * place.h - place.overlap(inside);
            let taken = || placed.iter().flatten().map(|p| p.area);
            let names: f32 = taken().map(|other| place.overlap(other)).sum();
            let hidden: f32 = marks.iter().map(|mark| place.overlap(*mark)).sum();
            let struck: f32 = pieces.iter().map(|piece| place.overlap(*piece)).sum();
            let led: f32 = if *rank < 8 {
                0.0
            } else {
                taken()
                    .map(|name| led_over(at, end(at, *place), name))
                    .sum()
            };
            let far = (place.x + 0.5 * place.w - at[0]).hypot(place.y + 0.5 * place.h - at[1]);
            1e4 * (outside + names)
                + 30.0 * hidden
                + 8.0 * struck
                + 60.0 * led
                + far
                + if *rank < 8 { 2.0 * *rank as f32 } else { 30.0 }
        };
        let best = places(at, width)
            .enumerate()
            .min_by(|a, b| cost(a).total_cmp(&cost(b)));
        placed[p] = best.map(|(rank, area)| Placed { area, rank });
    }
    placed.into_iter().flatten().collect()
}

/// Writes the names of points within an area, off lines along the axes where they can. Returns how many of them lie on others
/// or partly outside, and how many would if each had its first place.
pub fn write(
    canvas: &mut Canvas,
    inside: Area,
    points: &[Named],
    lines: &[[[f32; 2]; 2]],
) -> [usize; 2] {
    let style = |point: &Named| Type::plain(SIZE, point.colour);
    let sizes: Vec<_> = points
        .iter()
        .map(|p| (p.at, canvas.width(&p.text, style(p))))
        .collect();
    let placed = layout(inside, &sizes, lines);
    for (point, Placed { area, rank }) in points.iter().zip(&placed) {
        // A name that stands away from its point is led to it.
        if *rank >= 8 {
            canvas.segment(point.at, end(point.at, *area), 0.8, point.colour);
        }
        let anchor = [area.x, area.y + 0.8 * area.h];
        canvas.text(&point.text, anchor, Align::Left, style(point), area.w + 1.0);
    }
    let first = sizes.iter().filter_map(|(at, w)| places(*at, *w).next());
    let placed: Vec<Area> = placed.iter().map(|p| p.area).collect();
    [placed, first.collect()].map(|names| faults(&names, inside))
}

/// How many names lie on one before them or partly outside.
fn faults(names: &[Area], inside: Area) -> usize {
    let faulty = |&i: &usize| {
        let name = names[i];
        let out = name.w * name.h - name.overlap(inside) > 1e-2;
        out || names[..i].iter().any(|other| name.overlap(*other) > 1e-2)
    };
    (0..names.len()).filter(faulty).count()
}
