//! The warps of the float tiers, as far as they run on cores. A new warp is one block here.
//!
//! From these blocks come the golden subjects, the cost kernels of `benches/cores`, the host benches and the subjects
//! of the page. What only a host knows, the truths and the cases of the laws, stands in `tests/support`.
//!
//! A block has the name of the type and three parts. `T` is the tier.
//! - `golden`: the warps whose bits every target must reproduce, `"name" => constructor`. `v` hides a parameter from
//!   the compiler. The table is in the order of the blocks.
//! - `cost`: the warps whose instructions are counted, `"name" uniforms -> point = warp`, with the aliases of a tier
//!   module in scope. `poly_name`, `libm_name` and the two with `_pcg32`, which draw, come of it. A warp that the kernel
//!   loads, because its constructor is not `const` or its fields are many, is `stored(|| constructor)`. A warp without a
//!   kernel says why: `none "reason"`.
//! - `page`: the subjects of `examples/web`, `view uniforms: Name(parameter: start in least..most by step) => warp`.
//!   The view is `line`, `plane` or `sphere`; `by step` may be left out.

/// Hands all blocks to the macro that is named.
#[macro_export]
macro_rules! float_warps {
    ($then:ident $($with:tt)?) => {
        $then! {
            $($with)?
            // On the line.
            Interval {
                golden {
                    "Interval -3 5" => Interval::new(v(-3.0), v(5.0)),
                    "Interval decreasing 3e38" => Interval::decreasing(v(-3e38), v(3e38)),
                    "Interval 1 3.1" => Interval::new(v(1.0), v(3.1)),
                }
                cost { "interval" u -> f32 = const { ok(Interval::new(-3.0, 5.0)) }, }
                page {
                    line 1: Interval(from: -3 in -10..10, to: 5 in -10..10) => Interval::new(from, to),
                    line 1: IntervalDecreasing(from: -3 in -10..10, to: 5 in -10..10) => Interval::decreasing(from, to),
                }
            }
            Power {
                golden {
                    "Power 2.5" => Power::<T>::new(v(2.5), v(0.0), v(1.0)),
                    "Power -1" => Power::<T>::new(v(-1.0), v(1.0), v(100.0)),
                    "Power -0.99 decades" => Power::<T>::new(v(-0.99), v(1e-10), v(1e10)),
                    "Power decreasing -2.5" => Power::<T>::decreasing(v(-2.5), v(1.0), v(1e20)),
                    "Power 1000" => Power::<T>::new(v(1000.0), v(1.0), v(2.0)),
                }
                cost { "power" u -> f32 = stored(|| Power::new(2.5, 0.0, 1.0)), }
                page {
                    line 1: Power(exponent: 2.5 in -6..10, from: 0 in 0..10, to: 1 in 0..10)
                        => Power::<T>::new(exponent, from, to),
                    line 1: PowerDecreasing(exponent: -1 in -6..10, from: 1 in 0..10, to: 10 in 0..10)
                        => Power::<T>::decreasing(exponent, from, to),
                }
            }
            PowerMax {
                golden { "PowerMax 3" => Ok(PowerMax::<3>::new()), }
                cost { "power_max_4" [a, b, c, d] -> f32 = PowerMax::<4>::new(), }
                page { line 4: PowerMax() => Ok(PowerMax::<4>::new()), }
            }
            Exponential {
                golden { "Exponential" => Exponential::<T>::from_rate(v(1.5)), }
                cost { "exponential_1" u -> f32 = const { ok(Exponential::from_rate(1.0)) }, }
                page { line 1: Exponential(rate: 1 in 0..10) => Exponential::<T>::from_rate(rate), }
            }
            ExponentialTail {
                golden { "ExponentialTail" => ExponentialTail::<T>::from_rate(v(1.5)), }
                cost { "exponential_tail_1" u -> f32 = const { ok(ExponentialTail::from_rate(1.0)) }, }
                // Its uniform is made of two words.
                page { line 2: ExponentialTail(rate: 1 in 0..10) => ExponentialTail::<T>::from_rate(rate), }
            }
            TruncatedExponential {
                golden {
                    "TruncatedExponential 2" => TruncatedExponential::<T>::from_rate(v(2.0), v(3.0)),
                    "TruncatedExponential small" => TruncatedExponential::<T>::from_rate(v(1e-3), v(1.0)),
                    "TruncatedExponential -200" => TruncatedExponential::<T>::from_rate(v(-200.0), v(1.0)),
                }
                cost { "truncated_exponential_2_3" u -> f32 = stored(|| TruncatedExponential::from_rate(2.0, 3.0)), }
                page {
                    line 1: TruncatedExponential(rate: 2 in -20..20, length: 3 in 0..10)
                        => TruncatedExponential::<T>::from_rate(rate, length),
                }
            }
            EquiAngular {
                golden {
                    "EquiAngular 2" => EquiAngular::<T>::new(v(2.0), v(-5.0), v(15.0)),
                    "EquiAngular before" => EquiAngular::<T>::new(v(0.5), v(-9.0), v(-0.25)),
                    "EquiAngular 0" => EquiAngular::<T>::new(v(0.0), v(1.0), v(1e6)),
                }
                cost { "equi_angular_2" u -> f32 = stored(|| EquiAngular::new(2.0, -5.0, 15.0)), }
                page {
                    line 1: EquiAngular(distance: 2 in 0..10 by 0.1, low: -5 in -20..20, high: 15 in -20..20)
                        => EquiAngular::<T>::new(distance, low, high),
                }
            }
            Tent {
                golden { "Tent" => Tent::new(v(2.0)), }
                cost { "tent_2" u -> f32 = const { ok(Tent::new(2.0)) }, }
                page { line 1: Tent(radius: 1 in 0..5) => Tent::new(radius), }
            }
            Linear {
                golden {
                    "Linear" => Linear::new(v(1.0), v(3.0)),
                    "Linear from 0" => Linear::new(v(0.0), v(1.0)),
                }
                cost { "linear_1_3" u -> f32 = const { ok(Linear::new(1.0, 3.0)) }, }
                page {
                    line 1: Linear(density_at_0: 1 in 0..10, density_at_1: 3 in 0..10)
                        => Linear::new(density_at_0, density_at_1),
                }
            }
            Normal {
                golden { "Normal" => Normal::<T>::new(v(10.0), v(2.0)), }
                cost { "normal" u -> f32 = const { ok(Normal::new(0.0, 1.0)) }, }
                page { line 1: Normal(mean: 0 in -10..10, std_dev: 1 in 0..5) => Normal::<T>::new(mean, std_dev), }
            }
            NormalPair {
                golden { "NormalPair" => NormalPair::<T>::new([v(1.0), v(-1.0)], v(0.5)), }
                cost { "normal_pair" [u, v] -> [f32; 2] = const { ok(NormalPair::new([0.0; 2], 1.0)) }, }
                page {
                    plane 2: NormalPair(mean_x: 0 in -10..10, mean_y: 0 in -10..10, std_dev: 1 in 0..5)
                        => NormalPair::<T>::new([mean_x, mean_y], std_dev),
                }
            }

            // Made of closures, or of other warps.
            Inversion {
                golden { "Inversion" => Ok(Inversion::new(T::sqrt, |x: f32| 2.0 * x, |x: f32| x * x)), }
                cost { none "it costs what the functions given to it cost" }
                page {
                    // p(x) = ½ + x on [0, 1], as a user would write it.
                    line 1: Inversion() => Ok(Inversion::new(
                        |u: f32| 4.0 * u / (1.0 + T::sqrt(1.0 + 8.0 * u)),
                        |x: f32| if (0.0..=1.0).contains(&x) { 0.5 + x } else { 0.0 },
                        |x: f32| 0.5 * x * (1.0 + x),
                    )),
                }
            }
            Transform {
                golden {
                    "Transform" => Interval::new(v(0.0), v(2.0)).map(|i| Transform::new(i, T::exp, T::ln, T::exp)),
                }
                cost { none "it costs what the warp and the functions given to it cost" }
                page {
                    // y = sin x of x with density 2x on [0, 1].
                    line 1: Transform() => Linear::new(0.0, 1.0).map(|x| Transform::new(
                        x,
                        |x: f32| T::sincos_turns(x * (1.0 / TAU)).0,
                        |y: f32| T::atan2_turns(y, T::sqrt((1.0 - y) * (1.0 + y))) * TAU,
                        |x: f32| T::sincos_turns(x * (1.0 / TAU)).1,
                    )),
                }
            }
            MarginalConditional {
                golden {
                    "MarginalConditional" => Linear::new(v(0.0), v(1.0)).and_then(|marginal| {
                        let whole = Interval::new(v(0.0), v(1.0))?;
                        Ok(MarginalConditional::new(marginal, move |x: f32| Interval::new(0.0, x).unwrap_or(whole)))
                    }),
                }
                cost { none "it costs what the two warps given to it cost" }
                page {
                    // Uniform on 0 ≤ y ≤ x ≤ 1: p(x) = 2x, p(y | x) = 1/x.
                    plane 2: MarginalConditional() => Linear::new(0.0, 1.0).and_then(|marginal| {
                        let whole = Interval::new(0.0, 1.0)?;
                        Ok(MarginalConditional::new(marginal, move |x: f32| Interval::new(0.0, x).unwrap_or(whole)))
                    }),
                }
            }

            // In the plane.
            Disk {
                golden { "Disk" => Ok(Disk::<T>::new()), }
                cost { "disk" [u, v] -> [f32; 2] = Disk::new(), }
                page { plane 2: Disk() => Ok(Disk::<T>::new()), }
            }
            DiskConcentric {
                golden { "DiskConcentric" => Ok(DiskConcentric::<T>::new()), }
                cost { "disk_concentric" [u, v] -> [f32; 2] = DiskConcentric::new(), }
                page { plane 2: DiskConcentric() => Ok(DiskConcentric::<T>::new()), }
            }
            Triangle {
                golden { "Triangle" => Ok(Triangle::new()), }
                cost { "triangle" [u, v] -> [f32; 3] = Triangle::new(), }
                page { plane 2: Triangle() => Ok(Triangle::new()), }
            }
            TriangleOn {
                golden {
                    "TriangleOn 2" => TriangleOn::new([[v(0.0), v(0.0)], [v(4.0), v(0.0)], [v(1.0), v(3.0)]]),
                    "TriangleOn 3" => TriangleOn::new([
                        [v(1.0), v(0.0), v(0.0)],
                        [v(0.0), v(2.0), v(0.5)],
                        [v(-1.0), v(0.0), v(3.0)],
                    ]),
                }
                cost {
                    "triangle_on" [u, v] -> [f32; 2]
                        = stored(|| TriangleOn::new([[-90.0, 10.0], [300.0, -200.0], [40.0, 250.0]])),
                }
                page {
                    plane 2: TriangleOn(
                        a_x: 0 in -4..4, a_y: 0 in -4..4, b_x: 4 in -4..4, b_y: 0 in -4..4, c_x: 1 in -4..4, c_y: 3 in -4..4
                    ) => TriangleOn::new([[a_x, a_y], [b_x, b_y], [c_x, c_y]]),
                }
            }

            // Directions.
            Sphere {
                golden { "Sphere" => Ok(Sphere::<T>::new()), }
                cost { "sphere" [u, v] -> [f32; 3] = Sphere::new(), }
                page { sphere 2: Sphere() => Ok(Sphere::<T>::new()), }
            }
            Hemisphere {
                golden { "Hemisphere" => Ok(Hemisphere::<T>::new()), }
                cost { "hemisphere" [u, v] -> [f32; 3] = Hemisphere::new(), }
                page { sphere 2: Hemisphere() => Ok(Hemisphere::<T>::new()), }
            }
            CosineHemisphere {
                golden { "CosineHemisphere" => Ok(CosineHemisphere::<T>::new()), }
                cost { "cosine_hemisphere" [u, v] -> [f32; 3] = CosineHemisphere::new(), }
                page { sphere 2: CosineHemisphere() => Ok(CosineHemisphere::<T>::new()), }
            }
            MalleyHemisphere {
                golden { "MalleyHemisphere" => Ok(MalleyHemisphere::<T>::new()), }
                cost { "malley_hemisphere" [u, v] -> [f32; 3] = MalleyHemisphere::new(), }
                page { sphere 2: MalleyHemisphere() => Ok(MalleyHemisphere::<T>::new()), }
            }
            PhongLobe {
                golden {
                    "PhongLobe 0" => PhongLobe::<T>::new(v(0.0)),
                    "PhongLobe 50" => PhongLobe::<T>::new(v(50.0)),
                    "PhongLobe 1e8" => PhongLobe::<T>::new(v(1e8)),
                }
                cost { "phong_lobe_50" [u, v] -> [f32; 3] = const { ok(PhongLobe::new(50.0)) }, }
                page { sphere 2: PhongLobe(exponent: 50 in 0..200 by 0.5) => PhongLobe::<T>::new(exponent), }
            }
            HenyeyGreenstein {
                golden {
                    "HenyeyGreenstein 0.8" => HenyeyGreenstein::<T>::new(v(0.8)),
                    "HenyeyGreenstein -0.5" => HenyeyGreenstein::<T>::new(v(-0.5)),
                    "HenyeyGreenstein 0" => HenyeyGreenstein::<T>::new(v(0.0)),
                    "HenyeyGreenstein 1-2^-24" => HenyeyGreenstein::<T>::new(v(0.999_999_94)),
                }
                cost { "henyey_greenstein_08" [u, v] -> [f32; 3] = const { ok(HenyeyGreenstein::new(0.8)) }, }
                page { sphere 2: HenyeyGreenstein(asymmetry: 0.8 in -0.99..0.99) => HenyeyGreenstein::<T>::new(asymmetry), }
            }
            VonMisesFisher {
                golden {
                    "VonMisesFisher 10" => VonMisesFisher::<T>::new(v(10.0)),
                    "VonMisesFisher 0" => VonMisesFisher::<T>::new(v(0.0)),
                    "VonMisesFisher 0.5" => VonMisesFisher::<T>::new(v(0.5)),
                    "VonMisesFisher 1e30" => VonMisesFisher::<T>::new(v(1e30)),
                }
                cost { "von_mises_fisher_10" [u, v] -> [f32; 3] = stored(|| VonMisesFisher::new(10.0)), }
                page { sphere 2: VonMisesFisher(concentration: 10 in 0..200 by 0.5) => VonMisesFisher::<T>::new(concentration), }
            }
            Ggx {
                golden {
                    "Ggx 0.3" => Ggx::<T>::new([v(0.3), v(0.3)]),
                    "Ggx 1e-4 1" => Ggx::<T>::new([v(1e-4), v(1.0)]),
                }
                cost { "ggx_03" [u, v] -> [f32; 3] = const { ok(Ggx::new([0.3, 0.3])) }, }
                page {
                    sphere 2: Ggx(roughness_along_x: 0.1 in 0.001..1, roughness_along_y: 0.5 in 0.001..1)
                        => Ggx::<T>::new([roughness_along_x, roughness_along_y]),
                }
            }
            GgxVisible {
                golden {
                    "GgxVisible 0.3" => GgxVisible::<T>::new([v(0.6), v(0.0), v(0.8)], [v(0.3), v(0.3)]),
                    "GgxVisible 1e-4 1" => GgxVisible::<T>::new([v(0.5), v(-0.7), v(0.1)], [v(1e-4), v(1.0)]),
                    "GgxVisible bounded" => GgxVisible::<T>::bounded([v(0.6), v(0.0), v(0.8)], [v(0.5), v(0.5)]),
                }
                cost { "ggx_visible_03" [u, v] -> [f32; 3] = stored(|| GgxVisible::new([0.6, 0.0, 0.8], [0.3, 0.3])), }
                page {
                    sphere 2: GgxVisible(view_in_turns: 0.15 in 0..0.25, roughness: 0.3 in 0.001..1)
                        => Spherical::<T>::from_turns(1.0, view_in_turns, 0.0)
                            .and_then(|view| GgxVisible::<T>::new(view.to_cartesian(), [roughness, roughness])),
                }
            }
            Cone {
                golden {
                    "Cone 0.1" => Cone::<T>::from_radians(v(0.1)),
                    "Cone 1e-7" => Cone::<T>::from_radians(v(1e-7)),
                    "Cone 3" => Cone::<T>::from_radians(v(3.0)),
                    "Cone sphere" => Cone::<T>::from_sine(v(0.5)),
                }
                cost { "cone" [u, v] -> [f32; 3] = const { ok(Cone::from_one_minus_cos(0.25)) }, }
                page { sphere 2: Cone(half_angle_in_rad: 0.6 in 0..3.14) => Cone::<T>::from_radians(half_angle_in_rad), }
            }
            SphericalPatch {
                golden { "SphericalPatch" => SphericalPatch::<T>::from_turns(v(0.1), v(0.4), v(-0.25), v(0.5)), }
                cost {
                    "spherical_patch" [u, v] -> [f32; 3] = stored(|| SphericalPatch::from_turns(0.2, 0.3, -0.1, 0.4)),
                }
                page {
                    sphere 2: SphericalPatch(
                        theta_from_in_turns: 0 in 0..0.5 by 0.001, theta_to_in_turns: 0.25 in 0..0.5 by 0.001,
                        phi_from_in_turns: 0 in -1..1 by 0.001, phi_to_in_turns: 0.25 in -1..1 by 0.001
                    ) => SphericalPatch::<T>::from_turns(
                        theta_from_in_turns, theta_to_in_turns, phi_from_in_turns, phi_to_in_turns,
                    ),
                }
            }
            Oriented {
                golden {
                    "Oriented" => Frame::new([v(1.0), v(2.0), v(-3.0)])
                        .map(|f| Oriented::new(CosineHemisphere::<T>::new(), f)),
                }
                cost { none "it costs what the warp given to it costs, and a turn" }
                page {
                    sphere 2: Oriented(normal_x: 1 in -3..3, normal_y: 2 in -3..3, normal_z: 3 in -3..3)
                        => Frame::new([normal_x, normal_y, normal_z])
                            .map(|frame| Oriented::new(CosineHemisphere::<T>::new(), frame)),
                }
            }

            // Shapes.
            Aabb {
                golden { "Aabb" => Aabb::new([v(-1.0), v(0.0), v(2.0)], [v(1.0), v(0.5), v(4.0)]), }
                cost { none "it costs an Interval a coordinate" }
                page {
                    plane 2: Aabb(left: -1 in -10..10, right: 1 in -10..10, bottom: 2 in -10..10, top: 2.5 in -10..10)
                        => Aabb::new([left, bottom], [right, top]),
                }
            }

            // Tables that are warps. The page shows them among the tables, which have no tier.
            PiecewiseConstant1d {
                golden {
                    "PiecewiseConstant1d" => PiecewiseConstant1d::new(&weights(), v(-3.0), v(5.0)),
                    "PiecewiseConstant1d wide"
                        => PiecewiseConstant1d::new_u64(&weights(), v(-3e38), v(3e38)),
                }
                cost { none "its kernels are those of the tables" }
                page {}
            }
            PiecewiseConstant2d {
                golden {
                    "PiecewiseConstant2d" => PiecewiseConstant2d::new(
                        &[weights(), [v(0.0); 6], [v(0.5); 6]],
                        [v(0.0), v(6.0)],
                        [v(-1.0), v(1.0)],
                    ),
                    "PiecewiseConstant2d wide" => PiecewiseConstant2d::new_u64(
                        &[weights(), [v(1e-30); 6]],
                        [v(0.0), v(1.0)],
                        [v(0.0), v(1.0)],
                    ),
                }
                cost { none "its kernels are those of the tables" }
                page {}
            }
        }
    };
}
