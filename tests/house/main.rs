//! The house itself: its output bits, the order of its rooms, that nothing is without its names, its golden bits or its
//! cost, and the pages that a newcomer reads.

mod golden;
mod names;
mod pages;
mod rooms;

use std::collections::BTreeSet;
use std::fs;

use host::root;

/// The text of a file of the repository.
fn read(path: &str) -> String {
    fs::read_to_string(root().join(path)).unwrap_or_else(|e| panic!("{path}: {e}"))
}

/// The files under a path of the repository whose names have one of these endings, sorted, with their texts.
fn files(under: &str, endings: &[&str]) -> Vec<(String, String)> {
    let (mut found, mut open) = (Vec::new(), vec![root().join(under)]);
    while let Some(path) = open.pop() {
        if path.is_dir() {
            // What is built there is not read.
            if !path.ends_with("target") {
                open.extend(fs::read_dir(path).unwrap().map(|e| e.unwrap().path()));
            }
        } else if endings
            .iter()
            .any(|end| path.to_str().unwrap().ends_with(end))
        {
            let name = path.strip_prefix(root()).unwrap().to_str().unwrap();
            found.push((name.to_owned(), read(name)));
        }
    }
    found.sort();
    found
}

/// The code of the Rust files under a path, without comments.
fn code(under: &str) -> String {
    let files = files(under, &[".rs"]);
    let lines = files.iter().flat_map(|(_, text)| text.lines());
    let code = lines.map(|line| line.split("//").next().unwrap());
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

/// The public names of the rooms that have samplers beside the warps, of the code of the crate.
fn of_rooms(code: &str) -> BTreeSet<String> {
    let rooms = ["discrete", "rejection", "metropolis", "estimate", "uniform"];
    let rooms = rooms
        .map(|room| self::code(&format!("src/{room}.rs")))
        .concat();
    let names = public(&rooms, code);
    assert!(names.len() > 40, "{} names are seen", names.len());
    names.into_iter().map(str::to_owned).collect()
}

/// The names that are not among others.
fn missing<'a, S: AsRef<str>>(names: &'a BTreeSet<S>, present: &BTreeSet<&str>) -> Vec<&'a str> {
    let names = names.iter().map(AsRef::as_ref);
    names.filter(|name| !present.contains(*name)).collect()
}

#[test]
fn public_names_are_seen_and_so_are_those_that_are_missing() {
    let source = "impl<T: Tier> Warp for Disk<T> {}\nimpl Warp for Ring {}\nimpl<W> Warp for &W {}";
    assert_eq!(Vec::from_iter(warps(source)), ["Disk", "Ring"]);
    let room =
        "pub use self::walk::{Walk, Mutation,\n stay};\npub use self::step::Step;\nuse a::B;";
    let code = "pub trait Mutation<X> {}\npub trait Steps {}\npub struct Step;";
    let names = public(room, code);
    assert_eq!(Vec::from_iter(names.clone()), ["Step", "Walk", "stay"]);
    let golden = identifiers("Walk::new(), Stepped, stays()");
    assert_eq!(missing(&names, &golden), ["Step", "stay"]);
}
