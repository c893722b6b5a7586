//! Where the words come from: a generator, strata, or a sequence of low discrepancy; and a record of them.

use core::convert::Infallible;
use microwarp::uniform::{Strata1d, Strata2d};
use rand_core::{Rng, TryRng};
use rand_pcg::Pcg32;

/// Words for one point after another. A plan lays out the first dimensions of a point; all further words are random.
pub struct Words {
    rng: Pcg32,
    plan: Plan,
    dimensions: usize,
    /// Which point it is, and how many of its words have been drawn.
    index: u32,
    drawn: usize,
    /// The second coordinate of a stratum of the square, drawn with the first.
    pending: u32,
    /// The last words, the latest last.
    last: [u32; 4],
}

enum Plan {
    Random,
    Line(Strata1d),
    Square(Strata2d),
    /// A step and a start for each dimension.
    Sequence([(u32, u32); 4]),
}

impl Words {
    /// Words for `count` points by a plan: random (0), strata (1), a sequence (2).
    pub fn new(plan: u32, dimensions: u32, count: u32, seed: u32) -> Self {
        let mut rng = Pcg32::new(seed.into(), 54);
        let plan = match (plan, dimensions) {
            (1, 2) => square(count).map_or(Plan::Random, Plan::Square),
            (1, _) => Strata1d::new(count).map_or(Plan::Random, Plan::Line),
            (2, _) => Plan::Sequence(steps(dimensions).map(|step| (step, rng.next_u32()))),
            _ => Plan::Random,
        };
        Self {
            rng,
            plan,
            dimensions: dimensions.min(4) as usize,
            index: 0,
            drawn: 0,
            pending: 0,
            last: [0; 4],
        }
    }

    /// Moves on to the next point.
    pub fn advance(&mut self) {
        self.index = self.index.wrapping_add(1);
        self.drawn = 0;
        self.last = [0; 4];
    }

    pub fn last(&self) -> [u32; 4] {
        self.last
    }

    fn planned(&mut self) -> u32 {
        let axis = self.drawn;
        let index = self.index;
        match &self.plan {
            Plan::Random => self.rng.next_u32(),
            Plan::Line(strata) => {
                // Odd factors permute the strata where their number is a power of two, each axis in its own way.
                let factor = [1, 0x9e37_79b1, 0x85eb_ca77, 0xc2b2_ae3d]
                    .get(axis)
                    .copied();
                let place = index.wrapping_mul(factor.unwrap_or(1));
                let u = strata.draw(place, &mut self.rng);
                self.word(u)
            }
            Plan::Square(strata) => {
                if axis == 0 {
                    let [u, v] = strata.draw(index, &mut self.rng);
                    self.pending = self.word(v);
                    self.word(u)
                } else {
                    self.pending
                }
            }
            Plan::Sequence(axes) => axes.get(axis).map_or(0, |(step, start)| {
                start.wrapping_add(step.wrapping_mul(index))
            }),
        }
    }

    /// A word of the cell that this is the middle of: from 2⁻⁹ up it has 2⁹ of them, below one.
    fn word(&mut self, u: f32) -> u32 {
        let first = (u * 4_294_967_296.0) as u32;
        if u < 1.0 / 512.0 {
            first
        } else {
            first >> 9 << 9 | self.rng.next_u32() >> 23
        }
    }
}

/// As many strata as points, as nearly square as a power of two allows.
fn square(count: u32) -> Option<Strata2d> {
    let rows = 1_u32.wrapping_shl(count.max(1).ilog2().wrapping_shr(1));
    Strata2d::new(count.checked_div(rows)?, rows).ok()
}

/// The steps of an additive recurrence in so many dimensions: the powers of the root g of g^(d + 1) = g + 1.
///
/// Source: M. Roberts, "The Unreasonable Effectiveness of Quasirandom Sequences", 2018.
fn steps(dimensions: u32) -> [u32; 4] {
    let root: f64 = match dimensions {
        0 | 1 => 1.618_033_988_749_895,
        2 => 1.324_717_957_244_746,
        3 => 1.220_744_084_605_76,
        _ => 1.167_303_978_261_418_7,
    };
    let mut power = 1.0;
    [(); 4].map(|()| {
        power /= root;
        (power * 4_294_967_296.0) as u32
    })
}

impl TryRng for Words {
    type Error = Infallible;

    fn try_next_u32(&mut self) -> Result<u32, Infallible> {
        let word = if self.drawn < self.dimensions {
            self.planned()
        } else {
            self.rng.next_u32()
        };
        self.drawn = self.drawn.wrapping_add(1);
        let [_, a, b, c] = self.last;
        self.last = [a, b, c, word];
        Ok(word)
    }

    fn try_next_u64(&mut self) -> Result<u64, Infallible> {
        let low = self.next_u32();
        Ok(u64::from(self.next_u32()) << 32 | u64::from(low))
    }

    fn try_fill_bytes(&mut self, bytes: &mut [u8]) -> Result<(), Infallible> {
        for chunk in bytes.chunks_mut(4) {
            for (byte, drawn) in chunk.iter_mut().zip(self.next_u32().to_le_bytes()) {
                *byte = drawn;
            }
        }
        Ok(())
    }
}
