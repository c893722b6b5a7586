//! Nanoseconds a point on the host: every warp in both tiers beside the generator alone.
//!
//! `cargo bench --bench warps`. Each figure is for 1,024 points with PCG32, drawn one by one or filled, so that calls
//! and clocks do not show; compare figures of one run only.

use divan::{Bencher, black_box};
use microwarp::{Warp, uniform};
use rand_pcg::Pcg32;

const POINTS: usize = 1_024;

fn main() {
    divan::main();
}

fn repeat<W: Warp>(bencher: Bencher, warp: &W, action: impl Fn(&W, &mut Pcg32, &mut [W::Point])) {
    let mut rng = Pcg32::new(1, 1);
    let mut points = vec![warp.draw(&mut rng); POINTS];
    bencher
        .counter(divan::counter::ItemsCount::new(POINTS))
        .bench_local(|| action(black_box(warp), &mut rng, black_box(&mut points)));
}

fn draw<W: Warp>(bencher: Bencher, warp: &W) {
    repeat(bencher, warp, |warp, rng, points| {
        for point in points {
            *point = warp.draw(rng);
        }
    });
}

fn fill<W: Warp>(bencher: Bencher, warp: &W) {
    repeat(bencher, warp, |warp, rng, points| warp.fill(rng, points));
}

/// The floor: two words of the generator as uniforms, and nothing made of them.
#[divan::bench]
fn a_floor_of_two_uniforms(bencher: Bencher) {
    let mut rng = Pcg32::new(1, 1);
    let mut points = vec![[0.0; 2]; POINTS];
    bencher
        .counter(divan::counter::ItemsCount::new(POINTS))
        .bench_local(|| {
            for point in black_box(&mut points) {
                *point = [uniform::grid(&mut rng), uniform::grid(&mut rng)];
            }
        });
}

/// The same warps in a tier; one line each.
macro_rules! benches {
    ($tier:ident) => {
        mod $tier {
            use super::*;
            use divan::Bencher;

            macro_rules! bench {
                ($name:ident, $warp:expr) => {
                    mod $name {
                        use super::*;

                        #[divan::bench]
                        fn draw(bencher: Bencher) {
                            super::draw(bencher, &$warp);
                        }
                        #[divan::bench]
                        fn fill(bencher: Bencher) {
                            super::fill(bencher, &$warp);
                        }
                    }
                };
            }
            use ::microwarp::$tier as mw;
            bench!(interval, mw::Interval::new(-3.0, 5.0).unwrap());
            bench!(power, mw::Power::new(2.5, 0.0, 1.0).unwrap());
            bench!(exponential, mw::Exponential::new(1.0).unwrap());
            bench!(exponential_tail, mw::ExponentialTail::new(1.0).unwrap());
            bench!(
                truncated_exponential,
                mw::TruncatedExponential::new(2.0, 3.0).unwrap()
            );
            bench!(tent, mw::Tent::new(1.0).unwrap());
            bench!(linear, mw::Linear::new(1.0, 3.0).unwrap());
            bench!(normal, mw::Normal::new(0.0, 1.0).unwrap());
            bench!(normal_pair, mw::NormalPair::new([0.0; 2], 1.0).unwrap());
            bench!(disk, mw::Disk::new());
            bench!(disk_concentric, mw::DiskConcentric::new());
            bench!(triangle, mw::Triangle::new());
            bench!(sphere, mw::Sphere::new());
            bench!(hemisphere, mw::Hemisphere::new());
            bench!(cosine_hemisphere, mw::CosineHemisphere::new());
            bench!(malley_hemisphere, mw::MalleyHemisphere::new());
            bench!(phong_lobe, mw::PhongLobe::new(50.0).unwrap());
            bench!(cone, mw::Cone::from_angle(0.1).unwrap());
        }
    };
}

benches!(libm);
benches!(poly);
