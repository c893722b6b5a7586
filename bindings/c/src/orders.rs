//! Orders of items of any size, choices, permutations, Latin hypercubes and the order of a picture.

use crate::error::{Code, code};
use crate::generators::{Pcg32, Source};
use crate::warps::{as_declared, makers};
use core_crate::uniform::{
    ChoiceInOrder, ChoiceOfStream, LatinHypercube, Permutation, Points, Screen, Sobol, choose_with,
    shuffle_with, try_choose_with, try_shuffle_with,
};

/// What exchanges two items of so many bytes.
///
/// # Safety
/// The memory is valid for the items that are exchanged, as long as this is used.
unsafe fn exchange(items: *mut u8, size: usize) -> impl FnMut(usize, usize) {
    move |i, j| {
        let [one, other] = [i, j].map(|item| items.wrapping_add(item.wrapping_mul(size)));
        // SAFETY: the caller's promise, and i is not j.
        unsafe { core::ptr::swap_nonoverlapping(one, other, size) }
    }
}

#[unsafe(export_name = "mw_shuffle")]
unsafe extern "C" fn shuffle(items: *mut u8, count: usize, size: usize, rng: &mut Pcg32) {
    // SAFETY: the promise of the header.
    shuffle_with(count, rng, unsafe { exchange(items, size) });
}

#[unsafe(export_name = "mw_shuffle_from")]
unsafe extern "C" fn shuffle_from(
    items: *mut u8,
    count: usize,
    size: usize,
    source: &Source,
) -> Code {
    // SAFETY: the promise of the header.
    let swap = unsafe { exchange(items, size) };
    code(try_shuffle_with(count, &mut { *source }, swap), drop)
}

#[unsafe(export_name = "mw_choose")]
unsafe extern "C" fn choose(
    items: *mut u8,
    count: usize,
    size: usize,
    chosen: usize,
    rng: &mut Pcg32,
) -> Code {
    // SAFETY: the promise of the header.
    let swap = unsafe { exchange(items, size) };
    code(choose_with(count, chosen, rng, swap), drop)
}

#[unsafe(export_name = "mw_choose_from")]
unsafe extern "C" fn choose_from(
    items: *mut u8,
    count: usize,
    size: usize,
    chosen: usize,
    source: &Source,
) -> Code {
    // SAFETY: the promise of the header.
    let swap = unsafe { exchange(items, size) };
    match try_choose_with(count, chosen, &mut { *source }, swap) {
        Ok(done) => code(done, drop),
        Err(failed) => failed.into(),
    }
}

const _: () = as_declared::<ChoiceInOrder>(&["mw_choice_in_order"]);
const _: () = as_declared::<ChoiceOfStream>(&["mw_choice_of_stream"]);
const _: () = as_declared::<Permutation>(&["mw_permutation"]);
const _: () = as_declared::<LatinHypercube>(&["mw_latin_hypercube"]);
const _: () = as_declared::<Screen<Sobol<8>>>(&["mw_screen"]);

makers! {
    "choice_in_order_init" ChoiceInOrder, (chosen: u32, count: u32) { ChoiceInOrder::new(chosen, count) }
    "choice_of_stream_init" ChoiceOfStream, (places: u32) { ChoiceOfStream::new(places) }
    "permutation_init" Permutation, (count: u32, seed: u32) { Permutation::new(count, seed) }
    "latin_hypercube_init" LatinHypercube, (count: u32, seed: u32) { LatinHypercube::new(count, seed) }
    "screen_init" Screen<Sobol<8>>, (width: u32, height: u32, log2_samples: u32, seed: u32) {
        Sobol::new(seed).and_then(|set| Screen::new(set, [width, height], log2_samples, seed))
    }
}

#[unsafe(export_name = "mw_choice_in_order_take")]
extern "C" fn in_order_take(choice: &mut ChoiceInOrder, word: u32) -> bool {
    choice.take(word)
}

#[unsafe(export_name = "mw_choice_in_order_draw")]
extern "C" fn in_order_draw(choice: &mut ChoiceInOrder, rng: &mut Pcg32) -> bool {
    choice.draw(rng)
}

/// Whether there is a number, which then goes to its place.
fn put(number: Option<u32>, place: &mut u32) -> bool {
    if let Some(number) = number {
        *place = number;
    }
    number.is_some()
}

#[unsafe(export_name = "mw_choice_of_stream_take")]
extern "C" fn of_stream_take(choice: &mut ChoiceOfStream, word: u32, place: &mut u32) -> bool {
    put(choice.take(word), place)
}

#[unsafe(export_name = "mw_choice_of_stream_draw")]
extern "C" fn of_stream_draw(
    choice: &mut ChoiceOfStream,
    rng: &mut Pcg32,
    place: &mut u32,
) -> bool {
    put(choice.draw(rng), place)
}

#[unsafe(export_name = "mw_permutation_get")]
extern "C" fn permutation_get(order: &Permutation, place: u32, number: &mut u32) -> Code {
    code(order.get(place).ok_or(OUTSIDE), |found| *number = found)
}

#[unsafe(export_name = "mw_permutation_index_of")]
extern "C" fn permutation_index_of(order: &Permutation, number: u32, place: &mut u32) -> Code {
    code(order.index_of(number).ok_or(OUTSIDE), |found| {
        *place = found
    })
}

const OUTSIDE: core_crate::Error = core_crate::Error::OutOfRange(1);

#[unsafe(export_name = "mw_latin_hypercube_word")]
extern "C" fn latin_hypercube_word(set: &LatinHypercube, index: u32, dimension: u32) -> u32 {
    set.word(index, dimension)
}

#[unsafe(export_name = "mw_screen_word")]
extern "C" fn screen_word(
    screen: &Screen<Sobol<8>>,
    x: u32,
    y: u32,
    sample: u32,
    dimension: u32,
) -> u32 {
    screen.pixel(x, y).word(sample, dimension)
}

#[unsafe(export_name = "mw_screen_index")]
extern "C" fn screen_index(screen: &Screen<Sobol<8>>, x: u32, y: u32, sample: u32) -> u32 {
    screen.pixel(x, y).index(sample)
}
