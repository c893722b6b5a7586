//! The same inputs give the same bits: the golden table holds on this machine.
//!
//! The table is `tests/golden/golden.csv`; the very code that is compared here also runs as WASM and as
//! firmware. `cargo regenerate` adds the lines of new cases; it changes others only where they are named.

use microwarp_golden::{cases, describe, evaluate};
use std::fmt::Write as _;
use std::path::PathBuf;

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
