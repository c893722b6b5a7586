//! The list of contests, but for laws that stand in the registry.

use crate::{draws, fills, integers, lamps, laws, tables};
use host::contest::Standings;

#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// One sample after the other.
    Draw,
    /// Our `fill` of a slice beside the peers' single draws.
    Fill,
    /// One sample with its density after the other, beside the published map.
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
    all.extend(laws::registered());
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
    Draw "geometric, p = 1/2" "StandardGeometric" laws::geometric_of_a_half();
    Draw "geometric, p = 0.01" "Geometric" laws::geometric(0.01);
    Draw "Poisson, mean 10" "Poisson" laws::poisson(10.0);
    Draw "Poisson, mean 60" "Poisson" laws::poisson(60.0);
    Draw "Poisson, mean 30, rejection" "Poisson" laws::poisson_rejection(30.0);
    Draw "Poisson, mean 1000" "Poisson" laws::poisson_rejection(1000.0);
    Draw "gamma, shape 0.5" "Gamma" laws::gamma(0.5);
    Draw "gamma, shape 2.5" "Gamma" laws::gamma(2.5);
    Draw "gamma, shape 1000" "Gamma" laws::gamma(1000.0);
    Draw "beta, shapes 0.5 and 3" "Beta" laws::beta(0.5, 3.0);
    Draw "beta, shapes 2 and 5" "Beta" laws::beta(2.0, 5.0);
    Draw "Dirichlet, 4 shapes" "Dirichlet" laws::dirichlet([0.5, 1.0, 2.0, 4.0]);
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
    Draw "integer below 6" "random_range of rand" integers::below(6);
    Draw "integer below 3221225473" "random_range of rand" integers::below((3 << 30) + 1);
    Draw "integer from -20 to 20" "random_range of rand" integers::range(-20, 20);
    Draw "integer below 2^40" "random_range of rand" integers::below_of_64_bits(1 << 40);
    Draw "coin of 0.1" "random_bool of rand" integers::chance(0.1);
    Draw "shuffle of 52" "shuffle of rand" integers::shuffle(52);
    Draw "shuffle of 1000" "shuffle of rand" integers::shuffle(1000);
    Draw "choice of 5 of 52" "partial_shuffle of rand" integers::choose(52, 5);
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
    Weighed "cone" "by the cosine" lamps::cone();
    Weighed "Henyey-Greenstein" "by the cosine" lamps::henyey_greenstein();
    Weighed "bilinear" "by two roots" lamps::bilinear();
    Weighed "concentric disk" "Shirley, Chiu 1997" lamps::concentric_disk();
    Weighed "concentric cosine" "Malley" lamps::cosine_hemisphere();
    Weighed "exponential law" "by the logarithm" lamps::exponential();
    Weighed "logistic law" "by the logarithm" lamps::logistic();
    Weighed "normal law" "Giles 2012" lamps::normal();
}
