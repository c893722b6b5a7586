//! The subjects and the inputs of the golden table. The warps stand in `warps.rs`.

use crate::cases::Golden;
use crate::{chains, counts, gammas, integers, lamps, orders};
use core::hint::black_box;
use microwarp::discrete::{
    Alias, AliasEntry, Cdf, InvertParts, LatLongMap, Mesh, MeshPoint, Mixture, Parts,
    PiecewiseConstant1d, PiecewiseConstant2d, PiecewiseLinear1d, PixelSample, Reservoir, Selection,
    SignedLinear1d, filter, select_once, select_once_uniform,
};
use microwarp::estimate::{Integral, Moments, WeightedMean, balance_heuristic, power_heuristic};
use microwarp::rejection::{
    Accepted, BallRejection, BinomialRejection, Bounded, DiskRejection, Failure,
    HypergeometricRejection, PoissonRejection, Region, Rejection, SLACK, VonMises,
    ZigguratExponential, ZigguratNormal, ZigguratStandardExponential, ZigguratStandardNormal,
    budget_for,
};
use microwarp::uniform::{
    self, ByPosition, Canonical, Points, Recurrence, Sobol, Strata1d, Strata2d, Uniforms,
};
use microwarp::warp::*;
use microwarp::{Error, Invert, Warp, warp::Frame};
use rand_core::{Rng, TryRng};
use rand_pcg::Pcg32;

/// Uniforms in and out of range; warps take as many of the four as they need.
pub const UNIFORMS: [[f32; 4]; 12] = [
    [0.0, 0.0, 0.0, 0.0],
    [0.125, 0.625, 0.375, 0.875],
    [0.25, 0.75, 0.5, 0.1],
    [0.5, 0.5, 0.5, 0.5],
    [0.499_999_97, 0.500_000_06, 0.123, 0.456],
    [0.900_000_04, 0.3, 0.7, 0.2],
    [0.999_999_94, 0.999_999_94, 0.999_999_94, 0.999_999_94],
    [5.960_464_5e-8, 0.249_999_99, 1e-3, 0.01],
    [1e-20, 0.333_333_34, 1e-45, 0.6],
    [f32::NAN, f32::INFINITY, -1.0, 7.0],
    [1.0, 1.0, 1.0, 1.0],
    [0.734_375, 0.015_625, 0.031_25, 0.062_5],
];

/// Draws from a generator, after the fixed uniforms.
const SEEDS: usize = 4;

/// How many inputs each subject is evaluated on.
pub const INPUTS: usize = UNIFORMS.len() + SEEDS;

/// The words a case yields; those that do not fit are dropped, and the host's test notices.
pub struct Out<'a> {
    words: &'a mut [u32; 16],
    len: usize,
}

impl<'a> Out<'a> {
    pub fn new(words: &'a mut [u32; 16]) -> Self {
        Self { words, len: 0 }
    }

    pub fn len(&self) -> usize {
        self.len
    }

    pub fn is_empty(&self) -> bool {
        self.len == 0
    }

    pub fn word(&mut self, word: u32) {
        if let Some(slot) = self.words.get_mut(self.len) {
            *slot = word;
            self.len = self.len.saturating_add(1);
        }
    }

    pub fn float(&mut self, x: f32) {
        self.word(if x.is_nan() { 0x7fc0_0000 } else { x.to_bits() });
    }
}

/// What is put out as words.
pub(crate) trait Put: Copy {
    fn put(self, out: &mut Out);
}

/// One or several numbers, made from four.
pub(crate) trait Numbers: Put {
    fn from_four(four: [f32; 4]) -> Self;
}

impl Numbers for f32 {
    fn from_four([first, ..]: [f32; 4]) -> Self {
        first
    }
}

impl<const N: usize> Numbers for [f32; N] {
    fn from_four(four: [f32; 4]) -> Self {
        core::array::from_fn(|i| four.get(i).copied().unwrap_or(0.5))
    }
}

impl<const N: usize> Numbers for ([f32; N], f32) {
    fn from_four(four: [f32; 4]) -> Self {
        (
            Numbers::from_four(four),
            four.get(N).copied().unwrap_or(0.5),
        )
    }
}

impl Put for f32 {
    fn put(self, out: &mut Out) {
        out.float(self);
    }
}

impl Put for MeshPoint {
    fn put(self, out: &mut Out) {
        self.position.put(out);
        self.barycentrics.put(out);
        out.word(self.triangle as u32);
    }
}

impl Put for SurfacePoint {
    fn put(self, out: &mut Out) {
        self.position.put(out);
        self.normal.put(out);
    }
}

impl<const N: usize> Put for [f32; N] {
    fn put(self, out: &mut Out) {
        for x in self {
            out.float(x);
        }
    }
}

/// Shares and the rest.
impl<const N: usize> Put for ([f32; N], f32) {
    fn put(self, out: &mut Out) {
        self.0.put(out);
        self.1.put(out);
    }
}

pub(crate) fn generator(input: usize) -> Pcg32 {
    Pcg32::new(0x5eed + input as u64, 54)
}

/// Sample, density and inverse at fixed uniforms, or at a drawn point.
fn triple<W>(warp: W, input: usize, out: &mut Out)
where
    W: Invert<Density = f32>,
    W::Uniforms: Numbers,
    W::Point: Put,
{
    let point = match UNIFORMS.get(input) {
        Some(&u) => warp.sample(W::Uniforms::from_four(u)),
        None => warp.draw(&mut generator(input)),
    };
    point.put(out);
    out.float(warp.pdf(point));
    warp.invert(point).put(out);
}

/// A mixture as a warp with an inverse. It leads back to a point's uniforms where no point comes of two
/// parts.
#[derive(Clone, Copy, Debug)]
pub struct Mixed<P, const N: usize>(pub Mixture<P, N>);

