//! The cost of a function as WASM: counts the operators that it executes, and reads the sizes of its module.

mod count;
mod instrument;
mod sizes;

pub use count::measure;
pub use sizes::sizes;

/// Any error, for display.
pub type Failure = Box<dyn std::error::Error>;
