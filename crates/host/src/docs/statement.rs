//! A stated bound: a number, or a formula in the parameters of the sampler and in what its exact density says.

use exmex::{Express, FlatEx, FloatOpsFactory, MatchLiteral, literal_matcher_from_pattern};

literal_matcher_from_pattern!(Scientific, r"^[0-9]+(\.[0-9]+)?(e[+-]?[0-9]+)?");

/// One cell of a table of errors.
#[derive(Clone, Debug)]
pub struct Statement {
    formula: FlatEx<f64, FloatOpsFactory<f64>, Scientific>,
    number: Option<f64>,
}

impl Statement {
    /// Reads `2e-7`, `3e-7 + 2*s` or, since Markdown takes what stands between two stars for emphasis, `a·s + 6e-7·q`;
    /// nothing where the text is none of these.
    pub fn parse(cell: &str) -> Option<Self> {
        let formula: FlatEx<_, _, _> = FlatEx::parse(&cell.replace('·', "*")).ok()?;
        let number = formula.var_names().is_empty().then(|| formula.eval(&[]));
        let number = number.transpose().ok()?;
        Some(Self { formula, number })
    }

    /// The names that the formula holds.
    pub fn names(&self) -> &[String] {
        self.formula.var_names()
    }

    /// The number, where the cell holds no names.
    pub fn number(&self) -> Option<f64> {
        self.number
    }

    /// Whether both cells hold the same text.
    pub fn is(&self, other: &Self) -> bool {
        self.formula.unparse() == other.formula.unparse()
    }

    /// The bound for these values of [`Statement::names`], in their order.
    pub fn eval(&self, values: &[f64]) -> f64 {
        let eval = || self.formula.eval(values).expect("a value for each name");
        self.number.unwrap_or_else(eval)
    }
}

#[test]
fn cells_are_read_as_written() {
    let read = |cell, values: &[f64]| Statement::parse(cell).map(|s| s.eval(values));
    assert_eq!(read("1.3e-7", &[]), Some(1.3e-7));
    let cells =
        ["3e-7 + 2*s", "3e-7 + 2·s", "3e-7 + 3*s"].map(|cell| Statement::parse(cell).unwrap());
    assert!(cells[0].is(&cells[1]) && !cells[0].is(&cells[2]));
    assert_eq!(read("3e-7 + 2*s", &[1e-3]), Some(3e-7 + 2e-3));
    assert_eq!(read("2·s + 3·r", &[5.0, 7.0]), Some(29.0));
    assert_eq!(read("max(b, 2*a)/4", &[3.0, 5.0]), Some(1.5));
    assert_eq!(Statement::parse("2*s + r").unwrap().names(), ["r", "s"]);
    assert!(Statement::parse("2*s").unwrap().number().is_none());
    assert!(Statement::parse("twice + ").is_none() && Statement::parse("2e").is_none());
}

// Why a bound that is stated holds.

/// What the last column of a table of errors says.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Kind {
    /// By an argument, for all inputs.
    Proven,
    /// All inputs have been tried.
    Exhaustive,
    /// No search has met more, and there is a margin over the worst that one met.
    Found,
}

impl Kind {
    pub fn parse(cell: &str) -> Option<Self> {
        let kinds = [Self::Proven, Self::Exhaustive, Self::Found];
        kinds.into_iter().find(|kind| kind.name() == cell)
    }

    pub fn name(self) -> &'static str {
        match self {
            Self::Proven => "proven",
            Self::Exhaustive => "exhaustive",
            Self::Found => "found",
        }
    }

    /// The least part of such a bound that the worst case known reaches: a bound that is larger is too large.
    pub fn least(self) -> f64 {
        match self {
            Self::Proven | Self::Exhaustive => 1.0 / 2.0,
            Self::Found => 1.0 / 2.5,
        }
    }

    /// The largest part of such a bound that a case kept from a search may reach: what is found has a margin.
    pub fn most(self) -> f64 {
        match self {
            Self::Proven | Self::Exhaustive => 1.0,
            Self::Found => 1.0 / 1.3,
        }
    }
}
