//! Several items of a stream by weight, in places of the caller: each holds an item, in the order in which they would be drawn.

use crate::error::{Code, code};
use crate::generators::{Pcg32, Source};
use crate::warps::{as_declared, given, memory};
use core_crate::discrete::WeightedReservoir;
use rand_core::{Rng, TryRng};

/// `mw_weighted_place`: a reservoir of one item.
type Place = WeightedReservoir<u32, 1>;

const _: () = as_declared::<Place>(&["mw_weighted_place"]);

/// `mw_weighted_reservoir`
#[repr(C)]
#[derive(Clone, Copy)]
struct Handle {
    places: *mut Place,
    count: usize,
}

impl Handle {
    /// # Safety
    /// The places are valid for reads and writes, and for nobody else as long as they are used.
    #[inline]
    unsafe fn places(self) -> &'static mut [Place] {
        // SAFETY: the caller's promise.
        unsafe { memory(self.places, self.count) }
    }
}

/// Puts an item in its place, if it is early enough, behind those of the same time. Those from there on move one place to the end.
#[inline]
fn take(places: &mut [Place], new: Place) -> bool {
    let Some(&last) = places.last() else {
        return false;
    };
    let mut tried = last;
    tried.merge(new);
    if tried == last {
        return false;
    }
    let (mut passed, mut moving) = (new, false);
    for place in places {
        let mut tried = *place;
        tried.merge(new);
        moving = moving || tried != *place;
        if moving {
            passed = core::mem::replace(place, passed);
        }
    }
    true
}

#[inline]
fn offered(places: &mut [Place], item: u32, weight: u32, word: u32) -> bool {
    let mut one = Place::new();
    one.offer_with(item, weight, word);
    take(places, one)
}

#[unsafe(export_name = "mw_weighted_reservoir_init")]
unsafe extern "C" fn init(reservoir: &mut Handle, places: *mut Place, count: usize) {
    *reservoir = Handle { places, count };
    // SAFETY: the promise of the header.
    unsafe { reservoir.places() }.fill(Place::new());
}

#[unsafe(export_name = "mw_weighted_reservoir_offer_with")]
unsafe extern "C" fn offer_with(reservoir: &mut Handle, item: u32, weight: u32, word: u32) -> bool {
    // SAFETY: the promise of the header.
    offered(unsafe { reservoir.places() }, item, weight, word)
}

#[unsafe(export_name = "mw_weighted_reservoir_offer")]
unsafe extern "C" fn offer(
    reservoir: &mut Handle,
    item: u32,
    weight: u32,
    rng: &mut Pcg32,
) -> bool {
    // SAFETY: the promise of the header.
    offered(unsafe { reservoir.places() }, item, weight, rng.next_u32())
}

#[unsafe(export_name = "mw_weighted_reservoir_offer_from")]
unsafe extern "C" fn offer_from(
    reservoir: &mut Handle,
    item: u32,
    weight: u32,
    source: &Source,
    taken: &mut bool,
) -> Code {
    // SAFETY: the promise of the header.
    let places = unsafe { reservoir.places() };
    code({ *source }.try_next_u32(), |word| {
        *taken = offered(places, item, weight, word);
    })
}

/// # Safety
/// Both are valid for reads, and may be one.
#[unsafe(export_name = "mw_weighted_reservoir_merge")]
unsafe extern "C" fn merge(reservoir: *const Handle, other: *const Handle) {
    // SAFETY: the caller's promise.
    let (reservoir, other) = unsafe { (*reservoir, *other) };
    // It holds what it holds.
    if reservoir.places == other.places {
        return;
    }
    // SAFETY: the promise of the header. The places of two reservoirs are apart.
    let (places, others) = unsafe { (reservoir.places(), given(other.places, other.count)) };
    for other in others {
        take(places, *other);
    }
}

#[unsafe(export_name = "mw_weighted_reservoir_item")]
unsafe extern "C" fn item(reservoir: &Handle, place: usize, item: &mut u32) -> bool {
    // SAFETY: the promise of the header.
    let places = unsafe { given(reservoir.places, reservoir.count) };
    let held = places.get(place).and_then(|held| held.items().next());
    if let Some(&held) = held {
        *item = held;
    }
    held.is_some()
}
