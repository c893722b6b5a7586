//! The board: the log, the reset, and the end of a run. On a host there is no board, and the package is only
//! type-checked.

use core::panic::PanicInfo;
use core::sync::atomic::{AtomicU32, Ordering};
use cortex_m::peripheral::{SCB, SYST, syst::SystClkSource};
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

/// Counts instructions, in an emulator that gives each the same time (QEMU's `-icount`).
pub struct Stopwatch {
    /// Cycles of the core that the known instructions took.
    cycles: u64,
    then: u64,
}

/// Instructions that are timed to begin with.
const KNOWN: u32 = 1_000_000;

impl Stopwatch {
    pub fn calibrated() -> Self {
        // SAFETY: nobody else has the system timer.
        let mut timer = unsafe { cortex_m::Peripherals::steal() }.SYST;
        timer.set_clock_source(SystClkSource::Core);
        timer.set_reload(0xFF_FFFF);
        timer.clear_current();
        timer.enable_counter();
        timer.enable_interrupt();
        let mut watch = Self { cycles: 1, then: 0 };
        let [short, long] = [KNOWN, 2 * KNOWN].map(|instructions| {
            watch.start();
            execute(instructions);
            cycles_now() - watch.then
        });
        watch.cycles = long - short;
        watch
    }

    pub fn start(&mut self) {
        self.then = cycles_now();
    }

    /// Instructions since the start.
    pub fn instructions(&self) -> u64 {
        (cycles_now() - self.then) * u64::from(KNOWN) / self.cycles
    }
}

/// Executes so many instructions, and a few more; an even number.
#[inline(never)]
fn execute(instructions: u32) {
    #[cfg(target_arch = "arm")]
    // SAFETY: it counts a register down.
    unsafe {
        core::arch::asm!("2:", "subs {0}, {0}, #2", "bne 2b", inout(reg) instructions => _);
    }
    #[cfg(not(target_arch = "arm"))]
    core::hint::black_box(instructions);
}

/// How often the timer has gone round.
static ROUNDS: AtomicU32 = AtomicU32::new(0);

#[exception]
fn SysTick() {
    // A Cortex-M0 cannot do both at once, and need not: there is nobody else.
    ROUNDS.store(ROUNDS.load(Ordering::Relaxed) + 1, Ordering::Relaxed);
}

fn cycles_now() -> u64 {
    loop {
        let rounds = ROUNDS.load(Ordering::Relaxed);
        let left = SYST::get_current();
        if !SCB::is_pendst_pending() && ROUNDS.load(Ordering::Relaxed) == rounds {
            return (u64::from(rounds) << 24) + u64::from(0xFF_FFFF - left);
        }
    }
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
