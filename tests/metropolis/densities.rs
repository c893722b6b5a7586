//! The targets, each with the coordinates that make it uniform, exactly and in f64, and the cells that its states are
//! counted in.

use rand_core::TryRng;
use rand_pcg::Pcg32;
use statrs::distribution::{ContinuousCDF, Normal};
use std::f64::consts::{FRAC_1_PI, LN_10};

/// (x − ½)² on [0, 1], and nothing beside it.
pub fn parabola(x: f32) -> f32 {
    if (0.0..=1.0).contains(&x) {
        (x - 0.5) * (x - 0.5)
    } else {
        0.0
    }
}

pub fn parabola_cells() -> Cells<f32> {
    Cells::uniform(|x: f32| [0.5 + 0.5 * (2.0 * f64::from(x) - 1.0).powi(3)])
}

/// A draw from it: no chain needs to forget this start.
pub fn on_parabola(rng: &mut Pcg32) -> f32 {
    let Ok(word) = rng.try_next_u32();
    let u = (f64::from(word) + 0.5) / 4_294_967_296.0;
    (0.5 + 0.5 * (2.0 * u - 1.0).cbrt()) as f32
}

/// Two normals in the plane, of unlike weight and width: weight, mean, deviation.
const BLOBS: [(f64, [f64; 2], f64); 2] = [(0.6, [-1.0, 0.5], 0.7), (0.4, [1.25, -0.5], 0.5)];

pub fn blobs([x, y]: [f32; 2]) -> f32 {
    let terms = BLOBS.map(|(weight, mean, deviation)| {
        let [mx, my] = mean.map(|m| m as f32);
        let square = (x - mx) * (x - mx) + (y - my) * (y - my);
        let (weight, variance) = (weight as f32, (deviation * deviation) as f32);
        weight / variance * (-0.5 * square / variance).exp()
    });
    terms[0] + terms[1]
}

/// The marginal distribution function of x, and that of y given x.
pub fn blobs_cells() -> Cells<[f32; 2]> {
    let normal = Normal::standard();
    Cells::uniform(move |point: [f32; 2]| {
        let [x, y] = point.map(f64::from);
        let (mut below, mut density, mut both) = (0.0, 0.0, 0.0);
        for (weight, [mx, my], deviation) in BLOBS {
            let t = (x - mx) / deviation;
            let here = weight / deviation * (-0.5 * t * t).exp();
            below += weight * normal.cdf(t);
            density += here;
            both += here * normal.cdf((y - my) / deviation);
        }
        [below, both / density]
    })
}

/// The least and the largest state of the power law below.
const DECADES: (f32, f32) = (1e-15, 1e15);
const POWER: f64 = 0.95;

/// ln x^−0.95 over thirty decades: densities from 1e-14 to 1e14, all of which a chain meets.
pub fn log_power(x: f32) -> f64 {
    if (DECADES.0..=DECADES.1).contains(&x) {
        -POWER * f64::from(x).ln()
    } else {
        f64::NEG_INFINITY
    }
}

pub fn power_cells() -> Cells<f32> {
    let rest = 1.0 - POWER;
    let [least, most] = [DECADES.0, DECADES.1].map(|x| f64::from(x).powf(rest));
    Cells::uniform(move |x: f32| [(f64::from(x).powf(rest) - least) / (most - least)])
}

/// A density that falls by thirty decades across the unit interval: ln of 10^(15 − 30u).
pub fn log_cliff(u: f32) -> f64 {
    LN_10 * (15.0 - 30.0 * f64::from(u))
}

pub fn cliff_cells() -> Cells<f32> {
    // The states are multiples of 2⁻²⁴ from 0 up: each stands for the cell above it.
    let middle = |u: f32| f64::from(u) + 0.5 / 16_777_216.0;
    Cells::uniform(move |u| [(-30.0 * LN_10 * middle(u)).exp_m1() / (-30.0 * LN_10).exp_m1()])
}

/// x² e^−x.
pub fn gamma(x: f32) -> f32 {
    if x > 0.0 { x * x * (-x).exp() } else { 0.0 }
}

pub fn gamma_cells() -> Cells<f32> {
    Cells::uniform(|x: f32| {
        let x = f64::from(x);
        [1.0 - (-x).exp() * (1.0 + x + 0.5 * x * x)]
    })
}

/// (x − ½)², but that it is none below 0.2.
pub fn gap(x: f32) -> f32 {
    if x < 0.2 { f32::NAN } else { parabola(x) }
}

pub fn gap_cells() -> Cells<f32> {
    // (x − ½)³ runs from −0.027 to 0.125. A state in the gap is in no cell.
    let low = (f64::from(0.2_f32) - 0.5).powi(3);
    Cells::uniform(move |x: f32| [((f64::from(x) - 0.5).powi(3) - low) / (0.125 - low)])
}

/// 1/(1 + x²).
pub fn cauchy(x: f32) -> f32 {
    1.0 / (1.0 + x * x)
}

pub fn cauchy_cells() -> Cells<f32> {
    Cells::uniform(|x: f32| [0.5 + FRAC_1_PI * f64::from(x).atan()])
}

/// The exponent of the lobe.
pub const SHINE: f32 = 20.0;

/// Directions of density cos²⁰θ, out of the uniforms of a warp that is not made for them: `z` of a uniform
/// and the azimuth are all that it takes from them.
pub fn lobe_cells(z: fn(f64) -> f64) -> Cells<[f32; 2]> {
    let power = i32::from(SHINE as i16) + 1;
    Cells::uniform(move |[u, turns]: [f32; 2]| {
        // Uniforms stand for the cells above them, 2⁻²⁴ wide: nothing that is seen here.
        [1.0 - z(f64::from(u)).powi(power), f64::from(turns)]
    })
}

/// What a batch is counted in.
pub struct Cells<X> {
    /// The cell of a state; nothing outside the target's domain.
    pub place: Box<dyn Fn(X) -> Option<usize>>,
    /// The exact probabilities.
    pub exact: Vec<f64>,
}

impl<X: Copy + 'static> Cells<X> {
    /// Equal cells in coordinates that make the target uniform.
    pub fn uniform<const A: usize>(uniforms: impl Fn(X) -> [f64; A] + 'static) -> Self {
        let counts: &[usize] = if A == 1 { &[20] } else { &[5, 4] };
        let place = move |x| {
            let u = uniforms(x);
            let inside = u.iter().all(|u| (0.0..=1.0).contains(u));
            inside.then(|| {
                u.iter().zip(counts).fold(0, |cell, (u, &count)| {
                    cell * count + ((u * count as f64) as usize).min(count - 1)
                })
            })
        };
        Self {
            place: Box::new(place),
            exact: vec![0.05; 20],
        }
    }
}
