//! What the module of the npm package exports: plain functions that take addresses and numbers.
//!
//! The JavaScript around it owns the memory: it writes what an export reads, and copies out what an export writes. What a
//! caller gives passes through two buffers whose length is known here too. Nothing here keeps anything, so no object of
//! JavaScript has anything to free.
#![no_std]
#![allow(unsafe_code, reason = "the caller's memory is all there is")]

mod buffers;
mod chains;
mod counts;
mod flat;
mod frames;
mod laws;
mod lights;
mod mixture;
mod parts;
mod rejection;
mod tables;
mod times;
mod warps;
mod words;
