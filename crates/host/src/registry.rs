//! The registry of the warps of both float tiers: every constructor once, with its exact counterpart, its cases, what it
//! refuses, its picture and its place in comparisons. Laws, measurements and pictures run over it and ask for no name.
//!
//! The files below hold a block a constructor; how a block is written is said at [`Registered`]. What runs on cores, without
//! a truth, is registered in `crates/list`.

mod composed;
mod directions;
pub mod evidence;
mod lights;
mod line;
pub mod picture;
mod plane;
pub mod power;
mod shapes;
mod surfaces;
pub mod tables;

use crate::adversary::words::Kind;
use crate::contest::{POINTS, generator};
use crate::generators::Cycle;
use crate::truth::Truth;
use evidence::{Control, Moment, Peer};
use microwarp::tier::{Libm, Poly, Tier};
use microwarp::uniform::Uniforms as _;
use microwarp::{Error, Invert};
use picture::{Picture, View};
use rand_pcg::Pcg32;
use std::any::type_name;
use std::collections::BTreeSet;
use std::fmt;
use std::hint::black_box;
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
    /// Points of space.
    Space,
    /// Points of space that three uniforms lead to.
    Solid,
    /// Unit quaternions of rotations: their x, y and z. w, which is not negative, is what they leave of the length.
    Rotations,
    /// Barycentric coordinates.
    Barycentric,
}

/// In what unit the error of a sample is stated.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Measure {
    /// Units in the last place of the exact value: relative accuracy everywhere.
    Ulp,
    /// Units in the last place of a fixed magnitude, for maps through 0.
    UlpOf(f64),
    /// Units in the last place of a mean, of the distance from it, or of a length, whichever is largest.
    UlpFrom(f64, f64),
    /// Units in the last place of the exact value, or of a magnitude where it is smaller than that.
    UlpAbove(f64),
    /// Euclidean distance in units of a length.
    Length(f64),
    /// Euclidean distance in the plane in units of the exact one from a point, or of that point's coordinates, but at least of
    /// the smallest normal number.
    From([f64; 2]),
}

impl Measure {
    /// The unit of [`Self::From`] at an exact point.
    pub fn far([a, b]: [f64; 2], [x, y, _]: [f64; 3]) -> f64 {
        let least = f64::from(f32::MIN_POSITIVE);
        (x - a).hypot(y - b).max(a.abs()).max(b.abs()).max(least)
    }
}

/// A warp whose types have been erased.
pub trait Erased: Send + Sync {
    fn sample(&self, u: Uniforms) -> Point;
    fn pdf(&self, x: Point) -> f32;
    fn sample_with_pdf(&self, u: Uniforms) -> (Point, f32) {
        let x = self.sample(u);
        (x, self.pdf(x))
    }
    fn invert(&self, x: Point) -> Uniforms;
    /// The fourth coordinate of a sample, for which a point has no room; 0 where there is none.
    fn fourth(&self, _: Uniforms) -> f32 {
        0.0
    }
    /// The point of a generator that yields this word again and again.
    fn drawn(&self, _: u32) -> Point {
        [f32::NAN; 3]
    }
    /// Draws through `Warp::fill`; `n` points.
    fn fill(&self, rng: &mut Pcg32, n: usize) -> Vec<Point>;
    /// Maps a slice: the points by `Warp::map`, then points and densities by `Warp::map_with_pdf`.
    fn map(&self, _: &[Uniforms]) -> (Vec<Point>, Vec<(Point, f32)>) {
        (Vec::new(), Vec::new())
    }
    /// A block of points in memory of its own, drawn one by one or filled: what takes time is this alone.
    fn block(&self, filled: bool) -> Box<dyn FnMut()>;
    /// One point of the generator by each way to draw it: what the way is, and the point.
    fn ways(&self, _rng: &Pcg32) -> Vec<(&'static str, Point)> {
        Vec::new()
    }
    /// One point of the generator and its density by each way to draw both: what the way is, the point and the density.
    fn ways_with_pdf(&self, _rng: &Pcg32) -> Vec<(&'static str, Point, f32)> {
        Vec::new()
    }
}

