//! The one table that lists every warp, in both tiers, with its exact counterpart.
//!
//! Every law runs over the whole table, so a new warp is one line here (and a truth in `truth.rs`).
//! What the laws are is not said here: see the files in `tests/`.

pub mod directions;
pub mod discrete;
pub mod line;
pub mod plane;

use crate::truth::Truth;
use microwarp::tier::{Libm, Poly, Tier};
use microwarp::uniform::Uniforms as _;
use microwarp::{Transform, Warp};
use rand_pcg::Pcg32;
use std::sync::Arc;

/// Up to four uniforms; those a warp does not take are 0.
pub type Uniforms = [f32; 4];
/// Up to three coordinates; those a point does not have are 0.
pub type Point = [f32; 3];

/// What kind of space a warp's points lie in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Domain {
    /// The real line.
    Line,
    /// The plane.
    Plane,
    /// Unit vectors, in local coordinates about +z.
    Directions,
    /// Unit vectors in world coordinates.
    World,
    /// Points of space, or barycentric coordinates.
    Space,
}

/// In what unit the error of a sample is stated.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Measure {
    /// Units in the last place of the exact value: relative accuracy everywhere.
    Ulp,
    /// Units in the last place of a fixed magnitude, for maps through 0.
    UlpOf(f64),
    /// Units in the last place of a mean or of the distance from it, whichever is larger.
    UlpFrom(f64),
    /// Euclidean distance in units of a length.
    Length(f64),
}

/// A warp whose types have been erased.
pub trait Erased: Send + Sync {
    fn sample(&self, u: Uniforms) -> Point;
    fn pdf(&self, x: Point) -> f32;
    fn invert(&self, x: Point) -> Uniforms;
    /// Draws through `Warp::fill`; `n` points.
    fn fill(&self, rng: &mut Pcg32, n: usize) -> Vec<Point>;
    /// One point of the generator by each way to draw it: what the way is, and the point.
    fn ways(&self, _rng: &Pcg32) -> Vec<(&'static str, Point)> {
        Vec::new()
    }
}

/// One warp with its parameters in one tier.
pub struct Entry {
    pub name: &'static str,
    pub parameters: &'static str,
    pub tier: &'static str,
    pub domain: Domain,
    /// How many uniforms a sample takes.
    pub uniforms: usize,
    /// How many `u32` of a generator a draw takes.
    pub words: usize,
    pub measure: Measure,
    /// Whether `f32` resolves the distribution well enough for a test of its shape.
    pub resolved: bool,
    /// Whether u is recovered by the round trip, which parameters that `f32` barely resolves prevent.
    pub round_trip: bool,
    /// Whether u = 0 counts as 2^-149, as the documentation of the warp says.
    pub open: bool,
    pub warp: Arc<dyn Erased>,
    pub truth: Arc<dyn Truth>,
    /// Coordinates in the unit square in which cells for a test of shape are laid out: the inverse of
    /// some map onto the domain, not always that of the warp itself.
    pub chart: Arc<dyn Truth>,
    /// The parameters that the formulas of its documentation name.
    pub variables: Vec<(&'static str, f64)>,
}

impl Entry {
    /// `"Disk poly"`, `"PhongLobe n=50 libm"`.
    pub fn label(&self) -> String {
        let space = if self.parameters.is_empty() { "" } else { " " };
        format!("{}{space}{} {}", self.name, self.parameters, self.tier)
    }

    fn with(mut self, change: impl FnOnce(&mut Self)) -> Self {
        change(&mut self);
        self
    }

    fn chart(self, chart: impl Into<Arc<dyn Truth>>) -> Self {
        let chart = chart.into();
        self.with(|e| e.chart = chart)
    }

    /// Marks parameters whose spread `f32` barely resolves.
    fn unresolved(self) -> Self {
        self.with(|e| {
            e.resolved = false;
            e.round_trip = false;
        })
    }

