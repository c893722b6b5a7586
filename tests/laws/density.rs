//! The density that comes with a sample: that of its point, or one as near to it as both statements allow.

use host::docs::{Statement, row_of};
use host::errors::or_infinite;
use host::figures::{Exact, at_open_end};
use host::moved::Moved;
use host::registry::{Entry, Uniforms, entries};
use microwarp::Warp;

/// The bound of a row for these uniforms, for a warp that states it.
struct Bounds {
    rows: [Statement; 2],
}

impl Bounds {
    fn of(entry: &Entry) -> Self {
        let name = entry.name.split(' ').next().unwrap();
        let row = |title: &str| {
            let row = row_of(name, entry.tier, title);
            row.unwrap_or_else(|| panic!("{name} states no {title}"))
        };
        let titles = [
            "pdf with the sample, relative",
            "realised density, relative",
        ];
        Self {
            rows: titles.map(row),
        }
    }

    /// The sum of both bounds.
    fn sum(&self, entry: &Entry, moved: &Moved) -> f64 {
        let value = |name: &String| match name.as_str() {
            "s" => moved.density,
            "r" => moved.inverse,
            _ => entry.variable(name).expect("a parameter of the entry"),
        };
        let bound = |row: &Statement| row.eval(&row.names().iter().map(value).collect::<Vec<_>>());
        self.rows.iter().map(bound).sum()
    }
}

/// By how many times the sum of the bounds the two densities differ at most, and over how many samples.
fn disagreement(entry: &Entry, with: impl Fn(Uniforms) -> f32) -> (f64, u32) {
    let bounds = Bounds::of(entry);
    let normal = f64::from(f32::MIN_POSITIVE)..=f64::from(f32::MAX);
    let (mut worst, mut judged) = (0.0_f64, 0);
    super::for_any_uniforms(entry, |u| {
        let u = u.map(|u| {
            if u > 0.0 {
                u.min(microwarp::uniform::LARGEST)
            } else {
                0.0
            }
        });
        let exact = Exact::of(entry, u, true);
        let x = entry.warp.sample(u);
        let read = entry.truth.pdf(x.map(f64::from));
        if at_open_end(entry, u) || !normal.contains(&exact.density) || !normal.contains(&read) {
            return;
        }
        judged += 1;
        let apart = (f64::from(with(u)) - f64::from(entry.warp.pdf(x))).abs() / exact.density;
        let part = |moved: &Moved| or_infinite(apart / bounds.sum(entry, moved));
        // What rounding the point does only enlarges the bounds, and takes long to work out.
        if part(&Moved::default()) > worst {
            worst = worst.max(part(&Moved::of(entry, &exact, x)));
        }
    });
    (worst, judged)
}

#[test]
fn the_density_of_a_sample_is_that_of_its_point_unless_an_error_is_stated() {
    for entry in entries() {
        super::for_any_uniforms(&entry, |u| {
            let (x, density) = entry.warp.sample_with_pdf(u);
            let point = entry.warp.sample(u);
            assert_eq!(
                x.map(f32::to_bits),
                point.map(f32::to_bits),
                "{entry} at {u:?}"
            );
            assert!(
                density > 0.0 && density <= f32::MAX,
                "{entry} at {u:?} has {density}"
            );
            if !entry.own_density {
                assert_eq!(
                    density.to_bits(),
                    entry.warp.pdf(x).to_bits(),
                    "{entry} at {u:?}"
                );
            }
        });
    }
}

#[test]
fn both_densities_of_a_sample_agree_to_the_sum_of_their_errors() {
    let mut compared = 0;
    // Nothing is stated of densities below the normal range.
    let normal = |e: &&Entry| Exact::of(e, [0.5; 4], true).density >= f64::from(f32::MIN_POSITIVE);
    let own = |e: &&Entry| e.own_density && e.resolved;
    for entry in entries().iter().filter(own).filter(normal) {
        let (worst, judged) = disagreement(entry, |u| entry.warp.sample_with_pdf(u).1);
        println!("{entry}: {worst:.3} of the sum of both bounds, over {judged}");
        assert!(judged > 1_000, "{entry}: {judged} compared");
        assert!(worst <= 1.0, "{entry}: {worst} times the bounds");
        compared += 1;
    }
    assert!(compared >= 10, "{compared} compared");
}

/// The textbook's density of fog at the returned cosine is told from it.
#[test]
fn a_density_that_belongs_to_another_point_is_noticed() {
    let entries = entries();
    let fog = |e: &&Entry| e.name == "HenyeyGreenstein" && e.parameters == "g=0.999";
    let entry = entries.iter().find(fog).expect("fog");
    let (worst, _) = disagreement(entry, |u| {
        let [_, _, z] = entry.warp.sample(u);
        let (g, four_pi) = (0.999_f32, 4.0 * std::f32::consts::PI);
        (1.0 - g * g) / (four_pi * (1.0 + g * g - 2.0 * g * z).powf(1.5))
    });
    assert!(worst > 100.0, "the textbook passes: {worst}");
    let (worst, _) = disagreement(entry, |u| entry.warp.sample_with_pdf(u).1 * 1.000_01);
    assert!(worst > 1.0, "a density off by 1e-5 passes: {worst}");
    let (worst, _) = disagreement(entry, |_| f32::NAN);
    assert!(worst == f64::INFINITY, "NaN passes: {worst}");
}