impl<P: Parts<N>, const N: usize> Warp for Mixed<P, N> {
    type Uniforms = P::Uniforms;
    type Point = P::Point;
    type Density = f32;

    fn sample_canonical(&self, u: Canonical<P::Uniforms>) -> P::Point {
        self.0.sample_canonical(u)
    }

    fn pdf(&self, x: P::Point) -> f32 {
        self.0.pdf(x)
    }

    fn sample_words(&self, words: <P::Uniforms as Uniforms>::Words) -> P::Point {
        self.0.sample_words(words)
    }

    fn try_draw<R: TryRng + ?Sized>(&self, rng: &mut R) -> Result<P::Point, R::Error> {
        self.0.try_draw(rng)
    }
}

impl<P: InvertParts<N>, const N: usize> Invert for Mixed<P, N> {
    fn invert(&self, x: P::Point) -> P::Uniforms {
        self.0.invert_with(x, 0.25)
    }
}

/// A parameter the compiler cannot see, so that the linked firmware holds the constructors' refusals too.
pub(crate) fn v(x: f32) -> f32 {
    black_box(x)
}

/// A number for each refusal, the index it names included.
pub(crate) fn refusal(error: Error) -> u32 {
    let (code, index) = match error {
        Error::NotFinite(_) => (0, 0),
        Error::Reversed(_) => (1, 0),
        Error::Empty(_) => (2, 0),
        Error::TooLarge(_) => (3, 0),
        Error::NotPositive(_) => (4, 0),
        Error::Negative(_) => (5, 0),
        Error::OutOfRange(_) => (6, 0),
        Error::NotNormalizable(_) => (7, 0),
        Error::ZeroLength(_) => (8, 0),
        Error::NoWeights => (9, 0),
        Error::TooManyWeights => (10, 0),
        Error::NotFiniteWeight(i) => (11, i),
        Error::NegativeWeight(i) => (12, i),
        Error::AllZero => (13, 0),
        Error::Unreachable(i) => (14, i),
        Error::NotATable => (15, 0),
        _ => (255, 0),
    };
    code + ((index as u32) << 8)
}

/// What a constructor says of parameters that are mostly impossible: 0, or the error's number and one.
pub(crate) fn verdict<W>(result: Result<W, Error>, out: &mut Out) {
    out.word(match result {
        Ok(warp) => {
            black_box(&warp);
            0
        }
        Err(e) => refusal(e).saturating_add(1),
    });
}

/// A try: whether the point was accepted, and the point.
fn attempted<const N: usize>(point: Option<[f32; N]>, out: &mut Out) {
    out.word(u32::from(point.is_some()));
    if let Some(point) = point {
        point.put(out);
    }
}

/// A number for each failure, with the ratio or the tries it names.
pub(crate) fn failed<E>(failure: Failure<E>, out: &mut Out) {
    match failure {
        Failure::Generator(_) => out.word(0xf0),
        Failure::BudgetSpent { tries } => {
            out.word(0xf1);
            out.word(tries);
        }
        Failure::BoundExceeded { ratio } => {
            out.word(0xf2);
            out.float(ratio);
        }
        Failure::NotFinite => out.word(0xf3),
        Failure::Negative => out.word(0xf4),
        Failure::ProposalDensity => out.word(0xf5),
        _ => out.word(0xff),
    }
}

/// A drawn point with its tries, or the failure.
fn drawn<const N: usize, E>(result: Result<Accepted<[f32; N]>, Failure<E>>, out: &mut Out) {
    match result {
        Ok(Accepted { point, tries }) => {
            out.word(tries);
            point.put(out);
        }
        Err(failure) => failed(failure, out),
    }
}

/// What is not known yields the word of a NaN.
pub(crate) fn figure(x: Option<f32>, out: &mut Out) {
    out.float(x.unwrap_or(f32::NAN));
}

fn bound(x: Result<f32, Error>, out: &mut Out) {
    match x {
        Ok(x) => out.float(x),
        Err(e) => out.word(refusal(e)),
    }
}

/// What a selection yields.
fn selected(chosen: Selection, out: &mut Out) {
    out.word(chosen.index as u32);
    out.float(chosen.pmf);
    out.float(chosen.leftover);
    out.word(chosen.leftover_bits);
}

/// A selection, or the refusal.
fn selected_or(chosen: Result<Selection, Error>, out: &mut Out) {
    match chosen {
        Ok(chosen) => selected(chosen, out),
        Err(e) => out.word(refusal(e)),
    }
}

/// The table of a selector, or the refusal.
pub(crate) fn with<S>(table: Result<S, Error>, out: &mut Out, then: impl FnOnce(S, &mut Out)) {
    match table {
        Ok(table) => then(table, out),
        Err(e) => out.word(refusal(e)),
    }
}

/// What a try gave, and a count that is drawn, with its probability.
fn tried_and_drawn(
    law: &impl Rejection<Point = u32>,
    count: Option<u32>,
    pmf: impl Fn(u32) -> f32,
    input: usize,
    out: &mut Out,
) {
    out.word(count.unwrap_or(0xf0));
    match law.draw(&mut generator(input)) {
        Ok(drawn) => {
            out.word(drawn.point);
            out.float(pmf(drawn.point));
        }
        Err(failure) => failed(failure, out),
    }
}

/// Weights with zeros and decades, which the compiler cannot see.
pub fn weights() -> [f32; 6] {
    [v(0.0), v(1.0), v(1e-6), v(37.0), v(0.3), v(0.0)]
}

