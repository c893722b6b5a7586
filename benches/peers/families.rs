//! The list of contests, but for laws that stand in the registry.

use crate::args::{FLOOR, INDEX, LIBM, POLY, RAND_DISTR, REJECTION};
use crate::draws::{self, accepted, word};
use crate::{anew, fills, kit, lamps, tables};
use host::contest::{Contest, Standings};
use host::peers::theirs;
use host::registry::{of_libm, of_poly};
use microwarp::discrete;
use microwarp::rejection::{Beta, Dirichlet, Gamma, PoissonRejection};
use microwarp::tier::{Libm, Poly};
use rand_distr::multi::MultiDistribution;
use rand_pcg::rand_core::Rng;
use std::hint::black_box;

#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// One sample after the other.
    Draw,
    /// Our `fill` of a slice beside the peers' single draws.
    Fill,
    /// One sample with its density after the other, or another piece of a renderer's kit, beside the published form.
    Weighed,
}

/// Runs this many rounds, with a callback after each.
pub type Run = dyn Fn(usize, &mut dyn FnMut()) -> Standings;

pub struct Family {
    pub name: &'static str,
    pub kind: Kind,
    /// What `rand_distr` stands for in this contest, where it says so of `rand`, or whose map the published one is.
    pub peer: &'static str,
    pub run: Box<Run>,
}

impl Family {
    pub fn title(&self) -> String {
        match self.kind {
            Kind::Draw => self.name.into(),
            Kind::Fill => format!("{}, filled", self.name),
            Kind::Weighed => format!("{}, with density", self.name),
        }
    }
}

/// All of them, in the order of the tables.
pub fn all() -> Vec<Family> {
    let mut all = listed();
    all.extend(registered());
    all
}

macro_rules! families {
    ($($kind:ident $name:literal $peer:literal $contest:expr;)*) => {
        /// Those that are written here.
        fn listed() -> Vec<Family> {
            vec![$(Family {
                name: $name,
                kind: Kind::$kind,
                peer: $peer,
                run: Box::new(|rounds, after_round| $contest.run(rounds, after_round)),
            }),*]
        }
    };
}

