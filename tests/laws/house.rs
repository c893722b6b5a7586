//! The house itself: the order of its rooms, and that no warp is missing from the catalogue.

use crate::catalogue::entries;
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

fn sources(under: &str) -> Vec<(PathBuf, String)> {
    let mut found = Vec::new();
    let mut open = vec![Path::new(env!("CARGO_MANIFEST_DIR")).join(under)];
    while let Some(path) = open.pop() {
        if path.is_dir() {
            open.extend(fs::read_dir(path).unwrap().map(|e| e.unwrap().path()));
        } else if path.extension().is_some_and(|e| e == "rs") {
            let text = fs::read_to_string(&path).unwrap();
            found.push((path, text));
        }
    }
    assert!(!found.is_empty());
    found
}

/// The rooms in their order; each knows only those before it.
const ROOMS: [&str; 10] = [
    "error",
    "num",
    "uniform",
    "tier",
    "warp",
    "discrete",
    "rejection",
    "estimate",
    "metropolis",
    "fixed",
];

fn room_of(path: &Path) -> Option<usize> {
    let inside = path.to_str().unwrap().rsplit_once("/src/").unwrap().1;
    let first = inside.split(['/', '.']).next().unwrap();
    ROOMS.iter().position(|room| *room == first)
}

/// The rooms that a source file uses.
fn uses(text: &str) -> Vec<usize> {
    let code = text.lines().filter(|l| !l.trim_start().starts_with("//"));
    let mentions = code.flat_map(|l| {
        l.match_indices("crate::")
            .map(move |(i, m)| &l[i + m.len()..])
    });
    mentions
        .filter_map(|rest| {
            let name = rest.split(|c: char| !c.is_alphanumeric()).next().unwrap();
            ROOMS.iter().position(|room| *room == name)
        })
        .collect()
}

#[test]
fn each_room_knows_only_the_rooms_before_it() {
    let mut seen = 0;
    for (path, text) in sources("src") {
        let Some(room) = room_of(&path) else { continue };
        for used in uses(&text) {
            seen += 1;
            assert!(used <= room, "{} uses {}", path.display(), ROOMS[used]);
        }
    }
    assert!(seen > 20, "the rooms' uses are not seen: {seen}");
    // The check itself sees a use of a later room, and none in a comment.
    assert_eq!(uses("use crate::warp::Disk;"), [4]);
    assert!(uses("/// [`crate::warp`]").is_empty());
}

#[test]
fn the_only_unsafe_is_the_square_root() {
    for (path, text) in sources("src") {
        let code = text.lines().filter(|l| !l.trim_start().starts_with("//"));
        let unsafes = code
            .filter(|l| {
                l.contains("unsafe {")
                    || l.contains("unsafe extern")
                    || l.contains("allow(unsafe_code)")
            })
            .count();
        assert_eq!(
            unsafes > 0,
            path.ends_with("tier/sqrt.rs"),
            "{}",
            path.display()
        );
    }
}

#[test]
fn no_warp_is_missing_from_the_catalogue() {
    let listed: BTreeSet<_> = entries()
        .iter()
        .map(|e| e.name.split(' ').next().unwrap())
        .collect();
    let mut implemented = BTreeSet::new();
    let rooms = ["src/warp", "src/discrete"].map(sources);
    for (_, text) in rooms.into_iter().flatten() {
        for line in text
            .lines()
            .filter(|l| l.starts_with("impl") && l.contains("Warp for "))
        {
            let name = line.split("Warp for ").nth(1).unwrap();
            implemented.insert(name.split(['<', ' ']).next().unwrap().to_string());
        }
    }
    assert!(implemented.len() > 20);
    let missing: Vec<_> = implemented
        .iter()
        .filter(|n| !listed.contains(n.as_str()))
        .collect();
    assert!(missing.is_empty(), "{missing:?}");
}

#[test]
fn both_tiers_carry_the_same_names() {
    let of = |tier: &str| -> Vec<String> {
        let all = entries();
        all.iter()
            .filter(|e| e.tier == tier)
            .map(|e| format!("{} {}", e.name, e.parameters))
            .collect()
    };
    assert_eq!(of("libm"), of("poly"));
}
