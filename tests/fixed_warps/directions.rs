//! The disk and the directions.

use crate::figures::{Figures, WORD, hold, over_pairs, sample_rows};
use fixed::types::{I2F30, U0F32, U2F62, U32F32};
use microwarp::Warp;
use microwarp::fixed::warp::{Cone, CosineHemisphere, Disk, Hemisphere, PhongLobe, Sphere};
use microwarp::fixed::{Coarse, Compact, Density, Fine, Grade};
use std::f64::consts::{FRAC_1_PI, TAU};

const PAIRS: u64 = 1 << 20;

/// Sine and cosine of the polar angle of a uniform.
type Polar<'a> = &'a (dyn Fn(f64) -> (f64, f64) + Sync);

/// What is measured of a warp over directions in one grade.
#[derive(Clone, Copy, Default)]
struct Measured {
    sample: Figures,
    length: Figures,
    /// Of the first uniform; of the second times the sine, as no azimuth is known at a pole.
    back: Figures,
}

impl Measured {
    /// Keeps rms and mean of the first.
    fn join_extremes(&mut self, other: &Self) {
        for (mine, other) in [
            (&mut self.sample, &other.sample),
            (&mut self.length, &other.length),
            (&mut self.back, &other.back),
        ] {
            mine.observe_extreme(other.largest, other.at);
        }
    }
}

/// The distance of two numbers of turns.
fn apart(a: f64, b: f64) -> f64 {
    let d = a - b;
    d - d.round()
}

fn measured<W>(warp: &W, polar: Polar) -> Measured
where
    W: Warp<Uniforms = [U0F32; 2], Point = [I2F30; 3], Density = Density> + Sync,
{
    let point = |pair: [u32; 2]| warp.sample(pair.map(U0F32::from_bits));
    let exact = |pair: [u32; 2]| {
        let [u, v] = pair.map(|w| f64::from(w) * WORD);
        let (sin, cos) = polar(u);
        [sin * (TAU * v).cos(), sin * (TAU * v).sin(), cos]
    };
    let sample = over_pairs(PAIRS, |pair, observe| {
        let got = point(pair);
        assert!(warp.pdf(got) > 0, "{pair:?}");
        for (got, due) in got.into_iter().zip(exact(pair)) {
            observe(got.to_num::<f64>() - due);
        }
    });
    let length = over_pairs(PAIRS / 4, |pair, observe| {
        let square: f64 = point(pair).map(|c| c.to_num::<f64>().powi(2)).iter().sum();
        observe(square.sqrt() - 1.0);
    });
    let back = over_pairs(PAIRS / 4, |pair, observe| {
        let back = warp.invert(point(pair)).map(|u| u.to_num::<f64>());
        let [u, v] = pair.map(|w| f64::from(w) * WORD);
        observe(back[0] - u);
        observe(apart(back[1], v) * polar(u).0);
    });
    Measured {
        sample,
        length,
        back,
    }
}

fn rows(all: [Measured; 3]) -> Vec<(&'static str, [f64; 3])> {
    let mut rows = sample_rows(all.map(|m| m.sample)).to_vec();
    rows.push(("unit length", all.map(|m| m.length.largest)));
    rows.push(("round trip", all.map(|m| m.back.largest)));
    rows
}

#[test]
fn the_disk_keeps_its_stated_errors() {
    fn of<G: Grade>() -> [Figures; 2] {
        let warp = Disk::<G>::new();
        let exact = |pair: [u32; 2]| {
            let [u, v] = pair.map(|w| f64::from(w) * WORD);
            (u.sqrt(), v)
        };
        let sample = over_pairs(PAIRS, |pair, observe| {
            let got = warp.sample(pair.map(U0F32::from_bits));
            assert!(warp.pdf(got) > 0, "{pair:?}");
            let (r, v) = exact(pair);
            let due = [r * (TAU * v).cos(), r * (TAU * v).sin()];
            for (got, due) in got.into_iter().zip(due) {
                observe(got.to_num::<f64>() - due);
            }
        });
        let back = over_pairs(PAIRS / 4, |pair, observe| {
            let back = warp.invert(warp.sample(pair.map(U0F32::from_bits)));
            let (r, v) = exact(pair);
            observe(back[0].to_num::<f64>() - f64::from(pair[0]) * WORD);
            observe(apart(back[1].to_num(), v) * r);
        });
        [sample, back]
    }
    let all = [of::<Fine>(), of::<Coarse>(), of::<Compact>()];
    let mut rows = sample_rows(all.map(|[sample, _]| sample)).to_vec();
    rows.push(("round trip", all.map(|[_, back]| back.largest)));
    hold("disk.rs", "Disk", &rows);
}

#[test]
fn the_sphere_keeps_its_stated_errors() {
    let polar: Polar = &|u| (2.0 * (u * (1.0 - u)).sqrt(), 1.0 - 2.0 * u);
    let all = [
        measured(&Sphere::<Fine>::new(), polar),
        measured(&Sphere::<Coarse>::new(), polar),
        measured(&Sphere::<Compact>::new(), polar),
    ];
    hold("sphere.rs", "Sphere", &rows(all));
}

#[test]
fn the_hemisphere_keeps_its_stated_errors() {
    let polar: Polar = &|u| (((1.0 - u) * (1.0 + u)).sqrt(), u);
    let all = [
        measured(&Hemisphere::<Fine>::new(), polar),
        measured(&Hemisphere::<Coarse>::new(), polar),
        measured(&Hemisphere::<Compact>::new(), polar),
    ];
    hold("hemisphere.rs", "Hemisphere", &rows(all));
}

