//! How a program of `src/bin` begins and ends, and a panic that cannot be overlooked.

use crate::output;
use core::panic::PanicInfo;

/// Runs the program.
#[inline(always)]
pub fn start() -> ! {
    unsafe extern "C" {
        safe fn probe_main();
    }
    probe_main();
    halt()
}

/// Stops for good.
#[unsafe(no_mangle)]
pub extern "C" fn halt() -> ! {
    loop {
        core::hint::spin_loop();
    }
}

/// Reads the whole message, so that no part of the panic machinery can be optimised away: where a
/// panic can be reached, `core::panicking`, `core::fmt` and `probe_panicked` are all in the symbols.
#[panic_handler]
fn panic(info: &PanicInfo) -> ! {
    probe_panicked(info)
}

#[unsafe(no_mangle)]
#[inline(never)]
fn probe_panicked(info: &PanicInfo) -> ! {
    struct Sink;
    impl core::fmt::Write for Sink {
        fn write_str(&mut self, text: &str) -> core::fmt::Result {
            text.bytes().for_each(|byte| output(byte.into()));
            Ok(())
        }
    }
    let _ = core::fmt::write(&mut Sink, format_args!("{info}"));
    halt()
}
