//! Prints golden bits, row by row as they stand in `tests/golden/golden.csv`.
//!
//! All of them together, every function of the crate in every tier, are more than the 256 KB of the smaller board; so
//! the program is built twice for each float tier, and once for the integers.

use crate::board::{exit, print};
use core::fmt::{Error, Write};
use microwarp_list::{
    Golden, cases, describe, evaluate_first_half, evaluate_fixed, evaluate_second_half, fixed,
};

/// Some of a tier: its first case, how many it has, and what evaluates them, counted from 0.
pub struct Part {
    first: usize,
    count: usize,
    evaluate: fn(usize, &mut [u32; 16]) -> usize,
}

impl Part {
    /// The first half of a float tier.
    pub fn first_half<T: Golden>() -> Self {
        Self {
            first: T::first(),
            count: T::cases_of_half(),
            evaluate: evaluate_first_half::<T>,
        }
    }

    /// The second half of a float tier.
    pub fn second_half<T: Golden>() -> Self {
        Self {
            first: T::first() + T::cases_of_half(),
            count: T::cases() - T::cases_of_half(),
            evaluate: evaluate_second_half::<T>,
        }
    }

    /// The integer tier.
    pub fn integers() -> Self {
        Self {
            first: cases() - fixed::cases(),
            count: fixed::cases(),
            evaluate: evaluate_fixed,
        }
    }

    /// Prints all its rows, and ends.
    pub fn run(&self) -> ! {
        exit(
            (0..self.count)
                .try_for_each(|index| self.row(index))
                .is_ok(),
        )
    }

    /// Prints a row in one piece: a call of the host costs much more than a byte.
    fn row(&self, index: usize) -> Result<(), Error> {
        let mut words = [0; 16];
        let len = (self.evaluate)(index, &mut words);
        let (name, input, tier) = describe(self.first + index);
        let mut row = heapless::String::<256>::new();
        write!(row, "{tier} {name} #{input}")?;
        for word in words.iter().take(len) {
            write!(row, ",{word:08x}")?;
        }
        writeln!(row)?;
        print(&row);
        Ok(())
    }
}
