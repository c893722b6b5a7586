//! An adversary of the stated errors: a search over parameters and uniforms for the worst case of each row.
//!
//! Here live the search and the worst cases kept from earlier searches. What a
//! sampler is, and how its errors are measured, is the business of the tests that set the adversary on it.
//! Parameters and uniforms are raw words, so that one search serves `f32` and the integer tier.

pub mod kept;
pub mod search;
pub mod words;

use crate::docs;
use crate::parallel::{in_parallel, threads};
use crate::speed;
use search::{Budget, Worst};
use std::collections::BTreeMap;
use words::Kind;

/// The worst of each row of each family, found by all threads of the machine.
pub fn attack(families: &[Family], budget: Budget) -> Vec<Vec<Worst>> {
    let known = vec![Vec::new(); families.len()];
    attack_from(families, budget, &known)
}

fn attack_from(families: &[Family], budget: Budget, known: &[Vec<Worst>]) -> Vec<Vec<Worst>> {
    let jobs: Vec<_> = families.iter().zip(known).collect();
    in_parallel(threads(), &jobs, |(family, known)| {
        search::worst(family, budget, known)
    })
}

/// Holds the statements of all families against the worst cases: those kept in a file beside the test and those found
/// now. A statement fails when it is exceeded, and when the worst case known is less of it than its kind asks for; also,
/// in the full speed, when the search by itself comes so near to no bound of a statement.
///
/// `MICROWARP_SEARCH=seconds` searches each family for so long, from the worst cases kept as well; a second number is another
/// seed. `MICROWARP_WRITE=1` keeps the worst cases.
pub fn hold(families: &[Family], file: &str) {
    let kept = kept::read(file, families);
    let found = attack_from(families, Budget::of_environment(), &kept);
    let mut complaints = Vec::new();
    let mut alone: BTreeMap<&str, f64> = BTreeMap::new();
    let mut known: BTreeMap<(&str, &str), (f64, docs::Kind)> = BTreeMap::new();
    let mut worst_known = Vec::new();
    for ((family, found), kept) in families.iter().zip(found).zip(kept) {
        let (statement, rows) = (family.statement.as_str(), family.rows.iter());
        let rows = rows.zip(&family.kinds);
        for ((title, kind), (found, kept)) in rows.zip(found.into_iter().zip(kept)) {
            raise_to(alone.entry(statement).or_default(), found.ratio);
            let now = found.ratio;
            let worst = if kept.ratio > now { kept } else { found };
            let (most, _) = known.entry((statement, title)).or_insert((0.0, *kind));
            raise_to(most, worst.ratio);
            let line = family.line(title, &worst);
            println!("{line}; found {now:.3}");
            // Written so that NaN complains, here and below.
            let holds = worst.ratio <= 1.0;
            if !holds {
                complaints.push(line);
            }
            worst_known.push((family, title.clone(), worst));
        }
    }
    for (statement, most) in alone {
        let near = !speed::full() || most >= docs::Kind::Found.least();
        if !near {
            complaints.push(format!(
                "{statement}: the search comes no nearer than {most:.3}"
            ));
        }
    }
    for ((statement, title), (ratio, kind)) in known {
        // A statement of 0 is kept by an error of 0.
        let fresh = ratio >= kind.least() || ratio == 0.0;
        if !fresh {
            complaints.push(format!(
                "{statement}; {title}: {}, and stated too large, {ratio:.3}",
                kind.name()
            ));
        }
    }
    if std::env::var_os("MICROWARP_WRITE").is_some() {
        kept::write(file, &worst_known);
    }
    assert!(complaints.is_empty(), "\n{}\n", complaints.join("\n"));
}

/// Holds what was found to its margin over the cases kept from searches; what is proven needs none.
pub fn hold_margins(families: &[Family], file: &str) {
    let kept = kept::read(file, families);
    let close = without_margin(families, &kept);
    assert!(close.is_empty(), "\n{}\n", close.join("\n"));
    // A case that comes a little nearer is noticed where a bound was found, and nowhere else.
    let mut nearer = kept;
    for worst in nearer.iter_mut().flatten() {
        worst.ratio = 0.78;
    }
    let kinds = families.iter().flat_map(|family| &family.kinds);
    let found = kinds.filter(|kind| **kind == docs::Kind::Found).count();
    assert_eq!(without_margin(families, &nearer).len(), found);
}

/// The rows, with the kept case of each, that such a case leaves no margin that their kind asks for.
fn without_margin(families: &[Family], kept: &[Vec<Worst>]) -> Vec<String> {
    let mut close = Vec::new();
    for (family, kept) in families.iter().zip(kept) {
        let rows = family.rows.iter().zip(&family.kinds);
        for ((title, kind), worst) in rows.zip(kept) {
            // Written so that NaN is close.
            let has_margin = worst.ratio <= kind.most();
            if !has_margin {
                close.push(family.line(title, worst));
            }
        }
    }
    close
}

fn raise_to(most: &mut f64, ratio: f64) {
    *most = most.max(ratio);
}

// What the adversary attacks: families of samplers as raw words.

/// Four uniforms as raw words; those a sampler does not take are 0.
pub type Uniforms = [u32; 4];

/// Receives the row, the error found and the bound stated for it.
pub type Observe<'a> = dyn FnMut(usize, f64, f64) + 'a;

/// A sampler with parameters that its constructor has accepted.
pub trait Case {
    /// Measures all errors at one point. An error counts against the bound of its row; NaN is infinitely wrong.
    fn judge(&self, u: Uniforms, observe: &mut Observe);
}

/// Builds a sampler from its parameters; nothing where the constructor refuses them.
pub type Build = dyn Fn(&[u32]) -> Option<Box<dyn Case>> + Send + Sync;

/// Everything that one constructor accepts, in one tier or grade.
pub struct Family {
    /// Unique, without commas or semicolons: `"Power decreasing poly"`.
    pub label: String,
    /// Families of one statement are held to it together: `"Power poly"`.
    pub statement: String,
    pub parameters: Vec<Kind>,
    pub uniforms: Vec<Kind>,
    /// The titles of the rows, by the index that [`Case::judge`] gives.
    pub rows: Vec<String>,
    /// Their kinds; what does not say one is found.
    pub kinds: Vec<docs::Kind>,
    pub build: Box<Build>,
    /// Parameters that someone has listed, to start from.
    pub seeds: Vec<Vec<u32>>,
}

impl Family {
    /// What is reported of a row: its worst case.
    fn line(&self, title: &str, worst: &Worst) -> String {
        format!("{}; {title}: {}", self.label, worst.describe(self))
    }
}
