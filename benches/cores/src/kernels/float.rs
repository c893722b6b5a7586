//! The warps of both float tiers. Those of one uniform of no tier are listed in both, too.

use crate::registry::{float_warps, ok};
use microwarp::Warp;

/// The vertices of a triangle.
const FACET: [[f32; 2]; 3] = [[-90.0, 10.0], [300.0, -200.0], [40.0, 250.0]];

float_warps! {
    // On the line.
    "poly_interval" "poly_interval_pcg32" "libm_interval" "libm_interval_pcg32"
        u -> f32 = const { ok(Interval::new(-3.0, 5.0)) };
    "poly_power" "poly_power_pcg32" "libm_power" "libm_power_pcg32"
        u -> f32 = stored(|| Power::new(2.5, 0.0, 1.0));
    "poly_power_max_4" "poly_power_max_4_pcg32" "libm_power_max_4" "libm_power_max_4_pcg32"
        [a, b, c, d] -> f32 = PowerMax::<4>::new();
    "poly_exponential_1" "poly_exponential_1_pcg32" "libm_exponential_1" "libm_exponential_1_pcg32"
        u -> f32 = const { ok(Exponential::new(1.0)) };
    "poly_exponential_tail_1" "poly_exponential_tail_1_pcg32" "libm_exponential_tail_1" "libm_exponential_tail_1_pcg32"
        u -> f32 = const { ok(ExponentialTail::new(1.0)) };
    "poly_truncated_exponential_2_3" "poly_truncated_exponential_2_3_pcg32"
    "libm_truncated_exponential_2_3" "libm_truncated_exponential_2_3_pcg32"
        u -> f32 = stored(|| TruncatedExponential::new(2.0, 3.0));
    "poly_tent_2" "poly_tent_2_pcg32" "libm_tent_2" "libm_tent_2_pcg32"
        u -> f32 = const { ok(Tent::new(2.0)) };
    "poly_linear_1_3" "poly_linear_1_3_pcg32" "libm_linear_1_3" "libm_linear_1_3_pcg32"
        u -> f32 = const { ok(Linear::new(1.0, 3.0)) };
    "poly_normal" "poly_normal_pcg32" "libm_normal" "libm_normal_pcg32"
        u -> f32 = const { ok(Normal::new(0.0, 1.0)) };
    "poly_normal_pair" "poly_normal_pair_pcg32" "libm_normal_pair" "libm_normal_pair_pcg32"
        [u, v] -> [f32; 2] = const { ok(NormalPair::new([0.0; 2], 1.0)) };

    // In the plane.
    "poly_disk" "poly_disk_pcg32" "libm_disk" "libm_disk_pcg32"
        [u, v] -> [f32; 2] = Disk::new();
    "poly_disk_concentric" "poly_disk_concentric_pcg32" "libm_disk_concentric" "libm_disk_concentric_pcg32"
        [u, v] -> [f32; 2] = DiskConcentric::new();
    "poly_triangle" "poly_triangle_pcg32" "libm_triangle" "libm_triangle_pcg32"
        [u, v] -> [f32; 3] = Triangle::new();
    "poly_triangle_on" "poly_triangle_on_pcg32" "libm_triangle_on" "libm_triangle_on_pcg32"
        [u, v] -> [f32; 2] = stored(|| TriangleOn::new(FACET));

    // Directions.
    "poly_sphere" "poly_sphere_pcg32" "libm_sphere" "libm_sphere_pcg32"
        [u, v] -> [f32; 3] = Sphere::new();
    "poly_hemisphere" "poly_hemisphere_pcg32" "libm_hemisphere" "libm_hemisphere_pcg32"
        [u, v] -> [f32; 3] = Hemisphere::new();
    "poly_cosine_hemisphere" "poly_cosine_hemisphere_pcg32" "libm_cosine_hemisphere" "libm_cosine_hemisphere_pcg32"
        [u, v] -> [f32; 3] = CosineHemisphere::new();
    "poly_malley_hemisphere" "poly_malley_hemisphere_pcg32" "libm_malley_hemisphere" "libm_malley_hemisphere_pcg32"
        [u, v] -> [f32; 3] = MalleyHemisphere::new();
    "poly_phong_lobe_50" "poly_phong_lobe_50_pcg32" "libm_phong_lobe_50" "libm_phong_lobe_50_pcg32"
        [u, v] -> [f32; 3] = const { ok(PhongLobe::new(50.0)) };
    "poly_cone" "poly_cone_pcg32" "libm_cone" "libm_cone_pcg32"
        [u, v] -> [f32; 3] = const { ok(Cone::from_one_minus_cos(0.25)) };
    "poly_spherical_patch" "poly_spherical_patch_pcg32" "libm_spherical_patch" "libm_spherical_patch_pcg32"
        [u, v] -> [f32; 3] = stored(|| SphericalPatch::new(0.2, 0.3, -0.1, 0.4));
}
