//! The warps of the integer tier with their parameters, each with the exact map back to uniforms.
//!
//! A new warp is one line here. The exact maps are those of the library, in `f64`, which holds every point of the
//! tier without rounding.

use fixed::types::extra::LeEqU32;
use fixed::types::{I2F30, I16F16, U0F32, U2F62, U16F16, U32F32};
use fixed::{FixedI32, FixedU32};
use host::speed;
use host::truth::{self, Truth};
use microwarp::Warp;
use microwarp::fixed::{Coarse, Compact, Density, Fine, Grade, Interval, warp::*};
use rand_pcg::Pcg32;

/// A point as it is.
trait Exact: Copy {
    fn exact(self) -> [f64; 3];
    fn nowhere() -> Self;
}

impl<Frac: LeEqU32> Exact for FixedU32<Frac> {
    fn exact(self) -> [f64; 3] {
        [self.into(), 0.0, 0.0]
    }
    fn nowhere() -> Self {
        Self::ZERO
    }
}

impl<Frac: LeEqU32> Exact for FixedI32<Frac> {
    fn exact(self) -> [f64; 3] {
        [self.into(), 0.0, 0.0]
    }
    fn nowhere() -> Self {
        Self::ZERO
    }
}

impl<T: Exact, const N: usize> Exact for [T; N] {
    fn exact(self) -> [f64; 3] {
        std::array::from_fn(|i| self.get(i).map_or(0.0, |x| x.exact()[0]))
    }
    fn nowhere() -> Self {
        [T::nowhere(); N]
    }
}

impl<A: Exact, B: Exact> Exact for (A, B) {
    fn exact(self) -> [f64; 3] {
        self.0.exact()
    }
    fn nowhere() -> Self {
        (A::nowhere(), B::nowhere())
    }
}

/// Fills a slice with the uniforms of drawn points; says which of the points has density 0, if any.
pub type Fill = Box<dyn Fn(&mut Pcg32, &mut [[f64; 2]]) -> Option<[f64; 3]> + Send + Sync>;

/// A warp whose points have been mapped back: uniform on the unit interval, or on the unit square.
pub struct Shape {
    pub name: String,
    /// How many uniforms a point has.
    pub axes: usize,
    pub samples: usize,
    /// Cells along an axis.
    pub cells: usize,
    /// How far beyond the unit interval rounding may lead.
    pub slack: f64,
    pub fill: Fill,
}

/// How much of a grade's error would show, and so how many samples, in how many cells, its shape bears.
struct Power {
    samples: usize,
    cells: [usize; 2],
    slack: f64,
}

/// Samples off by e of the mass add 2 N K² e² to a chi-square of K cells along an axis, whose standard deviation
/// is √(2K) on the line: of e = 1e-7 and 1e-5 that is next to nothing here.
const FINE: Power = Power {
    samples: 1 << 22,
    cells: [251, 61],
    slack: 4e-6,
};
const COARSE: Power = Power {
    samples: 1 << 22,
    cells: [31, 31],
    slack: 4e-4,
};

/// The samples of any shape, and by how much more than in the full speed controls are wrong.
const QUICK: (usize, f64) = (1 << 16, 8.0);

/// The fewest samples that a shape gets, and how wrong its negative controls are.
pub fn fewest() -> (usize, f64) {
    if speed::full() {
        (COARSE.samples, 1.0)
    } else {
        QUICK
    }
}

impl Shape {
    pub fn new(name: String, axes: usize, fill: Fill) -> Self {
        Self {
            name,
            axes,
            samples: fewest().0,
            cells: COARSE.cells[axes - 1],
            slack: FINE.slack,
            fill,
        }
    }
}

fn shape<W>(name: String, power: &Power, warp: W, truth: Box<dyn Truth>) -> Shape
where
    W: Warp<Density = Density> + Send + Sync + 'static,
    W::Point: Exact,
{
    let back = move |point: W::Point| {
        let [u, v, ..] = truth.invert(point.exact());
        [u, v]
    };
    mapped(name, power, warp, back)
}

