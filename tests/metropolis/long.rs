//! A hundred million steps.
