//! What stands in the picture of error against cost: samplers of one law beside each other, ours and the peers', with the
//! error of each and a block that can be timed. `benches/tradeoff.rs` records both, `cargo regenerate` draws what is recorded.
//!
//! Which samplers there are is said in `list`.

mod list;

use crate::contest::{POINTS, block_of, generator};
use crate::errors::raise;
use crate::truth::{Point, Uniforms};
pub use list::samplers;
use rand_pcg::Pcg32;
use std::hint::black_box;

pub struct Sampler {
    pub family: &'static str,
    pub name: &'static str,
    pub tier: &'static str,
    /// In `docs/measured/counts.csv`; empty where it runs on the host alone.
    pub kernel: String,
    /// How many calls make a sample of the family.
    pub calls: f64,
    /// The largest distance of a point from the exact one, over so many and over the edges.
    pub error: Box<dyn Fn(u64) -> f64>,
    /// Draws points one after the other.
    pub block: Box<dyn FnMut()>,
}

impl Sampler {
    fn new<P: Copy + Default + 'static>(
        [family, name, tier]: [&'static str; 3],
        kernel: impl Into<String>,
        draw: impl FnMut(&mut Pcg32) -> P + 'static,
        error: impl Fn(u64) -> f64 + 'static,
    ) -> Self {
        let (mut block, mut points) = (block_of(draw), vec![P::default(); POINTS]);
        Self {
            family,
            name,
            tier,
            kernel: kernel.into(),
            calls: 1.0,
            error: Box::new(error),
            block: Box::new(move || {
                block(black_box(&mut points));
                black_box(&points);
            }),
        }
    }

    /// What a row of the record begins with.
    pub fn key(&self) -> String {
        let (kernel, calls) = (&self.kernel, self.calls);
        [self.family, self.name, self.tier].join(",") + &format!(",{kernel},{calls}")
    }
}

/// The columns of `docs/measured/tradeoff.csv`: those of a key, and what is recorded.
pub const COLUMNS: &str = "family,sampler,tier,kernel,calls,error,ns";

/// 2⁻³².
const WORD: f64 = 1.0 / 4_294_967_296.0;

fn distance(a: Point, b: Point) -> f64 {
    (0..3).map(|k| (a[k] - b[k]).powi(2)).sum::<f64>().sqrt()
}

/// The largest distance of two points of uniforms of so many bits: over so many that lie evenly, and over all next to powers
/// of two, where maps change their form. Not-a-number counts as infinite.
fn sweep(bits: u32, axes: usize, points: u64, at: &dyn Fn(Uniforms) -> [Point; 2]) -> f64 {
    let mut largest = 0.0;
    let mut look = |words: [u32; 2]| {
        let [u, v] = words.map(|word| f64::from(word >> (32 - bits) << (32 - bits)) * WORD);
        let [exact, point] = at([u, v, 0.0, 0.0]);
        raise(&mut largest, distance(exact, point));
    };
    let lattice = lattice(axes);
    for k in 1..=points {
        look(lattice.map(|step| (step.wrapping_mul(k) >> 32) as u32));
    }
    let near = (0..=bits).flat_map(|k| [-1, 0, 1].map(|d| (1_i64 << k) + d));
    let edges: Vec<u32> = near.map(|number| (number << (32 - bits)) as u32).collect();
    for &first in &edges {
        for &second in if axes > 1 { &edges[..] } else { &[0] } {
            look([first, second]);
        }
    }
    largest
}

/// Steps whose multiples fill the square, or the line, more evenly than any generator's: inverse powers of the root of
/// x^(d + 1) = x + 1.
///
/// Source: M. Roberts, "The Unreasonable Effectiveness of Quasirandom Sequences", 2018.
fn lattice(axes: usize) -> [u64; 2] {
    let degree = axes as f64 + 1.0;
    let root = (0..64).fold(1.5, |root: f64, _| (1.0 + root).powf(1.0 / degree));
    // Odd, so that all words occur.
    [1, 2].map(|k| (root.powi(-k) / WORD / WORD) as u64 | 1)
}

/// The error of points that tell what they should have been, as far as they do.
fn repaired<const N: usize>(
    draw: impl Fn(&mut Pcg32) -> [f32; N],
    repair: fn(Point) -> Point,
) -> impl Fn(u64) -> f64 {
    move |points| {
        let (mut rng, mut largest) = (generator(), 0.0);
        for _ in 0..points {
            let x = flat(draw(&mut rng));
            raise(&mut largest, distance(x, repair(x)));
        }
        largest
    }
}

/// The coordinates of a point, of which missing ones are 0.
fn flat<T: Into<f64>, const N: usize>(x: [T; N]) -> Point {
    let mut x = x.into_iter().map(Into::into);
    std::array::from_fn(|_| x.next().unwrap_or(0.0))
}
