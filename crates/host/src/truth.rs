//! What each warp should do, in `f64`, written from the definitions and not from the crate's code; and the same in 237 bits.
//!
//! The formulas stand once, in `truth/all.rs` and its files, over a type `Real`. `double` and `precise` are that text with either type
//! in its place, so that the second shows how much of a truth the rounding of the first has cost.

pub mod double;
pub mod precise;

pub use double::*;

use std::cell::Cell;
use std::sync::Arc;

thread_local! {
    /// Whether `both!` takes the precise one, and how often it has.
    static PRECISE: Cell<Option<usize>> = const { Cell::new(None) };
}

/// What is made of an entry where each of its truths is the precise one, rounded to `f64` at the end; and of how many there is one.
pub fn precisely<T>(make: impl FnOnce() -> T) -> (T, usize) {
    PRECISE.set(Some(0));
    let made = make();
    (made, PRECISE.take().unwrap_or(0))
}

/// Whether it is the precise truth that is asked for. It counts as made.
pub fn is_precise() -> bool {
    PRECISE.set(PRECISE.get().map(|made| made + 1));
    PRECISE.get().is_some()
}

/// The truth that is asked for, of its text over a `Real`: in doubles, or the precise one.
macro_rules! exact {
    ($truth:expr) => {
        if $crate::truth::is_precise() {
            #[allow(unused_imports, reason = "not every text names a `Real`")]
            use $crate::truth::precise::*;
            let truth = std::sync::Arc::new($truth);
            std::sync::Arc::new($crate::truth::Rounded(truth))
                as std::sync::Arc<dyn $crate::truth::double::Truth>
        } else {
            #[allow(unused_imports, reason = "not every text names a `Real`")]
            use $crate::truth::double::*;
            std::sync::Arc::new($truth)
        }
    };
}
pub(crate) use exact;

/// A precise truth behind the interface of `f64`.
pub struct Rounded(pub Arc<dyn precise::Truth>);

impl Truth for Rounded {
    fn sample(&self, u: Uniforms) -> Point {
        self.0.sample(u.map(precise::real)).map(precise::to_f64)
    }
    fn pdf(&self, x: Point) -> f64 {
        precise::to_f64(self.0.pdf(x.map(precise::real)))
    }
    fn density(&self, u: Uniforms) -> f64 {
        precise::to_f64(self.0.density(u.map(precise::real)))
    }
    fn invert(&self, x: Point) -> Uniforms {
        self.0.invert(x.map(precise::real)).map(precise::to_f64)
    }
    fn fourth(&self, u: Uniforms) -> Option<f64> {
        self.0.fourth(u.map(precise::real)).map(precise::to_f64)
    }
}
