//! Vectors that are off by a sum of vectors, each of which may point either way: how far all of them together reach.

use crate::cover::halves;
use crate::inputs::in_parallel;
use crate::range::Range;
use crate::tape::{NEAR, Tape, Traced};
use host::errors::raise;
use std::sync::LazyLock;

pub type Vector = [Range; 3];

pub fn times(vector: Vector, by: Range) -> Vector {
    vector.map(|x| x * by)
}

pub fn plus(a: Vector, b: Vector) -> Vector {
    std::array::from_fn(|i| a[i] + b[i])
}

/// The derivatives of three outputs of a record.
pub struct Spread([Vec<[Range; 2]>; 3]);

impl Spread {
    pub fn of(tape: &Tape, outputs: [Traced; 3]) -> Self {
        let one = Range::only(1.0);
        Self(outputs.map(|output| tape.derivatives([(output, one, output.value())])))
    }

    /// By a value, and that times the value.
    pub fn by(&self, of: Traced) -> [Vector; 2] {
        [0, 1].map(|which| self.0.each_ref().map(|by| by[of.index][which]))
    }

    /// What each operation of the record rounds.
    pub fn rounded(&self, tape: &Tape, all: &mut Vec<Vector>) {
        let nodes = tape.nodes.borrow();
        for (i, node) in nodes.iter().enumerate() {
            let lost = node.lost;
            if lost.absolute == 0.0 && lost.floor == 0.0 {
                continue;
            }
            let [d, s] = [0, 1].map(|which| self.0.each_ref().map(|by| by[i][which]));
            let absolute = times(d, Range::both(lost.absolute));
            let relative = std::array::from_fn(|i| {
                s[i] * Range::both(lost.relative) + d[i] * Range::both(lost.floor)
            });
            let is_part = lost.relative.is_finite() && size(relative) < size(absolute);
            all.push(if is_part { relative } else { absolute });
        }
    }
}

fn size(vector: Vector) -> f64 {
    vector.iter().map(|x| x.size() * x.size()).sum()
}

/// Directions of which every one is near to one, or to the opposite of one, and by how much more than its longest projection a vector may
/// reach.
///
/// They are the middles of the cells of three sides of a cube. Half the diagonal of a cell is the root of 2 over their number along
/// an edge, and what is outside the unit ball comes no farther apart when it is moved onto it.
pub struct Net {
    directions: Vec<[f64; 3]>,
    missed: f64,
}

impl Net {
    pub fn new(cells: u32) -> Self {
        let at = |i: u32| (f64::from(2 * i + 1) / f64::from(cells)) - 1.0;
        let mut directions = Vec::new();
        for (i, j) in (0..cells).flat_map(|i| (0..cells).map(move |j| (i, j))) {
            let [a, b] = [at(i), at(j)];
            let length = (1.0 + a * a + b * b).sqrt();
            let [a, b, c] = [a, b, 1.0].map(|x| x / length);
            directions.extend([[a, b, c], [b, c, a], [c, a, b]]);
        }
        let missed = 1.0 / (1.0 - 1.0 / f64::from(cells * cells));
        Self { directions, missed }
    }

    /// The largest projection of a sum onto a direction of the net.
    fn longest(&self, all: &[[[f64; 3]; 2]]) -> f64 {
        let of = self.directions.iter();
        of.map(|direction| along(all, *direction))
            .fold(0.0, f64::max)
    }
}

/// A coarse net and a fine one.
static NETS: LazyLock<[Net; 2]> = LazyLock::new(|| [4, 14].map(Net::new));

/// The largest length of a sum, or a longer one, which is more than `enough` only if it has to be or if the fine net says so.
pub fn reach(all: &[Vector], enough: f64) -> f64 {
    let all: Vec<_> = all.iter().map(|v| parts(*v)).collect();
    let [coarse, fine] = &*NETS;
    let longest = coarse.longest(&all);
    let most = if longest <= enough && longest * coarse.missed > enough {
        fine.longest(&all) * fine.missed
    } else {
        longest * coarse.missed
    };
    most * (1.0 + 4.0 * NEAR)
}

/// The largest length of a sum by the fine net.
pub fn length(all: &[Vector]) -> f64 {
    let all: Vec<_> = all.iter().map(|v| parts(*v)).collect();
    let [_, fine] = &*NETS;
    fine.longest(&all) * fine.missed * (1.0 + 4.0 * NEAR)
}

/// The middles and half the widths of a vector's ranges.
fn parts(vector: Vector) -> [[f64; 3]; 2] {
    let middle = vector.map(|Range { low, high }| 0.5 * (low + high));
    let half = vector.map(|Range { low, high }| 0.5 * (high - low));
    [middle, half]
}

fn along(all: &[[[f64; 3]; 2]], [x, y, z]: [f64; 3]) -> f64 {
    let sums = all.iter().map(|[[a, b, c], [d, e, f]]| {
        (a * x + b * y + c * z).abs() + (d * x.abs() + e * y.abs() + f * z.abs())
    });
    sums.sum()
}

/// The largest of the bounds of boxes. A box of which it is above `fine` is cut in half where its width counts most, up to `depth` times.
pub fn over<const N: usize>(
    boxes: &[[Range; N]],
    counts: [f64; N],
    (fine, depth): (f64, u32),
    bound: impl Fn(&[Range; N], f64) -> f64 + Sync,
) -> f64 {
    let parts = in_parallel(boxes.len() as u32, |i| {
        let mut worst = 0.0;
        let mut open = vec![(boxes[i as usize], depth)];
        while let Some((of, depth)) = open.pop() {
            let enough = fine.max(worst);
            let most = bound(&of, enough);
            if depth == 0 || most <= enough {
                raise(&mut worst, most);
                continue;
            }
            let width = |i: usize| counts[i] * (of[i].high - of[i].low);
            let ways = (0..N).max_by(|&i, &j| width(i).total_cmp(&width(j)));
            let way = ways.expect("a way to cut");
            open.extend(halves(of[way]).map(|half| {
                let mut of = of;
                of[way] = half;
                (of, depth - 1)
            }));
        }
        worst
    });
    parts.into_iter().fold(0.0, f64::max)
}
