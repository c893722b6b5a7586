//! Calls with inputs from the whole range and its edges, with the worst that the tests know, and with warps of other
//! parameters, for the plugin that counts each call by itself.

use crate::measured::count::{CALLS, CHUNKS, Entry, Vary, fill, run};
use crate::measured::edges;
use crate::measured::edges::{Line, lines};
use rand_pcg::Pcg32;

/// Of 64 calls each: 2^16 calls.
const BATCHES: u32 = 65536 / CALLS as u32;
/// An odd number, which takes the calls of each set of parameters from all over the sweep.
const SCATTER: u32 = 40503;
/// Sets of parameters where none are listed.
const DRAWN: u32 = 32;

/// The warp of the first parameters that there are, whose calls are counted.
pub fn prepare(entry: &Entry) {
    if entry.vary.is_some() && varied(entry, &mut |_| false) == 0 {
        panic!("no parameters");
    }
}

/// As many calls as there are, or until 2^30 cycles have gone.
pub fn sweep(entry: &Entry) {
    let (mut batch, mut spent) = (0, 0_u64);
    if entry.inputs.is_empty() && !entry.warp.is_empty() {
        // A warp that draws is swept where its uniforms are given.
        return;
    }
    let goes_on = |batch: u32, spent: u64| batch < BATCHES && spent >> 30 == 0;
    if entry.vary.is_none() {
        for line in lines(entry.warp) {
            spent += worst(entry, &line);
        }
        while goes_on(batch, spent) {
            spent += spread(entry, batch, 1);
            batch += 1;
        }
        return;
    }
    let (mut rounds, mut any) = (0, true);
    while any && goes_on(batch, spent) {
        varied(entry, &mut |line| {
            if let (Some(line), 0) = (line, rounds) {
                spent += worst(entry, line);
            }
            spent += spread(entry, batch, SCATTER);
            batch += 1;
            any = goes_on(batch, spent);
            any
        });
        rounds += 1;
    }
}

/// Makes the warp of each set of parameters that is accepted, and says by which line, as long as more are wanted; returns
/// how many there were.
fn varied(entry: &Entry, each: &mut dyn FnMut(Option<&Line>) -> bool) -> u32 {
    let Some(vary) = &entry.vary else { return 0 };
    let mut sets = 0;
    for line in lines(entry.warp) {
        let mut words = line.parameters();
        let made = (vary.make)(line.constructor, &mut words).is_some();
        // What is left is of another constructor of that name.
        if made && words.next().is_none() {
            sets += 1;
            if !each(Some(&line)) {
                return sets;
            }
        }
    }
    if sets == 0 { drawn(vary, each) } else { sets }
}

/// The same with words drawn as uniforms are, where no parameters are listed.
fn drawn(vary: &Vary, each: &mut dyn FnMut(Option<&Line>) -> bool) -> u32 {
    let mut random = Pcg32::new(1, 1);
    let (mut sets, mut tries) = (0, 0);
    while sets < DRAWN && tries < 64 * DRAWN {
        let constructor = vary.constructors[tries as usize % vary.constructors.len()];
        let call = tries;
        let mut axis = 0;
        let mut words = core::iter::from_fn(|| {
            axis += 1;
            Some(edges::word(&mut random, call, axis - 1, 3))
        });
        if (vary.make)(constructor, &mut words).is_some() {
            sets += 1;
            if !each(None) {
                break;
            }
        }
        tries += 1;
    }
    sets
}

/// A batch of words over the whole range and at its edges.
fn spread(entry: &Entry, batch: u32, factor: u32) -> u64 {
    let axes = entry.inputs.len();
    fill(entry, CHUNKS + batch, |random, index| {
        let call = (batch * CALLS as u32 + (index / axes) as u32).wrapping_mul(factor) % 65536;
        entry.inputs[index % axes](edges::word(random, call, index % axes, axes))
    });
    u64::from(run(entry, entry.kernel).0)
}

/// A batch of the worst uniforms of a line, as they are.
fn worst(entry: &Entry, line: &Line) -> u64 {
    if line.uniforms().next().is_none() || entry.inputs.is_empty() {
        return 0;
    }
    let axes = entry.inputs.len();
    fill(entry, 0, |_, index| {
        line.uniforms().nth(index % axes).unwrap_or(0)
    });
    u64::from(run(entry, entry.kernel).0)
}
