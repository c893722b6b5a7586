//! Rejection, with its generator.

use crate::registry::kernels;
use fixed::types::I2F30;
use microwarp::fixed as integer;
use microwarp::rejection::{
    BallRejection, DiskRejection, Rejection, ZigguratStandardExponential, ZigguratStandardNormal,
};

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
}
