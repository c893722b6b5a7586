//! Tables of weights. What is selected by is a word, so no tier has a part in it.

use crate::run::{Draw, Visit};
use crate::shared::Refusal;
use crate::subject::{Parameters, Subject};
use microwarp::discrete::{
    Alias, AliasEntry, Cdf, PiecewiseConstant1d, PiecewiseConstant2d, Reservoir, select_once,
};
use rand_core::Rng;

/// How many weights the tables have.
const ENTRIES: usize = 6;

/// Builds a subject and hands it on.
pub fn visit<V: Visit>(subject: Subject, p: &Parameters, v: &mut V) -> Result<(), Refusal> {
    let &[a, b, c, d, e, f, ..] = p;
    let weights = [a, b, c, d, e, f];
    match subject {
        Subject::Cdf => v.take(Cumulated(Cdf::<[u32; ENTRIES]>::new(&weights)?)),
        Subject::Alias => {
            let mut bins = [AliasEntry::<u32>::EMPTY; 8];
            v.take(Aliased(Alias::<&[AliasEntry<u32>]>::new_in(
                &weights, &mut bins,
            )?))
        }
        Subject::SelectOnce => v.take(Once(weights)),
        Subject::Reservoir => v.take(Stream(weights)),
        Subject::PiecewiseConstant1d => {
            let cdf = Cdf::<[u32; ENTRIES]>::new(&weights)?;
            v.warp(&PiecewiseConstant1d::new(cdf, 0.0, 1.0)?)
        }
        Subject::PiecewiseConstant2d => {
            v.warp(&PiecewiseConstant2d::<[u32; 4], [[u32; 6]; 4]>::new(
                &sky(a, b),
                [0.0, 1.5],
                [0.0, 1.0],
            )?)
        }
        _ => Err(Refusal::Unknown),
    }
}

/// Clouds of a given brightness with a sun among them, and a dark column.
fn sky(clouds: f32, sun: f32) -> [[f32; 6]; 4] {
    let c = clouds;
    [
        [1.0, c, 1.0, 0.0, c, 1.0],
        [c, c, 1.0, 0.0, sun, 1.0],
        [1.0, c, c, 0.0, 1.0, 1.0],
        [1.0, 1.0, c, 0.0, c, c],
    ]
}

struct Cumulated(Cdf<[u32; ENTRIES]>);

struct Aliased<'a>(Alias<&'a [AliasEntry<u32>]>);

/// Draws the index of a table's entry, and reports the numerators of all.
macro_rules! indices {
    ($($table:ty),*) => {$(
        impl Draw for $table {
            type Point = usize;

            fn draw<R: Rng>(&mut self, rng: &mut R) -> Result<usize, Refusal> {
                Ok(self.0.draw_index(rng))
            }

            fn density(&self, index: usize) -> f64 {
                self.0.pmf(index).into()
            }

            fn report(&self, report: &mut [f64; 16]) {
                for (index, slot) in report.iter_mut().enumerate().take(ENTRIES) {
                    *slot = self.0.numerator(index) as f64;
                }
            }
        }
    )*};
}

indices!(Cumulated, Aliased<'_>);

/// A selection and the probability it reported; the page is told that, not one worked out again.
#[derive(Clone, Copy)]
pub struct Chosen {
    index: usize,
    pmf: f32,
}

impl crate::numbers::Numbers for Chosen {
    fn wide(self) -> [f64; 3] {
        self.index.wide()
    }
    fn bits(self) -> u32 {
        self.index as u32 ^ self.pmf.to_bits()
    }
}

struct Once([f32; ENTRIES]);

impl Draw for Once {
    type Point = Chosen;

    fn draw<R: Rng>(&mut self, rng: &mut R) -> Result<Chosen, Refusal> {
        let chosen = select_once(&self.0, rng.next_u32())?;
        Ok(Chosen {
            index: chosen.index,
            pmf: chosen.pmf,
        })
    }

    fn density(&self, chosen: Chosen) -> f64 {
        chosen.pmf.into()
    }
}

struct Stream([f32; ENTRIES]);

impl Draw for Stream {
    type Point = Chosen;

    fn draw<R: Rng>(&mut self, rng: &mut R) -> Result<Chosen, Refusal> {
        let mut held = Reservoir::new();
        for (index, weight) in self.0.into_iter().enumerate() {
            held.offer(index, weight, rng)?;
        }
        let index = *held.item().ok_or(microwarp::Error::AllZero)?;
        Ok(Chosen {
            index,
            pmf: held.pmf(),
        })
    }

    fn density(&self, chosen: Chosen) -> f64 {
        chosen.pmf.into()
    }
}
