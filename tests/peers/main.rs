//! What `crates/host` has for the benches: its stopwatch, and the peers that they run beside. (They stand here because
//! cargo builds a package's programs, which no test runs, for the tests beside them.)

mod contest;
mod drawn;
mod renderers;
