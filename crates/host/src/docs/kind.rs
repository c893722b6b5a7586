//! Why a bound that is stated holds.

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
}
