//! What `crates/host` has for the benches: its stopwatch, and the peers that they run beside. (They are no tests of
//! `crates/host` itself, since cargo would build all its programs for them.)

mod contest;
mod drawn;
mod kit;
mod renderers;
