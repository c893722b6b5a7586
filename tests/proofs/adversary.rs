//! How a stated bound is read, of what the adversary has.

#[allow(dead_code, reason = "no formula is evaluated here")]
#[path = "../adversary/statement.rs"]
pub mod statement;
