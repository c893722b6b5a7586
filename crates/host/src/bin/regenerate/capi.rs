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

use super::same;
use header::{HEADERS, LAYOUT, headers, layout};
use microwarp_host::upkeep::{Outcome, read, write};

/// The headers of the C interface, and the sizes that every target is held to.
pub fn step(check: bool) -> Outcome {
    let paths = HEADERS.map(|(path, _)| path).into_iter();
    for (path, text) in paths.zip(headers()?).chain([(LAYOUT, layout())]) {
        let changed = text.replacen("_disk", "_disc", 1);
        if changed == text || same(path, &changed, &text).is_ok() {
            return Err(format!("control: a changed line of {path} passes"));
        }
        if check {
            same(path, &read(path)?, &text)?;
        } else {
            write(path, &text)?;
        }
    }
    Ok(())
}

/// Prints what the tests of `bindings/c` include.
pub fn print(part: &str) -> Outcome {
    let text = match part {
        "golden" => golden::golden(),
        "hostile" => hostile::hostile()?,
        _ => return Err("name a part: golden or hostile".into()),
    };
    print!("{text}");
    Ok(())
}
