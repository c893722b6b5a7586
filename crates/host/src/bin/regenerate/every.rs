//! The tables of docs/every_sampler.md: every function by every core and by the clock, and the peers beside.

use crate::cycles::{Row, TIMINGS, all, whole};
use crate::sources::{Sources, TIERS};
use crate::tables::rows;
use microwarp_host::upkeep::Outcome;

/// The tiers of the warps, and what a table calls the rest.
const PREFIXES: [&str; 5] = ["poly_", "libm_", "fine_", "coarse_", "compact_"];
const OTHERS: &str = "others";

/// The head, with columns of nanoseconds behind.
fn head(clock: &[&str]) -> Vec<Vec<String>> {
    let mut head = vec![String::new()];
    for (timing, title) in TIMINGS {
        // The same instructions are executed whatever a multiplication takes.
        if !matches!(timing, "m0_slow" | "m0plus") {
            head.push(format!("{title}: instructions"));
            head.push("cycles".into());
        } else {
            head.push(format!("{title}: cycles"));
        }
    }
    head.extend(clock.iter().map(ToString::to_string));
    let line = (0..head.len()).map(|i| if i == 0 { "---" } else { "--:" }.into());
    let line = line.collect();
    vec![head, line]
}

/// The least, the mean and the most, or one figure where they are the same.
fn spread(figures: [f64; 3]) -> String {
    let [least, mean, most] = figures.map(whole);
    if least == most {
        most
    } else {
        format!("{least} / {mean} / {most}")
    }
}

/// What a function costs on all cores; blank where it has not been swept.
fn costs(cycles: &[Row], kernel: &str) -> Vec<String> {
    let mut cells = vec![format!("`{kernel}`")];
    for (timing, _) in TIMINGS {
        let is = |row: &&Row| row.kernel == kernel && row.timing == timing;
        let row = cycles.iter().find(is);
        let [instructions, taken] = row.map_or_else(Default::default, |row| {
            let [mean, fewest, most] = row.instructions;
            [
                spread([fewest, mean, most]),
                spread([row.least, row.mean[1], row.longest]),
            ]
        });
        if !matches!(timing, "m0_slow" | "m0plus") {
            cells.push(instructions);
        }
        cells.push(taken);
    }
    cells
}

/// Nanoseconds of a warp, drawn, filled and mapped, where they have been measured.
fn clock(sources: &Sources, kernel: &str) -> Vec<String> {
    let of = |action: &str| {
        let (tier, name) = kernel.split_once('_').unwrap_or_default();
        let measured = sources.nanoseconds("warps", &format!("{tier}::{action}::{name}"));
        measured.unwrap_or_default()
    };
    ["draw", "fill", "map"].map(of).into()
}

/// `PREFIX`: the functions of a tier, those of any parameters among them, in the order of cycles.csv; or `others`.
pub fn every(prefix: &str, sources: &Sources) -> Outcome<String> {
    let cycles = all()?;
    let is_warp = |kernel: &str| PREFIXES.iter().any(|prefix| kernel.starts_with(prefix));
    let clocked = matches!(prefix, "poly_" | "libm_");
    let mut table = head(if clocked {
        &["ns: `draw`", "`fill`", "`map`"]
    } else {
        &[]
    });
    for row in cycles.iter().filter(|row| row.timing == "m4f") {
        let kernel = row.kernel.as_str();
        let drawn = kernel.strip_suffix("_pcg32");
        let drawn = drawn.is_some_and(|alone| cycles.iter().any(|row| row.kernel == alone));
        let belongs = match prefix {
            OTHERS => !is_warp(kernel) && !kernel.starts_with("peer_"),
            _ => kernel.starts_with(prefix),
        };
        if belongs && !drawn && !kernel.ends_with("_any") {
            let mut cells = costs(&cycles, kernel);
            if clocked {
                cells.extend(clock(sources, kernel));
            }
            table.push(cells);
        }
    }
    let mut listed = TIERS
        .iter()
        .filter(|(_, tiers)| tiers.contains(&prefix) || (prefix == OTHERS && tiers.contains(&"")));
    if let Some((warps, tiers)) = listed.next() {
        let tier = if tiers.contains(&prefix) { prefix } else { "" };
        for name in warps.iter().flat_map(|warp| warp.varied()) {
            let kernel = format!("{tier}{name}_any");
            if cycles.iter().all(|row| row.kernel != kernel) {
                continue;
            }
            let mut cells = costs(&cycles, &kernel);
            if clocked {
                cells.extend([const { String::new() }; 3]);
            }
            table.push(cells);
        }
    }
    if table.len() == 2 {
        return Err(format!("cycles.csv has no {prefix}"));
    }
    Ok(rows(&table))
}

