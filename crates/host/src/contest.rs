//! Samplers timed side by side: who takes part, in which order, and what the times say.
//!
//! Machines change speed while they are measured, from one second to the next and by half. So nothing here compares
//! times of different moments: in a round every contestant draws the same number of points once, and what counts is
//! the quotient of two times of one round. Of these quotients the median is reported, with the quartiles, which show
//! how noisy the machine was. Rounds follow a plan in which everyone is everyone's successor equally often.
//!
//! What is measured is the business of others: `peers.rs` and the benches.

use microwarp::Warp;
use rand_pcg::Pcg32;
use statrs::statistics::{Data, OrderStatistics};
use std::hint::black_box;
use std::time::Instant;

/// Points of a block, the same memory for all of a contest; few enough for the first cache.
pub const POINTS: usize = 1_024;
/// Blocks that are timed together, so that reading the clock does not show.
pub const BLOCKS: usize = 8;

/// What everyone's generator starts from.
pub fn generator() -> Pcg32 {
    Pcg32::new(42, 54)
}

/// Draws a block of points, each time others.
pub type Block<P> = Box<dyn FnMut(&mut [P])>;

/// The block of a sampler of single points.
pub fn block_of<P>(mut draw: impl FnMut(&mut Pcg32) -> P) -> impl FnMut(&mut [P]) {
    let mut kept = generator();
    move |points| {
        // In a local variable the generator may stay in registers, as it does in a caller's own loop.
        let mut rng = kept.clone();
        for point in points {
            *point = draw(&mut rng);
        }
        kept = rng;
    }
}

/// Who takes part, and the memory that they write to.
pub struct Contest<P> {
    names: Vec<String>,
    blocks: Vec<Block<P>>,
    points: Vec<P>,
    repeats: usize,
    /// How many samples a point is.
    samples: usize,
}

impl<P: Copy + 'static> Contest<P> {
    /// A contest of nobody yet; the points hold `blank` before they are drawn.
    pub fn new(blank: P) -> Self {
        Self::of_blocks(blank, POINTS, BLOCKS)
    }

    /// Likewise, with blocks of so many points of which so many are timed together.
    pub fn of_blocks(blank: P, points: usize, repeats: usize) -> Self {
        Self {
            names: Vec::new(),
            blocks: Vec::new(),
            points: vec![blank; points],
            repeats,
            samples: 1,
        }
    }

    /// Counts every point as so many samples, as a pair of normals is two.
    #[must_use]
    pub fn counting(mut self, samples: usize) -> Self {
        self.samples = samples;
        self
    }

    /// Admits a sampler of single points.
    #[must_use]
    pub fn draw(self, name: &str, draw: impl FnMut(&mut Pcg32) -> P + 'static) -> Self {
        self.block(name, block_of(draw))
    }

    /// Admits a sampler that fills slices.
    #[must_use]
    pub fn fill(self, name: &str, mut fill: impl FnMut(&mut Pcg32, &mut [P]) + 'static) -> Self {
        let mut kept = generator();
        self.block(name, move |points| {
            let mut rng = kept.clone();
            fill(&mut rng, points);
            kept = rng;
        })
    }

    /// Admits a warp that is drawn from.
    #[must_use]
    pub fn warp<W: Warp<Point = P> + 'static>(self, name: &str, warp: W) -> Self {
        let warp = black_box(warp);
        self.draw(name, move |rng| warp.draw(rng))
    }

    /// Admits a warp that fills slices.
    #[must_use]
    pub fn warp_fill<W: Warp<Point = P> + 'static>(self, name: &str, warp: W) -> Self {
        let warp = black_box(warp);
        self.fill(name, move |rng, points| warp.fill(rng, points))
    }

    /// Admits anything that overwrites a block.
    #[must_use]
    pub fn block(mut self, name: &str, block: impl FnMut(&mut [P]) + 'static) -> Self {
        assert!(
            !self.names.iter().any(|known| known == name),
            "{name} twice"
        );
        self.names.push(name.into());
        self.blocks.push(Box::new(block));
        self
    }

    /// How many take part.
    pub fn contestants(&self) -> usize {
        self.names.len()
    }

    /// Runs so many rounds; `after_round` is called between them, outside all times.
    pub fn run(mut self, rounds: usize, mut after_round: impl FnMut()) -> Standings {
        let mut nanoseconds = vec![Vec::with_capacity(rounds); self.names.len()];
        for round in 0..rounds {
            for contestant in order(self.names.len(), round) {
                nanoseconds[contestant].push(self.turn(contestant));
            }
            after_round();
        }
        Standings::new(self.names, nanoseconds)
    }

    /// Nanoseconds a sample of one contestant, once.
    fn turn(&mut self, contestant: usize) -> f64 {
        let block = &mut self.blocks[contestant];
        // A block that is not timed brings this one's code and tables into the caches.
        block(black_box(&mut self.points));
        let start = Instant::now();
        for _ in 0..self.repeats {
            block(black_box(&mut self.points));
        }
        let elapsed = start.elapsed();
        black_box(&self.points);
        let samples = self.repeats * self.points.len() * self.samples;
        elapsed.as_secs_f64() * 1e9 / samples as f64
    }
}

