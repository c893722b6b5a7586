//! 10⁸ samples, in the quick speed 4·10⁶, whose mean is 1000 deviations: the figures stay right, one by one and merged, where plain
//! sums and Welford's recurrence in f32 do not.

use crate::{Exact, Largest, at_most, errors, relative};
use host::docs::Doc;
use host::speed;
use microwarp::estimate::{Moments, WeightedMean};
use microwarp::{Warp, poly as mw, uniform};
use rand_pcg::Pcg32;
use std::sync::LazyLock;

static SAMPLES: LazyLock<u64> =
    LazyLock::new(|| speed::of("samples of a long run", 4_000_000, 100_000_000));

/// Samples between two looks at the figures.
fn checkpoint() -> u64 {
    *SAMPLES / 100
}

/// What the project owes.
const OWED: f64 = 1e-5;

fn samples() -> impl Iterator<Item = f32> {
    let noise = mw::Normal::new(1000.0, 1.0).unwrap();
    let mut rng = Pcg32::new(0x10e8, 54);
    (0..*SAMPLES).map(move |_| noise.draw(&mut rng))
}

/// Likewise, but flat, and drawn in less time.
fn flat_samples() -> impl Iterator<Item = f32> {
    let half = 3f32.sqrt();
    let noise = mw::Interval::new(1000.0 - half, 1000.0 + half).unwrap();
    let mut rng = Pcg32::new(0x10eb, 54);
    (0..*SAMPLES).map(move |_| noise.draw(&mut rng))
}

const OF_MOMENTS: [&str; 2] = ["mean", "variance"];
const OF_RATIO: [&str; 2] = ["ratio", "standard error"];

#[test]
fn the_owed_accuracy_is_stated() {
    for (estimator, rows) in [("Moments", OF_MOMENTS), ("WeightedMean", OF_RATIO)] {
        let doc = Doc::of("estimate", estimator);
        for row in rows {
            for column in 0..3 {
                assert!(doc.figure(row, column) <= OWED, "{row}");
            }
        }
    }
}

#[test]
fn many_samples_one_by_one() {
    let mut moments = Moments::new();
    let (mut exact, mut largest) = (Exact::default(), Largest::default());
    // The controls: plain sums, sums about the first sample, and Welford's recurrence, all in f32.
    let (mut sum, mut squares) = (0.0_f32, 0.0_f32);
    let (mut first, mut shifted, mut shifted_squares) = (None, 0.0_f32, 0.0_f32);
    let (mut mean, mut corrected, mut n) = (0.0_f32, 0.0_f32, 0.0_f32);
    let checkpoint = checkpoint();
    for (i, x) in (1_u64..).zip(samples()) {
        moments.push(x);
        exact.push(x);
        sum += x;
        squares += x * x;
        let d = x - *first.get_or_insert(x);
        shifted += d;
        shifted_squares += d * d;
        // Kinder to the recurrence than a count in f32, which would stop at 2²⁴.
        n = if i < 1 << 24 { n + 1.0 } else { i as f32 };
        let delta = x - mean;
        mean += delta / n;
        corrected += delta * (x - mean);
        if i % checkpoint == 0 {
            largest.moments(&moments, &exact);
        }
    }
    largest.assert_stated("Moments", OF_MOMENTS, 0);
    let variance = |sum: f32, squares: f32| (squares - sum * sum / n) / (n - 1.0);
    let controls = [
        ("plain sums", sum / n, variance(sum, squares)),
        (
            "sums about the first",
            first.unwrap() + shifted / n,
            variance(shifted, shifted_squares),
        ),
        ("Welford in f32", mean, corrected / (n - 1.0)),
    ];
    for (what, mean, variance) in controls {
        let [mean, variance] = errors(Some(mean), Some(variance), &exact);
        println!("{what}: mean off by {mean:.2e}, variance by {variance:.2e}");
        let passes = mean <= OWED && variance <= OWED;
        assert!(!passes, "{what} passes");
    }
}

fn merged<'a>(parts: impl IntoIterator<Item = &'a Moments>) -> Moments {
    parts.into_iter().fold(Moments::new(), |mut all, part| {
        all.merge(part);
        all
    })
}

/// Parts of a run, merged as they come so that every merge is of equals: a tree.
#[derive(Default)]
struct Tree(Vec<(u32, Moments)>);

impl Tree {
    fn push(&mut self, part: Moments) {
        let mut node = (0, part);
        while self.0.last().is_some_and(|last| last.0 == node.0) {
            let (height, mut left) = self.0.pop().unwrap();
            left.merge(&node.1);
            node = (height + 1, left);
        }
        self.0.push(node);
    }

    fn root(&self) -> Moments {
        let mut root = Moments::new();
        for (_, node) in self.0.iter().rev() {
            root.merge(node);
        }
        root
    }
}

