//! Rejection, with its generator.

use crate::measured::registry::{kernels, loaded, made};
use fixed::types::I2F30;
use microwarp::rejection::{
    BallRejection, DiskRejection, Rejection, ZigguratStandardExponential, ZigguratStandardNormal,
};
use microwarp::{Error, fixed as integer, poly};

fn poisson<const MEAN: u32>() -> Result<poly::PoissonRejection, Error> {
    poly::PoissonRejection::new(MEAN as f32)
}

fn binomial<const TRIALS: u32>() -> Result<poly::BinomialRejection, Error> {
    poly::BinomialRejection::new(TRIALS, 0.25)
}

fn urn<const POPULATION: u32>() -> Result<poly::HypergeometricRejection, Error> {
    poly::HypergeometricRejection::new(POPULATION, POPULATION / 2, POPULATION / 4)
}

fn von_mises<const CONCENTRATION: u32>() -> Result<poly::VonMises, Error> {
    poly::VonMises::new(1.0, CONCENTRATION as f32)
}

fn gamma<const TENTHS: u32>() -> Result<poly::Gamma, Error> {
    poly::Gamma::new(0.1 * TENTHS as f32, 2.0)
}

fn beta() -> Result<poly::Beta, Error> {
    poly::Beta::new(2.0, 5.0)
}

fn dirichlet() -> Result<poly::Dirichlet<4>, Error> {
    poly::Dirichlet::new([0.5, 1.0, 2.0, 4.0])
}

kernels! {
    "rejection_disk_pcg32" (rng) -> [f32; 2] = DiskRejection::new().draw(rng).map_or([0.0; 2], |accepted| accepted.point);
    "rejection_ball_pcg32" (rng) -> [f32; 3] = BallRejection::new().draw(rng).map_or([0.0; 3], |accepted| accepted.point);
    "fixed_rejection_disk_pcg32" (rng) -> [I2F30; 2] =
        integer::DiskRejection::new().draw(rng).map_or([I2F30::ZERO; 2], |accepted| accepted.point);
    "fixed_rejection_disk_16_pcg32" (rng) -> [I2F30; 2] =
        integer::DiskRejection16::new().draw(rng).map_or([I2F30::ZERO; 2], |accepted| accepted.point);
    "rejection_ziggurat_standard_normal_pcg32" (rng) -> f32 =
        ZigguratStandardNormal::new().draw(rng).map_or(0.0, |accepted| accepted.point);
    "rejection_ziggurat_standard_exponential_pcg32" (rng) -> f32 =
        ZigguratStandardExponential::new().draw(rng).map_or(0.0, |accepted| accepted.point);
    "poly_poisson_rejection_100_pcg32" (rng) -> u32 =
        loaded(poisson::<100>).draw(rng).map_or(0, |accepted| accepted.point), made(poisson::<100>);
    "poly_poisson_rejection_65536_pcg32" (rng) -> u32 =
        loaded(poisson::<65536>).draw(rng).map_or(0, |accepted| accepted.point), made(poisson::<65536>);
    "poly_binomial_rejection_1000_pcg32" (rng) -> u32 =
        loaded(binomial::<1000>).draw(rng).map_or(0, |accepted| accepted.point), made(binomial::<1000>);
    "poly_hypergeometric_rejection_10000_pcg32" (rng) -> u32 =
        loaded(urn::<10_000>).draw(rng).map_or(0, |accepted| accepted.point), made(urn::<10_000>);
    "poly_von_mises_10_pcg32" (rng) -> f32 =
        loaded(von_mises::<10>).draw(rng).map_or(0.0, |accepted| accepted.point), made(von_mises::<10>);
    "poly_gamma_25_pcg32" (rng) -> f32 =
        loaded(gamma::<25>).draw(rng).map_or(0.0, |accepted| accepted.point), made(gamma::<25>);
    "poly_gamma_5_pcg32" (rng) -> f32 =
        loaded(gamma::<5>).draw(rng).map_or(0.0, |accepted| accepted.point), made(gamma::<5>);
    "poly_beta_2_5_pcg32" (rng) -> [f32; 2] =
        loaded(beta).draw(rng).map_or([0.0; 2], |accepted| accepted.point), made(beta);
    "poly_dirichlet_4_pcg32" (rng) -> [f32; 4] =
        loaded(dirichlet).draw(rng).map_or([0.0; 4], |accepted| accepted.point), made(dirichlet);
}
