//! The disk and the directions.

use super::figures::{Figures, WORD, hold, over_pairs, sample_rows};
use crate::raw::{Raw, raw, signed};
use fixed::types::{I2F30, U0F32, U2F62, U32F32};
use host::truth::{self, Truth};
use microwarp::fixed::warp::{
    Cone, CosineHemisphere, Disk, Hemisphere, HenyeyGreenstein, PhongLobe, Sphere,
};
use microwarp::fixed::{Coarse, Compact, Fine, Grade};
use microwarp::{Error, Warp};
use std::f64::consts::{FRAC_1_PI, TAU};

const PAIRS: u64 = 1 << 20;

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
            mine.join_extreme(other);
        }
    }
}

/// The distance of two numbers of turns, with its sign.
fn turned(a: f64, b: f64) -> f64 {
    let d = a - b;
    d - d.round()
}

/// The exact point of a pair of words.
fn exact(truth: &dyn Truth, pair: [u32; 2]) -> [f64; 3] {
    let [u, v] = pair.map(|w| f64::from(w) * WORD);
    truth.sample([u, v, 0.0, 0.0])
}

/// The step of a coordinate.
const STEP: f64 = 4.0 * WORD;

fn measured(warp: Box<dyn Raw>, truth: &dyn Truth) -> Measured {
    let point = |pair: [u32; 2]| -> [f64; 3] { signed(warp.sample(&pair), STEP) };
    let sample = over_pairs(PAIRS, |pair, observe| {
        assert!(warp.pdf(&warp.sample(&pair)) > 0, "{pair:?}");
        for (got, due) in point(pair).into_iter().zip(exact(truth, pair)) {
            observe(got - due);
        }
    });
    let length = over_pairs(PAIRS / 4, |pair, observe| {
        let square: f64 = point(pair).map(|c| c.powi(2)).iter().sum();
        observe(square.sqrt() - 1.0);
    });
    let back = over_pairs(PAIRS / 4, |pair, observe| {
        let back = warp.invert(&warp.sample(&pair));
        let [u, v] = [0, 1].map(|i| [back[i], pair[i]].map(|w| f64::from(w) * WORD));
        observe(u[0] - u[1]);
        let sine = exact(truth, [pair[0], 0])[0];
        observe(turned(v[0], v[1]) * sine);
    });
    Measured {
        sample,
        length,
        back,
    }
}

fn rows(all: [Measured; 3]) -> Vec<(&'static str, [f64; 3])> {
    let mut rows = sample_rows(all.map(|m| m.sample)).to_vec();
    rows.push(("unit length", all.map(|m| m.length.max)));
    rows.push(("round trip", all.map(|m| m.back.max)));
    rows
}

#[test]
fn the_disk_keeps_its_stated_errors() {
    fn of(warp: Box<dyn Raw>) -> [Figures; 2] {
        let sample = over_pairs(PAIRS, |pair, observe| {
            let got = warp.sample(&pair);
            assert!(warp.pdf(&got) > 0, "{pair:?}");
            let got: [f64; 2] = signed(got, STEP);
            for (got, due) in got.into_iter().zip(exact(&truth::Disk, pair)) {
                observe(got - due);
            }
        });
        let back = over_pairs(PAIRS / 4, |pair, observe| {
            let back = warp.invert(&warp.sample(&pair));
            let [u, v] = [0, 1].map(|i| [back[i], pair[i]].map(|w| f64::from(w) * WORD));
            observe(u[0] - u[1]);
            observe(turned(v[0], v[1]) * u[1].sqrt());
        });
        [sample, back]
    }
    let all = [
        of(raw(Disk::<Fine>::new())),
        of(raw(Disk::<Coarse>::new())),
        of(raw(Disk::<Compact>::new())),
    ];
    let mut rows = sample_rows(all.map(|[sample, _]| sample)).to_vec();
    rows.push(("round trip", all.map(|[_, back]| back.max)));
    hold("Disk", &rows);
}

#[test]
fn the_sphere_keeps_its_stated_errors() {
    let truth = truth::sphere();
    let truth = truth.as_ref();
    let all = [
        measured(raw(Sphere::<Fine>::new()), truth),
        measured(raw(Sphere::<Coarse>::new()), truth),
        measured(raw(Sphere::<Compact>::new()), truth),
    ];
    hold("Sphere", &rows(all));
}

