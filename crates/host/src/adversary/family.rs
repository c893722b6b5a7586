//! What the adversary attacks: families of samplers as raw words.

use super::words::Kind;
use crate::docs;

/// Four uniforms as raw words; those a sampler does not take are 0.
pub type Uniforms = [u32; 4];

/// Receives the row, the error found and the bound stated for it.
pub type Observe<'a> = dyn FnMut(usize, f64, f64) + 'a;

/// A sampler with parameters that its constructor has accepted.
pub trait Case {
    /// Measures all errors at one point. An error counts against the bound of its row; NaN is infinitely wrong.
    fn judge(&self, u: Uniforms, observe: &mut Observe);
}

/// Builds a sampler from its parameters; nothing where the constructor refuses them.
pub type Build = dyn Fn(&[u32]) -> Option<Box<dyn Case>> + Send + Sync;

/// Everything that one constructor accepts, in one tier or grade.
pub struct Family {
    /// Unique, without commas or semicolons: `"Power decreasing poly"`.
    pub label: String,
    /// Families of one statement are held to it together: `"Power poly"`.
    pub statement: String,
    pub parameters: Vec<Kind>,
    pub uniforms: Vec<Kind>,
    /// The titles of the rows, by the index that [`Case::judge`] gives.
    pub rows: Vec<String>,
    /// Their kinds; what does not say one is found.
    pub kinds: Vec<docs::Kind>,
    pub build: Box<Build>,
    /// Parameters that someone has listed, to start from.
    pub seeds: Vec<Vec<u32>>,
}
