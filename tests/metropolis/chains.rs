//! The chain as a value: counts, refusals, limits, exact restoring, saving and resuming, its size.
