//! Functions of either sign: weights have the mean 1, means are those under the function, and filters are their formulas.

use host::errors::or_infinite;
use microwarp::Error;
use microwarp::discrete::{SignedLinear1d, filter};
use rand_pcg::Pcg32;
use std::f64::consts::PI;

const LOW: f32 = -2.0;
const HIGH: f32 = 1.75;

/// A function by its vertices, with its sampler.
struct Case<const N: usize> {
    name: &'static str,
    vertices: [f32; N],
    table: SignedLinear1d<N>,
}

impl<const N: usize> Case<N> {
    fn new(name: &'static str, vertices: [f32; N]) -> Self {
        let table = SignedLinear1d::new(&vertices, LOW, HIGH).expect(name);
        Self {
            name,
            vertices,
            table,
        }
    }

    /// The vertices at the ends of each cell.
    fn cells(&self) -> Vec<[f64; 2]> {
        let pairs = self.vertices.windows(2);
        pairs
            .map(|pair| [pair[0], pair[1]].map(f64::from))
            .collect()
    }

    fn width() -> f64 {
        (f64::from(HIGH) - f64::from(LOW)) / (N - 1) as f64
    }

    fn at(cell: usize, t: f64) -> f64 {
        f64::from(LOW) + (cell as f64 + t) * Self::width()
    }

    /// The part of the words that lead to a cell.
    fn mass(&self, cell: usize) -> f64 {
        self.table.sizes().cdf().numerator(cell) as f64 / 2f64.powi(32)
    }

    /// The mean of the weight times a function, by the words of the table and its density within each cell.
    fn mean(&self, weight: &dyn Fn(f32) -> f32, g: fn(f64) -> f64) -> f64 {
        const STEPS: usize = 400;
        let cells = self.cells();
        let of = |(cell, [a, b]): (usize, &[f64; 2])| {
            let inner = |k: usize| {
                let t = (k as f64 + 0.5) / STEPS as f64;
                let (x, size) = (Self::at(cell, t), (1.0 - t) * a.abs() + t * b.abs());
                let share = size / (0.5 * (a.abs() + b.abs()) * STEPS as f64);
                if size > 0.0 {
                    share * f64::from(weight(x as f32)) * g(x)
                } else {
                    0.0
                }
            };
            self.mass(cell) * (0..STEPS).map(inner).sum::<f64>()
        };
        cells.iter().enumerate().map(of).sum()
    }

    /// The mean under the function itself.
    fn exact(&self, g: fn(f64) -> f64) -> f64 {
        const STEPS: usize = 400;
        let (mut sum, mut whole) = (0.0, 0.0);
        for (cell, [a, b]) in self.cells().into_iter().enumerate() {
            for k in 0..STEPS {
                let t = (k as f64 + 0.5) / STEPS as f64;
                let f = (1.0 - t) * a + t * b;
                sum += f * g(Self::at(cell, t));
                whole += f;
            }
        }
        sum / whole
    }

    /// ∫|f|/∫f of sizes that are linear in each cell.
    fn ratio(&self) -> f64 {
        let [mut sizes, mut sum] = [0.0; 2];
        for [a, b] in self.cells() {
            sizes += a.abs() + b.abs();
            sum += a + b;
        }
        sizes / sum
    }

    fn holds(&self) {
        let weight = |x| self.table.weight(x);
        let functions: [fn(f64) -> f64; 3] = [|_| 1.0, |x| x, |x| (2.0 * x + 0.3).cos()];
        let off = |weight: &dyn Fn(f32) -> f32| {
            let off = functions.map(|g| (self.mean(weight, g) - self.exact(g)).abs());
            off.into_iter().map(or_infinite).fold(0.0, f64::max)
        };
        let found = off(&weight);
        let ratio = self.ratio();
        println!(
            "{}, {N} vertices: S {ratio:.5}, means off by {found:.1e}",
            self.name
        );
        assert!(found <= 2e-6, "{}: {found:e}", self.name);
        if ratio > 1.001 {
            let unsigned = off(&|x| weight(x).abs());
            let halved = off(&|x| weight(x) / ratio as f32);
            assert!(unsigned > 1e-3 && halved > 1e-3, "{unsigned:e}, {halved:e}");
        }
        self.weights_are_right(ratio);
    }

