//! Samples follow the density they report: every warp of the registry in both tiers, by chi-square, Kolmogorov and
//! Smirnov's distance and moments. In the full speed the first parameters of a warp get two million samples, further ones
//! a quarter of that.
//!
//! Here lives the run over the whole registry. How one entry is examined is in `examination`; that the
//! examination rejects what is wrong is in `controls`, that it does not reject what is right in
//! `calibration`. Jittered strata are in `strata`.

mod calibration;
mod controls;
mod examination;
mod moments;
mod report;
mod strata;

use examination::Examination;
use host::parallel::{in_parallel, threads};
use host::registry::{Domain, Entry};
use host::{speed, stats};
use report::Report;
use std::collections::{BTreeMap, BTreeSet};
use std::sync::LazyLock;
use std::time::Instant;

/// Samples for the first parameters of each warp, unless `f32` resolves them too coarsely for so many.
static SAMPLES: LazyLock<usize> =
    LazyLock::new(|| speed::of("samples of each warp", 90_000, 2_000_000));
/// Samples for its further parameters.
static FURTHER: LazyLock<usize> =
    LazyLock::new(|| speed::or_all("samples of further parameters", 15_000, 200_000, 10_000_000));

/// The seed of an entry's run: fixed, and another one for every entry.
fn seed(index: usize) -> u64 {
    0x6d69_6372_6f77_6172 ^ (index as u64).wrapping_mul(0x9e37_79b9_7f4a_7c15)
}

/// The entries that are examined: all of them, or in the quick speed the first parameters of each warp in both tiers and
/// further ones in `poly`.
fn due() -> Vec<Entry> {
    let all = host::registry::entries();
    let mut seen = BTreeSet::new();
    let first: Vec<_> = all
        .iter()
        .map(|e| seen.insert((e.name, e.tier)) || e.tier != "libm")
        .collect();
    let mut entries: Vec<_> = all.into_iter().zip(first).collect();
    entries.retain(|(e, first)| (*first || speed::full()) && speed::wants(e.name));
    entries.into_iter().map(|(e, _)| e).collect()
}

/// Examines all entries; the rows are in their order.
fn examine(entries: &[Entry]) -> Vec<(usize, f64, Report)> {
    let seeded: Vec<_> = entries.iter().enumerate().collect();
    in_parallel(threads(), &seeded, |(i, entry)| {
        let has_all =
            |e: &Entry| e.domain != Domain::Line || stats::resolve(e, *SAMPLES).1 == *SAMPLES;
        let mut before = entries[..*i]
            .iter()
            .filter(|e| (e.name, e.tier) == (entry.name, entry.tier));
        let further = before.any(has_all);
        let examination = Examination::new(entry, if further { *FURTHER } else { *SAMPLES });
        let report = examination.run(seed(*i));
        (examination.samples, examination.integral, report)
    })
}

#[test]
fn samples_follow_the_density_they_report() {
    let start = Instant::now();
    let (entries, unresolved): (Vec<_>, Vec<_>) = due().into_iter().partition(|e| e.resolved);
    let due = entries.iter().map(|e| moments::tests(e.domain)).sum();
    let threshold = stats::threshold(due);
    let rows = examine(&entries);

    println!(
        "{:<50} {:>9} {:>9} {:>5} {:>8} {:>8} {:>8}  integral - 1",
        "warp", "samples", "chi2", "dof", "p", "KS p", "moment p"
    );
    let (mut objections, mut made) = (Vec::new(), 0);
    let mut most = BTreeMap::new();
    for (entry, (samples, integral, report)) in entries.iter().zip(&rows) {
        println!(
            "{:<50} {samples:>9} {:>9.1} {:>5} {:>8.1e} {:>8.1e} {:>8.1e}  {:+.1e}",
            entry,
            report.chi2,
            report.dof,
            report.lowest("chi"),
            report.lowest("distance"),
            report.lowest("mean"),
            integral - 1.0
        );
        made += report.tests.len();
        let most = most.entry((entry.name, entry.tier)).or_insert(0);
        *most = samples.max(most).to_owned();
        objections.extend(
            report
                .objections(threshold)
                .iter()
                .map(|o| format!("{entry}: {o}")),
        );
    }
    println!(
        "{} entries examined, {} left out because f32 does not resolve their shape, {made} tests, threshold {threshold:.1e}, {:.0} s",
        rows.len(),
        unresolved.len(),
        start.elapsed().as_secs_f64()
    );
    // Nothing may have been skipped in silence.
    assert_eq!(rows.len(), entries.len());
    assert_eq!(made, due);
    for entry in &unresolved {
        assert!(
            most.contains_key(&(entry.name, entry.tier)),
            "{} has no resolved parameters",
            entry.name
        );
    }
    for ((name, tier), samples) in most {
        assert!(
            samples >= *SAMPLES,
            "{name} {tier}: at most {samples} samples"
        );
    }
    assert!(objections.is_empty(), "{}", objections.join("\n"));
}
