//! Continuous targets, with controls that must be rejected.