#[test]
fn the_hemisphere_keeps_its_stated_errors() {
    let truth = truth::hemisphere();
    let truth = truth.as_ref();
    let all = [
        measured(raw(Hemisphere::<Fine>::new()), truth),
        measured(raw(Hemisphere::<Coarse>::new()), truth),
        measured(raw(Hemisphere::<Compact>::new()), truth),
    ];
    hold("Hemisphere", &rows(all));
}

#[test]
fn the_cosine_hemisphere_keeps_its_stated_errors() {
    let truth = truth::cosine_hemisphere();
    let truth = truth.as_ref();
    let all = [
        measured(raw(CosineHemisphere::<Fine>::new()), truth),
        measured(raw(CosineHemisphere::<Coarse>::new()), truth),
        measured(raw(CosineHemisphere::<Compact>::new()), truth),
    ];
    hold("CosineHemisphere", &rows(all));
    let warp = CosineHemisphere::<Fine>::new();
    let density = over_pairs(PAIRS / 4, |pair, observe| {
        let point = warp.sample(pair.map(U0F32::from_bits));
        observe(warp.pdf(point).to_num::<f64>() - point[2].to_num::<f64>() * FRAC_1_PI);
    });
    let bound = 0.5_f64.powi(28);
    assert!(density.max <= bound, "{:e}", density.max);
}

#[test]
fn the_cone_keeps_its_stated_errors() {
    fn of<G: Grade>(k: f64) -> Measured {
        let warp = Cone::<G>::from_one_minus_cos(U2F62::from_num(k)).unwrap();
        measured(raw(warp), truth::cone(k, 2.0 - k).as_ref())
    }
    fn all<G: Grade>() -> Measured {
        let mut all = of::<G>(0.3);
        for k in [2.0, 1.5, 1.0, 1e-2] {
            all.join_extremes(&of::<G>(k));
        }
        all
    }
    hold(
        "Cone",
        &rows([all::<Fine>(), all::<Coarse>(), all::<Compact>()]),
    );
}

#[test]
fn the_phase_function_keeps_its_stated_errors() {
    fn of<G: Grade>(g: f32) -> Measured {
        let warp = HenyeyGreenstein::<G>::new(I2F30::from_num(g)).unwrap();
        measured(raw(warp), truth::henyey_greenstein(g).as_ref())
    }
    fn all<G: Grade>() -> Measured {
        let mut all = of::<G>(0.8);
        for g in [0.0, -0.5, 0.25, -0.875, 0.96875] {
            all.join_extremes(&of::<G>(g));
        }
        all
    }
    hold(
        "HenyeyGreenstein",
        &rows([all::<Fine>(), all::<Coarse>(), all::<Compact>()]),
    );
}

#[test]
fn an_asymmetry_near_1_is_given_by_its_complement() {
    type Fog = HenyeyGreenstein<Fine>;
    let of = |bits: u64| Fog::from_one_minus(U2F62::from_bits(bits));
    let one = 1_u64 << 62;
    assert_eq!(of(0), Err(Error::OutOfRange(0)));
    assert_eq!(of(2 * one), Err(Error::OutOfRange(0)));
    assert_eq!(of(u64::MAX), Err(Error::OutOfRange(0)));
    for least in [1, (one >> 17) - 1] {
        assert_eq!(of(least), Err(Error::Empty(0)));
        assert_eq!(of(2 * one - least), Err(Error::Empty(0)));
    }
    for bits in [
        one >> 17,
        2 * one - (one >> 17),
        one,
        one / 3,
        one + one / 3,
    ] {
        let fog = of(bits).unwrap();
        assert_eq!(fog.one_minus_asymmetry(), U2F62::from_bits(bits));
        // The peak, the largest density there is.
        let z = if bits > one { -1 } else { 1 };
        assert!(fog.pdf([0, 0, z].map(I2F30::from_num)) > 0);
    }
    for g in [0, 1, -1, 12_345, -(3 << 28), (1 << 30) - (1 << 13)] {
        let g = I2F30::from_bits(g);
        let complement = U2F62::from_num(1) - U2F62::from_num(g.abs());
        let complement = if g < 0 {
            U2F62::from_bits(2 * one - complement.to_bits())
        } else {
            complement
        };
        assert_eq!(Fog::new(g), of(complement.to_bits()));
    }
    for g in [I2F30::ONE, -I2F30::ONE, I2F30::MIN, I2F30::MAX] {
        assert_eq!(Fog::new(g), Err(Error::OutOfRange(0)));
    }
    assert_eq!(Fog::new(I2F30::ONE - I2F30::DELTA), Err(Error::Empty(0)));
}