#[test]
fn the_cosine_hemisphere_keeps_its_stated_errors() {
    let polar: Polar = &|u| (u.sqrt(), (1.0 - u).sqrt());
    let all = [
        measured(&CosineHemisphere::<Fine>::new(), polar),
        measured(&CosineHemisphere::<Coarse>::new(), polar),
        measured(&CosineHemisphere::<Compact>::new(), polar),
    ];
    hold("hemisphere.rs", "CosineHemisphere", &rows(all));
    let warp = CosineHemisphere::<Fine>::new();
    let density = over_pairs(PAIRS / 4, |pair, observe| {
        let point = warp.sample(pair.map(U0F32::from_bits));
        observe(warp.pdf(point).to_num::<f64>() - point[2].to_num::<f64>() * FRAC_1_PI);
    });
    let bound = 0.5_f64.powi(28);
    assert!(density.largest <= bound, "{:e}", density.largest);
}

/// The direction of 1 − cos θ.
fn of_complement(a: f64) -> (f64, f64) {
    ((a * (2.0 - a)).sqrt(), 1.0 - a)
}

#[test]
fn the_cone_keeps_its_stated_errors() {
    fn of<G: Grade>(k: f64) -> Measured {
        let warp = Cone::<G>::from_one_minus_cos(U2F62::from_num(k)).unwrap();
        measured(&warp, &|u| of_complement(u * k))
    }
    fn all<G: Grade>() -> Measured {
        let mut all = of::<G>(0.3);
        for k in [2.0, 1.5, 1.0, 1e-2] {
            all.join_extremes(&of::<G>(k));
        }
        all
    }
    hold(
        "cone.rs",
        "Cone",
        &rows([all::<Fine>(), all::<Coarse>(), all::<Compact>()]),
    );
}

#[test]
fn narrow_cones_and_lobes_keep_their_digits() {
    // Of the size of the cone or lobe itself.
    for k in [1e-5, 1e-8] {
        let warp = Cone::<Fine>::from_one_minus_cos(U2F62::from_num(k)).unwrap();
        let found = measured(&warp, &|u| of_complement(u * k));
        let size = (2.0 * k).sqrt();
        println!("cone {k:e}: {:e} of {size:e}", found.sample.largest);
        assert!(found.sample.largest <= 1e-6 * size + 4.0 * 0.5_f64.powi(30));
    }
    for n in [1e5, 1e8, 4e9] {
        let warp = PhongLobe::<Fine>::new(U32F32::from_num(n)).unwrap();
        let found = measured(&warp, &lobe(n));
        let size = (2.0 / n).sqrt();
        println!("lobe {n:e}: {:e} of {size:e}", found.sample.largest);
        assert!(found.sample.largest <= 4e-6 * size + 4.0 * 0.5_f64.powi(30));
    }
}

fn lobe(n: f64) -> impl Fn(f64) -> (f64, f64) + Sync {
    move |u| of_complement(-((-u).ln_1p() / (n + 1.0)).exp_m1())
}

#[test]
fn the_lobe_keeps_its_stated_errors() {
    fn of<G: Grade>(n: f64) -> Measured {
        measured(&PhongLobe::<G>::new(U32F32::from_num(n)).unwrap(), &lobe(n))
    }
    fn all<G: Grade>() -> Measured {
        let mut all = of::<G>(50.0);
        for n in [0.0, 0.5, 1.0, 2.0, 10.0, 1e3] {
            all.join_extremes(&of::<G>(n));
        }
        all
    }
    /// The density at points of its own, of that on the axis.
    fn density<G: Grade>() -> f64 {
        let mut largest = 0.0_f64;
        for n in [0.0, 0.5, 1.0, 2.0, 10.0, 50.0, 1e3] {
            let warp = PhongLobe::<G>::new(U32F32::from_num(n)).unwrap();
            let peak = (n + 1.0) / TAU;
            let figures = over_pairs(PAIRS / 16, |pair, observe| {
                let point = warp.sample(pair.map(U0F32::from_bits));
                let [x, y, z] = point.map(|c| c.to_num::<f64>());
                // Near the axis z has lost what x and y still hold.
                let log = if z > 0.5 {
                    (-(x * x + y * y) / (1.0 + z)).ln_1p()
                } else {
                    z.ln()
                };
                observe(warp.pdf(point).to_num::<f64>() / peak - (n * log).exp());
            });
            largest = largest.max(figures.largest);
        }
        largest
    }
    let mut rows = rows([all::<Fine>(), all::<Coarse>(), all::<Compact>()]);
    let densities = [density::<Fine>(), density::<Coarse>(), density::<Compact>()];
    rows.push(("pdf, of that on the axis", densities));
    hold("lobe.rs", "PhongLobe", &rows);
}

/// Each angle gives the cone of its own cosine, cut to 2⁻³⁰ as stated: four words, and as many are lost where the angle
/// itself is cut to 32 bits and squared.
#[test]
fn an_angle_has_its_cosine() {
    let of = |word: u32| {
        Cone::<Fine>::from_angle(U0F32::from_bits(word))
            .unwrap()
            .one_minus_cos()
    };
    for k in 1..=10_000 {
        let word = k * ((1 << 31) / 10_000);
        let exact = 2.0 * (TAU / 2.0 * f64::from(word) * WORD).sin().powi(2);
        let cut = exact - of(word).to_num::<f64>();
        assert!((-4.0 * WORD..=8.0 * WORD).contains(&cut), "{word}: {cut:e}");
    }
    assert_eq!(of(1 << 31), 2);
}
