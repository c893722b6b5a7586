//! What draws of chains say, by the definitions of Vehtari et al. (2021) in f64, and the draws that `reference.py` makes too.

use host::mean::mean_and_variance;
use host::truth::normal_quantile_lower;

/// The figures of a line of `reference.csv`, in its order: split R̂, R̂ by ranks, folded R̂; effective sizes of mean, bulk and tails;
/// the error of the mean.
pub type Figures = [f64; 7];

type Run = Vec<f64>;

fn mean(x: &[f64]) -> f64 {
    mean_and_variance(x.iter().copied()).0
}

fn variance(x: &[f64]) -> f64 {
    mean_and_variance(x.iter().copied()).1
}

fn halves(runs: &[Run]) -> Vec<Run> {
    let both = |run: &Run| {
        let half = run.len() / 2;
        [run[..half].to_vec(), run[run.len() - half..].to_vec()]
    };
    runs.iter().flat_map(both).collect()
}

fn ranked(runs: &[Run]) -> Vec<Run> {
    let mut sorted = runs.concat();
    sorted.sort_by(f64::total_cmp);
    let n = sorted.len() as f64;
    let score = |&x: &f64| {
        let below = sorted.partition_point(|y| *y < x) as f64;
        let up_to = sorted.partition_point(|y| *y <= x) as f64;
        let tail = |rank: f64| normal_quantile_lower((rank - 0.375) / (n + 0.25));
        let rank = (below + up_to + 1.0) / 2.0;
        if 2.0 * rank <= n + 1.0 {
            tail(rank)
        } else {
            -tail(n + 1.0 - rank)
        }
    };
    runs.iter()
        .map(|run| run.iter().map(score).collect())
        .collect()
}

fn folded(runs: &[Run]) -> Vec<Run> {
    let mut sorted = runs.concat();
    sorted.sort_by(f64::total_cmp);
    let upper = sorted.len() / 2;
    let median = (sorted[upper - 1] + sorted[upper]) / 2.0;
    let fold = |run: &Run| run.iter().map(|x| (x - median).abs()).collect();
    runs.iter().map(fold).collect()
}

/// Of runs that may differ in length.
pub fn r_hat(runs: &[Run]) -> f64 {
    let n = runs.iter().map(Vec::len).min().unwrap() as f64;
    let means: Run = runs.iter().map(|run| mean(run)).collect();
    let within = mean(&runs.iter().map(|run| variance(run)).collect::<Run>());
    (variance(&means) / within + (n - 1.0) / n).sqrt()
}

/// The effective size, and how near 0 the sum of a pair came that ends the series or could have.
fn size(runs: &[Run]) -> (f64, f64) {
    let (n, all) = (runs[0].len(), runs.concat());
    let count = all.len() as f64;
    if all.iter().all(|&x| x == all[0]) {
        return (count, 1.0);
    }
    let means: Run = runs.iter().map(|run| mean(run)).collect();
    let within = mean(&runs.iter().map(|run| variance(run)).collect::<Run>());
    let pooled = within * (n as f64 - 1.0) / n as f64 + variance(&means);
    let rho = |lag: usize| {
        let products = runs.iter().zip(&means).map(|(run, m)| {
            let pairs = run.iter().zip(&run[lag..]);
            pairs.map(|(x, y)| (x - m) * (y - m)).sum::<f64>()
        });
        1.0 - (within - products.sum::<f64>() / count) / pooled
    };
    let mut pairs = vec![(1.0, 1.0 + rho(1))];
    let mut nearest = pairs[0].1.abs();
    let mut lag = 2;
    while lag + 2 < n && pairs[pairs.len() - 1].1 > 0.0 {
        let even = rho(lag);
        pairs.push((even, even + rho(lag + 1)));
        nearest = nearest.min(pairs[pairs.len() - 1].1.abs());
        lag += 2;
    }
    let (even, last) = pairs.pop().unwrap();
    let mut least = f64::INFINITY;
    let mut sum = -1.0;
    for (_, pair) in pairs {
        least = least.min(pair);
        sum += 2.0 * least;
    }
    if even > 0.0 || last >= 0.0 {
        sum += even;
    }
    (
        count / sum.max(1.0 / count.log10()),
        nearest.min(even.abs()),
    )
}

