//! Directions about +z turned onto a normal, and back.

use crate::buffers::Buffers;
use crate::parts::{NOT_LINKED, linked};
use microwarp::warp::Frame;

/// Turns the direction behind a normal, both in the input, about that normal to the output; or `back`. 0, or the code of the refusal.
#[unsafe(no_mangle)]
pub extern "C" fn turn(buffers: &mut Buffers, back: bool) -> u32 {
    if !const { linked("frames") } {
        return NOT_LINKED;
    }
    let ([a, b, c, x, y, z, ..], [i, j, k, ..]) = (&buffers.input, &mut buffers.output);
    let [normal, direction] = [[a, b, c], [x, y, z]].map(|bits| bits.map(|&x| f32::from_bits(x)));
    let turned = match Frame::new(normal) {
        Ok(frame) if back => frame.to_local(direction),
        Ok(frame) => frame.to_world(direction),
        Err(refusal) => return refusal.code().into(),
    };
    [*i, *j, *k] = turned.map(f32::to_bits);
    0
}
