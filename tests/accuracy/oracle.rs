//! The truths in doubles, by which errors are judged, are those of 237 bits to a thousandth of every statement.
//!
//! Both judge the same samples: where a truth has lost digits, the errors differ. Tried are the listed parameters, the hard ones and
//! the worst cases that searches have kept, each with its uniforms and with those at which maps break.

use super::families::{self, Make};
use super::{EDGES, spread};
use host::adversary::{Case, Family};
use host::parallel::{in_parallel, threads};
use host::registry::{Entry, Registered, of_poly};
use host::speed;
use host::truth::{Truth, Uniforms, precisely};
use std::collections::BTreeMap;
use std::sync::Arc;

/// How far two truths may be apart, of what is stated.
const PART: f64 = 1e-3;

/// The rows that a case shows at a point: the error, and the bound on it.
fn judged(case: &dyn Case, u: [u32; 4]) -> BTreeMap<usize, [f64; 2]> {
    let mut rows = BTreeMap::new();
    case.judge(u, &mut |row, error, bound| {
        rows.insert(row, [error, bound]);
    });
    rows
}

/// The row where errors differ most, of what is stated, and both; of the rows that both judges show.
fn apart(one: &dyn Case, other: &dyn Case, u: [u32; 4]) -> (f64, String) {
    let others = judged(other, u);
    let mut worst = (0.0_f64, String::new());
    for (row, [error, bound]) in judged(one, u) {
        let Some([same, due]) = others.get(&row) else {
            continue;
        };
        let off = (error - same).abs() / bound.min(*due);
        // What is equal may be 0 or infinite; where so much is granted, nothing is stated. NaN counts as apart.
        let near = off <= worst.0 || error == *same || bound.max(*due) > 1e6;
        if !near {
            worst = (
                off,
                format!("row {row}: {error:e} of {bound:e}, {same:e} of {due:e}"),
            );
        }
    }
    worst
}

/// The worst cases of a family in the file of those that searches have kept: parameters and uniforms.
fn kept(label: &str) -> Vec<(Vec<u32>, [u32; 4])> {
    let hex = |words: &str| -> Vec<u32> {
        let words = words.split_whitespace().map(|w| u32::from_str_radix(w, 16));
        words.map(Result::unwrap).collect()
    };
    let lines = include_str!("worst.csv").lines();
    let of_family = lines.filter_map(|line| line.strip_prefix(label)?.strip_prefix(';'));
    let each = of_family.map(|line| {
        let columns: Vec<&str> = line.split(';').collect();
        let uniforms = hex(columns[2]);
        (hex(columns[1]), std::array::from_fn(|i| uniforms[i]))
    });
    each.filter(|(parameters, _)| !parameters.is_empty())
        .collect()
}

/// Everything that is tried of a family.
fn tried(of: &Registered, label: &str) -> Vec<(Vec<u32>, [u32; 4])> {
    let number = speed::of("uniforms of each set of parameters beside 237 bits", 1, 4);
    let stride = speed::of(
        "one set of parameters tried of every, beside 237 bits",
        16,
        1,
    );
    let kept = kept(label);
    let listed = of.cases.iter().map(|(_, p, _)| p).chain(&of.seeds);
    let listed = listed.map(|p| p.iter().map(|x| x.to_bits()).collect());
    let of_kept = kept.iter().map(|(p, _)| p.clone());
    let sets: Vec<Vec<u32>> = listed.chain(of_kept).collect();
    let mut all: Vec<_> = kept.into_iter().step_by(stride).collect();
    for (k, set) in sets.into_iter().enumerate().step_by(stride) {
        for j in 0..number {
            let mut u = spread((97 * k + j) as u32);
            if j % 3 == 0 {
                u[j / 3 % 2] = EDGES[(k + j) % EDGES.len()];
            }
            all.push((set.clone(), u.map(f32::to_bits)));
        }
    }
    all
}

