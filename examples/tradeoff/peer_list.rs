//! The list of the peers' samplers: a line each.

use crate::sampler::{FromWords, Map, Numbers, Row, Way};
use crate::subject::{Name, drawn, law, map};
use host::peers::{micro, rejecting, textbook};
use host::registry::family::{BALL, COSINE, DISK, EXPONENTIAL, HEMISPHERE, LOBE, NORMAL, SPHERE};
use host::truth::{self, Point, Truth, Uniforms};
use rand_pcg::Pcg32;

/// The standard normal pair.
pub fn pair() -> Box<dyn Truth> {
    Box::new(truth::NormalPair {
        mean: [0.0; 2],
        deviation: 1.0,
    })
}

/// The unit ball: a direction, and the cube root of the third uniform as its length.
pub struct Ball;

impl Truth for Ball {
    fn sample(&self, u: Uniforms) -> Point {
        let r = u[2].cbrt();
        truth::sphere().sample(u).map(|x| r * x)
    }
    fn pdf(&self, _: Point) -> f64 {
        0.75 * std::f64::consts::FRAC_1_PI
    }
    fn invert(&self, x: Point) -> Uniforms {
        let r = truth::dot(x, x).sqrt();
        let [u, v, ..] = truth::sphere().invert(x.map(|x| x / r));
        [u, v, r.powi(3), 0.0]
    }
}

/// A distribution over the first uniform's complement.
struct Mirrored(Box<dyn Truth>);

impl Truth for Mirrored {
    fn sample(&self, [u, v, ..]: Uniforms) -> Point {
        self.0.sample([1.0 - u, v, 0.0, 0.0])
    }
    fn pdf(&self, x: Point) -> f64 {
        self.0.pdf(x)
    }
    fn invert(&self, x: Point) -> Uniforms {
        let [u, v, ..] = self.0.invert(x);
        [1.0 - u, v, 0.0, 0.0]
    }
}

const EXPONENT: f32 = 1.0 / 51.0;

#[rustfmt::skip] // one line a sampler
pub fn add(rows: &mut Vec<Row>) {
    // Those that take uniforms.
    macro_rules! maps {
        ($($family:ident, $kernel:literal => $plain:expr, $micro:expr, $truth:expr;)*) => {$(
            let name = |tier| Name::new($family, "formula", tier, format!("peer_{}_{}", str::replace(tier, " ", "_"), $kernel));
            rows.push(map(name("plain libm"), $plain, $truth));
            rows.push(map(name("micromath"), $micro, $truth));
        )*};
    }
    maps! {
        DISK, "disk" => textbook::disk, micro::disk, Box::new(truth::Disk);
        SPHERE, "sphere" => textbook::sphere, micro::sphere, truth::sphere();
        HEMISPHERE, "hemisphere" => textbook::hemisphere, micro::hemisphere, truth::hemisphere();
        COSINE, "cosine_hemisphere" => textbook::cosine_hemisphere, micro::cosine_hemisphere, truth::cosine_hemisphere();
        LOBE, "phong_lobe_50" => |u| textbook::lobe(EXPONENT, u), |u| micro::lobe(EXPONENT, u),
            Box::new(Mirrored(truth::phong(50.0)));
        EXPONENTIAL, "exponential_1" => textbook::exponential, micro::exponential, truth::exponential(1.0);
        NORMAL, "normal_pair" => textbook::normal_pair, micro::normal_pair, pair();
    }
    let ball = Name::new(BALL, "formula", "plain libm", "peer_plain_libm_ball");
    rows.push(map(ball, textbook::ball, Box::new(Ball)));
    // Those that reject: exact but for the numbers they return, or for what is computed of accepted points.
    macro_rules! rejecting {
        ($($family:ident, $name:literal, $kernel:literal => $draw:expr, $way:expr, $truth:expr, $axes:literal;)*) => {$({
            let name = Name::new($family, $name, "rand_distr", concat!("peer_rand_distr_", $kernel));
            rows.push(drawn(name, false, $draw, law($truth, $axes), $way));
        })*};
    }
    let floats = || Way::Rejection(Numbers::Floats);
    rejecting! {
        DISK, "UnitDisc", "unit_disc" => rejecting::disk, floats(), Box::new(truth::Disk), 2;
        SPHERE, "UnitSphere", "unit_sphere" => rejecting::sphere, Way::Repaired(outwards), truth::sphere(), 2;
        HEMISPHERE, "UnitSphere, folded", "hemisphere" => rejecting::hemisphere, Way::Repaired(outwards), truth::hemisphere(), 2;
        COSINE, "UnitDisc, lifted", "cosine_hemisphere" => rejecting::cosine_hemisphere, Way::Repaired(lifted), truth::cosine_hemisphere(), 2;
        LOBE, "UnitCircle at a height", "phong_lobe_50" => lobe, at_height(), Box::new(Mirrored(truth::phong(50.0))), 2;
        EXPONENTIAL, "Exp1", "exp1" => rejecting::exponential, floats(), truth::exponential(1.0), 1;
        BALL, "UnitBall", "unit_ball" => rejecting::ball, floats(), Box::new(Ball), 3;
    }
    let normal = Name::new(NORMAL, "StandardNormal", "rand_distr", "peer_rand_distr_standard_normal");
    let law = law(truth::normal(0.0, 1.0), 1);
    rows.push(drawn(normal, false, rejecting::normal, law, floats()).twice());
}

fn lobe(rng: &mut Pcg32) -> [f32; 3] {
    rejecting::lobe(EXPONENT, rng)
}

/// The direction that one of about unit length stands for: it is off by no less than its length.
fn outwards(x: [f64; 3]) -> [f64; 3] {
    let length = truth::dot(x, x).sqrt();
    x.map(|x| x / length)
}

/// The direction above a point of the disk.
fn lifted([x, y, _]: [f64; 3]) -> [f64; 3] {
    [x, y, (1.0 - (x * x + y * y)).max(0.0).sqrt()]
}

/// The height of `rejecting::lobe` and its distance from the axis, with an azimuth as if that were exact.
fn at_height() -> Way {
    let at = |words: [u32; 4]| {
        let z = f32::of(&words).powf(EXPONENT);
        let r = f64::from((1.0 - z * z).sqrt());
        let (s, c) = (std::f64::consts::TAU * f64::from(f32::of(&words[1..]))).sin_cos();
        ([r * c, r * s, f64::from(z)], None)
    };
    Way::Map(Map {
        bits: <f32 as FromWords>::BITS,
        at: Box::new(at),
    })
}
