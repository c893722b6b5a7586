//! Tables of weights. A word selects, so they belong to no tier.

use crate::run::{Draw, of};
use crate::shared::Refusal;
use crate::subject::subjects;
use microwarp::discrete::{
    Alias, AliasEntry, Cdf, PiecewiseConstant1d, PiecewiseConstant2d, Reservoir, select_once,
};
use rand_core::Rng;

/// How many weights the tables have.
const ENTRIES: usize = 6;

/// The subjects that take six weights, and those with parameters of their own.
macro_rules! tables {
    (
        of weights { $($type:ident: $view:ident $words:literal: $name:ident => $table:expr,)* }
        $($rest:tt)*
    ) => {
        subjects! {
            TABLES visit[] "tables" "exact":
            $($type: $view $words: $name(
                weight_0: 3 in 0..10 by 0.1, weight_1: 1 in 0..10 by 0.1, weight_2: 0 in 0..10 by 0.1,
                weight_3: 5 in 0..10 by 0.1, weight_4: 2 in 0..10 by 0.1, weight_5: 4 in 0..10 by 0.1
            ) => $table([weight_0, weight_1, weight_2, weight_3, weight_4, weight_5]),)*
            $($rest)*
        }
    };
}

tables! {
    of weights {
        Cdf: bars 1: Cdf => |weights: [f32; 6]| Cdf::new(&weights).map(Cumulated),
        Alias: bars 1: Alias => |weights: [f32; 6]| Alias::<[AliasEntry<u32>; 8]>::new(&weights).map(Aliased),
        select_once: bars 1: SelectOnce => |weights| Ok::<_, Refusal>(Once(weights)),
        Reservoir: bars 0: Reservoir => |weights| Ok::<_, Refusal>(Stream(weights)),
        PiecewiseConstant1d: line 1: PiecewiseConstant1d => |weights: [f32; 6]| {
            of(PiecewiseConstant1d::new(&weights, 0.0, 1.0))
        },
    }
    PiecewiseConstant2d: plane 2: PiecewiseConstant2d(clouds: 3 in 0..10 by 0.1, sun: 30 in 0..100 by 0.5)
        => of(PiecewiseConstant2d::new(&sky(clouds, sun), [0.0, 1.5], [0.0, 1.0])),
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

struct Aliased(Alias<[AliasEntry<u32>; 8]>);

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

indices!(Cumulated, Aliased);

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
