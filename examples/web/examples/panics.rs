//! A module that panics where an index is out of range. The test must find the import that gives it away, or else
//! its finding none in the page's own module would mean nothing.
#![no_std]
#![allow(unsafe_code)]

microwarp_list::import_panic!();

static WORDS: [u32; 4] = [1, 2, 3, 5];

/// One of four words.
#[unsafe(no_mangle)]
pub extern "C" fn word(index: usize) -> u32 {
    WORDS[index]
}
