//! Jittered strata: every stratum gets its point, the mean stays right, and the variance falls below that
//! of plain sampling, on a smooth integrand and on a discontinuous one.

use host::generators::Cycle;
use microwarp::uniform::{LARGEST, Strata1d, Strata2d, grid, grid_from_word};
use rand_pcg::Pcg32;

/// Estimates of an integral by plain and by stratified sampling: means and variances of each.
struct Contest {
    plain: (f64, f64),
    stratified: (f64, f64),
}

/// What it is, its exact integral, by what factor the variance must fall, and the integrand.
type Integrand<X> = (&'static str, f64, f64, fn(X) -> f64);

const REPEATS: u32 = 20_000;

/// Runs both estimators many times.
fn contest(
    seed: u64,
    mut plain: impl FnMut(&mut Pcg32) -> f64,
    mut stratified: impl FnMut(&mut Pcg32) -> f64,
) -> Contest {
    let mut rng = Pcg32::new(seed, seed);
    let mut moments = |estimate: &mut dyn FnMut(&mut Pcg32) -> f64| {
        let estimates: Vec<f64> = (0..REPEATS).map(|_| estimate(&mut rng)).collect();
        let mean = estimates.iter().sum::<f64>() / f64::from(REPEATS);
        let squares: f64 = estimates.iter().map(|e| (e - mean) * (e - mean)).sum();
        (mean, squares / f64::from(REPEATS - 1))
    };
    Contest {
        plain: moments(&mut plain),
        stratified: moments(&mut stratified),
    }
}

impl Contest {
    /// Asserts that both are unbiased and that stratifying wins by at least a factor.
    fn assert_won(&self, what: &str, exact: f64, factor: f64) {
        let Self { plain, stratified } = self;
        println!(
            "{what}: variance {:.3e} plain, {:.3e} stratified, {:.1} times less",
            plain.1,
            stratified.1,
            plain.1 / stratified.1
        );
        for (mean, variance) in [plain, stratified] {
            // Seven standard errors: a false alarm in 4e11 runs.
            let error = (variance / f64::from(REPEATS)).sqrt();
            assert!(
                (mean - exact).abs() <= 7.0 * error + 1e-7,
                "{what}: {mean} for {exact}"
            );
        }
        assert!(
            stratified.1 * factor <= plain.1,
            "{what}: less than {factor} times better"
        );
    }
}

#[test]
fn strata_of_the_line_lower_the_variance() {
    let strata = Strata1d::new(64).unwrap();
    let integrands: [Integrand<f64>; 2] = [
        // What is left is the mean of (f')²/(12 · 64²) of the variance 0.242: one part in 3723.
        ("e^x, 64 strata", 1f64.exp() - 1.0, 3000.0, f64::exp),
        // Only the stratum with the step still varies, by 2/9 where plain sampling has 64 · 2/9.
        ("x < 1/3, 64 strata", f64::from(1.0_f32 / 3.0), 40.0, |x| {
            f64::from(u8::from(x < f64::from(1.0_f32 / 3.0)))
        }),
    ];
    for (seed, (what, exact, factor, f)) in (1..).zip(integrands) {
        let result = contest(
            seed,
            |rng| (0..64).map(|_| f(f64::from(grid(rng)))).sum::<f64>() / 64.0,
            |rng| {
                (0..64)
                    .map(|i| f(f64::from(strata.draw(i, rng))))
                    .sum::<f64>()
                    / 64.0
            },
        );
        result.assert_won(what, exact, factor);
    }
}

#[test]
fn strata_of_the_square_lower_the_variance() {
    let strata = Strata2d::new(16, 8).unwrap();
    let integrands: [Integrand<[f64; 2]>; 2] = [
        // What is left is the mean of (∂f/∂x)²/(12 · 16²) + (∂f/∂y)²/(12 · 8²) of the variance
        // 1/10 - 4/(9 pi²): one part in 46.
        (
            "sin(pi x) y², 16 x 8 strata",
            2.0 / std::f64::consts::PI / 3.0,
            40.0,
            |[x, y]| (std::f64::consts::PI * x).sin() * y * y,
        ),
        // At most the 16 + 8 strata along the arc still vary, by 1/4 at most: 6 where plain sampling has
        // 128 times 0.1685, 21.6.
        (
            "quarter disk, 16 x 8 strata",
            std::f64::consts::FRAC_PI_4,
            3.5,
            |[x, y]| f64::from(u8::from(x * x + y * y < 1.0)),
        ),
    ];
    for (seed, (what, exact, factor, f)) in (11..).zip(integrands) {
        let result = contest(
            seed,
            |rng| {
                (0..128)
                    .map(|_| f([grid(rng), grid(rng)].map(f64::from)))
                    .sum::<f64>()
                    / 128.0
            },
            |rng| {
                (0..128)
                    .map(|k| f(strata.draw(k, rng).map(f64::from)))
                    .sum::<f64>()
                    / 128.0
            },
        );
        result.assert_won(what, exact, factor);
    }
}

/// Whether x lies in stratum i of n, but for the rounding down to the 24-bit grid.
fn within(x: f32, i: u32, n: u32) -> bool {
    let (x, i, n) = (f64::from(x), f64::from(i), f64::from(n));
    (0.0..1.0).contains(&x) && x > i / n - 2f64.powi(-24) && x < (i + 1.0) / n
}

/// Whether a drawn x does: it is the middle of a cell of 2⁻²³, across a border by half of one unless that is on its edge.
fn drawn_within(x: f32, i: u32, n: u32) -> bool {
    let half = if n.is_power_of_two() {
        0.0
    } else {
        2f64.powi(-24)
    };
    let (x, i, n) = (f64::from(x), f64::from(i), f64::from(n));
    x > 0.0 && x < 1.0 && x > i / n - half && x < (i + 1.0) / n + half
}

#[test]
fn every_stratum_of_the_line_gets_its_point() {
    let mut rng = Pcg32::new(21, 21);
    for count in [1, 2, 3, 7, 64, 1000, 65_537, (1 << 23) - 1, 1 << 23] {
        let strata = Strata1d::new(count).unwrap();
        for k in 0..count.min(100_000) {
            // Spread over all of them where there are more.
            let i = (u64::from(k) * u64::from(count) / u64::from(count.min(100_000))) as u32;
            for x in [strata.point(i, 0.0), strata.point(i, LARGEST)] {
                assert!(within(x, i, count), "stratum {i} of {count} got {x}");
            }
            let ends = [0, u32::MAX].map(|word| strata.draw(i, &mut Cycle::new(&[word])));
            for x in [strata.draw(i, &mut rng), ends[0], ends[1]] {
                assert!(drawn_within(x, i, count), "stratum {i} of {count} drew {x}");
            }
        }
        assert!(within(strata.point(count - 1, LARGEST), count - 1, count));
    }
}

#[test]
fn every_stratum_of_the_square_gets_its_point() {
    let mut rng = Pcg32::new(22, 22);
    for (columns, rows) in [(1, 1), (1, 9), (9, 1), (3, 5), (16, 8), (333, 77)] {
        let strata = Strata2d::new(columns, rows).unwrap();
        assert_eq!(strata.count(), columns * rows);
        for k in 0..strata.count() {
            for [x, y] in [
                strata.point(k, [0.0, LARGEST]),
                strata.point(k, [LARGEST, 0.0]),
            ] {
                let placed = within(x, k % columns, columns) && within(y, k / columns, rows);
                assert!(placed, "stratum {k} of {columns} x {rows} got ({x}, {y})");
            }
            let [x, y] = strata.draw(k, &mut rng);
            let placed =
                drawn_within(x, k % columns, columns) && drawn_within(y, k / columns, rows);
            assert!(placed, "stratum {k} of {columns} x {rows} drew ({x}, {y})");
        }
    }
}

/// How far a drawn point is, on average, from the place of its word in its stratum: nowhere. The grid's jitter was 2⁻²⁵
/// low.
#[test]
fn drawn_points_are_right_on_average() {
    for count in [1, 3, 64, 1000] {
        let strata = Strata1d::new(count).unwrap();
        let mean = |at: &dyn Fn(u32, u32) -> f32| {
            let (mut sum, mut points) = (0.0, 0.0);
            for k in 0..1_u32 << 16 {
                // Odd, so that the low half takes every value once, in no order of the high one.
                let word = k << 16 | (k.wrapping_mul(40_503) & 0xffff);
                for i in 0..count {
                    let place = (f64::from(word) + 0.5) * 2f64.powi(-32);
                    sum += f64::from(at(i, word)) - (f64::from(i) + place) / f64::from(count);
                    points += 1.0;
                }
            }
            sum / points
        };
        let drawn = mean(&|i, word| strata.draw(i, &mut Cycle::new(&[word])));
        let grid = mean(&|i, word| strata.point(i, grid_from_word(word)));
        println!("{count} strata: {drawn:.1e} off on average, of the grid's jitter {grid:.1e}");
        assert!(drawn.abs() <= 1e-9, "{drawn}");
        assert!(grid.abs() > 2.5e-8, "{grid}");
    }
}