    fn weights_are_right(&self, ratio: f64) {
        let cells = self.cells();
        let sum: f64 = cells.iter().map(|[a, b]| a + b).sum();
        let ulp = f64::from(HIGH.max(-LOW)) * f64::from(f32::EPSILON);
        let mut rng = Pcg32::new(5, 5);
        let mut worst: [f64; 2] = [0.0; 2];
        for _ in 0..20_000 {
            let (x, w) = self.table.draw(&mut rng);
            let cell = self.table.sizes().cell(x);
            let [a, b] = cells[cell];
            let t = (f64::from(x) - Self::at(cell, 0.0)) / Self::width();
            let size = (1.0 - t) * a.abs() + t * b.abs();
            let sign = ((1.0 - t) * a + t * b) / size;
            let whole = (a.abs() + b.abs()) / (self.mass(cell) * sum);
            let error = (f64::from(w) - sign * whole).abs();
            let changes = a * b < 0.0;
            let steep = if changes {
                2.0 * (a * b).abs() / size.powi(2)
            } else {
                0.0
            };
            let allowed = whole * (3e-7 + steep * 1.5 * ulp / Self::width());
            assert!(error <= allowed, "{}: {x}: {w}, {error:e} off", self.name);
            let kind = usize::from(changes);
            worst[kind] = worst[kind].max(error / whole);
            assert!(f64::from(w).abs() <= ratio * 1.001 + 1e-6);
        }
        let [one, both] = worst;
        println!("  weights off by {one:.1e} in cells of one sign, {both:.1e} of both");
    }
}

#[test]
fn means_of_weights_are_those_under_the_function() {
    Case::new("gaussian", filter::gaussian::<33>(1.0 / 3.0)).holds();
    Case::new("Blackman-Harris", filter::blackman_harris::<33>()).holds();
    Case::new("Mitchell", filter::mitchell::<16>(1.0 / 3.0, 1.0 / 3.0)).holds();
    Case::new("Mitchell", filter::mitchell::<65>(1.0 / 3.0, 1.0 / 3.0)).holds();
    Case::new("Catmull-Rom", filter::mitchell::<33>(0.0, 0.5)).holds();
    Case::new("Lanczos 3", filter::lanczos::<17>(3)).holds();
    Case::new("Lanczos 3", filter::lanczos::<129>(3)).holds();
    Case::new(
        "a change of sign in a cell",
        [3.0, -1.0, 0.0, 0.0, -0.5, 2.5],
    )
    .holds();
    Case::new("more of it negative than not", [-1e-3, 2.0, -1.9, 1.0]).holds();
}

/// The values of filters beside their formulas, and what their signs cost.
#[test]
fn filters_are_their_formulas() {
    const N: usize = 257;
    fn check(name: &str, vertices: [f32; N], f: impl Fn(f64) -> f64) {
        let mut worst: f64 = 0.0;
        for (i, found) in vertices.into_iter().enumerate() {
            let t = (2 * i) as f64 / (N - 1) as f64 - 1.0;
            worst = worst.max((f64::from(found) - f(t)).abs());
            assert_eq!(found, vertices[N - 1 - i]);
        }
        println!("{name}: off by {worst:.1e}");
        assert!(worst <= 5e-7, "{name}: {worst:e}");
    }
    let sinc = |x: f64| {
        if x == 0.0 {
            1.0
        } else {
            (PI * x).sin() / (PI * x)
        }
    };
    let cubic = |b: f64, c: f64| {
        move |t: f64| {
            let x = 2.0 * t.abs();
            let far = [
                8.0 * b + 24.0 * c,
                -12.0 * b - 48.0 * c,
                6.0 * b + 30.0 * c,
                -b - 6.0 * c,
            ];
            let near = [
                6.0 - 2.0 * b,
                0.0,
                12.0 * b + 6.0 * c - 18.0,
                12.0 - 9.0 * b - 6.0 * c,
            ];
            let [p, q, r, s] = if x < 1.0 { near } else { far };
            (p + x * (q + x * (r + x * s))) / 6.0
        }
    };
    let deviation = f64::from(1.0_f32 / 3.0);
    let normal = move |t: f64| (-0.5 * (t / deviation).powi(2)).exp();
    check("gaussian", filter::gaussian(1.0 / 3.0), move |t| {
        normal(t) - normal(1.0)
    });
    check("Blackman-Harris", filter::blackman_harris(), |t| {
        let terms = [0.35875, 0.48829, 0.14128, 0.01168];
        (0..4).map(|k| terms[k] * (k as f64 * PI * t).cos()).sum()
    });
    check(
        "Mitchell",
        filter::mitchell(1.0 / 3.0, 1.0 / 3.0),
        cubic(1.0 / 3.0, 1.0 / 3.0),
    );
    check("B-spline", filter::mitchell(1.0, 0.0), cubic(1.0, 0.0));
    check("Lanczos 3", filter::lanczos(3), |t| sinc(3.0 * t) * sinc(t));
    check("Lanczos 2", filter::lanczos(2), |t| sinc(2.0 * t) * sinc(t));
    let page = host::docs::sources("discrete")
        .into_iter()
        .find(|(path, _)| path.ends_with("filter.rs"));
    let page = page.unwrap().1;
    for (ratio, line) in [
        (
            Case::new("Mitchell", filter::mitchell::<N>(1.0 / 3.0, 1.0 / 3.0)).ratio(),
            "mitchell",
        ),
        (
            Case::new("Lanczos", filter::lanczos::<N>(3)).ratio(),
            "lanczos",
        ),
        (
            Case::new("gaussian", filter::gaussian::<N>(1.0 / 3.0)).ratio(),
            "gaussian",
        ),
    ] {
        let row = page
            .lines()
            .find(|row| row.starts_with(&format!("//! | [`{line}`]")))
            .unwrap();
        let cells: Vec<f64> = row
            .split('|')
            .filter_map(|cell| cell.trim().parse().ok())
            .collect();
        let [stated, variance] = cells[..] else {
            panic!("{row}")
        };
        println!("{line}: S {ratio:.5}, S^4 - 1 {:.3}", ratio.powi(4) - 1.0);
        assert!((ratio / stated - 1.0).abs() <= 3e-4);
        assert!((ratio.powi(4) - 1.0 - variance).abs() <= 0.01);
    }
}