/// What says a place and the exact one.
pub type Place = dyn Fn(Uniforms) -> ([f32; 3], [f64; 3]) + Send + Sync;

/// One warp with its parameters in one tier.
pub struct Entry {
    pub name: &'static str,
    pub parameters: &'static str,
    pub tier: &'static str,
    /// Whether the type has a tier. What has none is one and the same in both.
    pub tiered: bool,
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
    /// Whether many uniforms give the same point.
    pub folds: bool,
    /// Whether the map is made of other warps, or of functions that are a user's.
    pub composed: bool,
    /// Whether the density that comes with a sample is another number than that of its point, with an error of its own.
    pub own_density: bool,
    /// Whether a draw reads its words more deeply than the grid.
    pub deep: bool,
    /// Whether a draw is held to the error of a sample at the exact middle of its word.
    pub middle: bool,
    /// Whether density and inverse are functions of a user's, which need not be total.
    pub closures: bool,
    /// Whether the last of several uniforms is an azimuth, of which 0 and 1 are the same.
    pub azimuth: bool,
    /// Whether a second uniform of 0 gives the direction of azimuth 0, so that sin θ and cos θ can be judged alone.
    pub polar: bool,
    /// Whether cos θ is judged in ulp: it passes through 0 otherwise.
    pub cosine: bool,
    pub ends: Ends,
    /// How far outside the unit square the exact inverse may place a point that was rounded.
    pub slack: f64,
    /// Whether neighbouring uniforms may give points that are far apart.
    pub jumps: bool,
    /// What holds for every point beside its place in the domain, exactly.
    pub inside: fn([f64; 3]) -> bool,
    /// Points outside the domain, where the density is 0; `None` where nobody has said which those are.
    pub outside: Option<&'static [Point]>,
    /// Walks along the rim of the domain, from the largest uniform and the other one.
    pub rims: &'static [fn(f32, f32) -> Uniforms],
    pub picture: Option<Picture>,
    pub trade: Option<Trade>,
    /// The place on a light that uniforms lead to, and the exact one.
    pub place: Option<Arc<Place>>,
    /// The density of all its points as a function gives it without the warp.
    pub alone: Option<f32>,
    pub warp: Arc<dyn Erased>,
    pub truth: Arc<dyn Truth>,
    /// Coordinates in the unit square in which cells for a test of shape are laid out: the inverse of
    /// some map onto the domain, not always that of the warp itself.
    pub chart: Arc<dyn Truth>,
    /// The parameters that the formulas of its documentation name.
    pub variables: Vec<(&'static str, f64)>,
}

/// What the samples of the first and of the last uniform are on the line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ends {
    /// The bounds of the domain.
    Bounds,
    /// Samples like others, which are rounded.
    Samples,
    /// Infinite.
    None,
}

/// Where a sampler stands in the picture of error against cost.
#[derive(Clone, Copy, Debug)]
pub struct Trade {
    /// The heading.
    pub family: &'static str,
    /// Its name in `docs/measured/counts.csv`, without the tier.
    pub kernel: &'static str,
}

/// `Disk poly`, `PhongLobe n=50 libm`.
impl fmt::Display for Entry {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let space = if self.parameters.is_empty() { "" } else { " " };
        f.pad(&format!(
            "{}{space}{} {}",
            self.name, self.parameters, self.tier
        ))
    }
}

impl Entry {
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

    /// Counts no smaller unit than one in the last place of this scale.
    fn or_scale(self, scale: f32) -> Self {
        self.with(|e| {
            if let Measure::UlpFrom(_, least) = &mut e.measure {
                *least = scale.into();
            }
        })
    }

    fn middle(self) -> Self {
        self.with(|e| e.middle = true)
    }

    /// Marks a warp whose draws read their words more deeply than the grid.
    fn deep(self) -> Self {
        self.with(|e| e.deep = true)
    }

    fn own_density(self) -> Self {
        self.with(|e| e.own_density = true)
    }

    /// The same of a law whose draws read their word more deeply than the grid.
    fn own_density_of_word(self) -> Self {
        self.own_density().with(|e| e.deep = true)
    }

