//! The warps of the integer tier, as far as they run on cores. A new warp is one block here.
//!
//! From these blocks come the golden subjects, the cost kernels of `crates/cores`, the probe without floating point,
//! and the C functions. A block reads like those of `warps.rs`, with these differences:
//! - `G` is the grade.
//! - `golden`: `v` makes a number of the bits of a word and `whole` one of 16 fraction bits.
//! - `cost`: the names become `fine_name`, `coarse_name`, `compact_name`, and the three with `_pcg32`. Behind the
//!   uniforms stands their type.
//! - `bind`: a parameter with a unit is in Q16.16, signed or unsigned.

/// Hands all blocks to the macro that is named: the warps that have grades, floats over them, and the others.
#[macro_export]
macro_rules! integer_warps {
    ($then:ident $($with:tt)?) => {
        $then! {
            $($with)?
            in every grade {
                Disk {
                    golden { "Disk" => Ok(Disk::<G>::new()), }
                    cost { "disk" [u, v]: U0F32 -> [I2F30; 2] = Disk::new(), }
                    bind { "disk" = Disk { new(), } }
                }
                Annulus {
                    golden {
                        "Annulus 30 50" => Annulus::<_, G>::new(whole::<I16F16>(30), whole(50)),
                        "Annulus thin" => Annulus::<_, G>::new(v::<I2F30>((1 << 30) - 999), v(1 << 30)),
                        "Annulus sector" => Annulus::<_, G>::sector(v::<I16F16>(0), v(77), [v(0xf000_0000), v(1 << 27)]),
                    }
                    cost {
                        "annulus_30_50" [u, v]: U0F32 -> [I16F16; 2]
                            = const { ok(Annulus::new(I16F16::lit("30"), I16F16::lit("50"))) },
                    }
                    bind {
                        "annulus" = Annulus<U16> {
                            new(inner: I16F16, outer: I16F16),
                            sector(inner: I16F16, outer: I16F16, sides: [U0F32; 2]),
                        }
                    }
                }
                RegularPolygon {
                    golden {
                        "RegularPolygon 3" => RegularPolygon::<G>::new(black_box(3)),
                        "RegularPolygon 1001" => RegularPolygon::<G>::new(black_box(1001)),
                    }
                    cost { "regular_polygon_6" [u, v]: U0F32 -> [I2F30; 2] = const { ok(RegularPolygon::new(6)) }, }
                    bind { "regular_polygon" = RegularPolygon { new(corners: u16), } }
                }
                Rotation {
                    golden { "Rotation" => Ok(Rotation::<G>::new()), }
                    cost { "rotation" [u, v, w]: U0F32 -> [I2F30; 4] = Rotation::new(), }
                    bind { "rotation" = Rotation { new(), } }
                }
                Simplex {
                    golden {
                        "Simplex 1" => Ok(Simplex::<1, G>::new()),
                        "Simplex 3" => Ok(Simplex::<3, G>::new()),
                    }
                    cost {
                        "simplex_2" [u, v]: U0F32 -> ([I2F30; 2], I2F30) = Simplex::<2>::new(),
                        "simplex_3" [u, v, w]: U0F32 -> ([I2F30; 3], I2F30) = Simplex::<3>::new(),
                    }
                    bind {
                        "simplex_2" = Simplex<2> { new(), }
                        "simplex_3" = Simplex<3> { new(), }
                        "simplex_4" = Simplex<4> { new(), }
                    }
                }
                Sphere {
                    golden { "Sphere" => Ok(Sphere::<G>::new()), }
                    cost { "sphere" [u, v]: U0F32 -> [I2F30; 3] = Sphere::new(), }
                    bind { "sphere" = Sphere { new(), } }
                }
                Hemisphere {
                    golden { "Hemisphere" => Ok(Hemisphere::<G>::new()), }
                    cost { "hemisphere" [u, v]: U0F32 -> [I2F30; 3] = Hemisphere::new(), }
                    bind { "hemisphere" = Hemisphere { new(), } }
                }
                CosineHemisphere {
                    golden { "CosineHemisphere" => Ok(CosineHemisphere::<G>::new()), }
                    cost { "cosine_hemisphere" [u, v]: U0F32 -> [I2F30; 3] = CosineHemisphere::new(), }
                    bind { "cosine_hemisphere" = CosineHemisphere { new(), } }
                }
                Cone {
                    golden {
                        "Cone 0.1" => Cone::<G>::from_one_minus_cos(v(107_374_182)),
                        "Cone towards a sphere" => Cone::<G>::towards_sphere(v::<U16F16>(111_411), v::<U16F16>(98_304)),
                        "Cone of a thousandth turn" => Cone::<G>::from_turns(v(4_294_967)),
                    }
                    cost {
                        "cone" [u, v]: U0F32 -> [I2F30; 3] = const { ok(Cone::from_one_minus_cos(U2F62::lit("0.25"))) },
                    }
                    bind {
                        "cone" = Cone {
                            from_one_minus_cos(one_minus_cos: U2F62),
                            from_turns(half_angle: U0F32),
                            towards_sphere(distance: U16F16, radius: U16F16),
                        }
                    }
                }
                PhongLobe {
                    golden {
                        "PhongLobe 0" => PhongLobe::<G>::new(v(0)),
                        "PhongLobe 50" => PhongLobe::<G>::new(v(50)),
                        "PhongLobe 1e8" => PhongLobe::<G>::new(v(100_000_000)),
                    }
                    cost { "phong_lobe_50" [u, v]: U0F32 -> [I2F30; 3] = const { ok(PhongLobe::new(U32F32::lit("50"))) }, }
                    bind { "phong_lobe" = PhongLobe { new(exponent: U32F32), } }
                }
                HenyeyGreenstein {
                    golden {
                        "HenyeyGreenstein 0.75" => HenyeyGreenstein::<G>::new(v(3 << 28)),
                        "HenyeyGreenstein -0.5" => HenyeyGreenstein::<G>::new(v(7 << 29)),
                        "HenyeyGreenstein 1-2^-12" => HenyeyGreenstein::<G>::from_one_minus(v(1 << 18)),
                    }
                    cost {
                        "henyey_greenstein_08" [u, v]: U0F32 -> [I2F30; 3]
                            = const { ok(HenyeyGreenstein::new(I2F30::lit("0.8"))) },
                    }
                    bind {
                        "henyey_greenstein" = HenyeyGreenstein {
                            new(asymmetry: I2F30),
                            from_one_minus(one_minus_g: U2F62),
                        }
                    }
                }
                Bilinear {
                    golden {
                        "Bilinear" => Bilinear::<G>::new([[whole::<U16F16>(1), whole(3)], [whole(2), whole(0)]]),
                        "Bilinear far" => Bilinear::<G>::new([[v::<U0F32>(0), v(1)], [v(7), v(u32::MAX)]]),
                    }
                    cost {
                        "bilinear" [u, v]: U0F32 -> [U0F32; 2] = const {
                            let weights = [[U16F16::lit("1"), U16F16::lit("3")], [U16F16::lit("2"), U16F16::lit("0.5")]];
                            ok(Bilinear::new(weights))
                        },
                    }
                    bind { "bilinear" = Bilinear { new(weights: [[U16F16; 2]; 2]), } }
                }
                Triangle {
                    golden { "Triangle" => Ok(Triangle::<G>::new()), }
                    cost { "triangle" [u, v]: U0F32 -> [I2F30; 3] = Triangle::new(), }
                    bind { "triangle" = Triangle { new(), } }
                }
                TriangleOn {
                    golden {
                        "TriangleOn" => TriangleOn::<_, 2, G>::new([
                            [whole::<I16F16>(0), whole(0)],
                            [whole(4), whole(1)],
                            [whole(0xfffd), whole(2)],
                        ]),
                        "TriangleOn solid" => TriangleOn::<_, 3, G>::new([
                            [whole::<I16F16>(0), whole(0), whole(7)],
                            [whole(4), whole(1), whole(0)],
                            [whole(0xfffd), whole(2), whole(5)],
                        ]),
                    }
                    cost {
                        "triangle_on" [u, v]: U0F32 -> [I16F16; 2] = const {
                            ok(TriangleOn::new([
                                [I16F16::lit("-90"), I16F16::lit("10")],
                                [I16F16::lit("300"), I16F16::lit("-200")],
                                [I16F16::lit("40"), I16F16::lit("250")],
                            ]))
                        },
                    }
                    bind {
                        "triangle_on_2d" = TriangleOn<U16, 2> { new(vertices: [[I16F16; 2]; 3]), }
                        "triangle_on_3d" = TriangleOn<U16, 3> { new(vertices: [[I16F16; 3]; 3]), }
                    }
                }
                StandardExponential {
                    golden { "StandardExponential" => Ok(StandardExponential::<G>::new()), }
                    cost { "standard_exponential" u: U0F32 -> U5F27 = StandardExponential::new(), }
                    bind { "standard_exponential" = StandardExponential { new(), } }
                }
                Exponential {
                    golden { "Exponential 20" => Exponential::<_, G>::from_mean(whole::<U16F16>(20)), }
                    cost { "exponential_20" u: U0F32 -> U16F16 = const { ok(Exponential::from_mean(U16F16::lit("20"))) }, }
                    bind {
                        "exponential" = Exponential<U16> { from_mean(mean: U16F16), from_rate(rate: U32F32), }
                    }
                }
                TruncatedExponential {
                    golden {
                        "TruncatedExponential 10 4" => TruncatedExponential::<_, G>::from_mean(whole::<U16F16>(10), whole(4)),
                        "TruncatedExponential 100 4" => TruncatedExponential::<_, G>::from_mean(whole::<U16F16>(100), whole(4)),
                    }
                    cost {
                        "truncated_exponential_10_20" u: U0F32 -> U16F16
                            = const { ok(TruncatedExponential::from_mean(U16F16::lit("10"), U16F16::lit("20"))) },
                        "truncated_exponential_10_1" u: U0F32 -> U16F16
                            = const { ok(TruncatedExponential::from_mean(U16F16::lit("10"), U16F16::lit("1"))) },
                    }
                    bind {
                        "truncated_exponential" = TruncatedExponential<U16> {
                            from_mean(mean: U16F16, length: U16F16),
                            from_rate(rate: U32F32, length: U16F16),
                        }
                    }
                }
                StandardNormalPair {
                    golden { "StandardNormalPair" => Ok(StandardNormalPair::<G>::new()), }
                    cost { "standard_normal_pair" [u, v]: U0F32 -> [I5F27; 2] = StandardNormalPair::new(), }
                    bind { "standard_normal_pair" = StandardNormalPair { new(), } }
                }
                NormalPair {
                    golden {
                        "NormalPair 100 20 5" => NormalPair::<_, G>::new([whole::<I16F16>(100), whole(20)], whole(5)),
                    }
                    cost {
                        "normal_pair_100_5" [u, v]: U0F32 -> [I16F16; 2]
                            = const { ok(NormalPair::new([I16F16::lit("100"); 2], I16F16::lit("5"))) },
                    }
                    bind { "normal_pair" = NormalPair<U16> { new(mean: [I16F16; 2], std_dev: I16F16), } }
                }
                MultivariateNormal {
                    golden {
                        "MultivariateNormal 2" => MultivariateNormal::<_, 2, G>::new(
                            [whole::<I16F16>(100), whole(0xfffe)],
                            [whole(5), v(77_777)],
                            [[v(1 << 30), v(0xcccc_cccd)], [v(0xcccc_cccd), v(1 << 30)]],
                        ),
                        "MultivariateNormal 3 singular" => MultivariateNormal::<_, 3, G>::new(
                            [v::<I2F30>(0), v(1 << 30), v(0xf000_0000)],
                            [v(1 << 20), v(0x0012_3456), v(1 << 24)],
                            [
                                [v(1 << 30), v(0xc000_0000), v(1 << 28)],
                                [v(0xc000_0000), v(1 << 30), v(0xf000_0000)],
                                [v(1 << 28), v(0xf000_0000), v(1 << 30)],
                            ],
                        ),
                        "MultivariateNormal 1" => MultivariateNormal::<_, 1, G>::new([v::<I32F0>(7)], [v(1000)], [[v(1 << 30)]]),
                    }
                    cost {
                        "multivariate_normal_3" [u, v, w, x]: U0F32 -> [I16F16; 3] = const {
                            let [none, some, one] = [I2F30::lit("-0.3"), I2F30::lit("0.5"), I2F30::ONE];
                            ok(MultivariateNormal::new(
                                [I16F16::lit("100"), I16F16::lit("100"), I16F16::lit("0.1")],
                                [I16F16::lit("5"), I16F16::lit("2"), I16F16::lit("0.04")],
                                [[one, some, none], [some, one, some], [none, some, one]],
                            ))
                        },
                    }
                    bind {
                        "multivariate_normal_2" = MultivariateNormal<U16, 2> {
                            new(means: [I16F16; 2], deviations: [I16F16; 2], correlations: [[I2F30; 2]; 2]),
                        }
                        "multivariate_normal_3" = MultivariateNormal<U16, 3> {
                            new(means: [I16F16; 3], deviations: [I16F16; 3], correlations: [[I2F30; 3]; 3]),
                        }
                    }
                }
                Rayleigh {
                    golden { "Rayleigh 5" => Rayleigh::<_, G>::new(whole::<U16F16>(5)), }
                    cost { "rayleigh_5" u: U0F32 -> U16F16 = const { ok(Rayleigh::new(U16F16::lit("5"))) }, }
                    bind { "rayleigh" = Rayleigh<U16> { new(scale: U16F16), } }
                }
                Laplace {
                    golden { "Laplace 100 5" => Laplace::<_, G>::new(whole::<I16F16>(100), whole(5)), }
                    cost {
                        "laplace_100_5" u: U0F32 -> I16F16
                            = const { ok(Laplace::new(I16F16::lit("100"), I16F16::lit("5"))) },
                    }
                    bind { "laplace" = Laplace<U16> { new(location: I16F16, scale: I16F16), } }
                }
                Logistic {
                    golden { "Logistic 100 5" => Logistic::<_, G>::new(whole::<I16F16>(100), whole(5)), }
                    cost {
                        "logistic_100_5" u: U0F32 -> I16F16
                            = const { ok(Logistic::new(I16F16::lit("100"), I16F16::lit("5"))) },
                    }
                    bind { "logistic" = Logistic<U16> { new(location: I16F16, scale: I16F16), } }
                }
                Tent {
                    golden { "Tent 2" => Tent::<_, G>::new(whole::<I16F16>(2)), }
                    cost { "tent_2" u: U0F32 -> I16F16 = const { ok(Tent::new(I16F16::lit("2"))) }, }
                    bind { "tent" = Tent<U16> { new(radius: I16F16), } }
                }
            }
            with floats {
                Float {
                    golden {
                        "Float Disk" => Ok(Float::new(Disk::<G>::new())),
                        "Float Tent 2" => Tent::<_, G>::new(whole::<I16F16>(2)).map(Float::new),
                    }
                    cost {
                        "float_disk" [u, v]: f32 -> [f32; 2] = Float::new(Disk::new()),
                        "float_sphere" [u, v]: f32 -> [f32; 3] = Float::new(Sphere::new()),
                        "float_cosine_hemisphere" [u, v]: f32 -> [f32; 3] = Float::new(CosineHemisphere::new()),
                        "float_phong_lobe_50" [u, v]: f32 -> [f32; 3]
                            = Float::new(const { ok(PhongLobe::new(U32F32::lit("50"))) }),
                        "float_standard_exponential" u: f32 -> f32 = Float::new(StandardExponential::new()),
                        "float_standard_normal_pair" [u, v]: f32 -> [f32; 2] = Float::new(StandardNormalPair::new()),
                    }
                    bind { none "the caller calls the float tier, or divides" }
                }
            }
            without grade {
                Interval {
                    golden {
                        "Interval of a die" => Interval::<i32>::inclusive(v(1), v(6)),
                        "Interval -3 5" => Interval::<I16F16>::new(whole(0xfffd), whole(5)),
                        "Interval of all words" => Interval::<U0F32>::inclusive(v(0), v(u32::MAX)),
                    }
                    cost { "interval_1_6" u: U0F32 -> i32 = const { ok(Interval::<i32>::inclusive(1, 6)) }, }
                    bind {
                        "interval_i32" = Interval<i32> { new(low: i32, high: i32), inclusive(low: i32, last: i32), }
                        "interval_u32" = Interval<u32> { new(low: u32, high: u32), inclusive(low: u32, last: u32), }
                        "interval_q16" = Interval<I16F16> {
                            new(low: I16F16, high: I16F16),
                            inclusive(low: I16F16, last: I16F16),
                        }
                        "interval_uq16" = Interval<U16F16> {
                            new(low: U16F16, high: U16F16),
                            inclusive(low: U16F16, last: U16F16),
                        }
                    }
                }
            }
        }
    };
}