#[test]
fn functions_without_a_positive_integral_are_refused() {
    let new = |vertices: [f32; 3]| SignedLinear1d::new(&vertices, 0.0, 1.0).map(|_| ());
    assert_eq!(new([1.0, -0.5, 1.0]), Ok(()));
    for negative in [
        [-1.0, -1.0, -1.0],
        [1.0, -1.0, 1.0],
        [1.0, -1.000_001, 1.0],
        [1e38, -3e38, 1e38],
    ] {
        assert_eq!(
            new(negative),
            Err(Error::NotNormalizable(0)),
            "{negative:?}"
        );
    }
    assert_eq!(new([1.0, -0.999_99, 1.0]), Ok(()));
    assert_eq!(new([0.0, -0.0, 0.0]), Err(Error::AllZero));
    assert_eq!(new([1.0, f32::NAN, 1.0]), Err(Error::NotFiniteWeight(1)));
    assert_eq!(
        new([1.0, 1.0, f32::NEG_INFINITY]),
        Err(Error::NotFiniteWeight(2))
    );
    assert_eq!(SignedLinear1d::new(&[1.0], 0.0, 1.0), Err(Error::NoWeights));
    assert_eq!(
        SignedLinear1d::new(&[1.0, 1.0], 1.0, 0.0),
        Err(Error::Reversed(2))
    );
    assert_eq!(
        SignedLinear1d::new(&[1.0, 1.0], 1.0, 1.0),
        Err(Error::Empty(2))
    );
    for odd in [0.0, f32::NAN, f32::INFINITY, -1e-30, 1e-30] {
        let made = SignedLinear1d::new(&filter::gaussian::<9>(odd), -1.0, 1.0);
        assert!(made.is_err(), "{odd}");
    }
    assert!(SignedLinear1d::new(&filter::mitchell::<9>(f32::NAN, 0.0), -1.0, 1.0).is_err());
    assert!(SignedLinear1d::new(&filter::lanczos::<1>(3), -1.0, 1.0).is_err());
}

/// Any size of the function gives the same weights, and there are some beyond it.
#[test]
fn weights_do_not_depend_on_the_size_of_the_function() {
    let base = filter::lanczos::<33>(2);
    let table = SignedLinear1d::new(&base, -2.0, 2.0).unwrap();
    for power in [127, 100, -100, -110] {
        let scaled = base.map(|f| (f64::from(f) * 2f64.powi(power)) as f32);
        let other = SignedLinear1d::new(&scaled, -2.0, 2.0).unwrap();
        let mut draws = [Pcg32::new(3, 3), Pcg32::new(3, 3)];
        for _ in 0..2000 {
            let [(x, w), (y, v)] = [table.draw(&mut draws[0]), other.draw(&mut draws[1])];
            assert!(
                x.to_bits() == y.to_bits() && (w - v).abs() <= 2e-6 * w.abs().max(1.0),
                "{x}, {w}, {v}"
            );
            assert_eq!(
                table.sample(0.3),
                (table.sample(0.3).0, table.weight(table.sample(0.3).0))
            );
        }
    }
    for x in [-2.1, 2.1, f32::NAN, f32::INFINITY] {
        assert_eq!(table.weight(x), 0.0);
    }
    let gap = SignedLinear1d::new(&[1.0, 0.0, 0.0, 1.0], 0.0, 3.0).unwrap();
    assert_eq!(gap.weight(1.5), 0.0);
}
