//! No sampler without its names: what is generic over a tier or a grade has an alias in each, and every warp is in
//! the list of warps and in the catalogue of the host.

use crate::{code, files, warps};
use host::registry::entries;
use std::collections::BTreeSet;

/// What a header of an `impl` says.
struct Impl<'a> {
    /// The trait, without its arguments; empty where there is none.
    of: &'a str,
    name: &'a str,
    /// Whether the type is generic over something of this trait.
    over: BTreeSet<&'a str>,
}

/// The text up to the bracket that closes the one it begins with; and what follows. Arrows close nothing.
fn bracketed(text: &str) -> (&str, &str) {
    let mut open = 0;
    let closing = text.char_indices().find(|(i, c)| {
        open += i32::from(*c == '<') - i32::from(*c == '>' && !text[..*i].ends_with('-'));
        open == 0
    });
    let (end, _) = closing.expect("a closing bracket");
    (&text[1..end], &text[end + 1..])
}

fn name_of(path: &str) -> &str {
    let plain = path.split('<').next().unwrap();
    plain.trim().rsplit("::").next().unwrap()
}

impl<'a> Impl<'a> {
    /// Of a header, without the word itself.
    fn new(header: &'a str) -> Self {
        let generic = header.starts_with('<');
        let (generics, rest) = if generic {
            bracketed(header)
        } else {
            ("", header)
        };
        let head = rest.split('{').next().unwrap();
        let (subject, bounds) = head.split_once("where").unwrap_or((head, ""));
        let (of, name) = subject.split_once(" for ").unwrap_or(("", subject));
        let arguments = name.split_once('<').map_or("", |(_, arguments)| arguments);
        let names = |variable: &str| {
            let mut words = arguments.split(|c: char| !c.is_alphanumeric());
            words.any(|word| word == variable)
        };
        let bounds = generics.split(',').chain(bounds.split(','));
        let over = bounds
            .filter_map(|bound| bound.split_once(':'))
            .filter(|(variable, _)| names(variable.trim()))
            .flat_map(|(_, traits)| traits.split('+').map(name_of));
        Self {
            of: name_of(of),
            name: name_of(name),
            over: over.collect(),
        }
    }
}

/// The headers of a source's `impl`s.
fn impls(text: &str) -> Vec<Impl<'_>> {
    text.split("\nimpl").skip(1).map(Impl::new).collect()
}

/// Which names are missing in a house, and where: of the texts of its files, by their paths below `src`.
fn missing(sources: &[(String, String)]) -> Vec<String> {
    let text = |file: &str| {
        let found = sources.iter().find(|(path, _)| path == file);
        found.map_or("", |(_, text)| text)
    };
    let has = |file: &str, entry: &str| {
        let mut lines = text(file).lines().map(str::trim);
        lines.any(|line| !line.starts_with("//") && line.contains(entry))
    };
    let mut missing = BTreeSet::new();
    for (path, source) in sources {
        let stem = path
            .strip_suffix(".rs")
            .unwrap()
            .rsplit('/')
            .next()
            .unwrap();
        for item in impls(source) {
            let Impl { of, name, over } = &item;
            let public = |kind| {
                let mut lines = source.lines().filter_map(|l| l.strip_prefix(kind));
                lines.any(|line| name_of(line.split(['(', ' ', ';']).next().unwrap()) == *name)
            };
            if !public("pub struct ") && !public("pub enum ") {
                continue;
            }
            let entry = format!("{stem}::{name}");
            if over.contains("Tier")
                && !has("warp.rs", &format!("{entry}<T> \""))
                && !has("warp.rs", &format!("{entry}<T, N> \""))
                && !has("lib.rs", &format!("pub type {name}<"))
                && !has("lib.rs", &format!("pub type {name} "))
            {
                missing.insert(format!("{name} in the tiers"));
            }
            if *of == "Warp"
                && path.starts_with("warp/")
                && !has("warp.rs", &format!("{entry}<"))
                && !has("warp.rs", &format!("{entry} "))
            {
                missing.insert(format!("{name} in the list of warps"));
            }
            if over.contains("Grade")
                && !has("fixed.rs", &format!("{entry} \""))
                && !has("fixed.rs", &format!("{entry}["))
            {
                missing.insert(format!("{name} in the grades"));
            }
        }
    }
    missing.into_iter().collect()
}

/// How many types are generic over a trait.
fn count_over(sources: &[(String, String)], bound: &str) -> usize {
    let all = sources.iter().flat_map(|(_, source)| impls(source));
    let names: BTreeSet<_> = all
        .filter(|i| i.over.contains(bound))
        .map(|i| i.name)
        .collect();
    names.len()
}

/// The texts of the crate's files, by their paths below `src`.
fn house() -> Vec<(String, String)> {
    let inside = |(path, text): (String, String)| (path[4..].to_owned(), text);
    files("src", &[".rs"]).into_iter().map(inside).collect()
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
fn no_warp_is_missing_from_the_catalogue() {
    let entries = entries();
    let names = entries.iter().map(|e| e.name.split(' ').next().unwrap());
    let code = ["src/warp", "src/discrete"].map(code).concat();
    let implemented = warps(&code);
    assert!(implemented.len() > 25);
    assert_eq!(crate::missing(&implemented, &names.collect()), [""; 0]);
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