/// A distribution, our functions that draw it, the peers', and its row in the table of peers by the clock.
type Beside = (
    &'static str,
    &'static [&'static str],
    &'static [&'static str],
);

#[rustfmt::skip]
const BESIDE: [Beside; 9] = [
    ("disk", &["poly_disk", "libm_disk", "fine_disk", "rejection_disk", "fixed_rejection_disk"], &["rand_distr_unit_disc", "micromath_disk", "plain_libm_disk"]),
    ("circle", &[], &["rand_distr_unit_circle"]),
    ("sphere", &["poly_sphere", "libm_sphere", "fine_sphere"], &["rand_distr_unit_sphere", "micromath_sphere", "plain_libm_sphere"]),
    ("hemisphere", &["poly_hemisphere", "libm_hemisphere", "fine_hemisphere"], &["micromath_hemisphere", "plain_libm_hemisphere"]),
    ("cosine hemisphere", &["poly_cosine_hemisphere", "libm_cosine_hemisphere", "fine_cosine_hemisphere"], &["micromath_cosine_hemisphere", "plain_libm_cosine_hemisphere"]),
    ("lobe", &["poly_phong_lobe_50", "libm_phong_lobe_50", "fine_phong_lobe_50"], &["micromath_phong_lobe_50", "plain_libm_phong_lobe_50"]),
    ("exponential", &["poly_exponential_1", "libm_exponential_1", "fine_standard_exponential", "rejection_ziggurat_standard_exponential"], &["rand_distr_exp1", "micromath_exponential_1", "plain_libm_exponential_1"]),
    ("normal", &["poly_normal_pair", "libm_normal_pair", "fine_standard_normal_pair", "rejection_ziggurat_standard_normal"], &["rand_distr_standard_normal", "micromath_normal_pair", "plain_libm_normal_pair"]),
    ("ball", &["poly_ball", "libm_ball", "rejection_ball"], &["rand_distr_unit_ball"]),
];

/// The column of the table of peers that a function stands in.
fn column(kernel: &str) -> Option<&'static str> {
    let columns = [
        ("poly_", "`poly`, or the index"),
        ("libm_", "`libm`"),
        ("rejection_", "rejection"),
        ("peer_rand_distr_", "rand_distr"),
        ("peer_micromath_", "micromath"),
    ];
    let found = columns
        .iter()
        .find(|(prefix, _)| kernel.starts_with(prefix));
    found.map(|(_, column)| *column)
}

/// What draws the same, with the generator.
pub fn beside_peers(sources: &Sources) -> Outcome<String> {
    let cycles = all()?;
    let mut table = head(&["ns, drawn"]);
    for (family, ours, peers) in BESIDE {
        let ours = ours.iter().map(|kernel| format!("{kernel}_pcg32"));
        let peers = peers.iter().map(|kernel| format!("peer_{kernel}_pcg32"));
        for kernel in ours.chain(peers) {
            let mut cells = costs(&cycles, &kernel);
            let found = column(&kernel).and_then(|column| sources.peer(family, column).ok());
            cells.push(found.unwrap_or_default().into());
            table.push(cells);
        }
    }
    Ok(rows(&table))
}
