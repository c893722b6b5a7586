//! A sampler with its types erased, and what is known exactly about it.
//!
//! Which samplers there are is said in `list`.

use fixed::types::U0F32;
use fixed::types::extra::LeEqU32;
use fixed::{FixedI32, FixedU32};
use host::registry::Entry;
use host::truth::Truth;
use microwarp::uniform::{Uniforms, grid_from_word};
use rand_pcg::Pcg32;
use std::sync::Arc;

/// Up to three coordinates; missing ones are 0.
pub type Point = [f64; 3];

/// Points that `f64` holds as they are.
pub trait Exact: Copy + 'static {
    /// Some point.
    const BLANK: Self;
    fn exact(self) -> Point;
}

impl Exact for f32 {
    const BLANK: Self = 0.0;
    fn exact(self) -> Point {
        [self.into(), 0.0, 0.0]
    }
}

impl<Frac: LeEqU32 + 'static> Exact for FixedU32<Frac> {
    const BLANK: Self = Self::ZERO;
    fn exact(self) -> Point {
        [self.into(), 0.0, 0.0]
    }
}

impl<Frac: LeEqU32 + 'static> Exact for FixedI32<Frac> {
    const BLANK: Self = Self::ZERO;
    fn exact(self) -> Point {
        [self.into(), 0.0, 0.0]
    }
}

impl<T: Exact, const N: usize> Exact for [T; N] {
    const BLANK: Self = [T::BLANK; N];
    fn exact(self) -> Point {
        std::array::from_fn(|i| self.get(i).map_or(0.0, |x| x.exact()[0]))
    }
}

/// Up to four words; each is read as a uniform.
pub type Words = [u32; 4];

/// Uniforms that are made from words as a generator's are.
pub trait FromWords: Uniforms {
    /// The bits of a word that count, the upper ones.
    const BITS: u32;
    fn of(words: &[u32]) -> Self;
}

impl FromWords for f32 {
    const BITS: u32 = 24;
    fn of(words: &[u32]) -> Self {
        grid_from_word(words[0])
    }
}

impl FromWords for U0F32 {
    const BITS: u32 = 32;
    fn of(words: &[u32]) -> Self {
        Self::from_bits(words[0])
    }
}

impl<const N: usize> FromWords for [f32; N] {
    const BITS: u32 = <f32 as FromWords>::BITS;
    fn of(words: &[u32]) -> Self {
        std::array::from_fn(|i| f32::of(&words[i..]))
    }
}

impl<const N: usize> FromWords for [U0F32; N] {
    const BITS: u32 = <U0F32 as FromWords>::BITS;
    fn of(words: &[u32]) -> Self {
        std::array::from_fn(|i| U0F32::of(&words[i..]))
    }
}

/// Densities as `f64`, precise enough for any comparison.
pub trait Wide: Copy {
    fn wide(self) -> f64;
}

impl Wide for f32 {
    fn wide(self) -> f64 {
        self.into()
    }
}

impl Wide for microwarp::fixed::Density {
    fn wide(self) -> f64 {
        self.to_num()
    }
}

/// A point of words, and the density that is reported there, if any is.
pub type At = Box<dyn Fn(Words) -> (Point, Option<f64>) + Send + Sync>;
/// Draws points.
pub type Fill = Box<dyn Fn(&mut Pcg32, &mut [Point]) + Send + Sync>;
/// Draws a point, and the density that is reported there.
pub type Judged = Box<dyn Fn(&mut Pcg32) -> (Point, f64) + Send + Sync>;
/// Draws a block of points into memory of its own.
pub type Block = Box<dyn FnMut()>;

impl Law {
    /// Of a map that is one to one.
    pub fn new(truth: Arc<dyn Truth>, uniforms: usize) -> Self {
        Self {
            chart: truth.clone(),
            truth,
            uniforms,
            axes: uniforms,
            open: false,
        }
    }

    /// Whether the exact inverse leads back to where the exact map began: it does not where several uniforms make one
    /// number.
    pub fn inverts(&self) -> bool {
        let u = [0.3, 0.6, 0.0, 0.0];
        let back = self.truth.invert(self.truth.sample(u));
        (0..self.uniforms).all(|k| (back[k] - u[k]).abs() < 1e-9)
    }
}

/// What makes points out of uniforms, explicitly.
pub struct Map {
    /// Bits of a uniform.
    pub bits: u32,
    pub at: At,
}

/// What numbers the coordinates of a sampler are that is exact but for them.
#[derive(Clone, Copy)]
pub enum Numbers {
    Floats,
    /// Multiples of a step.
    Steps(f64),
}

impl Numbers {
    /// The one nearest to a number.
    pub fn nearest(self, x: f64) -> f64 {
        match self {
            Self::Floats => f64::from(x as f32),
            Self::Steps(step) => (x / step).round() * step,
        }
    }
}

/// The probabilities of an entry of a table.
#[derive(Clone, Copy)]
pub struct Chance {
    pub due: f64,
    pub realised: f64,
    /// Nothing of a table that reports none.
    pub reported: Option<f64>,
}

/// How the points come about.
pub enum Way {
    /// By a map of uniforms, which can be held against the exact one.
    Map(Map),
    /// By rejection, which is exact in law; its points are as good as the numbers that hold them.
    Rejection(Numbers),
    /// By rejection and by functions that are not exact: with the point that a drawn one should have been, as far as
    /// it tells by itself.
    Repaired(fn(Point) -> Point),
    /// By a table, which selects an entry with a probability that is known beside the one it should have.
    Table(Vec<Chance>),
    /// In a way that reveals only the points.
    Opaque,
}

/// The distribution that a sampler should have.
#[derive(Clone)]
pub struct Law {
    pub truth: Arc<dyn Truth>,
    /// How many uniforms a point takes.
    pub uniforms: usize,
    /// Some map onto the domain whose inverse is known, that of the law itself where it has one; and how many uniforms
    /// it takes.
    pub chart: Arc<dyn Truth>,
    pub axes: usize,
    /// Whether a uniform of 0 counts as 2^-149, as the documentation of the warp says.
    pub open: bool,
}

pub struct Sampler {
    pub family: &'static str,
    pub name: String,
    pub tier: &'static str,
    /// Whether it is this crate's.
    pub ours: bool,
    pub law: Law,
    pub way: Way,
    pub fill: Fill,
    /// Draws a point and the density that is reported there, where a map does not tell.
    pub judged: Option<Judged>,
    /// What it is called in `docs/measured/counts.csv`, and how many calls are a sample.
    pub kernel: String,
    pub calls: f64,
    /// What the registry knows of it.
    pub entry: Option<Arc<Entry>>,
}

impl Sampler {
    /// `"Disk poly"`.
    pub fn label(&self) -> String {
        format!("{} {}", self.name, self.tier)
    }

    /// Whether its error may be larger than what is seen of it.
    pub fn errs_at_least(&self) -> bool {
        matches!(self.way, Way::Repaired(_))
    }
}

/// A sampler with what is timed of it: one point after another, and a slice at once where there is a way.
pub struct Row {
    pub sampler: Sampler,
    pub draw: Block,
    pub fill: Option<Block>,
}
