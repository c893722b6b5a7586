//! The house itself: the order of its rooms, and that no warp is missing from the catalogue.

mod files;
mod names;

use self::files::House;
use self::names::{count_over, missing};
use host::registry::entries;
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
            // Integers need no tables, and tables no fixed-point numbers.
            let rooms = (ROOMS[room], ROOMS[used]);
            assert_ne!(rooms, ("fixed", "discrete"), "{}", path.display());
        }
    }
    assert!(seen > 20, "the rooms' uses are not seen: {seen}");
    // The check itself sees a use of a later room, and none in a comment.
    assert_eq!(uses("use crate::warp::Disk;"), [4]);
    assert!(uses("/// [`crate::warp`]").is_empty());
}

/// The texts of the crate's files, by their paths below `src`.
fn house() -> Vec<(String, String)> {
    let inside = |path: &Path| {
        let (_, inside) = path.to_str().unwrap().rsplit_once("/src/").unwrap();
        inside.to_owned()
    };
    let all = sources("src").into_iter();
    all.map(|(path, text)| (inside(&path), text)).collect()
}

/// The same with one text changed.
fn changed(file: &str, change: impl Fn(&str) -> String) -> Vec<(String, String)> {
    let mut texts = house();
    let (_, text) = texts.iter_mut().find(|(path, _)| path == file).unwrap();
    let after = change(text);
    assert_ne!(*text, after, "{file} stays as it is");
    *text = after;
    texts
}

#[test]
fn no_file_stands_on_itself_by_way_of_others() {
    let texts = house();
    let house = House::new(&texts);
    assert!(house.edges().len() > texts.len(), "the paths are not seen");
    assert_eq!(house.circles(), [[""; 0]; 0]);
}

#[test]
fn a_circle_of_files_is_noticed() {
    let house = |files: &[(&str, &str)]| {
        let owned = files
            .iter()
            .map(|(path, text)| ((*path).to_owned(), (*text).to_owned()));
        House::new(&owned.collect::<Vec<_>>()).circles()
    };
    let root = ("lib.rs", "mod room; pub use room::Name;");
    let room = (
        "room.rs",
        "mod a;\nmod b;\npub use self::a::Name;\nuse self::b::{other as o};\nfn f() { o() }",
    );
    let one = (
        "room/a.rs",
        "/// `super::b`\nuse core::{fmt, ops::Range};\npub struct Name; // super::b::other",
    );
    let other = (
        "room/b.rs",
        "mod sealed { use super::other; }\npub fn other(_: crate::Name) {}",
    );
    assert!(house(&[root, room, one, other]).is_empty());
    // By an import, by a path in the code, by a name of the parent that the parent has from another file.
    for text in [
        "use super::{b::other};",
        "fn f() { super::b::other() }",
        "use super::o;",
    ] {
        assert_eq!(
            house(&[root, room, ("room/a.rs", text), other]),
            [["room/a", "room/b"]],
            "{text}"
        );
    }
    // In the house itself: a room uses a later one, which stands on it.
    let texts = changed("num/word.rs", |text| {
        format!("{text}use crate::warp::Normal;\n")
    });
    assert_eq!(House::new(&texts).circles().len(), 1);
    // By what the parent defines itself, and what it hands on and uses.
    let below = ("room/b.rs", "use super::f;");
    assert_eq!(house(&[root, room, one, below]), [["room", "room/b"]]);
    let uses = (
        "room.rs",
        "mod a;\npub use self::a::Name;\nfn f(_: Name) {}",
    );
    assert_eq!(
        house(&[root, uses, ("room/a.rs", "use super::f;")]),
        [["room", "room/a"]]
    );
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
            .filter(|l| l.starts_with("impl") && l.contains("Warp for ") && !l.contains("for &"))
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
fn every_tier_and_grade_has_every_name() {
    let texts = house();
    let counts = ["Tier", "Grade"].map(|bound| count_over(&texts, bound));
    assert!(counts.iter().all(|count| *count > 12), "{counts:?}");
    assert_eq!(missing(&texts), Vec::<String>::new());
}

#[test]
fn a_missing_name_is_noticed() {
    // Each line of a list, taken out.
    let taken_out = |file: &str, line: &str, what: &str| {
        let without = |text: &str| {
            let kept = text.lines().filter(|l| !l.contains(line));
            kept.fold(String::new(), |all, l| all + l + "\n")
        };
        assert_eq!(
            missing(&changed(file, without)),
            what.split_terminator(", ").collect::<Vec<_>>()
        );
    };
    taken_out(
        "warp.rs",
        "disk::Disk<T>",
        "Disk in the list of warps, Disk in the tiers",
    );
    taken_out("warp.rs", "tent::Tent", "Tent in the list of warps");
    taken_out("lib.rs", "pub type NormalStep", "NormalStep in the tiers");
    taken_out("fixed.rs", "cone::Cone", "Cone in the grades");
    // A tier forgotten in its line.
    let texts = changed("warp.rs", |text| {
        text.replace("sphere::Sphere<T>", "sphere::Sphere")
    });
    assert_eq!(missing(&texts), ["Sphere in the tiers"]);
    // What is new: generic over its tier by a bound behind, in a room without a list; and what is not public.
    for (vis, what) in [("pub ", vec!["New in the tiers"]), ("pub(crate) ", vec![])] {
        let more = format!(
            "{vis}struct New<T>(T);\nimpl<T, X> Rejection for New<T>\nwhere\n    T: Copy + Tier,\n{{}}\n"
        );
        let texts = changed("rejection/ball.rs", |text| format!("{text}{more}"));
        assert_eq!(missing(&texts), what);
    }
}
