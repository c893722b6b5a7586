//! The order of the rooms, on what packages may depend, and where `unsafe` may stand.

use crate::files;

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

fn room_of(path: &str) -> Option<usize> {
    let inside = path.strip_prefix("src/").unwrap();
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
    for (path, text) in files("src", &[".rs"]) {
        let Some(room) = room_of(&path) else { continue };
        for used in uses(&text) {
            seen += 1;
            assert!(used <= room, "{} uses {}", path, ROOMS[used]);
            // Integers need no tables, and tables no fixed-point numbers.
            let rooms = (ROOMS[room], ROOMS[used]);
            assert_ne!(rooms, ("fixed", "discrete"), "{}", path);
        }
    }
    assert!(seen > 20, "the rooms' uses are not seen: {seen}");
    // The check itself sees a use of a later room, and none in a comment.
    assert_eq!(uses("use crate::warp::Disk;"), [4]);
    assert!(uses("/// [`crate::warp`]").is_empty());
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
    for room in [
        "Cargo.toml",
        "crates",
        "tests",
        "benches",
        "examples",
        "bindings",
    ] {
        for (path, manifest) in files(room, &["Cargo.toml"]) {
            let folder = path.trim_end_matches("Cargo.toml");
            packages += 1;
            seen += depends_on(folder, &manifest).len();
            assert_eq!(misplaced(folder, &manifest), [""; 0], "{folder}");
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
        misplaced("tests/generators", wrong),
        ["tests/golden", "examples/d"]
    );
    assert!(
        misplaced(
            "tests/generators",
            "path = \"../golden/main.rs\"\na = { path = \"../..\" }"
        )
        .is_empty()
    );
}

#[test]
fn the_only_unsafe_is_the_square_root() {
    for (path, text) in files("src", &[".rs"]) {
        let code = text.lines().filter(|l| !l.trim_start().starts_with("//"));
        let unsafes = code
            .filter(|l| {
                l.contains("unsafe {")
                    || l.contains("unsafe extern")
                    || l.contains("allow(unsafe_code)")
            })
            .count();
        assert_eq!(unsafes > 0, path == "src/tier/sqrt.rs", "{}", path);
    }
}
