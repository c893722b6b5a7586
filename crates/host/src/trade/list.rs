//! The list of the samplers: a line each.

use super::{Sampler, WORD, flat, repaired, sweep};
use crate::figures::{Exact, wide};
use crate::generators::Cycle;
use crate::peers::{drawn, micro, rejecting, textbook};
use crate::registry::{Domain, Entry, entries_of_each_tier, evidence::*};
use crate::truth::{self, Point, Truth, Uniforms};
use fixed::types::U32F32;
use microwarp::fixed::{self as integers, Coarse, Compact, Fine, Grade, warp as integer};
use microwarp::rejection as reject;
use microwarp::rejection::Rejection;
use microwarp::{Warp, uniform::Uniforms as _};
use rand_pcg::Pcg32;

type Law = Box<dyn Truth>;

/// All of them, by family.
pub fn samplers() -> Vec<Sampler> {
    let entries = entries_of_each_tier().into_iter();
    let mut all: Vec<Sampler> = entries.filter_map(registered).collect();
    of_grade::<Fine>(&mut all, "fine in f32");
    of_grade::<Coarse>(&mut all, "coarse in f32");
    of_grade::<Compact>(&mut all, "compact in f32");
    rejections(&mut all);
    formulas(&mut all);
    all.sort_by_key(|s| PICTURED.iter().position(|family| *family == s.family));
    all
}

/// A warp of the float tiers.
fn registered(entry: Entry) -> Option<Sampler> {
    let trade = entry.trade?;
    let is_half = trade.family == NORMAL && entry.domain == Domain::Line;
    Some(Sampler {
        family: trade.family,
        name: entry.name,
        tier: entry.tier,
        kernel: format!("{}_{}", entry.tier, trade.kernel),
        calls: if is_half { 2.0 } else { 1.0 },
        block: entry.warp.block(false),
        error: Box::new(move |points| {
            sweep(24, entry.uniforms, points, &|u| {
                let u = u.map(|u| u as f32);
                let exact = Exact::of(&entry, u, false).point;
                [exact, wide(entry.warp.sample(u))]
            })
        }),
    })
}

