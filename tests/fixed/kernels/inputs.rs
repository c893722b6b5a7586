//! The words over which kernels are tried, in chunks that threads can share.

use host::cli::{STEPS, progress};
use host::parallel::{in_parallel, threads};
use host::speed;
pub use host::words::edges;

/// A part of the words: `2^bits` of them from 0 on, one of every `stride`, and the edges.
#[derive(Clone, Copy, Debug)]
pub struct Words {
    pub bits: u32,
    pub stride: u32,
}

/// Words in a chunk.
const CHUNK: u32 = 1 << 20;

impl Words {
    /// One of every so many words in the quick speed and in the full; all 2³² where they were asked for.
    pub fn every(quick: u32, full: u32) -> Self {
        Self::all_or(1, quick, full)
    }

    /// Likewise, and where all were asked for one of every `all`.
    pub fn all_or(all: u32, quick: u32, full: u32) -> Self {
        let stride = speed::or_all("one word tried of every", quick, full, all);
        Self { bits: 32, stride }
    }

    fn chunks(self) -> u32 {
        1 << (self.bits - 20)
    }

    /// Hands every word of a chunk to `each`: the first of every stride is followed by one at another place in it.
    fn for_each(self, chunk: u32, mut each: impl FnMut(u32)) {
        let base = chunk * CHUNK;
        for i in 0..CHUNK / self.stride {
            // The leading bits of a multiple of an odd number: no two strides in a row are tried at the same place.
            let place = i.wrapping_add(chunk).wrapping_mul(0x9e37_79b9);
            let place = (u64::from(place) * u64::from(self.stride)) >> 32;
            each(base + i * self.stride + place as u32);
        }
    }

    /// Folds all words, a state for each chunk, on as many threads as there are cores; the states are in the order
    /// of the chunks. The last of them is that of the edges.
    pub fn fold<S: Send>(
        self,
        what: &str,
        edges: &[u32],
        state: impl Fn() -> S + Sync,
        step: impl Fn(&mut S, u32) + Sync,
    ) -> Vec<S> {
        let bar = progress(self.chunks().into(), STEPS).unwrap();
        bar.set_message(what.to_owned());
        let chunks: Vec<u32> = (0..self.chunks()).collect();
        let mut states = in_parallel(threads(), &chunks, |&chunk| {
            let mut folded = state();
            self.for_each(chunk, |word| step(&mut folded, word));
            bar.inc(1);
            folded
        });
        bar.finish_and_clear();
        let mut at_edges = state();
        edges.iter().for_each(|&word| step(&mut at_edges, word));
        states.push(at_edges);
        states
    }
}
