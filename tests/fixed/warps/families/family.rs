//! A warp of the integer tier in a grade, as a family for the adversary.
//!
//! A subject is a warp whose parameters, and whose format where it has one, are words that its constructor accepted.
//! Judging it is one sample, its density and its inverse against the truth in `f64`, or in integers where the warp is
//! exact; what may never happen whatever the words is a fault.

use crate::warps::figures::statements;
use fixed::types::extra::Unsigned;
use host::adversary::words::Kind;
use host::adversary::{self, Case, Observe, Uniforms};
use host::docs::{self, Doc, Statement};

/// 2⁻³².
pub const WORD: f64 = 1.0 / 4_294_967_296.0;
/// 2⁻³⁰, the step of a coordinate.
pub const STEP: f64 = 4.0 * WORD;

/// What must not happen.
pub type Fault = &'static str;

/// Measures the errors of one sample, in the order of the rows.
pub type Judge = dyn Fn([u32; 4], &mut [f64]) -> Result<(), Fault>;

/// A warp of certain parameters.
pub struct Subject {
    /// What the formulas of its documentation name.
    pub variables: Vec<(&'static str, f64)>,
    pub judge: Box<Judge>,
}

/// A warp in a grade, over all parameters.
pub struct Family {
    pub name: &'static str,
    /// Fine, coarse, compact.
    pub grade: usize,
    /// The rows of its table.
    pub rows: &'static [&'static str],
    /// How many words its parameters take, and a point.
    pub parameters: usize,
    pub words: usize,
    /// Nothing where the constructor refuses.
    pub build: fn(&[u32]) -> Option<Subject>,
}

impl Subject {
    pub fn new(
        variables: Vec<(&'static str, f64)>,
        judge: impl Fn([u32; 2], &mut [f64]) -> Result<(), Fault> + 'static,
    ) -> Option<Self> {
        Self::of_four(variables, move |[u, v, ..], errors| judge([u, v], errors))
    }

    /// Of up to four words.
    pub fn of_four(
        variables: Vec<(&'static str, f64)>,
        judge: impl Fn([u32; 4], &mut [f64]) -> Result<(), Fault> + 'static,
    ) -> Option<Self> {
        let judge = Box::new(judge);
        Some(Self { variables, judge })
    }

    /// A statement with these parameters in it.
    fn bound(&self, statement: &Statement) -> f64 {
        let value = |name: &String| {
            let mut known = self.variables.iter();
            let found = known.find(|(known, _)| known == name);
            found.unwrap_or_else(|| panic!("no parameter {name}")).1
        };
        let values: Vec<f64> = statement.names().iter().map(value).collect();
        statement.eval(&values)
    }
}

/// A subject with what is stated of it.
struct Stated {
    subject: Subject,
    bounds: Vec<f64>,
}

impl Case for Stated {
    fn judge(&self, words: Uniforms, observe: &mut Observe) {
        let mut errors = vec![0.0; self.bounds.len()];
        if let Err(fault) = (self.subject.judge)(words, &mut errors) {
            // Only the words are reported, so the fault itself is said here.
            println!("{fault}: {words:#x?}");
            return observe(0, f64::INFINITY, 1.0);
        }
        for (row, (error, bound)) in errors.into_iter().zip(&self.bounds).enumerate() {
            observe(row, error.abs(), *bound);
        }
    }
}

const GRADES: [&str; 3] = ["fine", "coarse", "compact"];

impl Family {
    pub fn stated(self) -> adversary::Family {
        let label = format!("{} {}", self.name, GRADES[self.grade]);
        let statements: Vec<Statement> = self
            .rows
            .iter()
            .map(|title| self.statement(title))
            .collect();
        let kinds = self.rows.iter().map(|title| self.kind(title)).collect();
        let build = self.build;
        adversary::Family {
            statement: label.clone(),
            label,
            parameters: vec![Kind::Word; self.parameters],
            uniforms: vec![Kind::Word; self.words],
            rows: self.rows.iter().map(|title| (*title).to_owned()).collect(),
            kinds,
            build: Box::new(move |parameters| {
                let subject = build(parameters)?;
                let bounds = statements.iter().map(|s| subject.bound(s)).collect();
                Some(Box::new(Stated { subject, bounds }))
            }),
            seeds: Vec::new(),
        }
    }

    fn kind(&self, title: &str) -> docs::Kind {
        let row = Doc::of("fixed", self.name).row(title);
        // What stands in words is how a result is rounded or cut.
        row.and_then(|row| row.kind).unwrap_or(docs::Kind::Proven)
    }

    fn statement(&self, title: &str) -> Statement {
        // What its documentation says in words stands as the title's last word here.
        if Doc::of("fixed", self.name).tables().is_empty() {
            let word = title.rsplit(' ').next().and_then(Statement::parse);
            return word.unwrap_or_else(|| panic!("{} states nothing of: {title}", self.name));
        }
        statements(self.name, title)[self.grade].clone()
    }
}

pub fn uniform(word: u32) -> f64 {
    f64::from(word) * WORD
}

pub fn check(holds: bool, fault: Fault) -> Result<(), Fault> {
    if holds { Ok(()) } else { Err(fault) }
}

/// By how much a number lies beyond an allowance.
pub fn beyond(error: f64, allowance: f64) -> f64 {
    // NaN stays NaN.
    if error.abs() <= allowance {
        0.0
    } else {
        error.abs() - allowance
    }
}

/// The error of a density beyond a step of 2⁻³², of the peak; what is below a step or above the largest density
/// counts as that.
pub fn density_error(got: microwarp::fixed::Density, due: f64, peak: f64) -> f64 {
    let due = due.clamp(WORD, 4_294_967_296.0);
    beyond(got.to_num::<f64>() - due, WORD) / peak
}

/// What is made of the format that a word chooses.
macro_rules! in_format {
    ($word:expr, $format:ident, $made:expr) => {{
        use fixed::types::extra::{U0, U1, U8, U16, U27, U30, U31, U32};
        in_format!(@ $word, $format, $made, 0 U0, 1 U1, 2 U8, 3 U16, 4 U27, 5 U30, 6 U31, 7 U32)
    }};
    (@ $word:expr, $format:ident, $made:expr, $($place:literal $of:ident),*) => {
        match $word % 8 {
            $($place => {
                type $format = $of;
                $made
            })*
            _ => unreachable!(),
        }
    };
}
pub(super) use in_format;

/// How many steps of the format that a word chooses are 1.
pub fn one(word: u32) -> f64 {
    in_format!(word, Frac, 2_f64.powi(<Frac as Unsigned>::I32))
}

/// A family in each of the grades.
macro_rules! family {
    ($all:ident, $name:literal, $rows:expr, $parameters:literal, |$p:ident, $grade:ident| $build:expr) => {
        family!($all, $name, $rows, $parameters, words 2, |$p, $grade| $build)
    };
    (
        $all:ident, $name:literal, $rows:expr, $parameters:literal, words $words:literal,
        |$p:ident, $grade:ident| $build:expr
    ) => {{
        use microwarp::fixed::{Coarse, Compact, Fine, Grade};
        fn build<$grade: Grade>($p: &[u32]) -> Option<Subject> {
            $build
        }
        let builds = [build::<Fine>, build::<Coarse>, build::<Compact>];
        for (grade, build) in builds.into_iter().enumerate() {
            $all.push(Family {
                name: $name,
                grade,
                rows: $rows,
                parameters: $parameters,
                words: $words,
                build,
            });
        }
    }};
}
pub(super) use family;
