//! Choices by the words of a table, and the sky that is sampled by them.

use super::model::wide;
use super::samplers::{mix, plus, scaled};
use crate::truth::{Point, dot, turn};
use microwarp::discrete::Cdf;
use microwarp::tier::Poly;
use microwarp_scene::scenes::slivers::{self, Evening};
use microwarp_scene::sky::{COLUMNS, ROWS};
use microwarp_scene::{NoSky, Sky};
use std::f64::consts::{PI, TAU};

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
