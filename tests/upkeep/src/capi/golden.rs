//! The table of the golden test in C.

pub fn golden() -> String {
    String::new()
}
