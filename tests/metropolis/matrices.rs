//! Exact transition matrices of the implemented step.