    fn no_round_trip(self) -> Self {
        self.with(|e| e.round_trip = false)
    }

    fn outside(self, points: &'static [Point]) -> Self {
        self.with(|e| e.outside = Some(points))
    }

    fn picture(self, caption: &'static str, view: View) -> Self {
        self.with(|e| e.picture = Some(Picture { caption, view }))
    }

    fn trade(self, family: &'static str, kernel: &'static str) -> Self {
        self.with(|e| e.trade = Some(Trade { family, kernel }))
    }

    /// The value of a parameter of the formulas.
    pub fn variable(&self, name: &str) -> Option<f64> {
        let found = self.variables.iter().find(|(known, _)| *known == name);
        found.map(|(_, value)| *value)
    }
}

/// One constructor of a warp in one tier: everything that the host knows of it. All laws, measurements and pictures come
/// from here.
pub struct Registered {
    /// The struct, whose documentation states the errors.
    pub name: &'static str,
    pub tier: &'static str,
    /// What tells constructors of one struct apart.
    pub constructor: &'static str,
    /// What kinds of numbers it takes, one after the other.
    pub takes: &'static [Kind],
    /// The place of the constructor's parameter to which each number belongs; its own where nothing is said.
    pub parameters: &'static [usize],
    /// Pairs of numbers of which the smaller one comes first; who draws parameters puts them in order.
    pub ordered: &'static [[usize; 2]],
    /// The entry of these numbers, or why they are refused.
    pub build: fn(&[f32]) -> Result<Entry, Error>,
    /// The parameters under which every law runs: a label, the numbers, and what is particular to them.
    pub cases: Vec<Case>,
    /// Wrong maps that the examination of samples rejects.
    pub controls: Vec<Control>,
    pub moments: Vec<Moment>,
    pub peers: Vec<Peer>,
    /// Accepted parameters where the search for the worst case starts: hard ones, and the extremes.
    pub seeds: Vec<Vec<f32>>,
    pub refused: Vec<(Vec<f32>, Error)>,
    /// What was made at run time, and the constant of the same parameters.
    pub constants: Vec<[String; 2]>,
    /// What the getters give back of parameters: the same.
    pub given_back: Option<Getters>,
    /// What it does without, and why.
    pub without: Vec<(&'static str, &'static str)>,
}

/// What the getters give back of parameters.
pub type Getters = fn(&[f32]) -> Result<Vec<f32>, Error>;