/// How far two ways to make the entries of a family are apart at most, and the parameters and uniforms where.
fn worst(of: fn() -> Vec<Registered>, i: usize, ways: [Make; 2]) -> (f64, String) {
    let [one, other] = ways.map(|make| families::family_by(of().swap_remove(i), make));
    let registered = of().swap_remove(i);
    let mut worst = (0.0, String::new());
    for (parameters, mut u) in tried(&registered, &one.label) {
        for (k, word) in u.iter_mut().enumerate() {
            *word = if k < one.uniforms.len() { *word } else { 0 };
        }
        let build = |family: &Family| (family.build)(&parameters);
        if let (Some(one), Some(other)) = (build(&one), build(&other)) {
            let (off, row) = apart(one.as_ref(), other.as_ref(), u);
            let near = off <= worst.0;
            if !near {
                let numbers: Vec<f32> = parameters.iter().map(|w| f32::from_bits(*w)).collect();
                worst = (
                    off,
                    format!("{numbers:?} at {:?}, {row}", u.map(f32::from_bits)),
                );
            }
        }
    }
    (
        worst.0,
        format!(
            "{}: {:.1e} of what is stated, {}",
            one.label, worst.0, worst.1
        ),
    )
}

fn doubles(of: &Registered, p: &[f32]) -> Result<Entry, microwarp::Error> {
    of.of_drawn(p)
}

fn precise(of: &Registered, p: &[f32]) -> Result<Entry, microwarp::Error> {
    let (entry, number) = precisely(|| of.of_drawn(p));
    assert!(number > 0, "{} has no precise truth", of.name);
    entry
}

#[test]
fn truths_in_doubles_are_those_of_237_bits() {
    let jobs: Vec<usize> = (0..of_poly().len()).collect();
    let wanted = of_poly()
        .into_iter()
        .map(|of| speed::wants(of.name))
        .collect::<Vec<_>>();
    let found = in_parallel(threads(), &jobs, |&i| {
        wanted[i].then(|| worst(of_poly, i, [doubles, precise]))
    });
    let mut complaints = Vec::new();
    for (off, text) in found.into_iter().flatten() {
        println!("{text}");
        // Written so that NaN complains.
        let holds = off <= PART;
        if !holds {
            complaints.push(text);
        }
    }
    assert!(complaints.is_empty(), "\n{}\n", complaints.join("\n"));
}

/// A truth that is off by a part of what is stated.
struct Off(Arc<dyn Truth>, f64);

impl Truth for Off {
    fn sample(&self, u: Uniforms) -> [f64; 3] {
        self.0.sample(u).map(|x| x * (1.0 + self.1))
    }
    fn pdf(&self, x: [f64; 3]) -> f64 {
        self.0.pdf(x) * (1.0 + self.1)
    }
    fn density(&self, u: Uniforms) -> f64 {
        self.0.density(u) * (1.0 + self.1)
    }
    fn invert(&self, x: [f64; 3]) -> Uniforms {
        self.0.invert(x)
    }
    fn fourth(&self, u: Uniforms) -> Option<f64> {
        self.0.fourth(u)
    }
}

/// A hundredth of a unit in the last place, where a statement is one or two.
fn off(of: &Registered, p: &[f32]) -> Result<Entry, microwarp::Error> {
    let mut entry = of.of_drawn(p)?;
    entry.truth = Arc::new(Off(entry.truth, 0.01 * f64::from(f32::EPSILON)));
    Ok(entry)
}

#[test]
fn truths_that_are_off_by_a_hundredth_are_noticed() {
    let mut tried = 0;
    for (i, of) in of_poly().iter().enumerate() {
        if [
            "Exponential",
            "Sphere",
            "Disk",
            "Cone",
            "Weibull",
            "VisibleSphere",
        ]
        .contains(&of.name)
        {
            let (found, text) = worst(of_poly, i, [off, precise]);
            println!("{text}");
            assert!(found > PART, "{text}");
            tried += 1;
        }
    }
    assert!(tried >= 6);
}
