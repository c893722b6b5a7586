//! The integer tier in its three grades.

use crate::registry::{integer_warps, ok};
use fixed::types::{I2F30, I5F27, I16F16, U0F32, U2F62, U5F27, U16F16, U32F32};
use microwarp::Warp;

/// The vertices of a triangle.
const FACET: [[I16F16; 2]; 3] = [
    [I16F16::from_bits(-90 << 16), I16F16::from_bits(10 << 16)],
    [I16F16::from_bits(300 << 16), I16F16::from_bits(-200 << 16)],
    [I16F16::from_bits(40 << 16), I16F16::from_bits(250 << 16)],
];

/// A cone, a quarter of the way from its axis to the plane.
const CONE: U2F62 = U2F62::from_bits(1 << 60);

/// A number of the tier's input formats.
const fn q16(value: u32) -> U16F16 {
    U16F16::from_bits(value << 16)
}

const fn i16(value: i32) -> I16F16 {
    I16F16::from_bits(value << 16)
}

const FIFTY: U32F32 = U32F32::from_bits(50 << 32);

integer_warps! {
    "fine_disk" "fine_disk_pcg32"
    "coarse_disk" "coarse_disk_pcg32"
    "compact_disk" "compact_disk_pcg32"
        [u, v]: U0F32 -> [I2F30; 2] = Disk::new();
    "fine_sphere" "fine_sphere_pcg32"
    "coarse_sphere" "coarse_sphere_pcg32"
    "compact_sphere" "compact_sphere_pcg32"
        [u, v]: U0F32 -> [I2F30; 3] = Sphere::new();
    "fine_hemisphere" "fine_hemisphere_pcg32"
    "coarse_hemisphere" "coarse_hemisphere_pcg32"
    "compact_hemisphere" "compact_hemisphere_pcg32"
        [u, v]: U0F32 -> [I2F30; 3] = Hemisphere::new();
    "fine_cosine_hemisphere" "fine_cosine_hemisphere_pcg32"
    "coarse_cosine_hemisphere" "coarse_cosine_hemisphere_pcg32"
    "compact_cosine_hemisphere" "compact_cosine_hemisphere_pcg32"
        [u, v]: U0F32 -> [I2F30; 3] = CosineHemisphere::new();
    "fine_cone" "fine_cone_pcg32"
    "coarse_cone" "coarse_cone_pcg32"
    "compact_cone" "compact_cone_pcg32"
        [u, v]: U0F32 -> [I2F30; 3] = const { ok(Cone::from_one_minus_cos(CONE)) };
    "fine_phong_lobe_50" "fine_phong_lobe_50_pcg32"
    "coarse_phong_lobe_50" "coarse_phong_lobe_50_pcg32"
    "compact_phong_lobe_50" "compact_phong_lobe_50_pcg32"
        [u, v]: U0F32 -> [I2F30; 3] = const { ok(PhongLobe::new(FIFTY)) };
    "fine_standard_exponential" "fine_standard_exponential_pcg32"
    "coarse_standard_exponential" "coarse_standard_exponential_pcg32"
    "compact_standard_exponential" "compact_standard_exponential_pcg32"
        u: U0F32 -> U5F27 = StandardExponential::new();
    "fine_exponential_20" "fine_exponential_20_pcg32"
    "coarse_exponential_20" "coarse_exponential_20_pcg32"
    "compact_exponential_20" "compact_exponential_20_pcg32"
        u: U0F32 -> U16F16 = const { ok(Exponential::new(q16(20))) };
    "fine_truncated_exponential_10_20" "fine_truncated_exponential_10_20_pcg32"
    "coarse_truncated_exponential_10_20" "coarse_truncated_exponential_10_20_pcg32"
    "compact_truncated_exponential_10_20" "compact_truncated_exponential_10_20_pcg32"
        u: U0F32 -> U16F16 = const { ok(TruncatedExponential::new(q16(10), q16(20))) };
    "fine_truncated_exponential_10_1" "fine_truncated_exponential_10_1_pcg32"
    "coarse_truncated_exponential_10_1" "coarse_truncated_exponential_10_1_pcg32"
    "compact_truncated_exponential_10_1" "compact_truncated_exponential_10_1_pcg32"
        u: U0F32 -> U16F16 = const { ok(TruncatedExponential::new(q16(10), q16(1))) };
    "fine_standard_normal_pair" "fine_standard_normal_pair_pcg32"
    "coarse_standard_normal_pair" "coarse_standard_normal_pair_pcg32"
    "compact_standard_normal_pair" "compact_standard_normal_pair_pcg32"
        [u, v]: U0F32 -> [I5F27; 2] = StandardNormalPair::new();
    "fine_normal_pair_100_5" "fine_normal_pair_100_5_pcg32"
    "coarse_normal_pair_100_5" "coarse_normal_pair_100_5_pcg32"
    "compact_normal_pair_100_5" "compact_normal_pair_100_5_pcg32"
        [u, v]: U0F32 -> [I16F16; 2] = const { ok(NormalPair::new([i16(100); 2], i16(5))) };
    "fine_tent_2" "fine_tent_2_pcg32"
    "coarse_tent_2" "coarse_tent_2_pcg32"
    "compact_tent_2" "compact_tent_2_pcg32"
        u: U0F32 -> I16F16 = const { ok(Tent::new(i16(2))) };
    "fine_triangle" "fine_triangle_pcg32"
    "coarse_triangle" "coarse_triangle_pcg32"
    "compact_triangle" "compact_triangle_pcg32"
        [u, v]: U0F32 -> [I2F30; 3] = Triangle::new();
    "fine_triangle_on" "fine_triangle_on_pcg32"
    "coarse_triangle_on" "coarse_triangle_on_pcg32"
    "compact_triangle_on" "compact_triangle_on_pcg32"
        [u, v]: U0F32 -> [I16F16; 2] = const { ok(TriangleOn::new(FACET)) };

    // With unit floats in and floats out.
    "fine_float_disk" "fine_float_disk_pcg32"
    "coarse_float_disk" "coarse_float_disk_pcg32"
    "compact_float_disk" "compact_float_disk_pcg32"
        [u, v]: f32 -> [f32; 2] = Float::new(Disk::new());
    "fine_float_sphere" "fine_float_sphere_pcg32"
    "coarse_float_sphere" "coarse_float_sphere_pcg32"
    "compact_float_sphere" "compact_float_sphere_pcg32"
        [u, v]: f32 -> [f32; 3] = Float::new(Sphere::new());
    "fine_float_cosine_hemisphere" "fine_float_cosine_hemisphere_pcg32"
    "coarse_float_cosine_hemisphere" "coarse_float_cosine_hemisphere_pcg32"
    "compact_float_cosine_hemisphere" "compact_float_cosine_hemisphere_pcg32"
        [u, v]: f32 -> [f32; 3] = Float::new(CosineHemisphere::new());
    "fine_float_phong_lobe_50" "fine_float_phong_lobe_50_pcg32"
    "coarse_float_phong_lobe_50" "coarse_float_phong_lobe_50_pcg32"
    "compact_float_phong_lobe_50" "compact_float_phong_lobe_50_pcg32"
        [u, v]: f32 -> [f32; 3] = Float::new(const { ok(PhongLobe::new(FIFTY)) });
    "fine_float_standard_exponential" "fine_float_standard_exponential_pcg32"
    "coarse_float_standard_exponential" "coarse_float_standard_exponential_pcg32"
    "compact_float_standard_exponential" "compact_float_standard_exponential_pcg32"
        u: f32 -> f32 = Float::new(StandardExponential::new());
    "fine_float_standard_normal_pair" "fine_float_standard_normal_pair_pcg32"
    "coarse_float_standard_normal_pair" "coarse_float_standard_normal_pair_pcg32"
    "compact_float_standard_normal_pair" "compact_float_standard_normal_pair_pcg32"
        [u, v]: f32 -> [f32; 2] = Float::new(StandardNormalPair::new());
}
