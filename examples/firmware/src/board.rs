//! The board: the log, the reset, and the end of a run. On a host there is no board, and the package is only
//! type-checked.

use core::panic::PanicInfo;
use cortex_m_rt::{ExceptionFrame, STACK_PAINT_VALUE, exception};

// A logger is linked by being named.
#[cfg(feature = "rtt")]
use defmt_rtt as _;
#[cfg(all(target_os = "none", not(feature = "rtt")))]
use defmt_semihosting as _;

/// Ends the run: the emulator, or the tool behind the probe, exits with success or failure. A product never
/// exits.
pub fn exit(well: bool) -> ! {
    #[cfg(target_os = "none")]
    semihosting::process::exit(i32::from(!well));
    #[cfg(not(target_os = "none"))]
    loop {
        core::hint::black_box(well);
    }
}

/// Resets, as after a watchdog or a deep sleep. RAM keeps its contents, except where the start-up code writes.
pub fn reset() -> ! {
    defmt::flush();
    cortex_m::peripheral::SCB::sys_reset()
}

/// Writes text for the host, if anybody listens.
pub fn print(text: &str) {
    #[cfg(target_os = "none")]
    if let Ok(mut out) = semihosting::io::stdout() {
        let _ = semihosting::io::Write::write_all(&mut out, text.as_bytes());
    }
    #[cfg(not(target_os = "none"))]
    core::hint::black_box(text);
}

/// How many bytes of stack have been in use, and how many there are: the start-up code paints them all.
pub fn stack() -> (usize, usize) {
    unsafe extern "C" {
        static _stack_end: u32;
        static _stack_start: u32;
    }
    let (end, start) = (&raw const _stack_end, &raw const _stack_start);
    let mut lowest = end;
    // SAFETY: whole words between the linker's two symbols; those in use are not painted.
    while lowest < start && unsafe { lowest.read_volatile() } == STACK_PAINT_VALUE {
        lowest = lowest.wrapping_add(1);
    }
    (
        start as usize - lowest as usize,
        start as usize - end as usize,
    )
}

/// Says where, and fails. The message itself would take the formatting of `core::fmt` into flash.
#[panic_handler]
fn panic(info: &PanicInfo) -> ! {
    match info.location() {
        Some(place) => defmt::error!("panicked at {=str}:{=u32}", place.file(), place.line()),
        None => defmt::error!("panicked"),
    }
    defmt::flush();
    exit(false)
}

/// A fault: a stack that has run over, or an exit with no debugger to exit to. Then this faults too, and the core
/// locks up.
#[exception]
unsafe fn HardFault(frame: &ExceptionFrame) -> ! {
    defmt::error!("hard fault at {=u32:#x}", frame.pc());
    defmt::flush();
    exit(false)
}
