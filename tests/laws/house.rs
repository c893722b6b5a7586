//! The house itself: the order of its rooms, and that no warp is missing from the catalogue.

mod names;

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

/// The packages that a manifest depends on by path, as folders from the root.
fn depends_on(folder: &str, manifest: &str) -> Vec<String> {
    let paths = manifest.lines().filter_map(|line| {
        // `path = "src/main.rs"` of a target begins its line; that of a dependency does not.
        let (before, after) = line.split_once("path = \"")?;
        (!before.is_empty()).then(|| after.split('"').next().unwrap())
    });
    let from_the_root = |path: &str| {
        let mut folders: Vec<&str> = folder.split('/').filter(|f| !f.is_empty()).collect();
        for step in path.split('/') {
            match step {
                ".." => drop(folders.pop()),
                step => folders.push(step),
            }
        }
        folders.join("/")
    };
    paths.map(from_the_root).collect()
}

/// Those of them that stand where nothing that is shared may stand.
fn misplaced(folder: &str, manifest: &str) -> Vec<String> {
    let all = depends_on(folder, manifest).into_iter();
    let wrong = |path: &String| {
        ["tests/", "benches/", "examples/"]
            .iter()
            .any(|room| path.starts_with(room))
    };
    all.filter(wrong).collect()
}

#[test]
fn no_package_depends_on_what_stands_in_tests_benches_or_examples() {
    let (mut packages, mut seen) = (0, 0);
    for room in ["", "crates", "tests", "benches", "examples", "bindings"] {
        for (folder, manifest) in manifests(room) {
            packages += 1;
            seen += depends_on(&folder, &manifest).len();
            assert_eq!(misplaced(&folder, &manifest), [""; 0], "{folder}");
        }
    }
    assert!(
        packages > 8 && seen > packages,
        "the manifests are not seen: {packages}, {seen}"
    );
    // The check itself sees a dependency by any spelling, and none in a target.
    let wrong =
        "a = { path = \"../golden\" }\nb = { package = \"c\", path = \"../../examples/d\" }";
    assert_eq!(
        misplaced("tests/probe", wrong),
        ["tests/golden", "examples/d"]
    );
    assert!(
        misplaced(
            "tests/probe",
            "path = \"../golden/main.rs\"\na = { path = \"../..\" }"
        )
        .is_empty()
    );
}

/// The manifests below a folder of the root, or the root's own, with their folders.
fn manifests(room: &str) -> Vec<(String, String)> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut found = Vec::new();
    let mut open = vec![root.join(room)];
    while let Some(folder) = open.pop() {
        if let Ok(text) = fs::read_to_string(folder.join("Cargo.toml")) {
            let name = folder.strip_prefix(root).unwrap();
            found.push((name.to_str().unwrap().to_owned(), text));
        }
        // The root's other folders are named, so that what is built there is not read.
        let inside = (!room.is_empty()).then(|| fs::read_dir(&folder).unwrap());
        let folders = inside
            .into_iter()
            .flatten()
            .map(|entry| entry.unwrap().path());
        open.extend(folders.filter(|path| path.is_dir() && !path.ends_with("target")));
    }
    found
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