families! {
    Draw "disk" "UnitDisc" draws::disk();
    Draw "circle" "UnitCircle" draws::circle();
    Draw "sphere" "UnitSphere" draws::sphere();
    Draw "hemisphere" "UnitSphere, folded" draws::hemisphere();
    Draw "cosine hemisphere" "UnitDisc, lifted" draws::cosine_hemisphere();
    Draw "lobe" "powf and UnitCircle" draws::lobe();
    Draw "exponential" "Exp1" draws::exponential();
    Draw "normal" "StandardNormal" draws::normal();
    Draw "ball" "UnitBall" draws::ball();
    Draw "geometric, p = 1/2" "StandardGeometric" geometric_of_a_half();
    Draw "geometric, p = 0.01" "Geometric" geometric(0.01);
    Draw "Poisson, mean 10" "Poisson" poisson(10.0);
    Draw "Poisson, mean 60" "Poisson" poisson(60.0);
    Draw "Poisson, mean 30, rejection" "Poisson" poisson_rejection(30.0);
    Draw "Poisson, mean 1000" "Poisson" poisson_rejection(1000.0);
    Draw "gamma, shape 0.5" "Gamma" gamma(0.5);
    Draw "gamma, shape 2.5" "Gamma" gamma(2.5);
    Draw "gamma, shape 1000" "Gamma" gamma(1000.0);
    Draw "beta, shapes 0.5 and 3" "Beta" beta(0.5, 3.0);
    Draw "beta, shapes 2 and 5" "Beta" beta(2.0, 5.0);
    Draw "Dirichlet, 4 shapes" "Dirichlet" dirichlet([0.5, 1.0, 2.0, 4.0]);
    Draw "cdf of 8" "WeightedIndex" tables::cdf(8);
    Draw "cdf of 64" "WeightedIndex" tables::cdf(64);
    Draw "cdf of 1024" "WeightedIndex" tables::cdf(1024);
    Draw "cdf of 1048576" "WeightedIndex" tables::cdf(1 << 20);
    Draw "alias of 3" "WeightedAliasIndex" tables::alias(3);
    Draw "alias of 8" "WeightedAliasIndex" tables::alias(8);
    Draw "alias of 64" "WeightedAliasIndex" tables::alias(64);
    Draw "alias of 1024" "WeightedAliasIndex" tables::alias(1024);
    Draw "sum tree of 16, select and set" "WeightedTreeIndex" tables::tree(16);
    Draw "sum tree of 4096, select and set" "WeightedTreeIndex" tables::tree(4096);
    Draw "integer below 6" "random_range of rand" tables::below(6);
    Draw "integer below 3221225473" "random_range of rand" tables::below((3 << 30) + 1);
    Draw "integer from -20 to 20" "random_range of rand" tables::range(-20, 20);
    Draw "integer below 2^40" "random_range of rand" tables::below_of_64_bits(1 << 40);
    Draw "coin of 0.1" "random_bool of rand" tables::chance(0.1);
    Draw "shuffle of 52" "shuffle of rand" tables::shuffle(52);
    Draw "shuffle of 1000" "shuffle of rand" tables::shuffle(1000);
    Draw "choice of 5 of 52" "partial_shuffle of rand" tables::choose(52, 5);
    Draw "gamma, shape 1 to 5, anew" "Gamma" anew::gamma();
    Draw "beta, shapes 1 to 5 and 2, anew" "Beta" anew::beta();
    Draw "Student's t of 1 to 5 degrees, anew" "StudentT" anew::student_t();
    Draw "Poisson, mean 1 to 5, anew" "Poisson" anew::poisson();
    Draw "cdf of 64, anew" "WeightedIndex" anew::cdf();
    Fill "disk" "UnitDisc" fills::disk();
    Fill "sphere" "UnitSphere" fills::sphere();
    Fill "hemisphere" "UnitSphere, folded" fills::hemisphere();
    Fill "cosine hemisphere" "UnitDisc, lifted" fills::cosine_hemisphere();
    Fill "lobe" "powf and UnitCircle" fills::lobe();
    Fill "exponential" "Exp1" fills::exponential();
    Fill "normal" "StandardNormal" fills::normal();
    Weighed "sphere lamp, anew" "Shirley, Wang, Zimmerman 1996" lamps::sphere();
    Weighed "triangle lamp, anew" "Arvo 1995" lamps::triangle();
    Weighed "rectangle lamp, anew" "Urena, Fajardo, King 2013" lamps::rectangle();
    Weighed "triangle lamp, density alone" "Arvo 1995, with its sample" lamps::triangle_density();
    Weighed "rectangle lamp, density alone" "Urena et al. 2013, with its sample" lamps::rectangle_density();
    Weighed "visible normals, anew" "Heitz 2018" lamps::ggx();
    Weighed "visible reflection, anew" "Heitz 2018, Walter et al. 2007" kit::reflection();
    Weighed "masking of a view, anew" "Walter et al. 2007" kit::masking();
    Weighed "cone" "by the cosine" lamps::cone();
    Weighed "Henyey-Greenstein" "by the cosine" lamps::henyey_greenstein();
    Weighed "bilinear" "by two roots" lamps::bilinear();
    Weighed "concentric disk" "Shirley, Chiu 1997" lamps::concentric_disk();
    Weighed "concentric cosine" "Malley" lamps::cosine_hemisphere();
    Weighed "exponential law" "by the logarithm" lamps::exponential();
    Weighed "logistic law" "by the logarithm" lamps::logistic();
    Weighed "normal law" "Giles 2012" lamps::normal();
    Weighed "piecewise constant, 64" "by sums in floats" kit::piecewise();
    Weighed "piecewise constant, 64 x 32" "by sums in floats" kit::piecewise_of_rows();
    Weighed "tent filter" "by halves" kit::tent();
    Weighed "Mitchell's filter" "by a table of 128 x 128" kit::mitchell();
    Weighed "balance heuristic" "Veach, Guibas 1995" kit::balance();
    Weighed "power heuristic" "Veach, Guibas 1995" kit::power();
    Weighed "light offered to a reservoir" "Chao 1982" kit::reservoir();
    Weighed "mixture of two lobes" "by a third uniform" kit::mixture();
    Weighed "index in a picture's order" "Ahmed, Wonka 2020" kit::screen();
}

// Contests of laws on the line and of counts, which rand_distr has too.

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
