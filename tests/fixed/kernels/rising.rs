//! Functions that rise may fall from a word to the next, by no more than the documentation of the grades says.
//!
//! The figures stand in its second table, in steps of the result; `MICROWARP_WRITE=1 MICROWARP_FULL=all cargo test
//! --test fixed rise` writes them anew.

use super::inputs::{Words, edges};
use fixed::types::{U0F32, U5F27};
use host::docs::{self, Doc, Row, states};
use host::speed::{Speed, speed};
use microwarp::fixed::{Coarse, Compact, Fine, Grade};

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
    let falls = Words::every(8192, 128).fold(
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

/// The falls in the three grades, by the function.
fn stated() -> Vec<(String, [u32; 3])> {
    let mut tables = Doc::of("fixed", "Grade").tables();
    let rows = tables.swap_remove(1).into_iter();
    let falls = |cells: Vec<String>| -> Vec<u32> {
        cells.iter().map(|cell| cell.parse().unwrap()).collect()
    };
    rows.map(|row| (row.title, falls(row.cells).try_into().unwrap()))
        .collect()
}

fn write(measured: &[(String, [u32; 3])]) {
    let rows = measured.iter();
    let rows = rows.map(|(name, falls)| Row::new(name, falls.map(|fall| fall.to_string())));
    docs::write("fixed", "Grade", 1, &rows.collect::<Vec<_>>());
}

/// Over all words the falls are those that are stated; over some of them, no larger and nearly as large; over few, no
/// larger.
fn agrees(speed: Speed, stated: u32, measured: u32) -> bool {
    match speed {
        Speed::All => measured == stated,
        Speed::Full => states(stated.into(), measured.into(), 0.0),
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
