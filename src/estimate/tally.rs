//! How many samples were taken in, and how many were refused.

/// Two counts that never wrap: a sample for which the first has no room goes to the second.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(crate) struct Tally {
    count: u64,
    refused: u64,
}

impl Tally {
    pub(crate) const NOTHING: Self = Self {
        count: 0,
        refused: 0,
    };

    #[inline]
    pub(crate) const fn count(self) -> u64 {
        self.count
    }

    #[inline]
    pub(crate) const fn refused(self) -> u64 {
        self.refused
    }

    /// Counts a sample, and says whether to take it in: if it is sound and there is room.
    #[inline]
    pub(crate) const fn admits(&mut self, sound: bool) -> bool {
        let admitted = sound && self.count < u64::MAX;
        if admitted {
            self.count = self.count.saturating_add(1);
        } else {
            self.refused = self.refused.saturating_add(1);
        }
        admitted
    }

    /// The sum of two tallies; or, if there is no room, this one with all samples of the other refused.
    pub(crate) const fn joined(self, other: Self) -> Result<Self, Self> {
        let refused = self.refused.saturating_add(other.refused);
        match self.count.checked_add(other.count) {
            Some(count) => Ok(Self { count, refused }),
            None => Err(Self {
                count: self.count,
                refused: refused.saturating_add(other.count),
            }),
        }
    }
}