/// A label, the numbers, and what is particular to them.
pub type Case = (&'static str, Vec<f32>, fn(Entry) -> Entry);

/// What a constructor makes at run time, and the constant of the same parameters. The shortest digits tell every number,
/// and every zero from its opposite.
macro_rules! in_both {
    ($name:ident $(<$tier:ty>)? :: $constructor:ident ( $($x:expr),* )) => {{
        let at_run_time = $name$(::<$tier>)?::$constructor($(std::hint::black_box($x)),*);
        let constant = const { $name$(::<$tier>)?::$constructor($($x),*) };
        [format!("{at_run_time:?}"), format!("{constant:?}")]
    }};
}
use in_both;

/// The ends of a box as its parameters have them: both of one side, then of the next.
fn ends<const N: usize>(low: [f32; N], high: [f32; N]) -> Vec<f32> {
    let sides = low.into_iter().zip(high);
    sides.flat_map(|(low, high)| [low, high]).collect()
}

/// Nothing particular.
const PLAIN: fn(Entry) -> Entry = |entry| entry;

impl Registered {
    pub fn new(
        name: &'static str,
        constructor: &'static str,
        takes: &'static [Kind],
        build: fn(&[f32]) -> Result<Entry, Error>,
    ) -> Self {
        Self {
            name,
            tier: "",
            constructor,
            takes,
            parameters: &[],
            ordered: &[],
            build,
            cases: Vec::new(),
            controls: Vec::new(),
            moments: Vec::new(),
            peers: Vec::new(),
            seeds: Vec::new(),
            refused: Vec::new(),
            constants: Vec::new(),
            given_back: None,
            without: Vec::new(),
        }
    }

    fn case(self, label: &'static str, parameters: &[f32]) -> Self {
        self.case_with(label, parameters, PLAIN)
    }

    fn case_with(
        mut self,
        label: &'static str,
        parameters: &[f32],
        change: fn(Entry) -> Entry,
    ) -> Self {
        self.cases.push((label, parameters.to_vec(), change));
        self
    }

    fn parameters(mut self, places: &'static [usize]) -> Self {
        self.parameters = places;
        self
    }

    /// The place of the parameter to which a number belongs.
    pub fn parameter(&self, number: usize) -> usize {
        self.parameters.get(number).copied().unwrap_or(number)
    }

    fn ordered(mut self, pairs: &'static [[usize; 2]]) -> Self {
        self.ordered = pairs;
        self
    }

    fn seed(mut self, parameters: &[f32]) -> Self {
        self.seeds.push(parameters.to_vec());
        self
    }

    fn refuse(mut self, parameters: &[f32], error: Error) -> Self {
        self.refused.push((parameters.to_vec(), error));
        self
    }

    fn constant(mut self, made: [String; 2]) -> Self {
        self.constants.push(made);
        self
    }

    fn gives_back(mut self, getters: Getters) -> Self {
        self.given_back = Some(getters);
        self
    }

    fn without(mut self, what: &'static str, why: &'static str) -> Self {
        self.without.push((what, why));
        self
    }

    /// The entry of numbers as they are drawn.
    pub fn of_drawn(&self, numbers: &[f32]) -> Result<Entry, Error> {
        let mut numbers = numbers.to_vec();
        for &[low, high] in self.ordered {
            let ends = [numbers[low], numbers[high]];
            (numbers[low], numbers[high]) = (ends[0].min(ends[1]), ends[0].max(ends[1]));
        }
        (self.build)(&numbers)
    }

    /// The entries of all cases.
    pub fn entries(&self) -> impl Iterator<Item = Entry> {
        self.cases.iter().map(|(label, parameters, change)| {
            let entry = (self.build)(parameters);
            let mut entry =
                entry.unwrap_or_else(|error| panic!("{} {label}: {error:?}", self.name));
            entry.parameters = label;
            change(entry)
        })
    }
}

/// Arrays of up to N numbers, as the erased table holds them.
pub trait Flat<const N: usize>: Copy + 'static {
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
        // A coordinate that has no room is what the others leave of a quaternion's length.
        let left = 1.0 - flat.iter().map(|c| f64::from(*c).powi(2)).sum::<f64>();
        std::array::from_fn(|i| flat.get(i).copied().unwrap_or(left.max(0.0).sqrt() as f32))
    }
}

/// Shares and the rest, which follows from them where it has no room.
impl<const M: usize, const N: usize> Flat<N> for ([f32; M], f32) {
    fn flat(self) -> [f32; N] {
        std::array::from_fn(|i| match i {
            i if i < M => self.0[i],
            i if i == M => self.1,
            _ => 0.0,
        })
    }
    fn unflat(flat: [f32; N]) -> Self {
        let shares = std::array::from_fn(|i| flat[i]);
        let left = 1.0 - shares.iter().map(|x: &f32| f64::from(*x)).sum::<f64>();
        (shares, flat.get(M).copied().unwrap_or(left.max(0.0) as f32))
    }
}

/// Compiled once for all warps of one kind of points, here and below.
#[inline(never)]
fn flat_all<P: Flat<N>, const N: usize>(all: &[P]) -> Vec<[f32; N]> {
    all.iter().map(|x| x.flat()).collect()
}

#[inline(never)]
fn unflat_all<P: Flat<N>, const N: usize>(all: &[[f32; N]]) -> Vec<P> {
    all.iter().map(|x| P::unflat(*x)).collect()
}

/// A way to draw, and what it gave.
#[inline(never)]
fn told<P: Flat<3>>(way: &'static str, (x, density): (P, f32)) -> (&'static str, Point, f32) {
    (way, x.flat(), density)
}