#[test]
fn narrow_cones_and_lobes_keep_their_digits() {
    // Of the size of the cone or lobe itself.
    for k in [1e-5, 1e-8] {
        let warp = Cone::<Fine>::from_one_minus_cos(U2F62::from_num(k)).unwrap();
        let found = measured(raw(warp), truth::cone(k, 2.0 - k).as_ref());
        let size = (2.0 * k).sqrt();
        println!("cone {k:e}: {:e} of {size:e}", found.sample.max);
        assert!(found.sample.max <= 1e-6 * size + 4.0 * 0.5_f64.powi(30));
    }
    for n in [1e5_f64, 1e8, 4e9] {
        let warp = PhongLobe::<Fine>::new(U32F32::from_num(n)).unwrap();
        let found = measured(raw(warp), truth::phong(n as f32).as_ref());
        let size = (2.0 / n).sqrt();
        println!("lobe {n:e}: {:e} of {size:e}", found.sample.max);
        assert!(found.sample.max <= 4e-6 * size + 4.0 * 0.5_f64.powi(30));
    }
}

#[test]
fn the_lobe_keeps_its_stated_errors() {
    fn lobe<G: Grade>(n: f64) -> Box<dyn Raw> {
        raw(PhongLobe::<G>::new(U32F32::from_num(n)).unwrap())
    }
    fn of<G: Grade>(n: f64) -> Measured {
        measured(lobe::<G>(n), truth::phong(n as f32).as_ref())
    }
    fn all<G: Grade>() -> Measured {
        let mut all = of::<G>(50.0);
        for n in [0.0, 0.5, 1.0, 2.0, 10.0, 1e3] {
            all.join_extremes(&of::<G>(n));
        }
        all
    }
    /// The density at points of its own, of that on the axis.
    fn density(lobe: fn(f64) -> Box<dyn Raw>) -> f64 {
        let mut largest = 0.0_f64;
        for n in [0.0, 0.5, 1.0, 2.0, 10.0, 50.0, 1e3] {
            let (warp, peak, truth) = (lobe(n), (n + 1.0) / TAU, truth::phong(n as f32));
            let figures = over_pairs(PAIRS / 16, |pair, observe| {
                let point = warp.sample(&pair);
                let due = truth.pdf(signed(point, STEP));
                observe((warp.pdf(&point).to_num::<f64>() - due) / peak);
            });
            largest = largest.max(figures.max);
        }
        largest
    }
    let mut rows = rows([all::<Fine>(), all::<Coarse>(), all::<Compact>()]);
    let densities = [lobe::<Fine>, lobe::<Coarse>, lobe::<Compact>].map(density);
    rows.push(("pdf, of that on the axis", densities));
    hold("PhongLobe", &rows);
}

/// Each angle gives the cone of its own cosine: some words are lost where the angle itself is cut to 32 bits and squared.
#[test]
fn an_angle_has_its_cosine() {
    let of = |word: u32| {
        Cone::<Fine>::from_turns(U0F32::from_bits(word))
            .unwrap()
            .one_minus_cos()
    };
    for k in 1..=10_000 {
        let word = k * ((1 << 31) / 10_000);
        let exact = 2.0 * (TAU / 2.0 * f64::from(word) * WORD).sin().powi(2);
        let cut = exact - of(word).to_num::<f64>();
        assert!((-4.0 * WORD..=5.0 * WORD).contains(&cut), "{word}: {cut:e}");
    }
    assert_eq!(of(1 << 31), 2);
}
