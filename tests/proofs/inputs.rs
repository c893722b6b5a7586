//! The inputs of the maps, and the threads that go through them.

use host::parallel::{self, threads};
use host::speed;
use std::sync::LazyLock;

/// Which uniforms a bound holds for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Uniforms {
    /// Every `f32` in [0, 1).
    Any,
    /// k·2⁻²⁴, which generators yield.
    Grid,
}

/// The results of jobs 0..count, worked out on as many threads as there are cores.
pub fn in_parallel<T: Send>(count: u32, job: impl Fn(u32) -> T + Sync) -> Vec<T> {
    let jobs: Vec<u32> = (0..count).collect();
    parallel::in_parallel(threads(), &jobs, |&i| job(i))
}

/// What comes of one of every so many numbers from 0 to `last`, in parts of 2²⁰, each with its own last number.
pub fn in_parts<T: Default + Send>(
    last: u32,
    stride: u32,
    note: impl Fn(&mut T, u32) + Sync,
) -> Vec<T> {
    in_parallel((last >> 20) + 1, |part| {
        let mut made = T::default();
        let (start, end) = (part << 20, last.min((part << 20) + ((1 << 20) - 1)));
        for i in (start.next_multiple_of(stride)..=end).step_by(stride as usize) {
            note(&mut made, i);
        }
        note(&mut made, end);
        made
    })
}

/// One of how many inputs is tried. Odd, so that all low bits occur.
pub static STRIDE: LazyLock<u32> = LazyLock::new(|| speed::of("one input tried of every", 53, 1));
