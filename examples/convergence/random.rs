//! The random methods, over the crate's uniforms, strata and warps.

use crate::integrand::{EXACT, Importance, integrand};
use crate::method::Method;
use microwarp::uniform::{self, Strata1d};
use rand_pcg::Pcg32;

/// The root of the mean square error over a number of runs with `size` as in [`Method::sizes`].
pub fn error(method: Method, size: u32, s: u32, runs: u32, rng: &mut Pcg32) -> f64 {
    match s {
        1 => rms::<1>(method, size, runs, rng),
        2 => rms::<2>(method, size, runs, rng),
        _ => rms::<6>(method, size, runs, rng),
    }
}

fn rms<const S: usize>(method: Method, size: u32, runs: u32, rng: &mut Pcg32) -> f64 {
    let squares: f64 = (0..runs)
        .map(|_| (estimate::<S>(method, size, rng) - EXACT).powi(2))
        .sum();
    (squares / f64::from(runs)).sqrt()
}

fn estimate<const S: usize>(method: Method, size: u32, rng: &mut Pcg32) -> f64 {
    match method {
        Method::Stratified => {
            let strata = Strata1d::new(size).expect("a number of strata");
            let cells = size.pow(S as u32);
            mean(cells, |cell| integrand(jittered::<S>(strata, cell, rng)))
        }
        Method::Importance => {
            let importance = Importance::new();
            mean(size, |_| {
                let (x, density) = importance.draw::<S>(rng);
                integrand(x) / density
            })
        }
        _ => mean(size, |_| {
            integrand::<S>(std::array::from_fn(|_| uniform::grid(rng)))
        }),
    }
}

/// A point of one of the equal cells of the unit cube: its index holds a stratum of each axis as a digit.
fn jittered<const S: usize>(strata: Strata1d, mut cell: u32, rng: &mut Pcg32) -> [f32; S] {
    std::array::from_fn(|_| {
        let x = strata.draw(cell % strata.count(), rng);
        cell /= strata.count();
        x
    })
}

fn mean(count: u32, value: impl FnMut(u32) -> f64) -> f64 {
    (0..count).map(value).sum::<f64>() / f64::from(count)
}
