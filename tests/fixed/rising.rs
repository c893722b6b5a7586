//! Functions that rise may fall from a word to the next, by no more than the documentation of the grades says.
//!
//! The figures stand in its second table, in steps of the result; `MICROWARP_WRITE=1 MICROWARP_FULL=all cargo test
//! --test fixed rise` writes them anew.

use crate::inputs::{Words, edges};
use fixed::types::{U0F32, U5F27};
use microwarp::fixed::{Coarse, Compact, Fine, Grade};
use std::path::{Path, PathBuf};
use support::speed::{Speed, speed};

/// A rising function of a word, in its words.
type Rising = fn(u32) -> u32;

const NAMES: [&str; 4] = ["`sqrt`", "`neg_ln_1m`", "`exp_neg`", "`exp_m1_neg`"];

fn functions<G: Grade>() -> [Rising; 4] {
    [
        |word| G::sqrt(U0F32::from_bits(word)).to_bits(),
        |word| G::neg_ln_1m(U0F32::from_bits(word)).to_bits(),
        // It falls, so its complement.
        |word| !G::exp_neg(U5F27::from_bits(word)).to_bits(),
        |word| G::exp_m1_neg(U5F27::from_bits(word)).to_bits(),
    ]
}

/// By how much a function falls at most from a word to the next.
fn largest_fall(name: &str, function: Rising) -> u32 {
    let falls = Words::every(64).fold(
        name,
        &edges(),
        || 0,
        |largest: &mut u32, word| {
            let next = function(word.saturating_add(1));
            *largest = function(word).saturating_sub(next).max(*largest);
        },
    );
    falls.into_iter().max().unwrap()
}

fn source() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("src/fixed/grade.rs")
}

const MARK: &str = "/// | ";

/// A row of the table: the function, and the falls in the three grades.
fn row(line: &str) -> Option<(&str, [u32; 3])> {
    let cells = line.strip_prefix(MARK)?.strip_suffix(" |")?;
    let (name, numbers) = cells.split_once(" | ")?;
    let numbers: Option<Vec<u32>> = numbers.split(" | ").map(|n| n.parse().ok()).collect();
    Some((name, numbers?.try_into().ok()?))
}

fn stated() -> Vec<(String, [u32; 3])> {
    let text = std::fs::read_to_string(source()).unwrap();
    let rows = text.lines().filter_map(row);
    rows.map(|(name, falls)| (name.to_owned(), falls)).collect()
}

fn write(measured: &[(String, [u32; 3])]) {
    let text = std::fs::read_to_string(source()).unwrap();
    let lines = text.lines().map(|line| {
        let of = |name: &str| measured.iter().find(|row| row.0 == name);
        match row(line).and_then(|(name, _)| of(name)) {
            Some((name, [a, b, c])) => format!("{MARK}{name} | {a} | {b} | {c} |\n"),
            None => format!("{line}\n"),
        }
    });
    let text: String = lines.collect();
    std::fs::write(source(), text).unwrap();
}

/// Over all words the falls are those that are stated; over some of them, no larger and nearly as large; over few, no
/// larger.
fn agrees(speed: Speed, stated: u32, measured: u32) -> bool {
    match speed {
        Speed::All => measured == stated,
        Speed::Full => measured <= stated && 5 * u64::from(measured) >= 4 * u64::from(stated),
        Speed::Quick => measured <= stated,
    }
}

#[test]
fn functions_rise_but_for_what_is_stated() {
    let all = [
        functions::<Fine>(),
        functions::<Coarse>(),
        functions::<Compact>(),
    ];
    let measured: Vec<(String, [u32; 3])> = NAMES
        .iter()
        .enumerate()
        .map(|(i, name)| {
            (
                name.to_string(),
                all.map(|grade| largest_fall(name, grade[i])),
            )
        })
        .collect();
    println!("{measured:?}");
    if std::env::var_os("MICROWARP_WRITE").is_some() {
        write(&measured);
    }
    let stated = stated();
    assert_eq!(stated.len(), NAMES.len());
    for ((name, stated), (of, measured)) in stated.iter().zip(&measured) {
        assert_eq!(name, of);
        for (stated, measured) in stated.iter().zip(measured) {
            assert!(
                agrees(speed(), *stated, *measured),
                "{name}: {stated}, measured {measured}"
            );
        }
    }
    // A fall at one word in 2¹⁰ is seen, and a stated fall that there is not.
    let falling = |word: u32| word - if word & 1023 == 77 { 5 } else { 0 };
    assert_eq!(largest_fall("control", falling), 4);
    for speed in [Speed::Quick, Speed::Full, Speed::All] {
        assert!(!agrees(speed, 4, 5));
    }
    assert!(!agrees(Speed::Full, 7, 5) && !agrees(Speed::All, 6, 5));
}