/// The order of a round: in n consecutive rounds everyone has every place once, and in n of an even n, 2n of an odd
/// one, everyone is the successor of everyone else equally often.
///
/// Source: E. J. Williams, "Experimental Designs Balanced for the Estimation of Residual Effects of Treatments", 1949.
pub fn order(contestants: usize, round: usize) -> Vec<usize> {
    // 0, 1, n − 1, 2, n − 2 and so on has every difference modulo n once; so has every shift of it.
    let shifted = (0..contestants).map(|place| {
        let step = place.div_ceil(2);
        let start = if place % 2 == 1 {
            step
        } else {
            contestants - step
        };
        (start + round) % contestants
    });
    // Of an odd number the differences come in equal pairs; the other of each pair is in the reverse.
    if contestants % 2 == 1 && (round / contestants) % 2 == 1 {
        shifted.rev().collect()
    } else {
        shifted.collect()
    }
}

/// Half of all values lie between the quartiles, half on either side of the median.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quartiles {
    pub lower: f64,
    pub median: f64,
    pub upper: f64,
}

impl Quartiles {
    /// Of some values; not numbers of none.
    pub fn of(values: impl IntoIterator<Item = f64>) -> Self {
        let mut data = Data::new(values.into_iter().collect::<Vec<_>>());
        Self {
            lower: data.lower_quartile(),
            median: data.median(),
            upper: data.upper_quartile(),
        }
    }

    /// Their distance relative to the median: the noise of the machine, were all else equal.
    pub fn spread(&self) -> f64 {
        (self.upper - self.lower) / self.median
    }
}

/// The times of all rounds.
pub struct Standings {
    names: Vec<String>,
    /// Of each contestant the nanoseconds a sample in each round.
    nanoseconds: Vec<Vec<f64>>,
}

impl Standings {
    /// Of each contestant its name and its times, the same number of each.
    pub fn new(names: Vec<String>, nanoseconds: Vec<Vec<f64>>) -> Self {
        assert_eq!(names.len(), nanoseconds.len());
        Self { names, nanoseconds }
    }

    /// The contestants, in the order in which they were admitted.
    pub fn names(&self) -> impl Iterator<Item = &str> {
        self.names.iter().map(String::as_str)
    }

    fn times(&self, name: &str) -> Option<&[f64]> {
        let place = self.names().position(|known| known == name)?;
        self.nanoseconds.get(place).map(Vec::as_slice)
    }

    /// Nanoseconds a sample.
    pub fn nanoseconds(&self, name: &str) -> Option<Quartiles> {
        Some(Quartiles::of(self.times(name)?.iter().copied()))
    }

    /// How many times as long as the other it takes: quartiles of the quotients within each round.
    pub fn ratio(&self, name: &str, other: &str) -> Option<Quartiles> {
        let (times, others) = (self.times(name)?, self.times(other)?);
        Some(Quartiles::of(
            times.iter().zip(others).map(|(time, other)| time / other),
        ))
    }
}
