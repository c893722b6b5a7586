//! Choices by the words of a table, and the sky that is sampled by them.

use super::model::{Air, Stuff, wide};
use super::samplers::{
    Axes, ggx, grid, lambert, mix, phong, phong_pdf, plus, scaled, scatter, scatter_pdf, unit,
    visible_normal,
};
use super::{largest, pair};
use crate::truth::{Point, dot, turn};
use microwarp::discrete::Cdf;
use microwarp::tier::Poly;
use microwarp_scene::scenes::slivers::{self, Evening};
use microwarp_scene::sky::{COLUMNS, ROWS};
use microwarp_scene::{NoSky, Sky, Source};
use std::f64::consts::{FRAC_1_PI, PI, TAU};

/// The words that choose among entries: the first of each, and how many there are.
#[derive(Clone, Debug, Default)]
pub(super) struct Entries(Vec<(f64, f64)>);

/// All words.
const WORDS: f64 = 4_294_967_296.0;

impl Entries {
    pub fn of(table: Cdf<&[u32]>) -> Self {
        let entry = |i| match table.words_of(i) {
            Some(words) => {
                let (first, last) = (f64::from(*words.start()), f64::from(*words.end()));
                (first, last - first + 1.0)
            }
            None => (0.0, 0.0),
        };
        Self((0..table.entries()).map(entry).collect())
    }

    pub fn probability(&self, index: usize) -> f64 {
        self.0.get(index).map_or(0.0, |(_, count)| count / WORDS)
    }

    /// The entry of a word, and the place within it.
    pub fn choose(&self, word: u32) -> Option<(usize, f64)> {
        let word = f64::from(word);
        let holds = |(first, count): &(f64, f64)| word >= *first && word < first + count;
        let index = self.0.iter().position(holds)?;
        let (first, count) = self.0[index];
        Some((index, (word - first) / count))
    }
}

/// The sky: none, or the evening with the table that it is sampled by.
#[derive(Clone, Debug)]
pub struct Heaven(Option<(Entries, Vec<Entries>)>);

impl From<NoSky> for Heaven {
    fn from(_: NoSky) -> Self {
        Self(None)
    }
}

impl From<Evening> for Heaven {
    fn from(sky: Evening) -> Self {
        let table = sky.table::<Poly>().expect("it has a table").table();
        let rows = Entries::of(table.marginal().cdf().view());
        let columns = |row| Entries::of(*table.conditional(row).cdf());
        Self(Some((rows, (0..ROWS).map(columns).collect())))
    }
}

impl Heaven {
    pub(super) fn radiance(&self, direction: Point) -> Point {
        if self.0.is_none() {
            return [0.0; 3];
        }
        let low = (1.0 - direction[2].max(0.0)).powi(4);
        let sky = mix(
            wide(slivers::ZENITH),
            1.0 - low,
            wide(slivers::HORIZON),
            low,
        );
        let cosine = dot(direction, wide(slivers::SUN));
        let halo = f64::from(slivers::HALO) * cosine.max(0.0).powi(8);
        let within = (1.0 - (1.0 - cosine) / f64::from(slivers::WIDTH)).max(0.0);
        let sun = scaled(wide(slivers::DISC), f64::from(slivers::PEAK) * within);
        plus(mix(sky, 1.0, wide(slivers::GLOW), halo), sun)
    }

    /// The density of a direction in a row and a column.
    fn density(&self, row: usize, column: usize) -> f64 {
        self.0.as_ref().map_or(0.0, |(rows, columns)| {
            let chance = rows.probability(row) * columns[row].probability(column);
            let [top, bottom] = zone(row);
            chance * COLUMNS as f64 / (TAU * (top - bottom))
        })
    }

    pub(super) fn pdf(&self, [x, y, z]: Point) -> f64 {
        let down = x.hypot(y).atan2(z) / PI;
        let [row, column] = [(down, ROWS), (turn(x, y), COLUMNS)]
            .map(|(part, count)| ((part * count as f64) as usize).min(count - 1));
        self.density(row, column)
    }

    pub(super) fn sample(&self, [along, down]: [u32; 2]) -> Option<(Point, f64)> {
        let (rows, columns) = self.0.as_ref()?;
        let (row, part) = rows.choose(down)?;
        let (column, beside) = columns[row].choose(along)?;
        let [top, bottom] = zone(row);
        let z = top + part * (bottom - top);
        let (sin, cos) = (TAU * (column as f64 + beside) / COLUMNS as f64).sin_cos();
        let flat = (1.0 - z * z).sqrt();
        Some(([flat * cos, flat * sin, z], self.density(row, column)))
    }
}

/// The heights between which a row of the sky is.
fn zone(row: usize) -> [f64; 2] {
    [row, row + 1].map(|k| (PI * k as f64 / ROWS as f64).cos())
}

