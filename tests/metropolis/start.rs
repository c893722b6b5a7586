//! The start-up bias and its two cures.
