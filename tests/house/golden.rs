//! The same inputs give the same bits: the golden table holds on this machine.
//!
//! The table is `tests/golden/golden.csv`; the very code that is compared here also runs as WASM and as
//! firmware. `cargo regenerate` adds the lines of new cases; it changes others only where they are named.
//!
//! The last tests hold the lists of `crates/list` against `src`: nothing public is without a golden subject, and no
//! warp without a cost kernel.

use crate::{code, identifiers, missing, of_rooms, public, read, warps};
use microwarp_list::{FLOAT_WARPS, GRADED_WARPS, Listed, PLAIN_WARPS, cases, describe, evaluate};
use std::collections::BTreeSet;
use std::fmt::Write as _;

/// One row a case: its name, then the words it yields.
fn table() -> String {
    let mut text = String::from(
        "# The bits that every target yields; compared, never edited. Columns: case, then words in hex.\n",
    );
    for index in 0..cases() {
        let mut words = [0; 16];
        let len = evaluate(index, &mut words);
        let (name, input, tier) = describe(index);
        assert!(len > 0 && len < 16, "{name} yields {len} words");
        assert!(!name.contains(','), "{name} is two columns");
        let _ = write!(text, "{tier} {name} #{input}");
        for word in &words[..len] {
            let _ = write!(text, ",{word:08x}");
        }
        text.push('\n');
    }
    text
}

/// The first row in which two tables differ, counting a missing one as different.
fn first_difference(golden: &str, now: &str) -> Option<usize> {
    let (mut golden, mut now) = (golden.lines(), now.lines());
    for row in 0.. {
        match (golden.next(), now.next()) {
            (None, None) => return None,
            (a, b) if a == b => {}
            _ => return Some(row),
        }
    }
    None
}

#[test]
fn same_inputs_give_the_golden_bits() {
    let now = table();
    let golden = read("tests/golden/golden.csv");
    assert_eq!(golden.lines().count(), cases() + 1);
    if let Some(row) = first_difference(&golden, &now) {
        let row_of = |text: &str| text.lines().nth(row).unwrap_or("nothing").to_string();
        panic!(
            "row {row}\ngolden {}\nnow    {}",
            row_of(&golden),
            row_of(&now)
        );
    }
}

/// What has no tier stands among the rows of `poly` alone.
#[test]
fn what_has_no_tier_has_its_rows_once() {
    let rows = |tier: &'static str| -> BTreeSet<&str> {
        let all = (0..cases()).map(describe);
        all.filter(|(.., of)| *of == tier)
            .map(|(name, ..)| name)
            .collect()
    };
    let (poly, libm) = (rows("poly"), rows("libm"));
    assert!(libm.is_subset(&poly));
    let entries = host::registry::entries();
    let mut seen = [0, 0];
    for warp in FLOAT_WARPS {
        let of_warp =
            |entry: &&host::registry::Entry| entry.name.split(' ').next() == Some(warp.name);
        let of_warp: Vec<_> = entries.iter().filter(of_warp).collect();
        // What is made of others has their tier.
        if of_warp.iter().any(|entry| entry.composed) {
            continue;
        }
        // A wrapper of the registry may have a tier where the type has none, so that one direction alone is asked.
        let tiered = of_warp.iter().any(|entry| entry.tiered);
        for name in warp.golden {
            assert!(tiered || !libm.contains(name), "{name}");
            seen[usize::from(libm.contains(name))] += 1;
        }
    }
    assert!(seen.iter().all(|count| *count > 10), "{seen:?}");
}

/// A single flipped bit, a missing row and an empty table do not pass.
#[test]
fn a_changed_table_is_noticed() {
    let now = table();
    let at = now.rfind(|c: char| c.is_ascii_hexdigit()).unwrap();
    let digit = now[at..].chars().next().unwrap().to_digit(16).unwrap();
    let flipped = format!("{}{:x}\n", &now[..at], digit ^ 1);
    assert_eq!(first_difference(&flipped, &now), Some(cases()));
    let short = now[..at].rsplit_once('\n').unwrap().0;
    assert_eq!(first_difference(short, &now), Some(cases()));
    assert_eq!(first_difference("", &now), Some(0));
    assert_eq!(first_difference(&now, &now), None);
}

/// Evaluating twice, in any order, gives the same bits: no state survives a call.
#[test]
fn evaluation_has_no_memory() {
    let forwards: Vec<_> = (0..cases()).map(words).collect();
    let backwards: Vec<_> = (0..cases()).rev().map(words).collect();
    assert!(forwards.iter().eq(backwards.iter().rev()));
}

fn words(index: usize) -> [u32; 16] {
    let mut words = [0; 16];
    evaluate(index, &mut words);
    words
}

/// The types of a list that have golden subjects.
fn with_golden<'a>(lists: &[&'a [Listed]]) -> BTreeSet<&'a str> {
    let listed = lists.iter().copied().flatten();
    let golden = listed.filter(|warp| !warp.golden.is_empty());
    golden.map(|warp| warp.name).collect()
}