/// A warp whose uniforms are words.
fn of_words<W>(
    name: [&'static str; 3],
    kernel: String,
    warp: W,
    law: Law,
    flat: fn(W::Point) -> Point,
) -> Sampler
where
    W: Warp<Point: Copy + Default + 'static> + Copy + 'static,
{
    let error = move |points| {
        sweep(32, W::Uniforms::COUNT, points, &|u| {
            let words = u.map(|u| (u / WORD) as u32);
            [law.sample(u), flat(warp.draw(&mut Cycle::new(&words)))]
        })
    };
    Sampler::new(name, kernel, move |rng| warp.draw(rng), error)
}

/// The warps of a grade, and those of them that hand over floats.
fn of_grade<G: Grade>(all: &mut Vec<Sampler>, floats: &'static str) {
    let grade = G::NAME;
    macro_rules! both {
        ($($family:ident, $name:literal, $kernel:literal, $warp:expr, $law:expr, $flat:expr;)*) => {$(
            let kernel = format!("{grade}_{}", $kernel);
            all.push(of_words([$family, $name, grade], kernel, $warp, $law, $flat));
            let kernel = format!("{grade}_float_{}", $kernel);
            let of_floats = integers::Float::new($warp);
            all.push(of_words([$family, $name, floats], kernel, of_floats, $law, $flat));
        )*};
    }
    let lobe = integer::PhongLobe::<G>::new(U32F32::from_num(50)).expect("an exponent");
    let (exponential, pair) = (
        integer::StandardExponential::<G>::new(),
        integer::StandardNormalPair::<G>::new(),
    );
    both! {
        DISK, "Disk", "disk", integer::Disk::<G>::new(), disk(), flat;
        SPHERE, "Sphere", "sphere", integer::Sphere::<G>::new(), truth::sphere(), flat;
        COSINE, "CosineHemisphere", "cosine_hemisphere", integer::CosineHemisphere::<G>::new(), truth::cosine_hemisphere(), flat;
        LOBE, "PhongLobe", "phong_lobe_50", lobe, truth::phong(50.0), flat;
        EXPONENTIAL, "StandardExponential", "standard_exponential", exponential, truth::exponential(1.0), |x| flat([x]);
        NORMAL, "StandardNormalPair", "standard_normal_pair", pair, two_normals(), flat;
    }
    let hemisphere = integer::Hemisphere::<G>::new();
    let name = [HEMISPHERE, "Hemisphere", grade];
    all.push(of_words(
        name,
        format!("{grade}_hemisphere"),
        hemisphere,
        truth::hemisphere(),
        flat,
    ));
}

/// What is exact in law: its error is that of a point of the law which is rounded to the nearest that the sampler returns.
fn rounded(axes: usize, law: Law, nearest: fn(f64) -> f64) -> impl Fn(u64) -> f64 {
    move |points| {
        sweep(24, axes, points, &|u| {
            let exact = law.sample(u);
            [exact, exact.map(nearest)]
        })
    }
}

/// A point that is accepted. A budget that is spent, which no true generator does, shows as 0.
fn accepted<S: Rejection<Point: Default>>(sampler: S) -> impl Fn(&mut Pcg32) -> S::Point {
    move |rng| {
        sampler
            .draw(rng)
            .map_or_else(|_| S::Point::default(), |accepted| accepted.point)
    }
}

/// What rejects: ours, and what rand_distr has or what its users make of it, whose error is what is seen of it.
fn rejections(all: &mut Vec<Sampler>) {
    macro_rules! list {
        ($($calls:literal $family:ident, $name:literal, $tier:literal, $kernel:literal => $draw:expr, $error:expr;)*) => {
            $(let sampler = Sampler::new([$family, $name, $tier], $kernel, $draw, $error);
            all.push(Sampler { calls: $calls, ..sampler });)*
        };
    }
    let lobe = |rng: &mut Pcg32| rejecting::lobe(POWER, rng);
    let float = |x| f64::from(x as f32);
    list! {
        1.0 DISK, "DiskRejection", "rejection", "rejection_disk"
            => accepted(reject::DiskRejection::new()), rounded(2, disk(), float);
        1.0 DISK, "fixed::DiskRejection", "fixed rejection", "fixed_rejection_disk"
            => accepted(integers::DiskRejection::new()), rounded(2, disk(), |x| to_step(x, 29));
        1.0 DISK, "fixed::DiskRejection16", "16-bit rejection", "fixed_rejection_disk_16"
            => accepted(integers::DiskRejection16::new()), rounded(2, disk(), |x| to_step(x, 15));
        1.0 EXPONENTIAL, "ZigguratStandardExponential", "ziggurat", "rejection_ziggurat_standard_exponential"
            => accepted(reject::ZigguratStandardExponential::new()), rounded(1, truth::exponential(1.0), float);
        2.0 NORMAL, "ZigguratStandardNormal", "ziggurat", "rejection_ziggurat_standard_normal"
            => accepted(reject::ZigguratStandardNormal::new()), rounded(1, truth::normal(0.0, 1.0), float);
        1.0 DISK, "UnitDisc", "rand_distr", "peer_rand_distr_unit_disc" => rejecting::disk, rounded(2, disk(), float);
        1.0 SPHERE, "UnitSphere", "rand_distr", "peer_rand_distr_unit_sphere"
            => rejecting::sphere, repaired(rejecting::sphere, outwards);
        1.0 HEMISPHERE, "UnitSphere folded", "rand_distr", ""
            => rejecting::hemisphere, repaired(rejecting::hemisphere, outwards);
        1.0 COSINE, "UnitDisc lifted", "rand_distr", ""
            => rejecting::cosine_hemisphere, repaired(rejecting::cosine_hemisphere, lifted);
        1.0 LOBE, "UnitCircle at a height", "rand_distr", "" => lobe, at_height;
        1.0 EXPONENTIAL, "Exp1", "rand_distr", "peer_rand_distr_exp1"
            => rejecting::exponential, rounded(1, truth::exponential(1.0), float);
        2.0 NORMAL, "StandardNormal", "rand_distr", "peer_rand_distr_standard_normal"
            => rejecting::normal, rounded(1, truth::normal(0.0, 1.0), float);
    }
}

/// The nearest multiple of a power of a half.
fn to_step(x: f64, power: i32) -> f64 {
    let step = 0.5_f64.powi(power);
    (x / step).round() * step
}

/// The direction that one of about unit length stands for: it is off by no less than its length.
fn outwards(x: Point) -> Point {
    let length = truth::dot(x, x).sqrt();
    x.map(|x| x / length)
}

/// The direction above a point of the disk.
fn lifted([x, y, _]: Point) -> Point {
    [x, y, (1.0 - (x * x + y * y)).max(0.0).sqrt()]
}

/// The peers' lobe raises to 1/(n + 1).
const POWER: f32 = 1.0 / 51.0;

/// Their lobe of n = 50, in which the complement of our first uniform is a height.
fn mirrored([u, v, ..]: Uniforms) -> Point {
    truth::phong(50.0).sample([1.0 - u, v, 0.0, 0.0])
}

/// The error of the height of `rejecting::lobe` and of its distance from the axis, as if its azimuth were exact.
fn at_height(points: u64) -> f64 {
    sweep(24, 2, points, &|u| {
        let z = (u[0] as f32).powf(POWER);
        let r = f64::from((1.0 - z * z).sqrt());
        let (s, c) = (std::f64::consts::TAU * u[1]).sin_cos();
        [mirrored(u), [r * c, r * s, f64::from(z)]]
    })
}

/// The formulas of books over the functions of libm and over those of micromath.
fn formulas(all: &mut Vec<Sampler>) {
    fn map<const N: usize, P: Copy + Default + 'static>(
        name: [&'static str; 3],
        kernel: String,
        map: impl Fn([f32; N]) -> P + Copy + 'static,
        law: impl Fn(Uniforms) -> Point + 'static,
        flat: fn(P) -> Point,
    ) -> Sampler {
        let error = move |points| {
            sweep(24, N, points, &|u| {
                let point = map(std::array::from_fn(|i| u[i] as f32));
                [law(u), flat(point)]
            })
        };
        Sampler::new(name, kernel, drawn(map), error)
    }
    macro_rules! both {
        ($($family:ident, $kernel:literal, $libm:expr, $micromath:expr, $law:expr, $flat:expr;)*) => {$(
            let kernel = format!("peer_plain_libm_{}", $kernel);
            all.push(map([$family, "formula", "plain libm"], kernel, $libm, $law, $flat));
            let kernel = format!("peer_micromath_{}", $kernel);
            all.push(map([$family, "formula", "micromath"], kernel, $micromath, $law, $flat));
        )*};
    }
    fn of(law: Law) -> impl Fn(Uniforms) -> Point {
        move |u| law.sample(u)
    }
    both! {
        DISK, "disk", textbook::disk, micro::disk, of(disk()), flat;
        SPHERE, "sphere", textbook::sphere, micro::sphere, of(truth::sphere()), flat;
        HEMISPHERE, "hemisphere", textbook::hemisphere, micro::hemisphere, of(truth::hemisphere()), flat;
        COSINE, "cosine_hemisphere", textbook::cosine_hemisphere, micro::cosine_hemisphere, of(truth::cosine_hemisphere()), flat;
        LOBE, "phong_lobe_50", |u| textbook::lobe(POWER, u), |u| micro::lobe(POWER, u), mirrored, flat;
        EXPONENTIAL, "exponential_1", textbook::exponential, micro::exponential, of(truth::exponential(1.0)), |x| flat([x]);
        NORMAL, "normal_pair", textbook::normal_pair, micro::normal_pair, of(two_normals()), flat;
    }
}

fn disk() -> Law {
    Box::new(truth::Disk)
}

fn two_normals() -> Law {
    Box::new(truth::NormalPair {
        mean: [0.0; 2],
        deviation: 1.0,
    })
}
