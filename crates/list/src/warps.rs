//! The warps of the float tiers, as far as they run on cores. A new warp is one block here.
//!
//! From these blocks come the golden subjects, the cost kernels of `crates/cores`, the host benches and the bindings for C
//! and JavaScript. What only a host knows, the truths and the cases of the laws, stands in `crates/host`.
//!
//! A block has the name of the type and three parts. `T` is the tier.
//! - `golden`: the warps whose bits every target must reproduce, `"name" => constructor`. `v` hides a parameter from
//!   the compiler. The table is in the order of the blocks.
//! - `cost`: the warps whose instructions are counted, `"name" uniforms -> point = warp`, with the aliases of a tier
//!   module in scope. `poly_name`, `libm_name` and the two with `_pcg32`, which draw, come of it. A warp that the kernel
//!   loads, because its constructor is not `const` or its fields are many, is `stored(|| constructor)`. A warp without a
//!   kernel says why: `none "reason"`.
//! - `bind`: what other languages get, `"name" = Type { constructor(parameter: type), }`, with the aliases of a tier module
//!   in scope. The functions of the C header and the classes for JavaScript come of it. A warp that is not bound says
//!   why: `none "reason"`.

/// Hands all blocks to the macro that is named.
#[macro_export]
macro_rules! float_warps {
    ($then:ident $($with:tt)?) => {
        $then! {
            $($with)?
            // On the line.
            Interval {
                golden {
                    once "Interval -3 5" => Interval::new(v(-3.0), v(5.0)),
                    once "Interval decreasing 3e38" => Interval::decreasing(v(-3e38), v(3e38)),
                    once "Interval 1 3.1" => Interval::new(v(1.0), v(3.1)),
                }
                cost { "interval" u -> f32 = const { ok(Interval::new(-3.0, 5.0)) }, }
                bind {
                    "interval" = Interval { new(low: f32, high: f32), decreasing(low: f32, high: f32), }
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
                bind {
                    "power" = Power {
                        new(exponent: f32, low: f32, high: f32),
                        decreasing(exponent: f32, low: f32, high: f32),
                    }
                }
            }
            PowerMax {
                golden { once "PowerMax 3" => Ok(PowerMax::<3>::new()), }
                cost { "power_max_4" [a, b, c, d] -> f32 = PowerMax::<4>::new(), }
                bind {
                    "power_max_2" = PowerMax<2> { new(), }
                    "power_max_3" = PowerMax<3> { new(), }
                    "power_max_4" = PowerMax<4> { new(), }
                }
            }
            Exponential {
                golden { "Exponential" => Exponential::<T>::from_rate(v(1.5)), }
                cost { "exponential_1" u -> f32 = const { ok(Exponential::from_rate(1.0)) }, }
                bind {
                    "exponential" = Exponential { from_rate(rate: f32), from_mean(mean: f32), }
                }
            }
            ExponentialTail {
                golden { "ExponentialTail" => ExponentialTail::<T>::from_rate(v(1.5)), }
                cost { "exponential_tail_1" u -> f32 = const { ok(ExponentialTail::from_rate(1.0)) }, }
                bind {
                    "exponential_tail" = ExponentialTail { from_rate(rate: f32), from_mean(mean: f32), }
                }
            }
            TruncatedExponential {
                golden {
                    "TruncatedExponential 2" => TruncatedExponential::<T>::from_rate(v(2.0), v(3.0)),
                    "TruncatedExponential small" => TruncatedExponential::<T>::from_rate(v(1e-3), v(1.0)),
                    "TruncatedExponential -200" => TruncatedExponential::<T>::from_rate(v(-200.0), v(1.0)),
                }
                cost { "truncated_exponential_2_3" u -> f32 = stored(|| TruncatedExponential::from_rate(2.0, 3.0)), }
                bind {
                    "truncated_exponential" = TruncatedExponential {
                        from_rate(rate: f32, length: f32),
                        from_mean(mean: f32, length: f32),
                    }
                }
            }
            EquiAngular {
                golden {
                    "EquiAngular 2" => EquiAngular::<T>::new(v(2.0), v(-5.0), v(15.0)),
                    "EquiAngular before" => EquiAngular::<T>::new(v(0.5), v(-9.0), v(-0.25)),
                    "EquiAngular 0" => EquiAngular::<T>::new(v(0.0), v(1.0), v(1e6)),
                }
                cost { "equi_angular_2" u -> f32 = stored(|| EquiAngular::new(2.0, -5.0, 15.0)), }
                bind { "equi_angular" = EquiAngular { new(distance: f32, low: f32, high: f32), } }
            }
            Tent {
                golden { once "Tent" => Tent::new(v(2.0)), }
                cost { "tent_2" u -> f32 = const { ok(Tent::new(2.0)) }, }
                bind { "tent" = Tent { new(radius: f32), } }
            }
            Linear {
                golden {
                    once "Linear" => Linear::new(v(1.0), v(3.0)),
                    once "Linear from 0" => Linear::new(v(0.0), v(1.0)),
                }
                cost { "linear_1_3" u -> f32 = const { ok(Linear::new(1.0, 3.0)) }, }
                bind { "linear" = Linear { new(density_at_0: f32, density_at_1: f32), } }
            }
            Normal {
                golden { "Normal" => Normal::<T>::new(v(10.0), v(2.0)), }
                cost { "normal" u -> f32 = const { ok(Normal::new(0.0, 1.0)) }, }
                bind { "normal" = Normal { new(mean: f32, std_dev: f32), } }
            }
            NormalPair {
                golden { "NormalPair" => NormalPair::<T>::new([v(1.0), v(-1.0)], v(0.5)), }
                cost { "normal_pair" [u, v] -> [f32; 2] = const { ok(NormalPair::new([0.0; 2], 1.0)) }, }
                bind { "normal_pair" = NormalPair { new(mean: [f32; 2], std_dev: f32), } }
            }
            StudentPair {
                golden {
                    "StudentPair" => StudentPair::<T>::new(v(3.0), [v(1.0), v(-1.0)], v(0.5)),
                    "StudentPair 1e20" => StudentPair::<T>::new(v(1e20), [v(0.0), v(2.0)], v(0.5)),
                }
                cost { "student_pair" [u, v] -> [f32; 2] = const { ok(StudentPair::new(3.0, [0.0; 2], 1.0)) }, }
                bind { "student_pair" = StudentPair { new(degrees: f32, location: [f32; 2], scale: f32), } }
            }
            StudentT {
                golden {
                    "StudentT" => StudentT::<T>::new(v(5.0), v(10.0), v(2.0)),
                    "StudentT 0.3" => StudentT::<T>::new(v(0.3), v(0.0), v(1.0)),
                    "StudentT 1e20" => StudentT::<T>::new(v(1e20), v(0.0), v(1.0)),
                }
                cost { "student_t" [u, v] -> f32 = const { ok(StudentT::new(5.0, 0.0, 1.0)) }, }
                bind { "student_t" = StudentT { new(degrees: f32, location: f32, scale: f32), } }
            }
            TruncatedNormal {
                golden {
                    "TruncatedNormal -1 2" => TruncatedNormal::<T>::new(v(0.0), v(1.0), v(-1.0), v(2.0)),
                    "TruncatedNormal narrow" => TruncatedNormal::<T>::new(v(0.5), v(1.0), v(0.1), v(0.100_1)),
                    "TruncatedNormal above 30" => TruncatedNormal::<T>::above(v(0.0), v(1.0), v(30.0)),
                    "TruncatedNormal below -0.5" => TruncatedNormal::<T>::below(v(0.0), v(2.0), v(-0.5)),
                }
                cost { "truncated_normal" u -> f32 = stored(|| TruncatedNormal::new(0.0, 1.0, -1.0, 2.0)), }
                bind {
                    "truncated_normal" = TruncatedNormal {
                        new(mean: f32, std_dev: f32, low: f32, high: f32),
                        above(mean: f32, std_dev: f32, low: f32),
                        below(mean: f32, std_dev: f32, high: f32),
                    }
                }
            }
            Cauchy {
                golden {
                    "Cauchy" => Cauchy::<T>::new(v(10.0), v(2.0)),
                    "Cauchy 1e19" => Cauchy::<T>::new(v(-1e30), v(1e19)),
                }
                cost { "cauchy" u -> f32 = const { ok(Cauchy::new(0.0, 1.0)) }, }
                bind { "cauchy" = Cauchy { new(location: f32, scale: f32), } }
            }
            Laplace {
                golden { "Laplace" => Laplace::<T>::new(v(10.0), v(2.0)), }
                cost { "laplace" u -> f32 = const { ok(Laplace::new(0.0, 1.0)) }, }
                bind { "laplace" = Laplace { new(location: f32, scale: f32), } }
            }
            Logistic {
                golden { "Logistic" => Logistic::<T>::new(v(10.0), v(2.0)), }
                cost { "logistic" u -> f32 = const { ok(Logistic::new(0.0, 1.0)) }, }
                bind { "logistic" = Logistic { new(location: f32, scale: f32), } }
            }
            TruncatedLogistic {
                golden {
                    "TruncatedLogistic 360 830" => TruncatedLogistic::<T>::new(v(538.0), v(69.444_44), v(360.0), v(830.0)),
                    "TruncatedLogistic narrow" => TruncatedLogistic::<T>::new(v(0.5), v(1.0), v(0.1), v(0.100_1)),
                    "TruncatedLogistic 30 60" => TruncatedLogistic::<T>::new(v(0.0), v(1.0), v(30.0), v(60.0)),
                    "TruncatedLogistic -1 2" => TruncatedLogistic::<T>::new(v(0.0), v(1.0), v(-1.0), v(2.0)),
                }
                cost {
                    "truncated_logistic" u -> f32 = const { ok(TruncatedLogistic::new(538.0, 69.444_44, 360.0, 830.0)) },
                }
                bind {
                    "truncated_logistic" = TruncatedLogistic { new(location: f32, scale: f32, low: f32, high: f32), }
                }
            }
            Gumbel {
                golden { "Gumbel" => Gumbel::<T>::new(v(0.0), v(2.0)), }
                cost { "gumbel" u -> f32 = const { ok(Gumbel::new(0.0, 1.0)) }, }
                bind { "gumbel" = Gumbel { new(location: f32, scale: f32), } }
            }
            Rayleigh {
                golden { "Rayleigh" => Rayleigh::<T>::new(v(1.5)), }
                cost { "rayleigh" u -> f32 = const { ok(Rayleigh::new(1.0)) }, }
                bind { "rayleigh" = Rayleigh { new(scale: f32), } }
            }
            Weibull {
                golden {
                    "Weibull 1.5" => Weibull::<T>::new(v(3.0), v(1.5)),
                    "Weibull 0.1" => Weibull::<T>::new(v(1e-20), v(0.1)),
                    "Weibull 1e6" => Weibull::<T>::new(v(1.0), v(1e6)),
                }
                cost { "weibull" u -> f32 = stored(|| Weibull::new(1.0, 1.5)), }
                bind { "weibull" = Weibull { new(scale: f32, shape: f32), } }
            }
            Pareto {
                golden {
                    "Pareto 2" => Pareto::<T>::new(v(3.0), v(2.0)),
                    "Pareto 0.2" => Pareto::<T>::new(v(1e-30), v(0.2)),
                }
                cost { "pareto" u -> f32 = stored(|| Pareto::new(1.0, 2.0)), }
                bind { "pareto" = Pareto { new(minimum: f32, shape: f32), } }
            }
            LogNormal {
                golden {
                    "LogNormal 0.5" => LogNormal::<T>::new(v(0.25), v(0.5)),
                    "LogNormal 20" => LogNormal::<T>::new(v(-60.0), v(20.0)),
                }
                cost { "log_normal" u -> f32 = const { ok(LogNormal::new(0.0, 0.5)) }, }
                bind { "log_normal" = LogNormal { new(mean_of_log: f32, std_dev_of_log: f32), } }
            }

            // Made of closures, or of other warps.
            Inversion {
                golden { "Inversion" => Ok(Inversion::new(T::sqrt, |x: f32| 2.0 * x, |x: f32| x * x)), }
                cost { none "it costs what the functions given to it cost" }
                bind { none "its functions are the caller's already" }
            }
            Transform {
                golden {
                    "Transform" => Interval::new(v(0.0), v(2.0)).map(|i| Transform::new(i, T::exp, T::ln, T::exp)),
                }
                cost { none "it costs what the warp and the functions given to it cost" }
                bind { none "its functions are the caller's already" }
            }
            MarginalConditional {
                golden {
                    once "MarginalConditional" => Linear::new(v(0.0), v(1.0)).and_then(|marginal| {
                        let whole = Interval::new(v(0.0), v(1.0))?;
                        Ok(MarginalConditional::new(marginal, move |x: f32| Interval::new(0.0, x).unwrap_or(whole)))
                    }),
                }
                cost { none "it costs what the two warps given to it cost" }
                bind { none "the caller samples one warp and builds the other from its point" }
            }
            Composed {
                golden {
                    once "Composed" => Bilinear::new([[v(4.0), v(4.0)], [v(1.0), v(0.0)]])
                        .map(|weights| Composed::new(weights, Triangle::new())),
                    "Composed sphere" => Bilinear::new([[v(1.0), v(0.5)], [v(0.0), v(2.0)]])
                        .map(|weights| Composed::new(weights, Sphere::<T>::new())),
                }
                cost { none "it costs what the two warps given to it cost" }
                bind {
                    none "the caller hands the point of a bilinear patch to another warp and multiplies the densities"
                }
            }
            Product {
                golden {
                    "Product cylinder" => Interval::new(v(-1.0), v(2.0))
                        .map(|height| Product::new(Disk::<T>::new(), height)),
                }
                cost { none "it costs what the two warps given to it cost" }
                bind { none "the caller samples two warps and multiplies the densities" }
            }
            Each {
                golden {
                    once "Each tents" => Tent::new(v(1.5)).and_then(|tent| Ok(Each::new([tent, Tent::new(v(0.5))?]))),
                    once "Each far apart" => Interval::new(v(0.0), v(1e-30)).and_then(|narrow| {
                        Ok(Each::new([narrow, narrow, Interval::new(v(0.0), v(1e30))?]))
                    }),
                }
                cost { none "it costs what the warps given to it cost" }
                bind { none "the caller samples the warps and multiplies the densities" }
            }

            // In the plane.
            Disk {
                golden { "Disk" => Ok(Disk::<T>::new()), }
                cost { "disk" [u, v] -> [f32; 2] = Disk::new(), }
                bind { "disk" = Disk { new(), } }
            }
            DiskConcentric {
                golden { "DiskConcentric" => Ok(DiskConcentric::<T>::new()), }
                cost { "disk_concentric" [u, v] -> [f32; 2] = DiskConcentric::new(), }
                bind { "disk_concentric" = DiskConcentric { new(), } }
            }
            Triangle {
                golden { once "Triangle" => Ok(Triangle::new()), }
                cost { "triangle" [u, v] -> [f32; 3] = Triangle::new(), }
                bind { "triangle" = Triangle { new(), } }
            }
            MultivariateNormal {
                golden {
                    "MultivariateNormal 2" => MultivariateNormal::<T, 2>::new([v(1.0), v(-2.0)], [[v(4.0), v(1.5)], [v(1.5), v(1.0)]]),
                    "MultivariateNormal 3 singular" => MultivariateNormal::<T, 3>::new(
                        [v(0.0), v(3.0), v(0.1)],
                        [[v(0.04), v(0.04), v(0.004)], [v(0.04), v(0.04), v(0.004)], [v(0.004), v(0.004), v(0.01)]],
                    ),
                    "MultivariateNormal 2 far apart" => MultivariateNormal::<T, 2>::new(
                        [v(0.0), v(1e9)],
                        [[v(1e38), v(0.0)], [v(0.0), v(1e-30)]],
                    ),
                }
                cost {
                    "multivariate_normal_3" [u, v, w] -> [f32; 3] = stored(|| MultivariateNormal::<3>::new(
                        [0.0, 0.0, 0.1],
                        [[0.04, 0.01, 0.002], [0.01, 0.02, -0.001], [0.002, -0.001, 0.0016]],
                    )),
                }
                bind {
                    "multivariate_normal_2" = MultivariateNormal<2> { new(mean: [f32; 2], covariance: [[f32; 2]; 2]), }
                    "multivariate_normal_3" = MultivariateNormal<3> { new(mean: [f32; 3], covariance: [[f32; 3]; 3]), }
                }
            }
            TriangleOn {
                golden {
                    once "TriangleOn 2" => TriangleOn::new([[v(0.0), v(0.0)], [v(4.0), v(0.0)], [v(1.0), v(3.0)]]),
                    once "TriangleOn 3" => TriangleOn::new([
                        [v(1.0), v(0.0), v(0.0)],
                        [v(0.0), v(2.0), v(0.5)],
                        [v(-1.0), v(0.0), v(3.0)],
                    ]),
                }
                cost {
                    "triangle_on" [u, v] -> [f32; 2]
                        = stored(|| TriangleOn::new([[-90.0, 10.0], [300.0, -200.0], [40.0, 250.0]])),
                }
                bind {
                    "triangle_on_2d" = TriangleOn<2> { new(vertices: [[f32; 2]; 3]), }
                    "triangle_on_3d" = TriangleOn<3> { new(vertices: [[f32; 3]; 3]), }
                }
            }

            Bilinear {
                golden {
                    once "Bilinear" => Bilinear::new([[v(1.0), v(3.0)], [v(2.0), v(0.0)]]),
                    once "Bilinear far" => Bilinear::new([[v(0.0), v(1e-45)], [v(1e-20), v(3e38)]]),
                }
                cost { "bilinear" [u, v] -> [f32; 2] = stored(|| Bilinear::new([[1.0, 3.0], [2.0, 0.5]])), }
                bind { "bilinear" = Bilinear { new(weights: [[f32; 2]; 2]), } }
            }

            // Directions.
            Sphere {
                golden { "Sphere" => Ok(Sphere::<T>::new()), }
                cost { "sphere" [u, v] -> [f32; 3] = Sphere::new(), }
                bind { "sphere" = Sphere { new(), } }
            }
            Hemisphere {
                golden { "Hemisphere" => Ok(Hemisphere::<T>::new()), }
                cost { "hemisphere" [u, v] -> [f32; 3] = Hemisphere::new(), }
                bind { "hemisphere" = Hemisphere { new(), } }
            }
            CosineHemisphere {
                golden { "CosineHemisphere" => Ok(CosineHemisphere::<T>::new()), }
                cost { "cosine_hemisphere" [u, v] -> [f32; 3] = CosineHemisphere::new(), }
                bind { "cosine_hemisphere" = CosineHemisphere { new(), } }
            }
            MalleyHemisphere {
                golden { "MalleyHemisphere" => Ok(MalleyHemisphere::<T>::new()), }
                cost { "malley_hemisphere" [u, v] -> [f32; 3] = MalleyHemisphere::new(), }
                bind { "malley_hemisphere" = MalleyHemisphere { new(), } }
            }
            PhongLobe {
                golden {
                    "PhongLobe 0" => PhongLobe::<T>::new(v(0.0)),
                    "PhongLobe 50" => PhongLobe::<T>::new(v(50.0)),
                    "PhongLobe 1e8" => PhongLobe::<T>::new(v(1e8)),
                }
                cost { "phong_lobe_50" [u, v] -> [f32; 3] = const { ok(PhongLobe::new(50.0)) }, }
                bind { "phong_lobe" = PhongLobe { new(exponent: f32), } }
            }
            HenyeyGreenstein {
                golden {
                    "HenyeyGreenstein 0.8" => HenyeyGreenstein::<T>::new(v(0.8)),
                    "HenyeyGreenstein -0.5" => HenyeyGreenstein::<T>::new(v(-0.5)),
                    "HenyeyGreenstein 0" => HenyeyGreenstein::<T>::new(v(0.0)),
                    "HenyeyGreenstein 1-2^-24" => HenyeyGreenstein::<T>::new(v(0.999_999_94)),
                    "HenyeyGreenstein 1-g=1e-9" => HenyeyGreenstein::<T>::from_one_minus_g(v(1e-9)),
                    "HenyeyGreenstein 1+g=1e-9" => HenyeyGreenstein::<T>::from_one_plus_g(v(1e-9)),
                }
                cost { "henyey_greenstein_08" [u, v] -> [f32; 3] = const { ok(HenyeyGreenstein::new(0.8)) }, }
                bind {
                    "henyey_greenstein" = HenyeyGreenstein {
                        new(asymmetry: f32),
                        from_one_minus_g(one_minus_g: f32),
                        from_one_plus_g(one_plus_g: f32),
                    }
                }
            }
            VonMisesFisher {
                golden {
                    "VonMisesFisher 10" => VonMisesFisher::<T>::new(v(10.0)),
                    "VonMisesFisher 0" => VonMisesFisher::<T>::new(v(0.0)),
                    "VonMisesFisher 0.5" => VonMisesFisher::<T>::new(v(0.5)),
                    "VonMisesFisher 1e30" => VonMisesFisher::<T>::new(v(1e30)),
                }
                cost { "von_mises_fisher_10" [u, v] -> [f32; 3] = stored(|| VonMisesFisher::new(10.0)), }
                bind { "von_mises_fisher" = VonMisesFisher { new(kappa: f32), } }
            }
            Ggx {
                golden {
                    "Ggx 0.3" => Ggx::<T>::new([v(0.3), v(0.3)]),
                    "Ggx 1e-4 1" => Ggx::<T>::new([v(1e-4), v(1.0)]),
                }
                cost { "ggx_03" [u, v] -> [f32; 3] = const { ok(Ggx::new([0.3, 0.3])) }, }
                bind { "ggx" = Ggx { new(alpha: [f32; 2]), } }
            }
            GgxVisible {
                golden {
                    "GgxVisible 0.3" => GgxVisible::<T>::new([v(0.6), v(0.0), v(0.8)], [v(0.3), v(0.3)]),
                    "GgxVisible 1e-4 1" => GgxVisible::<T>::new([v(0.5), v(-0.7), v(0.1)], [v(1e-4), v(1.0)]),
                    "GgxVisible bounded" => GgxVisible::<T>::bounded([v(0.6), v(0.0), v(0.8)], [v(0.5), v(0.5)]),
                }
                cost { "ggx_visible_03" [u, v] -> [f32; 3] = stored(|| GgxVisible::new([0.6, 0.0, 0.8], [0.3, 0.3])), }
                bind {
                    "ggx_visible" = GgxVisible {
                        new(view: [f32; 3], alpha: [f32; 2]),
                        bounded(view: [f32; 3], alpha: [f32; 2]),
                    }
                }
            }
            Reflected {
                golden {
                    "Reflected 0.3" => GgxVisible::<T>::new([v(0.6), v(0.0), v(0.8)], [v(0.3), v(0.3)]).map(Reflected::new),
                    "Reflected bounded" => GgxVisible::<T>::bounded([v(0.6), v(-0.7), v(0.1)], [v(0.05), v(1.0)])
                        .map(Reflected::new),
                }
                cost {
                    "reflected_03" [u, v] -> [f32; 3]
                        = stored(|| GgxVisible::new([0.6, 0.0, 0.8], [0.3, 0.3]).map(Reflected::new)),
                }
                bind { none "`mw_ggx_visible_reflect` gives the direction with its normal and its density" }
            }
            Cone {
                golden {
                    "Cone 0.1" => Cone::<T>::from_radians(v(0.1)),
                    "Cone 1e-7" => Cone::<T>::from_radians(v(1e-7)),
                    "Cone 3" => Cone::<T>::from_radians(v(3.0)),
                    "Cone sphere" => Cone::<T>::from_sine(v(0.5)),
                }
                cost { "cone" [u, v] -> [f32; 3] = const { ok(Cone::from_one_minus_cos(0.25)) }, }
                bind {
                    "cone" = Cone {
                        from_one_minus_cos(one_minus_cos: f32),
                        from_radians(half_angle: f32),
                        from_sine(sine: f32),
                    }
                }
            }
            VisibleSphere {
                golden {
                    "VisibleSphere 0.5" => VisibleSphere::<T>::new([v(0.0), v(0.0), v(0.0)], [v(0.0), v(3.0), v(4.0)], v(0.5)),
                    "VisibleSphere near" => VisibleSphere::<T>::new([v(1.0), v(2.0), v(2.0)], [v(1e-8), v(0.0), v(0.0)], v(3.0)),
                    "VisibleSphere inside" => VisibleSphere::<T>::new([v(1.0), v(2.0), v(-2.0)], [v(0.1), v(0.0), v(0.0)], v(3.0)),
                }
                cost {
                    "visible_sphere" [u, v] -> [f32; 3]
                        = stored(|| VisibleSphere::new([0.0; 3], [0.0, 3.0, 4.0], 0.5)),
                    // With its setup, for every sample.
                    "visible_sphere_anew" [u, v] -> [f32; 3] = ok(VisibleSphere::new(
                        core::hint::black_box([0.0; 3]),
                        core::hint::black_box([0.0, 3.0, 4.0]),
                        core::hint::black_box(0.5),
                    )),
                }
                bind { "visible_sphere" = VisibleSphere { new(point: [f32; 3], centre: [f32; 3], radius: f32), } }
            }
            SphericalPatch {
                golden { "SphericalPatch" => SphericalPatch::<T>::from_turns(v(0.1), v(0.4), v(-0.25), v(0.5)), }
                cost {
                    "spherical_patch" [u, v] -> [f32; 3] = stored(|| SphericalPatch::from_turns(0.2, 0.3, -0.1, 0.4)),
                }
                bind {
                    "spherical_patch" = SphericalPatch {
                        from_turns(theta0: f32, theta1: f32, phi0: f32, phi1: f32),
                    }
                }
            }
            SphericalTriangle {
                golden {
                    "SphericalTriangle" => SphericalTriangle::<T>::new(
                        [v(0.0); 3],
                        [[v(-0.6), v(-0.5), v(0.8)], [v(0.7), v(-0.4), v(0.9)], [v(0.1), v(0.8), v(0.6)]],
                    ),
                    "SphericalTriangle 1e-13 sr" => SphericalTriangle::<T>::new(
                        [v(0.6), v(0.0), v(-0.8)],
                        [[v(1e-7), v(1e-7), v(3e-8)], [v(0.0), v(-1e-7), v(2e-8)], [v(-1e-7), v(1e-7), v(-6e-8)]],
                    ),
                    "SphericalTriangle close" => SphericalTriangle::<T>::new(
                        [v(0.0), v(0.1), v(0.0)],
                        [[v(1.0), v(0.0), v(0.003)], [v(-0.5), v(0.9), v(0.003)], [v(-0.5), v(-0.9), v(0.003)]],
                    ),
                }
                cost {
                    "spherical_triangle" [u, v] -> [f32; 3] = stored(|| SphericalTriangle::new(
                        [0.0; 3],
                        [[-0.6, -0.5, 0.8], [0.7, -0.4, 0.9], [0.1, 0.8, 0.6]],
                    )),
                    // With its setup, for every sample.
                    "spherical_triangle_anew" [u, v] -> [f32; 3] = ok(SphericalTriangle::new(
                        core::hint::black_box([0.0; 3]),
                        core::hint::black_box([[-0.6, -0.5, 0.8], [0.7, -0.4, 0.9], [0.1, 0.8, 0.6]]),
                    )),
                }
                bind { "spherical_triangle" = SphericalTriangle { new(point: [f32; 3], vertices: [[f32; 3]; 3]), } }
            }
            SphericalRectangle {
                golden {
                    "SphericalRectangle" => SphericalRectangle::<T>::new(
                        [v(0.0); 3],
                        [v(-0.6), v(-0.5), v(0.8)],
                        [[v(1.2), v(0.1), v(0.1)], [v(-0.1), v(1.0), v(0.2)]],
                    ),
                    "SphericalRectangle close" => SphericalRectangle::<T>::new(
                        [v(0.1), v(0.2), v(0.0)],
                        [v(0.5), v(-0.7), v(0.004)],
                        [[v(0.0), v(1.4), v(0.0)], [v(-1.0), v(0.0), v(0.0)]],
                    ),
                }
                cost {
                    "spherical_rectangle" [u, v] -> [f32; 3] = stored(|| SphericalRectangle::new(
                        [0.0; 3],
                        [-0.6, -0.5, 0.8],
                        [[1.2, 0.1, 0.1], [-0.1, 1.0, 0.2]],
                    )),
                    "spherical_rectangle_anew" [u, v] -> [f32; 3] = ok(SphericalRectangle::new(
                        core::hint::black_box([0.0; 3]),
                        core::hint::black_box([-0.6, -0.5, 0.8]),
                        core::hint::black_box([[1.2, 0.1, 0.1], [-0.1, 1.0, 0.2]]),
                    )),
                }
                bind {
                    "spherical_rectangle" = SphericalRectangle {
                        new(point: [f32; 3], corner: [f32; 3], edges: [[f32; 3]; 2]),
                    }
                }
            }
            Oriented {
                golden {
                    "Oriented" => Frame::new([v(1.0), v(2.0), v(-3.0)])
                        .map(|f| Oriented::new(CosineHemisphere::<T>::new(), f)),
                }
                cost { none "it costs what the warp given to it costs, and a turn" }
                bind { none "the caller turns the point of a warp with a frame" }
            }

            // Shapes.
            Aabb {
                golden { once "Aabb" => Aabb::new([v(-1.0), v(0.0), v(2.0)], [v(1.0), v(0.5), v(4.0)]), }
                cost { none "it costs an Interval a coordinate" }
                bind {
                    "aabb_2d" = Aabb<2> { new(low: [f32; 2], high: [f32; 2]), }
                    "aabb_3d" = Aabb<3> { new(low: [f32; 3], high: [f32; 3]), }
                }
            }

            Annulus {
                golden {
                    "Annulus 1 2" => Annulus::<T>::new(v(1.0), v(2.0)),
                    "Annulus thin" => Annulus::<T>::new(v(3e-15), v(3.000_001e-15)),
                    "Annulus sector" => Annulus::<T>::sector(v(0.0), v(1e15), v(-0.7), v(0.1)),
                }
                cost { "annulus" [u, v] -> [f32; 2] = const { ok(Annulus::new(1.0, 2.0)) }, }
                bind {
                    "annulus" = Annulus {
                        new(inner: f32, outer: f32),
                        sector(inner: f32, outer: f32, from_turns: f32, to_turns: f32),
                    }
                }
            }
            Ball {
                golden { "Ball" => Ok(Ball::<T>::new()), }
                cost { "ball" [u, v, w] -> [f32; 3] = Ball::new(), }
                bind { "ball" = Ball { new(), } }
            }
            Rotation {
                golden { "Rotation" => Ok(Rotation::<T>::new()), }
                cost { "rotation" [u, v, w] -> [f32; 4] = Rotation::new(), }
                bind { "rotation" = Rotation { new(), } }
            }
            RegularPolygon {
                golden {
                    "RegularPolygon 3" => RegularPolygon::<T>::new(black_box(3)),
                    "RegularPolygon 1001" => RegularPolygon::<T>::new(black_box(1001)),
                }
                cost { "regular_polygon_6" [u, v] -> [f32; 2] = stored(|| RegularPolygon::new(6)), }
                bind { "regular_polygon" = RegularPolygon { new(corners: u16), } }
            }
            Simplex {
                golden {
                    "Simplex 2" => Ok(Simplex::<T, 2>::new()),
                    "Simplex 4" => Ok(Simplex::<T, 4>::new()),
                }
                cost {
                    "simplex_2" [u, v] -> ([f32; 2], f32) = Simplex::<2>::new(),
                    "simplex_3" [u, v, w] -> ([f32; 3], f32) = Simplex::<3>::new(),
                }
                bind {
                    "simplex_2" = Simplex<2> { new(), }
                    "simplex_3" = Simplex<3> { new(), }
                    "simplex_4" = Simplex<4> { new(), }
                }
            }
            BoxSurface {
                golden {
                    once "BoxSurface" => BoxSurface::new([v(-1.0), v(0.0), v(0.25)], [v(1.0), v(1.0), v(0.75)]),
                    once "BoxSurface flat" => BoxSurface::new([v(-1.0), v(1e6), v(0.0)], [v(1.0), v(1_000_000.5), v(0.0)]),
                }
                cost {
                    "box_surface" [u, v] -> microwarp::warp::SurfacePoint
                        = stored(|| BoxSurface::new([-1.0, 0.0, 0.25], [1.0, 1.0, 0.75])),
                }
                bind { "box_surface" = BoxSurface { new(low: [f32; 3], high: [f32; 3]), } }
            }
            FrustumSurface {
                golden {
                    "FrustumSurface" => FrustumSurface::<T>::new([v(1.0), v(0.5)], v(2.0)),
                    "FrustumSurface cone" => FrustumSurface::<T>::new([v(3.0), v(0.0)], v(4.0)),
                    "FrustumSurface ring" => FrustumSurface::<T>::tube([v(1e-3), v(2.0)], v(0.0)),
                }
                cost {
                    "frustum_surface" [u, v] -> microwarp::warp::SurfacePoint
                        = stored(|| FrustumSurface::new([1.0, 0.5], 2.0)),
                }
                bind {
                    "frustum_surface" = FrustumSurface {
                        new(radii: [f32; 2], height: f32),
                        tube(radii: [f32; 2], height: f32),
                    }
                }
            }
            CapsuleSurface {
                golden {
                    "CapsuleSurface" => CapsuleSurface::<T>::new(v(1.0), v(0.5)),
                    "CapsuleSurface needle" => CapsuleSurface::<T>::new(v(1e10), v(1e-10)),
                }
                cost {
                    "capsule_surface" [u, v] -> microwarp::warp::SurfacePoint
                        = stored(|| CapsuleSurface::new(1.0, 0.5)),
                }
                bind { "capsule_surface" = CapsuleSurface { new(height: f32, radius: f32), } }
            }

            // Tables that are warps.
            PiecewiseConstant1d {
                golden {
                    once "PiecewiseConstant1d" => PiecewiseConstant1d::new(&weights(), v(-3.0), v(5.0)),
                    once "PiecewiseConstant1d wide"
                        => PiecewiseConstant1d::new_u64(&weights(), v(-3e38), v(3e38)),
                }
                cost { none "its kernels are those of the tables" }
                bind { none "it lies in memory of the caller, so it is bound with the tables" }
            }
            PiecewiseConstant2d {
                golden {
                    once "PiecewiseConstant2d" => PiecewiseConstant2d::new(
                        &[weights(), [v(0.0); 6], [v(0.5); 6]],
                        [v(0.0), v(6.0)],
                        [v(-1.0), v(1.0)],
                    ),
                    once "PiecewiseConstant2d wide" => PiecewiseConstant2d::new_u64(
                        &[weights(), [v(1e-30); 6]],
                        [v(0.0), v(1.0)],
                        [v(0.0), v(1.0)],
                    ),
                }
                cost { none "its kernels are those of the tables" }
                bind { none "it lies in memory of the caller, so it is bound with the tables" }
            }
            PiecewiseLinear1d {
                golden {
                    once "PiecewiseLinear1d" => PiecewiseLinear1d::new(&weights(), v(-3.0), v(5.0)),
                    once "PiecewiseLinear1d wide"
                        => PiecewiseLinear1d::new_u64(&weights(), v(0.0), v(1e-3)),
                }
                cost { none "its kernels are those of the tables" }
                bind { none "it lies in memory of the caller, so it is bound with the tables" }
            }
            Mixture {
                golden {
                    "Mixture lobes" => GgxVisible::<T>::new([v(0.6), v(0.0), v(0.8)], [v(0.3), v(0.3)]).and_then(|normals| {
                        let parts = (CosineHemisphere::<T>::new(), Reflected::new(normals));
                        Ok(Mixed(Mixture::new(parts, &[v(1.0), v(2.0)])?))
                    }),
                    once "Mixture of three" => Interval::new(v(0.0), v(1.0)).and_then(|interval| {
                        let parts = [interval, Interval::new(v(0.5), v(2.0))?, Interval::new(v(-1e30), v(1e30))?];
                        Ok(Mixed(Mixture::new(parts, &[v(0.3), v(0.0), v(1e-7)])?))
                    }),
                }
                cost { none "its kernels are those of the tables" }
                bind { none "the caller picks a part by a table and adds the densities" }
            }
            Mesh {
                golden {
                    once "Mesh" => Cdf::new(&weights())
                        .and_then(|table| Mesh::from_trusted_parts(&VERTICES, &FACES, &AREAS, table)),
                    once "Mesh wide" => Cdf::new_u64(&weights())
                        .and_then(|table| Mesh::from_trusted_parts(&VERTICES, &FACES, &AREAS, table)),
                }
                cost { none "it costs a selection from a table and a triangle" }
                bind { none "it lies in memory of the caller, so it is bound with the tables" }
            }
            LatLongMap {
                golden {
                    "LatLongMap" => LatLongMap::<T, _, _>::new(&[weights(), [v(0.0); 6], [v(0.5); 6]]),
                    "LatLongMap wide"
                        => LatLongMap::<T, _, _>::new_u64(&[weights(), [v(1e-30); 6]]),
                }
                cost { none "its kernels are those of the tables" }
                bind { none "it lies in memory of the caller, so it is bound with the tables" }
            }
        }
    };
}
