//! What a chain asks of a value of its target and of a Hastings ratio: whether they are positive.

/// Whether a chain can be at a state, or can take a proposal.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Standing {
    /// It can.
    Positive,
    /// It cannot.
    Zero,
    /// The number is not a valid density, weight or ratio.
    Unsound,
}

impl Standing {
    /// Judges a density in `f32`.
    #[inline]
    pub(super) const fn of_density(x: f32) -> Self {
        if x > 0.0 && x <= f32::MAX {
            Self::Positive
        } else if x == 0.0 {
            Self::Zero
        } else {
            Self::Unsound
        }
    }

    /// Judges a product.
    #[inline]
    pub(super) const fn and(self, other: Self) -> Self {
        match (self, other) {
            (Self::Unsound, _) | (_, Self::Unsound) => Self::Unsound,
            (Self::Zero, _) | (_, Self::Zero) => Self::Zero,
            (Self::Positive, Self::Positive) => Self::Positive,
        }
    }
}
