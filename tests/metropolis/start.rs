//! The start-up bias and its two cures, measured over many short runs of a slow chain.

use crate::targets::{FAMILY, p_value_of_mean};
use host::speed;
use microwarp::metropolis::{BoxStep, Chain, UniformStep};
use rand_pcg::Pcg32;
use std::sync::OnceLock;

/// (x − ½)² between ¼ and 1: two humps of 1/9 and 8/9 of the mass, and nothing below.
pub fn humps(x: f32) -> f32 {
    if (0.25..1.0).contains(&x) {
        (x - 0.5) * (x - 0.5)
    } else {
        0.0
    }
}

/// Its integral, (1/8 + 1/64)/3.
const INTEGRAL: f64 = 0.046_875;

/// What is asked of a state: whether it is on the greater hump, and its place.
fn asked(x: f32) -> [f64; 2] {
    [if x > 0.5 { 1.0 } else { 0.0 }, f64::from(x)]
}

/// The same under the target: ∫x(x − ½)² from ¼ to 1 is (½)⁴/4 − (¼)⁴/4 and half of the integral.
const TRUE: [f64; 2] = [8.0 / 9.0, 0.5 + (1.0 / 64.0 - 1.0 / 1024.0) / INTEGRAL];

fn how_many() -> usize {
    speed::of("runs", 8_000, 30_000)
}

/// Steps after which a run is looked at.
const LENGTHS: [u32; 10] = [0, 1, 2, 5, 10, 20, 50, 100, 200, 400];
const CANDIDATES: [u32; 4] = [1, 4, 16, 64];

/// Sums over runs: of a number, and of its square.
#[derive(Clone, Copy, Default)]
struct Sums(f64, f64);

impl Sums {
    fn add(&mut self, x: f64) {
        self.0 += x;
        self.1 += x * x;
    }

    fn mean(&self, count: usize) -> f64 {
        self.0 / count as f64
    }

    fn p_value(&self, count: usize, exact: f64) -> f64 {
        p_value_of_mean(self.0, self.1, count as f64, exact)
    }
}

/// Over many runs of one kind, by length.
struct Table {
    /// What is asked, with the weight of the run: 0 of a run without a start.
    weighted: Vec<[Sums; 2]>,
    /// The same without weights, over the runs that have a start.
    plain: Vec<[Sums; 2]>,
    weights: Sums,
    runs: usize,
    started: usize,
}

impl Table {
    fn p_values(&self, exact: [f64; 2], sums: &[[Sums; 2]], count: usize) -> Vec<f64> {
        let both = sums.iter().flat_map(|s| s.iter().zip(exact));
        both.map(|(sums, exact)| sums.p_value(count, exact))
            .collect()
    }

    /// Of W g(X) against ∫fg, at all lengths.
    fn weighted(&self) -> Vec<f64> {
        self.p_values(TRUE.map(|g| g * INTEGRAL), &self.weighted, self.runs)
    }

    /// Of g(X) against ∫fg/∫f.
    fn plain(&self) -> Vec<f64> {
        self.p_values(TRUE, &self.plain, self.started)
    }
}

/// Runs of chains that `start` finds, each with its weight.
fn runs(seed: u64, start: impl Fn(&mut Pcg32) -> Option<(Chain<f32>, f32)>) -> Table {
    let step = BoxStep::new(0.4).unwrap();
    let mut table = Table {
        weighted: vec![Default::default(); LENGTHS.len()],
        plain: vec![Default::default(); LENGTHS.len()],
        weights: Sums::default(),
        runs: how_many(),
        started: 0,
    };
    for run in 0..table.runs {
        let mut rng = Pcg32::new(seed, run as u64);
        let Some((mut chain, weight)) = start(&mut rng) else {
            continue;
        };
        table.started += 1;
        table.weights.add(weight.into());
        for (row, length) in LENGTHS.into_iter().enumerate() {
            while chain.steps() < u64::from(length) {
                chain.step(humps, &step, &mut rng);
            }
            for (i, g) in asked(chain.state()).into_iter().enumerate() {
                table.plain[row][i].add(g);
                table.weighted[row][i].add(f64::from(weight) * g);
            }
        }
    }
    table
}

