//! Canonical uniforms, integers and chances, and the point sets that yield words.

mod canonical;
mod chance;
mod points;
mod range;
