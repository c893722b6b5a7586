//! The scenes behind plain exports that take and return numbers. A picture has two halves, each a picture of its own seed:
//! their mean is shown, and half of their difference is its error.
#![no_std]
#![allow(unsafe_code)]

use microwarp_scene::golden::PLAN;
use microwarp_scene::numbered::{HALVES, MOST, POINTS, Request, SCENES, TIERS, row};
use microwarp_scene::vector::Vector;
use microwarp_scene::{Hash, Plan};

microwarp_list::import_panic!();

/// Both sides know this layout.
#[repr(C)]
pub struct Shared {
    halves: [[Vector; MOST as usize]; HALVES as usize],
    /// Scene, tier and points; columns, rows and samples; the seed of the first half.
    request: [u32; 7],
    /// Why a row was refused.
    text: [u8; 64],
}

/// The one instance.
fn shared() -> &'static mut Shared {
    static mut SHARED: Shared = Shared {
        halves: [[[0.0; 3]; MOST as usize]; HALVES as usize],
        request: [0; 7],
        text: [0; 64],
    };
    // SAFETY: a module instance has one thread, each export takes this once, and none calls another.
    unsafe { &mut *core::ptr::addr_of_mut!(SHARED) }
}

const START: [u32; 7] = {
    let [width, height] = PLAN.size;
    [0, 1, 3, width, height, PLAN.samples, PLAN.seed]
};

/// Where the shared memory is, with the request for a picture of the golden table in it.
#[unsafe(no_mangle)]
pub extern "C" fn shared_memory() -> *const Shared {
    // Not where it is defined: all of it would then lie in the module as bytes.
    let shared = shared();
    shared.request = START;
    &raw const *shared
}

/// The pixels of a half, or fewer.
#[unsafe(no_mangle)]
pub extern "C" fn most_pixels() -> u32 {
    MOST
}

/// The names of scenes (list 0), tiers (1) and point sets (2), an empty one behind the last.
fn named(list: usize, number: usize) -> &'static str {
    let lists: [&[&str]; 3] = [&SCENES, &TIERS, &POINTS];
    let name = lists.get(list).and_then(|names| names.get(number));
    name.copied().unwrap_or("")
}

#[unsafe(no_mangle)]
pub extern "C" fn name(list: usize, number: usize) -> *const u8 {
    named(list, number).as_ptr()
}

/// How many bytes that has.
#[unsafe(no_mangle)]
pub extern "C" fn name_length(list: usize, number: usize) -> usize {
    named(list, number).len()
}

/// Renders a row of one half of the picture that is requested. Returns 0, or how many bytes of the text say why not.
#[unsafe(no_mangle)]
pub extern "C" fn render(half: u32, line: u32) -> usize {
    let Shared {
        halves,
        request: [scene, tier, points, width, height, samples, seed],
        text,
    } = shared();
    let plan = Plan {
        size: [*width, *height],
        samples: *samples,
        seed: seed.wrapping_add(half),
    };
    let picture = Request {
        scene: *scene,
        tier: *tier,
        points: *points,
        plan,
    };
    let start = line.wrapping_mul(*width) as usize;
    let end = start.wrapping_add(*width as usize);
    let pixels = halves.get_mut(half as usize);
    let colours = pixels.and_then(|pixels| pixels.get_mut(start..end));
    match row(&picture, line, colours.unwrap_or_default()) {
        Ok(()) => 0,
        Err(refusal) => {
            let message = refusal.message().as_bytes();
            let bytes = text.iter_mut().zip(message);
            bytes.map(|(slot, byte)| *slot = *byte).count()
        }
    }
}

/// The hash of a half.
#[unsafe(no_mangle)]
pub extern "C" fn hash(half: usize) -> u32 {
    let Shared {
        halves, request, ..
    } = shared();
    let [.., width, height, _, _] = *request;
    let picture = halves.get(half).into_iter().flatten();
    let colours = picture.take(width.wrapping_mul(height) as usize);
    colours
        .fold(Hash::EMPTY, |hash, colour| hash.with(*colour))
        .word()
}
