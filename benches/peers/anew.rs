//! Contests of laws and tables that are made for each number: a chain over their parameters, the noise of a picture, odds that
//! change with each draw.

use crate::args::{FLOOR, INDEX, LIBM, POLY, RAND_DISTR};
use crate::tables::{of_indices, weights};
use host::contest::Contest;
use host::peers::uniform;
use microwarp::Warp as _;
use microwarp::discrete::{Cdf, Poisson};
use microwarp::rejection::{Beta, Gamma, Rejection as _};
use microwarp::tier::{Libm, Poly, Tier};
use microwarp::warp::StudentT;
use rand_distr::Distribution as _;
use rand_distr::weighted::WeightedIndex;
use rand_pcg::Pcg32;
use std::hint::black_box;

/// Draws by a parameter from 1 to 5 that nobody knows beforehand.
fn by(sample: impl Fn(f32, &mut Pcg32) -> f32 + 'static) -> impl Fn(&mut Pcg32) -> f32 {
    move |rng| {
        let parameter = 1.0 + 4.0 * uniform(rng);
        sample(parameter, rng)
    }
}

fn contest() -> Contest<f32> {
    Contest::new(0.0).draw(FLOOR, by(|parameter, rng| parameter * uniform(rng)))
}

/// Ours in both tiers beside rand_distr's.
fn of_tiers(
    libm: impl Fn(f32, &mut Pcg32) -> f32 + 'static,
    poly: impl Fn(f32, &mut Pcg32) -> f32 + 'static,
    peer: impl Fn(f32, &mut Pcg32) -> f32 + 'static,
) -> Contest<f32> {
    contest()
        .draw(LIBM, by(libm))
        .draw(POLY, by(poly))
        .draw(RAND_DISTR, by(peer))
}

pub fn gamma() -> Contest<f32> {
    fn ours<T: Tier>(shape: f32, rng: &mut Pcg32) -> f32 {
        let gamma = Gamma::<T>::new(shape, 1.0).unwrap();
        gamma.draw(rng).unwrap().point
    }
    of_tiers(ours::<Libm>, ours::<Poly>, |shape, rng| {
        rand_distr::Gamma::new(shape, 1.0).unwrap().sample(rng)
    })
}

pub fn beta() -> Contest<f32> {
    fn ours<T: Tier>(a: f32, rng: &mut Pcg32) -> f32 {
        let [share, _] = Beta::<T>::new(a, 2.0).unwrap().draw(rng).unwrap().point;
        share
    }
    of_tiers(ours::<Libm>, ours::<Poly>, |a, rng| {
        rand_distr::Beta::new(a, 2.0).unwrap().sample(rng)
    })
}

pub fn student_t() -> Contest<f32> {
    fn ours<T: Tier>(degrees: f32, rng: &mut Pcg32) -> f32 {
        StudentT::<T>::new(degrees, 0.0, 1.0).unwrap().draw(rng)
    }
    of_tiers(ours::<Libm>, ours::<Poly>, |degrees, rng| {
        rand_distr::StudentT::new(degrees).unwrap().sample(rng)
    })
}

pub fn poisson() -> Contest<f32> {
    contest()
        .draw(
            INDEX,
            by(|mean, rng| Poisson::new(mean).unwrap().draw(rng) as f32),
        )
        .draw(
            RAND_DISTR,
            by(|mean, rng| rand_distr::Poisson::new(mean).unwrap().sample(rng)),
        )
}

/// A table of 64 weights, for one index.
pub fn cdf() -> Contest<usize> {
    let weights: [f32; 64] = weights(64).try_into().unwrap();
    of_indices()
        .draw(INDEX, move |rng| {
            let table = Cdf::<[u32; 64]>::new(black_box(&weights));
            table.unwrap().draw_index(rng)
        })
        .draw(RAND_DISTR, move |rng| {
            let table = WeightedIndex::new(black_box(&weights));
            table.unwrap().sample(rng)
        })
}
