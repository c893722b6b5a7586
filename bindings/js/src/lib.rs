//! The module of the npm package. What it exports is in `small`, compiled for size; the loops that fill arrays most often are
//! in `hot`, compiled for speed. The panic handler calls an import; a module without reachable panics needs none, and
//! the tests check that.
#![no_std]
#![allow(unsafe_code, reason = "an import is declared")]

use microwarp_js_small as _;

microwarp_list::import_panic!();