/// Erases the types of a warp.
pub fn erased<W>(warp: W) -> Arc<dyn Erased>
where
    W: Invert<Density = f32> + Send + Sync + 'static,
    W::Uniforms: Flat<4>,
    W::Point: Flat<3> + Flat<4> + 'static,
{
    Arc::new(Wrapped(Arc::new(warp)))
}

struct Wrapped<W>(Arc<W>);

impl<W> Erased for Wrapped<W>
where
    W: Invert<Density = f32> + Send + Sync + 'static,
    W::Uniforms: Flat<4>,
    W::Point: Flat<3> + Flat<4> + 'static,
{
    fn sample(&self, u: Uniforms) -> Point {
        self.0.sample(W::Uniforms::unflat(u)).flat()
    }
    fn pdf(&self, x: Point) -> f32 {
        self.0.pdf(W::Point::unflat(x))
    }
    fn sample_with_pdf(&self, u: Uniforms) -> (Point, f32) {
        let (x, density) = self.0.sample_with_pdf(W::Uniforms::unflat(u));
        (x.flat(), density)
    }
    fn invert(&self, x: Point) -> Uniforms {
        self.0.invert(W::Point::unflat(x)).flat()
    }
    fn fourth(&self, u: Uniforms) -> f32 {
        let all: [f32; 4] = self.0.sample(W::Uniforms::unflat(u)).flat();
        all[3]
    }
    fn drawn(&self, word: u32) -> Point {
        self.0.draw(&mut Cycle::new(&[word])).flat()
    }
    fn fill(&self, rng: &mut Pcg32, n: usize) -> Vec<Point> {
        let mut points = unflat_all(&vec![[0.0; 3]; n]);
        self.0.fill(rng, &mut points);
        flat_all(&points)
    }
    fn map(&self, u: &[Uniforms]) -> (Vec<Point>, Vec<(Point, f32)>) {
        let (u, nowhere) = (unflat_all(u), vec![[0.0; 3]; u.len()]);
        let [mut points, mut same] = [unflat_all(&nowhere), unflat_all(&nowhere)];
        self.0.map(&u, &mut points);
        let mut densities = vec![-1.0; u.len()];
        self.0.map_with_pdf(&u, &mut same, &mut densities);
        let same = flat_all(&same).into_iter().zip(densities);
        (flat_all(&points), same.collect())
    }
    fn block(&self, filled: bool) -> Box<dyn FnMut()> {
        let (warp, mut kept) = (Arc::clone(&self.0), generator());
        let mut points: Vec<W::Point> = unflat_all(&[[0.0; 3]; POINTS]);
        Box::new(move || {
            let mut rng = kept.clone();
            if filled {
                warp.fill(&mut rng, black_box(&mut points));
            } else {
                for point in black_box(&mut points) {
                    *point = warp.draw(&mut rng);
                }
            }
            kept = rng;
            black_box(&points);
        })
    }
    fn ways_with_pdf(&self, rng: &Pcg32) -> Vec<(&'static str, Point, f32)> {
        let one = self.0.draw_with_pdf(&mut rng.clone());
        let mut filled = [one; 3];
        self.0.fill_with_pdf(&mut rng.clone(), &mut filled);
        let words = W::Uniforms::try_words(&mut rng.clone()).unwrap();
        let u = W::Uniforms::from_words(words);
        let sampled = self.0.sample_canonical_with_pdf(u);
        vec![
            told("drawn", one),
            told("filled", filled[0]),
            told("sampled", sampled),
        ]
    }
    fn ways(&self, rng: &Pcg32) -> Vec<(&'static str, Point)> {
        let words = W::Uniforms::try_words(&mut rng.clone()).unwrap();
        // One of a block, of what is left of one, and alone.
        let filled = |n| self.fill(&mut rng.clone(), n)[0];
        vec![
            ("drawn", self.0.draw(&mut rng.clone()).flat()),
            ("filled", filled(9)),
            ("filled alone", filled(1)),
            ("of words", self.0.sample_words(words).flat()),
        ]
    }
}

