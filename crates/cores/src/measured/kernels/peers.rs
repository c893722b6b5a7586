//! Peers for the same distributions, with the generator: `rand_distr`, and the textbook forms over the functions of
//! `micromath` and of `libm`.

use crate::measured::registry::kernels;
use crate::measured::textbook::{Micromath, PlainLibm, Textbook};
use rand_distr::{Distribution, Exp1, StandardNormal, UnitBall, UnitCircle, UnitDisc, UnitSphere};
use rand_pcg::Pcg32;

kernels! {
    "peer_rand_distr_unit_disc_pcg32" (rng) -> [f32; 2] = UnitDisc.sample(rng);
    "peer_rand_distr_unit_circle_pcg32" (rng) -> [f32; 2] = UnitCircle.sample(rng);
    "peer_rand_distr_unit_sphere_pcg32" (rng) -> [f32; 3] = UnitSphere.sample(rng);
    "peer_rand_distr_unit_ball_pcg32" (rng) -> [f32; 3] = UnitBall.sample(rng);
    "peer_rand_distr_exp1_pcg32" (rng) -> f32 = Exp1.sample(rng);
    "peer_rand_distr_standard_normal_pcg32" (rng) -> f32 = StandardNormal.sample(rng);

    "peer_micromath_disk_pcg32" (rng) -> [f32; 2] = Micromath::disk(rng);
    "peer_micromath_sphere_pcg32" (rng) -> [f32; 3] = Micromath::sphere(rng);
    "peer_micromath_hemisphere_pcg32" (rng) -> [f32; 3] = Micromath::hemisphere(rng);
    "peer_micromath_cosine_hemisphere_pcg32" (rng) -> [f32; 3] = Micromath::cosine_hemisphere(rng);
    "peer_micromath_phong_lobe_50_pcg32" (rng) -> [f32; 3] = Micromath::phong_lobe(50.0, rng);
    "peer_micromath_exponential_1_pcg32" (rng) -> f32 = Micromath::exponential(rng);
    "peer_micromath_normal_pair_pcg32" (rng) -> [f32; 2] = Micromath::normal_pair(rng);

    "peer_plain_libm_disk_pcg32" (rng) -> [f32; 2] = PlainLibm::disk(rng);
    "peer_plain_libm_sphere_pcg32" (rng) -> [f32; 3] = PlainLibm::sphere(rng);
    "peer_plain_libm_hemisphere_pcg32" (rng) -> [f32; 3] = PlainLibm::hemisphere(rng);
    "peer_plain_libm_cosine_hemisphere_pcg32" (rng) -> [f32; 3] = PlainLibm::cosine_hemisphere(rng);
    "peer_plain_libm_phong_lobe_50_pcg32" (rng) -> [f32; 3] = PlainLibm::phong_lobe(50.0, rng);
    "peer_plain_libm_exponential_1_pcg32" (rng) -> f32 = PlainLibm::exponential(rng);
    "peer_plain_libm_normal_pair_pcg32" (rng) -> [f32; 2] = PlainLibm::normal_pair(rng);
}