/// Two of the uniforms of a point, or the only one, by the exact map back.
fn mapped<W>(
    name: String,
    power: &Power,
    warp: W,
    back: impl Fn(W::Point) -> [f64; 2] + Send + Sync + 'static,
) -> Shape
where
    W: Warp<Density = Density> + Send + Sync + 'static,
    W::Point: Exact,
{
    let axes = <W::Uniforms as microwarp::uniform::Uniforms>::COUNT.min(2);
    Shape {
        name,
        axes,
        samples: speed::of("samples of each shape", QUICK.0, power.samples),
        cells: power.cells[axes - 1],
        slack: power.slack,
        fill: Box::new(move |rng, uniforms| {
            let mut points = vec![W::Point::nowhere(); uniforms.len()];
            warp.fill(rng, &mut points);
            for (uniforms, point) in uniforms.iter_mut().zip(&points) {
                *uniforms = back(*point);
            }
            let mut seen = points.iter().step_by(16);
            let without = seen.find(|point| warp.pdf(**point) == Density::ZERO);
            without.map(|point| point.exact())
        }),
    }
}

/// A distribution on the line by its CDF, of which shapes ask no more.
struct OnLine(fn(f64) -> f64);

impl Truth for OnLine {
    fn sample(&self, _: truth::Uniforms) -> truth::Point {
        unreachable!("shapes only go back")
    }
    fn pdf(&self, _: truth::Point) -> f64 {
        unreachable!("shapes only go back")
    }
    fn invert(&self, [x, ..]: truth::Point) -> truth::Uniforms {
        [self.0(x), 0.0, 0.0, 0.0]
    }
}

const PLANE: [[i32; 2]; 3] = [[-300, 20], [400, -30], [-100, 500]];
const SPACE: [[i32; 3]; 3] = [[-300, 20, 1000], [400, -30, 0], [-100, 500, 70]];

/// Deviations and correlations.
const POSE: ([f64; 3], [[f64; 3]; 3]) = (
    [5.0, 20.0, 50.0],
    [[1.0, 0.5, -0.3], [0.5, 1.0, 0.4], [-0.3, 0.4, 1.0]],
);

/// The uniforms of the first two normals, and of the third by itself.
pub fn pose(point: [f64; 3]) -> [f64; 3] {
    let (deviations, [_, [a, ..], [b, c, _]]) = POSE;
    let means = [100.0, -20.0, 3.0];
    let [x, y, z]: [f64; 3] = std::array::from_fn(|i| (point[i] - means[i]) / deviations[i]);
    // What the others leave is 1 - a² and 1 - b² of the variances; the larger comes first.
    let root = (1.0 - b * b).sqrt();
    let third = (z - b * x) / root;
    let part = (c - a * b) / root;
    let second = (y - a * x - part * third) / (1.0 - a * a - part * part).sqrt();
    let [u, v, ..] = truth::NormalPair {
        mean: [0.0; 2],
        deviation: 1.0,
    }
    .invert([x, second, 0.0]);
    [u, v, truth::normal_cdf(third)]
}