/// The vertices, the faces and the areas of a mesh, in flash.
pub static VERTICES: [[f32; 3]; 6] = [
    [0.0, 0.0, 2.0],
    [3.0, 0.0, 0.0],
    [0.0, 4.0, 0.0],
    [-1.0, 0.0, 0.1],
    [0.0, -1.0, 0.0],
    [0.0, 0.0, 1.0],
];
pub static FACES: [[u16; 3]; 6] = [
    [0, 5, 0],
    [0, 1, 2],
    [0, 2, 3],
    [0, 3, 4],
    [0, 4, 1],
    [5, 5, 5],
];
pub static AREAS: [f32; 6] = [0.0, 7.810_25, 4.294_182_5, 1.16, 3.5, 0.0];

/// Known to the compiler, in flash.
static FLASH: Cdf<[u32; 6]> = match Cdf::new(&[0.0, 1.0, 1e-6, 37.0, 0.3, 0.0]) {
    Ok(table) => table,
    Err(_) => panic!("refused"),
};

/// Which subjects are evaluated in one tier alone: those marked `once`, which have no tier and so cannot name it.
macro_rules! once {
    () => {
        false
    };
    (once) => {
        true
    };
    (once $subject:expr) => {{
        #[allow(dead_code)]
        type T = ();
        $subject
    }};
    ($subject:expr) => {
        $subject
    };
}

/// The subjects: the warps of the list, and behind them what is no warp, functions of four uniforms and the input.
macro_rules! subjects {
    (
        { $($($once:ident)? $name:literal => $function:expr,)* }
        $($type:ident {
            golden { $($($warp_once:ident)? $warp_name:literal => $warp:expr,)* }
            cost $cost:tt bind $bind:tt
        })*
    ) => {
        /// The names of all subjects, in the order of their cases: first the warps. And whether they have no tier.
        pub const SUBJECTS: &[(&str, bool)] = &[
            $($(($warp_name, once!($($warp_once)?)),)*)*
            $(($name, once!($($once)?)),)*
        ];

        /// Evaluates one subject at one input; nothing for an index past the last. No other subject than those of a range is
        /// linked, and what has no tier in one alone.
        pub fn evaluate<T: Golden, const FROM: usize, const TO: usize>(subject: usize, input: usize, out: &mut Out) {
            let linked = |index, once: bool| FROM <= index && index < TO && (T::ALL || !once);
            let mut index = 0;
            $($(
                if linked(index, once!($($warp_once)?)) && subject == index {
                    let warp: Result<_, Error> = once!($($warp_once)? $warp);
                    if let Ok(warp) = warp {
                        triple(warp, input, out);
                    }
                    return;
                }
                index += 1;
            )*)*
            let uniforms = UNIFORMS.get(input).copied().unwrap_or_else(|| {
                Uniforms::canonical(core::array::from_fn(|_| uniform::grid(&mut generator(input)))).get()
            });
            $(
                if linked(index, once!($($once)?)) && subject == index {
                    let function: fn([f32; 4], usize, &mut Out) = once!($($once)? $function);
                    function(uniforms, input, out);
                    return;
                }
                index += 1;
            )*
            let _ = index;
        }
    };
}