/// The warps of a list without a kernel that is in the table of sizes in every tier, but for those that say why.
fn without_kernel<'a>(list: &'a [Listed], tiers: &[&str], sizes: &str) -> Vec<&'a str> {
    let measured: BTreeSet<_> = sizes.lines().filter_map(|l| l.split(',').next()).collect();
    let is_measured = |kernel: &&str| {
        let name = |tier, drawn| format!("{tier}{kernel}{drawn}");
        tiers.iter().all(|tier| {
            ["", "_pcg32"]
                .iter()
                .all(|drawn| measured.contains(&*name(tier, drawn)))
        })
    };
    list.iter()
        .filter(|warp| match warp.kernels {
            [] => warp.no_kernel.is_none_or(str::is_empty),
            kernels => warp.no_kernel.is_some() || !kernels.iter().all(is_measured),
        })
        .map(|warp| warp.name)
        .collect()
}

/// Every warp has golden subjects in all its tiers: the subjects of a list are evaluated in each tier of it.
#[test]
fn no_warp_is_without_golden_bits() {
    let floats: String = ["src/warp", "src/discrete"].map(code).concat();
    let integers = code("src/fixed");
    let [floats, integers] = [&floats, &integers].map(|code| warps(code));
    assert!(floats.len() > 25 && integers.len() > 15, "none are seen");
    let integer_lists = with_golden(&[GRADED_WARPS, PLAIN_WARPS]);
    assert!(missing(&floats, &with_golden(&[FLOAT_WARPS])).is_empty());
    assert!(missing(&integers, &integer_lists).is_empty());
    // Whatever is listed is a warp, and no tier is left out.
    assert!(missing(&with_golden(&[FLOAT_WARPS]), &floats).is_empty());
    assert!(missing(&integer_lists, &integers).is_empty());
    let tiers: BTreeSet<_> = (0..cases()).map(|index| describe(index).2).collect();
    assert_eq!(tiers.len(), 6, "{tiers:?}");
}

/// Public and in no golden subject by name, with the reason.
const SPARED: [(&str, &str); 11] = [
    ("Cursor", "a point as `Points::at` returns it"),
    ("Error06", "the error of `TryRng06`"),
    ("FromFn", "words as a closure returns them"),
    ("RandomWalk", "how `BoxStep` and the other steps propose"),
    ("Rng06", "words of another generator as they are"),
    ("Rng09", "words of another generator as they are"),
    (
        "ScreenPixel",
        "the points of a pixel as `Screen::pixel` returns them",
    ),
    ("Start", "what `Chain::resample` returns"),
    ("Transition", "what `Chain::step` returns"),
    ("TryRng06", "words of another generator as they are"),
    ("try_up_to", "`up_to` of a generator that can fail"),
];

/// Tables, selections, rejection samplers, mutations, chains, estimates, strata and tiers are in a golden subject.
#[test]
fn nothing_public_is_without_golden_bits() {
    let all = code("src");
    let spared: Vec<_> = SPARED.iter().map(|(name, _)| *name).collect();
    let golden = code("crates/list/src");
    assert_eq!(missing(&of_rooms(&all), &identifiers(&golden)), spared);
    let integer_files = ["fixed", "fixed_warps", "integers"];
    let golden = integer_files.map(|file| code(&format!("crates/list/src/{file}.rs")));
    let (fixed, inside) = (code("src/fixed.rs"), code("src/fixed"));
    let mut names = public(&fixed, &all);
    names.extend(warps(&inside));
    assert!(names.len() > 15, "{} names are seen", names.len());
    assert!(missing(&names, &identifiers(&golden.concat())).is_empty());
}

#[test]
fn no_warp_is_without_a_cost_kernel() {
    let sizes = read(host::counts::FILE);
    let lists: [(&[Listed], &[&str]); 3] = [
        (FLOAT_WARPS, &["poly_", "libm_"]),
        (GRADED_WARPS, &["fine_", "coarse_", "compact_"]),
        (PLAIN_WARPS, &[""]),
    ];
    for (list, tiers) in lists {
        assert!(without_kernel(list, tiers, &sizes).is_empty());
    }
}

/// The checks of completeness see what is forgotten.
#[test]
fn what_is_forgotten_is_noticed() {
    let listed = |name, golden, kernels, no_kernel| Listed {
        name,
        golden,
        kernels,
        no_kernel,
        bound: &[],
    };
    let list = [
        listed("Disk", &["Disk"], &["disk"], None),
        listed("Ring", &[], &[], None),
        listed("Oval", &["Oval"], &["oval"], None),
        listed("Turned", &["Turned"], &[], Some("it costs what it turns")),
        listed("Silent", &["Silent"], &[], Some("")),
    ];
    let names = BTreeSet::from(["Disk", "Ring"]);
    assert_eq!(missing(&names, &with_golden(&[&list])), ["Ring"]);
    let sizes = "poly_disk,m0,1,1\npoly_disk_pcg32,m0,1,1\npoly_oval,m0,1,1\n";
    let forgotten = without_kernel(&list, &["poly_"], sizes);
    assert_eq!(forgotten, ["Ring", "Oval", "Silent"]);
    let other = without_kernel(&list, &["poly_", "libm_"], sizes);
    assert_eq!(other, ["Disk", "Ring", "Oval", "Silent"]);
}
