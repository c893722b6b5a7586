//! The index at the top of a header: what each section declares, by the names without `mw_`.

use super::declare::WIDTH;
use crate::upkeep::wrapped;
use std::fmt::Write;

/// The grades of the integer tier: a sampler of all is named once.
const GRADES: [&str; 3] = ["fixed_", "coarse_", "compact_"];

/// The lines of the comment, section by section.
pub fn index(header: &str) -> String {
    let mut text = String::new();
    for section in header.split("/* ---- ").skip(1) {
        let title = section.split(" --").next().unwrap_or_default();
        let names = names(section);
        let (graded, others) = graded(&names);
        writeln!(text, " *   {title}").unwrap();
        if !graded.is_empty() {
            writeln!(
                text,
                " *     in three grades, {}_NAME:",
                GRADES
                    .map(|grade| grade.trim_end_matches('_'))
                    .join("_NAME, ")
            )
            .unwrap();
            listed(&mut text, "       ", &graded);
        }
        if !graded.is_empty() && !others.is_empty() {
            writeln!(text, " *     and").unwrap();
        }
        listed(&mut text, "     ", &others);
    }
    text
}

fn listed(text: &mut String, indent: &str, names: &[String]) {
    if names.is_empty() {
        return;
    }
    for line in wrapped(&names.join(", "), WIDTH - 3 - indent.len()) {
        writeln!(text, " *{indent}{line}").unwrap();
    }
}

/// What functions are named after: the structs, and samplers without one. The longest come first.
fn stems(section: &str) -> Vec<String> {
    let structs = section.split("typedef struct ").skip(1);
    let structs = structs.filter_map(|rest| rest.split([' ', ';']).next());
    let samplers = functions(section).into_iter();
    let samplers = samplers.filter_map(|name| name.strip_suffix("_sample"));
    let mut stems: Vec<String> = structs.chain(samplers).map(Into::into).collect();
    stems.sort_by_key(|stem| std::cmp::Reverse(stem.len()));
    stems
}

/// The functions that a text declares, in order.
fn functions(text: &str) -> Vec<&str> {
    let code = text
        .lines()
        .filter(|line| line.starts_with(|c: char| c.is_ascii_lowercase()));
    let calls = code
        .filter_map(|line| line.split_once('('))
        .map(|(before, _)| before);
    let names = calls.filter_map(|before| before.rsplit([' ', '*']).next());
    names.filter(|name| name.starts_with("mw_")).collect()
}

/// What the functions of a section belong to, each once, without `mw_`.
fn names(section: &str) -> Vec<String> {
    let (stems, functions) = (stems(section), functions(section));
    let mut names: Vec<String> = Vec::new();
    for name in &functions {
        let of = |stem: &&String| {
            name.strip_prefix(stem.as_str())
                .is_some_and(|rest| rest.starts_with('_'))
        };
        let owner = stems.iter().find(of).map_or(*name, |stem| stem.as_str());
        // The same function from a source is not named beside it.
        let again = owner
            .strip_suffix("_from")
            .is_some_and(|with| functions.contains(&with));
        let owner = owner.trim_start_matches("mw_").to_owned();
        if !again && !names.contains(&owner) {
            names.push(owner);
        }
    }
    names
}

/// Those of all grades without the grade, and the others.
fn graded(names: &[String]) -> (Vec<String>, Vec<String>) {
    let every = |name: &str| {
        GRADES
            .iter()
            .all(|grade| names.contains(&format!("{grade}{name}")))
    };
    let of = |name: &String| {
        let bare = GRADES.iter().find_map(|grade| name.strip_prefix(grade))?;
        every(bare).then(|| bare.to_owned())
    };
    let mut graded: Vec<String> = names.iter().filter_map(of).collect();
    graded.sort();
    graded.dedup();
    let others = names
        .iter()
        .filter(|name| of(name).is_none())
        .cloned()
        .collect();
    (graded, others)
}