/// All figures by the definitions, and how near 0 a sum came that decides where a series ends.
pub fn exact(runs: &[Vec<f32>]) -> (Figures, f64) {
    let wide = |run: &Vec<f32>| run.iter().map(|&x| f64::from(x)).collect();
    let runs: Vec<Run> = runs.iter().map(wide).collect();
    let (all, split) = (runs.concat(), halves(&runs));
    let (ranks, folds) = (ranked(&split), ranked(&folded(&split)));
    let mut sorted = all.clone();
    sorted.sort_by(f64::total_cmp);
    let last = sorted.len() - 1;
    // Whether a quantile or the lower of its neighbours is the limit makes no difference.
    let tail = |twentieth: usize| {
        let limit = sorted[last * twentieth / 20];
        let below = |&x: &f64| if x <= limit { 1.0 } else { 0.0 };
        let of = |run: &Run| run.iter().map(below).collect();
        size(&split.iter().map(of).collect::<Vec<Run>>())
    };
    let sizes = [size(&split), size(&ranks), tail(1), tail(19)];
    let nearest = sizes.iter().fold(1.0, |near: f64, size| near.min(size.1));
    let (bulk, fold) = (r_hat(&ranks), r_hat(&folds));
    let [of_mean, of_bulk, low, high] = sizes.map(|size| size.0);
    let error = (variance(&all) / of_mean).sqrt();
    let figures = [
        r_hat(&split),
        bulk.max(fold),
        fold,
        of_mean,
        of_bulk,
        low.min(high),
        error,
    ];
    (figures, nearest)
}

/// The generator of `reference.py`: the same numbers by the same sums and products.
struct Words(u64);

impl Words {
    fn uniform(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005);
        self.0 = self.0.wrapping_add(1_442_695_040_888_963_407);
        ((self.0 >> 33) as f64 + 0.5) / 2_147_483_648.0
    }

    fn normal(&mut self) -> f64 {
        (0..12).fold(0.0, |sum, _| sum + self.uniform()) - 6.0
    }

    fn series(&mut self, n: usize, rho: f64, of: impl Fn(usize, f64) -> f64) -> Run {
        let mut x = self.normal();
        let step = |i| {
            let now = of(i, x);
            x = rho * x + (1.0 - rho * rho) * self.normal();
            now
        };
        (0..n).map(step).collect()
    }

    fn run(&mut self, case: &str, chain: usize, n: usize) -> Run {
        let far = |shift: f64| move |_: usize, x: f64| shift + x;
        match case {
            "slow" => self.series(n, 0.9, far(0.0)),
            "negative" => self.series(n, -0.5, far(0.0)),
            "very negative" => self.series(n, -0.9, far(0.0)),
            "one apart" => self.series(n, 0.5, far(if chain == 2 { 1.5 } else { 0.0 })),
            "one wide" => self.series(n, 0.5, |_, x| if chain == 1 { 3.0 * x } else { x }),
            "drift" => self.series(n, 0.5, |i, x| i as f64 * 0.005 + x),
            "alone" => self.series(n, 0.7, far(0.0)),
            "heavy" => {
                let odds = |u: f64| (2.0 * u - 1.0) / (1.0 - (2.0 * u - 1.0) * (2.0 * u - 1.0));
                (0..n).map(|_| odds(self.uniform())).collect()
            }
            "lazy" => {
                let mut x = self.normal();
                let step = |_| {
                    if self.uniform() < 0.15 {
                        x = self.normal();
                    }
                    x
                };
                (0..n).map(step).collect()
            }
            "coins" => (0..n)
                .map(|_| if self.uniform() < 0.3 { 1.0 } else { 0.0 })
                .collect(),
            "far" => self.series(n, 0.5, far(10_000.0)),
            "large" => self.series(n, 0.5, |_, x| 2f64.powi(100) * x),
            "small" => self.series(n, 0.5, |_, x| 2f64.powi(-40) * x),
            "stuck" => vec![chain as f64 * 0.5; n],
            "nearly stuck" => self.series(n, 0.5, |_, x| chain as f64 + 0.001 * x),
            "constant" => vec![2.5; n],
            _ => self.series(n, 0.5, far(0.0)),
        }
    }
}

/// The cases of `reference.csv`: name, draws, and what arviz says of them.
pub fn reference() -> Vec<(String, Vec<Vec<f32>>, Figures)> {
    let lines = include_str!("reference.csv").lines().skip(1).zip(1..);
    let case = |(line, seed): (&str, u64)| {
        let cells: Vec<&str> = line.split(',').collect();
        let [chains, n] = [cells[1], cells[2]].map(|cell| cell.parse::<usize>().unwrap());
        let mut words = Words(seed);
        let narrow = |run: Run| run.iter().map(|&x| x as f32).collect::<Vec<f32>>();
        let runs: Vec<_> = (0..chains)
            .map(|chain| narrow(words.run(cells[0], chain, n)))
            .collect();
        let sum: u64 = runs.iter().flatten().map(|x| u64::from(x.to_bits())).sum();
        assert_eq!(sum.to_string(), cells[3], "other draws of {}", cells[0]);
        let figures = std::array::from_fn(|i| cells[4 + i].parse().unwrap());
        (cells[0].to_owned(), runs, figures)
    };
    lines.map(case).collect()
}
