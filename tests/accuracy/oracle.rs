//! The truths in doubles, by which errors are judged, are those of 237 bits to a thousandth of every statement.
//!
//! Both judge the same samples: where a truth has lost digits, the errors differ. Tried are the listed parameters, the hard ones and
//! the worst cases that searches have kept, each with its uniforms and with those at which maps break.

use super::families::{self, Make};
use super::{EDGES, spread};
use host::adversary::{self, Case, Family};
use host::parallel::{in_parallel, threads};
use host::registry::{Entry, Registered, of_poly};
use host::speed;
use host::truth::{Truth, Uniforms, precisely};
use microwarp::Error;
use std::collections::BTreeMap;
use std::sync::Arc;

/// How far two truths may be apart, of what is stated.
const PART: f64 = 1e-3;

/// A label, parameters and uniforms.
type Kept = (String, Vec<u32>, [u32; 4]);

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

/// Everything that is tried of a family: parameters and uniforms.
fn tried(of: &Registered, family: &Family, kept: &[Kept]) -> Vec<(Vec<u32>, [u32; 4])> {
    let number = speed::of("uniforms of each set of parameters beside 237 bits", 1, 4);
    let stride = speed::of(
        "one set of parameters tried of every, beside 237 bits",
        16,
        1,
    );
    let kept = kept.iter().filter(|(label, ..)| *label == family.label);
    let listed = of.cases.iter().map(|(_, p, _)| p).chain(&of.seeds);
    let listed = listed.map(|p| p.iter().map(|x| x.to_bits()).collect());
    let sets = listed.chain(kept.clone().map(|(_, p, _)| p.clone()));
    let mut all: Vec<_> = kept
        .step_by(stride)
        .map(|(_, p, u)| (p.clone(), *u))
        .collect();
    for (k, set) in sets.enumerate().step_by(stride) {
        for j in 0..number {
            let mut u = spread((97 * k + j) as u32);
            if j % 3 == 0 {
                u[j / 3 % 2] = EDGES[(k + j) % EDGES.len()];
            }
            all.push((set.clone(), u.map(f32::to_bits)));
        }
    }
    for (_, u) in &mut all {
        u[family.uniforms.len()..].fill(0);
    }
    all
}

/// How far two ways to make the entries of each wanted family are apart at most, and the parameters and uniforms where.
fn worst(wants: fn(&str) -> bool, ways: [Make; 2]) -> Vec<(f64, String)> {
    let made = |make| {
        let families = of_poly().into_iter();
        families.map(move |of| families::family_by(of, make))
    };
    let pairs = made(ways[0]).zip(made(ways[1]));
    let all = of_poly().into_iter().zip(pairs);
    let all: Vec<_> = all.filter(|(of, _)| wants(of.name)).collect();
    let kept = adversary::kept::cases("accuracy/worst.csv");
    in_parallel(threads(), &all, |(of, (one, other))| {
        let mut worst = (0.0, String::new());
        for (parameters, u) in tried(of, one, &kept) {
            let build = |family: &Family| (family.build)(&parameters);
            if let (Some(one), Some(other)) = (build(one), build(other)) {
                let (off, row) = apart(one.as_ref(), other.as_ref(), u);
                let near = off <= worst.0;
                if !near {
                    let numbers: Vec<f32> = parameters.iter().map(|w| f32::from_bits(*w)).collect();
                    let at = format!("{numbers:?} at {:?}, {row}", u.map(f32::from_bits));
                    worst = (off, at);
                }
            }
        }
        let (off, at) = worst;
        let text = format!("{}: {off:.1e} of what is stated, {at}", one.label);
        println!("{text}");
        (off, text)
    })
}

fn doubles(of: &Registered, p: &[f32]) -> Result<Entry, Error> {
    of.of_drawn(p)
}

fn precise(of: &Registered, p: &[f32]) -> Result<Entry, Error> {
    let (entry, number) = precisely(|| of.of_drawn(p));
    assert!(number > 0, "{} has no precise truth", of.name);
    entry
}

#[test]
fn truths_in_doubles_are_those_of_237_bits() {
    let mut complaints = Vec::new();
    for (off, text) in worst(speed::wants, [doubles, precise]) {
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
fn off(of: &Registered, p: &[f32]) -> Result<Entry, Error> {
    let mut entry = of.of_drawn(p)?;
    entry.truth = Arc::new(Off(entry.truth, 0.01 * f64::from(f32::EPSILON)));
    Ok(entry)
}

#[test]
fn truths_that_are_off_by_a_hundredth_are_noticed() {
    const TRIED: [&str; 6] = [
        "Exponential",
        "Sphere",
        "Disk",
        "Cone",
        "Weibull",
        "VisibleSphere",
    ];
    let found = worst(|name| TRIED.contains(&name), [off, precise]);
    assert!(found.len() >= TRIED.len());
    for (off, text) in found {
        assert!(off > PART, "{text}");
    }
}
