//! Canonical uniforms, integers, chances and orders, and the point sets that yield words.

mod canonical;
mod chance;
mod orders;
mod points;
mod range;
