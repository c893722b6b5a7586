//! The module of the npm package: all that the library exports. The panic handler calls an import; a module without reachable
//! panics needs none, and the tests check that.
#![no_std]
#![allow(unsafe_code, reason = "an import is declared")]

use microwarp_js as _;

microwarp_list::import_panic!();