fn of_grade<G: Grade>(power: &Power) -> Vec<Shape> {
    let q16 = U16F16::from_num::<f64>;
    let lobe = |n| PhongLobe::<G>::new(U32F32::from_num(n)).unwrap();
    let normals = NormalPair::<_, G>::new([100, -20].map(I16F16::from_num), I16F16::from_num(5));
    let truncated =
        |mean, length| TruncatedExponential::<_, G>::from_mean(q16(mean), q16(length)).unwrap();
    let short = I16F16::from_num::<f64>;
    let flat = [[-90.0, 10.0], [300.0, -200.0], [40.0, 250.0]];
    let solid = [
        [-90.0, 10.0, 5.0],
        [300.0, -200.0, 70.0],
        [40.0, 250.0, -300.0],
    ];
    let narrow = U0F32::from_num(0.001);
    let cone = |k: f64| Cone::<G>::from_one_minus_cos(U2F62::from_num(k)).unwrap();
    let normal_pair = |mean, deviation| Box::new(truth::NormalPair { mean, deviation });
    macro_rules! shapes {
        ($($name:literal => $warp:expr, $truth:expr;)*) => {
            vec![$(shape(format!("{} {}", $name, G::NAME), power, $warp, $truth)),*]
        };
    }
    let mut shapes = shapes! {
        "Disk" => Disk::<G>::new(), Box::new(truth::Disk);
        "Annulus 30 50" => Annulus::<_, G>::new(short(30.0), short(50.0)).unwrap(),
            Box::new(truth::Annulus { radii: [30.0, 50.0], turns: [0.0, 1.0] });
        "Annulus sector" => Annulus::<_, G>::sector(short(0.0), short(50.0), [0.875, 0.25].map(U0F32::from_num::<f64>)).unwrap(),
            Box::new(truth::Annulus { radii: [0.0, 50.0], turns: [-0.125, 0.25] });
        "RegularPolygon 3" => RegularPolygon::<G>::new(3).unwrap(), Box::new(truth::RegularPolygon(3));
        "RegularPolygon 6" => RegularPolygon::<G>::new(6).unwrap(), Box::new(truth::RegularPolygon(6));
        "Sphere" => Sphere::<G>::new(), truth::sphere();
        "Hemisphere" => Hemisphere::<G>::new(), truth::hemisphere();
        "CosineHemisphere" => CosineHemisphere::<G>::new(), truth::cosine_hemisphere();
        "Cone 0.25" => cone(0.25), truth::cone(0.25, 1.75);
        "Cone 1.75" => cone(1.75), truth::cone(1.75, 0.25);
        "PhongLobe 0" => lobe(0), truth::phong(0.0);
        "PhongLobe 50" => lobe(50), truth::phong(50.0);
        "HenyeyGreenstein 0.75" => HenyeyGreenstein::<G>::new(I2F30::from_num(0.75)).unwrap(),
            truth::henyey_greenstein(0.75);
        "HenyeyGreenstein -0.5" => HenyeyGreenstein::<G>::new(I2F30::from_num(-0.5)).unwrap(),
            truth::henyey_greenstein(-0.5);
        "Triangle" => Triangle::<G>::new(), Box::new(truth::Barycentric);
        "Bilinear" => Bilinear::<G>::new([[1.0, 3.0], [2.0, 0.0]].map(|row| row.map(q16))).unwrap(),
            Box::new(truth::Bilinear([[1.0, 3.0], [2.0, 0.0]]));
        "Bilinear in a corner" => Bilinear::<G>::new([[0.0, 0.0], [0.0, 1.0]].map(|row| row.map(q16))).unwrap(),
            Box::new(truth::Bilinear([[0.0, 0.0], [0.0, 1.0]]));
        "TriangleOn plane" => TriangleOn::<_, 2, G>::new(PLANE.map(|v| v.map(I16F16::from_num))).unwrap(),
            Box::new(truth::OnTriangle(PLANE.map(|[x, y]| [x, y, 0]).map(|v| v.map(f64::from))));
        "TriangleOn space" => TriangleOn::<_, 3, G>::new(SPACE.map(|v| v.map(I16F16::from_num))).unwrap(),
            Box::new(truth::OnTriangle(SPACE.map(|v| v.map(f64::from))));
        "StandardExponential" => StandardExponential::<G>::new(), truth::exponential(1.0);
        "Exponential 16" => Exponential::<_, G>::from_mean(q16(16.0)).unwrap(), truth::exponential(0.0625);
        "TruncatedExponential 8, 16" => truncated(8.0, 16.0), truth::truncated_exponential(0.125, 16.0);
        "TruncatedExponential 128, 16" => truncated(128.0, 16.0), truth::truncated_exponential(0.007_812_5, 16.0);
        "Rayleigh 5" => Rayleigh::<_, G>::new(q16(5.0)).unwrap(),
            Box::new(OnLine(|x| -(-x * x / 50.0).exp_m1()));
        "Laplace 10, 5" => Laplace::<_, G>::new(short(10.0), short(5.0)).unwrap(),
            Box::new(OnLine(|x| { let half = 0.5 * (-(x - 10.0).abs() / 5.0).exp(); if x < 10.0 { half } else { 1.0 - half } }));
        "Logistic 10, 5" => Logistic::<_, G>::new(short(10.0), short(5.0)).unwrap(),
            Box::new(OnLine(|x| 1.0 / (1.0 + (-(x - 10.0) / 5.0).exp())));
        "StandardNormalPair" => StandardNormalPair::<G>::new(), normal_pair([0.0; 2], 1.0);
        "NormalPair (100, -20), 5" => normals.unwrap(), normal_pair([100.0, -20.0], 5.0);
        "TriangleOn" => TriangleOn::<_, 2, G>::new(flat.map(|v| v.map(short))).unwrap(),
            Box::new(truth::OnTriangle(flat.map(|[x, y]| [x, y, 0.0])));
        "TriangleOn, solid" => TriangleOn::<_, 3, G>::new(solid.map(|v| v.map(short))).unwrap(),
            Box::new(truth::OnTriangle(solid));
        "Tent 2" => Tent::<_, G>::new(I16F16::from_num(2)).unwrap(), truth::tent(2.0);
    };
    // Of four words, the first two and the normal of the others, of which one is not used.
    let law = MultivariateNormal::<_, 3, G>::new(
        [100, -20, 3].map(I16F16::from_num),
        POSE.0.map(short),
        POSE.1.map(|row| row.map(I2F30::from_num)),
    );
    for axes in [[0, 1], [0, 2], [1, 2]] {
        let back = move |point: [I16F16; 3]| {
            let uniforms = pose(point.map(|x| x.to_num()));
            axes.map(|axis: usize| uniforms[axis])
        };
        let name = format!("MultivariateNormal {axes:?} {}", G::NAME);
        shapes.push(mapped(name, power, law.unwrap(), back));
    }
    // Of more uniforms, every two.
    for [i, j] in [[0, 1], [0, 2], [1, 2]] {
        let name = |of: &str| format!("{of} {i}{j} {}", G::NAME);
        let back = move |quaternion: [I2F30; 4]| {
            let uniforms = truth::Rotations::uniforms(quaternion.map(|c| c.to_num()));
            [uniforms[i], uniforms[j]]
        };
        shapes.push(mapped(name("Rotation"), power, Rotation::<G>::new(), back));
        let back = move |(shares, rest): ([I2F30; 5], I2F30)| {
            let shares: Vec<f64> = shares
                .into_iter()
                .chain([rest])
                .map(|x| x.to_num())
                .collect();
            let uniforms = truth::Simplex::uniforms(&shares);
            // Of the powers 1/5, 1/2 and 1.
            [[0, 3, 4][i], [0, 3, 4][j]].map(|axis: usize| uniforms[axis])
        };
        shapes.push(mapped(
            name("Simplex 5"),
            power,
            Simplex::<5, G>::new(),
            back,
        ));
    }
    // Coordinates in steps of 2⁻¹⁵ do not resolve what is that narrow.
    if G::NAME != Coarse::NAME {
        let half = (std::f64::consts::PI * f64::from(narrow)).sin().powi(2);
        shapes.extend(shapes! {
            "Cone of a thousandth turn" => Cone::<G>::from_turns(narrow).unwrap(),
                truth::cone(2.0 * half, 2.0 - 2.0 * half);
            "PhongLobe 1e6" => lobe(1_000_000), truth::phong(1e6);
        });
    }
    shapes
}

pub fn shapes() -> Vec<Shape> {
    let mut all = of_grade::<Fine>(&FINE);
    all.extend(of_grade::<Coarse>(&COARSE));
    all.extend(of_grade::<Compact>(&FINE));
    let interval = Interval::<I16F16>::new(I16F16::from_num(-3), I16F16::from_num(5)).unwrap();
    let truth = truth::interval(-3.0, 5.0, true);
    all.push(shape("Interval [-3, 5)".into(), &FINE, interval, truth));
    all
}
