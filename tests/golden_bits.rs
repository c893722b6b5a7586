//! The same inputs give the same bits: the golden table holds on this machine.
//!
//! The table is `tests/golden/golden.csv`; the very code that is compared here also runs as WASM and as
//! firmware. `cargo regenerate` adds the lines of new cases; it changes others only where they are named.
//!
//! The last tests hold the lists of `tests/golden` against `src`: nothing public is without a golden subject, and no
//! warp without a cost kernel.

use microwarp_list::{FLOAT_WARPS, GRADED_WARPS, Listed, PLAIN_WARPS, cases, describe, evaluate};
use std::collections::BTreeSet;
use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};

fn path() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("tests/golden/golden.csv")
}

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
    let golden = std::fs::read_to_string(path()).expect("the golden table is checked in");
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

/// What has no tier stands among the rows of `poly` alone; what has one stands in both.
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
        // What is made of others has their tier.
        let tiered = entries
            .iter()
            .filter(of_warp)
            .any(|entry| entry.tiered || entry.composed);
        let in_libm = warp.golden.iter().any(|name| libm.contains(name));
        assert!(tiered || !in_libm, "{}", warp.name);
        seen[usize::from(in_libm)] += 1;
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

/// The code of all Rust files under a path of the repository, without comments.
fn code(under: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(under);
    if path.is_dir() {
        let mut inside: Vec<_> = fs::read_dir(&path)
            .unwrap()
            .map(|entry| entry.unwrap().file_name().into_string().unwrap())
            .collect();
        inside.sort();
        let files = inside.iter().map(|name| code(&format!("{under}/{name}")));
        return files.collect();
    }
    let text = fs::read_to_string(&path).unwrap();
    let code = text.lines().map(|line| line.split("//").next().unwrap());
    code.fold(String::new(), |all, line| all + line + "\n")
}

fn identifiers(text: &str) -> BTreeSet<&str> {
    text.split(|c: char| !c.is_alphanumeric() && c != '_')
        .filter(|word| word.starts_with(|c: char| c.is_alphabetic()))
        .collect()
}

/// The identifier that a text begins with.
fn first(text: &str) -> &str {
    let end = text.find(|c: char| !c.is_alphanumeric() && c != '_');
    &text[..end.unwrap_or(text.len())]
}

/// The types that are warps; a reference to one is none of them.
fn warps(code: &str) -> BTreeSet<&str> {
    let found = code.split(" Warp for ").skip(1).map(first);
    found.filter(|name| !name.is_empty()).collect()
}

/// The names that a room of the crate makes public, but for those of traits, other names and constants.
fn public<'a>(room: &'a str, code: &str) -> BTreeSet<&'a str> {
    let uses = room.split("pub use ").skip(1);
    let lists = uses.filter_map(|rest| rest.split(';').next());
    let names = lists.flat_map(|list| {
        let names = list.rsplit("::").next().unwrap();
        identifiers(names.trim_matches(['{', '}']))
    });
    let declared = |kind: &str, name: &str| {
        code.split(&format!("pub {kind} {name}"))
            .skip(1)
            .any(|rest| first(rest).is_empty())
    };
    let other = |name: &str| {
        ["trait", "type", "const"]
            .iter()
            .any(|kind| declared(kind, name))
    };
    // Some names of types are also those of aliases in a tier.
    names
        .filter(|name| declared("struct", name) || !other(name))
        .collect()
}

/// The names that are not among others.
fn missing<'a>(names: &BTreeSet<&'a str>, present: &BTreeSet<&str>) -> Vec<&'a str> {
    let absent = names.iter().filter(|name| !present.contains(*name));
    absent.copied().collect()
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
const SPARED: [(&str, &str); 10] = [
    ("Chance", "the acceptance in a step of integer weights"),
    ("Cursor", "a point as `Points::at` returns it"),
    ("Error06", "the error of `TryRng06`"),
    ("FromFn", "words as a closure returns them"),
    ("RandomWalk", "how `BoxStep` and the other steps propose"),
    ("Rng06", "words of another generator as they are"),
    ("Rng09", "words of another generator as they are"),
    ("Start", "what `Chain::resample` returns"),
    ("Transition", "what `Chain::step` returns"),
    ("TryRng06", "words of another generator as they are"),
];

/// Tables, selections, rejection samplers, mutations, chains, estimates, strata and tiers are in a golden subject.
#[test]
fn nothing_public_is_without_golden_bits() {
    let all = code("src");
    let golden = code("crates/list/src");
    let rooms = ["discrete", "rejection", "metropolis", "estimate", "uniform"];
    let floats = rooms.map(|room| code(&format!("src/{room}.rs"))).concat();
    let names = public(&floats, &all);
    assert!(names.len() > 40, "{} names are seen", names.len());
    let spared: BTreeSet<_> = SPARED.iter().map(|(name, _)| *name).collect();
    assert_eq!(
        missing(&names, &identifiers(&golden)),
        spared.into_iter().collect::<Vec<_>>()
    );
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
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(".ci/sizes.csv");
    let sizes = fs::read_to_string(path).unwrap();
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
    let source = "impl<T: Tier> Warp for Disk<T> {}\nimpl Warp for Ring {}\nimpl<W> Warp for &W {}";
    assert_eq!(Vec::from_iter(warps(source)), ["Disk", "Ring"]);
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
    let golden = with_golden(&[&list]);
    assert_eq!(missing(&warps(source), &golden), ["Ring"]);
    let sizes = "poly_disk,m0,1,1\npoly_disk_pcg32,m0,1,1\npoly_oval,m0,1,1\n";
    let forgotten = without_kernel(&list, &["poly_"], sizes);
    assert_eq!(forgotten, ["Ring", "Oval", "Silent"]);
    let other = without_kernel(&list, &["poly_", "libm_"], sizes);
    assert_eq!(other, ["Disk", "Ring", "Oval", "Silent"]);

    let room =
        "pub use self::walk::{Walk, Mutation,\n stay};\npub use self::step::Step;\nuse a::B;";
    let code = "pub trait Mutation<X> {}\npub trait Steps {}\npub struct Step;";
    let names = public(room, code);
    assert_eq!(Vec::from_iter(names.clone()), ["Step", "Walk", "stay"]);
    let golden = identifiers("Walk::new(), Stepped, stays()");
    assert_eq!(missing(&names, &golden), ["Step", "stay"]);
}
