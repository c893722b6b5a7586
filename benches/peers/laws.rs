//! Contests of laws on the line and of counts, which rand_distr has too.

use crate::contestants::{FLOOR, INDEX, LIBM, POLY, RAND_DISTR, REJECTION};
use crate::draws::{accepted, tiers, word};
use host::contest::Contest;
use microwarp::discrete;
use microwarp::rejection::PoissonRejection;
use microwarp::tier::Poly;
use rand_distr::Distribution;
use rand_pcg::Pcg32;
use rand_pcg::rand_core::Rng;
use std::hint::black_box;

/// A law of rand_distr; the compiler may not know its parameters beforehand.
fn theirs<P, D: Distribution<P>>(law: D) -> impl Fn(&mut Pcg32) -> P {
    let law = black_box(law);
    move |rng| law.sample(rng)
}

/// Both have the same parameters.
macro_rules! laws {
    ($($name:ident: $warp:ident($($parameter:literal),+);)*) => {$(
        pub fn $name() -> Contest<f32> {
            tiers!(Contest::new(0.0).draw(FLOOR, word), mw::$warp::new($($parameter),+).unwrap())
                .draw(RAND_DISTR, theirs(rand_distr::$warp::new($($parameter),+).unwrap()))
        }
    )*};
}

laws! {
    cauchy: Cauchy(0.0, 1.0);
    gumbel: Gumbel(0.0, 1.0);
    weibull: Weibull(1.0, 1.5);
    pareto: Pareto(1.0, 2.5);
    log_normal: LogNormal(0.0, 0.5);
}

/// A contest of counts with the generator alone.
fn of_counts() -> Contest<u32> {
    Contest::new(0).draw(FLOOR, |rng| rng.next_u32())
}

/// Single normals, of parameters of their own.
pub fn normal() -> Contest<f32> {
    tiers!(
        Contest::new(0.0).draw(FLOOR, word),
        mw::Normal::new(0.5, 1.5).unwrap()
    )
    .draw(
        RAND_DISTR,
        theirs(rand_distr::Normal::new(0.5_f32, 1.5).unwrap()),
    )
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
