//! The bytes of a module.

use crate::Failure;
use wasmparser::{Parser, Payload};

/// The bytes of a module without those of its data, and those.
pub fn sizes(module: &[u8]) -> Result<String, Failure> {
    let mut data = 0;
    for payload in Parser::new(0).parse_all(module) {
        if let Payload::DataSection(segments) = payload? {
            for segment in segments {
                data += segment?.data.len();
            }
        }
    }
    Ok(format!("{} {data}", module.len() - data))
}
