//! The C interface of `bindings/c` as text: the headers, the sizes of its structs, and the table of its golden test. All
//! come from the lists of `crates/list`, the crate's documentation, and what is not a warp from a template.

mod bound;
mod call;
mod comments;
mod declare;
mod form;
mod golden;
mod header;
mod hostile;
mod made;

pub use golden::golden;
pub use header::{HEADERS, LAYOUT, headers, layout};
pub use hostile::hostile;