float_warps!(subjects {
    once "Mixture choices" => |[a, b, c, d], input, out| {
        let mixture = Tent::new(1.0).and_then(|tent| Mixture::new([tent; 4], &[a, b.abs(), 0.0, c]));
        with(mixture, out, |mixture, out| {
            let word = generator(input).next_u32();
            for word in [word, 0, u32::MAX] {
                let (part, rest) = mixture.choose(word);
                out.word(part as u32);
                out.word(rest);
            }
            out.word(mixture.numerator(1) as u32);
            out.float(mixture.pmf(3));
            out.float(mixture.pdf_of([a, b, c, d]));
            out.float(mixture.sample_with_pdf(d).1);
            mixture.draw_with_pdf(&mut generator(input)).0.put(out);
        });
    },
    "verdicts on the line" => |[a, b, c, _], _, out| {
        verdict(Interval::new(a, b), out);
        verdict(Interval::decreasing(b, c), out);
        verdict(Power::<T>::new(c - 2.0, a, b), out);
        verdict(Power::<T>::decreasing(a, b, c), out);
        verdict(Exponential::<T>::from_rate(a), out);
        verdict(ExponentialTail::<T>::from_rate(b - 0.5), out);
        verdict(TruncatedExponential::<T>::from_rate(a, b - 0.5), out);
        verdict(Tent::new(a), out);
        verdict(Linear::new(a - 0.5, b), out);
        verdict(Normal::<T>::new(a, b), out);
        verdict(NormalPair::<T>::new([a, b], c), out);
    },
    "verdicts on shapes" => |[a, b, c, d], _, out| {
        verdict(TriangleOn::new([[a, b], [c, d], [a, a]]), out);
        verdict(TriangleOn::new([[a, b, c], [c, d, b], [a, a, a]]), out);
        verdict(PhongLobe::<T>::new(a - 0.5), out);
        verdict(Cone::<T>::from_radians(4.0 * b), out);
        verdict(Cone::<T>::from_sine(2.0 * b), out);
        verdict(Cone::<T>::from_one_minus_cos(3.0 * c), out);
        verdict(SphericalPatch::<T>::from_turns(a, b, c, d), out);
        verdict(Spherical::<T>::from_turns(a - 0.1, b, c), out);
        verdict(Frame::new([a, b, c]), out);
        verdict(Strata1d::new(a.to_bits()), out);
        verdict(Strata2d::new(a.to_bits(), b.to_bits()), out);
    },
    "slices" => |_, input, out| {
        let mut rng = generator(input);
        let mut points = [0.0; 4];
        if let Ok(tail) = ExponentialTail::<T>::from_rate(v(2.0)) {
            tail.fill(&mut rng, &mut points);
        }
        points.put(out);
        let mut points = [[0.0; 2]; 3];
        let filled = Disk::<T>::new().try_fill(&mut rng, &mut points);
        out.word(u32::from(filled.is_err()));
        for point in points {
            point.put(out);
        }
    },
    "mapped slices" => |[a, b, c, d], _, out| {
        let mut points = [[0.0; 2]; 2];
        Disk::<T>::new().map(&[[a, b], [c, d]], &mut points);
        for point in points {
            point.put(out);
        }
        let (mut points, mut densities) = ([0.0; 3], [0.0; 3]);
        if let Ok(tail) = Exponential::<T>::from_rate(v(2.0)) {
            tail.map_with_pdf(&[a, b, c, d], &mut points, &mut densities);
        }
        points.put(out);
        densities.put(out);
    },
    "tier turns" => |[a, b, ..], _, out| {
        let (s, c) = T::sincos_turns(a);
        [s, c, T::atan2_turns(b - 0.5, a - 0.5), T::sqrt(b)].put(out);
    },
    "tier logarithms" => |[a, b, ..], _, out| {
        [T::ln(a), T::ln_1p(-a), T::ln_1p(b), T::exp(10.0 * a), T::exp(-90.0 * b), T::exp_m1(-a)].put(out);
    },
    "tier powers" => |[a, b, ..], _, out| {
        [T::pow(a, 2.5), T::pow(a, -0.3), T::pow(1.0 + b, 40.0 * a)].put(out);
    },
    "tier normal" => |[a, b, ..], _, out| {
        [T::normal_cdf_lower(-14.0 * a), T::normal_quantile_lower(0.5 * b)].put(out);
    },
    once "uniforms" => |u, input, out| {
        u.canonical().get().put(out);
        let mut rng = generator(input);
        [uniform::grid(&mut rng), uniform::open(&mut rng), uniform::full(&mut rng)].put(out);
        out.float(uniform::full_from_words(rng.next_u32() >> (2 * input), rng.next_u32()));
        out.float(uniform::full_from_words(0, rng.next_u32() >> (2 * input)));
    },
    once "strata" => |[a, b, ..], input, out| {
        if let (Ok(line), Ok(square)) = (Strata1d::new(7), Strata2d::new(5, 3)) {
            out.float(line.point(input as u32, a));
            square.point(input as u32, [a, b]).put(out);
            square.draw(input as u32, &mut generator(input)).put(out);
            out.word(square.count());
        }
    },
    once "points" => |[a, b, ..], input, out| {
        let (index, pixel) = (a.to_bits(), b.to_bits());
        let sets = (Sobol::<2>::new(pixel), Sobol::<8>::new(pixel), Recurrence::<3>::new(pixel));
        if let (Ok(pairs), Ok(eight), Ok(recurrence)) = sets {
            pairs.point::<2>(index).put(out);
            let random = ByPosition::new(input as u32, pixel);
            let words = pairs.words::<3>(index).into_iter().chain(eight.words::<8>(index));
            words.for_each(|word| out.word(word));
            let others = [recurrence.word(index, 2), random.at(index).next_u32()];
            out.word(others.into_iter().fold(0, |all, word| all.rotate_left(1) ^ word));
        }
    },
    once "frame" => |[a, b, c, d], _, out| {
        match Frame::new([a - 0.5, b - 0.5, c - 0.5]) {
            Ok(frame) => {
                frame.normal().put(out);
                frame.to_world([a, b, d]).put(out);
                frame.to_local([a, b, d]).put(out);
                let [tangent, bitangent] = frame.tangents();
                tangent.put(out);
                bitangent.put(out);
            }
            Err(e) => out.word(refusal(e)),
        }
    },
    "spherical" => |[a, b, c, _], _, out| {
        let s = Spherical::<T>::from_cartesian([a - 0.5, b - 0.5, c - 0.5]);
        [s.radius(), s.theta_turns(), s.phi_turns(), s.solid_angle_jacobian(), s.volume_jacobian()].put(out);
        s.to_cartesian().put(out);
        match Spherical::<T>::from_turns(a, 0.5 * b, c) {
            Ok(s) => s.to_cartesian().put(out),
            Err(e) => out.word(refusal(e)),
        }
    },
    "solid angles" => |[a, b, ..], _, out| {
        match Cone::<T>::from_one_minus_cos(2.0 * a) {
            Ok(cone) => [cone.one_minus_cos(), cone.solid_angle()].put(out),
            Err(e) => out.word(refusal(e)),
        }
        match SphericalPatch::<T>::from_turns(0.25 * a, 0.25 + 0.25 * b, -a, b - a) {
            Ok(patch) => out.float(patch.solid_angle()),
            Err(e) => out.word(refusal(e)),
        }
        if let Ok(triangle) = TriangleOn::new([[0.0, 0.0], [4.0, 0.0], [1.0, 3.0]]) {
            out.float(triangle.area());
        }
    },
    once "cdf" => |[a, b, ..], input, out| {
        let bits = (b * 4_294_967_296.0) as u32;
        with(Cdf::new(&weights()), out, |table, out| {
            selected(table.select_uniform(a), out);
            selected(table.select(bits), out);
            selected(FLASH.draw(&mut generator(input)), out);
            out.word(table.words_of(input & 7).map_or(u32::MAX, |words| *words.start()));
            out.word(table.numerator(input & 7) as u32);
            out.word(u32::from(table == FLASH));
        });
    },
    once "cdf wide" => |[a, b, ..], input, out| {
        let bits = (b * 4_294_967_296.0) as u32;
        with(Cdf::new_u64(&weights()), out, |table, out| {
            selected(table.select_uniform(a), out);
            selected(table.select(bits), out);
            selected(table.draw(&mut generator(input)), out);
            out.word((table.numerator(input & 7) >> 32) as u32);
            out.word(table.numerator(input & 7) as u32);
            out.word(table.as_words().first().map_or(0, |word| *word as u32));
        });
    },
    once "cdf of any weights" => |[a, b, c, d], _, out| {
        let mut memory = [0_u32; 6];
        let any = [a, b, 1e-9 * c, d, 1e6 * a];
        with(Cdf::<&[u32]>::new_in(&any, &mut memory), out, |table, out| {
            table.as_words().iter().for_each(|&word| out.word(word));
            out.float(table.pmf(0));
        });
        with(Cdf::<heapless::Vec<u64, 6>>::from_slice(&any), out, |table, out| {
            for index in 0..table.entries() {
                out.word((table.numerator(index) >> 32) as u32);
            }
        });
        out.word(u32::from(Cdf::from_words([a.to_bits(), b.to_bits(), 1]).is_ok()));
        let index = 2 + (u64::from(a.to_bits() >> 29) << 32);
        out.word(u32::from(Cdf::from_words([1, 2, index]).is_ok()));
    },
    once "cdf of integers" => |[a, b, c, d], input, out| {
        let any = [a.to_bits(), b.to_bits() >> 9, c.to_bits() >> 20, d.to_bits()];
        with(Cdf::from_integers(&any), out, |table, out| {
            table.as_words().iter().for_each(|&word| out.word(word));
        });
        with(Cdf::<heapless::Vec<u32, 3>>::from_integer_slice(any.get(..input & 3).unwrap_or(&[])), out, |table, out| {
            out.float(table.pmf(0));
        });
        let mut memory = [0_u64; 4];
        with(Cdf::<&[u64]>::from_integers_in(&any, &mut memory), out, |table, out| {
            out.float(table.pmf(3));
        });
    },
    once "alias" => |[a, b, ..], input, out| {
        let bits = (b * 4_294_967_296.0) as u32;
        with(Alias::<[AliasEntry<u32>; 8]>::new(&weights()), out, |table, out| {
            selected(table.select_uniform(a), out);
            selected(table.select(bits), out);
            selected(table.draw(&mut generator(input)), out);
            out.word(table.numerator(input & 7) as u32);
            out.word(table.draw_index(&mut generator(input)) as u32);
                out.word(table.bins() as u32);
        });
    },
    once "alias wide" => |[a, b, c, d], input, out| {
        let mut memory = [AliasEntry::<u64>::EMPTY; 8];
        let any = [a, b, 1e-9 * c, d, 1e6 * a];
        with(Alias::<&[AliasEntry<u64>]>::new_in(&any, &mut memory), out, |table, out| {
            selected(table.select_uniform(a), out);
            selected(table.select((b * 4_294_967_296.0) as u32), out);
            selected(table.draw(&mut generator(input)), out);
            out.word((table.numerator(0) >> 32) as u32);
        });
        let integers = [a.to_bits(), b.to_bits() >> 9, 0];
        with(Alias::<heapless::Vec<AliasEntry<u32>, 4>>::from_integer_slice(&integers), out, |table, out| {
            out.float(table.pmf(1));
        });
    },
    once "select once" => |[a, b, c, d], _, out| {
        selected_or(select_once(&weights(), (a * 4_294_967_296.0) as u32), out);
        selected_or(select_once_uniform(&[b, c, 1e-9 * d, a], c), out);
        selected_or(select_once(&[a - 0.5, b, 0.0], 0), out);
    },
    once "reservoir" => |[a, b, c, d], input, out| {
        let mut rng = generator(input);
        let (mut one, mut two) = (Reservoir::new(), Reservoir::new());
        for (item, weight) in [a, b, 1e30 * c, 1e-30 * d].into_iter().enumerate() {
            match one.offer(item as u32, weight, &mut rng) {
                Ok(taken) => out.word(u32::from(taken)),
                Err(e) => out.word(refusal(e)),
            }
            let _ = two.offer_with(item as u32 + 4, weight + 0.5, (weight.to_bits() as u64) << 32);
        }
        out.word(one.item().copied().unwrap_or(99));
        out.float(one.pmf());
        out.word(u32::from(one.merge(two, &mut rng)));
        out.word(one.item().copied().unwrap_or(99));
        out.float(one.pmf());
    },
    once "piecewise of any weights" => |[a, b, c, d], input, out| {
        let (mut rows, mut cells) = ([0_u32; 2], [0_u32; 4]);
        let table = PiecewiseConstant2d::<&[u32], &[u32]>::new_in(&[a, b, c, d], [2, 2], [0.0, 1.0], [a, 9.0], &mut rows, &mut cells);
        with(table, out, |table, out| {
            let point = table.draw(&mut generator(input));
            point.put(out);
            out.float(table.pdf(point));
            let [column, row] = table.cell(point);
            out.word((2 * row + column) as u32);
            table.marginal().sample(b).put(out);
            table.conditional(1).sample(c).put(out);
            let (marginal, conditional) = table.as_words();
            out.word(u32::from(PiecewiseConstant2d::from_words(marginal, conditional, [0.0, 1.0], [a, 9.0]).is_ok()));
        });
        with(Cdf::new_u64(&[a, b, c]).and_then(|cdf| PiecewiseConstant1d::from_cdf(cdf, -1.0, d)), out, |line, out| {
            line.sample(a).put(out);
            line.draw(&mut generator(input)).put(out);
            out.word(line.cell(b) as u32);
            out.float(line.cdf().pmf(1));
        });
    },
    "sky and curve of any weights" => |[a, b, c, d], input, out| {
        let (mut rows, mut cells) = ([0_u32; 2], [0_u32; 6]);
        let radiances = [a, b, c, d, 0.0, 1e-3];
        let sky = LatLongMap::<T, &[u32], &[u32]>::new_in(&radiances, [3, 2], &mut rows, &mut cells);
        with(sky, out, |sky, out| {
            let PixelSample { pixel: [column, row], direction, pdf } = sky.draw_pixel(&mut generator(input));
            direction.put(out);
            out.float(pdf);
            out.word((3 * row + column) as u32);
            let [column, row] = sky.pixel([b - 0.5, c - 0.5, d - 0.5]);
            out.word((3 * row + column) as u32);
        });
        let curve = [c, 1e30 * d, a];
        let mut words = [0_u64; 3];
        with(PiecewiseLinear1d::<&[u64], &[f32]>::new_in(&curve, -1.0, 1.0 + b, &mut words), out, |curve, out| {
            curve.sample(a).put(out);
            curve.draw(&mut generator(input)).put(out);
            out.float(curve.pdf(b));
            out.word(curve.cell(c) as u32);
        });
    },
    once "mesh of any vertices" => |[a, b, c, d], input, out| {
        let vertices = [[a, b, 0.0], [c, d, 1.0], [1.0, a, c], [d, 0.25, 1e-3]];
        let (mut areas, mut words) = ([0.0; 3], [0_u64; 3]);
        let mesh = Mesh::new_in(&vertices, &[[0_u8, 1, 2], [1, 2, 3], [2, 2, 0]], &mut areas, &mut words);
        with(mesh, out, |mesh, out| {
            mesh.draw(&mut generator(input)).position.put(out);
            mesh.sample_words([a.to_bits() << 7, b.to_bits() << 7]).barycentrics.put(out);
            mesh.normal(1).unwrap_or([0.0; 3]).put(out);
            [mesh.area(), mesh.density(0), mesh.probability(1), mesh.density(2)].put(out);
        });
        let mut areas = [0.0; 1];
        let table = Cdf::<[u32; 1]>::new(&[1.0]);
        verdict(table.and_then(|t| Mesh::from_table(&vertices, &[[3_u8, 2, 7]], &mut areas, t).map(|m| m.area())), out);
    },
    once "rejection disk and ball" => |[a, b, c, _], input, out| {
        let mut rng = generator(input);
        attempted(DiskRejection::new().attempt([a, b]), out);
        attempted(BallRejection::new().attempt([a, b, c]), out);
        drawn(DiskRejection::new().draw(&mut rng), out);
        drawn(BallRejection::new().try_draw(&mut rng), out);
    },
    once "rejection budgets and densities" => |[a, b, c, d], input, out| {
        let mut rng = generator(input);
        out.float(DiskRejection::new().pdf([2.0 * a - 1.0, b]));
        out.float(BallRejection::new().pdf([a, 2.0 * b - 1.0, c]));
        for budget in [0, 1, 3] {
            match DiskRejection::new().with_budget(black_box(budget)) {
                Ok(disk) => drawn(disk.draw(&mut rng), out),
                Err(e) => out.word(refusal(e)),
            }
        }
        match BallRejection::new().with_budget(black_box(2)) {
            Ok(ball) => out.word(ball.budget()),
            Err(e) => out.word(refusal(e)),
        }
        for efficiency in [d - 0.5, 1e-7 * d] {
            match budget_for(efficiency) {
                Ok(budget) => out.word(budget),
                Err(e) => out.word(refusal(e)),
            }
        }
    },
    once "rejection ziggurats" => |[a, b, c, d], input, out| {
        // Any layer and place; a wedge; the far tails.
        let word = |u: f32| (u * 4_294_967_296.0) as u32;
        let (normal, wait) = (ZigguratStandardNormal::new(), ZigguratStandardExponential::new());
        let words = [word(a).wrapping_add(word(b) >> 24), word(c), word(d)];
        for words in [words, [word(a) | 0x7fff_ff00, word(b), word(c)], [0x7fff_ff00, word(c) >> 20, word(d)]] {
            for x in [normal.attempt(words), wait.attempt(words)] {
                figure(x, out);
            }
        }
        let mut rng = generator(input);
        for drawn in [normal.draw(&mut rng), wait.try_draw(&mut rng)] {
            figure(drawn.ok().map(|drawn| drawn.point), out);
        }
        out.float(normal.pdf(10.0 * a));
        out.float(wait.pdf(b - 0.25));
    },
    once "rejection ziggurats scaled" => |[a, b, c, d], input, out| {
        let mut rng = generator(input);
        with(ZigguratNormal::new(a - 0.5, 1e3 * b), out, |normal, out| {
            out.word(normal.draw(&mut rng).map_or(0, |drawn| drawn.tries));
            figure(normal.attempt([(c * 4_294_967_296.0) as u32, 7, 8]), out);
            figure(normal.draw(&mut rng).ok().map(|drawn| drawn.point), out);
            out.float(normal.pdf(c - d));
        });
        with(ZigguratExponential::from_rate(1e3 * b), out, |wait, out| {
            figure(wait.attempt([(c * 4_294_967_296.0) as u32, 7, 8]), out);
            figure(wait.draw(&mut rng).ok().map(|drawn| drawn.point), out);
            out.float(wait.pdf(d));
        });
        verdict(ZigguratNormal::new(1e38 * a, 1e37 * (b + 0.25)).and_then(|sampler| sampler.with_budget((3.0 * c) as u32)), out);
        verdict(ZigguratExponential::from_rate(d - 0.25).and_then(|sampler| sampler.with_budget((3.0 * c) as u32)), out);
        verdict(ZigguratStandardNormal::new().with_budget((3.0 * c) as u32), out);
        match ZigguratStandardExponential::new().with_budget(black_box(1)) {
            Ok(wait) => out.word(wait.draw(&mut rng).map_or(0xf1, |drawn| drawn.tries)),
            Err(e) => out.word(refusal(e)),
        }
    },
    once "rejection region" => |[a, b, c, d], input, out| {
        let region = Aabb::new([v(-1.0), v(0.0), v(2.0)], [v(1.0), v(0.5), v(4.0)]).and_then(|room| {
            out.float(room.pdf([a, b, 2.0 + c]));
            room.invert([a, 0.5 * b, 2.0 + c]).put(out);
            Region::new(room, move |[x, y, z]: [f32; 3]| x * y * z > d - 0.5).with_budget(20)
        });
        match region {
            Ok(region) => {
                attempted(region.attempt([a, b, c]), out);
                drawn(region.draw(&mut generator(input)), out);
            }
            Err(e) => out.word(refusal(e)),
        }
    },
    "rejection bounded" => |[a, b, c, d], input, out| {
        // f/p is at most π; the bound is one from 2 to 4, so that it is exceeded sometimes.
        let bump = |[x, y]: [f32; 2]| 1.0 / (1.0 + x * x + y * y);
        match Bounded::new(Disk::<T>::new(), bump, 2.0 + 2.0 * c).and_then(|sampler| sampler.with_budget(30)) {
            Ok(bounded) => {
                match bounded.attempt([a, b], (d * 4_294_967_296.0) as u32) {
                    Ok(point) => attempted(point, out),
                    Err(failure) => failed(failure, out),
                }
                drawn(bounded.draw(&mut generator(input)), out);
            }
            Err(e) => out.word(refusal(e)),
        }
        // Far magnitudes: f, p and c near both ends of f32, and the slack.
        let far = Inversion::new(|u: f32| u, |_| 1e-39, |x: f32| x);
        for (f, bound) in [(a * 1e-39, 1.0), (0.5 * b, 3e38), (1e-39 * (1.0 + SLACK * c), 1.0), (1e-39 * (d - 0.5), 1.0)] {
            match Bounded::new(far, move |_| f, bound).and_then(|sampler| sampler.with_budget(1)).map(|far| far.attempt(a, (d * 4_294_967_296.0) as u32)) {
                Ok(Ok(point)) => out.word(u32::from(point.is_some())),
                Ok(Err(failure)) => failed(failure, out),
                Err(e) => out.word(refusal(e)),
            }
        }
    },
    "rejection verdicts" => |[a, b, c, d], _, out| {
        let disk = Disk::<T>::new();
        verdict(Region::new(disk, |_| true).with_budget((8.0 * a) as u32), out);
        verdict(Bounded::new(disk, |_| 1.0, b - 0.5).and_then(|sampler| sampler.with_budget(1)), out);
        verdict(Bounded::new(disk, |_| 1.0, 1.0).and_then(|sampler| sampler.with_budget((4.0 * c) as u32)), out);
        verdict(DiskRejection::new().with_budget((2.0 * d) as u32), out);
        verdict(BallRejection::new().with_budget((2.0 * a) as u32), out);
        verdict(Aabb::new([a, b], [c, d]), out);
        verdict(Aabb::new([0.0; 3], [1e13, 1e13 * a, 1e13 * b]), out);
    },
    once "moments" => |[a, b, c, d], _, out| {
        let (mut moments, mut other) = (Moments::new(), Moments::default());
        for (i, x) in [a, b, c, d, 3.0 * a, a + b, 1.0 - c].into_iter().enumerate() {
            moments.push(1000.0 + x);
            if i < 5 {
                other.push(v(1e-30) * x);
            }
        }
        out.word(moments.count() as u32);
        out.word(moments.refused() as u32);
        figure(moments.mean(), out);
        figure(moments.variance(), out);
        figure(moments.population_variance(), out);
        figure(moments.std_dev(), out);
        figure(moments.standard_error(), out);
        figure(other.std_dev(), out);
        other.merge(&moments);
        figure(other.mean(), out);
        figure(other.variance(), out);
        // By itself it doubles: the count to 2^40 and a little, with all digits of the mean.
        for _ in 0..37 {
            other.merge(&other.clone());
        }
        out.word((other.count() >> 32) as u32);
        out.word(other.count() as u32);
        figure(other.mean(), out);
        figure(other.standard_error(), out);
    },
    "integral" => |[a, b, c, d], _, out| {
        let (mut integral, mut other) = (Integral::new(), Integral::new());
        for (f, pdf) in [(a, b), (b, c), (c, d), (d, a)] {
            integral.push(f, pdf);
            other.push(v(1e20) * f, pdf + 0.5);
        }
        figure(integral.estimate(), out);
        figure(integral.standard_error(), out);
        bound(integral.chebyshev_bound(a), out);
        bound(integral.normal_bound::<T>(b), out);
        integral.merge(&other);
        out.word(integral.count() as u32);
        out.word(integral.refused() as u32);
        figure(integral.estimate(), out);
        figure(integral.moments().variance(), out);
        bound(integral.chebyshev_bound(v(0.05)), out);
        bound(integral.normal_bound::<T>(v(0.95)), out);
    },
    once "ratio" => |[a, b, c, d], _, out| {
        let (mut ratio, mut other) = (WeightedMean::new(), WeightedMean::default());
        for (value, weight) in [(a, b), (b, c), (c, d), (d, a), (a + b, -0.1 * c)] {
            ratio.push(100.0 + value, weight);
            other.push(value, v(1e10) * weight);
        }
        out.word(ratio.count() as u32);
        out.word(ratio.refused() as u32);
        figure(ratio.mean(), out);
        figure(ratio.standard_error(), out);
        ratio.merge(&other);
        out.word(ratio.count() as u32);
        figure(ratio.mean(), out);
        figure(ratio.standard_error(), out);
    },
    once "heuristics" => |[a, b, c, d], _, out| {
        let n = c.to_bits() >> 20;
        for (f, g) in [(a, b), (v(1e-25) * c, v(1e20) * b), (v(3e38) * a, v(3e38) * d)] {
            out.float(balance_heuristic(1, f, 1, g));
            out.float(balance_heuristic(n, f, 7, g));
            out.float(power_heuristic(1, f, 1, g));
            out.float(power_heuristic(n, f, 7, g));
        }
    },
    "chain displacements" => chains::displacements::<T>,
    "chain acceptances" => chains::acceptances::<T>,
    "chain in the cube" => chains::cube::<T>,
    "chain in the plane" => chains::plane::<T>,
    once "chain of indices" => chains::indices,
    "chain of parts" => chains::parts::<T>,
    once "chain with limits" => chains::limits,
    "chain starts" => chains::starts::<T>,
    "chain of uniforms" => chains::primary::<T>,
    once "chain health" => chains::health,
    "chain tuned" => chains::tuned::<T>,
    once "chain draws" => chains::judged,
    "chain verdicts" => chains::verdicts::<T>,
    once "integer chains" => integers::chains,
    once "integer chances" => integers::chances,
    once "integer selections" => integers::selections,
    once "integer selections wide" => integers::wide_selections,
    once "integer disks" => integers::disks,
    once "integer resampling" => integers::resampled,
    once "counts" => counts::counts,
    once "shuffles" => orders::shuffles,
    once "permutations" => orders::permutations,
    once "screens" => orders::screens,
    once "signed functions" => |[a, b, c, d], input, out| {
        let tables = [
            SignedLinear1d::new(&filter::lanczos::<17>(3), -3.0, 3.0),
            SignedLinear1d::new(&filter::mitchell::<17>(a, c), v(-2.0), 2.0 + b),
            if input & 1 == 0 {
                SignedLinear1d::new(&filter::gaussian::<17>(0.2 + d), -1.5, 1.5)
            } else {
                SignedLinear1d::new(&filter::blackman_harris::<17>(), -a, b)
            },
        ];
        for table in tables {
            with(table, out, |table, out| {
                let (x, w) = table.sample(b);
                let (y, drawn) = table.draw(&mut generator(input));
                [x, w, y, drawn * table.weight(a)].put(out);
            });
        }
    },
    "draws of places" => |u, input, out| {
        let [a, b, c, _] = u;
        let (near, far) = ([0.5 + a, b, 2.0], [[2.0, 0.0, c], [0.0, 1.5, 0.0]]);
        let mut rng = generator(input);
        with(GgxVisible::<T>::new([0.6, 0.0, 0.8], [0.3, 0.1]), out, |glossy, out| {
            let drawn = glossy.draw_reflection(&mut rng);
            drawn.direction.put(out);
            out.float(drawn.pdf);
        });
        with(VisibleSphere::<T>::new([0.0; 3], near, 0.7), out, |ball, out| {
            out.float(ball.draw_surface(&mut rng).distance);
        });
        with(SphericalRectangle::<T>::new([0.0; 3], near, far), out, |panel, out| {
            panel.draw_place(&mut rng).st.put(out);
        });
        let [x, y] = far;
        with(SphericalTriangle::<T>::new([0.0; 3], [near, x, y]), out, |face, out| {
            let Ok(drawn) = face.try_draw_place(&mut rng);
            drawn.barycentric.put(out);
        });
    },
    once "changing weights" => integers::trees,
    once "light reservoirs" => lamps::reservoirs,
    once "light reservoirs merged" => lamps::merged,
    once "techniques" => lamps::techniques,
    once "roulette" => lamps::roulettes,
    "rejection poisson" => |[a, b, c, d], input, out| {
        for mean in [10.0 + 100.0 * a, 65536.0 * b, v(1_048_576.0) * c] {
            with(PoissonRejection::<T>::new(mean), out, |law, out| {
                let count = law.attempt([(d * 4_294_967_296.0) as u32, (a * 4_294_967_296.0) as u32]);
                tried_and_drawn(&law, count, |count| law.pmf(count), input, out);
            });
        }
    },
    once "ranges" => integers::ranges,
    once "coins" => integers::coins,
    once "binomial counts" => counts::successes,
    "rejection binomial" => |[a, b, c, d], input, out| {
        let word = |u: f32| (u * 4_294_967_296.0) as u32;
        for (trials, p) in [(word(a) >> 22, b), (word(b), c), (word(c), v(1e-6) * d), (word(d) >> 10, 1.0 - v(1e-3) * a)] {
            with(BinomialRejection::<T>::new(trials, p), out, |law, out| {
                let count = law.attempt([word(d), word(a)]);
                tried_and_drawn(&law, count, |count| law.pmf(count), input, out);
            });
        }
    },
    once "negative binomial counts" => counts::failures,
    once "hypergeometric counts" => counts::urns,
    "rejection hypergeometric" => |[a, b, c, d], input, out| {
        let [a, b, c, d] = [a, b, c, d].map(|u| (u * 4_294_967_296.0) as u32);
        for (population, marked, drawn) in [(a, b, c), (d >> 16, a >> 17, b >> 17), (u32::MAX, c, d), (u32::MAX - d, a >> 12, b)] {
            with(HypergeometricRejection::<T>::new(population, marked, drawn), out, |law, out| {
                tried_and_drawn(&law, law.attempt([d, a]), |count| law.pmf(count), input, out);
            });
        }
    },
    once "integers around" => counts::around,
    "rejection von mises" => |[a, b, c, d], input, out| {
        let [place, decision] = [d, a].map(|u| (u * 4_294_967_296.0) as u32);
        for (mean, concentration) in [(6.0 * a - 3.0, 20.0 * b), (v(3.0), v(1e-20) * c), (12.0 * b - 6.0, v(1e20) * d)] {
            with(VonMises::<T>::new(mean, concentration), out, |law, out| {
                out.float(law.attempt([place, decision]).unwrap_or(9.0));
                out.float(law.pdf(a));
                match law.draw(&mut generator(input)) {
                    Ok(drawn) => {
                        out.float(drawn.point);
                        out.float(law.pdf(drawn.point));
                    }
                    Err(failure) => failed(failure, out),
                }
            });
        }
    },
    "rejection gamma" => gammas::numbers::<T>,
    "rejection shares" => gammas::shares::<T>,
    "lamps seen" => lamps::seen::<T>,
    "masking" => lamps::masking::<T>,
    "masked" => lamps::masked::<T>,
});
