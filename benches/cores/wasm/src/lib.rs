//! What a function costs as WASM: counts the operators that it executes, and reads the sizes of its module.

mod count;
mod instrument;
mod sizes;

pub use count::measure;
pub use sizes::sizes;

/// Whatever went wrong, for people.
pub type Failure = Box<dyn std::error::Error>;
