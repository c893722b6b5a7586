//! Every registered constructor as a family for the adversary: what it takes, and how its samples are judged.

mod flawed;

use host::adversary::words::{Kind, first_accepted};
use host::adversary::{Case, Family, Observe};
use host::docs::{self, Statement, rows_of_floats};
use host::figures::{
    Exact, Figures, ROWS, density_and_inverse_error, density_with_sample_error, draw_error,
    place_error, place_moved, polar_error, sample_error,
};
use host::moved::Moved;
use host::registry::{Domain, Entry, Registered, Uniforms, registered};
use microwarp::Error;
use microwarp::tier::{Libm, Poly};
use std::sync::Arc;

/// All families, in both tiers where they have one.
pub fn families() -> Vec<Family> {
    registered().into_iter().map(family).collect()
}

/// Families with a planted defect, one a tier.
pub fn flawed() -> Vec<Family> {
    vec![
        family(flawed::overflowing::<Libm>()),
        family(flawed::overflowing::<Poly>()),
    ]
}

fn family(of: Registered) -> Family {
    family_by(of, |of, p| of.of_drawn(p))
}

/// How an entry is made of parameters.
pub type Make = fn(&Registered, &[f32]) -> Result<Entry, Error>;

/// A family whose entries are made in another way.
pub fn family_by(of: Registered, make: Make) -> Family {
    let tier = of.tier;
    let column = usize::from(tier != "libm");
    let rows: Arc<[Row]> = rows_of_floats(of.name)
        .into_iter()
        .map(|row| {
            let index = ROWS
                .iter()
                .position(|(title, _)| row.title.starts_with(title));
            let cells: [Statement; 2] = row.statements();
            Row {
                index: index.unwrap_or_else(|| panic!("{}: no row {:?}", of.name, row.title)),
                statement: cells[column].clone(),
                title: row.title,
                kind: row.kind.unwrap_or(docs::Kind::Found),
            }
        })
        .collect();
    let titles = rows.iter().map(|r| r.title.clone()).collect();
    let kinds = rows.iter().map(|r| r.kind).collect();
    let spaced = |part: &str| {
        if part.is_empty() {
            String::new()
        } else {
            format!(" {part}")
        }
    };
    let arity = of.takes.len();
    // Any parameters the constructor accepts tell how many uniforms a sample takes.
    let uniforms = first_accepted(of.takes, |p| {
        of.of_drawn(&floats(p)).ok().map(|entry| entry.uniforms)
    });
    Family {
        label: format!("{}{} {tier}", of.name, spaced(of.constructor)),
        statement: format!("{} {tier}", of.name),
        parameters: of.takes.to_vec(),
        uniforms: vec![Kind::Uniform; uniforms],
        rows: titles,
        kinds,
        seeds: of
            .seeds
            .iter()
            .map(|s| s.iter().map(|x| x.to_bits()).collect())
            .collect(),
        build: Box::new(move |words| {
            assert_eq!(words.len(), arity);
            let entry = make(&of, &floats(words)).ok()?;
            Some(Box::new(Subject {
                entry,
                rows: Arc::clone(&rows),
            }))
        }),
    }
}

fn floats(words: &[u32]) -> Vec<f32> {
    words.iter().map(|w| f32::from_bits(*w)).collect()
}

struct Row {
    title: String,
    /// Among [`ROWS`].
    index: usize,
    statement: Statement,
    kind: docs::Kind,
}

/// A warp beside its truth and its statements.
struct Subject {
    entry: Entry,
    rows: Arc<[Row]>,
}

impl Case for Subject {
    fn judge(&self, u: [u32; 4], observe: &mut Observe) {
        let entry = &self.entry;
        let u: Uniforms = u.map(f32::from_bits);
        let exact = Exact::of(entry, u, true);
        let x = entry.warp.sample(u);
        if !in_order(entry, x) {
            return observe(0, f64::INFINITY, 1.0);
        }
        let mut figures = Figures::default();
        sample_error(entry, &exact, x, &mut figures);
        draw_error(entry, u[0], &mut figures);
        density_and_inverse_error(entry, &exact, x, &mut figures);
        density_with_sample_error(entry, &exact, u, &mut figures);
        place_error(entry, u, &mut figures);
        if entry.domain == Domain::Directions && u[1] == 0.0 {
            polar_error(entry, &exact, x, &mut figures);
        }
        let mut moved = None;
        for (k, row) in self.rows.iter().enumerate() {
            let error = *ROWS[row.index].1(&mut figures);
            let values: Vec<f64> = row
                .statement
                .names()
                .iter()
                .map(|name| match name.as_str() {
                    "s" => {
                        moved
                            .get_or_insert_with(|| Moved::of(entry, &exact, x))
                            .density
                    }
                    "r" => {
                        moved
                            .get_or_insert_with(|| Moved::of(entry, &exact, x))
                            .inverse
                    }
                    "p" => place_moved(entry, u, &exact),
                    _ => self.variable(name),
                })
                .collect();
            let bound = row.statement.eval(&values);
            // Uniforms are never farther apart than 1: such a bound says nothing and is not held to be reached.
            let empty = bound >= 1.0 && matches!(ROWS[row.index].0, "inverse" | "round trip");
            if !empty {
                observe(k, error, bound);
            }
        }
    }
}

impl Subject {
    fn variable(&self, name: &str) -> f64 {
        let known = self.entry.variable(name);
        known.unwrap_or_else(|| panic!("{}: no parameter {name}", self.entry))
    }
}

/// Whether a sample is what every sample must be: finite, of positive finite density, with an inverse in range.
fn in_order(entry: &Entry, x: [f32; 3]) -> bool {
    let density = entry.warp.pdf(x);
    x.iter().all(|c| c.is_finite())
        && density > 0.0
        && density <= f32::MAX
        && entry.warp.invert(x).iter().all(|u| (0.0..1.0).contains(u))
}
