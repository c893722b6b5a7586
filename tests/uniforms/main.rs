//! Canonical uniforms, and the point sets that yield them.

mod canonical;
mod points;
