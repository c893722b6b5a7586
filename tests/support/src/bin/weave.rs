//! Weaves many mutants into one copy of `src`, so that one build of the tests serves them all; `.ci/mutants` calls it.
//!
//! Run in the copy. Each line of the input is a mutant, its fields separated by tabs: a number, the file, the first and
//! last line and column of the function and of the mutated part, and the replacement. A function's body becomes
//! `if crate::mutant::on(1) { the mutant } else { the original }`, with as many branches as it has mutants. At run time
//! the environment says which mutant is on; none is while the compiler evaluates constants.
//! The output says which lines of which file each mutant takes, so that an error of the compiler leads to it.

use std::collections::BTreeMap;
use std::fs::{read_to_string, write};
use std::ops::Range;

struct Mutant<'a> {
    number: &'a str,
    function: Range<usize>,
    part: Range<usize>,
    replacement: String,
}

/// The byte at a line and a column, both counted from 1, columns in characters.
fn offset(text: &str, line: usize, column: usize) -> usize {
    let lines = text.split_inclusive('\n').take(line - 1);
    let start: usize = lines.map(str::len).sum();
    let before = text[start..].chars().take(column - 1);
    start + before.map(char::len_utf8).sum::<usize>()
}

impl<'a> Mutant<'a> {
    fn read(fields: &[&'a str], text: &str) -> Self {
        let at = |k: usize| {
            offset(
                text,
                fields[k].parse().unwrap(),
                fields[k + 1].parse().unwrap(),
            )
        };
        let escaped = [("\\n", "\n"), ("\\t", "\t"), ("\\\\", "\\")];
        Self {
            number: fields[0],
            function: at(2)..at(4),
            part: at(6)..at(8),
            replacement: (escaped.iter())
                .fold(fields[10].into(), |all, (from, to)| all.replace(from, to)),
        }
    }
}

/// What stands between the braces of a function, whose comments and attributes may hold braces too.
fn body(text: &str, function: &Range<usize>) -> Range<usize> {
    let whole = &text[function.clone()];
    let head = whole
        .split_inclusive('\n')
        .take_while(|line| line.trim_start().starts_with(['/', '#']));
    let signature = function.start + head.map(str::len).sum::<usize>();
    signature + text[signature..].find('{').unwrap() + 1..function.end - 1
}

fn weave(file: &str, text: &str, mut mutants: Vec<Mutant>) -> String {
    // A function comes before those inside it, whose mutants become its own.
    mutants.sort_by_key(|m| (m.function.start, usize::MAX - m.function.end));
    let (mut woven, mut done, mut rest) = (String::new(), 0, &mutants[..]);
    while let Some(first) = rest.first() {
        let inside = rest.partition_point(|m| m.function.start < first.function.end);
        let body = body(text, &first.function);
        woven += &text[done..body.start];
        for m in &rest[..inside] {
            woven += &format!("if crate::mutant::on({}) {{\n", m.number);
            let line = woven.lines().count();
            let (before, after) = (&text[body.start..m.part.start], &text[m.part.end..body.end]);
            woven += &format!("{before}{}{after}\n}} else ", m.replacement);
            println!("{}\t{file}\t{line}\t{}", m.number, woven.lines().count());
        }
        woven += &format!("{{{}}}", &text[body.clone()]);
        (done, rest) = (body.end, &rest[inside..]);
    }
    woven + &text[done..]
}

/// The module that reads the mutant's number from the environment. The crate has no `std`, so it asks the C library.
const SWITCH: &str = r#"
use core::sync::atomic::{AtomicU32, Ordering::Relaxed};

static ACTIVE: AtomicU32 = AtomicU32::new(u32::MAX);

unsafe extern "C" {
    fn getenv(name: *const core::ffi::c_char) -> *const core::ffi::c_char;
}

#[inline]
pub(crate) const fn on(number: u32) -> bool {
    core::intrinsics::const_eval_select((number,), none_is, is_on)
}

const fn none_is(_: u32) -> bool {
    false
}

#[inline]
fn is_on(number: u32) -> bool {
    let active = ACTIVE.load(Relaxed);
    if active == u32::MAX { asked() == number } else { active == number }
}

#[cold]
fn asked() -> u32 {
    let text = unsafe { getenv(c"MICROWARP_MUTANT".as_ptr()) };
    let mut number = 0;
    if !text.is_null() {
        for digit in unsafe { core::ffi::CStr::from_ptr(text) }.to_bytes() {
            number = number * 10 + u32::from(digit - b'0');
        }
    }
    ACTIVE.store(number, Relaxed);
    number
}
"#;

fn main() {
    let input = std::io::read_to_string(std::io::stdin()).unwrap();
    let mut files: BTreeMap<&str, Vec<Vec<&str>>> = BTreeMap::new();
    for line in input.lines() {
        let fields: Vec<_> = line.split('\t').collect();
        files.entry(fields[1]).or_default().push(fields);
    }
    for (file, rows) in files {
        let text = read_to_string(file).unwrap();
        let mutants = rows
            .iter()
            .map(|fields| Mutant::read(fields, &text))
            .collect();
        write(file, weave(file, &text, mutants)).unwrap();
    }
    write("src/mutant.rs", SWITCH).unwrap();
    // The lints ask for what the switch cannot give, and say nothing about mutants.
    let root = read_to_string("src/lib.rs")
        .unwrap()
        .replace("#![deny(", "#![allow(");
    let features =
        "#![no_std]\n#![allow(warnings)]\n#![feature(core_intrinsics, const_eval_select)]\n";
    let root = root.replacen("#![no_std]\n", features, 1);
    write("src/lib.rs", root + "\nmod mutant;\n").unwrap();
}