#[test]
fn every_way_to_draw_with_a_density_gives_the_same() {
    for entry in entries() {
        let drawn = |rng: &rand_pcg::Pcg32| entry.warp.ways(rng)[0].1.map(f32::to_bits);
        for seed in 0..20 {
            let rng = rand_pcg::Pcg32::new(seed, 8);
            let ways = entry.warp.ways_with_pdf(&rng);
            assert_eq!(ways.len(), 3);
            let due = ways[0].2.to_bits();
            for (way, x, density) in ways {
                let x = x.map(f32::to_bits);
                // Some draw more words than there are uniforms, or read them more deeply than the grid.
                let own = entry.own_density && !entry.composed && !entry.deep;
                if way == "sampled" && !own {
                    continue;
                }
                assert_eq!(x, drawn(&rng), "{entry}: {way}");
                assert_eq!(density.to_bits(), due, "{entry}: {way}");
            }
        }
    }
}

/// The density of a law at the point of a uniform, by a formula, and by the law with a sample in both tiers.
fn with_a_sample<W: Warp<Uniforms = f32, Density = f32>>(
    warps: [W; 2],
    exact: impl Fn(f64) -> f64,
) -> f64 {
    let mut worst = 0.0_f64;
    for u in [f32::from_bits(1), f32::from_bits(5), 1e-42, 3e-39, 1e-31] {
        for warp in &warps {
            let (_, density) = warp.sample_with_pdf(u);
            let error = (f64::from(density) / exact(f64::from(u)) - 1.0).abs();
            worst = worst.max(or_infinite(error));
        }
    }
    worst
}

#[test]
fn densities_with_samples_keep_their_digits_at_the_smallest_uniforms() {
    // Of each the density is a plain number where the uniform is subnormal.
    macro_rules! worst {
        ($warp:ident($($parameter:literal),+), $exact:expr) => {{
            let warp = microwarp::libm::$warp::new($($parameter),+).unwrap();
            let libm = with_a_sample([warp; 2], $exact);
            let warp = microwarp::poly::$warp::new($($parameter),+).unwrap();
            f64::max(libm, with_a_sample([warp; 2], $exact))
        }};
    }
    let power = worst!(Power(1.5, 0.0, 1.0), |u| 2.5 * u.powf(0.6));
    let weibull = worst!(Weibull(1.0, 2.5), |u| 2.5 * u.powf(0.6));
    let gumbel = worst!(Gumbel(0.0, 1e-10), |u| -u.ln() * u / f64::from(1e-10_f32));
    for error in [power, weibull, gumbel] {
        assert!(error <= 2e-6, "{power:e} {weibull:e} {gumbel:e}");
    }
    // From a product with a subnormal number.
    let flawed = worst!(Weibull(1.0, 2.5), |u| {
        let rate = 2.5 * u as f32;
        f64::from(rate) / u.powf(0.4)
    });
    assert!(flawed > 0.01, "{flawed:e}");
    let normal = microwarp::poly::TruncatedNormal::new(0.0, 1e-28, -1e-26, 1e-26).unwrap();
    let (x, density) = normal.sample_with_pdf(1e-20);
    let error = (density / normal.pdf(x) - 1.0).abs();
    assert!(error <= 1e-4, "{density:e} at {x:e}");
}

/// The density of a Weibull law at 0 is that of its power of x: without end, of the rate, or none, which counts as the smallest
/// number since 0 is in the domain.
#[test]
fn a_weibull_law_has_the_density_of_its_power_at_0() {
    let least = f32::from_bits(1);
    let cases = [
        (0.5, f32::MAX),
        (1.0, 0.25),
        (1.000_000_1, least),
        (3.0, least),
    ];
    for (shape, due) in cases {
        let [libm, poly] = [
            microwarp::libm::Weibull::new(4.0, shape).unwrap().pdf(0.0),
            microwarp::poly::Weibull::new(4.0, shape).unwrap().pdf(0.0),
        ];
        assert_eq!((libm, poly), (due, due));
    }
}

/// What rounds to the smallest number has the density of the point before it was rounded, which may lie half as high again.
#[test]
fn a_log_normal_number_rounded_to_the_smallest_has_its_own_density() {
    let (mean, deviation) = (-86.839_485, 3.204_307);
    let truth = host::truth::log_normal(mean, deviation);
    let libm = microwarp::libm::LogNormal::new(mean, deviation).unwrap();
    let poly = microwarp::poly::LogNormal::new(mean, deviation).unwrap();
    let least = f32::from_bits(1);
    let (mut worst, mut flawed, mut met) = (0.0_f64, 0.0_f64, 0);
    for k in 1_u16..400 {
        let u = 1e-9 * f32::from(k);
        let exact = truth.density([f64::from(u), 0.0, 0.0, 0.0]);
        for (x, density) in [libm.sample_with_pdf(u), poly.sample_with_pdf(u)] {
            let error = |density: f32| or_infinite((f64::from(density) / exact - 1.0).abs());
            worst = worst.max(error(density));
            if x <= least {
                met += 1;
                flawed = flawed.max(error(poly.pdf(x)));
            }
        }
    }
    assert!(worst <= 7.2e-6, "{worst:e}");
    assert!(met > 100 && flawed > 0.1, "{met} samples, {flawed:e}");
}
