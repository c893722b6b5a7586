//! Parameters and uniforms that are hard for a warp: those that the registry of the tests lists, and the worst that their
//! adversary has found. `run` has `cargo test --test accuracy hard` write them before a sweep.

const TEXT: &str = include_str!(env!("CORES_HARD"));

/// One line. Parameters are there where the constructor is named, uniforms where the adversary found some.
pub struct Line {
    pub constructor: &'static str,
    parameters: &'static str,
    uniforms: &'static str,
}

impl Line {
    pub fn parameters(&self) -> impl Iterator<Item = u32> + use<> {
        words(self.parameters)
    }

    pub fn uniforms(&self) -> impl Iterator<Item = u32> + use<> {
        words(self.uniforms)
    }
}

fn words(text: &'static str) -> impl Iterator<Item = u32> {
    let words = text.split_ascii_whitespace();
    words.map_while(|word| u32::from_str_radix(word, 16).ok())
}

/// The lines of a warp.
pub fn lines(warp: &'static str) -> impl Iterator<Item = Line> {
    TEXT.lines().filter_map(move |line| {
        let mut cells = line.strip_prefix(warp)?.strip_prefix(';')?.split(';');
        Some(Line {
            constructor: cells.next()?,
            parameters: cells.next()?,
            uniforms: cells.next()?,
        })
    })
}