/// An entry of a warp and its truth; what is particular to it is said by the methods of [`Entry`].
pub fn entry<T: Tier, W>(
    name: &'static str,
    domain: Domain,
    measure: Measure,
    warp: W,
    truth: impl Into<Arc<dyn Truth>>,
) -> Entry
where
    W: Invert<Density = f32> + Send + Sync + 'static,
    W::Uniforms: Flat<4>,
    W::Point: Flat<3> + Flat<4>,
{
    let of = Erasure {
        tier: T::NAME,
        tiered: type_name::<W>().contains(type_name::<T>()),
        uniforms: <W::Uniforms as microwarp::uniform::Uniforms>::COUNT,
        warp: erased(warp),
    };
    of.entry(name, domain, measure, truth.into())
}

/// What is left of the types of an entry.
struct Erasure {
    tier: &'static str,
    tiered: bool,
    uniforms: usize,
    warp: Arc<dyn Erased>,
}

impl Erasure {
    fn entry(
        self,
        name: &'static str,
        domain: Domain,
        measure: Measure,
        truth: Arc<dyn Truth>,
    ) -> Entry {
        let first = truth.sample([0.0; 4]);
        let density = truth.pdf(first);
        let usable = density > 0.0 && density < f64::INFINITY;
        let turned = matches!(domain, Domain::Directions | Domain::World);
        Entry {
            name,
            parameters: "",
            tier: self.tier,
            tiered: self.tiered,
            domain,
            uniforms: self.uniforms,
            words: self.uniforms,
            measure,
            resolved: true,
            round_trip: true,
            open: !usable && (first[0] <= 0.0 || domain != Domain::Line),
            folds: false,
            composed: false,
            own_density: false,
            deep: false,
            middle: false,
            closures: false,
            azimuth: turned,
            polar: domain == Domain::Directions,
            cosine: true,
            ends: Ends::Bounds,
            slack: if domain == Domain::Line {
                f64::INFINITY
            } else {
                2e-6
            },
            jumps: false,
            inside: |_| true,
            outside: None,
            rims: &[],
            picture: None,
            trade: None,
            place: None,
            alone: None,
            warp: self.warp,
            chart: Arc::clone(&truth),
            truth,
            variables: Vec::new(),
        }
    }
}

/// Every constructor of every warp: in both tiers where it has one, otherwise once, beside those of `poly`.
pub fn registered() -> Vec<Registered> {
    let mut all = of_libm();
    let tiered: BTreeSet<&str> = all
        .iter()
        .filter(|of| of.entries().any(|entry| entry.tiered))
        .map(|of| of.name)
        .collect();
    all.retain(|of| tiered.contains(of.name));
    all.extend(of_poly());
    all
}

/// Every constructor of every warp in the tier `libm`, compiled here and nowhere else.
pub fn of_libm() -> Vec<Registered> {
    of_tier::<Libm>()
}

/// The same in `poly`.
pub fn of_poly() -> Vec<Registered> {
    of_tier::<Poly>()
}

/// Every constructor of every warp in one tier.
fn of_tier<T: Tier>() -> Vec<Registered> {
    let mut all = line::registered::<T>();
    all.extend(power::registered::<T>());
    all.extend(composed::registered::<T>());
    all.extend(plane::registered::<T>());
    all.extend(shapes::registered::<T>());
    all.extend(directions::registered::<T>());
    all.extend(lights::registered::<T>());
    all.extend(tables::registered::<T>());
    all.extend(surfaces::registered::<T>());
    for of in &mut all {
        of.tier = T::NAME;
    }
    all
}

/// Every warp at comfortable and at extreme parameters, in both tiers where it has one.
pub fn entries() -> Vec<Entry> {
    entries_of(&registered())
}

fn entries_of(all: &[Registered]) -> Vec<Entry> {
    all.iter().flat_map(Registered::entries).collect()
}

/// The same in each tier, whether it has one or not: for what lays the tiers side by side.
pub fn entries_of_each_tier() -> Vec<Entry> {
    [of_libm(), of_poly()]
        .iter()
        .flat_map(|all| entries_of(all))
        .collect()
}
