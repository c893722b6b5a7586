//! The bytes of a module.

use crate::Failure;
use wasmparser::{Parser, Payload};

/// The bytes of a module without those of its data, and those. Names and other notes, which nothing reads at run
/// time, are left out.
pub fn sizes(module: &[u8]) -> Result<String, Failure> {
    let (mut notes, mut data) = (0, 0);
    for payload in Parser::new(0).parse_all(module) {
        match payload? {
            Payload::CustomSection(note) => {
                // Its kind and its size come before it.
                let size = note.range().len();
                let digits = size.max(1).ilog2() as usize / 7 + 1;
                notes += 1 + digits + size;
            }
            Payload::DataSection(segments) => {
                for segment in segments {
                    data += segment?.data.len();
                }
            }
            _ => {}
        }
    }
    Ok(format!("{} {data}", module.len() - notes - data))
}