// How places scatter light, by the formulas of textbooks.

/// The power heuristic: the weight of a sample of density `own`, where the other technique has density `other`.
pub(super) fn power(own: f64, other: f64) -> f64 {
    own * own / (own * own + other * other)
}

/// A place where light is scattered.
pub(super) enum Place {
    /// The axes about the normal, and the view in them.
    Surface(Axes, Point, Stuff),
    /// The axes about the way that light goes, and the asymmetry.
    Fog(Axes, f64),
}

impl Place {
    pub fn fog(along: Point, air: &Air) -> Self {
        Self::Fog(Axes::about(along), air.asymmetry)
    }

    pub fn surface(normal: Point, view: Point, stuff: Stuff) -> Self {
        let axes = Axes::about(normal);
        Self::Surface(axes, axes.to_local(view), stuff)
    }

    /// What is sent along a direction of the world, with the cosine, and the density by which that is drawn.
    pub fn weigh(&self, along: Point) -> (Point, f64) {
        match self {
            Self::Surface(axes, view, stuff) => stuff.weigh(*view, axes.to_local(along)),
            Self::Fog(axes, g) => {
                let pdf = scatter_pdf(*g, axes.to_local(along)[2]);
                ([pdf; 3], pdf)
            }
        }
    }

    /// A direction with its value and its density; none where the light is taken.
    pub fn draw(&self, source: &mut impl Source) -> Option<(Point, Point, f64)> {
        let (axes, local, (value, pdf)) = match self {
            Self::Surface(axes, view, stuff) => {
                let local = stuff.draw(*view, source);
                (axes, local, stuff.weigh(*view, local))
            }
            Self::Fog(axes, g) => {
                let local = scatter(*g, pair(source));
                let pdf = scatter_pdf(*g, local[2]);
                (axes, local, ([pdf; 3], pdf))
            }
        };
        (pdf > 0.0).then(|| (axes.to_world(local), value, pdf))
    }
}

impl Stuff {
    fn weigh(&self, view: Point, along: Point) -> (Point, f64) {
        let cosine = along[2].max(0.0);
        let diffuse = cosine * FRAC_1_PI;
        match *self {
            Self::Matte(albedo) => (scaled(albedo, diffuse), diffuse),
            Self::Glossy {
                ground,
                coat,
                exponent,
            } => {
                let mirrored = unit([-view[0], -view[1], view[2]]);
                let gloss = phong_pdf(exponent, dot(mirrored, along));
                let value = coat * gloss * cosine * (exponent + 2.0) / (exponent + 1.0);
                let chance = coat / (coat + largest(ground));
                let pdf = chance * gloss + (1.0 - chance) * diffuse;
                (plus(scaled(ground, diffuse), [value; 3]), pdf)
            }
            Self::Metal { colour, roughness } => {
                let normal = unit(plus(view, along));
                let d = ggx(normal, roughness);
                // Smith's masking of both, given their heights, with Schlick's approximation of Fresnel's law.
                let [seen, leaving] = [view, along].map(|[x, y, z]| {
                    let tan2 = (x * x + y * y) / (z * z);
                    0.5 * ((1.0 + roughness * roughness * tan2).sqrt() - 1.0)
                });
                let pdf = d / (4.0 * view[2]) / (1.0 + seen);
                if cosine == 0.0 {
                    return ([0.0; 3], pdf);
                }
                let value = d / (4.0 * view[2]) / (1.0 + seen + leaving);
                let past = (1.0 - dot(normal, along)).powi(5);
                (colour.map(|c| value * (c + (1.0 - c) * past)), pdf)
            }
        }
    }

    fn draw(&self, view: Point, source: &mut impl Source) -> Point {
        match *self {
            Self::Matte(_) => lambert(pair(source)),
            Self::Glossy {
                ground,
                coat,
                exponent,
            } => {
                // One word chooses, and where it lies in the share of its choice is the first number of that.
                let (word, words) = (f64::from(source.next_u32()), 2.0_f64.powi(32));
                let share = (words * coat / (coat + largest(ground))).ceil();
                let on_coat = word < share;
                let first = if on_coat {
                    (word + 0.5) / share
                } else {
                    (word - share + 0.5) / (words - share)
                };
                let steps = 2.0_f64.powi(24);
                let u = [(first * steps).floor() / steps, grid(source.next_u32())];
                if on_coat {
                    let axes = Axes::about([-view[0], -view[1], view[2]]);
                    axes.to_world(phong(exponent, u))
                } else {
                    lambert(u)
                }
            }
            Self::Metal { roughness, .. } => {
                let normal = visible_normal(view, roughness, pair(source));
                mix(normal, 2.0 * dot(normal, view), view, -1.0)
            }
        }
    }
}