#[test]
fn many_samples_merged() {
    let (mut exact, mut largest) = (Exact::default(), Largest::default());
    // 16 parts: the first takes half the samples, the next a quarter and so on.
    let mut parts = [Moments::new(); 16];
    // Parts of 1 to 19 samples, in a tree and one after another.
    let (mut tree, mut chain, mut tiny) = (Tree::default(), Moments::new(), Moments::new());
    let mut size = 1;
    let checkpoint = checkpoint();
    for (i, x) in (1_u64..).zip(flat_samples()) {
        exact.push(x);
        parts[(*SAMPLES / i).ilog2().min(15) as usize].push(x);
        tiny.push(x);
        let check = i % checkpoint == 0;
        if tiny.count() == size || check {
            tree.push(tiny);
            chain.merge(&tiny);
            tiny = Moments::new();
            size = 1 + (size + 6) % 19;
        }
        if check {
            largest.moments(&merged(&parts), &exact);
            largest.moments(&merged(parts.iter().rev()), &exact);
            largest.moments(&tree.root(), &exact);
            largest.moments(&chain, &exact);
        }
    }
    largest.assert_stated("Moments", OF_MOMENTS, 1);
    let counts = parts.map(|part| part.count());
    assert!(
        counts[0] > 10_000 * counts[15] && counts[15] > 0,
        "{counts:?}"
    );
    // The control: the means of parts of unequal size averaged as equals, and the variances.
    let averaged = |of: fn(&Moments) -> Option<f32>| {
        let figures = parts.iter().map(|part| of(part).unwrap());
        Some(figures.sum::<f32>() / 16.0)
    };
    let [mean, variance] = errors(averaged(Moments::mean), averaged(Moments::variance), &exact);
    println!("averaged: mean off by {mean:.2e}, variance by {variance:.2e}");
    assert!(
        !(mean <= OWED && variance <= OWED),
        "parts averaged as equals pass"
    );
}

/// A sample from its index and a uniform.
type Order = fn(u32, f32) -> f32;

/// Orders in which the mean moves away from where it was: a far first sample, a ramp, and two levels.
#[test]
fn the_order_of_samples_does_not_matter() {
    let n = 10_000_000_u32;
    let orders: [(&str, Order); 3] = [
        ("far first", |i, u| if i == 0 { 0.0 } else { 1e4 + u }),
        ("ramp", |i, u| 1e-3 * i as f32 + u),
        ("two levels", |i, u| if i < 5_000_000 { u } else { 1e3 + u }),
    ];
    for (what, sample) in orders {
        let mut rng = Pcg32::new(0x10ea, 54);
        let (mut moments, mut sum, mut squares) = (Moments::new(), 0.0_f64, 0.0_f64);
        let (mut first, mut shifted, mut shifted_squares) = (None, 0.0_f32, 0.0_f32);
        // Of the orders' means, so that the truth does not cancel.
        let near = if what == "far first" { 1e4 } else { 0.0 };
        for i in 0..n {
            let x = sample(i, uniform::grid(&mut rng));
            moments.push(x);
            let d = f64::from(x) - near;
            sum += d;
            squares += d * d;
            let d = x - *first.get_or_insert(x);
            shifted += d;
            shifted_squares += d * d;
        }
        let total = f64::from(n);
        let exact = (squares - sum * sum / total) / (total - 1.0);
        let mean = relative(moments.mean(), near + sum / total);
        let variance = relative(moments.variance(), exact);
        println!("{what}: mean off by {mean:.2e}, variance by {variance:.2e}");
        assert!(mean <= OWED && variance <= OWED, "{what}");
        // The control: plain sums about the first sample.
        let n = n as f32;
        let control = (shifted_squares - shifted * shifted / n) / (n - 1.0);
        assert!(
            !at_most(relative(Some(control), exact), OWED),
            "{what}: plain sums pass"
        );
    }
}

#[test]
fn many_weighted_samples() {
    let mut rng = Pcg32::new(0x10e9, 54);
    let (mut ratio, mut parts) = (WeightedMean::new(), [WeightedMean::new(); 16]);
    let mut largest = [Largest::default(); 2];
    // Σw, Σwd, Σw², Σw²d, Σw²d², with d from 1000, in f64.
    let mut sums = [0.0_f64; 5];
    let (mut plain, mut plain_weights, mut exact) = (0.0_f32, 0.0_f32, 0.0);
    let checkpoint = checkpoint();
    for (i, x) in (1_u64..).zip(flat_samples()) {
        let weight = 0.5 + uniform::grid(&mut rng);
        ratio.push(x, weight);
        parts[(*SAMPLES / i).ilog2().min(15) as usize].push(x, weight);
        let (w, d) = (f64::from(weight), f64::from(x) - 1000.0);
        let terms = [w, w * d, w * w, w * w * d, w * w * d * d];
        sums.iter_mut()
            .zip(terms)
            .for_each(|(sum, term)| *sum += term);
        plain += weight * x;
        plain_weights += weight;
        if i % checkpoint == 0 {
            let [w, wd, ww, wwd, wwdd] = sums;
            let distance = wd / w;
            let squares = wwdd - 2.0 * distance * wwd + distance * distance * ww;
            let error = (i as f64 / (i - 1) as f64 * squares).sqrt() / w;
            exact = 1000.0 + distance;
            largest[0].ratio(&ratio, [exact, error]);
            let merged = parts.iter().fold(WeightedMean::new(), |mut all, part| {
                all.merge(part);
                all
            });
            assert_eq!((ratio.count(), merged.count()), (i, i));
            largest[1].ratio(&merged, [exact, error]);
        }
    }
    largest[0].assert_stated("WeightedMean", OF_RATIO, 0);
    largest[1].assert_stated("WeightedMean", OF_RATIO, 1);
    let control = relative(Some(plain / plain_weights), exact);
    println!("plain sums: ratio off by {control:.2e}");
    assert!(control > OWED, "plain sums pass");
}
