//! Turning directions about +z onto a normal, and back.

use crate::error::{Code, code};
use crate::value::Value;
use crate::warps::as_declared;
use core_crate::warp::Frame;

type Direction = [f32; 3];

const _: () = as_declared::<Frame>(&["mw_frame"]);

#[unsafe(export_name = "mw_frame_init")]
unsafe extern "C" fn init(frame: *mut Frame, normal: *const Direction) -> Code {
    // SAFETY: the promise of the header.
    unsafe {
        code(Frame::new(Direction::read(normal)), |made| {
            frame.write(made)
        })
    }
}

#[unsafe(export_name = "mw_frame_to_world")]
unsafe extern "C" fn to_world(frame: &Frame, local: *const Direction, world: *mut Direction) {
    // SAFETY: the promise of the header.
    unsafe { world.write(frame.to_world(Direction::read(local))) }
}

#[unsafe(export_name = "mw_frame_to_local")]
unsafe extern "C" fn to_local(frame: &Frame, world: *const Direction, local: *mut Direction) {
    // SAFETY: the promise of the header.
    unsafe { local.write(frame.to_local(Direction::read(world))) }
}
