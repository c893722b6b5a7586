//! Contests of laws on the line and of counts, which rand_distr has too.

use crate::contestants::{FLOOR, INDEX, LIBM, POLY, RAND_DISTR, REJECTION};
use crate::draws::{accepted, word};
use crate::families::{Family, Kind};
use host::contest::Contest;
use host::peers::theirs;
use host::registry::{of_libm, of_poly};
use microwarp::discrete;
use microwarp::rejection::{Beta, Dirichlet, Gamma, PoissonRejection};
use microwarp::tier::{Libm, Poly};
use rand_distr::multi::MultiDistribution;
use rand_pcg::rand_core::Rng;
use std::hint::black_box;

/// The laws of the registry that rand_distr has too, each beside it.
pub fn registered() -> Vec<Family> {
    let tiers = of_libm().into_iter().zip(of_poly());
    let families = tiers.flat_map(|(libm, poly)| {
        let ours = [(LIBM, libm.build), (POLY, poly.build)];
        poly.peers.into_iter().map(move |peer| Family {
            name: peer.law,
            kind: Kind::Draw,
            peer: peer.name,
            run: Box::new(move |rounds, after_round| {
                let mut contest = Contest::new(0.0).draw(FLOOR, word);
                for (tier, build) in ours {
                    let mut block = build(&peer.parameters).expect("accepted").warp.block(false);
                    contest = contest.block(tier, move |_| block());
                }
                let contest = contest.block(RAND_DISTR, (peer.block)());
                contest.run(rounds, after_round)
            }),
        })
    });
    families.collect()
}

/// A contest of counts with the generator alone.
fn of_counts() -> Contest<u32> {
    Contest::new(0).draw(FLOOR, |rng| rng.next_u32())
}

/// Failures before a head.
pub fn geometric_of_a_half() -> Contest<u32> {
    let ours = black_box(discrete::Geometric::new(0.5).unwrap());
    let peer = theirs(rand_distr::StandardGeometric);
    of_counts()
        .draw(INDEX, move |rng| ours.draw(rng))
        .draw(RAND_DISTR, move |rng| peer(rng) as u32)
}

pub fn geometric(p: f32) -> Contest<u32> {
    let ours = black_box(discrete::Geometric::new(p).unwrap());
    let peer = theirs(rand_distr::Geometric::new(p.into()).unwrap());
    of_counts()
        .draw(INDEX, move |rng| ours.draw(rng))
        .draw(RAND_DISTR, move |rng| peer(rng) as u32)
}

/// By inversion, of a small mean.
pub fn poisson(mean: f32) -> Contest<u32> {
    let ours = black_box(discrete::Poisson::new(mean).unwrap());
    let peer = theirs::<f32, _>(rand_distr::Poisson::new(mean).unwrap());
    of_counts()
        .draw(INDEX, move |rng| ours.draw(rng))
        .draw(RAND_DISTR, move |rng| peer(rng) as u32)
}

/// By rejection, of a large mean.
pub fn poisson_rejection(mean: f32) -> Contest<u32> {
    let ours = black_box(PoissonRejection::<Poly>::new(mean).unwrap());
    let peer = theirs::<f32, _>(rand_distr::Poisson::new(mean).unwrap());
    of_counts()
        .draw(REJECTION, accepted(ours))
        .draw(RAND_DISTR, move |rng| peer(rng) as u32)
}

/// A contest of numbers with the generator alone.
fn of_numbers() -> Contest<f32> {
    Contest::new(0.0).draw(FLOOR, word)
}

pub fn gamma(shape: f32) -> Contest<f32> {
    let libm = black_box(Gamma::<Libm>::new(shape, 1.0).unwrap());
    let poly = black_box(Gamma::<Poly>::new(shape, 1.0).unwrap());
    let peer = theirs::<f32, _>(rand_distr::Gamma::new(shape, 1.0).unwrap());
    of_numbers()
        .draw(LIBM, accepted(libm))
        .draw(POLY, accepted(poly))
        .draw(RAND_DISTR, peer)
}

/// Ours gives the rest as well.
pub fn beta(a: f32, b: f32) -> Contest<f32> {
    let libm = accepted(black_box(Beta::<Libm>::new(a, b).unwrap()));
    let poly = accepted(black_box(Beta::<Poly>::new(a, b).unwrap()));
    let peer = theirs::<f32, _>(rand_distr::Beta::new(a, b).unwrap());
    of_numbers()
        .draw(LIBM, move |rng| libm(rng)[0])
        .draw(POLY, move |rng| poly(rng)[0])
        .draw(RAND_DISTR, peer)
}

pub fn dirichlet(shapes: [f32; 4]) -> Contest<[f32; 4]> {
    let libm = accepted(black_box(Dirichlet::<Libm, 4>::new(shapes).unwrap()));
    let poly = accepted(black_box(Dirichlet::<Poly, 4>::new(shapes).unwrap()));
    let peer = black_box(rand_distr::multi::Dirichlet::new(&shapes).unwrap());
    Contest::new([0.0; 4])
        .draw(FLOOR, |rng| [(); 4].map(|()| word(rng)))
        .draw(LIBM, libm)
        .draw(POLY, poly)
        .draw(RAND_DISTR, move |rng| {
            let mut shares = [0.0; 4];
            peer.sample_to_slice(rng, &mut shares);
            shares
        })
}
