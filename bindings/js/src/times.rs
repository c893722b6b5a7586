//! When items of a weighted reservoir come. The caller keeps the items by their times.

use crate::buffers::Buffers;
use crate::parts::{NOT_LINKED, linked};
use microwarp::discrete::WeightedReservoir;

const TIMES: bool = linked("reservoirs");

/// A time as a reservoir of one item has it, which is the same for all.
type Time = WeightedReservoir<u32, 1>;

/// Its words, of which any are a time.
type Words = [u32; 4];
const _: () = assert!(size_of::<Time>() == size_of::<Words>());

/// Puts the time of an item of a positive weight by a word into the input; or, of weight 0, says whether the first time in the
/// input comes before the second: a reservoir of one item that has the second takes the first. Where this is not linked, no time is made.
#[unsafe(no_mangle)]
pub extern "C" fn earlier(buffers: &mut Buffers, weight: u32, word: u32) -> u32 {
    if !TIMES {
        return NOT_LINKED;
    }
    let times = buffers.input.as_mut_ptr().cast::<Time>();
    if weight > 0 {
        let mut time = Time::new();
        time.offer_with(0, weight, word);
        // SAFETY: the buffer is as long.
        unsafe { times.write_unaligned(time) };
        return 0;
    }
    // SAFETY: the buffer is as long. A weight of 0 says that there is no item, and any other numbers are one.
    let (first, second) = unsafe { (times.read_unaligned(), times.add(1).read_unaligned()) };
    let mut held = second;
    held.merge(first);
    (held != second).into()
}