/// On the lesser hump.
fn badly_started(burn_in: u32) -> Table {
    let step = BoxStep::new(0.4).unwrap();
    runs(300 + u64::from(burn_in), |rng| {
        let mut chain = Chain::new(0.3, humps).unwrap();
        chain.burn_in(humps, &step, burn_in, rng);
        Some((chain, 1.0))
    })
}

/// By the counts of candidates.
fn resampled() -> &'static [Table; 4] {
    static TABLES: OnceLock<[Table; 4]> = OnceLock::new();
    TABLES.get_or_init(|| {
        CANDIDATES.map(|count| {
            runs(700 + u64::from(count), |rng| {
                let start = Chain::resample(humps, &UniformStep::new(), count, rng).ok()?;
                Some((start.chain, start.weight))
            })
        })
    })
}

#[test]
fn burning_in_long_enough_leaves_no_bias_and_less_leaves_some() {
    let at = |table: &Table, row: usize| table.plain()[2 * row..2 * row + 2].to_vec();
    let [bad, short, longer, long] = [0, 10, 100, 2000].map(badly_started);
    let runs = bad.runs;
    // The bias is still there after 100 steps. (Before the first all states are the same: no spread to judge by.)
    for row in 1..8 {
        FAMILY.assert_rejected("a bad start", &at(&bad, row));
        FAMILY.assert_rejected("10 steps of burn-in", &at(&short, row));
    }
    FAMILY.assert_rejected("100 steps of burn-in", &at(&longer, 0));
    FAMILY.assert_passes("2000 steps of burn-in", &long.plain());
    // Steps of the burn-in and steps after are the same steps.
    let [k100, after_burn_in] =
        [(&bad, 7), (&longer, 0)].map(|(t, row)| t.plain[row][0].mean(runs));
    let spread = (0.25 / runs as f64).sqrt() * 2_f64.sqrt();
    FAMILY.assert_passes(
        "100 steps",
        &[host::stats::two_sided((k100 - after_burn_in) / spread)],
    );
}

#[test]
fn a_weighted_start_is_unbiased_after_any_number_of_steps() {
    for (count, table) in CANDIDATES.into_iter().zip(resampled()) {
        FAMILY.assert_passes(&format!("{count} candidates"), &table.weighted());
        let mean = table.weights.mean(table.runs);
        println!("mean weight {mean:.6}, exact {INTEGRAL:.6}");
        FAMILY.assert_passes(
            "mean weight",
            &[table.weights.p_value(table.runs, INTEGRAL)],
        );
    }
}

/// The controls: without weights a start by few candidates is biased.
#[test]
fn a_start_without_its_weight_is_biased() {
    for table in &resampled()[..2] {
        FAMILY.assert_rejected("without the weight", &table.plain()[..2]);
    }
    // One candidate is not even better than a source that knows nothing.
    let [one, four, ..] = resampled();
    let bias = |t: &Table| (t.plain[0][0].mean(t.started) - TRUE[0]).abs();
    assert!(bias(four) < bias(one));
}

/// A run without a start counts as 0, or a quarter of a single candidate's weight comes on top.
#[test]
fn runs_without_a_start_count_as_zero() {
    let [one, ..] = resampled();
    let (runs, none) = (one.runs, one.runs - one.started);
    let spread = (0.25 * 0.75 * runs as f64).sqrt();
    println!("{none} of {runs} without a start");
    assert!((none as f64 - 0.25 * runs as f64).abs() <= 6.0 * spread);
    FAMILY.assert_rejected("left out", &[one.weights.p_value(one.started, INTEGRAL)]);
    let left_out = one.p_values(TRUE.map(|g| g * INTEGRAL), &one.weighted, one.started);
    FAMILY.assert_rejected("left out", &left_out);
}
