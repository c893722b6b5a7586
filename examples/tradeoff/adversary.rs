//! How the tests read a bound that may be a formula.

#[allow(dead_code, reason = "the tests use the rest")]
#[path = "../../tests/adversary/statement.rs"]
pub mod statement;
