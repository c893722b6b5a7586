//! Words over the whole range and at its edges: what might take longest.

use rand_core::Rng;
use rand_pcg::Pcg32;

/// Powers of two, what lies below one, and these seen from the upper end; eighths and what lies beside them on the
/// 24-bit grid; thirds.
const EDGES: [u32; 123] = {
    let mut edges = [0; 123];
    let mut i = 0;
    while i < 32 {
        edges[i] = 1 << i;
        edges[32 + i] = (1 << i) - 1;
        edges[64 + i] = !((1 << i) - 1);
        if i < 8 {
            let eighth = (i as u32) << 29;
            edges[96 + 3 * i] = eighth.wrapping_sub(0x100);
            edges[97 + 3 * i] = eighth;
            edges[98 + 3 * i] = eighth + 0x100;
        }
        i += 1;
    }
    edges[120] = u32::MAX;
    edges[121] = u32::MAX / 3;
    edges[122] = u32::MAX / 3 * 2;
    edges
};

/// Input `axis` of `axes` of a call, of which there are 2^16. A quarter each: all pairs of edges, or random edges of
/// more than two inputs; an edge among random words; one input in strata; random words drawn towards 0 or 1.
pub fn word(random: &mut Pcg32, call: u32, axis: usize, axes: usize) -> u32 {
    let (count, axes) = (EDGES.len() as u32, axes as u32);
    let (of_four, number) = (call % 4, call / 4);
    let any = random.next_u32();
    let here = number % axes == axis as u32;
    match of_four {
        0 if axes <= 2 => EDGES[(number / count.pow(axis as u32) % count) as usize],
        0 => EDGES[(any % count) as usize],
        1 if here => EDGES[(number / axes % count) as usize],
        2 if here => (number / axes * (axes << 18)).wrapping_add(any % (axes << 18)),
        3 => {
            let towards = random.next_u32();
            let small = any >> (towards % 32);
            if towards >> 31 == 0 { small } else { !small }
        }
        _ => any,
    }
}

// Parameters and uniforms that are hard for a warp: those that the registry of the tests lists, and the worst that their
// adversary has found. `run` has `cargo test --test accuracy hard` write them before a sweep.

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