    pub fn variables(self, variables: &[(&'static str, f64)]) -> Self {
        self.with(|e| e.variables = variables.to_vec())
    }

    fn words(self, words: usize) -> Self {
        self.with(|e| e.words = words)
    }

    fn no_round_trip(self) -> Self {
        self.with(|e| e.round_trip = false)
    }
}

/// Arrays of up to N numbers, as the erased table holds them.
pub trait Flat<const N: usize>: Copy {
    fn flat(self) -> [f32; N];
    fn unflat(flat: [f32; N]) -> Self;
}

impl<const N: usize> Flat<N> for f32 {
    fn flat(self) -> [f32; N] {
        std::array::from_fn(|i| if i == 0 { self } else { 0.0 })
    }
    fn unflat(flat: [f32; N]) -> Self {
        flat[0]
    }
}

impl<const M: usize, const N: usize> Flat<N> for [f32; M] {
    fn flat(self) -> [f32; N] {
        std::array::from_fn(|i| if i < M { self[i] } else { 0.0 })
    }
    fn unflat(flat: [f32; N]) -> Self {
        std::array::from_fn(|i| flat[i])
    }
}

struct Wrapped<W>(W);

impl<W> Erased for Wrapped<W>
where
    W: Warp<Density = f32> + Send + Sync,
    W::Uniforms: Flat<4>,
    W::Point: Flat<3>,
{
    fn sample(&self, u: Uniforms) -> Point {
        self.0.sample(W::Uniforms::unflat(u)).flat()
    }
    fn pdf(&self, x: Point) -> f32 {
        self.0.pdf(W::Point::unflat(x))
    }
    fn invert(&self, x: Point) -> Uniforms {
        self.0.invert(W::Point::unflat(x)).flat()
    }
    fn fill(&self, rng: &mut Pcg32, n: usize) -> Vec<Point> {
        let mut points = vec![W::Point::unflat([0.0; 3]); n];
        self.0.fill(rng, &mut points);
        points.into_iter().map(Flat::flat).collect()
    }
    fn ways(&self, rng: &Pcg32) -> Vec<(&'static str, Point)> {
        let words = || W::Uniforms::try_words(&mut rng.clone()).unwrap();
        // One of a block, of what is left of one, and alone.
        let filled = |n| self.fill(&mut rng.clone(), n)[0];
        let same = Transform::new(&self.0, |x| x, |x| x, |_| 1.0);
        let mut through = [same.draw(&mut rng.clone()); 9];
        same.fill(&mut rng.clone(), &mut through);
        vec![
            ("drawn", self.0.draw(&mut rng.clone()).flat()),
            ("filled", filled(9)),
            ("filled alone", filled(1)),
            ("by reference", (&&self.0).draw(&mut rng.clone()).flat()),
            ("transformed", same.draw(&mut rng.clone()).flat()),
            ("transformed, filled", through[0].flat()),
            ("of words", self.0.sample_words(words()).flat()),
            (
                "of words, by reference",
                (&&self.0).sample_words(words()).flat(),
            ),
            ("of words, transformed", same.sample_words(words()).flat()),
        ]
    }
}

pub fn entry<T: Tier, W>(
    name: &'static str,
    parameters: &'static str,
    domain: Domain,
    measure: Measure,
    warp: W,
    truth: impl Into<Arc<dyn Truth>>,
) -> Entry
where
    W: Warp<Density = f32> + Send + Sync + 'static,
    W::Uniforms: Flat<4>,
    W::Point: Flat<3>,
{
    let truth = truth.into();
    let first = truth.sample([0.0; 4]);
    let density = truth.pdf(first);
    let usable = density > 0.0 && density < f64::INFINITY;
    let uniforms = <W::Uniforms as microwarp::uniform::Uniforms>::COUNT;
    Entry {
        name,
        parameters,
        tier: T::NAME,
        domain,
        uniforms,
        words: uniforms,
        measure,
        resolved: true,
        round_trip: true,
        open: !usable
            && (first[0] <= 0.0 || domain != Domain::Line)
            && name != "TruncatedExponential",
        warp: Arc::new(Wrapped(warp)),
        chart: Arc::clone(&truth),
        truth,
        variables: Vec::new(),
    }
}

/// Every warp at comfortable and at extreme parameters, in both tiers.
pub fn entries() -> Vec<Entry> {
    let mut all = of_tier::<Libm>();
    all.extend(of_tier::<Poly>());
    all
}

fn of_tier<T: Tier>() -> Vec<Entry> {
    let mut table = line::entries::<T>();
    table.extend(plane::entries::<T>());
    table.extend(directions::entries::<T>());
    table.extend(discrete::entries::<T>());
    table
}
