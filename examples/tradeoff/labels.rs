//! Places the names of points so that they cover neither points, whiskers, borders nor each other.

use host::draw::canvas::{Area, Canvas};
use host::draw::colour::Colour;
use host::draw::text::{Align, Type};

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
pub struct Placed {
    pub area: Area,
    pub rank: usize,
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
pub fn layout(inside: Area, points: &[([f32; 2], f32)], lines: &[[[f32; 2]; 2]]) -> Vec<Placed> {
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

/// Writes the names of points within an area, off lines along the axes where they can.
pub fn write(canvas: &mut Canvas, inside: Area, points: &[Named], lines: &[[[f32; 2]; 2]]) {
    let style = |point: &Named| Type::plain(SIZE, point.colour);
    let sizes: Vec<_> = points
        .iter()
        .map(|p| (p.at, canvas.width(&p.text, style(p))))
        .collect();
    for (point, Placed { area, rank }) in points.iter().zip(layout(inside, &sizes, lines)) {
        // A name that stands away from its point is led to it.
        if rank >= 8 {
            canvas.segment(point.at, end(point.at, area), 0.8, point.colour);
        }
        let anchor = [area.x, area.y + 0.8 * area.h];
        canvas.text(&point.text, anchor, Align::Left, style(point), area.w + 1.0);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use microwarp::uniform::grid;
    use rand_pcg::Pcg32;

    const PANEL: Area = Area {
        x: 0.0,
        y: 0.0,
        w: 435.0,
        h: 284.0,
    };

    /// Names that lie on each other or outside, marks and whiskers that names lie on.
    fn faults(
        points: &[([f32; 2], f32)],
        lines: &[[[f32; 2]; 2]],
        placed: &[Placed],
    ) -> [usize; 2] {
        let (mut on_names, mut struck) = (0, 0);
        for (i, a) in placed.iter().enumerate() {
            let out = a.area.w * a.area.h - a.area.overlap(PANEL) > 1e-2;
            let meets = placed[..i].iter().any(|b| a.area.overlap(b.area) > 1e-2);
            on_names += usize::from(out || meets);
            let mark = points
                .iter()
                .any(|([x, y], _)| a.area.overlap(Area::new(x - 4.0, y - 4.0, 8.0, 8.0)) > 1e-2);
            let line = lines
                .iter()
                .any(|[from, to]| a.area.overlap(piece(*from, *to)) > 1e-2);
            struck += usize::from(mark || line);
        }
        [on_names, struck]
    }

    /// A point and the width of its name.
    type Named = ([f32; 2], f32);
    type Line = [[f32; 2]; 2];

    /// A crowd as in the panel of the disk on the host: twelve points with names of four to fifteen letters, most of them in
    /// a heap, with a whisker each.
    fn crowd(rng: &mut Pcg32) -> (Vec<Named>, Vec<Line>) {
        let mut u = || grid(rng);
        let heap = [60.0 + 250.0 * u(), 120.0 + 110.0 * u()];
        let mut points = Vec::new();
        let mut lines = Vec::new();
        for k in 0..12 {
            let wide = if k < 9 { [110.0, 60.0] } else { [380.0, 240.0] };
            let at = [0, 1].map(|i| heap[i] + wide[i] * (u() - 0.5));
            let at = [at[0].clamp(6.0, 425.0), at[1].clamp(6.0, 278.0)];
            points.push((at, 32.0 + 90.0 * u()));
            lines.push([at, [(at[0] + 60.0 * u()).min(430.0), at[1]]]);
        }
        (points, lines)
    }

    #[test]
    fn names_cover_neither_each_other_nor_points_nor_whiskers() {
        let rng = &mut Pcg32::new(5, 17);
        let (mut panels, mut control, mut struck) = (0, 0, 0);
        for _ in 0..100 {
            let (points, lines) = crowd(rng);
            let placed = layout(PANEL, &points, &lines);
            assert_eq!(placed.len(), points.len());
            let [on_names, on_lines] = faults(&points, &lines, &placed);
            assert_eq!(on_names, 0, "{points:?}");
            struck += on_lines;
            panels += 1;
            // Each at the first of its places, whatever the others do.
            let first = |(at, w): &([f32; 2], f32)| places(*at, *w).next();
            let area = |area| Placed { area, rank: 0 };
            let naive: Vec<_> = points.iter().filter_map(first).map(area).collect();
            let [names, lines] = faults(&points, &lines, &naive);
            control += usize::from(names > 0 && lines > 0);
        }
        println!(
            "{panels} panels: {struck} names on a point or a whisker; control: {control} panels"
        );
        // Of 1,200; a heap may leave no free place nearby.
        assert!(struck <= 24, "{struck}");
        assert_eq!(control, panels);
    }
}
