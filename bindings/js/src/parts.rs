//! A smaller module: with the parts alone that are named when it is built.

/// What is said of a part that the module does not have; no error has this code.
pub const NOT_LINKED: u32 = 31;

/// The names of warps in the list, and `indices`, `pieces`, `points`, `frames`, `chains`, `counts`, `rejections`, `reservoirs`,
/// `densities`, `mixtures` and `lights`, with spaces between; without it the module has everything.
const PARTS: Option<&str> = option_env!("MICROWARP_PARTS");

/// Whether the module has a part. It is known at compile time, so nothing else is linked.
pub const fn linked(part: &str) -> bool {
    let Some(parts) = PARTS else { return true };
    let (parts, part) = (parts.as_bytes(), part.as_bytes());
    let mut start = 0;
    while start < parts.len() {
        let mut end = start;
        let mut same = true;
        while end < parts.len() && parts[end] != b' ' {
            same = same && end - start < part.len() && parts[end] == part[end - start];
            end += 1;
        }
        if same && end - start == part.len() {
            return true;
        }
        start = end + 1;
    }
    false
}
