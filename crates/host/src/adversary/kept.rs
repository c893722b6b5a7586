//! The worst cases of earlier searches, checked in.

use super::search::{Worst, raise};
use super::{Family, Uniforms};
use crate::speed;
use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::path::PathBuf;

fn path(file: &str) -> PathBuf {
    crate::root().join("tests").join(file)
}

fn hex(words: &str) -> Vec<u32> {
    let words = words.split_whitespace();
    words
        .map(|w| u32::from_str_radix(w, 16).expect("words in hex"))
        .collect()
}

/// The kept cases of all families: the label, the parameters and the uniforms.
pub fn cases(file: &str) -> Vec<(String, Vec<u32>, Uniforms)> {
    let text = std::fs::read_to_string(path(file)).unwrap_or_default();
    let lines = text.lines().filter(|line| !line.starts_with('#'));
    let cases = lines.map(|line| {
        let columns: Vec<&str> = line.split(';').collect();
        let &[label, _, parameters, uniforms] = columns.as_slice() else {
            panic!("{file} has the line {line:?}");
        };
        let uniforms = hex(uniforms).try_into().expect("four uniforms");
        (label.to_owned(), hex(parameters), uniforms)
    });
    cases.collect()
}

/// The label of a family without its tier: in both, the same cases are bad ones.
fn without_tier(label: &str) -> &str {
    let tiers = [" libm", " poly"];
    let without = tiers.iter().find_map(|tier| label.strip_suffix(tier));
    without.unwrap_or(label)
}

/// What the kept cases of each family reach now, row by row, with those of the same family in another tier.
pub fn read(file: &str, families: &[Family]) -> Vec<Vec<Worst>> {
    let mut worst: Vec<_> = families
        .iter()
        .map(|f| vec![Worst::default(); f.rows.len()])
        .collect();
    for (label, parameters, uniforms) in cases(file) {
        // A sampler that has gone takes its cases with it when the file is written anew.
        let own = families
            .iter()
            .zip(&mut worst)
            .filter(|(family, _)| without_tier(&family.label) == without_tier(&label));
        for (family, worst) in own {
            if let Some(case) = (family.build)(&parameters) {
                raise(case.as_ref(), &parameters, uniforms, worst);
            }
        }
    }
    worst
}

/// Writes the worst case of each row. The cases of families that [`speed::wants`] leaves out stay.
pub fn write(file: &str, worst: &[(&Family, String, Worst)]) {
    let words = |words: &[u32]| {
        let words: Vec<_> = words.iter().map(|w| format!("{w:08x}")).collect();
        words.join(" ")
    };
    let mut lines = BTreeMap::<String, String>::new();
    for (family, title, worst) in worst.iter().filter(|(.., worst)| worst.ratio > 0.0) {
        let (p, u) = (words(&worst.parameters), words(&worst.uniforms));
        let lines = lines.entry(family.label.clone()).or_default();
        let _ = writeln!(lines, "{};{title};{p};{u}", family.label);
    }
    let mut text = String::from(
        "# The worst cases that searches have found, a row of each statement: family; row; parameters; uniforms (words in hex).\n",
    );
    let before = std::fs::read_to_string(path(file)).unwrap_or_default();
    for line in before.lines().filter(|line| !line.starts_with('#')) {
        let label = line.split(';').next().unwrap_or_default();
        if let Some(now) = lines.remove(label) {
            text.push_str(&now);
        } else if !speed::wants(label) {
            let _ = writeln!(text, "{line}");
        }
    }
    let added = worst
        .iter()
        .filter_map(|(family, ..)| lines.remove(&family.label));
    text.extend(added);
    std::fs::write(path(file), text).unwrap();
}
