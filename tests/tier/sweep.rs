//! The inputs over which a function is measured, as numbered lists that threads can share.

use host::speed;
use rand_core::{Rng, SeedableRng};
use rand_pcg::Pcg32;

/// Inputs of a function of one or two arguments; where there is one, it is the first.
pub type Input = (f32, f32);

#[derive(Clone, Copy, Debug)]
pub enum Sweep {
    /// Every k/2^24 from 0 to 1, times the sign and size of a factor.
    Grid(f32),
    /// From one magnitude to another in steps of so many units in the last place, with a sign.
    Magnitudes {
        from: f32,
        to: f32,
        step: u32,
        sign: f32,
    },
    /// So many pairs at random: the arguments' bits uniform between those of the given magnitudes, the
    /// second argument with either sign.
    Pairs {
        x: [f32; 2],
        y: [f32; 2],
        count: u32,
    },
    /// So many powers x^y at random with x from the magnitudes and |y ln x| up to 104, half of them within
    /// a factor 2 of it.
    Powers { x: [f32; 2], count: u32 },
    /// All pairs of edge values.
    Edges,
}

/// Where functions tend to break, all of them finite.
pub const EDGES: [f32; 17] = [
    0.0,
    1.0e-45,
    5.877_472e-39,
    1.175_494_2e-38,
    f32::MIN_POSITIVE,
    5.960_464_5e-8,
    1.192_092_9e-7,
    0.5,
    1.0 - 5.960_464_5e-8,
    1.0,
    1.0 + 1.192_092_9e-7,
    2.0,
    16_777_215.0,
    16_777_216.0,
    8_388_607.5,
    1.0e30,
    f32::MAX,
];

const CHUNK: u32 = 1 << 16;

impl Sweep {
    fn len(self) -> u32 {
        match self {
            Sweep::Grid(_) => (1 << 24) + 1,
            Sweep::Magnitudes { from, to, step, .. } => (to.to_bits() - from.to_bits()) / step + 2,
            Sweep::Pairs { count, .. } | Sweep::Powers { count, .. } => count,
            Sweep::Edges => (EDGES.len() * EDGES.len() * 4) as u32,
        }
    }

    pub fn chunks(self) -> u32 {
        self.len().div_ceil(CHUNK)
    }

    /// One of how many inputs is tried: fewer of those at random and of far ones, of which there are fewer.
    pub fn stride(self) -> usize {
        match self {
            Sweep::Grid(_) | Sweep::Magnitudes { step: 1, .. } => {
                speed::of("one neighbour tried of every", 29, 1)
            }
            Sweep::Magnitudes { .. } | Sweep::Pairs { .. } | Sweep::Powers { .. } => {
                speed::of("one other input tried of every", 7, 1)
            }
            Sweep::Edges => 1,
        }
    }

    /// Hands one of every `stride` inputs of a chunk to `each`.
    pub fn for_each(self, chunk: u32, stride: usize, mut each: impl FnMut(Input)) {
        let mut rng = Pcg32::seed_from_u64(u64::from(chunk) + 1);
        let mut magnitude = |[from, to]: [f32; 2]| {
            let span = to.to_bits() - from.to_bits();
            f32::from_bits(from.to_bits() + (rng.next_u64() % u64::from(span + 1)) as u32)
        };
        let start = chunk * CHUNK;
        for i in (start..self.len().min(start + CHUNK)).step_by(stride) {
            each(match self {
                Sweep::Grid(factor) => (factor * (i as f32 / 16_777_216.0), 0.0),
                Sweep::Magnitudes {
                    from,
                    to,
                    step,
                    sign,
                } => {
                    let bits = from.to_bits() + (i * step).min(to.to_bits() - from.to_bits());
                    (sign * f32::from_bits(bits), 0.0)
                }
                Sweep::Pairs { x, y, .. } => {
                    let (x, y) = (magnitude(x), magnitude(y));
                    // Four signs in turn.
                    let sign = |bit: u32| if i & bit == 0 { 1.0 } else { -1.0 };
                    (sign(2) * x, sign(1) * y)
                }
                Sweep::Powers { x, .. } => {
                    let x = magnitude(x);
                    let size = if i & 1 == 0 {
                        [52.0, 104.0]
                    } else {
                        [1.0e-6, 104.0]
                    };
                    let y = (f64::from(magnitude(size)) / f64::from(x).ln()) as f32;
                    (x, if i & 2 == 0 { y } else { -y })
                }
                Sweep::Edges => {
                    let i = i as usize;
                    let n = EDGES.len();
                    let sign = |bit: usize| if i & bit == 0 { 1.0 } else { -1.0 };
                    (sign(1) * EDGES[i / 4 % n], sign(2) * EDGES[i / 4 / n])
                }
            });
        }
    }
}
