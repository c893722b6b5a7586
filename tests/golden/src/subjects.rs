//! The subjects and the inputs of the golden table. A new warp is one line here.

use core::hint::black_box;
use microwarp::tier::Tier;
use microwarp::uniform::{self, Strata1d, Strata2d, Uniforms};
use microwarp::warp::*;
use microwarp::{Error, Frame, Warp};
use rand_core::Rng;
use rand_pcg::Pcg32;

/// Uniforms in and out of range; warps take as many of the four as they need.
const UNIFORMS: [[f32; 4]; 12] = [
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

/// One or several numbers: made from four, and put out.
trait Numbers: Copy {
    fn from_four(four: [f32; 4]) -> Self;
    fn put(self, out: &mut Out);
}

impl Numbers for f32 {
    fn from_four([first, ..]: [f32; 4]) -> Self {
        first
    }
    fn put(self, out: &mut Out) {
        out.float(self);
    }
}

impl<const N: usize> Numbers for [f32; N] {
    fn from_four(four: [f32; 4]) -> Self {
        core::array::from_fn(|i| four.get(i).copied().unwrap_or(0.5))
    }
    fn put(self, out: &mut Out) {
        for x in self {
            out.float(x);
        }
    }
}

fn generator(input: usize) -> Pcg32 {
    Pcg32::new(0x5eed + input as u64, 54)
}

/// Sample, density and inverse at fixed uniforms, or at a drawn point.
fn triple<W>(warp: W, input: usize, out: &mut Out)
where
    W: Warp<Density = f32>,
    W::Uniforms: Numbers,
    W::Point: Numbers,
{
    let point = match UNIFORMS.get(input) {
        Some(&u) => warp.sample(W::Uniforms::from_four(u)),
        None => warp.draw(&mut generator(input)),
    };
    point.put(out);
    out.float(warp.pdf(point));
    warp.invert(point).put(out);
}

/// A parameter the compiler cannot see, so that the linked firmware holds the constructors' refusals too.
fn v(x: f32) -> f32 {
    black_box(x)
}

/// A number for each refusal, the index it names included.
pub(crate) fn refusal(error: Error) -> u32 {
    let (code, index) = match error {
        Error::NotFinite => (0, 0),
        Error::Reversed => (1, 0),
        Error::Empty => (2, 0),
        Error::TooLarge => (3, 0),
        Error::NotPositive => (4, 0),
        Error::Negative => (5, 0),
        Error::OutOfRange => (6, 0),
        Error::NotNormalizable => (7, 0),
        Error::ZeroLength => (8, 0),
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
fn verdict<W>(result: Result<W, Error>, out: &mut Out) {
    out.word(match result {
        Ok(warp) => {
            black_box(&warp);
            0
        }
        Err(e) => refusal(e).saturating_add(1),
    });
}

/// Accepts a warp and the result of a constructor alike.
trait Built {
    type Warp;
    fn built(self) -> Result<Self::Warp, Error>;
}

impl<W> Built for Result<W, Error> {
    type Warp = W;
    fn built(self) -> Result<W, Error> {
        self
    }
}

struct Plain<W>(W);

impl<W> Built for Plain<W> {
    type Warp = W;
    fn built(self) -> Result<W, Error> {
        Ok(self.0)
    }
}

macro_rules! subjects {
    (
        warps { $($warp_name:literal => $warp:expr,)* }
        functions { $($name:literal => $function:expr,)* }
    ) => {
        /// The names of all subjects, in the order of their cases.
        pub const SUBJECTS: &[&str] = &[$($warp_name,)* $($name,)*];

        /// Evaluates one subject at one input; nothing for an index past the last.
        pub fn evaluate<T: Tier>(subject: usize, input: usize, out: &mut Out) {
            let mut index = 0;
            $(
                if subject == index {
                    if let Ok(warp) = $warp.built() {
                        triple(warp, input, out);
                    }
                    return;
                }
                index += 1;
            )*
            let uniforms = UNIFORMS.get(input).copied().unwrap_or_else(|| {
                Uniforms::canonical(core::array::from_fn(|_| uniform::grid(&mut generator(input)))).get()
            });
            $(
                if subject == index {
                    let function: fn([f32; 4], usize, &mut Out) = $function;
                    function(uniforms, input, out);
                    return;
                }
                index += 1;
            )*
            let _ = index;
        }
    };
}

subjects! {
    warps {
        "Interval -3 5" => Interval::new(v(-3.0), v(5.0)),
        "Interval decreasing 3e38" => Interval::decreasing(v(-3e38), v(3e38)),
        "Power 2.5" => Power::<T>::new(v(2.5), v(0.0), v(1.0)),
        "Power -1" => Power::<T>::new(v(-1.0), v(1.0), v(100.0)),
        "Power -0.99 decades" => Power::<T>::new(v(-0.99), v(1e-10), v(1e10)),
        "Power decreasing -2.5" => Power::<T>::decreasing(v(-2.5), v(1.0), v(1e20)),
        "Power 1000" => Power::<T>::new(v(1000.0), v(1.0), v(2.0)),
        "PowerMax 3" => Plain(PowerMax::<3>::new()),
        "Exponential" => Exponential::<T>::new(v(1.5)),
        "ExponentialTail" => ExponentialTail::<T>::new(v(1.5)),
        "TruncatedExponential 2" => TruncatedExponential::<T>::new(v(2.0), v(3.0)),
        "TruncatedExponential small" => TruncatedExponential::<T>::new(v(1e-3), v(1.0)),
        "TruncatedExponential -200" => TruncatedExponential::<T>::new(v(-200.0), v(1.0)),
        "Tent" => Tent::new(v(2.0)),
        "Linear" => Linear::new(v(1.0), v(3.0)),
        "Linear from 0" => Linear::new(v(0.0), v(1.0)),
        "Normal" => Normal::<T>::new(v(10.0), v(2.0)),
        "NormalPair" => NormalPair::<T>::new([v(1.0), v(-1.0)], v(0.5)),
        "Inversion" => Plain(Inversion::new(T::sqrt, |x: f32| 2.0 * x, |x: f32| x * x)),
        "Transform" => Interval::new(v(0.0), v(2.0)).map(|i| Transform::new(i, T::exp, T::ln, T::exp)),
        "MarginalConditional" => Linear::new(v(0.0), v(1.0)).and_then(|marginal| {
            let whole = Interval::new(v(0.0), v(1.0))?;
            Ok(MarginalConditional::new(marginal, move |x: f32| Interval::new(0.0, x).unwrap_or(whole)))
        }),
        "Disk" => Plain(Disk::<T>::new()),
        "DiskConcentric" => Plain(DiskConcentric::<T>::new()),
        "Triangle" => Plain(Triangle::new()),
        "TriangleOn 2" => TriangleOn::new([[v(0.0), v(0.0)], [v(4.0), v(0.0)], [v(1.0), v(3.0)]]),
        "TriangleOn 3" => TriangleOn::new([[v(1.0), v(0.0), v(0.0)], [v(0.0), v(2.0), v(0.5)], [v(-1.0), v(0.0), v(3.0)]]),
        "Sphere" => Plain(Sphere::<T>::new()),
        "Hemisphere" => Plain(Hemisphere::<T>::new()),
        "CosineHemisphere" => Plain(CosineHemisphere::<T>::new()),
        "MalleyHemisphere" => Plain(MalleyHemisphere::<T>::new()),
        "PhongLobe 0" => PhongLobe::<T>::new(v(0.0)),
        "PhongLobe 50" => PhongLobe::<T>::new(v(50.0)),
        "PhongLobe 1e8" => PhongLobe::<T>::new(v(1e8)),
        "Cone 0.1" => Cone::<T>::from_angle(v(0.1)),
        "Cone 1e-7" => Cone::<T>::from_angle(v(1e-7)),
        "Cone 3" => Cone::<T>::from_angle(v(3.0)),
        "Cone sphere" => Cone::<T>::from_sphere(v(0.5)),
        "SphericalPatch" => SphericalPatch::<T>::new(v(0.1), v(0.4), v(-0.25), v(0.5)),
        "Oriented" => Frame::new([v(1.0), v(2.0), v(-3.0)]).map(|f| Oriented::new(CosineHemisphere::<T>::new(), f)),
    }
    functions {
        "verdicts on the line" => |[a, b, c, _], _, out| {
            verdict(Interval::new(a, b), out);
            verdict(Interval::decreasing(b, c), out);
            verdict(Power::<T>::new(c - 2.0, a, b), out);
            verdict(Power::<T>::decreasing(a, b, c), out);
            verdict(Exponential::<T>::new(a), out);
            verdict(ExponentialTail::<T>::new(b - 0.5), out);
            verdict(TruncatedExponential::<T>::new(a, b - 0.5), out);
            verdict(Tent::new(a), out);
            verdict(Linear::new(a - 0.5, b), out);
            verdict(Normal::<T>::new(a, b), out);
            verdict(NormalPair::<T>::new([a, b], c), out);
        },
        "verdicts on shapes" => |[a, b, c, d], _, out| {
            verdict(TriangleOn::new([[a, b], [c, d], [a, a]]), out);
            verdict(TriangleOn::new([[a, b, c], [c, d, b], [a, a, a]]), out);
            verdict(PhongLobe::<T>::new(a - 0.5), out);
            verdict(Cone::<T>::from_angle(4.0 * b), out);
            verdict(Cone::<T>::from_sphere(2.0 * b), out);
            verdict(Cone::<T>::from_one_minus_cos(3.0 * c), out);
            verdict(SphericalPatch::<T>::new(a, b, c, d), out);
            verdict(Spherical::<T>::new(a - 0.1, b, c), out);
            verdict(Frame::new([a, b, c]), out);
            verdict(Strata1d::new(a.to_bits()), out);
            verdict(Strata2d::new(a.to_bits(), b.to_bits()), out);
        },
        "slices" => |_, input, out| {
            let mut rng = generator(input);
            let mut points = [0.0; 4];
            if let Ok(tail) = ExponentialTail::<T>::new(v(2.0)) {
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
        "uniforms" => |u, input, out| {
            u.canonical().get().put(out);
            let mut rng = generator(input);
            [uniform::grid(&mut rng), uniform::open(&mut rng), uniform::full(&mut rng)].put(out);
            out.float(uniform::full_from_words(rng.next_u32() >> (2 * input), rng.next_u32()));
            out.float(uniform::full_from_words(0, rng.next_u32() >> (2 * input)));
        },
        "strata" => |[a, b, ..], input, out| {
            if let (Ok(line), Ok(square)) = (Strata1d::new(7), Strata2d::new(5, 3)) {
                out.float(line.point(input as u32, a));
                square.point(input as u32, [a, b]).put(out);
                square.draw(input as u32, &mut generator(input)).put(out);
                out.word(square.count());
            }
        },
        "frame" => |[a, b, c, d], _, out| {
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
            [s.radius(), s.theta(), s.phi(), s.solid_angle_jacobian(), s.volume_jacobian()].put(out);
            s.to_cartesian().put(out);
            match Spherical::<T>::new(a, 0.5 * b, c) {
                Ok(s) => s.to_cartesian().put(out),
                Err(e) => out.word(refusal(e)),
            }
        },
        "solid angles" => |[a, b, ..], _, out| {
            match Cone::<T>::from_one_minus_cos(2.0 * a) {
                Ok(cone) => [cone.one_minus_cos(), cone.solid_angle()].put(out),
                Err(e) => out.word(refusal(e)),
            }
            match SphericalPatch::<T>::new(0.25 * a, 0.25 + 0.25 * b, -a, b - a) {
                Ok(patch) => out.float(patch.solid_angle()),
                Err(e) => out.word(refusal(e)),
            }
            if let Ok(triangle) = TriangleOn::new([[0.0, 0.0], [4.0, 0.0], [1.0, 3.0]]) {
                out.float(triangle.area());
            }
        },
    }
}
